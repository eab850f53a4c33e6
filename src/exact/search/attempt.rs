//! One attempt at a proof: a certificate, or what it would need besides; and what is made of a certificate.

use super::combined::combined_hypotheses;
use super::prove::Prover;
use super::radical::base_of_power;
use super::{Effort, assuming, pose, rates};
use crate::algebra::{Atom, Atoms, Expr, Formula, Monomial, Polynomial, Relation, effort, expr_of};
use crate::kernel::{
    Candidate, Certificate, Checked, Claim, Fact, Knowledge, Obligation, Origin, Problem, Proof,
    Proven, Reject, Sign,
};
use crate::sorted::Set;

/// So much work is done for one attempt, as [`effort`] counts it: hardly a proof takes a tenth of it.
const MOST_WORK: u64 = 200_000;
/// How often conditions may show what else must be so.
const MOST_ROUNDS: usize = 3;

/// A proof, and what it makes use of.
#[derive(Clone, Debug)]
pub struct Derived {
    /// The kernel's word.
    pub proven: Proven,
    /// The hypotheses that the certificate combines, by position. Those that only say that something does
    /// not vanish are not among them.
    pub combined: Set<usize>,
}

/// A proof of the claim, or of the claim under conditions that are nowhere stated. The prover is kept for who tries again with more effort.
///
/// # Errors
/// The kernel cannot even say what the claim means in polynomials.
pub(super) fn prove(
    obligation: &Obligation,
    effort: Effort,
    prover: &mut Option<Prover>,
) -> Result<Option<(Derived, Vec<Formula>)>, Reject> {
    let mut conditions: Vec<Formula> = Vec::new();
    let mut under = None;
    for _ in 0..MOST_ROUNDS {
        let attempted = match &under {
            None => attempt_by(prover, obligation, effort),
            Some(posed) => attempt(posed, effort),
        };
        let posed = under.as_ref().unwrap_or(obligation);
        let mut needs = match attempted? {
            Attempt::Proof(certificate) => {
                // Its lemmas are in the certificate.
                *prover = None;
                return Ok(derived(posed, certificate).map(|derived| (derived, conditions)));
            }
            Attempt::Needs(needs) => needs,
            Attempt::Nothing if effort == Effort::Full => divided_beside_roots(posed.problem()),
            Attempt::Nothing => Vec::new(),
        };
        needs.retain(|need| !conditions.contains(need));
        if needs.is_empty() {
            return Ok(None);
        }
        conditions.extend(needs);
        let claim = assuming(obligation.claim(), &conditions);
        under = Some(Obligation::new(claim, obligation.unfold().to_vec())?);
    }
    Ok(None)
}

pub(super) enum Attempt {
    Nothing,
    Proof(Certificate),
    Needs(Vec<Formula>),
}

fn attempt(obligation: &Obligation, effort: Effort) -> Result<Attempt, Reject> {
    attempt_by(&mut None, obligation, effort)
}

/// The same by a prover that has tried the obligation before, if there is one.
fn attempt_by(
    kept: &mut Option<Prover>,
    obligation: &Obligation,
    effort: Effort,
) -> Result<Attempt, Reject> {
    let problem = obligation.problem();
    if effort == Effort::Light && is_beyond_elimination(problem) {
        return Ok(Attempt::Nothing);
    }
    let attempt = || {
        let prover = match kept {
            Some(prover) => prover,
            None => kept.insert(Prover::new(problem)?),
        };
        Ok::<_, Reject>(attempt_with(prover, obligation, problem, effort))
    };
    let found = effort::with_at_most(MOST_WORK, attempt)?;
    if !matches!(found, Attempt::Nothing) || effort == Effort::Light {
        return Ok(found);
    }
    let from_rates = || rates::attempt(obligation).unwrap_or(Attempt::Nothing);
    Ok(effort::with_at_most(MOST_WORK, from_rates))
}

/// Whether elimination alone cannot show the goal: it shows no sign, and where no equation is known it leaves one as it is.
fn is_beyond_elimination(problem: &Problem) -> bool {
    let says = |fact: &Fact| fact.sign == Sign::Zero && !fact.polynomial.is_zero();
    match problem.goal.sign {
        Sign::Zero => says(&problem.goal) && !problem.facts.iter().any(says),
        Sign::NonZero => false,
        Sign::NonNegative | Sign::Positive => true,
    }
}

/// The goal proved from the facts of `problem`: those of the obligation, or more. What was not found with little effort may be looked for
/// with more by the same prover.
pub(super) fn attempt_with(
    prover: &mut Prover,
    obligation: &Obligation,
    problem: &Problem,
    effort: Effort,
) -> Attempt {
    let conditions = &problem.conditions;
    if !conditions.doubtful.is_empty() {
        return Attempt::Nothing;
    }
    if effort == Effort::Full && prover.learn_powers(problem).is_err() {
        return Attempt::Nothing;
    }
    let conclusion = prover.prove(&problem.goal, effort);
    let Some(conclusion) = conclusion.or_else(|| in_logarithms(prover, problem, effort)) else {
        return Attempt::Nothing;
    };
    let mut needs = Vec::new();
    let nonzero = conditions.divisors().map(|p| (p, Sign::NonZero));
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
                let term = || expr_of(polynomial, &problem.atoms);
                needs.push(match sign {
                    Sign::NonNegative => compared(term(), Relation::GreaterOrEqual),
                    Sign::Positive => compared(term(), Relation::Greater),
                    _ => does_not_vanish(polynomial, &problem.atoms),
                });
            }
        }
    }
    for change in &problem.conditions.zero {
        if !problem.vanishes_throughout(change) {
            let term = expr_of(change, &problem.atoms);
            needs.push(Formula::equal(term, Expr::integer(0)));
        }
    }
    if !needs.is_empty() {
        return Attempt::Needs(needs);
    }
    Attempt::Proof(Certificate {
        unfold: obligation.unfold().to_vec(),
        rates: Vec::new(),
        lemmas: prover.take_lemmas(),
        conclusion,
    })
}

/// `x = y` where it is `\ln x = \ln y` that follows.
fn in_logarithms(prover: &mut Prover, problem: &Problem, effort: Effort) -> Option<Proof> {
    let (polynomial, sign) = (problem.goal_in_logarithms.clone()?, Sign::Zero);
    let proof = prover.prove(&Fact { polynomial, sign }, effort)?;
    Some(Proof::Logarithms(proof.into()))
}

/// Whether a claim can still be proved by elimination when one hypothesis says nothing; in doubt, it can.
pub fn may_do_without(obligation: &Obligation, hypothesis: usize) -> bool {
    let problem = obligation.problem();
    let silenced = |fact: usize| match problem.origins[fact] {
        Origin::Hypothesis(at) | Origin::Logarithms(at) => at == hypothesis,
        _ => false,
    };
    // What was put in is in every fact.
    obligation.unfold().contains(&hypothesis)
        || !is_beyond_elimination(problem)
            && !leaves_a_term(problem, silenced)
            && Prover::without(problem, silenced).is_ok_and(|mut prover| {
                let attempt = attempt_with(&mut prover, obligation, problem, Effort::Light);
                matches!(attempt, Attempt::Proof(_))
            })
}

/// Whether elimination leaves something of an equation where some facts say nothing: a product of unknowns of which no other equation
/// speaks.
fn leaves_a_term(problem: &Problem, silenced: impl Fn(usize) -> bool) -> bool {
    if problem.goal.sign != Sign::Zero || problem.goal_in_logarithms.is_some() {
        return false;
    }
    let goal = &problem.goal.polynomial;
    let mut alone = goal.vars();
    for (at, fact) in problem.facts.iter().enumerate() {
        if fact.sign == Sign::Zero && !silenced(at) {
            alone.retain(|var| !fact.polynomial.has(*var));
        }
    }
    let stays = |own: &Monomial| {
        let mut others = goal.terms().filter(|(other, _)| *other != own);
        let mut powers = own.powers().iter();
        powers.all(|(var, _)| alone.contains(var)) && others.all(|(other, _)| !own.divides(other))
    };
    !alone.is_empty() && goal.terms().any(|(own, _)| !own.is_one() && stays(own))
}

/// A proof without further conditions, if one is found.
pub fn prove_unconditionally(claim: Claim, effort: Effort) -> Option<Derived> {
    prove_posed(&pose(claim).ok()?, effort)
}

/// The same for a claim that was read before.
pub fn prove_posed(obligation: &Obligation, effort: Effort) -> Option<Derived> {
    match attempt(obligation, effort) {
        Ok(Attempt::Proof(certificate)) => derived(obligation, certificate),
        _ => None,
    }
}

/// The same, the easier way if that will do.
pub fn prove_by_degrees(obligation: &Obligation) -> Option<Derived> {
    let mut efforts = [Effort::Light, Effort::Full].into_iter();
    efforts.find_map(|effort| prove_posed(obligation, effort))
}

pub(super) fn derived(obligation: &Obligation, certificate: Certificate) -> Option<Derived> {
    let combined = match certificate.rates.is_empty() {
        true => combined_hypotheses(obligation.problem(), &certificate),
        false => {
            let problem = obligation.problem().with_rates(&certificate.rates).ok()?;
            combined_hypotheses(&problem, &certificate)
        }
    };
    match obligation.check(Candidate::Proof(certificate)) {
        Ok(Checked::Proven(proven)) => Some(Derived { proven, combined }),
        _ => None,
    }
}

/// What a goal with roots divides by, if it is not known not to vanish: before that is, nothing is known of the roots.
pub fn divided_beside_roots(problem: &Problem) -> Vec<Formula> {
    let vars = problem.goal.polynomial.vars();
    let mut atoms = vars.into_iter().map(|var| problem.atoms.atom(var));
    if !atoms.any(|atom| matches!(atom, Atom::Opaque(Expr::Power(..)))) {
        return Vec::new();
    }
    let knowledge = Knowledge::new(&problem.facts);
    let divisors = problem.conditions.nonzero.iter();
    let unknown = divisors.filter(|divisor| !knowledge.is_nonzero(divisor));
    unknown
        .map(|divisor| does_not_vanish(divisor, &problem.atoms))
        .collect()
}

/// `a - b ≠ 0`, and not `-b + a ≠ 0`; of a power, that what it is a power of does not vanish.
fn does_not_vanish(polynomial: &Polynomial, atoms: &Atoms) -> Formula {
    let polynomial = &base_of_power(polynomial);
    let term = expr_of(polynomial, atoms);
    Formula::nonzero(match &term {
        Expr::Sum(terms) if matches!(terms.first(), Some(Expr::Negate(_))) => {
            expr_of(&polynomial.negated(), atoms)
        }
        _ => term,
    })
}

pub(super) fn compared(term: Expr, relation: Relation) -> Formula {
    Formula::Relation {
        left: term,
        relation,
        right: Expr::integer(0),
    }
}
