//! Which names occur in a formula, bound ones included.

use crate::algebra::{Expr, Formula, Symbol};

/// Calls `found` for every occurrence of a symbol, functions and the variables of derivatives and limits included.
pub fn symbols<'a>(formula: &'a Formula, found: &mut impl FnMut(&'a Symbol)) {
    formula
        .terms()
        .into_iter()
        .for_each(|term| in_term(term, found));
}

/// Calls `found` for every occurrence of a sequence.
pub fn sequences<'a>(formula: &'a Formula, found: &mut impl FnMut(&'a Symbol)) {
    fn walk<'a>(term: &'a Expr, found: &mut impl FnMut(&'a Symbol)) {
        if let Expr::Element { sequence, .. } = term {
            found(sequence);
        }
        term.children()
            .into_iter()
            .for_each(|child| walk(child, found));
    }
    if let Formula::AllEqual { sequence, .. } = formula {
        found(sequence);
    }
    formula
        .terms()
        .into_iter()
        .for_each(|term| walk(term, found));
}

fn in_term<'a>(term: &'a Expr, found: &mut impl FnMut(&'a Symbol)) {
    match term {
        Expr::Symbol(symbol) | Expr::Apply(symbol, _) => found(symbol),
        Expr::Derivative { variable, .. } | Expr::Limit { variable, .. } => found(variable),
        _ => {}
    }
    term.children()
        .into_iter()
        .for_each(|child| in_term(child, found));
}
