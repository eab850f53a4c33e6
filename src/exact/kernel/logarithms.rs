//! What an equation between logarithms says without them, `\ln x - \ln y + r = 0` says that `x e^r = y`; and what an equation between
//! products says with them, `x^p = c y` that `p \ln x = \ln c + \ln y`.
//!
//! An exponential is taken of what is 0, so it is 1; that there are the logarithms says that what they are of is positive. A factor
//! that all logarithms have, `u` in `v = u \ln(m_0/m)`, is divided by where it is known not to be 0. A logarithm is taken where both
//! products are known to be positive; then it says the same, so that it may be shown instead.

use super::{Fact, Knowledge, Origin, Problem, Reject, Sign};
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

    /// Adds the logarithms of premises between products, where exponentials or powers with symbols in the exponent are spoken of; and
    /// reads that of the goal.
    pub(super) fn take_logarithms(&mut self) -> Result<(), Reject> {
        let is_logarithm = |atom: &Atom| matches!(atom, Atom::Opaque(Expr::Call(Function::Ln, _)));
        let speaks = |atom: &Atom| is_raised(atom) || is_logarithm(atom);
        if !self.atoms.iter().any(|(_, atom)| speaks(atom)) {
            return Ok(());
        }
        let raises = self.atoms.iter().any(|(_, atom)| is_raised(atom));
        let equates = |fact: &Fact| fact.sign == Sign::Zero && fact.polynomial.len() == 2;
        let equations = self.facts.iter().zip(&self.origins);
        let equations = equations.filter_map(|(fact, origin)| match origin {
            Origin::Hypothesis(at) if equates(fact) => Some((fact.polynomial.clone(), *at)),
            _ => None,
        });
        let equations: Vec<(Polynomial, usize)> = equations.collect();
        let goal = equates(&self.goal).then(|| self.goal.polynomial.clone());
        if equations.is_empty() && goal.is_none() {
            return Ok(());
        }
        let knowledge = &Knowledge::new(&self.facts);
        for (equation, at) in equations {
            if let Some(taken) = self.logarithm_of(&equation, raises, knowledge)? {
                self.add(taken, Sign::Zero, Origin::Logarithms(at));
            }
        }
        if let Some(goal) = goal {
            self.goal_in_logarithms = self.logarithm_of(&goal, raises, knowledge)?;
        }
        Ok(())
    }

    /// The difference of the logarithms of two products that are known to be positive: it is 0 just where the products are equal. Where
    /// nothing `raises` anything to a power, only of what logarithms are spoken of.
    fn logarithm_of(
        &mut self,
        equation: &Polynomial,
        raises: bool,
        knowledge: &Knowledge,
    ) -> Result<Option<Polynomial>, Reject> {
        // What both sides have as a factor is divided by where it is not 0.
        let (factor, rest) = equation.without_content();
        let divided = knowledge.monomial_is_nonzero(&factor);
        let equation = if divided { &*rest } else { equation };
        let terms: Vec<Polynomial> = equation
            .terms()
            .map(|(monomial, number)| Polynomial::term(monomial.clone(), number.clone()))
            .collect();
        let (negative, positive): (Vec<Polynomial>, Vec<Polynomial>) = (terms.into_iter())
            .partition(|own| own.leading().is_some_and(|(_, c)| c.is_negative()));
        let ([negative], [positive]) = (negative.as_slice(), positive.as_slice()) else {
            return Ok(None);
        };
        let sides = [positive.clone(), negative.negated()];
        if !sides.iter().all(|own| knowledge.is_positive(own)) {
            return Ok(None);
        }
        let [more, less] =
            sides.map(|own| Expr::Call(Function::Ln, expr_of(&own, &self.atoms).into()));
        // Unknowns are added only where the logarithms are of use.
        let mut atoms = self.atoms.clone();
        let mut lowering = self.lowering_over(&mut atoms);
        let value = lowering.lower(&more)?.minus(&lowering.lower(&less)?)?;
        let conditions = lowering.conditions;
        let sure = conditions.divisors().all(|own| knowledge.is_nonzero(own))
            && conditions
                .positive
                .iter()
                .all(|own| knowledge.is_positive(own))
            && conditions.nonnegative.is_empty()
            && conditions.bases.is_empty()
            && conditions.away.is_empty()
            && conditions.zero.is_empty()
            && conditions.doubtful.is_empty()
            && value
                .denominator()
                .all(|(own, _)| knowledge.is_nonzero(own));
        if !sure || !raises && atoms.len() > self.atoms.len() {
            return Ok(None);
        }
        self.atoms = atoms;
        Ok(Some(value.numerator().clone()))
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

/// `e^{-k t}`, `x^p`
fn is_raised(atom: &Atom) -> bool {
    match atom {
        Atom::Opaque(Expr::Call(Function::Exp, _)) => true,
        Atom::Opaque(Expr::Power(_, exponent)) => !matches!(**exponent, Expr::Number(_)),
        _ => false,
    }
}
