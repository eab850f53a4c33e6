//! Quantities that are written with what they depend on, and without: `y(t) = h - \frac12 g t^2`, and below it `y`.
//!
//! Both are one quantity where a page has both and is solved for it somewhere, wherever the argument is the same symbol. Not where a term or a statement speaks
//! of both in two ways, where a sum or a limit goes over the argument, nor where it is another elsewhere: `f(s)` beside `f(t)`.

use std::collections::BTreeSet;

use crate::algebra::{Expr, Formula, Symbol};
use crate::sorted::Tree;

use super::Equation;
use super::equation::{conditions, each_side, formulas};
use super::page::Page;

/// How a page speaks of a name.
#[derive(Default)]
struct Spoken {
    /// The arguments that it has somewhere.
    arguments: BTreeSet<Symbol>,
    /// Some equation is solved for it: `y(t) = …`.
    solved: bool,
    /// It stands by itself somewhere.
    alone: bool,
    /// It is differentiated by itself somewhere.
    moves: bool,
    /// Nothing may be concluded from that.
    apart: bool,
}

/// Leaves out the arguments of what also stands without them on a page.
pub(super) fn leave_out(page: &mut Page, equations: &mut [Equation]) {
    let mut all: Tree<Symbol, Spoken> = Tree::new();
    for statement in equations.iter().flat_map(Equation::statements) {
        let said: Vec<Formula> = formulas(statement);
        see_together(said.iter().chain(&conditions(statement)), &mut all);
    }
    for formula in page.locals.iter().flat_map(|local| &local.formulas) {
        see_together(std::iter::once(&**formula), &mut all);
    }
    let left_out = |(name, own): &(Symbol, Spoken)| {
        let argument = own.arguments.first();
        own.solved && own.alone && !own.apart && own.arguments.len() == 1 && argument != Some(name)
    };
    let all: Tree<Symbol, Spoken> = all.into_entries().filter(left_out).collect();
    if all.is_empty() {
        return;
    }
    for equation in equations {
        for statement in equation.statements.iter_mut().flatten() {
            each_side(statement, &mut |term, _| *term = without(term, &all));
        }
    }
    for formula in page.locals.iter_mut().flat_map(|local| &mut local.formulas) {
        *formula = formula.map_terms(|term| without(term, &all)).into();
    }
}

/// What is said in one statement.
fn see_together<'a>(formulas: impl Iterator<Item = &'a Formula>, all: &mut Tree<Symbol, Spoken>) {
    let mut own: Tree<Symbol, Spoken> = Tree::new();
    for formula in formulas {
        if let Formula::AllEqual { sequence, .. } = formula {
            own.entry(sequence.clone()).or_default().apart = true;
        }
        if let Some((Expr::Apply(name, _), _)) = formula.as_equation() {
            own.entry(name.clone()).or_default().solved = true;
        }
        for term in formula.terms() {
            see(term, &mut Vec::new(), &mut own);
        }
    }
    for (name, own) in own.into_entries() {
        let known = all.entry(name).or_default();
        known.apart |= own.apart || own.alone && !own.arguments.is_empty();
        known.alone |= own.alone || own.moves;
        known.solved |= own.solved;
        known.arguments.extend(own.arguments);
    }
}

fn see<'a>(term: &'a Expr, bound: &mut Vec<&'a Symbol>, own: &mut Tree<Symbol, Spoken>) {
    match term {
        Expr::Symbol(symbol) => own.entry(symbol.clone()).or_default().alone = true,
        Expr::Element { sequence, .. } => own.entry(sequence.clone()).or_default().apart = true,
        // `\frac{dy}{dt} = -k y(t)` speaks of one `y`.
        Expr::Derivative { body, .. } if let Expr::Symbol(symbol) = &**body => {
            own.entry(symbol.clone()).or_default().moves = true;
        }
        Expr::Apply(name, arguments) => {
            let known = own.entry(name.clone()).or_default();
            match &arguments[..] {
                [Expr::Symbol(argument)] if !bound.contains(&argument) => {
                    known.arguments.insert(argument.clone());
                }
                _ => known.apart = true,
            }
            arguments
                .iter()
                .for_each(|argument| see(argument, bound, own));
        }
        Expr::Series { index, .. } => within(term, index, bound, own),
        Expr::Limit { variable, .. } => within(term, variable, bound, own),
        term => term.children().for_each(|child| see(child, bound, own)),
    }
}

fn within<'a>(
    term: &'a Expr,
    symbol: &'a Symbol,
    bound: &mut Vec<&'a Symbol>,
    own: &mut Tree<Symbol, Spoken>,
) {
    bound.push(symbol);
    term.children().for_each(|child| see(child, bound, own));
    bound.pop();
}

fn without(term: &Expr, names: &Tree<Symbol, Spoken>) -> Expr {
    match term {
        Expr::Apply(name, _) if names.contains_key(name) => Expr::Symbol(name.clone()),
        term => term.map_children(|child| without(child, names)),
    }
}
