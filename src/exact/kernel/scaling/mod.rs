//! Scaling relations, `a ~ b` and `a ∝ b`: linear algebra on exponents.
//!
//! **Semantics.** Two situations are compared, in both of which every premise is true. In the second each
//! quantity `s` has `r_s` times the size that it has in the first, `r_s > 0`. What stands in a product of a
//! scaling relation is a size, so it is not 0 and its sign does not matter.
//!
//! - `a ~ b` says that `a/b` is the same number in both situations, whichever they are: a constant factor, and
//!   no quantity at all, is left open. For products of powers that is one linear equation in the `log r_s`,
//!   whose coefficients are the exponents.
//! - `a ∝ b` says it of situations in which the symbols that are declared `constant`, and occur in neither `a`
//!   nor `b`, are the same.
//! - `a = b` between products of powers says as much as `a ~ b`, and more. An equation with a sum in it says
//!   nothing of exponents by itself: from `F = A + B` does not follow `F ~ A`, of which either term may be the
//!   greater part. If its terms are known to scale alike, the sum scales as they do.
//! - π, undeclared, is the number.
//! - What depends on the variable of an integral or derivative runs in both situations through the same curve,
//!   stretched. So `∫_0^T f dt` scales as `f · T` and `da/dt` as `a/t`, with `f` and `a` for the sizes of these
//!   functions; and where `t` itself is spoken of, `t ~ T`. A premise about such a function must hold
//!   throughout, not at one point.
//! - Each application `F(x)` is a quantity of its own: it is neither `F` nor a function known to the kernel.
//!
//! A goal is proved by a rational combination of the premises' exponents, and refuted by two situations. The
//! kernel reads all exponents from the claim and evaluates every premise in both situations, those included
//! that say nothing of exponents: equations with sums, inequalities, domains.

mod product;
mod rows;
mod situations;
mod size;

use super::{Claim, Reject};
use crate::algebra::{Expr, Rational};
use crate::sorted::Map;
pub use product::Product;
pub(in crate::kernel) use rows::sides;
pub use rows::{Row, Rows};
pub use size::Size;

/// A rational combination of rows: each by its position, with its coefficient.
pub type Combination = Vec<(usize, Rational)>;

/// Why a scaling relation follows.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ScalingProof {
    /// Sums and integrals that are shown to scale as products, in order; each adds a row.
    pub alike: Vec<Alike>,
    /// `left / right = Π row^coefficient`, but for constant factors.
    pub combination: Combination,
}

/// That a sum scales as its first term, because all do; or an integral, because both limits do.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Alike {
    /// The sum or integral, as it stands among the quantities.
    pub term: Expr,
    /// For each further term of the sum (for the lower limit of the integral) that it scales as the first (as
    /// the upper one).
    pub combinations: Vec<Combination>,
}

/// Two situations in which all premises are true, and between which the sides of the goal change differently.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Situations {
    /// Hypotheses `quantity = term`, in order, whose quantity occurs in nothing that is left: it can have the
    /// value of the term in either situation.
    pub aside: Vec<usize>,
    /// Each quantity in the first and in the second situation.
    pub values: Map<Expr, (Size, Size)>,
}

/// What the search hands over. Nothing in here is believed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ScalingCandidate {
    /// The goal follows.
    Proof(ScalingProof),
    /// It does not.
    Counterexample(Situations),
}

/// A scaling relation that the kernel has seen proved. Only [`PosedScaling`] builds one.
///
/// ```compile_fail
/// use cradle_exact::kernel::{Claim, ScalingProof, Scales};
/// fn forge(claim: Claim, proof: ScalingProof) -> Scales {
///     Scales { claim, proof }
/// }
/// ```
#[derive(Clone, Debug)]
pub struct Scales {
    claim: Claim,
    proof: ScalingProof,
}

/// A scaling relation that the kernel has seen refuted. Only [`check_scaling`] builds one.
///
/// ```compile_fail
/// use cradle_exact::kernel::{Claim, Situations, ScalesNot};
/// fn forge(claim: Claim, situations: Situations) -> ScalesNot {
///     ScalesNot { claim, situations }
/// }
/// ```
#[derive(Clone, Debug)]
pub struct ScalesNot {
    claim: Claim,
    situations: Situations,
}

/// What the kernel has found of a scaling relation.
#[derive(Clone, Debug)]
pub enum ScalingVerdict {
    /// It follows.
    Proven(Scales),
    /// It does not.
    Refuted(ScalesNot),
}

/// Decides whether a candidate is evidence for or against a scaling relation.
///
/// # Errors
/// The first reason found for which it is not.
pub fn check_scaling(claim: Claim, candidate: ScalingCandidate) -> Result<ScalingVerdict, Reject> {
    match candidate {
        ScalingCandidate::Proof(proof) => {
            let proven = PosedScaling::new(claim)?.check(proof)?;
            Ok(ScalingVerdict::Proven(proven))
        }
        ScalingCandidate::Counterexample(situations) => {
            situations::check(&claim, &situations)?;
            Ok(ScalingVerdict::Refuted(ScalesNot { claim, situations }))
        }
    }
}

/// A scaling relation together with the rows that the kernel makes of it, so that several proofs can be checked
/// without reading the claim anew for each.
///
/// The fields are private: the rows are the claim's own, and stay so.
pub struct PosedScaling {
    claim: Claim,
    rows: Rows,
}

impl PosedScaling {
    /// Reads a claim.
    ///
    /// # Errors
    /// As [`Rows::new`].
    pub fn new(claim: Claim) -> Result<Self, Reject> {
        let rows = Rows::new(&claim)?;
        Ok(PosedScaling { claim, rows })
    }

    /// What must follow from what.
    pub fn claim(&self) -> &Claim {
        &self.claim
    }

    /// The claim as rows of exponents: what proofs speak of.
    pub fn rows(&self) -> &Rows {
        &self.rows
    }

    /// Decides whether the goal follows as a proof says.
    ///
    /// # Errors
    /// The first reason found for which it does not.
    pub fn check(&self, proof: ScalingProof) -> Result<Scales, Reject> {
        self.rows.clone().check(&proof)?;
        let claim = self.claim.clone();
        Ok(Scales { claim, proof })
    }
}

impl Scales {
    /// What was proved.
    pub fn claim(&self) -> &Claim {
        &self.claim
    }

    /// How.
    pub fn proof(&self) -> &ScalingProof {
        &self.proof
    }
}

impl ScalesNot {
    /// What was refuted.
    pub fn claim(&self) -> &Claim {
        &self.claim
    }

    /// The two situations.
    pub fn situations(&self) -> &Situations {
        &self.situations
    }

    /// By how much a term grows from the first situation to the second.
    pub fn growth(&self, term: &Expr) -> Option<Size> {
        situations::growth(&self.claim, &self.situations, term).ok()
    }
}
