//! The search: clever, and believed by nobody. What it finds goes to the kernel, which alone can make a verdict.
//!
//! [`decide`] tries, in order of cost: elimination of linear unknowns; a counterexample in small numbers;
//! Gröbner bases, sums of squares and products of inequalities; a counterexample in larger numbers; one in irrational
//! numbers.

mod algebraic;
mod course;
mod elements;
mod family;
mod functions;
mod ideal;
mod implied;
mod induction;
mod mend;
mod missing;
mod nought;
mod point;
mod positivity;
mod prove;
mod radical;
mod rates;
mod refute;
mod roots;
mod scaling;
mod simplex;
mod still;
mod tracked;
mod unfold;
mod units;
mod unknown;
mod values;

use crate::algebra::{
    Atom, Atoms, Expr, Formula, Polynomial, Rational, Relation, Symbol, expr_of, factors,
};
use crate::kernel::{
    Assignment, Candidate, Certificate, Checked, Claim, Fact, Hypothesis, Knowledge, Model,
    Obligation, Origin, Problem, Proof, Proven, Refuted, Reject, Sign, Standing, check,
};
use crate::sorted::{self, Set};
pub use algebraic::without_rational_points;
pub use family::family;
pub use implied::{Implied, implied, value_in_constants};
pub use induction::{prove_for_every, refute_by_first_elements};
pub use mend::{Change, InChain, Mended, mended};
pub use missing::{missing_among, missing_suppositions};
pub use nought::without_powers_of_nought;
pub use prove::Effort;
use prove::Prover;
use radical::base_of_power;
pub use rates::prove_throughout;
pub use scaling::{
    Repair, ScalingDecision, decide_scaling, is_plainly_possible, is_scaling, kept_hypotheses,
    prove_scaling,
};
pub use still::{are_tied, is_possible, still_in, with_constants};

/// How many choices a search for a point may try, quickly and in earnest.
const QUICK: usize = 200;
const EARNEST: usize = 1_500;
const IN_CONTEXT: usize = 600;
/// How often conditions may show what else must be so.
const MOST_ROUNDS: usize = 3;
/// So many divisors that might vanish are tried.
const MOST_DIVISORS: usize = 8;

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
    pub combined: Set<usize>,
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
    pose(claim).map_or_else(hopeless, |obligation| decide_posed(&obligation, hints))
}

/// What the kernel cannot even read.
pub fn hopeless(reject: Reject) -> Decision {
    Decision::Open(Stop {
        reason: reject.to_string(),
        tried: 0,
        hopeless: true,
    })
}

/// The same for a claim that was read before.
pub fn decide_posed(obligation: &Obligation, hints: &[Assignment]) -> Decision {
    decide_within(obligation, hints, None)
}

/// The same with at most so many choices of values tried for a counterexample. Proofs are looked for as always, so a
/// smaller number can leave undecided what is refuted with a larger one, and nothing else.
pub fn decide_within(
    obligation: &Obligation,
    hints: &[Assignment],
    most: Option<usize>,
) -> Decision {
    let mut stop = Stop {
        reason: "no proof and no counterexample was found".into(),
        ..Stop::default()
    };
    // Elimination decides no inequality: there the proper search comes early.
    let quick = if obligation.claim().goal.is_inequality() {
        QUICK / 8
    } else {
        QUICK
    };
    let mut known = None;
    let mut points = None;
    let quick = most.map_or(quick, |most| quick.min(most));
    let earnest = most.map_or(EARNEST, |most| most - quick);
    for (effort, budget) in [(Effort::Light, quick), (Effort::Full, earnest)] {
        // Where a counterexample is known, only a simpler one is worth looking for.
        if known.is_none() {
            match prove(obligation, effort) {
                Ok(Some((derived, conditions))) => {
                    return Decision::Proven {
                        derived,
                        conditions,
                    };
                }
                Ok(None) => {}
                Err(reject) => return hopeless(reject),
            }
        }
        if effort == Effort::Light
            && let Some(decision) = rates::decide(obligation)
        {
            return decision;
        }
        let points = points.get_or_insert_with(|| refute::Points::new(obligation));
        if effort == Effort::Light {
            known = points.near(hints).find_map(|p| refuted(obligation, p));
        }
        if let Some(refuted) = first(points, budget, |point| refuted(obligation, point)) {
            return Decision::Refuted(refuted);
        }
        stop.tried = points.tried;
    }
    // Where no rational point was found there may be an irrational one.
    let irrational = || algebraic::first(obligation, true, |point| refuted(obligation, point));
    known
        .or_else(irrational)
        .map(Decision::Refuted)
        .or_else(|| still::decide(obligation))
        .or_else(|| unknown::decide(obligation))
        .unwrap_or(Decision::Open(stop))
}

/// Reads a claim, with the definitions put in without which nothing can be computed.
///
/// # Errors
/// As [`Obligation::new`].
pub fn pose(claim: Claim) -> Result<Obligation, Reject> {
    let mut unfold = unfold::definitions_to_unfold(&claim);
    while !unfold.is_empty() {
        match Obligation::new(claim.clone(), unfold.clone()) {
            // What holds at one moment cannot be put in where something moves.
            Err(Reject::NotUnfoldable(stuck)) if unfold.contains(&stuck) => {
                unfold.retain(|&position| position != stuck);
            }
            posed => return posed,
        }
    }
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
    let of = |claim: &Claim, unfold: Vec<usize>| {
        let premises = Obligation::of_premises(claim.clone(), unfold);
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
fn contradiction(premises: &Obligation) -> Option<Proven> {
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

/// Whether premises like those of a claim hold near one of the `hints` where its goal does not, so that
/// no proof need be looked for.
pub fn is_doomed<'a>(
    obligation: &Obligation,
    hints: impl IntoIterator<Item = &'a Assignment>,
) -> bool {
    let points = refute::Points::new(obligation);
    points
        .near(hints)
        .any(|point| refuted(obligation, point).is_some())
}

/// Conditions under which a claim follows.
#[derive(Clone, Debug)]
pub struct Unless {
    /// What is divided out, and must not be 0.
    pub divided: Vec<Formula>,
    /// What must be so for the goal to be defined.
    pub own: Vec<Formula>,
}

impl Unless {
    /// All conditions, what is divided out first.
    pub fn conditions(self) -> Vec<Formula> {
        self.divided.into_iter().chain(self.own).collect()
    }
}

/// What would have to be different from 0 for a claim to follow; with it the proof goes through. Of a claim that was refuted, only
/// what vanishes at the witness is of interest.
pub fn missing_conditions(
    claim: &Claim,
    witness: Option<&Assignment>,
    effort: Effort,
    hints: &[Assignment],
) -> Option<Unless> {
    let obligation = pose(claim.clone()).ok()?;
    let problem = obligation.problem();
    let prover = Prover::new(problem).ok()?;
    let values = witness.map(|witness| refute::known_at(witness, &problem.atoms));
    let (mut candidates, mut others): (Vec<Expr>, Vec<Expr>) = (Vec::new(), Vec::new());
    for fact in problem.facts.iter().filter(|f| f.sign == Sign::Zero) {
        for var in fact.polynomial.vars() {
            if fact.polynomial.degree_in(var) > 2 {
                continue;
            }
            let parts = fact.polynomial.in_powers_of(var);
            for factor in parts.last().map(factors).unwrap_or_default().into_keys() {
                // What does not vanish at the counterexample would not rule it out by itself.
                let remains = |values: &Vec<Option<_>>| {
                    let there = factor.evaluate(|var| values.get(var.position())?.clone());
                    there.is_ok_and(|value| value.is_some_and(|value| !value.is_zero()))
                };
                let remains = values.as_ref().is_some_and(remains);
                let plain = factor
                    .vars()
                    .iter()
                    .all(|&v| !matches!(problem.atoms.atom(v), Atom::Opaque(_)));
                let term = expr_of(&factor, &problem.atoms);
                let found = match remains {
                    true => &mut others,
                    false => &mut candidates,
                };
                if plain && !prover.knows_nonzero(&factor) && !found.contains(&term) {
                    found.push(term);
                }
            }
        }
    }
    // What a product says that does not vanish, no factor of it may.
    if problem.goal.sign == Sign::NonZero {
        let factors = factors(&problem.goal.polynomial).into_keys();
        let terms = factors.map(|factor| expr_of(&factor, &problem.atoms));
        candidates.extend(terms.filter(|term| matches!(term, Expr::Symbol(_))));
    }
    // What speaks of one symbol is likelier meant than what ties several.
    sorted::sort_by_key(&mut candidates, |term| term.free_symbols().len());
    candidates.truncate(MOST_DIVISORS);
    // Where two factors are divided out, the counterexample has only one of them 0.
    others.retain(|term| term.free_symbols().len() == 1 && !candidates.contains(term));
    others.truncate(MOST_DIVISORS);
    // That a sum is not 0 may say no more than that a factor beside it is: `m a = m g` follows from anything where `a ≠ g`.
    let is_natural = |conditions: &[Formula]| {
        if conditions.iter().all(|c| c.free_symbols().len() < 2) {
            return true;
        }
        let others = nowhere_put(claim).into_iter();
        let others = others.map(|symbol| Formula::nonzero(Expr::Symbol(symbol)));
        let all: Vec<Formula> = conditions.iter().cloned().chain(others).collect();
        let possible = consistency(&assuming(claim, &all), hints);
        matches!(possible, Consistency::Model(_))
    };
    let proved =
        |formulas: &[Formula]| prove(&pose(assuming(claim, formulas)).ok()?, effort).ok()?;
    let with = |terms: &[Expr]| {
        let formulas: Vec<Formula> = terms.iter().cloned().map(Formula::nonzero).collect();
        let (_, own) = proved(&formulas)?;
        let conditions: Vec<Formula> = formulas.iter().chain(&own).cloned().collect();
        // What the premises rule out would prove anything.
        let possible = consistency(&assuming(claim, &conditions), hints);
        let possible = matches!(possible, Consistency::Model(_)) && is_natural(&formulas);
        possible.then_some(Unless {
            divided: formulas,
            own,
        })
    };
    if witness.is_none()
        && let Some(found) = with(&[])
    {
        return Some(found);
    }
    if candidates.is_empty() {
        return None;
    }
    // In earnest one by one only where all of them would do.
    if effort == Effort::Full {
        let all = candidates.iter().chain(&others);
        let all = all.cloned().map(Formula::nonzero);
        proved(&all.collect::<Vec<_>>())?;
    }
    if let Some(found) = candidates
        .iter()
        .find_map(|c| with(std::slice::from_ref(c)))
    {
        return Some(found);
    }
    if with(&candidates).is_none() {
        // What ties several symbols may be what another factor leaves 0: both together nothing allows.
        candidates.retain(|term| term.free_symbols().len() == 1);
        candidates.extend(others);
        with(&candidates)?;
    }
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

/// What is found under conditions, and those of them without which it is not; the last are left out first.
pub fn fewest<T>(
    mut conditions: Vec<Formula>,
    found: impl Fn(&[Formula]) -> Option<T>,
) -> Option<(T, Vec<Formula>)> {
    let mut least = found(&conditions)?;
    for at in (0..conditions.len()).rev() {
        let mut fewer = conditions.clone();
        fewer.remove(at);
        if let Some(own) = found(&fewer) {
            (conditions, least) = (fewer, own);
        }
    }
    Some((least, conditions))
}

/// Whether a formula gives a value to a symbol of which no hypothesis says anything: then it can only define it.
fn defines_afresh(claim: &Claim, formula: &Formula) -> bool {
    let unsaid = |symbol: &Symbol| {
        let mut all = claim.hypotheses.iter().flat_map(|h| h.formula.terms());
        !all.any(|term| term.mentions(symbol))
    };
    crate::kernel::definition(formula).is_some_and(|(symbol, _)| unsaid(&symbol))
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

/// The symbols of which a claim speaks and no hypothesis gives a number for a value.
fn nowhere_put(claim: &Claim) -> Vec<Symbol> {
    let is_put = |symbol: &Symbol| {
        let mut hypotheses = claim.hypotheses.iter();
        hypotheses.any(|own| own.formula.set_to_number() == Some(symbol))
    };
    let named = Formula::free_symbols_of(claim.formulas()).into_iter();
    named.filter(|symbol| !is_put(symbol)).cloned().collect()
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
    let mut conditions: Vec<Formula> = Vec::new();
    let mut under = None;
    for _ in 0..MOST_ROUNDS {
        let posed = under.as_ref().unwrap_or(obligation);
        let mut needs = match attempt(posed, effort)? {
            Attempt::Proof(certificate) => {
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

fn derived(obligation: &Obligation, certificate: Certificate) -> Option<Derived> {
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

/// Whether a claim can still be proved by elimination when one hypothesis says nothing; in doubt, it can.
pub fn may_do_without(obligation: &Obligation, hypothesis: usize) -> bool {
    let problem = obligation.problem();
    let silenced = |fact: usize| problem.origins[fact] == Origin::Hypothesis(hypothesis);
    // What was put in is in every fact.
    obligation.unfold().contains(&hypothesis)
        || Prover::without(problem, silenced).is_ok_and(|prover| {
            let attempt = attempt_with(prover, obligation, problem, Effort::Light);
            matches!(attempt, Attempt::Proof(_))
        })
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

fn attempt(obligation: &Obligation, effort: Effort) -> Result<Attempt, Reject> {
    let problem = obligation.problem();
    if effort == Effort::Light && has_nothing_to_eliminate(problem) {
        return Ok(Attempt::Nothing);
    }
    let found = attempt_with(Prover::new(problem)?, obligation, problem, effort);
    if !matches!(found, Attempt::Nothing) || effort == Effort::Light {
        return Ok(found);
    }
    Ok(rates::attempt(obligation).unwrap_or(Attempt::Nothing))
}

/// Whether an equation is to be shown and none is known: then elimination leaves it as it is.
fn has_nothing_to_eliminate(problem: &Problem) -> bool {
    let says = |fact: &Fact| fact.sign == Sign::Zero && !fact.polynomial.is_zero();
    says(&problem.goal) && !problem.facts.iter().any(says)
}

/// The goal proved from the facts of `problem`: those of the obligation, or more.
fn attempt_with(
    mut prover: Prover,
    obligation: &Obligation,
    problem: &Problem,
    effort: Effort,
) -> Attempt {
    if effort == Effort::Full && prover.learn_powers(problem).is_err() {
        return Attempt::Nothing;
    }
    let Some(conclusion) = prover.prove(&problem.goal, effort) else {
        return Attempt::Nothing;
    };
    let mut needs = Vec::new();
    let conditions = &problem.conditions;
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
    if !conditions.doubtful.is_empty() {
        return Attempt::Nothing;
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
        lemmas: prover.into_lemmas(),
        conclusion,
    })
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

/// The hypotheses that a certificate combines, by position.
fn combined_hypotheses(problem: &Problem, certificate: &Certificate) -> Set<usize> {
    let mut used: Set<usize> = certificate.unfold.iter().copied().collect();
    let proofs = certificate
        .lemmas
        .iter()
        .map(|l| &l.proof)
        .chain([&certificate.conclusion]);
    let proofs: Vec<&Proof> = proofs.collect();
    // Only the lemmas that the conclusion reaches count.
    let mut wanted = vec![proofs.len() - 1];
    let mut seen = Set::new();
    while let Some(at) = wanted.pop() {
        if !seen.insert(at) {
            continue;
        }
        for fact in facts_of(proofs[at]) {
            match problem.origins.get(fact) {
                Some(Origin::Hypothesis(position) | Origin::Rate(position)) => {
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
        Proof::Square(inner) | Proof::Larger { squares: inner, .. } => facts_of(inner),
        Proof::OfPower { base, .. } => vec![*base],
    }
}

/// A counterexample to `claim` at which the hypotheses of `larger` hold as well.
pub fn refute_in_context(claim: &Claim, larger: Claim) -> Option<Refuted> {
    let larger = pose(larger).ok()?;
    let mut points = refute::Points::new(&larger);
    // The larger claim numbers its hypotheses differently; what is put in there is put in here, too, if need be.
    let position = |own: &usize| {
        let formula = &larger.claim().hypotheses.get(*own)?.formula;
        claim.hypotheses.iter().position(|h| h.formula == *formula)
    };
    let put_in = larger.unfold().iter().filter_map(position).collect();
    let mut unfolds: Vec<Vec<usize>> = vec![unfold::definitions_to_unfold(claim), put_in];
    unfolds.dedup();
    first(&mut points, IN_CONTEXT, |mut point| {
        larger.model(point.clone()).ok()?;
        unfolds.iter().find_map(|unfold| {
            point.unfold.clone_from(unfold);
            match check(claim.clone(), Candidate::Counterexample(point.clone())) {
                Ok(Checked::Refuted(refuted)) => Some(refuted),
                _ => None,
            }
        })
    })
}
