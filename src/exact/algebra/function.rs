//! Elementary functions taken apart: addition theorems, laws of exponents and logarithms, absolute values.
//!
//! | term | is read as | for |
//! | --- | --- | --- |
//! | `sin(a + b)`, `cos(2 a)`, `sin(−a)` | polynomials in sin and cos of the summands | all reals |
//! | `tan a` | sin a / cos a | cos a ≠ 0, which is kept as a condition |
//! | `exp(2 a − b)` | exp(a)² / exp(b) | all reals |
//! | `exp(c ln x)` | x^c | x > 0, the condition of the logarithm |
//! | `ln(2 e^a x / y)` | ln 2 + a + ln x − ln y | what is split off is positive by itself; the condition of the whole is kept |
//! | `\|2 x y²\|` | 2 \|x\| y² | all reals |
//! | `√(p²)` | \|p\| | all reals |
//!
//! A unit is a product of powers over q, without a numeric factor above: `ω t`, `θ/2`. Functions of units are
//! unknowns; how those of `θ` and `θ/2` belong together is said by facts about them.

use num_integer::Integer;
use num_traits::{Signed, ToPrimitive};

use super::lower::{LowerError, Lowered, Lowering, sign_of_fraction};
use super::power::{exact_square_root, numeric_content, prime_factors};
use super::{
    Atom, BigInt, BigRational, Expr, Fraction, Function, Monomial, Polynomial, Rational, Symbol,
    TooLarge, Var, expr_of, expr_of_fraction,
};
use crate::sorted::Set;

/// An angle with more summands, or a greater multiple of a unit, is an angle of its own.
const MOST_SUMMANDS: usize = 4;
const HIGHEST_MULTIPLE: u32 = 8;
const MOST_MULTIPLES: u32 = 12;
/// The same for exponents, which do not make terms longer.
const MOST_EXPONENTS: usize = 16;
const HIGHEST_POWER: u32 = 1_024;
/// The square root of a polynomial is looked for up to this many terms.
const MOST_TERMS_OF_A_ROOT: usize = 12;
/// Longer numbers are not factored.
const MOST_BITS: u64 = 256;

/// What is known of symbols in either reading of powers; true wherever a term is read with it, at points too.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Functions {
    /// Whether `\pi` is the number.
    pub pi: bool,
    /// Positive symbols.
    pub positive: Set<Symbol>,
    /// Whole numbers that are not negative.
    pub naturals: Set<Symbol>,
    /// All whole numbers.
    pub integers: Set<Symbol>,
}

/// The sine and the cosine of an angle.
pub type SineCosine = (Fraction, Fraction);

impl Lowering<'_> {
    /// A known function of a term.
    pub(super) fn call(&mut self, function: Function, argument: &Expr) -> Lowered {
        let value = self.lower(argument)?;
        match function {
            Function::Sin => Ok(self.angle(&value)?.0),
            Function::Cos => Ok(self.angle(&value)?.1),
            Function::Tan => {
                let (sine, cosine) = self.angle(&value)?;
                Ok(sine.times(&self.recip(&cosine)?)?)
            }
            Function::Exp => self.exponential(&value),
            Function::Ln => self.logarithm_of_positive(&value),
            Function::Abs => self.absolute(&value),
            Function::ArcSin | Function::ArcCos => {
                // There is none beyond 1.
                let inside = one().minus(&value.times(&value)?)?;
                self.conditions
                    .nonnegative
                    .insert(sign_of_fraction(&inside)?);
                Ok(self.function_of(function, &value))
            }
            Function::ArcTan | Function::Ceiling | Function::Floor => {
                Ok(self.function_of(function, &value))
            }
        }
    }

    /// An unknown for a function of a value.
    fn function_of(&mut self, function: Function, value: &Fraction) -> Fraction {
        let argument = expr_of_fraction(value, self.atoms);
        self.atom(Atom::Opaque(Expr::Call(function, argument.into())))
    }

    /// The sine and the cosine of a sum by those of its units.
    pub(super) fn angle(&mut self, value: &Fraction) -> Result<SineCosine, LowerError> {
        let mut whole: SineCosine = (Fraction::default(), one());
        let parts = summands(value)?;
        let mut read = Vec::new();
        for (number, unit) in &parts {
            let turn = self.twelfths(number, unit);
            let multiple = number.numer().abs().to_u32();
            let multiple = multiple.filter(|&k| k <= HIGHEST_MULTIPLE);
            read.push((turn, multiple));
        }
        let open = || read.iter().filter(|(turn, _)| turn.is_none());
        let all: Option<u32> = open().map(|(_, multiple)| *multiple).sum();
        let fits = all.is_some_and(|all| all <= MOST_MULTIPLES);
        if parts.len() > MOST_SUMMANDS || !fits {
            return Ok(self.angle_of_its_own(value));
        }
        for ((number, unit), (turn, multiple)) in parts.iter().zip(read) {
            if let Some(cosine) = self.half_turns(number, unit)? {
                whole = turned(&whole, &(Fraction::default(), cosine))?;
                continue;
            }
            let part = match (turn, multiple) {
                (Some(turn), _) => (self.sine_of_turn(turn)?, self.sine_of_turn(turn + 6)?),
                (None, multiple) => {
                    let unit = unit.times(&Rational::from(number.denom()).recip().into())?;
                    let own = self.angle_of_its_own(&unit);
                    let (sine, cosine) = multiplied(&own, multiple.unwrap_or(1))?;
                    match number.is_negative() {
                        true => (sine.negated(), cosine),
                        false => (sine, cosine),
                    }
                }
            };
            whole = turned(&whole, &part)?;
        }
        Ok(whole)
    }

    /// The sine and the cosine of a value as unknowns; of a value and its negative, those of the one that begins
    /// with a positive coefficient.
    fn angle_of_its_own(&mut self, value: &Fraction) -> SineCosine {
        let lead = value.numerator().leading().map(|(_, c)| c.is_negative());
        match lead {
            None => (Fraction::default(), one()),
            Some(true) => {
                let (sine, cosine) = self.angle_of_its_own(&value.negated());
                (sine.negated(), cosine)
            }
            Some(false) => (
                self.function_of(Function::Sin, value),
                self.function_of(Function::Cos, value),
            ),
        }
    }

    /// How many twelfths of π an angle is, from 0 to 23, where its sine and cosine are square roots at most.
    fn twelfths(&self, number: &Rational, unit: &Fraction) -> Option<u32> {
        let pi = self.atoms.find(&Atom::Symbol(Symbol::new("\\pi")))?;
        let known = self.functions.is_some_and(|f| f.pi);
        if !known || unit.as_polynomial() != Some(&Polynomial::var(pi)) {
            return None;
        }
        let twelfths = (number * &Rational::from(12)).to_big();
        let turn = twelfths.is_integer().then(|| twelfths.to_integer())?;
        let turn = turn.mod_floor(&BigInt::from(24)).to_u32()?;
        (turn % 2 == 0 || turn % 3 == 0).then_some(turn)
    }

    /// The cosine of a whole number of half turns: `cos(k n π)` is `(-1)^{k n}`, and the sine is 0.
    fn half_turns(
        &mut self,
        number: &Rational,
        unit: &Fraction,
    ) -> Result<Option<Fraction>, LowerError> {
        let pi = self.atoms.find(&Atom::Symbol(Symbol::new("\\pi")));
        let (Some(pi), Some(known)) = (pi, self.functions.filter(|f| f.pi)) else {
            return Ok(None);
        };
        let pi = Polynomial::var(pi);
        let turns = unit.as_polynomial().and_then(|unit| unit.divided_by(&pi));
        let Some(turns) = turns.filter(|turns| !turns.vars().is_empty() && number.is_integer())
        else {
            return Ok(None);
        };
        let whole = |var: &Var| match self.atoms.atom(*var) {
            Atom::Symbol(symbol) => known.integers.contains(symbol),
            _ => false,
        };
        if turns.len() != 1 || !turns.vars().iter().all(whole) {
            return Ok(None);
        }
        if number.numer().is_even() {
            return Ok(Some(one()));
        }
        let exponent = expr_of(&turns.monic(), self.atoms);
        let sign = Expr::Power(Expr::integer(-1).into(), exponent.into());
        self.lower(&sign).map(Some)
    }

    fn sine_of_turn(&mut self, twelfths: u32) -> Lowered {
        let twelfths = twelfths % 24;
        if twelfths > 12 {
            return Ok(self.sine_of_turn(24 - twelfths)?.negated());
        }
        let mut root = |number: i64| {
            let half = Expr::Number(BigRational::new(1.into(), 2.into()));
            let root = self.lower(&Expr::Power(Expr::integer(number).into(), half.into()))?;
            Ok(root.times(&Rational::ratio(1, 2).into())?)
        };
        match twelfths.min(12 - twelfths) {
            0 => Ok(Fraction::default()),
            2 => Ok(Rational::ratio(1, 2).into()),
            3 => root(2),
            4 => root(3),
            _ => Ok(one()),
        }
    }

    fn exponential(&mut self, value: &Fraction) -> Lowered {
        let parts = summands(value)?;
        let high = |number: &Rational| number.numer().abs() > HIGHEST_POWER.into();
        if parts.len() > MOST_EXPONENTS || parts.iter().any(|(number, _)| high(number)) {
            return Ok(self.function_of(Function::Exp, value));
        }
        let mut product = one();
        for (number, unit) in &parts {
            if let Some(factor) = self.power_by_logarithm(number, unit)? {
                product = product.times(&factor)?;
                continue;
            }
            let unit = unit.times(&Rational::from(number.denom()).recip().into())?;
            let power = number.numer().abs().to_u32().ok_or(TooLarge)?;
            let own = self.function_of(Function::Exp, &unit).pow(power)?;
            // What is never 0 may be divided by.
            product = match number.is_negative() {
                true => product.times(&inverse(&own)?)?,
                false => product.times(&own)?,
            };
        }
        Ok(product)
    }

    /// `exp(c ln x) = x^c`, where just one logarithm is a factor of the exponent.
    fn power_by_logarithm(
        &mut self,
        number: &Rational,
        unit: &Fraction,
    ) -> Result<Option<Fraction>, LowerError> {
        let mut found = None;
        for &(var, exponent) in unit.numerator().content().powers() {
            let Atom::Opaque(Expr::Call(Function::Ln, of)) = self.atoms.atom(var) else {
                continue;
            };
            if found.is_some() || exponent > 1 {
                return Ok(None);
            }
            found = Some((var, of.clone()));
        }
        let Some((var, of)) = found else {
            return Ok(None);
        };
        let own = inverse(&Polynomial::var(var).into())?;
        let exponent = unit.times(&own)?.times(&number.clone().into())?;
        let exponent = expr_of_fraction(&exponent, self.atoms);
        self.lower(&Expr::Power(of, exponent.into())).map(Some)
    }

    /// The logarithm of a value, which must be positive.
    pub(super) fn logarithm_of_positive(&mut self, value: &Fraction) -> Lowered {
        let sign = sign_of_fraction(value)?;
        self.conditions.positive.insert(sign);
        self.logarithm(value)
    }

    /// The logarithm of a value that is positive, by those of its factors that are positive whatever the others are.
    fn logarithm(&mut self, value: &Fraction) -> Lowered {
        let mut sum = Fraction::default();
        let mut rest = value.numerator().clone();
        for &(var, exponent) in rest.content().powers() {
            if let Some(own) = self.logarithm_of_unknown(var)? {
                let term = Polynomial::term(Monomial::power(var, exponent), Rational::one());
                rest = rest.divided_by(&term).ok_or(TooLarge)?;
                sum = sum.plus(&own.times(&Rational::from(exponent).into())?)?;
            }
        }
        let mut divisor = one();
        for (factor, exponent) in value.denominator() {
            let own = match alone(factor) {
                Some(var) => self.logarithm_of_unknown(var)?,
                None if self.is_plainly_positive(factor) => {
                    Some(self.function_of(Function::Ln, &factor.clone().into()))
                }
                None => None,
            };
            match own {
                Some(own) => sum = sum.minus(&own.times(&Rational::from(exponent).into())?)?,
                None => {
                    let factor = Fraction::from(factor.clone()).pow(exponent)?;
                    divisor = divisor.times(&factor)?;
                }
            }
        }
        let size = numeric_content(&rest);
        if size.numer().bits() + size.denom().bits() <= MOST_BITS {
            rest = rest.scaled(&size.recip());
            sum = sum.plus(&self.logarithm_of_number(&size)?)?;
        }
        let rest = Fraction::from(rest).times(&inverse(&divisor)?)?;
        if rest.as_constant().is_some_and(|c| c.is_one()) {
            return Ok(sum);
        }
        // ln(1/x) = −ln x: of both the one whose term comes first is written.
        let turned = inverse(&rest)?;
        let first = |value: &Fraction| expr_of_fraction(value, self.atoms);
        Ok(match first(&turned) < first(&rest) {
            true => sum.minus(&self.function_of(Function::Ln, &turned))?,
            false => sum.plus(&self.function_of(Function::Ln, &rest))?,
        })
    }

    /// The logarithm of a positive number by its prime factors.
    fn logarithm_of_number(&mut self, number: &Rational) -> Lowered {
        let mut sum = Fraction::default();
        for (part, above) in [(number.numer(), true), (number.denom(), false)] {
            for (prime, exponent) in prime_factors(&part, 1) {
                let prime = Rational::from(BigRational::from_integer(prime));
                let own = self.function_of(Function::Ln, &prime.into());
                let own = own.times(&Rational::from(exponent).into())?;
                sum = if above {
                    sum.plus(&own)?
                } else {
                    sum.minus(&own)?
                };
            }
        }
        Ok(sum)
    }

    /// The logarithm of an unknown that is positive in any case.
    fn logarithm_of_unknown(&mut self, var: Var) -> Result<Option<Fraction>, LowerError> {
        let known = self.functions;
        let positive = |symbol: &Symbol| known.is_some_and(|f| f.positive.contains(symbol));
        match self.atoms.atom(var).clone() {
            Atom::Symbol(symbol) if positive(&symbol) => {
                let own = Polynomial::var(var).into();
                Ok(Some(self.function_of(Function::Ln, &own)))
            }
            Atom::Root { of, order } => {
                let argument = Expr::Symbol(of).into();
                let own = self.atom(Atom::Opaque(Expr::Call(Function::Ln, argument)));
                let share = Rational::from(order).recip();
                Ok(Some(own.times(&share.into())?))
            }
            Atom::Opaque(Expr::Call(Function::Exp, exponent)) => self.lower(&exponent).map(Some),
            Atom::Opaque(Expr::Power(base, exponent)) => {
                let base = match &*base {
                    Expr::Number(number) if number.is_positive() => {
                        self.logarithm_of_number(&number.into())?
                    }
                    Expr::Symbol(symbol) if positive(symbol) => {
                        let argument = base.clone();
                        self.atom(Atom::Opaque(Expr::Call(Function::Ln, argument)))
                    }
                    base => {
                        let value = self.lower(base)?;
                        let mut below = value.denominator();
                        if !self.is_plainly_positive(value.numerator())
                            || !below.all(|(own, _)| self.is_plainly_positive(own))
                        {
                            return Ok(None);
                        }
                        self.logarithm(&value)?
                    }
                };
                Ok(Some(self.lower(&exponent)?.times(&base)?))
            }
            _ => Ok(None),
        }
    }

    /// Whether a polynomial is a sum of positive terms.
    pub(super) fn is_plainly_positive(&self, polynomial: &Polynomial) -> bool {
        let positive = |var: &Var| match self.atoms.atom(*var) {
            Atom::Root { .. } | Atom::Opaque(Expr::Call(Function::Exp, _)) => true,
            Atom::Symbol(symbol) => self.functions.is_some_and(|f| f.positive.contains(symbol)),
            Atom::Opaque(Expr::Power(base, _)) => {
                matches!(&**base, Expr::Number(base) if base.is_positive())
            }
            _ => false,
        };
        let mut terms = polynomial.terms();
        !polynomial.is_zero()
            && terms.all(|(_, c)| c.is_positive())
            && polynomial.vars().iter().all(positive)
    }

    /// An absolute value by those of its factors: of an even power there is nothing to do.
    fn absolute(&mut self, value: &Fraction) -> Lowered {
        if value.is_zero() {
            return Ok(Fraction::default());
        }
        let content = value.numerator().content();
        let whole = Polynomial::term(content.clone(), Rational::one());
        let rest = value.numerator().divided_by(&whole).ok_or(TooLarge)?;
        let mut product = Fraction::from(numeric_content(&rest));
        for &(var, exponent) in content.powers() {
            product = product.times(&self.absolute_power(&Polynomial::var(var), exponent)?)?;
        }
        if rest.as_constant().is_none() {
            product = product.times(&self.absolute_power(&rest, 1)?)?;
        }
        for (factor, exponent) in value.denominator() {
            // That this does not vanish is among the conditions of what the absolute value is taken of.
            let below = self.absolute_power(factor, exponent)?;
            product = product.times(&inverse(&below)?)?;
        }
        Ok(product)
    }

    /// `|p|^e`, up to the numeric content of `p` where `e` is odd.
    fn absolute_power(&mut self, polynomial: &Polynomial, exponent: u32) -> Lowered {
        let even = Fraction::from(polynomial.clone()).pow(exponent - exponent % 2)?;
        if exponent.is_multiple_of(2) {
            return Ok(even);
        }
        let size = match alone(polynomial) {
            Some(_) => Rational::one(),
            None => numeric_content(polynomial),
        };
        let mut primitive = polynomial.scaled(&size.recip());
        if primitive.leading().is_some_and(|(_, c)| c.is_negative()) {
            primitive = primitive.negated();
        }
        let known = match alone(&primitive) {
            Some(var) => self.is_never_negative(var),
            None => self.is_plainly_positive(&primitive),
        };
        let own = match known {
            true => primitive.into(),
            false => {
                let argument = expr_of(&primitive, self.atoms);
                self.atom(Atom::Opaque(Expr::Call(Function::Abs, argument.into())))
            }
        };
        Ok(even.times(&own)?)
    }

    fn is_never_negative(&self, var: Var) -> bool {
        let known = |symbol: &Symbol| self.functions.is_some_and(|f| f.positive.contains(symbol));
        match self.atoms.atom(var) {
            Atom::Symbol(symbol) => known(symbol),
            Atom::Root { .. } => true,
            Atom::Opaque(Expr::Call(Function::Exp | Function::Abs, _)) => true,
            Atom::Opaque(Expr::Power(_, exponent)) => {
                matches!(&**exponent, Expr::Number(e) if e.denom().is_even())
            }
            _ => false,
        }
    }

    /// `√(p²) = |p|`; `None` where the value is not seen to be a square.
    pub(super) fn root_of_square(
        &mut self,
        value: &Fraction,
    ) -> Result<Option<Fraction>, LowerError> {
        if value.is_zero() || value.denominator().any(|(_, exponent)| exponent % 2 == 1) {
            return Ok(None);
        }
        let Some(mut root) = square_root(value.numerator())?.map(Fraction::from) else {
            return Ok(None);
        };
        for (factor, exponent) in value.denominator() {
            let below = Fraction::from(factor.clone()).pow(exponent / 2)?;
            root = root.times(&inverse(&below)?)?;
        }
        self.absolute(&root).map(Some)
    }

    /// The derivative of a function of a term by the chain rule; `None` for those that have none everywhere.
    pub(super) fn derivative_of_call(
        &mut self,
        function: Function,
        argument: &Expr,
        variable: &Symbol,
    ) -> Result<Option<Fraction>, LowerError> {
        if matches!(
            function,
            Function::Ceiling
                | Function::Floor
                | Function::Tan
                | Function::ArcSin
                | Function::ArcCos
        ) {
            return Ok(None);
        }
        let value = self.lower_apart(argument)?;
        let inner = self.derivative(&value, variable)?;
        let outer = match function {
            Function::Sin => self.angle(&value)?.1,
            Function::Cos => self.angle(&value)?.0.negated(),
            Function::Exp => self.exponential(&value)?,
            Function::Ln => self.recip(&value)?,
            Function::ArcTan => self.recip(&one().plus(&value.times(&value)?)?)?,
            // |p|′ = |p| / p · p′, where p is not 0.
            _ => self.absolute(&value)?.times(&self.recip(&value)?)?,
        };
        Ok(Some(outer.times(&inner)?))
    }
}

fn one() -> Fraction {
    Rational::one().into()
}

/// The inverse of what is known not to vanish wherever it is made use of.
pub(super) fn inverse(value: &Fraction) -> Lowered {
    value.recip()?.ok_or(LowerError::DivisionByZero)
}

/// The only unknown of a polynomial that is one.
pub(super) fn alone(polynomial: &Polynomial) -> Option<Var> {
    let vars = polynomial.vars();
    (vars.len() == 1 && *polynomial == Polynomial::var(vars[0])).then(|| vars[0])
}

/// A value as a sum of numbers times units.
fn summands(value: &Fraction) -> Result<Vec<(Rational, Fraction)>, LowerError> {
    let mut below = one();
    for (factor, exponent) in value.denominator() {
        below = below.times(&Fraction::from(factor.clone()).pow(exponent)?)?;
    }
    let below = inverse(&below)?;
    let terms = value.numerator().terms().map(|(monomial, number)| {
        let unit = Polynomial::term(monomial.clone(), Rational::one());
        Ok((number.clone(), Fraction::from(unit).times(&below)?))
    });
    terms.collect()
}

/// The sine and cosine of a sum: `(c + i s)(c′ + i s′)`.
fn turned(a: &SineCosine, b: &SineCosine) -> Result<SineCosine, TooLarge> {
    let sine = a.0.times(&b.1)?.plus(&a.1.times(&b.0)?)?;
    let cosine = a.1.times(&b.1)?.minus(&a.0.times(&b.0)?)?;
    Ok((sine, cosine))
}

/// The sine and cosine of a multiple of an angle, in powers of those of the angle.
pub fn multiplied(angle: &SineCosine, times: u32) -> Result<SineCosine, TooLarge> {
    let mut whole = (Fraction::default(), one());
    for _ in 0..times {
        whole = turned(&whole, angle)?;
    }
    Ok(whole)
}

/// The root of a polynomial that is a square, one of both.
pub(super) fn square_root(polynomial: &Polynomial) -> Result<Option<Polynomial>, TooLarge> {
    let Some((monomial, number)) = polynomial.leading() else {
        return Ok(None);
    };
    let (Some(monomial), Some(number)) = (monomial.sqrt(), exact_square_root(number)) else {
        return Ok(None);
    };
    let twice = &number + &number;
    let mut root = Polynomial::term(monomial.clone(), number);
    let mut rest = polynomial.minus(&root.pow(2)?);
    for _ in 0..MOST_TERMS_OF_A_ROOT {
        let Some((next, number)) = rest.leading() else {
            return Ok(Some(root));
        };
        let Some(next) = next.divided_by(&monomial).filter(|next| *next < monomial) else {
            return Ok(None);
        };
        // (r + n)² = r² + n (2 r + n)
        let next = Polynomial::term(next, number / &twice);
        let both = root.plus(&root).plus(&next);
        rest = rest.minus(&next.times(&both)?);
        root = root.plus(&next);
    }
    Ok(None)
}
