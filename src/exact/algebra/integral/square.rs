//! Odd powers of the variable times powers of `u = (a + b x²)/c`: `\int_0^R \frac{s \, ds}{\sqrt{s^2 + z^2}}`.
//!
//! With `du = 2 b x dx` and `x² = (u - a)/b` these are integrals over powers of `u`; and `x/(a √u)` has the slope `u^{-3/2}`. What is a power
//! with a broken or negative exponent must be positive all the way. `u` grows or falls with `x²`, which lies between the squares of the
//! limits, or between one of them and 0: so it is enough that `u` is positive at both limits and at 0.

use super::super::lower::{LowerError, Lowered, Lowering};
use super::super::{
    Atom, Atoms, Conditions, Expr, Fraction, Monomial, Polynomial, Rational, Var, expr_of,
    expr_of_fraction, sign_of_fraction,
};
use super::{Range, alone};
use crate::sorted::Set;

/// No odd power of the variable is taken apart that is higher than this.
const HIGHEST_POWER: u32 = 9;

/// `u = (a + b x²)/c`, what stands above in that, and its root, if that is spoken of.
struct Square {
    above: Polynomial,
    a: Fraction,
    b: Fraction,
    c: Fraction,
    root: Option<Var>,
}

impl Square {
    /// Whether a polynomial is nothing but the root.
    fn is_root(&self, polynomial: &Polynomial) -> bool {
        self.root.is_some() && alone(polynomial) == self.root
    }

    /// `u` as a term.
    fn term(&self, atoms: &Atoms) -> Expr {
        let above = expr_of(&self.above, atoms);
        match self.c.as_constant() {
            Some(one) if one.is_one() => above,
            _ => Expr::Quotient(above.into(), expr_of_fraction(&self.c, atoms).into()),
        }
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
            } else if *factor == square.above {
                below += Rational::from(exponent);
                let own = square.c.pow(exponent)?;
                still = still.times(&self.recip(&own)?)?;
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
        // Where nothing is divided by `u`, it may vanish at a limit.
        let may_vanish = (parts.iter()).all(|(_, _, exponent)| !exponent.is_negative());
        if !self.is_positive_all_the_way(&square, range, may_vanish)? {
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
            let below = Fraction::from(base.expanded_denominator()?);
            if !is_half || self.moves(below.numerator(), range) || found.is_some() {
                return Ok(None);
            }
            let Some(own) = self.square_of(base.numerator(), below, Some(var), range)? else {
                return Ok(None);
            };
            found = Some(own);
        }
        for factor in below {
            match &found {
                Some(own) if own.above == factor || own.is_root(&factor) => {}
                None => match self.square_of(&factor, Rational::one().into(), None, range)? {
                    Some(own) => found = Some(own),
                    None => return Ok(None),
                },
                Some(_) => return Ok(None),
            }
        }
        Ok(found)
    }

    fn square_of(
        &mut self,
        above: &Polynomial,
        c: Fraction,
        root: Option<Var>,
        range: &Range,
    ) -> Result<Option<Square>, LowerError> {
        let [a, none, b] = &above.in_powers_of(range.own)[..] else {
            return Ok(None);
        };
        if !none.is_zero() || a.is_zero() || self.moves(a, range) || self.moves(b, range) {
            return Ok(None);
        }
        let by_c = self.recip(&c)?;
        Ok(Some(Square {
            above: above.clone(),
            a: by_c.times(&a.clone().into())?,
            b: by_c.times(&b.clone().into())?,
            c,
            root,
        }))
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
        let sign = self.recip(&square.c).ok();
        let sign = sign.and_then(|own| own.times(&square.above.clone().into()).ok());
        let sign = sign.and_then(|own| sign_of_fraction(&own).ok());
        let is_own = |own: &Polynomial| {
            *own == square.above || sign.as_ref() == Some(own) || square.is_root(own)
        };
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

    /// Notes that `u` is positive at both limits and at 0, unless it vanishes at a limit and may; whether it can be.
    fn is_positive_all_the_way(
        &mut self,
        square: &Square,
        range: &Range,
        may_vanish: bool,
    ) -> Result<bool, LowerError> {
        let by_c = self.recip(&square.c)?;
        let middle = square.a.clone();
        let [start, end] = self.at_limits(&square.above, range)?;
        for value in [start.times(&by_c)?, end.times(&by_c)?, middle] {
            let vanishes = may_vanish && value.is_zero();
            if !vanishes && !self.may_be_positive(&value)? {
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
        let u = square.term(self.atoms);
        let mut sum = Fraction::default();
        let mut choices = Rational::one();
        for i in 0..=m {
            let power = exponent.clone() + Rational::from(i);
            let part = self.power_between(&u, &-&power, range)?;
            let rest = square.a.negated().pow(m - i)?;
            let rest = rest.times(&choices.clone().into())?;
            sum = sum.plus(&part.times(&rest)?)?;
            choices = choices * Rational::from(m - i) * Rational::from(i + 1).recip();
        }
        let below = square.b.pow(m + 1)?;
        let below = below.times(&Rational::from(2).into())?;
        sum.times(&self.recip(&below)?).map_err(LowerError::from)
    }

    /// `∫ u^{-3/2} dx`, which is `x/(a √u)`.
    fn beside_the_root(&mut self, square: &Square, range: &Range) -> Lowered {
        let u = square.term(self.atoms);
        let root = Expr::Power(
            u.into(),
            Expr::Number(Rational::ratio(1, 2).to_big()).into(),
        );
        let variable = Expr::Symbol(range.variable.clone());
        let whole = Expr::Quotient(variable.into(), root.into());
        let end = self.lower(&whole.substitute(range.variable, &range.to))?;
        let start = self.lower(&whole.substitute(range.variable, &range.from))?;
        let a = self.recip(&square.a)?;
        end.minus(&start)?.times(&a).map_err(LowerError::from)
    }
}
