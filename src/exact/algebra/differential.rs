//! Differentials: `dU`, the rate of `U` along any change.

use super::{Expr, Symbol};

/// By what a change is followed of which nobody says by what. No name that is read is this one.
const CHANGE: &str = "\\mathrm{d}";

impl Symbol {
    /// By what differentials differentiate.
    pub fn change() -> Symbol {
        Symbol::new(CHANGE)
    }

    /// Whether it is that by which differentials differentiate.
    pub fn is_change(&self) -> bool {
        self.name() == CHANGE
    }
}

impl Expr {
    /// Its differential.
    pub fn differential(self) -> Expr {
        self.differentiated_by(&Symbol::change())
    }

    /// What it is the differential of.
    pub fn as_differential(&self) -> Option<&Expr> {
        match self {
            Expr::Derivative { body, variable } if variable.is_change() => Some(body),
            _ => None,
        }
    }
}
