//! Rational functions as terms again: the way back from [`Lowering`](super::Lowering).

use super::{
    Atom, Atoms, BigRational, Expr, Fraction, Polynomial, Rational, Symbol, element_symbol,
};

/// A polynomial as a term, in an order that depends on names alone.
pub fn expr_of(polynomial: &Polynomial, atoms: &Atoms) -> Expr {
    let mut terms: Vec<(std::cmp::Reverse<u32>, Vec<Expr>, Rational)> = polynomial
        .terms()
        .map(|(monomial, coefficient)| {
            let powers = monomial.powers().iter();
            let mut factors: Vec<Expr> = powers
                .map(|&(var, exponent)| expr_of_power(atoms.atom(var), exponent))
                .collect();
            factors.sort();
            (
                std::cmp::Reverse(monomial.degree()),
                factors,
                coefficient.clone(),
            )
        })
        .collect();
    terms.sort();
    let mut written: Vec<Expr> = terms
        .into_iter()
        .map(|(_, mut factors, coefficient)| {
            if !coefficient.abs().is_one() || factors.is_empty() {
                factors.insert(0, Expr::Number(coefficient.abs().to_big()));
            }
            let product = product_of(factors);
            match coefficient.is_negative() {
                true => Expr::Negate(product.into()),
                false => product,
            }
        })
        .collect();
    match written.len() {
        0 => Expr::integer(0),
        1 => written.remove(0),
        _ => Expr::Sum(written.into()),
    }
}

/// A rational function as a term, in an order that depends on names alone.
pub fn expr_of_fraction(value: &Fraction, atoms: &Atoms) -> Expr {
    let above = expr_of(value.numerator(), atoms);
    let mut below: Vec<Expr> = value
        .denominator()
        .map(|(factor, exponent)| {
            let vars = factor.vars();
            match vars.len() == 1 && *factor == Polynomial::var(vars[0]) {
                true => expr_of_power(atoms.atom(vars[0]), exponent),
                false => raised(expr_of(factor, atoms), exponent),
            }
        })
        .collect();
    below.sort();
    match below.is_empty() {
        true => above,
        false => Expr::Quotient(above.into(), product_of(below).into()),
    }
}

/// The term that an atom stands for.
pub fn expr_of_atom(atom: &Atom) -> Expr {
    match atom {
        Atom::Symbol(symbol) => Expr::Symbol(symbol.clone()),
        Atom::Element { sequence, position } => Expr::Symbol(element_symbol(sequence, *position)),
        Atom::Bound { sequence, index } => Expr::Element {
            sequence: sequence.clone(),
            index: index.clone(),
        },
        Atom::PowerSum { to, powers } => {
            let index = Symbol::new("i");
            let elements = powers.iter().map(|(sequence, exponent)| {
                let element = Expr::Element {
                    sequence: sequence.clone(),
                    index: index.clone(),
                };
                raised(element, *exponent)
            });
            Expr::Series {
                from: Expr::integer(1).into(),
                to: Expr::Symbol(to.clone()).into(),
                body: product_of(elements.collect()).into(),
                index: index.clone(),
            }
        }
        Atom::Root { of, order } => power_of_root(of, *order, 1),
        Atom::Opaque(expr) => expr.clone(),
    }
}

/// A power of an unknown as a term.
fn expr_of_power(atom: &Atom, exponent: u32) -> Expr {
    match atom {
        Atom::Root { of, order } => power_of_root(of, *order, exponent),
        atom => raised(expr_of_atom(atom), exponent),
    }
}

/// `r^e`, for the root `r` of a symbol, as a power of the symbol.
fn power_of_root(of: &Symbol, order: u32, exponent: u32) -> Expr {
    let exponent = BigRational::new(exponent.into(), order.into());
    let symbol = Expr::Symbol(of.clone());
    match exponent == BigRational::from_integer(1.into()) {
        true => symbol,
        false => Expr::Power(symbol.into(), Expr::Number(exponent).into()),
    }
}

/// A power, the first one without its exponent.
pub fn raised(base: Expr, exponent: u32) -> Expr {
    match exponent {
        1 => base,
        _ => Expr::Power(
            base.into(),
            Expr::Number(BigRational::from_integer(exponent.into())).into(),
        ),
    }
}

/// A product; one factor is itself.
pub fn product_of(mut factors: Vec<Expr>) -> Expr {
    match factors.len() {
        0 => Expr::integer(1),
        1 => factors.remove(0),
        _ => Expr::Product(factors.into()),
    }
}
