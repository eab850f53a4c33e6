//! Sums of terms that are written out.

use super::lower::Lowered;
use super::{Expr, Fraction, Lowering, Polynomial};

/// Of sums with more terms than this also those are put together at once that have terms with something else below.
const MANY: usize = 32;

impl Lowering<'_> {
    /// The value of a sum. Polynomials are put together at once, so that the cost does not grow with the square of their number; where
    /// few terms are divided by something, one is added after another, and what can be cancelled is cancelled on the way.
    pub(super) fn sum(&mut self, terms: &[Expr]) -> Lowered {
        let terms = terms.iter().map(|term| self.lower(term));
        let terms: Vec<Fraction> = terms.collect::<Result<_, _>>()?;
        let is_polynomial = |term: &Fraction| term.as_polynomial().is_some();
        let put_together = |polynomials: Vec<Fraction>| {
            let polynomials = polynomials.into_iter().map(|term| term.into_parts().0);
            Fraction::from(Polynomial::sum(polynomials))
        };
        if terms.iter().all(is_polynomial) {
            return Ok(put_together(terms));
        }
        if terms.len() <= MANY {
            let mut terms = terms.into_iter();
            let first = terms.next().unwrap_or_default();
            return Ok(terms.try_fold(first, |sum, term| sum.plus(&term))?);
        }
        let (polynomials, divided): (Vec<_>, Vec<_>) = terms.into_iter().partition(is_polynomial);
        let mut divided = divided.into_iter();
        let rest = divided.try_fold(Fraction::default(), |sum, term| sum.plus(&term))?;
        Ok(rest.plus(&put_together(polynomials))?)
    }
}
