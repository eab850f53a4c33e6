//! Odd powers of the variable times powers of `u = a + b x²`: `\int_0^R \frac{s \, ds}{\sqrt{s^2 + z^2}}`.
//!
//! With `du = 2 b x dx` and `x² = (u - a)/b` these are integrals over powers of `u`; and `x/(a √u)` has the slope `u^{-3/2}`. What is a power
//! with a broken or negative exponent must be positive all the way. `u` grows or falls with `x²`, which lies between the squares of the
//! limits, or between one of them and 0: so it is enough that `u` is positive at both limits and at 0.

use super::super::lower::{LowerError, Lowered, Lowering};
use super::super::{
    Atom, Conditions, Expr, Fraction, Monomial, Polynomial, Rational, Var, expr_of,
};
use super::{Range, alone};
use crate::sorted::Set;

/// No odd power of the variable is taken apart that is higher than this.
const HIGHEST_POWER: u32 = 9;

/// `a + b x²`, and its root, if that is spoken of.
struct Square {
    u: Polynomial,
    a: Polynomial,
    b: Polynomial,
    root: Option<Var>,
}

impl Square {
    /// Whether a polynomial is nothing but the root.
    fn is_root(&self, polynomial: &Polynomial) -> bool {
        self.root.is_some() && alone(polynomial) == self.root
    }
}

impl Lowering<'_> {
    /// The integral, if the integrand is of this form, on conditions that are noted.
    pub(super) fn over_square(
        &mut self,
        value: &Fraction,
        inner: &Conditions,
        range: &Range,
    ) -> Result<Option<Fraction>, LowerError> {
        let Some(square) = self.square_in(value, range)? else {
            return Ok(None);
        };
        if !self.asks_nothing_else(&square, inner, range) {
            return Ok(None);
        }
        // What stands below, beside powers of `u`.
        let mut still = Fraction::from(Rational::one());
        let mut below = Rational::zero();
        for (factor, exponent) in value.denominator() {
            if !self.moves(factor, range) {
                let own = Fraction::from(factor.clone()).pow(exponent)?;
                still = still.times(&self.recip(&own)?)?;
            } else if *factor == square.u {
                below += Rational::from(exponent);
            } else if square.is_root(factor) {
                below += Rational::from(exponent) * Rational::ratio(1, 2);
            } else {
                return Ok(None);
            }
        }
        let mut parts = Vec::new();
        for (monomial, coefficient) in value.numerator().terms() {
            let (mut outside, mut power, mut exponent) = (Monomial::one(), 0, -&below);
            for &(var, own) in monomial.powers() {
                if var == range.own {
                    power = own;
                } else if Some(var) == square.root {
                    exponent += Rational::from(own) * Rational::ratio(1, 2);
                } else if self.is_constant(&self.atoms.atom(var).clone(), range.variable) {
                    outside = outside.times(&Monomial::power(var, own));
                } else {
                    return Ok(None);
                }
            }
            let is_odd = power % 2 == 1 && power <= HIGHEST_POWER;
            let is_known = power == 0 && exponent == Rational::ratio(-3, 2);
            if !is_odd && !is_known {
                return Ok(None);
            }
            let outside = Polynomial::term(outside, coefficient.clone());
            parts.push((outside, power, exponent));
        }
        if !self.is_positive_all_the_way(&square, range)? {
            return Ok(None);
        }
        let mut sum = Fraction::default();
        for (outside, power, exponent) in parts {
            let part = match power {
                0 => self.beside_the_root(&square, range)?,
                power => self.in_powers_of_square(&square, power / 2, &exponent, range)?,
            };
            sum = sum.plus(&part.times(&outside.into())?)?;
        }
        Ok(Some(sum.times(&still)?))
    }

    /// The one `a + b x²` of which an integrand speaks.
    fn square_in(&mut self, value: &Fraction, range: &Range) -> Result<Option<Square>, LowerError> {
        let mut found: Option<Square> = None;
        let below = value.denominator().map(|(factor, _)| factor);
        let below: Vec<Polynomial> = below
            .filter(|own| self.moves(own, range))
            .cloned()
            .collect();
        let mut vars = value.numerator().vars().to_vec();
        vars.extend(below.iter().filter_map(alone));
        for var in vars {
            let Atom::Opaque(Expr::Power(base, exponent)) = self.atoms.atom(var).clone() else {
                continue;
            };
            if !base.mentions(range.variable) {
                continue;
            }
            let is_half = matches!(&*exponent, Expr::Number(own) if Rational::from(own) == Rational::ratio(1, 2));
            if found.as_ref().is_some_and(|own| own.root == Some(var)) {
                continue;
            }
            let base = self.lower(&base)?;
            if !is_half || base.denominator().next().is_some() || found.is_some() {
                return Ok(None);
            }
            let Some(own) = self.square_of(base.numerator(), Some(var), range) else {
                return Ok(None);
            };
            found = Some(own);
        }
        for factor in below {
            match &found {
                Some(own) if own.u == factor || own.is_root(&factor) => {}
                None => match self.square_of(&factor, None, range) {
                    Some(own) => found = Some(own),
                    None => return Ok(None),
                },
                Some(_) => return Ok(None),
            }
        }
        Ok(found)
    }

    fn square_of(&self, u: &Polynomial, root: Option<Var>, range: &Range) -> Option<Square> {
        let [a, none, b] = &u.in_powers_of(range.own)[..] else {
            return None;
        };
        let is_so =
            none.is_zero() && !a.is_zero() && !self.moves(a, range) && !self.moves(b, range);
        is_so.then(|| Square {
            u: u.clone(),
            a: a.clone(),
            b: b.clone(),
            root,
        })
    }

    /// Whether the integrand asks for nothing that moves but that `u` has a root, and does not vanish.
    fn asks_nothing_else(&mut self, square: &Square, inner: &Conditions, range: &Range) -> bool {
        let is_sure = inner.zero.is_empty()
            && inner.bases.is_empty()
            && inner.away.is_empty()
            && inner.doubtful.is_empty();
        if !is_sure {
            return false;
        }
        let is_own = |own: &Polynomial| *own == square.u || square.is_root(own);
        for (asked, may_be_own) in [
            (&inner.nonnegative, true),
            (&inner.nonzero, true),
            (&inner.positive, false),
        ] {
            let mut moving = asked.iter().filter(|own| self.moves(own, range));
            if !moving.all(|own| may_be_own && is_own(own)) {
                return false;
            }
        }
        let still = |all: &Set<Polynomial>| -> Vec<Polynomial> {
            let still = all.iter().filter(|own| !self.moves(own, range));
            still.cloned().collect()
        };
        let (nonnegative, nonzero, positive) = (
            still(&inner.nonnegative),
            still(&inner.nonzero),
            still(&inner.positive),
        );
        self.conditions.nonnegative.extend(nonnegative);
        self.conditions.nonzero.extend(nonzero);
        self.conditions.positive.extend(positive);
        true
    }

    /// Notes that `u` is positive at both limits and at 0; whether it can be.
    fn is_positive_all_the_way(
        &mut self,
        square: &Square,
        range: &Range,
    ) -> Result<bool, LowerError> {
        let [start, end] = self.at_limits(&square.u, range)?;
        let middle = Fraction::from(square.a.clone());
        for value in [start, end, middle] {
            if !self.may_be_positive(&value)? {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// `∫ x^{2 m + 1} u^e dx`, which is the sum of `C(m, i) (-a)^{m - i} ∫ u^{e + i} du` over `2 b^{m + 1}`.
    fn in_powers_of_square(
        &mut self,
        square: &Square,
        m: u32,
        exponent: &Rational,
        range: &Range,
    ) -> Lowered {
        let u = expr_of(&square.u, self.atoms);
        let mut sum = Fraction::default();
        let mut choices = Rational::one();
        for i in 0..=m {
            let power = exponent.clone() + Rational::from(i);
            let part = self.power_between(&u, &-&power, range)?;
            let rest = square.a.negated().pow(m - i)?.scaled(&choices);
            sum = sum.plus(&part.times(&rest.into())?)?;
            choices = choices * Rational::from(m - i) * Rational::from(i + 1).recip();
        }
        let below = square.b.pow(m + 1)?.scaled(&Rational::from(2));
        sum.times(&self.recip(&below.into())?)
            .map_err(LowerError::from)
    }

    /// `∫ u^{-3/2} dx`, which is `x/(a √u)`.
    fn beside_the_root(&mut self, square: &Square, range: &Range) -> Lowered {
        let u = expr_of(&square.u, self.atoms);
        let root = Expr::Power(
            u.into(),
            Expr::Number(Rational::ratio(1, 2).to_big()).into(),
        );
        let variable = Expr::Symbol(range.variable.clone());
        let whole = Expr::Quotient(variable.into(), root.into());
        let end = self.lower(&whole.substitute(range.variable, &range.to))?;
        let start = self.lower(&whole.substitute(range.variable, &range.from))?;
        let a = self.recip(&square.a.clone().into())?;
        end.minus(&start)?.times(&a).map_err(LowerError::from)
    }
}
