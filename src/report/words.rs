//! How equations, places, sources and statements are named: alike in every view.

use std::collections::BTreeSet;

use crate::algebra::{Symbol, as_printed};
use crate::audit::Entry;
use crate::derivation::{Among, Equation, Source};
use crate::document::{Position, Span};
use crate::notation::{Statement, plain_formula};

use super::Report;

/// What the law of propagation is called wherever something was taken from it.
pub(super) const PROPAGATION: &str = "the law of propagation of uncertainty";
/// What constants of nature have to do with one another is called this.
pub(super) const NATURE: &str = "known of constants of nature";

/// What a hypothesis is called that stands nowhere else in the text.
pub(super) fn unplaced(source: Source) -> &'static str {
    match source {
        Source::Step => "the step before",
        Source::Taken => "taken so",
        Source::Propagation => PROPAGATION,
        Source::Nature => NATURE,
        Source::Equation(_) | Source::Local(..) => "a hypothesis",
    }
}

impl<'a> Report<'a> {
    pub(super) fn equation(&self, at: usize) -> &'a Equation {
        &self.derivation.equations[at]
    }

    /// `(23)`, `n-in-n-out`, or where it stands.
    pub(super) fn name(&self, at: usize) -> String {
        let equation = self.equation(at);
        match (&equation.tag, &equation.name) {
            (Some(tag), _) => format!("({tag})"),
            (None, Some(name)) => name.clone(),
            (None, None) => self.line_of(self.equation(at).page, self.equation(at).body),
        }
    }

    /// How an equation is referred to in a sentence.
    pub(super) fn reference(&self, at: usize) -> String {
        match self.is_named(at) {
            false => format!("the equation at {}", self.place(at)),
            true => self.equation(at).reference(),
        }
    }

    /// Whether it has a number or a name of its own.
    pub(super) fn is_named(&self, at: usize) -> bool {
        let equation = self.equation(at);
        equation.tag.is_some() || equation.name.is_some()
    }

    /// `equation (23)`, `claim n-in-n-out`, with the part of a display that states several things.
    pub(super) fn subject(&self, entry: &Entry) -> String {
        let whole = match &self.equation(entry.equation).tag {
            Some(tag) => format!("equation ({tag})"),
            None => self.reference(entry.equation),
        };
        match self.part_of(entry) {
            None => whole,
            Some((part, parts)) => format!("{whole}, statement {part} of {parts},"),
        }
    }

    /// Which of how many statements it is that bear one number, counted from 1; `None` where it is the only one.
    pub(super) fn part_of(&self, entry: &Entry) -> Option<(usize, usize)> {
        let alone = Among {
            before: 0,
            all: entry.parts,
        };
        let Among { before, all } = self.equation(entry.equation).among.unwrap_or(alone);
        (all > 1).then_some((before + entry.part + 1, all))
    }

    /// `line 12`, or `parts/a.tex:12` where that is another file than the page's.
    pub(super) fn line_of(&self, page: usize, span: Span) -> String {
        let document = &self.derivation.pages[page].document;
        match document.place(span) {
            (path, place) if path == document.path => format!("line {}", place.line),
            (path, place) => format!("{path}:{}", place.line),
        }
    }

    /// `path:line:column` of an equation.
    pub(super) fn place(&self, at: usize) -> String {
        self.place_of(self.equation(at).page, self.equation(at).body)
    }

    pub(super) fn place_of(&self, page: usize, span: Span) -> String {
        let document = &self.derivation.pages[page].document;
        let (path, Position { line, column }) = document.place(span);
        format!("{path}:{line}:{column}")
    }

    pub(super) fn statement(&self, entry: &Entry) -> Option<&'a Statement> {
        self.equation(entry.equation).statements().get(entry.part)
    }

    pub(super) fn references(&self, equations: &[usize]) -> String {
        list_once(equations.iter().map(|&at| self.reference(at)))
    }

    /// A source of hypotheses, in a sentence.
    pub(super) fn source(&self, source: &Source) -> String {
        match *source {
            Source::Equation(at) => self.reference(at),
            Source::Local(page, at) => {
                let local = self.derivation.local(page, at);
                let said: Vec<String> = local.formulas.iter().map(|f| plain_formula(f)).collect();
                format!("`{}` ({})", said.join(", "), self.line_of(page, local.span))
            }
            of_no_place => unplaced(of_no_place).into(),
        }
    }

    pub(super) fn sources(&self, sources: &[Source]) -> String {
        list_once(sources.iter().map(|s| self.source(s)))
    }
}

/// `a`, `a and b`, `a, b and c`.
pub(super) fn list(mut items: Vec<String>) -> String {
    match items.pop() {
        None => "nothing".into(),
        Some(last) if items.is_empty() => last,
        Some(last) => format!("{} and {last}", items.join(", ")),
    }
}

/// The same of names of which some may be alike: what bears the number of another is printed like it, and said once.
fn list_once(names: impl Iterator<Item = String>) -> String {
    let mut told = BTreeSet::new();
    list(names.filter(|own| told.insert(own.clone())).collect())
}

/// A symbol as one reads it.
pub(super) use crate::notation::plain_symbol as symbol;

/// A symbol as one reads it, told apart from another of the same letter: `k (line 17)`.
pub(super) fn symbol_apart(own: &Symbol) -> String {
    with_line(own, symbol(own))
}

/// The name of a symbol for programs, which may not be that of another.
pub(super) fn key(own: &Symbol) -> String {
    with_line(own, as_printed(own.name()).0.into_owned())
}

fn with_line(own: &Symbol, text: String) -> String {
    match as_printed(own.name()).1 {
        Some(line) => format!("{text} (line {line})"),
        None => text,
    }
}

/// At most so many characters, the last being `…` where something is left out.
pub(super) fn shortened(text: &str, most: usize) -> String {
    // No text has more characters than bytes.
    if text.len() <= most || text.chars().count() <= most {
        return text.to_owned();
    }
    let kept: String = text.chars().take(most.saturating_sub(1)).collect();
    format!("{}…", kept.trim_end())
}

/// `1 equation`, `2 equations`.
pub(super) fn count(number: usize, thing: &str) -> String {
    match number {
        1 => format!("1 {thing}"),
        _ => format!("{number} {thing}s"),
    }
}
