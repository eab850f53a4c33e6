use super::{
    Assignment, Candidate, Checked, Claim, Model, Problem, Proven, Refuted, Reject, replay, witness,
};
use crate::algebra::{Expr, Formula};

/// A claim together with the problem that the kernel makes of it, so that several candidates can be checked
/// without reading the claim anew for each.
///
/// The fields are private: the problem is the claim's own, and stays so.
#[derive(Clone, Debug)]
pub struct Obligation {
    claim: Claim,
    unfold: Vec<usize>,
    problem: Problem,
}

impl Obligation {
    /// Reads a claim, the hypotheses `unfold` put in.
    ///
    /// # Errors
    /// As [`Problem::new`].
    pub fn new(claim: Claim, unfold: Vec<usize>) -> Result<Self, Reject> {
        let problem = Problem::new(&claim, &unfold)?;
        Ok(Obligation {
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

    /// The claim as facts about polynomials.
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
                replay::State::new(&self.problem).certificate(&certificate)?;
                Ok(Checked::Proven(Proven {
                    claim: claim(),
                    certificate,
                }))
            }
            Candidate::Counterexample(witness) => {
                let mut point = witness::Point::new(&self.claim, &self.problem, &witness);
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
        witness::Point::new(&self.claim, &self.problem, &point).premises()?;
        Ok(Model { point })
    }
}
