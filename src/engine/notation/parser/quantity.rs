//! Numbers with units as siunitx writes them: `\qty{9.81}{m/s^2}`.
//!
//! A reader sees digits and upright letters, so neither a power nor a stroke may stand directly beside a quantity.

use super::{Factor, Kind, Parser, Read, Shape, refuse_with};
use crate::algebra::{BigRational, Expr};
use crate::notation::unit::{self, Unit};
use num_traits::{One, Signed};

impl Parser<'_> {
    /// `\qty{3}{m}`, `\num{1e3}` or `\unit{m}`.
    pub(super) fn quantity(&mut self, number: &str, of: &str) -> Read<Factor> {
        let (start, span) = (self.at, self.span());
        self.advance();
        let value = match (number, unit::number(number)) {
            ("", _) if !of.is_empty() => None,
            (_, Some(value)) => Some(value),
            (text, None) => {
                let help = "digits with a decimal point are read, and a power of ten: `1.6e-19`";
                return refuse_with(span, format!("`{text}` is not read as a number"), help);
            }
        };
        let (mut unit, last) = match unit::read_with_last(of) {
            Ok(read) => read,
            Err(message) => {
                let help = "give the quantity a name, and declare its dimension or its figures";
                return refuse_with(span, message, help);
            }
        };
        // `\mathrm{m/s}^2`
        let several = of.contains(|c: char| !c.is_alphanumeric());
        if let Some(last) = last.filter(|_| value.is_none() && several) {
            self.raise_last(&mut unit, &last)?;
        }
        let expr = product(value.as_ref(), &unit);
        if let (Expr::Symbol(_), None) = (&expr, &value) {
            return self.scripts(start, expr, Shape::Tight, false);
        }
        if matches!(self.peek(), Kind::Char('^' | '_' | '\'')) {
            let help = "put the quantity in parentheses";
            return refuse_with(self.span(), "what this belongs to is not clear", help);
        }
        let negative = value.as_ref().is_some_and(BigRational::is_negative);
        let shape = match (negative, &value) {
            (true, _) => Shape::Loose,
            (false, Some(_)) => Shape::Number,
            (false, None) => Shape::Tight,
        };
        Ok(Factor {
            expr,
            shape,
            span: self.since(start),
            braces: negative,
        })
    }
}

/// A number of a unit as a term. As `60\,\mathrm{cm}` is read, a number stands by itself before a unit that is none of the SI: what is worked out
/// in numbers alone is compared with the number as it is written.
pub(in crate::notation) fn product(value: Option<&BigRational>, unit: &Unit) -> Expr {
    let has_bases = unit.factors().next().is_some();
    let mut factors = Vec::new();
    let number = match value {
        Some(value) if has_bases && !unit.number.is_one() => {
            factors.push(Expr::Number(value.abs()));
            factors.push(product(None, unit));
            value.clone()
        }
        value => {
            let number = value.map_or_else(|| unit.number.clone(), |own| own * &unit.number);
            if value.is_some() || !number.is_one() || !has_bases {
                factors.push(Expr::Number(number.abs()));
            }
            factors.extend(unit.factors().map(|(base, power)| {
                let base = Expr::Symbol(base);
                match power {
                    1 => base,
                    power => Expr::Power(base.into(), Expr::integer(power).into()),
                }
            }));
            number
        }
    };
    let expr = match factors.len() {
        1 => factors.remove(0),
        _ => Expr::Product(factors.into()),
    };
    match number.is_negative() {
        true => Expr::Negate(expr.into()),
        false => expr,
    }
}
