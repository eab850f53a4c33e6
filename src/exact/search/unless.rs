//! What would have to be different from 0 for a claim to follow.

use super::prove::Prover;
use super::{Consistency, Effort, assuming, attempt, consistency, nowhere_put, pose, refute};
use crate::algebra::{Atom, Expr, Formula, expr_of, factors};
use crate::kernel::{Assignment, Fact, Obligation, Problem, Sign};
use crate::sorted;

/// So many divisors that might vanish are tried.
const MOST_DIVISORS: usize = 8;

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
    obligation: &Obligation,
    witness: Option<&Assignment>,
    effort: Effort,
    hints: &[Assignment],
) -> Option<Unless> {
    let (claim, problem) = (obligation.claim(), obligation.problem());
    let prover = Prover::new(problem).ok()?;
    let Divisors {
        mut candidates,
        others,
    } = Divisors::of(problem, &prover, witness);
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
    let proved = |formulas: &[Formula]| {
        attempt::prove(&pose(assuming(claim, formulas)).ok()?, effort, &mut None).ok()?
    };
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
    // One alone was tried.
    if candidates.len() == 1 || with(&candidates).is_none() {
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

/// What might be divided out.
struct Divisors {
    candidates: Vec<Expr>,
    /// What does not vanish at the counterexample would not rule it out by itself.
    others: Vec<Expr>,
}

impl Divisors {
    fn of(problem: &Problem, prover: &Prover, witness: Option<&Assignment>) -> Divisors {
        let values = witness.map(|witness| refute::known_at(witness, &problem.atoms));
        let equations = problem.facts.iter().filter(|f| f.sign == Sign::Zero);
        let leading = equations.flat_map(|Fact { polynomial, .. }| {
            let vars = polynomial.vars().into_iter();
            let vars = vars.filter(|&var| polynomial.degree_in(var) <= 2);
            vars.flat_map(|var| {
                let parts = polynomial.in_powers_of(var);
                parts.last().map(factors).unwrap_or_default().into_keys()
            })
        });
        let (mut candidates, mut others): (Vec<Expr>, Vec<Expr>) = (Vec::new(), Vec::new());
        for factor in leading {
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
        Divisors { candidates, others }
    }
}
