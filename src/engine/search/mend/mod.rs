//! The nearest true formula to a false one: a slip of the pen undone.
//!
//! Of the formulas that are one small edit away ([`edits`]) most are false at the known counterexample, or at another
//! point on the premises; the few that are left go to the kernel.

mod edits;

use std::collections::BTreeSet;

use num_traits::Signed;

use crate::algebra::{BigRational, Expr, Formula, Relation, Symbol, Values};
use crate::kernel::{Assignment, Claim, Domain, Hypothesis, Obligation, Proven, Standing};

use super::{Effort, defines_afresh, prove_unconditionally, refute, unfold};
pub use edits::Change;
use edits::{Edit, edits};

/// How many edits that are true at every point are handed to the prover.
const MOST_TRIED: usize = 6;
/// How many of these are tried in earnest.
const IN_EARNEST: usize = 2;
/// How many bounds are: none of them is seen at first sight.
const BOUNDS_IN_EARNEST: usize = 4;
/// How many choices a search for a further point may try.
const CHOICES: usize = 120;
/// Symbols that are given a number of their own.
const MOST_PINNED: usize = 12;
/// Symbols that one may have been mistaken for.
const MOST_NAMES: usize = 16;

/// A formula one edit away from what is printed, that follows.
#[derive(Clone, Debug)]
pub struct Mended {
    /// The kernel's word for it.
    pub proven: Proven,
    /// What was changed.
    pub change: Change,
    /// The kernel's word for the next link of its chain, which begins with the right side, once that is changed.
    pub next: Option<Proven>,
}

/// What a refuted link of a chain has to do with its neighbours.
#[derive(Clone, Debug, Default)]
pub struct InChain {
    /// The left side is right, as far as the links beside it tell: only the right side is wrong.
    pub settled: bool,
    /// The link that goes on with the right side.
    pub next: Option<Formula>,
}

impl InChain {
    /// The next link after an edit of the right side.
    fn next_after(&self, edit: &Edit) -> Option<Formula> {
        let (Formula::Relation { right: changed, .. }, false) = (&edit.formula, edit.right_kept)
        else {
            return None;
        };
        match self.next.clone()? {
            Formula::Relation {
                relation, right, ..
            } => Some(Formula::Relation {
                left: changed.clone(),
                relation,
                right,
            }),
            Formula::AllEqual { .. } => None,
        }
    }
}

/// The likeliest slip of the pen in a refuted goal: one edit with which it follows from the claim's hypotheses.
///
/// `evaluate` gives the values that a point has under a claim; `hints` are points at which premises like these are known to hold. Nothing where no edit is good: what would follow from
/// no premises at all is none, unless what is printed is a piece of algebra.
///
/// In a chain an edit that leaves the next link true, or makes it so, goes before others.
pub fn mended(
    claim: &Claim,
    chain: &InChain,
    witness: &Assignment,
    hints: &[Assignment],
    evaluate: impl Fn(&Claim, &Assignment) -> Values,
) -> Option<Mended> {
    let names: Vec<Symbol> = claim.free_symbols().into_iter().cloned().collect();
    let names = &names[..names.len().min(MOST_NAMES)];
    let mut left = edits(&claim.goal, names, chain.settled);
    left.retain(|edit| !defines_afresh(claim, &edit.formula));
    if left.is_empty() {
        return None;
    }
    let mut points: Vec<Values> = Vec::new();
    let mut weigh = |values: &Values| {
        let printed = Printed::new(&claim.goal, values);
        left.retain(|edit| !printed.is_false(edit, values));
        if chain.next.is_some() {
            points.push(values.clone());
        }
        left.is_empty()
    };
    let there = evaluate(claim, witness);
    if weigh(&there) {
        return None;
    }
    for hint in hints.iter().filter(|hint| is_admissible(claim, hint)) {
        let values = evaluate(claim, hint);
        let mut premises = claim.hypotheses.iter();
        if premises.all(|h| values.holds(&h.formula) == Ok(true)) && weigh(&values) {
            return None;
        }
    }
    // What is proved at first sight, or not at all, is not worth a long search for points.
    let light = !claim.sequences.is_empty() && !claim.goal.is_inequality();
    let shifts = if light { 0 } else { 2 };
    for shift in 0..shifts {
        if let Some((pinned, point)) = generic(claim, shift)
            && weigh(&evaluate(&pinned, &point))
        {
            return None;
        }
    }
    // Of several bounds that hold the nearest true one is the tightest.
    if claim.goal.is_inequality() {
        let letters = |change: &Change| {
            matches!(
                change,
                Change::Symbol { .. } | Change::Factor | Change::Summand
            )
        };
        left.sort_by_cached_key(|edit| (letters(&edit.change), slack(edit, &there), edit.cost));
    }
    if chain.next.is_some() {
        // A symbol that a chain begins with is what it is about.
        let begins = matches!(claim.goal.as_equation(), Some((Expr::Symbol(_), _)));
        let breaks = |edit: &Edit| {
            let next = chain.next_after(edit);
            next.is_some_and(|next| points.iter().any(|p| p.holds(&next) == Ok(false)))
        };
        left.sort_by_cached_key(|edit| breaks(edit) || begins && !edit.left_kept);
    }
    left.truncate(MOST_TRIED);
    let with = |goal: &Formula| Claim {
        goal: goal.clone(),
        ..claim.clone()
    };
    // Sums with a symbolic number of terms are proved at first sight or after a long search.
    let in_earnest = match claim.goal.is_inequality() {
        true if claim.sequences.is_empty() => BOUNDS_IN_EARNEST,
        false if !claim.sequences.is_empty() => 0,
        _ => IN_EARNEST,
    };
    for (effort, most) in [(Effort::Light, MOST_TRIED), (Effort::Full, in_earnest)] {
        for edit in left.iter().take(most) {
            let Some(derived) = prove_unconditionally(with(&edit.formula), effort) else {
                continue;
            };
            if is_vacuous(claim, &edit.change, &edit.formula) {
                continue;
            }
            let next = chain.next_after(edit);
            let next = next.and_then(|next| prove_unconditionally(with(&next), Effort::Light));
            return Some(Mended {
                proven: derived.proven,
                change: edit.change.clone(),
                next: next.map(|derived| derived.proven),
            });
        }
    }
    None
}

/// Whether the symbols that a point gives a value lie where they may.
fn is_admissible(claim: &Claim, point: &Assignment) -> bool {
    let mut values = point.symbols.iter();
    values.all(|(symbol, value)| claim.domains.get(symbol).is_none_or(|d| d.contains(value)))
}

/// How far apart the sides of an edited inequality are at a point; nothing where only the relation was edited.
fn slack(edit: &Edit, values: &Values) -> Option<BigRational> {
    let Formula::Relation { left, right, .. } = &edit.formula else {
        return None;
    };
    if matches!(edit.change, Change::Strict | Change::Relation) {
        return None;
    }
    let (left, right) = (values.value(left).ok()?, values.value(right).ok()?);
    Some((left - right).abs())
}

/// The sides of a printed goal at a point, if they have values there.
struct Printed {
    left: Option<BigRational>,
    right: Option<BigRational>,
}

impl Printed {
    fn new(goal: &Formula, values: &Values) -> Printed {
        let (left, right) = match goal {
            Formula::Relation { left, right, .. } => (values.value(left), values.value(right)),
            Formula::AllEqual { .. } => {
                return Printed {
                    left: None,
                    right: None,
                };
            }
        };
        Printed {
            left: left.ok(),
            right: right.ok(),
        }
    }

    /// Whether an edited formula is false at the point. The side that is as printed is not worked out again.
    fn is_false(&self, edit: &Edit, values: &Values) -> bool {
        let Formula::Relation {
            left,
            relation,
            right,
        } = &edit.formula
        else {
            return true;
        };
        let value = |own: &Option<BigRational>, kept: bool, side: &Expr| match kept {
            true => own.clone(),
            false => values.value(side).ok(),
        };
        let (Some(left), Some(right)) = (
            value(&self.left, edit.left_kept, left),
            value(&self.right, edit.right_kept, right),
        ) else {
            return false;
        };
        let there = Formula::Relation {
            left: Expr::Number(left),
            relation: *relation,
            right: Expr::Number(right),
        };
        values.holds(&there) == Ok(false)
    }
}

/// Whether an edit only makes the formula say nothing, or nothing new: `v = v`, `x > -1`, a premise.
fn is_vacuous(claim: &Claim, change: &Change, formula: &Formula) -> bool {
    let Formula::Relation {
        left,
        relation,
        right,
    } = formula
    else {
        return true;
    };
    let turned = Formula::Relation {
        left: right.clone(),
        relation: *relation,
        right: left.clone(),
    };
    let says = |h: &Hypothesis| *h.formula == *formula || *h.formula == turned;
    if claim.hypotheses.iter().any(says) {
        return true;
    }
    let bare = Claim {
        hypotheses: Vec::new(),
        goal: formula.clone(),
        ..claim.clone()
    };
    // Bounds are rarely seen at first sight.
    let effort = match relation {
        Relation::Equal => Effort::Light,
        _ => Effort::Full,
    };
    if prove_unconditionally(bare, effort).is_none() {
        return false;
    }
    let bare = |side: &Expr| matches!(side, Expr::Symbol(_) | Expr::Number(_));
    // Algebra is put right by algebra; a statement about symbols is not. So are bounds that rest on nothing, and
    // those of which only the relation is wrong.
    let algebra = (*relation == Relation::Equal && !matches!(change, Change::Symbol { .. })
        || formula.is_inequality()
            && (claim.hypotheses.is_empty()
                || matches!(change, Change::Strict | Change::Relation)))
        && [&claim.goal, formula]
            .into_iter()
            .all(|formula| match formula {
                Formula::Relation {
                    left,
                    relation: Relation::Equal,
                    right,
                } => !bare(left) && !bare(right),
                Formula::Relation { left, right, .. } => !(bare(left) && bare(right)),
                Formula::AllEqual { .. } => false,
            });
    if !algebra || !formula.is_inequality() || matches!(change, Change::Strict | Change::Relation) {
        return !algebra;
    }
    // Of what rests on nothing only the best bound is worth a word: both sides can be equal.
    let mut reached = claim.clone();
    reached.hypotheses.push(Hypothesis {
        formula: Formula::equal(left.clone(), right.clone()).into(),
        standing: Standing::AtPoint,
    });
    model(&reached).is_none()
}

/// A point on the premises at which nothing is true by chance: the symbols on the right of the goal are different
/// primes, or their reciprocals, as far as the premises leave them free.
fn generic(claim: &Claim, shift: usize) -> Option<(Claim, Assignment)> {
    let (left, right) = match &claim.goal {
        Formula::Relation { left, right, .. } => (left, right),
        Formula::AllEqual { .. } => return None,
    };
    let mut symbols: BTreeSet<Symbol> = right.free_symbols();
    if symbols.is_empty() {
        symbols = left.free_symbols();
    }
    let mut pinned = claim.clone();
    for (at, symbol) in symbols.into_iter().enumerate().take(MOST_PINNED) {
        let value = chosen(claim, &symbol, at * (shift + 1) + shift);
        let Some(value) = value else { continue };
        pinned.hypotheses.push(Hypothesis {
            formula: Formula::equal(Expr::Symbol(symbol), Expr::Number(value)).into(),
            standing: Standing::AtPoint,
        });
        // What the premises tie together cannot be chosen freely.
        if model(&pinned).is_none() {
            pinned.hypotheses.pop();
        }
    }
    let mut point = model(&pinned)?;
    // Of what no premise speaks a model says nothing.
    for (at, symbol) in claim.goal.free_symbols().into_iter().enumerate() {
        let value = chosen(claim, &symbol, at + shift);
        if let Some(value) = value.filter(|_| !point.symbols.contains_key(&symbol)) {
            point.symbols.insert(symbol, value);
        }
    }
    Some((pinned, point))
}

/// A prime, its reciprocal or its negative, where the symbol's domain has it.
fn chosen(claim: &Claim, symbol: &Symbol, at: usize) -> Option<BigRational> {
    const PRIMES: [i64; 12] = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37];
    let whole = BigRational::from_integer(PRIMES[at % PRIMES.len()].into());
    let domain = claim.domains.get(symbol);
    let fits = |value: &BigRational| domain.is_none_or(|d: &Domain| d.contains(value));
    [whole.clone(), whole.recip(), -whole]
        .into_iter()
        .find(fits)
}

fn model(claim: &Claim) -> Option<Assignment> {
    let unfold = unfold::definitions_to_unfold(claim);
    let premises = Obligation::of_premises(claim.clone(), unfold).ok()?;
    let mut points = refute::Points::of_premises(&premises);
    let found = points.next(CHOICES).into_iter();
    found
        .map(|point| premises.model(point))
        .find_map(Result::ok)
        .map(|m| m.point().clone())
}
