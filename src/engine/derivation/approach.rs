//! Limits that are told in prose: "In the limit $M \to \infty$ we get", "For $m \ll M$,", "… as $t \to 0$."
//!
//! Where a display is said of a limit is told by the sentence that leads on to it, or by the few words that end it.

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
}

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
        let readings = match () {
            () if ARROWS.iter().any(|sign| text.contains(sign)) => arrow(source, math.body),
            () if MUCH.iter().any(|sign| text.contains(sign)) => much(source, math.body),
            () => return None,
        };
        let span = math.span;
        (!readings.is_empty()).then_some(Told { span, readings })
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

/// `m \ll M`
fn much(source: &str, body: Span) -> Vec<Approach> {
    let Ok(statements) = read_formulas(source, body) else {
        return Vec::new();
    };
    let all = statements.iter().flat_map(|own: &Statement| formulas(own));
    all.flat_map(|formula| {
        let Formula::Relation {
            left,
            relation,
            right,
        } = formula
        else {
            return Vec::new();
        };
        let (small, large) = match relation {
            Relation::MuchLess => (left, right),
            Relation::MuchGreater => (right, left),
            _ => return Vec::new(),
        };
        let vanishing = factors(&small).into_iter().map(|variable| Approach {
            variable,
            point: LimitPoint::Finite(Expr::integer(0).into()),
        });
        let growing = factors(&large).into_iter().map(|variable| Approach {
            variable,
            point: LimitPoint::PlusInfinity,
        });
        growing.chain(vanishing).collect()
    })
    .collect()
}

/// The symbols of a product.
fn factors(term: &Expr) -> Vec<Symbol> {
    match term {
        Expr::Symbol(symbol) => vec![symbol.clone()],
        Expr::Product(all) => all.iter().flat_map(factors).collect(),
        _ => Vec::new(),
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
        let of = near.filter(is_of);
        of.flat_map(|told| told.readings.iter().cloned()).collect()
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
