//! All there is to remark on an audit, one thing at a time: what the views for programs list.
//!
//! The page for people tells several equations that rest on the same failing one together; here each is told where it
//! stands. What is merely good to know is told as well, as a note.

use std::collections::BTreeSet;
use std::path::Path;

use crate::audit::{Entry, Note, Verdict};
use crate::document::{Position, Span};

use super::Report;
use super::codes::{self, Level};
use super::diagnostic::Finding;
use super::fingerprint::{Fingerprints, spaced};
use super::fix::Fix;
use super::place::relative;

/// What a remark is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Subject {
    /// An entry of the audit, by position.
    Entry(usize),
    /// Something besides equations on a page, by the byte at which it starts.
    Page(usize, usize),
}

/// Remarks that need no attention, because a baseline knows them.
pub type Known = BTreeSet<(Subject, &'static str)>;

/// One thing to mend, or to know.
#[derive(Clone, Debug)]
pub struct Remark {
    /// How grave it is.
    pub level: Level,
    /// Its stable code.
    pub code: &'static str,
    /// What it is, in a sentence.
    pub title: String,
    /// What it is about.
    pub subject: Subject,
    /// The page, by position.
    pub page: usize,
    /// The path of the page, told from where the program was started, with `/`.
    pub path: String,
    /// Where it starts and ends; the end is the first place that is no part of it.
    pub place: (Position, Position),
    /// What else there is to see: places with what they are.
    pub context: Vec<((Position, Position), String)>,
    /// The evidence and what to do: names and texts.
    pub said: Vec<(String, String)>,
    /// A repair that a program can apply.
    pub fix: Option<(Fix, (Position, Position))>,
    /// What it is known by from one run to the next.
    pub fingerprint: String,
    /// A baseline knows it.
    pub known: bool,
}

impl Report<'_> {
    /// All remarks in the order of their places; paths are told from `here`.
    pub fn remarks(&self, here: &Path, known: &Known) -> Vec<Remark> {
        let mut found: Vec<(Subject, Finding, Level)> = Vec::new();
        for (subject, finding) in self.elsewhere() {
            found.push((subject, finding, Level::Error));
        }
        for (at, entry) in self.audit.entries.iter().enumerate() {
            for finding in self.about(entry) {
                let level = codes::level(finding.code).unwrap_or(Level::Warning);
                found.push((Subject::Entry(at), finding, level));
            }
        }
        found.sort_by_key(|(_, finding, _)| (finding.page, finding.primary.0.start));
        let entries = self.fingerprints();
        let mut fingerprints = Fingerprints::default();
        let remarks = found.into_iter().map(|(subject, finding, level)| {
            let document = &self.derivation.pages[finding.page].document;
            // In the author's own file, whatever that takes in.
            let place = |span: Span| {
                let (file, own) = document.written_at(span);
                (file.position(own.start), file.position(own.end))
            };
            let fingerprint = match subject {
                Subject::Entry(at) => fingerprints.of(&[finding.code, &entries[at]]),
                Subject::Page(..) => {
                    let content = spaced(document.text(finding.primary.0));
                    fingerprints.of(&[finding.code, &finding.title, &content])
                }
            };
            let fix = match subject {
                Subject::Entry(at) if finding.code == "fails" => self.fix(&self.audit.entries[at]),
                _ => None,
            };
            // What a macro stands for cannot be replaced where it is used.
            let fix = fix.filter(|fix| document.written(fix.span) == document.text(fix.span));
            Remark {
                level,
                code: finding.code,
                subject,
                page: finding.page,
                path: relative(document.place(finding.primary.0).0, here),
                place: place(finding.primary.0),
                context: finding
                    .context
                    .iter()
                    .filter(|(span, _)| *span != finding.primary.0)
                    .map(|(span, text)| (place(*span), text.clone()))
                    .collect(),
                said: finding.said_plainly(),
                fix: fix.map(|fix| (fix.clone(), place(fix.span))),
                fingerprint,
                known: known.contains(&(subject, finding.code)),
                title: finding.title,
            }
        });
        remarks.collect()
    }

    /// The codes of all that is remarked on an entry, sorted: those to mend, and those to know.
    pub fn codes(&self, entry: &Entry) -> Vec<&'static str> {
        let mut codes: Vec<&'static str> = Vec::new();
        let wrong = entry.is_wrong() && !entry.fails_as_marked();
        if wrong {
            codes.push(entry.verdict.word());
        }
        let apart = |note: &&Note| !(wrong && super::belongs_to_failing(note));
        let told = |note: &&Note| !note.is_quiet();
        codes.extend(
            entry
                .notes
                .iter()
                .filter(apart)
                .filter(told)
                .map(Note::code),
        );
        if self.is_left_open(entry) {
            codes.push(Verdict::Undecided.word());
        }
        codes.sort_unstable();
        codes
    }

    /// Undecided, and no other remark says why.
    fn is_left_open(&self, entry: &Entry) -> bool {
        let said = entry.notes.iter().any(Note::is_finding);
        entry.verdict == Verdict::Undecided && !entry.is_supported() && !said
    }

    /// Each remark on an entry as a finding.
    fn about(&self, entry: &Entry) -> Vec<Finding> {
        let mut all = self.of_entry(entry);
        let equation = self.equation(entry.equation);
        let whole = self.statement(entry).map_or(equation.body, |s| s.span);
        let mut tell = |code: &'static str, title: String| {
            all.push(Finding {
                level: annotate_snippets::Level::NOTE,
                code,
                title,
                page: equation.page,
                primary: (whole, String::new()),
                context: Vec::new(),
                said: super::diagnostic::replay(self, entry.equation)
                    .into_iter()
                    .collect(),
            });
        };
        for note in &entry.notes {
            let aside = self.aside(entry.equation, note).unwrap_or_default();
            match note {
                Note::RestsOn(on) => {
                    let fails = self.how_they_fail(on);
                    let on = self.references(on);
                    let title = format!("{} rests on {on}, which {fails}", self.subject(entry));
                    tell(note.code(), title);
                }
                Note::Uncited(sources) => {
                    let sources = self.sources(sources);
                    let title = format!(
                        "{} cites nothing; it follows from {sources}",
                        self.subject(entry)
                    );
                    tell(note.code(), title);
                }
                Note::OtherReading(other) if !note.is_quiet() => {
                    let verdict = other.verdict.word();
                    let title = format!(
                        "{} is {verdict} as it is read: {aside}",
                        self.subject(entry)
                    );
                    tell(note.code(), title);
                }
                Note::OutOfScope(_) | Note::RestsOnUnproved(_) => {
                    tell(note.code(), format!("{} {aside}", self.subject(entry)));
                }
                _ => {}
            }
        }
        if self.is_left_open(entry) {
            let reason = self.headline(entry);
            let colon = if reason.is_empty() { "" } else { ": " };
            let title = format!("{} is undecided{colon}{reason}", self.subject(entry));
            tell(Verdict::Undecided.word(), title);
        }
        all
    }
}
