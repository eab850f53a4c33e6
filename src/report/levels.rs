//! How grave each thing is that there is to remark, as the author wants it: a `cradle.toml` beside a document may make a code
//! graver or lighter, or leave it untold. No verdict depends on it.

use crate::audit::{Entry, Note, Verdict};
use crate::derivation::Severity;

use super::Report;
use super::codes::{self, Level};
use super::remark::Subject;

impl Report<'_> {
    /// How grave a code is on a page; nothing for what is not told.
    pub fn level(&self, page: usize, code: &str) -> Option<Level> {
        let beside = self.derivation.pages[page].beside.as_ref();
        match beside.and_then(|beside| beside.severity.get(code)) {
            None => codes::level(code),
            Some(Severity::Error) => Some(Level::Error),
            Some(Severity::Warning) => Some(Level::Warning),
            Some(Severity::Note) => Some(Level::Note),
            Some(Severity::Off) => None,
        }
    }

    /// The level of the verdict of an entry, where that is something to remark.
    pub(super) fn level_of_verdict(&self, entry: &Entry) -> Option<Level> {
        let remarked = entry.is_mistake() || self.is_left_open(entry);
        let page = self.equation(entry.equation).page;
        match remarked {
            true => self.level(page, entry.verdict.word()),
            false => None,
        }
    }

    /// The level of a note of an entry; nothing for what is not told, or told with something else.
    pub(super) fn level_of_note(&self, entry: &Entry, note: &Note) -> Option<Level> {
        let level = self.level(self.equation(entry.equation).page, note.code())?;
        let wrong = entry.is_mistake();
        let elsewhere = wrong && super::belongs_to_failing(note)
            || matches!(note, Note::CitationsShifted { steps, .. } if steps.is_empty())
            || note.is_quiet() && level == Level::Note;
        (!elsewhere).then_some(level)
    }

    /// Whether a note is told in the line of its equation.
    pub(super) fn is_in_line(&self, entry: &Entry, note: &Note) -> bool {
        let level = self.level(self.equation(entry.equation).page, note.code());
        level > Some(Level::Note) || level.is_some() && !note.is_quiet()
    }

    /// Whether a note is something to mend, rather than to know.
    pub(super) fn is_to_mend(&self, entry: &Entry, note: &Note) -> bool {
        self.level_of_note(entry, note) > Some(Level::Note)
    }

    /// How many things there are to mend about one entry: what belongs to its failing is counted with that.
    pub(super) fn findings_of(&self, entry: &Entry) -> usize {
        let notes = entry
            .notes
            .iter()
            .filter(|note| self.is_to_mend(entry, note));
        usize::from(self.level_of_verdict(entry) > Some(Level::Note)) + notes.count()
    }

    /// Whether there is something to mend about an entry.
    pub fn is_finding(&self, entry: &Entry) -> bool {
        self.findings_of(entry) > 0
    }

    /// The level of the gravest thing that there is to remark.
    pub fn gravest(&self) -> Option<Level> {
        let elsewhere = self.elsewhere().into_iter();
        let elsewhere = elsewhere.map(|(_, finding)| self.level(finding.page, finding.code));
        let entries = self.audit.entries.iter().flat_map(|entry| {
            let page = self.equation(entry.equation).page;
            let codes = self.codes(entry).into_iter();
            codes.map(move |code| self.level(page, code))
        });
        elsewhere.chain(entries).max().flatten()
    }

    /// The page that something is remarked on.
    pub(super) fn page_of(&self, subject: Subject) -> usize {
        match subject {
            Subject::Entry(at) => self.equation(self.audit.entries[at].equation).page,
            Subject::Page(page, _) => page,
        }
    }

    /// Undecided, and no other remark says why.
    pub(super) fn is_left_open(&self, entry: &Entry) -> bool {
        let page = self.equation(entry.equation).page;
        let told = |note: &Note| note.is_finding() && self.level(page, note.code()).is_some();
        let said = entry.notes.iter().any(told);
        entry.verdict == Verdict::Undecided && !entry.is_supported() && !said
    }
}
