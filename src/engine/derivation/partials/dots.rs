//! `\dot x` beside `\frac{d}{dt} \frac{\partial L}{\partial \dot x}`, or with `\ddot x` beside `\frac{dE}{dt}`: the slope of `x`, and `\ddot x` that of
//! `\dot x`.

use crate::algebra::{Expr, Formula, Symbol};
use crate::document::Span;
use crate::sorted::Set;

use super::super::Equation;
use super::super::names::{self, undotted};
use super::super::page::Page;
use super::super::slopes::{TIME, base};
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
        return tie_accelerations(page, equations);
    };
    let Some(own) = suppose(page, tied, &time, span) else {
        return;
    };
    for equation in equations {
        equation.locals.push(own);
    }
}

/// Where something is differentiated by the time, `\frac{dE}{dt}`, that so is what has a dot, and two, on the page.
pub(super) fn tie_accelerations(page: &mut Page, equations: &mut [Equation]) {
    let time = Symbol::new(TIME);
    let is_slope =
        |part: &Expr| matches!(part, Expr::Derivative { variable, .. } if *variable == time);
    let has_slope = |equation: &Equation| {
        let mut sides = equation.statements().iter().flat_map(sides_of);
        sides.any(|side| side.any(&is_slope))
    };
    let concerned: Vec<usize> = (equations.iter().enumerate())
        .filter(|(_, equation)| has_slope(equation))
        .map(|(at, _)| at)
        .collect();
    let Some(span) = concerned.first().map(|&at| equations[at].body) else {
        return;
    };
    let mut names = Set::new();
    for side in equations
        .iter()
        .flat_map(Equation::statements)
        .flat_map(sides_of)
    {
        names.extend(side.free_symbols());
    }
    let twice = names.iter().filter_map(|name| {
        let (own, order, is_dot) = base(name)?;
        let dotted = names::dotted(&own, false);
        (order == 2 && is_dot && names.contains(&dotted)).then_some((dotted, own))
    });
    let Some(own) = suppose(page, twice.collect(), &time, span) else {
        return;
    };
    for at in concerned {
        equations[at].locals.push(own);
    }
}

/// Supposes that names with a dot are slopes of those without, and those with two dots of them.
fn suppose(
    page: &mut Page,
    tied: Set<(Symbol, Symbol)>,
    time: &Symbol,
    span: Span,
) -> Option<usize> {
    let mut said = Vec::new();
    for (dotted, name) in tied {
        let slope = |own: &Symbol| Expr::Symbol(own.clone()).differentiated_by(time);
        let twice = names::dotted(&name, true);
        said.push(Formula::equal(slope(&name), Expr::Symbol(dotted.clone())));
        said.push(Formula::equal(slope(&dotted), Expr::Symbol(twice)));
    }
    (!said.is_empty()).then(|| page.suppose_meant(said, span))
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
