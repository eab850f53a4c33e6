//! Formulas in the text with a stroke that may be meant otherwise: "with the Compton wavelength $\lambda_C = h/mc$".
//!
//! They are read as displays are, `h/mc` as `h/(mc)`. What follows where another reading is taken is not refuted by this one.

use crate::algebra::Formula;
use crate::derivation::{Assumed, Goal, Source, formulas};
use crate::notation::read_formulas;
use crate::search::Decision;

use super::super::judge::{Found, Judge};

impl Judge<'_> {
    /// Leaves open, and tells why, what follows where a formula in the text is read in its other way.
    pub(in crate::audit) fn heed_other_readings(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        found: &mut Found,
    ) {
        if !found.judged.outcome.is_refuted() {
            return;
        }
        for (at, own) in assumed.iter().enumerate() {
            let Some((told, others)) = self.read_otherwise(own) else {
                continue;
            };
            for other in others {
                let mut all = assumed.to_vec();
                all[at].formula = other.into();
                let decided = self.decide_from(&all, &goal.formula);
                if matches!(decided, Some(Decision::Proven { .. }))
                    && !self.is_contradictory(&all, goal)
                {
                    return found.leave_open(format!(
                        "it follows where the stroke in `{told}` is read the other way"
                    ));
                }
            }
        }
    }

    /// What a hypothesis that the text states says where it is read in its other ways, after its text.
    fn read_otherwise(&self, own: &Assumed) -> Option<(&str, Vec<Formula>)> {
        let Source::Local(page, local) = own.source else {
            return None;
        };
        let document = &self.derivation.pages[page].document;
        let span = self.derivation.local(page, local).span;
        let told = document.text(span);
        if !told.contains('/') {
            return None;
        }
        let read = read_formulas(&document.source, span).ok()?;
        let is_own = |said: &Formula| *said == *own.formula;
        let meant = read.iter().filter(|said| formulas(said).iter().any(is_own));
        let others = meant.flat_map(|said| &said.others);
        let others = others.flat_map(|other| formulas(&other.statement));
        Some((told, others.collect()))
    }
}
