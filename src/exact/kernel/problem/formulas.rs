//! Formulas as facts: what the sides are compared for, and what is known besides where one is asserted.

use super::super::scaling::sides;
use super::super::{Fact, Reject, Sign};
use super::{Origin, Problem, Reading};
use crate::algebra::{
    Conditions, Expr, Formula, Fraction, Lowering, Polynomial, Rational, Relation, Symbol,
};
use crate::sorted::Set;

impl Problem {
    /// A formula as a fact. `None` for relations that say nothing exact.
    pub(super) fn read(&mut self, formula: &Formula) -> Result<(Option<Fact>, Conditions), Reject> {
        let mut lowering = self.lowering();
        let (left, relation, right) = match formula {
            Formula::Relation {
                left,
                relation,
                right,
            } => (lowering.lower(left)?, *relation, lowering.lower(right)?),
            Formula::AllEqual {
                sequence,
                to,
                value,
            } => {
                let spread = spread(&mut lowering, sequence, to, value.as_ref())?;
                (spread, Relation::Equal, Fraction::default())
            }
        };
        let conditions = lowering.conditions;
        Ok((compared(left, relation, right)?, conditions))
    }

    pub(super) fn assume(&mut self, formula: &Formula, origin: Origin) -> Result<(), Reject> {
        let (fact, conditions) = match sides(formula) {
            // At one point a relation between two says no more than that neither side is 0.
            Some((left, right)) => {
                let both = Expr::Product([left.clone(), right.clone()].into());
                self.read(&Formula::nonzero(both))?
            }
            None => self.read(formula)?,
        };
        let fact = match fact {
            Some(fact) => away_from(fact, &conditions.away)?,
            None => None,
        };
        self.take(fact, conditions, &origin);
        Ok(())
    }

    pub(super) fn take(&mut self, fact: Option<Fact>, conditions: Conditions, origin: &Origin) {
        // A limit that was taken with something held constant means what was read only if that is so.
        let fact = fact.filter(|_| conditions.zero.is_empty());
        let position = fact.as_ref().map(|_| self.facts.len());
        if let Some(fact) = fact {
            self.add(fact.polynomial, fact.sign, origin.clone());
            // What is asserted is defined.
            for factor in &conditions.nonzero {
                self.add(factor.clone(), Sign::NonZero, origin.clone());
            }
            for base in &conditions.nonnegative {
                self.add(base.clone(), Sign::NonNegative, origin.clone());
            }
            for base in &conditions.positive {
                self.add(base.clone(), Sign::Positive, origin.clone());
            }
        }
        self.readings.push(Reading {
            fact: position,
            conditions,
        });
    }
}

/// `left relation right` as a fact. `None` for relations that say nothing exact.
pub(super) fn compared(
    left: Fraction,
    relation: Relation,
    right: Fraction,
) -> Result<Option<Fact>, Reject> {
    let (more, less) = match relation {
        Relation::Less | Relation::LessOrEqual => (right, left),
        _ => (left, right),
    };
    // To be compared with 0 is common.
    let value = match less.is_zero() {
        true => more,
        false => more.minus(&less)?,
    };
    let sign = match relation {
        Relation::Equal => Sign::Zero,
        Relation::NotEqual => Sign::NonZero,
        Relation::Less | Relation::Greater => Sign::Positive,
        Relation::LessOrEqual | Relation::GreaterOrEqual => Sign::NonNegative,
        _ => return Ok(None),
    };
    let (mut polynomial, denominator) = value.into_parts();
    if matches!(sign, Sign::Positive | Sign::NonNegative) {
        // P / Q has the sign of P times the factors of Q with an odd exponent.
        for (factor, exponent) in denominator {
            if exponent % 2 == 1 {
                polynomial = polynomial.times(&factor)?;
            }
        }
    }
    Ok(Some(Fact { polynomial, sign }))
}

/// What vanishes if all elements are equal, `u_1 = … = u_n (= w)`: `n Σu² − (Σu)²`, or `Σu² − 2w Σu + n w²`.
fn spread(
    lowering: &mut Lowering,
    sequence: &Symbol,
    to: &Expr,
    value: Option<&Expr>,
) -> Result<Fraction, Reject> {
    let element = Expr::Element {
        sequence: sequence.clone(),
        index: Symbol::new("i"),
    };
    let square = Expr::Power(element.clone().into(), Expr::integer(2).into());
    let sum = |body: Expr| Expr::Series {
        index: Symbol::new("i"),
        from: Expr::integer(1).into(),
        to: to.clone().into(),
        body: body.into(),
    };
    let first = lowering.lower(&sum(element))?;
    let second = lowering.lower(&sum(square))?;
    let count = lowering.lower(to)?;
    let Some(value) = value else {
        return Ok(count.times(&second)?.plus(&first.pow(2)?.negated())?);
    };
    let value = lowering.lower(value)?;
    let two = Fraction::from(Rational::from(2));
    let middle = two.times(&value)?.times(&first)?.negated();
    Ok(second.plus(&middle)?.plus(&count.times(&value.pow(2)?)?)?)
}

/// What a premise says if something vanishes, too, where its terms are read as if that did not: nothing then.
fn away_from(fact: Fact, away: &Set<Polynomial>) -> Result<Option<Fact>, Reject> {
    let Fact {
        mut polynomial,
        mut sign,
    } = fact;
    for factor in away {
        polynomial = match sign {
            Sign::Zero => polynomial.times(factor)?,
            Sign::NonNegative | Sign::Positive => {
                sign = Sign::NonNegative;
                polynomial.times(factor)?.times(factor)?
            }
            Sign::NonZero => return Ok(None),
        };
    }
    Ok(Some(Fact { polynomial, sign }))
}
