use crate::algebra::{Symbol, split_subscript};
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
                    && let Some(index) = index_that_runs(goal, assumed)
                {
                    found.leave_open(format!(
                        "elements of a sequence change with their index `{}`",
                        plain_symbol(&index)
                    ));
                }
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

/// What a goal speaks of, and is the index of elements beside each other too: `I_n I_{n-1} = \pi/2n`.
fn index_that_runs(goal: &Goal, assumed: &[Assumed]) -> Option<Symbol> {
    let mut names = goal.formula.names();
    names.extend(assumed.iter().flat_map(|own| own.formula.names()));
    let is_counted_by = |own: &Symbol, index: &Symbol| {
        let below = split_subscript(own.name()).map(|(_, below)| below);
        below.is_some_and(|below| {
            let signs = below.split_once(['+', '-']);
            signs.is_some_and(|(before, after)| before == index.name() || after == index.name())
        })
    };
    let spoken_of = goal.formula.free_symbols().into_iter();
    let mut indices = spoken_of.filter(|index| names.iter().any(|own| is_counted_by(own, index)));
    indices.next()
}

/// What a proof was left with.
fn kept(assumed: &[Assumed], claim: &Claim, proven: &Scales) -> Vec<Assumed> {
    let kept = search::kept_hypotheses(claim, proven);
    kept.into_iter().map(|at| assumed[at].clone()).collect()
}
