//! What would have to be supposed besides for a refuted claim to follow: a sign, an order of two quantities, or an
//! equation that stands elsewhere.

use super::mend::is_nought;
use super::{
    Consistency, Effort, assuming, consistency, defines_afresh, pose, prove_posed,
    prove_unconditionally, refute, refuted,
};
use crate::algebra::{Expr, Formula, Relation, Symbol, Values};
use crate::kernel::{Assignment, Claim, Obligation, Proven};
use crate::sorted;

/// Symbols of which a sign or an order is supposed.
const MOST_SYMBOLS: usize = 6;
/// How many suppositions are looked at in earnest, one by one and two by two.
const MOST_SINGLE: usize = 16;
const MOST_PAIRS: usize = 6;
/// How many choices a search for a further counterexample may try.
const CHOICES: usize = 60;

/// The fewest of the `elsewhere`, and of signs and orders of its symbols, with which a refuted claim follows: one,
/// or two. With the proof.
///
/// What would prove the goal by itself is not offered, nor what the premises rule out. Each must be false at every
/// counterexample that is met on the way. `evaluate` gives the values that a point has under a claim.
pub fn missing_suppositions(
    claim: &Claim,
    witness: &Assignment,
    elsewhere: &[Formula],
    hints: &[Assignment],
    evaluate: impl Fn(&Claim, &Assignment) -> Values,
) -> Option<(Vec<Formula>, Proven)> {
    let mut candidates: Vec<Formula> = elsewhere.to_vec();
    // A sign or an order gives no value to a symbol that no premise speaks of.
    if !defines_afresh(claim, &claim.goal) {
        candidates.extend(simple(claim));
    }
    missing_among(claim, witness, candidates, hints, evaluate)
}

/// The same among a few candidates.
pub fn missing_among(
    claim: &Claim,
    witness: &Assignment,
    mut candidates: Vec<Formula>,
    hints: &[Assignment],
    evaluate: impl Fn(&Claim, &Assignment) -> Values,
) -> Option<(Vec<Formula>, Proven)> {
    // With a symbolic number of elements a proof is too long a search for a guess.
    if !claim.sequences.is_empty() {
        return None;
    }
    let mut met = Met {
        claim,
        evaluate: &evaluate,
        points: vec![evaluate(claim, witness)],
    };
    candidates.retain(|c| *c != claim.goal);
    let mut tried = 0;
    let mut possible: Vec<Formula> = Vec::new();
    for candidate in candidates {
        let alone = std::slice::from_ref(&candidate);
        if met.rules_out(alone) {
            possible.push(candidate);
            continue;
        }
        if tried == MOST_SINGLE {
            break;
        }
        tried += 1;
        if proves_alone(claim, alone) {
            continue;
        }
        if let Some(found) = met.settle(alone, hints) {
            return Some(found);
        }
        possible.push(candidate);
    }
    // Two that are strict say most; what they prove can be weakened by whoever reads it.
    let strict = |formula: &Formula| {
        matches!(
            formula,
            Formula::Relation {
                relation: Relation::Greater,
                ..
            }
        )
    };
    sorted::sort_by_key(&mut possible, |formula| !strict(formula));
    let mut tried = 0;
    for (at, one) in possible.iter().enumerate() {
        for other in &possible[at + 1..] {
            let both = [one.clone(), other.clone()];
            if met.rules_out(&both) {
                continue;
            }
            if tried == MOST_PAIRS {
                return None;
            }
            tried += 1;
            if !proves_alone(claim, &both)
                && let Some(found) = met.settle(&both, hints)
            {
                return Some(found);
            }
        }
    }
    None
}

/// A claim with the counterexamples to it that were met.
struct Met<'a, F> {
    claim: &'a Claim,
    evaluate: &'a F,
    points: Vec<Values>,
}

impl<F: Fn(&Claim, &Assignment) -> Values> Met<'_, F> {
    /// Whether all of the suppositions are true at a counterexample.
    fn rules_out(&self, supposed: &[Formula]) -> bool {
        let holds = |point: &Values| supposed.iter().all(|f| point.holds(f) == Ok(true));
        self.points.iter().any(holds)
    }

    /// A proof under suppositions that the premises do not rule out, or one more counterexample.
    fn settle(
        &mut self,
        supposed: &[Formula],
        hints: &[Assignment],
    ) -> Option<(Vec<Formula>, Proven)> {
        let posed = pose(assuming(self.claim, supposed)).ok()?;
        let with = posed.claim();
        if let Some(point) = counterexample(&posed) {
            self.points.push((self.evaluate)(with, &point));
            return None;
        }
        let derived = prove_posed(&posed, effort_for(with))?;
        let possible = consistency(with, hints);
        matches!(possible, Consistency::Model(_)).then(|| (supposed.to_vec(), derived.proven))
    }
}

/// Signs of the symbols, those of the goal first, and orders between two of them, the weakest first.
fn simple(claim: &Claim) -> Vec<Formula> {
    let mut symbols: Vec<Symbol> = claim.goal.free_symbols().into_iter().collect();
    // A goal about one symbol can only lack what is said of those behind it.
    if symbols.len() < 2 {
        for hypothesis in &claim.hypotheses {
            for symbol in hypothesis.formula.free_symbols() {
                if !symbols.contains(&symbol) {
                    symbols.push(symbol);
                }
            }
        }
    }
    // Of what is 0 nothing is left to suppose.
    symbols.retain(|symbol| !claim.hypotheses.iter().any(|h| is_nought(h, symbol)));
    symbols.truncate(MOST_SYMBOLS);
    let relation = |left: Expr, relation: Relation, right: Expr| Formula::Relation {
        left,
        relation,
        right,
    };
    let mut all = Vec::new();
    for strict in [false, true] {
        let above = match strict {
            true => Relation::Greater,
            false => Relation::GreaterOrEqual,
        };
        let below = match strict {
            true => Relation::Less,
            false => Relation::LessOrEqual,
        };
        for symbol in &symbols {
            let own = || Expr::Symbol(symbol.clone());
            all.push(relation(own(), above, Expr::integer(0)));
        }
        for one in &symbols {
            for other in symbols.iter().filter(|other| *other != one) {
                let (one, other) = (one.clone(), other.clone());
                all.push(relation(Expr::Symbol(one), below, Expr::Symbol(other)));
            }
        }
    }
    all
}

/// Whether the goal follows from suppositions without any premise: then these are the goal in other words. A sign or an order is never
/// an equation in other words: `x > 0` is what `\sqrt{x^2} = x` lacks.
fn proves_alone(claim: &Claim, supposed: &[Formula]) -> bool {
    let equation = |formula: &Formula| formula.as_equation().is_some();
    if equation(&claim.goal) && !supposed.iter().any(equation) {
        return false;
    }
    let bare = Claim {
        hypotheses: Vec::new(),
        ..claim.clone()
    };
    let named = claim.goal.free_symbols();
    let speaks = |f: &Formula| f.free_symbols().iter().any(|s| named.contains(s));
    let effort = effort_for(claim);
    // What shares no symbol with the goal says nothing of it.
    supposed.iter().any(speaks)
        && prove_unconditionally(assuming(&bare, supposed), effort).is_some()
}

/// Inequalities are rarely seen at first sight.
fn effort_for(claim: &Claim) -> Effort {
    match claim.goal.as_equation() {
        Some(_) => Effort::Light,
        None => Effort::Full,
    }
}

fn counterexample(obligation: &Obligation) -> Option<Assignment> {
    let mut points = refute::Points::any(obligation);
    let found = points.next(CHOICES).into_iter();
    found
        .filter_map(|point| refuted(obligation, point))
        .map(|refuted| refuted.witness().clone())
        .next()
}
