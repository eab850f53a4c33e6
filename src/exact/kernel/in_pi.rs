//! Exact numbers: polynomials in π with rational coefficients; or, at points of their own, in a power of `e`.
//!
//! π is transcendental: a polynomial in it with rational coefficients vanishes only if all of them do. So whether
//! two such numbers are equal is decided by their coefficients, and an equation can be refuted without a digit of
//! π. Which of two is greater is decided by twenty digits, or not at all.

use std::cmp::Ordering;
use std::sync::LazyLock;

use num_traits::{One, Zero};

use super::Reject;
use crate::algebra::{BigInt, BigRational, Expr, Polynomial, Rational, Var, product_of, raised};

/// Longer polynomials are refused.
const MOST_POWERS: usize = 48;

/// `Σ c_k π^k`; the last coefficient is not 0.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct InPi(Vec<Rational>);

impl InPi {
    pub fn new(coefficients: impl IntoIterator<Item = Rational>) -> InPi {
        let mut all: Vec<Rational> = coefficients.into_iter().collect();
        while all.last().is_some_and(Rational::is_zero) {
            all.pop();
        }
        InPi(all)
    }

    pub fn rational(value: Rational) -> InPi {
        InPi::new([value])
    }

    pub fn pi() -> InPi {
        InPi::new([Rational::zero(), Rational::one()])
    }

    pub fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    /// `π^k`, or that of the number in its place.
    pub fn power(exponent: u32) -> Result<InPi, Reject> {
        let exponent = exponent as usize;
        if exponent >= MOST_POWERS {
            return Err(Reject::TooLarge);
        }
        let zeros = std::iter::repeat_n(Rational::zero(), exponent);
        Ok(InPi::new(zeros.chain([Rational::one()])))
    }

    pub fn as_rational(&self) -> Option<Rational> {
        match self.0.as_slice() {
            [] => Some(Rational::zero()),
            [only] => Some(only.clone()),
            _ => None,
        }
    }

    /// `c π^k` as `c`, which is not 0, and `k`.
    pub fn as_multiple(&self) -> Option<(Rational, usize)> {
        let (last, lower) = self.0.split_last()?;
        let is_alone = lower.iter().all(Rational::is_zero);
        is_alone.then(|| (last.clone(), lower.len()))
    }

    /// Numbers over the one power of π that each of them is a multiple of; `None` where there is no such power.
    pub fn without_common_power(numbers: &[InPi]) -> Option<Vec<Rational>> {
        let is_known = |number: &&InPi| !number.is_zero();
        let length = numbers.iter().find(is_known).map_or(0, |own| own.0.len());
        let over = |number: &InPi| match number.0.split_last() {
            None => Some(Rational::zero()),
            Some((last, lower)) => {
                let is_alone = number.0.len() == length && lower.iter().all(Rational::is_zero);
                is_alone.then(|| last.clone())
            }
        };
        numbers.iter().map(over).collect()
    }

    pub fn coefficients(&self) -> &[Rational] {
        &self.0
    }

    pub fn plus(&self, other: &InPi) -> InPi {
        let length = self.0.len().max(other.0.len());
        let at = |list: &[Rational], k| list.get(k).cloned().unwrap_or_else(Rational::zero);
        InPi::new((0..length).map(|k| at(&self.0, k) + at(&other.0, k)))
    }

    pub fn scaled(&self, factor: &Rational) -> InPi {
        InPi::new(self.0.iter().map(|c| c * factor))
    }

    pub fn times(&self, other: &InPi) -> Result<InPi, Reject> {
        if self.0.len() + other.0.len() > MOST_POWERS {
            return Err(Reject::TooLarge);
        }
        let mut all = vec![Rational::zero(); (self.0.len() + other.0.len()).saturating_sub(1)];
        for (i, a) in self.0.iter().enumerate() {
            for (j, b) in other.0.iter().enumerate() {
                all[i + j] += a * b;
            }
        }
        Ok(InPi::new(all))
    }

    /// How it compares with 0; an error where twenty digits do not tell.
    pub fn sign(&self) -> Result<Ordering, Reject> {
        let first = self.sign_between(&FIRST_DIGITS);
        first.or_else(|_| self.sign_between(&DIGITS))
    }

    /// The same where what it is a polynomial in lies between two positive numbers.
    pub fn sign_between(&self, (low, high): &(Rational, Rational)) -> Result<Ordering, Reject> {
        if self.is_zero() {
            return Ok(Ordering::Equal);
        }
        // No digit of π is needed for a number without it.
        if let [only] = self.0.as_slice() {
            return Ok(match only.is_positive() {
                true => Ordering::Greater,
                false => Ordering::Less,
            });
        }
        let (mut least, mut most) = (Rational::zero(), Rational::zero());
        let (mut low_power, mut high_power) = (Rational::one(), Rational::one());
        for (at, c) in self.0.iter().enumerate() {
            if at > 0 {
                low_power *= low;
                high_power *= high;
            }
            let (a, b) = (c * &low_power, c * &high_power);
            match c.is_negative() {
                true => (least, most) = (least + b, most + a),
                false => (least, most) = (least + a, most + b),
            }
        }
        match (least.is_positive(), most.is_negative()) {
            (true, _) => Ok(Ordering::Greater),
            (_, true) => Ok(Ordering::Less),
            _ => Err(Reject::NoValue),
        }
    }

    /// The value of a polynomial, its unknowns being such numbers.
    pub fn evaluate(
        polynomial: &Polynomial,
        value: impl Fn(Var) -> Option<InPi>,
    ) -> Result<InPi, Reject> {
        let mut sum = InPi::default();
        for (monomial, coefficient) in polynomial.terms() {
            let mut term = InPi::rational(coefficient.clone());
            for &(var, exponent) in monomial.powers() {
                let own = value(var).ok_or(Reject::NoValue)?;
                if let Some(number) = own.as_rational() {
                    let power = Polynomial::constant(number).pow(exponent)?;
                    term = term.scaled(&power.as_constant().ok_or(Reject::NoValue)?);
                    continue;
                }
                if exponent as usize > MOST_POWERS {
                    return Err(Reject::TooLarge);
                }
                for _ in 0..exponent {
                    term = term.times(&own)?;
                }
            }
            sum = sum.plus(&term);
        }
        Ok(sum)
    }
}

/// `3.1415926 < π < 3.1415927`: with numbers that fit in machine words most signs are told already.
static FIRST_DIGITS: LazyLock<(Rational, Rational)> = LazyLock::new(|| {
    let number = |digits| Rational::ratio(digits, 10_000_000);
    (number(31_415_926), number(31_415_927))
});

/// `3.14159265358979323846 < π < 3.14159265358979323847`.
static DIGITS: LazyLock<(Rational, Rational)> = LazyLock::new(|| {
    let below = BigInt::from(314_159_265_358_979_323_846_i128);
    let scale = BigInt::from(10).pow(20);
    let above = &below + BigInt::one();
    let number = |n| Rational::from(BigRational::new(n, scale.clone()));
    (number(below), number(above))
});

/// `Σ c_k π^k` as a term.
pub fn in_powers_of_pi(coefficients: &[BigRational]) -> Expr {
    let terms = coefficients
        .iter()
        .zip(0_u32..)
        .filter(|(c, _)| !c.is_zero());
    let mut terms: Vec<Expr> = terms
        .map(|(c, k)| {
            let mut factors = vec![Expr::Number(c.clone())];
            if k > 0 {
                factors.push(raised(Expr::symbol("\\pi"), k));
            }
            factors.retain(|f| k == 0 || !f.is_one());
            product_of(factors)
        })
        .collect();
    match terms.len() {
        0 => Expr::integer(0),
        1 => terms.remove(0),
        _ => Expr::Sum(terms.into()),
    }
}
