//! The change of units that shows a disagreement: the one with the smallest numbers.

use num_integer::Integer;
use num_traits::ToPrimitive;

use crate::algebra::{Base, BigInt, BigRational, Dimension, Rational};
use crate::kernel::dimension::Rescaling;

/// A unit is made no smaller than by this power of two.
const SMALLEST_UNIT: u32 = 64;
/// Exponents beyond this are not written out.
const HIGHEST_POWER: i64 = 512;

/// A unit that is made smaller by a power of two, so that both sides grow by powers of two, and not by the same.
pub(super) fn rescaling(left: &Dimension, right: &Dimension) -> Option<Rescaling> {
    let candidates = Base::ALL.into_iter().filter_map(|base| {
        let (a, b) = (left.exponent(base)?, right.exponent(base)?);
        let halvings = a
            .denom()
            .lcm(&b.denom())
            .to_u32()
            .filter(|n| *n <= SMALLEST_UNIT)?;
        let power = |exponent: &Rational| {
            let power = exponent * Rational::from(halvings);
            power.numer().to_i64().filter(|n| n.abs() <= HIGHEST_POWER)
        };
        let (a, b) = (power(&a)?, power(&b)?);
        (a != b).then_some((halvings, a.abs().max(b.abs()), order(base), base, a, b))
    });
    let (halvings, _, _, base, left, right) = candidates.min_by_key(|c| (c.0, c.1, c.2))?;
    Some(Rescaling {
        base,
        factor: two_to(halvings.into()),
        left: two_to(left),
        right: two_to(right),
    })
}

/// Lengths are the easiest to picture.
fn order(base: Base) -> usize {
    match base {
        Base::Length => 0,
        Base::Time => 1,
        Base::Mass => 2,
        other => 3 + other as usize,
    }
}

fn two_to(power: i64) -> BigRational {
    let power = i32::try_from(power).unwrap_or_default();
    BigRational::from_integer(BigInt::from(2)).pow(power)
}
