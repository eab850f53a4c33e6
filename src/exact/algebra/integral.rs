//! Definite integrals, by antiderivatives.
//!
//! | integrand | antiderivative | for |
//! | --- | --- | --- |
//! | x^r | x^(r+1)/(r+1) | r ≠ -1; where r < 0, 0 does not lie between the limits |
//! | 1/x | ln x | 0 does not lie between the limits |
//! | 1/(a + b x)^m | the same of a + b x, over b | it does not vanish between the limits |
//! | x^n / ((a + b x)^m (c + d x)^l …) | by partial fractions | b c ≠ a d; they do not vanish between the limits |
//! | x^n f with f' = k f | by parts, n times | k ≠ 0 |
//! | x^n f with f' = k x^m f, as of exp(-x²) | by parts | k ≠ 0, n = m + l (m + 1) |
//! | x^n f with f'' = k f + c, as sin and sin² are | by parts, two at a time | k ≠ 0 |
//! | f g with g' = k f | g²/(2 k) | k ≠ 0 |
//!
//! What is linear does not vanish between two places if, and only if, its values there have one sign: their product is positive.

use num_traits::ToPrimitive;

use super::function::{alone, inverse, square_root};
use super::lower::{LowerError, Lowered, Lowering};
use super::{
    Atom, Atoms, BigInt, Conditions, Expr, Fraction, Function, Monomial, Polynomial, Rational,
    Symbol, TooLarge, Var, expr_of, expr_of_fraction, sign_of_fraction,
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
        let found = match within.exists(&inner, &range)? {
            true => within.integrated(&value, &range)?,
            false => None,
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
    fn exists(&mut self, inner: &Conditions, range: &Range) -> Result<bool, LowerError> {
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
            if !self.may_be_positive(&a.times(&b)?)? {
                return Ok(false);
            }
        }
        Ok(true)
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
        let mut below = Moving {
            power: Rational::zero(),
            factors: Vec::new(),
            linear: Vec::new(),
        };
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

    /// The integral of a power of the variable over linear factors, or of one over several of these, by partial fractions.
    fn fractions_between(
        &mut self,
        term: &Moving,
        linear: &[(Polynomial, u32)],
        range: &Range,
    ) -> Result<Option<Fraction>, LowerError> {
        let mut linear = linear.to_vec();
        let mut power = term.power.clone();
        if power.is_negative() {
            let Some(exponent) = small(&-&power) else {
                return Ok(None);
            };
            linear.push((Polynomial::var(range.own), exponent));
            power = Rational::zero();
        }
        let size = linear.iter().map(|own| u64::from(own.1)).sum::<u64>();
        if small(&power).is_none_or(|power| size + u64::from(power) > MOST_PARTS) {
            return Ok(None);
        }
        // The same with one factor less of some, and another power of the variable.
        let less = |own: &mut Self, power: &Rational, factor: Option<usize>| {
            let mut fewer = linear.clone();
            if let Some(at) = factor {
                fewer[at].1 -= 1;
            }
            fewer.retain(|own| own.1 > 0);
            let term = Moving {
                power: power.clone(),
                factors: Vec::new(),
                linear: fewer,
            };
            own.between(&term, range)
        };
        let one = Rational::one();
        let parts = |own: &Self, at: usize| {
            let slope = own.slope(&linear[at].0, range)?;
            let rest = linear[at].0.in_powers_of(range.own).into_iter().next()?;
            Some((slope, rest))
        };
        // x = ((a + b x) - a)/b; and b/(a + b x) - d/(c + d x) is (b c - a d) over both.
        let (first, second, divisor) = if power.is_positive() {
            let Some((slope, rest)) = parts(self, 0) else {
                return Ok(None);
            };
            let fewer = &power - &one;
            let first = less(self, &fewer, Some(0))?;
            let second = less(self, &fewer, None)?;
            let second = second.map(|own| own.times(&rest.into())).transpose()?;
            (first, second, slope)
        } else {
            let (Some((b, a)), Some((d, c))) = (parts(self, 0), parts(self, 1)) else {
                return Ok(None);
            };
            let between = b.times(&c)?.minus(&a.times(&d)?);
            let first = less(self, &power, Some(1))?;
            let second = less(self, &power, Some(0))?;
            let first = first.map(|own| own.times(&b.into())).transpose()?;
            let second = second.map(|own| own.times(&d.into())).transpose()?;
            (first, second, between)
        };
        let (Some(first), Some(second)) = (first, second) else {
            return Ok(None);
        };
        if divisor.is_zero() {
            return Ok(None);
        }
        let over = self.recip(&divisor.into())?;
        Ok(Some(first.minus(&second)?.times(&over)?))
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

    /// An antiderivative of `x^power` times a product of unknowns that are no powers of the variable.
    fn antiderivative(
        &mut self,
        power: u32,
        factors: &[(Var, i64)],
        range: &Range,
    ) -> Result<Option<Fraction>, LowerError> {
        // A product of exponentials has the sum of their rates.
        let mut rate = Some(Fraction::default());
        let mut product = Fraction::from(Rational::one());
        for &(var, exponent) in factors {
            let own = self.rate(var, range.variable)?;
            rate = match (rate, own) {
                (Some(all), Some(own)) => Some(all.plus(&own.times(&whole(exponent).into())?)?),
                _ => None,
            };
            let size = u32::try_from(exponent.unsigned_abs()).map_err(|_| TooLarge)?;
            let var = Polynomial::var(var);
            let own = Fraction::from(var).pow(size)?;
            product = match exponent < 0 {
                true => product.times(&inverse(&own)?)?,
                false => product.times(&own)?,
            };
        }
        if let Some(rate) = rate.filter(|rate| !rate.is_zero()) {
            return self.by_parts(power, &product, &rate, range).map(Some);
        }
        if let Some((degree, rate)) = self.rate_in_powers(factors, range)?
            && let Some(over) = power.checked_sub(degree)
            && over % (degree + 1) == 0
        {
            let times = over / (degree + 1);
            return self
                .by_parts_in_powers((degree, times), &product, &rate, range)
                .map(Some);
        }
        let zero = Fraction::default();
        match *factors {
            [(var, exponent @ (1 | 2))] => {
                let first = self.atom_derivative(var, range.variable)?;
                let second = self.derivative(&first, range.variable)?;
                let Some(factor) = self.quotient_that_stays(&second, var, range)? else {
                    return Ok(None);
                };
                if exponent == 1 {
                    let swing = [product, first, factor, zero];
                    return self.by_parts_twice(power, &swing, range).map(Some);
                }
                if !self.is_sine_or_cosine(var) {
                    return Ok(None);
                }
                // f'² = k (f² - 1), for sines and cosines.
                let times = |value: &Fraction, number| value.times(&whole(number).into());
                let slope = times(&first.times(&Polynomial::var(var).into())?, 2)?;
                let swing = [product, slope, times(&factor, 4)?, times(&factor, -2)?];
                self.by_parts_twice(power, &swing, range).map(Some)
            }
            [(f, 1), (g, 1)] if power == 0 => {
                let slope = self.atom_derivative(g, range.variable)?;
                let Some(factor) = self.quotient_that_stays(&slope, f, range)? else {
                    return Ok(None);
                };
                let square = Fraction::from(Polynomial::var(g)).pow(2)?;
                let half = Fraction::from(Rational::from(2).recip());
                Ok(Some(square.times(&half)?.times(&self.recip(&factor)?)?))
            }
            _ => Ok(None),
        }
    }

    /// ∫ xⁿ f dx for f' = k f: it is (xⁿ f - n ∫ xⁿ⁻¹ f dx)/k.
    fn by_parts(&mut self, n: u32, f: &Fraction, k: &Fraction, range: &Range) -> Lowered {
        let own = Fraction::from(Polynomial::var(range.own));
        let over = self.recip(k)?;
        let mut all = f.times(&over)?;
        for n in 1..=n {
            let less = all.times(&Rational::from(n).into())?;
            all = own.pow(n)?.times(f)?.minus(&less)?.times(&over)?;
        }
        Ok(all)
    }

    /// m and k in f' = k x^m f with m > 0, for a product of unknowns.
    fn rate_in_powers(
        &mut self,
        factors: &[(Var, i64)],
        range: &Range,
    ) -> Result<Option<(u32, Fraction)>, LowerError> {
        let mut rate = Fraction::default();
        for &(var, exponent) in factors {
            let slope = self.atom_derivative(var, range.variable)?;
            let own = slope.times(&inverse(&Polynomial::var(var).into())?)?;
            rate = rate.plus(&own.times(&whole(exponent).into())?)?;
        }
        let mut below = Fraction::from(Rational::one());
        for (factor, exponent) in rate.denominator() {
            if self.moves(factor, range) {
                return Ok(None);
            }
            below = below.times(&Fraction::from(factor.clone()).pow(exponent)?)?;
        }
        let parts = rate.numerator().in_powers_of(range.own);
        let mut known = (0_u32..).zip(&parts).filter(|(_, own)| !own.is_zero());
        let (Some((degree, coefficient)), None) = (known.next(), known.next()) else {
            return Ok(None);
        };
        if degree == 0 || self.moves(coefficient, range) {
            return Ok(None);
        }
        let rate = Fraction::from(coefficient.clone()).times(&inverse(&below)?)?;
        Ok(Some((degree, rate)))
    }

    /// ∫ x^(m + n (m+1)) f dx for f' = k x^m f: it is (x^(n (m+1)) f - n (m+1) ∫ x^(m + (n-1) (m+1)) f dx)/k.
    fn by_parts_in_powers(
        &mut self,
        (m, n): (u32, u32),
        f: &Fraction,
        k: &Fraction,
        range: &Range,
    ) -> Lowered {
        let own = Fraction::from(Polynomial::var(range.own));
        let over = self.recip(k)?;
        let mut all = f.times(&over)?;
        for n in 1..=n {
            let exponent = n * (m + 1);
            let less = all.times(&Rational::from(exponent).into())?;
            let whole = own.pow(exponent)?.times(f)?;
            all = whole.minus(&less)?.times(&over)?;
        }
        Ok(all)
    }

    /// ∫ xⁿ f dx for f'' = k f + c: it is (xⁿ f' - n xⁿ⁻¹ f + n (n-1) ∫ xⁿ⁻² f dx - c xⁿ⁺¹/(n+1))/k.
    fn by_parts_twice(
        &mut self,
        n: u32,
        [f, slope, k, c]: &[Fraction; 4],
        range: &Range,
    ) -> Lowered {
        let own = Fraction::from(Polynomial::var(range.own));
        let over = self.recip(k)?;
        let mut all = Fraction::default();
        for n in (n % 2..=n).step_by(2) {
            let next = Rational::from(n + 1).recip();
            let straight = own.pow(n + 1)?.times(&next.into())?.times(c)?;
            let factor = whole(i64::from(n) * (i64::from(n) - 1));
            let mut sum = all.times(&factor.into())?.minus(&straight)?;
            sum = sum.plus(&own.pow(n)?.times(slope)?)?;
            if n > 0 {
                let less = own.pow(n - 1)?.times(&Rational::from(n).into())?;
                sum = sum.minus(&less.times(f)?)?;
            }
            all = sum.times(&over)?;
        }
        Ok(all)
    }

    /// k in f' = k f, where it does not move with the variable.
    pub(super) fn rate(
        &mut self,
        var: Var,
        variable: &Symbol,
    ) -> Result<Option<Fraction>, LowerError> {
        let slope = self.atom_derivative(var, variable)?;
        let own = self.atom_of_symbol(variable);
        let range = Range {
            variable,
            own: self.atoms.var(own),
            from: Expr::integer(0),
            to: Expr::integer(0),
        };
        self.quotient_that_stays(&slope, var, &range)
    }

    /// A value over an unknown, where that is not 0 and does not move with the variable.
    fn quotient_that_stays(
        &mut self,
        value: &Fraction,
        var: Var,
        range: &Range,
    ) -> Result<Option<Fraction>, LowerError> {
        let quotient = value.times(&inverse(&Polynomial::var(var).into())?)?;
        let moves = self.moves(quotient.numerator(), range)
            || quotient
                .denominator()
                .any(|(factor, _)| self.moves(factor, range));
        Ok((!moves && !quotient.is_zero()).then_some(quotient))
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

    fn is_sine_or_cosine(&self, var: Var) -> bool {
        let atom = self.atoms.atom(var);
        matches!(
            atom,
            Atom::Opaque(Expr::Call(Function::Sin | Function::Cos, _))
        )
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

/// More factors than these are not taken apart into partial fractions.
const MOST_PARTS: u64 = 6;

/// A power of the variable that integration by parts takes down to none.
fn small(power: &Rational) -> Option<u32> {
    let power = power.is_integer().then(|| power.numer().to_u32())??;
    (power <= HIGHEST_POWER).then_some(power)
}

fn whole(number: i64) -> Rational {
    BigInt::from(number).into()
}
