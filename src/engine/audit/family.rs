//! Counterexamples for every number at once: asked when a step that fails is shown, not in the audit.

use crate::algebra::{Expr, Formula, effort};
use crate::derivation::{Assumed, Derivation, Kind, Source, unconditional, values_at};
use crate::kernel::{FailsThroughout, Hypothesis, Refuted, Standing};
use crate::search;

use super::{Judged, Outcome};

/// How much exact arithmetic a family is worth, as [`effort`] counts it: some ten times what the report needs.
const MOST_WORK: u64 = 100_000;

/// A family of counterexamples to a step, at each of which everything else is true that is true at the one counterexample
/// and given before.
#[derive(Clone, Debug)]
pub struct Counterexamples {
    /// The kernel's word. The hypotheses of its claim are those of the step, then what is given besides.
    pub fails: FailsThroughout,
    /// The equations that give what is true besides, one for each hypothesis behind those of the step.
    pub besides: Vec<usize>,
}

/// The counterexamples for every number, where one to a link about a symbolic number of elements is known and they are
/// found.
pub fn counterexamples(
    derivation: &Derivation,
    at: usize,
    judged: &Judged,
) -> Option<Counterexamples> {
    let Outcome::Refuted(refuted) = &judged.outcome else {
        return None;
    };
    if refuted.witness().sequences.is_empty() {
        return None;
    }
    let given = true_besides(derivation, at, refuted);
    let hypotheses: Vec<Assumed> = given
        .iter()
        .map(|(equation, formula)| Assumed {
            formula: formula.clone().into(),
            standing: Standing::AtPoint,
            source: Source::Equation(*equation),
        })
        .collect();
    // The derivation knows in which domains the symbols are of which only these speak.
    let beside = derivation.claim(at, &hypotheses, &judged.goal.formula);
    let mut claim = refuted.claim().clone();
    for (symbol, domain) in beside.domains {
        claim.domains.entry(symbol).or_insert(domain);
    }
    for (sequence, domain) in beside.sequences {
        claim.sequences.entry(sequence).or_insert(domain);
    }
    let more = hypotheses.into_iter().map(|assumed| Hypothesis {
        formula: assumed.formula,
        standing: assumed.standing,
    });
    claim.hypotheses.extend(more);
    let fails = effort::within(MOST_WORK, || search::family(&claim, refuted.witness()))?;
    let besides = given.into_iter().map(|(equation, _)| equation);
    Some(Counterexamples {
        fails,
        besides: besides.collect(),
    })
}

/// What is given before an equation on its page and is true at its counterexample as well, though it was not judged
/// from that: each with the equation that gives it. No way leads from there to what fails either.
pub fn true_besides(
    derivation: &Derivation,
    own: usize,
    refuted: &Refuted,
) -> Vec<(usize, Formula)> {
    let there = values_at(refuted.claim(), refuted.witness());
    let hypotheses = &refuted.claim().hypotheses;
    let page = derivation.equations_of(derivation.equations[own].page);
    let mut all: Vec<(usize, Formula)> = Vec::new();
    for at in page.start..own.min(page.end) {
        let equation = &derivation.equations[at];
        if equation.kind != Kind::Given {
            continue;
        }
        for formula in equation.statements().iter().flat_map(unconditional) {
            let is_known = hypotheses.iter().any(|h| *h.formula == formula)
                || all.iter().any(|(_, other)| *other == formula);
            // What changes is not told by one value.
            let changes = formula.terms().into_iter().any(changes);
            if !is_known && !is_idle(&formula) && !changes && there.holds(&formula) == Ok(true) {
                all.push((at, formula));
            }
        }
    }
    all
}

/// Whether both sides are the same term, as those of `u_1 + \cdots + u_k = \sum u_i` are once they are read: that it is true
/// somewhere tells nothing.
pub fn is_idle(formula: &Formula) -> bool {
    matches!(formula, Formula::Relation { left, right, .. } if left == right)
}

/// Whether a derivative or a limit is taken in a term.
pub fn changes(term: &Expr) -> bool {
    term.any(&|part| matches!(part, Expr::Derivative { .. } | Expr::Limit { .. }))
}
