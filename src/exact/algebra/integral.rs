//! Definite integrals, by antiderivatives.
//!
//! | integrand | antiderivative | for |
//! | --- | --- | --- |
//! | x^r | x^(r+1)/(r+1) | r ≠ -1; where r < 0, 0 does not lie between the limits; one of them may be 0 where r > -1 |
//! | 1/x | ln x | 0 does not lie between the limits |
//! | 1/(a + b x)^m | the same of a + b x, over b | it does not vanish between the limits |
//! | x^n / ((a + b x)^m (c + d x)^l …) | by partial fractions | b c ≠ a d; they do not vanish between the limits |
//! | x^n f with f' = k x^m f, as of exp(-x) and exp(-x²) | by parts, l times | k ≠ 0, n = m + l (m + 1) |
//! | x^n f with f'' = k f + c, as sin and sin² are | by parts, two at a time | k ≠ 0 |
//! | f g with g' = k f | g²/(2 k) | k ≠ 0 |
//! | x^(2 n + 1) u^r with u = a + b x² | by powers of u | b ≠ 0; u is positive at both limits and at 0 |
//! | u^(-3/2) | x/(a u^(1/2)) | u is positive at both limits and at 0 |
//!
//! What is linear does not vanish between two places if, and only if, its values there have one sign: their product is positive.

mod antiderivative;
mod partial_fractions;
mod square;

use num_traits::ToPrimitive;

use super::function::{alone, inverse, square_root};
use super::lower::{LowerError, Lowered, Lowering};
use super::{
    Atom, Atoms, BigInt, Conditions, Expr, Fraction, Function, Monomial, Polynomial, Rational,
    Symbol, Var, expr_of, expr_of_fraction, sign_of_fraction,
};

/// What is integrated over, and from where to where.
struct Range<'a> {
    variable: &'a Symbol,
    /// The unknown of the variable.
    own: Var,
    from: Expr,
    to: Expr,
}

/// An integrand of one term: what moves in it with the variable.
#[derive(Clone)]
struct Moving {
    /// The exponent of the variable.
    power: Rational,
    /// Other unknowns with their exponents, those below the stroke negative.
    factors: Vec<(Var, i64)>,
    /// What is linear in the variable, below the stroke.
    linear: Vec<(Polynomial, u32)>,
}

impl Moving {
    fn nothing() -> Moving {
        Moving {
            power: Rational::zero(),
            factors: Vec::new(),
            linear: Vec::new(),
        }
    }
}

impl Lowering<'_> {
    /// An integral by linearity: what has a known antiderivative is integrated, everything else becomes an integral of
    /// one product, in which no more than the product itself tells it from another.
    pub(super) fn integral(
        &mut self,
        whole: &Expr,
        body: &Expr,
        variable: &Symbol,
        from: &Expr,
        to: &Expr,
    ) -> Lowered {
        let (start, end) = (self.lower(from)?, self.lower(to)?);
        let (from, to) = (
            expr_of_fraction(&start, self.atoms),
            expr_of_fraction(&end, self.atoms),
        );
        // The variable is no unknown of the claim, nor is what it is in.
        let mut atoms = self.atoms.clone();
        let mut within = self.over(&mut atoms);
        let value = within.lower(body)?;
        let inner = std::mem::take(&mut within.conditions);
        let own = within.atom_of_symbol(variable);
        let range = Range {
            variable,
            own: within.atoms.var(own),
            from,
            to,
        };
        let found = match within.exists(&value, &inner, &range)? {
            true => within.integrated(&value, &range)?,
            false => {
                within.conditions = Conditions::default();
                within.over_square(&value, &inner, &range)?
            }
        };
        let Some(found) = found else {
            return Ok(self.atom(Atom::Opaque(whole.clone())));
        };
        let conditions = std::mem::take(&mut within.conditions);
        self.conditions
            .extend(conditions.map(|own| transferred(own, &atoms, self.atoms)));
        let mut value = Fraction::from(transferred(found.numerator(), &atoms, self.atoms));
        for (factor, exponent) in found.denominator() {
            let factor = Fraction::from(transferred(factor, &atoms, self.atoms)).pow(exponent)?;
            value = value.times(&inverse(&factor)?)?;
        }
        Ok(value)
    }

    /// Whether the integrand has a value all the way, on conditions that are noted.
    fn exists(
        &mut self,
        value: &Fraction,
        inner: &Conditions,
        range: &Range,
    ) -> Result<bool, LowerError> {
        let sure = inner.zero.is_empty() && inner.bases.is_empty() && inner.doubtful.is_empty();
        if !sure {
            return Ok(false);
        }
        // An even root of the variable needs limits that are not negative; one of something else that moves
        // with it cannot be followed.
        for base in &inner.nonnegative {
            if *base == Polynomial::var(range.own) {
                for limit in [&range.from, &range.to] {
                    let limit = self.lower(limit)?;
                    self.conditions
                        .nonnegative
                        .insert(sign_of_fraction(&limit)?);
                }
            } else if base
                .vars()
                .iter()
                .any(|&var| self.depends(var, range.variable))
            {
                return Ok(false);
            } else {
                self.conditions.nonnegative.insert(base.clone());
            }
        }
        for base in &inner.positive {
            if !self.moves(base, range) {
                self.conditions.positive.insert(base.clone());
                continue;
            }
            if self.slope(base, range).is_none() {
                return Ok(false);
            }
            let [a, b] = self.at_limits(base, range)?;
            if !self.may_be_positive(&a)? || !self.may_be_positive(&b)? {
                return Ok(false);
            }
        }
        for divisor in &inner.nonzero {
            if !self.moves(divisor, range) {
                self.conditions.nonzero.insert(divisor.clone());
                continue;
            }
            let followed = match alone(divisor) {
                Some(var) if self.power_in(var, range).is_some() => Polynomial::var(range.own),
                Some(var) if self.is_exponential(var) => continue,
                _ => match self.linear(divisor, range)? {
                    Some((linear, _)) => linear,
                    None => return Ok(false),
                },
            };
            let [a, b] = self.at_limits(&followed, range)?;
            // `\int_0^h \frac{dx}{\sqrt{x}}`: what grows more slowly than 1/x has an area at 0.
            let at_nought = match (a.is_zero(), b.is_zero()) {
                (true, false) => Some(&b),
                (false, true) => Some(&a),
                _ => None,
            };
            let away = match at_nought {
                Some(other)
                    if followed == Polynomial::var(range.own)
                        && self.has_area_at_nought(value, range) =>
                {
                    other.clone()
                }
                _ => a.times(&b)?,
            };
            if !self.may_be_positive(&away)? {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// Whether an integrand is a sum of powers of the variable, all of which have an exponent above -1.
    fn has_area_at_nought(&self, value: &Fraction, range: &Range) -> bool {
        let mut below = Moving::nothing();
        for (factor, exponent) in value.denominator() {
            match alone(factor) {
                _ if !self.moves(factor, range) => {}
                Some(var) => self.join(&mut below, var, -i64::from(exponent), range),
                None => return false,
            }
        }
        value.numerator().terms().all(|(monomial, _)| {
            let mut term = below.clone();
            for &(var, exponent) in monomial.powers() {
                if !self.is_constant(self.atoms.atom(var), range.variable) {
                    self.join(&mut term, var, i64::from(exponent), range);
                }
            }
            term.factors.is_empty() && term.power > -Rational::one()
        })
    }

    /// Notes that a value must be positive; whether it can be.
    fn may_be_positive(&mut self, value: &Fraction) -> Result<bool, LowerError> {
        let sign = sign_of_fraction(value)?;
        if let Some(number) = sign.as_constant() {
            return Ok(number.is_positive());
        }
        self.conditions.positive.insert(sign);
        Ok(true)
    }

    /// The values of a polynomial at the limits.
    fn at_limits(
        &mut self,
        polynomial: &Polynomial,
        range: &Range,
    ) -> Result<[Fraction; 2], LowerError> {
        let term = expr_of(polynomial, self.atoms);
        let mut at = |limit: &Expr| self.lower(&term.substitute(range.variable, limit));
        Ok([at(&range.from)?, at(&range.to)?])
    }

    fn integrated(
        &mut self,
        value: &Fraction,
        range: &Range,
    ) -> Result<Option<Fraction>, LowerError> {
        let mut still = Fraction::from(Rational::one());
        let mut below = Moving::nothing();
        let denominator: Vec<(Polynomial, u32)> =
            (value.denominator()).map(|(f, e)| (f.clone(), e)).collect();
        for (factor, exponent) in denominator {
            if !self.moves(&factor, range) {
                let own = Fraction::from(factor).pow(exponent)?;
                still = still.times(&self.recip(&own)?)?;
                continue;
            }
            match alone(&factor) {
                Some(var) => self.join(&mut below, var, -i64::from(exponent), range),
                None => match self.linear(&factor, range)? {
                    Some((linear, power)) => below.linear.push((linear, power * exponent)),
                    None => return Ok(None),
                },
            }
        }
        let mut above = value.numerator().clone();
        for (linear, exponent) in &mut below.linear {
            while *exponent > 0
                && let Some(less) = above.divided_by(linear)
            {
                (above, *exponent) = (less, *exponent - 1);
            }
        }
        below.linear.retain(|(_, exponent)| *exponent > 0);
        let below_moves = below.power != Rational::zero()
            || !below.factors.is_empty()
            || !below.linear.is_empty();
        let mut sum = Fraction::default();
        for (monomial, coefficient) in above.terms() {
            let (mut outside, mut inside) = (Monomial::one(), Monomial::one());
            let mut moving = below.clone();
            for &(var, exponent) in monomial.powers() {
                let own = Monomial::power(var, exponent);
                if self.is_constant(&self.atoms.atom(var).clone(), range.variable) {
                    outside = outside.times(&own);
                    continue;
                }
                inside = inside.times(&own);
                self.join(&mut moving, var, i64::from(exponent), range);
            }
            let part = match self.between(&moving, range)? {
                Some(part) => part,
                None if below_moves => return Ok(None),
                None => {
                    let one = Polynomial::term(inside, Rational::one());
                    self.atom(Atom::Opaque(Expr::Integral {
                        body: expr_of(&one, self.atoms).into(),
                        variable: range.variable.clone(),
                        from: range.from.clone().into(),
                        to: range.to.clone().into(),
                    }))
                }
            };
            let factor = Polynomial::term(outside, coefficient.clone());
            sum = sum.plus(&part.times(&factor.into())?)?;
        }
        Ok(Some(sum.times(&still)?))
    }

    /// The integral of one term.
    fn between(&mut self, term: &Moving, range: &Range) -> Result<Option<Fraction>, LowerError> {
        let plain = term.power == Rational::zero();
        match (&term.factors[..], &term.linear[..]) {
            ([], []) => {
                let own = Expr::Symbol(range.variable.clone());
                self.power_between(&own, &-&term.power, range).map(Some)
            }
            ([], [(linear, exponent)]) if plain => {
                let Some(slope) = self.slope(linear, range) else {
                    return Ok(None);
                };
                let slope = self.recip(&slope.into())?;
                let linear = expr_of(linear, self.atoms);
                let part = self.power_between(&linear, &Rational::from(*exponent), range)?;
                Ok(Some(part.times(&slope)?))
            }
            ([], linear) if term.power.is_integer() => self.fractions_between(term, linear, range),
            (factors, []) if let Some(power) = small(&term.power) => {
                let before = std::mem::take(&mut self.conditions);
                let found = self.antiderivative(power, factors, range)?;
                let own = std::mem::replace(&mut self.conditions, before);
                // What would have to be so all the way is not looked at.
                let sure = !own.polynomials().any(|own| self.moves(own, range));
                let Some(found) = found.filter(|_| sure) else {
                    return Ok(None);
                };
                self.conditions.extend(own);
                let found = expr_of_fraction(&found, self.atoms);
                let at = |limit: &Expr| found.substitute(range.variable, limit);
                let (end, start) = (self.lower(&at(&range.to))?, self.lower(&at(&range.from))?);
                Ok(Some(end.minus(&start)?))
            }
            _ => Ok(None),
        }
    }

    /// ∫ du / u^e between the values that `u` has at the limits.
    fn power_between(&mut self, u: &Expr, exponent: &Rational, range: &Range) -> Lowered {
        let end = u.substitute(range.variable, &range.to);
        let start = u.substitute(range.variable, &range.from);
        let power = Rational::one() - exponent.clone();
        if power == Rational::zero() {
            // Both have one sign, so that their quotient has a logarithm.
            let quotient = Expr::Quotient(end.into(), start.into());
            return self.lower(&Expr::Call(Function::Ln, quotient.into()));
        }
        let raised = |base: Expr| Expr::Power(base.into(), Expr::Number(power.to_big()).into());
        let (above, below) = (self.lower(&raised(end))?, self.lower(&raised(start))?);
        Ok(above.minus(&below)?.times(&power.recip().into())?)
    }

    /// Whether anything in a polynomial moves with the variable, as far as is known.
    fn moves(&self, polynomial: &Polynomial, range: &Range) -> bool {
        let still = |&var: &Var| self.is_constant(self.atoms.atom(var), range.variable);
        !polynomial.vars().iter().all(still)
    }

    /// What a polynomial that is linear in the variable grows by.
    fn slope(&self, polynomial: &Polynomial, range: &Range) -> Option<Polynomial> {
        let by_power = polynomial.in_powers_of(range.own);
        let [rest, slope] = &by_power[..] else {
            return None;
        };
        let moves = self.moves(rest, range) || self.moves(slope, range);
        (!moves).then(|| slope.clone())
    }

    /// What a polynomial is a power of that is linear in the variable, and which.
    fn linear(
        &self,
        polynomial: &Polynomial,
        range: &Range,
    ) -> Result<Option<(Polynomial, u32)>, LowerError> {
        if self.slope(polynomial, range).is_some() {
            return Ok(Some((polynomial.clone(), 1)));
        }
        let root = square_root(polynomial)?;
        let root = root.filter(|root| self.slope(root, range).is_some());
        Ok(root.map(|root| (root, 2)))
    }

    /// The exponent, where an unknown is a power of the variable.
    fn power_in(&self, var: Var, range: &Range) -> Option<Rational> {
        match self.atoms.atom(var) {
            Atom::Symbol(own) if own == range.variable => Some(Rational::one()),
            Atom::Root { of, order } if of == range.variable => {
                Some(Rational::from(*order).recip())
            }
            Atom::Opaque(Expr::Power(base, exponent)) => match (&**base, &**exponent) {
                (Expr::Symbol(own), Expr::Number(exponent)) if own == range.variable => {
                    Some(exponent.into())
                }
                _ => None,
            },
            _ => None,
        }
    }

    fn is_exponential(&self, var: Var) -> bool {
        let atom = self.atoms.atom(var);
        matches!(atom, Atom::Opaque(Expr::Call(Function::Exp, _)))
    }

    /// Takes a power of an unknown in.
    fn join(&self, moving: &mut Moving, var: Var, exponent: i64, range: &Range) {
        if let Some(power) = self.power_in(var, range) {
            moving.power = moving.power.clone() + power * whole(exponent);
            return;
        }
        match moving.factors.iter_mut().find(|own| own.0 == var) {
            Some(own) => own.1 += exponent,
            None => moving.factors.push((var, exponent)),
        }
        moving.factors.retain(|own| own.1 != 0);
    }
}

/// A polynomial in the unknowns of one table, in those of another.
fn transferred(polynomial: &Polynomial, from: &Atoms, to: &mut Atoms) -> Polynomial {
    let mut all = Polynomial::zero();
    for (monomial, coefficient) in polynomial.terms() {
        let mut own = Monomial::one();
        for &(var, exponent) in monomial.powers() {
            let var = to.var(from.atom(var).clone());
            own = own.times(&Monomial::power(var, exponent));
        }
        all = all.plus(&Polynomial::term(own, coefficient.clone()));
    }
    all
}

/// How often something is integrated by parts at most.
const HIGHEST_POWER: u32 = 16;

/// A power of the variable that integration by parts takes down to none.
fn small(power: &Rational) -> Option<u32> {
    let power = power.is_integer().then(|| power.numer().to_u32())??;
    (power <= HIGHEST_POWER).then_some(power)
}

fn whole(number: i64) -> Rational {
    BigInt::from(number).into()
}
