use super::lower::Lowered;
use super::{Expr, Fraction, Lowering, Polynomial};

impl Lowering<'_> {
    /// A sum of many terms: those that are polynomials are put together at once, so that its cost does not grow with the square of
    /// their number; what is divided is added one after another.
    pub(super) fn long_sum(&mut self, terms: &[Expr]) -> Lowered {
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
