//! Solutions that do not obey their law: "The solution is $N = N_0 e^{\lambda t}$" after `\frac{dN}{dt} = -\lambda N`.
//!
//! What a law of change leaves open is fixed by constants that a solution brings along. Put into the law, a solution must obey it for some of
//! them; one that obeys it for none, unless something is nought, is none.

use crate::algebra::{Expr, Formula, Function, Symbol, effort};
use crate::derivation::{Assumed, Goal, Source};
use crate::document::Extent;
use crate::kernel::{Refuted, Standing};
use crate::search::Decision;
use crate::sorted::Set;

use super::super::judge::{Found, Judge, taken};
use super::super::{Judged, Outcome};
use super::conditions::collect_waves;
use super::solution::met;

/// What a solution comes after, where nothing else says that it is one.
const SOLVING: [&str; 16] = [
    "solve",
    "solved",
    "solves",
    "solving",
    "solution",
    "solutions",
    "integrate",
    "integrated",
    "integrates",
    "integrating",
    "integration",
    "separate",
    "separating",
    "separation",
    "exponentiate",
    "exponentiating",
];
/// With one of these it is the solution of something simpler than what the law says, or near one.
const OF_ANOTHER_LAW: [&str; 20] = [
    "without",
    "absence",
    "neglect",
    "neglecting",
    "neglected",
    "ignoring",
    "ignored",
    "vanishing",
    "small",
    "large",
    "weak",
    "strong",
    "slow",
    "early",
    "late",
    "short",
    "long",
    "approximate",
    "approximately",
    "undamped",
];
/// So much work is done, as [`effort`] counts it.
const MOST_WORK: u64 = 2_000_000;

/// What is said to be a solution, and of what.
struct Solution<'a> {
    law: &'a Assumed,
    variable: Symbol,
    /// What does not move in either.
    constants: Set<Symbol>,
    /// The solution, that all is positive, and what the text says besides.
    assumed: Vec<Assumed>,
}

impl Solution<'_> {
    fn is_of_law(&self, own: &Symbol) -> bool {
        *own == self.variable || self.law.formula.names().contains(own)
    }

    /// The same without the solution.
    fn circumstances(&self) -> &[Assumed] {
        &self.assumed[1..]
    }
}

impl Judge<'_> {
    /// What to say of a solution that obeys the law that it is said to solve for no values of its constants but nought.
    pub(in crate::audit) fn as_no_solution(
        &self,
        goal: &Goal,
        premises: &[usize],
    ) -> Option<Found> {
        let own = self.said_to_solve(goal, premises)?;
        effort::within(MOST_WORK, || {
            let refuted = match self.decide_of(&own, &own.assumed, &own.law.formula)? {
                Decision::Refuted(refuted) => refuted,
                // It obeys the law, and may have another value where the text tells one.
                Decision::Proven { .. } => return self.begins_otherwise(goal, &own),
                Decision::Open(_) => return None,
            };
            // For some values of the constants that it brings along it may be one, whatever the law's own are.
            if !own.constants.iter().all(|symbol| own.is_of_law(symbol))
                && !self.is_one_for_none(goal, &own, &refuted)
            {
                return None;
            }
            let mut found = refuted_of(goal, &own.law.formula, &own.assumed, refuted);
            found.constant = own.constants.iter().cloned().collect();
            Some(found)
        })
    }

    /// The law that a goal is said to solve; nothing where words say that it is none of that law, or something else moves.
    fn said_to_solve(&self, goal: &Goal, premises: &[usize]) -> Option<Solution<'_>> {
        let (left, right) = goal.formula.as_equation()?;
        if goal.questioned || !goal.suppositions.is_empty() {
            return None;
        }
        let own = &self.derivation.equations[self.at];
        if !own.drawn && !self.says(&SOLVING) {
            return None;
        }
        // "Without friction the solution is" is of another law.
        if own.extent != Extent::Throughout || self.says(&OF_ANOTHER_LAW) {
            return None;
        }
        let near = &self.others(premises)[0];
        let laws = || self.usable.assumed.iter().chain(near);
        let mut moved = Formula::differentiated_in(laws().map(|own| &*own.formula));
        moved.retain(|own| left.mentions(own) && !right.mentions(own));
        let of = moved.pop_first().filter(|_| moved.is_empty())?;
        let is_law = |own: &&Assumed| {
            own.standing == Standing::Identity
                && matches!(own.source, Source::Equation(_))
                && own.formula.as_equation().is_some()
                && Formula::differentiated_in([&*own.formula].into_iter()).contains(&of)
        };
        let variable = self.variable()?;
        if !right.mentions(&variable) {
            return None;
        }
        let law = laws().find(is_law)?;
        // Nothing else moves, and nothing else is known of what stands in it.
        let mut constants = goal.formula.free_symbols();
        constants.extend(law.formula.free_symbols());
        constants.retain(|own| *own != of && *own != variable && !own.is_unit());
        let moves = |own: &Symbol| self.auditor.changes(self.at, own, &variable);
        if constants.iter().any(moves) {
            return None;
        }
        let throughout = |formula: &Formula| Assumed {
            standing: Standing::Identity,
            ..taken(formula)
        };
        let positive = constants.iter().chain([&variable]);
        let positive = positive.map(|own| taken(&Formula::positive(Expr::Symbol(own.clone()))));
        let assumed = [throughout(&goal.formula)].into_iter().chain(positive);
        let mut own = Solution {
            law,
            assumed: assumed.collect(),
            variable,
            constants,
        };
        // What the text says besides may be of a case in which it is one, and of no moment: "**Critical damping** ($\gamma = \omega_0$)".
        let stands =
            |symbol: &Symbol| *symbol != own.variable && *symbol != of && own.is_of_law(symbol);
        // "with $v(0) = 0$" is of one moment.
        let is_applied = |part: &Expr| matches!(part, Expr::Apply(..));
        let mut said = self.derivation.written_since(self.at);
        said.retain(|said| {
            said.names().iter().all(stands)
                && !said.terms().into_iter().any(|term| term.any(&is_applied))
        });
        let supposed = self.usable.assumed.iter().filter(|said| {
            matches!(said.source, Source::Local(..))
                && !said.formula.names().contains(&own.variable)
        });
        let said = said.iter().map(throughout).chain(supposed.cloned());
        let said: Vec<Assumed> = said.collect();
        own.assumed.extend(said);
        Some(own)
    }

    /// What is decided where all but the variable and what depends on it is constant.
    fn decide_of(
        &self,
        own: &Solution,
        assumed: &[Assumed],
        formula: &Formula,
    ) -> Option<Decision> {
        let mut claim = self.derivation.claim(self.at, assumed, formula);
        for own in &own.constants {
            claim.domains.entry(own.clone()).or_default().constant = true;
        }
        Some(self.decide(&*self.pose_claim(claim).ok()?))
    }

    /// What to say of a solution that has another value than the text tells just before it.
    fn begins_otherwise(&self, goal: &Goal, own: &Solution) -> Option<Found> {
        let mut said = self.derivation.conditions_said(self.at);
        said.retain(|own| own.just_said);
        let mut met = met(said, goal, &own.variable).into_iter();
        met.find_map(
            |(_, there)| match self.decide_of(own, own.circumstances(), &there)? {
                Decision::Refuted(refuted) => {
                    Some(refuted_of(goal, &there, own.circumstances(), refuted))
                }
                _ => None,
            },
        )
    }

    /// Whether a solution obeys its law for no values of the constants that it brings along, where those of the law are as a point says.
    fn is_one_for_none(&self, goal: &Goal, own: &Solution, point: &Refuted) -> bool {
        let set = point.witness().symbols.iter();
        let set = set.filter(|(symbol, _)| own.is_of_law(symbol));
        let set = set.map(|(symbol, value)| {
            let value = Expr::Number(value.clone());
            taken(&Formula::equal(Expr::Symbol(symbol.clone()), value))
        });
        let so = Assumed {
            standing: Standing::AtPoint,
            ..own.law.clone()
        };
        // It would have to be one at each moment, and so where no wave is nought.
        let mut waves = Vec::new();
        if let Some((_, right)) = goal.formula.as_equation() {
            collect_waves(right, &mut waves);
        }
        let is_tangent = |wave: &Expr| matches!(wave, Expr::Call(Function::Tan, _));
        waves.retain(|wave| wave.mentions(&own.variable) && !is_tangent(wave));
        let waves = waves
            .into_iter()
            .map(|wave| taken(&Formula::positive(wave)));
        let all = own
            .assumed
            .iter()
            .cloned()
            .chain(set)
            .chain([so])
            .chain(waves);
        let all: Vec<Assumed> = all.collect();
        let nonsense = Formula::equal(Expr::integer(0), Expr::integer(1));
        matches!(
            self.decide_of(own, &all, &nonsense),
            Some(Decision::Proven { .. })
        )
    }
}

/// That something else than a goal is refuted, and by that the goal.
fn refuted_of(goal: &Goal, formula: &Formula, assumed: &[Assumed], refuted: Refuted) -> Found {
    Found::open(Judged {
        goal: Goal {
            formula: formula.clone(),
            ..goal.clone()
        },
        assumed: assumed.to_vec(),
        outcome: Outcome::Refuted(refuted.into()),
    })
}
