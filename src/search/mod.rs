//! The search: clever, and believed by nobody. What it finds goes to the kernel, which alone can make a verdict.
//!
//! [`decide`] tries, in order of cost: elimination of linear unknowns; a counterexample in small numbers;
//! Gröbner bases, sums of squares and products of inequalities; a counterexample in larger numbers.

mod ideal;
mod point;
mod positivity;
mod prove;
mod refute;
mod scaling;
mod simplex;
mod tracked;
mod unfold;
mod units;
mod values;

use crate::algebra::{Atom, Expr, Formula, Relation, expr_of, factors};
use crate::kernel::{
    Assignment, Candidate, Certificate, Checked, Claim, Fact, Hypothesis, Model, Origin, Problem,
    Proof, Proven, Refuted, Reject, Sign, Standing, check, check_model,
};
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
        proven: Proven,
        /// What must not vanish (or not vary), and is nowhere said not to.
        conditions: Vec<Formula>,
    },
    /// It does not.
    Refuted(Refuted),
    /// Neither was found.
    Open(Stop),
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

/// Decides a claim, or says why not.
pub fn decide(claim: &Claim) -> Decision {
    let mut stop = Stop {
        reason: "no proof and no counterexample was found".into(),
        ..Stop::default()
    };
    let mut points: Option<refute::Points> = None;
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
    let unfold = unfold::definitions_to_unfold(claim);
    let problem = match Problem::new(claim, &unfold) {
        Ok(problem) => problem,
        Err(reject) => {
            stop.reason = reject.to_string();
            stop.hopeless = true;
            return Decision::Open(stop);
        }
    };
    for (effort, budget) in [(Effort::Light, quick), (Effort::Full, EARNEST)] {
        match prove_as(claim, &unfold, &problem, effort) {
            Ok(Some(decision)) => return decision,
            Ok(None) => {}
            Err(reject) => {
                stop.reason = reject.to_string();
                stop.hopeless = true;
                return Decision::Open(stop);
            }
        }
        let points = points.get_or_insert_with(|| refute::Points::new(claim, true));
        if let Some(refuted) = first(points, budget, |point| refuted(claim, point)) {
            return Decision::Refuted(refuted);
        }
        stop.tried = points.tried;
    }
    Decision::Open(stop)
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

/// A point at which all hypotheses hold, or a proof that there is none.
pub fn consistency(claim: &Claim) -> Consistency {
    let mut points = refute::Points::new(claim, false);
    for budget in [QUICK, EARNEST] {
        if let Some(model) = first(&mut points, budget, |p| check_model(claim, p).ok()) {
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
            if let Some(proven) = prove_unconditionally(&claim, Effort::Full) {
                return Consistency::Contradictory(proven.into());
            }
        }
    }
    Consistency::Unknown
}

/// What would have to be different from 0 for a refuted claim to follow, with the proof that it then does.
pub fn missing_conditions(claim: &Claim, witness: &Assignment) -> Option<(Vec<Formula>, Proven)> {
    let problem = Problem::new(claim, &unfold::definitions_to_unfold(claim)).ok()?;
    let prover = Prover::new(&problem).ok()?;
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
        refuted(&claim, witness.clone()).is_none()
    });
    if candidates.is_empty() {
        return None;
    }
    let with = |terms: &[Expr]| {
        let formulas: Vec<Formula> = terms.iter().cloned().map(Formula::nonzero).collect();
        match prove(&assuming(claim, &formulas), Effort::Light) {
            Ok(Some(Decision::Proven {
                proven,
                mut conditions,
            })) => {
                conditions.splice(0..0, formulas);
                // What the premises rule out would prove anything.
                let possible = consistency(&assuming(claim, &conditions));
                matches!(possible, Consistency::Model(_)).then_some((conditions, proven))
            }
            _ => None,
        }
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
            formula: formula.clone(),
            standing: Standing::Identity,
        }));
    claim
}

fn refuted(claim: &Claim, point: Assignment) -> Option<Refuted> {
    match check(claim.clone(), Candidate::Counterexample(point)) {
        Ok(Checked::Refuted(refuted)) => Some(refuted),
        _ => None,
    }
}

/// A proof of the claim, or of the claim under conditions that are nowhere stated.
///
/// # Errors
/// The kernel cannot even say what the claim means in polynomials.
fn prove(claim: &Claim, effort: Effort) -> Result<Option<Decision>, Reject> {
    let unfold = unfold::definitions_to_unfold(claim);
    let problem = Problem::new(claim, &unfold)?;
    prove_as(claim, &unfold, &problem, effort)
}

/// The same where the problem is at hand.
fn prove_as(
    claim: &Claim,
    unfold: &[usize],
    problem: &Problem,
    effort: Effort,
) -> Result<Option<Decision>, Reject> {
    match attempt(unfold, problem, effort)? {
        Attempt::Nothing => Ok(None),
        Attempt::Proof(candidate) => Ok(proven(claim.clone(), candidate, Vec::new())),
        Attempt::Needs(conditions) => {
            let claim = assuming(claim, &conditions);
            let problem = Problem::new(&claim, unfold)?;
            match attempt(unfold, &problem, effort)? {
                Attempt::Proof(candidate) => Ok(proven(claim, candidate, conditions)),
                _ => Ok(None),
            }
        }
    }
}

fn proven(claim: Claim, certificate: Certificate, conditions: Vec<Formula>) -> Option<Decision> {
    match check(claim, Candidate::Proof(certificate)) {
        Ok(Checked::Proven(proven)) => Some(Decision::Proven { proven, conditions }),
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

fn attempt(unfold: &[usize], problem: &Problem, effort: Effort) -> Result<Attempt, Reject> {
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
        unfold: unfold.to_vec(),
        lemmas: prover.into_lemmas(),
        conclusion,
    }))
}

/// A proof without further conditions, if one is found.
pub fn prove_unconditionally(claim: &Claim, effort: Effort) -> Option<Proven> {
    match prove(claim, effort) {
        Ok(Some(Decision::Proven { proven, conditions })) => {
            conditions.is_empty().then_some(proven)
        }
        _ => None,
    }
}

/// The hypotheses that a certificate combines, by position. Those that only say that something does not
/// vanish are not among them.
pub fn combined_hypotheses(proven: &Proven) -> BTreeSet<usize> {
    let certificate = proven.certificate();
    let mut used: BTreeSet<usize> = certificate.unfold.iter().copied().collect();
    let Ok(problem) = Problem::new(proven.claim(), &certificate.unfold) else {
        return used;
    };
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
pub fn refute_in_context(claim: &Claim, larger: &Claim) -> Option<Refuted> {
    let mut points = refute::Points::new(larger, true);
    first(&mut points, IN_CONTEXT, |mut point| {
        // The larger claim numbers its hypotheses differently; the same symbols are put in.
        check_model(larger, point.clone()).ok()?;
        point.unfold = unfold::definitions_to_unfold(claim);
        refuted(claim, point)
    })
}
