//! After how many collisions no more than half is left, decided in whole numbers.

use std::cmp::Ordering;

use num_bigint::BigUint;
use num_traits::{One, Signed, Zero};

use crate::algebra::{BigInt, BigRational};

/// The first *n* with `share`ⁿ ≤ 1/2, for a share between 0 and 1; `None` if there is none.
///
/// For a share of many digits next to 1 this *n* is too large to count up to. So it is put together from powers of
/// two, the largest first, each power of the share being enclosed between two fractions of a common denominator. Where
/// an enclosure contains 1/2 it is narrowed; that comes to an end, for beyond the first power none of a rational number is 1/2.
///
/// ```
/// use cradle_verify::algebra::{BigInt, BigRational};
/// use cradle_verify::figures::first_half;
/// let steel = BigRational::new(BigInt::from(98 * 98), BigInt::from(100 * 100));
/// assert_eq!(first_half(&steel), Some(18u32.into()));
/// assert_eq!(first_half(&BigRational::from_integer(BigInt::from(1))), None);
/// ```
pub fn first_half(share: &BigRational) -> Option<BigUint> {
    let half = BigRational::new(BigInt::one(), BigInt::from(2));
    if *share >= BigRational::one() || share.is_negative() {
        return None;
    }
    if *share <= half {
        return Some(BigUint::one());
    }
    let mut precision = 64 + 2 * share.denom().bits();
    loop {
        if let Some(last) = last_above_half(share, precision) {
            return Some(last + 1u32);
        }
        precision *= 2;
    }
}

/// A power of the share, between two multiples of 2⁻ᵖ.
#[derive(Clone)]
struct Enclosed {
    low: BigUint,
    high: BigUint,
    precision: u64,
}

impl Enclosed {
    fn new(share: &BigRational, precision: u64) -> Self {
        let scaled = share * (BigInt::one() << precision);
        let end = |value: BigRational| value.to_integer().magnitude().clone();
        Enclosed {
            low: end(scaled.floor()),
            high: end(scaled.ceil()),
            precision,
        }
    }

    fn times(&self, other: &Enclosed) -> Enclosed {
        let unit = BigUint::one() << self.precision;
        let up = |product: BigUint| (product + &unit - 1u32) >> self.precision;
        Enclosed {
            low: (&self.low * &other.low) >> self.precision,
            high: up(&self.high * &other.high),
            precision: self.precision,
        }
    }

    /// How it compares with 1/2; `None` where the enclosure does not tell.
    fn against_half(&self) -> Option<Ordering> {
        let half = BigUint::one() << (self.precision - 1);
        match () {
            () if self.low > half => Some(Ordering::Greater),
            () if self.high < half => Some(Ordering::Less),
            () => None,
        }
    }
}

/// The last power that is above 1/2, for a share that is itself; `None` where the precision does not tell.
fn last_above_half(share: &BigRational, precision: u64) -> Option<BigUint> {
    let mut squares = vec![Enclosed::new(share, precision)];
    while let Some(last) = squares.last()
        && last.against_half()? == Ordering::Greater
    {
        squares.push(last.times(last));
    }
    let mut count = BigUint::zero();
    let mut reached: Option<Enclosed> = None;
    for (at, square) in squares.iter().enumerate().rev() {
        let next = match &reached {
            Some(reached) => reached.times(square),
            None => square.clone(),
        };
        if next.against_half()? == Ordering::Greater {
            count += BigUint::one() << at;
            reached = Some(next);
        }
    }
    Some(count)
}
