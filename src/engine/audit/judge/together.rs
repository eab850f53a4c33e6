//! Whether premises can be true together.

use crate::derivation::{Assumed, Goal};
use crate::kernel::Obligation;
use crate::search::{self, Consistency};

use super::Judge;

impl Judge<'_> {
    /// Whether hypotheses are known not to be true together.
    pub(in crate::audit) fn is_contradictory(&self, assumed: &[Assumed], goal: &Goal) -> bool {
        if assumed.is_empty() {
            return false;
        }
        let claim = self.derivation.claim(self.at, assumed, &goal.formula);
        // The hints are given back before a new one is remembered.
        let consistency = search::consistency(&claim, &self.auditor.hints());
        self.cannot_be(consistency)
    }

    /// The same of the hypotheses of a claim that was read before.
    pub(in crate::audit) fn contradicts_itself(&self, posed: &Obligation) -> bool {
        if posed.claim().hypotheses.is_empty() {
            return false;
        }
        let consistency = search::consistency_posed(posed, &self.auditor.hints());
        self.cannot_be(consistency)
    }

    /// Neighbouring steps share their premises, and so the points at which these hold.
    fn cannot_be(&self, consistency: Consistency) -> bool {
        match consistency {
            Consistency::Model(model) => {
                self.auditor.remember(model.point());
                false
            }
            Consistency::Contradictory(_) => true,
            Consistency::Unknown => false,
        }
    }
}
