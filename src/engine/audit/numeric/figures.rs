//! Equations that are said to be numeric: what their figures are taken from.

use crate::derivation::{Assumed, Kind, Source, goals};
use crate::notation::Statement;

use super::super::entry::blank;
use super::super::premise::Usable;
use super::super::{Auditor, Entry, Note, Verdict, numeric};
use super::Weighed;

impl Auditor<'_> {
    /// Evaluates a numeric claim.
    pub(in crate::audit) fn numeric(
        &self,
        at: usize,
        statement: &Statement,
        usable: &Usable,
    ) -> Entry {
        let mut entry = blank(at, 0, 1, Kind::Derived, Verdict::Undecided);
        let assumed = self.sound_figures(at, usable);
        let numeric = numeric::evaluate(self.derivation, at, &goals(statement), &assumed);
        let used = numeric::used(&numeric);
        if *numeric.outcome() == Weighed::Contradicted {
            entry.notes.push(Note::NumericNotSupported);
        }
        let open = self.unproved(at, &used);
        if !open.is_empty() {
            entry.notes.push(Note::RestsOnUnproved(open));
        }
        entry.premises = used.into_iter().collect();
        entry.numeric = Some(numeric.into());
        entry
    }

    /// What figures may be taken from: what is wrong or not proved itself is not put in.
    pub(in crate::audit) fn sound_figures(&self, at: usize, usable: &Usable) -> Vec<Assumed> {
        let sound = |premise: usize| {
            // Of what figures support only what is exact is offered.
            let proved = |e: &Entry| match e.verdict {
                Verdict::Given | Verdict::Holds => true,
                Verdict::Undecided => e.numeric.is_some(),
                _ => false,
            };
            let mut entries = self.entries_of(at, premise);
            entries.all(|e| proved(e) && e.rests_on.is_empty())
        };
        let assumed = usable.assumed.iter();
        assumed
            .filter(|a| !matches!(a.source, Source::Equation(premise) if !sound(premise)))
            .cloned()
            .collect()
    }
}
