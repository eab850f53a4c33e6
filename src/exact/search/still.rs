//! What the author differentiates nowhere is mostly meant not to change. That is nothing to prove with unseen: a claim that
//! follows so follows under a condition, and a counterexample at which it is so is a counterexample.

use super::course::{differentiated, moved, said_to_move};
use super::prove::Prover;
use super::refute::Points;
use super::unfold::definitions_to_unfold;
use super::{
    Decision, Derived, Effort, QUICK, assuming, contradiction, first, nowhere_put, pose,
    prove_by_degrees, rates, refuted, refuted_beyond,
};
use crate::algebra::{Atom, Expr, Formula, Polynomial, Rational, Symbol, element_parts, expr_of};
use crate::kernel::{
    Claim, Fact, Obligation, Origin, Problem, Refuted, Sign, Standing, applied_definition,
    definition, pi_is_the_number,
};
use crate::sorted::{Map, Set};

/// More quantities than this that might change are not looked at one by one.
const MOST_STILL: usize = 8;

/// Decides a claim in which symbols might change of which the author does not say so.
pub(super) fn decide(obligation: &Obligation) -> Option<Decision> {
    let still = held_still(obligation, obligation.problem());
    let claim = obligation.claim();
    let with = |still: &[Formula]| pose(assuming(claim, still)).ok();
    let proved = |still: &[Formula]| -> Option<Derived> { prove_by_degrees(&with(still)?) };
    if let Some((derived, conditions)) = fewest(still.clone(), proved) {
        // From what cannot be anything follows.
        return is_possible(claim, &conditions).then_some(Decision::Proven {
            derived,
            conditions,
        });
    }
    if still.len() > MOST_STILL {
        return None;
    }
    let found = refuted_where_still(obligation, &still);
    let found = found.or_else(|| refuted_along_laws(obligation, &still));
    found.map(Decision::Refuted)
}

/// A counterexample at which what might change does not.
fn refuted_where_still(obligation: &Obligation, still: &[Formula]) -> Option<Refuted> {
    if still.is_empty() {
        return None;
    }
    let claim = obligation.claim();
    let posed = pose(assuming(claim, still)).ok()?;
    let own = claim.hypotheses.len();
    let mut points = Points::new(&posed);
    let found = first(&mut points, QUICK, |mut point| {
        if let Some(course) = &mut point.course {
            course.leads.retain(|law, _| *law < own);
        }
        refuted(obligation, point)
    });
    found.or_else(|| refuted_where_constant(obligation))
}

/// A counterexample through which all moves as the laws ask once they are differentiated: `V dp/dV + p = 0` for `p V = c`.
///
/// Of what speaks of no slope the laws may well say more than is read here.
fn refuted_along_laws(obligation: &Obligation, still: &[Formula]) -> Option<Refuted> {
    let claim = obligation.claim();
    let is_slope = |part: &Expr| matches!(part, Expr::Derivative { .. });
    let mut goal = claim.goal.terms().into_iter();
    if !goal.any(|term| term.any(&is_slope)) {
        return None;
    }
    let posed = pose(assuming(claim, still)).ok()?;
    let with_rates =
        rates::with_rates(&posed).or_else(|| rates::with_rates_of_variables(&posed))?;
    let problem = with_rates.0;
    let slopes = problem.facts.iter().zip(&problem.origins);
    let slopes = slopes.filter(|(_, origin)| matches!(origin, Origin::Rate(_)));
    let slopes = slopes.map(|(fact, _)| {
        let slope = expr_of(&fact.polynomial, &problem.atoms);
        Formula::equal(slope, Expr::integer(0))
    });
    let slopes: Vec<Formula> = slopes.collect();
    let posed = pose(assuming(posed.claim(), &slopes)).ok()?;
    let mut points = Points::any(&posed);
    first(&mut points, QUICK, |point| {
        refuted(obligation, moved(obligation, &point)?)
    })
}

/// Whether the premises of a claim are not seen to contradict what is held still, nor to let it be so only where something vanishes:
/// where `C U` is constant, `U` is so for all `C` only if it is 0.
pub fn is_possible(claim: &Claim, still: &[Formula]) -> bool {
    if still.is_empty() {
        return true;
    }
    let held = assuming(claim, still);
    let unfold = definitions_to_unfold(&held);
    let premises = Obligation::of_premises(held.clone(), unfold);
    let named = nowhere_put(&held);
    premises.is_ok_and(|own| contradiction(&own).is_none())
        && !pose(held).is_ok_and(|posed| makes_vanish(&posed, named))
}

/// Whether it follows from the premises of a claim that something of which its goal speaks is 0, and none of them says so.
pub fn makes_goal_vanish(obligation: &Obligation) -> bool {
    let claim = obligation.claim();
    let mut named = nowhere_put(claim);
    let goal = claim.goal.free_symbols();
    named.retain(|symbol| goal.contains(symbol));
    !named.is_empty() && makes_vanish(obligation, named)
}

/// Whether it follows from the premises of a claim, and from how they change, that one of these is 0.
fn makes_vanish(posed: &Obligation, named: Vec<Symbol>) -> bool {
    let with_rates = rates::with_rates_of_variables(posed).or_else(|| rates::with_rates(posed));
    let with_rates = with_rates.map(|found| found.0);
    let problem = with_rates.as_ref().unwrap_or(posed.problem());
    let square = |symbol| {
        let var = problem.atoms.find(&Atom::Symbol(symbol))?;
        let own = Polynomial::var(var);
        own.times(&own).ok()
    };
    let mut squares = named.into_iter().filter_map(square);
    let one = Polynomial::constant(Rational::one());
    let product = squares.try_fold(one, |all, own| all.times(&own).ok());
    let (Some(polynomial), Ok(mut prover)) = (product, Prover::new(problem)) else {
        return false;
    };
    let sign = Sign::Zero;
    prover
        .prove(&Fact { polynomial, sign }, Effort::Light)
        .is_some()
}

/// A counterexample in which what is held still is constant: only then it is known what an integral is worth, or a slope of a slope.
fn refuted_where_constant(obligation: &Obligation) -> Option<Refuted> {
    let claim = obligation.claim();
    let said = Said::of(claim, obligation.unfold());
    let mut held = said.nothing_of_integrands();
    let slopes = said.nothing_of_slopes(obligation.problem());
    held.extend(
        slopes
            .iter()
            .filter_map(|slope| Some(differentiated(slope)?.0.clone())),
    );
    let posed = pose(held_in(claim, held)?).ok()?;
    let found = first(&mut Points::new(&posed), QUICK, |point| {
        refuted(&posed, point)
    });
    let found = found.or_else(|| refuted_beyond(&posed, QUICK))?;
    obligation.refuted_by_fewer(&found).ok()?;
    Some(found)
}

/// The claim with what stands in its integrands constant, where the author does not say that it moves; `None` where nothing
/// does. The hypotheses `unfold` are put in.
pub(super) fn held_constant(claim: &Claim, unfold: &[usize]) -> Option<Claim> {
    held_in(claim, Said::of(claim, unfold).nothing_of_integrands())
}

/// What a claim says of what moves.
struct Said<'a> {
    claim: &'a Claim,
    /// What holds throughout.
    laws: Vec<&'a Formula>,
    /// What is differentiated where the author writes it.
    moving: Set<Symbol>,
    /// The symbols for which hypotheses put in the terms that define them: how these move is said there.
    put_in: Map<Symbol, Expr>,
    /// The same of functions: what `v(r)` is.
    applied: Vec<(Expr, Expr)>,
}

impl<'a> Said<'a> {
    fn of(claim: &'a Claim, unfold: &[usize]) -> Self {
        let hypotheses = || unfold.iter().filter_map(|&at| claim.hypotheses.get(at));
        let defined = hypotheses().filter_map(|own| definition(&own.formula));
        let applied = hypotheses().filter_map(|own| applied_definition(&own.formula));
        let laws = claim.hypotheses.iter();
        let laws = laws.filter(|own| own.standing == Standing::Identity);
        Said {
            claim,
            laws: laws.map(|own| &*own.formula).collect(),
            moving: said_to_move(claim),
            put_in: defined.collect(),
            applied: applied.collect(),
        }
    }

    /// Whether nothing is said of how a symbol moves with a variable.
    fn nothing_of(&self, symbol: &Symbol, variable: &Symbol) -> bool {
        let moves = |other: &Symbol| self.moving.contains(other);
        let constant = |other: &Symbol| self.claim.is_constant(other);
        !moves(symbol)
            && !is_pi(symbol, self.claim)
            && !self.put_in.contains_key(symbol)
            && !are_tied(symbol, variable, &self.laws, moves, constant)
    }

    /// What stands in integrands besides the variable, with the variable, and is not said to move; of what terms are put in for, what
    /// stands in these.
    fn nothing_of_all_integrands(&self) -> Vec<(Symbol, Symbol)> {
        let mut all = Vec::new();
        for term in self.claim.formulas().flat_map(Formula::terms) {
            let mut take = |symbol: &Symbol, variable: &Symbol| {
                all.push((symbol.clone(), variable.clone()));
            };
            match &self.applied[..] {
                [] => in_integrals(term, &mut take),
                applied => {
                    let replaced = |term: Expr, (what, by): &(Expr, Expr)| term.replace(what, by);
                    let written_out = applied.iter().fold(term.clone(), replaced);
                    in_integrals(&written_out, &mut take);
                }
            }
        }
        let (mut seen, mut found) = (Set::new(), Vec::new());
        let mut next = 0;
        while let Some((symbol, variable)) = all.get(next).cloned() {
            next += 1;
            let own = (symbol, variable);
            if !seen.insert(own.clone()) {
                continue;
            }
            let (symbol, variable) = &own;
            if let Some(term) = self.put_in.get(symbol) {
                let inside = term.free_symbols().into_iter();
                let inside = inside.filter(|symbol| symbol != variable);
                all.extend(inside.map(|symbol| (symbol, variable.clone())));
            } else if !self.claim.is_constant(symbol) && self.nothing_of(symbol, variable) {
                found.push(own);
            }
        }
        found
    }

    /// The same without the variables.
    fn nothing_of_integrands(&self) -> Set<Symbol> {
        let all = self.nothing_of_all_integrands().into_iter();
        all.map(|own| own.0).collect()
    }

    /// The slopes, and slopes of slopes, of what is not said to move.
    fn nothing_of_slopes(&self, problem: &Problem) -> Vec<Expr> {
        let mut slopes = Vec::new();
        for (_, atom) in problem.atoms.iter() {
            let Atom::Opaque(slope @ Expr::Derivative { body, variable }) = atom else {
                continue;
            };
            let is_still = match &**body {
                // A sum over data, and not one that runs to the variable.
                body @ Expr::Series { .. } => {
                    let own = element_parts(variable).map(|parts| parts.0);
                    let mut moving = self.moving.iter().chain([variable]).chain(&own);
                    !moving.any(|symbol| body.mentions(symbol))
                }
                _ => differentiated(slope).is_some_and(|(symbol, _)| {
                    self.nothing_of(symbol, variable) && !is_velocity(symbol, problem)
                }),
            };
            if is_still {
                slopes.push(slope.clone());
            }
        }
        slopes
    }
}

/// Whether a dotted symbol is a slope by an unknown of the problem: it changes, if that is not said otherwise.
fn is_velocity(symbol: &Symbol, problem: &Problem) -> bool {
    let dotted = symbol.name().strip_prefix("\\dot{");
    let dotted = dotted.or_else(|| symbol.name().strip_prefix("\\ddot{"));
    let Some(dotted) = dotted else {
        return false;
    };
    // `\dot{x}_1` is one dot over `x_1`.
    let is_below = |name: &Symbol| {
        let mut ends = dotted.match_indices('}');
        ends.any(|(at, _)| {
            let scripts = name.name().strip_prefix(&dotted[..at]);
            scripts == Some(&dotted[at + 1..])
        })
    };
    let is_slope = |(_, atom): (_, &Atom)| match atom {
        Atom::Opaque(slope @ Expr::Derivative { .. }) => {
            differentiated(slope).is_some_and(|(own, _)| is_below(own))
        }
        _ => false,
    };
    problem.atoms.iter().any(is_slope)
}

/// Whether one of these laws ties a symbol to a variable, and none says which of all that it speaks of moves with it: `p V = c` ties `p` to
/// `V`, and `s = v t` not `v` to `t`, unless `s` is constant.
pub fn are_tied(
    symbol: &Symbol,
    variable: &Symbol,
    laws: &[&Formula],
    moves: impl Fn(&Symbol) -> bool,
    is_constant: impl Fn(&Symbol) -> bool,
) -> bool {
    let speaking = laws.iter().filter_map(|law| {
        let (left, right) = law.as_equation()?;
        let names = law.free_symbols();
        names.contains(variable).then_some((left, right, names))
    });
    let speaking: Vec<(&Expr, &Expr, Set<Symbol>)> = speaking.collect();
    let by_itself = |left: &Expr, own: &Symbol| alone(left) == Some(own);
    // What the links of `z = a = b` are equal to, be it only the last that speaks of the variable.
    let first_links = laws.iter().filter_map(|law| match law.as_equation()? {
        (Expr::Symbol(own), right) => {
            let silent = !law.free_symbols().contains(variable) && !is_constant(own);
            (silent && !matches!(right, Expr::Symbol(_) | Expr::Number(_))).then_some(right)
        }
        _ => None,
    });
    let mut explicit: Vec<&Expr> = first_links.collect();
    let says: Vec<bool> = speaking
        .iter()
        .map(|(left, right, _)| {
            let says = match left {
                // `x = a` names a place, and `y(t) = a t` says what depends on what.
                Expr::Symbol(own) => own == variable || !is_constant(own),
                // `T^2 = a^3` gives `T`.
                left if let Some(own) = alone(left) => !is_constant(own) && !right.mentions(own),
                left => matches!(left, Expr::Apply(..)) || explicit.contains(left),
            };
            if says && !by_itself(left, variable) {
                explicit.push(right);
            }
            says
        })
        .collect();
    let is_explicit = |own: &Symbol| {
        let mut lefts = speaking.iter().map(|law| law.0);
        lefts.any(|left| by_itself(left, own)) && !is_constant(own)
    };
    let moves = |own: &Symbol| own != variable && (moves(own) || is_explicit(own));
    speaking.iter().zip(says).any(|((left, _, names), says)| {
        let own = by_itself(left, symbol) && !is_constant(symbol);
        names.contains(symbol) && (own || !says && !names.iter().any(moves))
    })
}

/// The symbol of which a side is, or is a power.
fn alone(side: &Expr) -> Option<&Symbol> {
    match side {
        Expr::Symbol(symbol) => Some(symbol),
        Expr::Power(base, exponent) => match (&**base, &**exponent) {
            (Expr::Symbol(symbol), Expr::Number(_)) => Some(symbol),
            _ => None,
        },
        _ => None,
    }
}

/// The claim with further symbols constant. Most claims have none of these: nothing is copied for them.
fn held_in(claim: &Claim, held: Set<Symbol>) -> Option<Claim> {
    (!held.is_empty()).then(|| with_constants(claim.clone(), held))
}

/// A claim with further symbols that depend on no variable. The number π does so anyway, and is that number only where nobody declares it.
pub fn with_constants(mut claim: Claim, held: impl IntoIterator<Item = Symbol>) -> Claim {
    for symbol in held {
        if is_pi(&symbol, &claim) {
            continue;
        }
        claim.domains.entry(symbol).or_default().constant = true;
    }
    claim
}

/// Whether a symbol is the number π in a claim.
pub fn is_pi(symbol: &Symbol, claim: &Claim) -> bool {
    symbol.name() == "\\pi" && pi_is_the_number(claim)
}

/// A proof with as few of these held still as may be.
pub(super) fn fewest(
    still: Vec<Formula>,
    proved: impl Fn(&[Formula]) -> Option<Derived>,
) -> Option<(Derived, Vec<Formula>)> {
    if still.is_empty() || still.len() > MOST_STILL {
        return None;
    }
    super::fewest(still, proved)
}

/// What might change in a claim, of which the author does not say so, held still.
pub fn still_in(obligation: &Obligation) -> Vec<Formula> {
    let mut still = held_still(obligation, obligation.problem());
    still.truncate(MOST_STILL);
    still
}

/// That each derivative is 0 of what is differentiated nowhere, and might depend on what others are differentiated by. The problem
/// may be the obligation's with its laws differentiated.
pub(super) fn held_still(obligation: &Obligation, problem: &Problem) -> Vec<Formula> {
    let said = Said::of(obligation.claim(), obligation.unfold());
    let mut slopes = said.nothing_of_slopes(problem);
    for (symbol, variable) in said.nothing_of_all_integrands() {
        let slope = Expr::Symbol(symbol).differentiated_by(&variable);
        if !slopes.contains(&slope) {
            slopes.push(slope);
        }
    }
    let zero = |slope: Expr| Formula::equal(slope, Expr::integer(0));
    slopes.into_iter().map(zero).collect()
}

/// What stands in integrands besides the variable, with the variable.
fn in_integrals(term: &Expr, found: &mut impl FnMut(&Symbol, &Symbol)) {
    if let Expr::Integral { body, variable, .. } = term {
        let mut symbols = body.free_symbols();
        symbols.remove(variable);
        symbols.iter().for_each(|symbol| found(symbol, variable));
    }
    term.children().for_each(|child| in_integrals(child, found));
}
