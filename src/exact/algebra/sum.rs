//! Sums of terms that are written out.

use super::lower::Lowered;
use super::{Expr, Fraction, Lowering, Polynomial};

/// Sums of more terms than this are put together at once.
const MANY: usize = 32;

impl Lowering<'_> {
    /// The value of a sum.
    pub(super) fn sum(&mut self, terms: &[Expr]) -> Lowered {
        if terms.len() > MANY {
            return self.long_sum(terms);
        }
        let Some((first, rest)) = terms.split_first() else {
            return Ok(Fraction::default());
        };
        let mut sum = self.lower(first)?;
        for term in rest {
            sum = sum.plus(&self.lower(term)?)?;
        }
        Ok(sum)
    }

    /// A sum of many terms: those that are polynomials are put together at once, so that its cost does not grow with the square of
    /// their number; what is divided is added one after another.
    fn long_sum(&mut self, terms: &[Expr]) -> Lowered {
        let mut polynomials = Vec::with_capacity(terms.len());
        let mut rest = Fraction::default();
        for term in terms {
            let own = self.lower(term)?;
            match own.as_polynomial() {
                Some(polynomial) => polynomials.push(polynomial.clone()),
                None => rest = rest.plus(&own)?,
            }
        }
        Ok(rest.plus(&Polynomial::sum(polynomials).into())?)
    }
}
