//! What goes wrong without a premise: asked when one step is explained, not in the audit.

use crate::algebra::effort;
use crate::derivation::{Assumed, Derivation, Source};
use crate::kernel::Refuted;
use crate::search::{self, Decision};

use super::judge::sources;
use super::{Judged, MOST_WORK, Outcome};

/// Of a step with more premises than this, the first are looked at.
const MOST_PREMISES: usize = 8;

/// What becomes of a step without one of the premises that its proof uses.
#[derive(Clone, Debug)]
pub enum Without {
    /// It does not follow from the rest: a counterexample, through the kernel.
    Fails(Box<Refuted>),
    /// It follows from the rest by another proof.
    Follows,
    /// Neither was found.
    Open,
}

/// For each source of premises that the proof of a link uses: what becomes of the link without it. Nothing for a link
/// that is not proved.
pub fn without_each(derivation: &Derivation, at: usize, judged: &Judged) -> Vec<(Source, Without)> {
    // Of what is said to be some constant it is not shown that it is none.
    let mut symbols = judged.goal.formula.free_symbols().into_iter();
    if !matches!(judged.outcome, Outcome::Proven(_))
        || symbols.any(|symbol| derivation.is_some_constant(&symbol))
    {
        return Vec::new();
    }
    let all = sources(&judged.assumed).into_iter().take(MOST_PREMISES);
    let found = all.map(|source| {
        let rest = judged.assumed.iter().filter(|a| a.source != source);
        let rest: Vec<Assumed> = rest.cloned().collect();
        let claim = derivation.claim(at, &rest, &judged.goal.formula);
        let outcome = match effort::within(MOST_WORK, || search::decide(claim, &[])) {
            Decision::Refuted(refuted) => Without::Fails(refuted.into()),
            Decision::Proven { conditions, .. } if conditions.is_empty() => Without::Follows,
            _ => Without::Open,
        };
        (source, outcome)
    });
    found.collect()
}
