use std::cmp::Ordering;

use num_integer::Integer;
use num_traits::{One, Signed, ToPrimitive};

use super::super::Reject;
use crate::algebra::{BigInt, BigRational, Rational};

/// No power that is computed is longer than this.
const MOST_BITS: u64 = 1 << 16;

/// A positive number as a product of rational powers of positive rationals, and of π: `2^{4/5}`, `3 π^{1/2}`.
///
/// It is never rounded. Two of them are compared by raising both to a power that makes every exponent an
/// integer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Size {
    /// Bases with their exponents. The kernel looks at each base: all are to be positive.
    pub powers: Vec<(Rational, Rational)>,
    /// The exponent of π, no product of powers of which is rational.
    pub pi: Rational,
}

impl Size {
    /// 1.
    pub fn one() -> Size {
        Size {
            powers: Vec::new(),
            pi: Rational::zero(),
        }
    }

    /// π.
    pub fn pi() -> Size {
        Size {
            powers: Vec::new(),
            pi: Rational::one(),
        }
    }

    /// `base^exponent`.
    pub fn power(base: Rational, exponent: Rational) -> Size {
        match base.is_one() || exponent.is_zero() {
            true => Size::one(),
            false => Size {
                powers: vec![(base, exponent)],
                pi: Rational::zero(),
            },
        }
    }

    /// Whether every base is positive.
    pub(super) fn is_positive(&self) -> bool {
        self.powers.iter().all(|(base, _)| base.is_positive())
    }

    /// The product of `self` and a power of another size.
    pub fn times(&self, other: &Size, exponent: &Rational) -> Size {
        let mut product = self.clone();
        for (base, own) in &other.powers {
            let raised = own * exponent;
            match product.powers.iter_mut().find(|p| p.0 == *base) {
                Some(slot) => slot.1 += raised,
                None => product.powers.push((base.clone(), raised)),
            }
        }
        product
            .powers
            .retain(|(base, e)| !e.is_zero() && !base.is_one());
        product.pi += &other.pi * exponent;
        product
    }

    /// `self / other`.
    pub fn over(&self, other: &Size) -> Size {
        self.times(other, &-Rational::one())
    }

    /// The rational `self^n`, with the `n` that makes every exponent an integer.
    fn cleared(&self) -> Result<(BigRational, u32), Reject> {
        if !self.pi.is_zero() {
            return Err(Reject::NoValue);
        }
        let common = self
            .powers
            .iter()
            .fold(BigInt::one(), |all, p| all.lcm(&p.1.denom()));
        let common = common.to_u32().ok_or(Reject::TooLarge)?;
        let mut value = BigRational::one();
        for (base, exponent) in &self.powers {
            let times = (exponent * &Rational::from(common)).numer();
            let base = base.to_big();
            let length = base.numer().bits().max(base.denom().bits());
            let count = times.abs().to_u64().ok_or(Reject::TooLarge)?;
            if length.saturating_mul(count) > MOST_BITS {
                return Err(Reject::TooLarge);
            }
            let power = times.to_i32().ok_or(Reject::TooLarge)?;
            value *= base.pow(power);
        }
        Ok((value, common))
    }

    /// Whether this is 1.
    ///
    /// # Errors
    /// The numbers are too long.
    pub fn is_one(&self) -> Result<bool, Reject> {
        // A product of rational powers of rationals is algebraic; a power of π with another exponent than 0 is not.
        match self.pi.is_zero() {
            true => Ok(self.against_one()?.is_eq()),
            false => Ok(false),
        }
    }

    /// How it compares with 1.
    ///
    /// # Errors
    /// The numbers are too long, or π occurs.
    pub fn against_one(&self) -> Result<Ordering, Reject> {
        // One power of a positive number is told without computing it, however long it is.
        if let ([(base, exponent)], true) = (&self.powers[..], self.pi.is_zero())
            && base.is_positive()
        {
            let order = base.cmp(&Rational::one());
            return Ok(match exponent.cmp(&Rational::zero()) {
                Ordering::Less => order.reverse(),
                Ordering::Equal => Ordering::Equal,
                Ordering::Greater => order,
            });
        }
        Ok(self.cleared()?.0.cmp(&BigRational::one()))
    }

    /// The value, where it is rational.
    ///
    /// # Errors
    /// The numbers are too long.
    pub fn as_rational(&self) -> Result<Option<Rational>, Reject> {
        if !self.pi.is_zero() {
            return Ok(None);
        }
        let (value, root) = self.cleared()?;
        let (above, below) = (value.numer().nth_root(root), value.denom().nth_root(root));
        let exact = above.pow(root) == *value.numer() && below.pow(root) == *value.denom();
        Ok(exact.then(|| BigRational::new(above, below).into()))
    }
}

impl Default for Size {
    fn default() -> Size {
        Size::one()
    }
}

impl From<Rational> for Size {
    fn from(value: Rational) -> Size {
        Size::power(value, Rational::one())
    }
}
