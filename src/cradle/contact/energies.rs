//! Heat against sound, for a real ball: a numeric claim, with every figure as an interval.

use std::f64::consts::PI;

use super::impact::{End, Impact, damping_number};
use super::interval::Interval;
use super::law::{CONTACT_TIME, Contact};
use super::numeric::{ContactError, positive};

/// A ball, in SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// Its radius, in m.
    pub radius: Interval,
    /// Its density, in kg/m³.
    pub density: Interval,
    /// Young's modulus, in Pa.
    pub young: Interval,
    /// Poisson's ratio.
    pub poisson: Interval,
    /// The coefficient of restitution against its like, at the speed in question. Measured; damping is inferred from it.
    pub restitution: Interval,
}

impl Material {
    /// A hardened steel ball of 2 cm across, as in a desk cradle, at some 1 m/s or less.
    ///
    /// **Source.** The first four contain what handbooks tabulate for carbon, alloy and bearing steels (Kaye and Laby,
    /// *Tables of Physical and Chemical Constants*, has 212 GPa and 0.29 for mild steel). Restitution is the figure that decides:
    /// Goldsmith, *Impact*, collects measurements, and those of hard steel at such speeds are some 0.95. The interval is
    /// wider than that by judgement, not by measurement. The claim is hardest for the largest, so 0.99 is what counts.
    pub const STEEL: Material = Material {
        radius: Interval::new(0.009_9, 0.010_1),
        density: Interval::new(7_700.0, 8_000.0),
        young: Interval::new(200e9, 215e9),
        poisson: Interval::new(0.27, 0.31),
        restitution: Interval::new(0.90, 0.99),
    };
}

/// What carries the sound.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Air {
    /// Its density, in kg/m³.
    pub density: Interval,
    /// The speed of sound, in m/s.
    pub sound_speed: Interval,
}

impl Air {
    /// Air indoors; at 20 °C and sea level handbooks have 1.20 kg/m³ and 343 m/s.
    pub const INDOORS: Air = Air {
        density: Interval::new(1.1, 1.3),
        sound_speed: Interval::new(335.0, 350.0),
    };
}

/// What the power `P ~ (ρ/c) A² a²` may have to be multiplied by, with `A = R²` and `a = v0/τ`.
///
/// For rigid spheres there is an upper bound. One that oscillates with velocity `u cos ωt` radiates, with `x = ωR/c`,
///
/// $$ P = \frac{2\pi}{3} \rho c R^2 u^2 \frac{x^4}{4 + x^4} = \frac{2\pi}{3} \frac{\rho}{c} R^4 (\omega u)^2 \frac{x^2}{4 + x^4}, $$
///
/// and the last fraction is at most 1/4. Hence, by Parseval, any motion with acceleration `a(t)` radiates at most
/// `(π/3)(ρ/c) R⁴ ∫a² dt`. Two of them radiate at most twice what both would separately, where the one does not scatter what the
/// other sends. In Hertz's impact `∫a² dt` is 1.39 `v0²/τ`. Together: at most 4 · π/3 · 1.39 = 5.8. The interval goes to 10 for
/// what is left out, and down to 1/100, as a slow contact radiates far less than the bound.
///
/// **Source.** Landau–Lifshitz, *Fluid Mechanics*, §74, problems; Morse and Ingard, *Theoretical Acoustics*, ch. 7.
pub const RADIATION_FACTOR: Interval = Interval::new(0.01, 10.0);

/// "Far exceeds" is taken for: at least ten times.
pub const FAR: f64 = 10.0;

/// Heat and sound of one click.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// The kinetic energy lost, `(1 − e²)/2` of what was brought, in J: heat and sound together.
    pub loss: Interval,
    /// What of it is heat, in J.
    pub heat: Interval,
    /// What of it is sound, in J.
    pub sound: Interval,
    /// Heat over sound is at least this. Sharper than the quotient of the two intervals, for speed and radius enter both alike.
    pub least_ratio: f64,
    /// The time of contact, in s.
    pub duration: Interval,
    /// The damping `γ` that the restitution implies, in N s m^(−3/2), with all of the loss put down to it.
    pub damping: Interval,
    /// The claim would still stand with a radiation factor up to this.
    pub tolerated_factor: f64,
}

impl Estimate {
    /// Whether heat is at least [`FAR`] times sound, whatever the figures are within their intervals.
    pub fn heat_far_exceeds_sound(&self) -> bool {
        self.least_ratio >= FAR
    }
}

/// Heat and sound when a ball strikes an identical one at rest.
///
/// $$ E_{\text{heat}} + E_{\text{sound}} = \frac{1 - e^2}{4} m v_0^2, \qquad
///    E_{\text{sound}} = f\,\frac{\rho_{\text{air}}}{c_{\text{air}}} R^4 \frac{v_0^2}{\tau}, \qquad
///    \frac{v_0\tau}{R} = T \left(\frac{5\sqrt2\,\pi}{4}\,\frac{\rho v_0^2 (1 - \nu^2)}{E}\right)^{2/5} $$
///
/// The first is the balance of energy with the measured restitution, that is, the integral of `γ δ^{1/2} δ'²` with the `γ` that
/// gives this restitution, less the sound. The last is Hertz's contact time for twins; `T` is 2.943 without damping, and
/// what the damped impact is integrated to with it. So
///
/// $$ \frac{E_{\text{heat}} + E_{\text{sound}}}{E_{\text{sound}}} = \frac{\pi}{3f}\,(1 - e^2)\,\frac{\rho}{\rho_{\text{air}}}\,
///    \frac{c_{\text{air}}}{v_0}\,\frac{v_0\tau}{R}, $$
///
/// in which the radius drops out. What balls keep as vibration ends as heat, and is counted so.
///
/// **Units.** SI; `speed` in m/s. **Frame.** Where the struck ball rests. **Trusts** that restitution falls and the contact time grows
/// with damping, as integration shows they do. `factor` is usually [`RADIATION_FACTOR`].
///
/// ```
/// use cradle_verify::cradle::contact::energies::RADIATION_FACTOR;
/// use cradle_verify::cradle::contact::{Air, Interval, Material, heat_against_sound};
/// let speed = Interval::new(0.5, 1.0);
/// let click = heat_against_sound(&Material::STEEL, speed, &Air::INDOORS, RADIATION_FACTOR).unwrap();
/// assert!(click.heat_far_exceeds_sound());
/// ```
///
/// # Errors
/// A restitution from which no damping is inferred, or figures with which sound might be all of the loss.
pub fn heat_against_sound(
    ball: &Material,
    speed: Interval,
    air: &Air,
    factor: Interval,
) -> Result<Estimate, ContactError> {
    let number = Interval::exactly;
    let pi = Interval::new(PI.next_down(), PI.next_up());
    let e = ball.restitution;
    let weakest = Interval::exactly(damping_number(e.high())?).widened(1e-6);
    let strongest = Interval::exactly(damping_number(e.low())?).widened(1e-6);
    let beta = Interval::new(weakest.low(), strongest.high());
    let stretch = Interval::new(CONTACT_TIME, longest(strongest.high())?).widened(1e-9);

    let mass = number(4.0) / number(3.0) * pi * ball.radius.powf(3.0) * ball.density;
    let lost_share = e.powf(2.0).from_one();
    let loss = lost_share / number(4.0) * mass * speed.powf(2.0);
    let hertz = number(1.25) * number(2.0).powf(0.5) * pi;
    let softness = hertz * ball.density * ball.poisson.powf(2.0).from_one() / ball.young;
    // δ_max / R, and v0 τ / R, the latter also without the speed in it.
    let depth = (softness * speed.powf(2.0)).powf(0.4);
    let path = stretch * softness.powf(0.4) * speed.powf(0.8);
    let duration = path * ball.radius / speed;
    let sound =
        factor * air.density / air.sound_speed * ball.radius.powf(4.0) * speed.powf(2.0) / duration;

    let without_factor = pi / number(3.0)
        * lost_share
        * (ball.density.powf(1.4) / air.density)
        * air.sound_speed
        * stretch
        * (softness / ball.density).powf(0.4)
        / speed.powf(0.2);
    let least_share = positive(
        "least share of heat in the loss",
        1.0 - (factor / without_factor).high(),
    )?;
    let ratio = without_factor / factor;
    let compression = depth * ball.radius;
    Ok(Estimate {
        loss,
        heat: loss * Interval::new(least_share.next_down(), 1.0),
        sound,
        least_ratio: (ratio.low() - 1.0).next_down(),
        duration,
        damping: beta * (mass / number(2.0)) * speed / compression.powf(1.5),
        tolerated_factor: (without_factor / number(FAR + 1.0)).low(),
    })
}

/// The time of contact in units of `δ_max/v`, at a damping number, rounded up.
fn longest(beta: f64) -> Result<f64, ContactError> {
    let impact = Impact {
        mass: 2.0,
        speed: 1.0,
        contact: Contact {
            stiffness: 1.25,
            damping: beta,
        },
        end: End::Recovered,
    };
    let duration = impact.run()?.duration;
    Ok((duration.value + duration.error).max(CONTACT_TIME))
}
