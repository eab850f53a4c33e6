use super::powers::said_positive;
use super::{
    Assignment, Candidate, Checked, Claim, Hypothesis, Model, Problem, Proven, Refuted, Reject,
    definition, replay, witness,
};
use crate::algebra::{Expr, Formula, Symbol};
use crate::sorted::Set;

/// A claim together with the problem that the kernel makes of it, so that several candidates can be checked
/// without reading the claim anew for each.
///
/// The fields are private: the problem is the claim's own, and stays so.
#[derive(Clone, Debug)]
pub struct Obligation {
    claim: Claim,
    unfold: Vec<usize>,
    problem: Problem,
    /// The same as written, where that is something else.
    as_written: Option<Problem>,
}

impl Obligation {
    /// Reads a claim, the hypotheses `unfold` put in.
    ///
    /// # Errors
    /// As [`Problem::new`].
    pub fn new(claim: Claim, unfold: Vec<usize>) -> Result<Self, Reject> {
        let problem = Problem::new(&claim, &unfold)?;
        let apart = problem.takes_powers_apart();
        let as_written = apart.then(|| Problem::as_written(&claim, &unfold));
        Ok(Obligation {
            as_written: as_written.transpose()?,
            claim,
            unfold,
            problem,
        })
    }

    /// The same for the domains and hypotheses of a claim alone: the goal is `0 = 0`.
    ///
    /// # Errors
    /// As [`Problem::new`].
    pub fn of_premises(mut claim: Claim, unfold: Vec<usize>) -> Result<Self, Reject> {
        claim.goal = Formula::equal(Expr::integer(0), Expr::integer(0));
        Obligation::new(claim, unfold)
    }

    /// What must follow from what.
    pub fn claim(&self) -> &Claim {
        &self.claim
    }

    /// The hypotheses that are put in.
    pub fn unfold(&self) -> &[usize] {
        &self.unfold
    }

    /// The claim as it is evaluated at points: with every power as it is written.
    pub fn as_written(&self) -> &Problem {
        self.as_written.as_ref().unwrap_or(&self.problem)
    }

    /// The claim as facts about polynomials: what certificates speak of.
    pub fn problem(&self) -> &Problem {
        &self.problem
    }

    /// Decides whether a candidate is evidence for or against the claim.
    ///
    /// # Errors
    /// The first reason found for which it is not. A candidate that puts other hypotheses in is read anew.
    pub fn check(&self, candidate: Candidate) -> Result<Checked, Reject> {
        if candidate.unfold() != self.unfold {
            return super::check(self.claim.clone(), candidate);
        }
        let claim = || self.claim.clone();
        match candidate {
            Candidate::Proof(certificate) => {
                let more = match certificate.rates.as_slice() {
                    [] => None,
                    rates => Some(self.problem.with_rates(rates)?),
                };
                let problem = more.as_ref().unwrap_or(&self.problem);
                replay::State::new(problem).certificate(&certificate)?;
                Ok(Checked::Proven(Proven {
                    claim: claim(),
                    certificate,
                }))
            }
            Candidate::Counterexample(witness) => {
                let mut point = witness::Point::new(&self.claim, self.as_written(), &witness);
                point.premises()?;
                point.goal_is_false()?;
                Ok(Checked::Refuted(Refuted {
                    claim: claim(),
                    witness,
                }))
            }
        }
    }

    /// Decides whether all domains and hypotheses are true at a point. The goal is not looked at.
    ///
    /// # Errors
    /// The first reason found for which they are not.
    pub fn model(&self, point: Assignment) -> Result<Model, Reject> {
        if point.unfold != self.unfold {
            return super::check_model(&self.claim, point);
        }
        witness::Point::new(&self.claim, self.as_written(), &point).premises()?;
        Ok(Model { point })
    }

    /// Whether a counterexample to another claim is one to this: the other is about fewer situations, for more is constant in it, or more
    /// of what it speaks of is said to be positive, or to be some number.
    ///
    /// # Errors
    /// The other claim is not the same with further symbols constant, and further premises that symbols of its own are positive, or
    /// numbers.
    pub fn refuted_by_fewer(&self, other: &Refuted) -> Result<(), Reject> {
        let mut own = self.claim.clone();
        let further = other.claim.hypotheses.iter().skip(own.hypotheses.len());
        let quantities = self.quantities();
        let is_told = |further: &Hypothesis| {
            let symbol = said_positive(&further.formula);
            let symbol = symbol.or_else(|| further.formula.set_to_number());
            symbol.is_some_and(|own| quantities.contains(own))
        };
        own.hypotheses
            .extend(further.filter(|own| is_told(own)).cloned());
        let constant = other.claim.domains.iter().filter(|(_, own)| own.constant);
        for (symbol, _) in constant {
            // To declare it would make π any constant, and a point at which it is another number is none of this claim.
            if symbol.name() != "\\pi" || own.domains.contains_key(symbol) {
                own.domains.entry(symbol.clone()).or_default().constant = true;
            }
        }
        match own == other.claim {
            true => Ok(()),
            false => Err(Reject::OfAnotherClaim),
        }
    }

    /// The symbols of which the claim speaks that are one quantity each, and not the number π: of these a further premise may tell.
    fn quantities(&self) -> Set<&Symbol> {
        let named = self.claim.free_symbols().into_iter();
        let is_one =
            |own: &&Symbol| own.name() != "\\pi" && !self.claim.sequences.contains_key(*own);
        named.filter(is_one).collect()
    }

    /// Refutes a relation by its opposite: this follows from the hypotheses, and from which numbers symbols are at the point, and there all
    /// hypotheses are true. Where the values are `\ln 2` and the like, no side has one that could be compared.
    ///
    /// # Errors
    /// What is proved is not the opposite, or a hypothesis is not known to be true at the point.
    pub fn refuted_by_opposite(
        &self,
        opposite: &Proven,
        point: Assignment,
    ) -> Result<Refuted, Reject> {
        let mut own = self.claim.clone();
        if let Formula::Relation { relation, .. } = &mut own.goal {
            *relation = relation.denied().ok_or(Reject::UnsupportedRelation)?;
        }
        let is_put_in = |symbol: &Symbol| {
            let mut put_in = point.unfold.iter().map(|&at| &self.claim.hypotheses[at]);
            put_in.any(|own| definition(&own.formula).is_none_or(|own| own.0 == *symbol))
        };
        let quantities = self.quantities();
        let is_so = |further: &&Hypothesis| match further.formula.number_said() {
            Some((symbol, number)) => {
                quantities.contains(symbol)
                    && point.symbols.get(symbol) == Some(number)
                    && !is_put_in(symbol)
            }
            None => false,
        };
        if point.unfold.iter().any(|&at| at >= own.hypotheses.len()) {
            return Err(Reject::NotUnfoldable(own.hypotheses.len()));
        }
        let further = opposite.claim.hypotheses.iter().skip(own.hypotheses.len());
        own.hypotheses.extend(further.filter(is_so).cloned());
        if own != opposite.claim || own == self.claim {
            return Err(Reject::OfAnotherClaim);
        }
        let model = self.model(point)?;
        Ok(Refuted {
            claim: self.claim.clone(),
            witness: model.point,
        })
    }
}
