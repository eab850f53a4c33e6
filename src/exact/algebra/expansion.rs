//! Power series of terms in 1/N where N grows beyond all bounds: what `N sin(1/N)` and `N (√(1 + 1/N) − 1)` go to.
//!
//! A series is known up to an order and says nothing beyond. Its coefficients are exact, in terms of all else: `sin(a + 1/N)` begins
//! `sin a + cos a/N`. What is divided by must not begin with 0, what is under a root must begin with something positive; both are
//! conditions of the value. What has no such series, `√(1/N)` or `ln N`, has none here.

use super::effort::is_spent;
use super::lower::{LowerError, Lowering};
use super::{Expr, Fraction, Function, Rational, Symbol, expr_of_fraction, sign_of_fraction};

/// So many coefficients are worked out at first, and at most where those before cancel.
const FIRST_LENGTH: usize = 3;
const MOST_LENGTH: usize = 12;
/// Series are multiplied out up to this power.
const HIGHEST_POWER: u32 = 16;
/// No series begins further from order 0.
const FURTHEST: i32 = 4096;

/// `a_first/N^first + …`: what is not listed is not known. The first coefficient is not 0.
#[derive(Clone, Debug)]
struct Expansion {
    first: i32,
    known: Vec<Fraction>,
}

type Expanded = Result<Option<Expansion>, LowerError>;

impl Lowering<'_> {
    /// What a term goes to as a variable grows beyond all bounds, by its series; nothing where it has none, or grows itself.
    pub(super) fn limit_of_expansion(
        &mut self,
        body: &Expr,
        variable: &Symbol,
    ) -> Result<Option<Fraction>, LowerError> {
        let outer = std::mem::take(&mut self.conditions);
        let mut length = FIRST_LENGTH;
        let value = loop {
            self.conditions = Default::default();
            let found = self.expanded(body, variable, length)?;
            match found {
                // Nothing is left of it as far as it is known, which is far enough.
                Some(own) if own.first > 0 => break Some(Fraction::default()),
                Some(own) if own.first < 0 && !own.known.is_empty() => break None,
                Some(own) if !own.known.is_empty() => break own.known.into_iter().next(),
                _ if length >= MOST_LENGTH || is_spent() => break None,
                _ => length += FIRST_LENGTH,
            }
        };
        let own = std::mem::replace(&mut self.conditions, outer);
        if value.is_some() {
            self.conditions.extend(own);
        }
        Ok(value)
    }

    /// The series of a term, with so many coefficients where none cancel.
    fn expanded(&mut self, term: &Expr, variable: &Symbol, length: usize) -> Expanded {
        if !term.mentions(variable) {
            return Ok(Some(Expansion::of(self.lower(term)?, 0, length)));
        }
        match term {
            Expr::Symbol(_) => Ok(Some(Expansion::of(one(), -1, length))),
            Expr::Sum(terms) => {
                let mut whole: Option<Expansion> = None;
                for term in terms.iter() {
                    let Some(own) = self.expanded(term, variable, length)? else {
                        return Ok(None);
                    };
                    whole = Some(match whole {
                        Some(whole) => whole.plus(&own)?,
                        None => own,
                    });
                }
                Ok(whole)
            }
            Expr::Product(factors) => {
                let mut whole = Expansion::of(one(), 0, length);
                for factor in factors.iter() {
                    let Some(own) = self.expanded(factor, variable, length)? else {
                        return Ok(None);
                    };
                    whole = whole.times(&own)?;
                }
                Ok(Some(whole))
            }
            Expr::Negate(inner) => {
                let inner = self.expanded(inner, variable, length)?;
                Ok(inner.map(|own| own.each(Fraction::negated)))
            }
            Expr::Quotient(above, below) => {
                let above = self.expanded(above, variable, length)?;
                let below = self.expanded(below, variable, length)?;
                let (Some(above), Some(below)) = (above, below) else {
                    return Ok(None);
                };
                let inverse = self.expansion_raised(&below, &Rational::from(-1), length)?;
                inverse.map(|own| above.times(&own)).transpose()
            }
            Expr::Power(base, exponent) if !exponent.mentions(variable) => {
                let exponent = self.lower(exponent)?;
                let base = self.expanded(base, variable, length)?;
                let Some(base) = base else {
                    return Ok(None);
                };
                match exponent.as_constant() {
                    Some(exponent) => self.expansion_raised(&base, &exponent, length),
                    None => self.expansion_to_power(&base, &exponent, length),
                }
            }
            Expr::Call(function, argument) => {
                let argument = self.expanded(argument, variable, length)?;
                let Some(argument) = argument else {
                    return Ok(None);
                };
                self.expansion_in_function(*function, &argument, length)
            }
            _ => Ok(None),
        }
    }

    /// A series to a power that is a number.
    fn expansion_raised(
        &mut self,
        base: &Expansion,
        exponent: &Rational,
        length: usize,
    ) -> Expanded {
        if exponent.is_integer()
            && let Some(times) = exponent.to_u32()
        {
            if times > HIGHEST_POWER || is_spent() {
                return Err(LowerError::TooLarge);
            }
            let mut whole = Expansion::of(one(), 0, length);
            for _ in 0..times {
                whole = whole.times(base)?;
            }
            return Ok(Some(whole));
        }
        let order = exponent.clone() * Rational::from(base.first);
        let order = match order.is_integer() {
            true => i32::try_from(order.numer()).ok(),
            false => None,
        };
        let order = order.filter(|own| (-FURTHEST..=FURTHEST).contains(own));
        let (Some(order), Some(lead)) = (order, base.known.first()) else {
            return Ok(None);
        };
        let value = match exponent.is_integer() {
            true => {
                let inverse = self.recip(lead)?;
                let times = (-exponent).to_u32().ok_or(LowerError::TooLarge)?;
                inverse.pow(times)?
            }
            false => {
                self.conditions.positive.insert(sign_of_fraction(lead)?);
                let exponent = Expr::Number(exponent.to_big());
                let lead = expr_of_fraction(lead, self.atoms);
                self.lower(&Expr::Power(lead.into(), exponent.into()))?
            }
        };
        let whole = self.binomial(base, &exponent.clone().into(), length)?;
        Ok(whole
            .map(|own| own.scaled(&value))
            .transpose()?
            .map(|own| own.moved(order)))
    }

    /// A series that begins with a positive constant to a power that is none of its variable.
    fn expansion_to_power(
        &mut self,
        base: &Expansion,
        exponent: &Fraction,
        length: usize,
    ) -> Expanded {
        let (0, Some(lead)) = (base.first, base.known.first()) else {
            return Ok(None);
        };
        if lead.as_constant() == Some(Rational::from(1)) {
            return self.binomial(base, exponent, length);
        }
        self.conditions.positive.insert(sign_of_fraction(lead)?);
        let power = Expr::Power(
            expr_of_fraction(lead, self.atoms).into(),
            expr_of_fraction(exponent, self.atoms).into(),
        );
        let value = self.lower(&power)?;
        let whole = self.binomial(base, exponent, length)?;
        whole.map(|own| own.scaled(&value)).transpose()
    }

    /// `(1 + u)^e` for the series `lead (1 + u)`, by Newton's series. The lead is known not to be 0.
    fn binomial(&mut self, base: &Expansion, exponent: &Fraction, length: usize) -> Expanded {
        let Some(lead) = base.known.first().cloned() else {
            return Ok(None);
        };
        let inverse = self.recip(&lead)?;
        let mut rest = base.scaled(&inverse)?.moved(-base.first);
        rest.known[0] = Fraction::default();
        let mut factors = vec![one()];
        for k in 1..length {
            let (k, before) = (number(k), &factors[k - 1]);
            let own = exponent.minus(&k.minus(&one())?)?;
            let inverse = k.recip()?.ok_or(LowerError::DivisionByZero)?;
            factors.push(before.times(&own)?.times(&inverse)?);
        }
        Ok(Some(rest.trimmed().put_in(&factors)?))
    }

    /// A function of a series that stays finite.
    fn expansion_in_function(
        &mut self,
        function: Function,
        of: &Expansion,
        length: usize,
    ) -> Expanded {
        if of.first < 0 {
            return Ok(None);
        }
        let at = match (of.first, of.known.first()) {
            (0, Some(at)) => at.clone(),
            // Not even its value is known.
            (0, None) => return Ok(None),
            _ => Fraction::default(),
        };
        let mut rest = of.clone();
        if rest.first == 0 {
            rest.known[0] = Fraction::default();
            rest = rest.trimmed();
        }
        let is_zero = of.first > 0;
        let mut called = |function| {
            let argument = expr_of_fraction(&at, self.atoms);
            self.lower(&Expr::Call(function, argument.into()))
        };
        let found = match function {
            Function::Exp => {
                let all = rest.put_in(&reciprocal_factorials(length, |_| 1)?)?;
                all.scaled(&called(Function::Exp)?)?
            }
            Function::Sin | Function::Cos | Function::Tan => {
                let sine =
                    rest.put_in(&reciprocal_factorials(length, |k| [0, 1, 0, -1][k % 4])?)?;
                let cosine =
                    rest.put_in(&reciprocal_factorials(length, |k| [1, 0, -1, 0][k % 4])?)?;
                let (sine, cosine) = match is_zero {
                    true => (sine, cosine),
                    false => {
                        let (s, c) = (called(Function::Sin)?, called(Function::Cos)?);
                        let turned = sine.scaled(&c)?.plus(&cosine.scaled(&s)?)?;
                        let other = cosine.scaled(&c)?.plus(&sine.scaled(&s.negated())?)?;
                        (turned, other)
                    }
                };
                match function {
                    Function::Sin => sine,
                    Function::Cos => cosine,
                    _ => {
                        let inverse =
                            self.expansion_raised(&cosine, &Rational::from(-1), length)?;
                        return inverse.map(|own| sine.times(&own)).transpose();
                    }
                }
            }
            Function::Ln if !is_zero => {
                let value = called(Function::Ln)?;
                let inverse = self.recip(&at)?;
                let sign = |k: usize| if k % 2 == 1 { 1 } else { -1 };
                let all: Result<Vec<Fraction>, LowerError> = (0..length)
                    .map(|k| quotient(if k == 0 { 0 } else { sign(k) }, k.max(1)))
                    .collect();
                let all = rest.scaled(&inverse)?.put_in(&all?)?;
                Expansion::of(value, 0, length).plus(&all)?
            }
            Function::ArcTan if is_zero => {
                let all: Result<Vec<Fraction>, LowerError> = (0..length)
                    .map(|k| quotient([0, 1, 0, -1][k % 4], k.max(1)))
                    .collect();
                rest.put_in(&all?)?
            }
            _ => return Ok(None),
        };
        Ok(Some(found))
    }
}

impl Expansion {
    /// `value/N^order`, known to a length.
    fn of(value: Fraction, order: i32, length: usize) -> Expansion {
        let mut known = vec![Fraction::default(); length];
        known[0] = value;
        Expansion {
            first: order,
            known,
        }
        .trimmed()
    }

    /// The first order that is not known.
    fn end(&self) -> i32 {
        self.first + self.known.len() as i32
    }

    fn at(&self, order: i32) -> Option<&Fraction> {
        let place = usize::try_from(order - self.first).ok()?;
        self.known.get(place)
    }

    /// The same without what is 0 at its beginning.
    fn trimmed(mut self) -> Expansion {
        let zeros = self.known.iter().take_while(|own| own.is_zero()).count();
        self.known.drain(..zeros);
        self.first += zeros as i32;
        self
    }

    /// The same with each order higher by so much.
    fn moved(mut self, by: i32) -> Expansion {
        self.first += by;
        self
    }

    fn each(mut self, change: impl Fn(&Fraction) -> Fraction) -> Expansion {
        self.known = self.known.iter().map(change).collect();
        self
    }

    fn scaled(&self, by: &Fraction) -> Result<Expansion, LowerError> {
        let known: Result<Vec<Fraction>, _> = self.known.iter().map(|own| own.times(by)).collect();
        let first = self.first;
        Ok(Expansion {
            first,
            known: known?,
        }
        .trimmed())
    }

    fn plus(&self, other: &Expansion) -> Result<Expansion, LowerError> {
        let end = self.end().min(other.end());
        let first = self.first.min(other.first).min(end);
        let mut known = Vec::new();
        for order in first..end {
            let both = (self.at(order), other.at(order));
            known.push(match both {
                (Some(a), Some(b)) => a.plus(b)?,
                (Some(own), None) | (None, Some(own)) => own.clone(),
                (None, None) => Fraction::default(),
            });
        }
        Ok(Expansion { first, known }.trimmed())
    }

    fn times(&self, other: &Expansion) -> Result<Expansion, LowerError> {
        let length = self.known.len().min(other.known.len());
        let mut known = Vec::new();
        for k in 0..length {
            let mut sum = Fraction::default();
            for i in 0..=k {
                let (a, b) = (&self.known[i], &other.known[k - i]);
                if !a.is_zero() && !b.is_zero() {
                    sum = sum.plus(&a.times(b)?)?;
                }
            }
            known.push(sum);
        }
        let first = self.first + other.first;
        match (-FURTHEST..=FURTHEST).contains(&first) {
            true => Ok(Expansion { first, known }.trimmed()),
            false => Err(LowerError::TooLarge),
        }
    }

    /// `f_0 + f_1 u + f_2 u² + …` of this series, which begins beyond order 0.
    fn put_in(&self, factors: &[Fraction]) -> Result<Expansion, LowerError> {
        // From the innermost of `f_0 + u (f_1 + u (f_2 + …))`; what is left out is of the order of as many factors.
        let length = factors.len();
        let mut whole: Option<Expansion> = None;
        for factor in factors.iter().rev() {
            let own = Expansion::of(factor.clone(), 0, length);
            whole = Some(match whole {
                Some(whole) => whole.times(self)?.plus(&own)?,
                None => own.shortened(self.first.max(1)),
            });
        }
        Ok(whole.unwrap_or_else(|| Expansion::of(Fraction::default(), 0, length)))
    }

    /// The same, known up to an order and no further.
    fn shortened(mut self, end: i32) -> Expansion {
        self.first = self.first.min(end);
        self.known
            .truncate(usize::try_from(end - self.first).unwrap_or(0));
        self
    }
}

fn one() -> Fraction {
    Rational::one().into()
}

fn number(value: usize) -> Fraction {
    Rational::from(value as u64).into()
}

fn quotient(above: i32, below: usize) -> Result<Fraction, LowerError> {
    let inverse = number(below).recip()?.ok_or(LowerError::DivisionByZero)?;
    Ok(Fraction::from(Rational::ratio(above, 1)).times(&inverse)?)
}

/// `s(k)/k!` for each k.
fn reciprocal_factorials(
    length: usize,
    sign: impl Fn(usize) -> i32,
) -> Result<Vec<Fraction>, LowerError> {
    let (mut all, mut own) = (Vec::new(), one());
    for k in 0..length {
        if k > 0 {
            own = own.times(&quotient(1, k)?)?;
        }
        all.push(own.times(&quotient(sign(k), 1)?)?);
    }
    Ok(all)
}
