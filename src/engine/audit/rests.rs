//! What a step rests on: which of it fails, and which is not proved.

use crate::sorted::Set;

use super::{Auditor, Note, Verdict};

/// So many of the equations that a step comes from and that fail, or are not proved, are named: the nearest. All of them, for each
/// step of a document where thousands follow from one another, would cost the square of their number.
const MOST_ANCESTORS: usize = 64;

impl Auditor<'_> {
    /// The failing equations among premises, and those that these rest on.
    pub(super) fn failing(&self, at: usize, premises: &Set<usize>) -> Vec<usize> {
        let mut failing = Set::new();
        for &premise in premises {
            for entry in self.entries_of(at, premise) {
                if entry.is_mistake() {
                    failing.insert(premise);
                }
                failing.extend(&entry.rests_on);
            }
        }
        nearest(failing)
    }

    /// The premises that are not proved themselves, or only under a condition that nothing states, and those
    /// that these rest on.
    pub(super) fn unproved(&self, at: usize, premises: &Set<usize>) -> Vec<usize> {
        let mut open = Set::new();
        for &premise in premises {
            for entry in self
                .entries_of(at, premise)
                .filter(|own| !own.names_a_value())
            {
                let conditional = entry
                    .notes
                    .iter()
                    .any(|n| matches!(n, Note::UnstatedCondition(_)));
                if entry.verdict == Verdict::Undecided || conditional {
                    open.insert(premise);
                }
                for note in &entry.notes {
                    if let Note::RestsOnUnproved(others) = note {
                        open.extend(others);
                    }
                }
            }
        }
        nearest(open)
    }
}

/// The last ones, in order.
fn nearest(ancestors: Set<usize>) -> Vec<usize> {
    let far = ancestors.len().saturating_sub(MOST_ANCESTORS);
    ancestors.into_iter().skip(far).collect()
}
