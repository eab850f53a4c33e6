//! Exponentials of numbers, at points that give every symbol a rational value.
//!
//! `e^u` is transcendental for every rational `u` but 0 (Lindemann). So a polynomial in it with rational coefficients vanishes only if all of
//! them do, as one in π does, and whether an equation is true is told by its coefficients. What has a natural multiple of `u` in the
//! exponent is a power of it. Beside π, roots or functions that have values of their own nothing is said: nobody knows how `e` and π
//! belong together.

use num_integer::Integer;

use super::Reject;
use super::in_pi::InPi;
use super::witness::Point;
use crate::algebra::{Atom, BigInt, BigRational, Expr, Function, Rational};

/// Greater exponents are left alone.
const GREATEST: u32 = 16;
/// So many terms of the series of the exponential tell it to some ten digits up to that.
const TERMS: u32 = 64;

/// The number in which those values are polynomials that are not rational, where it is not π, and its bounds.
#[derive(Clone, Debug)]
pub(super) struct Unit {
    pub number: Transcendental,
    pub bounds: (Rational, Rational),
}

/// A number that is no root of any polynomial with rational coefficients.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Transcendental {
    /// `e^u`, where all exponents are multiples of `u`.
    Exponential(Rational),
    /// `\ln p`
    Logarithm(BigInt),
}

impl Point<'_> {
    /// The exponential of a term that has a positive value, as a power of that of the unit.
    pub(super) fn exponential(&mut self, argument: &Expr) -> Result<InPi, Reject> {
        let at = self.at;
        let others = !at.functions.is_empty() || !at.in_pi.is_empty() || at.algebraic.is_some();
        // An exponent in which there is an exponential is no number.
        if others || self.problem.pi_is_the_number() || self.in_exponent {
            return Err(Reject::NoValue);
        }
        let value = self.exponent(argument)?;
        let unit = match self.unit.as_ref().map(|own| &own.number) {
            Some(Transcendental::Exponential(unit)) => unit.clone(),
            Some(Transcendental::Logarithm(_)) => return Err(Reject::NoValue),
            None => self.choose_unit(value.clone())?,
        };
        let times = value / unit;
        let times = u32::try_from(times.numer())
            .ok()
            .filter(|_| times.is_integer());
        InPi::power(times.ok_or(Reject::NoValue)?)
    }

    fn exponent(&mut self, argument: &Expr) -> Result<Rational, Reject> {
        let value = self.lowered(argument)?;
        self.in_exponent = true;
        let value = self.fraction(&value);
        self.in_exponent = false;
        value?.filter(Rational::is_positive).ok_or(Reject::NoValue)
    }

    /// The greatest exponent of which all that have a value are multiples.
    fn choose_unit(&mut self, first: Rational) -> Result<Rational, Reject> {
        let exponent_of = |atom: &Atom| match atom {
            Atom::Opaque(Expr::Call(Function::Exp, argument)) => Some(argument.clone()),
            _ => None,
        };
        let all = self.atoms.iter();
        let all: Vec<_> = all.filter_map(|(_, atom)| exponent_of(atom)).collect();
        let mut unit = first;
        for argument in all {
            if let Ok(value) = self.exponent(&argument) {
                let (a, b) = (unit.numer() * value.denom(), value.numer() * unit.denom());
                let below = unit.denom() * value.denom();
                unit = BigRational::new(a.gcd(&b), below).into();
            }
        }
        let bounds = bounds(&unit).ok_or(Reject::NoValue)?;
        self.unit = Some(Unit {
            number: Transcendental::Exponential(unit.clone()),
            bounds,
        });
        Ok(unit)
    }
}

/// Between which numbers the exponential of a positive number lies: what is left of its series after the last term `a` taken is less
/// than that of the geometric one with `a q`, where `q` is what the next term is of it.
fn bounds(exponent: &Rational) -> Option<(Rational, Rational)> {
    if *exponent > Rational::from(GREATEST) {
        return None;
    }
    let (mut sum, mut term) = (Rational::one(), Rational::one());
    for k in 1..=TERMS {
        term = term * exponent.clone() / Rational::from(k);
        sum += term.clone();
    }
    let ratio = exponent.clone() / Rational::from(TERMS + 1);
    let rest = term * &ratio / (Rational::one() - ratio);
    Some((sum.clone(), sum + rest))
}
