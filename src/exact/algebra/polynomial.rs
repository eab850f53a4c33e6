use std::borrow::Cow;
use std::cmp::Ordering;
use std::fmt;

use smallvec::SmallVec;

use super::division::exact_quotient;
use super::effort::{is_spent, spend};
use super::terms::{Made, Term, Terms};
use super::{Monomial, Rational, Var};

/// Products of polynomials beyond these sizes are refused rather than waited for.
const MOST_TERM_PRODUCTS: usize = 60_000;
const MOST_TERMS_OF_A_POWER: u64 = 10_000;
const HIGHEST_EXPONENT_OF_A_SUM: u32 = 256;
const HIGHEST_DEGREE: u32 = 1 << 20;
/// A coefficient may grow to this many bits in a power.
const LONGEST_NUMBER: u64 = 1 << 17;

/// A computation would exceed the bounds on degree, number of terms or size of numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TooLarge;

impl fmt::Display for TooLarge {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the expression is too large to expand")
    }
}

/// The unknowns of a polynomial; few have more than eight.
type Vars = SmallVec<[Var; 8]>;

/// A polynomial over the rationals in the unknowns of an [`Atoms`](super::Atoms) table.
///
/// Canonical by construction: the terms are sorted, none occurs twice and no coefficient is zero, so two
/// polynomials are equal exactly when their lists of terms are.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct Polynomial {
    terms: Terms,
}

impl Polynomial {
    /// From terms in order, none of them 0.
    fn of(terms: impl Into<Terms>) -> Self {
        let terms = terms.into();
        Polynomial { terms }
    }

    /// Each term changed to one that stands in the same place and is not 0.
    #[inline]
    fn mapped(&self, change: impl Fn(&Monomial, &Rational) -> (Monomial, Rational)) -> Self {
        let terms = match &self.terms {
            Terms::None => Terms::None,
            Terms::One((m, c)) => Terms::One(change(m, c)),
            Terms::Several(terms) => {
                Terms::Several(terms.iter().map(|(m, c)| change(m, c)).collect())
            }
        };
        Polynomial { terms }
    }

    /// 0.
    pub fn zero() -> Self {
        Polynomial::default()
    }

    /// 1.
    pub fn one() -> Self {
        Polynomial::constant(Rational::one())
    }

    /// A constant.
    pub fn constant(value: Rational) -> Self {
        Polynomial::term(Monomial::one(), value)
    }

    /// One unknown.
    pub fn var(var: Var) -> Self {
        Polynomial::term(Monomial::power(var, 1), Rational::one())
    }

    /// `coefficient · monomial`.
    pub fn term(monomial: Monomial, coefficient: Rational) -> Self {
        let terms = match coefficient.is_zero() {
            true => Terms::None,
            false => Terms::One((monomial, coefficient)),
        };
        Polynomial { terms }
    }

    /// The terms from the lowest to the highest.
    pub fn terms(&self) -> impl DoubleEndedIterator<Item = (&Monomial, &Rational)> {
        self.terms.iter().map(|(m, c)| (m, c))
    }

    /// How many terms there are.
    pub fn len(&self) -> usize {
        self.terms.len()
    }

    /// Whether this is 0.
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// Whether there are no terms, that is, whether this is 0.
    pub fn is_empty(&self) -> bool {
        self.is_zero()
    }

    /// The value, where no unknown occurs.
    pub fn as_constant(&self) -> Option<Rational> {
        match self.terms.len() {
            0 => Some(Rational::zero()),
            1 if self.terms[0].0.is_one() => Some(self.terms[0].1.clone()),
            _ => None,
        }
    }

    /// Whether this is 1.
    pub fn is_one(&self) -> bool {
        matches!(&*self.terms, [(monomial, coefficient)] if monomial.is_one() && coefficient.is_one())
    }

    /// The unknown, where this is one and nothing else.
    pub fn as_var(&self) -> Option<Var> {
        match &*self.terms {
            [(monomial, coefficient)] if coefficient.is_one() => match monomial.powers() {
                [(var, 1)] => Some(*var),
                _ => None,
            },
            _ => None,
        }
    }

    /// The coefficient of a monomial, where it occurs.
    pub fn coefficient(&self, monomial: &Monomial) -> Option<&Rational> {
        let found = self.terms.binary_search_by(|(m, _)| m.cmp(monomial));
        found.ok().map(|at| &self.terms[at].1)
    }

    /// The highest term.
    pub fn leading(&self) -> Option<(&Monomial, &Rational)> {
        self.terms.last().map(|(m, c)| (m, c))
    }

    /// The total degree; 0 for the zero polynomial.
    pub fn degree(&self) -> u32 {
        self.leading().map_or(0, |(m, _)| m.degree())
    }

    /// The unknowns that occur, in order.
    pub fn vars(&self) -> Vars {
        let mut vars = Vars::new();
        for (monomial, _) in self.terms.iter() {
            for &(var, _) in monomial.powers() {
                // One that is in all terms is met again and again.
                if vars.last() != Some(&var) {
                    vars.push(var);
                }
            }
        }
        if !vars.is_sorted_by(|a, b| a < b) {
            vars.sort_unstable();
            vars.dedup();
        }
        vars
    }

    /// Whether an unknown occurs.
    pub fn has(&self, var: Var) -> bool {
        self.terms.iter().any(|(m, _)| m.exponent(var) > 0)
    }

    /// The degree in one unknown.
    pub fn degree_in(&self, var: Var) -> u32 {
        self.terms
            .iter()
            .map(|(m, _)| m.exponent(var))
            .max()
            .unwrap_or(0)
    }

    /// From terms in any order, equal monomials added up.
    fn collect(mut terms: Vec<Term>) -> Self {
        if !terms.is_sorted_by(|a, b| a.0 < b.0) {
            terms.sort_by(|a, b| a.0.cmp(&b.0));
            terms.dedup_by(|next, kept| {
                let same = next.0 == kept.0;
                if same {
                    kept.1 += &next.1;
                }
                same
            });
        }
        if terms.iter().any(|term| term.1.is_zero()) {
            terms.retain(|term| !term.1.is_zero());
        }
        Polynomial::of(terms)
    }

    /// `self + factor · other`, by merging.
    fn merged(&self, other: &Self, factor: &Rational) -> Self {
        // Comparing with 0 is common, and leaves nothing to merge.
        if other.is_zero() {
            return self.clone();
        }
        if self.is_zero() {
            return other.scaled(factor);
        }
        spend(self.len() + other.len());
        let mut terms = Vec::with_capacity(self.len() + other.len());
        let mut own = &*self.terms;
        for (monomial, theirs) in other.terms.iter() {
            let mut coefficient = factor * theirs;
            while let [(m, c), after @ ..] = own {
                match m.cmp(monomial) {
                    Ordering::Less => terms.push((m.clone(), c.clone())),
                    Ordering::Equal => coefficient += c,
                    Ordering::Greater => break,
                }
                own = after;
            }
            if !coefficient.is_zero() {
                terms.push((monomial.clone(), coefficient));
            }
        }
        terms.extend_from_slice(own);
        Polynomial::of(terms)
    }

    /// The sum of many: put together at once, not one after another.
    pub(super) fn sum(all: impl Iterator<Item = Polynomial>) -> Self {
        // Most of them are a single term.
        let mut terms = Vec::with_capacity(all.size_hint().0);
        all.for_each(|own| match own.terms {
            Terms::None => {}
            Terms::One(term) => terms.push(term),
            Terms::Several(several) => terms.extend_from_slice(&several),
        });
        spend(terms.len());
        Polynomial::collect(terms)
    }

    /// The sum.
    pub fn plus(&self, other: &Self) -> Self {
        self.merged(other, &Rational::one())
    }

    /// The difference.
    pub fn minus(&self, other: &Self) -> Self {
        self.merged(other, &Rational::from(-1))
    }

    /// The negative.
    pub fn negated(&self) -> Self {
        self.scaled(&-Rational::one())
    }

    /// A rational multiple.
    pub fn scaled(&self, factor: &Rational) -> Self {
        if factor.is_zero() {
            return Polynomial::zero();
        }
        if factor.is_one() {
            return self.clone();
        }
        self.mapped(|m, c| (m.clone(), c * factor))
    }

    /// `coefficient · monomial · self`.
    pub fn times_term(&self, monomial: &Monomial, coefficient: &Rational) -> Self {
        if monomial.is_one() {
            return self.scaled(coefficient);
        }
        if coefficient.is_zero() {
            return Polynomial::zero();
        }
        self.mapped(|m, c| (m.times(monomial), c * coefficient))
    }

    /// The product, within bounds.
    pub fn times(&self, other: &Self) -> Result<Self, TooLarge> {
        let degree = self.degree().checked_add(other.degree()).ok_or(TooLarge)?;
        let products = self.len().saturating_mul(other.len());
        spend(products);
        if products > MOST_TERM_PRODUCTS || degree > HIGHEST_DEGREE || is_spent() {
            return Err(TooLarge);
        }
        // Multiplying by one term keeps the order.
        if let [(m, c)] = &*other.terms {
            return Ok(self.times_term(m, c));
        }
        if let [(m, c)] = &*self.terms {
            return Ok(other.times_term(m, c));
        }
        let mut terms = Vec::with_capacity(self.len() * other.len());
        for (m, c) in self.terms.iter() {
            terms.extend(other.terms.iter().map(|(n, d)| (m.times(n), c * d)));
        }
        Ok(Polynomial::collect(terms))
    }

    /// The product, within bounds; without a copy where the weight is 1, but for as much of the work allowed.
    pub fn weighted(&self, weight: &Self) -> Result<Cow<'_, Self>, TooLarge> {
        if !weight.is_one() {
            return self.times(weight).map(Cow::Owned);
        }
        spend(self.len());
        match is_spent() {
            true => Err(TooLarge),
            false => Ok(Cow::Borrowed(self)),
        }
    }

    /// The power, within bounds.
    pub fn pow(&self, exponent: u32) -> Result<Self, TooLarge> {
        if let (1, Some((m, c))) = (self.len(), self.leading()) {
            let degree = u64::from(m.degree()) * u64::from(exponent);
            if degree > u64::from(HIGHEST_DEGREE) {
                return Err(TooLarge);
            }
            let powers = m.powers().iter();
            let monomial = powers.fold(Monomial::one(), |product, &(v, e)| {
                product.times(&Monomial::power(v, e * exponent))
            });
            return Ok(Polynomial::term(
                monomial,
                c.pow(exponent, LONGEST_NUMBER).ok_or(TooLarge)?,
            ));
        }
        if self.is_zero() && exponent > 0 {
            return Ok(Polynomial::zero());
        }
        if exponent > HIGHEST_EXPONENT_OF_A_SUM {
            return Err(TooLarge);
        }
        // A power of t unlike terms has (e + t − 1 choose t − 1) terms, if none cancel.
        let mut terms: u64 = 1;
        for k in 1..self.len() as u64 {
            terms = terms.saturating_mul(u64::from(exponent) + k) / k;
            if terms > MOST_TERMS_OF_A_POWER {
                return Err(TooLarge);
            }
        }
        let mut product = Polynomial::one();
        for _ in 0..exponent {
            product = product.times(self)?;
        }
        Ok(product)
    }

    /// `self / other`, where the division leaves no remainder and is done before all work allowed is.
    pub fn divided_by(&self, other: &Self) -> Option<Self> {
        let (lead, _) = other.leading()?;
        if let [(monomial, coefficient)] = &*other.terms {
            let (mut terms, inverse) = (Made::new(), coefficient.recip());
            for (m, c) in self.terms.iter() {
                let quotient = (m.divided_by(monomial)?, c * &inverse);
                // Room is asked for once something divides: most divisions that fail, fail at the first term.
                if terms.is_empty() {
                    terms.reserve(self.len());
                }
                terms.push(quotient);
            }
            return Some(Polynomial::of(terms));
        }
        // The lowest terms must divide too: most divisions that fail, fail here.
        if let (Some((low, _)), Some((own, _))) = (self.terms.first(), other.terms.first())
            && !(own.divides(low) && lead.divides(self.leading()?.0))
        {
            return None;
        }
        let mut quotient = exact_quotient(self, other)?;
        quotient.reverse();
        Some(Polynomial::of(quotient))
    }

    /// The coefficients of the powers of one unknown, from the 0th up.
    pub fn in_powers_of(&self, var: Var) -> Vec<Polynomial> {
        let mut coefficients = vec![Made::new(); self.degree_in(var) as usize + 1];
        for (m, c) in self.terms.iter() {
            coefficients[m.exponent(var) as usize].push((m.without(var), c.clone()));
        }
        // What is left of terms with the same power is in the same order.
        let coefficients = coefficients.into_iter();
        coefficients.map(Polynomial::of).collect()
    }

    /// The coefficient of one power of an unknown.
    pub fn coefficient_of_power(&self, var: Var, exponent: u32) -> Polynomial {
        let mut terms = Made::new();
        for (m, c) in self.terms.iter() {
            if m.exponent(var) == exponent {
                terms.push((m.without(var), c.clone()));
            }
        }
        Polynomial::of(terms)
    }

    /// The greatest monomial that divides every term.
    pub fn content(&self) -> Monomial {
        let mut monomials = self.terms.iter().map(|t| &t.0);
        let mut content = monomials.next().cloned().unwrap_or_default();
        for other in monomials {
            // Nothing is left to have in common.
            if content.is_one() {
                break;
            }
            content = content.gcd(other);
        }
        content
    }

    /// The greatest monomial that divides every term, and the rest.
    pub fn without_content(&self) -> (Monomial, Cow<'_, Self>) {
        let content = self.content();
        if content.is_one() {
            return (content, Cow::Borrowed(self));
        }
        let rest = self.divided_by(&Polynomial::term(content.clone(), Rational::one()));
        (content, Cow::Owned(rest.unwrap_or_default()))
    }

    /// The polynomial divided by its leading coefficient; 0 stays 0.
    pub fn monic(&self) -> Self {
        self.as_monic().into_owned()
    }

    /// The same, without a copy of what is monic already.
    pub fn as_monic(&self) -> Cow<'_, Self> {
        match self.leading() {
            Some((_, c)) if !c.is_one() => Cow::Owned(self.scaled(&c.recip())),
            _ => Cow::Borrowed(self),
        }
    }

    /// The partial derivative.
    pub fn derivative(&self, var: Var) -> Self {
        let mut terms = Vec::new();
        for (m, c) in self.terms.iter() {
            let exponent = m.exponent(var);
            if exponent > 0 {
                let lowered = m.without(var).times(&Monomial::power(var, exponent - 1));
                terms.push((lowered, c * Rational::from(exponent)));
            }
        }
        Polynomial::collect(terms)
    }

    /// Puts a polynomial in the place of an unknown, within bounds.
    pub fn substitute(&self, var: Var, value: &Polynomial) -> Result<Self, TooLarge> {
        if !self.has(var) {
            return Ok(self.clone());
        }
        if let Some(value) = value.as_constant() {
            spend(self.len());
            let mut terms = Vec::with_capacity(self.len());
            for (m, c) in self.terms.iter() {
                if is_spent() {
                    return Err(TooLarge);
                }
                match m.exponent(var) {
                    0 => terms.push((m.clone(), c.clone())),
                    _ if value.is_zero() => {}
                    exponent => {
                        let power = value.pow(exponent, LONGEST_NUMBER).ok_or(TooLarge)?;
                        terms.push((m.without(var), c * power));
                    }
                }
            }
            return Ok(Polynomial::collect(terms));
        }
        let coefficients = self.in_powers_of_bounded(var)?;
        // Horner's rule.
        let mut sum = Polynomial::zero();
        for coefficient in coefficients.iter().rev() {
            sum = sum.times(value)?.plus(coefficient);
        }
        Ok(sum)
    }

    fn in_powers_of_bounded(&self, var: Var) -> Result<Vec<Polynomial>, TooLarge> {
        if self.degree_in(var) > 4096 {
            return Err(TooLarge);
        }
        Ok(self.in_powers_of(var))
    }

    /// The value at a point; `None` where the point does not give every unknown a value.
    pub fn evaluate(
        &self,
        value: impl Fn(Var) -> Option<Rational>,
    ) -> Result<Option<Rational>, TooLarge> {
        let mut sum = Rational::zero();
        spend(self.len());
        for (m, c) in self.terms.iter() {
            if is_spent() {
                return Err(TooLarge);
            }
            let mut product = c.clone();
            for &(var, exponent) in m.powers() {
                let Some(value) = value(var) else {
                    return Ok(None);
                };
                product *= value.pow(exponent, LONGEST_NUMBER).ok_or(TooLarge)?;
            }
            sum += product;
        }
        Ok(Some(sum))
    }
}
