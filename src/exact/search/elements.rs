//! Sums over all elements of a sequence that cannot be negative, because no element leaves its declared domain.

use crate::algebra::{Atom, Polynomial, Symbol};
use crate::kernel::{BoundedSeries, ElementFactor, ElementSide, Problem, bounded_series};
use crate::sorted::{self, Map, Set};

/// Guesses at what a step of a derivation can need.
const HIGHEST_DEGREE: u32 = 6;
const MOST: usize = 40;

/// `Σ x (1 − x)²`, `Σ x w`, `Σ_{i≠j} x_i x_j` and their like, as far as the claim has the power sums that they
/// consist of. Most claims have no sequence with bounds, and then there are none.
pub fn bounded(problem: &Problem) -> Vec<(Polynomial, BoundedSeries)> {
    // By count, the sequences that are summed with it, and the highest degree of a sum.
    let mut counts: Map<&Symbol, (Set<&Symbol>, u32)> = Map::new();
    for (_, atom) in problem.atoms.iter() {
        if let Atom::PowerSum { to, powers } = atom
            && powers.iter().any(|p| !sides(problem, &p.0).is_empty())
        {
            let (sequences, highest) = counts.entry(to).or_default();
            sequences.extend(powers.iter().map(|p| &p.0));
            *highest = (*highest).max(powers.iter().map(|p| p.1).sum());
        }
    }
    let mut found = Vec::new();
    for (count, (sequences, highest)) in counts {
        let mut all = Vec::new();
        for (at, sequence) in sequences.iter().enumerate() {
            all.extend(powers(problem, sequence, highest.min(HIGHEST_DEGREE)));
            for other in sequences.iter().skip(at + 1) {
                for a in powers(problem, sequence, 1) {
                    let pairs = powers(problem, other, 1);
                    all.extend(pairs.into_iter().map(|b| [a.clone(), b].concat()));
                }
            }
        }
        let twice = all.iter().map(|f| (f.clone(), Some(f.clone())));
        let once = all.iter().map(|f| (f.clone(), None));
        for (f, g) in once.chain(twice) {
            let count = count.clone();
            let series = BoundedSeries { count, f, g };
            // What speaks of sums that do not occur is of no use.
            if let Ok(value) = bounded_series(problem, &series)
                && !value.is_zero()
                && found.len() < MOST
            {
                found.push((value, series));
            }
        }
    }
    found
}

/// The sides on which the domain of the elements ends.
fn sides(problem: &Problem, sequence: &Symbol) -> Vec<ElementSide> {
    let domain = problem.element_domain(sequence);
    let lower = domain.is_some_and(|d| d.lower.is_some());
    let upper = domain.is_some_and(|d| d.upper.is_some());
    let lower = lower.then_some(ElementSide::AboveLower);
    lower
        .into_iter()
        .chain(upper.then_some(ElementSide::BelowUpper))
        .collect()
}

/// All products of distances from the bounds, up to a degree, the lowest first.
fn powers(problem: &Problem, sequence: &Symbol, highest: u32) -> Vec<Vec<ElementFactor>> {
    let mut all: Vec<Vec<ElementFactor>> = vec![Vec::new()];
    for side in sides(problem, sequence) {
        let raised = |exponent| ElementFactor {
            sequence: sequence.clone(),
            side,
            exponent,
        };
        all = all
            .iter()
            .flat_map(|f| {
                let powers =
                    (1..=highest).map(|exponent| [f.clone(), vec![raised(exponent)]].concat());
                [f.clone()].into_iter().chain(powers)
            })
            .collect();
    }
    let degree = |f: &Vec<ElementFactor>| f.iter().map(|x| x.exponent).sum::<u32>();
    all.retain(|f| (1..=highest).contains(&degree(f)));
    sorted::sort_by_key(&mut all, degree);
    all
}
