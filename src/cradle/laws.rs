//! What a collision of perfectly elastic balls cannot change: momentum and kinetic energy.
//!
//! Both are sums over the balls, so both are dot products of the masses with something: with the velocities, or with
//! their squares.

use std::fmt;

use nalgebra::DVector;
use num_bigint::BigInt;
use num_rational::BigRational;

/// The momentum of a line of balls along the line.
///
/// $$ p = \sum_i m_i v_i $$
///
/// **Units.** mass × velocity. **Frame.** Any inertial one: a boost by `w` adds `M w`, with `M` the total mass.
/// **Source.** Landau–Lifshitz, *Mechanics*, §7.
///
/// ```
/// use cradle_verify::cradle::{momentum, parse_exact, parse_list};
/// let (masses, velocities) = (parse_list("1, 2").unwrap(), parse_list("3, -1/2").unwrap());
/// assert_eq!(momentum(&masses, &velocities), parse_exact("2").unwrap());
/// ```
///
/// # Panics
/// If there are not as many velocities as masses.
pub fn momentum(masses: &DVector<BigRational>, velocities: &DVector<BigRational>) -> BigRational {
    masses.dot(velocities)
}

/// The kinetic energy of a line of balls.
///
/// $$ T = \tfrac12 \sum_i m_i v_i^2 $$
///
/// **Units.** mass × velocity². **Frame.** Any inertial one: a boost by `w` adds `p w + M w²/2`, so that once momentum
/// is conserved, a change of kinetic energy is the same in every frame. **Source.** Landau–Lifshitz, *Mechanics*, §§4, 8.
///
/// ```
/// use cradle_verify::cradle::{kinetic_energy, parse_exact, parse_list};
/// let (masses, velocities) = (parse_list("1, 2").unwrap(), parse_list("3, -1/2").unwrap());
/// assert_eq!(kinetic_energy(&masses, &velocities), parse_exact("19/4").unwrap());
/// ```
///
/// # Panics
/// If there are not as many velocities as masses.
pub fn kinetic_energy(
    masses: &DVector<BigRational>,
    velocities: &DVector<BigRational>,
) -> BigRational {
    masses.dot(&velocities.component_mul(velocities)) / BigInt::from(2)
}

/// A conservation law, as something to hold an outcome against.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Law {
    /// [`momentum`] is the same after as before. True of every collision, however much is lost to heat.
    Momentum,
    /// [`kinetic_energy`] is the same after as before. True of perfectly elastic collisions.
    KineticEnergy,
}

impl Law {
    /// The laws, in the order in which they are reported.
    pub const ALL: [Law; 2] = [Law::Momentum, Law::KineticEnergy];

    /// The conserved quantity for these balls.
    ///
    /// # Panics
    /// If there are not as many velocities as masses.
    pub fn quantity(
        self,
        masses: &DVector<BigRational>,
        velocities: &DVector<BigRational>,
    ) -> BigRational {
        match self {
            Law::Momentum => momentum(masses, velocities),
            Law::KineticEnergy => kinetic_energy(masses, velocities),
        }
    }
}

impl fmt::Display for Law {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Law::Momentum => "momentum",
            Law::KineticEnergy => "kinetic energy",
        })
    }
}
