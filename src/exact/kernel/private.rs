//! Points at which sines, exponentials and logarithms have values that no rational argument gives.
//!
//! A symbol of which the claim says nothing but sines and cosines of its multiples may be any angle: for every
//! point `(c, s)` of the unit circle there is one, and with it all that differ by whole turns. So the value of the
//! symbol is left open and those of the functions are given. The same is true of `exp`, with any positive value, and
//! of `ln`, with any. That nothing else is said of the symbol needs no looking for: it has no value, and whatever
//! needs one is rejected. Bounds on it are collected and met at the end.

use std::cmp::Ordering;

use num_traits::ToPrimitive;

use super::in_pi::InPi;
use super::witness::Point;
use super::{Reject, Sign};
use crate::algebra::{
    Atom, Expr, Fraction, Function, Monomial, Polynomial, Rational, SineCosine, Symbol, Var,
    multiplied,
};

/// Multiples of the given angle or exponent are evaluated up to this.
const HIGHEST_MULTIPLE: u32 = 64;
/// After so many terms of the series of the arctangent its sums differ by less than 1/20.
const ARCTANGENT_TERMS: i32 = 9;

/// What is known of `slope · symbol`, in place of a value for the symbol.
#[derive(Clone, Debug)]
pub(super) struct Private {
    var: Var,
    slope: InPi,
    known: Known,
}

#[derive(Clone, Debug)]
enum Known {
    Angle { sine: Rational, cosine: Rational },
    Exponential(Rational),
    Logarithm(Rational),
}

/// `slope · symbol + rest` has a sign.
#[derive(Clone, Debug)]
pub(super) struct Bound {
    var: Var,
    slope: InPi,
    rest: InPi,
    sign: Sign,
}

impl Point<'_> {
    /// Takes the values of functions that the point gives.
    pub(super) fn take_functions(&mut self) -> Result<(), Reject> {
        let at = self.at;
        for (call, value) in &at.functions {
            let (function, argument) = match call {
                Expr::Call(function, argument) => (function, argument),
                Expr::Apply(..) => continue,
                _ => return Err(Reject::NoValue),
            };
            let value = Rational::from(value);
            let partner = |function| {
                let call = Expr::Call(function, argument.clone());
                let value = at.functions.get(&call).map(Rational::from);
                value.ok_or(Reject::NoPartner)
            };
            let known = match function {
                Function::Sin => {
                    let (sine, cosine) = (value, partner(Function::Cos)?);
                    if !(&sine * &sine + &cosine * &cosine).is_one() {
                        return Err(Reject::NoSuchValue);
                    }
                    Known::Angle { sine, cosine }
                }
                // It is taken with the sine.
                Function::Cos => {
                    partner(Function::Sin)?;
                    continue;
                }
                Function::Exp if value.is_positive() => Known::Exponential(value),
                Function::Exp => return Err(Reject::NoSuchValue),
                Function::Ln => Known::Logarithm(value),
                _ => return Err(Reject::NoValue),
            };
            let open = argument.free_symbols().into_iter();
            let mut open = open.filter(|s| !self.has_value(s));
            let (Some(symbol), None) = (open.next(), open.next()) else {
                return Err(Reject::NotPrivate);
            };
            // Nothing can be chosen for a whole number, and nothing need be for what does not occur.
            let integer = self.claim.domains.get(&symbol).is_some_and(|d| d.integer);
            let Some(var) = self.atoms.find(&Atom::Symbol(symbol.clone())) else {
                continue;
            };
            if integer || self.private.iter().any(|p| p.var == var) {
                return Err(Reject::NotPrivate);
            }
            let value = self.lowered(argument)?;
            let slope = self.slope(&value, var)?.ok_or(Reject::NotPrivate)?;
            self.private.push(Private { var, slope, known });
        }
        Ok(())
    }

    fn has_value(&self, symbol: &Symbol) -> bool {
        let number = self.problem.pi_is_the_number() && symbol.name() == "\\pi";
        let algebraic = self.at.algebraic.as_deref();
        let is_algebraic = algebraic.is_some_and(|own| own.symbols.contains_key(symbol));
        number
            || is_algebraic
            || self.at.symbols.contains_key(symbol)
            || self.at.in_pi.contains_key(symbol)
    }

    /// The private symbol in a polynomial.
    fn private_in(&self, polynomial: &Polynomial) -> Result<Option<Var>, Reject> {
        if self.private.is_empty() {
            return Ok(None);
        }
        let vars = polynomial.vars();
        let mut found = self.private.iter().filter(|p| vars.contains(&p.var));
        let first = found.next().map(|p| p.var);
        match found.next() {
            None => Ok(first),
            Some(_) => Err(Reject::NotPrivate),
        }
    }

    /// `a` and `b`, for `a x + b`.
    fn linear(&mut self, polynomial: &Polynomial, var: Var) -> Result<(InPi, InPi), Reject> {
        let parts = polynomial.in_powers_of(var);
        match parts.as_slice() {
            [rest] => Ok((InPi::default(), self.number(rest)?)),
            [rest, slope] => Ok((self.number(slope)?, self.number(rest)?)),
            _ => Err(Reject::NotPrivate),
        }
    }

    /// `a`, for a value `a x`; `None` for other values.
    fn slope(&mut self, value: &Fraction, var: Var) -> Result<Option<InPi>, Reject> {
        let below = value.expanded_denominator()?;
        let (slope, rest) = self.linear(value.numerator(), var)?;
        if !rest.is_zero() || slope.is_zero() {
            return Ok(None);
        }
        let below = self.number(&below)?.as_rational();
        let below = below.filter(|b| !b.is_zero()).ok_or(Reject::NoValue)?;
        Ok(Some(slope.scaled(&below.recip())))
    }

    /// What is left of a product of powers of private symbols and something else, once each of them is asked to be
    /// positive, or not to vanish: that is enough, if not needed, for both to have the same sign.
    fn without_private_factors(
        &mut self,
        polynomial: &Polynomial,
        sign: Sign,
    ) -> Result<Option<Polynomial>, Reject> {
        let content = polynomial.content();
        let own = self.private.iter().filter(|p| content.exponent(p.var) > 0);
        let own: Vec<Var> = own.map(|p| p.var).collect();
        // What is linear in one is met without asking for more.
        let linear = |var: &Var| content.exponent(*var) == 1;
        if own.is_empty() || own.len() == 1 && own.iter().all(linear) {
            return Ok(None);
        }
        let mut rest = polynomial.clone();
        for var in own {
            let power = Monomial::power(var, content.exponent(var));
            let power = Polynomial::term(power, Rational::one());
            rest = rest.divided_by(&power).ok_or(Reject::TooLarge)?;
            self.bounds.push(Bound {
                var,
                slope: InPi::rational(Rational::one()),
                rest: InPi::default(),
                sign: match sign {
                    Sign::NonZero => Sign::NonZero,
                    _ => Sign::Positive,
                },
            });
        }
        Ok(Some(rest))
    }

    /// Whether a polynomial has a sign; where it speaks of a private symbol, that is asked of the symbol later.
    pub(super) fn meets(&mut self, polynomial: &Polynomial, sign: Sign) -> Result<bool, Reject> {
        // What speaks of a private symbol is no number of the field: it is rational but for that symbol, or rejected.
        if self.in_field.is_some() && self.private_in(polynomial)?.is_none() {
            let order = self.sign_in_field(polynomial)?;
            return Ok(sign.admits(order));
        }
        if sign != Sign::Zero
            && let Some(rest) = self.without_private_factors(polynomial, sign)?
        {
            return self.meets(&rest, sign);
        }
        if let Some(var) = self.private_in(polynomial)? {
            let (slope, rest) = self.linear(polynomial, var)?;
            if !slope.is_zero() {
                if sign == Sign::Zero {
                    return Err(Reject::NotPrivate);
                }
                self.bounds.push(Bound {
                    var,
                    slope,
                    rest,
                    sign,
                });
                return Ok(true);
            }
        }
        let value = self.number(polynomial)?;
        Ok(match sign {
            Sign::Zero => value.is_zero(),
            Sign::NonZero => !value.is_zero(),
            Sign::NonNegative => self.order(&value)?.is_ge(),
            Sign::Positive => self.order(&value)?.is_gt(),
        })
    }

    /// How a number compares with 0.
    fn order(&self, value: &InPi) -> Result<Ordering, Reject> {
        match &self.unit {
            Some(unit) => value.sign_between(&unit.bounds),
            None => value.sign(),
        }
    }

    /// Whether there is a value for each private symbol within its bounds.
    pub(super) fn bounds_are_met(&self) -> Result<(), Reject> {
        for private in &self.private {
            let own: Vec<&Bound> = self
                .bounds
                .iter()
                .filter(|b| b.var == private.var)
                .collect();
            if !private.fits(&own)? {
                return Err(Reject::OutsideDomain);
            }
        }
        Ok(())
    }

    /// The value of a function of a multiple of what is known, or of a number.
    pub(super) fn function(
        &mut self,
        function: Function,
        argument: &Fraction,
    ) -> Result<Rational, Reject> {
        if let Some(var) = self.private_in(argument.numerator())? {
            // What a private symbol is multiplied with may vanish: then it does not matter.
            let (slope, rest) = self.linear(argument.numerator(), var)?;
            if !slope.is_zero() || !rest.is_zero() {
                let slope = self.slope(argument, var)?.ok_or(Reject::NotPrivate)?;
                let private = self.private.iter().find(|p| p.var == var);
                let private = private.ok_or(Reject::NotPrivate)?;
                return private.value(function, &slope);
            }
        }
        let below = self.number(&argument.expanded_denominator()?)?;
        let below = below.as_rational().filter(|b| !b.is_zero());
        let value = match self.private_in(argument.numerator())? {
            Some(_) => InPi::default(),
            None => self.number(argument.numerator())?,
        };
        // The sine of a multiple of π may be known; that of one of `e` or of a logarithm is not.
        if self.unit.is_some() && value.as_rational().is_none() {
            return Err(Reject::NoValue);
        }
        let value = value.scaled(&below.ok_or(Reject::NoValue)?.recip());
        let terms = value.coefficients().iter().enumerate().map(|(k, c)| {
            let power = Expr::Power(Expr::symbol("\\pi").into(), Expr::integer(k).into());
            Expr::Product([Expr::Number(c.to_big()), power].into())
        });
        let call = Expr::Call(function, Expr::Sum(terms.collect()).into());
        self.lowered(&call)?.as_constant().ok_or(Reject::NoValue)
    }
}

impl Private {
    fn value(&self, function: Function, slope: &InPi) -> Result<Rational, Reject> {
        let own = self.slope.coefficients().last().ok_or(Reject::NoValue)?;
        let other = slope.coefficients().last().ok_or(Reject::NoValue)?;
        let ratio = other / own;
        if self.slope.scaled(&ratio) != *slope || !ratio.is_integer() {
            return Err(Reject::NotPrivate);
        }
        let times = ratio.abs().numer().to_u32();
        let times = times
            .filter(|&t| t <= HIGHEST_MULTIPLE)
            .ok_or(Reject::TooLarge)?;
        let constant = |f: Fraction| f.as_constant().ok_or(Reject::NoValue);
        match (&self.known, function) {
            (Known::Angle { sine, cosine }, Function::Sin | Function::Cos) => {
                let angle: SineCosine = (sine.clone().into(), cosine.clone().into());
                let (sine, cosine) = multiplied(&angle, times)?;
                match function {
                    Function::Cos => constant(cosine),
                    _ if ratio.is_negative() => Ok(-constant(sine)?),
                    _ => constant(sine),
                }
            }
            (Known::Exponential(value), Function::Exp) => {
                let power = constant(Fraction::from(value.clone()).pow(times)?)?;
                Ok(if ratio.is_negative() {
                    power.recip()
                } else {
                    power
                })
            }
            (Known::Logarithm(value), Function::Ln) if ratio.is_one() => Ok(value.clone()),
            _ => Err(Reject::NotPrivate),
        }
    }

    /// Whether some value of the symbol that gives the functions their values is within bounds.
    fn fits(&self, bounds: &[&Bound]) -> Result<bool, Reject> {
        let number = |n: i32, d: i32| InPi::rational(Rational::ratio(n, d));
        let forwards = self.slope.sign()?;
        // In `φ = slope · x`, with the same sign: `a x + b` is `a φ + b slope` over the slope.
        let mut lines = Vec::new();
        let (mut above, mut below) = (false, false);
        for bound in bounds {
            let turn = if forwards.is_lt() { -1 } else { 1 };
            let turn = Rational::from(turn);
            let slope = bound.slope.scaled(&turn);
            let rest = bound.rest.times(&self.slope)?.scaled(&turn);
            if bound.sign != Sign::NonZero {
                above |= slope.sign()?.is_gt();
                below |= slope.sign()?.is_lt();
            }
            lines.push((slope, rest, bound.sign));
        }
        let within = |from: Option<InPi>, to: Option<InPi>| -> Result<bool, Reject> {
            for (slope, rest, sign) in &lines {
                if !keeps_sign(slope, rest, *sign, from.as_ref(), to.as_ref())? {
                    return Ok(false);
                }
            }
            Ok(true)
        };
        match &self.known {
            Known::Angle { sine, cosine } => {
                // By whole turns it can be as great, or as small, as is wanted, past all that is excluded.
                if !(above && below) {
                    return Ok(true);
                }
                let (s, c) = (sine.cmp(&Rational::zero()), cosine.cmp(&Rational::zero()));
                use Ordering::{Equal, Greater, Less};
                // Whole quarters, and what is left of an angle that is no whole number of them.
                let (before, rest) = match (s, c) {
                    (Equal, Greater) => (0, None),
                    (Greater, Greater) => (0, Some((sine.clone(), cosine.clone()))),
                    (Greater, Equal) => (1, None),
                    (Greater, Less) => (1, Some((-cosine, sine.clone()))),
                    (Equal, _) => (2, None),
                    (Less, Less) => (2, Some((-sine, -cosine))),
                    (Less, Equal) => (3, None),
                    (Less, Greater) => (3, Some((cosine.clone(), -sine))),
                };
                let (from, to) = match rest {
                    None => (Rational::zero(), Rational::zero()),
                    Some((sine, cosine)) => acute(&sine, &cosine),
                };
                let quarters = |n: i32| InPi::pi().scaled(&Rational::ratio(n, 2));
                for turns in [0, -4, 4] {
                    let end = |rest: &Rational| {
                        quarters(before + turns).plus(&InPi::rational(rest.clone()))
                    };
                    if within(Some(end(&from)), Some(end(&to)))? {
                        return Ok(true);
                    }
                }
                Ok(false)
            }
            Known::Exponential(value) => match value.cmp(&Rational::one()) {
                Ordering::Greater => within(Some(number(0, 1)), None),
                Ordering::Equal => within(Some(number(0, 1)), Some(number(0, 1))),
                Ordering::Less => within(None, Some(number(0, 1))),
            },
            Known::Logarithm(value) => match value.cmp(&Rational::zero()) {
                Ordering::Greater => within(Some(number(1, 1)), None),
                Ordering::Equal => within(Some(number(1, 1)), Some(number(1, 1))),
                Ordering::Less => within(Some(number(0, 1)), Some(number(1, 1))),
            },
        }
    }
}

/// Bounds on the angle between 0 and a quarter turn that has a sine and a cosine, both positive.
///
/// It is `2 arctan t` with `t = s / (1 + c)` between 0 and 1, and the sums of `t − t³/3 + t⁵/5 − …` lie above and below
/// the whole by turns. The angle lies strictly between the bounds.
fn acute(sine: &Rational, cosine: &Rational) -> (Rational, Rational) {
    let tangent = sine / &(Rational::one() + cosine);
    let square = &tangent * &tangent;
    let mut power = tangent.clone();
    let (mut below, mut above) = (Rational::zero(), tangent);
    for k in 1..=ARCTANGENT_TERMS {
        power *= &square;
        let term = &power / &Rational::from(2 * k + 1);
        match k % 2 {
            1 => below = &above - &term,
            _ => above = &below + &term,
        }
    }
    let two = Rational::from(2);
    (below * &two, above * two)
}

/// Whether `slope φ + rest` has a sign for every φ strictly between two ends, or at the only one; no end is
/// infinitely far.
fn keeps_sign(
    slope: &InPi,
    rest: &InPi,
    sign: Sign,
    from: Option<&InPi>,
    to: Option<&InPi>,
) -> Result<bool, Reject> {
    let at = |end: &InPi| -> Result<Ordering, Reject> { slope.times(end)?.plus(rest).sign() };
    if let (Some(from), Some(to)) = (from, to)
        && from == to
    {
        let order = at(from)?;
        return Ok(sign.admits(order));
    }
    // A slope that is not 0 keeps what is not negative at the ends positive between them.
    let rising = slope.sign()?;
    let ends = [
        from.map_or(Ok(rising.reverse()), at)?,
        to.map_or(Ok(rising), at)?,
    ];
    let positive = ends.iter().all(|o| o.is_ge());
    let negative = ends.iter().all(|o| o.is_le());
    Ok(positive || sign == Sign::NonZero && negative)
}
