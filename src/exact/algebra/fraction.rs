use std::borrow::Cow;

use super::effort::is_spent;
use super::{BigRational, Polynomial, Rational, TooLarge, Var};
use crate::sorted::Map;

/// A rational function whose denominator is kept in factors.
///
/// The factors are monic and none is constant; a monomial is split into its unknowns. Common factors are
/// cancelled where that is a plain division, so equality is decided by cross-multiplying, not by comparing.
#[derive(Clone, Debug, PartialEq, Eq, Default)]
pub struct Fraction {
    numerator: Polynomial,
    denominator: Map<Polynomial, u32>,
}

impl From<Polynomial> for Fraction {
    fn from(numerator: Polynomial) -> Self {
        Fraction {
            numerator,
            denominator: Map::new(),
        }
    }
}

impl Fraction {
    /// The numerator.
    pub fn numerator(&self) -> &Polynomial {
        &self.numerator
    }

    /// The factors of the denominator with their exponents.
    pub fn denominator(&self) -> impl Iterator<Item = (&Polynomial, u32)> {
        self.denominator.iter().map(|(p, &e)| (p, e))
    }

    /// The denominator, multiplied out.
    pub fn expanded_denominator(&self) -> Result<Polynomial, TooLarge> {
        product(self.denominator())
    }

    /// The value as a polynomial, where nothing is divided by.
    pub fn as_polynomial(&self) -> Option<&Polynomial> {
        self.denominator.is_empty().then_some(&self.numerator)
    }

    /// The value, where no unknown occurs.
    pub fn as_constant(&self) -> Option<Rational> {
        self.as_polynomial()?.as_constant()
    }

    /// The numerator, and the factors of the denominator with their exponents.
    pub fn into_parts(self) -> (Polynomial, Map<Polynomial, u32>) {
        (self.numerator, self.denominator)
    }

    /// The sum.
    pub fn plus(&self, other: &Self) -> Result<Self, TooLarge> {
        if let (Some(a), Some(b)) = (self.as_polynomial(), other.as_polynomial())
            && !is_spent()
        {
            return Ok(a.plus(b).into());
        }
        self.joined(other, Polynomial::plus)
    }

    /// The difference.
    pub fn minus(&self, other: &Self) -> Result<Self, TooLarge> {
        if let (Some(a), Some(b)) = (self.as_polynomial(), other.as_polynomial()) {
            return Ok(a.minus(b).into());
        }
        self.joined(other, Polynomial::minus)
    }

    /// The sum or the difference, which is that of the numerators over a common denominator.
    fn joined(
        &self,
        other: &Self,
        join: fn(&Polynomial, &Polynomial) -> Polynomial,
    ) -> Result<Self, TooLarge> {
        if is_spent() {
            return Err(TooLarge);
        }
        if self.denominator == other.denominator {
            let sum = Fraction {
                numerator: join(&self.numerator, &other.numerator),
                denominator: self.denominator.clone(),
            };
            return Ok(sum.cancelled());
        }
        let mut denominator = self.denominator.clone();
        for (factor, exponent) in other.denominator() {
            let slot = denominator.entry(factor.clone()).or_insert(0);
            *slot = (*slot).max(exponent);
        }
        let left = self.extended_to(&denominator)?;
        let right = other.extended_to(&denominator)?;
        Ok(Fraction {
            numerator: join(&left, &right),
            denominator,
        }
        .cancelled())
    }

    /// The numerator that this fraction has over a larger denominator.
    fn extended_to<'a>(
        &'a self,
        denominator: &'a Map<Polynomial, u32>,
    ) -> Result<Cow<'a, Polynomial>, TooLarge> {
        let own = |factor| self.denominator.get(factor).copied().unwrap_or(0);
        let mut missing = denominator.iter().map(|(f, &e)| (f, e - own(f)));
        let numerator = Cow::Borrowed(&self.numerator);
        missing.try_fold(numerator, |product, (factor, exponent)| {
            times_power(product, factor, exponent)
        })
    }

    /// The product.
    pub fn times(&self, other: &Self) -> Result<Self, TooLarge> {
        if let (Some(a), Some(b)) = (self.as_polynomial(), other.as_polynomial()) {
            return Ok(a.times(b)?.into());
        }
        let denominator = match self.denominator.is_empty() {
            true => other.denominator.clone(),
            false => {
                let mut denominator = self.denominator.clone();
                for (factor, exponent) in other.denominator() {
                    let slot = denominator.entry(factor.clone()).or_insert(0);
                    *slot = slot.checked_add(exponent).ok_or(TooLarge)?;
                }
                denominator
            }
        };
        Ok(Fraction {
            numerator: self.numerator.times(&other.numerator)?,
            denominator,
        }
        .cancelled())
    }

    /// The negative.
    pub fn negated(&self) -> Self {
        Fraction {
            numerator: self.numerator.negated(),
            denominator: self.denominator.clone(),
        }
    }

    /// `1 / self`; `None` for 0.
    pub fn recip(&self) -> Result<Option<Self>, TooLarge> {
        let Some((_, lead)) = self.numerator.leading() else {
            return Ok(None);
        };
        let numerator = match self.denominator.is_empty() {
            true => Polynomial::constant(lead.recip()),
            false => self.expanded_denominator()?.scaled(&lead.recip()),
        };
        Ok(Some(Fraction {
            numerator,
            denominator: factors(&self.numerator),
        }))
    }

    /// A natural power.
    pub fn pow(&self, exponent: u32) -> Result<Self, TooLarge> {
        let mut denominator = Map::new();
        for (factor, own) in self.denominator() {
            let raised = own.checked_mul(exponent).ok_or(TooLarge)?;
            if raised > 0 {
                denominator.insert(factor.clone(), raised);
            }
        }
        Ok(Fraction {
            numerator: self.numerator.pow(exponent)?,
            denominator,
        })
    }

    fn cancelled(mut self) -> Self {
        if self.denominator.is_empty() {
            return self;
        }
        if self.numerator.is_zero() {
            self.denominator.clear();
            return self;
        }
        for (factor, exponent) in &mut self.denominator {
            while *exponent > 0 {
                let Some(quotient) = self.numerator.divided_by(factor) else {
                    break;
                };
                self.numerator = quotient;
                *exponent -= 1;
            }
        }
        self.denominator.retain(|_, exponent| *exponent > 0);
        self
    }
}

/// The product of powers, multiplied out.
pub fn product<'a>(
    powers: impl Iterator<Item = (&'a Polynomial, u32)>,
) -> Result<Polynomial, TooLarge> {
    Ok(times_all(Cow::Owned(Polynomial::one()), powers)?.into_owned())
}

/// The same with something else; that is not copied where there are no powers.
pub fn times_all<'a>(
    first: Cow<'a, Polynomial>,
    mut powers: impl Iterator<Item = (&'a Polynomial, u32)>,
) -> Result<Cow<'a, Polynomial>, TooLarge> {
    powers.try_fold(first, |product, (factor, exponent)| {
        times_power(product, factor, exponent)
    })
}

/// A product with a power; nothing is copied where either is 1.
fn times_power<'a>(
    product: Cow<'a, Polynomial>,
    factor: &'a Polynomial,
    exponent: u32,
) -> Result<Cow<'a, Polynomial>, TooLarge> {
    let power = match exponent {
        0 => return Ok(product),
        1 => Cow::Borrowed(factor),
        _ => Cow::Owned(factor.pow(exponent)?),
    };
    Ok(match product.is_one() {
        true => power,
        false => Cow::Owned(product.times(&power)?),
    })
}

/// The factors that a polynomial visibly has: its unknowns' powers and what is left, monic. Constants are dropped.
pub fn factors(polynomial: &Polynomial) -> Map<Polynomial, u32> {
    let content = polynomial.content();
    // Of two unknowns the later one comes first.
    let powers = content.powers().iter().rev();
    let mut factors: Map<Polynomial, u32> = powers
        .map(|&(v, e): &(Var, u32)| (Polynomial::var(v), e))
        .collect();
    // A single term is its unknowns and a number.
    if polynomial.len() == 1 {
        return factors;
    }
    let whole = Polynomial::term(content, Rational::one());
    if let Some(rest) = polynomial.divided_by(&whole)
        && rest.as_constant().is_none()
    {
        *factors.entry(rest.monic()).or_insert(0) += 1;
    }
    factors
}

impl From<Rational> for Fraction {
    fn from(value: Rational) -> Self {
        Polynomial::constant(value).into()
    }
}

impl From<BigRational> for Fraction {
    fn from(value: BigRational) -> Self {
        Rational::from(value).into()
    }
}

impl Fraction {
    /// Whether this is 0.
    pub fn is_zero(&self) -> bool {
        self.numerator.is_zero()
    }
}
