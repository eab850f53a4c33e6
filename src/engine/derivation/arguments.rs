//! Quantities that are written with what they depend on, and without: `y(t) = h - \frac12 g t^2`, and below it `y`.
//!
//! Both are one quantity where a page has both and is solved for it somewhere, wherever the argument is the same symbol. Not where a term or a statement speaks
//! of both in two ways, where a sum or a limit goes over the argument, nor where it is another elsewhere: `f(s)` beside `f(t)`.
//!
//! The value at a number, `y(0)` or `y(\pi)`, is that of what depends on one symbol throughout; `\dot{y}(0)` is that of its slope. So is the value at what
//! names a special value of the argument, `y(t_1)`, or is composed of such, `y(L/2)`, where the argument is left out elsewhere, or a law says by what it is differentiated.

use std::collections::BTreeSet;

use crate::algebra::{Expr, Formula, LimitPoint, Symbol};
use crate::notation::{is_composed_place, names_a_place};
use crate::sorted::{Set, Tree};

use super::Equation;
use super::equation::{all_terms, conditions, formulas, map_terms};
use super::names;
use super::page::Page;
use super::slopes::base;

/// How a page speaks of a name.
#[derive(Default)]
struct Spoken {
    /// The arguments that it has somewhere.
    arguments: BTreeSet<Symbol>,
    /// Some equation is solved for it: `y(t) = …`.
    solved: bool,
    /// It stands by itself somewhere.
    alone: bool,
    /// By what it is differentiated by itself somewhere.
    moves: BTreeSet<Symbol>,
    /// What a term speaks of by which it is given without an argument.
    given_in: BTreeSet<Symbol>,
    /// Its value at a number is spoken of.
    valued: bool,
    /// Nothing may be concluded from that.
    apart: bool,
}

/// Leaves out the arguments of what also stands without them on a page.
pub(super) fn leave_out(page: &mut Page, equations: &mut [Equation]) {
    // Few pages write an argument.
    let is_applied = |part: &Expr| matches!(part, Expr::Apply(..));
    if !all_terms(page, equations).any(|term| term.any(&is_applied)) {
        return;
    }
    integrate_over_arguments(page, equations);
    let mut all: Tree<Symbol, Spoken> = Tree::new();
    for statement in equations.iter().flat_map(Equation::statements) {
        let said: Vec<Formula> = formulas(statement);
        see_together(said.iter().chain(&conditions(statement)), &mut all);
    }
    for formula in page.locals.iter().flat_map(|local| &local.formulas) {
        see_together(std::iter::once(&**formula), &mut all);
    }
    let in_text = names::arguments_in_text(&page.document.source, page.document.inline());
    // What has one argument throughout, and whether it is left out.
    let mut functions: Tree<Symbol, (Symbol, bool)> = Tree::new();
    let mut any = false;
    let all: Vec<(Symbol, Spoken)> = all.into_entries().collect();
    let moving = all.iter().filter(|own| !own.1.moves.is_empty());
    let moving: Set<Symbol> = moving.map(|own| own.0.clone()).collect();
    let variables: BTreeSet<Symbol> = (all.iter())
        .flat_map(|own| own.1.moves.iter().cloned())
        .collect();
    for (name, own) in all {
        // `w''(L)` is read of `w`.
        if base(&name).is_some_and(|of| moving.contains(&of.0)) {
            any |= own.valued || !own.arguments.is_empty();
            continue;
        }
        let told = in_text.get(&name);
        let argument = the_argument(&own.arguments).filter(|_| own.arguments.len() == 1);
        // `w(L)` beside `w(0)`, of a `w` that is not known to depend on that.
        let is_place = |own: &&Symbol| names_a_place(own);
        let argument =
            argument.filter(|only| !is_place(only) || told.is_none_or(|own| own == *only));
        let may_be_left_out = own.solved && own.alone && !own.apart;
        // "At $t_1$ it is $y(t_1)$", where `y` is elsewhere what `y(t)` is.
        let beside_values = || the_argument(&own.arguments).filter(|_| may_be_left_out);
        // `s = A + \frac{B}{r^2}`, where the page says how something changes with `r`.
        let by_term = || {
            let mut by = own.given_in.iter().filter(|own| variables.contains(*own));
            let only = by.next()?;
            (own.moves.is_empty() && by.next().is_none()).then_some(only)
        };
        // "At the free end it is $y(L)$", where `y` changes with `x`.
        let of_places = || {
            let mut places = own.arguments.iter();
            let by = own.moves.first().filter(|_| own.moves.len() == 1);
            let by = by.or(told.filter(|_| own.moves.is_empty()));
            let by = by.or_else(by_term)?;
            let is_moved = may_be_left_out && !own.arguments.is_empty();
            (is_moved && places.all(|place| place != by && names_a_place(place))).then_some(by)
        };
        // "$w(0) = 0$ and $w'(L) = 0$" of a law for `\frac{d^2 w}{dx^2}`.
        let of_law = || {
            let by = own.moves.first().filter(|_| own.moves.len() == 1)?;
            let mut places = own.arguments.iter();
            let is_so = !own.apart && places.all(|place| place == by || names_a_place(place));
            is_so.then_some(by)
        };
        // "If $\zeta(\psi)$ is its elevation", and `\zeta(0) - \zeta(\pi/2)`.
        let of_text = || {
            let is_so = own.valued && own.alone && !own.apart && own.arguments.is_empty();
            told.filter(|_| is_so)
        };
        any |= own.valued;
        let argument = of_places().or(argument).or_else(beside_values);
        let by_law = argument.is_none().then(of_law).flatten();
        let by_law = by_law.or_else(|| argument.is_none().then(of_text).flatten());
        if let Some(argument) = argument.or(by_law) {
            let may_be_left_out = may_be_left_out || by_law.is_some();
            let left_out = may_be_left_out && *argument != name;
            any |= left_out;
            functions.insert(name, (argument.clone(), left_out));
        }
    }
    if !any {
        return;
    }
    map_terms(page, equations, |term| without(term, &functions));
}

/// Whether an argument is a number, π among them: that is a place, and nothing that a quantity depends on.
fn is_number(argument: &Expr) -> bool {
    match argument {
        Expr::Symbol(own) => own.name() == "\\pi",
        own => matches!(own, Expr::Number(_)),
    }
}

/// The one symbol of which all other arguments name special values, as `r_0` and `a` do of `r`.
fn the_argument(all: &BTreeSet<Symbol>) -> Option<&Symbol> {
    let is_it = |own: &&Symbol| {
        let mut others = all.iter().filter(|other| other != own);
        let varies = !names_a_place(own);
        others.all(|other| other.is_variant_of(own) || varies && names_a_place(other))
    };
    all.iter().find(is_it)
}

/// What is said in one statement.
fn see_together<'a>(formulas: impl Iterator<Item = &'a Formula>, all: &mut Tree<Symbol, Spoken>) {
    let mut own: Tree<Symbol, Spoken> = Tree::new();
    for formula in formulas {
        if let Formula::AllEqual { sequence, .. } = formula {
            own.entry(sequence.clone()).or_default().apart = true;
        }
        match formula.as_equation() {
            Some((Expr::Apply(name, _), _)) => own.entry(name.clone()).or_default().solved = true,
            Some((Expr::Symbol(name), value)) => {
                let known = own.entry(name.clone()).or_default();
                known.given_in.extend(value.free_symbols());
            }
            _ => {}
        }
        for term in formula.terms() {
            see(term, &mut Vec::new(), &mut own);
        }
    }
    for (name, own) in own.into_entries() {
        let known = all.entry(name).or_default();
        known.apart |= own.apart || own.alone && !own.arguments.is_empty();
        known.alone |= own.alone || !own.moves.is_empty();
        known.moves.extend(own.moves);
        known.given_in.extend(own.given_in);
        known.solved |= own.solved;
        known.valued |= own.valued;
        known.arguments.extend(own.arguments);
    }
}

fn see<'a>(term: &'a Expr, bound: &mut Vec<&'a Symbol>, own: &mut Tree<Symbol, Spoken>) {
    match term {
        Expr::Symbol(symbol) => own.entry(symbol.clone()).or_default().alone = true,
        Expr::Element { sequence, .. } => own.entry(sequence.clone()).or_default().apart = true,
        // `\frac{dy}{dt} = -k y(t)` speaks of one `y`.
        Expr::Derivative { body, variable } if let Expr::Symbol(symbol) = &**body => {
            let known = own.entry(symbol.clone()).or_default();
            known.moves.insert(variable.clone());
        }
        Expr::Apply(name, arguments) => {
            let known = own.entry(name.clone()).or_default();
            match &arguments[..] {
                [place] if is_number(place) => known.valued = true,
                // Of what nobody leaves the argument out that is an argument like any other.
                [place] if is_composed_place(place) => {}
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
        // The value of a slope, `y'(0)`.
        Expr::Limit {
            body,
            point: LimitPoint::Finite(place),
            ..
        } if matches!((&**body, is_number(place)), (Expr::Derivative { .. }, true)) => {
            see(body, bound, own);
        }
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

/// An integral over another letter than the argument of what stands in it, up to that: `\int_0^r \rho s^2\,ds` of `\rho(r)` is one of `\rho(s)`.
fn over_another(term: &Expr, functions: &Tree<Symbol, (Symbol, bool)>) -> Option<Expr> {
    over(term, |body, variable, limits| {
        let moved = |own: &Symbol| match functions.get(own) {
            Some((argument, true)) if argument != variable => {
                let is_limit = limits.iter().any(|limit| limit.mentions(argument));
                is_limit.then_some(argument)
            }
            _ => None,
        };
        body.free_symbols().iter().find_map(moved).cloned()
    })
}

/// An integral with its variable called otherwise, as its integrand, its variable and its limits ask for; nothing where something else is called so in it.
fn over(
    term: &Expr,
    called: impl Fn(&Expr, &Symbol, [&Expr; 2]) -> Option<Symbol>,
) -> Option<Expr> {
    let Expr::Integral {
        body,
        variable,
        from,
        to,
    } = term
    else {
        return None;
    };
    let other = called(body, variable, [from, to])?;
    let is_taken = |part: &Expr| {
        let binds = |own: &Symbol| *own == other || own == variable;
        matches!(part, Expr::Symbol(own) if *own == other) || part.binder().is_some_and(binds)
    };
    (!body.any(&is_taken)).then(|| Expr::Integral {
        body: body
            .substitute(variable, &Expr::Symbol(other.clone()))
            .into(),
        variable: other.clone(),
        from: from.clone(),
        to: to.clone(),
    })
}

/// Integrals of what displays give, over its own argument: `\int_0^r \rho(s) s^2\,ds` of `\rho(r) = …` is `\int_0^r \rho(r) r^2\,dr`.
fn integrate_over_arguments(page: &mut Page, equations: &mut [Equation]) {
    let mut given: Tree<Symbol, Option<Symbol>> = Tree::new();
    let statements = equations.iter().flat_map(Equation::statements);
    for formula in statements.flat_map(formulas) {
        let Some((Expr::Apply(name, arguments), value)) = formula.as_equation() else {
            continue;
        };
        if let [Expr::Symbol(argument)] = &arguments[..]
            && value.mentions(argument)
            && !names_a_place(argument)
        {
            let known = given
                .entry(name.clone())
                .or_insert_with(|| Some(argument.clone()));
            known.take_if(|own| own != argument);
        }
    }
    if !given.is_empty() {
        map_terms(page, equations, |term| over_arguments(term, &given));
    }
}

fn over_arguments(term: &Expr, given: &Tree<Symbol, Option<Symbol>>) -> Expr {
    let own = term.map_children(|child| over_arguments(child, given));
    let renamed = over(&own, |body, variable, _| {
        let here = Expr::Symbol(variable.clone());
        let argument = |part: &Expr| match part {
            Expr::Apply(name, arguments) if arguments[..] == [here.clone()] => {
                given.get(name)?.clone()
            }
            _ => None,
        };
        body.first(&argument).filter(|own| own != variable)
    });
    renamed.unwrap_or(own)
}

/// A term without the arguments that are left out, and with values at a number as what they are: limits there, which are the values of
/// what does not jump.
fn without(term: &Expr, functions: &Tree<Symbol, (Symbol, bool)>) -> Expr {
    let Expr::Apply(name, arguments) = term else {
        let own = term.map_children(|child| without(child, functions));
        return over_another(&own, functions).unwrap_or(own);
    };
    let plain = |name: &Symbol| {
        let (argument, left_out) = functions.get(name)?;
        let body = match left_out {
            true => Expr::Symbol(name.clone()),
            false => Expr::Apply(name.clone(), [Expr::Symbol(argument.clone())].into()),
        };
        Some((body, argument.clone()))
    };
    let slope = || {
        let (own, order, _) = base(name)?;
        let (body, variable) = plain(&own)?;
        let slope = (0..order).fold(body, |body, _| body.differentiated_by(&variable));
        Some((slope, variable))
    };
    // `y(0)`, or `y(t_1)` beside `y(t)`.
    let of = base(name).map(|(own, ..)| own);
    let known = functions.get(name).or_else(|| functions.get(of.as_ref()?));
    let is_place = |place: &Expr| match (place, known) {
        (Expr::Symbol(place), Some((argument, true))) => {
            place != argument && (place.is_variant_of(argument) || names_a_place(place))
        }
        (place, Some((_, true))) if is_composed_place(place) => true,
        (place, _) => is_number(place),
    };
    match &arguments[..] {
        [place] if is_place(place) => match plain(name).or_else(slope) {
            Some((body, variable)) => Expr::Limit {
                body: body.into(),
                variable,
                point: LimitPoint::Finite(place.clone().into()),
            },
            None => term.clone(),
        },
        _ => match functions.get(name) {
            Some((_, true)) => Expr::Symbol(name.clone()),
            _ => term.clone(),
        },
    }
}
