//! `y(x, t)` and `y`: one quantity where one of them is differentiated partially, and written in one way.

use std::sync::Arc;

use crate::algebra::{Expr, Symbol};
use crate::sorted::Map;

use super::super::Equation;
use super::super::equation::map_terms;
use super::super::page::Page;
use super::{name_of, sides_of};

/// How a page speaks of what is differentiated partially.
#[derive(Default)]
struct Applied {
    /// What it is applied to; `None` where that is not the same everywhere.
    to: Option<Arc<[Expr]>>,
    is_applied: bool,
    /// It stands without arguments, and not only below a partial derivative.
    alone: bool,
    differentiated: bool,
}

/// Writes `y(x, t)` and `y` in one way, where one of them is differentiated partially: without what it depends on where it stands so
/// elsewhere, and otherwise with.
pub(super) fn write_alike(page: &mut Page, equations: &mut [Equation]) {
    let mut all: Map<Symbol, Applied> = Map::new();
    for statement in equations.iter().flat_map(Equation::statements) {
        sides_of(statement).for_each(|side| see_applied(side, &mut all));
    }
    for formula in page.locals.iter().flat_map(|local| &local.formulas) {
        let terms = formula.terms().into_iter();
        terms.for_each(|term| see_applied(term, &mut all));
    }
    all.retain(|_, own| own.is_applied && own.differentiated && own.to.is_some());
    if !all.is_empty() {
        map_terms(page, equations, |term| alike(term, &all));
    }
}

fn see_applied(term: &Expr, all: &mut Map<Symbol, Applied>) {
    match term {
        Expr::Symbol(name) => all.entry(name.clone()).or_default().alone = true,
        Expr::Apply(name, arguments) => {
            let known = all.entry(name.clone()).or_default();
            let is_first = !known.is_applied;
            known.is_applied = true;
            let bare = arguments.iter().all(|own| matches!(own, Expr::Symbol(_)));
            if is_first && bare {
                known.to = Some(arguments.clone());
            } else if known.to.as_ref() != Some(arguments) {
                known.to = None;
            }
        }
        Expr::Partial { body, .. } => {
            if let Some(name) = name_of(body) {
                all.entry(name.clone()).or_default().differentiated = true;
            }
            if !matches!(**body, Expr::Symbol(_)) {
                see_applied(body, all);
            }
            return;
        }
        _ => {}
    }
    if !matches!(term, Expr::Apply(..)) {
        term.children().for_each(|child| see_applied(child, all));
    }
}

fn alike(term: &Expr, all: &Map<Symbol, Applied>) -> Expr {
    match term {
        Expr::Apply(name, arguments) if arguments.len() > 1 => match all.get(name) {
            Some(own) if own.alone => Expr::Symbol(name.clone()),
            _ => term.clone(),
        },
        Expr::Partial {
            body,
            variable,
            held,
        } => {
            let with_arguments = name_of(body).and_then(|name| {
                let own = all.get(name).filter(|own| !own.alone)?;
                Some(Expr::Apply(name.clone(), own.to.clone()?))
            });
            Expr::Partial {
                body: with_arguments.unwrap_or_else(|| alike(body, all)).into(),
                variable: variable.clone(),
                held: held.clone(),
            }
        }
        term => term.map_children(|child| alike(child, all)),
    }
}
