//! Intervals with exact rational ends.
//!
//! An interval stands for all real numbers between its ends. Every operation gives one that contains each value that the operation
//! can take; sums, products and quotients are exact, roots and elementary functions are rounded outwards. Nothing here is a proof in the sense of the kernel: what
//! comes out is as good as the figures that go in.

mod function;
mod power;
mod term;

use std::cmp::Ordering;
use std::fmt;
use std::ops::{Add, Mul, Neg, Sub};
use std::sync::LazyLock;

use num_integer::Integer;
use num_traits::{One, Signed, Zero};

use crate::algebra::{BigInt, BigRational, Function};

pub use term::{Compared, Figures, NoInterval};

/// Ends are rounded outwards by at most one part in 2 to this power, where they are rounded at all.
pub const PRECISION: u64 = 40;

/// What is known of π.
static PI: LazyLock<Interval> = LazyLock::new(|| {
    let digits = BigInt::from(314_159_265_358_979_323_u64);
    let unit = BigInt::from(100_000_000_000_000_000_u64);
    Interval {
        high: BigRational::new(&digits + 1, unit.clone()),
        low: BigRational::new(digits, unit),
    }
});

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

    /// The values of a function; nothing where it may have none, or its argument is out of all proportion.
    pub fn under(&self, function: Function) -> Option<Interval> {
        function::call(function, self)
    }

    /// Ends of bounded length: a little wider where they have grown too long.
    fn trimmed(self) -> Interval {
        let round = |end: BigRational, side| {
            let (over, under) = end.into_raw();
            rounded(over, under, side)
        };
        Interval {
            low: round(self.low, Ordering::Less),
            high: round(self.high, Ordering::Greater),
        }
    }
}

/// A number below or above `over / under`, which need not be in lowest terms, or that number where both parts of it fit in 64 bits;
/// `under` is positive.
///
/// What is rounded is a whole number of some power of 2, and is brought to lowest terms by shifting: reducing first what is rounded
/// anyway would be most of the work.
fn rounded(over: BigInt, under: BigInt, side: Ordering) -> BigRational {
    let (above, below) = (over.bits(), under.bits());
    if let (Ok(above), Ok(below)) = (over.magnitude().try_into(), under.magnitude().try_into()) {
        // What fits in a machine word is divided by its common divisor in few steps.
        return match u64::gcd(&above, &below) {
            1 => BigRational::new_raw(over, under),
            common => BigRational::new_raw(over / common, under / common),
        };
    }
    // So many binary places that `PRECISION` bits remain.
    let places = (PRECISION + 1 + below).saturating_sub(above);
    let excess = above.saturating_sub(below).saturating_sub(PRECISION + 1);
    let (over, under) = (over << places, under << excess);
    let steps = match side {
        Ordering::Less => over.div_floor(&under),
        _ => over.div_ceil(&under),
    };
    let rounded = in_binary(steps, places);
    BigRational::new_raw(rounded.numer() << excess, rounded.denom().clone())
}

/// So many steps of which `2^places` make 1, in lowest terms.
fn in_binary(steps: BigInt, places: u64) -> BigRational {
    let spare = steps.trailing_zeros().unwrap_or(places).min(places);
    BigRational::new_raw(steps >> spare, BigInt::one() << (places - spare))
}

impl Add for &Interval {
    type Output = Interval;
    fn add(self, other: &Interval) -> Interval {
        let sum = |a: &BigRational, b: &BigRational, side| {
            let over = a.numer() * b.denom() + b.numer() * a.denom();
            rounded(over, a.denom() * b.denom(), side)
        };
        Interval {
            low: sum(&self.low, &other.low, Ordering::Less),
            high: sum(&self.high, &other.high, Ordering::Greater),
        }
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
        let product = |a: &BigRational, b: &BigRational, side| {
            rounded(a.numer() * b.numer(), a.denom() * b.denom(), side)
        };
        // Rounding keeps the order, so the least and the greatest of the products may be sought after it.
        let ends = |side| {
            let all = [
                (&self.low, &other.low),
                (&self.low, &other.high),
                (&self.high, &other.low),
                (&self.high, &other.high),
            ];
            all.map(|(a, b)| product(a, b, side))
        };
        // What is below 0 throughout is multiplied without its sign: then its ends need not be sought.
        if self.high.is_negative() {
            return -&(&-self * other);
        }
        if other.high.is_negative() {
            return -&(self * &-other);
        }
        if !self.low.is_negative() && !other.low.is_negative() {
            return Interval {
                low: product(&self.low, &other.low, Ordering::Less),
                high: product(&self.high, &other.high, Ordering::Greater),
            };
        }
        let [a, b, c, d] = ends(Ordering::Less);
        let low = a.min(b).min(c.min(d));
        let [a, b, c, d] = ends(Ordering::Greater);
        let high = a.max(b).max(c.max(d));
        Interval { low, high }
    }
}

/// Exact, ends and all.
impl fmt::Display for Interval {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "[{}, {}]", self.low, self.high)
    }
}
