//! Names that may be no numbers: vectors, by an arrow or bold type, and what bears a hat.
//!
//! Sums of vectors, their multiples by numbers, derivatives and integrals obey the rules of numbers: what follows for numbers from
//! equations between such terms follows for each component. Products, powers and magnitudes do not, so they are refused.
//! A hat may be that of an estimate, a unit vector or an operator: products of two different names with one are refused.

use super::{Factor, Parser, Read, refuse_with};
use crate::algebra::{Expr, Symbol};
use crate::document::Span;
use crate::sorted::Set;

const VECTORS: &[&str] = &["\\vec{", "\\mathbf{", "\\boldsymbol{", "\\bm{"];
const HATS: &[&str] = &["\\hat{", "\\widehat{"];
const HELP: &str = "write it in components, or give magnitudes names of their own";

/// What the factors of a product so far bear.
#[derive(Default)]
pub(super) struct Borne {
    vector: bool,
    hats: Set<Symbol>,
}

impl Borne {
    /// Takes one more factor, which a `\times` may stand before, unless the order or the kind of the product would matter.
    pub(super) fn join(&mut self, factor: &Factor, times: Option<Span>) -> Read<()> {
        let mut next = Borne::default();
        next.look(&factor.expr);
        if self.is_any() && next.is_any() {
            let vector = self.vector || next.vector;
            if let Some(sign) = times {
                let message = "`\\times` between vectors does not commute, so it is not read as a product of numbers";
                return refuse_with(sign, message, HELP);
            }
            if vector {
                let message =
                    "products of vectors do not obey the rules of numbers, so they are not read";
                return refuse_with(factor.span, message, HELP);
            }
            if next.hats.len() > 1 || self.hats != next.hats {
                let message = "what bears a hat may be an operator or a unit vector, so this may not be a product of numbers";
                let help = "give numbers names without hats";
                return refuse_with(factor.span, message, help);
            }
        }
        self.vector |= next.vector;
        self.hats.append(&mut next.hats);
        Ok(())
    }

    /// What is divided by: hats are joined, for nothing but numbers is divided by.
    pub(super) fn divide(&mut self, by: &Factor) -> Read<()> {
        refuse_vector(&by.expr, by.span, "nothing is divided by a vector")?;
        self.look(&by.expr);
        Ok(())
    }

    fn is_any(&self) -> bool {
        self.vector || !self.hats.is_empty()
    }

    /// What a function is applied to says nothing of its value.
    fn look(&mut self, expr: &Expr) {
        match expr {
            Expr::Symbol(name) | Expr::Element { sequence: name, .. } | Expr::Apply(name, _) => {
                self.vector |= is_vector(name);
                // A mean is a number, whatever it is of.
                if bears(name, HATS) && !name.is_bracketed() {
                    self.hats.insert(name.clone());
                }
            }
            expr => expr.children().for_each(|child| self.look(child)),
        }
    }
}

fn bears(name: &Symbol, marks: &[&str]) -> bool {
    // Most names are plain letters.
    let name = name.name();
    name.contains('\\') && marks.iter().any(|mark| name.contains(mark))
}

/// Whether a name is marked as that of a vector.
pub(super) fn is_vector(name: &Symbol) -> bool {
    bears(name, VECTORS)
}

/// Refuses a term with a vector in it where numbers alone have a meaning.
pub(super) fn refuse_vector(expr: &Expr, span: Span, message: &str) -> Read<()> {
    let mut borne = Borne::default();
    borne.look(expr);
    match borne.vector {
        true => refuse_with(span, message, HELP),
        false => Ok(()),
    }
}

impl Parser<'_> {
    /// A power, of numbers alone.
    pub(super) fn power(&self, start: usize, base: Expr, exponent: Expr) -> Read<Expr> {
        let message = "powers and roots of vectors are not read";
        for part in [&base, &exponent] {
            refuse_vector(part, self.since(start), message)?;
        }
        Ok(Expr::Power(base.into(), exponent.into()))
    }
}
