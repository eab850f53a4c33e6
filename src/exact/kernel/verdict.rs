use super::{Assignment, Certificate, Claim};
use crate::algebra::{Expr, Symbol};
use std::fmt;

/// A claim that the kernel has seen proved. Only [`check`](super::check) builds one.
///
/// ```compile_fail
/// use cradle_exact::kernel::Proven;
/// fn forge(claim: cradle_exact::kernel::Claim, certificate: cradle_exact::kernel::Certificate) -> Proven {
///     Proven { claim, certificate }
/// }
/// ```
#[derive(Clone, Debug)]
pub struct Proven {
    pub(super) claim: Claim,
    pub(super) certificate: Certificate,
}

/// A claim that the kernel has seen refuted. Only [`check`](super::check) builds one.
///
/// ```compile_fail
/// use cradle_exact::kernel::Refuted;
/// fn forge(claim: cradle_exact::kernel::Claim, witness: cradle_exact::kernel::Assignment) -> Refuted {
///     Refuted { claim, witness }
/// }
/// ```
#[derive(Clone, Debug)]
pub struct Refuted {
    pub(super) claim: Claim,
    pub(super) witness: Assignment,
}

/// A point at which all hypotheses of a claim hold together: nothing follows from them for want of one.
/// Only [`check_model`](super::check_model) builds one.
///
/// ```compile_fail
/// use cradle_exact::kernel::Model;
/// fn forge(point: cradle_exact::kernel::Assignment) -> Model {
///     Model { point }
/// }
/// ```
#[derive(Clone, Debug)]
pub struct Model {
    pub(super) point: Assignment,
}

/// What the kernel has found of a claim.
#[derive(Clone, Debug)]
pub enum Checked {
    /// It follows.
    Proven(Proven),
    /// It does not.
    Refuted(Refuted),
}

impl Proven {
    /// What was proved.
    pub fn claim(&self) -> &Claim {
        &self.claim
    }

    /// How.
    pub fn certificate(&self) -> &Certificate {
        &self.certificate
    }
}

impl Refuted {
    /// What was refuted.
    pub fn claim(&self) -> &Claim {
        &self.claim
    }

    /// Where the hypotheses are true and the goal false.
    pub fn witness(&self) -> &Assignment {
        &self.witness
    }
}

impl Model {
    /// Where all hypotheses are true.
    pub fn point(&self) -> &Assignment {
        &self.point
    }
}

/// Why the kernel does not accept a candidate.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Reject {
    /// The hypothesis with this position cannot be put in for its symbol.
    NotUnfoldable(usize),
    /// There is no fact at this position, or it is not of the kind that is needed.
    NoSuchFact(usize),
    /// The evidence is about a claim that is not this one with more held constant.
    OfAnotherClaim,
    /// The relation is not one that the certificates speak of.
    UnsupportedRelation,
    /// The proof is of another kind than the goal.
    WrongKind,
    /// The two sides of the certificate's identity differ.
    IdentityFails,
    /// A multiplier, or something divided by in the goal, is not known to be different from 0.
    MayVanish(Expr),
    /// A factor is not known to be positive.
    MayBeNegative(Expr),
    /// A coefficient of a term that should not be negative is.
    NegativeCoefficient,
    /// No term of a proof of strict positivity is itself positive.
    NotStrict,
    /// The power of the goal is 0.
    ZeroPower,
    /// A derivative that was taken to vanish is not known to.
    MayVary(Expr),
    /// It is not known whether a term of the goal has a value at all.
    MayHaveNoValue(Expr),
    /// The certificate speaks of an unknown that the claim does not have.
    NoSuchUnknown,
    /// A power sum that a certificate speaks of does not occur in the claim.
    NoSuchSum,
    /// Nothing is declared that would keep an element of this sequence from being negative in that way.
    NoSuchBound(Symbol),
    /// The point gives no value to a term.
    NoValue,
    /// A function takes no such value: a sine and cosine off the unit circle, an exponential that is not positive, a
    /// root whose power is not what it is taken of.
    NoSuchValue,
    /// The polynomial that is to define a number has a root more than once.
    NotSquarefree,
    /// A number that is to isolate a root is itself one.
    RootAtEnd,
    /// There are so many roots where there should be one.
    NotIsolated(usize),
    /// A sine is given without its cosine, or a cosine without its sine.
    NoPartner,
    /// A symbol that was left open has to have a value of its own.
    NotPrivate,
    /// Nothing need move through the point in the way that the laws about derivatives ask.
    NoCourse,
    /// The hypothesis (or domain condition) with this position is false at the point.
    PremiseFalse(usize),
    /// A value lies outside of the domain of its symbol.
    OutsideDomain,
    /// The goal is true, or not defined, at the point.
    GoalNotFalse,
    /// Something is divided by 0 identically.
    DivisionByZero,
    /// A term of a scaling relation cannot be read as a product of powers.
    NotAProduct(Expr),
    /// What the hypothesis with this position speaks of is spoken of elsewhere, or may have no value.
    NotSetAside(usize),
    /// The index is not known to run through all whole numbers from one on.
    NoRun(Symbol),
    /// The fact with this position may have no derivative.
    NoRate(usize),
    /// The hypothesis with this position is not said of every index.
    NotThroughout(usize),
    /// A premise is used at an index for which it is not said.
    OutOfRange(usize),
    /// What is said cannot be said of another index.
    Unmovable,
    /// This symbol may be another number for another index.
    MayRun(Symbol),
    /// An induction begins nowhere.
    NoBase,
    /// Values up to some index are not known to go on for ever.
    MayEnd,
    /// What is said cannot be said of every member of a family in one way.
    NoFamily,
    /// A bound on the size of the computation was exceeded.
    TooLarge,
}

impl fmt::Display for Reject {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Reject::NotUnfoldable(_) => "a hypothesis cannot be put in for a symbol",
            Reject::NoSuchFact(_) => "the certificate names a fact that is not there",
            Reject::OfAnotherClaim => "the evidence is about another claim",
            Reject::UnsupportedRelation => "the relation is not one that can be decided yet",
            Reject::WrongKind => "the proof is of another kind than the goal",
            Reject::IdentityFails => "the certificate's identity does not hold",
            Reject::MayVanish(_) => "a divisor or multiplier may vanish",
            Reject::MayBeNegative(_) => "a factor may be negative",
            Reject::NegativeCoefficient => "a coefficient is negative",
            Reject::NotStrict => "nothing in the proof is strictly positive",
            Reject::ZeroPower => "the goal does not occur in the certificate",
            Reject::MayVary(_) => "a symbol that was held constant may vary",
            Reject::MayHaveNoValue(_) => "a term may have no value",
            Reject::NoSuchUnknown => "the certificate names an unknown that is not there",
            Reject::NoSuchSum => "the certificate names a sum that is not there",
            Reject::NoSuchBound(_) => "a factor under a sum may be negative",
            Reject::NoValue => "the point does not give every term a value",
            Reject::NoSuchValue => "a function takes no such value",
            Reject::NotSquarefree => "a polynomial has a root more than once",
            Reject::RootAtEnd => "an interval ends at a root",
            Reject::NotIsolated(_) => "an interval does not hold one root alone",
            Reject::NoPartner => "a sine has a value without its cosine",
            Reject::NotPrivate => "a symbol that is left open needs a value",
            Reject::NoCourse => "nothing need move through the point as the premises ask",
            Reject::PremiseFalse(_) => "a premise is false at the point",
            Reject::OutsideDomain => "a value lies outside of its domain",
            Reject::GoalNotFalse => "the goal is not false at the point",
            Reject::DivisionByZero => "division by an expression that is always 0",
            Reject::NotAProduct(_) => "a term of a scaling relation is no product of powers",
            Reject::NotSetAside(_) => "a premise that is set aside may matter",
            Reject::NoRun(_) => "the index is not known to run through all whole numbers",
            Reject::NoRate(_) => "a fact may have no derivative",
            Reject::NotThroughout(_) => "a premise is not said of every index",
            Reject::OutOfRange(_) => "a premise is used where it is not said",
            Reject::Unmovable => "what is said cannot be said of another index",
            Reject::MayRun(_) => "a symbol may depend on the index",
            Reject::NoBase => "the induction has no base",
            Reject::MayEnd => "the sequence may not go on",
            Reject::NoFamily => "what is said cannot be said of a family",
            Reject::TooLarge => "the expression is too large to expand",
        })
    }
}

impl From<crate::algebra::TooLarge> for Reject {
    fn from(_: crate::algebra::TooLarge) -> Self {
        Reject::TooLarge
    }
}

impl From<crate::algebra::LowerError> for Reject {
    fn from(error: crate::algebra::LowerError) -> Self {
        match error {
            crate::algebra::LowerError::TooLarge => Reject::TooLarge,
            crate::algebra::LowerError::DivisionByZero => Reject::DivisionByZero,
        }
    }
}
