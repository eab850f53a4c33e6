//! From facts to a certificate: consequence first, sign (`sign`) second, and what roots are (`power`) before both.

mod power;
mod sign;

use super::elements;
use super::ideal::Ideal;
use super::positivity;
use super::roots::{beside_difference, root_of};
use super::tracked::{Nonzero, Reduced, Tracked, cofactors, expand, listed};
use crate::algebra::{Monomial, Polynomial, Rational, TooLarge, Var};
use crate::kernel::{BoundedSeries, Cofactors, Fact, Knowledge, Lemma, Problem, Proof, Sign};
use crate::sorted::Map;

/// The highest power of a goal that is tried: `(μ − 1)² = 0` gives `μ = 1`.
const HIGHEST_POWER: u32 = 3;
/// Two products are compared by these of their powers, besides the second.
const HIGHER_ROOTS: [u32; 2] = [3, 4];
/// How often roots are taken of what came of it.
const MOST_ROUNDS: usize = 3;
const REDUCTIONS: usize = 2_000;
const LIGHT_REDUCTIONS: usize = 60;

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
    /// The sign that was sought in vain last, and how many facts there were then.
    unproved: Option<(Fact, usize)>,
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
            unproved: None,
            bounded: elements::bounded(problem),
            has_bounded: false,
            has_simplified: false,
        };
        prover.sharpen();
        prover.take_roots(problem.takes_powers_apart())?;
        Ok(prover)
    }

    /// What is not negative and does not vanish is positive: `x ≤ 1` and `x ≠ 1` say `x < 1`.
    fn sharpen(&mut self) {
        let is_sharper = |own: &&Fact| {
            let mut terms = own.polynomial.terms();
            let is_plain = terms.all(|(_, coefficient)| coefficient.is_positive());
            own.sign == Sign::NonNegative
                && !is_plain
                && self.knowledge.is_positive(&own.polynomial)
        };
        let found: Vec<Polynomial> = (self.facts.iter().filter(is_sharper))
            .map(|own| own.polynomial.clone())
            .collect();
        for polynomial in found {
            let proof = Proof::Positivity {
                multiplier: Vec::new(),
                terms: vec![positivity::factor(polynomial.clone())],
                cofactors: Vec::new(),
            };
            let sign = Sign::Positive;
            self.add(Fact { polynomial, sign }, proof);
        }
    }

    /// Adds what equations say of positive unknowns below a common power: `v² = 2 t²` gives `v = √2 t`.
    ///
    /// Where no root is asked for, only of premises themselves: what two wrong ones say together is not helped.
    fn take_roots(&mut self, of_all: bool) -> Result<(), TooLarge> {
        for _ in 0..MOST_ROUNDS {
            let mut found = false;
            for element in &mut self.ideal.rest {
                element.divide_by_leads(&self.knowledge);
            }
            for at in 0..self.ideal.rest.len() {
                let element = &self.ideal.rest[at];
                if !of_all && element.sources().len() > 1 {
                    continue;
                }
                let Some((fact, proof)) = root_of(element, self)? else {
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
            self.read_equations()?;
        }
        Ok(())
    }

    /// Reads the equations anew, with those that were added.
    fn read_equations(&mut self) -> Result<(), TooLarge> {
        self.ideal = Ideal::new(&self.facts, &self.knowledge)?;
        (self.basis, self.signed, self.unproved) = (None, None, None);
        Ok(())
    }

    pub fn take_lemmas(&mut self) -> Vec<Lemma> {
        std::mem::take(&mut self.lemmas)
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
            (_, Effort::Full) => self.sign_in_earnest(fact),
        }
    }

    fn zero(&mut self, goal: &Polynomial, effort: Effort) -> Option<Proof> {
        if let Some(proof) = zero_by_elimination(&self.ideal, goal) {
            return Some(proof);
        }
        if let Some(ideal) = self.ideal.by_powers(&self.knowledge).ok()?
            && let Some(proof) = zero_by_elimination(&ideal, goal)
        {
            return Some(proof);
        }
        if effort == Effort::Light {
            return None;
        }
        let reduced = self.ideal.reduce(goal, false).ok()?;
        if !self.is_tied_down(&reduced.polynomial) {
            return None;
        }
        if !self.ideal.rest.is_empty() {
            let basis = self.basis().to_vec();
            for power in 1..=HIGHEST_POWER {
                let mut reduced = self.ideal.reduce(&goal.pow(power).ok()?, false).ok()?;
                let mut steps = REDUCTIONS;
                if reduced.normal_form(&basis, &mut steps).is_ok() && reduced.polynomial.is_zero() {
                    return combination(&reduced, power).ok();
                }
            }
            // A consequence that cannot vanish, and does: anything follows.
            let impossible = basis
                .iter()
                .find(|e| self.knowledge.is_nonzero(&e.polynomial));
            if let Some(own) = impossible {
                let cofactors = own.cofactors().ok()?;
                return from_contradiction(&own.polynomial, &own.multiplier, &cofactors, goal).ok();
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
        if let Some(proof) = self.zero_by_the_impossible(goal) {
            return Some(proof);
        }
        if !self.has_inequalities() && self.ideal.rest.is_empty() {
            return None;
        }
        let bound = |polynomial| Fact {
            polynomial,
            sign: Sign::NonNegative,
        };
        if let Some(below) = self.sign(&bound(goal.clone()))
            && let Some(above) = self.sign(&bound(goal.negated()))
        {
            return Some(Proof::BothBounds {
                below: below.into(),
                above: above.into(),
            });
        }
        let square = bound(goal.pow(2).ok()?.negated());
        Some(Proof::Square(self.sign(&square)?.into()))
    }

    /// Anything follows where something that cannot vanish does: `v = w` and `w = 2 v` leave nothing but 0 for both.
    fn zero_by_the_impossible(&self, goal: &Polynomial) -> Option<Proof> {
        let mut certain =
            (self.facts.iter()).filter(|f| matches!(f.sign, Sign::NonZero | Sign::Positive));
        let (fact, reduced) = certain.find_map(|fact| {
            let reduced = self.ideal.reduce(&fact.polynomial, false).ok()?;
            reduced.polynomial.is_zero().then_some((fact, reduced))
        })?;
        let cofactors = reduced.cofactors().ok()?;
        from_contradiction(&fact.polynomial, &reduced.multiplier, &cofactors, goal).ok()
    }

    /// The same with what cannot vanish kept to the end, so that it can be divided out of what is left: two
    /// resistors have one voltage, and it is none of the conclusion.
    fn zero_by_dividing(&self, goal: &Polynomial) -> Option<Proof> {
        let kept = |var| {
            let power = Monomial::power(var, 1);
            self.knowledge.monomial_is_nonzero(&power)
        };
        let ideal = Ideal::keeping(&self.facts, &self.knowledge, kept).ok()?;
        zero_by_elimination(&ideal, goal)
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
            let (Ok(cofactor), Ok(used)) = (expand(&reduced.outer), reduced.cofactors()) else {
                continue;
            };
            let mut certain = reduced.multiplier.clone();
            *certain.entry(own).or_insert(0) += 1;
            let proof = Proof::NonVanishing {
                certain: listed(&certain),
                cofactor,
                cofactors: cofactors(&used),
            };
            let sign = Sign::NonZero;
            self.add(Fact { polynomial, sign }, proof);
        }
        if self.facts.len() == before {
            return false;
        }
        self.read_equations().is_ok()
    }

    /// `a = b` from `a² = b²`, where neither is negative: what is a root of something is told by its square. So is a third or fourth root.
    fn zero_by_squares(&self, goal: &Polynomial, basis: &[Tracked]) -> Option<Proof> {
        if goal.len() < 2 {
            return None;
        }
        // Of `s - s R - r` the sum is `s - s R + r`, where `R < 1`.
        let with_signs = |is_changed: &dyn Fn(&Monomial, &Rational) -> bool| {
            let mut sum = Polynomial::zero();
            for (monomial, coefficient) in goal.terms() {
                let own = match is_changed(monomial, coefficient) {
                    true => -coefficient,
                    false => coefficient.clone(),
                };
                sum = sum.plus(&Polynomial::term(monomial.clone(), own));
            }
            sum
        };
        let mut sums = vec![with_signs(&|_, coefficient| coefficient.is_negative())];
        // What only its square is told of: a root.
        let is_root = |var: &Var| {
            let mut equations = self.facts.iter().filter(|own| own.sign == Sign::Zero);
            equations.any(|own| {
                let polynomial = &own.polynomial;
                let is_even = |(own, _): (&Monomial, _)| own.exponent(*var) % 2 == 0;
                polynomial.degree_in(*var) == 2 && polynomial.terms().all(is_even)
            })
        };
        for var in goal.vars().into_iter().filter(is_root) {
            let sum = with_signs(&|monomial, _| monomial.exponent(var) % 2 == 1);
            sums.extend([sum.negated(), sum]);
        }
        sums.extend(
            HIGHER_ROOTS
                .into_iter()
                .filter_map(|order| beside_root(goal, order)),
        );
        let mut sums = sums
            .into_iter()
            .filter(|sum| self.knowledge.is_positive(sum));
        let (sum, mut reduced) = sums.find_map(|sum| {
            let mut reduced = self.ideal.reduce(&goal.times(&sum).ok()?, false).ok()?;
            let settled = reduced.normal_form(basis, &mut { REDUCTIONS }).is_ok()
                && reduced.polynomial.is_zero();
            settled.then_some((sum, reduced))
        })?;
        *reduced.multiplier.entry(sum).or_insert(0) += 1;
        combination(&reduced, 1).ok()
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
                cofactors: negated(&reduced.cofactors().ok()?),
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
            if let Some(proof) = self.sign_in_earnest(&fact) {
                self.add(fact, proof);
                return Some(Proof::NonVanishing {
                    certain: vec![(goal.clone(), 1)],
                    cofactor: Polynomial::one(),
                    cofactors: Vec::new(),
                });
            }
        }
        self.nonzero_behind_factors(goal, effort)
    }

    /// What has any sign for the sake of a factor, `(n − 1) v` with `v ≠ 0`, does not vanish where the rest does not.
    fn nonzero_behind_factors(&mut self, goal: &Polynomial, effort: Effort) -> Option<Proof> {
        let (content, polynomial) = goal.without_content();
        if content.is_one() || !self.knowledge.monomial_is_nonzero(&content) {
            return None;
        }
        let polynomial = polynomial.into_owned();
        let proof = self.nonzero(&polynomial, effort)?;
        let sign = Sign::NonZero;
        self.add(Fact { polynomial, sign }, proof);
        Some(Proof::NonVanishing {
            certain: vec![(goal.clone(), 1)],
            cofactor: Polynomial::one(),
            cofactors: Vec::new(),
        })
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
        let mut used = element.cofactors().ok()?;
        let cofactor = used.remove(&own).unwrap_or_default();
        Some(Proof::NonVanishing {
            certain: listed(&certain),
            cofactor,
            cofactors: cofactors(&used),
        })
    }

    /// Whether every unknown occurs in some fact: one that occurs in none can have any value.
    fn is_tied_down(&self, polynomial: &Polynomial) -> bool {
        let facts = || self.facts.iter().map(|f| &f.polynomial);
        let sums = || self.bounded.iter().map(|b| &b.0);
        let occurs = |var| facts().chain(sums()).any(|p| p.has(var));
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
}

fn negated(map: &Map<usize, Polynomial>) -> Cofactors {
    let used = map.iter().filter(|(_, c)| !c.is_zero());
    used.map(|(at, c)| (*at, c.negated())).collect()
}

/// What `a − b` is multiplied by to be `a^g − b^g`: the sum of all `a^i b^(g−1−i)`.
fn beside_root(goal: &Polynomial, order: u32) -> Option<Polynomial> {
    let mut terms = goal.terms();
    let (Some((m, c)), Some((n, d)), None) = (terms.next(), terms.next(), terms.next()) else {
        return None;
    };
    let (c, d) = if c.is_negative() {
        (-c, d.clone())
    } else {
        (c.clone(), -d)
    };
    let left = Polynomial::term(m.clone(), c);
    let right = Polynomial::term(n.clone(), d);
    beside_difference(&left, &right, order).ok()
}

/// What elimination gives. What it leaves may already be a multiple of the goal; no basis is needed to see that.
fn zero_by_elimination(ideal: &Ideal, goal: &Polynomial) -> Option<Proof> {
    let mut reduced = ideal.reduce(goal, false).ok()?;
    if !reduced.polynomial.is_zero() {
        reduced
            .normal_form(&ideal.rest, &mut { LIGHT_REDUCTIONS })
            .ok()?;
    }
    let settled = reduced.polynomial.is_zero();
    settled.then(|| combination(&reduced, 1).ok())?
}

/// `M · goal^power = Σ C h`.
fn combination(reduced: &Reduced, power: u32) -> Result<Proof, TooLarge> {
    Ok(Proof::Combination {
        multiplier: listed(&reduced.multiplier),
        power,
        cofactors: cofactors(&reduced.cofactors()?),
    })
}

/// `M e · goal = Σ (goal · cofactor) h`, where `e` cannot vanish and `M e = Σ cofactor h`.
fn from_contradiction(
    certain: &Polynomial,
    multiplier: &Nonzero,
    own: &Map<usize, Polynomial>,
    goal: &Polynomial,
) -> Result<Proof, TooLarge> {
    let mut multiplier = multiplier.clone();
    *multiplier.entry(certain.clone()).or_insert(0) += 1;
    let mut used = Map::new();
    for (at, cofactor) in own {
        used.insert(*at, cofactor.times(goal)?);
    }
    Ok(Proof::Combination {
        multiplier: listed(&multiplier),
        power: 1,
        cofactors: cofactors(&used),
    })
}
