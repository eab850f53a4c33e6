//! What words before a step say to be otherwise than before: "whereas equal work needs", "the rate drops to", "The balance now contains
//! three terms", "this is its energy also".

use crate::algebra::{Expr, Formula};
use crate::derivation::{Assumed, Goal, Source, first_goal, in_a_row, words_of};
use crate::search::Change;

use super::super::judge::{Found, Judge};

/// With one of these it sets something against what stands before.
const SET_AGAINST: [&str; 5] = ["whereas", "while", "contrast", "instead", "rather"];
/// So it is with one of these before one of those: a "reduced length" is no other length than before.
const CHANGED: [&str; 14] = [
    "reduced",
    "raised",
    "lowered",
    "changed",
    "drops",
    "falls",
    "rises",
    "increases",
    "decreases",
    "grows",
    "shrinks",
    "climbs",
    "changes",
    "improves",
];
const BY_HOW_MUCH: [&str; 3] = ["to", "by", "from"];
/// With one of these after "now", or that before it, something is no more as it was: "now contains three terms", "no longer holds".
const NOW: [&str; 1] = ["now"];
const NO: [&str; 1] = ["no"];
const LONGER: [&str; 1] = ["longer"];
const CONTAINING: [&str; 7] = [
    "contains", "contain", "includes", "include", "consists", "has", "reads",
];
/// "Since the neutrino is massless, this is its energy also": what two names are is the same, and only words say so.
const IDENTIFYING: [&str; 2] = ["this", "it"];
const BEING: [&str; 1] = ["is"];
const TOO: [&str; 2] = ["also", "too"];

impl Judge<'_> {
    /// Leaves open another value of what the display before gives a value of, where words set one against the other: "whereas equal work from
    /// both engines needs".
    pub(in crate::audit) fn heed_contrast(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        found: &mut Found,
    ) {
        if !found.judged.outcome.is_refuted() || !self.cites_loosely() || !self.sets_against() {
            return;
        }
        let of = match goal.formula.as_equation() {
            Some((Expr::Symbol(of), _)) => of,
            Some((Expr::Limit { body, .. }, _)) => match &**body {
                Expr::Symbol(of) | Expr::Apply(of, _) => of,
                _ => return,
            },
            _ => return,
        };
        let is_of_it = |own: &Formula| {
            let sides = own.as_equation();
            matches!(sides, Some((Expr::Symbol(own) | Expr::Apply(own, _), _)) if own == of)
        };
        let is_value =
            |own: &Assumed| matches!(own.source, Source::Equation(_)) && is_of_it(&own.formula);
        let is_given_value = |at: usize| {
            let mut before = self.derivation.equations[at].statements().iter();
            before.any(|own| first_goal(own).is_some_and(|own| is_of_it(&own.formula)))
        };
        let mut speaking = self.derivation.speaking_before(self.at, of);
        if assumed.iter().any(is_value) || speaking.any(is_given_value) {
            found.leave_open("words set it against another value that stands before");
        }
    }

    /// Whether words set what is said against what stands before: "The wall moment is then reduced to".
    pub(in crate::audit) fn sets_against(&self) -> bool {
        self.says(&SET_AGAINST) || self.says_in_a_row(&CHANGED, &BY_HOW_MUCH)
    }

    /// Leaves open what was refuted where something was told of it before the display before, where words since then say that something is otherwise
    /// now.
    pub(in crate::audit) fn heed_what_is_otherwise_now(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        found: &mut Found,
    ) {
        if !found.judged.outcome.is_refuted() || !self.has_changed() {
            return;
        }
        let page = self.derivation.equations[self.at].page;
        let Some(before) = self.derivation.before_display(self.at) else {
            return;
        };
        let end = self.derivation.equations[before].span.end;
        let is_old = |own: &&Assumed| match own.source {
            Source::Local(of, at) => of == page && self.derivation.local(of, at).span.end <= end,
            _ => false,
        };
        let names = goal.formula.names();
        let is_of_it = |own: &Assumed| !own.formula.names().is_disjoint(&names);
        if assumed.iter().filter(is_old).any(is_of_it) {
            found.leave_open("words say that something is otherwise now than it was told before");
        }
    }

    /// Leaves open what differs from what follows by one name for another, where words say that two things are the same.
    pub(in crate::audit) fn heed_names_in_words(&self, found: &mut Found) {
        let is_name = |change: &Change| matches!(change, Change::Symbol { .. });
        let mended = found.mended.as_deref();
        if !found.judged.outcome.is_refuted() || !mended.is_some_and(|own| is_name(&own.change)) {
            return;
        }
        let text = self.derivation.text_before(self.at);
        let identifies = |sentence: &str| {
            let words: Vec<String> = words_of(sentence).collect();
            in_a_row(&words, &IDENTIFYING, &BEING) && words.iter().any(|own| TOO.contains(&&**own))
        };
        if text.split(['.', ';']).any(identifies) {
            found.leave_open("words say that two things are the same");
        }
    }

    /// Whether the text since the display before says that something is otherwise now.
    fn has_changed(&self) -> bool {
        let words: Vec<String> = words_of(self.derivation.text_before(self.at)).collect();
        in_a_row(&words, &NOW, &CONTAINING) || in_a_row(&words, &NO, &LONGER)
    }
}
