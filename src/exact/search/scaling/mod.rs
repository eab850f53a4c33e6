//! Scaling relations: exact elimination on exponents.

mod linear;
mod situations;

use super::Stop;
use crate::algebra::{Expr, Formula, Rational, Relation};
use crate::kernel::{
    Alike, Claim, PosedScaling, Reject, Rows, Scales, ScalesNot, ScalingProof, Size,
};
use crate::sorted::Set;
use linear::{Echelon, Exponents, pairing};

/// What is known of a scaling relation after the search.
#[derive(Clone, Debug)]
pub enum ScalingDecision {
    /// It follows.
    Proven(Box<Scales>),
    /// It does not.
    Refuted {
        /// The kernel's word.
        refuted: Box<ScalesNot>,
        /// What follows instead.
        repair: Option<Box<Repair>>,
    },
    /// Neither was found.
    Open(Stop),
}

/// What the premises do say of the left side of a relation that does not follow from them.
#[derive(Clone, Debug)]
pub struct Repair {
    /// The relation, proved.
    pub proven: Scales,
    /// There are others, for the premises relate quantities on its right side to one another.
    pub one_of_many: bool,
}

/// Whether a relation is one of scaling.
pub fn is_scaling(formula: &Formula) -> bool {
    matches!(
        formula,
        Formula::Relation {
            relation: Relation::Scales | Relation::Proportional,
            ..
        }
    )
}

/// Decides a scaling relation, or says why not.
pub fn decide_scaling(claim: &Claim) -> ScalingDecision {
    let posed = match PosedScaling::new(claim.clone()) {
        Ok(posed) => posed,
        Err(reject) => return open(words(&reject), true),
    };
    let mut rows = posed.rows().clone();
    let known = Known::new(&mut rows, claim);
    let goal = rows.varying(&rows.goal);
    if let Some(proven) = known.prove(&posed, &goal) {
        return ScalingDecision::Proven(shortest(proven, &posed).into());
    }
    if let Some(refuted) = situations::refute(claim, &rows) {
        let repair = repair(claim, &rows, &known).map(Box::new);
        let refuted = refuted.into();
        return ScalingDecision::Refuted { refuted, repair };
    }
    open(undecided(claim, &rows, &known, &goal), false)
}

/// A proof of a scaling relation, if there is one.
pub fn prove_scaling(claim: &Claim) -> Option<Scales> {
    let posed = PosedScaling::new(claim.clone()).ok()?;
    Some(shortest(proved(&posed)?, &posed))
}

fn proved(posed: &PosedScaling) -> Option<Scales> {
    let mut rows = posed.rows().clone();
    let known = Known::new(&mut rows, posed.claim());
    let goal = rows.varying(&rows.goal);
    known.prove(posed, &goal)
}

/// Whether what the hypotheses say of products of powers is seen to be possible.
pub fn is_plainly_possible(claim: &Claim) -> bool {
    situations::is_possible(claim)
}

fn open(reason: String, hopeless: bool) -> ScalingDecision {
    ScalingDecision::Open(Stop {
        reason,
        tried: 0,
        hopeless,
    })
}

fn words(reject: &Reject) -> String {
    match reject {
        Reject::NotAProduct(_) => "a side is no product of powers".into(),
        other => other.to_string(),
    }
}

/// The rows of a claim, eliminated, with all sums and integrals whose parts are alike.
struct Known {
    echelon: Echelon,
    alike: Vec<Alike>,
}

impl Known {
    fn new(rows: &mut Rows, claim: &Claim) -> Known {
        let mut echelon = Echelon::new(preferred(rows, claim));
        let own: Vec<(usize, Exponents)> = rows
            .rows
            .iter()
            .enumerate()
            .filter_map(|(at, row)| Some((at, rows.varying(&row.as_ref()?.product))))
            .collect();
        for (number, row) in &own {
            echelon.insert(*number, row, &Size::one());
        }
        let mut known = Known {
            echelon,
            alike: Vec::new(),
        };
        let products = own.iter().map(|(_, row)| row);
        let goal = rows.varying(&rows.goal);
        let mut waiting: Set<Expr> = Set::new();
        for row in products.chain([&goal]) {
            let compound = |q: &&Expr| !matches!(q, Expr::Symbol(_) | Expr::Apply(..));
            waiting.extend(row.keys().filter(compound).cloned());
        }
        // Each may need another one first.
        let mut number = rows.rows.len();
        loop {
            let mut found = None;
            for term in &waiting {
                let Ok((parts, row)) = rows.compound(term) else {
                    continue;
                };
                let parts = parts.iter().map(|part| rows.varying(part));
                let combinations: Option<Vec<_>> =
                    parts.map(|part| known.echelon.combination(&part)).collect();
                if let Some(combinations) = combinations {
                    found = Some((term.clone(), combinations, rows.varying(&row.product)));
                    break;
                }
            }
            let Some((term, combinations, row)) = found else {
                return known;
            };
            waiting.remove(&term);
            known.echelon.insert(number, &row, &Size::one());
            known.alike.push(Alike { term, combinations });
            number += 1;
        }
    }

    fn prove(&self, posed: &PosedScaling, goal: &Exponents) -> Option<Scales> {
        let proof = ScalingProof {
            alike: self.alike.clone(),
            combination: self.echelon.combination(goal)?,
        };
        posed.check(proof).ok()
    }
}

/// The hypotheses that a proof combines, by position.
fn combined(proven: &Scales) -> Set<usize> {
    let proof = proven.proof();
    let inner = proof.alike.iter().flat_map(|a| a.combinations.iter());
    let all = inner.chain([&proof.combination]).flatten();
    let most = proven.claim().hypotheses.len();
    all.map(|(at, _)| *at).filter(|at| *at < most).collect()
}

/// The same from no more hypotheses than it combines, and without needless steps. `posed` is its claim.
fn shortest(proven: Scales, posed: &PosedScaling) -> Scales {
    let mut proof = proven.proof().clone();
    let first = proven.claim().hypotheses.len();
    let uses = |proof: &ScalingProof, number: usize| {
        let inner = proof.alike.iter().flat_map(|a| a.combinations.iter());
        let mut all = inner.chain([&proof.combination]).flatten();
        all.any(|(at, _)| *at == number)
    };
    // Steps are numbered after the rows of the claim; only the last can be dropped without renumbering.
    while let Some(last) = proof.alike.len().checked_sub(1) {
        if uses(&proof, posed.rows().rows.len() + last) {
            break;
        }
        proof.alike.pop();
    }
    let proven = match proof.alike.len() < proven.proof().alike.len() {
        true => posed.check(proof).unwrap_or(proven),
        false => proven,
    };
    let used = combined(&proven);
    if used.len() == first {
        return proven;
    }
    let mut claim = proven.claim().clone();
    let kept = claim.hypotheses.into_iter().enumerate();
    claim.hypotheses = kept
        .filter(|(at, _)| used.contains(at))
        .map(|(_, h)| h)
        .collect();
    let named = claim
        .free_symbols()
        .into_iter()
        .cloned()
        .collect::<Set<_>>();
    claim.domains.retain(|symbol, _| named.contains(symbol));
    let shorter = PosedScaling::new(claim).ok();
    let shorter = shorter.and_then(|posed| proved(&posed));
    shorter.unwrap_or(proven)
}

/// The hypotheses of a larger claim that a proof was left with, by position in it.
pub fn kept_hypotheses(larger: &Claim, proven: &Scales) -> Vec<usize> {
    let mut wanted = proven.claim().hypotheses.iter().peekable();
    let all = larger.hypotheses.iter().enumerate();
    let kept = all.filter(|(_, hypothesis)| wanted.next_if(|own| own == hypothesis).is_some());
    kept.map(|(at, _)| at).collect()
}

/// The order in which quantities are solved for: the left side of the goal, what stands alone on the left side of
/// a premise, the rest, and at last the right side of the goal, which had better be chosen freely; among these a
/// speed comes last, which a reader can imagine to be doubled.
fn preferred(rows: &Rows, claim: &Claim) -> Vec<Expr> {
    let left = rows.varying(&rows.sides.0);
    let right = rows.varying(&rows.sides.1);
    let mut all: Vec<Expr> = left
        .into_keys()
        .filter(|q| !right.contains_key(q))
        .collect();
    let mut add = |quantity: &Expr| {
        if !right.contains_key(quantity) && !all.contains(quantity) {
            all.push(quantity.clone());
        }
    };
    for hypothesis in &claim.hypotheses {
        if let Formula::Relation {
            left: lone @ (Expr::Symbol(_) | Expr::Apply(..)),
            ..
        } = &*hypothesis.formula
        {
            add(lone);
        }
    }
    for row in rows.rows.iter().flatten() {
        row.product.exponents.keys().for_each(&mut add);
    }
    let mut named: Vec<Expr> = match &claim.goal {
        Formula::Relation { right: term, .. } => in_order(term),
        Formula::AllEqual { .. } => Vec::new(),
    };
    named.retain(|q| right.contains_key(q));
    let missing: Vec<Expr> = right.into_keys().filter(|q| !named.contains(q)).collect();
    named.extend(missing);
    let is_speed =
        |q: &Expr| matches!(q, Expr::Symbol(s) if s.name().starts_with(['v', 'u', 'V', 'U']));
    let (speeds, others): (Vec<Expr>, Vec<Expr>) = named.into_iter().partition(is_speed);
    all.extend(others.into_iter().rev());
    all.extend(speeds.into_iter().rev());
    all
}

/// The quantities of a term as they are met from left to right.
fn in_order(term: &Expr) -> Vec<Expr> {
    let mut found = Vec::new();
    fn walk(term: &Expr, found: &mut Vec<Expr>) {
        if matches!(term, Expr::Symbol(_) | Expr::Apply(..)) {
            if !found.contains(term) {
                found.push(term.clone());
            }
            return;
        }
        term.children().for_each(|child| walk(child, found));
    }
    walk(term, &mut found);
    found
}

/// The left side of the goal by its right side's quantities, as far as the premises give it.
fn repair(claim: &Claim, rows: &Rows, known: &Known) -> Option<Repair> {
    let Formula::Relation {
        left,
        relation,
        right,
    } = &claim.goal
    else {
        return None;
    };
    let (rest, ..) = known.echelon.reduce(&rows.varying(&rows.sides.0));
    let own = rows.varying(&rows.sides.1);
    let related = own.keys().any(|q| known.echelon.is_pivot(q));
    let mut exponents = rest;
    if related {
        // Of many relations that follow, the one that differs least from what is written.
        let (goal, ..) = known.echelon.reduce(&rows.varying(&rows.goal));
        let change = own.keys().find_map(|q| {
            let unit = Exponents::from([(q.clone(), Rational::one())]);
            let (unit, ..) = known.echelon.reduce(&unit);
            let (first, slope) = unit.iter().next()?;
            let factor = goal.get(first)? / slope;
            let fits = goal.len() == unit.len()
                && unit
                    .iter()
                    .all(|(k, e)| goal.get(k) == Some(&(e * &factor)));
            fits.then(|| (q.clone(), factor))
        });
        if let Some((quantity, factor)) = change {
            exponents = own.clone();
            *exponents.entry(quantity).or_insert_with(Rational::zero) += factor;
            exponents.retain(|_, e| !e.is_zero());
        }
    }
    let plain = |q: &Expr| matches!(q, Expr::Symbol(_) | Expr::Apply(..));
    let added = exponents.keys().filter(|q| !own.contains_key(q)).count();
    let itself = rows.varying(&rows.sides.0);
    if exponents
        .keys()
        .any(|q| itself.contains_key(q) || !plain(q))
        || added > 2
    {
        return None;
    }
    let mut order = in_order(right);
    order.extend(exponents.keys().cloned());
    let goal = Formula::Relation {
        left: left.clone(),
        relation: *relation,
        right: written(&exponents, &order),
    };
    let proven = prove_scaling(&Claim {
        goal,
        ..claim.clone()
    })?;
    // What needs no premise is nothing to say.
    if proven.claim().hypotheses.is_empty() {
        return None;
    }
    Some(Repair {
        proven,
        one_of_many: related,
    })
}

/// A product of powers as one would write it.
fn written(exponents: &Exponents, order: &[Expr]) -> Expr {
    let (mut above, mut below) = (Vec::new(), Vec::new());
    let mut done: Set<&Expr> = Set::new();
    for quantity in order {
        let Some(exponent) = exponents.get(quantity).filter(|_| done.insert(quantity)) else {
            continue;
        };
        let under = exponent.is_negative() && exponent.is_integer();
        let size = if under { -exponent } else { exponent.clone() };
        let power = match size.is_one() {
            true => quantity.clone(),
            false => Expr::Power(quantity.clone().into(), ratio(&size).into()),
        };
        if under { &mut below } else { &mut above }.push(power);
    }
    let product = |mut factors: Vec<Expr>| match factors.len() {
        0 => Expr::integer(1),
        1 => factors.remove(0),
        _ => Expr::Product(factors.into()),
    };
    match below.is_empty() {
        true => product(above),
        false => Expr::Quotient(product(above).into(), product(below).into()),
    }
}

/// A number as a quotient of integers: `3/5`, not `0.6`.
fn ratio(number: &Rational) -> Expr {
    let size = number.abs();
    let above = Expr::integer(size.numer());
    let written = match size.is_integer() {
        true => above,
        false => Expr::Quotient(above.into(), Expr::integer(size.denom()).into()),
    };
    match number.is_negative() {
        true => Expr::Negate(written.into()),
        false => written,
    }
}

/// Why neither evidence was found.
fn undecided(claim: &Claim, rows: &Rows, known: &Known, goal: &Exponents) -> String {
    let (rest, ..) = known.echelon.reduce(goal);
    let proportional = matches!(
        &claim.goal,
        Formula::Relation {
            relation: Relation::Proportional,
            ..
        }
    );
    let right = rows.varying(&rows.sides.1);
    let own = rows.varying(&rows.sides.0);
    let elsewhere: Vec<String> = rest
        .keys()
        .filter(|q| !right.contains_key(q) && !own.contains_key(q))
        .filter_map(|q| match q {
            Expr::Symbol(s) => Some(s.to_string()),
            _ => None,
        })
        .collect();
    match proportional && !elsewhere.is_empty() {
        true => format!(
            "it depends on what is held fixed: `{}` is not declared to be constant",
            elsewhere.join("`, `")
        ),
        false => "the premises were not seen to give these exponents, nor to allow others".into(),
    }
}

/// Whether a rescaling changes the two sides of the goal differently.
fn breaks(goal: &Exponents, rescaling: &Exponents) -> bool {
    !pairing(goal, rescaling).is_zero()
}
