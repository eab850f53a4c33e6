//! Which definitions must be put in before anything can be computed.

use std::collections::BTreeSet;

use crate::algebra::{Expr, Formula, Symbol};
use crate::kernel::{Claim, Standing, definition};

/// The hypotheses `symbol = term` whose symbol is differentiated, integrated, taken to a limit or summed up
/// to: what is done to the symbol must be done to the term.
pub fn definitions_to_unfold(claim: &Claim) -> Vec<usize> {
    let mut formulas: Vec<Formula> = claim.formulas().cloned().collect();
    let goal = formulas.len() - 1;
    let mut chosen = Vec::new();
    loop {
        let mut wanted = BTreeSet::new();
        let mut variables = BTreeSet::new();
        for term in formulas.iter().flat_map(Formula::terms) {
            operands(term, &mut wanted, &mut variables);
        }
        for formula in &formulas {
            if let Formula::AllEqual { to, .. } = formula {
                wanted.extend(to.free_symbols());
            }
        }
        let next = (0..goal).find_map(|at| {
            if chosen.contains(&at) || claim.hypotheses[at].standing != Standing::Identity {
                return None;
            }
            let (symbol, term) = definition(&formulas[at])?;
            let fits = wanted.contains(&symbol) && !variables.contains(&symbol);
            fits.then_some((at, symbol, term))
        });
        let Some((at, symbol, term)) = next else {
            return chosen;
        };
        chosen.push(at);
        for formula in &mut formulas {
            *formula = formula.map_terms(|t| t.substitute(&symbol, &term));
        }
    }
}

/// The symbols under a derivative, limit or integral, or in the upper limit of a sum; and what is moved.
fn operands(term: &Expr, wanted: &mut BTreeSet<Symbol>, variables: &mut BTreeSet<Symbol>) {
    match term {
        Expr::Derivative { body, variable }
        | Expr::Limit { body, variable, .. }
        | Expr::Integral { body, variable, .. } => {
            wanted.extend(body.free_symbols().into_iter().filter(|s| s != variable));
            variables.insert(variable.clone());
        }
        Expr::Series { to, .. } => wanted.extend(to.free_symbols()),
        _ => {}
    }
    for child in term.children() {
        operands(child, wanted, variables);
    }
}
