//! Terms over intervals.
//!
//! In plain interval arithmetic `x/x` is not 1, for both places take any value. So a term is first written as a sum of products of powers,
//! in which equal factors are put together; then each factor takes its values. Sums are not multiplied out: a sum that is a
//! factor counts as one.

use num_traits::Zero;

use super::{Interval, PI, power};
use crate::algebra::{BigRational, Expr, Function, Rational, Symbol};
use crate::sorted::{Map, Set};

/// Longer sums are not put together.
const MOST_TERMS: usize = 256;
/// Deeper terms are not evaluated.
const DEEPEST: usize = 64;

/// Why a term has no interval.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NoInterval {
    /// Nothing says what a symbol is.
    Unknown(Symbol),
    /// A divisor may be 0, or the base of a root negative.
    Undefined(Expr),
    /// A kind of term that is not evaluated.
    Unsupported(Expr),
    /// Too long or too deep.
    TooLarge,
}

/// What is known of symbols.
#[derive(Clone, Debug, Default)]
pub struct Figures {
    known: Map<Symbol, Interval>,
    free: Set<Symbol>,
}

/// Factors with their exponents, which are not 0.
type Powers = Map<Expr, Rational>;
/// A sum of products of powers, with their coefficients, which are not 0.
type Terms = Map<Powers, Rational>;
/// The values of factors with their exponents that were found.
type Known = Map<(Expr, Rational), Interval>;

/// What figures give for the two sides of a relation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Compared {
    /// The left side.
    pub left: Interval,
    /// The right side.
    pub right: Interval,
    /// Left minus right.
    pub difference: Interval,
    /// Left over right; nothing where the right side may be 0.
    pub ratio: Option<Interval>,
}

impl FromIterator<(Symbol, Interval)> for Figures {
    fn from_iter<T: IntoIterator<Item = (Symbol, Interval)>>(figures: T) -> Self {
        Figures {
            known: figures.into_iter().collect(),
            free: Set::new(),
        }
    }
}

impl Figures {
    /// The same with symbols of which nothing is known but that they are not 0, and below roots positive: a term has a value where they
    /// cancel.
    pub fn but_free(self, free: &Set<Symbol>) -> Figures {
        Figures {
            free: free.clone(),
            ..self
        }
    }

    /// What is known of a symbol; π is known to everybody.
    pub fn of(&self, symbol: &Symbol) -> Option<Interval> {
        let is_pi = symbol.name() == "\\pi" && !self.free.contains(symbol);
        let pi = || is_pi.then(|| PI.clone());
        self.known.get(symbol).cloned().or_else(pi)
    }

    /// An interval with all values of a term.
    ///
    /// # Errors
    /// It has no value for some figures, or is of a kind that is not evaluated.
    pub fn value(&self, term: &Expr) -> Result<Interval, NoInterval> {
        self.interval(&self.terms(term, 0)?, 0)
    }

    /// Both sides of a relation, their difference and their quotient, each term read once.
    ///
    /// # Errors
    /// As [`Figures::value`], for either side.
    pub fn compared(&self, left: &Expr, right: &Expr) -> Result<Compared, NoInterval> {
        let (above, below) = (self.terms(left, 0)?, self.terms(right, 0)?);
        // The same factors are in all of these.
        let known = &mut Known::new();
        let a = self.interval_with(known, &above, 0)?;
        let b = self.interval_with(known, &below, 0)?;
        Ok(Compared {
            difference: self.difference(known, &above, &below, &a - &b),
            ratio: a
                .over(&b)
                .and_then(|plain| self.quotient(known, &above, &below, right, plain).ok()),
            left: a,
            right: b,
        })
    }

    /// The quotient of two terms, in which what is common to both is cancelled, where nothing else is left than that is known.
    ///
    /// # Errors
    /// As [`Figures::value`].
    pub fn ratio(&self, left: &Expr, right: &Expr) -> Result<Interval, NoInterval> {
        let (above, below) = (self.terms(left, 0)?, self.terms(right, 0)?);
        let quotient = self.reduced(&above, &below, right)?;
        let undefined = || NoInterval::Undefined(right.clone());
        self.interval(&quotient.ok_or_else(undefined)?, 0)
    }

    /// The difference, in which what is common to both is cancelled.
    fn difference(
        &self,
        known: &mut Known,
        left: &Terms,
        right: &Terms,
        plain: Interval,
    ) -> Interval {
        let mut joint = left.clone();
        for (powers, coefficient) in right {
            add(&mut joint, powers.clone(), -coefficient);
        }
        if joint.len() > MOST_TERMS {
            return plain;
        }
        match self.interval_with(known, &joint, 0) {
            Ok(joint) => plain.meet(&joint).unwrap_or(joint),
            Err(_) => plain,
        }
    }

    /// The quotient, in which what is common to both is cancelled.
    fn quotient(
        &self,
        known: &mut Known,
        above: &Terms,
        below: &Terms,
        divisor: &Expr,
        plain: Interval,
    ) -> Result<Interval, NoInterval> {
        let Some(sum) = self.reduced(above, below, divisor)? else {
            return Ok(plain);
        };
        let joint = self.interval_with(known, &sum, 0)?;
        Ok(plain.meet(&joint).unwrap_or(joint))
    }

    /// A quotient with what is common to both cancelled, where the divisor is one product.
    fn reduced(
        &self,
        above: &Terms,
        below: &Terms,
        divisor: &Expr,
    ) -> Result<Option<Terms>, NoInterval> {
        let mut inverse = self.raised(below.clone(), divisor, &Rational::from(-1), 0)?;
        let (Some((powers, factor)), true) = (inverse.pop_first(), inverse.is_empty()) else {
            return Ok(None);
        };
        let mut sum = Terms::new();
        for (own, coefficient) in above {
            add(&mut sum, multiplied(own, &powers), coefficient * &factor);
        }
        Ok(Some(sum))
    }

    fn interval(&self, terms: &Terms, depth: usize) -> Result<Interval, NoInterval> {
        self.interval_with(&mut Known::new(), terms, depth)
    }

    /// The same where some factors are known at this depth.
    fn interval_with(
        &self,
        known: &mut Known,
        terms: &Terms,
        depth: usize,
    ) -> Result<Interval, NoInterval> {
        let mut sum = Interval::exactly(BigRational::zero());
        for (powers, coefficient) in terms {
            let mut product = Interval::exactly(coefficient.to_big());
            for (factor, exponent) in powers {
                let own = (factor.clone(), exponent.clone());
                if let Some(power) = known.get(&own) {
                    product = &product * power;
                    continue;
                }
                let value = self.factor(factor, depth)?;
                let power = value.power(&exponent.to_big());
                let power = power.ok_or_else(|| NoInterval::Undefined(factor.clone()))?;
                product = &product * &power;
                known.insert(own, power);
            }
            sum = &sum + &product;
        }
        Ok(sum)
    }

    /// What is not taken apart any further.
    fn factor(&self, factor: &Expr, depth: usize) -> Result<Interval, NoInterval> {
        if depth > DEEPEST {
            return Err(NoInterval::TooLarge);
        }
        match factor {
            Expr::Number(value) => Ok(Interval::exactly(value.clone())),
            Expr::Symbol(symbol) => self
                .of(symbol)
                .ok_or_else(|| NoInterval::Unknown(symbol.clone())),
            Expr::Call(function, inner) => {
                let inner = self.deeper(inner, depth)?;
                let value = inner.under(*function);
                value.ok_or_else(|| NoInterval::Undefined(factor.clone()))
            }
            Expr::Power(base, exponent) => {
                let undefined = || NoInterval::Undefined(factor.clone());
                let base = self.deeper(base, depth)?;
                if let Some(power) = number(exponent).and_then(|number| base.power(&number)) {
                    return Ok(power);
                }
                // `b^x = exp(x ln b)`
                let logarithm = base.under(Function::Ln).ok_or_else(undefined)?;
                let exponent = self.deeper(exponent, depth)?;
                let value = (&exponent * &logarithm).under(Function::Exp);
                value.ok_or_else(undefined)
            }
            _ => self.deeper(factor, depth),
        }
    }

    fn deeper(&self, term: &Expr, depth: usize) -> Result<Interval, NoInterval> {
        self.interval(&self.terms(term, depth + 1)?, depth + 1)
    }

    fn terms(&self, term: &Expr, depth: usize) -> Result<Terms, NoInterval> {
        if depth > DEEPEST {
            return Err(NoInterval::TooLarge);
        }
        let deeper = |inner: &Expr| self.terms(inner, depth + 1);
        match term {
            Expr::Number(value) => Ok(constant(value.into())),
            Expr::Symbol(_) | Expr::Call(..) => Ok(single(term, Rational::one())),
            Expr::Sum(parts) => {
                let mut sum = Terms::new();
                for part in parts.iter() {
                    for (powers, coefficient) in deeper(part)? {
                        add(&mut sum, powers, coefficient);
                    }
                }
                match sum.len() > MOST_TERMS {
                    true => Err(NoInterval::TooLarge),
                    false => Ok(sum),
                }
            }
            Expr::Negate(inner) => {
                let negated = deeper(inner)?.into_iter();
                Ok(negated.map(|(powers, c)| (powers, -c)).collect())
            }
            Expr::Product(factors) => {
                let mut product = constant(Rational::one());
                for factor in factors.iter() {
                    product = times(product, whole(deeper(factor)?, factor));
                }
                Ok(product)
            }
            Expr::Quotient(above, below) => {
                let inverse = self.raised(deeper(below)?, below, &Rational::from(-1), depth)?;
                Ok(times(whole(deeper(above)?, above), inverse))
            }
            Expr::Power(base, exponent) => match number(exponent) {
                Some(exponent) if power::is_plain(&exponent) => {
                    self.raised(deeper(base)?, base, &exponent.into(), depth)
                }
                _ => Ok(single(term, Rational::one())),
            },
            _ => Err(NoInterval::Unsupported(term.clone())),
        }
    }

    /// A power of what `base` was read as.
    fn raised(
        &self,
        terms: Terms,
        base: &Expr,
        exponent: &Rational,
        depth: usize,
    ) -> Result<Terms, NoInterval> {
        if exponent.is_one() {
            return Ok(terms);
        }
        if exponent.is_zero() {
            return Ok(constant(Rational::one()));
        }
        if terms.is_empty() && exponent.is_negative() {
            return Err(NoInterval::Undefined(base.clone()));
        }
        let mut product = whole(terms, base);
        let Some((powers, coefficient)) = product.pop_first() else {
            return Ok(Terms::new());
        };
        // `(x²)^(1/2)` is not `x` for all `x`, and `1/x` not `x/x²` where `x` may be 0.
        for factor in powers.keys() {
            let is_free = matches!(factor, Expr::Symbol(own) if self.free.contains(own));
            if is_free {
                continue;
            }
            let value = self.factor(factor, depth + 1)?;
            let known = match exponent.is_integer() {
                true => exponent.is_positive() || value.recip().is_some(),
                false => value.is_positive(),
            };
            if !known && exponent.is_integer() {
                return Err(NoInterval::Undefined(base.clone()));
            }
            if !known {
                let exponent = Expr::Number(exponent.to_big());
                let power = Expr::Power(base.clone().into(), exponent.into());
                return Ok(single(&power, Rational::one()));
            }
        }
        let mut raised: Powers = powers
            .into_iter()
            .map(|(factor, own)| (factor, own * exponent))
            .collect();
        if exponent.is_integer() {
            let value = Interval::exactly(coefficient.to_big()).power(&exponent.to_big());
            let value = value.ok_or(NoInterval::TooLarge)?;
            return Ok(Map::from([(raised, value.low.into())]));
        }
        if coefficient.is_negative() {
            return Err(NoInterval::Undefined(base.clone()));
        }
        if !coefficient.is_one() {
            *raised
                .entry(Expr::Number(coefficient.to_big()))
                .or_insert_with(Rational::zero) += exponent;
        }
        raised.retain(|_, exponent| !exponent.is_zero());
        Ok(Map::from([(raised, Rational::one())]))
    }
}

/// A rational number, however it is written.
pub(super) fn number(term: &Expr) -> Option<BigRational> {
    match term {
        Expr::Number(value) => Some(value.clone()),
        Expr::Negate(inner) => Some(-number(inner)?),
        Expr::Quotient(above, below) => {
            let below = number(below).filter(|below| !below.is_zero())?;
            Some(number(above)? / below)
        }
        _ => None,
    }
}

fn constant(value: Rational) -> Terms {
    match value.is_zero() {
        true => Terms::new(),
        false => Map::from([(Powers::new(), value)]),
    }
}

fn single(factor: &Expr, exponent: Rational) -> Terms {
    Map::from([(Map::from([(factor.clone(), exponent)]), Rational::one())])
}

/// A sum of several terms as a factor of its own.
fn whole(terms: Terms, term: &Expr) -> Terms {
    match terms.len() > 1 {
        true => single(term, Rational::one()),
        false => terms,
    }
}

/// The product of what has one term each, or none.
fn times(left: Terms, right: Terms) -> Terms {
    let mut product = Terms::new();
    for (own, a) in &left {
        for (other, b) in &right {
            add(&mut product, multiplied(own, other), a * b);
        }
    }
    product
}

fn multiplied(left: &Powers, right: &Powers) -> Powers {
    let mut product = left.clone();
    for (factor, exponent) in right {
        *product.entry(factor.clone()).or_insert_with(Rational::zero) += exponent;
    }
    product.retain(|_, exponent| !exponent.is_zero());
    product
}

fn add(sum: &mut Terms, powers: Powers, coefficient: Rational) {
    let total = sum.entry(powers.clone()).or_insert_with(Rational::zero);
    *total += coefficient;
    if total.is_zero() {
        sum.remove(&powers);
    }
}
