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
    if let Formula::AllEqual { sequence, .. } = formula {
        found(sequence);
    }
    formula
        .terms()
        .into_iter()
        .for_each(|term| elements(term, found));
}

fn in_term<'a>(term: &'a Expr, found: &mut impl FnMut(&'a Symbol)) {
    match term {
        Expr::Symbol(symbol) | Expr::Apply(symbol, _) => found(symbol),
        Expr::Derivative { variable, .. }
        | Expr::Partial { variable, .. }
        | Expr::Limit { variable, .. } => found(variable),
        _ => {}
    }
    term.children().for_each(|child| in_term(child, found));
}

/// Calls `found` for every sequence in a sum with a power whose exponent is the index: in `\sum_i a_i x^i` the
/// elements need not have one dimension.
pub fn graded<'a>(formula: &'a Formula, found: &mut impl FnMut(&'a Symbol)) {
    fn walk<'a>(term: &'a Expr, found: &mut impl FnMut(&'a Symbol)) {
        if let Expr::Series { index, body, .. } = term
            && has_power_of(body, index)
        {
            elements(body, found);
        }
        term.children().for_each(|child| walk(child, found));
    }
    fn has_power_of(term: &Expr, index: &Symbol) -> bool {
        term.any(&|part| matches!(part, Expr::Power(_, exponent) if exponent.mentions(index)))
    }
    formula
        .terms()
        .into_iter()
        .for_each(|term| walk(term, found));
}

fn elements<'a>(term: &'a Expr, found: &mut impl FnMut(&'a Symbol)) {
    if let Expr::Element { sequence, .. } = term {
        found(sequence);
    }
    term.children().for_each(|child| elements(child, found));
}
