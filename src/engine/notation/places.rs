//! Terms that say where something is: `w(L)`, `v(L/2)`, `u(1\,\mathrm{s})`.

use crate::algebra::{Expr, Symbol, split_subscript};

/// Whether a symbol in parentheses rather names a place than what varies: `w(L)`, `v(t_0)`, `f(a)`.
pub(crate) fn names_a_place(symbol: &Symbol) -> bool {
    let name = symbol.name();
    let is_large = name.starts_with(|first: char| first.is_ascii_uppercase());
    is_large || split_subscript(name).is_some() || matches!(name, "a" | "b" | "\\ell")
}

/// Whether a term of more than one symbol is such a place: a part or a multiple of one, `L/2`, or a number with its unit. What is added may be
/// the other factor of a product, `N (K - N)`.
pub(crate) fn is_composed_place(term: &Expr) -> bool {
    let is_constant = |own: &Symbol| own.is_unit() || own.name() == "\\pi" || names_a_place(own);
    let is_plain = |part: &Expr| {
        matches!(
            part,
            Expr::Number(_) | Expr::Symbol(_) | Expr::Product(_) | Expr::Quotient(..)
        ) || matches!(part, Expr::Power(_, exponent) if matches!(**exponent, Expr::Number(_)))
    };
    let is_composed = matches!(term, Expr::Product(_) | Expr::Quotient(..));
    is_composed && !term.any(&|part| !is_plain(part)) && term.free_symbols().iter().all(is_constant)
}
