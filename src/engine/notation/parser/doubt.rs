//! What reads as a power or a product and may be neither: remembered here, and decided where the whole page is known.

use super::name::Name;
use super::{Doubt, DoubtKind, Kind, Parser};
use crate::algebra::{Expr, Symbol};
use crate::document::Span;

/// What is written for a sum; `\Sigma_a` is a cross section.
const SUMS: [&str; 5] = [
    "\\Sigma",
    "\\Sigma_i",
    "\\Sigma_j",
    "\\Sigma_k",
    "\\Sigma_n",
];

impl Parser<'_> {
    /// Remembers a name whose exponent is nothing but letters. Those of Euler's number are no indices, nor is the Latin letter that a sum
    /// runs over, as in a power series.
    pub(super) fn doubt_power(&mut self, name: &Name, span: Span) {
        let Some(letters) = name.power.as_ref().and_then(letters) else {
            return;
        };
        let symbol = Symbol::new(name.canonical());
        let runs = |letter: &Symbol| self.bound.iter().any(|own| own == letter.name());
        let bound = |letter: &Symbol| runs(letter) && !letter.name().starts_with('\\');
        if !matches!(symbol.name(), "e" | "\\text{e}") && !letters.iter().any(bound) {
            let kind = DoubtKind::Raised {
                name: symbol,
                letters,
            };
            self.doubts.push(Doubt { span, kind });
        }
    }

    /// Remembers a `\Delta` or `\Sigma`, which began at `start`, right before what it would multiply.
    pub(super) fn doubt_operator(&mut self, start: usize, read: &Expr) {
        let Expr::Symbol(symbol) = read else { return };
        let is_operator = match self.kind(start) {
            Kind::Command("Delta") => symbol.name() == "\\Delta",
            Kind::Command("Sigma") => SUMS.contains(&symbol.name()),
            _ => false,
        };
        if is_operator && (self.pending.is_some() || self.starts_factor()) {
            self.doubts.push(Doubt {
                span: self.since(start),
                kind: DoubtKind::Operator(symbol.clone()),
            });
        }
    }
}

/// The letters that an exponent consists of, side by side.
fn letters(exponent: &Expr) -> Option<Vec<Symbol>> {
    let parts = match exponent {
        Expr::Product(factors) => &factors[..],
        single => std::slice::from_ref(single),
    };
    let letter = |part: &Expr| match part {
        Expr::Symbol(symbol) if is_letter(symbol.name()) => Some(symbol.clone()),
        _ => None,
    };
    parts.iter().map(letter).collect()
}

/// Whether a name is one letter, without accents and scripts.
fn is_letter(name: &str) -> bool {
    let greek = |name: &str| name.chars().all(|c| c.is_ascii_alphabetic());
    name.len() == 1 || name.strip_prefix('\\').is_some_and(greek)
}
