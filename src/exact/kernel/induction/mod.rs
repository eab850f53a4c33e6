//! Statements about every element of a sequence, and proofs by induction.
//!
//! A [`ForEvery`] is a claim with an index `n` in it, of which some hypotheses are said of every `n`. The kernel makes
//! ordinary claims of it, in one way only ([`ForEvery::part`]), and has each of them proved by an ordinary certificate:
//!
//! $$ P(n_0),\ \dots,\ P(n_0+d-1), \qquad P(n), \dots, P(n+d-1) \vdash P(n+d) \qquad\Longrightarrow\qquad P(n) \text{ for all } n \ge n_0 $$
//!
//! **Source.** Peano's fifth axiom. **Trusts** that what is called `throughout` is, and that plain symbols which are not
//! called `varying` are the same number for every index: who makes the claim answers for both.

mod go_on;
mod part;

use num_traits::{One, Signed, ToPrimitive};

use super::{Candidate, Certificate, Checked, Claim, Domain, Problem, Proven, Reject, check};
use crate::algebra::{Moved, Symbol};
use crate::sorted::{Map, Set};

pub use go_on::{at_the_index, refute_for_every};
pub use part::PartOrigin;

/// Inductions that need more bases are not looked at.
const MOST_BASES: usize = 4;
/// An index that begins later is not looked at.
const LATEST_START: u32 = 1_000;

/// A claim about every value of an index.
///
/// **Semantics.** A name with the index in its subscript, `E_n` or `E_{n+1}`, is the element of a sequence; `E_0` is
/// one too. Every other symbol is one number. The index runs through its declared domain. The claim: wherever the
/// hypotheses `throughout` are true for every index, and the others for the index in question, so is the goal.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ForEvery {
    /// What is to follow, at the index itself.
    pub claim: Claim,
    /// The index.
    pub index: Symbol,
    /// The hypotheses that are said of every index, by position.
    pub throughout: Set<usize>,
    /// The domain of the elements whose number is in the range of the index, by the name of the sequence.
    pub elements: Map<Symbol, Domain>,
    /// Symbols without the index in their name that may depend on it all the same.
    pub varying: Set<Symbol>,
}

/// A hypothesis that is said of every index, at one of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Instance {
    /// The position of the hypothesis.
    pub hypothesis: usize,
    /// The index for which it is taken.
    pub at: Moved,
}

/// One part of a proof: an ordinary one from hypotheses at some indices.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Part {
    /// The hypotheses that depend on the index, each as often as it is needed.
    pub instances: Vec<Instance>,
    /// The proof.
    pub certificate: Certificate,
}

/// Why something is true for every index.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Reasoning {
    /// It follows from hypotheses at this index and others.
    Direct(Part),
    /// It is true for the first indices, and for the next one where it is true for as many before.
    Induction {
        /// For the first index, the second, and so on.
        bases: Vec<Part>,
        /// From as many as there are bases to the next.
        step: Part,
    },
}

/// A claim about every index that the kernel has seen proved. Only [`check_for_every`] builds one.
///
/// ```compile_fail
/// use cradle_exact::kernel::{ForEvery, HoldsForEvery};
/// fn forge(claim: ForEvery) -> HoldsForEvery {
///     HoldsForEvery { claim, bases: Vec::new(), last: todo!() }
/// }
/// ```
#[derive(Clone, Debug)]
pub struct HoldsForEvery {
    claim: ForEvery,
    bases: Vec<ProvenPart>,
    last: ProvenPart,
}

/// One part of a proof, as it was checked.
#[derive(Clone, Debug)]
pub struct ProvenPart {
    /// What the kernel has seen proved.
    pub proven: Proven,
    /// Where each of its hypotheses comes from.
    pub origins: Vec<PartOrigin>,
}

impl HoldsForEvery {
    /// What was proved.
    pub fn claim(&self) -> &ForEvery {
        &self.claim
    }

    /// The bases of an induction; none where the proof is direct.
    pub fn bases(&self) -> &[ProvenPart] {
        &self.bases
    }

    /// The step of an induction, or the direct proof.
    pub fn last(&self) -> &ProvenPart {
        &self.last
    }
}

impl ForEvery {
    /// The least value of the index.
    ///
    /// # Errors
    /// The index does not run through all whole numbers from one on.
    pub fn start(&self) -> Result<u32, Reject> {
        let none = || Reject::NoRun(self.index.clone());
        let domain = self.claim.domains.get(&self.index).ok_or_else(none)?;
        let (bound, strict) = domain.lower.as_ref().ok_or_else(none)?;
        let runs = domain.integer && domain.upper.is_none() && !domain.constant;
        if !runs || bound.is_negative() || !self.index.can_be_index() {
            return Err(none());
        }
        let mut least = bound.ceil();
        if *strict && least == *bound {
            least += crate::algebra::BigRational::one();
        }
        if domain.nonzero && !least.is_positive() {
            return Err(none());
        }
        let least = least.to_integer().to_u32();
        least.filter(|&l| l <= LATEST_START).ok_or_else(none)
    }

    /// A hypothesis that says nothing of the index: it is there in every part.
    pub fn is_constant(&self, position: usize) -> bool {
        let hypothesis = self.claim.hypotheses.get(position);
        hypothesis.is_some_and(|h| !h.formula.depends_on(&self.index))
    }

    fn prove(&self, goal: Moved, supposed: u32, part: Part) -> Result<ProvenPart, Reject> {
        let (claim, origins) = self.part(goal, supposed, &part.instances)?;
        if supposed > 0 {
            // What is supposed of one index is supposed at one point.
            if let Some(rate) = part.certificate.rates.first() {
                return Err(Reject::NoRate(rate.fact));
            }
            let problem = Problem::new(&claim, &part.certificate.unfold)?;
            part::has_value(&problem, &origins)?;
        }
        match check(claim, Candidate::Proof(part.certificate))? {
            Checked::Proven(proven) => Ok(ProvenPart { proven, origins }),
            Checked::Refuted(_) => Err(Reject::WrongKind),
        }
    }
}

/// Decides whether some reasoning shows a claim for every index.
///
/// # Errors
/// The first reason found for which it does not.
pub fn check_for_every(claim: ForEvery, reasoning: Reasoning) -> Result<HoldsForEvery, Reject> {
    let start = claim.start()?;
    match reasoning {
        Reasoning::Direct(part) => {
            let last = claim.prove(Moved::By(0), 0, part)?;
            Ok(HoldsForEvery {
                claim,
                bases: Vec::new(),
                last,
            })
        }
        Reasoning::Induction { bases, step } => {
            if bases.is_empty() || bases.len() > MOST_BASES {
                return Err(Reject::NoBase);
            }
            let depth = bases.len() as u32;
            let numbered = (start..).zip(bases);
            let bases = numbered.map(|(number, part)| claim.prove(Moved::To(number), 0, part));
            let bases = bases.collect::<Result<Vec<_>, _>>()?;
            let last = claim.prove(Moved::By(depth), depth, step)?;
            Ok(HoldsForEvery { claim, bases, last })
        }
    }
}
