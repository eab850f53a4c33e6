//! Powers with rational exponents; roots rounded outwards.

use num_traits::{One, Signed, ToPrimitive, Zero};

use super::{Interval, PRECISION, in_binary};
use crate::algebra::{BigInt, BigRational};

/// Exponents whose numerator or denominator is larger are not evaluated.
const LARGEST: u32 = 64;

/// Whether a power with this exponent is one of roots and products.
pub(super) fn is_plain(exponent: &BigRational) -> bool {
    let fits = |n: &BigInt| n.abs().to_u32().is_some_and(|n| n <= LARGEST);
    fits(exponent.numer()) && fits(exponent.denom())
}

pub(super) fn power(base: &Interval, exponent: &BigRational) -> Option<Interval> {
    let size = |n: &BigInt| n.abs().to_u32().filter(|&n| n <= LARGEST);
    let (over, under) = (size(exponent.numer())?, size(exponent.denom())?);
    if exponent.is_negative() {
        return power(base, &-exponent)?.recip();
    }
    if (over, under) == (1, 1) {
        return Some(base.clone());
    }
    let rooted = match under {
        1 => base.clone(),
        _ if base.low().is_negative() => return None,
        _ => Interval::new(root(base.low(), under).0, root(base.high(), under).1)?,
    };
    Some(raised(&rooted, over).trimmed())
}

fn raised(base: &Interval, exponent: u32) -> Interval {
    // An even power of what may have either sign is a power of its size.
    let base = match exponent % 2 {
        0 => base.abs(),
        _ => base.clone(),
    };
    // What is in lowest terms stays so.
    let power = |end: &BigRational| {
        BigRational::new_raw(end.numer().pow(exponent), end.denom().pow(exponent))
    };
    Interval {
        low: power(&base.low),
        high: power(&base.high),
    }
}

/// Numbers just below and above a root of what is not negative; both the root itself where it is rational.
fn root(value: &BigRational, degree: u32) -> (BigRational, BigRational) {
    if value.is_zero() || value.is_one() {
        return (value.clone(), value.clone());
    }
    let exact = |n: &BigInt| Some(n.nth_root(degree)).filter(|r| r.pow(degree) == *n);
    if let (Some(over), Some(under)) = (exact(value.numer()), exact(value.denom())) {
        let root = BigRational::new_raw(over, under);
        return (root.clone(), root);
    }
    // The integer root of the value times `2^(degree · places)` has at least `PRECISION` bits.
    let missing = value.denom().bits().saturating_sub(value.numer().bits()) / u64::from(degree);
    let places = PRECISION + missing + 2;
    let scaled: BigInt = (value.numer() << (places * u64::from(degree))) / value.denom();
    let below = scaled.nth_root(degree);
    let above = in_binary(&below + 1, places);
    (in_binary(below, places), above)
}
