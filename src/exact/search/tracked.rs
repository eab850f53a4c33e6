//! Polynomials that remember how they were made from the equations.

use std::borrow::Cow;

use crate::algebra::{Monomial, Polynomial, Rational, TooLarge, Var, product, times_all};
use crate::kernel::{Cofactors, Factors, Knowledge};
use crate::sorted::Map;

/// A product of powers that are known not to vanish.
pub type Nonzero = Map<Polynomial, u32>;

/// An equation's consequence: `Π multiplier · polynomial = Σ cofactor · equation`.
#[derive(Clone, Debug)]
pub struct Tracked {
    pub polynomial: Polynomial,
    pub multiplier: Nonzero,
    pub cofactors: Map<usize, Polynomial>,
}

/// What a goal has become: `Π multiplier · goal = Π outer · polynomial + Σ cofactor · equation`.
#[derive(Clone, Debug)]
pub struct Reduced {
    pub polynomial: Polynomial,
    pub multiplier: Nonzero,
    pub outer: Nonzero,
    pub cofactors: Map<usize, Polynomial>,
}

pub fn expand(factors: &Nonzero) -> Result<Polynomial, TooLarge> {
    product(factors.iter().map(|(f, e)| (f, *e)))
}

/// A polynomial times such a product.
fn times<'a>(
    polynomial: &'a Polynomial,
    factors: &'a Nonzero,
) -> Result<Cow<'a, Polynomial>, TooLarge> {
    let factors = factors.iter().map(|(f, e)| (f, *e));
    times_all(Cow::Borrowed(polynomial), factors)
}

pub fn listed(factors: &Nonzero) -> Factors {
    factors.iter().map(|(f, e)| (f.clone(), *e)).collect()
}

pub fn cofactors(map: &Map<usize, Polynomial>) -> Cofactors {
    let used = map.iter().filter(|(_, c)| !c.is_zero());
    used.map(|(at, c)| (*at, c.clone())).collect()
}

/// Adds `weight · from` to `to`.
fn accumulate(
    to: &mut Map<usize, Polynomial>,
    from: &Map<usize, Polynomial>,
    weight: &Polynomial,
) -> Result<(), TooLarge> {
    for (at, cofactor) in from {
        let scaled = cofactor.times(weight)?;
        let slot = to.entry(*at).or_default();
        *slot = match slot.is_zero() {
            true => scaled,
            false => slot.plus(&scaled),
        };
    }
    Ok(())
}

fn scale(map: &mut Map<usize, Polynomial>, weight: &Polynomial) -> Result<(), TooLarge> {
    if weight.as_constant().is_some_and(|c| c.is_one()) {
        return Ok(());
    }
    for cofactor in map.values_mut() {
        *cofactor = cofactor.times(weight)?;
    }
    Ok(())
}

fn include(into: &mut Nonzero, factors: &Nonzero) {
    for (factor, exponent) in factors {
        *into.entry(factor.clone()).or_insert(0) += exponent;
    }
}

impl Tracked {
    /// One of the equations themselves.
    pub fn equation(at: usize, polynomial: Polynomial) -> Self {
        Tracked {
            polynomial,
            multiplier: Nonzero::new(),
            cofactors: Map::from([(at, Polynomial::one())]),
        }
    }

    /// Divides out what is known not to vanish.
    pub fn strip(&mut self, knowledge: &Knowledge, divisors: &[Polynomial]) {
        let content = self.polynomial.content();
        for &(var, exponent) in content.powers() {
            let power = Monomial::power(var, 1);
            if knowledge.monomial_is_nonzero(&power) {
                let factor = Polynomial::var(var);
                for _ in 0..exponent {
                    if let Some(rest) = self.polynomial.divided_by(&factor) {
                        self.polynomial = rest;
                        *self.multiplier.entry(factor.clone()).or_insert(0) += 1;
                    }
                }
            }
        }
        for divisor in divisors {
            self.divide_out(divisor);
        }
    }

    /// Divides by what stands before a power of an unknown and is a factor of all: `(m + M) v² = (m + M) c`.
    pub fn divide_by_leads(&mut self, knowledge: &Knowledge) {
        for var in self.polynomial.vars() {
            let highest = self.polynomial.degree_in(var);
            let lead = self.polynomial.coefficient_of_power(var, highest);
            let factor = lead.without_content().1;
            if (2..self.polynomial.len()).contains(&factor.len()) && knowledge.is_nonzero(&factor) {
                self.divide_out(&factor.monic());
            }
        }
    }

    /// Divides by what is known not to vanish, as often as it can be.
    fn divide_out(&mut self, divisor: &Polynomial) {
        while self.polynomial.degree() >= divisor.degree() && !self.polynomial.is_zero() {
            let Some(rest) = self.polynomial.divided_by(divisor) else {
                break;
            };
            self.polynomial = rest;
            *self.multiplier.entry(divisor.clone()).or_insert(0) += 1;
        }
    }

    /// `p · self − q · other`.
    pub fn combine(&self, p: &Polynomial, other: &Self, q: &Polynomial) -> Result<Self, TooLarge> {
        // Bring both to the same multiplier.
        let mut multiplier = self.multiplier.clone();
        for (factor, exponent) in &other.multiplier {
            let slot = multiplier.entry(factor.clone()).or_insert(0);
            *slot = (*slot).max(*exponent);
        }
        let missing = |own: &Nonzero, times| {
            let exponent = |f: &Polynomial| own.get(f).copied().unwrap_or(0);
            let missing = multiplier.iter().map(|(f, e)| (f, e - exponent(f)));
            times_all(Cow::Borrowed(times), missing)
        };
        let mut cofactors = Map::new();
        let plus = missing(&self.multiplier, p)?;
        accumulate(&mut cofactors, &self.cofactors, &plus)?;
        let minus = missing(&other.multiplier, q)?.negated();
        accumulate(&mut cofactors, &other.cofactors, &minus)?;
        Ok(Tracked {
            polynomial: (self.polynomial.weighted(p)?).minus(&*other.polynomial.weighted(q)?),
            multiplier,
            cofactors,
        })
    }

    /// Removes the power of an unknown in which `pivot` is linear, by multiplying with its coefficient.
    pub fn eliminate(&self, pivot: &Pivot) -> Result<Self, TooLarge> {
        let mut done: Option<Tracked> = None;
        loop {
            let current = done.as_ref().unwrap_or(self);
            let Some(quotient) = pivot.quotient(&current.polynomial) else {
                return Ok(done.unwrap_or_else(|| self.clone()));
            };
            // The element is a consequence up to its own coefficient, which does not vanish.
            done = Some(current.combine(&pivot.coefficient, &pivot.element, &quotient)?);
        }
    }
}

/// An element that is linear in a power of an unknown, its coefficient known not to vanish.
#[derive(Clone, Debug)]
pub struct Pivot {
    pub var: Var,
    pub power: u32,
    pub coefficient: Polynomial,
    pub positive: bool,
    pub element: Tracked,
}

impl Pivot {
    /// How often the element goes into the highest power of the unknown, the coefficient aside; `None` where that is too low.
    fn quotient(&self, polynomial: &Polynomial) -> Option<Polynomial> {
        let highest = polynomial.degree_in(self.var);
        let left = highest.checked_sub(self.power)?;
        let lead = polynomial.coefficient_of_power(self.var, highest);
        match left {
            0 => Some(lead),
            _ => Some(lead.times_term(&Monomial::power(self.var, left), &Rational::one())),
        }
    }
}

impl Reduced {
    /// A goal as it is.
    pub fn new(goal: Polynomial) -> Self {
        Reduced {
            polynomial: goal,
            multiplier: Nonzero::new(),
            outer: Nonzero::new(),
            cofactors: Map::new(),
        }
    }

    /// Replaces `polynomial` by `weight · polynomial − quotient · element`, where `weight` does not vanish.
    pub fn step(
        &mut self,
        weight: &Nonzero,
        quotient: &Polynomial,
        element: &Tracked,
    ) -> Result<(), TooLarge> {
        let polynomial = times(&self.polynomial, weight)?;
        let polynomial = polynomial.minus(&quotient.times(&element.polynomial)?);
        // M w Mₑ goal = S Mₑ (w G − q e) + S q Σ cof_e h + w Mₑ Σ C h
        scale(
            &mut self.cofactors,
            &*times(&expand(weight)?, &element.multiplier)?,
        )?;
        let outer = times(quotient, &self.outer)?;
        accumulate(&mut self.cofactors, &element.cofactors, &outer)?;
        include(&mut self.multiplier, weight);
        include(&mut self.multiplier, &element.multiplier);
        include(&mut self.outer, &element.multiplier);
        self.polynomial = polynomial;
        Ok(())
    }

    /// Removes the pivot's unknown. Where signs matter the goal is multiplied by something positive only.
    pub fn eliminate(&mut self, pivot: &Pivot, keep_sign: bool) -> Result<(), TooLarge> {
        while let Some(mut quotient) = pivot.quotient(&self.polynomial) {
            let mut weight = Nonzero::new();
            match pivot.coefficient.as_constant() {
                Some(c) if c.is_one() => {}
                Some(c) => quotient = quotient.scaled(&c.recip()),
                None if keep_sign && !pivot.positive => {
                    weight.insert(pivot.coefficient.clone(), 2);
                    quotient = quotient.times(&pivot.coefficient)?;
                }
                None => {
                    weight.insert(pivot.coefficient.clone(), 1);
                }
            }
            self.step(&weight, &quotient, &pivot.element)?;
        }
        Ok(())
    }

    /// Cancels every term that a leading term of the basis divides.
    pub fn normal_form(&mut self, basis: &[Tracked], steps: &mut usize) -> Result<(), TooLarge> {
        'again: while *steps > 0 {
            for (monomial, coefficient) in self.polynomial.clone().terms().rev() {
                for element in basis {
                    let Some((lead, own)) = element.polynomial.leading() else {
                        continue;
                    };
                    if let Some(quotient) = monomial.divided_by(lead) {
                        *steps -= 1;
                        let quotient = Polynomial::term(quotient, coefficient / own);
                        self.step(&Nonzero::new(), &quotient, element)?;
                        continue 'again;
                    }
                }
            }
            return Ok(());
        }
        Err(TooLarge)
    }
}
