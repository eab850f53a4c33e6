//! What is printed, refuted beside what should be printed: where all is true that this was shown from, both cannot be.

use crate::algebra::{Expr, Formula, Symbol, effort, product_of};
use crate::derivation::{Assumed, Goal};
use crate::kernel::{Obligation, Standing};
use crate::search::{self, Decision, Effort};

use super::super::readings::Circumstances;
use super::super::{Auditor, Judged, Outcome, judge};
use super::Shown;

/// How much work may be done to refute it from some premises; there are others that say less.
const MOST_WORK: u64 = 1_000_000;

impl Auditor<'_> {
    /// What is printed, refuted where all is true that something near to it was shown from, as far as that is needed, and so that as well.
    pub(super) fn refuted_beside(
        &self,
        how: &Circumstances,
        printed: &Goal,
        shown: &Shown,
        from: Vec<Assumed>,
    ) -> Option<Judged> {
        let (at, usable) = (how.at, how.usable);
        let domains = &self.derivation.pages[self.derivation.equations[at].page].domains;
        let is_anything = |own: &Symbol| {
            let domain = domains.get(own);
            domain.is_none_or(|own| !own.nonzero && !own.integer && own.bounds().next().is_none())
        };
        let decided = |assumed: Vec<Assumed>, formula: Formula| {
            let claim = self.derivation.claim(at, &assumed, &formula);
            let decide = || search::decide(claim, &self.hints());
            let Decision::Refuted(refuted) = effort::within(MOST_WORK, decide) else {
                return None;
            };
            let goal = Goal {
                formula,
                ..printed.clone()
            };
            let judged = Judged {
                goal,
                assumed,
                outcome: Outcome::Refuted(refuted.into()),
            };
            let judge = judge::Judge::new(self, at, usable);
            judge.held_and_moving(&judged).is_none().then_some(judged)
        };
        let plain = decided(from.clone(), printed.formula.clone());
        let plain = plain.or_else(|| {
            let mut with_shown = from.clone();
            // What solves a law says how it varies.
            let standing = match from.iter().any(|own| own.formula.speaks_of_slopes()) {
                true => Standing::Identity,
                false => Standing::AtPoint,
            };
            with_shown.push(Assumed {
                standing,
                ..judge::taken(&shown.formula)
            });
            decided(with_shown, printed.formula.clone())
        });
        let apart = || {
            let between = between(&shown.formula, &printed.formula)?;
            let all = but_names(from.clone(), &between, Some(&is_anything));
            Some((all, between))
        };
        let plain = plain.or_else(|| {
            let (all, between) = apart()?;
            decided(all, between)
        });
        let plain = plain.or_else(|| {
            let known = but_integrals(&from, &printed.formula)?;
            decided(known, printed.formula.clone())
        });
        // What is false where all is positive is false.
        plain.or_else(|| {
            let (mut all, between) = apart()?;
            let symbols = between.free_symbols().into_iter();
            let symbols = symbols.filter(|own| !own.is_unit());
            let positive = symbols.map(|own| Formula::positive(Expr::Symbol(own)));
            all.extend(positive.map(|own| judge::condition(&own)));
            decided(all, between)
        })
    }

    /// What something is shown from: what it is not shown from may stand in the way of a point.
    pub(super) fn needed(&self, at: usize, shown: &Shown) -> Vec<Assumed> {
        let mut assumed = shown.from.clone();
        // Nothing is shown from that, and of no point it is known whether it is true there.
        assumed.retain(|own| !own.formula.is_approximation());
        let posed = |assumed: &[Assumed]| {
            let claim = self.derivation.claim(at, assumed, &shown.formula);
            search::pose(claim).ok()
        };
        let proof = |posed: &Obligation| search::prove_posed(posed, Effort::Full);
        let follows = |assumed: &[Assumed]| posed(assumed).is_some_and(|own| proof(&own).is_some());
        // What is neither put in nor combined is mostly not needed, and much that is left out one by one costs a proof each.
        let of_proof = || {
            let posed = posed(&assumed)?;
            let combined = proof(&posed)?.combined;
            let is_used = |at: &usize| combined.contains(at) || posed.unfold().contains(at);
            let used = (0..assumed.len()).filter(is_used);
            let used: Vec<Assumed> = used.map(|at| assumed[at].clone()).collect();
            (used.len() < assumed.len() && follows(&used)).then_some(used)
        };
        if let Some(used) = of_proof() {
            assumed = used;
        }
        for from in (0..assumed.len()).rev() {
            let own = assumed.remove(from);
            if !follows(&assumed) {
                assumed.insert(from, own);
            }
        }
        assumed
    }
}

/// That what should be printed on one side is what is printed there: the other side is the same.
pub(in crate::audit) fn between(shown: &Formula, printed: &Formula) -> Option<Formula> {
    let (left, right) = shown.as_equation()?;
    let (printed_left, printed_right) = printed.as_equation()?;
    if left == printed_left {
        return Some(Formula::equal(right.clone(), printed_right.clone()));
    }
    (right == printed_right).then(|| Formula::equal(printed_left.clone(), left.clone()))
}

/// What is assumed, but for what only gives names to things of which nothing else speaks: what is true without these is true with them.
///
/// Where it is told which names may stand for anything, they may stand beside something, too, that is not 0 then: `E I w(x) = F x^2` says what
/// `w(x)` is where `E I ≠ 0`.
pub(in crate::audit) fn but_names(
    mut assumed: Vec<Assumed>,
    goal: &Formula,
    is_anything: Option<&dyn Fn(&Symbol) -> bool>,
) -> Vec<Assumed> {
    let may_be = |named: &Expr| {
        let name = match named {
            Expr::Symbol(own) => Some(own),
            _ => None,
        };
        is_anything.is_none_or(|is_anything| name.is_none_or(is_anything))
    };
    loop {
        let beside = |at: usize| {
            let (left, right) = assumed[at].formula.as_equation()?;
            let mut others: Vec<&Formula> = vec![goal];
            let rest = assumed.iter().enumerate().filter(|(other, _)| *other != at);
            others.extend(rest.map(|(_, own)| &*own.formula));
            if may_be(left) && names(left, right, &others) {
                return Some((at, Vec::new()));
            }
            is_anything?;
            let sides = [(left, right), (right, left)].into_iter();
            sides
                .filter_map(|(product, value)| match product {
                    Expr::Product(factors) => Some((factors, value)),
                    _ => None,
                })
                .find_map(|(factors, value)| {
                    (0..factors.len()).find_map(|named| {
                        let mut beside = factors.to_vec();
                        let named = beside.remove(named);
                        let said = Formula::nonzero(product_of(beside.clone()));
                        let others: Vec<&Formula> = others.iter().copied().chain([&said]).collect();
                        let is_one = may_be(&named) && names(&named, value, &others);
                        is_one.then_some((at, beside))
                    })
                })
        };
        let Some((at, beside)) = (0..assumed.len()).rev().find_map(beside) else {
            return assumed;
        };
        assumed.remove(at);
        let nonzero = beside.into_iter().map(Formula::nonzero);
        assumed.extend(nonzero.map(|own| judge::condition(&own)));
    }
}

/// What is assumed, with what integrals come to put in for them, where nothing else speaks of what is integrated: `V = \int_a^b E\,dr = c` says
/// that `V = c`, and what else it says is so for some `E`. `None` where there is no such integral.
fn but_integrals(assumed: &[Assumed], goal: &Formula) -> Option<Vec<Assumed>> {
    let (at, integral, value) = assumed.iter().enumerate().find_map(|(at, own)| {
        let (left, right) = own.formula.as_equation()?;
        let is_free = |term: &Expr| {
            let Expr::Integral { body, .. } = term else {
                return false;
            };
            let Expr::Symbol(integrated) = &**body else {
                return false;
            };
            let elsewhere = |own: &Formula| {
                let all = own.map_terms(|own| own.replace(term, &Expr::integer(0)));
                all.names().contains(integrated)
            };
            !elsewhere(goal) && !assumed.iter().any(|own| elsewhere(&own.formula))
        };
        let sides = [(left, right), (right, left)].into_iter();
        let mut sides = sides.filter(|own| is_free(own.0) && !own.1.any(&|part| part == own.0));
        // That it is a number that has a name says nothing of it.
        let (integral, value) = sides.find(|own| !matches!(own.1, Expr::Symbol(_)))?;
        Some((at, integral.clone(), value.clone()))
    })?;
    let mut known = assumed.to_vec();
    known.remove(at);
    for own in &mut known {
        let put_in = (own.formula).map_terms(|term| term.replace(&integral, &value));
        own.formula = put_in.into();
    }
    Some(known)
}

/// Whether an equation is the only one that speaks of what its left side is, a name or how fast something changes.
fn names(left: &Expr, right: &Expr, others: &[&Formula]) -> bool {
    match left {
        Expr::Symbol(own) | Expr::Apply(own, _) => {
            let speaks = |term: &Expr| term.any(&|part| is_of(part, own));
            let mut terms = others.iter().flat_map(|own| own.terms());
            !speaks(right) && !terms.any(speaks)
        }
        Expr::Derivative { .. } => {
            let is_slope = |part: &Expr| {
                matches!(part, Expr::Derivative { .. } | Expr::Partial { .. })
                    && part.any(&|own| own == left)
            };
            let mut terms = others.iter().flat_map(|own| own.terms());
            !right.any(&is_slope) && !terms.any(|term| term.any(&is_slope))
        }
        _ => false,
    }
}

fn is_of(part: &Expr, symbol: &Symbol) -> bool {
    match part {
        Expr::Symbol(own) | Expr::Apply(own, _) => own == symbol,
        own => own.binder() == Some(symbol),
    }
}
