//! An equation on the page: typeset, its number, its verdict in words in the margin, its evidence folded below.

use crate::audit::{Entry, Note, Verdict};
use crate::notation::{Statement, escape, latex_statement, read_display};
use crate::report::codes::Level;
use crate::report::style;

use super::{Page, anchors, words};

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

    fn of(entry: &Entry, is_to_mend: bool) -> Tone {
        match Tone::of_verdict(entry.verdict) {
            Tone::Good if is_to_mend => Tone::Mixed,
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
        let several = if entries.len() > 1 { " several" } else { "" };
        let mut text = format!(
            "<div class=\"equation{several}\" id=\"{id}\" data-verdict=\"{}\">\n",
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
        let set = self.set(entry);
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
        let tone = Tone::of(entry, self.is_to_mend(entry)).class();
        let mut asides = self.resting(entry);
        if entry.verdict.word() != word {
            asides.push(entry.verdict.word().to_owned());
        }
        if entry.fails_as_marked() {
            asides.push("as the author says".to_owned());
        }
        let asides: String = asides
            .iter()
            .map(|aside| format!(" <span class=\"aside\">{aside}</span>"))
            .collect();
        format!(
            "<div class=\"statement {tone}\">\n<div class=\"sheet\">{set}</div>\n{tag}\n\
             <p class=\"verdict\"><span class=\"sign\" aria-hidden=\"true\">{sign}</span> <strong>{word}</strong>{asides}</p>\n\
             <details class=\"evidence\"><summary>{}</summary>\n<div id=\"{}\">\n{}</div>\n</details>\n</div>\n",
            self.told_shortly(entry),
            anchors::evidence(id, entry),
            self.evidence(entry)
        )
    }

    /// A statement as its author typed it. Of a display that states several things it is this one's part, and where that says less by
    /// itself, as with cases, what was understood.
    fn set(&self, entry: &Entry) -> String {
        let equation = self.report.equation(entry.equation);
        let document = &self.report.derivation.pages[equation.page].document;
        let (Some(own), 2..) = (self.report.statement(entry), equation.statements().len()) else {
            return words::typed(document.text(equation.body));
        };
        match says_the_same(&document.source, own) {
            true => words::typed(document.text(own.span)),
            false => words::understood(own),
        }
    }

    /// Whether there is something to mend about an entry, told with it or once with others.
    fn is_to_mend(&self, entry: &Entry) -> bool {
        let page = self.report.equation(entry.equation).page;
        let graver = |note: &Note| self.report.level(page, note.code()) > Some(Level::Note);
        self.report.is_finding(entry) || entry.notes.iter().any(graver)
    }

    /// What a verdict rests on that is no better: what fails, or is not proved.
    fn resting(&self, entry: &Entry) -> Vec<String> {
        let rests = |note: &&Note| matches!(note, Note::RestsOn(_) | Note::RestsOnUnproved(_));
        let notes = entry.notes.iter().filter(rests);
        let told = notes.filter(|note| self.report.is_in_line(entry, note));
        let asides = told.filter_map(|note| self.report.aside(entry.equation, note));
        asides.map(|aside| words::scripted(&aside)).collect()
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

/// Whether the place of a statement says all of it.
fn says_the_same(source: &str, statement: &Statement) -> bool {
    let alone = read_display(source, statement.span).statements;
    match alone.as_deref() {
        Ok([alone]) => latex_statement(alone) == latex_statement(statement),
        _ => false,
    }
}
