//! Whether premises can be true together: a point, or a proof of something impossible.

use super::attempt::{compared, prove_unconditionally};
use super::prove::Prover;
use super::{EARNEST, Effort, QUICK, algebraic, first, refute, still, unfold};
use crate::algebra::{Expr, Polynomial, Rational, Relation};
use crate::kernel::{Assignment, Claim, Fact, Model, Obligation, Problem, Proven, Sign};

/// Whether premises can be true together.
#[derive(Clone, Debug)]
pub enum Consistency {
    /// They are, here.
    Model(Model),
    /// They cannot be.
    Contradictory(Box<Proven>),
    /// Neither was found.
    Unknown,
}

/// A point at which all hypotheses hold, or a proof that there is none. `hints` are points to start from.
pub fn consistency(claim: &Claim, hints: &[Assignment]) -> Consistency {
    let of = |claim: &Claim, unfold: Vec<usize>| {
        let read = |unfold| Obligation::of_premises(claim.clone(), unfold);
        let is_plain = unfold.is_empty();
        let premises = match read(unfold) {
            // What makes no sense with a value put in may be impossible with it.
            Err(_) if !is_plain => read(Vec::new()),
            premises => premises,
        };
        premises.map_or(Consistency::Unknown, |own| consistency_posed(&own, hints))
    };
    let unfold = unfold::definitions_to_unfold(claim);
    // What is true together where more is constant is true together.
    let held = still::held_constant(claim, &unfold);
    let held = held.map(|constant| of(&constant, unfold::definitions_to_unfold(&constant)));
    match held {
        Some(model @ Consistency::Model(_)) => model,
        _ => of(claim, unfold),
    }
}

/// The same for a claim that was read before; its goal is left alone.
pub fn consistency_posed(premises: &Obligation, hints: &[Assignment]) -> Consistency {
    let mut points = refute::Points::of_premises(premises);
    if let Some(model) = points.near(hints).find_map(|p| premises.model(p).ok()) {
        return Consistency::Model(model);
    }
    if let Some(model) = first(&mut points, QUICK, |p| premises.model(p).ok()) {
        return Consistency::Model(model);
    }
    if let Some(proven) = contradiction(premises) {
        return Consistency::Contradictory(proven.into());
    }
    first(&mut points, EARNEST, |p| premises.model(p).ok())
        .or_else(|| algebraic::first(premises, false, |p| premises.model(p).ok()))
        .map_or(Consistency::Unknown, Consistency::Model)
}

/// A proof of something impossible from the premises of a claim.
pub(super) fn contradiction(premises: &Obligation) -> Option<Proven> {
    let impossible = [
        (1, Relation::Equal, Sign::Zero),
        (-1, Relation::GreaterOrEqual, Sign::NonNegative),
        (0, Relation::Greater, Sign::Positive),
    ];
    // These say nothing of any symbol, so one reading of the premises shows which of them can be proved.
    let mut prover = Prover::new(premises.problem()).ok()?;
    impossible.into_iter().find_map(|(number, relation, sign)| {
        let polynomial = Polynomial::constant(Rational::from(number));
        prover.prove(&Fact { polynomial, sign }, Effort::Full)?;
        let claim = Claim {
            goal: compared(Expr::integer(number), relation),
            ..premises.claim().clone()
        };
        Some(prove_unconditionally(claim, Effort::Full)?.proven)
    })
}

/// Whether what a proof rests on cannot all be true as the proof reads it, with what it puts in and differentiates: anything would follow.
pub fn rests_on_contradiction(proven: &Proven) -> bool {
    let certificate = proven.certificate();
    let problem = Problem::new(proven.claim(), &certificate.unfold);
    let problem = problem.and_then(|problem| problem.with_rates(&certificate.rates));
    problem.is_ok_and(|problem| is_impossible(&problem))
}

/// Whether `1 = 0` follows from the facts of a problem.
pub(super) fn is_impossible(problem: &Problem) -> bool {
    let impossible = Fact {
        polynomial: Polynomial::constant(Rational::one()),
        sign: Sign::Zero,
    };
    let prover = Prover::new(problem);
    prover.is_ok_and(|mut prover| prover.prove(&impossible, Effort::Full).is_some())
}
