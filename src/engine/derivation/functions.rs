//! What the definition of a function says of the arguments with which others speak of it: of `f(x) = 3 x^2` also that `f(2) = 12`.
//!
//! A function is defined by the equation that is the first to speak of it, and gives it for a symbol by a term in that. What comes later,
//! `f(x) = 0`, is a condition.

use std::sync::Arc;

use crate::algebra::{Expr, Formula, LimitPoint, Symbol};
use crate::document::Extent;
use crate::kernel::Domain;
use crate::sorted::Set;

use super::equation::{formulas, terms};
use super::page::Page;
use super::{Derivation, Equation};

/// Where a function is spoken of.
#[derive(PartialEq)]
struct Place {
    /// Its argument there.
    at: Expr,
    /// `B(0)` is read as where `B(z)` goes with `z`.
    is_limit: bool,
}

/// So many values of one function are told.
const MOST_VALUES: usize = 8;

impl Equation {
    /// The functions that it speaks of with an argument.
    pub(super) fn functions(&self) -> Set<Symbol> {
        Formula::applied_in(self.statements().iter().flat_map(terms))
    }
}

/// Tells of what the text supposes where it says no more than what a function is of which nothing else speaks: `\theta = T(x) - T_0`, put for the
/// excess temperature. Whatever `\theta` is, there is such a function.
pub(super) fn see_mere_names(page: &mut Page, equations: &[Equation]) {
    let applied = |formula: &Formula| Formula::applied_in(formula.terms());
    let supposed = page.locals.iter().flat_map(|local| &local.formulas);
    let supposed: Vec<Set<Symbol>> = supposed.map(|own| applied(own)).collect();
    if supposed.iter().all(Set::is_empty) {
        return;
    }
    let mut spoken_of: Set<Symbol> = equations.iter().flat_map(Equation::functions).collect();
    let stated = equations.iter().flat_map(Equation::symbols);
    spoken_of.extend(stated);
    let is_alone = |own: &Symbol| {
        let times = supposed.iter().filter(|all| all.contains(own)).count();
        times == 1 && !spoken_of.contains(own)
    };
    let names = |formula: &Arc<Formula>| {
        formula.as_equation().is_some() && applied(formula).iter().any(is_alone)
    };
    for local in &mut page.locals {
        local.only_names = !local.formulas.is_empty() && local.formulas.iter().all(names);
    }
}

impl Derivation {
    /// The values of a function that an equation defines, for the arguments with which equations among these speak of it.
    pub fn values_of_function(&self, definition: usize, among: &[usize]) -> Vec<Formula> {
        let equation = &self.equations[definition];
        // Most equations define no function, and need not be gone through for it.
        let mut sides = equation.statements().iter().flat_map(terms);
        let may_define = sides.any(|side| matches!(side, Expr::Apply(..)));
        if equation.extent != Extent::Throughout || !may_define {
            return Vec::new();
        }
        let mut stated = equation.statements().iter().flat_map(formulas);
        let Some((function, argument, value)) = stated.find_map(|own| defined(&own)) else {
            return Vec::new();
        };
        let page = &self.pages[equation.page];
        let mentions = self.mentions[equation.page].get(&function);
        let is_first = mentions.and_then(|all| all.first()) == Some(&definition);
        // What is defined for some numbers alone says nothing of others.
        if !is_first || page.domains.get(&argument).is_some_and(is_bounded) {
            return Vec::new();
        }
        let mut places: Vec<Place> = Vec::new();
        for own in among.iter().map(|&at| &self.equations[at]) {
            let stated = own.statements().iter().flat_map(terms);
            // "The distance along the plane is $R = x(T)/\cos\alpha$."
            let said = own.told.iter().chain(&own.locals);
            let said = said.flat_map(|&at| &self.local(own.page, at).formulas);
            for term in stated.chain(said.flat_map(|own| own.terms())) {
                collect_arguments(term, &function, &mut places);
            }
        }
        places.retain(|place| place.at != Expr::Symbol(argument.clone()));
        places.truncate(MOST_VALUES);
        let at = |place: Place| {
            let own = value.substitute(&argument, &place.at);
            let applied = |to: Expr| Expr::Apply(function.clone(), [to].into());
            let left = match place.is_limit {
                true => Expr::Limit {
                    body: applied(Expr::Symbol(argument.clone())).into(),
                    variable: argument.clone(),
                    point: LimitPoint::Finite(place.at.into()),
                },
                false => applied(place.at),
            };
            Formula::equal(left, own)
        };
        places.into_iter().map(at).collect()
    }
}

/// `f(x) = term`, where the term speaks of `x` and not of `f`.
fn defined(formula: &Formula) -> Option<(Symbol, Symbol, Expr)> {
    let (Expr::Apply(function, arguments), value) = formula.as_equation()? else {
        return None;
    };
    let [Expr::Symbol(argument)] = &arguments[..] else {
        return None;
    };
    let is_said = value.mentions(argument) && !value.mentions(function);
    // To put something in under what is done by the argument would change what that is.
    let is_bound = value.any(&|part| part.binder().is_some());
    (is_said && !is_bound).then(|| (function.clone(), argument.clone(), value.clone()))
}

fn is_bounded(domain: &Domain) -> bool {
    domain.integer || domain.bounds().next().is_some()
}

/// The arguments of a function, where they stand under nothing by which they run.
fn collect_arguments(term: &Expr, function: &Symbol, found: &mut Vec<Place>) {
    let mut found_at = |at: &Expr, is_limit| {
        let at = at.clone();
        let place = Place { at, is_limit };
        if !found.contains(&place) {
            found.push(place);
        }
    };
    if let Expr::Limit {
        body,
        point: LimitPoint::Finite(place),
        ..
    } = term
        && matches!(&**body, Expr::Apply(own, _) if own == function)
        && matches!(**place, Expr::Number(_))
    {
        found_at(place, true);
    }
    if term.binder().is_some() {
        return;
    }
    if let Expr::Apply(own, arguments) = term
        && own == function
        && let [place] = &arguments[..]
    {
        found_at(place, false);
    }
    term.children()
        .for_each(|child| collect_arguments(child, function, found));
}
