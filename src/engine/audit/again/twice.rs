//! Solutions of laws for second derivatives, with what the text tells of the slope at a place: "Integrating twice with $w = 0$ and $w' = 0$ at
//! $x = 0$".
//!
//! What is printed is differentiated once. That must be the slope by the law and by its value at a place, and with it what is printed must be
//! the solution by its own.

use crate::algebra::{Atoms, Expr, Formula, Lowering, Symbol, expr_of_fraction};
use crate::derivation::{Assumed, ConditionSaid, Goal};
use crate::kernel::Standing;
use crate::sorted::Set;

use super::super::judge::{Found, Judge, step};
use super::solution::for_the_quantity;
use super::there::join;

impl Judge<'_> {
    /// What to say of a step that is the solution of a law for how a slope changes; nothing where it is not shown to be that.
    pub(super) fn as_integrated_twice(
        &self,
        goal: &Goal,
        premises: &[usize],
        found: &Found,
        said: &[ConditionSaid],
    ) -> Option<Found> {
        let (left @ Expr::Symbol(_), right) = goal.formula.as_equation()? else {
            return None;
        };
        // To look for the variable is to look through the page.
        if !said.iter().any(ConditionSaid::is_of_slope) {
            return None;
        }
        let variable = self.variable_of(left)?;
        let slope = left.clone().differentiated_by(&variable);
        said.iter().find(|own| own.subject(&variable) == slope)?;
        let slope = Goal {
            formula: Formula::equal(slope, differentiated(right, &variable)?),
            ..goal.clone()
        };
        let proven = |own: &Found| own.judged.outcome.is_proven();
        let first = self.as_solution_where(&slope, premises, found, said.to_vec());
        let first = first.filter(proven)?;
        let mut usable = self.usable.clone();
        usable.assumed.push(Assumed {
            standing: Standing::Identity,
            ..step(&slope.formula)
        });
        let with_slope = Judge::new(self.auditor, self.at, &usable);
        let second = with_slope.as_solution_where(goal, premises, found, said.to_vec());
        let mut second = second.filter(proven)?;
        // The slope was shown from what it was shown from.
        join(first.judged.assumed.into_iter(), &mut second.judged.assumed);
        join(first.instead.into_iter(), &mut second.instead);
        second.conditions.extend(first.conditions);
        second.constant.extend(first.constant);
        second.constant.sort();
        second.constant.dedup();
        Some(second)
    }

    /// What a solution comes to where the text tells its slope.
    pub(super) fn slopes_where_told(
        &self,
        said: &[ConditionSaid],
        goal: &Goal,
        variable: &Symbol,
    ) -> Vec<(ConditionSaid, Formula)> {
        let Some((left, right)) = goal.formula.as_equation() else {
            return Vec::new();
        };
        let (left, right) = &for_the_quantity(left, right);
        let slope = left.clone().differentiated_by(variable);
        let is_slope = |own: &&ConditionSaid| own.subject(variable) == slope;
        let is_here =
            |own: &&ConditionSaid| own.variable.as_ref().is_none_or(|own| own == variable);
        let mut said = said.iter().filter(is_slope).filter(is_here).peekable();
        if said.peek().is_none() {
            return Vec::new();
        }
        let Some(change) = differentiated(right, variable) else {
            return Vec::new();
        };
        let there = said.map(|own| {
            let change = change.substitute(variable, &own.place);
            (own.clone(), Formula::equal(change, own.value.clone()))
        });
        there.collect()
    }
}

/// A term differentiated by a variable, all else in it held constant; nothing where how something in it changes is not known.
fn differentiated(term: &Expr, variable: &Symbol) -> Option<Expr> {
    let mut constants: Set<Symbol> = term.free_symbols();
    constants.remove(variable);
    let mut atoms = Atoms::default();
    let mut lowering = Lowering {
        constants: &constants,
        ..Lowering::plain(&mut atoms)
    };
    let slope = lowering
        .lower(&term.clone().differentiated_by(variable))
        .ok()?;
    let slope = expr_of_fraction(&slope, &atoms);
    let is_open = |part: &Expr| matches!(part, Expr::Derivative { .. } | Expr::Partial { .. });
    (!slope.any(&is_open)).then_some(slope)
}
