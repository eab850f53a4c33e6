//! What the text says is constant, "where $g$ is constant", as far as nothing on the page speaks against it.

use crate::algebra::{Expr, Formula, Symbol};
use crate::document::Span;
use crate::kernel::running_in;
use crate::notation::read_symbol;
use crate::sorted::Set;

use super::Equation;
use super::equation::formulas;
use super::page::Page;

/// The symbols of which a text says that they are constant; none where it is no list of symbols.
pub(super) fn named(source: &str, body: Span) -> Vec<Symbol> {
    let text = source.get(body.range()).unwrap_or_default();
    let read = |text: &str| read_symbol(text).map(|symbol| vec![symbol]);
    let list = |_| text.split(',').map(read_symbol).collect();
    let said: Result<Vec<Symbol>, _> = read(text).or_else(list);
    said.unwrap_or_default()
}

/// Leaves out of what is said to be constant what the page lets change all the same.
pub(super) fn leave_out_what_moves(page: &Page, equations: &mut [Equation]) {
    if equations.iter().all(|own| own.constants.is_empty()) {
        return;
    }
    let moving = moving(page, equations);
    for equation in equations {
        equation
            .constants
            .retain(|symbol, _| !moving.contains(symbol));
    }
}

/// What something runs through, what is differentiated or a function, and what is given by a term in these.
fn moving(page: &Page, equations: &[Equation]) -> Set<Symbol> {
    let stated = equations.iter().flat_map(Equation::statements);
    let mut said: Vec<Formula> = stated.flat_map(formulas).collect();
    let locals = page.locals.iter().flat_map(|local| &local.formulas);
    said.extend(locals.map(|formula| (**formula).clone()));
    let mut moving = running_in(said.iter());
    for term in said.iter().flat_map(Formula::terms) {
        term.collect_differentiated(&mut moving);
        applied(term, &mut moving);
    }
    let mut given = Set::new();
    for (left, right) in said.iter().filter_map(Formula::as_equation) {
        for (side, other) in [(left, right), (right, left)] {
            if let Expr::Symbol(symbol) = side
                && speaks_of(other, &moving)
            {
                given.insert(symbol.clone());
            }
        }
    }
    moving.extend(given);
    moving
}

fn applied(term: &Expr, found: &mut Set<Symbol>) {
    if let Expr::Apply(name, _) = term {
        found.insert(name.clone());
    }
    term.children().for_each(|part| applied(part, found));
}

/// Whether a term speaks of one of these but in slopes: `F = m \frac{dv}{dt}` gives no force by the time.
fn speaks_of(term: &Expr, symbols: &Set<Symbol>) -> bool {
    match term {
        Expr::Derivative { .. } => false,
        Expr::Symbol(symbol) => symbols.contains(symbol),
        term => term.children().any(|part| speaks_of(part, symbols)),
    }
}
