//! All there is to remark on an audit, one thing at a time: what the views for programs list.
//!
//! The page for people tells several equations that rest on the same failing one together; here each is told where it
//! stands. What is merely good to know is told as well, as a note.

use std::collections::BTreeSet;
use std::path::Path;

use crate::audit::{Entry, Note, Verdict};
use crate::document::{File, Position, Span};
use crate::sorted;

use super::Report;
use super::codes::Level;
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
    /// Where that is in the file, if it is in a cell of a notebook.
    pub saved: Option<Saved>,
    /// What else there is to see.
    pub context: Vec<Context>,
    /// The evidence and what to do: names and texts.
    pub said: Vec<(String, String)>,
    /// A repair that a program can apply.
    pub fix: Option<(Fix, (Position, Position))>,
    /// What it is known by from one run to the next.
    pub fingerprint: String,
    /// A baseline knows it.
    pub known: bool,
}

/// What else there is to see of a remark.
#[derive(Clone, Debug)]
pub struct Context {
    /// The path, as that of a remark.
    pub path: String,
    /// Where it starts and ends.
    pub place: (Position, Position),
    /// Where that is in the file, if it is in a cell of a notebook.
    pub saved: Option<Saved>,
    /// What it is.
    pub text: String,
}

/// A place in a cell of a notebook, as who opens the file finds it. The text is in quotation marks there, so that columns are
/// others.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Saved {
    /// The path of the notebook, as that of a remark.
    pub path: String,
    /// The first line and the last.
    pub lines: (usize, usize),
    /// The cell, `cell 3`.
    pub cell: String,
}

impl Saved {
    fn of(file: &File, (start, end): (Position, Position), here: &Path) -> Option<Saved> {
        let cell = file.cell.as_ref()?;
        Some(Saved {
            path: relative(&cell.notebook, here),
            lines: (cell.saved_line(start.line), cell.saved_line(end.line)),
            cell: format!("cell {}", cell.number),
        })
    }
}

impl Report<'_> {
    /// All remarks in the order of their places; paths are told from `here`.
    pub fn remarks(&self, here: &Path, known: &Known) -> Vec<Remark> {
        let mut found: Vec<(Subject, Finding, Level)> = Vec::new();
        let mut add = |subject: Subject, finding: Finding| {
            let level = self.level(finding.page, finding.code);
            found.extend(level.map(|level| (subject, finding, level)));
        };
        for (subject, finding) in self.elsewhere() {
            add(subject, finding);
        }
        for (at, entry) in self.audit.entries.iter().enumerate() {
            for finding in self.remarked(entry, Level::Note) {
                add(Subject::Entry(at), finding);
            }
        }
        sorted::sort_by_key(&mut found, |(_, finding, _)| {
            (finding.page, finding.primary.0.start)
        });
        let mut fingerprints = Fingerprints::default();
        let remarks = found.into_iter().map(|(subject, finding, level)| {
            let document = &self.derivation.pages[finding.page].document;
            // In the author's own file, whatever that takes in.
            let place = |span: Span| {
                let (file, own) = document.written_at(span);
                (file.position(own.start), file.position(own.end))
            };
            let saved = |span: Span| Saved::of(document.written_at(span).0, place(span), here);
            let fingerprint = match subject {
                Subject::Entry(at) => fingerprints.of(&[finding.code, &self.content(at)]),
                // Not the title, in which there may be numbers of equations.
                Subject::Page(..) => {
                    let content = spaced(document.text(finding.primary.0));
                    fingerprints.of(&[finding.code, &content])
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
                saved: saved(finding.primary.0),
                context: finding
                    .context
                    .iter()
                    .filter(|(span, _)| *span != finding.primary.0)
                    .map(|(span, text)| Context {
                        path: relative(document.place(*span).0, here),
                        place: place(*span),
                        saved: saved(*span),
                        text: text.clone(),
                    })
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
        if self.level_of_verdict(entry).is_some() {
            codes.push(entry.verdict.word());
        }
        let wrong = entry.is_mistake();
        let apart = |note: &&Note| !(wrong && super::belongs_to_failing(note));
        let told = |note: &&Note| self.is_in_line(entry, note);
        codes.extend(
            entry
                .notes
                .iter()
                .filter(apart)
                .filter(told)
                .map(Note::code),
        );
        codes.sort_unstable();
        codes
    }

    /// A note that needs no more than a sentence, as a finding.
    pub(super) fn told_shortly(&self, entry: &Entry, note: &Note) -> Option<Finding> {
        let title = match note {
            Note::RestsOn(on) => {
                let fails = self.how_they_fail(on);
                let on = self.references(on);
                format!("{} rests on {on}, which {fails}", self.subject(entry))
            }
            Note::UnreadablePremise(unread) => {
                let (subject, unread) = (self.subject(entry), self.references(unread));
                format!("{subject} is not judged: {unread} could not be read")
            }
            Note::Uncited(sources) => {
                let sources = self.sources(sources);
                let (_, cites, _) = self.derivation.premises(entry.equation);
                let subject = self.subject(entry);
                match cites {
                    true => format!("{subject} follows from {sources}, not all of which it cites"),
                    false => format!("{subject} cites nothing; it follows from {sources}"),
                }
            }
            Note::OtherReading(other) => {
                let verdict = other.verdict.word();
                let aside = self.aside(entry.equation, note).unwrap_or_default();
                format!(
                    "{} is {verdict} as it is read: {aside}",
                    self.subject(entry)
                )
            }
            Note::OutOfScope(_)
            | Note::RestsOnUnproved(_)
            | Note::TakenAsGiven(_)
            | Note::TakenAsConstant(_)
            | Note::UnusedPremise(_) => {
                let aside = self.aside(entry.equation, note).unwrap_or_default();
                format!("{} {aside}", self.subject(entry))
            }
            _ => return None,
        };
        let mut finding = self.in_a_sentence(entry, note.code(), title);
        if let Note::UnreadablePremise(unread) = note {
            finding.said.splice(0..0, self.where_they_are(unread));
        }
        Some(finding)
    }

    /// That an entry is undecided, as a finding.
    pub(super) fn left_open(&self, entry: &Entry) -> Finding {
        let reason = self.headline(entry);
        let colon = if reason.is_empty() { "" } else { ": " };
        let title = format!("{} is undecided{colon}{reason}", self.subject(entry));
        self.in_a_sentence(entry, Verdict::Undecided.word(), title)
    }

    fn in_a_sentence(&self, entry: &Entry, code: &'static str, title: String) -> Finding {
        let equation = self.equation(entry.equation);
        let whole = self.statement(entry).map_or(equation.body, |s| s.span);
        Finding {
            level: annotate_snippets::Level::NOTE,
            code,
            title,
            page: equation.page,
            primary: (whole, String::new()),
            context: Vec::new(),
            said: vec![super::diagnostic::replay(self, entry.equation)],
        }
    }
}
