//! From facts to a certificate: consequence first, sign second.

use std::collections::BTreeMap;

use super::elements;
use super::ideal::Ideal;
use super::positivity::{Known, decompose};
use super::roots::root_of;
use super::tracked::{Nonzero, Reduced, Tracked, cofactors, expand, listed};
use crate::algebra::{Atom, Expr, Function, Monomial, Polynomial, Rational, TooLarge, Var};
use crate::kernel::{
    BoundedSeries, Cofactors, Fact, Knowledge, Lemma, PositiveTerm, Problem, Proof, Sign,
};

/// The highest power of a goal that is tried: `(μ − 1)² = 0` gives `μ = 1`.
const HIGHEST_POWER: u32 = 3;
/// How often roots are taken of what came of it.
const MOST_ROUNDS: usize = 3;
const REDUCTIONS: usize = 2_000;
const LIGHT_REDUCTIONS: usize = 60;
/// How many equations, terms and positive unknowns are tried to put what is compared in other words.
const MOST_EXCHANGED: usize = 4;
/// How often what is compared is squared.
const DEEPEST_SQUARES: usize = 2;

/// How hard to try.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effort {
    /// Linear elimination alone: almost free.
    Light,
    /// Gröbner bases and sign arguments too.
    Full,
}

/// Proves facts from the facts of a problem, adding lemmas on the way.
pub struct Prover {
    pub(super) facts: Vec<Fact>,
    pub(super) knowledge: Knowledge,
    pub(super) atoms: crate::algebra::Atoms,
    lemmas: Vec<Lemma>,
    ideal: Ideal,
    basis: Option<Vec<Tracked>>,
    /// The inequalities with the eliminated unknowns removed, by position.
    signed: Option<Vec<(usize, Fact)>>,
    /// What the domains of elements say of sums, until it is asked for.
    bounded: Vec<(Polynomial, BoundedSeries)>,
    /// Whether it has been asked for, so that there are many facts.
    has_bounded: bool,
    /// Whether what does not vanish has been simplified.
    has_simplified: bool,
}

impl Prover {
    pub fn new(problem: &Problem) -> Result<Self, TooLarge> {
        Prover::without(problem, |_| false)
    }

    /// The same where some facts say nothing, as if they read `0 = 0`.
    pub fn without(problem: &Problem, silenced: impl Fn(usize) -> bool) -> Result<Self, TooLarge> {
        let nothing = || Fact {
            polynomial: Polynomial::zero(),
            sign: Sign::Zero,
        };
        let facts = problem.facts.iter().enumerate();
        let facts: Vec<Fact> = facts
            .map(|(at, fact)| match silenced(at) {
                true => nothing(),
                false => fact.clone(),
            })
            .collect();
        let knowledge = Knowledge::new(&facts);
        let mut prover = Prover {
            ideal: Ideal::new(&facts, &knowledge)?,
            facts,
            atoms: problem.atoms.clone(),
            knowledge,
            lemmas: Vec::new(),
            basis: None,
            signed: None,
            bounded: elements::bounded(problem),
            has_bounded: false,
            has_simplified: false,
        };
        prover.take_roots(problem.takes_powers_apart())?;
        Ok(prover)
    }

    /// Adds what equations say of positive unknowns below a common power: `v² = 2 t²` gives `v = √2 t`.
    ///
    /// Where no root is asked for, only of premises themselves: what two wrong ones say together is not helped.
    fn take_roots(&mut self, of_all: bool) -> Result<(), TooLarge> {
        for _ in 0..MOST_ROUNDS {
            let mut found = false;
            for element in self.ideal.rest.clone() {
                if !of_all && element.cofactors.len() > 1 {
                    continue;
                }
                let Some((fact, proof)) = root_of(&element, self)? else {
                    continue;
                };
                if !self.facts.contains(&fact) {
                    self.add(fact, proof);
                    found = true;
                }
            }
            if !found {
                return Ok(());
            }
            self.ideal = Ideal::new(&self.facts, &self.knowledge)?;
        }
        Ok(())
    }

    pub fn into_lemmas(self) -> Vec<Lemma> {
        self.lemmas
    }

    pub fn knows_nonzero(&self, polynomial: &Polynomial) -> bool {
        self.knows(polynomial, Sign::NonZero)
    }

    pub fn knows(&self, polynomial: &Polynomial, sign: Sign) -> bool {
        match sign {
            Sign::Zero => polynomial.is_zero(),
            Sign::NonZero => self.knowledge.is_nonzero(polynomial),
            Sign::NonNegative => self.knowledge.is_nonnegative(polynomial),
            Sign::Positive => self.knowledge.is_positive(polynomial),
        }
    }

    /// Adds a proved fact and says where it stands.
    pub fn add(&mut self, fact: Fact, proof: Proof) -> usize {
        self.knowledge.learn(&fact);
        self.facts.push(fact.clone());
        self.lemmas.push(Lemma { fact, proof });
        self.facts.len() - 1
    }

    /// A proof of a fact, if one is found.
    pub fn prove(&mut self, fact: &Fact, effort: Effort) -> Option<Proof> {
        match (fact.sign, effort) {
            (Sign::Zero, _) => self.zero(&fact.polynomial, effort),
            (Sign::NonZero, _) => self.nonzero(&fact.polynomial, effort),
            (_, Effort::Light) => None,
            (_, Effort::Full) => self.sign(fact),
        }
    }

    fn zero(&mut self, goal: &Polynomial, effort: Effort) -> Option<Proof> {
        let reduced = self.ideal.reduce(goal, false).ok()?;
        if reduced.polynomial.is_zero() {
            return Some(combination(&reduced, 1));
        }
        // What is left may already be a multiple of the goal; no basis is needed to see that.
        let mut divided = reduced.clone();
        if !self.ideal.rest.is_empty()
            && divided
                .normal_form(&self.ideal.rest, &mut { LIGHT_REDUCTIONS })
                .is_ok()
            && divided.polynomial.is_zero()
        {
            return Some(combination(&divided, 1));
        }
        if effort == Effort::Light || !self.is_tied_down(&reduced.polynomial) {
            return None;
        }
        if !self.ideal.rest.is_empty() {
            let basis = self.basis().to_vec();
            for power in 1..=HIGHEST_POWER {
                let mut reduced = self.ideal.reduce(&goal.pow(power).ok()?, false).ok()?;
                let mut steps = REDUCTIONS;
                if reduced.normal_form(&basis, &mut steps).is_ok() && reduced.polynomial.is_zero() {
                    return Some(combination(&reduced, power));
                }
            }
            // A consequence that cannot vanish, and does: anything follows.
            let impossible = basis
                .iter()
                .find(|e| self.knowledge.is_nonzero(&e.polynomial));
            if let Some(element) = impossible {
                return from_contradiction(element, goal).ok();
            }
            if let Some(proof) = self.zero_by_dividing(goal) {
                return Some(proof);
            }
            if let Some(proof) = self.zero_by_squares(goal, &basis) {
                return Some(proof);
            }
            if self.simplify_nonzero() {
                return self.zero(goal, effort);
            }
        }
        if !self.has_inequalities() && self.ideal.rest.is_empty() {
            return None;
        }
        let bound = |polynomial| Fact {
            polynomial,
            sign: Sign::NonNegative,
        };
        if let Some(below) = self.sign_within(&bound(goal.clone()), DEEPEST_SQUARES)
            && let Some(above) = self.sign_within(&bound(goal.negated()), DEEPEST_SQUARES)
        {
            return Some(Proof::BothBounds {
                below: below.into(),
                above: above.into(),
            });
        }
        let square = bound(goal.pow(2).ok()?.negated());
        let square = self.sign_within(&square, DEEPEST_SQUARES)?;
        Some(Proof::Square(square.into()))
    }

    /// The same with what cannot vanish kept to the end, so that it can be divided out of what is left: two
    /// resistors have one voltage, and it is none of the conclusion.
    fn zero_by_dividing(&self, goal: &Polynomial) -> Option<Proof> {
        let kept = |var| {
            let power = Monomial::power(var, 1);
            self.knowledge.monomial_is_nonzero(&power)
        };
        let ideal = Ideal::keeping(&self.facts, &self.knowledge, kept).ok()?;
        let mut reduced = ideal.reduce(goal, false).ok()?;
        let settled = reduced.polynomial.is_zero()
            || reduced
                .normal_form(&ideal.rest, &mut { LIGHT_REDUCTIONS })
                .is_ok()
                && reduced.polynomial.is_zero();
        settled.then(|| combination(&reduced, 1))
    }

    /// What is known not to vanish, with the eliminated unknowns removed: for `m_1 = m_2`, that `m_1 + m_2 ≠ 0` says that `m_2 ≠ 0`.
    /// Whether anything came of it, once.
    fn simplify_nonzero(&mut self) -> bool {
        if std::mem::replace(&mut self.has_simplified, true) {
            return false;
        }
        let known =
            (self.facts.iter()).filter(|f| matches!(f.sign, Sign::NonZero | Sign::Positive));
        let known: Vec<Polynomial> = known.map(|fact| fact.polynomial.clone()).collect();
        let before = self.facts.len();
        for own in known {
            let Ok(reduced) = self.ideal.reduce(&own, false) else {
                continue;
            };
            let polynomial = reduced.polynomial.clone();
            if polynomial.is_zero() || self.knowledge.is_nonzero(&polynomial) {
                continue;
            }
            // M F = S G + Σ C h
            let Ok(cofactor) = expand(&reduced.outer) else {
                continue;
            };
            let mut certain = reduced.multiplier.clone();
            *certain.entry(own).or_insert(0) += 1;
            let proof = Proof::NonVanishing {
                certain: listed(&certain),
                cofactor,
                cofactors: cofactors(&reduced.cofactors),
            };
            let sign = Sign::NonZero;
            self.add(Fact { polynomial, sign }, proof);
        }
        let Ok(ideal) = Ideal::new(&self.facts, &self.knowledge) else {
            return false;
        };
        if self.facts.len() == before {
            return false;
        }
        (self.ideal, self.basis, self.signed) = (ideal, None, None);
        true
    }

    /// `a = b` from `a² = b²`, where neither is negative: what is a root of something is told by its square.
    fn zero_by_squares(&self, goal: &Polynomial, basis: &[Tracked]) -> Option<Proof> {
        let mut sum = Polynomial::zero();
        for (monomial, coefficient) in goal.terms() {
            let size = Polynomial::term(monomial.clone(), coefficient.abs());
            sum = sum.plus(&size);
        }
        if goal.len() < 2 || !self.knowledge.is_positive(&sum) {
            return None;
        }
        let mut reduced = self.ideal.reduce(&goal.times(&sum).ok()?, false).ok()?;
        let settled =
            reduced.normal_form(basis, &mut { REDUCTIONS }).is_ok() && reduced.polynomial.is_zero();
        if !settled {
            return None;
        }
        *reduced.multiplier.entry(sum).or_insert(0) += 1;
        Some(combination(&reduced, 1))
    }

    fn nonzero(&mut self, goal: &Polynomial, effort: Effort) -> Option<Proof> {
        let reduced = self.ideal.reduce(goal, false).ok()?;
        if self.knowledge.is_nonzero(&reduced.polynomial) {
            // S G = M goal − Σ C h
            let mut certain = reduced.outer.clone();
            *certain.entry(reduced.polynomial.clone()).or_insert(0) += 1;
            return Some(Proof::NonVanishing {
                certain: listed(&certain),
                cofactor: expand(&reduced.multiplier).ok()?,
                cofactors: negated(&reduced.cofactors),
            });
        }
        if effort == Effort::Light {
            return None;
        }
        if let Some(proof) = self.nonzero_by_contradiction(goal) {
            return Some(proof);
        }
        for polynomial in [goal.clone(), goal.negated()] {
            let fact = Fact {
                polynomial,
                sign: Sign::Positive,
            };
            if let Some(proof) = self.sign(&fact) {
                self.add(fact, proof);
                return Some(Proof::NonVanishing {
                    certain: vec![(goal.clone(), 1)],
                    cofactor: Polynomial::one(),
                    cofactors: Vec::new(),
                });
            }
        }
        None
    }

    /// Were the goal 0, something that cannot vanish would.
    fn nonzero_by_contradiction(&mut self, goal: &Polynomial) -> Option<Proof> {
        let mut facts = self.facts.clone();
        let own = facts.len();
        facts.push(Fact {
            polynomial: goal.clone(),
            sign: Sign::Zero,
        });
        let ideal = Ideal::new(&facts, &self.knowledge).ok()?;
        let basis = ideal.basis(&self.knowledge);
        let element = basis
            .iter()
            .find(|e| self.knowledge.is_nonzero(&e.polynomial))?;
        let mut certain = element.multiplier.clone();
        *certain.entry(element.polynomial.clone()).or_insert(0) += 1;
        let mut used = element.cofactors.clone();
        let cofactor = used.remove(&own).unwrap_or_default();
        Some(Proof::NonVanishing {
            certain: listed(&certain),
            cofactor,
            cofactors: cofactors(&used),
        })
    }

    fn sign(&mut self, fact: &Fact) -> Option<Proof> {
        if let Some(found) = self.sign_within(fact, DEEPEST_SQUARES) {
            return Some(found);
        }
        if self.simplify_nonzero()
            && let Some(found) = self.sign_within(fact, DEEPEST_SQUARES)
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
        let ideal = Ideal::keeping(&self.facts, &self.knowledge, |other| other != var).ok()?;
        if ideal.first() != Some(var) || self.ideal.first() == Some(var) {
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
        let mut larger = Polynomial::zero();
        for (monomial, coefficient) in fact.polynomial.terms() {
            let term = Polynomial::term(monomial.clone(), coefficient.clone());
            if self.knowledge.is_nonnegative(&term) {
                larger = larger.plus(&term);
            }
        }
        if larger.is_zero() || larger == fact.polynomial {
            return None;
        }
        let squares = Fact {
            polynomial: Proof::difference_of_squares(&larger, &fact.polynomial).ok()?,
            sign: fact.sign,
        };
        let squares = self.sign_within(&squares, depth)?.into();
        Some(Proof::Larger { larger, squares })
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
        if !content.is_one() {
            let content = Polynomial::term(content, Rational::one());
            reduced.polynomial = reduced.polynomial.divided_by(&content)?;
            *reduced.outer.entry(content).or_insert(0) += 1;
        }
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
        let found = found?;
        let mut used: BTreeMap<usize, Polynomial> = BTreeMap::new();
        for (at, weight) in &found.equations {
            for (position, cofactor) in &self.ideal.rest[*at].cofactors {
                let slot = used.entry(*position).or_default();
                *slot = slot.plus(&cofactor.times(weight).ok()?);
            }
        }
        let inner = Proof::Positivity {
            multiplier: Vec::new(),
            terms: found.terms,
            cofactors: cofactors(&used),
        };
        if reduced.multiplier.is_empty() && reduced.outer.is_empty() && reduced.cofactors.is_empty()
        {
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
                coefficient: Rational::one(),
                factors: listed(&reduced.outer),
                squares: Vec::new(),
                series: Vec::new(),
                bounded: Vec::new(),
                facts: vec![position],
            }],
            cofactors: cofactors(&reduced.cofactors),
        })
    }

    /// The same in other words, each of which may show a sign: times the number of elements of a sum, as a variance is a sum of
    /// squares; with a term exchanged by an equation, `u² − 2 x y` for `u² = x² + y²`; times something positive, so that an equation
    /// can be put in, `c² − v²` for `γ² (c² − v²) = c²`.
    fn variants(&self, reduced: &Reduced) -> Vec<Reduced> {
        let times = |factor: &Polynomial| -> Option<Reduced> {
            let mut other = reduced.clone();
            other.polynomial = other.polynomial.times(factor).ok()?;
            *other.multiplier.entry(factor.clone()).or_insert(0) += 1;
            for cofactor in other.cofactors.values_mut() {
                *cofactor = cofactor.times(factor).ok()?;
            }
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
        for var in positive.iter().take(MOST_EXCHANGED) {
            let factor = Polynomial::term(power(var), Rational::one());
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

    /// Makes every factor of the multiplier positive or even, and the outer factor with it.
    fn make_positive(&self, reduced: &mut Reduced) -> Result<(), TooLarge> {
        let doubtful = |factors: &Nonzero| -> Vec<Polynomial> {
            let odd = factors
                .iter()
                .filter(|(f, e)| *e % 2 == 1 && !self.knowledge.is_positive(f));
            odd.map(|(f, _)| f.clone()).collect()
        };
        for factor in doubtful(&reduced.multiplier) {
            *reduced.multiplier.entry(factor.clone()).or_insert(0) += 1;
            *reduced.outer.entry(factor.clone()).or_insert(0) += 1;
            for cofactor in reduced.cofactors.values_mut() {
                *cofactor = cofactor.times(&factor)?;
            }
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

    /// Whether every unknown occurs in some fact: one that occurs in none can have any value.
    fn is_tied_down(&self, polynomial: &Polynomial) -> bool {
        let facts = || self.facts.iter().map(|f| &f.polynomial);
        let sums = || self.bounded.iter().map(|b| &b.0);
        let occurs = |var| facts().chain(sums()).any(|p| p.degree_in(var) > 0);
        polynomial.vars().into_iter().all(occurs)
    }

    fn has_inequalities(&self) -> bool {
        let signed = |f: &Fact| matches!(f.sign, Sign::NonNegative | Sign::Positive);
        self.facts
            .iter()
            .any(|f| signed(f) && f.polynomial.as_constant().is_none())
            || !self.bounded.is_empty()
    }

    fn basis(&mut self) -> &[Tracked] {
        let (ideal, knowledge) = (&self.ideal, &self.knowledge);
        self.basis.get_or_insert_with(|| ideal.basis(knowledge))
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
                coefficient: Rational::one(),
                factors: Vec::new(),
                squares: Vec::new(),
                series: Vec::new(),
                bounded: vec![series],
                facts: Vec::new(),
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
        // What says that 1 > 0 is of no use; what says that 0 > 0 is of great use.
        let idle = |c: Rational| c.is_positive() || c.is_zero() && fact.sign == Sign::NonNegative;
        if polynomial == fact.polynomial || polynomial.as_constant().is_some_and(idle) {
            return Ok(None);
        }
        // S m Q = M F − Σ C h
        let proof = Proof::Positivity {
            multiplier,
            terms: vec![PositiveTerm {
                coefficient: Rational::one(),
                factors: listed(&reduced.multiplier),
                squares: Vec::new(),
                series: Vec::new(),
                bounded: Vec::new(),
                facts: vec![position],
            }],
            cofactors: negated(&reduced.cofactors),
        };
        let sign = fact.sign;
        Ok(Some((Fact { polynomial, sign }, proof)))
    }
}

fn negated(map: &BTreeMap<usize, Polynomial>) -> Cofactors {
    let used = map.iter().filter(|(_, c)| !c.is_zero());
    used.map(|(at, c)| (*at, c.negated())).collect()
}

/// `M · goal^power = Σ C h`.
fn combination(reduced: &Reduced, power: u32) -> Proof {
    Proof::Combination {
        multiplier: listed(&reduced.multiplier),
        power,
        cofactors: cofactors(&reduced.cofactors),
    }
}

/// `M e · goal = Σ (goal · cofactor) h`, where `e` cannot vanish.
fn from_contradiction(element: &Tracked, goal: &Polynomial) -> Result<Proof, TooLarge> {
    let mut multiplier = element.multiplier.clone();
    *multiplier.entry(element.polynomial.clone()).or_insert(0) += 1;
    let mut used = BTreeMap::new();
    for (at, cofactor) in &element.cofactors {
        used.insert(*at, cofactor.times(goal)?);
    }
    Ok(Proof::Combination {
        multiplier: listed(&multiplier),
        power: 1,
        cofactors: cofactors(&used),
    })
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
