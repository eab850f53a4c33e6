//! Two identical balls, one at rest, from touch to separation.

use nalgebra::{Const, SVector};

use super::law::Contact;
use super::numeric::{ContactError, Numeric, positive};
use crate::cradle::ode::{Moment, System};

/// The tolerance of the coarser of the two runs; the finer one has a hundredth of it.
const TOLERANCE: f64 = 1e-10;

/// A ball strikes an identical one at rest.
///
/// **Units.** Any that agree. **Frame.** Where the struck ball rests at first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Impact {
    /// The mass of each ball.
    pub mass: f64,
    /// The speed of the striking ball.
    pub speed: f64,
    /// The force between the two.
    pub contact: Contact,
    /// When it is over.
    pub end: End,
}

/// When a contact is over.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// The compression is back to 0. Until then the damped force may pull a little, which dry balls cannot do. But nothing
    /// remains stored, so what is dissipated is just what kinetic energy is lost: the books of a report that
    /// integrates the dissipation over the contact. Therefore this is the usual choice here.
    Recovered,
    /// The force is back to 0, with some compression left that the balls recover from by themselves: what dry balls do.
    /// **Source.** Schwager and Pöschel, *Phys. Rev. E* 78, 051304 (2008). Without damping the two are the same.
    Released,
}

/// What an impact comes to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rebound {
    /// The largest compression.
    pub compression: Numeric,
    /// The time from touch to the end.
    pub duration: Numeric,
    /// The work done against the viscous force, `∫ γ δ^{1/2} δ'² dt`.
    pub dissipated: Numeric,
    /// The kinetic energy before less that after: another way to the same, up to what is still stored.
    pub kinetic_loss: Numeric,
    /// The elastic energy still stored at the end: none if the compression is back to 0.
    pub stored: Numeric,
    /// The velocity of separation over that of approach.
    pub restitution: Numeric,
    /// The velocities after, striking ball first.
    pub velocities: [Numeric; 2],
}

/// What is integrated: `√δ`, the two velocities, time, and the work done against the viscous force.
type State = SVector<f64, 5>;
type Slope<'a> = Box<dyn Fn(&State) -> State + 'a>;

impl Impact {
    /// Integrates the impact, twice.
    ///
    /// # Errors
    /// A mass, speed or stiffness that is not positive, a negative damping, or one so strong that the balls hardly part.
    pub fn run(&self) -> Result<Rebound, ContactError> {
        positive("mass", self.mass)?;
        positive("speed", self.speed)?;
        positive("stiffness", self.contact.stiffness)?;
        if !self.contact.damping.is_finite() || self.contact.damping < 0.0 {
            let (what, value) = ("damping, unless it is 0,", self.contact.damping);
            return Err(ContactError::NotPositive { what, value });
        }
        let coarse = self.follow(TOLERANCE)?;
        let fine = self.follow(TOLERANCE / 100.0)?;
        let brought = 0.5 * self.mass * self.speed * self.speed;
        let scales = [0.0, 0.0, 0.0, brought, 0.0, 1.0, self.speed, self.speed];
        let at = |i: usize| Numeric::from_runs(coarse[i], fine[i], scales[i]);
        Ok(Rebound {
            compression: at(0),
            duration: at(1),
            dissipated: at(2),
            kinetic_loss: at(3),
            stored: at(4),
            restitution: at(5),
            velocities: [at(6), at(7)],
        })
    }

    /// The impact in the variable `s` with `dt = 2√δ ds`.
    ///
    /// In time the forces have `δ^{1/2}` and `δ^{3/2}` in them, which are not smooth where the contact begins and ends, and
    /// no method keeps its order there. In `s`, with `y = √δ` and `w` the rate of compression, everything is a polynomial,
    ///
    /// $$ \frac{dy}{ds} = w, \quad m\frac{dv_{1,2}}{ds} = \mp 2y^2(k y^2 + \gamma w), \quad \frac{dt}{ds} = 2y, \quad
    ///    \frac{dQ}{ds} = 2\gamma y^2 w^2, $$
    ///
    /// and `y` goes through 0 at the end like any other smooth function.
    fn system(&self, tolerance: f64) -> System<Slope<'_>, Const<5>> {
        let (m, k, gamma) = (self.mass, self.contact.stiffness, self.contact.damping);
        let depth = self.contact.largest_compression(m / 2.0, self.speed);
        let work = match gamma > 0.0 {
            true => gamma * depth.powf(1.5) * self.speed,
            false => 1.0,
        };
        System {
            slope: Box::new(move |state| {
                let (y, w) = (state[0], state[1] - state[2]);
                let push = 2.0 * y * y * (k * y * y + gamma * w) / m;
                State::from([w, -push, push, 2.0 * y, 2.0 * gamma * y * y * w * w])
            }),
            scale: State::from([
                depth.sqrt(),
                self.speed,
                self.speed,
                depth / self.speed,
                work,
            ]),
            tolerance,
        }
    }

    fn follow(&self, tolerance: f64) -> Result<[f64; 8], ContactError> {
        let system = self.system(tolerance);
        let first = 0.01 * system.scale[0] / self.speed;
        let touch = Moment::start(State::from([0.0, self.speed, 0.0, 0.0, 0.0]), first);
        let deepest = system.until(touch, |state| state[1] - state[2])?;
        let compression = deepest.state[0] * deepest.state[0];
        let (k, gamma) = (self.contact.stiffness, self.contact.damping);
        let end = system.until(deepest, |state| match self.end {
            // The force is y (k y² + γ w); past y = 0 it would be positive again, so y has a say too.
            End::Released if gamma > 0.0 => {
                let force = k * state[0] * state[0] + gamma * (state[1] - state[2]);
                (state[0] / system.scale[0]).min(force / (gamma * self.speed))
            }
            _ => state[0],
        })?;
        let [y, v1, v2, time, dissipated] = end.state.data.0[0];
        let kinetic = |v: f64| 0.5 * self.mass * v * v;
        let loss = kinetic(self.speed) - kinetic(v1) - kinetic(v2);
        let stored = self.contact.stored((y * y).max(0.0));
        let restitution = (v2 - v1) / self.speed;
        Ok([
            compression,
            time,
            dissipated,
            loss,
            stored,
            restitution,
            v1,
            v2,
        ])
    }
}

/// The damping that makes an impact rebound with this coefficient of restitution, the compression going back to 0.
///
/// The equation of motion in units of `δ_max` and `δ_max/v` has one parameter, `β = γ δ_max^{3/2}/(μ v)`, so `e` fixes `β`.
/// It is found by halving, for `e` falls as `β` grows.
///
/// **Units.** None. Relative accuracy 10⁻⁷ or better.
///
/// # Errors
/// [`ContactError::NoSuchRestitution`] unless `0.05 ≤ e ≤ 0.9999`.
pub fn damping_number(e: f64) -> Result<f64, ContactError> {
    if !(0.05..=0.9999).contains(&e) {
        return Err(ContactError::NoSuchRestitution(e));
    }
    // Reduced mass, speed and δ_max are 1.
    let impact = |beta: f64| Impact {
        mass: 2.0,
        speed: 1.0,
        contact: Contact {
            stiffness: 1.25,
            damping: beta,
        },
        end: End::Recovered,
    };
    // To first order 1 − e² = 2 · WEAK_LOSS · β; the rebound slows the dissipation down, so the root lies above.
    let mut low = (1.0 - e * e) / (2.0 * super::law::WEAK_LOSS);
    let mut high = 40.0 * low;
    while high - low > 1e-10 * low {
        let middle = 0.5 * (low + high);
        match impact(middle).follow(1e-12)?[5] > e {
            true => low = middle,
            false => high = middle,
        }
    }
    Ok(0.5 * (low + high))
}
