//! Why there is no such line of balls, or no end to its collisions.

use std::fmt;

use nalgebra::DVector;
use num_rational::BigRational;
use num_traits::Signed;

/// Why a chain cannot be set up, or does not come to an end.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ChainError {
    /// There are no balls.
    NoBalls,
    /// A different number of masses and of velocities.
    LengthsDiffer {
        /// How many masses.
        masses: usize,
        /// How many velocities.
        velocities: usize,
    },
    /// A ball without a positive mass.
    MassNotPositive {
        /// The ball, counted from 1.
        ball: usize,
        /// Its mass.
        mass: BigRational,
    },
    /// A coefficient of restitution that is not between 0 and 1.
    RestitutionOutOfRange(BigRational),
    /// Still colliding after so many collisions.
    TooManyCollisions(usize),
    /// A number has become longer than is computed with.
    NumbersTooLong {
        /// How many collisions it took.
        collisions: usize,
        /// How many bits its numerator and denominator may have.
        bits: u64,
    },
}

impl fmt::Display for ChainError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ChainError::NoBalls => write!(f, "a chain needs at least one ball"),
            ChainError::LengthsDiffer { masses, velocities } => {
                write!(
                    f,
                    "each ball needs a mass and a velocity, but masses are {masses} and velocities {velocities}"
                )
            }
            ChainError::MassNotPositive { ball, mass } => {
                write!(f, "ball {ball} has the mass {mass}: it must be positive")
            }
            ChainError::RestitutionOutOfRange(e) => {
                write!(
                    f,
                    "a coefficient of restitution lies between 0 and 1, and {e} does not"
                )
            }
            ChainError::TooManyCollisions(count) => {
                write!(f, "the balls are still colliding after {count} collisions")
            }
            ChainError::NumbersTooLong { collisions, bits } => {
                write!(
                    f,
                    "after {collisions} collisions the exact numbers are longer than {bits} bits, and the balls may still be colliding"
                )
            }
        }
    }
}

impl std::error::Error for ChainError {}

/// Why masses and velocities do not make a scenario.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ScenarioError {
    /// There are no balls.
    NoBalls,
    /// Not as many masses, velocities before and velocities after.
    LengthsDiffer {
        /// How many masses.
        masses: usize,
        /// How many velocities before.
        before: usize,
        /// How many velocities after.
        after: usize,
    },
    /// A ball without a positive mass.
    MassNotPositive {
        /// The ball, counted from 1.
        ball: usize,
        /// Its mass.
        mass: BigRational,
    },
}

impl fmt::Display for ScenarioError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ScenarioError::NoBalls => write!(f, "a scenario needs at least one ball"),
            ScenarioError::LengthsDiffer {
                masses,
                before,
                after,
            } => write!(
                f,
                "each ball needs a mass, a velocity before and a velocity after, but there are \
                 {masses}, {before} and {after} of them"
            ),
            ScenarioError::MassNotPositive { ball, mass } => {
                write!(f, "ball {ball} has the mass {mass}: it must be positive")
            }
        }
    }
}

impl std::error::Error for ScenarioError {}

/// The first ball, counted from 1, whose mass is not positive.
pub(super) fn massless(masses: &DVector<BigRational>) -> Option<(usize, BigRational)> {
    masses
        .iter()
        .position(|mass| !mass.is_positive())
        .map(|at| (at + 1, masses[at].clone()))
}
