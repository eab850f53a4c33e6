//! How near the numbers on a page are meant: a decimal is rounded in its last digit, `5.0 \pm 0.1` says how near it is.

use num_traits::{Signed, Zero};

use super::both::refuse_signs;
use super::term::counted;
use super::{Kind, Parser, Read, refuse_with};
use crate::algebra::{BigInt, BigRational, Expr};
use crate::document::Span;
use crate::notation::figures::is_degrees;
use crate::notation::{Precision, Rounding, Side, is_figures};

impl Parser<'_> {
    /// How near a side that began at `start` is meant, if it is one number, perhaps with a power of ten and units.
    pub(super) fn rounding(&self, start: usize, expr: &Expr) -> Option<Rounding> {
        let bare = match expr {
            Expr::Negate(inner) => inner,
            own => own,
        };
        let mut at = start;
        if matches!(self.kind(at), Kind::Char('-' | '+')) {
            at += 1;
        }
        if !(counted(bare) || is_degrees(bare) && self.are_degrees_at(at + 1)) {
            return None;
        }
        let text = match self.kind(at) {
            Kind::Number(text) => text,
            Kind::Quantity(text, _) => text.split(['e', 'E']).next()?,
            _ => return None,
        };
        // Another number beside it, but for a power, is one that it is multiplied with.
        let is_number = |at: usize| match self.kind(at) {
            Kind::Number("10") | Kind::Quantity("", _) => false,
            Kind::Number(_) => !self.is_raised(at),
            Kind::Quantity(..) | Kind::Char('!') => true,
            _ => false,
        };
        if (at + 1..self.at).any(is_number) {
            return None;
        }
        // Of `6 \cdot 10^{-4}` the one digit is all that is known.
        let has_power =
            |at: usize| matches!(self.kind(at), Kind::Number("10") | Kind::Quantity("", _));
        let is_scientific = text.len() == 1 && (at + 1..self.at).any(has_power);
        let rounding = rounded(text)?;
        Some(match is_scientific {
            true => Rounding {
                precision: Precision::Decimal,
                ..rounding
            },
            false => rounding,
        })
    }

    /// Whether a unit may stand after a factor: after a number, or one with its uncertainty, `(5.0 \pm 0.1)\,\mathrm{kg}`.
    pub(super) fn may_have_unit(&self, factor: &Expr) -> bool {
        let is_sum = |term: &Expr| matches!(term, Expr::Sum(terms) if terms.iter().all(counted));
        let has_signs = self.signs.as_ref().is_some_and(|signs| signs.met.is_some());
        // `\frac{4\pi \cdot 10^{-7}}{0.2}\ \mathrm{H}`, `\sqrt{2 \cdot 9.81}\ \mathrm{m/s}`
        let calculated = is_figures(factor) && factor.any(&|part| matches!(part, Expr::Number(_)));
        counted(factor) || calculated || has_signs && is_sum(factor)
    }

    /// Whether a number stands in an exponent: `^2`, `^{-19}`.
    fn is_raised(&self, at: usize) -> bool {
        let mut before = (0..at).rev().map(|at| self.kind(at));
        before
            .find(|kind| !matches!(kind, Kind::Open | Kind::Char('-')))
            .is_some_and(|kind| kind == Kind::Char('^'))
    }

    /// A value with its uncertainty, read with its upper sign from `start` on: the value, and how near it is.
    pub(super) fn with_uncertainty(&self, start: usize, upper: Side, sign: Span) -> Read<Side> {
        let is_decimal = |at: usize| match self.kind(at) {
            Kind::Number(text) | Kind::Quantity(text, _) => {
                !text.chars().all(|c| c.is_ascii_digit())
            }
            _ => false,
        };
        let has_units = |part: &Expr| matches!(part, Expr::Symbol(_));
        // `1 \pm 2` may be two roots.
        if !upper.expr.any(&has_units) && !(start..self.at).any(is_decimal) {
            return refuse_with(
                upper.span,
                "whether this is a value with its uncertainty or two values is not clear",
                "write the value alone, or a name for it",
            );
        }
        let Some((expr, share)) = apart(&upper.expr) else {
            return refuse_signs(sign);
        };
        Ok(Side {
            terms: vec![upper.span],
            expr,
            rounding: Some(Box::new(Rounding {
                share,
                precision: Precision::Stated,
            })),
            ..upper
        })
    }
}

/// Half a unit of the last digit of a number, as a share of it. Of a whole number the noughts at its end say nothing.
fn rounded(text: &str) -> Option<Rounding> {
    let is_decimal = text.contains('.') || text.contains("{,}");
    let digits: String = text.chars().filter(char::is_ascii_digit).collect();
    let (written, precision) = match is_decimal {
        true => (&*digits, Precision::Decimal),
        false => (digits.trim_end_matches('0'), Precision::Whole),
    };
    let number: BigInt = written.parse().ok()?;
    if number.is_zero() {
        return None;
    }
    let share = BigRational::new(1.into(), BigInt::from(2) * number);
    Some(Rounding { share, precision })
}

/// Whether a term is a sum of numbers, perhaps times units: `(5.0 \pm 0.1)\,\mathrm{m}`.
pub(super) fn is_measured(upper: &Expr) -> bool {
    let is_sum = |term: &Expr| matches!(term, Expr::Sum(terms) if terms.iter().all(counted));
    let product = |factors: &[Expr]| {
        let units =
            |factor: &Expr| counted(factor) && factor.any(&|part| matches!(part, Expr::Symbol(_)));
        let (sums, others): (Vec<&Expr>, Vec<&Expr>) = factors.iter().partition(|own| is_sum(own));
        sums.len() == 1 && others.iter().all(|own| counted(own)) && others.into_iter().any(units)
    };
    !upper.any(&Expr::is_root)
        && match upper {
            Expr::Product(factors) => product(factors),
            own => is_sum(own),
        }
}

/// The value in `value + spread`, perhaps times units, and what share of it the spread is.
fn apart(upper: &Expr) -> Option<(Expr, BigRational)> {
    match upper {
        Expr::Sum(terms) => {
            let [value, spread] = &terms[..] else {
                return None;
            };
            let ((number, units), (spread, of)) = (in_units(value)?, in_units(spread)?);
            let share = (units == of && !number.is_zero()).then(|| (spread / number).abs())?;
            Some((value.clone(), share))
        }
        Expr::Product(factors) => {
            let at = factors.iter().position(|own| matches!(own, Expr::Sum(_)))?;
            let (value, share) = apart(&factors[at])?;
            let mut factors = factors.to_vec();
            factors[at] = value;
            Some((Expr::Product(factors.into()), share))
        }
        _ => None,
    }
}

/// A number and the units beside it.
fn in_units(term: &Expr) -> Option<(BigRational, &[Expr])> {
    match term {
        Expr::Number(number) => Some((number.clone(), &[])),
        Expr::Negate(inner) => in_units(inner).map(|(number, units)| (-number, units)),
        Expr::Product(factors) => match factors.split_first()? {
            (Expr::Number(number), units) => Some((number.clone(), units)),
            _ => None,
        },
        _ => None,
    }
}
