//! The search: clever, and believed by nobody. What it finds goes to the kernel, which alone can make a verdict.
//!
//! [`decide`] tries, in order of cost: elimination of linear unknowns; a counterexample in small numbers;
//! Gröbner bases, sums of squares and products of inequalities; a counterexample in larger numbers.

mod ideal;
mod implied;
mod mend;
mod missing;
mod point;
mod positivity;
mod prove;
mod refute;
mod roots;
mod scaling;
mod simplex;
mod tracked;
mod unfold;
mod units;
mod values;

use crate::algebra::{Atom, Expr, Formula, Relation, expr_of, factors};
use crate::kernel::{
    Assignment, Candidate, Certificate, Checked, Claim, Fact, Hypothesis, Model, Obligation,
    Origin, Problem, Proof, Proven, Refuted, Reject, Sign, Standing, check,
};
pub use implied::{Implied, implied};
pub use mend::{Change, Mended, mended};
pub use missing::missing_suppositions;
pub use prove::Effort;
use prove::Prover;
pub use scaling::{
    Repair, ScalingDecision, decide_scaling, is_plainly_possible, is_scaling, kept_hypotheses,
    prove_scaling,
};
use std::collections::BTreeSet;

/// How many choices a search for a point may try, quickly and in earnest.
const QUICK: usize = 200;
const EARNEST: usize = 1_500;
const IN_CONTEXT: usize = 600;

/// What is known of a claim after the search.
#[derive(Clone, Debug)]
pub enum Decision {
    /// It follows; under `conditions` besides the claim's own hypotheses, where something had to be added.
    Proven {
        /// The kernel's word.
        derived: Derived,
        /// What must not vanish (or not vary), and is nowhere said not to.
        conditions: Vec<Formula>,
    },
    /// It does not.
    Refuted(Refuted),
    /// Neither was found.
    Open(Stop),
}

/// A proof, and what it makes use of.
#[derive(Clone, Debug)]
pub struct Derived {
    /// The kernel's word.
    pub proven: Proven,
    /// The hypotheses that the certificate combines, by position. Those that only say that something does
    /// not vanish are not among them.
    pub combined: BTreeSet<usize>,
}

/// Why a search ended without an answer.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Stop {
    /// In words.
    pub reason: String,
    /// How many points were tried.
    pub tried: usize,
    /// The goal itself is beyond what can be decided, whatever the premises.
    pub hopeless: bool,
}

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

/// Decides a claim, or says why not. `hints` are points at which premises like these are known to hold.
pub fn decide(claim: Claim, hints: &[Assignment]) -> Decision {
    let mut stop = Stop {
        reason: "no proof and no counterexample was found".into(),
        ..Stop::default()
    };
    // Elimination decides no inequality: there the proper search comes early.
    let inequality = matches!(
        claim.goal,
        Formula::Relation {
            relation: Relation::Less
                | Relation::LessOrEqual
                | Relation::Greater
                | Relation::GreaterOrEqual,
            ..
        }
    );
    let quick = if inequality { QUICK / 8 } else { QUICK };
    let hopeless = |reject: Reject, mut stop: Stop| {
        stop.reason = reject.to_string();
        stop.hopeless = true;
        Decision::Open(stop)
    };
    let obligation = match posed(claim) {
        Ok(obligation) => obligation,
        Err(reject) => return hopeless(reject, stop),
    };
    let mut points = refute::Points::new(&obligation);
    let mut known = None;
    for (effort, budget) in [(Effort::Light, quick), (Effort::Full, EARNEST)] {
        // Where a counterexample is known, only a simpler one is worth looking for.
        if known.is_none() {
            match prove(&obligation, effort) {
                Ok(Some((derived, conditions))) => {
                    return Decision::Proven {
                        derived,
                        conditions,
                    };
                }
                Ok(None) => {}
                Err(reject) => return hopeless(reject, stop),
            }
        }
        if effort == Effort::Light {
            known = points.near(hints).find_map(|p| refuted(&obligation, p));
        }
        if let Some(refuted) = first(&mut points, budget, |point| refuted(&obligation, point)) {
            return Decision::Refuted(refuted);
        }
        stop.tried = points.tried;
    }
    known.map_or(Decision::Open(stop), Decision::Refuted)
}

fn posed(claim: Claim) -> Result<Obligation, Reject> {
    let unfold = unfold::definitions_to_unfold(&claim);
    Obligation::new(claim, unfold)
}

/// The first point that the kernel accepts.
fn first<T>(
    points: &mut refute::Points,
    budget: usize,
    accepts: impl Fn(Assignment) -> Option<T>,
) -> Option<T> {
    let end = points.tried + budget;
    loop {
        let found = points.next(end.saturating_sub(points.tried));
        if found.is_empty() {
            return None;
        }
        if let Some(accepted) = found.into_iter().find_map(&accepts) {
            return Some(accepted);
        }
    }
}

/// A point at which all hypotheses hold, or a proof that there is none. `hints` are points to start from.
pub fn consistency(claim: &Claim, hints: &[Assignment]) -> Consistency {
    let unfold = unfold::definitions_to_unfold(claim);
    let Ok(premises) = Obligation::of_premises(claim.clone(), unfold) else {
        return Consistency::Unknown;
    };
    let mut points = refute::Points::of_premises(&premises);
    if let Some(model) = points.near(hints).find_map(|p| premises.model(p).ok()) {
        return Consistency::Model(model);
    }
    if let Some(model) = first(&mut points, QUICK, |p| premises.model(p).ok()) {
        return Consistency::Model(model);
    }
    let zero = || Expr::integer(0);
    let impossible = [
        Formula::equal(Expr::integer(1), zero()),
        compared(Expr::integer(-1), Relation::GreaterOrEqual),
        compared(zero(), Relation::Greater),
    ];
    for goal in impossible {
        let claim = Claim {
            goal,
            ..claim.clone()
        };
        if let Some(derived) = prove_unconditionally(claim, Effort::Full) {
            return Consistency::Contradictory(derived.proven.into());
        }
    }
    first(&mut points, EARNEST, |p| premises.model(p).ok())
        .map_or(Consistency::Unknown, Consistency::Model)
}

/// Whether premises like those of a claim hold near one of the `hints` where its goal does not, so that
/// no proof need be looked for.
pub fn is_doomed(claim: Claim, hints: &[Assignment]) -> bool {
    let Ok(obligation) = posed(claim) else {
        return false;
    };
    let points = refute::Points::new(&obligation);
    points
        .near(hints)
        .any(|point| refuted(&obligation, point).is_some())
}

/// What would have to be different from 0 for a refuted claim to follow, with the proof that it then does.
pub fn missing_conditions(
    claim: &Claim,
    witness: &Assignment,
    hints: &[Assignment],
) -> Option<(Vec<Formula>, Proven)> {
    let obligation = posed(claim.clone()).ok()?;
    let problem = obligation.problem();
    let prover = Prover::new(problem).ok()?;
    let mut candidates: Vec<Expr> = Vec::new();
    for fact in problem.facts.iter().filter(|f| f.sign == Sign::Zero) {
        for var in fact.polynomial.vars() {
            if fact.polynomial.degree_in(var) > 2 {
                continue;
            }
            let parts = fact.polynomial.in_powers_of(var);
            for factor in parts.last().map(factors).unwrap_or_default().into_keys() {
                let plain = factor
                    .vars()
                    .iter()
                    .all(|&v| !matches!(problem.atoms.atom(v), Atom::Opaque(_)));
                let term = expr_of(&factor, &problem.atoms);
                if plain && !prover.knows_nonzero(&factor) && !candidates.contains(&term) {
                    candidates.push(term);
                }
            }
        }
    }
    candidates.truncate(8);
    // What does not vanish at the counterexample would not rule it out.
    candidates.retain(|term| {
        let claim = assuming(claim, &[Formula::nonzero(term.clone())]);
        check(claim, Candidate::Counterexample(witness.clone())).is_err()
    });
    if candidates.is_empty() {
        return None;
    }
    let with = |terms: &[Expr]| {
        let formulas: Vec<Formula> = terms.iter().cloned().map(Formula::nonzero).collect();
        let obligation = posed(assuming(claim, &formulas)).ok()?;
        let (derived, mut conditions) = prove(&obligation, Effort::Light).ok()??;
        conditions.splice(0..0, formulas);
        // What the premises rule out would prove anything.
        let possible = consistency(&assuming(claim, &conditions), hints);
        matches!(possible, Consistency::Model(_)).then_some((conditions, derived.proven))
    };
    if let Some(found) = candidates
        .iter()
        .find_map(|c| with(std::slice::from_ref(c)))
    {
        return Some(found);
    }
    with(&candidates)?;
    // Leave out what is not needed.
    let mut at = 0;
    while at < candidates.len() {
        let mut fewer = candidates.clone();
        fewer.remove(at);
        match with(&fewer) {
            Some(_) => candidates = fewer,
            None => at += 1,
        }
    }
    with(&candidates)
}

fn assuming(claim: &Claim, formulas: &[Formula]) -> Claim {
    let mut claim = claim.clone();
    claim
        .hypotheses
        .extend(formulas.iter().map(|formula| Hypothesis {
            formula: formula.clone().into(),
            standing: Standing::Identity,
        }));
    claim
}

fn refuted(obligation: &Obligation, point: Assignment) -> Option<Refuted> {
    match obligation.check(Candidate::Counterexample(point)) {
        Ok(Checked::Refuted(refuted)) => Some(refuted),
        _ => None,
    }
}

/// A proof of the claim, or of the claim under conditions that are nowhere stated.
///
/// # Errors
/// The kernel cannot even say what the claim means in polynomials.
fn prove(
    obligation: &Obligation,
    effort: Effort,
) -> Result<Option<(Derived, Vec<Formula>)>, Reject> {
    match attempt(obligation, effort)? {
        Attempt::Nothing => Ok(None),
        Attempt::Proof(certificate) => {
            Ok(derived(obligation, certificate).map(|derived| (derived, Vec::new())))
        }
        Attempt::Needs(conditions) => {
            let claim = assuming(obligation.claim(), &conditions);
            let obligation = Obligation::new(claim, obligation.unfold().to_vec())?;
            match attempt(&obligation, effort)? {
                Attempt::Proof(certificate) => {
                    Ok(derived(&obligation, certificate).map(|derived| (derived, conditions)))
                }
                _ => Ok(None),
            }
        }
    }
}

fn derived(obligation: &Obligation, certificate: Certificate) -> Option<Derived> {
    let combined = combined_hypotheses(obligation.problem(), &certificate);
    match obligation.check(Candidate::Proof(certificate)) {
        Ok(Checked::Proven(proven)) => Some(Derived { proven, combined }),
        _ => None,
    }
}

fn compared(term: Expr, relation: Relation) -> Formula {
    Formula::Relation {
        left: term,
        relation,
        right: Expr::integer(0),
    }
}

enum Attempt {
    Nothing,
    Proof(Certificate),
    Needs(Vec<Formula>),
}

fn attempt(obligation: &Obligation, effort: Effort) -> Result<Attempt, Reject> {
    let problem = obligation.problem();
    let mut prover = Prover::new(problem)?;
    let Some(conclusion) = prover.prove(&problem.goal, effort) else {
        return Ok(Attempt::Nothing);
    };
    let mut needs = Vec::new();
    let conditions = &problem.conditions;
    let nonzero = conditions.nonzero.iter().map(|p| (p, Sign::NonZero));
    let nonnegative = conditions
        .nonnegative
        .iter()
        .map(|p| (p, Sign::NonNegative));
    let positive = conditions.positive.iter().map(|p| (p, Sign::Positive));
    for (polynomial, sign) in nonzero.chain(nonnegative).chain(positive) {
        if prover.knows(polynomial, sign) {
            continue;
        }
        let fact = Fact {
            polynomial: polynomial.clone(),
            sign,
        };
        match prover.prove(&fact, Effort::Full) {
            Some(proof) => {
                prover.add(fact, proof);
            }
            None => {
                let term = expr_of(polynomial, &problem.atoms);
                needs.push(match sign {
                    Sign::NonNegative => compared(term, Relation::GreaterOrEqual),
                    Sign::Positive => compared(term, Relation::Greater),
                    _ => Formula::nonzero(term),
                });
            }
        }
    }
    if !conditions.doubtful.is_empty() {
        return Ok(Attempt::Nothing);
    }
    for change in &problem.conditions.zero {
        if !problem.vanishes_throughout(change) {
            let term = expr_of(change, &problem.atoms);
            needs.push(Formula::equal(term, Expr::integer(0)));
        }
    }
    if !needs.is_empty() {
        return Ok(Attempt::Needs(needs));
    }
    Ok(Attempt::Proof(Certificate {
        unfold: obligation.unfold().to_vec(),
        lemmas: prover.into_lemmas(),
        conclusion,
    }))
}

/// A proof without further conditions, if one is found.
pub fn prove_unconditionally(claim: Claim, effort: Effort) -> Option<Derived> {
    match prove(&posed(claim).ok()?, effort) {
        Ok(Some((derived, conditions))) => conditions.is_empty().then_some(derived),
        _ => None,
    }
}

/// The hypotheses that a certificate combines, by position.
fn combined_hypotheses(problem: &Problem, certificate: &Certificate) -> BTreeSet<usize> {
    let mut used: BTreeSet<usize> = certificate.unfold.iter().copied().collect();
    let proofs = certificate
        .lemmas
        .iter()
        .map(|l| &l.proof)
        .chain([&certificate.conclusion]);
    let proofs: Vec<&Proof> = proofs.collect();
    // Only the lemmas that the conclusion reaches count.
    let mut wanted = vec![proofs.len() - 1];
    let mut seen = BTreeSet::new();
    while let Some(at) = wanted.pop() {
        if !seen.insert(at) {
            continue;
        }
        for fact in facts_of(proofs[at]) {
            match problem.origins.get(fact) {
                Some(Origin::Hypothesis(position)) => {
                    used.insert(*position);
                }
                Some(_) => {}
                None => wanted.push(fact - problem.facts.len()),
            }
        }
    }
    used
}

/// The facts that a proof names.
fn facts_of(proof: &Proof) -> Vec<usize> {
    let names = |cofactors: &[(usize, crate::algebra::Polynomial)]| -> Vec<usize> {
        cofactors.iter().map(|c| c.0).collect()
    };
    match proof {
        Proof::Combination { cofactors, .. } | Proof::NonVanishing { cofactors, .. } => {
            names(cofactors)
        }
        Proof::Positivity {
            terms, cofactors, ..
        } => {
            let mut all = names(cofactors);
            all.extend(terms.iter().flat_map(|t| t.facts.iter().copied()));
            all
        }
        Proof::BothBounds { below, above } => {
            let mut all = facts_of(below);
            all.extend(facts_of(above));
            all
        }
        Proof::Square(inner) => facts_of(inner),
    }
}

/// A counterexample to `claim` at which the hypotheses of `larger` hold as well.
pub fn refute_in_context(claim: &Claim, larger: Claim) -> Option<Refuted> {
    let larger = posed(larger).ok()?;
    let mut points = refute::Points::new(&larger);
    first(&mut points, IN_CONTEXT, |mut point| {
        // The larger claim numbers its hypotheses differently; the same symbols are put in.
        larger.model(point.clone()).ok()?;
        point.unfold = unfold::definitions_to_unfold(claim);
        match check(claim.clone(), Candidate::Counterexample(point)) {
            Ok(Checked::Refuted(refuted)) => Some(refuted),
            _ => None,
        }
    })
}
