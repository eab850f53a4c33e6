//! Claims under further suppositions.

use crate::algebra::{Expr, Formula, Symbol};
use crate::kernel::{Claim, Hypothesis, Standing, definition};

pub(super) fn assuming(claim: &Claim, formulas: &[Formula]) -> Claim {
    let mut claim = claim.clone();
    claim
        .hypotheses
        .extend(formulas.iter().map(|formula| Hypothesis {
            formula: formula.clone().into(),
            standing: Standing::Identity,
        }));
    claim
}

/// What is found under conditions, and those of them without which it is not; the last are left out first.
pub fn fewest<T>(
    mut conditions: Vec<Formula>,
    found: impl Fn(&[Formula]) -> Option<T>,
) -> Option<(T, Vec<Formula>)> {
    let mut least = found(&conditions)?;
    for at in (0..conditions.len()).rev() {
        let mut fewer = conditions.clone();
        fewer.remove(at);
        if let Some(own) = found(&fewer) {
            (conditions, least) = (fewer, own);
        }
    }
    Some((least, conditions))
}

/// Whether a formula gives a value to a symbol of which no hypothesis says anything: then it can only define it.
pub(super) fn defines_afresh(claim: &Claim, formula: &Formula) -> bool {
    let unsaid = |symbol: &Symbol| {
        let mut all = claim.hypotheses.iter().flat_map(|h| h.formula.terms());
        !all.any(|term| term.mentions(symbol))
    };
    definition(formula).is_some_and(|(symbol, _)| unsaid(&symbol))
}

/// The symbols of which a claim speaks and no hypothesis gives a number for a value.
pub(super) fn nowhere_put(claim: &Claim) -> Vec<Symbol> {
    let is_put = |symbol: &Symbol| {
        let mut hypotheses = claim.hypotheses.iter();
        hypotheses.any(|own| {
            own.formula.set_to_number() == Some(symbol) || measures(&own.formula, symbol)
        })
    };
    let named = Formula::free_symbols_of(claim.formulas()).into_iter();
    named.filter(|symbol| !is_put(symbol)).cloned().collect()
}

/// Whether a formula says how many units a symbol is, `v_0 = 0 m/s`.
fn measures(formula: &Formula, symbol: &Symbol) -> bool {
    matches!(formula.as_equation(), Some((Expr::Symbol(own), value))
        if own == symbol && value.free_symbols().iter().all(|own| own.is_unit()))
}
