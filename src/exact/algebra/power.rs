//! Powers taken apart: fractional powers of what is positive, and symbolic exponents.
//!
//! Only where [`Powers`] says so. Terms are read as they are written elsewhere, and at points always.

use num_integer::Integer;
use num_traits::{One, ToPrimitive, Zero};

use super::lower::{LowerError, Lowered, Lowering, sign_of_fraction};
use super::{
    Atom, BigInt, BigRational, Expr, Fraction, Function, Monomial, Polynomial, Rational, Symbol,
    TooLarge, expr_of, expr_of_atom, expr_of_fraction,
};
use crate::sorted::{Map, Set};

/// Prime factors of numbers are looked for up to this.
const LARGEST_PRIME: u32 = 1_000;
/// Roots of a higher order, and of longer numbers, are left as they are.
const HIGHEST_ORDER: u32 = 64;
const MOST_BITS: u64 = 2_048;

/// What is known of symbols when powers are taken apart. Each entry must be true wherever a term is read with it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Powers {
    /// Positive symbols that are read as powers of their roots, with the order of the root.
    pub roots: Map<Symbol, u32>,
    /// All positive symbols.
    pub positive: Set<Symbol>,
    /// All symbols that are not 0.
    pub nonzero: Set<Symbol>,
    /// Whether a power with a whole exponent that may be negative is taken apart only where its base is seen not to be 0: what is asserted
    /// is true for `x^{n-1} = y` at `n = 1` and `x = 0` too.
    pub cautious: bool,
}

impl Lowering<'_> {
    /// `base^(p/q)`, `p/q` positive and in lowest terms: √(m · rest) = √m · √rest, where m > 0.
    pub(super) fn root_taken_apart(&mut self, base: &Fraction, p: u32, q: u32) -> Lowered {
        if base.is_zero() {
            return Ok(Fraction::default());
        }
        let (mut above, mut below) = (Monomial::one(), Monomial::one());
        let mut inside = Monomial::one();
        let mut take = |var, whole: u32, up: bool| {
            let exponent = whole.checked_mul(p).ok_or(TooLarge)?;
            let own = Monomial::power(var, exponent);
            match up {
                true => above = above.times(&own),
                false => below = below.times(&own),
            }
            Ok::<_, TooLarge>(())
        };
        let content = base.numerator().content();
        let mut rest = base.numerator().clone();
        for &(var, exponent) in content.powers() {
            if !matches!(self.atoms.atom(var), Atom::Root { .. }) {
                continue;
            }
            let own = Polynomial::term(Monomial::power(var, exponent), Rational::one());
            rest = rest.divided_by(&own).ok_or(TooLarge)?;
            take(var, exponent / q, true)?;
            inside = inside.times(&Monomial::power(var, exponent % q));
        }
        let mut divisor = Fraction::from(Rational::one());
        for (factor, exponent) in base.denominator() {
            let vars = factor.vars();
            if vars.len() == 1
                && *factor == Polynomial::var(vars[0])
                && matches!(self.atoms.atom(vars[0]), Atom::Root { .. })
            {
                // 1/v^e = v^(q−e) / v^q
                take(vars[0], exponent.div_ceil(q), false)?;
                let missing = exponent.div_ceil(q) * q - exponent;
                inside = inside.times(&Monomial::power(vars[0], missing));
            } else {
                divisor = divisor.times(&Fraction::from(factor.clone()).pow(exponent)?)?;
            }
        }
        let size = numeric_content(&rest);
        let number = self.root_of_number(&size, p, q)?;
        let size = if number.is_some() {
            size
        } else {
            Rational::one()
        };
        rest = rest.scaled(&size.recip());
        let mut value = number.unwrap_or_else(|| Rational::one().into());
        value = value.times(&Polynomial::term(above, Rational::one()).into())?;
        let below = Fraction::from(Polynomial::term(below, Rational::one()));
        // Roots of what is positive do not vanish.
        value = value.times(&below.recip()?.ok_or(LowerError::DivisionByZero)?)?;
        let rest = rest.times_term(&inside, &Rational::one());
        let divisor = divisor.recip()?.ok_or(LowerError::DivisionByZero)?;
        let rest = Fraction::from(rest).times(&divisor)?;
        if rest.as_constant().is_some_and(|c| c.is_one()) {
            return Ok(value);
        }
        if q == 2
            && let Some(root) = self.root_of_square(&rest)?
        {
            return Ok(value.times(&root.pow(p)?)?);
        }
        if q.is_even() {
            let sign = sign_of_fraction(&rest)?;
            self.conditions.nonnegative.insert(sign);
        }
        let written = expr_of_fraction(&rest, self.atoms);
        let root = self.atom(root_atom(written, q));
        Ok(value.times(&root.pow(p)?)?)
    }

    /// `size^(p/q)` of a positive number by its prime factors; `None` where that would take too long.
    fn root_of_number(
        &mut self,
        size: &Rational,
        p: u32,
        q: u32,
    ) -> Result<Option<Fraction>, LowerError> {
        let (above, below) = (size.numer(), size.denom());
        if q > HIGHEST_ORDER || (above.bits() + below.bits()) * u64::from(q) > MOST_BITS {
            return Ok(None);
        }
        // n/d = n d^(q−1) / d^q
        let whole = above * below.pow(q - 1);
        let mut value = Fraction::from(Rational::from(below).recip());
        for (prime, exponent) in prime_factors(&whole, q) {
            let prime = Rational::from(BigRational::from_integer(prime));
            value = value.times(&Fraction::from(prime.clone()).pow(exponent / q)?)?;
            let left = exponent % q;
            if left > 0 {
                let common = left.gcd(&q);
                let written = Expr::Number(prime.to_big());
                let root = self.atom(root_atom(written, q / common));
                value = value.times(&root.pow(left / common)?)?;
            }
        }
        Ok(Some(value.pow(p)?))
    }

    /// A power with an exponent that is no number, term by term of the exponent: `x^(2n+1) = (x^n)² x`.
    ///
    /// `None` where the exponent is no polynomial with integer constant term.
    pub(super) fn symbolic_power(
        &mut self,
        base: &Fraction,
        exponent: &Fraction,
        powers: &Powers,
    ) -> Result<Option<Fraction>, LowerError> {
        let Some(exponent) = exponent.as_polynomial() else {
            return Ok(None);
        };
        if base.is_zero() {
            // 0^0 is 1.
            let zero = self.least(exponent).is_some_and(|least| least > 0);
            return Ok(zero.then(Fraction::default));
        }
        if exponent.terms().any(|(m, c)| m.is_one() && !c.is_integer()) {
            return Ok(None);
        }
        // With a natural exponent every part has a value for every base, for 0^0 is 1 as it is at points.
        let natural =
            self.least(exponent).is_some() && exponent.terms().all(|(_, c)| !c.is_negative());
        let whole = self.is_whole(exponent);
        if whole && !natural {
            if powers.cautious && !self.is_seen_nonzero(base, powers) {
                return Ok(None);
            }
            self.conditions.bases.insert(base.numerator().clone());
        } else if !natural {
            self.conditions.positive.insert(sign_of_fraction(base)?);
        }
        let mut value = Fraction::from(Rational::one());
        for (monomial, coefficient) in exponent.terms() {
            let whole = coefficient
                .numer()
                .to_i32()
                .filter(|_| coefficient.is_integer());
            let factor = match (monomial.is_one(), whole) {
                (true, Some(whole)) => {
                    let power = base.pow(whole.unsigned_abs())?;
                    if whole < 0 {
                        self.recip(&power)?
                    } else {
                        power
                    }
                }
                (true, None) => return Err(LowerError::TooLarge),
                (false, Some(whole)) => {
                    let unit = Polynomial::term(monomial.clone(), Rational::one());
                    let power = self.unit_power(base, &unit, natural, powers)?;
                    let power = power.pow(whole.unsigned_abs())?;
                    if whole < 0 {
                        self.recip(&power)?
                    } else {
                        power
                    }
                }
                (false, None) => {
                    let unit = Polynomial::term(monomial.clone(), coefficient.clone());
                    self.unit_power(base, &unit, natural, powers)?
                }
            };
            value = value.times(&factor)?;
        }
        Ok(Some(value))
    }

    /// What a power with this exponent needs to have a value.
    ///
    /// With a natural exponent there is a value for every base, for `0^0` is 1; with another whole one, for every
    /// base but 0. Elsewhere `((-1)^2)^{1/2}` and `((-1)^{1/2})^2` would not be the same.
    pub(super) fn require_base(
        &mut self,
        base: &Fraction,
        exponent: &Polynomial,
    ) -> Result<(), LowerError> {
        if self.least(exponent).is_some_and(|least| least >= 0) {
            return Ok(());
        }
        if self.is_whole(exponent) {
            self.conditions.bases.insert(base.numerator().clone());
        } else {
            self.conditions.positive.insert(sign_of_fraction(base)?);
        }
        Ok(())
    }

    /// Whether an exponent is a whole number, whatever its symbols are.
    fn is_whole(&self, exponent: &Polynomial) -> bool {
        let whole = |atom: &Atom| match atom {
            Atom::Symbol(own) => self.functions.is_some_and(|f| f.integers.contains(own)),
            Atom::Opaque(Expr::Call(Function::Ceiling | Function::Floor, _)) => true,
            _ => false,
        };
        let mut vars = exponent.vars().into_iter();
        exponent.terms().all(|(_, c)| c.is_integer()) && vars.all(|v| whole(self.atoms.atom(v)))
    }

    /// Whether a base is a product of what is declared not to be 0.
    fn is_seen_nonzero(&self, base: &Fraction, powers: &Powers) -> bool {
        let nonzero = |atom: &Atom| match atom {
            Atom::Root { .. } => true,
            Atom::Symbol(symbol) => powers.nonzero.contains(symbol),
            _ => false,
        };
        let above = base.numerator();
        let mut vars = above.vars().into_iter();
        above.len() == 1 && vars.all(|v| nonzero(self.atoms.atom(v)))
    }

    /// `base^unit`, factor by factor: for a natural exponent every factor, else those that are positive.
    fn unit_power(
        &mut self,
        base: &Fraction,
        unit: &Polynomial,
        natural: bool,
        powers: &Powers,
    ) -> Lowered {
        let exponent = expr_of(unit, self.atoms);
        let positive = |atom: &Atom| match atom {
            Atom::Root { .. } => true,
            Atom::Symbol(symbol) => powers.positive.contains(symbol),
            _ => false,
        };
        let mut value = Fraction::from(Rational::one());
        let mut rest = base.numerator().clone();
        for &(var, own) in base.numerator().content().powers() {
            if !natural && !positive(self.atoms.atom(var)) {
                continue;
            }
            let term = Polynomial::term(Monomial::power(var, own), Rational::one());
            rest = rest.divided_by(&term).ok_or(TooLarge)?;
            let written = expr_of_atom(self.atoms.atom(var));
            let factor = self.opaque_power(written, &exponent);
            value = value.times(&factor.pow(own)?)?;
        }
        let mut divisor = Fraction::from(Rational::one());
        for (factor, own) in base.denominator() {
            let vars = factor.vars();
            let single = vars.len() == 1 && *factor == Polynomial::var(vars[0]);
            if natural || single && positive(self.atoms.atom(vars[0])) {
                let written = expr_of(factor, self.atoms);
                let below = self.opaque_power(written, &exponent).pow(own)?;
                value = value.times(&self.recip(&below)?)?;
            } else {
                divisor = divisor.times(&Fraction::from(factor.clone()).pow(own)?)?;
            }
        }
        let size = numeric_content(&rest);
        if size.numer().bits() + size.denom().bits() <= MOST_BITS {
            rest = rest.scaled(&size.recip());
            for (number, up) in [(size.numer(), true), (size.denom(), false)] {
                for (prime, own) in prime_factors(&number, 1) {
                    let written = Expr::Number(BigRational::from_integer(prime));
                    let factor = self.opaque_power(written, &exponent).pow(own)?;
                    let factor = if up { factor } else { self.recip(&factor)? };
                    value = value.times(&factor)?;
                }
            }
        }
        let divisor = divisor.recip()?.ok_or(LowerError::DivisionByZero)?;
        let rest = Fraction::from(rest).times(&divisor)?;
        if rest.as_constant().is_some_and(|c| c.is_one()) {
            return Ok(value);
        }
        let written = expr_of_fraction(&rest, self.atoms);
        Ok(value.times(&self.opaque_power(written, &exponent))?)
    }

    fn opaque_power(&mut self, base: Expr, exponent: &Expr) -> Fraction {
        let power = Expr::Power(base.into(), exponent.clone().into());
        self.atom(Atom::Opaque(power))
    }
}

fn root_atom(base: Expr, order: u32) -> Atom {
    let unit = BigRational::new_raw(BigInt::one(), order.into());
    Atom::Opaque(Expr::Power(base.into(), Expr::Number(unit).into()))
}

/// The root of a number, where it is rational.
pub(super) fn exact_square_root(value: &Rational) -> Option<Rational> {
    if value.is_negative() {
        return None;
    }
    let (above, below) = (value.numer().sqrt(), value.denom().sqrt());
    let exact = above.pow(2) == value.numer() && below.pow(2) == value.denom();
    exact.then(|| BigRational::new(above, below).into())
}

/// The positive number that leaves coprime integers as coefficients.
pub(super) fn numeric_content(polynomial: &Polynomial) -> Rational {
    let (mut above, mut below) = (BigInt::zero(), BigInt::one());
    for (_, coefficient) in polynomial.terms() {
        above = above.gcd(&coefficient.numer());
        below = below.lcm(&coefficient.denom());
    }
    match above.is_zero() {
        true => Rational::one(),
        false => BigRational::new(above, below).into(),
    }
}

/// Factors of a positive number, prime but for the last, which may be a product of large primes. One that is a
/// perfect power of order `q` is given as such.
pub(super) fn prime_factors(number: &BigInt, q: u32) -> Vec<(BigInt, u32)> {
    let mut left = number.clone();
    let mut found = Vec::new();
    for prime in 2..=LARGEST_PRIME {
        let mut exponent = 0;
        while (&left % prime).is_zero() {
            left /= prime;
            exponent += 1;
        }
        if exponent > 0 {
            found.push((BigInt::from(prime), exponent));
        }
        if left.is_one() {
            return found;
        }
    }
    let root = left.nth_root(q);
    match root.pow(q) == left {
        true => found.push((root, q)),
        false => found.push((left, 1)),
    }
    found
}
