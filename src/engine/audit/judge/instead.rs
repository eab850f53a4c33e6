//! What holds in the place of what was refuted.

use crate::algebra::{Expr, Formula, Symbol};
use crate::derivation::{Assumed, Goal, values_at};
use crate::kernel::Claim;
use crate::search::{self, Effort, Implied, InChain};

use super::super::Outcome;
use super::{Found, Judge};

impl Judge<'_> {
    /// Looks for what holds in the place of what was refuted: a consequence, a mended formula, or what was not said.
    pub(in crate::audit) fn instead(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        premises: &[usize],
        found: &mut Found,
    ) {
        let Some((claim, chain)) = self.instead_from_these(goal, assumed, premises, found) else {
            return;
        };
        let Outcome::Refuted(refuted) = &found.judged.outcome else {
            return;
        };
        if found.conditions.is_empty()
            && found.mended.is_none()
            && found
                .implied
                .as_ref()
                .is_none_or(|i| i.restates() && !i.is_multiple())
        {
            let elsewhere = self.later(premises);
            // What is tried next remembers points, and so needs the hints given back.
            let missing = {
                let hints = self.auditor.hints();
                let witness = refuted.witness();
                search::missing_suppositions(&claim, witness, &elsewhere, &hints, values_at)
            };
            if let Some((all, _)) = missing {
                (found.missing, found.implied) = (all, None);
            } else {
                self.mended_from_all(goal, assumed, premises, &chain, found);
                if found.mended.is_none() {
                    self.mended_under_conditions(goal, assumed, premises, &chain, found);
                }
            }
        }
    }

    /// The same from just these premises. Gives what is mended and where it stands, unless nothing more is to be looked for.
    pub(in crate::audit) fn instead_from_these(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        premises: &[usize],
        found: &mut Found,
    ) -> Option<(Claim, InChain)> {
        let Outcome::Refuted(refuted) = &found.judged.outcome else {
            return None;
        };
        let claim = self.derivation.claim(self.at, assumed, &goal.formula);
        let held = self.held_in(goal, (assumed, premises), refuted.claim(), &claim);
        let claim = search::with_constants(claim, held);
        let chain = self.in_chain(goal, assumed)?;
        // What the text itself names is likelier meant than that the pen slipped.
        let mentioned = self.derivation.mentioned(self.at);
        if !mentioned.is_empty() {
            let mentioned = mentioned.into_iter().map(|(_, formula)| formula).collect();
            let (witness, hints) = (refuted.witness(), self.auditor.hints());
            let missing = search::missing_among(&claim, witness, mentioned, &hints, values_at);
            if let Some((all, _)) = missing {
                found.missing = all;
                return None;
            }
        }
        let posed = self.pose_claim(claim.clone()).ok();
        let begins = matches!(goal.formula.as_equation(), Some((Expr::Symbol(_), _)));
        let settled = match begins {
            true => chain.right_settled,
            false => chain.left_settled,
        };
        if !settled {
            let implied = posed.as_deref().and_then(search::implied);
            // To be told what a premise says helps nobody who cites it.
            let helps = |i: &Implied| !i.restates() || i.ratio.is_some();
            found.implied = implied.filter(helps).map(Box::new);
        }
        // Where only a factor is wrong, the author's own words are kept already.
        if !found.implied.as_ref().is_some_and(|i| i.is_multiple()) {
            let witness = refuted.witness();
            let hints = self.auditor.hints();
            let mended = search::mended(&claim, &chain, witness, &hints, values_at);
            found.mended = mended.map(Box::new);
        }
        if !found.has_conditions
            && let Some(posed) = &posed
            && let Some(unless) = search::missing_conditions(
                posed,
                Some(refuted.witness()),
                Effort::Light,
                &self.auditor.hints(),
            )
        {
            found.conditions = unless.conditions();
        }
        Some((claim, chain))
    }

    /// What a counterexample holds constant and may be meant to be; nothing where the goal takes an integral or a limit of what other equations give than
    /// those it is drawn from: `\int \rho s^2\,ds` after `\rho = \rho_c (1 - r/R)`.
    pub(in crate::audit) fn held_in(
        &self,
        goal: &Goal,
        (assumed, premises): (&[Assumed], &[usize]),
        by: &Claim,
        claim: &Claim,
    ) -> Vec<Symbol> {
        let names = goal.formula.names();
        let is_held = |own: &&Symbol| by.is_constant(own) && !claim.is_constant(own);
        let mut held: Vec<Symbol> = names.iter().filter(is_held).cloned().collect();
        // Most counterexamples hold nothing.
        if held.is_empty() {
            return held;
        }
        let [near, _] = self.others(premises);
        let is_given = |symbol: &Symbol| {
            let mut known = assumed.iter().chain(near);
            known.any(|own| own.formula.said_of().is_some_and(|said| said.0 == symbol))
        };
        let is_drawn_from = |symbol: &Symbol, by: &Symbol| {
            let mut said = assumed.iter().filter_map(|own| own.formula.said_of());
            said.any(|(of, term)| of == symbol && term.mentions(by))
        };
        let takes_unknown = |part: &Expr| {
            let (Expr::Integral { body, variable, .. } | Expr::Limit { body, variable, .. }) = part
            else {
                return false;
            };
            let moves =
                |own: &Symbol| is_given(own) || self.auditor.changes(self.at, own, variable);
            let names = body.free_symbols();
            let mut names = names.iter().filter(|own| *own != variable);
            names.any(|own| moves(own) && !is_drawn_from(own, variable))
        };
        let mut terms = goal.formula.terms().into_iter();
        if terms.any(|term| term.any(&takes_unknown)) {
            return Vec::new();
        }
        held.retain(|own| !is_given(own));
        held
    }

    /// Which side of a refuted link may be wrong, as far as its neighbours tell; nothing where it is only the left one,
    /// which is the link before to put right.
    fn in_chain(&self, goal: &Goal, assumed: &[Assumed]) -> Option<InChain> {
        let sides = |goal: &Goal| {
            let (left, right) = goal.formula.as_equation()?;
            Some((left.clone(), right.clone()))
        };
        // Where a chain goes on rightly past a member, that member is wrong.
        let joined = |one: &Goal, other: &Goal| {
            let joined = sides(one).zip(sides(other));
            joined.is_some_and(|((left, _), (_, right))| {
                let formula = Formula::equal(left, right);
                let claim = self.derivation.claim(self.at, assumed, &formula);
                search::prove_unconditionally(claim, Effort::Light).is_some()
            })
        };
        let before = self.derivation.link_before(self.at, goal);
        if let Some(before) = before.as_ref().filter(|before| joined(before, goal)) {
            // Of what an author only asks no repair is looked for.
            let asked = InChain {
                right_settled: true,
                ..InChain::default()
            };
            return before.questioned.then_some(asked);
        }
        let after = self.derivation.link_after(self.at, goal);
        let passed = after.as_ref().is_some_and(|after| joined(goal, after));
        Some(InChain {
            left_settled: before.is_some() || passed,
            right_settled: false,
            next: after.map(|after| after.formula),
        })
    }
}
