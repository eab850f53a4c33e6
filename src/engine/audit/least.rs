//! What a proof does without: hypotheses that are not needed are not told of.

use std::rc::Rc;

use crate::derivation::{Assumed, Goal, Kind, Source};
use crate::kernel::{Obligation, Proven};
use crate::search::{self, Derived, Effort};

use super::judge::Judge;

/// So many equations that are not cited a reader takes in; of more it is asked in earnest which are needed.
const FEW: usize = 3;

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
        let is_left = |source: &Source| kept.iter().any(|a| a.source == *source);
        needless.retain(is_left);
        if needless.len() > FEW {
            let own = &all[..cited];
            let pair = self.two_of(own, &all[cited..], &needless, goal);
            (kept, proven) = pair.unwrap_or_else(|| self.fewer(kept, proven, &needless, goal));
        }
        (kept, proven)
    }

    /// What is cited with all that two equations say, the nearest first, if that is enough.
    fn two_of(
        &self,
        own: &[Assumed],
        borrowed: &[Assumed],
        sources: &[Source],
        goal: &Goal,
    ) -> Option<(Vec<Assumed>, Proven)> {
        let near = || sources.iter().rev().enumerate();
        let mut pairs =
            near().flat_map(|(at, one)| near().skip(at + 1).map(move |(_, other)| [one, other]));
        pairs.find_map(|pair| {
            let both = borrowed.iter().filter(|a| pair.contains(&&a.source));
            let hypotheses: Vec<Assumed> = own.iter().chain(both).cloned().collect();
            let proven = self.proved_in_earnest(&hypotheses, goal)?;
            Some((hypotheses, proven))
        })
    }

    /// Leaves out one equation after another, as far as the rest is enough.
    fn fewer(
        &self,
        mut kept: Vec<Assumed>,
        mut proven: Proven,
        sources: &[Source],
        goal: &Goal,
    ) -> (Vec<Assumed>, Proven) {
        for source in sources {
            let fewer = kept.iter().filter(|a| a.source != *source);
            let fewer: Vec<Assumed> = fewer.cloned().collect();
            if let Some(found) = self.proved_in_earnest(&fewer, goal) {
                (kept, proven) = (fewer, found);
            }
        }
        (kept, proven)
    }

    fn proved_in_earnest(&self, hypotheses: &[Assumed], goal: &Goal) -> Option<Proven> {
        let claim = self.derivation.claim(self.at, hypotheses, &goal.formula);
        search::prove_unconditionally(claim, Effort::Full).map(|derived| derived.proven)
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
        let pose = |assumed: &[Assumed]| self.pose(assumed, &goal.formula).ok();
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
        let mut shorter: Option<Rc<Obligation>> = None;
        if few.len() < assumed.len()
            && let Some(posed) = pose(&few)
            && let Some(derived) = search::prove_by_degrees(&posed)
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
            if !search::may_do_without(shorter.as_deref().unwrap_or(posed), position) {
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
