//! A line of balls that touch from the start: Hertz's law at every contact, all of them at once.
//!
//! Where balls touch, a collision is not over before the next one begins, and "one in, one out" is only nearly true: the pulse
//! spreads over some five balls, and what is behind it drifts back.

use nalgebra::{DVector, Dyn};

use super::law::Contact;
use super::numeric::{ContactError, Numeric, positive};
use crate::cradle::ode::{MOST_STEPS, Moment, System};

/// The tolerance of the coarser of the two runs; the finer one has a hundredth of it.
const TOLERANCE: f64 = 1e-9;
/// The most by which the heaviest ball may exceed the lightest: beyond, one contact is over in a small part of another.
pub const MOST_UNEQUAL: f64 = 1e6;
/// The longest line. A guess: it takes a second, and the pulse has its final shape after some five balls.
pub const MOST_BALLS: usize = 200;
/// Approaches slower than this share of the largest speed are taken for parting: they come to a collision after ages, if
/// they are there at all and not an error of the integration. What is so left out is added to the reported error.
const SLOW: f64 = 1e-7;

/// A line of balls, left to right, each touching the next without pressing; all contacts are of one stiffness.
///
/// The stiffness drops out of the velocities in the end: it sets the unit of length, and nothing else here has one.
///
/// **Units.** Any that agree. **Frame.** Any inertial one. **Source.** Hertz's law as in [`Contact`]; for the touching line,
/// Herrmann and Seitz, *Am. J. Phys.* 50, 977 (1982).
#[derive(Clone, Debug, PartialEq)]
pub struct TouchingBalls {
    masses: Vec<f64>,
    velocities: Vec<f64>,
}

/// Balls that have parted for good.
#[derive(Clone, Debug, PartialEq)]
pub struct Parting {
    /// The velocities, left to right.
    pub velocities: Vec<Numeric>,
    /// The change of momentum on the way, which is nothing but error.
    pub momentum_drift: f64,
    /// The change of kinetic energy from start to end, likewise.
    pub energy_drift: f64,
    /// The steps that the finer run took.
    pub steps: usize,
}

impl TouchingBalls {
    /// Balls of these masses, moving at these velocities.
    ///
    /// # Errors
    /// Unless there is a ball and at most [`MOST_BALLS`], each has a positive mass and a velocity, and the masses are not too
    /// unequal.
    pub fn new(masses: Vec<f64>, velocities: Vec<f64>) -> Result<Self, ContactError> {
        if masses.is_empty() || masses.len() != velocities.len() {
            return Err(ContactError::LengthsDiffer {
                masses: masses.len(),
                velocities: velocities.len(),
            });
        }
        if masses.len() > MOST_BALLS {
            return Err(ContactError::TooManyBalls(masses.len()));
        }
        for &mass in &masses {
            positive("mass", mass)?;
        }
        for &velocity in &velocities {
            positive("size of a velocity, plus 1,", 1.0 + velocity.abs())?;
        }
        let ratio = largest(&masses) / masses.iter().copied().fold(f64::INFINITY, f64::min);
        match ratio <= MOST_UNEQUAL {
            true => Ok(TouchingBalls { masses, velocities }),
            false => Err(ContactError::MassesTooUnequal(ratio)),
        }
    }

    /// Equal balls, of which the first ones come in at speed 1 and the rest stand.
    ///
    /// # Errors
    /// If there is no ball, or more than [`MOST_BALLS`].
    pub fn equal(balls: usize, arriving: usize) -> Result<Self, ContactError> {
        let speed = |ball| f64::from(u8::from(ball < arriving));
        TouchingBalls::new(vec![1.0; balls], (0..balls).map(speed).collect())
    }

    /// Integrates until no two balls touch or approach, twice.
    ///
    /// # Errors
    /// [`ContactError::TooManySteps`].
    pub fn part(&self) -> Result<Parting, ContactError> {
        // In units of the largest mass and speed, with k = 1, everything is of order 1.
        let (mass, speed) = (largest(&self.masses), largest(&self.velocities));
        let speed = if speed > 0.0 { speed } else { 1.0 };
        let line = Line {
            masses: DVector::from_iterator(self.masses.len(), self.masses.iter().map(|m| m / mass)),
            contact: Contact {
                stiffness: 1.0,
                damping: 0.0,
            },
        };
        let start = DVector::from_iterator(
            self.velocities.len(),
            self.velocities.iter().map(|v| v / speed),
        );
        let (coarse, _) = line.follow(&start, TOLERANCE)?;
        let (fine, steps) = line.follow(&start, TOLERANCE / 100.0)?;
        let left_out = fine
            .as_slice()
            .windows(2)
            .map(|pair| pair[0] - pair[1])
            .fold(0.0, f64::max);
        let velocity = |(coarse, fine): (&f64, &f64)| {
            let number = Numeric::from_runs(coarse * speed, fine * speed, speed);
            Numeric {
                error: number.error + left_out * speed,
                ..number
            }
        };
        let energy = |v: &DVector<f64>| 0.5 * line.masses.dot(&v.component_mul(v));
        Ok(Parting {
            velocities: coarse.iter().zip(&fine).map(velocity).collect(),
            momentum_drift: (line.masses.dot(&fine) - line.masses.dot(&start)) * mass * speed,
            energy_drift: (energy(&fine) - energy(&start)) * mass * speed * speed,
            steps,
        })
    }
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, x| f64::max(most, x.abs()))
}

/// The line in its own units. A state is all displacements from the touching line, then all velocities.
struct Line {
    masses: DVector<f64>,
    contact: Contact,
}

impl Line {
    fn slope(&self, state: &DVector<f64>) -> DVector<f64> {
        let count = self.masses.len();
        let mut slope = DVector::zeros(2 * count);
        slope
            .rows_mut(0, count)
            .copy_from(&state.rows(count, count));
        for left in 0..count - 1 {
            let push = self.contact.force(state[left] - state[left + 1], 0.0);
            slope[count + left] -= push / self.masses[left];
            slope[count + left + 1] += push / self.masses[left + 1];
        }
        slope
    }

    /// Velocities after the last contact, and the steps it took.
    fn follow(
        &self,
        start: &DVector<f64>,
        tolerance: f64,
    ) -> Result<(DVector<f64>, usize), ContactError> {
        let count = self.masses.len();
        let mut state = DVector::zeros(2 * count);
        state.rows_mut(count, count).copy_from(start);
        let system: System<_, Dyn> = System {
            slope: |state: &DVector<f64>| self.slope(state),
            scale: DVector::from_element(2 * count, 1.0),
            tolerance,
        };
        let mut moment = Moment::start(state, 0.01);
        loop {
            let pairs: Vec<Pair> = self.pairs(&moment.state).collect();
            let closing = pairs.iter().filter(|pair| pair.approach > SLOW);
            if !pairs
                .iter()
                .any(|pair| pair.compression > 0.0 || pair.about_to_touch())
            {
                // Free flight, exactly, to where the next two balls touch.
                let flight = closing.map(|pair| -pair.compression / pair.approach);
                let flight = flight.fold(f64::INFINITY, f64::min);
                if flight == f64::INFINITY {
                    let end = moment.state.rows(count, count).into_owned();
                    return Ok((end, moment.tried));
                }
                let velocities = moment.state.rows(count, count).into_owned();
                moment
                    .state
                    .rows_mut(0, count)
                    .axpy(flight, &velocities, 1.0);
                moment.tried += 1;
                moment.step = 0.01;
            } else {
                // A step must not lead from before a contact to after it. Two balls that are yet apart may come to overlap by
                // a small part of what the pair can be compressed.
                let bounds = closing
                    .filter(|pair| pair.compression <= 0.0)
                    .map(|pair| (0.05 * pair.depth - pair.compression) / pair.approach);
                moment.step = bounds.fold(moment.step, f64::min);
                moment = system.advance(&moment)?;
            }
            if moment.tried >= MOST_STEPS {
                return Err(ContactError::TooManySteps(moment.tried));
            }
        }
    }

    fn pairs<'a>(&'a self, state: &'a DVector<f64>) -> impl Iterator<Item = Pair> + 'a {
        let count = self.masses.len();
        (0..count - 1).map(move |left| {
            let (m1, m2) = (self.masses[left], self.masses[left + 1]);
            let approach = state[count + left] - state[count + left + 1];
            Pair {
                compression: state[left] - state[left + 1],
                approach,
                depth: self
                    .contact
                    .largest_compression(m1 * m2 / (m1 + m2), approach.abs()),
            }
        })
    }
}

/// Two neighbours: how far they overlap, how fast they approach, and how far that speed would compress them.
struct Pair {
    compression: f64,
    approach: f64,
    depth: f64,
}

impl Pair {
    /// Whether a free flight to their touching would be too short to count.
    fn about_to_touch(&self) -> bool {
        self.approach > SLOW && -self.compression <= 1e-6 * self.depth
    }
}
