//! What sums run through that do not say it, `\sum_i x_i`: the same as the sums of the page that do.

use std::collections::BTreeSet;

use crate::algebra::{Expr, Symbol};
use crate::notation::{SyntaxError, Through};

use super::Equation;
use super::equation::formulas;

/// What all sums of a page run through that say it, if there are others that do not.
pub(super) fn run_through(equations: &[Equation]) -> Option<Through> {
    let is_unsaid = |own: &Equation| own.statements.as_ref().is_err_and(SyntaxError::is_of_ends);
    if !equations.iter().any(is_unsaid) {
        return None;
    }
    let statements = equations.iter().flat_map(Equation::statements);
    let mut found: Vec<Through> = Vec::new();
    for formula in statements.flat_map(formulas) {
        formula
            .terms()
            .into_iter()
            .for_each(|term| collect(term, &mut found));
    }
    let mut found = found.into_iter();
    let mut all = found.next()?;
    for own in found {
        if own.from != all.from || own.to != all.to {
            return None;
        }
        all.sequences.extend(own.sequences);
    }
    Some(all)
}

/// What the sums in a term run through that add up elements of sequences, the outer ones first.
pub fn sums_in(term: &Expr) -> Vec<Through> {
    let mut found = Vec::new();
    collect(term, &mut found);
    found
}

fn collect(term: &Expr, found: &mut Vec<Through>) {
    if let Expr::Series {
        index,
        from,
        to,
        body,
    } = term
    {
        let mut sequences = BTreeSet::new();
        elements(body, index, &mut sequences);
        if !sequences.is_empty() {
            found.push(Through {
                index: index.clone(),
                from: (**from).clone(),
                to: (**to).clone(),
                sequences,
            });
        }
    }
    term.children().for_each(|child| collect(child, found));
}

/// The sequences of which elements stand in a term, at an index.
fn elements(term: &Expr, at: &Symbol, found: &mut BTreeSet<Symbol>) {
    if let Expr::Element { sequence, index } = term
        && index == at
    {
        found.insert(sequence.clone());
    }
    term.children().for_each(|child| elements(child, at, found));
}
