//! Laws differentiated: what is true for all values of a variable stays true where both sides are differentiated by it.

use super::{Knowledge, Origin, Problem, Reject, Sign, Standing};
use crate::algebra::{Atom, Expr, Function, Polynomial, Symbol};

/// A fact to be differentiated.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Rate {
    /// Its position: an equation that a law gives, or one that was made so.
    pub fact: usize,
    /// The variable.
    pub variable: Symbol,
}

impl Problem {
    /// The same problem with the derivatives of some equations added to its facts, in order.
    ///
    /// $$ f = 0 \text{ throughout} \implies \frac{df}{dx} = 0 $$
    ///
    /// What is said of one point only ([`Standing::AtPoint`]) gives none, nor does what may have no derivative: what is rounded, a
    /// root or an absolute value of what may vanish, and anything by a whole number.
    ///
    /// # Errors
    /// A fact that may not be differentiated.
    pub fn with_rates(&self, rates: &[Rate]) -> Result<Problem, Reject> {
        let mut problem = self.clone();
        for Rate { fact, variable } in rates {
            let known = Knowledge::new(&problem.facts);
            let law = problem.facts.get(*fact).ok_or(Reject::NoSuchFact(*fact))?;
            let hypothesis = match problem.origins[*fact] {
                Origin::Hypothesis(at) | Origin::Rate(at) if law.sign == Sign::Zero => at,
                _ => return Err(Reject::NoSuchFact(*fact)),
            };
            let standing = problem.formulas.get(hypothesis).map(|own| own.1);
            if standing != Some(Standing::Identity)
                || !problem.may_be_varied(variable)
                || !problem.is_smooth(&law.polynomial)
            {
                return Err(Reject::NoRate(*fact));
            }
            let polynomial = law.polynomial.clone();
            let mut lowering = problem.lowering();
            let slope = lowering.derivative(&polynomial.into(), variable)?;
            let needed = lowering.conditions;
            let seen = needed.divisors().all(|p| known.is_nonzero(p))
                && needed.nonnegative.iter().all(|p| known.is_nonnegative(p))
                && needed.positive.iter().all(|p| known.is_positive(p))
                && needed.zero.is_empty()
                && needed.doubtful.is_empty();
            if !seen {
                return Err(Reject::NoRate(*fact));
            }
            let polynomial = slope.numerator().clone();
            problem.add(polynomial, Sign::Zero, Origin::Rate(hypothesis));
        }
        Ok(problem)
    }

    /// Whether a symbol takes all values around any.
    fn may_be_varied(&self, variable: &Symbol) -> bool {
        let whole = self.integers.iter().any(|value| {
            let below = value.denominator().map(|(factor, _)| factor);
            let mut all = below.chain([value.numerator()]);
            all.any(|p| self.mentions(p, variable))
        });
        !whole && !self.is_count(variable) && !self.constants.contains(variable)
    }

    fn mentions(&self, polynomial: &Polynomial, symbol: &Symbol) -> bool {
        let mut vars = polynomial.vars().into_iter();
        vars.any(|var| crate::algebra::expr_of_atom(self.atoms.atom(var)).mentions(symbol))
    }

    /// Whether nothing in it jumps.
    fn is_smooth(&self, polynomial: &Polynomial) -> bool {
        let jumps = |part: &Expr| {
            matches!(
                part,
                Expr::Call(
                    Function::Ceiling | Function::Floor | Function::ArcSin | Function::ArcCos,
                    _
                ) | Expr::Limit { .. }
                    | Expr::Series { .. }
            )
        };
        polynomial
            .vars()
            .into_iter()
            .all(|var| match self.atoms.atom(var) {
                Atom::Opaque(term) => !term.any(&jumps),
                Atom::Bound { .. } => false,
                _ => true,
            })
    }
}
