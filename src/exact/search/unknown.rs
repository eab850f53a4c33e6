//! Counterexamples in which unknown functions are constant: where `x(0) = x_0` is supposed of a function that nothing else is said of.

use super::refute::Points;
use super::still::with_constants;
use super::{Decision, QUICK, first, pose, refuted};
use crate::algebra::{BigRational, Expr, Formula, Symbol};
use crate::kernel::{Claim, Obligation, running_in, with_constant_functions};
use crate::sorted::{Map, Set};

/// Refutes a claim that speaks of unknown functions, with these constant, and with them all that its hypotheses tie to them.
pub(super) fn decide(obligation: &Obligation) -> Option<Decision> {
    let claim = obligation.claim();
    let mut applied: Map<Symbol, Expr> = Map::new();
    for term in claim.formulas().flat_map(Formula::terms) {
        applications(term, &mut applied);
    }
    if applied.is_empty() {
        return None;
    }
    let constant = held_constant(claim, &applied)?;
    let plain = pose(as_symbols(&constant, &applied)).ok()?;
    let constant = pose(constant).ok()?;
    let found = first(&mut Points::new(&plain), QUICK, |mut point| {
        for (name, application) in &applied {
            let value = point.symbols.remove(name)?;
            point.functions.insert(application.clone(), value);
        }
        point.unfold = constant.unfold().to_vec();
        refuted(&constant, point)
    })?;
    obligation.refuted_by_fewer(&found).ok()?;
    Some(Decision::Refuted(found))
}

/// An application of each unknown function, of a symbol if there is one.
fn applications(term: &Expr, found: &mut Map<Symbol, Expr>) {
    if let Expr::Apply(name, arguments) = term {
        let of_symbol = matches!(arguments[..], [Expr::Symbol(_)]);
        if of_symbol || !found.contains_key(name) {
            found.insert(name.clone(), term.clone());
        }
    }
    term.children().for_each(|part| applications(part, found));
}

/// The claim with all constant that is left in hypotheses about these functions; `None` where that is what something depends on.
fn held_constant(claim: &Claim, applied: &Map<Symbol, Expr>) -> Option<Claim> {
    let none = BigRational::from_integer(0.into());
    let values = applied.iter().map(|own| (own.1.clone(), none.clone()));
    let values: Map<Expr, BigRational> = values.collect();
    let mut held: Set<Symbol> = Set::new();
    for hypothesis in &claim.hypotheses {
        let terms = hypothesis.formula.terms();
        let concerned = |term: &&Expr| applied.keys().any(|name| term.mentions(name));
        if terms.iter().any(concerned) {
            let left = terms
                .into_iter()
                .map(|own| with_constant_functions(own, &values));
            held.extend(left.flat_map(|own| own.free_symbols()));
        }
    }
    let running = running_in(claim.formulas());
    let runs = held.iter().any(|symbol| running.contains(symbol));
    (!runs).then(|| with_constants(claim.clone(), held))
}

/// The claim with a constant symbol in place of each unknown function.
fn as_symbols(claim: &Claim, applied: &Map<Symbol, Expr>) -> Claim {
    fn plain(term: &Expr) -> Expr {
        match term {
            Expr::Apply(name, _) => Expr::Symbol(name.clone()),
            term => term.map_children(plain),
        }
    }
    let mut own = claim.clone();
    for hypothesis in &mut own.hypotheses {
        hypothesis.formula = hypothesis.formula.map_terms(plain).into();
    }
    own.goal = own.goal.map_terms(plain);
    with_constants(own, applied.keys().cloned())
}
