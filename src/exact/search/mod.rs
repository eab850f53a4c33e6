//! The search: clever, and believed by nobody. What it finds goes to the kernel, which alone can make a verdict.
//!
//! [`decide`] tries, in order of cost: elimination of linear unknowns; a counterexample in small numbers;
//! Gröbner bases, sums of squares and products of inequalities; a counterexample in larger numbers; one in irrational
//! numbers.

mod algebraic;
mod attempt;
mod combined;
mod consistency;
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
mod opposite;
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
mod supposing;
mod tracked;
mod unfold;
mod units;
mod unknown;
mod unless;
mod values;
mod whole;

use crate::algebra::{Atom, Expr, Formula, Function, Symbol, effort};
use crate::kernel::{Assignment, Candidate, Checked, Claim, Domain, Obligation, Refuted, Reject};
use crate::sorted::Set;
pub use algebraic::without_rational_points;
use attempt::{Attempt, attempt_with, derived, prove};
pub use attempt::{
    Derived, divided_beside_roots, may_do_without, prove_by_degrees, prove_posed,
    prove_unconditionally,
};
use consistency::contradiction;
pub use consistency::{Consistency, consistency, consistency_posed, rests_on_contradiction};
pub use family::family;
pub use implied::{Implied, implied, value_in_constants};
pub use induction::{prove_for_every, refute_by_first_elements};
pub use mend::{Change, Edit, InChain, Mended, Slips, mended};
pub use missing::{missing_among, missing_suppositions};
pub use nought::without_powers_of_nought;
pub use prove::Effort;
pub use rates::prove_throughout;
pub use scaling::{
    Repair, ScalingDecision, decide_scaling, is_plainly_possible, is_scaling, kept_hypotheses,
    prove_scaling,
};
pub use still::{are_tied, is_pi, is_possible, makes_goal_vanish, still_in, with_constants};
pub use supposing::fewest;
use supposing::{assuming, defines_afresh, nowhere_put};
pub use unless::{Unless, missing_conditions};

/// Why something is left open of which nothing more is known.
pub const UNDECIDED: &str = "no proof and no counterexample was found";
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
        reason: UNDECIDED.into(),
        ..Stop::default()
    };
    // Elimination decides no inequality: there the proper search comes early.
    let quick = if obligation.claim().goal.is_inequality() {
        QUICK / 8
    } else {
        QUICK
    };
    let (mut known, mut prover) = (None, None);
    let mut points = None;
    let quick = most.map_or(quick, |most| quick.min(most));
    let earnest = most.map_or(EARNEST, |most| most - quick);
    for (effort, budget) in [(Effort::Light, quick), (Effort::Full, earnest)] {
        // Where a counterexample is known, only a simpler one is worth looking for.
        if known.is_none() {
            match prove(obligation, effort, &mut prover) {
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
            && let Some(decision) = effort::with_most(|| rates::decide(obligation))
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
    // Where no rational point was found there may be another.
    known
        .or_else(|| refuted_beyond(obligation, quick))
        .map(Decision::Refuted)
        .or_else(|| still::decide(obligation))
        .or_else(|| refuted_where_positive(obligation, quick).map(Decision::Refuted))
        .or_else(|| whole::first_refuted(obligation, quick).map(Decision::Refuted))
        .or_else(|| unknown::decide(obligation))
        .or_else(|| opposite::decide(obligation, hints))
        .unwrap_or(Decision::Open(stop))
}

/// A counterexample where no simple point was found: any other with rational numbers, one with powers of `e`, or an irrational one. Powers
/// of `e` are for what is said of slopes: a solution that only its differential equation gives follows from nothing else.
fn refuted_beyond(obligation: &Obligation, budget: usize) -> Option<Refuted> {
    let accepts = |point| refuted(obligation, point);
    let exponentials = || {
        let alone = obligation.claim().goal.speaks_of_slopes()
            && functions::speaks_of_exponentials_alone(obligation.as_written());
        let mut points = alone.then(|| refute::Points::of_exponentials(obligation))?;
        first(&mut points, budget, accepts)
    };
    let any = || first(&mut refute::Points::any(obligation), budget, accepts);
    let powers = || {
        let tied = functions::tied_exponents(obligation.claim(), obligation.as_written());
        let mut points = (!tied.is_empty()).then(|| refute::Points::of_powers(obligation))?;
        first(&mut points, budget, accepts)
    };
    any()
        .or_else(powers)
        .or_else(exponentials)
        .or_else(|| algebraic::first(obligation, true, accepts))
}

/// A counterexample at which what stands in logarithms is positive factor by factor: then these are known by themselves.
fn refuted_where_positive(obligation: &Obligation, budget: usize) -> Option<Refuted> {
    let mut inside = Set::new();
    for (_, atom) in obligation.as_written().atoms.iter() {
        if let Atom::Opaque(Expr::Call(Function::Ln, argument)) = atom
            && !matches!(**argument, Expr::Symbol(_))
        {
            inside.extend(argument.free_symbols());
        }
    }
    let claim = obligation.claim();
    let is_positive = |symbol: &Symbol| claim.domains.get(symbol).is_some_and(Domain::is_positive);
    let positive = |symbol: &Symbol| Formula::positive(Expr::Symbol(symbol.clone()));
    let unknown = inside.iter().filter(|symbol| !is_positive(symbol));
    let positive: Vec<Formula> = unknown.map(positive).collect();
    if positive.is_empty() {
        return None;
    }
    let posed = pose(assuming(claim, &positive)).ok()?;
    let mut points = refute::Points::new(&posed);
    let found = first(&mut points, budget, |point| refuted(&posed, point))?;
    obligation.refuted_by_fewer(&found).ok()?;
    Some(found)
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

fn refuted(obligation: &Obligation, point: Assignment) -> Option<Refuted> {
    match obligation.check(Candidate::Counterexample(point)) {
        Ok(Checked::Refuted(refuted)) => Some(refuted),
        _ => None,
    }
}

/// A counterexample to a claim at which the hypotheses of a `larger` one hold as well.
pub fn refute_in_context(obligation: &Obligation, larger: &Obligation) -> Option<Refuted> {
    let claim = obligation.claim();
    let mut points = refute::Points::new(larger);
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
        if let Some(course) = &mut point.course {
            let leads = std::mem::take(&mut course.leads).into_iter();
            course.leads = leads
                .filter_map(|(law, rate)| Some((position(&law)?, rate)))
                .collect();
        }
        unfolds.iter().find_map(|unfold| {
            point.unfold.clone_from(unfold);
            refuted(obligation, point.clone())
        })
    })
}
