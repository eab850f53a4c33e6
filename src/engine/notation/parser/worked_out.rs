//! What is worked out in numbers, side after side: the units that it ends in, and where `=` says no more than that something is rounded,
//! `\frac{100.0^2 - 44.7^2}{400.0} = \frac{8002}{400} = 20.0\,\mathrm{cm}`.

use num_traits::{Signed, Zero};

use crate::algebra::{BigInt, BigRational, Expr, Function, Relation, Symbol};
use crate::interval::{Figures, Interval};
use crate::notation::{
    Link, Precision, Rounding, Side, has_decimals, has_units, in_si, is_figures, units_beside,
    without_units,
};
use crate::sorted::Map;

/// A whole number that is less says nothing of how near it is meant.
const LEAST_ROUNDED: u32 = 100;
/// Figures that are so many times what they are said to come to have other units.
const MOST_APART: u32 = 5;
/// So many decimal places are looked at.
const MOST_PLACES: usize = 30;

/// What has an uncertainty is nothing exactly, and what is worked out in numbers, `\frac{1361}{1.524^2} = 586`, is what it is rounded to.
pub(super) fn loosen(sides: &mut [Side], links: &mut [Link]) {
    for at in 1..sides.len() {
        if links[at - 1].relation != Relation::Equal {
            continue;
        }
        let share = match sides[at].rounding {
            None => share_of(&sides[at - 1..=at]),
            Some(_) => share_in_other_units(&sides[at - 1..=at]),
        };
        let Some(share) = share else { continue };
        let precision = Precision::Decimal;
        let rounding = Box::new(Rounding { share, precision });
        let before = sides[at].rounding.replace(rounding);
        if !is_rounded(&sides[at - 1..=at]) {
            sides[at].rounding = before;
        }
    }
    let is_loose = |side: &Side| {
        let rounding = side.rounding.as_ref();
        rounding.is_some_and(|own| own.precision == Precision::Stated)
    };
    for (link, pair) in links.iter_mut().zip(sides.windows(2)) {
        if link.relation == Relation::Equal && (pair.iter().any(is_loose) || is_rounded(pair)) {
            link.relation = Relation::Approximately;
        }
    }
}

/// How near a side is meant that is more than one number, and in which numbers may be rounded.
fn share_of(pair: &[Side]) -> Option<BigRational> {
    let [worked_out, result] = pair else {
        return None;
    };
    match is_figures(&result.expr) {
        true => has_decimals(&worked_out.expr)
            .then(|| share_of_figures(&result.expr))
            .flatten(),
        false => share_of_multiple(&result.expr),
    }
}

/// The same of a number that is rounded again in other units: `1.90 \cdot 10^4\,\mathrm{s} = 5.27\,\mathrm{h}`.
fn share_in_other_units(pair: &[Side]) -> Option<BigRational> {
    let [one, other] = pair else {
        return None;
    };
    let (own, last) = (one.rounding.as_ref()?, other.rounding.as_ref()?);
    let is_decimal = |own: &Rounding| own.precision == Precision::Decimal;
    let units = scale(&one.expr).zip(scale(&other.expr));
    let differ = has_units(&one.expr) && has_units(&other.expr);
    let differ = differ && units.is_some_and(|(one, other)| one != other);
    (differ && is_decimal(own) && is_decimal(last)).then(|| &own.share + &last.share)
}

/// The same of a decimal times something, `0.882 c`.
fn share_of_multiple(term: &Expr) -> Option<BigRational> {
    let Expr::Product(factors) = term else {
        return None;
    };
    let mut numbers = factors.iter().filter_map(|own| match own {
        Expr::Number(number) => Some(number),
        _ => None,
    });
    let (Some(number), None) = (numbers.next(), numbers.next()) else {
        return None;
    };
    let digits = whole_digits(number).filter(|_| !number.is_integer())?;
    Some(BigRational::new(1.into(), digits * 2))
}

/// The digits of a number as a whole one; nothing of what is no decimal, `\frac{1}{3}`.
fn whole_digits(number: &BigRational) -> Option<BigInt> {
    let mut digits = number.abs();
    let ten = BigRational::from_integer(10.into());
    let mut places = 0;
    while !digits.is_integer() && places < MOST_PLACES {
        (digits, places) = (digits * &ten, places + 1);
    }
    digits.is_integer().then(|| digits.to_integer())
}

/// How near what is made of figures is meant where the longest of them, `8002` in `\frac{8002}{400}`, is rounded; nothing of numbers that
/// say less.
fn share_of_figures(term: &Expr) -> Option<BigRational> {
    if matches!(term, Expr::Number(_)) {
        return None;
    }
    let mut longest = BigInt::zero();
    collect_digits(term, &mut longest);
    (longest >= BigInt::from(LEAST_ROUNDED)).then(|| BigRational::new(1.into(), longest * 2))
}

/// The greatest of the whole numbers that the digits of a term's numbers make, without noughts at the end.
fn collect_digits(term: &Expr, longest: &mut BigInt) {
    match term {
        Expr::Number(own) => {
            let digits = whole_digits(own).unwrap_or_default().to_string();
            let written = digits.trim_end_matches('0').parse().unwrap_or_default();
            *longest = longest.clone().max(written);
        }
        // What stands in an exponent counts nothing.
        Expr::Power(base, _) => collect_digits(base, longest),
        own => own
            .children()
            .for_each(|part| collect_digits(part, longest)),
    }
}

/// What is worked out in numbers alone has the units in which it ends, `x = \frac{20 \cdot 30}{30 - 20} = \frac{600}{10} = 60\,\mathrm{cm}`; where it is
/// nearer to the end in units of the SI, `\frac{6.63 \cdot 3.00}{1.60} \cdot 10^{-7} = 1240\,\mathrm{nm}`, it has these.
pub(super) fn lend_units(sides: &mut [Side]) {
    let Some((last, before)) = sides.split_last_mut() else {
        return;
    };
    let Some(units) = units_beside(&last.expr) else {
        return;
    };
    // `\frac{1}{200}\,\mathrm{mm}^{-1}` is a number, too.
    let is_fraction = |own: &Expr| match own {
        Expr::Quotient(over, under) => {
            matches!((&**over, &**under), (Expr::Number(_), Expr::Number(_)))
        }
        _ => false,
    };
    let begins_with_fraction = match &last.expr {
        Expr::Product(factors) => factors.first().is_some_and(is_fraction),
        _ => false,
    };
    if last.rounding.is_none() && !begins_with_fraction {
        return;
    }
    let scale = scale(&last.expr);
    let bare = value(&without_units(&last.expr)).map(|own| own.abs());
    let (Some(scale), Some(bare)) = (scale, bare) else {
        return;
    };
    let is_worked_out = |side: &&mut Side| {
        let is_number = matches!(side.expr, Expr::Number(_));
        !is_number && is_figures(&with_exponentials(&side.expr)) && !has_units(&side.expr)
    };
    for side in before.iter_mut().rev().take_while(is_worked_out) {
        let Some(found) = value(&with_exponentials(&side.expr)).map(|own| own.abs()) else {
            return;
        };
        let as_they_stand = apart_by(&found, bare.high());
        let in_si = apart_by(&found, &(bare.high() * &scale));
        let mut factors = vec![side.expr.clone()];
        // What is far from either is in other units than these, or wrong.
        let is_far = |own: &BigRational| *own > BigRational::from_integer(MOST_APART.into());
        match as_they_stand.zip(in_si) {
            Some((own, si)) if is_far((&own).min(&si)) => return,
            Some((own, si)) if own <= si => {}
            Some(_) => factors.push(Expr::Number(scale.recip())),
            None => return,
        }
        factors.extend(units.iter().cloned());
        side.expr = Expr::Product(factors.into());
    }
}

/// A term with `e^{-1/0.47}` as what it must be: no charge is raised to such a power.
fn with_exponentials(term: &Expr) -> Expr {
    match term {
        Expr::Power(base, exponent)
            if matches!(&**base, Expr::Symbol(own) if own.name() == "e")
                && is_figures(exponent)
                && !has_units(exponent)
                && has_decimals(exponent) =>
        {
            Expr::Call(Function::Exp, exponent.clone())
        }
        own => own.map_children(with_exponentials),
    }
}

/// By how much the greater of two values exceeds the lesser, as a multiple of that.
fn apart_by(one: &Interval, other: &BigRational) -> Option<BigRational> {
    let one = one.high();
    if one.is_zero() || other.is_zero() {
        return None;
    }
    let quotient = one / other;
    let inverse = quotient.recip();
    Some(quotient.max(inverse))
}

/// Whether a side is a number that the side before comes to when it is rounded, and is not that number.
fn is_rounded(pair: &[Side]) -> bool {
    let [worked_out, result] = pair else {
        return false;
    };
    let Some(rounding) = &result.rounding else {
        return false;
    };
    if matches!(worked_out.expr, Expr::Number(_) | Expr::Symbol(_)) {
        return false;
    }
    if !is_figures(&result.expr) {
        return is_rounded_multiple(&worked_out.expr, &result.expr, &rounding.share);
    }
    // Of a whole number all digits are meant.
    let size = match without_units(&result.expr) {
        Expr::Negate(inner) => (*inner).clone(),
        own => own,
    };
    let share = match (rounding.precision, size) {
        (Precision::Whole, Expr::Number(whole)) if !whole.is_zero() => {
            let own = (whole.abs() * BigRational::from_integer(2.into())).recip();
            own.min(rounding.share.clone())
        }
        (Precision::Whole, _) => return false,
        _ => rounding.share.clone(),
    };
    let (one, other) = (has_units(&worked_out.expr), has_units(&result.expr));
    // Who writes `7 \pi = 22` means it.
    let measured = one || other || has_decimals(&worked_out.expr);
    if rounding.precision == Precision::Whole && !measured {
        return false;
    }
    // `\frac{320 \cdot 480}{800} = 192\,\Omega` leaves the units out until the end.
    let both = |side: &Side| match one == other {
        true => value(&side.expr),
        false => value(&without_units(&side.expr)),
    };
    let (Some(found), Some(result)) = (both(worked_out), both(result)) else {
        return false;
    };
    let difference = (&found - &result).abs();
    !difference.high().is_zero() && *difference.high() <= result.abs().high() * share
}

/// How great the units beside a number are in those of the SI.
fn scale(term: &Expr) -> Option<BigRational> {
    let units = units_beside(term)?;
    Some(value(&Expr::Product(units.into()))?.high().clone())
}

/// Whether a term is the same number of times something that the result is when it is rounded: `\frac{1.2 c}{1.36}`, `0.882 c`.
fn is_rounded_multiple(worked_out: &Expr, result: &Expr, share: &BigRational) -> bool {
    if !has_decimals(result) {
        return false;
    }
    let both = multiple(worked_out).zip(multiple(result));
    both.is_some_and(|((found, of), (result, own))| {
        let difference = (&found - &result).abs();
        of == own
            && !difference.high().is_zero()
            && *difference.high() <= result.abs().high() * share
    })
}

/// A term as a number of times a product of powers of symbols; nothing where it is more than that.
fn multiple(term: &Expr) -> Option<(Interval, Map<Symbol, BigRational>)> {
    if is_figures(term) && !has_units(term) {
        return Some((value(term)?, Map::new()));
    }
    let one = || BigRational::from_integer(1.into());
    let times = |own: &mut Map<Symbol, BigRational>, of: Map<Symbol, BigRational>, sign: i32| {
        for (symbol, exponent) in of {
            let exponent = exponent * BigRational::from_integer(sign.into());
            let sum = own
                .get(&symbol)
                .map_or(exponent.clone(), |own| own + &exponent);
            own.insert(symbol, sum);
        }
        own.retain(|_, exponent| !exponent.is_zero());
    };
    match term {
        Expr::Symbol(own) if !own.is_unit() => Some((
            Interval::exactly(one()),
            Map::from_iter([(own.clone(), one())]),
        )),
        Expr::Negate(inner) => multiple(inner).map(|(number, of)| (-&number, of)),
        Expr::Product(factors) => {
            let mut all = (Interval::exactly(one()), Map::new());
            for factor in factors.iter() {
                let (number, of) = multiple(factor)?;
                all.0 = &all.0 * &number;
                times(&mut all.1, of, 1);
            }
            Some(all)
        }
        Expr::Quotient(over, under) => {
            let ((above, mut of), (below, by)) = (multiple(over)?, multiple(under)?);
            times(&mut of, by, -1);
            Some((above.over(&below)?, of))
        }
        Expr::Power(base, exponent) => {
            let Expr::Number(exponent) = &**exponent else {
                return None;
            };
            let (number, mut of) = multiple(base)?;
            of.values_mut().for_each(|own| *own *= exponent);
            Some((number.power(exponent)?, of))
        }
        _ => None,
    }
}

/// The value of what is made of figures.
fn value(term: &Expr) -> Option<Interval> {
    is_figures(term).then(|| Figures::default().value(&in_si(term)).ok())?
}
