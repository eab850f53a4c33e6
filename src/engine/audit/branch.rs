//! One of two roots: who goes from `s^2 - D s + D f = 0` to `s = (D + \sqrt{D^2 - 4 D f})/2` means the larger one, and has not said so.

use crate::algebra::{Expr, Formula, Relation};
use crate::derivation::{Assumed, Goal};
use crate::search::{self, Consistency, Effort};

use super::again::conditions::unbounded;
use super::judge::{Found, Judge, step};

impl Judge<'_> {
    /// Whether the step follows on one side of what its root is added to, with what must not vanish or must be positive besides.
    pub(super) fn follows_on_one_side(
        &self,
        goal: &Goal,
        set: &[Assumed],
        found: &mut Found,
    ) -> bool {
        let Some((left, middle)) = around_root(&goal.formula) else {
            return false;
        };
        let claim = self.derivation.claim(self.at, set, &goal.formula);
        let nonzero = unbounded(&claim).into_iter();
        let nonzero: Vec<Formula> = nonzero
            .map(|own| Formula::nonzero(Expr::Symbol(own)))
            .collect();
        let sides = [Relation::GreaterOrEqual, Relation::LessOrEqual];
        sides.into_iter().any(|relation| {
            let side = Formula::Relation {
                left: left.clone(),
                relation,
                right: middle.clone(),
            };
            let positive = self.positive(goal, set, &unbounded(&claim));
            let choices = [Some(nonzero.clone()), positive];
            choices.into_iter().flatten().any(|mut conditions| {
                conditions.insert(0, side.clone());
                let all = set.iter().cloned().chain(conditions.iter().map(step));
                let all: Vec<Assumed> = all.collect();
                let claim = self.derivation.claim(self.at, &all, &goal.formula);
                let possible = search::consistency(&claim, &self.auditor.hints());
                matches!(possible, Consistency::Model(_))
                    && self.holds_under(goal, set.to_vec(), &conditions, Effort::Full, found)
            })
        })
    }
}

/// What an equation gives, and what its one square root is added to, if it is added to anything.
fn around_root(formula: &Formula) -> Option<(Expr, Expr)> {
    let (left, right) = formula.as_equation()?;
    if left.any(&Expr::is_root) {
        return None;
    }
    let mut roots = Vec::new();
    collect_roots(right, &mut roots);
    let [root] = roots.as_slice() else {
        return None;
    };
    Some((left.clone(), without(right, root)?))
}

/// A term without the summand that has a root in it.
fn without(term: &Expr, root: &Expr) -> Option<Expr> {
    let has_root = |part: &Expr| part.any(&|inner| inner == root);
    match term {
        Expr::Sum(terms) => {
            let mut others: Vec<Expr> =
                terms.iter().filter(|own| !has_root(own)).cloned().collect();
            match others.len() {
                0 => None,
                1 => others.pop(),
                _ => Some(Expr::Sum(others.into())),
            }
        }
        Expr::Quotient(above, below) if !has_root(below) => {
            let above = without(above, root)?;
            Some(Expr::Quotient(above.into(), below.clone()))
        }
        Expr::Product(factors) => {
            let own = |factor: &Expr| match has_root(factor) {
                true => without(factor, root),
                false => Some(factor.clone()),
            };
            factors
                .iter()
                .map(own)
                .collect::<Option<_>>()
                .map(Expr::Product)
        }
        Expr::Negate(inner) => Some(Expr::Negate(without(inner, root)?.into())),
        _ => None,
    }
}

fn collect_roots<'a>(term: &'a Expr, found: &mut Vec<&'a Expr>) {
    match term.is_root() {
        true if !found.contains(&term) => found.push(term),
        true => {}
        false => (term.children()).for_each(|child| collect_roots(child, found)),
    }
}
