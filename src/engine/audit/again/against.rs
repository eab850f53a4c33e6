//! A counterexample held against what stands before and is not cited: it is strengthened, or left open what that might save.

use crate::algebra::{Expr, Formula};
use crate::derivation::{Assumed, Goal, Source, values_at};
use crate::kernel::{Claim, Refuted};
use crate::search::{self, Decision, InChain};

use super::super::Outcome;
use super::super::judge::{Found, Judge, NEARBY, step};
use super::super::slip::but_names;
use super::borrowed::speaks_of_all;
use super::conditions::unbounded;
use super::{ELSEWHERE, OPEN_ITSELF};

/// What an equation is only written in another form by.
const REARRANGING: [&str; 4] = ["rearranging", "rearranged", "rearrange", "inverting"];

impl Judge<'_> {
    /// Looks for a counterexample at which what stands before is true too: it convinces more, and nothing that
    /// stands before can then be what the step follows from.
    pub(in crate::audit) fn strengthen(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        premises: &[usize],
        found: &mut Found,
    ) -> bool {
        // Other pages may mean other things by the same letters.
        let page = self.derivation.equations[self.at].page;
        let near = |a: &Assumed| match a.source {
            Source::Equation(other) => self.derivation.equations[other].page == page,
            Source::Local(other, _) => other == page,
            Source::Step | Source::Taken | Source::Propagation | Source::Nature => true,
        };
        let [sound, _] = self.others(premises);
        let sound = sound.iter().filter(|own| near(own)).cloned();
        let all: Vec<Assumed> = assumed.iter().cloned().chain(sound).collect();
        if all.len() == assumed.len() {
            return false;
        }
        let larger = self.derivation.claim(self.at, &all, &goal.formula);
        if let Some(refuted) = self.refuted_in_context(goal, assumed, larger) {
            found.judged.outcome = Outcome::Refuted(refuted.into());
            return true;
        }
        false
    }

    /// A counterexample to what is cited for a goal at which the hypotheses of a larger claim hold as well.
    pub(in crate::audit) fn refuted_in_context(
        &self,
        goal: &Goal,
        cited: &[Assumed],
        larger: Claim,
    ) -> Option<Refuted> {
        let claim = self.derivation.claim(self.at, cited, &goal.formula);
        self.refuted_together(claim, larger)
    }

    /// The same of a claim.
    pub(super) fn refuted_together(&self, claim: Claim, larger: Claim) -> Option<Refuted> {
        let (claim, larger) = (self.pose_claim(claim).ok()?, self.pose_claim(larger).ok()?);
        search::refute_in_context(&claim, &larger)
    }

    /// Leaves open a step that was refuted from what is cited, where nothing refutes it at which a larger claim's hypotheses hold as well.
    pub(super) fn heed_larger(
        &self,
        goal: &Goal,
        cited: &[Assumed],
        larger: Claim,
        reason: impl Into<String>,
        found: &mut Found,
    ) {
        match self.refuted_in_context(goal, cited, larger) {
            Some(refuted) => found.judged.outcome = Outcome::Refuted(refuted.into()),
            None => found.leave_open(reason),
        }
    }

    /// The same with what stands besides, unless all of that only gives names to something else.
    pub(super) fn heed_besides(
        &self,
        goal: &Goal,
        cited: &[Assumed],
        besides: impl IntoIterator<Item = Assumed>,
        reason: &str,
        found: &mut Found,
    ) {
        let all: Vec<Assumed> = cited.iter().cloned().chain(besides).collect();
        let larger = self.derivation.claim(self.at, &all, &goal.formula);
        let speaking = but_names(all, &goal.formula, None);
        if speaking.iter().any(|own| !cited.contains(own)) {
            self.heed_larger(goal, cited, larger, reason, found);
        }
    }

    /// What gives as an integral a symbol of a goal on which what is cited is silent, or a function that this applies: a counterexample that
    /// gives it any value is none to what the author says.
    pub(in crate::audit) fn told_before(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        premises: &[usize],
    ) -> Vec<Assumed> {
        let integral = |part: &Expr| matches!(part, Expr::Integral { .. });
        let names = goal.formula.free_symbols();
        let concerns = |own: &&Assumed| !own.formula.free_symbols().is_disjoint(&names);
        let concerned = assumed.iter().filter(concerns);
        let mut applied = Formula::applied_in(concerned.flat_map(|own| own.formula.terms()));
        // What is cited says itself what these are.
        for own in assumed {
            if let Some((Expr::Apply(function, _), _)) = own.formula.as_equation() {
                applied.remove(function);
            }
        }
        let tells = |own: &&Assumed| match own.formula.as_equation() {
            Some((Expr::Apply(function, _), _)) => applied.contains(function),
            Some((Expr::Symbol(symbol), term)) => {
                let one = Formula::equal(Expr::Symbol(symbol.clone()), Expr::integer(0));
                names.contains(symbol)
                    && term.any(&integral)
                    && !speaks_of_all(assumed.iter(), &one)
            }
            _ => false,
        };
        let [near, _] = self.others(premises);
        near.iter().filter(tells).cloned().collect()
    }

    /// Leaves open a step that was refuted from less than what stands before, where all of it with what is itself left open does not
    /// refute it: it may follow from that. Nothing is left open of which a slip of the pen is found, or where the author says what it
    /// follows from.
    pub(in crate::audit) fn heed_what_is_open(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        premises: &[usize],
        found: &mut Found,
    ) {
        // Who only writes an equation in another form needs no other one.
        if self.names_its_premises() || found.mended.is_some() || self.says(&REARRANGING) {
            return;
        }
        let mut open = self.open_on_this_page(premises);
        open.retain(|&other| self.is_undecided(other));
        let names = goal.formula.free_symbols();
        let concerns = |own: &Assumed| {
            let stated = matches!(own.source, Source::Equation(_));
            stated && !own.formula.free_symbols().is_disjoint(&names)
        };
        let open: Vec<Assumed> = (self.gathered(&open).into_iter())
            .filter(concerns)
            .collect();
        if open.is_empty() {
            return;
        }
        let [sound, _] = self.others(premises);
        let besides = sound.iter().chain(&open).cloned();
        self.heed_besides(goal, assumed, besides, OPEN_ITSELF, found);
    }

    /// Leaves open a step that cites nothing and is of something else than what stands just before it, unless it is refuted with what
    /// speaks of it, or a slip of the pen is found.
    pub(in crate::audit) fn heed_what_is_elsewhere(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        premises: &[usize],
        found: &mut Found,
    ) {
        if !found.judged.outcome.is_refuted() || found.mended.is_some() {
            return;
        }
        let elsewhere = self.said_elsewhere(goal, assumed, premises);
        if elsewhere.is_empty() {
            return;
        }
        if !self.refutes_with(goal, assumed, elsewhere, premises, found) {
            found.leave_open(ELSEWHERE);
        }
    }

    /// Leaves open a step that cites what is said of a case alone, and was refuted without that: "Applying (3) to the two adiabats".
    pub(in crate::audit) fn heed_what_is_out_of_scope(&self, found: &mut Found) {
        let is_refuted = found.judged.outcome.is_refuted() && found.mended.is_none();
        let in_words = self.names_its_premises() && !self.is_directed();
        if is_refuted && in_words && !self.usable.out_of_scope.is_empty() {
            found.leave_open(
                "what it cites is said of a case, and may be meant to be said of this one",
            );
        }
    }

    /// Leaves open that something worked out is positive, `4 \pi + \frac{4 V}{r^3} > 0`, where it is so for positive values of its symbols,
    /// and nobody says where these lie.
    pub(in crate::audit) fn heed_signs(&self, goal: &Goal, assumed: &[Assumed], found: &mut Found) {
        let is_refuted = found.judged.outcome.is_refuted() && found.mended.is_none();
        if !is_refuted || self.is_directed() || !goal.formula.is_inequality() {
            return;
        }
        let terms = goal.formula.terms();
        let is_bare = |term: &&Expr| matches!(term, Expr::Symbol(_));
        if !terms.contains(&&Expr::integer(0)) || terms.iter().any(is_bare) {
            return;
        }
        let named = goal.formula.names();
        let claim = self.derivation.claim(self.at, assumed, &goal.formula);
        let mut open = unbounded(&claim);
        open.retain(|own| named.contains(own));
        let positive = open
            .into_iter()
            .map(|own| Formula::positive(Expr::Symbol(own)));
        let with = positive.map(|own| step(&own));
        let all: Vec<Assumed> = assumed.iter().cloned().chain(with).collect();
        if let Some(Decision::Proven { conditions, .. }) = self.decide_from(&all, &goal.formula)
            && conditions.is_empty()
            && !self.is_contradictory(&all, goal)
        {
            found.leave_open(
                "it is so where its symbols are positive, and nothing says where they lie",
            );
        }
    }

    /// Leaves open a step that cites nothing and follows with what is said under circumstances, where the step is said under some as
    /// well: they may be the same. "Under random mating …, in the next generation".
    pub(in crate::audit) fn heed_circumstances(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        premises: &[usize],
        found: &mut Found,
    ) {
        if !found.judged.outcome.is_refuted() || !self.cites_loosely() {
            return;
        }
        let under = self.said_under_circumstances(premises);
        if under.is_empty() {
            return;
        }
        let [sound, _] = self.others(premises);
        let near = sound.iter().take(NEARBY[1].0).cloned();
        let all: Vec<Assumed> = assumed.iter().cloned().chain(under).chain(near).collect();
        if let Some(Decision::Proven { .. }) = self.decide_from(&all, &goal.formula)
            && !self.is_contradictory(&all, goal)
        {
            found.leave_open(
                "it follows with what is said under circumstances, and nothing says that these are meant here",
            );
        }
    }

    /// Whether a step is refuted with what stands elsewhere, too. A point that everything before allows says most; if none is found,
    /// one that this allows.
    pub(in crate::audit) fn refutes_with(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        elsewhere: Vec<Assumed>,
        premises: &[usize],
        found: &mut Found,
    ) -> bool {
        let with = assumed.iter().cloned().chain(elsewhere).collect();
        let everything = self.with_others(assumed, premises);
        everything.into_iter().chain([with]).any(|all| {
            let Some(refuted) = self.counterexample(&all, &goal.formula) else {
                return false;
            };
            found.judged.outcome = Outcome::Refuted(refuted.into());
            found.judged.assumed = all;
            true
        })
    }

    /// What stands before and speaks of a symbol of which what stands just before a step that cites nothing says nothing: with that as
    /// the premise the symbol could have any value.
    fn said_elsewhere(&self, goal: &Goal, assumed: &[Assumed], premises: &[usize]) -> Vec<Assumed> {
        let mut names = goal.formula.names();
        names.retain(|symbol| !symbol.is_unit());
        let is_premise = |own: &&Assumed| matches!(own.source, Source::Equation(_));
        let mut near = assumed.iter().filter(is_premise).peekable();
        if !self.cites_loosely() || near.peek().is_none() {
            return Vec::new();
        }
        for own in near {
            let spoken_of = own.formula.names();
            names.retain(|symbol| !spoken_of.contains(symbol));
        }
        let speaks = |own: &&Assumed| !own.formula.names().is_disjoint(&names);
        let [others, _] = self.others(premises);
        let speaking = others.iter().filter(is_premise).filter(speaks);
        speaking.take(NEARBY[1].0).cloned().collect()
    }

    /// The slip of the pen in a step that needs what stands before and is not cited.
    pub(in crate::audit) fn mended_from_all(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        premises: &[usize],
        chain: &InChain,
        found: &mut Found,
    ) {
        let Outcome::Refuted(refuted) = &found.judged.outcome else {
            return;
        };
        if self.names_its_premises() {
            return;
        }
        let Some(all) = self.with_others(assumed, premises) else {
            return;
        };
        if !speaks_of_all(all.iter(), &goal.formula) {
            return;
        }
        let claim = self.derivation.claim(self.at, &all, &goal.formula);
        let mended = {
            let hints = self.auditor.hints();
            search::mended(&claim, chain, refuted.witness(), &hints, values_at)
        };
        // Anything follows from what contradicts itself: two regimes, of which each has its own.
        if let Some(mended) = mended
            && !self
                .derivation
                .is_of_section_before(self.at, &mended.proven.claim().goal)
            && !self.is_contradictory(&all, goal)
        {
            (found.mended, found.implied) = (Some(Box::new(mended)), None);
        }
    }
}
