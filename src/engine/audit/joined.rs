//! Premises that no author joins: equations of two cases that are not cited, and true together only where hardly anything is left.

use crate::algebra::{Expr, Formula};
use crate::derivation::{Assumed, Goal, Source};
use crate::search::{self, Decision};

use super::judge::{Found, Judge};
use super::{Judged, Outcome};

/// Why nothing is proved from what stands before and is not cited.
const TOGETHER: &str =
    "with what stands before and is not cited it is so only where something else vanishes";

impl Judge<'_> {
    /// The step judged from what it cites alone, where it follows only with premises that no author joins, and these can all be true only
    /// where something that it speaks of is 0: those of two cases, "at the top" and "on landing", are mostly true together where nothing
    /// is thrown.
    pub(super) fn alone_after_all(
        &self,
        goal: &Goal,
        steps: &[(usize, Formula)],
        premises: &[usize],
        found: &Found,
    ) -> Option<Found> {
        goal.formula.as_equation()?;
        let is_own = |own: &Assumed| match own.source {
            Source::Equation(at) => premises.contains(&at),
            _ => true,
        };
        let joined = &found.judged.assumed;
        let says_zero = || goal.formula.terms().contains(&&Expr::integer(0));
        if joined.iter().all(is_own) || says_zero() {
            return None;
        }
        // What is false may be what makes it vanish.
        if !self.failing(premises).is_empty() {
            return None;
        }
        let claim = self.derivation.claim(self.at, joined, &goal.formula);
        let constants = found.constant.iter().cloned();
        if !search::makes_goal_vanish(search::with_constants(claim, constants)) {
            return None;
        }
        let assumed = self.cited(goal, steps);
        let mut own = Found::open(Judged {
            goal: goal.clone(),
            assumed: assumed.clone(),
            outcome: Outcome::open(TOGETHER),
        });
        let claim = self.derivation.claim(self.at, &assumed, &goal.formula);
        let decision = search::pose(claim)
            .map(|posed| search::decide_within(&posed, &self.auditor.hints(), self.points()));
        if let Ok(Decision::Refuted(refuted)) = decision {
            own.judged.outcome = Outcome::Refuted(refuted.into());
            self.instead(goal, &assumed, premises, &mut own);
        }
        Some(own)
    }
}
