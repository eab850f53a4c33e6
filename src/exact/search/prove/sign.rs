//! Signs: sums of squares and products of what is known not to be negative, with the unknowns removed that equations give.

use super::super::positivity::{Known, decompose, plain};
use super::super::tracked::{Nonzero, Reduced, cofactors, listed};
use super::{Ideal, LIGHT_REDUCTIONS, Prover, negated};
use crate::algebra::{Atom, Expr, Function, Monomial, Polynomial, Rational, TooLarge, Var};
use crate::kernel::{Fact, Knowledge, PositiveTerm, Proof, Sign};
use crate::sorted::Map;

/// How many equations, terms and positive unknowns are tried to put what is compared in other words.
const MOST_EXCHANGED: usize = 4;
/// How often what is compared is squared.
const DEEPEST_SQUARES: usize = 2;

impl Prover {
    /// A proof of a sign from what is known as it stands.
    pub(super) fn sign(&mut self, fact: &Fact) -> Option<Proof> {
        // Of 1 what is asked of its square was asked already; until something is learnt, the answer is the same.
        let asked = |(own, known): &(Fact, usize)| own == fact && *known == self.facts.len();
        if self.unproved.as_ref().is_some_and(asked) {
            return None;
        }
        let found = self.sign_within(fact, DEEPEST_SQUARES);
        if found.is_none() {
            self.unproved = Some((fact.clone(), self.facts.len()));
        }
        found
    }

    /// The same for a sign that is asked for itself: with what is known put in other words, too.
    pub(super) fn sign_in_earnest(&mut self, fact: &Fact) -> Option<Proof> {
        if let Some(found) = self.sign(fact) {
            return Some(found);
        }
        if self.simplify_nonzero()
            && let Some(found) = self.sign(fact)
        {
            return Some(found);
        }
        let vars = fact.polynomial.vars();
        let mut vars = vars.into_iter().take(MOST_EXCHANGED);
        vars.find_map(|var| self.sign_without(fact, var))
    }

    /// The same with one unknown eliminated before any other: what the goal is about may be known by an equation in quantities that
    /// have signs.
    fn sign_without(&mut self, fact: &Fact, var: Var) -> Option<Proof> {
        if self.ideal.first() == Some(var) {
            return None;
        }
        let ideal = Ideal::keeping(&self.facts, &self.knowledge, |other| other != var).ok()?;
        if ideal.first() != Some(var) {
            return None;
        }
        let before = std::mem::replace(&mut self.ideal, ideal);
        let signed = self.signed.take();
        let found = self.sign_by_what_is_known(fact);
        (self.ideal, self.signed) = (before, signed);
        found
    }

    fn sign_within(&mut self, fact: &Fact, depth: usize) -> Option<Proof> {
        if let Some(found) = self.sign_by_what_is_known(fact) {
            return Some(found);
        }
        if self.add_bounded()
            && let Some(found) = self.sign_by_what_is_known(fact)
        {
            return Some(found);
        }
        self.larger(fact, depth)
    }

    /// Where roots and absolute values are compared, their squares may be: of `a − b` with `a ≥ 0` it is enough that
    /// `a² − b² ≥ 0`.
    fn larger(&mut self, fact: &Fact, depth: usize) -> Option<Proof> {
        let depth = depth.checked_sub(1)?;
        let unsquared = |var| {
            let atom = self.atoms.atom(var);
            matches!(
                atom,
                Atom::Opaque(Expr::Power(..) | Expr::Call(Function::Abs, _)) | Atom::Root { .. }
            )
        };
        if !fact.polynomial.vars().into_iter().any(unsquared) {
            return None;
        }
        // What is seen not to be negative term by term; or as a whole what has no root in it, `2 s - D`, or what has.
        let mut choices = [(); 3].map(|()| Polynomial::zero());
        for (monomial, coefficient) in fact.polynomial.terms() {
            let term = Polynomial::term(monomial.clone(), coefficient.clone());
            if self.knowledge.is_nonnegative(&term) {
                choices[0] = choices[0].plus(&term);
            }
            let part = match monomial.powers().iter().any(|&(var, _)| unsquared(var)) {
                false => 1,
                true => 2,
            };
            choices[part] = choices[part].plus(&term);
        }
        let [by_terms, plain, roots] = choices;
        let mut wholes = vec![by_terms];
        for whole in [plain, roots] {
            if !wholes.contains(&whole) && self.knowledge.is_nonnegative(&whole) {
                wholes.push(whole);
            }
        }
        wholes.retain(|own| !own.is_zero() && *own != fact.polynomial);
        wholes.into_iter().find_map(|larger| {
            let squares = Fact {
                polynomial: Proof::difference_of_squares(&larger, &fact.polynomial).ok()?,
                sign: fact.sign,
            };
            let squares = self.sign_within(&squares, depth)?.into();
            Some(Proof::Larger { larger, squares })
        })
    }

    fn sign_by_what_is_known(&mut self, fact: &Fact) -> Option<Proof> {
        let strict = fact.sign == Sign::Positive;
        let mut reduced = self.ideal.reduce(&fact.polynomial, true).ok()?;
        self.make_positive(&mut reduced).ok()?;
        let signed = self.signed_facts();
        let known = Known {
            atoms: &self.atoms,
            knowledge: &self.knowledge,
            facts: &signed,
            plain_first: self.has_bounded,
            equations: &self.ideal.rest,
        };
        // What is positive in every term only hides the rest.
        let content = self.positive_content(&reduced.polynomial);
        let mut reduced = without(reduced, content)?;
        let mut found = decompose(&reduced.polynomial, strict, &known);
        if found.is_none() {
            for other in self.variants(&reduced) {
                found = decompose(&other.polynomial, strict, &known);
                if found.is_some() {
                    reduced = other;
                    break;
                }
            }
        }
        // So may what is positive as a whole.
        if found.is_none() {
            let (rest, divisors) = self.without_positive_divisors(reduced.polynomial.clone());
            if !divisors.is_empty() {
                reduced.polynomial = rest;
                for divisor in divisors {
                    *reduced.outer.entry(divisor).or_insert(0) += 1;
                }
                found = decompose(&reduced.polynomial, strict, &known);
            }
        }
        // What is not negative does too, where 0 will do.
        if found.is_none() && !strict {
            let content = self.nonnegative_content(&reduced.polynomial);
            if !content.is_one() {
                reduced = without(reduced, content)?;
                found = decompose(&reduced.polynomial, strict, &known);
            }
        }
        let found = found?;
        let mut used: Map<usize, Polynomial> = Map::new();
        for (at, weight) in &found.equations {
            for (position, cofactor) in &self.ideal.rest[*at].cofactors().ok()? {
                let slot = used.entry(*position).or_default();
                *slot = slot.plus(&cofactor.times(weight).ok()?);
            }
        }
        let inner = Proof::Positivity {
            multiplier: Vec::new(),
            terms: found.terms,
            cofactors: cofactors(&used),
        };
        if reduced.is_as_it_was() {
            return Some(inner);
        }
        let lemma = Fact {
            polynomial: reduced.polynomial.clone(),
            sign: fact.sign,
        };
        let position = self.add(lemma, inner);
        Some(Proof::Positivity {
            multiplier: listed(&reduced.multiplier),
            terms: vec![PositiveTerm {
                factors: listed(&reduced.outer),
                facts: vec![position],
                ..plain(Rational::one())
            }],
            cofactors: cofactors(&reduced.cofactors().ok()?),
        })
    }

    /// The same in other words, each of which may show a sign: times the number of elements of a sum, as a variance is a sum of
    /// squares; with a term exchanged by an equation, `u² − 2 x y` for `u² = x² + y²`; times something positive, so that an equation
    /// can be put in, `c² − v²` for `γ² (c² − v²) = c²`.
    fn variants(&self, reduced: &Reduced) -> Vec<Reduced> {
        let times = |factor: &Polynomial| -> Option<Reduced> {
            let mut other = reduced.clone();
            other.multiply(factor).ok()?;
            Some(other)
        };
        let counts = positive_counts(&self.atoms, &self.knowledge);
        let mut all: Vec<Reduced> = counts.iter().filter_map(times).collect();
        for element in self.ideal.rest.iter().take(MOST_EXCHANGED) {
            let shared = element.polynomial.terms().filter_map(|(monomial, own)| {
                let coefficient = reduced.polynomial.coefficient(monomial)?;
                Some(coefficient / own)
            });
            for weight in shared.take(MOST_EXCHANGED) {
                let mut other = reduced.clone();
                let weight = Polynomial::constant(weight);
                if other.step(&Nonzero::new(), &weight, element).is_ok()
                    && self.make_positive(&mut other).is_ok()
                {
                    all.push(other);
                }
            }
        }
        let rest = self.ideal.rest.iter().take(MOST_EXCHANGED);
        let mut positive: Vec<Var> = rest.flat_map(|e| e.polynomial.vars()).collect();
        positive.sort_unstable();
        positive.dedup();
        let power = |var: &Var| Monomial::power(*var, 1);
        positive.retain(|var| self.knowledge.monomial_is_positive(&power(var)));
        let mut tried: Vec<Monomial> = positive.iter().take(MOST_EXCHANGED).map(power).collect();
        tried.extend(self.shared_factors(&reduced.polynomial));
        for factor in tried {
            let factor = Polynomial::term(factor, Rational::one());
            if let Some(mut other) = times(&factor)
                && let before = other.polynomial.clone()
                && (other.normal_form(&self.ideal.rest, &mut { LIGHT_REDUCTIONS })).is_ok()
                && other.polynomial != before
                && self.make_positive(&mut other).is_ok()
            {
                all.push(other);
            }
        }
        all
    }

    /// What is positive and makes a polynomial's first term one of an equation's.
    fn shared_factors(&self, polynomial: &Polynomial) -> Vec<Monomial> {
        let Some((lead, _)) = polynomial.leading() else {
            return Vec::new();
        };
        let rest = self.ideal.rest.iter().take(MOST_EXCHANGED);
        let terms = rest.flat_map(|element| element.polynomial.terms());
        let quotients = terms.filter_map(|(monomial, _)| monomial.divided_by(lead));
        let positive = quotients.filter(|q| !q.is_one() && self.knowledge.monomial_is_positive(q));
        positive.take(MOST_EXCHANGED).collect()
    }

    /// Makes every factor of the multiplier positive or even, and the outer factor with it.
    fn make_positive(&self, reduced: &mut Reduced) -> Result<(), TooLarge> {
        let doubtful = |factors: &Nonzero| -> Vec<Polynomial> {
            let odd = factors
                .iter()
                .filter(|(f, e)| *e % 2 == 1 && !self.knowledge.is_positive(f));
            odd.map(|(f, _)| f.clone()).collect()
        };
        for factor in doubtful(&reduced.multiplier) {
            reduced.multiply_outside(&factor);
        }
        for factor in doubtful(&reduced.outer) {
            reduced.polynomial = reduced.polynomial.times(&factor)?;
            if let Some(exponent) = reduced.outer.get_mut(&factor) {
                *exponent -= 1;
            }
        }
        reduced.outer.retain(|_, exponent| *exponent > 0);
        Ok(())
    }

    /// The unknowns that divide every term and are known to be positive.
    fn positive_content(&self, polynomial: &Polynomial) -> Monomial {
        let content = polynomial.content();
        let powers = content.powers().iter();
        let powers = powers.map(|&(var, exponent)| Monomial::power(var, exponent));
        powers
            .filter(|power| self.knowledge.monomial_is_positive(power))
            .fold(Monomial::one(), |all, power| all.times(&power))
    }

    /// A polynomial without what is known to be positive as a whole and divides it, `q - r` of `(q - r) (\beta (q - r) - (q - p))`; and that, as
    /// often as it does.
    fn without_positive_divisors(&self, polynomial: Polynomial) -> (Polynomial, Vec<Polynomial>) {
        let (mut rest, mut found) = (polynomial, Vec::new());
        for fact in self.facts.iter().filter(|own| own.sign == Sign::Positive) {
            let divisor = &fact.polynomial;
            while divisor.len() > 1
                && rest.degree() > divisor.degree()
                && let Some(quotient) = rest.divided_by(divisor)
            {
                rest = quotient;
                found.push(divisor.clone());
            }
        }
        (rest, found)
    }

    /// The powers that divide every term and are known not to be negative.
    fn nonnegative_content(&self, polynomial: &Polynomial) -> Monomial {
        let content = polynomial.content();
        let powers = content.powers().iter().map(|&(var, exponent)| {
            let is_known = self
                .knowledge
                .monomial_is_nonnegative(&Monomial::power(var, 1));
            Monomial::power(var, if is_known { exponent } else { exponent / 2 * 2 })
        });
        powers.fold(Monomial::one(), |all, power| all.times(&power))
    }

    /// Every inequality with the eliminated unknowns removed and positive factors divided out, as lemmas.
    fn signed_facts(&mut self) -> Vec<(usize, Fact)> {
        if let Some(known) = &self.signed {
            return known.clone();
        }
        let mut known = Vec::new();
        for position in 0..self.facts.len() {
            let fact = self.facts[position].clone();
            if !matches!(fact.sign, Sign::NonNegative | Sign::Positive) {
                continue;
            }
            match self.simplified(position, &fact) {
                Ok(Some((lemma, proof))) => {
                    let at = self.add(lemma.clone(), proof);
                    known.push((at, lemma));
                }
                _ => known.push((position, fact)),
            }
        }
        self.signed = Some(known.clone());
        known
    }

    /// Adds what the domains of elements say of sums to the inequalities. Whether there was anything.
    fn add_bounded(&mut self) -> bool {
        let series = std::mem::take(&mut self.bounded);
        let mut known = self.signed_facts();
        let any = !series.is_empty();
        for (polynomial, series) in series {
            let fact = Fact {
                polynomial,
                sign: Sign::NonNegative,
            };
            let term = PositiveTerm {
                bounded: vec![series],
                ..plain(Rational::one())
            };
            let proof = Proof::Positivity {
                multiplier: Vec::new(),
                terms: vec![term],
                cofactors: Vec::new(),
            };
            let at = self.add(fact.clone(), proof);
            known.push(match self.simplified(at, &fact) {
                Ok(Some((lemma, proof))) => (self.add(lemma.clone(), proof), lemma),
                _ => (at, fact),
            });
        }
        self.signed = Some(known);
        self.has_bounded |= any;
        any
    }

    fn simplified(&self, position: usize, fact: &Fact) -> Result<Option<(Fact, Proof)>, TooLarge> {
        let mut reduced = self.ideal.reduce(&fact.polynomial, true)?;
        self.make_positive(&mut reduced)?;
        let content = self.positive_content(&reduced.polynomial);
        let mut multiplier = listed(&reduced.outer);
        let mut polynomial = reduced.polynomial.clone();
        if !content.is_one() {
            let content = Polynomial::term(content, Rational::one());
            polynomial = polynomial.divided_by(&content).unwrap_or_default();
            multiplier.push((content, 1));
        }
        let (polynomial, divisors) = self.without_positive_divisors(polynomial);
        multiplier.extend(divisors.into_iter().map(|divisor| (divisor, 1)));
        // What says that 1 > 0 is of no use; what says that 0 > 0 is of great use.
        let idle = |c: Rational| c.is_positive() || c.is_zero() && fact.sign == Sign::NonNegative;
        if polynomial == fact.polynomial || polynomial.as_constant().is_some_and(idle) {
            return Ok(None);
        }
        // S m Q = M F − Σ C h
        let proof = Proof::Positivity {
            multiplier,
            terms: vec![PositiveTerm {
                factors: listed(&reduced.multiplier),
                facts: vec![position],
                ..plain(Rational::one())
            }],
            cofactors: negated(&reduced.cofactors()?),
        };
        let sign = fact.sign;
        Ok(Some((Fact { polynomial, sign }, proof)))
    }
}

/// The same with what divides every term outside.
fn without(mut reduced: Reduced, content: Monomial) -> Option<Reduced> {
    if !content.is_one() {
        let content = Polynomial::term(content, Rational::one());
        reduced.polynomial = reduced.polynomial.divided_by(&content)?;
        *reduced.outer.entry(content).or_insert(0) += 1;
    }
    Some(reduced)
}

/// The numbers of elements of sums that are known to be positive.
fn positive_counts(atoms: &crate::algebra::Atoms, knowledge: &Knowledge) -> Vec<Polynomial> {
    let mut found = Vec::new();
    for (_, atom) in atoms.iter() {
        if let Atom::PowerSum { to, .. } = atom
            && let Some(var) = atoms.find(&Atom::Symbol(to.clone()))
        {
            let count = Polynomial::var(var);
            if knowledge.is_positive(&count) && !found.contains(&count) {
                found.push(count);
            }
        }
    }
    found
}
