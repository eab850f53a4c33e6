//! Claims about every element of a sequence: directly from other indices, by induction, or refuted by first elements.

use super::{Decision, Effort, Obligation, decide_posed, prove_unconditionally};
use crate::algebra::{Expr, Formula, Moved, Place, Symbol};
use crate::kernel::{
    Claim, ForEvery, HoldsForEvery, Hypothesis, Instance, Part, PartOrigin, Reasoning, Refuted,
    Standing, at_the_index, check_for_every, refute_for_every,
};
use crate::sorted::Set;

/// An induction begins with so many bases at most.
const MOST_BASES: u32 = 2;
/// Counterexamples are looked for at so many of the first indices.
const FIRST_INDICES: u32 = 3;
/// More premises that are said of every index are not looked at.
const MOST_THROUGHOUT: usize = 16;
/// Elements with higher numbers are left alone.
const HIGHEST_NUMBER: u32 = 8;

/// Looks for a proof that a claim is true for every index, and says which hypotheses it uses.
pub fn prove_for_every(claim: &ForEvery) -> Option<(HoldsForEvery, Set<usize>)> {
    let start = claim.start().ok()?;
    claim.part(Moved::By(0), 0, &[]).ok()?;
    let usable = |&&hypothesis: &&usize| {
        let instance = |at| Instance { hypothesis, at };
        let fits = |at| claim.part(Moved::By(0), 0, &[instance(at)]).is_ok();
        !claim.is_constant(hypothesis) && (fits(Moved::By(0)) || fits(Moved::By(1)))
    };
    let usable: Vec<usize> = claim.throughout.iter().filter(usable).copied().collect();
    let is_sum = |part: &Expr| matches!(part, Expr::Series { .. });
    let sums = claim.claim.goal.terms().iter().any(|t| t.any(&is_sum));
    if usable.is_empty() && !sums || usable.len() > MOST_THROUGHOUT {
        return None;
    }
    let instances = |indices: &[Moved]| -> Vec<Instance> {
        let all = indices.iter().flat_map(|&at| {
            let own = usable.iter();
            own.map(move |&hypothesis| Instance { hypothesis, at })
        });
        let fits = |i: &Instance| claim.part(Moved::By(0), 0, &[*i]).is_ok();
        all.filter(fits).collect()
    };
    let ahead = last_offset(&claim.claim.goal, &claim.index);
    if ahead > HIGHEST_NUMBER {
        return None;
    }
    let mut near: Vec<Moved> = (0..=ahead.max(1)).map(Moved::By).collect();
    if let Some(last) = last_number(&claim.claim.goal, claim) {
        near.extend((start..=last.min(HIGHEST_NUMBER)).map(Moved::To));
    }
    if let Some((part, used)) = prove(claim, Moved::By(0), 0, instances(&near), Effort::Light) {
        let holds = check_for_every(claim.clone(), Reasoning::Direct(part)).ok()?;
        return Some((holds, used));
    }
    if !claim.claim.goal.depends_on(&claim.index) {
        return None;
    }
    (1..=MOST_BASES).find_map(|depth| {
        let (mut bases, mut used) = (Vec::new(), Set::new());
        for number in start..start + depth {
            let before: Vec<Moved> = (start..=number + ahead).map(Moved::To).collect();
            let goal = Moved::To(number);
            let (base, own) = prove(claim, goal, 0, instances(&before), Effort::Full)?;
            bases.push(base);
            used.extend(own);
        }
        let near: Vec<Moved> = (0..=depth + ahead).map(Moved::By).collect();
        let goal = Moved::By(depth);
        let (step, own) = prove(claim, goal, depth, instances(&near), Effort::Full)?;
        used.extend(own);
        let reasoning = Reasoning::Induction { bases, step };
        let holds = check_for_every(claim.clone(), reasoning).ok()?;
        Some((holds, used))
    })
}

/// Proves one part, from no more instances than it needs where that is seen, and says which hypotheses it uses.
fn prove(
    claim: &ForEvery,
    goal: Moved,
    supposed: u32,
    instances: Vec<Instance>,
    effort: Effort,
) -> Option<(Part, Set<usize>)> {
    let attempt = |instances: Vec<Instance>| {
        let (ordinary, origins) = claim.part(goal, supposed, &instances).ok()?;
        let derived = prove_unconditionally(ordinary.clone(), Effort::Light).or_else(|| {
            let full = effort == Effort::Full;
            full.then(|| prove_unconditionally(ordinary, Effort::Full))
                .flatten()
        })?;
        let certificate = derived.proven.certificate().clone();
        Some((
            Part {
                instances,
                certificate,
            },
            origins,
            derived.combined,
        ))
    };
    let (part, origins, combined) = attempt(instances)?;
    let needed = |origins: &[PartOrigin], combined: &Set<usize>| {
        let all = origins.iter().enumerate();
        let needed = all.filter(|(at, _)| combined.contains(at));
        needed.map(|(_, origin)| *origin).collect::<Vec<_>>()
    };
    let instances = needed(&origins, &combined).into_iter();
    let instances = instances.filter_map(|origin| match origin {
        PartOrigin::Instance(instance) => Some(instance),
        _ => None,
    });
    let hypotheses = |origins: Vec<PartOrigin>| {
        let all = origins.into_iter().filter_map(|origin| match origin {
            PartOrigin::Constant(at) => Some(at),
            PartOrigin::Instance(instance) => Some(instance.hypothesis),
            PartOrigin::Supposed(_) => None,
        });
        all.collect::<Set<usize>>()
    };
    Some(match attempt(instances.collect()) {
        Some((fewer, origins, combined)) => (fewer, hypotheses(needed(&origins, &combined))),
        // What only keeps something from vanishing is not among what is combined.
        None => (part, hypotheses(origins)),
    })
}

/// Looks for first elements at which the premises are true and the goal is false, which go on for ever.
pub fn refute_by_first_elements(claim: &ForEvery) -> Option<Refuted> {
    let start = claim.start().ok()?;
    let last = last_number(&claim.claim.goal, claim).unwrap_or(0);
    let first = match (
        fixed_index(claim),
        claim.claim.goal.depends_on(&claim.index),
    ) {
        (Some(fixed), _) if fixed >= start && fixed <= start + HIGHEST_NUMBER => fixed,
        (_, true) => start,
        // All elements of which the goal speaks must be there.
        (_, false) => start.max(last.min(HIGHEST_NUMBER)),
    };
    // The goal may speak of what premises say of this one index.
    let nothing = Formula::equal(Expr::integer(0), Expr::integer(0));
    let premises = ForEvery {
        claim: Claim {
            goal: nothing,
            ..claim.claim.clone()
        },
        ..claim.clone()
    };
    (first..first + FIRST_INDICES).find_map(|at| {
        let instances = claim.first_instances(at).ok()?;
        let (mut ordinary, origins) = premises.part(Moved::To(at), 0, &instances).ok()?;
        ordinary.goal = claim.claim.goal.moved(&claim.index, Moved::To(at))?;
        for (position, own) in claim.claim.hypotheses.iter().enumerate() {
            let there = match claim.is_constant(position) {
                true => origins.contains(&PartOrigin::Constant(position)),
                false => claim.throughout.contains(&position),
            };
            if !there {
                let formula = own.formula.moved(&claim.index, Moved::To(at))?.into();
                let standing = Standing::AtPoint;
                ordinary.hypotheses.push(Hypothesis { formula, standing });
            }
        }
        let symbols: Vec<Symbol> = ordinary.free_symbols().into_iter().cloned().collect();
        for symbol in symbols {
            if let Some(domain) = claim.claim.domains.get(&symbol) {
                ordinary
                    .domains
                    .entry(symbol)
                    .or_insert_with(|| domain.clone());
            }
        }
        let posed = Obligation::new(ordinary, Vec::new()).ok()?;
        let Decision::Refuted(refuted) = decide_posed(&posed, &[]) else {
            return None;
        };
        let point = at_the_index(claim, at, refuted.witness().clone());
        refute_for_every(claim, at, point).ok()
    })
}

/// The number that a hypothesis gives the index.
fn fixed_index(claim: &ForEvery) -> Option<u32> {
    let index = Expr::Symbol(claim.index.clone());
    claim.claim.hypotheses.iter().find_map(|h| {
        let (left, right) = h.formula.as_equation()?;
        match (left, right) {
            (own, Expr::Number(value)) | (Expr::Number(value), own) if *own == index => {
                let whole = value.is_integer().then(|| value.to_integer())?;
                u32::try_from(whole).ok()
            }
            _ => None,
        }
    })
}

/// The greatest offset from an index in a formula.
fn last_offset(formula: &Formula, index: &Symbol) -> u32 {
    let symbols = formula.free_symbols().into_iter();
    let offsets = symbols.filter_map(|s| match s.place(index)?.1 {
        Place::Running(offset) => u32::try_from(offset).ok(),
        _ => None,
    });
    offsets.max().unwrap_or(0)
}

/// The greatest number of an element in a formula.
fn last_number(formula: &Formula, claim: &ForEvery) -> Option<u32> {
    let symbols = formula.free_symbols().into_iter();
    let numbers = symbols.filter_map(|s| match s.place(&claim.index)? {
        (stem, Place::Number(number)) if claim.is_running(&stem) => Some(number),
        _ => None,
    });
    numbers.max()
}
