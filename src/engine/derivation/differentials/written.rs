//! Products with the sign of differentials, `T d \theta`, as differentials.

use crate::algebra::{Expr, Formula, Relation, Symbol};
use crate::notation::{Clause, Statement, SyntaxError};
use crate::sorted::Set;

use super::degree::is_understood;
use super::{DELTA, SMALL, groups, is_upright, refusal};
use crate::derivation::equation::{each_side, terms, terms_of_clause};

/// Reads what the signs stand before as differentials.
///
/// # Errors
/// It is not clear what a sign stands before, or not each term has one differential.
pub(super) fn read(statements: &mut [Statement], signs: &Set<Symbol>) -> Result<(), SyntaxError> {
    for statement in statements {
        let Some(sign) = signs
            .iter()
            .find(|own| terms(statement).any(|term| has(term, own)))
        else {
            continue;
        };
        let reading = Reading {
            signs,
            are_closed: are_closed(statement, signs),
        };
        each_side(statement, &mut |term, _| *term = reading.of(term));
        let is_clear = |own: &Statement| {
            let clear = |clause: &Clause| is_clear(clause, signs);
            own.clauses.iter().all(clear) && own.under.iter().all(|clause| !speaks(clause, signs))
        };
        if !is_clear(statement) {
            return Err(refusal(statement, sign));
        }
        statement.others.retain(|other| is_clear(&other.statement));
    }
    Ok(())
}

/// The same in what is supposed; nothing where nothing is to be read so.
pub(super) fn in_formula(formula: &Formula, signs: &Set<Symbol>) -> Option<Formula> {
    let is_sign = |term: &Expr| signs.iter().any(|sign| has(term, sign));
    if !formula.terms().into_iter().any(is_sign) {
        return None;
    }
    let reading = Reading {
        signs,
        are_closed: false,
    };
    let read = formula.map_terms(|term| reading.of(term));
    let is_clear = read.as_equation().is_some()
        && !read.terms().into_iter().any(is_sign)
        && is_understood(read.terms().into_iter());
    is_clear.then_some(read)
}

struct Reading<'a> {
    signs: &'a Set<Symbol>,
    /// Whether a power after a sign stands in parentheses.
    are_closed: bool,
}

impl Reading<'_> {
    fn of(&self, term: &Expr) -> Expr {
        match term {
            Expr::Product(factors) => {
                let mut read = Vec::new();
                let mut rest = factors.iter();
                while let Some(factor) = rest.next() {
                    let next = rest.as_slice().first();
                    let before = next.and_then(|next| self.before(factor, next));
                    if before.is_some() {
                        rest.next();
                    }
                    read.push(before.unwrap_or_else(|| self.of(factor)));
                }
                match read.len() {
                    1 => read.remove(0),
                    _ => Expr::Product(read.into()),
                }
            }
            Expr::Apply(own, arguments) if self.signs.contains(own) && is_upright(own) => {
                match &arguments[..] {
                    [of] => self.of(of).differential(),
                    _ => term.clone(),
                }
            }
            term => term.map_children(|part| self.of(part)),
        }
    }

    /// What a factor before another one means, if it is a sign: with `\delta` names of small changes are made.
    fn before(&self, factor: &Expr, next: &Expr) -> Option<Expr> {
        let sign = match factor {
            Expr::Symbol(own) if self.signs.contains(own) => own,
            _ => return None,
        };
        match (sign.name(), next) {
            (DELTA, Expr::Symbol(own)) => Some(Expr::symbol(&format!("{SMALL}{}", own.name()))),
            (DELTA, _) => None,
            _ => (self.is_operand(next)).then(|| self.of(next).differential()),
        }
    }

    /// Whether a factor is what the sign before it is said of: a name, a function of one, or what stands in parentheses. In `dx^2` that is not
    /// clear.
    fn is_operand(&self, factor: &Expr) -> bool {
        match factor {
            Expr::Symbol(own) => !self.signs.contains(own) && !own.is_unit(),
            Expr::Power(..) => self.are_closed,
            factor => matches!(
                factor,
                Expr::Sum(_)
                    | Expr::Product(_)
                    | Expr::Negate(_)
                    | Expr::Quotient(..)
                    | Expr::Call(..)
            ),
        }
    }
}

/// Whether all that a sign stands before, and may be a power, stands in parentheses: `d(v^2)` is read as the same product as `dv^2`.
fn are_closed(statement: &Statement, signs: &Set<Symbol>) -> bool {
    fn count(term: &Expr, sign: &Symbol) -> usize {
        let own = match term {
            Expr::Product(factors) => {
                let pairs = factors.windows(2).filter(|pair| {
                    let is_sign = matches!(&pair[0], Expr::Symbol(own) if own == sign);
                    is_sign && !matches!(pair[1], Expr::Symbol(_) | Expr::Call(..))
                });
                pairs.count()
            }
            _ => 0,
        };
        own + term.children().map(|part| count(part, sign)).sum::<usize>()
    }
    signs.iter().all(|sign| {
        let all: usize = terms(statement).map(|term| count(term, sign)).sum();
        all == groups(statement, sign)
    })
}

/// Whether no sign is left, and a clause with differentials says what may be said of rates.
fn is_clear(clause: &Clause, signs: &Set<Symbol>) -> bool {
    match clause {
        Clause::Chain { sides, links, .. } if !speaks(clause, signs) => {
            let mut terms = sides.iter().map(|side| &side.expr);
            let mut relations = links.iter().map(|link| link.relation);
            !terms.any(is_differentiated)
                || relations.all(|own| own == Relation::Equal)
                    && is_understood(sides.iter().map(|side| &side.expr))
        }
        clause => !speaks(clause, signs) && !terms_of_clause(clause).any(is_differentiated),
    }
}

fn speaks(clause: &Clause, signs: &Set<Symbol>) -> bool {
    terms_of_clause(clause).any(|term| signs.iter().any(|sign| has(term, sign)))
}

fn is_differentiated(term: &Expr) -> bool {
    term.any(&|part| part.as_differential().is_some())
}

/// Whether a sign stands in a term.
pub(super) fn has(term: &Expr, sign: &Symbol) -> bool {
    term.any(&|part| matches!(part, Expr::Symbol(own) | Expr::Apply(own, _) if own == sign))
}
