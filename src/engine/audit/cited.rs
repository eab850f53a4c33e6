//! What a step is said to follow from, held against what it uses.

use crate::derivation::{Derivation, Kind, Source};
use crate::document::Extent;
use crate::sorted::Set;

use super::entry::of_equations;
use super::premise::Offer;
use super::{Auditor, Entry, Note};

impl Auditor<'_> {
    /// Whether an equation says something, and no moment was left of which it does: what is not cited is a premise of what is said of that moment.
    pub(super) fn is_said_here(&self, at: usize, premise: usize) -> bool {
        let own = &self.derivation.equations[at];
        let is_here = |&(page, local): &(usize, usize)| {
            own.is_under(page, local) || !self.derivation.local(page, local).is_momentary()
        };
        // What an author only asks, or crosses out, says nothing.
        let is_marked = self.derivation.equations[premise].kind == Kind::Marked;
        let says =
            |offer: &Offer| !is_marked || !offer.formulas.is_empty() || !offer.cases.is_empty();
        let offer = self.offer(at, premise);
        offer.is_none_or(|offer| says(offer) && offer.under.iter().all(is_here))
    }

    /// Whether the text tells something in passing before a step.
    pub(super) fn is_told(&self, at: usize, source: &Source) -> bool {
        let own = &self.derivation.equations[at];
        match source {
            Source::Local(page, local) => {
                *page == own.page && own.told.iter().chain(&own.named).any(|told| told == local)
            }
            _ => false,
        }
    }

    /// Whether a step uses all that it cites, and besides only what stands just before it: "Inserting this into (1)". What the
    /// text tells may come of what is cited: "With (2), $v_2 = a v_1$, so".
    pub(super) fn goes_on(&self, at: usize, premises: &[usize], used: &Set<Source>) -> bool {
        let equations = &self.derivation.equations;
        let before = self.derivation.display_before(at);
        let own = &equations[at];
        let is_near = |source: &Source| match *source {
            Source::Equation(other) => {
                let put = &equations[other];
                let is_put = put.extent != Extent::Throughout && put.section == own.section;
                premises.contains(&other)
                    || before.contains(&other)
                    || is_put && put.page == own.page
            }
            Source::Local(page, local) => own.is_under(page, local),
            Source::Step | Source::Taken | Source::Propagation | Source::Nature => true,
        };
        let is_used = |premise: &usize| used.contains(&Source::Equation(*premise));
        let uses_all = premises.iter().all(is_used) || used.iter().any(|s| self.is_told(at, s));
        uses_all && (used.iter().all(is_near) || self.counts_equations(at))
    }

    /// Whether the sentence before a step names an equation by its place among others: "Inserting (2) in the second and multiplying by".
    fn counts_equations(&self, at: usize) -> bool {
        const PLACES: [&str; 6] = ["first", "second", "third", "former", "latter", "other"];
        const AFTER: [&str; 8] = [
            "equation", "one", "relation", "and", "gives", "yields", "leads", "we",
        ];
        let words = self.derivation.leading_words(at);
        (1..words.len()).any(|at| {
            let next = words.get(at + 1).map(String::as_str);
            words[at - 1] == "the"
                && PLACES.contains(&&*words[at])
                && next.is_none_or(|next| AFTER.contains(&next))
        })
    }
}

/// Leaves out of what is not needed what another row needs that shares the number of the step, and what shares the number of something
/// needed: who cites (2) cites all its rows.
pub(super) fn forgive_rows(derivation: &Derivation, entries: &mut [Entry]) {
    let notes_some = |entry: &Entry| {
        let mut notes = entry.notes.iter();
        notes.any(|note| matches!(note, Note::UnusedPremise(_)))
    };
    let noting: Vec<usize> = (0..entries.len())
        .filter(|&at| notes_some(&entries[at]))
        .collect();
    for at in noting {
        let rows = derivation.rows_of(entries[at].equation);
        let of_rows = of_equations(entries, rows).iter();
        let needed: Set<usize> = of_rows
            .flat_map(|own| own.premises.iter().copied())
            .collect();
        let is_needed =
            |premise: usize| derivation.rows_of(premise).any(|row| needed.contains(&row));
        for note in &mut entries[at].notes {
            if let Note::UnusedPremise(unused) = note {
                unused.retain(|&premise| !is_needed(premise));
            }
        }
        let is_empty = |note: &Note| matches!(note, Note::UnusedPremise(all) if all.is_empty());
        entries[at].notes.retain(|note| !is_empty(note));
    }
}

/// What is cited and not needed. What is cited wrongly is told already.
pub(super) fn unused(entries: &[Entry], premises: &[usize]) -> Vec<usize> {
    let told = |n: &Note| {
        matches!(
            n,
            Note::Miscited { .. } | Note::OutOfScope(_) | Note::CitesLater(_)
        )
    };
    if entries.iter().any(|e| e.notes.iter().any(told)) {
        return Vec::new();
    }
    let needed = |premise: &&usize| entries.iter().any(|e| e.premises.contains(premise));
    premises.iter().filter(|p| !needed(p)).copied().collect()
}
