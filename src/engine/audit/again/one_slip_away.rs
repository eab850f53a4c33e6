//! What is one slip of the pen away from what follows from some premises.

use crate::algebra::Formula;
use crate::derivation::{Assumed, Goal, values_at};
use crate::kernel::Refuted;
use crate::search::{self, Change, Decision, Edit, Effort, InChain, Mended, Slips};

use super::super::judge::{Found, Judge, positive};
use super::super::slip::between;
use super::obeys::refuted_of;

/// So many edits are tried.
const MOST_EDITS: usize = 60;
/// And so many in earnest.
const LIKELIEST: usize = 8;

impl Judge<'_> {
    /// A goal that is one small edit of its right side, such an edit as is said, away from what follows from premises, by what was decided of
    /// it from these. Nothing of one that follows, or that no edit makes follow.
    pub(super) fn one_slip_away(
        &self,
        goal: &Goal,
        premises: &[Assumed],
        decision: Decision,
        is_slip: impl Fn(&Change) -> bool,
    ) -> Option<Found> {
        let refuted = match decision {
            Decision::Refuted(refuted) => Some(refuted),
            Decision::Open(_) => None,
            Decision::Proven { .. } => return None,
        };
        let claim = |formula: &Formula| self.derivation.claim(self.at, premises, formula);
        let bare = claim(&goal.formula);
        let witness = refuted.as_ref().map(Refuted::witness);
        let slips = Slips::of(&bare, &InChain::default(), witness, values_at).and_rarer();
        let slips = slips.filter(|edit: &Edit| edit.left_kept && is_slip(&edit.change));
        let mut slips = slips.take(MOST_EDITS).enumerate();
        let (meant, mended) = slips.find_map(|(tried, edit)| {
            let posed = search::pose(claim(&edit.formula)).ok()?;
            // Without a point at which most of them are false there are many.
            let derived = match refuted.is_some() || tried < LIKELIEST {
                true => search::prove_by_degrees(&posed)?,
                false => search::prove_posed(&posed, Effort::Light)?,
            };
            // From what contradicts itself anything would follow.
            if search::rests_on_contradiction(&derived.proven) {
                return None;
            }
            Some((edit.formula, Mended::of(derived.proven, edit.change)))
        })?;
        // What follows may be rational nowhere; both that and what is printed cannot be so.
        let mut found = match refuted {
            Some(refuted) => refuted_of(goal, &goal.formula, premises, refuted),
            None => {
                let between = between(&meant, &goal.formula)?;
                let mut symbols = between.free_symbols();
                symbols.retain(|own| !own.is_unit());
                let all: Vec<Assumed> = symbols.iter().map(positive).collect();
                let Decision::Refuted(refuted) = self.decide_from(&all, &between)? else {
                    return None;
                };
                refuted_of(goal, &between, &all, refuted)
            }
        };
        found.mended = Some(mended.into());
        Some(found)
    }

    /// The same of the first of several that premises may be meant, unless it follows from one of them.
    pub(super) fn one_slip_away_from_each(
        &self,
        goal: &Goal,
        all: &[Vec<Assumed>],
        is_slip: impl Fn(&Change) -> bool,
    ) -> Option<Found> {
        let decided = |own: &Vec<Assumed>| self.decide_from(own, &goal.formula);
        let decisions: Vec<Option<Decision>> = all.iter().map(decided).collect();
        let follows = |own: &Option<Decision>| matches!(own, Some(Decision::Proven { .. }));
        if decisions.iter().any(follows) {
            return None;
        }
        let mut decided = all.iter().zip(decisions);
        decided.find_map(|(own, decision)| self.one_slip_away(goal, own, decision?, &is_slip))
    }
}
