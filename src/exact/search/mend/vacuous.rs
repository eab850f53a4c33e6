//! Edits that make a formula say nothing, or nothing new, or what nobody writes.

use num_traits::Zero;

use crate::algebra::{Expr, Formula, Relation, product_of};
use crate::kernel::{Claim, Hypothesis};

use super::super::{Effort, prove_unconditionally};
use super::{Change, is_never_reached};

/// Whether an edit only makes the formula say nothing, or nothing new: `v = v`, `x > -1`, a premise.
pub(super) fn is_vacuous(claim: &Claim, change: &Change, formula: &Formula) -> bool {
    is_premise(claim, formula) || says_nothing(claim, change, formula)
}

fn is_premise(claim: &Claim, formula: &Formula) -> bool {
    let turned = match formula {
        Formula::Relation {
            left,
            relation,
            right,
        } => Some(Formula::Relation {
            left: right.clone(),
            relation: *relation,
            right: left.clone(),
        }),
        Formula::AllEqual { .. } => None,
    };
    let says = |h: &Hypothesis| {
        let own = &*h.formula;
        own == formula || Some(own) == turned.as_ref()
    };
    claim.hypotheses.iter().any(says)
}

/// Whether an edited formula is true whatever the premises, `v = v`, `x > -1`, and no piece of algebra.
pub(super) fn says_nothing(claim: &Claim, change: &Change, formula: &Formula) -> bool {
    let Formula::Relation {
        left,
        relation,
        right,
    } = formula
    else {
        return true;
    };
    if times_nothing(formula) && !times_nothing(&claim.goal)
        || has_like_summands(formula) && !has_like_summands(&claim.goal)
    {
        return true;
    }
    let bare = Claim {
        hypotheses: Vec::new(),
        goal: formula.clone(),
        ..claim.clone()
    };
    // Bounds are rarely seen at first sight.
    let effort = match relation {
        Relation::Equal => Effort::Light,
        _ => Effort::Full,
    };
    if prove_unconditionally(bare, effort).is_none() {
        return false;
    }
    let bare = |side: &Expr| matches!(side, Expr::Symbol(_) | Expr::Number(_));
    // Algebra is put right by algebra; a statement about symbols is not. So are bounds that rest on nothing, and
    // those of which only the relation is wrong.
    let algebra = (*relation == Relation::Equal && !matches!(change, Change::Symbol { .. })
        || formula.is_inequality()
            && (claim.hypotheses.is_empty()
                || matches!(change, Change::Strict | Change::Relation)))
        && [&claim.goal, formula]
            .into_iter()
            .all(|formula| match formula {
                Formula::Relation {
                    left,
                    relation: Relation::Equal,
                    right,
                } => !bare(left) && !bare(right),
                Formula::Relation { left, right, .. } => !(bare(left) && bare(right)),
                Formula::AllEqual { .. } => false,
            });
    if !algebra || !formula.is_inequality() || matches!(change, Change::Strict | Change::Relation) {
        return !algebra;
    }
    // Of what rests on nothing only the best bound is worth a word: both sides can be equal.
    is_never_reached(claim, left, right)
}

/// Whether a sum in a formula has two summands that nobody leaves apart: `\frac2r - \frac1r`.
fn has_like_summands(formula: &Formula) -> bool {
    let has = |part: &Expr| match part {
        Expr::Sum(summands) => {
            let kinds: Vec<Expr> = summands.iter().map(without_coefficient).collect();
            (kinds.iter().enumerate()).any(|(at, own)| kinds[..at].contains(own))
        }
        _ => false,
    };
    formula.terms().into_iter().any(|term| term.any(&has))
}

/// A summand without its sign and the numbers that it is multiplied with or divided by.
fn without_coefficient(term: &Expr) -> Expr {
    match term {
        Expr::Negate(inner) => without_coefficient(inner),
        Expr::Number(_) => Expr::integer(1),
        Expr::Quotient(above, below) => {
            let (above, below) = (without_coefficient(above), without_coefficient(below));
            match below == Expr::integer(1) {
                true => above,
                false => Expr::Quotient(above.into(), below.into()),
            }
        }
        Expr::Product(factors) => {
            let is_number = |own: &&Expr| !matches!(own, Expr::Number(_));
            product_of(factors.iter().filter(is_number).cloned().collect())
        }
        term => term.clone(),
    }
}

/// Whether something in a formula is multiplied by 0: `0 (a - b) = 0`.
fn times_nothing(formula: &Formula) -> bool {
    let is_nothing = |own: &Expr| matches!(own, Expr::Number(number) if number.is_zero());
    let vanishes = |part: &Expr| match part {
        Expr::Product(factors) => factors.iter().any(is_nothing),
        _ => false,
    };
    formula.terms().into_iter().any(|term| term.any(&vanishes))
}
