use std::borrow::Cow;

use super::{Fact, Sign};
use crate::algebra::{Monomial, Polynomial, Rational, Var};
use crate::sorted::Set;

/// So many products are taken out of a polynomial of so many terms to see that it is positive.
const MOST_TAKEN: usize = 3;
const MOST_TERMS: usize = 12;

/// What the facts say by mere inspection about the sign of polynomials.
///
/// It looks at single terms and at facts that are multiples of what is asked; it proves nothing that
/// needs a certificate.
#[derive(Clone, Debug, Default)]
pub struct Knowledge {
    nonnegative_vars: Set<Var>,
    nonzero_vars: Set<Var>,
    nonzero: Set<Polynomial>,
    positive: Set<Polynomial>,
    nonnegative: Set<Polynomial>,
}

impl Knowledge {
    /// What some facts say.
    pub fn new(facts: &[Fact]) -> Self {
        let mut knowledge = Knowledge::default();
        facts.iter().for_each(|fact| knowledge.learn(fact));
        knowledge
    }

    /// Adds a fact.
    pub fn learn(&mut self, fact: &Fact) {
        let polynomial = &fact.polynomial;
        // Most facts are about an unknown alone, and that is found where terms are looked at.
        if let Some(var) = unknown_alone(polynomial) {
            if matches!(fact.sign, Sign::NonNegative | Sign::Positive) {
                self.nonnegative_vars.insert(var);
            }
            if matches!(fact.sign, Sign::NonZero | Sign::Positive) {
                self.nonzero_vars.insert(var);
            }
            return;
        }
        match fact.sign {
            Sign::Zero => return,
            Sign::NonZero => {
                self.nonzero.insert(polynomial.monic());
            }
            Sign::NonNegative => {
                self.nonnegative.insert(normal(polynomial).into_owned());
            }
            Sign::Positive => {
                self.nonzero.insert(polynomial.monic());
                self.positive.insert(normal(polynomial).into_owned());
            }
        }
        if matches!(fact.sign, Sign::NonZero | Sign::Positive) {
            // A product that does not vanish has no factor that does.
            let content = polynomial.content();
            if !content.is_one() {
                self.nonzero_vars
                    .extend(content.powers().iter().map(|p| p.0));
                let (_, rest) = polynomial.without_content();
                self.nonzero.insert(rest.monic());
            }
        }
        self.learn_bound(fact);
    }

    /// `a v − c ≥ 0` with `a > 0`, `c ≥ 0` bounds an unknown.
    fn learn_bound(&mut self, fact: &Fact) {
        let polynomial = &fact.polynomial;
        if fact.sign == Sign::NonZero || polynomial.degree() != 1 {
            return;
        }
        let mut vars = polynomial.vars().into_iter();
        let (Some(var), None) = (vars.next(), vars.next()) else {
            return;
        };
        let slope = polynomial.coefficient(&Monomial::power(var, 1));
        let constant = polynomial.coefficient(&Monomial::one());
        if slope.is_some_and(|c| c.is_positive()) && constant.is_none_or(|c| !c.is_positive()) {
            self.nonnegative_vars.insert(var);
            if fact.sign == Sign::Positive || constant.is_some_and(|c| !c.is_zero()) {
                self.nonzero_vars.insert(var);
            }
        }
    }

    /// Whether a product of unknowns is known not to be negative.
    pub fn monomial_is_nonnegative(&self, monomial: &Monomial) -> bool {
        let mut powers = monomial.powers().iter();
        powers.all(|(v, e)| e % 2 == 0 || self.nonnegative_vars.contains(v))
    }

    /// Whether a product of unknowns is known not to vanish.
    pub fn monomial_is_nonzero(&self, monomial: &Monomial) -> bool {
        let mut powers = monomial.powers().iter();
        powers.all(|(v, _)| self.nonzero_vars.contains(v))
    }

    /// Whether a product of unknowns is known to be positive.
    pub fn monomial_is_positive(&self, monomial: &Monomial) -> bool {
        self.monomial_is_nonnegative(monomial) && self.monomial_is_nonzero(monomial)
    }

    /// Whether no term is negative; and whether one is positive.
    fn inspect(&self, polynomial: &Polynomial) -> (bool, bool) {
        let mut terms = polynomial.terms();
        let nonnegative = terms.all(|(m, c)| c.is_positive() && self.monomial_is_nonnegative(m));
        let mut terms = polynomial.terms();
        (
            nonnegative,
            nonnegative && terms.any(|(m, _)| self.monomial_is_nonzero(m)),
        )
    }

    /// Whether a polynomial is known to be positive.
    pub fn is_positive(&self, polynomial: &Polynomial) -> bool {
        let positive = normal(polynomial);
        if self.inspect(polynomial).1
            || self.positive.contains(&*positive)
            || self.nonnegative.contains(&*positive) && self.is_said_not_to_vanish(polynomial)
            || self.is_made_of_positive(polynomial, MOST_TAKEN)
        {
            return true;
        }
        let (content, rest) = polynomial.without_content();
        match content.is_one() {
            false => self.monomial_is_positive(&content) && self.is_positive(&rest),
            // a² − b² = (a − b)(a + b)
            true => difference_of_squares(polynomial)
                .is_some_and(|factors| factors.iter().all(|factor| self.is_positive(factor))),
        }
    }

    /// Whether a polynomial is what is left of it and products of unknowns with what facts say is positive, and none of these is negative:
    /// `s − s R + r = s (1 − R) + r`.
    fn is_made_of_positive(&self, polynomial: &Polynomial, most: usize) -> bool {
        let negative = || polynomial.terms().find(|(_, c)| c.is_negative());
        let small = most > 0 && polynomial.len() <= MOST_TERMS;
        let Some((below, size)) = small.then(negative).flatten() else {
            return false;
        };
        let takes = |known: &Polynomial, (own, c): (&Monomial, &Rational)| {
            let times = below.divided_by(own).filter(|_| c.is_negative());
            let Some(times) = times.filter(|own| self.monomial_is_positive(own)) else {
                return false;
            };
            let rest = polynomial.minus(&known.times_term(&times, &(size / c)));
            self.inspect(&rest).0 || self.is_made_of_positive(&rest, most - 1)
        };
        let mut known = self.positive.iter();
        known.any(|known| known.terms().any(|term| takes(known, term)))
    }

    /// Whether a polynomial is known not to be negative.
    pub fn is_nonnegative(&self, polynomial: &Polynomial) -> bool {
        self.inspect(polynomial).0
            || self.nonnegative.contains(&*normal(polynomial))
            || self.is_positive(polynomial)
    }

    /// Whether a polynomial is known not to vanish.
    pub fn is_nonzero(&self, polynomial: &Polynomial) -> bool {
        if polynomial.is_zero() {
            return false;
        }
        let (content, rest) = polynomial.without_content();
        self.is_said_not_to_vanish(polynomial)
            || self.monomial_is_nonzero(&content)
                && (self.is_positive(&rest) || self.is_positive(&rest.negated()))
    }

    /// Whether facts say so of it, or of its factors.
    fn is_said_not_to_vanish(&self, polynomial: &Polynomial) -> bool {
        let (content, rest) = polynomial.without_content();
        self.nonzero.contains(&*polynomial.as_monic())
            || self.monomial_is_nonzero(&content)
                && (self.nonzero.contains(&*rest.as_monic())
                    || rest.as_constant().is_some_and(|own| !own.is_zero()))
    }
}

/// The unknown of which a polynomial is a positive multiple.
fn unknown_alone(polynomial: &Polynomial) -> Option<Var> {
    let mut terms = polynomial.terms();
    let (Some((monomial, coefficient)), None) = (terms.next(), terms.next()) else {
        return None;
    };
    match monomial.powers() {
        [(var, 1)] if coefficient.is_positive() => Some(*var),
        _ => None,
    }
}

/// The factors of `a² − b²`, for products of unknowns `a` and `b`, up to a positive number.
fn difference_of_squares(polynomial: &Polynomial) -> Option<[Polynomial; 2]> {
    let mut terms = polynomial.terms();
    let (Some(first), Some(second), None) = (terms.next(), terms.next(), terms.next()) else {
        return None;
    };
    let (above, below) = match first.1.is_positive() {
        true => (first, second),
        false => (second, first),
    };
    if *above.1 != -below.1 || !above.1.is_positive() {
        return None;
    }
    let root = |monomial: &Monomial| {
        let mut powers = monomial.powers().iter();
        powers.try_fold(Monomial::one(), |root, &(var, exponent)| {
            let half = exponent.is_multiple_of(2).then_some(exponent / 2)?;
            Some(root.times(&Monomial::power(var, half)))
        })
    };
    let (a, b) = (root(above.0)?, root(below.0)?);
    let term = |monomial| Polynomial::term(monomial, Rational::one());
    let (a, b) = (term(a), term(b));
    Some([a.minus(&b), a.plus(&b)])
}

/// The positive multiple with leading coefficient 1 or −1.
fn normal(polynomial: &Polynomial) -> Cow<'_, Polynomial> {
    match polynomial.leading().map(|(_, c)| c.abs()) {
        Some(size) if !size.is_one() => Cow::Owned(polynomial.scaled(&size.recip())),
        _ => Cow::Borrowed(polynomial),
    }
}
