use super::series::{bounded_series, series_square};
use super::{
    Certificate, Cofactors, Fact, Factors, Knowledge, PositiveTerm, Problem, Proof, Reject, Sign,
};
use crate::algebra::{Polynomial, Var, expr_of, product};

/// Facts with what they say at a glance; lemmas are added to both.
pub(super) struct State<'a> {
    problem: &'a Problem,
    facts: Vec<Fact>,
    knowledge: Knowledge,
}

impl<'a> State<'a> {
    pub fn new(problem: &'a Problem) -> Self {
        State {
            problem,
            facts: problem.facts.clone(),
            knowledge: Knowledge::new(&problem.facts),
        }
    }

    /// Checks every lemma in order, then the goal and that it is defined.
    pub fn certificate(&mut self, certificate: &Certificate) -> Result<(), Reject> {
        let known = |p: &&Polynomial| {
            p.vars()
                .iter()
                .all(|v| v.position() < self.problem.atoms.len())
        };
        if !certificate.polynomials().iter().all(known) {
            return Err(Reject::NoSuchUnknown);
        }
        for lemma in &certificate.lemmas {
            self.proof(&lemma.fact, &lemma.proof)?;
            self.knowledge.learn(&lemma.fact);
            self.facts.push(lemma.fact.clone());
        }
        self.definedness()?;
        self.proof(&self.problem.goal, &certificate.conclusion)
    }

    /// Whether every term of the goal has a value.
    fn definedness(&self) -> Result<(), Reject> {
        let (conditions, atoms) = (&self.problem.conditions, &self.problem.atoms);
        for divisor in conditions.divisors() {
            if !self.knowledge.is_nonzero(divisor) {
                return Err(Reject::MayVanish(expr_of(divisor, atoms)));
            }
        }
        for base in &conditions.nonnegative {
            if !self.knowledge.is_nonnegative(base) {
                return Err(Reject::MayBeNegative(expr_of(base, atoms)));
            }
        }
        for base in &conditions.positive {
            if !self.knowledge.is_positive(base) {
                return Err(Reject::MayBeNegative(expr_of(base, atoms)));
            }
        }
        if let Some(term) = conditions.doubtful.first() {
            return Err(Reject::MayHaveNoValue(term.clone()));
        }
        for change in &conditions.zero {
            if !self.problem.vanishes_throughout(change) {
                return Err(Reject::MayVary(expr_of(change, atoms)));
            }
        }
        Ok(())
    }

    fn proof(&self, fact: &Fact, proof: &Proof) -> Result<(), Reject> {
        let goal = &fact.polynomial;
        match (proof, fact.sign) {
            (
                Proof::Combination {
                    multiplier,
                    power,
                    cofactors,
                },
                Sign::Zero,
            ) => {
                if *power == 0 {
                    return Err(Reject::ZeroPower);
                }
                let left = self
                    .nonzero_product(multiplier)?
                    .times(&goal.pow(*power)?)?;
                self.identity(&left, &self.combination(cofactors)?)
            }
            (
                Proof::NonVanishing {
                    certain,
                    cofactor,
                    cofactors,
                },
                Sign::NonZero,
            ) => {
                let right = cofactor.times(goal)?.plus(&self.combination(cofactors)?);
                self.identity(&self.nonzero_product(certain)?, &right)
            }
            (
                Proof::Positivity {
                    multiplier,
                    terms,
                    cofactors,
                },
                Sign::NonNegative | Sign::Positive,
            ) => {
                let left = self.positive_product(multiplier)?.times(goal)?;
                let mut right = self.combination(cofactors)?;
                for term in terms {
                    right = right.plus(&self.positive_term(term)?);
                }
                if fact.sign == Sign::Positive && !terms.iter().any(|t| self.is_strict(t)) {
                    return Err(Reject::NotStrict);
                }
                self.identity(&left, &right)
            }
            (Proof::BothBounds { below, above }, Sign::Zero) => {
                let bound = |polynomial| Fact {
                    polynomial,
                    sign: Sign::NonNegative,
                };
                self.proof(&bound(goal.clone()), below)?;
                self.proof(&bound(goal.negated()), above)
            }
            (Proof::Logarithms(inner), Sign::Zero) => {
                let own = Some(goal).filter(|goal| **goal == self.problem.goal.polynomial);
                let taken = own.and(self.problem.goal_in_logarithms.clone());
                let polynomial = taken.ok_or(Reject::WrongKind)?;
                let sign = Sign::Zero;
                self.proof(&Fact { polynomial, sign }, inner)
            }
            (Proof::Square(inner), Sign::Zero) => {
                let polynomial = goal.pow(2)?.negated();
                let sign = Sign::NonNegative;
                self.proof(&Fact { polynomial, sign }, inner)
            }
            (Proof::Larger { larger, squares }, Sign::NonNegative | Sign::Positive) => {
                if !self.knowledge.is_nonnegative(larger) {
                    return Err(Reject::MayBeNegative(expr_of(larger, &self.problem.atoms)));
                }
                let polynomial = Proof::difference_of_squares(larger, goal)?;
                let sign = fact.sign;
                self.proof(&Fact { polynomial, sign }, squares)
            }
            (Proof::OfPower { power, base }, _) => self.of_power(fact, *power, *base),
            _ => Err(Reject::WrongKind),
        }
    }

    /// What is said of a power follows from nothing that is said of it: its base is spoken of without it.
    fn of_power(&self, fact: &Fact, power: Var, base: usize) -> Result<(), Reject> {
        let known = |f: &&Fact| matches!(f.sign, Sign::NonNegative | Sign::Positive);
        let own = self.facts.get(base).filter(known);
        let own = own.ok_or(Reject::NoSuchFact(base))?;
        if power.position() >= self.problem.atoms.len() {
            return Err(Reject::NoSuchUnknown);
        }
        let sign = self.problem.sign_of_base(power).ok_or(Reject::WrongKind)?;
        if own.polynomial != sign {
            return Err(Reject::MayBeNegative(expr_of(&sign, &self.problem.atoms)));
        }
        let told = self.problem.about_power(power, &self.knowledge)?;
        match told.contains(fact) {
            true => Ok(()),
            false => Err(Reject::WrongKind),
        }
    }

    fn identity(&self, left: &Polynomial, right: &Polynomial) -> Result<(), Reject> {
        match left == right {
            true => Ok(()),
            false => Err(Reject::IdentityFails),
        }
    }

    fn nonzero_product(&self, factors: &Factors) -> Result<Polynomial, Reject> {
        for (factor, _) in factors {
            if !self.knowledge.is_nonzero(factor) {
                return Err(Reject::MayVanish(expr_of(factor, &self.problem.atoms)));
            }
        }
        Ok(product(factors.iter().map(|(f, e)| (f, *e)))?)
    }

    fn positive_product(&self, factors: &Factors) -> Result<Polynomial, Reject> {
        for (factor, exponent) in factors {
            let square = exponent % 2 == 0 && self.knowledge.is_nonzero(factor);
            if !square && !self.knowledge.is_positive(factor) {
                return Err(Reject::MayBeNegative(expr_of(factor, &self.problem.atoms)));
            }
        }
        Ok(product(factors.iter().map(|(f, e)| (f, *e)))?)
    }

    fn combination(&self, cofactors: &Cofactors) -> Result<Polynomial, Reject> {
        let mut sum = Polynomial::zero();
        for (position, cofactor) in cofactors {
            let fact = self.facts.get(*position).filter(|f| f.sign == Sign::Zero);
            let equation = &fact.ok_or(Reject::NoSuchFact(*position))?.polynomial;
            sum = sum.plus(&cofactor.times(equation)?);
        }
        Ok(sum)
    }

    fn positive_term(&self, term: &PositiveTerm) -> Result<Polynomial, Reject> {
        if term.coefficient.is_negative() {
            return Err(Reject::NegativeCoefficient);
        }
        let mut value = Polynomial::constant(term.coefficient.clone());
        for (factor, exponent) in &term.factors {
            if exponent % 2 == 1 && !self.knowledge.is_nonnegative(factor) {
                return Err(Reject::MayBeNegative(expr_of(factor, &self.problem.atoms)));
            }
            value = value.times(&factor.pow(*exponent)?)?;
        }
        for square in &term.squares {
            value = value.times(&square.pow(2)?)?;
        }
        for series in &term.series {
            value = value.times(&series_square(self.problem, series)?)?;
        }
        for series in &term.bounded {
            value = value.times(&bounded_series(self.problem, series)?)?;
        }
        for position in &term.facts {
            let known = |f: &&Fact| matches!(f.sign, Sign::NonNegative | Sign::Positive);
            let fact = self.facts.get(*position).filter(known);
            value = value.times(&fact.ok_or(Reject::NoSuchFact(*position))?.polynomial)?;
        }
        Ok(value)
    }

    /// Whether a term that is not negative is known to be positive.
    fn is_strict(&self, term: &PositiveTerm) -> bool {
        let positive = |at: &usize| {
            self.facts
                .get(*at)
                .is_some_and(|f| f.sign == Sign::Positive)
        };
        !term.coefficient.is_zero()
            && term
                .factors
                .iter()
                .all(|(f, _)| self.knowledge.is_nonzero(f))
            && term.squares.iter().all(|s| self.knowledge.is_nonzero(s))
            && term.series.is_empty()
            && term.bounded.is_empty()
            && term.facts.iter().all(positive)
    }
}
