//! Special cases that nobody has left in so many words, and perhaps in thought: "In the special case $a = b$, (1) becomes $$…$$", and then
//! a step from (1) that follows only if $a = b$.
//!
//! A case is still meant where a step cites what was concluded in it, cites nothing and goes on from the display before, or says "then".
//! Where it does none of these, what follows in the case alone is left open: it may be said of all.

use crate::algebra::{Expr, Formula};
use crate::derivation::{Assumed, Equation, Goal, Source};
use num_traits::Zero;

use super::super::judge::{Found, Judge};
use super::super::stated::quantities;

/// With these a text goes on from what was just said.
const GOING_ON: [&str; 21] = [
    "then",
    "here",
    "still",
    "again",
    "also",
    "so",
    "hence",
    "thus",
    "therefore",
    "case",
    "too",
    "likewise",
    "moreover",
    "furthermore",
    "this",
    "inserting",
    "substituting",
    "eliminating",
    "plugging",
    "combining",
    "together",
];
/// With these it leaves what was said of a case, go on as it may.
const LEAVING: [&str; 8] = [
    "general",
    "any",
    "arbitrary",
    "every",
    "all",
    "next",
    "later",
    "instead",
];

impl Judge<'_> {
    /// The special case, as it is written, that a step which was proved needs, and that may not be meant any more where the step stands.
    pub(in crate::audit) fn lingering(&self, found: &Found, premises: &[usize]) -> Option<&str> {
        if !self.names_its_premises() || premises.is_empty() {
            return None;
        }
        let goal = &found.judged.goal;
        let is_left = |place: &(usize, usize)| {
            let local = self.derivation.local(place.0, place.1);
            local.is_of_special_case()
                && !local.is_passing()
                && self.may_be_left(*place, goal, premises)
        };
        // What is not cited may have been concluded in a case, or at one moment.
        let is_elsewhere = |place: &(usize, usize)| {
            let local = self.derivation.local(place.0, place.1);
            local.is_of_some_case() && self.may_be_left(*place, goal, premises)
        };
        let mut assumed = found.judged.assumed.iter();
        let (page, local) = assumed.find_map(|own| match own.source {
            Source::Local(page, local) => Some((page, local)).filter(is_left),
            Source::Equation(premise) if !premises.contains(&premise) => {
                let under = self.auditor.offer(self.at, premise)?.under.iter();
                under.copied().find(is_elsewhere)
            }
            _ => None,
        })?;
        let source = &self.derivation.pages[page].document.source;
        source.get(self.derivation.local(page, local).span.range())
    }

    /// Whether a hypothesis is what the words announce that lead on to the display: "At the centre, $z = 0$, it vanishes: $$V = 0$$". That is
    /// what is to be shown.
    pub(in crate::audit) fn announces(&self, own: &Assumed, goal: &Goal) -> bool {
        let Source::Local(page, local) = own.source else {
            return false;
        };
        let local = self.derivation.local(page, local);
        *own.formula == goal.formula
            && local.is_momentary()
            && self.derivation.equations[self.at].page == page
            && self.derivation.before_display(self.at).is_some()
            && self.derivation.is_said_since(self.at, local.span)
    }

    fn may_be_left(&self, place: (usize, usize), goal: &Goal, premises: &[usize]) -> bool {
        let equation = &self.derivation.equations[self.at];
        let local = self.derivation.local(place.0, place.1);
        if local.means {
            return false;
        }
        // What comes to a number is calculated from the numbers of an example.
        let is_number = |own: &Formula| {
            let sides = own.as_equation();
            sides.is_some_and(|(_, value)| quantities(value).is_empty())
        };
        let sets_number = |own: &Formula| {
            let sides = own.as_equation();
            sides.is_some_and(|(_, value)| matches!(value, Expr::Number(own) if !own.is_zero()))
        };
        if is_number(&goal.formula) && local.formulas.iter().any(|own| sets_number(own)) {
            return false;
        }
        let before = self.derivation.before_display(self.at);
        let before = before.map(|before| &self.derivation.equations[before]);
        let Some(before) = before.filter(|own| own.page == place.0) else {
            return false;
        };
        let is_of_case = |premise: &usize| {
            let offer = self.auditor.offer(self.at, *premise);
            offer.is_some_and(|own| own.under.contains(&place))
        };
        // What is told in passing is told of the case there and then.
        let told_before = || {
            equation
                .said_last
                .is_some_and(|own| local.span.end <= own.start)
        };
        let is_before = local.span.start < before.span.start || local.is_told && told_before();
        is_before && !premises.iter().any(is_of_case) && !self.goes_on_in_words(before, equation)
    }

    /// Whether a word between two displays goes on from the first, and none leaves it.
    fn goes_on_in_words(&self, before: &Equation, equation: &Equation) -> bool {
        let source = &self.derivation.pages[equation.page].document.source;
        let said = source
            .get(before.span.end..equation.span.start)
            .unwrap_or_default();
        // "and (3) becomes"
        let mut letters = said
            .chars()
            .skip_while(|c| !c.is_alphanumeric() && *c != '(');
        if letters.next().is_some_and(char::is_lowercase) {
            return true;
        }
        let words = said
            .split(|c: char| !c.is_alphabetic())
            .map(str::to_lowercase);
        let words: Vec<String> = words.collect();
        let has = |all: &[&str]| words.iter().any(|word| all.contains(&&**word));
        has(&GOING_ON) && !has(&LEAVING)
    }
}
