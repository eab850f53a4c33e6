//! An equation on the page: typeset, its number, its verdict in words in the margin, its evidence folded below.

use crate::audit::{Entry, Verdict};
use crate::notation::escape;
use crate::report::style;

use super::{Page, words};

/// What a verdict looks like beside its words.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Tone {
    Given,
    Good,
    /// Holds, and there is something to mend all the same.
    Mixed,
    Bad,
    /// Wrong, as its author says.
    Crossed,
    Open,
}

impl Tone {
    pub(super) fn class(self) -> &'static str {
        match self {
            Tone::Given => "given",
            Tone::Good => "good",
            Tone::Mixed => "mixed",
            Tone::Bad => "bad",
            Tone::Crossed => "crossed",
            Tone::Open => "open",
        }
    }

    pub(super) fn of_verdict(verdict: Verdict) -> Tone {
        match verdict {
            Verdict::Given => Tone::Given,
            Verdict::Holds => Tone::Good,
            Verdict::Fails | Verdict::IllDimensioned => Tone::Bad,
            Verdict::Undecided => Tone::Open,
        }
    }

    fn of(entry: &Entry, is_finding: bool) -> Tone {
        match Tone::of_verdict(entry.verdict) {
            Tone::Good if is_finding => Tone::Mixed,
            Tone::Bad if entry.fails_as_marked() => Tone::Crossed,
            tone => tone,
        }
    }
}

impl Page<'_> {
    /// An equation with all its statements.
    pub(super) fn equation(&self, at: usize) -> String {
        let report = self.report;
        let id = self.anchors.equation(at);
        let entries = report.audit.of_equation(at);
        let verdicts: Vec<&str> = entries.iter().map(|e| e.verdict.word()).collect();
        let mut text = format!(
            "<div class=\"equation\" id=\"{id}\" data-verdict=\"{}\">\n",
            verdicts.join(" ")
        );
        for entry in entries {
            text += &self.statement(entry, id);
        }
        text + "</div>\n"
    }

    fn statement(&self, entry: &Entry, id: &str) -> String {
        let report = self.report;
        let equation = report.equation(entry.equation);
        let document = &report.derivation.pages[equation.page].document;
        let set = match report.statement(entry) {
            Some(statement) => words::display(statement),
            None => format!(
                "<code class=\"tex\">{}</code>",
                escape(document.text(equation.body))
            ),
        };
        let name = escape(&report.name(entry.equation));
        let tag = match (&equation.tag, &equation.name, entry.part) {
            (Some(_), _, 0) => format!("<a class=\"tag\" href=\"#{id}\">{name}</a>"),
            (None, Some(_), 0) => format!("<a class=\"tag name\" href=\"#{id}\">{name}</a>"),
            (None, None, 0) => {
                format!("<a class=\"tag bare\" href=\"#{id}\" aria-label=\"{name}\">#</a>")
            }
            _ => "<span class=\"tag\"></span>".to_owned(),
        };
        let (sign, word) = report.told(entry);
        let tone = Tone::of(entry, report.is_finding(entry)).class();
        let marked = match entry.fails_as_marked() {
            true => " <span class=\"aside\">as the author says</span>",
            false => "",
        };
        let supported = match entry.verdict.word() == word {
            true => String::new(),
            false => format!(" <span class=\"aside\">{}</span>", entry.verdict.word()),
        };
        format!(
            "<div class=\"statement {tone}\">\n<div class=\"sheet\">{set}</div>\n{tag}\n\
             <p class=\"verdict\"><span class=\"sign\" aria-hidden=\"true\">{sign}</span> <strong>{word}</strong>{supported}{marked}</p>\n\
             <details class=\"evidence\"><summary>{}</summary>\n{}</details>\n</div>\n",
            self.told_shortly(entry),
            self.evidence(entry)
        )
    }

    /// What the fold is called: the one thing to know.
    fn told_shortly(&self, entry: &Entry) -> String {
        if entry.verdict == Verdict::Given && entry.notes.is_empty() {
            return "law, model or definition".into();
        }
        let headline = self.report.headline(entry);
        match headline.is_empty() {
            true => match style::sign(entry.verdict) {
                "?" => "neither proof nor counterexample was found".into(),
                _ => "evidence".into(),
            },
            false => words::ticked(&headline),
        }
    }
}
