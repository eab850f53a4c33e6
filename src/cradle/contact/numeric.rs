//! Numbers with an estimate of their error, and why there may be none.

use std::fmt;

/// A computed number, and how far off it may be.
///
/// The error is an estimate, not a bound: twice the change when the integration is repeated with a tolerance a hundred
/// times finer, and never less than what rounding does. The value is the finer one, so the estimate is generous.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Numeric {
    /// The number.
    pub value: f64,
    /// How far off it may be, in the same unit.
    pub error: f64,
}

impl Numeric {
    /// A number from a coarser and a finer computation. `scale` is the size of the numbers that were added and
    /// subtracted on the way, which is what rounding errors go with.
    pub fn from_runs(coarse: f64, fine: f64, scale: f64) -> Self {
        // Some hundred steps, each with a few roundings that partly cancel.
        let rounding = 64.0 * f64::EPSILON * scale.abs().max(fine.abs());
        Numeric {
            value: fine,
            error: 2.0 * (fine - coarse).abs() + rounding,
        }
    }

    /// Whether a number that is known otherwise lies within the error.
    pub fn agrees_with(&self, known: f64) -> bool {
        (self.value - known).abs() <= self.error
    }
}

impl fmt::Display for Numeric {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} ± {:.0e}", self.value, self.error)
    }
}

/// Why an integration has no result.
#[derive(Clone, Debug, PartialEq)]
pub enum ContactError {
    /// A quantity that must be positive and finite is not.
    NotPositive {
        /// Its name.
        what: &'static str,
        /// Its value.
        value: f64,
    },
    /// A different number of masses and of velocities, or none.
    LengthsDiffer {
        /// How many masses.
        masses: usize,
        /// How many velocities.
        velocities: usize,
    },
    /// A longer line than is integrated.
    TooManyBalls(usize),
    /// Still unfinished after so many steps.
    TooManySteps(usize),
    /// A ratio of masses beyond what is integrated.
    MassesTooUnequal(f64),
    /// A coefficient of restitution that no damping gives.
    NoSuchRestitution(f64),
}

impl fmt::Display for ContactError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ContactError::NotPositive { what, value } => {
                write!(
                    f,
                    "the {what} must be positive and finite, and {value} is not"
                )
            }
            ContactError::LengthsDiffer { masses, velocities } => write!(
                f,
                "each ball needs a mass and a velocity, but masses are {masses} and velocities {velocities}"
            ),
            ContactError::TooManyBalls(balls) => write!(
                f,
                "a line of {balls} balls is too long: with contact forces at most {} are integrated",
                super::touching::MOST_BALLS
            ),
            ContactError::TooManySteps(steps) => write!(
                f,
                "the integration was given up after {steps} steps: the balls have not parted"
            ),
            ContactError::MassesTooUnequal(ratio) => write!(
                f,
                "the heaviest ball has {ratio:.1e} times the mass of the lightest: with contact forces at most {:.0e} is integrated",
                super::touching::MOST_UNEQUAL
            ),
            ContactError::NoSuchRestitution(e) => write!(
                f,
                "damping is inferred from coefficients of restitution from 0.05 to 0.9999, and {e} is not one"
            ),
        }
    }
}

impl std::error::Error for ContactError {}

/// Refuses what is not positive and finite.
pub(super) fn positive(what: &'static str, value: f64) -> Result<f64, ContactError> {
    match value > 0.0 && value.is_finite() {
        true => Ok(value),
        false => Err(ContactError::NotPositive { what, value }),
    }
}
