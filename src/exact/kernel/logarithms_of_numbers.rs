//! Logarithms of prime numbers, `\ln 2`: between which numbers they lie, and points at which they have values.
//!
//! The logarithm of a rational number that is positive and not 1 is transcendental (Lindemann). So a polynomial in one of them with rational
//! coefficients vanishes only if all of these do, as one in π does. How two of them belong together nobody knows but for their bounds:
//! beside another one, π, an exponential of a number or a root nothing is said.

use num_traits::ToPrimitive;

use super::exponentials::{Transcendental, Unit};
use super::in_pi::InPi;
use super::witness::Point;
use super::{Origin, Problem, Reject, Sign};
use crate::algebra::{Atom, BigInt, Expr, Function, Polynomial, Rational};

/// Logarithms of greater numbers are left alone.
const GREATEST: u32 = 1_000_000;
/// How many terms of the series of the inverse hyperbolic tangent are taken, and in which parts bounds are given. In proofs they are multiplied
/// and added to one another: there they have few digits.
const IN_PROOFS: (u32, u64) = (4, 1_000);
const AT_POINTS: (u32, u64) = (16, 1_000_000_000_000);

impl Problem {
    /// Between which numbers the logarithms of numbers lie that are spoken of, where something is to be shown: that premises contradict one
    /// another is not looked for by their digits.
    pub(super) fn add_facts_about_logarithms_of_numbers(&mut self) {
        let is_trivial = self.goal.polynomial.as_constant().is_some();
        if is_trivial && self.conditions.divisors().next().is_none() {
            return;
        }
        let found = self.atoms.iter().filter_map(|(var, atom)| match atom {
            Atom::Opaque(term) => Some((var, bounds(&logarithm_of(term)?, IN_PROOFS)?)),
            _ => None,
        });
        let found: Vec<_> = found.collect();
        for (var, (below, above)) in found {
            let own = Polynomial::var(var);
            let more = own.minus(&Polynomial::constant(below));
            let less = Polynomial::constant(above).minus(&own);
            self.add(more, Sign::Positive, Origin::Functions);
            self.add(less, Sign::Positive, Origin::Functions);
        }
    }
}

impl Point<'_> {
    /// The logarithm of a number, where all values are polynomials in it.
    pub(super) fn logarithm_of_number(&mut self, term: &Expr) -> Result<InPi, Reject> {
        let others = !self.at.in_pi.is_empty() || self.at.algebraic.is_some();
        if others || self.problem.pi_is_the_number() {
            return Err(Reject::NoValue);
        }
        let number = Transcendental::Logarithm(logarithm_of(term).ok_or(Reject::NoValue)?);
        match (&self.unit, &number) {
            (Some(unit), _) if unit.number == number => {}
            (None, Transcendental::Logarithm(of)) => {
                let bounds = bounds(of, AT_POINTS).ok_or(Reject::NoValue)?;
                self.unit = Some(Unit { number, bounds });
            }
            _ => return Err(Reject::NoValue),
        }
        InPi::power(1)
    }
}

/// The whole number of which a term is the logarithm.
fn logarithm_of(term: &Expr) -> Option<BigInt> {
    let Expr::Call(Function::Ln, of) = term else {
        return None;
    };
    match &**of {
        Expr::Number(of) if of.is_integer() => Some(of.to_integer()),
        _ => None,
    }
}

/// Between which numbers the logarithm of a number lies that is greater than 1.
fn bounds(of: &BigInt, (terms, parts): (u32, u64)) -> Option<(Rational, Rational)> {
    let of = of.to_u32().filter(|of| (2..=GREATEST).contains(of))?;
    // of = 2^m q, and q is at least 1 and less than 2.
    let twos = of.ilog2();
    let rest = Rational::from(of) / Rational::from(1_u32 << twos);
    let (two, rest) = (near(Rational::from(2), terms), near(rest, terms));
    let twos = Rational::from(twos);
    let below = &twos * two.0 + rest.0;
    let above = twos * two.1 + rest.1;
    let part = Rational::from(parts);
    let rounded = |value: &Rational| {
        let scaled = (value * &part).to_big().floor();
        Rational::from(scaled)
    };
    let one = Rational::one();
    Some((rounded(&below) / &part, (rounded(&above) + one) / &part))
}

/// The same for a number between 1 and 2: `\ln q = 2 (y + y^3/3 + \dots)` with `y = (q - 1)/(q + 1)`; what is left of the series is less than that of
/// the geometric one that begins with the next power.
fn near(number: Rational, terms: u32) -> (Rational, Rational) {
    let one = Rational::one;
    let base = (number.clone() - one()) / (number + one());
    let square = &base * &base;
    let (mut sum, mut power) = (Rational::zero(), base);
    for k in 0..terms {
        sum += power.clone() / Rational::from(2 * k + 1);
        power *= &square;
    }
    let rest = power / (one() - square);
    let two = Rational::from(2);
    (&two * &sum, two * (sum + rest))
}
