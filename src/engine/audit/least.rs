//! What a proof does without: hypotheses that are not needed are not told of.

use crate::derivation::{Assumed, Goal, Kind, Source};
use crate::kernel::{Obligation, Proven};
use crate::search::{self, Derived, Effort};

use super::judge::Judge;

impl Judge<'_> {
    /// Leaves out every hypothesis that a proof does without, the last first. `posed` is the claim that was proved.
    pub(super) fn least(
        &self,
        assumed: Vec<Assumed>,
        goal: &Goal,
        posed: &Obligation,
        derived: Derived,
    ) -> (Vec<Assumed>, Proven) {
        let order = assumed.iter().rev().cloned().collect();
        self.without_needless(assumed, order, goal, posed, derived)
    }

    /// The same for what is proved from hypotheses of which the first few are cited and the others are not: of these a reader is told, so
    /// that each must be needed. What is derived itself is left out first, and what is far before what is near.
    pub(super) fn least_borrowed(
        &self,
        assumed: Vec<Assumed>,
        cited: usize,
        goal: &Goal,
        posed: &Obligation,
        derived: Derived,
    ) -> (Vec<Assumed>, Proven) {
        let is_given = |a: &&Assumed| match a.source {
            Source::Equation(at) => self.derivation.equations[at].kind == Kind::Given,
            _ => true,
        };
        let (own, borrowed) = assumed.split_at(cited);
        let (given, shown): (Vec<&Assumed>, Vec<&Assumed>) = borrowed.iter().partition(is_given);
        let borrowed: Vec<Assumed> = given.into_iter().chain(shown).rev().cloned().collect();
        let order = borrowed.iter().chain(own.iter().rev()).cloned().collect();
        let all = assumed.clone();
        let (mut kept, mut proven) = self.without_needless(assumed, order, goal, posed, derived);
        let mut needless: Vec<Source> = borrowed.iter().map(|a| a.source).collect();
        needless.dedup();
        let left = |kept: &[Assumed]| -> Vec<Source> {
            let is_left = |source: &&Source| kept.iter().any(|a| a.source == **source);
            needless.iter().filter(is_left).copied().collect()
        };
        let proved = |hypotheses: Vec<Assumed>| {
            let claim = self.derivation.claim(self.at, &hypotheses, &goal.formula);
            let derived = search::prove_unconditionally(claim, Effort::Full)?;
            Some((hypotheses, derived.proven))
        };
        // From what is cited alone it does not follow.
        for source in left(&kept) {
            let fewer = kept.iter().filter(|a| a.source != source);
            if left(&kept).len() > 1
                && let Some(found) = proved(fewer.cloned().collect())
            {
                (kept, proven) = found;
            }
        }
        // What none of several can be spared of may follow from two of them, from all that these say.
        let several = left(&kept);
        if several.len() > 2 {
            let near = || several.iter().rev().enumerate();
            let mut pairs = near()
                .flat_map(|(at, one)| near().skip(at + 1).map(move |(_, other)| [*one, *other]));
            let found = pairs.find_map(|pair| {
                let (own, borrowed) = all.split_at(cited);
                let borrowed = borrowed.iter().filter(|a| pair.contains(&a.source));
                proved(own.iter().chain(borrowed).cloned().collect())
            });
            (kept, proven) = found.unwrap_or((kept, proven));
        }
        (kept, proven)
    }

    /// Leaves out every hypothesis that a proof does without, in an order.
    fn without_needless(
        &self,
        mut assumed: Vec<Assumed>,
        order: Vec<Assumed>,
        goal: &Goal,
        posed: &Obligation,
        derived: Derived,
    ) -> (Vec<Assumed>, Proven) {
        let pose = |assumed: &[Assumed]| {
            search::pose(self.derivation.claim(self.at, assumed, &goal.formula)).ok()
        };
        // What the certificate combines nearly always suffices; what only keeps something from vanishing is not in it.
        let Derived {
            mut proven,
            combined,
        } = derived;
        let all = assumed.iter().enumerate();
        let few: Vec<Assumed> = all
            .filter(|(position, _)| combined.contains(position))
            .map(|(_, own)| own.clone())
            .collect();
        let mut shorter: Option<Obligation> = None;
        if few.len() < assumed.len()
            && let Some(posed) = pose(&few)
            && let Some(derived) = search::prove_posed(&posed, Effort::Light)
                .or_else(|| search::prove_posed(&posed, Effort::Full))
        {
            (assumed, proven, shorter) = (few, derived.proven, Some(posed));
        }
        for needless in order {
            if assumed.len() < 2 {
                break;
            }
            let Some(position) = assumed.iter().rposition(|own| *own == needless) else {
                continue;
            };
            if !search::may_do_without(shorter.as_ref().unwrap_or(posed), position) {
                continue;
            }
            let mut fewer = assumed.clone();
            fewer.remove(position);
            if let Some(posed) = pose(&fewer)
                && let Some(derived) = search::prove_posed(&posed, Effort::Light)
            {
                (assumed, proven, shorter) = (fewer, derived.proven, Some(posed));
            }
        }
        (assumed, proven)
    }
}
