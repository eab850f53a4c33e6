//! Numbers that were rounded on the way: `L = \frac{400}{96.04} (10.002 - 2.0)` where a root comes to 10.00199….
//!
//! What is calculated from such numbers is as near as they are, and no nearer.

use num_traits::{One, Zero};

use crate::algebra::{BigInt, BigRational, Expr, Formula, Relation, Symbol};
use crate::derivation::{Assumed, Goal, Source};
use crate::interval::{Figures, Interval};
use crate::notation::{Precision, Rounding, is_figures};
use crate::sorted::Map;

use super::is_evaluable;
use super::rounded::is_quantity;

/// A number with fewer digits is seldom rounded on the way: `0.5`.
pub(super) const FEWEST_DIGITS: usize = 3;

/// One in so many is as near as anything is weighed.
const NEAREST: i64 = 1_000_000;

/// A goal whose right side is calculated from decimals that nobody told, taken for as near as these are.
pub(super) fn as_near_as_decimals(goal: &Goal, source: &str, assumed: &[Assumed]) -> Option<Goal> {
    let Formula::Relation {
        relation: Relation::Equal,
        right,
        ..
    } = &goal.formula
    else {
        return None;
    };
    let is_calculated = is_figures(right) && is_evaluable(right);
    if goal.rounding.is_some() || !is_calculated || is_quantity(goal) {
        return None;
    }
    let text = source.get(goal.sides.1.range())?;
    let mut written = decimals(text, FEWEST_DIGITS);
    let is_told = |number: &Expr| {
        let told = assumed
            .iter()
            .filter(|own| matches!(own.source, Source::Local(..)));
        let mut terms = told.flat_map(|own| own.formula.terms());
        terms.any(|term| term.any(&|part| part == number))
    };
    written.retain(|value, _| !is_told(&Expr::Number(value.clone())));
    let mut figures = Vec::new();
    let loose = loosened(right, &written, &mut figures)?;
    let value = Figures::from_iter(figures).value(&loose).ok()?;
    let (low, high) = (value.low(), value.high());
    let (two, sum) = (BigRational::from_integer(2.into()), low + high);
    let is_wide = sum.is_zero() || *low <= BigRational::zero() && *high >= BigRational::zero();
    if is_wide {
        return None;
    }
    let middle = Interval::new(&sum / &two, &sum / &two)?.abs();
    let share = (high - low) / &two / middle.high();
    // Roots and the like are bounded no nearer.
    let share = share.max(BigRational::new(1.into(), NEAREST.into()));
    let rounding = Some(Rounding {
        share,
        precision: Precision::Decimal,
    });
    Some(Goal {
        rounding,
        ..goal.clone()
    })
}

/// A term with symbols for numbers that may be rounded. What these may be, with half a unit of their last digits, comes to the figures, and
/// the units in the term do: they are those of the SI.
pub(super) fn loosened(
    term: &Expr,
    rounded: &Map<BigRational, BigRational>,
    figures: &mut Vec<(Symbol, Interval)>,
) -> Option<Expr> {
    let mut loose = term.clone();
    for (value, half) in rounded {
        let symbol = Symbol::new(format!("\\decimal{{{}}}", figures.len()));
        loose = loose.replace(&Expr::Number(value.clone()), &Expr::Symbol(symbol.clone()));
        figures.push((symbol, Interval::new(value - half, value + half)?));
    }
    let units = term.free_symbols().into_iter().filter(Symbol::is_unit);
    figures.extend(units.map(|unit| (unit, Interval::exactly(BigRational::one()))));
    Some(loose)
}

/// The decimals in a text that may be rounded, with the fewest digits or more, each with half a unit of its last digit.
pub(super) fn decimals(text: &str, fewest: usize) -> Map<BigRational, BigRational> {
    let is_part = |c: char| c.is_ascii_digit() || c == '.';
    let mut found = Map::new();
    for number in text.split(|c: char| !is_part(c)) {
        let Some((whole, decimals)) = number.split_once('.') else {
            continue;
        };
        let digits = format!("{whole}{decimals}");
        let significant = digits.trim_start_matches('0').len();
        let (Ok(value), Ok(places)) = (digits.parse::<BigInt>(), u32::try_from(decimals.len()))
        else {
            continue;
        };
        if significant < fewest || decimals.is_empty() {
            continue;
        }
        let unit = BigInt::from(10).pow(places);
        let half = BigRational::new(1.into(), BigInt::from(2) * &unit);
        found.insert(BigRational::new(value, unit), half);
    }
    found
}
