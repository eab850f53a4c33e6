//! From terms as written to rational functions: `Expr` in, [`Fraction`] out, with all that must not vanish.

use std::fmt;

use num_integer::Integer;
use num_traits::{ToPrimitive, Zero};

use super::indexed::element_name;
use super::partial::Held;
use super::{
    Atom, Atoms, BigRational, Conditions, Expr, Fraction, Functions, Monomial, Polynomial, Powers,
    Rational, Symbol, TooLarge, expr_of_fraction,
};
use crate::sorted::Set;

/// Exponents up to this are multiplied out without asking whether that grows too large.
const SMALL_EXPONENT: u32 = 64;

/// Why a term has no value as a rational function.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum LowerError {
    /// Too large to expand.
    TooLarge,
    /// Something is divided by an expression that is identically 0.
    DivisionByZero,
}

impl From<TooLarge> for LowerError {
    fn from(_: TooLarge) -> Self {
        LowerError::TooLarge
    }
}

impl fmt::Display for LowerError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            LowerError::TooLarge => TooLarge.fmt(f),
            LowerError::DivisionByZero => f.write_str("division by an expression that is always 0"),
        }
    }
}

/// Reads terms into rational functions over one table of atoms.
pub struct Lowering<'a> {
    /// The unknowns met so far.
    pub atoms: &'a mut Atoms,
    /// The symbols that name sequences.
    pub sequences: &'a Set<Symbol>,
    /// The symbols that depend on no variable of differentiation.
    pub constants: &'a Set<Symbol>,
    /// Symbols that do not depend on another.
    pub still: &'a Set<(Symbol, Symbol)>,
    /// How powers are taken apart; `None` to read them as they are written.
    pub powers: Option<&'a Powers>,
    /// What is known of symbols where functions are taken apart.
    pub functions: Option<&'a Functions>,
    /// What does not change while a partial derivative is taken.
    pub partial: Option<Held>,
    /// What the values found so far depend on.
    pub conditions: Conditions,
}

pub(super) type Lowered = Result<Fraction, LowerError>;

impl<'a> Lowering<'a> {
    /// Reads terms as they are written, no symbol a sequence or known to be constant.
    pub fn plain(atoms: &'a mut Atoms) -> Self {
        static NONE: Set<Symbol> = Set::new();
        static NO_PAIRS: Set<(Symbol, Symbol)> = Set::new();
        Lowering {
            atoms,
            sequences: &NONE,
            constants: &NONE,
            still: &NO_PAIRS,
            powers: None,
            functions: None,
            partial: None,
            conditions: Conditions::default(),
        }
    }
}

impl Lowering<'_> {
    /// The same over another table of atoms, where nothing is needed yet.
    pub(super) fn over<'b>(&'b self, atoms: &'b mut Atoms) -> Lowering<'b> {
        Lowering {
            atoms,
            sequences: self.sequences,
            constants: self.constants,
            still: self.still,
            powers: self.powers,
            functions: self.functions,
            partial: None,
            conditions: Conditions::default(),
        }
    }

    /// The value of a term; [`Lowering::conditions`] grows by what it needs.
    pub fn lower(&mut self, expr: &Expr) -> Lowered {
        match expr {
            Expr::Number(value) => Ok(Rational::from(value).into()),
            Expr::Symbol(symbol) => {
                let power = self.symbol_power(symbol, 1);
                Ok(Polynomial::term(power, Rational::one()).into())
            }
            Expr::Element { sequence, index } => Ok(self.atom(Atom::Bound {
                sequence: sequence.clone(),
                index: index.clone(),
            })),
            Expr::Sum(terms) => self.sum(terms),
            Expr::Product(factors) => self.product(factors),
            Expr::Negate(inner) => Ok(self.lower(inner)?.negated()),
            Expr::Quotient(above, below) => {
                let above = self.lower(above)?;
                let inverse = match inverse(below) {
                    Some(number) => number.into(),
                    None => self.inverse(below)?,
                };
                Ok(above.times(&inverse)?)
            }
            Expr::Power(base, exponent) => match self.simple_factor(expr) {
                Some((power, number)) => Ok(Polynomial::term(power, number).into()),
                None => self.power(base, exponent),
            },
            Expr::Series {
                index,
                from,
                to,
                body,
            } => self.series(expr, index, from, to, body),
            Expr::Derivative { body, variable } => self.differentiated(body, variable, None),
            Expr::Partial {
                body,
                variable,
                held,
            } => self.partial(body, variable, held.as_deref()),
            Expr::Limit {
                body,
                variable,
                point,
            } => self.limit(body, variable, point),
            Expr::Call(function, argument) => self.call(*function, argument),
            Expr::Apply(function, arguments) => {
                let opaque = Expr::Apply(function.clone(), arguments.clone());
                Ok(self.atom(Atom::Opaque(opaque)))
            }
            Expr::Integral {
                body,
                variable,
                from,
                to,
            } => self.integral(expr, body, variable, from, to),
        }
    }

    /// Most products are of numbers and powers of symbols: these are multiplied in one go.
    fn product(&mut self, factors: &[Expr]) -> Lowered {
        let (mut monomial, mut coefficient) = (Monomial::one(), Rational::one());
        let mut others: Option<Fraction> = None;
        for factor in factors {
            if let Some((own, number)) = self.simple_factor(factor) {
                monomial = monomial.times(&own);
                coefficient *= number;
                continue;
            }
            let factor = self.lower(factor)?;
            others = Some(match others {
                Some(others) => others.times(&factor)?,
                None => factor,
            });
        }
        match others {
            Some(others) if monomial.is_one() && coefficient.is_one() => Ok(others),
            others => {
                let simple: Fraction = Polynomial::term(monomial, coefficient).into();
                Ok(match others {
                    Some(others) => simple.times(&others)?,
                    None => simple,
                })
            }
        }
    }

    /// A number, one over another, a symbol or a small natural power of one.
    fn simple_factor(&mut self, factor: &Expr) -> Option<(Monomial, Rational)> {
        let (symbol, exponent) = match factor {
            Expr::Number(value) => return Some((Monomial::one(), value.into())),
            Expr::Quotient(above, below) => {
                let Expr::Number(above) = &**above else {
                    return None;
                };
                return Some((Monomial::one(), Rational::from(above) * inverse(below)?));
            }
            Expr::Symbol(symbol) => (symbol, 1),
            Expr::Power(base, exponent) => {
                let Expr::Symbol(symbol) = &**base else {
                    return None;
                };
                let whole = natural(exponent)?;
                (
                    symbol,
                    Some(whole).filter(|e| (1..=SMALL_EXPONENT).contains(e))?,
                )
            }
            _ => return None,
        };
        Some((self.symbol_power(symbol, exponent), Rational::one()))
    }

    /// A power of a symbol: of its root, where it is read so.
    fn symbol_power(&mut self, symbol: &Symbol, exponent: u32) -> Monomial {
        if let Some(element) = self.element(symbol) {
            return Monomial::power(self.atoms.var(element), exponent);
        }
        let order = self.powers.and_then(|p| p.roots.get(symbol).copied());
        match order {
            None => Monomial::power(self.atoms.var_of_symbol(symbol), exponent),
            Some(order) => {
                let of = symbol.clone();
                let root = self.atoms.var(Atom::Root { of, order });
                Monomial::power(root, exponent * order)
            }
        }
    }

    pub(super) fn atom(&mut self, atom: Atom) -> Fraction {
        Polynomial::var(self.atoms.var(atom)).into()
    }

    /// `u_3` is an element where `u` is a sequence.
    pub(super) fn atom_of_symbol(&self, symbol: &Symbol) -> Atom {
        let element = self.element(symbol);
        element.unwrap_or_else(|| Atom::Symbol(symbol.clone()))
    }

    fn element(&self, symbol: &Symbol) -> Option<Atom> {
        if self.sequences.is_empty() {
            return None;
        }
        let (name, position) = element_name(symbol)?;
        let sequence = self.sequences.get(name)?.clone();
        Some(Atom::Element { sequence, position })
    }

    /// `1 / divisor`. Its factors are kept apart: `(x + y)^2` vanishes where `x + y` does.
    fn inverse(&mut self, divisor: &Expr) -> Lowered {
        let is_sum = |expr: &Expr| matches!(expr, Expr::Sum(_));
        let may_part = |factor: &Expr| match factor {
            Expr::Power(base, _) => is_sum(base),
            factor => is_sum(factor),
        };
        match divisor {
            Expr::Product(factors) if factors.iter().any(may_part) => {
                let mut whole = Fraction::from(Rational::one());
                for factor in factors.iter() {
                    whole = whole.times(&self.inverse(factor)?)?;
                }
                Ok(whole)
            }
            Expr::Power(base, exponent) if is_sum(base) => match natural(exponent) {
                // `0^0` is 1: of what has that exponent nothing is said.
                Some(exponent) if exponent > 0 => Ok(self.inverse(base)?.pow(exponent)?),
                _ => self.inverted(divisor),
            },
            _ => self.inverted(divisor),
        }
    }

    fn inverted(&mut self, divisor: &Expr) -> Lowered {
        let divisor = self.lower(divisor)?;
        self.recip(&divisor)
    }

    pub(super) fn recip(&mut self, value: &Fraction) -> Lowered {
        let inverse = value.recip()?.ok_or(LowerError::DivisionByZero)?;
        for (factor, _) in inverse.denominator() {
            self.conditions.nonzero.insert(factor.clone());
        }
        Ok(inverse)
    }

    fn power(&mut self, base: &Expr, exponent: &Expr) -> Lowered {
        let base = self.lower(base)?;
        if let Expr::Number(exponent) = exponent {
            return self.rational_power(&base, &exponent.into());
        }
        let exponent = self.lower(exponent)?;
        if let Some(exponent) = exponent.as_constant() {
            return self.rational_power(&base, &exponent);
        }
        if let Some(powers) = self.powers
            && let Some(value) = self.symbolic_power(&base, &exponent, powers)?
        {
            return Ok(value);
        }
        match exponent.as_polynomial() {
            Some(exponent) => self.require_base(&base, exponent)?,
            None => {
                self.conditions.positive.insert(sign_of_fraction(&base)?);
            }
        }
        let opaque = Expr::Power(
            expr_of_fraction(&base, self.atoms).into(),
            expr_of_fraction(&exponent, self.atoms).into(),
        );
        Ok(self.atom(Atom::Opaque(opaque)))
    }

    fn rational_power(&mut self, base: &Fraction, exponent: &Rational) -> Lowered {
        if exponent.is_negative() {
            if exponent.is_integer() {
                let inverse = self.recip(base)?;
                return self.rational_power(&inverse, &-exponent);
            }
            // `a^{-5/2}` speaks of the root that `1/a^{5/2}` and `\sqrt a` speak of, not of that of `1/a`.
            let power = self.rational_power(base, &-exponent)?;
            return self.recip(&power);
        }
        if exponent.is_integer() {
            let power = exponent.to_u32().ok_or(LowerError::TooLarge)?;
            return Ok(base.pow(power)?);
        }
        let power = exponent.numer().to_u32().ok_or(LowerError::TooLarge)?;
        if self.powers.is_some() {
            let order = exponent.denom().to_u32().ok_or(LowerError::TooLarge)?;
            return self.root_taken_apart(base, power, order);
        }
        let root = match base.as_constant().and_then(|c| exact_root(&c, exponent)) {
            Some(root) => root.into(),
            None => {
                if exponent.denom() == 2.into()
                    && let Some(root) = self.root_of_square(base)?
                {
                    return Ok(root.pow(power)?);
                }
                if exponent.denom().is_even() {
                    self.conditions.nonnegative.insert(sign_of_fraction(base)?);
                }
                let written = expr_of_fraction(base, self.atoms);
                let unit = BigRational::new_raw(1.into(), exponent.denom());
                self.atom(Atom::Opaque(Expr::Power(
                    written.into(),
                    Expr::Number(unit).into(),
                )))
            }
        };
        Ok(root.pow(power)?)
    }
}

/// One over a number, where that is one.
fn inverse(divisor: &Expr) -> Option<Rational> {
    match divisor {
        Expr::Number(number) if !number.is_zero() => Some(Rational::from(number).recip()),
        _ => None,
    }
}

/// An exponent that is a natural number or 0.
fn natural(exponent: &Expr) -> Option<u32> {
    match exponent {
        Expr::Number(exponent) if exponent.is_integer() => exponent.numer().to_u32(),
        _ => None,
    }
}

/// A polynomial with the sign of a rational function.
pub fn sign_of_fraction(value: &Fraction) -> Result<Polynomial, TooLarge> {
    let mut polynomial = value.numerator().clone();
    for (factor, exponent) in value.denominator() {
        if exponent % 2 == 1 {
            polynomial = polynomial.times(factor)?;
        }
    }
    Ok(polynomial)
}

/// The q-th root of a number for an exponent p/q, where it is rational.
fn exact_root(value: &Rational, exponent: &Rational) -> Option<Rational> {
    let q = exponent.denom().to_u32()?;
    if value.is_negative() || q > 64 {
        return None;
    }
    let (above, below) = (value.numer().nth_root(q), value.denom().nth_root(q));
    let exact = above.pow(q) == value.numer() && below.pow(q) == value.denom();
    exact.then(|| BigRational::new(above, below).into())
}
