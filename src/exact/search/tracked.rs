//! Polynomials that remember how they were made from the equations.

use std::borrow::Cow;
use std::collections::{HashMap, HashSet};
use std::rc::Rc;

use crate::algebra::{Monomial, Polynomial, Rational, TooLarge, Var, product, times_all};
use crate::kernel::{Cofactors, Factors, Knowledge};
use crate::sorted::{Map, Set};

/// A product of powers that are known not to vanish.
pub type Nonzero = Map<Polynomial, u32>;

/// An equation's consequence: `Π multiplier · polynomial = Σ cofactor · equation`.
///
/// Most are of no use in the end. So the cofactors, which are far longer than the polynomial, are worked out only when they are asked for.
#[derive(Clone, Debug)]
pub struct Tracked {
    pub polynomial: Polynomial,
    pub multiplier: Nonzero,
    made: Rc<Made>,
}

/// How a polynomial was made.
#[derive(Clone, Debug)]
enum Made {
    /// It is the equation at this position.
    Equation(usize),
    /// `Σ weight · part`, with the `multiplier` that all parts were brought to.
    Sum {
        multiplier: Nonzero,
        parts: Vec<(Polynomial, Part)>,
    },
}

/// Something made, with the multiplier that it had when it was made use of.
#[derive(Clone, Debug)]
struct Part {
    multiplier: Nonzero,
    made: Rc<Made>,
}

/// The cofactors that were worked out, by what was made.
type Known = HashMap<*const Made, Map<usize, Polynomial>>;

/// What a goal has become: `Π multiplier · goal = Π outer · polynomial + Σ cofactor · equation`.
#[derive(Clone, Debug)]
pub struct Reduced {
    pub polynomial: Polynomial,
    pub multiplier: Nonzero,
    pub outer: Nonzero,
    steps: Vec<Step>,
}

/// What was done to the cofactors of a goal.
#[derive(Clone, Debug)]
enum Step {
    /// All were multiplied by this.
    Scaled(Polynomial),
    /// To them, multiplied by `scale`, were added those of `part` times `weight · Π outer`.
    Added {
        scale: Nonzero,
        weight: Polynomial,
        outer: Nonzero,
        part: Part,
    },
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

/// Brings a product to a common multiple with another one.
fn join(into: &mut Nonzero, factors: &Nonzero) {
    for (factor, exponent) in factors {
        let slot = into.entry(factor.clone()).or_insert(0);
        *slot = (*slot).max(*exponent);
    }
}

/// What is left of a product where what it has in common with another one is gone.
fn missing(factors: &Nonzero, own: &Nonzero) -> Nonzero {
    let mut missing = factors.clone();
    missing.retain(|factor, exponent| {
        *exponent = exponent.saturating_sub(own.get(factor).copied().unwrap_or(0));
        *exponent > 0
    });
    missing
}

impl Part {
    /// `Π multiplier · polynomial = Σ cofactor · equation`, for what was made.
    fn cofactors<'k>(&self, known: &'k mut Known) -> Result<&'k Map<usize, Polynomial>, TooLarge> {
        let own = Rc::as_ptr(&self.made);
        if !known.contains_key(&own) {
            let cofactors = match &*self.made {
                Made::Equation(at) => Map::from([(*at, Polynomial::one())]),
                Made::Sum { multiplier, parts } => {
                    let mut sum = Map::new();
                    for (weight, part) in parts {
                        let missing = missing(multiplier, &part.multiplier);
                        let weight = times(weight, &missing)?.into_owned();
                        accumulate(&mut sum, part.cofactors(known)?, &weight)?;
                    }
                    sum
                }
            };
            known.insert(own, cofactors);
        }
        known.get(&own).ok_or(TooLarge)
    }

    /// Adds the equations that it was made from.
    fn collect_sources(&self, seen: &mut HashSet<*const Made>, found: &mut Set<usize>) {
        if !seen.insert(Rc::as_ptr(&self.made)) {
            return;
        }
        match &*self.made {
            Made::Equation(at) => {
                found.insert(*at);
            }
            Made::Sum { parts, .. } => {
                parts
                    .iter()
                    .for_each(|(_, part)| part.collect_sources(seen, found));
            }
        }
    }
}

impl Tracked {
    /// One of the equations themselves.
    pub fn equation(at: usize, polynomial: Polynomial) -> Self {
        Tracked {
            polynomial,
            multiplier: Nonzero::new(),
            made: Made::Equation(at).into(),
        }
    }

    /// What its polynomial is multiplied by each equation for.
    pub fn cofactors(&self) -> Result<Map<usize, Polynomial>, TooLarge> {
        self.part().cofactors(&mut Known::new()).cloned()
    }

    /// The equations that it was made from.
    pub fn sources(&self) -> Set<usize> {
        let mut found = Set::new();
        self.part().collect_sources(&mut HashSet::new(), &mut found);
        found
    }

    fn part(&self) -> Part {
        Part {
            multiplier: self.multiplier.clone(),
            made: Rc::clone(&self.made),
        }
    }

    /// The same with the sign turned round.
    pub fn negated(&self) -> Self {
        let minus_one = Polynomial::constant(Rational::from(-1));
        Tracked {
            polynomial: self.polynomial.negated(),
            multiplier: self.multiplier.clone(),
            made: Rc::new(Made::Sum {
                multiplier: self.multiplier.clone(),
                parts: vec![(minus_one, self.part())],
            }),
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
        let mut multiplier = self.multiplier.clone();
        join(&mut multiplier, &other.multiplier);
        Ok(Tracked {
            polynomial: (self.polynomial.weighted(p)?).minus(&*other.polynomial.weighted(q)?),
            made: Rc::new(Made::Sum {
                multiplier: multiplier.clone(),
                parts: vec![(p.clone(), self.part()), (q.negated(), other.part())],
            }),
            multiplier,
        })
    }

    /// Subtracts `q · other`.
    pub fn subtract(&mut self, q: &Polynomial, other: &Self) -> Result<(), TooLarge> {
        // One long sum, rather than sums in sums.
        match Rc::get_mut(&mut self.made) {
            Some(Made::Sum { multiplier, parts }) if *multiplier == self.multiplier => {
                self.polynomial = self.polynomial.minus(&*other.polynomial.weighted(q)?);
                join(multiplier, &other.multiplier);
                self.multiplier.clone_from(multiplier);
                parts.push((q.negated(), other.part()));
            }
            _ => *self = self.combine(&Polynomial::one(), other, q)?,
        }
        Ok(())
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
            steps: Vec::new(),
        }
    }

    /// Whether nothing was done to it.
    pub fn is_as_it_was(&self) -> bool {
        self.multiplier.is_empty() && self.outer.is_empty() && self.steps.is_empty()
    }

    /// The cofactors, worked out anew.
    pub fn cofactors(&self) -> Result<Map<usize, Polynomial>, TooLarge> {
        let (mut cofactors, mut known) = (Map::new(), Known::new());
        for step in &self.steps {
            match step {
                Step::Scaled(by) => scale(&mut cofactors, by)?,
                Step::Added {
                    scale: by,
                    weight,
                    outer,
                    part,
                } => {
                    scale(&mut cofactors, &expand(by)?)?;
                    let weight = times(weight, outer)?;
                    accumulate(&mut cofactors, part.cofactors(&mut known)?, &weight)?;
                }
            }
        }
        Ok(cofactors)
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
        // M w D goal = S D (w G − q e) + (S D / Mₑ) q Σ cof_e h + w D Σ C h, with the least D for which S D is a multiple of Mₑ
        let lacking = missing(&element.multiplier, &self.outer);
        include(&mut self.outer, &lacking);
        let mut scale = weight.clone();
        include(&mut scale, &lacking);
        include(&mut self.multiplier, &scale);
        self.steps.push(Step::Added {
            scale,
            weight: quotient.clone(),
            outer: missing(&self.outer, &element.multiplier),
            part: element.part(),
        });
        self.polynomial = polynomial;
        Ok(())
    }

    /// Multiplies by something that does not vanish: `M f goal = S (f G) + f Σ C h`.
    pub fn multiply(&mut self, factor: &Polynomial) -> Result<(), TooLarge> {
        self.polynomial = self.polynomial.times(factor)?;
        *self.multiplier.entry(factor.clone()).or_insert(0) += 1;
        self.steps.push(Step::Scaled(factor.clone()));
        Ok(())
    }

    /// Multiplies both sides by something that does not vanish, what stands before the polynomial with it.
    pub fn multiply_outside(&mut self, factor: &Polynomial) {
        *self.multiplier.entry(factor.clone()).or_insert(0) += 1;
        *self.outer.entry(factor.clone()).or_insert(0) += 1;
        self.steps.push(Step::Scaled(factor.clone()));
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
        while *steps > 0 {
            let Some((quotient, element)) = next_division(&self.polynomial, basis) else {
                return Ok(());
            };
            *steps -= 1;
            self.step(&Nonzero::new(), &quotient, element)?;
        }
        Err(TooLarge)
    }
}

/// The first term of a polynomial, the smallest ones first, that the leading term of an element divides, and how often.
pub fn next_division<'b>(
    polynomial: &Polynomial,
    basis: &'b [Tracked],
) -> Option<(Polynomial, &'b Tracked)> {
    let mut terms = polynomial.terms().rev();
    terms.find_map(|(monomial, coefficient)| {
        basis.iter().find_map(|element| {
            let (lead, own) = element.polynomial.leading()?;
            let quotient = monomial.divided_by(lead)?;
            Some((Polynomial::term(quotient, coefficient / own), element))
        })
    })
}
