//! Laws differentiated: a law holds at all times, so its two sides change at the same rate.

use super::consistency::is_impossible;
use super::course::{self, said_to_move};
use super::prove::Prover;
use super::{
    Attempt, Decision, Derived, Effort, assuming, attempt_with, derived, pose, prove_posed, still,
};
use crate::algebra::{Atom, Expr, Formula, Polynomial, Symbol, expr_of, factors};
use crate::kernel::{Certificate, Claim, Fact, Knowledge, Obligation, Origin, Problem, Rate, Sign};
use crate::sorted::Set;

/// No more equations than this are differentiated, nor more often than this.
const MOST_RATES: usize = 8;
const MOST_TIMES: usize = 2;
/// More factors than this are not divided out.
const MOST_DIVISORS: usize = 3;

/// Decides what follows from laws that are differentiated, with what is differentiated nowhere held still if need be. Before points
/// are looked for: at them such things may move.
pub(super) fn decide(obligation: &Obligation) -> Option<Decision> {
    let held = |problem: &Problem| still::held_still(obligation, problem);
    let narrow = || {
        let (problem, _) = with_rates(obligation)?;
        decide_by(obligation, &with_rates, held(&problem))
    };
    let wide = || {
        let (problem, _) = with_rates_of_variables(obligation)?;
        let mut still = held(&problem);
        // What a goal does not speak of may well change with what it does: `I` with `R` in `P = I^2 R = a R`.
        let named = obligation.claim().goal.names();
        let is_named = |slope: &Expr| {
            course::differentiated(slope).is_some_and(|(own, _)| named.contains(own))
        };
        still.retain(|own| own.as_equation().is_some_and(|(slope, _)| is_named(slope)));
        decide_by(obligation, &with_rates_of_variables, still)
    };
    narrow().or_else(wide)
}

/// The problem of a claim with the slopes of some of its laws.
type WithRates<'a> = dyn Fn(&Obligation) -> Option<(Problem, Vec<Rate>)> + 'a;

fn decide_by(
    obligation: &Obligation,
    with_rates: &WithRates<'_>,
    still: Vec<Formula>,
) -> Option<Decision> {
    let claim = obligation.claim();
    let attempt = |obligation: &Obligation| attempt_from(obligation, with_rates(obligation)?);
    let found = |conditions: &[Formula]| attempt(&pose(assuming(claim, conditions)).ok()?);
    let (attempted, divided) = match found(&still) {
        Some(attempted) => (attempted, Vec::new()),
        None => {
            let divided = divisors_of_slopes(claim, &still, with_rates)?;
            let conditions: Vec<Formula> = still.iter().chain(&divided).cloned().collect();
            (found(&conditions)?, divided)
        }
    };
    let mut needs = match attempted {
        Attempt::Needs(needs) => needs,
        _ => Vec::new(),
    };
    needs.extend(divided);
    let proved = |still: &[Formula]| -> Option<Derived> {
        let conditions: Vec<Formula> = still.iter().chain(&needs).cloned().collect();
        let posed = pose(assuming(claim, &conditions)).ok()?;
        match attempt(&posed)? {
            Attempt::Proof(certificate) => derived(&posed, certificate),
            _ => None,
        }
    };
    let (derived, mut conditions) = match proved(&[]) {
        Some(derived) => (derived, Vec::new()),
        None => still::fewest(still, proved)?,
    };
    if !still::is_possible(claim, &conditions) {
        return None;
    }
    conditions.extend(needs);
    Some(Decision::Proven {
        derived,
        conditions,
    })
}

/// That what the slopes of a goal are multiplied with in a differentiated law does not vanish, `4 T^3 dT/dS = a`, where that is not known.
/// `None` where there is no such thing.
fn divisors_of_slopes(
    claim: &Claim,
    still: &[Formula],
    with_rates: &WithRates<'_>,
) -> Option<Vec<Formula>> {
    let posed = pose(assuming(claim, still)).ok()?;
    let (problem, _) = with_rates(&posed)?;
    let knowledge = Knowledge::new(&problem.facts);
    let is_plain = |own: &Polynomial| {
        let mut vars = own.vars().into_iter();
        vars.all(|var| matches!(problem.atoms.atom(var), Atom::Symbol(_)))
    };
    let mut found: Vec<Formula> = Vec::new();
    for slope in problem.goal.polynomial.vars() {
        if !matches!(
            problem.atoms.atom(slope),
            Atom::Opaque(Expr::Derivative { .. })
        ) {
            continue;
        }
        for (fact, origin) in problem.facts.iter().zip(&problem.origins) {
            let parts = fact.polynomial.in_powers_of(slope);
            let (Origin::Rate(_), [_, by]) = (origin, parts.as_slice()) else {
                continue;
            };
            let factors = factors(by).into_keys();
            let open = factors.filter(|own| is_plain(own) && !knowledge.is_nonzero(own));
            let open = open.map(|own| Formula::nonzero(expr_of(&own, &problem.atoms)));
            found.extend(open.filter(|own| !found.contains(own)).collect::<Vec<_>>());
        }
    }
    (1..=MOST_DIVISORS).contains(&found.len()).then_some(found)
}

/// A proof from laws that hold for every value of a variable of which the goal does not speak.
pub fn prove_throughout(claim: Claim, variable: &Symbol) -> Option<Derived> {
    let posed = pose(claim).ok()?;
    // An exponential may be divided out at any single value.
    if let Some(derived) = prove_posed(&posed, Effort::Light) {
        return Some(derived);
    }
    let one = || Set::from_iter([variable.clone()]);
    let found = differentiated(&posed, one(), |_| one())?;
    match attempt_from(&posed, found)? {
        Attempt::Proof(certificate) => derived(&posed, certificate),
        _ => None,
    }
}

/// A proof with the laws of a claim differentiated by the variables that it differentiates by, or what it needs besides.
pub(super) fn attempt(obligation: &Obligation) -> Option<Attempt> {
    let narrow = with_rates(obligation).and_then(|found| attempt_from(obligation, found));
    // That takes work: it is worth it for a slope, where something is constant that laws tie to what moves.
    let claim = obligation.claim();
    let slopes = |part: &Expr| matches!(part, Expr::Derivative { .. });
    let mut goal = claim.goal.terms().into_iter();
    let speaks = goal.any(|term| term.any(&slopes));
    let speaks = speaks && claim.domains.iter().any(|(_, domain)| domain.constant);
    narrow.or_else(|| {
        attempt_from(
            obligation,
            with_rates_of_variables(obligation).filter(|_| speaks)?,
        )
    })
}

fn attempt_from(
    obligation: &Obligation,
    (problem, rates): (Problem, Vec<Rate>),
) -> Option<Attempt> {
    let mut prover = Prover::new(&problem).ok()?;
    let mut proved = |effort| match attempt_with(&mut prover, obligation, &problem, effort) {
        Attempt::Nothing => None,
        found => Some(found),
    };
    let found = proved(Effort::Light).or_else(|| proved(Effort::Full))?;
    // What holds at one value of the variable alone, be it meant as a law or not, contradicts its own slope.
    if is_impossible(&problem) {
        return None;
    }
    Some(match found {
        Attempt::Proof(certificate) => Attempt::Proof(Certificate {
            rates,
            ..certificate
        }),
        found => found,
    })
}

/// The problem of a claim with the slopes of its laws, where there are such.
pub(super) fn with_rates(obligation: &Obligation) -> Option<(Problem, Vec<Rate>)> {
    let moving = said_to_move(obligation.claim());
    if moving.is_empty() {
        return None;
    }
    let claim = obligation.claim();
    // What moves may have been put in; where the goal speaks of it, that need not be differentiated.
    let named = claim.goal.free_symbols();
    let mut written = Set::new();
    if named.is_disjoint(&moving) {
        let terms = claim.formulas().flat_map(Formula::terms);
        terms.for_each(|term| term.collect_variables(&mut written));
    }
    differentiated(obligation, moving, |problem| {
        let mut all = variables(problem);
        all.extend(written.iter().cloned());
        all
    })
}

/// The same of the laws, too, that speak of what is differentiated by: `P = U I = a R`, and not of what moves.
pub(super) fn with_rates_of_variables(obligation: &Obligation) -> Option<(Problem, Vec<Rate>)> {
    let variables = variables(obligation.problem());
    let moving = said_to_move(obligation.claim());
    if moving.is_empty() || variables.is_subset(&moving) {
        return None;
    }
    let moving = moving.into_iter().chain(variables.iter().cloned());
    differentiated(obligation, moving.collect(), |_| variables.clone())
}

/// The same by these variables, of the laws that speak of what moves.
fn differentiated(
    obligation: &Obligation,
    moving: Set<Symbol>,
    variables: impl Fn(&Problem) -> Set<Symbol>,
) -> Option<(Problem, Vec<Rate>)> {
    let mut problem = obligation.problem().clone();
    let mut rates = Vec::new();
    let mut from = 0;
    for _ in 0..MOST_TIMES {
        let (end, variables) = (problem.facts.len(), variables(&problem));
        for fact in from..end {
            for variable in &variables {
                if rates.len() >= MOST_RATES || !is_law(obligation.claim(), &problem, fact, &moving)
                {
                    continue;
                }
                let rate = Rate {
                    fact,
                    variable: variable.clone(),
                };
                if let Ok(more) = problem.with_rates(std::slice::from_ref(&rate)) {
                    problem = more;
                    rates.push(rate);
                }
            }
        }
        from = end;
    }
    (!rates.is_empty()).then_some((problem, rates))
}

/// Whether a fact is an equation between what moves. What says where something stands still, or what value the variable has, is
/// mostly said of one moment.
fn is_law(claim: &Claim, problem: &Problem, fact: usize, moving: &Set<Symbol>) -> bool {
    let Fact { polynomial, sign } = &problem.facts[fact];
    let (Origin::Hypothesis(law) | Origin::Rate(law)) = problem.origins[fact] else {
        return false;
    };
    if *sign != Sign::Zero || polynomial.len() < 2 {
        return false;
    }
    // What moves may have been put in.
    let law = claim.hypotheses.get(law);
    if law.is_some_and(|law| !law.formula.free_symbols().is_disjoint(moving)) {
        return true;
    }
    let mut vars = polynomial.vars().into_iter();
    vars.any(|var| match problem.atoms.atom(var) {
        Atom::Symbol(symbol) | Atom::Root { of: symbol, .. } => moving.contains(symbol),
        Atom::Opaque(term) => moving.iter().any(|symbol| term.mentions(symbol)),
        _ => false,
    })
}

/// What is differentiated by.
fn variables(problem: &Problem) -> Set<Symbol> {
    let atoms = problem.atoms.iter();
    let found = atoms.filter_map(|(_, atom)| match atom {
        Atom::Opaque(Expr::Derivative { variable, .. }) => Some(variable.clone()),
        _ => None,
    });
    found.collect()
}
