//! What the sentence that leads on to a step names and does not suppose plainly: "An object at $g = 2 f$ is thus imaged at".
//!
//! A step that does not follow from what it cites, nor with what stands before, may be meant to follow from that as well; what it was
//! taken from is told. No step follows from words that say as much as it does.

use crate::algebra::{Expr, Formula, Symbol};
use crate::derivation::{Assumed, Goal};
use crate::search::{self, Decision, Effort};

use super::Outcome;
use super::judge::{Found, Judge, NEARBY};
use crate::sorted::Set;

impl Judge<'_> {
    /// What a step may be taken from, with what the words before it name; nothing where they name nothing, or what cannot be so.
    pub(super) fn with_what_is_named(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
    ) -> Option<Vec<Assumed>> {
        let mut named = self.derivation.named(self.at);
        named.retain(|own| !assumed.iter().any(|known| known.formula == own.formula));
        // What is put in is gone: "with $V = V_0$ at $t = 0$" is no reason for what still speaks of the time.
        let names = goal.formula.names();
        let all = assumed.iter().chain(&named);
        let is_put = |name: &Symbol| {
            all.clone()
                .any(|own| own.formula.set_to_number() == Some(name))
        };
        let leaves = || named.iter().any(|own| leaves(&own.formula, &names));
        if named.is_empty() || !names.iter().all(is_put) && leaves() {
            return None;
        }
        let alone = self.derivation.claim(self.at, &named, &goal.formula);
        if search::prove_unconditionally(alone, Effort::Light).is_some() {
            return None;
        }
        named.splice(0..0, assumed.iter().cloned());
        (!self.is_contradictory(&named, goal)).then_some(named)
    }

    /// Whether the step follows from `all`: what it may be taken from, with what the words before it name.
    pub(super) fn follows_from_words(
        &self,
        goal: &Goal,
        all: &[Assumed],
        premises: &[usize],
        found: &mut Found,
    ) -> bool {
        let follows = self.holds_under(goal, all.to_vec(), &[], Effort::Light, found)
            || {
                let attempts = self.attempts(goal, all, premises, None);
                self.rescue(goal, &attempts, &NEARBY, found)
            }
            || self.under_conditions(goal, all.to_vec(), None, (false, Effort::Light), found);
        if follows {
            found.may_follow = true;
        }
        follows
    }

    /// Refutes a step where what the words name is so, too, and says from what; where that is not found, leaves it open.
    pub(super) fn heed_what_is_named(&self, goal: &Goal, all: &[Assumed], found: &mut Found) {
        let claim = self.derivation.claim(self.at, all, &goal.formula);
        let Ok(posed) = search::pose(claim) else {
            return;
        };
        match search::decide_within(&posed, &self.auditor.hints(), self.points()) {
            Decision::Refuted(refuted) => {
                found.judged.outcome = Outcome::Refuted(refuted.into());
                found.judged.assumed = all.to_vec();
            }
            _ => found.leave_open("it may follow with what the sentence before it names"),
        }
    }
}

/// Whether a step still speaks of a symbol that is given a value, and of what it is said to be.
fn leaves(named: &Formula, names: &Set<Symbol>) -> bool {
    match named.as_equation() {
        Some((Expr::Symbol(symbol), Expr::Number(_))) => names.contains(symbol),
        Some((Expr::Symbol(symbol), Expr::Symbol(value))) => {
            names.contains(symbol) && names.contains(value)
        }
        _ => false,
    }
}
