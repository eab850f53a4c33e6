//! The codes of verdicts and notes: how grave each is, and its page of the reference.
//!
//! The pages are `docs/notes.md`, embedded: what `explain CODE` prints and what a rule of the SARIF output says is that
//! text and no other.

use std::fmt;

use crate::document::nearest;

/// How grave something is; the graver, the greater.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Level {
    /// Good to know; nothing need be mended.
    Note,
    /// To be mended: what is said of an equation is wrong or missing.
    Warning,
    /// To be mended: an equation is wrong, or could not be judged for what was written.
    Error,
}

impl Level {
    /// The word for it.
    pub fn word(self) -> &'static str {
        match self {
            Level::Note => "note",
            Level::Warning => "warning",
            Level::Error => "error",
        }
    }
}

impl fmt::Display for Level {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.word())
    }
}

/// Every code with its level; none for the verdicts of which nothing is reported.
pub const CODES: &[(&str, Option<Level>)] = &[
    ("given", None),
    ("holds", None),
    ("fails", Some(Level::Error)),
    ("ill-dimensioned", Some(Level::Error)),
    ("undecided", Some(Level::Note)),
    ("rests-on", Some(Level::Warning)),
    ("rests-on-unproved", Some(Level::Note)),
    ("miscited", Some(Level::Warning)),
    ("citations-shifted", Some(Level::Warning)),
    ("uncited", Some(Level::Note)),
    ("unused-premise", Some(Level::Note)),
    ("unstated-condition", Some(Level::Warning)),
    ("inconsistent-premises", Some(Level::Error)),
    ("wrong-mark", Some(Level::Error)),
    ("unknown-citation", Some(Level::Error)),
    ("cites-later", Some(Level::Warning)),
    ("out-of-scope", Some(Level::Note)),
    ("duplicate-tag", Some(Level::Error)),
    ("unreadable", Some(Level::Error)),
    ("other-reading", Some(Level::Note)),
    ("taken-as-given", Some(Level::Note)),
    ("taken-as-constant", Some(Level::Note)),
    ("unreadable-premise", Some(Level::Warning)),
    ("numeric-not-supported", Some(Level::Warning)),
    ("clashing-declaration", Some(Level::Warning)),
    ("given-up", Some(Level::Error)),
];

/// What the reference says about notes and verdicts.
const REFERENCE: &str = include_str!("../../docs/notes.md");

/// How far a misspelt code may be from one that is there.
const SLIPS: usize = 3;

/// How grave a code is; `None` for a verdict of which nothing is reported, and for what is no code.
pub fn level(code: &str) -> Option<Level> {
    CODES.iter().find(|(own, _)| *own == code)?.1
}

/// The page of a code, without its heading: Markdown. `error[fails]` is understood as well as `fails`.
pub fn page(code: &str) -> Option<(&'static str, &'static str)> {
    let code = bare(code);
    let (own, _) = CODES.iter().find(|(own, _)| *own == code)?;
    let heading = format!("\n## `{own}`\n");
    let (_, after) = REFERENCE.split_once(heading.as_str())?;
    let text = after.split("\n## ").next().unwrap_or(after);
    Some((own, text.trim()))
}

/// The first paragraph of a code's page, without emphasis: what it is in a sentence or two.
pub fn summary(code: &str) -> Option<String> {
    let (_, text) = page(code)?;
    let first = text.split("\n\n").next()?;
    let words: Vec<&str> = first.split_whitespace().collect();
    Some(words.join(" ").replace("**", ""))
}

/// The code that was perhaps meant.
pub fn near(code: &str) -> Option<&'static str> {
    let names: Vec<&'static str> = CODES.iter().map(|(own, _)| *own).collect();
    let code = bare(code);
    let slips = SLIPS.min(code.chars().count() / 3);
    nearest(code, &names, slips)
}

/// A code without the level that stands before it in a finding.
fn bare(code: &str) -> &str {
    let code = code.trim();
    match code.split_once('[') {
        Some((_, inside)) => inside.trim_end_matches(']'),
        None => code,
    }
}
