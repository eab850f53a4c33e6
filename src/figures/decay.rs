//! What is left of the energy after many collisions, by what is printed and by what is proved in its place.

use num_bigint::BigUint;
use num_traits::{One, Pow, Signed};

use super::FigureError;
use super::halving::first_half;
use super::law::{Audited, Law, Standing};
use super::material::Material;
use crate::algebra::{BigInt, BigRational};
use crate::derivation::{Checker, Point};

/// What one collision leaves of an energy, as the report prints it and as its premises give it.
#[derive(Clone, Debug)]
pub struct Decay {
    /// Equation (41) as printed.
    pub printed: Law,
    /// What the audit has proved in its place; `None` where (41) does not fail.
    pub corrected: Option<Law>,
    /// The report's claim of what is left after *n* collisions.
    pub claim: Standing,
}

impl Decay {
    /// Reads both laws off the audit.
    ///
    /// # Errors
    /// The derivation has not these equations.
    pub fn of(checker: &Checker) -> Result<Self, FigureError> {
        let (printed, claim) = ("41", "claim energy-decay");
        let audited = Audited::of(checker, &[printed, claim])?;
        Ok(Decay {
            printed: Law::of(&audited, printed, r"E_{\text{after}}")?,
            corrected: Law::instead_of(&audited, printed)?,
            claim: Standing::of(&audited, claim)?,
        })
    }

    /// The laws that there are, the printed one first.
    pub fn laws(&self) -> impl Iterator<Item = &Law> {
        std::iter::once(&self.printed).chain(&self.corrected)
    }

    /// What a law leaves of an energy of 1 after 0, 1, … collisions: the powers of its share.
    ///
    /// # Errors
    /// As [`share`].
    pub fn energies(
        law: &Law,
        material: &Material,
        collisions: usize,
    ) -> Result<Vec<BigRational>, FigureError> {
        let share = share(law, material)?;
        Ok((0..=collisions).map(|n| Pow::pow(&share, n)).collect())
    }

    /// The first number of collisions after which a law leaves no more than half; `None` if there is none.
    ///
    /// # Errors
    /// As [`share`].
    pub fn halving(law: &Law, material: &Material) -> Result<Option<BigUint>, FigureError> {
        Ok(first_half(&share(law, material)?))
    }
}

/// What a law leaves of an energy after one collision.
fn after(law: &Law, material: &Material, before: BigRational) -> Result<BigRational, FigureError> {
    let restitution = material.restitution().clone();
    let at = Point::new()
        .with_ratio("e", restitution)
        .with_ratio("E_0", before);
    law.value(&at)
}

/// The share of the energy that a law leaves after one collision.
///
/// # Errors
/// The law has no value, or what is left is not a share: not in proportion to the energy, or not from 0 to 1.
pub fn share(law: &Law, material: &Material) -> Result<BigRational, FigureError> {
    let share = after(law, material, BigRational::one())?;
    let three = BigRational::from_integer(BigInt::from(3));
    let of_three = after(law, material, three.clone())?;
    if share.is_negative() || share > BigRational::one() || of_three != &share * three {
        return Err(FigureError::NoShare(law.plain()));
    }
    Ok(share)
}
