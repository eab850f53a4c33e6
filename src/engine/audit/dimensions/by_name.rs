//! What a text calls by the names of quantities, "a rod of length $L$", and letters that stand for constants of nature where it speaks of them.

use std::cell::LazyCell;

use crate::algebra::{Base, Dimension, Expr, Formula, Symbol};
use crate::derivation::Page;
use crate::dimension::named;
use crate::sorted::Set;

use super::super::nature::CONSTANTS;
use super::told::{Measured, Tells};

/// What who chooses units to suit says.
const CHOOSING: [&str; 7] = [
    "units in which",
    "units where",
    "units such that",
    "natural units",
    "atomic units",
    "geometric units",
    "with units",
];

/// Whether a page measures in units in which what it compares may be a number: "in units in which $c = 1$".
pub(super) fn chooses_units(page: &Page) -> bool {
    let is_set = |own: &Formula| match own.as_equation() {
        Some((Expr::Symbol(symbol), value)) => {
            *value == Expr::integer(1) && matches!(page.quantities.get(symbol), Some(Some(_)))
        }
        _ => false,
    };
    let text = page.document.source.to_lowercase();
    let mut supposed = page.locals.iter().flat_map(|local| &local.formulas);
    CHOOSING.iter().any(|words| text.contains(words)) || supposed.any(|own| is_set(own))
}

/// What dots are rates by, where nothing says otherwise.
pub(super) fn time() -> (Symbol, Measured) {
    let measured = Measured {
        dimension: Dimension::base(Base::Time),
        by: Tells::Rates,
    };
    (Symbol::new("t"), measured)
}

/// What a page calls by the names of quantities.
pub(super) fn quantities(page: &Page) -> impl Iterator<Item = (Symbol, Measured)> {
    page.quantities.iter().filter_map(|(symbol, quantity)| {
        let quantity = (*quantity)?;
        let measured = Measured {
            dimension: named(quantity.name)?,
            by: Tells::Name(quantity),
        };
        Some((symbol.clone(), measured))
    })
}

/// Which of some symbols are constants of nature, and called nothing else.
pub(super) fn constants(page: &Page, names: &Set<Symbol>) -> Vec<(Symbol, Measured)> {
    let text = LazyCell::new(|| page.document.source.to_lowercase());
    let constant = |symbol: &Symbol| {
        let mut all = CONSTANTS.iter().filter(|own| own.may_be(symbol));
        all.find_map(|own| {
            let measured = Measured {
                dimension: own.dimension_in(&text, symbol)?,
                by: Tells::Letter(own.name),
            };
            Some((symbol.clone(), measured))
        })
    };
    let others = (names.iter()).filter(|symbol| !page.quantities.contains_key(*symbol));
    others.filter_map(constant).collect()
}
