//! Capital letters that stand above a name and tell several of its kind apart: the profits `\pi^C`, `\pi^D` and `\pi^N` of three cases.
//!
//! They are spelt as powers are. Two such letters above one name, neither of which the page speaks of in any other way, number nothing and
//! are no exponents; so they are a part of the name.

use crate::algebra::{Expr, Symbol, split_subscript};
use crate::notation::with_subscript;
use crate::sorted::{Map, Set};

use super::Equation;
use super::equation::{all_terms, map_terms};
use super::page::Page;

/// So many letters above one name are no coincidence.
const SEVERAL: usize = 2;

/// Makes names of what such letters stand above.
pub(super) fn read_cases(page: &mut Page, equations: &mut [Equation]) {
    let mut found = Found::default();
    for term in all_terms(page, equations) {
        found.see(term);
    }
    let letters: Set<Symbol> = found.raised.iter().map(|own| own.1.clone()).collect();
    let is_known = |own: &&Symbol| {
        found.standing.contains(*own) || page.is_declared(own) || is_named(page, own)
    };
    let known: Set<Symbol> = letters.iter().filter(is_known).cloned().collect();
    found.raised.retain(|(_, letter)| !known.contains(letter));
    let mut above: Map<Symbol, usize> = Map::new();
    for (name, _) in found.raised.iter() {
        *above.entry(name.clone()).or_insert(0) += 1;
    }
    found
        .raised
        .retain(|(name, _)| above.get(name) >= Some(&SEVERAL));
    if !found.raised.is_empty() {
        map_terms(page, equations, |term| as_names(term, &found.raised));
    }
}

/// The letters of a page.
#[derive(Default)]
struct Found {
    /// The capital ones that stand above a name by themselves.
    raised: Set<(Symbol, Symbol)>,
    /// What stands anywhere else.
    standing: Set<Symbol>,
}

impl Found {
    fn see(&mut self, term: &Expr) {
        match (term, case(term)) {
            (_, Some((name, letter))) => {
                self.raised.insert((name.clone(), letter.clone()));
                self.standing.insert(name.clone());
            }
            // `DWL` is likely a word.
            (Expr::Product(factors), None) if factors.iter().all(is_capital) => {}
            (Expr::Symbol(own), None) => {
                self.standing.insert(own.clone());
            }
            _ => term.children().for_each(|child| self.see(child)),
        }
    }
}

/// A name and the capital letter that stands above it.
fn case(term: &Expr) -> Option<(&Symbol, &Symbol)> {
    let Expr::Power(base, exponent) = term else {
        return None;
    };
    let (Expr::Symbol(name), Expr::Symbol(letter)) = (&**base, &**exponent) else {
        return None;
    };
    (is_capital(exponent) && !name.name().contains('^')).then_some((name, letter))
}

fn is_capital(term: &Expr) -> bool {
    matches!(term, Expr::Symbol(own) if matches!(own.name().as_bytes(), [b'A'..=b'Z']))
}

/// `\pi_1^C`, spelt as other marks above a name are.
fn named(name: &Symbol, letter: &Symbol) -> Symbol {
    Symbol::new(match split_subscript(name.name()) {
        Some((stem, below)) => with_subscript(&format!("{stem}^{letter}"), below),
        None => format!("{name}^{letter}"),
    })
}

fn as_names(term: &Expr, raised: &Set<(Symbol, Symbol)>) -> Expr {
    match case(term) {
        Some((name, letter)) if raised.contains(&(name.clone(), letter.clone())) => {
            Expr::Symbol(named(name, letter))
        }
        _ => term.map_children(|child| as_names(child, raised)),
    }
}

/// Whether the text speaks of a letter by itself: "to the power $N$".
fn is_named(page: &Page, letter: &Symbol) -> bool {
    let document = &page.document;
    let mut inline = document.prose().flat_map(|prose| &prose.math);
    inline.any(|math| document.text(math.body).trim() == letter.name())
}
