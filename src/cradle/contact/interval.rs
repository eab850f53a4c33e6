//! Positive numbers known to within bounds.

use std::fmt;
use std::ops::{Div, Mul};

/// All numbers from `low` to `high`, both positive.
///
/// Each operation gives an interval that contains every result, rounding included: the sums, products and quotients of
/// floating point are off by at most half a unit in the last place, so one unit outwards is enough. Powers carry
/// no such promise and are widened by [`POWER_ERROR`], which is thousands of units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    low: f64,
    high: f64,
}

/// What a power may be off by, as a share of itself.
pub const POWER_ERROR: f64 = 1e-12;

impl Interval {
    /// All numbers from `low` to `high`.
    ///
    /// # Panics
    /// Unless `0 < low ≤ high`, both finite.
    pub const fn new(low: f64, high: f64) -> Self {
        assert!(
            0.0 < low && low <= high && high < f64::INFINITY,
            "an interval runs from a positive number to a larger one"
        );
        Interval { low, high }
    }

    /// A number that floating point knows exactly.
    ///
    /// # Panics
    /// Unless it is positive and finite.
    pub const fn exactly(value: f64) -> Self {
        Interval::new(value, value)
    }

    /// The lower bound.
    pub const fn low(self) -> f64 {
        self.low
    }

    /// The upper bound.
    pub const fn high(self) -> f64 {
        self.high
    }

    /// Whether a number lies within.
    pub fn contains(self, value: f64) -> bool {
        (self.low..=self.high).contains(&value)
    }

    /// A power with any exponent.
    #[must_use]
    pub fn powf(self, exponent: f64) -> Self {
        let (a, b) = (self.low.powf(exponent), self.high.powf(exponent));
        Interval::new(
            a.min(b) * (1.0 - POWER_ERROR),
            a.max(b) * (1.0 + POWER_ERROR),
        )
    }

    /// Wider by a share of each bound.
    #[must_use]
    pub fn widened(self, share: f64) -> Self {
        self * Interval::new((1.0 - share).next_down(), (1.0 + share).next_up())
    }

    /// `1 − x` for each of its numbers.
    ///
    /// # Panics
    /// Unless all of them are below 1.
    #[must_use]
    pub fn from_one(self) -> Self {
        Interval::new((1.0 - self.high).next_down(), (1.0 - self.low).next_up())
    }

    /// From this lower bound to that upper one, each with a number taken away that is known to lie in `other`.
    ///
    /// # Panics
    /// Unless what remains is positive.
    #[must_use]
    pub fn less(self, other: Interval) -> Self {
        Interval::new(
            (self.low - other.high).next_down(),
            (self.high - other.low).next_up(),
        )
    }
}

impl Mul for Interval {
    type Output = Interval;

    fn mul(self, other: Interval) -> Interval {
        Interval::new(
            (self.low * other.low).next_down(),
            (self.high * other.high).next_up(),
        )
    }
}

impl Div for Interval {
    type Output = Interval;

    fn div(self, other: Interval) -> Interval {
        Interval::new(
            (self.low / other.high).next_down(),
            (self.high / other.low).next_up(),
        )
    }
}

impl fmt::Display for Interval {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:.2e} … {:.2e}", self.low, self.high)
    }
}
