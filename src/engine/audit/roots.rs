//! What a step comes from in the end. A premise that is proved says nothing that its own premises do not; with these alone a
//! counterexample may be found where all together keep the search from one.

use super::judge::{Found, Judge};
use super::premise::{Usable, usable};
use super::{Note, Verdict};
use crate::algebra::Formula;
use crate::derivation::Goal;
use crate::sorted::Set;

/// More premises than this are not traced back.
const MOST_ROOTS: usize = 12;

impl Judge<'_> {
    /// A counterexample to an open goal at which all holds that its premises come from, and so these too.
    pub(super) fn refuted_by_roots(
        &self,
        goal: &Goal,
        steps: &[(usize, Formula)],
        premises: &[usize],
    ) -> Option<Found> {
        let roots = self.roots(premises)?;
        let offer = |premise| self.auditor.offer(self.at, premise);
        let usable: Usable = usable(self.derivation, offer, self.at, &roots);
        let judge = Judge::new(self.auditor, self.at, &usable);
        let found = judge.judged_from(goal, steps, &roots);
        found.judged.outcome.is_refuted().then_some(found)
    }

    /// The premises with each that is proved replaced by what it was proved from; `None` where none is.
    fn roots(&self, premises: &[usize]) -> Option<Vec<usize>> {
        let mut roots = Set::new();
        let mut open: Vec<usize> = premises.to_vec();
        let mut seen: Set<usize> = Set::new();
        while let Some(at) = open.pop() {
            if at >= self.at || !seen.insert(at) {
                continue;
            }
            let proved = self.auditor.entries_of(self.at, at).all(|entry| {
                let doubtful =
                    |n: &Note| matches!(n, Note::UnstatedCondition(_) | Note::TakenAsConstant(_));
                entry.verdict == Verdict::Holds && !entry.notes.iter().any(doubtful)
            });
            match proved {
                true => {
                    let entries = self.auditor.entries_of(self.at, at);
                    open.extend(entries.flat_map(|entry| entry.premises.iter().copied()));
                }
                false => {
                    roots.insert(at);
                }
            }
        }
        let replaced = premises.iter().any(|premise| !roots.contains(premise));
        (replaced && roots.len() <= MOST_ROOTS).then(|| roots.into_iter().collect())
    }
}
