use crate::algebra::Symbol;
use crate::derivation::{Assumed, Goal};
use crate::kernel::{Claim, Scales};
use crate::notation::plain_symbol;
use crate::search::{self, ScalingDecision};

use super::Outcome;
use super::judge::{CONTRADICTORY, Found, Judge, sources};

/// How many uncited hypotheses are added to those that are cited.
const NEARBY: usize = 8;

impl Judge<'_> {
    /// Judges a scaling relation from its premises, and from what stands before where it does not follow.
    pub(super) fn scaling(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        premises: &[usize],
        found: &mut Found,
    ) {
        let claim = self.derivation.claim(self.at, assumed, &goal.formula);
        match search::decide_scaling(&claim) {
            ScalingDecision::Proven(proven) => {
                let kept = kept(assumed, &claim, &proven);
                if !kept.is_empty()
                    && !search::is_plainly_possible(&claim)
                    && self.is_contradictory(assumed, goal)
                {
                    found.contradictory = sources(assumed);
                    found.judged.outcome = Outcome::open(CONTRADICTORY);
                    return;
                }
                found.judged.assumed = kept;
                found.judged.outcome = Outcome::Scales(proven);
            }
            ScalingDecision::Refuted { refuted, repair } => {
                found.judged.outcome = Outcome::ScalesNot(refuted, repair);
                self.scaling_from_elsewhere(goal, assumed, premises, found);
                // What nothing speaks of may scale as it likes.
                let is_silent =
                    |own: &Symbol| !assumed.iter().any(|a| a.formula.names().contains(own));
                if matches!(found.judged.outcome, Outcome::ScalesNot(..))
                    && !self.is_directed()
                    && let Some(silent) = goal.formula.names().iter().find(|own| is_silent(own))
                {
                    found.leave_open(format!(
                        "nothing that it is drawn from speaks of `{}`",
                        plain_symbol(silent)
                    ));
                }
            }
            ScalingDecision::Open(stop) => {
                let hopeless = stop.hopeless;
                found.judged.outcome = Outcome::Open(stop);
                if !hopeless {
                    self.scaling_from_elsewhere(goal, assumed, premises, found);
                }
            }
        }
    }

    fn scaling_from_elsewhere(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        premises: &[usize],
        found: &mut Found,
    ) {
        for others in self.others(premises) {
            let near = others.iter().take(NEARBY);
            let all: Vec<Assumed> = assumed.iter().chain(near).cloned().collect();
            if all.len() == assumed.len() {
                continue;
            }
            let claim = self.derivation.claim(self.at, &all, &goal.formula);
            let Some(proven) = search::prove_scaling(&claim) else {
                continue;
            };
            let kept = kept(&all, &claim, &proven);
            if !search::is_plainly_possible(proven.claim()) && self.is_contradictory(&kept, goal) {
                continue;
            }
            found.instead = sources(&kept);
            found.judged.assumed = kept;
            found.judged.outcome = Outcome::Scales(proven.into());
            return;
        }
    }
}

/// What a proof was left with.
fn kept(assumed: &[Assumed], claim: &Claim, proven: &Scales) -> Vec<Assumed> {
    let kept = search::kept_hypotheses(claim, proven);
    kept.into_iter().map(|at| assumed[at].clone()).collect()
}
