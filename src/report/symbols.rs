//! The symbols of a page: where each first stands, what is declared of it, and what its dimension is.

use std::collections::BTreeSet;

use crate::algebra::{Formula, Symbol, element_parts};
use crate::audit::Dimensions;
use crate::derivation::{Derivation, conditions, goals};
use crate::dimension::occur;
use crate::document::Span;
use crate::kernel::dimension::Form;
use crate::notation::{measured, read_symbol};
use crate::sorted;

/// A symbol of a page, or the elements of a sequence.
pub(super) struct Found {
    /// As a declaration names it: `u_i` for a sequence.
    pub name: Symbol,
    /// Where it first stands.
    pub span: Span,
    /// Whether the page declares it.
    pub declared: bool,
    /// Another page that does, where this one does not.
    pub elsewhere: Option<usize>,
    /// Its dimension, as far as it is known, and whether it is declared.
    pub dimension: Option<(Form, bool)>,
    /// Whether a declaration can name it.
    pub nameable: bool,
}

/// The symbols of a page in the order in which they first stand. What is bound is left out, and so are π and
/// constants without a name.
pub(super) fn symbols(derivation: &Derivation, dimensions: &Dimensions, page: usize) -> Vec<Found> {
    let mut terms: Vec<(Span, Formula)> = Vec::new();
    for at in derivation.equations_of(page) {
        for goal in derivation.equations[at].statements().iter().flat_map(goals) {
            match goal.formula {
                Formula::Relation { left, right, .. } => {
                    terms.push((goal.sides.0, Formula::nonzero(left)));
                    terms.push((goal.sides.1, Formula::nonzero(right)));
                }
                whole @ Formula::AllEqual { .. } => terms.push((goal.span, whole)),
            }
        }
    }
    for at in derivation.equations_of(page) {
        for statement in derivation.equations[at].statements() {
            let under = conditions(statement).into_iter();
            terms.extend(under.map(|formula| (statement.span, formula)));
        }
    }
    for local in &derivation.pages[page].locals {
        let formulas = local.formulas.iter();
        terms.extend(formulas.map(|f| (local.span, Formula::clone(f))));
    }
    sorted::sort_by_key(&mut terms, |(span, _)| span.start);

    let mut sequences: BTreeSet<&Symbol> = BTreeSet::new();
    for (_, formula) in &terms {
        occur::sequences(formula, &mut |sequence| {
            sequences.insert(sequence);
        });
    }
    let mut seen: BTreeSet<Symbol> = BTreeSet::new();
    let mut found = Vec::new();
    for (span, formula) in &terms {
        for (symbol, is_sequence) in names(formula) {
            let name = match is_sequence {
                true => Symbol::new(format!("{symbol}_i")),
                false => symbol.clone(),
            };
            let element = element_parts(&name).is_some_and(|(own, _)| sequences.contains(&own));
            let is_pi = name.name() == "\\pi";
            if is_pi && !derivation.pages[page].domains.contains_key(&name)
                || measured(&name).is_some()
                || derivation.is_some_constant(&name)
                || element
                || !seen.insert(name.clone())
            {
                continue;
            }
            let declares = |page: usize| {
                let page = &derivation.pages[page];
                match is_sequence {
                    true => page.element_domain(&symbol).is_some(),
                    false => page.is_declared(&symbol),
                }
            };
            let declared = declares(page);
            let mut others = (0..derivation.pages.len()).filter(|&other| other != page);
            found.push(Found {
                span: *span,
                declared,
                elsewhere: others.find(|&other| !declared && declares(other)),
                dimension: match is_sequence {
                    true => dimensions.of_sequence(page, &symbol),
                    false => dimensions.of_symbol(page, &symbol),
                },
                nameable: read_symbol(name.name()).is_ok_and(|read| read == name),
                name,
            });
        }
    }
    found
}

/// The symbols and sequences (`true`) of a formula that are not bound in it, as they stand.
fn names(formula: &Formula) -> Vec<(Symbol, bool)> {
    let mut free = formula.free_symbols();
    for term in formula.terms() {
        term.collect_applied(&|_| true, &mut free);
    }
    let mut names = Vec::new();
    occur::symbols(formula, &mut |symbol| {
        if free.contains(symbol) {
            names.push((symbol.clone(), false));
        }
    });
    occur::sequences(formula, &mut |sequence| {
        names.push((sequence.clone(), true));
    });
    names
}
