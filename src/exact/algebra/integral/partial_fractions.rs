//! Powers of the variable over linear factors, by partial fractions.

use super::super::lower::{LowerError, Lowering};
use super::super::{Fraction, Polynomial, Rational};
use super::{Moving, Range, small};

/// More factors than these are not taken apart into partial fractions.
const MOST_PARTS: u64 = 6;

impl Lowering<'_> {
    /// The integral of a power of the variable over linear factors, or of one over several of these, by partial fractions.
    pub(super) fn fractions_between(
        &mut self,
        term: &Moving,
        linear: &[(Polynomial, u32)],
        range: &Range,
    ) -> Result<Option<Fraction>, LowerError> {
        let mut linear = linear.to_vec();
        let mut power = term.power.clone();
        if power.is_negative() {
            let Some(exponent) = small(&-&power) else {
                return Ok(None);
            };
            linear.push((Polynomial::var(range.own), exponent));
            power = Rational::zero();
        }
        let size = linear.iter().map(|own| u64::from(own.1)).sum::<u64>();
        if small(&power).is_none_or(|power| size + u64::from(power) > MOST_PARTS) {
            return Ok(None);
        }
        // The same with one factor less of some, and another power of the variable.
        let less = |own: &mut Self, power: &Rational, factor: Option<usize>| {
            let mut fewer = linear.clone();
            if let Some(at) = factor {
                fewer[at].1 -= 1;
            }
            fewer.retain(|own| own.1 > 0);
            let term = Moving {
                power: power.clone(),
                factors: Vec::new(),
                linear: fewer,
            };
            own.between(&term, range)
        };
        let one = Rational::one();
        let parts = |own: &Self, at: usize| {
            let slope = own.slope(&linear[at].0, range)?;
            let rest = linear[at].0.in_powers_of(range.own).into_iter().next()?;
            Some((slope, rest))
        };
        // x = ((a + b x) - a)/b; and b/(a + b x) - d/(c + d x) is (b c - a d) over both.
        let (first, second, divisor) = if power.is_positive() {
            let Some((slope, rest)) = parts(self, 0) else {
                return Ok(None);
            };
            let fewer = &power - &one;
            let first = less(self, &fewer, Some(0))?;
            let second = less(self, &fewer, None)?;
            let second = second.map(|own| own.times(&rest.into())).transpose()?;
            (first, second, slope)
        } else {
            let (Some((b, a)), Some((d, c))) = (parts(self, 0), parts(self, 1)) else {
                return Ok(None);
            };
            let between = b.times(&c)?.minus(&a.times(&d)?);
            let first = less(self, &power, Some(1))?;
            let second = less(self, &power, Some(0))?;
            let first = first.map(|own| own.times(&b.into())).transpose()?;
            let second = second.map(|own| own.times(&d.into())).transpose()?;
            (first, second, between)
        };
        let (Some(first), Some(second)) = (first, second) else {
            return Ok(None);
        };
        if divisor.is_zero() {
            return Ok(None);
        }
        let over = self.recip(&divisor.into())?;
        Ok(Some(first.minus(&second)?.times(&over)?))
    }
}
