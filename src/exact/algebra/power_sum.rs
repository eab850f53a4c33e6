//! Sums over all elements of sequences, `Σ_{i=1}^{n} x_i² y_i`: linear combinations of unknowns, the power sums.

use super::lower::{LowerError, Lowering};
use super::{Atom, Atoms, Fraction, Monomial, Polynomial, Symbol, Var};

impl Lowering<'_> {
    /// `Σ_i` of a polynomial in the elements, as a linear combination of power sums.
    pub(super) fn power_sums(
        &mut self,
        body: &Fraction,
        index: &Symbol,
        count: &Symbol,
    ) -> Result<Option<Fraction>, LowerError> {
        let bound_sequence = |atoms: &Atoms, var: Var| match atoms.atom(var) {
            Atom::Bound { sequence, index: i } if i == index => Some(sequence.clone()),
            _ => None,
        };
        for (factor, _) in body.denominator() {
            if factor.vars().iter().any(|&v| self.depends(v, index)) {
                return Ok(None);
            }
        }
        let mut sum = Polynomial::zero();
        for (monomial, coefficient) in body.numerator().terms() {
            let (mut outside, mut powers) = (Monomial::one(), Vec::new());
            for &(var, exponent) in monomial.powers() {
                match bound_sequence(self.atoms, var) {
                    Some(sequence) => powers.push((sequence, exponent)),
                    None if self.depends(var, index) => return Ok(None),
                    None => outside = outside.times(&Monomial::power(var, exponent)),
                }
            }
            powers.sort();
            let total = power_sum(count, powers);
            let var = self.atoms.var(total);
            let term =
                Polynomial::term(outside.times(&Monomial::power(var, 1)), coefficient.clone());
            sum = sum.plus(&term);
        }
        let mut value = Fraction::from(sum);
        for (factor, exponent) in body.denominator() {
            let inverse = Fraction::from(factor.clone()).pow(exponent)?.recip()?;
            value = value.times(&inverse.ok_or(LowerError::DivisionByZero)?)?;
        }
        Ok(Some(value))
    }

    /// Whether an unknown is another at another value of a bound index.
    pub(super) fn depends(&self, var: Var, index: &Symbol) -> bool {
        match self.atoms.atom(var) {
            Atom::Bound { index: own, .. } => own == index,
            Atom::Symbol(symbol) | Atom::Root { of: symbol, .. } => symbol == index,
            Atom::PowerSum { to, .. } => to == index,
            Atom::Opaque(expr) => expr.mentions(index),
            Atom::Element { .. } => false,
        }
    }
}

/// `Σ_{i=1}^{count}` of a product of elements, or the count itself for the empty product.
pub fn power_sum(count: &Symbol, powers: Vec<(Symbol, u32)>) -> Atom {
    if powers.is_empty() {
        return Atom::Symbol(count.clone());
    }
    Atom::PowerSum {
        to: count.clone(),
        powers,
    }
}
