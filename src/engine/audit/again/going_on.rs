//! Steps that go on from the display before, whatever else they cite: "Inserting this into (1)".

use crate::derivation::{Assumed, Goal, Source};

use super::super::judge::{Found, Judge, sources};
use super::super::{Entry, Verdict};
use super::borrowed::Before;

impl Judge<'_> {
    /// Tries a step that does not follow from what it cites with the display before, where the text goes on from that: whoever does means the
    /// conditions under which it holds, and rests on what it rests on.
    pub(in crate::audit) fn rescue_going_on(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        premises: &[usize],
        found: &mut Found,
    ) -> bool {
        let Before { sound, .. } = self.before(premises);
        let mut before = self.gone_on_from(premises, sound);
        if before.is_empty() {
            return false;
        }
        let rests = |&other: &usize| {
            let mut entries = self.auditor.entries_of(self.at, other);
            entries.any(|own| !own.rests_on.is_empty())
        };
        // From what fails anything may follow, if only hard enough is tried.
        let under_conditions = !before.iter().any(rests) && self.failing(premises).is_empty();
        before.extend(sound);
        // What is cited besides may be what it takes to see it.
        found.may_follow = self.rescue_from(&before, goal, assumed, premises, found)
            || under_conditions && self.follows_with(&before, goal, assumed, found);
        found.may_follow
    }

    /// Leaves open a step that was refuted from what it cites, where the text goes on from the display before and nothing refutes the step
    /// with what that says: "The logarithms in (6) are therefore equal, and the efficiency is".
    pub(in crate::audit) fn heed_what_it_goes_on_from(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        premises: &[usize],
        found: &mut Found,
    ) {
        let is_refuted = found.judged.outcome.is_refuted() && found.mended.is_none();
        if !is_refuted || !self.names_its_premises() || self.is_directed() {
            return;
        }
        let before = self.display_gone_on_from(premises, &[]);
        // What is told besides, and slopes, only make it hard to see.
        let mut said = self.gathered(&before);
        // So do values elsewhere of what is cited.
        let cited = sources(assumed);
        said.retain(|own| {
            let is_new = matches!(own.source, Source::Equation(_)) && !cited.contains(&own.source);
            is_new && !own.formula.speaks_of_slopes()
        });
        if said.is_empty() {
            return;
        }
        let reason = "it may follow with what stands just before, and nothing decides it with that";
        self.heed_besides(goal, assumed, said, reason, found);
    }

    /// The display before, where the text goes on from that, and what it was drawn from: what is not wrong itself, nor cited or sound and
    /// tried already.
    fn gone_on_from(&self, premises: &[usize], sound: &[usize]) -> Vec<usize> {
        let mut all = self.display_gone_on_from(premises, sound);
        let entries = all
            .iter()
            .flat_map(|&other| self.auditor.entries_of(self.at, other));
        let judged = entries.flat_map(|entry| &entry.judged);
        let drawn_from: Vec<usize> = judged
            .flat_map(|own| sources(&own.assumed))
            .filter_map(|source| match source {
                Source::Equation(other) => Some(other),
                _ => None,
            })
            .filter(|&other| self.is_new(other, premises, sound) && !all.contains(&other))
            .collect();
        all.extend(drawn_from);
        all
    }

    /// The same without what it was drawn from.
    fn display_gone_on_from(&self, premises: &[usize], sound: &[usize]) -> Vec<usize> {
        let page = self.derivation.equations[self.at].page;
        let before = (self.derivation.equations_of(page).start..self.at).rev();
        before
            .take_while(|&other| self.goes_on_from(other))
            .filter(|&other| self.is_new(other, premises, sound) && self.may_borrow(other, true))
            .collect()
    }

    /// Whether an equation is neither wrong nor open, and not among what is tried already.
    fn is_new(&self, other: usize, premises: &[usize], sound: &[usize]) -> bool {
        let is_amiss = |entry: &Entry| entry.is_wrong() || entry.verdict == Verdict::Undecided;
        let known = premises.contains(&other) || sound.contains(&other);
        !known && !self.auditor.entries_of(self.at, other).any(is_amiss)
    }

    /// Whether the step is drawn where the text goes on from an equation: what that was shown under is meant as it is by a step that cites
    /// nothing. "In the steady state $dc/dt = 0$, so that … Eliminating $e$ with (1),".
    pub(super) fn goes_on_from(&self, other: usize) -> bool {
        let equations = &self.derivation.equations;
        let own = &equations[self.at];
        let is_before = self.derivation.display_before(self.at).contains(&other);
        let starts = self.derivation.section_start(self.at);
        own.drawn && is_before && other >= starts
    }
}
