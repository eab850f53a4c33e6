//! Intervals with exact rational ends.
//!
//! An interval stands for all real numbers between its ends. Every operation gives one that contains each value that the operation
//! can take; sums, products and quotients are exact, roots are rounded outwards. Nothing here is a proof in the sense of the kernel: what
//! comes out is as good as the figures that go in.

mod power;
mod term;

use std::cmp::Ordering;
use std::fmt;
use std::ops::{Add, Mul, Neg, Sub};

use num_traits::{One, Signed, Zero};

use crate::algebra::{BigInt, BigRational};

pub use term::{Compared, Figures, NoInterval};

/// Ends are rounded outwards by at most one part in 2 to this power, where they are rounded at all.
pub const PRECISION: u64 = 40;
/// Ends that take more bits than this are rounded.
const LONGEST: u64 = 128;

/// All real numbers from one rational number to another.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Interval {
    low: BigRational,
    high: BigRational,
}

impl Interval {
    /// All numbers from `low` to `high`; nothing if there are none.
    pub fn new(low: BigRational, high: BigRational) -> Option<Interval> {
        (low <= high).then_some(Interval { low, high })
    }

    /// One number.
    pub fn exactly(value: BigRational) -> Interval {
        Interval {
            low: value.clone(),
            high: value,
        }
    }

    /// The lower end.
    pub fn low(&self) -> &BigRational {
        &self.low
    }

    /// The upper end.
    pub fn high(&self) -> &BigRational {
        &self.high
    }

    /// Whether a number lies within.
    pub fn contains(&self, value: &BigRational) -> bool {
        self.low <= *value && *value <= self.high
    }

    /// Whether all of it is above 0.
    pub fn is_positive(&self) -> bool {
        self.low.is_positive()
    }

    /// What both contain; nothing where they do not meet.
    pub fn meet(&self, other: &Interval) -> Option<Interval> {
        let low = (&self.low).max(&other.low).clone();
        Interval::new(low, (&self.high).min(&other.high).clone())
    }

    /// The absolute values.
    pub fn abs(&self) -> Interval {
        match (self.low.is_negative(), self.high.is_negative()) {
            (false, _) => self.clone(),
            (true, true) => -self,
            (true, false) => Interval {
                low: BigRational::zero(),
                high: self.high.clone().max(-self.low.clone()),
            },
        }
    }

    /// `1/x`; nothing where 0 is within.
    pub fn recip(&self) -> Option<Interval> {
        let zero = self.contains(&BigRational::zero());
        (!zero).then(|| Interval {
            low: self.high.recip(),
            high: self.low.recip(),
        })
    }

    /// The quotient; nothing where the divisor may be 0.
    pub fn over(&self, divisor: &Interval) -> Option<Interval> {
        Some(self * &divisor.recip()?)
    }

    /// A power with a rational exponent; nothing where it may have no real value, or the exponent is out of all proportion.
    pub fn power(&self, exponent: &BigRational) -> Option<Interval> {
        power::power(self, exponent)
    }

    /// Ends of bounded length: a little wider where they have grown too long.
    fn trimmed(self) -> Interval {
        Interval {
            low: rounded(self.low, Ordering::Less),
            high: rounded(self.high, Ordering::Greater),
        }
    }
}

/// A number of bounded length below or above.
fn rounded(value: BigRational, side: Ordering) -> BigRational {
    let (over, under) = (value.numer().bits(), value.denom().bits());
    if over.max(under) <= LONGEST {
        return value;
    }
    // So many binary places that `PRECISION` bits remain.
    let places = (PRECISION + 1 + under).saturating_sub(over);
    let excess = (over.saturating_sub(under)).saturating_sub(PRECISION + 1);
    let unit = match places {
        0 => BigRational::from_integer(BigInt::one() << excess),
        _ => BigRational::new(BigInt::one(), BigInt::one() << places),
    };
    let steps = value / &unit;
    match side {
        Ordering::Less => steps.floor() * unit,
        _ => steps.ceil() * unit,
    }
}

impl Add for &Interval {
    type Output = Interval;
    fn add(self, other: &Interval) -> Interval {
        let (low, high) = (&self.low + &other.low, &self.high + &other.high);
        Interval { low, high }.trimmed()
    }
}

impl Neg for &Interval {
    type Output = Interval;
    fn neg(self) -> Interval {
        Interval {
            low: -self.high.clone(),
            high: -self.low.clone(),
        }
    }
}

impl Sub for &Interval {
    type Output = Interval;
    fn sub(self, other: &Interval) -> Interval {
        self + &-other
    }
}

impl Mul for &Interval {
    type Output = Interval;
    fn mul(self, other: &Interval) -> Interval {
        let first = &self.low * &other.low;
        let (mut low, mut high) = (first.clone(), first);
        for product in [
            &self.low * &other.high,
            &self.high * &other.low,
            &self.high * &other.high,
        ] {
            if product < low {
                low = product;
            } else if product > high {
                high = product;
            }
        }
        Interval { low, high }.trimmed()
    }
}

/// Exact, ends and all.
impl fmt::Display for Interval {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "[{}, {}]", self.low, self.high)
    }
}
