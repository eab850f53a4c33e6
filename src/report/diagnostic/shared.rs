//! What several equations have in common, in one finding for all of them.

use std::collections::BTreeSet;

use annotate_snippets::Level;

use crate::audit::{Entry, Note, Verdict};

use super::super::Report;
use super::super::remark::{Known, Subject};
use super::{Finding, replay};

/// What may be the matter with many equations at once, with the equations that it comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(in super::super) enum Shared<'a> {
    /// They follow from what fails.
    RestsOn(&'a [usize]),
    /// They are said to follow from what could not be read.
    Unjudged(&'a [usize]),
}

impl<'a> Shared<'a> {
    /// What of a note is told once for all that have it.
    pub(in super::super) fn of(note: &'a Note) -> Option<Shared<'a>> {
        match note {
            Note::RestsOn(on) => Some(Shared::RestsOn(on)),
            Note::UnreadablePremise(unread) => Some(Shared::Unjudged(unread)),
            _ => None,
        }
    }

    /// The code of the notes that it comes from.
    pub(super) fn is_code(code: &str) -> bool {
        matches!(code, "rests-on" | "unreadable-premise")
    }
}

impl Report<'_> {
    /// For each entry what it shares with later ones, and no entry before has: these are told together.
    pub(in super::super) fn first_to_share(&self, known: &Known) -> Vec<Vec<Shared<'_>>> {
        let mut told = BTreeSet::new();
        let entries = self.audit.entries.iter().enumerate();
        let first = entries.map(|(at, entry)| {
            let is_new = |note: &&Note| !known.contains(&(Subject::Entry(at), note.code()));
            let to_mend = |note: &&Note| self.is_to_mend(entry, note);
            let notes = entry.notes.iter().filter(is_new).filter(to_mend);
            let shared = notes.filter_map(Shared::of);
            shared.filter(|&shared| told.insert(shared)).collect()
        });
        first.collect()
    }

    /// All that share something, in one finding.
    pub(in super::super) fn sharing(&self, shared: Shared) -> Finding {
        let shares = |e: &&Entry| e.notes.iter().any(|note| Shared::of(note) == Some(shared));
        let sharing: Vec<&Entry> = self.audit.entries.iter().filter(shares).collect();
        let mut equations: Vec<usize> = sharing.iter().map(|e| e.equation).collect();
        equations.dedup();
        let subjects = self.references(&equations);
        let one = equations.len() == 1;
        let (code, title, replayed) = match shared {
            Shared::RestsOn(on) => {
                let verb = if one { "rests" } else { "rest" };
                let (failing, fail) = (self.references(on), self.how_they_fail(on));
                let title = format!("{subjects} {verb} on {failing}, which {fail}");
                ("rests-on", title, on[0])
            }
            Shared::Unjudged(unread) => {
                let verb = if one { "is" } else { "are" };
                let unread = self.references(unread);
                let title = format!("{subjects} {verb} not judged: {unread} could not be read");
                ("unreadable-premise", title, equations[0])
            }
        };
        let mut said = match shared {
            Shared::RestsOn(_) => vec![(Level::NOTE, whence(&sharing).to_owned())],
            Shared::Unjudged(unread) => self.where_they_are(unread),
        };
        for &at in &equations[1..] {
            let place = match self.is_named(at) {
                true => format!(" at {}", self.place(at)),
                false => String::new(),
            };
            let text = format!("{}{place}", self.reference(at));
            said.push((Level::NOTE.with_name("likewise"), text));
        }
        said.push(replay(self, replayed));
        let first = self.equation(equations[0]);
        Finding {
            level: Level::WARNING,
            code,
            title,
            page: first.page,
            primary: (first.body, String::new()),
            context: Vec::new(),
            said,
        }
    }

    /// Where equations are that something is said of; what has no name is called by its place already.
    pub(in super::super) fn where_they_are(
        &self,
        equations: &[usize],
    ) -> Vec<(Level<'static>, String)> {
        let named = equations.iter().filter(|&&at| self.is_named(at));
        let told = named.map(|&at| {
            let text = format!("{} is at {}", self.reference(at), self.place(at));
            (Level::NOTE, text)
        });
        told.collect()
    }

    /// The end of "… rests on …, which …".
    pub(in super::super) fn how_they_fail(&self, on: &[usize]) -> &'static str {
        let ill = |at: &usize| {
            let mut wrong = self.audit.of_equation(*at).iter().filter(|e| e.is_wrong());
            wrong.all(|e| e.verdict == Verdict::IllDimensioned)
        };
        match (on.iter().all(ill), on.len()) {
            (true, 1) => "is ill-dimensioned",
            (true, _) => "are ill-dimensioned",
            (false, 1) => "fails",
            (false, _) => "fail",
        }
    }
}

/// How what rests on something false follows from it.
fn whence(resting: &[&Entry]) -> &'static str {
    let is_borrowed = |note: &Note| matches!(note, Note::Miscited { .. } | Note::Uncited(_));
    match resting.iter().flat_map(|e| &e.notes).any(is_borrowed) {
        true => "each step follows from what it was judged from; some of that is false",
        false => "each step follows from what it cites; what it comes from is false",
    }
}
