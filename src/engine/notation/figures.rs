//! Terms made of figures: numbers, π and units of the SI.

use crate::algebra::{Expr, Symbol};

/// Whether a term is made of numbers, units and π alone.
pub(crate) fn is_figures(term: &Expr) -> bool {
    let is_figure = |own: &Symbol| own.is_unit() || own.name() == "\\pi";
    term.free_symbols().iter().all(is_figure)
}

/// Whether a unit stands in a term.
pub(crate) fn has_units(term: &Expr) -> bool {
    term.free_symbols().iter().any(Symbol::is_unit)
}

/// Whether a decimal stands in a term; a root has none in its exponent.
pub(crate) fn has_decimals(term: &Expr) -> bool {
    match term {
        Expr::Number(own) => !own.is_integer(),
        Expr::Power(base, _) => has_decimals(base),
        own => own.children().any(has_decimals),
    }
}

/// A term with its units left out, for figures are in those of the SI.
pub(crate) fn in_si(term: &Expr) -> Expr {
    let units: Vec<Symbol> = term
        .free_symbols()
        .into_iter()
        .filter(Symbol::is_unit)
        .collect();
    let one = Expr::integer(1);
    units
        .iter()
        .fold(term.clone(), |term, unit| term.substitute(unit, &one))
}

/// A number without the units that stand beside it.
pub(crate) fn without_units(term: &Expr) -> Expr {
    match term {
        Expr::Product(factors) => {
            let rest: Vec<Expr> = factors
                .iter()
                .filter(|own| !has_units(own))
                .cloned()
                .collect();
            match rest.len() {
                0 => Expr::integer(1),
                1 => rest[0].clone(),
                _ => Expr::Product(rest.into()),
            }
        }
        Expr::Negate(inner) => Expr::Negate(without_units(inner).into()),
        Expr::Quotient(over, under) if is_unit(under) => without_units(over),
        own => own.clone(),
    }
}

/// Whether a term is made of units alone, with no number beside them.
fn is_unit(term: &Expr) -> bool {
    match term {
        Expr::Symbol(own) => own.is_unit(),
        Expr::Power(base, _) => is_unit(base),
        Expr::Product(factors) => factors.iter().all(is_unit),
        _ => false,
    }
}

/// The units that stand beside a number: `\mathrm{m}^3` and `\mathrm{s}^{-1}` of `2\,\mathrm{m}^3/\mathrm{s}`.
pub(crate) fn units_beside(term: &Expr) -> Option<Vec<Expr>> {
    match term {
        Expr::Product(factors) => Some(
            factors
                .iter()
                .filter(|own| has_units(own))
                .cloned()
                .collect(),
        ),
        Expr::Quotient(over, under) if is_unit(under) => {
            let mut units = units_beside(over).unwrap_or_default();
            units.push(Expr::Power(under.clone(), Expr::integer(-1).into()));
            Some(units)
        }
        Expr::Negate(inner) => units_beside(inner),
        _ => None,
    }
}

/// What so many degrees come to: `30 \pi/180`.
pub(super) fn degrees(number: Expr) -> Expr {
    let over = Expr::Product([number, Expr::symbol("\\pi")].into());
    Expr::Quotient(over.into(), Expr::integer(180).into())
}

/// Whether a term is what degrees come to.
pub(crate) fn is_degrees(term: &Expr) -> bool {
    let Expr::Quotient(over, under) = term else {
        return false;
    };
    let is_number = |factors: &[Expr]| matches!(factors, [Expr::Number(_), Expr::Symbol(_)]);
    **under == Expr::integer(180) && matches!(&**over, Expr::Product(own) if is_number(own))
}
