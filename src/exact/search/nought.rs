//! Counterexamples that rest on `0^0 = 1`: that is a convention, and convinces nobody where another point does.

use num_traits::Zero;

use super::{assuming, pose, refute_in_context};
use crate::algebra::{Expr, Formula, Relation, Symbol};
use crate::kernel::{Obligation, Refuted};
use crate::sorted::Set;

/// A counterexample at which nothing that is raised to a power that depends on something is 0, where the one that was found has
/// such a thing.
pub fn without_powers_of_nought(obligation: &Obligation, refuted: &Refuted) -> Option<Refuted> {
    let claim = obligation.claim();
    let mut raised = Set::new();
    for term in claim.formulas().flat_map(Formula::terms) {
        collect_raised(term, &mut raised);
    }
    let values = &refuted.witness().symbols;
    raised.retain(|symbol| values.get(symbol).is_some_and(Zero::is_zero));
    if raised.is_empty() {
        return None;
    }
    let nonzero = |symbol: Symbol| Formula::Relation {
        left: Expr::Symbol(symbol),
        relation: Relation::NotEqual,
        right: Expr::integer(0),
    };
    let conditions: Vec<Formula> = raised.into_iter().map(nonzero).collect();
    let larger = pose(assuming(claim, &conditions)).ok()?;
    refute_in_context(obligation, &larger)
}

/// The symbols in what is raised to a power with a symbol in the exponent.
fn collect_raised(term: &Expr, raised: &mut Set<Symbol>) {
    if let Expr::Power(base, exponent) = term
        && !exponent.free_symbols().is_empty()
    {
        raised.extend(base.free_symbols());
    }
    term.children()
        .for_each(|child| collect_raised(child, raised));
}
