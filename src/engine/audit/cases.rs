//! Premises that say something under conditions: `f = a` where `x < 0`.
//!
//! A case is a premise where its conditions are known to hold, and no matter where one of them is known not to. Where
//! neither is known, what is proved without it stands, and what is refuted without it may follow with it all the same.

use crate::algebra::Formula;
use crate::derivation::{Assumed, Goal, Source};
use crate::search::{self, Effort};

use super::Outcome;
use super::identity::spoken_of;
use super::judge::{Found, Judge, step};

impl Judge<'_> {
    /// Adds the cases that apply under what is assumed. An equation with a case that may bear on the goal and of which
    /// it is not known whether it applies.
    ///
    /// Conditions count as known from the hypotheses in effect and from what the statement itself supposes: both are
    /// carried along with what is concluded. What other premises say is not asked.
    pub(super) fn cases(&self, goal: &Goal, assumed: &mut Vec<Assumed>) -> Option<usize> {
        let mut left_out = Vec::new();
        let mut given = self.derivation.locals(self.at);
        given.extend(goal.suppositions.iter().map(step));
        let known = |formula: &Formula| {
            given.iter().any(|own| *own.formula == *formula) || {
                let claim = self.derivation.claim(self.at, &given, formula);
                search::prove_unconditionally(claim, Effort::Full).is_some()
            }
        };
        for (conditions, case) in &self.usable.cases {
            if conditions.iter().all(known) {
                assumed.push(case.clone());
            } else if !conditions
                .iter()
                .filter_map(|own| own.denied())
                .any(|d| known(&d))
            {
                left_out.push((conditions, case));
            }
        }
        // What speaks of other symbols altogether is no matter.
        let mut spoken = spoken_of(&goal.formula);
        spoken.extend(assumed.iter().flat_map(|own| spoken_of(&own.formula)));
        let linked = left_out.iter().find(|(conditions, case)| {
            let formulas = conditions.iter().chain([&*case.formula]);
            let mut symbols = formulas.flat_map(spoken_of);
            symbols.any(|symbol| spoken.contains(&symbol))
        });
        match linked?.1.source {
            Source::Equation(premise) => Some(premise),
            _ => None,
        }
    }

    /// What is not proved without a case is not refuted either.
    pub(super) fn without_case(&self, mut found: Found, premise: usize) -> Found {
        if found.judged.outcome.is_refuted() {
            let premise = self.derivation.equations[premise].reference();
            found = Found::open(found.judged);
            found.judged.outcome = Outcome::open(format!(
                "{premise} is said by cases, and which of them it is here is not known: suppose one, or go through them"
            ));
        }
        found
    }
}
