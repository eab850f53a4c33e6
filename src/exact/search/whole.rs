//! Counterexamples at which what is a whole number is put in first: of `\cos(2 n \pi)`, or of an integral with `n` in it, a point gives a
//! value only where `n` is a number.

use super::{Decision, first, pose, refute, refuted, still};
use crate::algebra::{BigRational, Expr, Formula, Symbol};
use crate::kernel::{Claim, Domain, Hypothesis, Obligation, Refuted, Standing};
use crate::sorted::Set;

/// The numbers that are tried, the first few of these that may be meant.
const NUMBERS: [i64; 6] = [1, 2, 0, 3, 4, -1];
const MOST_NUMBERS: usize = 3;

/// A counterexample to an equation with one whole number put in that stands in functions, in exponents or in integrals.
pub(super) fn first_refuted(obligation: &Obligation, budget: usize) -> Option<Refuted> {
    let claim = obligation.claim();
    // Most claims speak of none.
    if !claim.domains.values().any(|own| own.integer) {
        return None;
    }
    claim.goal.as_equation()?;
    let mut within = Set::new();
    let terms = claim.formulas().flat_map(Formula::terms);
    terms.for_each(|term| collect(term, claim, &mut within));
    let symbol = within.pop_first()?;
    let domain = claim.domains.get(&symbol)?;
    let numbers = NUMBERS.map(|own| BigRational::from_integer(own.into()));
    let mut numbers = numbers
        .into_iter()
        .filter(|own| domain.contains(own))
        .take(MOST_NUMBERS);
    numbers.find_map(|number| {
        let mut there = claim.clone();
        there.hypotheses.push(Hypothesis {
            formula: Formula::number(symbol.clone(), number).into(),
            standing: Standing::Identity,
        });
        let posed = pose(there).ok()?;
        let mut points = refute::Points::new(&posed);
        let plain = first(&mut points, budget, |point| refuted(&posed, point));
        let still = || match still::decide(&posed) {
            Some(Decision::Refuted(found)) => Some(found),
            _ => None,
        };
        let found = plain.or_else(still)?;
        obligation.refuted_by_fewer(&found).ok()?;
        Some(found)
    })
}

/// The whole numbers of a claim that stand in functions, in exponents or in integrals.
fn collect(term: &Expr, claim: &Claim, found: &mut Set<Symbol>) {
    let is_whole = |own: &Domain| own.integer;
    let inner = match term {
        Expr::Call(_, argument) => Some(&**argument),
        Expr::Power(_, exponent) => Some(&**exponent),
        Expr::Integral { .. } => Some(term),
        _ => None,
    };
    if let Some(inner) = inner {
        let whole = inner.free_symbols().into_iter();
        let whole = whole.filter(|own| claim.domains.get(own).is_some_and(is_whole));
        found.extend(whole);
    }
    (term.children()).for_each(|part| collect(part, claim, found));
}
