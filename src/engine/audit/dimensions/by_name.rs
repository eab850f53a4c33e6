//! What a text calls by the names of quantities, "a rod of length $L$", and letters that stand for constants of nature where it speaks of them.

use crate::algebra::{Base, Dimension, Expr, Formula, Symbol};
use crate::derivation::Derivation;
use crate::dimension::named;
use crate::notation::read_symbol;

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

/// A letter of a constant of nature: its name, that of what it is measured in, and words without one of which something else is meant.
struct Letter(
    &'static [&'static str],
    &'static str,
    &'static str,
    &'static [&'static str],
);

#[rustfmt::skip]
static LETTERS: &[Letter] = &[
    Letter(&["\\hbar"], "the reduced Planck constant", "action", &[]),
    Letter(&["k_B", "k_{\\text{B}}"], "the Boltzmann constant", "boltzmann constant", &[]),
    Letter(&["\\epsilon_0", "\\varepsilon_0"], "the electric constant", "permittivity", &[]),
    Letter(&["\\mu_0"], "the magnetic constant", "permeability", &["magnet", "current", "coil"]),
    Letter(&["G"], "the gravitational constant", "gravitational constant", &["gravit", "planet", "star", "solar", "galax", "orbit"]),
    Letter(&["g"], "the acceleration of gravity", "acceleration", &["gravit", "weight", "pendulum", "fall", "buoyan", "hydrostatic"]),
    Letter(&["c"], "the speed of light", "velocity", &["light", "photon", "relativ", "radiat"]),
    Letter(&["e"], "the elementary charge", "charge", &["electron", "ions", "plasma", "proton"]),
    Letter(&["m_e", "m_{\\text{e}}"], "the mass of the electron", "mass", &["electron"]),
    Letter(&["R"], "the gas constant", "gas constant", &["ideal gas", "gas constant", "mole"]),
];

/// Whether a page measures in units in which what it compares may be a number: "in units in which $c = 1$".
pub(super) fn chooses_units(derivation: &Derivation, page: usize) -> bool {
    let page = &derivation.pages[page];
    let text = page.document.source.to_lowercase();
    let is_set = |own: &Formula| {
        matches!(own.as_equation(), Some((Expr::Symbol(symbol), value)) if *value == Expr::integer(1)
            && matches!(page.quantities.get(symbol), Some(Some(_))))
    };
    CHOOSING.iter().any(|words| text.contains(words))
        || page
            .locals
            .iter()
            .any(|local| local.formulas.iter().any(|own| is_set(own)))
}

/// What dots are rates by, where nothing says otherwise.
pub(super) fn time() -> (Symbol, Measured) {
    let measured = Measured {
        dimension: Dimension::base(Base::Time),
        by: Tells::Rates,
    };
    (Symbol::new("t"), measured)
}

/// What a page calls by the names of quantities, and constants of nature.
pub(super) fn by_name(derivation: &Derivation, page: usize) -> Vec<(Symbol, Measured)> {
    let page = &derivation.pages[page];
    let mut found = Vec::new();
    for (symbol, quantity) in page.quantities.iter() {
        if let Some(quantity) = quantity
            && let Some(dimension) = named(quantity.name)
        {
            let by = Tells::Name(*quantity);
            found.push((symbol.clone(), Measured { dimension, by }));
        }
    }
    let text = page.document.source.to_lowercase();
    for Letter(letters, name, of, words) in LETTERS {
        for letter in *letters {
            if let Ok(symbol) = read_symbol(letter)
                && (words.is_empty() || words.iter().any(|word| text.contains(word)))
                && !page.quantities.contains_key(&symbol)
                && let Some(dimension) = named(of)
            {
                let by = Tells::Letter(name);
                found.push((symbol, Measured { dimension, by }));
            }
        }
    }
    found
}
