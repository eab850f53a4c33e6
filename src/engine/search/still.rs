//! What the author differentiates nowhere is mostly meant not to change. That is nothing to prove with unseen: a claim that
//! follows so follows under a condition, and a counterexample at which it is so is a counterexample.

use super::course::{differentiated, said_to_move};
use super::refute::Points;
use super::{Decision, Derived, Effort, QUICK, assuming, first, pose, prove_posed, refuted};
use crate::algebra::{Atom, Expr, Formula, Symbol, element_parts};
use crate::kernel::{Claim, Obligation, Problem, Refuted, definition};
use crate::sorted::Set;

/// More quantities than this that might change are not looked at one by one.
const MOST_STILL: usize = 8;

/// Decides a claim in which symbols might change of which the author does not say so.
pub(super) fn decide(obligation: &Obligation) -> Option<Decision> {
    let still = held_still(obligation, obligation.problem());
    let claim = obligation.claim();
    let with = |still: &[Formula]| pose(assuming(claim, still)).ok();
    let proved = |still: &[Formula]| -> Option<Derived> {
        let posed = with(still)?;
        prove_posed(&posed, Effort::Light).or_else(|| prove_posed(&posed, Effort::Full))
    };
    if let Some((derived, conditions)) = fewest(still.clone(), proved) {
        return Some(Decision::Proven {
            derived,
            conditions,
        });
    }
    if still.is_empty() || still.len() > MOST_STILL {
        return None;
    }
    let posed = with(&still)?;
    let own = claim.hypotheses.len();
    let mut points = Points::new(&posed);
    let found = first(&mut points, QUICK, |mut point| {
        if let Some(course) = &mut point.course {
            course.leads.retain(|law, _| *law < own);
        }
        refuted(obligation, point)
    });
    let found = found.or_else(|| refuted_where_constant(obligation));
    found.map(Decision::Refuted)
}

/// A counterexample in which what is held still is constant: only then it is known what an integral is worth, or a slope of a slope.
fn refuted_where_constant(obligation: &Obligation) -> Option<Refuted> {
    let claim = obligation.claim();
    let mut held = in_integrands(claim, obligation.unfold());
    let slopes = slopes_held_still(obligation.problem(), &said_to_move(claim));
    held.extend(
        slopes
            .iter()
            .filter_map(|slope| Some(differentiated(slope)?.0.clone())),
    );
    let posed = pose(with_constants(claim, held)?).ok()?;
    let found = first(&mut Points::new(&posed), QUICK, |point| {
        refuted(&posed, point)
    })?;
    obligation.refuted_by_fewer(&found).ok()?;
    Some(found)
}

/// The claim with what stands in its integrands constant, where the author does not say that it moves; `None` where nothing
/// does. The hypotheses `unfold` are put in.
pub(super) fn held_constant(claim: &Claim, unfold: &[usize]) -> Option<Claim> {
    with_constants(claim, in_integrands(claim, unfold))
}

/// The symbols for which hypotheses put in the terms that define them: how these move is said there.
fn put_in(claim: &Claim, unfold: &[usize]) -> Set<Symbol> {
    let hypotheses = unfold.iter().filter_map(|&at| claim.hypotheses.get(at));
    let defined = hypotheses.filter_map(|own| definition(&own.formula));
    defined.map(|(symbol, _)| symbol).collect()
}

/// What stands in integrands and is not said to move.
fn in_integrands(claim: &Claim, unfold: &[usize]) -> Set<Symbol> {
    let is_constant = |symbol: &Symbol| claim.domains.get(symbol).is_some_and(|own| own.constant);
    let mut held: Set<Symbol> = Set::new();
    for term in claim.formulas().flat_map(Formula::terms) {
        in_integrals(term, &mut |symbol, _| {
            if !is_constant(symbol) {
                held.insert(symbol.clone());
            }
        });
    }
    if !held.is_empty() {
        let (said, known) = (said_to_move(claim), put_in(claim, unfold));
        held.retain(|symbol| !said.contains(symbol) && !known.contains(symbol));
    }
    held
}

/// The claim with further symbols constant. Most claims have none of these: nothing is copied for them.
fn with_constants(claim: &Claim, held: Set<Symbol>) -> Option<Claim> {
    if held.is_empty() {
        return None;
    }
    let mut constant = claim.clone();
    for symbol in &held {
        constant.domains.entry(symbol.clone()).or_default().constant = true;
    }
    Some(constant)
}

/// A proof with as few of these held still as may be.
pub(super) fn fewest(
    still: Vec<Formula>,
    proved: impl Fn(&[Formula]) -> Option<Derived>,
) -> Option<(Derived, Vec<Formula>)> {
    if still.is_empty() || still.len() > MOST_STILL {
        return None;
    }
    super::fewest(still, proved)
}

/// What might change in a claim, of which the author does not say so, held still.
pub fn still_in(claim: Claim) -> Vec<Formula> {
    let posed = pose(claim);
    let still = posed.map(|posed| held_still(&posed, posed.problem()));
    let mut still = still.unwrap_or_default();
    still.truncate(MOST_STILL);
    still
}

/// That each derivative is 0 of what is differentiated nowhere, and might depend on what others are differentiated by. The problem
/// may be the obligation's with its laws differentiated.
pub(super) fn held_still(obligation: &Obligation, problem: &Problem) -> Vec<Formula> {
    let claim = obligation.claim();
    let said = said_to_move(claim);
    let known = put_in(claim, obligation.unfold());
    let slopes = slopes_held_still(problem, &said).into_iter();
    let zero = |slope: Expr| Formula::equal(slope, Expr::integer(0));
    let mut still: Vec<Formula> = slopes.map(zero).collect();
    for term in claim.formulas().flat_map(Formula::terms) {
        in_integrals(term, &mut |symbol, variable| {
            let constant = claim.domains.get(symbol).is_some_and(|own| own.constant);
            let slope = Expr::Derivative {
                body: Expr::Symbol(symbol.clone()).into(),
                variable: variable.clone(),
            };
            let held = Formula::equal(slope, Expr::integer(0));
            let moves = said.contains(symbol) || known.contains(symbol);
            if !constant && !moves && !still.contains(&held) {
                still.push(held);
            }
        });
    }
    still
}

/// The slopes, and slopes of slopes, of what is not said to move.
fn slopes_held_still(problem: &Problem, said: &Set<Symbol>) -> Vec<Expr> {
    let mut slopes = Vec::new();
    for (_, atom) in problem.atoms.iter() {
        let Atom::Opaque(slope @ Expr::Derivative { body, variable }) = atom else {
            continue;
        };
        let is_still = match &**body {
            // A sum over data, and not one that runs to the variable.
            body @ Expr::Series { .. } => {
                let own = element_parts(variable).map(|parts| parts.0);
                let mut moving = said.iter().chain([variable]).chain(&own);
                !moving.any(|symbol| body.mentions(symbol))
            }
            _ => differentiated(slope).is_some_and(|(symbol, _)| !said.contains(symbol)),
        };
        if is_still {
            slopes.push(slope.clone());
        }
    }
    slopes
}

/// What stands in integrands besides the variable, with the variable.
fn in_integrals(term: &Expr, found: &mut impl FnMut(&Symbol, &Symbol)) {
    if let Expr::Integral { body, variable, .. } = term {
        let mut symbols = body.free_symbols();
        symbols.remove(variable);
        symbols.iter().for_each(|symbol| found(symbol, variable));
    }
    term.children().for_each(|child| in_integrals(child, found));
}
