//! Antiderivatives of powers of the variable times what grows or swings.

use super::super::function::inverse;
use super::super::lower::{LowerError, Lowered, Lowering};
use super::super::{Atom, Expr, Fraction, Function, Polynomial, Rational, TooLarge, Var};
use super::{Range, whole};

impl Lowering<'_> {
    /// An antiderivative of `x^power` times a product of unknowns that are no powers of the variable.
    pub(super) fn antiderivative(
        &mut self,
        power: u32,
        factors: &[(Var, i64)],
        range: &Range,
    ) -> Result<Option<Fraction>, LowerError> {
        if let [(var, 1)] = *factors
            && self.is_logarithm(var)
        {
            return self.of_logarithm(power, var, range);
        }
        let mut product = Fraction::from(Rational::one());
        for &(var, exponent) in factors {
            let size = u32::try_from(exponent.unsigned_abs()).map_err(|_| TooLarge)?;
            let var = Polynomial::var(var);
            let own = Fraction::from(var).pow(size)?;
            product = match exponent < 0 {
                true => product.times(&inverse(&own)?)?,
                false => product.times(&own)?,
            };
        }
        if let Some((degree, rate)) = self.rate_in_powers(factors, range)?
            && let Some(over) = power.checked_sub(degree)
            && over % (degree + 1) == 0
        {
            let times = over / (degree + 1);
            return self
                .by_parts((degree, times), &product, &rate, range)
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

    /// ∫ xⁿ f dx for x f' = k, `\ln\frac{b}{x}`: it is xⁿ⁺¹ f/(n+1) - k xⁿ⁺¹/(n+1)².
    fn of_logarithm(
        &mut self,
        n: u32,
        f: Var,
        range: &Range,
    ) -> Result<Option<Fraction>, LowerError> {
        let own = Fraction::from(Polynomial::var(range.own));
        // What the logarithm is taken of is positive all the way, and so `x` nowhere 0 that is divided by.
        let before = self.conditions.clone();
        let slope = self.atom_derivative(f, range.variable);
        self.conditions = before;
        let k = own.times(&slope?)?;
        let mut below = k.denominator();
        if self.moves(k.numerator(), range) || below.any(|(factor, _)| self.moves(factor, range)) {
            return Ok(None);
        }
        let share = Rational::from(n + 1).recip();
        let rest = k.times(&share.clone().into())?;
        let all = own.pow(n + 1)?.times(&share.into())?;
        let f = Fraction::from(Polynomial::var(f));
        Ok(Some(all.times(&f.minus(&rest)?)?))
    }

    fn is_logarithm(&self, var: Var) -> bool {
        matches!(
            self.atoms.atom(var),
            Atom::Opaque(Expr::Call(Function::Ln, _))
        )
    }

    /// m and k in f' = k x^m f, for a product of unknowns: that of exponentials has the sum of their rates.
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
        if self.moves(coefficient, range) {
            return Ok(None);
        }
        let rate = Fraction::from(coefficient.clone()).times(&inverse(&below)?)?;
        Ok(Some((degree, rate)))
    }

    /// ∫ x^(m + n (m+1)) f dx for f' = k x^m f: it is (x^(n (m+1)) f - n (m+1) ∫ x^(m + (n-1) (m+1)) f dx)/k.
    fn by_parts(
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

    fn is_sine_or_cosine(&self, var: Var) -> bool {
        let atom = self.atoms.atom(var);
        matches!(
            atom,
            Atom::Opaque(Expr::Call(Function::Sin | Function::Cos, _))
        )
    }
}
