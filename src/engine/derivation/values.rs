//! What the text says that a symbol is the value of: `v(0) = v_0`, "$q = q_0$ at $t = 0$".

use crate::algebra::{Expr, Formula, Symbol};
use crate::document::{Document, Span};
use crate::notation::read_formulas;

use super::Derivation;
use super::equation::formulas;

/// More pieces of mathematics in the text than this are not looked through.
const MOST_SAID: usize = 500;
/// The words between a relation and the place where it is so.
const AT: [&str; 6] = ["at", "at time", "at the time", "for", "when", "where"];

/// The value of something at a place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ValueSaid {
    /// What has the value.
    pub of: Symbol,
    /// What is a number at the place, where that is said.
    pub variable: Option<Symbol>,
    /// The number.
    pub place: Expr,
}

impl Derivation {
    /// What the text of a page says that a symbol is the value of. `None` where it says something of the symbol that is no such thing,
    /// or too much to look through.
    pub fn values_said(&self, page: usize, symbol: &Symbol) -> Option<Vec<ValueSaid>> {
        let document = &self.pages[page].document;
        if document.inline().count() > MOST_SAID {
            return None;
        }
        let said = |body: Span| -> Vec<Formula> {
            let read = read_formulas(&document.source, body).unwrap_or_default();
            read.iter().flat_map(formulas).collect()
        };
        let all: Vec<Span> = document.inline().map(|math| math.body).collect();
        let mut values = Vec::new();
        for (at, &body) in all.iter().enumerate() {
            for formula in said(body) {
                if !formula.names().contains(symbol) {
                    continue;
                }
                let before = at.checked_sub(1).map(|at| all[at]);
                let place = || match all.get(at + 1) {
                    Some(&next) if comes_at(document, body, next) => Some(said(next)),
                    _ => before.filter(|&own| goes_on(document, own, body)).map(said),
                };
                values.push(
                    value(&formula, symbol).or_else(|| value_at(&formula, symbol, &place()?))?,
                );
            }
        }
        Some(values)
    }
}

/// `v(0) = v_0`.
fn value(formula: &Formula, symbol: &Symbol) -> Option<ValueSaid> {
    match formula.as_equation()? {
        (Expr::Apply(name, arguments), Expr::Symbol(own)) if own == symbol => {
            let [place @ Expr::Number(_)] = arguments.as_slice() else {
                return None;
            };
            Some(ValueSaid {
                of: name.clone(),
                variable: None,
                place: place.clone(),
            })
        }
        _ => None,
    }
}

/// `q = q_0`, where something is a number.
fn value_at(formula: &Formula, symbol: &Symbol, place: &[Formula]) -> Option<ValueSaid> {
    let [place] = place else {
        return None;
    };
    match (formula.as_equation()?, place.as_equation()?) {
        (
            (Expr::Symbol(name), Expr::Symbol(own)),
            (Expr::Symbol(variable), place @ Expr::Number(_)),
        ) if own == symbol => Some(ValueSaid {
            of: name.clone(),
            variable: Some(variable.clone()),
            place: place.clone(),
        }),
        _ => None,
    }
}

/// "$q = q_0$ at $t = 0$".
fn comes_at(document: &Document, body: Span, place: Span) -> bool {
    let between = document
        .source
        .get(body.end..place.start)
        .unwrap_or_default();
    let words = between.trim_matches(|c: char| !c.is_alphabetic());
    AT.iter().any(|own| own.eq_ignore_ascii_case(words))
}

/// "At $t = 0$ the charge is $q = q_0$": one sentence, which begins with the place.
fn goes_on(document: &Document, place: Span, body: Span) -> bool {
    let between = document
        .source
        .get(place.end..body.start)
        .unwrap_or_default();
    let before = document.source.get(..place.start).unwrap_or_default();
    let word = before.trim_end_matches(|c: char| !c.is_alphabetic());
    let word = word.rsplit(|c: char| !c.is_alphabetic()).next();
    let begins = word.is_some_and(|word| ["At", "at", "When", "when", "time"].contains(&word));
    begins && !between.contains(['.', ';', '?'])
}
