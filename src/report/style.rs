//! The colours, by meaning.

use anstyle::{AnsiColor, Style};

use crate::audit::{Entry, Verdict};

pub(super) const BOLD: Style = Style::new().bold();
pub(super) const DIM: Style = Style::new().dimmed();
const GOOD: Style = AnsiColor::Green.on_default();
const BAD: Style = AnsiColor::Red.on_default().bold();
const WARN: Style = AnsiColor::Yellow.on_default();

/// Text in a style.
pub(super) fn paint(style: Style, text: &str) -> String {
    format!("{style}{text}{style:#}")
}

/// The sign for a verdict.
pub(super) fn sign(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Given => "·",
        Verdict::Holds => "✓",
        Verdict::Fails => "✗",
        Verdict::IllDimensioned => "!",
        Verdict::Undecided => "?",
    }
}

/// The colour of an entry's verdict; whether there is something to mend about it is said by the caller.
pub(super) fn of(entry: &Entry, is_finding: bool) -> Style {
    match entry.verdict {
        Verdict::Given => DIM,
        Verdict::Holds if is_finding => WARN,
        Verdict::Holds => GOOD,
        _ if entry.fails_as_marked() => DIM,
        Verdict::Fails | Verdict::IllDimensioned => BAD,
        Verdict::Undecided if entry.is_supported() => Style::new(),
        Verdict::Undecided => WARN,
    }
}

/// Text of which nothing but its colours commands a terminal, without them.
pub fn uncoloured(text: &str) -> String {
    let mut plain = String::with_capacity(text.len());
    let mut rest = text;
    while let Some((before, after)) = rest.split_once('\u{1b}') {
        plain += before;
        rest = match (after.starts_with('['), after.split_once('m')) {
            (true, Some((_, after))) => after,
            _ => after,
        };
    }
    plain + rest
}
