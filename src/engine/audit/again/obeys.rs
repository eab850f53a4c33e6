//! Solutions that do not obey their law: "The solution is $N = N_0 e^{\lambda t}$" after `\frac{dN}{dt} = -\lambda N`.
//!
//! What a law of change leaves open is fixed by constants that a solution brings along. Put into the law, a solution must obey it for some of
//! them; one that obeys it for none, unless something is nought, is none.

use crate::algebra::{Expr, Formula, Function, Symbol, effort};
use crate::derivation::{Assumed, Goal, Source};
use crate::document::Extent;
use crate::kernel::Standing;
use crate::search::Decision;

use super::super::judge::{Found, Judge, taken};
use super::super::{Judged, Outcome};
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

impl Judge<'_> {
    /// What to say of a solution that obeys the law that it is said to solve for no values of its constants but nought.
    pub(in crate::audit) fn as_no_solution(
        &self,
        goal: &Goal,
        premises: &[usize],
    ) -> Option<Found> {
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
        let mut symbols = goal.formula.free_symbols();
        symbols.extend(law.formula.free_symbols());
        symbols.retain(|own| *own != of && *own != variable && !own.is_unit());
        let moves = |own: &Symbol| self.auditor.changes(self.at, own, &variable);
        if symbols.iter().any(moves) {
            return None;
        }
        let is_of_law = |own: &Symbol| *own == variable || law.formula.names().contains(own);
        let solution = Assumed {
            standing: Standing::Identity,
            ..taken(&goal.formula)
        };
        // What the text says besides may be of a case in which it is one, and of no moment: "**Critical damping** ($\gamma = \omega_0$)".
        let is_of_law = &is_of_law;
        let stands = |own: &Symbol| *own != variable && *own != of && is_of_law(own);
        let said = self.derivation.written_since(self.at).into_iter();
        // "with $v(0) = 0$" is of one moment.
        let is_applied = |part: &Expr| matches!(part, Expr::Apply(..));
        let said = said.filter(|own| {
            own.names().iter().all(stands)
                && !own.terms().into_iter().any(|term| term.any(&is_applied))
        });
        let said = said.map(|own| Assumed {
            standing: Standing::Identity,
            ..taken(&own)
        });
        let supposed = self.usable.assumed.iter().filter(|own| {
            matches!(own.source, Source::Local(..)) && !own.formula.names().contains(&variable)
        });
        let said: Vec<Assumed> = said.chain(supposed.cloned()).collect();
        let positive = |own: &Symbol| taken(&Formula::positive(Expr::Symbol(own.clone())));
        let all = symbols.iter().chain([&variable]).map(positive);
        let all: Vec<Assumed> = [solution].into_iter().chain(said).chain(all).collect();
        let decide = |assumed: &[Assumed], formula: &Formula| {
            let mut claim = self.derivation.claim(self.at, assumed, formula);
            for own in &symbols {
                claim.domains.entry(own.clone()).or_default().constant = true;
            }
            Some(self.decide(&*self.pose_claim(claim).ok()?))
        };
        let begins_otherwise = || {
            let mut said = self.derivation.conditions_said(self.at);
            said.retain(|own| own.just_said);
            met(said, goal, &variable)
                .into_iter()
                .find_map(|(_, there)| {
                    let Decision::Refuted(refuted) = decide(&all[1..], &there)? else {
                        return None;
                    };
                    Some(Found::open(Judged {
                        goal: Goal {
                            formula: there,
                            ..goal.clone()
                        },
                        assumed: all[1..].to_vec(),
                        outcome: Outcome::Refuted(refuted.into()),
                    }))
                })
        };
        effort::within(MOST_WORK, || {
            let refuted = match decide(&all, &law.formula)? {
                Decision::Refuted(refuted) => refuted,
                // It obeys the law, and may have another value where the text tells one.
                Decision::Proven { .. } => return begins_otherwise(),
                Decision::Open(_) => return None,
            };
            // For some values of the constants that it brings along it may be one, whatever the law's own are.
            if !symbols.iter().all(is_of_law) {
                let set = refuted.witness().symbols.iter();
                let set = set.filter(|(own, _)| is_of_law(own)).map(|(own, value)| {
                    let value = Expr::Number(value.clone());
                    taken(&Formula::equal(Expr::Symbol(own.clone()), value))
                });
                let so = Assumed {
                    standing: Standing::AtPoint,
                    ..law.clone()
                };
                // It would have to be one at each moment, and so where no wave is nought.
                let mut waves = Vec::new();
                self::waves(right, &variable, &mut waves);
                let all = all.iter().cloned().chain(set).chain([so]).chain(waves);
                let all: Vec<Assumed> = all.collect();
                let nonsense = Formula::equal(Expr::integer(0), Expr::integer(1));
                let Decision::Proven { .. } = decide(&all, &nonsense)? else {
                    return None;
                };
            }
            let own = Goal {
                formula: (*law.formula).clone(),
                ..goal.clone()
            };
            let mut found = Found::open(Judged {
                goal: own,
                assumed: all.clone(),
                outcome: Outcome::Refuted(refuted.into()),
            });
            found.constant = symbols.iter().cloned().collect();
            Some(found)
        })
    }
}

/// That the sines and cosines of a term that move are positive.
fn waves(term: &Expr, variable: &Symbol, found: &mut Vec<Assumed>) {
    match term {
        Expr::Call(Function::Sin | Function::Cos, of) if of.mentions(variable) => {
            found.push(taken(&Formula::positive(term.clone())));
        }
        _ => (term.children()).for_each(|part| waves(part, variable, found)),
    }
}
