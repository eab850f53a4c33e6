//! Special cases that nobody has left in so many words, and perhaps in thought: "In the special case $a = b$, (1) becomes $$…$$", and then
//! a step from (1) that follows only if $a = b$.
//!
//! A case is still meant where a step cites what was concluded in it, cites nothing and goes on from the display before, or says "then".
//! Where it does none of these, what follows in the case alone is left open: it may be said of all.

use crate::algebra::{Expr, Formula};
use crate::derivation::{Assumed, Equation, Goal, Local, Source};
use crate::document::Span;
use crate::notation::plain_formula;
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
    pub(in crate::audit) fn lingering(&self, found: &Found, premises: &[usize]) -> Option<String> {
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
        let case = assumed.find_map(|own| match own.source {
            Source::Local(page, local) => {
                let place = Some((page, local));
                place.filter(|place| {
                    is_left(place)
                        || self.is_told_of_another_case(*place, found)
                        || self.is_said_otherwise(*place)
                })
            }
            Source::Equation(premise) if !premises.contains(&premise) => {
                let under = self.auditor.offer(self.at, premise)?.under.iter();
                under.copied().find(is_elsewhere)
            }
            _ => None,
        });
        match case {
            Some((page, local)) => {
                let source = &self.derivation.pages[page].document.source;
                let said = self.derivation.local(page, local).span;
                source.get(said.range()).map(str::to_owned)
            }
            None => self.displayed_of_a_moment(found, premises),
        }
    }

    /// Whether the last sentence before the step says something else in the place of a hypothesis: "It starts with $v = 0$. Later $v = a t$, and".
    fn is_said_otherwise(&self, (page, local): (usize, usize)) -> bool {
        let own = self.derivation.local(page, local);
        let mut told = self.derivation.told_just_before(self.at).into_iter();
        told.any(|other| match other.source {
            Source::Local(of, other) => {
                let other = self.derivation.local(of, other);
                of == page && own.span.end <= other.span.start && own.is_replaced_by(other)
            }
            _ => false,
        })
    }

    /// What is displayed and not cited, said of one moment, from which a step follows that is of something which a later sentence names:
    /// "Initially, at $t = 0$, we have $$x = 0$$ The area $A = x^2$ is, by (1),".
    fn displayed_of_a_moment(&self, found: &Found, premises: &[usize]) -> Option<String> {
        let own = &self.derivation.equations[self.at];
        let last = own.said_last.filter(|_| self.names_what_it_is_of(found))?;
        let source = &self.derivation.pages[own.page].document.source;
        if goes_on(source.get(last.range()).unwrap_or_default()) {
            return None;
        }
        let is_of_moment = |own: &&Assumed| match own.source {
            Source::Equation(premise) => {
                !premises.contains(&premise) && self.derivation.equations[premise].at_moment
            }
            _ => false,
        };
        let mut assumed = found.judged.assumed.iter();
        assumed
            .find(is_of_moment)
            .map(|own| plain_formula(&own.formula))
    }

    /// Whether a step that was proved is of something that the sentence before it says the meaning of.
    fn names_what_it_is_of(&self, found: &Found) -> bool {
        let Some(last) = self.derivation.equations[self.at].said_last else {
            return false;
        };
        found.judged.assumed.iter().any(|own| match own.source {
            Source::Local(page, local) => {
                let local = self.derivation.local(page, local);
                local.is_told && local.span.start >= last.start
            }
            _ => false,
        })
    }

    /// Whether a hypothesis is part of what a sentence before says of a case, "At $t = 1$ the body is at $x = v$.", and the step is of something
    /// that a later sentence names: "The area $A = x^2$ is, by (1),".
    fn is_told_of_another_case(&self, (page, local): (usize, usize), found: &Found) -> bool {
        let equation = &self.derivation.equations[self.at];
        let Some(last) = equation.said_last.filter(|_| equation.page == page) else {
            return false;
        };
        let source = &self.derivation.pages[page].document.source;
        let own = self.derivation.local(page, local);
        !own.means
            && !is_of_example(own, &found.judged.goal)
            && own.is_equation()
            && own.span.end <= last.start
            && self.derivation.is_said_since(self.at, own.span)
            && says_where(source, own.span)
            && self.names_what_it_is_of(found)
            && !goes_on(source.get(last.range()).unwrap_or_default())
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
        if is_of_example(local, goal) {
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
        // "as in free fall. The acceleration follows from (1)" goes on and comes to an end.
        let first = (equation.said_last).and_then(|own| source.get(before.span.end..own.start));
        let is_ended = first.is_some_and(|own| own.contains(char::is_alphanumeric));
        if !is_ended && letters.next().is_some_and(char::is_lowercase) {
            return true;
        }
        goes_on(said)
    }
}

/// Whether what comes to a number is calculated from the numbers of an example.
fn is_of_example(local: &Local, goal: &Goal) -> bool {
    let is_number = |own: &Formula| {
        let sides = own.as_equation();
        sides.is_some_and(|(_, value)| quantities(value).is_empty())
    };
    // A number with its unit is measured.
    let sets_number = |own: &Formula| {
        let sides = own.as_equation();
        sides.is_some_and(|(_, value)| match value {
            Expr::Number(own) => !own.is_zero(),
            value => is_number_with_unit(value),
        })
    };
    is_number(&goal.formula) && local.formulas.iter().any(|own| sets_number(own))
}

fn is_number_with_unit(value: &Expr) -> bool {
    let mut symbols = value.free_symbols().into_iter().peekable();
    symbols.peek().is_some() && symbols.all(|own| own.is_unit())
}

/// Whether a word goes on from what was just said, and none leaves it.
fn goes_on(said: &str) -> bool {
    let words = said
        .split(|c: char| !c.is_alphabetic())
        .map(str::to_lowercase);
    let words: Vec<String> = words.collect();
    let has = |all: &[&str]| words.iter().any(|word| all.contains(&&**word));
    has(&GOING_ON) && !has(&LEAVING)
}

/// Whether the sentence in which a formula stands says what is so where: "At $t = 1$ the body is at $x = v$.", "The place is $x = v$ when $t = 1$."
/// What is only set, "Let $m = a$ and $M = 3 a$.", is meant for what comes.
fn says_where(source: &str, span: Span) -> bool {
    const WHERE: [&str; 4] = ["at", "when", "if", "for"];
    const SETTING: [&str; 6] = ["let", "suppose", "assume", "take", "consider", "we"];
    let sentence = sentence_around(source, span);
    let sets = |word: &str| SETTING.contains(&&*word.to_lowercase());
    let words: Vec<&str> = sentence.split_whitespace().collect();
    let is_set = words.first().is_some_and(|own| sets(own));
    let is_place = |at: usize| {
        let word = words[at].trim_start_matches('(').to_lowercase();
        let rest = words[at + 1..].iter().skip_while(|own| **own == "time");
        let mut rest = rest.map(|own| own.starts_with(['$', '\\']));
        WHERE.contains(&&*word) && rest.next() == Some(true)
    };
    !is_set && (0..words.len()).any(is_place) && sentence.matches('=').count() > 1
}

/// The sentence in which a formula of the text stands.
fn sentence_around(source: &str, span: Span) -> &str {
    let ends = |(at, c): (usize, char)| {
        let after = source.get(at + 1..).and_then(|rest| rest.chars().next());
        matches!(c, '.' | '?' | '!') && after.is_none_or(|c| c.is_whitespace() || c == ')')
            || c == '\n' && after == Some('\n')
    };
    let before = source.get(..span.start).unwrap_or_default();
    let start = before.char_indices().rev().find(|&own| ends(own));
    let start = start.map_or(0, |(at, _)| at + 1);
    let rest = source.get(span.end..).unwrap_or_default();
    let end = rest
        .char_indices()
        .find(|&(at, c)| ends((span.end + at, c)));
    let end = end.map_or(source.len(), |(at, _)| span.end + at);
    source.get(start..end).unwrap_or_default()
}
