//! Sums with dots whose terms are written out: `1 + 3 + 5 + \dots + (2 k - 1)`, `q + q^2 + \dots + q^n`.
//!
//! The last term says what each of them is: where a single letter in it is put to a whole number, it must become the term just before the
//! dots, and put to the numbers before that, the terms before it, two of them at least. If more than one letter will do, none does.

use num_integer::Integer;
use num_traits::{One, Pow, Signed, ToPrimitive, Zero};

use super::Term;
use crate::algebra::{BigRational, Expr, Symbol};

/// The numbers that the letter is put to.
const FIRST: i64 = -4;
const LAST: i64 = 40;
/// A single term before the dots tells no pattern.
const FEWEST: usize = 2;
/// Longer powers are not multiplied out.
const LARGEST_POWER: i64 = 64;

/// What the terms before the dots and the last one come to.
pub(super) struct Progression {
    /// The letter of the last term that stands for a whole number there.
    pub letter: Symbol,
    /// The first of these numbers.
    pub from: i64,
    /// How many terms there are before the dots.
    pub count: usize,
}

/// The progression of which the last terms before the dots are and the last one.
pub(super) fn progression(terms: &[Term], last: &Term) -> Option<Progression> {
    let signed = |term: &Term| match term.negative {
        true => Expr::Negate(term.expr.clone().into()),
        false => term.expr.clone(),
    };
    let general = signed(last);
    let letters = general.free_symbols().into_iter();
    let letters = letters.filter(|own| own.name().chars().filter(|c| *c != '\\').count() == 1);
    let before: Vec<Expr> = terms
        .iter()
        .rev()
        .take(LAST as usize)
        .map(|own| reduced(&signed(own)))
        .collect();
    let mut found = None;
    for letter in letters {
        let at = |number: i64| reduced(&general.substitute(&letter, &Expr::integer(number)));
        // `(-2)^2` is `2^2`, too, and nobody counts so.
        let ends = (0..=LAST).chain((FIRST..0).rev());
        let mut ends = ends.filter(|&number| at(number) == before[0]);
        let Some(end) = ends.next() else {
            continue;
        };
        let run = before.iter().zip((FIRST..=end).rev());
        let count = run
            .take_while(|(term, number)| at(*number) == **term)
            .count();
        if count < FEWEST {
            continue;
        }
        if found.is_some() {
            return None;
        }
        let from = end + 1 - i64::try_from(count).ok()?;
        found = Some(Progression {
            letter,
            from,
            count,
        });
    }
    found
}

/// A term with its numbers calculated and what makes no difference left out: `a + (2 - 1) d` is `a + d`.
fn reduced(term: &Expr) -> Expr {
    match term {
        Expr::Negate(inner) => match reduced(inner) {
            Expr::Number(value) => Expr::Number(-value),
            Expr::Negate(inner) => inner.as_ref().clone(),
            inner => Expr::Negate(inner.into()),
        },
        Expr::Sum(parts) => {
            let mut rest = Vec::new();
            let mut number = BigRational::zero();
            let mut parts: Vec<Expr> = parts.iter().map(reduced).collect();
            parts.retain(|part| match part {
                Expr::Number(value) => {
                    number += value;
                    false
                }
                _ => true,
            });
            rest.append(&mut parts);
            if !number.is_zero() || rest.is_empty() {
                rest.push(Expr::Number(number));
            }
            one_of(rest, |rest| Expr::Sum(rest.into()))
        }
        Expr::Product(factors) => {
            let mut number = BigRational::one();
            let mut rest = Vec::new();
            for factor in factors.iter().map(reduced) {
                match factor {
                    Expr::Number(value) => number *= value,
                    Expr::Negate(inner) => {
                        number = -number;
                        rest.push(inner.as_ref().clone());
                    }
                    factor => rest.push(factor),
                }
            }
            times(number, rest)
        }
        Expr::Quotient(above, below) => match (reduced(above), reduced(below)) {
            (Expr::Number(above), Expr::Number(below)) if !below.is_zero() => {
                Expr::Number(above / below)
            }
            (above, Expr::Number(below)) if below.is_one() => above,
            (above, below) => Expr::Quotient(above.into(), below.into()),
        },
        Expr::Power(base, exponent) => power(reduced(base), reduced(exponent)),
        other => other.map_children(reduced),
    }
}

fn power(base: Expr, exponent: Expr) -> Expr {
    let whole = match &exponent {
        Expr::Number(value) if value.is_integer() => value.to_integer().to_i64(),
        _ => None,
    };
    match (&base, whole) {
        (_, Some(0)) => Expr::integer(1),
        (_, Some(1)) => base,
        (Expr::Number(value), Some(n))
            if n.abs() <= LARGEST_POWER && (n > 0 || !value.is_zero()) =>
        {
            let size = i32::try_from(n).unwrap_or_default();
            Expr::Number(Pow::pow(value, size))
        }
        // `(-x)^2` is `x^2`.
        (Expr::Negate(inner), Some(n)) => {
            let own = power(inner.as_ref().clone(), exponent);
            match n.is_even() {
                true => own,
                false => Expr::Negate(own.into()),
            }
        }
        _ => Expr::Power(base.into(), exponent.into()),
    }
}

fn times(number: BigRational, rest: Vec<Expr>) -> Expr {
    if number.is_zero() || rest.is_empty() {
        return Expr::Number(number);
    }
    let mut factors = rest;
    let is_negative = number.is_negative();
    if !number.abs().is_one() {
        factors.insert(0, Expr::Number(number.abs()));
    }
    let product = one_of(factors, |factors| Expr::Product(factors.into()));
    match is_negative {
        true => Expr::Negate(product.into()),
        false => product,
    }
}

fn one_of(mut parts: Vec<Expr>, join: impl Fn(Vec<Expr>) -> Expr) -> Expr {
    match parts.len() {
        1 => parts.remove(0),
        _ => join(parts),
    }
}
