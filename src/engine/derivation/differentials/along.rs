//! What differentials are taken along. By what a page differentiates, its differentials are rates: `dx = v\,dt` says `\frac{dx}{dt} = v`. Where
//! it differentiates by nothing, they are rates by the time, or by the one of two that stands alone on the right, `dT = \mu T\,d\theta`;
//! or along any change, `dU = T\,dS - p\,dV`, of which nothing more is known.

use num_traits::Zero;

use super::refusal;
use crate::algebra::{Expr, Formula, Symbol};
use crate::derivation::Equation;
use crate::derivation::equation::{all_terms, each_side, formulas, terms};
use crate::derivation::page::Page;
use crate::derivation::slopes::TIME;
use crate::sorted::Set;

/// Follows the differentials of a page, or refuses those of which it is not clear along what.
pub(super) fn follow(page: &mut Page, equations: &mut [Equation]) {
    if !all_terms(page, equations).any(|term| !changed(term).is_empty()) {
        return;
    }
    let along = Along::of(page, equations);
    let is_constant = |own: &Symbol| page.domains.get(own).is_some_and(|domain| domain.constant);
    for equation in equations.iter_mut() {
        let Ok(statements) = &mut equation.statements else {
            continue;
        };
        let mut refused = None;
        for statement in statements.iter_mut() {
            let own: Set<Symbol> = terms(statement).flat_map(changed).collect();
            if own.is_empty() {
                continue;
            }
            match along
                .variable(&own)
                .filter(|_| !own.iter().any(is_constant))
            {
                Some(None) => {}
                Some(Some(by)) => each_side(statement, &mut |term, _| *term = rates(term, by)),
                None => refused = Some(refusal(statement, &Symbol::new("d"))),
            }
        }
        if let Some(error) = refused {
            equation.statements = Err(error);
        }
    }
    for formula in page.locals.iter_mut().flat_map(|own| &mut own.formulas) {
        let own: Set<Symbol> = formula.terms().into_iter().flat_map(changed).collect();
        if let Some(Some(by)) = along.variable(&own) {
            *formula = formula.map_terms(|term| rates(term, by)).into();
        }
    }
}

/// What the differentials of a page are taken along.
enum Along {
    /// By one thing.
    One(Symbol),
    /// By that of several things of which an equation has the differential.
    Several(Set<Symbol>),
    /// A change of which nothing is known.
    Any,
}

impl Along {
    fn of(page: &Page, equations: &[Equation]) -> Along {
        let mut slopes = Set::new();
        all_terms(page, equations).for_each(|term| collect_slopes(term, &mut slopes));
        let all = said(page, equations);
        let own: Set<Symbol> = all.iter().flat_map(changed_in).collect();
        // What else is differentiated has nothing to do with these.
        slopes
            .retain(|(of, by)| own.contains(by) || of.as_ref().is_some_and(|of| own.contains(of)));
        if !slopes.is_empty() {
            // What runs with another one does not run by itself.
            let runs = |by: &Symbol| slopes.iter().any(|slope| slope.0.as_ref() == Some(by));
            let variables: Set<Symbol> = slopes.iter().map(|slope| slope.1.clone()).collect();
            let mut first: Set<Symbol> = variables.iter().filter(|by| !runs(by)).cloned().collect();
            return match first.len() {
                1 => first.pop_first().map_or(Along::Any, Along::One),
                _ => Along::Several(variables),
            };
        }
        let time = Symbol::new(TIME);
        let mut pairs = all.iter().filter_map(alone_on_the_right);
        let by = match own.contains(&time) {
            true => Some(time),
            false => pairs.next().filter(|_| own.len() == 2),
        };
        let stands = |by: &Symbol| all.iter().any(|own| says_it_stands(own, by));
        match by.filter(|by| !stands(by)) {
            Some(by) => Along::One(by),
            None => Along::Any,
        }
    }

    /// By what those are rates that stand in one equation; nothing where that is not clear, and `Some(None)` along any change.
    fn variable(&self, changed: &Set<Symbol>) -> Option<Option<&Symbol>> {
        match self {
            Along::Any => Some(None),
            Along::One(by) => Some(Some(by)),
            Along::Several(all) => {
                let mut own = all.iter().filter(|own| changed.contains(*own));
                let by = own.next()?;
                own.next().is_none().then_some(Some(by))
            }
        }
    }
}

/// All that a page states and supposes with differentials.
fn said(page: &Page, equations: &[Equation]) -> Vec<Formula> {
    let statements = equations.iter().flat_map(Equation::statements);
    let stated = statements.flat_map(formulas);
    let locals = page.locals.iter().flat_map(|own| &own.formulas);
    let all = stated.chain(locals.map(|own| (**own).clone()));
    all.filter(|own| !changed_in(own).is_empty()).collect()
}

fn changed_in(formula: &Formula) -> Set<Symbol> {
    formula.terms().into_iter().flat_map(changed).collect()
}

/// Of what a term has differentials.
fn changed(term: &Expr) -> Set<Symbol> {
    let mut found = match term.as_differential() {
        Some(of) => of.free_symbols(),
        None => Set::new(),
    };
    found.extend(term.children().flat_map(changed));
    found
}

/// `\theta` of `dT = \mu T\,d\theta`.
fn alone_on_the_right(formula: &Formula) -> Option<Symbol> {
    let (left, right) = formula.as_equation()?;
    let mut right = changed(right);
    (changed(left).len() == 1 && right.len() == 1)
        .then(|| right.pop_first())
        .flatten()
}

/// `dT = 0`
fn says_it_stands(formula: &Formula, by: &Symbol) -> bool {
    let is_nought = |term: &&Expr| matches!(term, Expr::Number(own) if own.is_zero());
    let terms = formula.terms();
    terms.iter().any(is_nought) && changed_in(formula) == Set::from([by.clone()])
}

/// The slopes in a term, but for differentials: of what, if that is a symbol, and by what.
fn collect_slopes(term: &Expr, found: &mut Set<(Option<Symbol>, Symbol)>) {
    if let Expr::Derivative { body, variable } = term
        && !variable.is_change()
    {
        let of = match &**body {
            Expr::Symbol(own) => Some(own.clone()),
            _ => None,
        };
        found.insert((of, variable.clone()));
    }
    (term.children()).for_each(|part| collect_slopes(part, found));
}

/// A term with the rates by something in the place of differentials.
fn rates(term: &Expr, by: &Symbol) -> Expr {
    let is_by =
        |part: &Expr| matches!(part.as_differential(), Some(Expr::Symbol(own)) if own == by);
    match term {
        term if is_by(term) => Expr::integer(1),
        Expr::Product(factors) => {
            let factors = factors.iter().filter(|factor| !is_by(factor));
            let mut factors: Vec<Expr> = factors.map(|factor| rates(factor, by)).collect();
            match factors.len() {
                0 => Expr::integer(1),
                1 => factors.remove(0),
                _ => Expr::Product(factors.into()),
            }
        }
        term => match term.as_differential() {
            Some(of) => rates(of, by).differentiated_by(by),
            None => term.map_children(|part| rates(part, by)),
        },
    }
}
