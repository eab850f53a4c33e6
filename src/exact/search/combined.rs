//! Which hypotheses a certificate combines.

use crate::algebra::Polynomial;
use crate::kernel::{Certificate, Origin, Problem, Proof};
use crate::sorted::Set;

/// The hypotheses that a certificate combines, by position.
pub(super) fn combined_hypotheses(problem: &Problem, certificate: &Certificate) -> Set<usize> {
    let mut used: Set<usize> = certificate.unfold.iter().copied().collect();
    let proofs = certificate
        .lemmas
        .iter()
        .map(|l| &l.proof)
        .chain([&certificate.conclusion]);
    let proofs: Vec<&Proof> = proofs.collect();
    // Only the lemmas that the conclusion reaches count.
    let mut wanted = vec![proofs.len() - 1];
    let mut seen = Set::new();
    while let Some(at) = wanted.pop() {
        if !seen.insert(at) {
            continue;
        }
        for fact in facts_of(proofs[at]) {
            match problem.origins.get(fact) {
                Some(
                    Origin::Hypothesis(position)
                    | Origin::Rate(position)
                    | Origin::Logarithms(position),
                ) => {
                    used.insert(*position);
                }
                Some(_) => {}
                None => wanted.push(fact - problem.facts.len()),
            }
        }
    }
    used
}

/// The facts that a proof names.
fn facts_of(proof: &Proof) -> Vec<usize> {
    let names = |cofactors: &[(usize, Polynomial)]| -> Vec<usize> {
        cofactors.iter().map(|c| c.0).collect()
    };
    match proof {
        Proof::Combination { cofactors, .. } | Proof::NonVanishing { cofactors, .. } => {
            names(cofactors)
        }
        Proof::Positivity {
            terms, cofactors, ..
        } => {
            let mut all = names(cofactors);
            all.extend(terms.iter().flat_map(|t| t.facts.iter().copied()));
            all
        }
        Proof::BothBounds { below, above } => {
            let mut all = facts_of(below);
            all.extend(facts_of(above));
            all
        }
        Proof::Square(inner) | Proof::Logarithms(inner) | Proof::Larger { squares: inner, .. } => {
            facts_of(inner)
        }
        Proof::OfPower { base, .. } => vec![*base],
    }
}
