//! Limits that are told in prose: "In the limit $M \to \infty$ we get", "For $m \ll M$,", "… as $t \to 0$."
//!
//! Where a display is said of a limit is told by the sentence that leads on to it, or by the few words that end it.

use num_traits::Signed;

use crate::algebra::{Expr, Formula, LimitPoint, Relation, Symbol};
use crate::document::{Document, Span};
use crate::notation::{Statement, read_expr, read_formulas};

use super::Derivation;
use super::equation::formulas;

/// A symbol on its way to a place: one way to read what is said.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Approach {
    /// What moves.
    pub variable: Symbol,
    /// Where it goes.
    pub point: LimitPoint,
}

/// What inline mathematics says that goes somewhere.
#[derive(Clone, Debug)]
pub struct Told {
    /// The mathematics with its fences.
    span: Span,
    /// The ways to read it. `m \ll M` says that `M` grows beyond `m`, or that `m` vanishes beside `M`.
    readings: Vec<Approach>,
    /// What is small or large beside all else, as far as terms are expanded in it: what words call so, too, "for small $x/a$".
    sizes: Vec<Approach>,
}

/// Words before mathematics that call it small, and those that call it large.
const SMALL: [&str; 9] = [
    "small",
    "tiny",
    "low",
    "short",
    "weak",
    "slow",
    "order in",
    "powers of",
    "orders of",
];
const LARGE: [&str; 5] = ["large", "high", "great", "long", "strong"];
/// Words that say that something is small, with no symbol for what.
const SMALL_THINGS: [&str; 9] = [
    "short times",
    "early times",
    "small times",
    "low speed",
    "low velocit",
    "small velocit",
    "small angle",
    "small amplitude",
    "small oscillation",
];

/// The signs of an arrow.
const ARROWS: [&str; 5] = ["\\to", "\\rightarrow", "\\longrightarrow", "→", "⟶"];
/// The signs by which something is much less or much more.
const MUCH: [&str; 4] = ["\\ll", "\\gg", "≪", "≫"];
/// With one of these a sentence may say what is so elsewhere.
const DENYING: [&str; 9] = [
    "not", "never", "unless", "except", "without", "instead", "unlike", "before", "whether",
];
/// More than this between two displays is not looked at.
const MOST_NEAR: usize = 20;
/// Sentences that are longer, in bytes, are not read to their ends.
const LONGEST: usize = 2000;
/// The words that end the sentence of a display.
const ENDING: [&str; 7] = [
    "for",
    "as",
    "when",
    "if",
    "in the limit",
    "in the case",
    "provided",
];

/// All that the text of a document says goes somewhere, in order.
pub(super) fn told(document: &Document) -> Vec<Told> {
    let source = &document.source;
    let all = document.inline().filter_map(|math| {
        let text = source.get(math.body.range())?;
        let (readings, sizes) = match () {
            () if ARROWS.iter().any(|sign| text.contains(sign)) => {
                let readings = arrow(source, math.body);
                (readings.clone(), readings)
            }
            () if MUCH.iter().any(|sign| text.contains(sign)) => much(source, math.body),
            () => (Vec::new(), called(source, math.span, math.body)),
        };
        let span = math.span;
        let is_told = !readings.is_empty() || !sizes.is_empty();
        is_told.then_some(Told {
            span,
            readings,
            sizes,
        })
    });
    all.collect()
}

/// `M \to \infty`
fn arrow(source: &str, body: Span) -> Vec<Approach> {
    let text = source.get(body.range()).unwrap_or_default();
    // `\to` is no part of `\top`.
    let sign = ARROWS.into_iter().find_map(|sign| {
        let (before, after) = text.split_once(sign)?;
        let is_whole = !sign.starts_with('\\') || !after.starts_with(char::is_alphabetic);
        is_whole.then_some((before.len(), sign.len()))
    });
    let Some((at, length)) = sign else {
        return Vec::new();
    };
    let before = Span::new(body.start, body.start + at);
    let after = Span::new(before.end + length, body.end);
    let Ok(Expr::Symbol(variable)) = read_expr(source, before) else {
        return Vec::new();
    };
    let point = match source.get(after.range()).unwrap_or_default().trim() {
        "\\infty" | "+\\infty" | "∞" => LimitPoint::PlusInfinity,
        "-\\infty" | "-∞" => LimitPoint::MinusInfinity,
        _ => match read_expr(source, after) {
            Ok(place) if !place.mentions(&variable) => LimitPoint::Finite(place.into()),
            _ => return Vec::new(),
        },
    };
    vec![Approach { variable, point }]
}

/// `m \ll M`: what goes where, and in what terms are expanded.
fn much(source: &str, body: Span) -> (Vec<Approach>, Vec<Approach>) {
    let Ok(statements) = read_formulas(source, body) else {
        return Default::default();
    };
    let all: Vec<Formula> = (statements.iter())
        .flat_map(|own: &Statement| formulas(own))
        .collect();
    let sizes = all.iter().flat_map(sizes).collect();
    let readings = all.iter().filter_map(much_smaller);
    let readings = readings.flat_map(|(small, large)| {
        let vanishing = factors(small).into_iter().map(Approach::vanishing);
        let growing = factors(large).into_iter().map(Approach::growing);
        growing.chain(vanishing)
    });
    (readings.collect(), sizes)
}

/// What is much smaller than what.
fn much_smaller(formula: &Formula) -> Option<(&Expr, &Expr)> {
    match formula {
        Formula::Relation {
            left,
            relation: Relation::MuchLess,
            right,
        } => Some((left, right)),
        Formula::Relation {
            left,
            relation: Relation::MuchGreater,
            right,
        } => Some((right, left)),
        _ => None,
    }
}

/// The ways in which terms may be expanded where one thing is much smaller than another, `x^2 \ll a b`; none for what says nothing of that.
pub fn sizes(formula: &Formula) -> Vec<Approach> {
    let Some((small, large)) = much_smaller(formula) else {
        return Vec::new();
    };
    size(small, true)
        .into_iter()
        .chain(size(large, false))
        .collect()
}

/// The same for a term that is small, or large: `v/c` is small where `v` is, or where `c` is large.
fn size(term: &Expr, is_small: bool) -> Vec<Approach> {
    match term {
        Expr::Symbol(symbol) if !symbol.is_unit() => vec![match is_small {
            true => Approach::vanishing(symbol.clone()),
            false => Approach::growing(symbol.clone()),
        }],
        Expr::Product(all) => all.iter().flat_map(|own| size(own, is_small)).collect(),
        Expr::Quotient(above, below) => {
            let both = size(above, is_small).into_iter();
            both.chain(size(below, !is_small)).collect()
        }
        Expr::Power(base, exponent) => match &**exponent {
            Expr::Number(exponent) if exponent.is_positive() => size(base, is_small),
            _ => Vec::new(),
        },
        _ => Vec::new(),
    }
}

/// What the word before mathematics calls small or large: "for small $x$", "to first order in $v/c$".
fn called(source: &str, span: Span, body: Span) -> Vec<Approach> {
    let before = source.get(..span.start).unwrap_or_default().trim_end();
    let ends = |words: &[&str]| words.iter().any(|own| before.ends_with(own));
    let is_small = match (ends(&SMALL), ends(&LARGE)) {
        (true, false) => true,
        (false, true) => false,
        _ => return Vec::new(),
    };
    match read_expr(source, body) {
        Ok(term) => size(&term, is_small),
        Err(_) => Vec::new(),
    }
}

/// The symbols of a product.
fn factors(term: &Expr) -> Vec<Symbol> {
    match term {
        Expr::Symbol(symbol) => vec![symbol.clone()],
        Expr::Product(all) => all.iter().flat_map(factors).collect(),
        _ => Vec::new(),
    }
}

impl Approach {
    /// To 0.
    pub fn vanishing(variable: Symbol) -> Approach {
        let point = LimitPoint::Finite(Expr::integer(0).into());
        Approach { variable, point }
    }

    /// Beyond all bounds.
    pub fn growing(variable: Symbol) -> Approach {
        let point = LimitPoint::PlusInfinity;
        Approach { variable, point }
    }
}

impl Derivation {
    /// What the text beside an equation says besides the limit of which the equation is said: it may be meant there, too.
    pub fn said_with_limit(&self, at: usize) -> Vec<Formula> {
        let equation = &self.equations[at];
        let document = &self.pages[equation.page].document;
        let before = at.checked_sub(1).map(|before| &self.equations[before]);
        let from = before.filter(|own| own.page == equation.page);
        let from = from.map_or(0, |own| own.span.end);
        let after = self.equations.get(at + 1);
        let after = after.filter(|own| own.page == equation.page);
        let until = after.map_or(document.source.len(), |own| own.span.start);
        let beside = document.inline().filter(|math| math.span.start >= from);
        let beside = beside.take_while(|math| math.span.end <= until);
        let read = beside.take(MOST_NEAR);
        let read = read.filter_map(|math| read_formulas(&document.source, math.body).ok());
        read.flatten().flat_map(|own| formulas(&own)).collect()
    }

    /// The ways to read the limit of which an equation is said; none where it is said of none.
    pub fn approached(&self, at: usize) -> Vec<Approach> {
        let told = self.told_with(at).into_iter();
        told.flat_map(|told| told.readings.iter().cloned())
            .collect()
    }

    /// In what the terms of an equation may be expanded by what the text says of it, one list for each thing it says.
    pub fn expanded_in(&self, at: usize) -> Vec<Vec<Approach>> {
        let told = self.told_with(at).into_iter();
        let told = told.map(|told| told.sizes.clone());
        told.filter(|sizes| !sizes.is_empty()).collect()
    }

    /// Whether words just before an equation say that something is small without a symbol for what: "At short times".
    pub fn speaks_of_what_is_small(&self, at: usize) -> bool {
        let begin = self.equations[self.display_start(at)].span.start;
        let before = self.before_display(at);
        let from = before.map_or(0, |before| self.equations[before].span.end);
        let page = &self.pages[self.equations[at].page];
        let text = page.document.source.get(from..begin).unwrap_or_default();
        let last = text.trim_end().rsplit("\n\n").next().unwrap_or_default();
        let last = last.to_lowercase();
        SMALL_THINGS.iter().any(|own| last.contains(own))
    }

    /// What the text says goes somewhere, or is small, where an equation is meant.
    fn told_with(&self, at: usize) -> Vec<&Told> {
        let equation = &self.equations[at];
        let page = &self.pages[equation.page];
        let said: &[Told] = &page.approaches;
        if said.is_empty() {
            return Vec::new();
        }
        // What leads on to a display does to each of its rows.
        let begin = self.equations[self.display_start(at)].span.start;
        let before = self.before_display(at);
        let from = before.map_or(0, |before| self.equations[before].span.end);
        let after = self.equations.get(at + 1);
        let after = after.filter(|own| own.page == equation.page);
        let until = after.map_or(page.document.source.len(), |own| own.span.start);
        let start = said.partition_point(|told| told.span.start < from);
        let near = said[start..].iter().take(MOST_NEAR);
        let near = near.take_while(|told| told.span.end <= until);
        let text = |from: usize, to: usize| page.document.source.get(from..to).unwrap_or_default();
        let is_of = |told: &&Told| match told.span.end <= begin {
            true => leads_on(text(from, told.span.start), text(told.span.end, begin)),
            false => ends(text(
                equation.span.end.min(told.span.start),
                told.span.start,
            )),
        };
        near.filter(is_of).collect()
    }
}

/// Whether text goes on from mathematics to a display, and the sentence denies nothing.
fn leads_on(before: &str, after: &str) -> bool {
    if after.len() > LONGEST {
        return false;
    }
    let mut far = before.len().saturating_sub(LONGEST);
    while !before.is_char_boundary(far) {
        far += 1;
    }
    let before = &before[far..];
    let begun = stops(before).last().map_or(before, |at| &before[at..]);
    let words = begun.split(|c: char| !c.is_alphabetic());
    let mut words = words.chain(after.split(|c: char| !c.is_alphabetic()));
    stops(after).next().is_none()
        && !words.any(|word| DENYING.iter().any(|own| own.eq_ignore_ascii_case(word)))
}

/// The places just after the ends of sentences.
fn stops(text: &str) -> impl Iterator<Item = usize> {
    let ends = text.match_indices(['.', '!', '?']);
    ends.map(|(at, _)| at + 1)
        .filter(|&at| text[at..].starts_with(char::is_whitespace))
}

/// Whether nothing but the words that end a sentence stands between a display and mathematics.
fn ends(between: &str) -> bool {
    let between = between.trim_matches(|c: char| c.is_whitespace() || c == '$' || c == ',');
    ENDING.contains(&between)
}
