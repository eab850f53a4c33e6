//! What holds for every element of a sequence: where the proof begins, and how it goes on.

use std::sync::Arc;

use num_traits::One;

use crate::algebra::{Moved, Place, Symbol};
use crate::audit::{Judged, Outcome};
use crate::derivation::{Assumed, Goal, Source};
use crate::kernel::{Claim, HoldsForEvery, PartOrigin, ProvenPart, Standing};
use crate::notation::plain_formula;
use crate::search::Stop;

use super::Report;
use super::words;

impl Report<'_> {
    /// A proof for every index, a step a line.
    pub(super) fn proof_for_every(&self, judged: &Judged, holds: &HoldsForEvery) -> Vec<String> {
        let claim = holds.claim();
        let index = words::symbol(&claim.index);
        let start = claim.start().unwrap_or_default();
        let bases = holds.bases();
        let mut lines = Vec::new();
        if bases.is_empty() {
            lines.push(format!("What is said of every {index} ≥ {start} is used"));
            lines.extend(self.part(judged, holds, holds.last()));
            return lines;
        }
        lines.push(format!(
            "By induction on {index}, from {index} = {start} on"
        ));
        for (number, base) in (start..).zip(bases) {
            let shown = plain_formula(&base.proven.claim().goal);
            lines.push(format!("Base, {index} = {number}: {shown}"));
            lines.extend(self.part(judged, holds, base));
        }
        let step = holds.last();
        let shown = plain_formula(&step.proven.claim().goal);
        lines.push(format!("Step, to {index} + {}: {shown}", bases.len()));
        lines.extend(self.part(judged, holds, step));
        lines
    }

    /// What one part is proved from, and its proof, set in.
    fn part(&self, judged: &Judged, holds: &HoldsForEvery, part: &ProvenPart) -> Vec<String> {
        let index = words::symbol(&holds.claim().index);
        let claim = part.proven.claim();
        let mut lines = Vec::new();
        let mut assumed = Vec::new();
        for (origin, hypothesis) in part.origins.iter().zip(&claim.hypotheses) {
            let shown = plain_formula(&hypothesis.formula);
            let source = |position: usize| {
                let own = judged.assumed.get(position);
                own.map_or(Source::Step, |own| own.source)
            };
            let (source, from) = match *origin {
                PartOrigin::Constant(position) => {
                    (source(position), self.source(&source(position)))
                }
                PartOrigin::Instance(instance) => {
                    let at = match instance.at {
                        Moved::To(number) => format!("{index} = {number}"),
                        Moved::By(0) => index.clone(),
                        Moved::By(ahead) => format!("{index} + {ahead}"),
                    };
                    let source = source(instance.hypothesis);
                    (source, format!("{} at {at}", self.source(&source)))
                }
                PartOrigin::Supposed(_) => (Source::Step, "supposed".into()),
            };
            lines.push(format!("  from {shown}   ({from})"));
            assumed.push(Assumed {
                formula: Arc::clone(&hypothesis.formula),
                standing: Standing::AtPoint,
                source,
            });
        }
        let supposed = part
            .origins
            .iter()
            .any(|o| matches!(o, PartOrigin::Supposed(_)));
        let own = Judged {
            goal: Goal {
                formula: claim.goal.clone(),
                ..judged.goal.clone()
            },
            assumed,
            outcome: Outcome::Open(Stop::default()),
        };
        for line in self.proof(&own, &part.proven) {
            let line = match supposed {
                true => line.replace("   the step before", "   supposed"),
                false => line,
            };
            lines.push(format!("  {line}"));
        }
        lines
    }
}

/// That a sequence is spoken of before it begins: `c_0 = 1`, where `n` is declared from 1 on, says nothing of `c_1`.
pub(super) fn before_the_start(claim: &Claim) -> Option<String> {
    let symbols = claim.free_symbols();
    let begins = |index: &Symbol| {
        let domain = claim.domains.get(index).filter(|d| d.integer)?;
        let (start, _) = domain.lower.as_ref()?;
        start.is_one().then_some(())
    };
    symbols.iter().find_map(|index| {
        begins(index)?;
        let places = || symbols.iter().filter_map(|s| Some((s, s.place(index)?)));
        places().find_map(|(element, (stem, place))| {
            let runs = |(_, (own, place)): (_, (Symbol, Place))| {
                own == stem && matches!(place, Place::Running(offset) if offset > 0)
            };
            (place == Place::Number(0) && places().any(runs)).then(|| {
                let element = words::symbol(element);
                format!(
                    "`{index}` is declared from 1 on, so nothing says how `{element}` goes on; `{index}: integer, >= 0` begins there"
                )
            })
        })
    })
}
