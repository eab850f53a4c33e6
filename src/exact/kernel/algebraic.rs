//! Exact numbers: polynomials in one real algebraic number α.
//!
//! α is given by a polynomial and two rational numbers between which it has one root. Nothing is approximated: the
//! sign of `f(α)`, 0 included, is the sum of the signs of `f` at all roots of the polynomial between the two, which a
//! sequence of remainders tells. So the polynomial need not be irreducible, and nothing is ever inverted.

use std::cmp::Ordering;

use num_traits::{One, ToPrimitive};

use super::witness::Point;
use super::{Algebraic, Domain, Reject};
use crate::algebra::{
    Atom, BigRational, Expr, Fraction, Function, Polynomial, Rational, Relation, Symbol,
    Univariate, Var, sum_of_signs,
};
use crate::sorted::Map;

/// Polynomials of a higher degree are refused, as given and as powers of what is given.
const HIGHEST_DEGREE: usize = 12;
const HIGHEST_POWER: u32 = 1 << 12;
/// Longer numbers are refused, as given and as computed.
const LONGEST_GIVEN: u64 = 256;
const LONGEST_NUMBER: u64 = 2_048;

/// The numbers `Σ c_k α^k`, α being the one root of a polynomial between two numbers.
#[derive(Clone, Debug)]
pub struct Field {
    polynomial: Univariate,
    low: Rational,
    high: Rational,
}

impl Field {
    /// The field of a root.
    ///
    /// # Errors
    /// The polynomial has a root more than once, or at one of the two numbers, or none or several between them; or it
    /// is too large.
    pub fn new(polynomial: Univariate, low: Rational, high: Rational) -> Result<Field, Reject> {
        let ends = Univariate::new([low.clone(), high.clone()]);
        if polynomial.degree() > HIGHEST_DEGREE
            || polynomial.bits().max(ends.bits()) > LONGEST_GIVEN
        {
            return Err(Reject::TooLarge);
        }
        if polynomial.degree() == 0 || low >= high {
            return Err(Reject::NotIsolated(0));
        }
        let remainders = polynomial.signed_remainders(&polynomial.derivative());
        if remainders.last().is_none_or(|last| last.degree() > 0) {
            return Err(Reject::NotSquarefree);
        }
        if polynomial.at(&low).is_zero() || polynomial.at(&high).is_zero() {
            return Err(Reject::RootAtEnd);
        }
        match sum_of_signs(&remainders, &low, &high) {
            1 => Ok(Field {
                polynomial,
                low,
                high,
            }),
            roots => Err(Reject::NotIsolated(roots.to_usize().unwrap_or(0))),
        }
    }

    /// The polynomial that vanishes at α.
    pub fn polynomial(&self) -> &Univariate {
        &self.polynomial
    }

    /// The two numbers between which α lies.
    pub fn ends(&self) -> (&Rational, &Rational) {
        (&self.low, &self.high)
    }

    /// The number `Σ c_k α^k`.
    ///
    /// # Errors
    /// It is too large.
    pub fn number<'a>(
        &self,
        coefficients: impl IntoIterator<Item = &'a BigRational>,
    ) -> Result<Univariate, Reject> {
        let given = coefficients.into_iter().take(HIGHEST_DEGREE + 2);
        let number = Univariate::new(given.map(Rational::from));
        match number.degree() > HIGHEST_DEGREE || number.bits() > LONGEST_GIVEN {
            true => Err(Reject::TooLarge),
            false => self.reduced(&number),
        }
    }

    fn reduced(&self, number: &Univariate) -> Result<Univariate, Reject> {
        let number = number.modulo(&self.polynomial);
        match number.bits() > LONGEST_NUMBER {
            true => Err(Reject::TooLarge),
            false => Ok(number),
        }
    }

    /// The product.
    ///
    /// # Errors
    /// It is too large.
    pub fn times(&self, a: &Univariate, b: &Univariate) -> Result<Univariate, Reject> {
        self.reduced(&a.times(b))
    }

    /// The power, by repeated squaring.
    ///
    /// # Errors
    /// It is too large.
    pub fn power(&self, base: &Univariate, exponent: u32) -> Result<Univariate, Reject> {
        if exponent > HIGHEST_POWER {
            return Err(Reject::TooLarge);
        }
        let mut power = Univariate::constant(Rational::one());
        for bit in (0..u32::BITS - exponent.leading_zeros()).rev() {
            power = self.times(&power, &power)?;
            if exponent >> bit & 1 == 1 {
                power = self.times(&power, base)?;
            }
        }
        Ok(power)
    }

    /// How a number compares with 0.
    ///
    /// $$ \operatorname{sign} f(\alpha) = \sum_{a < c < b,\; p(c) = 0} \operatorname{sign} f(c) $$
    pub fn sign(&self, number: &Univariate) -> Ordering {
        if let Some(value) = number.as_constant() {
            return value.cmp(&Rational::zero());
        }
        let query = self.polynomial.derivative().times(number);
        let query = query.modulo(&self.polynomial);
        let remainders = self.polynomial.signed_remainders(&query);
        sum_of_signs(&remainders, &self.low, &self.high).cmp(&0)
    }

    /// The value of a polynomial, its unknowns being such numbers.
    ///
    /// # Errors
    /// One has no value, or something is too large.
    pub fn evaluate(
        &self,
        polynomial: &Polynomial,
        mut value: impl FnMut(Var) -> Result<Univariate, Reject>,
    ) -> Result<Univariate, Reject> {
        let mut sum = Univariate::default();
        for (monomial, coefficient) in polynomial.terms() {
            let mut term = Univariate::constant(coefficient.clone());
            for &(var, exponent) in monomial.powers() {
                term = self.times(&term, &self.power(&value(var)?, exponent)?)?;
            }
            sum = self.reduced(&sum.plus(&term))?;
        }
        Ok(sum)
    }
}

/// The values of a point's unknowns in a field.
pub(super) struct InField {
    field: Field,
    symbols: Map<Symbol, Univariate>,
    roots: Map<Expr, Univariate>,
    found: Map<Var, Univariate>,
}

impl Point<'_> {
    /// Takes the values that are polynomials in a root, each within its domain.
    pub(super) fn take_field(&mut self) -> Result<(), Reject> {
        let Some(own) = self.at.algebraic.as_deref() else {
            return Ok(());
        };
        // Such a number and multiples of π, or functions that are constant, are not looked at together; and each symbol has one value.
        let pi = |symbol: &Symbol| self.problem.pi_is_the_number() && symbol.name() == "\\pi";
        let twice = |symbol: &Symbol| self.at.symbols.contains_key(symbol) || pi(symbol);
        let is_constant = |call: &Expr| matches!(call, Expr::Apply(..));
        if !self.at.in_pi.is_empty()
            || self.at.functions.keys().any(is_constant)
            || own.symbols.keys().any(twice)
        {
            return Err(Reject::NoValue);
        }
        let Algebraic {
            polynomial,
            low,
            high,
            ..
        } = own;
        // What is too long is not even copied.
        if polynomial.len() > HIGHEST_DEGREE + 1 {
            return Err(Reject::TooLarge);
        }
        let polynomial = Univariate::new(polynomial.iter().map(Rational::from));
        let field = Field::new(polynomial, low.into(), high.into())?;
        let mut symbols = Map::new();
        for (symbol, value) in &own.symbols {
            let value = field.number(value)?;
            if let Some(domain) = self.claim.domains.get(symbol)
                && !contains(&field, domain, &value)
            {
                return Err(Reject::OutsideDomain);
            }
            symbols.insert(symbol.clone(), value);
        }
        let roots = own.roots.iter();
        let roots = roots.map(|(term, value)| Ok((term.clone(), field.number(value)?)));
        let roots = roots.collect::<Result<_, Reject>>()?;
        self.in_field = Some(InField {
            field,
            symbols,
            roots,
            found: Map::new(),
        });
        Ok(())
    }

    /// How the value of a polynomial compares with 0. Of one in π its coefficients tell, as far as they have one sign: π is positive.
    pub(super) fn sign_in_field(&mut self, polynomial: &Polynomial) -> Result<Ordering, Reject> {
        let pi = self.problem.pi();
        let Some(pi) = pi.filter(|&pi| polynomial.degree_in(pi) > 0) else {
            let value = self.number_in_field(polynomial)?;
            return Ok(self.field()?.field.sign(&value));
        };
        let mut sign = Ordering::Equal;
        for coefficient in polynomial.in_powers_of(pi) {
            let value = self.number_in_field(&coefficient)?;
            let own = self.field()?.field.sign(&value);
            if sign.is_ne() && own.is_ne() && sign != own {
                return Err(Reject::NoValue);
            }
            sign = sign.then(own);
        }
        Ok(sign)
    }

    fn field(&self) -> Result<&InField, Reject> {
        self.in_field.as_ref().ok_or(Reject::NoValue)
    }

    fn number_in_field(&mut self, polynomial: &Polynomial) -> Result<Univariate, Reject> {
        for var in polynomial.vars() {
            if !self.field()?.found.contains_key(&var) {
                let value = self.unknown_in_field(var)?;
                let own = self.in_field.as_mut().ok_or(Reject::NoValue)?;
                own.found.insert(var, value);
            }
        }
        let own = self.field()?;
        own.field.evaluate(polynomial, |var| {
            own.found.get(&var).cloned().ok_or(Reject::NoValue)
        })
    }

    fn unknown_in_field(&mut self, var: Var) -> Result<Univariate, Reject> {
        match self.atoms.atom(var).clone() {
            Atom::Symbol(symbol) if self.field()?.symbols.contains_key(&symbol) => {
                let known = self.field()?.symbols.get(&symbol).cloned();
                known.ok_or(Reject::NoValue)
            }
            Atom::Opaque(Expr::Call(Function::Abs, inner)) => {
                let inner = self.lowered(&inner)?;
                let (above, below) = self.quotient_in_field(&inner)?;
                let below = below.as_constant().filter(|b| !b.is_zero());
                let value = above.scaled(&below.ok_or(Reject::NoValue)?.recip());
                Ok(match self.field()?.field.sign(&value) {
                    Ordering::Less => value.scaled(&-Rational::one()),
                    _ => value,
                })
            }
            Atom::Opaque(term) if self.field()?.roots.contains_key(&term) => {
                self.root_in_field(&term)
            }
            // All else has a rational value or none.
            _ => {
                let known = self.rational(var)?;
                Ok(Univariate::constant(known))
            }
        }
    }

    /// The value that is given for `(a/b)^(1/q)`, if it is that: `s^q b = a`, neither `s` nor `a/b` being negative.
    fn root_in_field(&mut self, term: &Expr) -> Result<Univariate, Reject> {
        let Expr::Power(base, exponent) = term else {
            return Err(Reject::NoValue);
        };
        let order = match &**exponent {
            Expr::Number(exponent) if exponent.numer().is_one() => exponent.denom().to_u32(),
            _ => None,
        };
        let order = order.ok_or(Reject::NoValue)?;
        let base = self.lowered(base)?;
        let (above, below) = self.quotient_in_field(&base)?;
        let InField { field, roots, .. } = self.field()?;
        let value = roots.get(term).ok_or(Reject::NoValue)?;
        let sign_of_base = field.sign(&field.times(&above, &below)?);
        let power = field.times(&field.power(value, order)?, &below)?;
        let is_root = field.sign(&power.minus(&above)).is_eq();
        if field.sign(&below).is_eq() || sign_of_base.is_lt() {
            return Err(Reject::NoValue);
        }
        match is_root && field.sign(value).is_ge() {
            true => Ok(value.clone()),
            false => Err(Reject::NoSuchValue),
        }
    }

    /// Numerator and denominator.
    fn quotient_in_field(&mut self, value: &Fraction) -> Result<(Univariate, Univariate), Reject> {
        let below = value.expanded_denominator()?;
        Ok((
            self.number_in_field(value.numerator())?,
            self.number_in_field(&below)?,
        ))
    }
}

/// Whether a number lies in a domain. None of these is taken for an integer.
fn contains(field: &Field, domain: &Domain, value: &Univariate) -> bool {
    let within = domain.bounds().all(|(relation, bound)| {
        let excess = value.minus(&Univariate::constant(bound.into()));
        let order = field.sign(&excess);
        match relation {
            Relation::Less => order.is_lt(),
            Relation::LessOrEqual => order.is_le(),
            Relation::Greater => order.is_gt(),
            Relation::GreaterOrEqual => order.is_ge(),
            Relation::NotEqual => order.is_ne(),
            _ => false,
        }
    });
    within && !domain.integer
}
