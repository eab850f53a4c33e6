//! The kernel: the one place where a verdict can be made.
//!
//! A [`Claim`] says what must follow from what. The search hands over a [`Candidate`]; [`check`] replays a
//! proof or evaluates a counterexample, in exact arithmetic, and builds [`Proven`] or [`Refuted`], which
//! nothing else can. It searches nothing, reads no file and prints nothing; it depends on the exact algebra
//! and the certificate language alone.
//!
//! | certificate | the kernel's work |
//! | --- | --- |
//! | [`Proof::Combination`] | multiplier · goal^power = Σ cofactor · equation, the multiplier not vanishing |
//! | [`Proof::NonVanishing`] | certain = cofactor · goal + Σ cofactor · equation |
//! | [`Proof::Positivity`] | multiplier · goal = Σ nonnegative terms + Σ cofactor · equation |
//! | [`Proof::BothBounds`] | a ≥ 0 and −a ≥ 0 |
//! | [`Proof::Square`] | −a² ≥ 0 |
//! | [`Proof::Logarithms`] | a > 0 and b > 0 and ln a = ln b |
//! | [`Proof::Larger`] | a ≥ 0 and a² − (a − goal)² ≥ 0 |
//! | [`Rate`] | a law differentiated anew: its derivative vanishes too |
//! | [`Assignment`] | evaluate: premises true, goal false |
//! | [`Algebraic`] | the same, modulo a polynomial with one root between two numbers |
//! | [`ScalingProof`] | exponents of the goal = Σ rational · exponents of a premise |
//! | [`Situations`] | evaluate in both: premises true, the goal's sides grow differently |
//! | [`Reasoning`] | the claims at the first indices and from one to the next, each with its certificate |
//! | [`Family`] | the premises and the opposite of the goal for every number, each with its certificate; the first is evaluated |
//!
//! [`check`] judges relations between numbers at one point, [`check_scaling`] relations between two situations,
//! [`check_for_every`] relations between the elements of sequences, [`check_family`] counterexamples for every number at once.

mod algebraic;
mod certificate;
mod claim;
mod course;
pub mod dimension;
mod exponentials;
mod family;
mod functions;
mod in_pi;
mod induction;
mod knowledge;
mod logarithms;
mod logarithms_of_numbers;
mod obligation;
mod powers;
mod private;
mod problem;
mod rates;
mod replay;
mod running;
mod scaling;
mod series;
mod unknown;
mod verdict;
mod witness;

pub use algebraic::Field;
pub use certificate::{
    Algebraic, Assignment, BoundedSeries, Candidate, Certificate, Cofactors, Course, ElementFactor,
    ElementSide, Fact, Factors, Lemma, PositiveTerm, Proof, SeriesSquare, Sign,
};
pub use claim::{Claim, Domain, Hypothesis, Standing};
pub use course::slope_along;
pub use family::{FailsThroughout, Family, FamilyPart, Group, check_family};
pub(crate) use functions::pi_is_the_number;
pub use in_pi::in_powers_of_pi;
pub use induction::{
    ForEvery, HoldsForEvery, Instance, Part, PartOrigin, ProvenPart, Reasoning, at_the_index,
    check_for_every, refute_for_every,
};
pub use knowledge::Knowledge;
pub use obligation::Obligation;
pub(crate) use problem::applied_definition;
pub use problem::{Origin, Problem, definition};
pub use rates::Rate;
pub use scaling::{
    Alike, Combination, PosedScaling, Product, Row, Rows, Scales, ScalesNot, ScalingCandidate,
    ScalingProof, ScalingVerdict, Situations, Size, check_scaling,
};
pub(crate) use series::bounded_series;
pub use unknown::{running_in, with_constant_functions};
pub use verdict::{Checked, Model, Proven, Refuted, Reject};

/// Decides whether a candidate is evidence for or against a claim.
///
/// # Errors
/// The first reason found for which it is not.
pub fn check(claim: Claim, candidate: Candidate) -> Result<Checked, Reject> {
    Obligation::new(claim, candidate.unfold().to_vec())?.check(candidate)
}

/// Decides whether all domains and hypotheses of a claim are true at a point. The goal is not looked at.
///
/// # Errors
/// The first reason found for which they are not.
pub fn check_model(claim: &Claim, point: Assignment) -> Result<Model, Reject> {
    Obligation::of_premises(claim.clone(), point.unfold.clone())?.model(point)
}
