//! `\dot x` and `\ddot x` where a page says how `x` goes with the time: `x = A \cos(\omega t)`. Elsewhere they are names like any other.

use crate::algebra::{Expr, Formula, Symbol};
use crate::sorted::Set;

use super::Equation;
use super::equation::{conditions, formulas, map_terms};
use super::names::undotted;
use super::page::Page;

/// What a dot stands for a slope by.
const TIME: &str = "t";

/// Reads dots over what is given by a term in `t` as derivatives by it, unless they are declared.
pub(super) fn read_as_slopes(page: &mut Page, equations: &mut [Equation]) {
    let time = Symbol::new(TIME);
    let mut explicit: Set<Symbol> = Set::new();
    let mut dotted: Set<Symbol> = Set::new();
    let mut see = |formula: &Formula| {
        if let Some((Expr::Symbol(name) | Expr::Apply(name, _), value)) = formula.as_equation()
            && value.mentions(&time)
            && !value.mentions(name)
        {
            explicit.insert(name.clone());
        }
        for term in formula.terms() {
            names(term, &mut dotted);
        }
    };
    for statement in equations.iter().flat_map(Equation::statements) {
        (formulas(statement).iter().chain(&conditions(statement))).for_each(&mut see);
    }
    for formula in page.locals.iter().flat_map(|local| &local.formulas) {
        see(formula);
    }
    dotted.retain(|name| {
        let own = base(name);
        own.is_some_and(|(own, _)| explicit.contains(&own)) && !page.is_declared(name)
    });
    if dotted.is_empty() {
        return;
    }
    map_terms(page, equations, |term| slopes(term, &dotted, &time));
}

/// What stands below the dots of a name, and how many they are.
fn base(name: &Symbol) -> Option<(Symbol, usize)> {
    match undotted(name) {
        Some(own) => Some((own, 1)),
        None => {
            let inside = name.name().strip_prefix("\\ddot{")?.strip_suffix('}')?;
            Some((Symbol::new(inside), 2))
        }
    }
}

/// The names with dots in a term.
fn names(term: &Expr, found: &mut Set<Symbol>) {
    if let Expr::Symbol(name) | Expr::Apply(name, _) = term
        && base(name).is_some()
    {
        found.insert(name.clone());
    }
    term.children().for_each(|part| names(part, found));
}

fn slopes(term: &Expr, dotted: &Set<Symbol>, time: &Symbol) -> Expr {
    let own = match term {
        Expr::Symbol(name) if dotted.contains(name) => {
            base(name).map(|(own, order)| (Expr::Symbol(own), order))
        }
        // Its value at a number is read later.
        Expr::Apply(name, arguments)
            if dotted.contains(name) && *arguments == [Expr::Symbol(time.clone())] =>
        {
            base(name).map(|(own, order)| (Expr::Apply(own, arguments.clone()), order))
        }
        _ => None,
    };
    let Some((body, order)) = own else {
        return term.map_children(|part| slopes(part, dotted, time));
    };
    (0..order).fold(body, |body, _| Expr::Derivative {
        body: body.into(),
        variable: time.clone(),
    })
}
