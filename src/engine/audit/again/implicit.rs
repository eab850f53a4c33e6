//! Integrals of a law that are not solved for the quantity: "Separating variables and integrating, $$\ln\frac{v}{v_0} = -b t$$" after
//! `\frac{dv}{dt} = -b v`.
//!
//! Where it begins brings a symbol of its own along, so that it would say what that is. But along the law both sides change alike, wherever
//! that is: it is refuted where they do not, and would with one small edit.

use crate::algebra::{Expr, Formula, Symbol, effort};
use crate::derivation::{Assumed, Goal, Source, values_at};
use crate::kernel::Standing;
use crate::search::{self, Decision, Effort, InChain, Mended, Slips};
use crate::sorted::Set;

use super::super::judge::{Found, Judge, taken};
use super::obeys::{fixed_by, meant, order, refuted_of, speaks_of_course};
use super::solution::value_of_its_own;

/// So much work is done for that, as [`effort`] counts it.
const MOST_WORK: u64 = 1_000_000;
/// So many edits are tried.
const MOST_EDITS: usize = 60;

/// A law of the first order, and how it goes.
struct Course {
    law: Assumed,
    /// What changes.
    of: Symbol,
    /// With what it changes.
    variable: Symbol,
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
            && self.is_led_to_as_solution()
            && !self.is_of_another_law();
        if !is_integral {
            return None;
        }
        let names = goal.formula.names();
        let near = &self.others(premises)[0];
        let laws = || self.usable.assumed.iter().chain(near);
        let course = laws().find_map(|own| course_of(own, &names))?;
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
        let Course { law, of, variable } = course;
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
        let decision = decide(&assumed, &own)?;
        if matches!(decision, Decision::Proven { .. }) {
            return None;
        }
        let bare = claim(&[], &goal.formula);
        let slips = Slips::of(&bare, &InChain::default(), None, values_at).and_rarer();
        let (mended, near) = slips.take(MOST_EDITS).find_map(|edit| {
            let near = changes_alike(&edit.formula)?;
            let derived = search::prove_unconditionally(claim(&assumed, &near), Effort::Full)?;
            Some((Mended::of(derived.proven, edit.change), near))
        })?;
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

/// The law of the first order that a premise is of something that some symbols name, and of what that changes with.
fn course_of(own: &Assumed, names: &Set<Symbol>) -> Option<Course> {
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
    (is_law && names.contains(&of) && names.contains(&variable)).then(|| Course {
        law: Assumed {
            standing: Standing::Identity,
            ..own.clone()
        },
        of,
        variable,
    })
}
