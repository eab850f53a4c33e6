//! Integrals of a law that are not solved for the quantity: "Separating variables and integrating, $$\ln\frac{v}{v_0} = -b t$$" after
//! `\frac{dv}{dt} = -b v`.
//!
//! Where it begins brings a symbol of its own along, so that it would say what that is. But along the law both sides change alike, wherever
//! that is: it is refuted where they do not, and would with one small edit.

use crate::algebra::{Expr, Formula, Symbol, effort};
use crate::derivation::{Assumed, Goal, Source, renamed, values_at};
use crate::kernel::Standing;
use crate::search::{self, Decision, Effort, InChain, Mended, Slips};
use crate::sorted::Set;

use super::super::instances::states;
use super::super::judge::{Found, Judge, positive, taken};
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
        let courses = || laws().filter_map(course_of);
        let is_of_goal = |own: &Course| names.contains(&own.of) && names.contains(&own.variable);
        let of_states = || courses().find_map(|own| between_states(goal, &names, own));
        let (goal, course) = match courses().find(is_of_goal) {
            Some(course) => (goal.clone(), course),
            None => of_states()?,
        };
        // What is solved for the quantity is looked at as a solution.
        let is_solved = |side: &&Expr| matches!(side, Expr::Symbol(own) if *own == course.of);
        if goal.formula.terms().iter().any(is_solved) {
            return None;
        }
        effort::within(MOST_WORK, || self.held_along(&goal, &course, laws()))
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
        // What is so along the law may still begin wrong.
        let begun = match decision {
            Decision::Proven { .. } => match decide(&positive, &in_first(&goal.formula)?)? {
                Decision::Refuted(refuted) => Some(refuted),
                _ => return None,
            },
            _ => None,
        };
        let bare = claim(&[], &goal.formula);
        let slips = Slips::of(&bare, &InChain::default(), None, values_at).and_rarer();
        let shown = |assumed: &[Assumed], formula: &Formula| {
            search::prove_unconditionally(claim(assumed, formula), Effort::Full)
        };
        let (mended, near) = slips.take(MOST_EDITS).find_map(|edit| {
            let near = changes_alike(&edit.formula)?;
            let derived = shown(&assumed, &near)?;
            if let Some(begins) = in_first(&edit.formula) {
                shown(&positive, &begins)?;
            }
            Some((Mended::of(derived.proven, edit.change), near))
        })?;
        let mut found = match (begun, decision) {
            (Some(refuted), _) => refuted_of(goal, &in_first(&goal.formula)?, &positive, refuted),
            (None, Decision::Refuted(refuted)) => refuted_of(goal, &own, &assumed, refuted),
            // Where no point of the law is found, the side that was edited does not change as it should.
            (None, _) => {
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

/// A relation between two states as one of any state and the first: `\ln\frac{K_2}{K_1} = c (\frac1{T_1} - \frac1{T_2})` of the law of `K` and
/// `T`, `\ln\frac{K}{K_1} = c (\frac1{T_1} - \frac1T)`.
fn between_states(goal: &Goal, names: &Set<Symbol>, course: Course) -> Option<(Goal, Course)> {
    let (of, variable) = (&course.of, &course.variable);
    if names.contains(of) || names.contains(variable) {
        return None;
    }
    let (of_both, at_both) = (states(of, names), states(variable, names));
    let ([(start, of_first), (last, of_last)], [(other_start, at_first), (other_last, at_last)]) =
        (&of_both[..], &at_both[..])
    else {
        return None;
    };
    if (start, last) != (other_start, other_last) {
        return None;
    }
    let rename = |own: &Symbol| match own {
        own if own == *of_last => of.clone(),
        own if own == *at_last => variable.clone(),
        own => own.clone(),
    };
    let goal = Goal {
        formula: goal.formula.map_terms(|term| renamed(term, &rename)),
        ..goal.clone()
    };
    let first = Some([(*of_first).clone(), (*at_first).clone()]);
    Some((goal, Course { first, ..course }))
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
