//! What an equation between logarithms says without them: `\ln x - \ln y + r = 0` says that `x e^r = y`.
//!
//! An exponential is taken of what is 0, so it is 1; that there are the logarithms says that what they are of is positive. A factor
//! that all logarithms have, `u` in `v = u \ln(m_0/m)`, is divided by where it is known not to be 0.

use super::{Knowledge, Origin, Problem, Reject, Sign};
use crate::algebra::{
    Atom, Expr, Fraction, Function, Monomial, Polynomial, Rational, Var, expr_of, expr_of_fraction,
};

/// Longer equations are left as they are.
const MOST_TERMS: usize = 8;

impl Problem {
    /// Adds what follows from each premise that is linear in logarithms, where exponentials are spoken of.
    pub(super) fn add_facts_about_logarithms(
        &mut self,
        knowledge: &Knowledge,
    ) -> Result<(), Reject> {
        let exponential = |atom: &Atom| matches!(atom, Atom::Opaque(Expr::Call(Function::Exp, _)));
        if !self.atoms.iter().any(|(_, atom)| exponential(atom)) {
            return Ok(());
        }
        let equations = self.facts.iter().zip(&self.origins);
        let equations = equations.filter(|(fact, origin)| {
            fact.sign == Sign::Zero && matches!(origin, Origin::Hypothesis(_))
        });
        let linear: Vec<(Polynomial, Monomial, Origin)> = equations
            .filter_map(|(fact, origin)| {
                let factor = self.factor_of_logarithms(&fact.polynomial)?;
                let known = factor.is_one() || knowledge.monomial_is_nonzero(&factor);
                known.then(|| (fact.polynomial.clone(), factor, origin.clone()))
            })
            .collect();
        for (equation, factor, origin) in linear {
            let over = expr_of(&equation, &self.atoms);
            let under = expr_of(&Polynomial::term(factor, Rational::one()), &self.atoms);
            let exponent = Expr::Quotient(over.into(), under.into());
            let mut lowering = self.lowering();
            let value = lowering.lower(&Expr::Call(Function::Exp, exponent.into()))?;
            // Powers that are not whole would need more than is known.
            let plain = lowering.conditions.nonnegative.is_empty()
                && lowering.conditions.bases.is_empty()
                && lowering.conditions.away.is_empty()
                && lowering.conditions.doubtful.is_empty();
            if !plain || self.speaks_of_logarithms(&value) {
                continue;
            }
            let one = Fraction::from(Rational::one());
            let less = value.minus(&one)?;
            self.add(less.numerator().clone(), Sign::Zero, origin);
        }
        Ok(())
    }

    /// What all logarithms in an equation are multiplied by, where each stands once by itself.
    fn factor_of_logarithms(&self, equation: &Polynomial) -> Option<Monomial> {
        if equation.len() > MOST_TERMS {
            return None;
        }
        let mut factor = None;
        for (monomial, number) in equation.terms() {
            let logarithms = monomial.powers().iter();
            let mut logarithms = logarithms.filter(|&&(var, _)| self.is_logarithm(var));
            let Some(&(var, exponent)) = logarithms.next() else {
                continue;
            };
            if exponent > 1 || logarithms.next().is_some() || !number.is_integer() {
                return None;
            }
            let own = monomial.without(var);
            match &factor {
                None => factor = Some(own),
                Some(known) if *known == own => {}
                Some(_) => return None,
            }
        }
        factor
    }

    fn is_logarithm(&self, var: Var) -> bool {
        matches!(
            self.atoms.atom(var),
            Atom::Opaque(Expr::Call(Function::Ln, _))
        )
    }

    fn speaks_of_logarithms(&self, value: &Fraction) -> bool {
        let is_logarithm = |part: &Expr| matches!(part, Expr::Call(Function::Ln, _));
        expr_of_fraction(value, &self.atoms).any(&is_logarithm)
    }
}
