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
    /// A goal that premises refute, or what follows from them with one small edit of its right side, such an edit as is said. Nothing of one
    /// that follows, or that no edit makes follow.
    pub(super) fn one_slip_away(
        &self,
        goal: &Goal,
        premises: &[Assumed],
        is_slip: impl Fn(&Change) -> bool,
    ) -> Option<Found> {
        let claim = |formula: &Formula| self.derivation.claim(self.at, premises, formula);
        let bare = claim(&goal.formula);
        let posed = self.pose_claim(bare.clone()).ok()?;
        let refuted = match self.decide(&posed) {
            Decision::Refuted(refuted) => Some(refuted),
            Decision::Open(_) => None,
            Decision::Proven { .. } => return None,
        };
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
}
