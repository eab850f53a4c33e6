//! `\dot x` beside `\frac{d}{dt} \frac{\partial L}{\partial \dot x}`: the slope of `x`, and `\ddot x` that of `\dot x`.

use crate::algebra::{Expr, Formula, Symbol};
use crate::document::Span;
use crate::sorted::Set;

use super::super::Equation;
use super::super::names::undotted;
use super::super::page::Page;
use super::{is_partial, sides_of};

/// Where `\frac{d}{dt} \frac{\partial L}{\partial \dot x}` is spoken of, that `\dot x` and `\ddot x` are slopes.
pub(super) fn tie_dots(page: &mut Page, equations: &mut [Equation]) {
    let mut found: Option<Span> = None;
    let mut tied: Set<(Symbol, Symbol)> = Set::new();
    let mut time = None;
    for equation in equations.iter() {
        for side in equation.statements().iter().flat_map(sides_of) {
            let mut own = None;
            turned(side, &mut own);
            if let Some(by) = own {
                found = found.or(Some(equation.body));
                time = time.or(Some(by));
            }
            dotted_variables(side, &mut tied);
        }
    }
    let (Some(span), Some(time)) = (found, time) else {
        return;
    };
    let mut said = Vec::new();
    for (dotted, name) in tied {
        let slope = |own: &Symbol| Expr::Symbol(own.clone()).differentiated_by(&time);
        let twice = Symbol::new(format!("\\ddot{{{}}}", name.name()));
        said.push(Formula::equal(slope(&name), Expr::Symbol(dotted.clone())));
        said.push(Formula::equal(slope(&dotted), Expr::Symbol(twice)));
    }
    if said.is_empty() {
        return;
    }
    let own = page.suppose_meant(said, span);
    for equation in equations {
        equation.locals.push(own);
    }
}

/// By what a partial derivative is differentiated further, if one is.
fn turned(term: &Expr, found: &mut Option<Symbol>) {
    if let Expr::Derivative { body, variable } = term
        && body.any(&is_partial)
    {
        found.get_or_insert_with(|| variable.clone());
    }
    term.children().for_each(|child| turned(child, found));
}

/// The names with a dot by which is differentiated, each with the name below it.
fn dotted_variables(term: &Expr, found: &mut Set<(Symbol, Symbol)>) {
    if let Expr::Partial { variable, .. } = term
        && let Some(name) = undotted(variable)
    {
        found.insert((variable.clone(), name));
    }
    term.children()
        .for_each(|child| dotted_variables(child, found));
}
