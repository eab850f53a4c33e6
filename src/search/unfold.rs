//! Which definitions must be put in before anything can be computed.

use std::collections::BTreeSet;

use crate::algebra::{Expr, Formula, Symbol};
use crate::kernel::{Claim, Standing, definition};

/// The hypotheses `symbol = term` whose symbol is differentiated, integrated, taken to a limit or summed up
/// to: what is done to the symbol must be done to the term.
pub fn definitions_to_unfold(claim: &Claim) -> Vec<usize> {
    // Most claims have nothing of the kind.
    if !claim.formulas().any(has_operands) {
        return Vec::new();
    }
    let mut formulas: Vec<Formula> = claim.formulas().cloned().collect();
    let goal = formulas.len() - 1;
    let mut chosen = Vec::new();
    loop {
        let mut found = Operands::default();
        for term in formulas.iter().flat_map(Formula::terms) {
            found.collect(term);
        }
        for formula in &formulas {
            if let Formula::AllEqual { to, .. } = formula {
                found.counts.extend(to.free_symbols());
            }
        }
        let next = (0..goal).find_map(|at| {
            if chosen.contains(&at) {
                return None;
            }
            let (symbol, term) = definition(&formulas[at])?;
            // A value at one point says nothing of how the symbol moves; a count does not move.
            let fits = match found.moving.contains(&symbol) {
                true => claim.hypotheses[at].standing == Standing::Identity,
                false => found.counts.contains(&symbol),
            };
            (fits && !found.variables.contains(&symbol)).then_some((at, symbol, term))
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

fn has_operands(formula: &Formula) -> bool {
    fn within(term: &Expr) -> bool {
        term.binder().is_some() || term.children().into_iter().any(within)
    }
    matches!(formula, Formula::AllEqual { .. }) || formula.terms().into_iter().any(within)
}

/// The symbols to which something is done.
#[derive(Default)]
struct Operands {
    /// Under a derivative, a limit or an integral.
    moving: BTreeSet<Symbol>,
    /// In the upper limit of a sum.
    counts: BTreeSet<Symbol>,
    /// What is differentiated by, goes to a limit or is integrated over.
    variables: BTreeSet<Symbol>,
}

impl Operands {
    fn collect(&mut self, term: &Expr) {
        match term {
            Expr::Derivative { body, variable }
            | Expr::Limit { body, variable, .. }
            | Expr::Integral { body, variable, .. } => {
                self.moving
                    .extend(body.free_symbols().into_iter().filter(|s| s != variable));
                self.variables.insert(variable.clone());
            }
            Expr::Series { to, .. } => self.counts.extend(to.free_symbols()),
            _ => {}
        }
        for child in term.children() {
            self.collect(child);
        }
    }
}
