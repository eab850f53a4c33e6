//! Integrals of a law that are not solved for the quantity: "Separating variables and integrating, $$\ln\frac{v}{v_0} = -b t$$" after
//! `\frac{dv}{dt} = -b v`.
//!
//! Where it begins brings a symbol of its own along, so that it would say what that is. But along the law both sides change alike, wherever
//! that is: it is refuted where they do not, and would with one small edit.

use std::borrow::Cow;

use crate::algebra::{Expr, Formula, Symbol, effort, split_subscript};
use crate::derivation::{Assumed, Goal, Source, renamed, values_at};
use crate::kernel::Standing;
use crate::search::{self, Decision, Effort, InChain, Mended, Slips};
use crate::sorted::Set;

use super::super::judge::{Found, Judge, taken};
use super::obeys::{fixed_by, meant, order, refuted_of, speaks_of_course};
use super::solution::value_of_its_own;

/// So much work is done for that, as [`effort`] counts it.
const MOST_WORK: u64 = 1_000_000;
/// With one of these two states are compared.
const BETWEEN: [&str; 2] = ["between", "states"];
/// So many edits are tried.
const MOST_EDITS: usize = 60;

/// A law of the first order, and how it goes.
struct Course {
    law: Assumed,
    /// What changes.
    of: Symbol,
    /// With what it changes.
    variable: Symbol,
    /// What stands for both in the first of two states.
    first: Option<[Symbol; 2]>,
}

impl Judge<'_> {
    /// What to say of a relation that is no integral of the law that it is said to come from.
    pub(in crate::audit) fn as_no_integral_of_law(
        &self,
        goal: &Goal,
        premises: &[usize],
    ) -> Option<Found> {
        goal.formula.as_equation()?;
        let is_integral = goal.is_said_outright()
            && goal.rounding.is_none()
            && !goal.formula.speaks_of_slopes()
            && (self.is_led_to_as_solution() || self.says(&BETWEEN))
            && !self.is_of_another_law();
        if !is_integral {
            return None;
        }
        let names = goal.formula.names();
        let near = &self.others(premises)[0];
        let laws = || self.usable.assumed.iter().chain(near);
        let of_goal = || {
            let is_of_it = |own: &Course| own.is_among(&names);
            laws().filter_map(course_of).find(is_of_it)
        };
        let of_states = || {
            let moving = laws().filter_map(course_of);
            { moving }.find_map(|own| between_states(goal, &names, own))
        };
        let (goal, course) = match of_goal() {
            Some(course) => (Cow::Borrowed(goal), course),
            None => of_states()?,
        };
        let goal = &*goal;
        // What is solved for the quantity is looked at as a solution.
        let is_solved = |side: &&Expr| matches!(side, Expr::Symbol(own) if *own == course.of);
        if goal.formula.terms().iter().any(is_solved) {
            return None;
        }
        effort::within(MOST_WORK, || self.held_along(goal, &course, laws()))
    }

    fn held_along<'a>(
        &self,
        goal: &Goal,
        course: &Course,
        said: impl Iterator<Item = &'a Assumed>,
    ) -> Option<Found> {
        let Course {
            law,
            of,
            variable,
            first,
        } = course;
        let mut constants = goal.formula.free_symbols();
        constants.extend(law.formula.free_symbols());
        let known = meant(said, &mut constants, (of, variable));
        let fixed = fixed_by(&law.formula, &known);
        let page = &self.derivation.pages[self.derivation.equations[self.at].page];
        constants.retain(|own| own != of && own != variable && !page.is_number(own));
        if (constants.iter()).any(|own| self.auditor.changes(self.at, own, variable)) {
            return None;
        }
        let claim = |assumed: &[Assumed], formula: &Formula| {
            let mut held = formula.free_symbols();
            held.extend(constants.iter().cloned());
            held.retain(|own| own != of && own != variable);
            search::with_constants(self.derivation.claim(self.at, assumed, formula), held)
        };
        let positive = |own: &Symbol| taken(&Formula::positive(Expr::Symbol(own.clone())));
        let along = constants.iter().chain([of, variable]);
        let positive: Vec<Assumed> = along.map(positive).collect();
        let changes_alike = |formula: &Formula| {
            let (left, right) = formula.as_equation()?;
            let slope = |side: &Expr| side.clone().differentiated_by(variable);
            Some(Formula::equal(slope(left), slope(right)))
        };
        // What the law does not fix may be anything: how the sides change must not depend on it.
        let own = changes_alike(&goal.formula)?;
        let is_free = |symbol: &Symbol| {
            let mut all = positive.clone();
            all.push(taken(&Formula::positive(value_of_its_own())));
            let depends = |slope: &&Expr| {
                let other = slope.substitute(symbol, &value_of_its_own());
                let same = Formula::equal((*slope).clone(), other);
                search::prove_unconditionally(claim(&all, &same), Effort::Light).is_none()
            };
            own.terms().iter().any(depends)
        };
        if constants.difference(&fixed).any(is_free) {
            return None;
        }
        let assumed: Vec<Assumed> = [law.clone()]
            .into_iter()
            .chain(known)
            .chain(positive.iter().cloned())
            .collect();
        let decide = |assumed: &[Assumed], formula: &Formula| {
            Some(self.decide(&*self.pose_claim(claim(assumed, formula)).ok()?))
        };
        // In the first state itself it says nothing.
        let in_first = |formula: &Formula| {
            let [of_first, at_first] = first.as_ref()?;
            let rename = |own: &Symbol| match own {
                own if own == of => of_first.clone(),
                own if own == variable => at_first.clone(),
                own => own.clone(),
            };
            Some(formula.map_terms(|term| renamed(term, &rename)))
        };
        let decision = decide(&assumed, &own)?;
        let begins_wrong = || decide(&positive, &in_first(&goal.formula)?);
        let begins = match decision {
            Decision::Proven { .. } => Some(begins_wrong()?),
            _ => None,
        };
        if matches!(begins, Some(Decision::Proven { .. })) {
            return None;
        }
        let bare = claim(&[], &goal.formula);
        let slips = Slips::of(&bare, &InChain::default(), None, values_at).and_rarer();
        let is_shown = |assumed: &[Assumed], formula: &Formula| {
            search::prove_unconditionally(claim(assumed, formula), Effort::Full)
        };
        let (mended, near) = slips.take(MOST_EDITS).find_map(|edit| {
            let near = changes_alike(&edit.formula)?;
            let derived = is_shown(&assumed, &near)?;
            let begins_right = in_first(&edit.formula);
            let begins_right = begins_right.is_none_or(|own| is_shown(&positive, &own).is_some());
            begins_right.then(|| (Mended::of(derived.proven, edit.change), near))
        })?;
        if let (Some(Decision::Refuted(refuted)), Some(own)) = (begins, in_first(&goal.formula)) {
            let mut found = refuted_of(goal, &own, &positive, refuted);
            found.mended = Some(mended.into());
            found.constant = constants.into_iter().collect();
            return Some(found);
        }
        let mut found = match decision {
            Decision::Refuted(refuted) => refuted_of(goal, &own, &assumed, refuted),
            // Where no point of the law is found, the side that was edited does not change as it should.
            _ => {
                let sides = own.terms().into_iter().zip(near.terms());
                let (printed, meant) = { sides }.find(|(printed, meant)| printed != meant)?;
                let same = Formula::equal(meant.clone(), printed.clone());
                let Decision::Refuted(refuted) = decide(&positive, &same)? else {
                    return None;
                };
                refuted_of(goal, &same, &positive, refuted)
            }
        };
        found.mended = Some(mended.into());
        found.constant = constants.into_iter().collect();
        Some(found)
    }
}

impl Course {
    /// Whether symbols are of what changes and of what it changes with.
    fn is_among(&self, names: &Set<Symbol>) -> bool {
        names.contains(&self.of) && names.contains(&self.variable)
    }
}

/// A relation between two states as one of any state and the first: `\ln\frac{K_2}{K_1} = c (\frac1{T_1} - \frac1{T_2})` of the law of `K` and
/// `T`, `\ln\frac{K}{K_1} = c (\frac1{T_1} - \frac1T)`.
fn between_states<'g>(
    goal: &Goal,
    names: &Set<Symbol>,
    course: Course,
) -> Option<(Cow<'g, Goal>, Course)> {
    let Course { of, variable, .. } = &course;
    // By the state that their subscripts name.
    let states = |own: &Symbol| -> Vec<(&str, &Symbol)> {
        let parts = names.iter().filter_map(|name| {
            let (stem, state) = split_subscript(name.name())?;
            (stem == own.name()).then_some((state, name))
        });
        let mut states: Vec<(&str, &Symbol)> = parts.collect();
        states.sort_unstable();
        states
    };
    let (own, at) = (states(of), states(variable));
    let ([(start, own_first), (last, _)], [(other_start, at_first), (other_last, _)]) =
        (&own[..], &at[..])
    else {
        return None;
    };
    if (start, last) != (other_start, other_last) || names.contains(of) || names.contains(variable)
    {
        return None;
    }
    let first = [*own_first, *at_first].map(Symbol::clone);
    let of_state = |own: &Symbol| match split_subscript(own.name()) {
        Some((stem, state)) if state == *last => {
            let mut both = [of, variable].into_iter();
            both.find(|own| own.name() == stem)
        }
        _ => None,
    };
    let rename = |own: &Symbol| of_state(own).unwrap_or(own).clone();
    let formula = goal.formula.map_terms(|term| renamed(term, &rename));
    let goal = Goal {
        formula,
        ..goal.clone()
    };
    let first = Some(first);
    Some((Cow::Owned(goal), Course { first, ..course }))
}

/// The law of the first order that a premise is, of what, and of what that changes with.
fn course_of(own: &Assumed) -> Option<Course> {
    own.formula.as_equation()?;
    let mut slopes = Set::new();
    for term in own.formula.terms() {
        term.collect_slopes(&mut slopes);
    }
    let mut slopes = slopes.into_iter();
    let (of, variable) = slopes.next()?;
    let is_law = slopes.next().is_none()
        && of != variable
        && matches!(own.source, Source::Equation(_))
        && order(&own.formula) == 1
        && !own.formula.speaks_of_values()
        && (own.standing == Standing::Identity || speaks_of_course(&own.formula, &of, &variable));
    is_law.then(|| Course {
        law: Assumed {
            standing: Standing::Identity,
            ..own.clone()
        },
        of,
        variable,
        first: None,
    })
}
