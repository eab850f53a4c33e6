//! Special cases that nobody has left in so many words, and perhaps in thought: "In the special case $a = b$, (1) becomes $$…$$", and then
//! a step from (1) that follows only if $a = b$.
//!
//! A case is still meant where a step cites what was concluded in it, cites nothing and goes on from the display before, or says "then".
//! Where it does none of these, what follows in the case alone is left open: it may be said of all.

use crate::algebra::{Expr, Formula, Symbol};
use crate::derivation::{Assumed, Equation, Goal, Local, Source};
use crate::document::Extent;
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
            return self.of_another_paragraph(found);
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
        let turns = self.turns_to_something(found);
        let mut assumed = found.judged.assumed.iter();
        let case = assumed.find_map(|own| match own.source {
            Source::Local(page, local) => {
                let place = (page, local);
                let is_over = is_left(&place)
                    || self.is_carried_by_nothing(place, found, premises)
                    || turns && self.is_told_of_another_case(place, goal)
                    || self.is_said_otherwise(place);
                is_over.then_some(place)
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
            None if turns => self.displayed_of_a_moment(found, premises),
            None => None,
        }
    }

    /// The special case that a step needs which cites nothing, where a paragraph with a title of its own begins between the two: "**Nearly equal
    /// periods.** Bessel noticed".
    fn of_another_paragraph(&self, found: &Found) -> Option<String> {
        let own = &self.derivation.equations[self.at];
        let source = &self.derivation.pages[own.page].document.source;
        let mut assumed = found.judged.assumed.iter();
        assumed.find_map(|assumed| {
            let Source::Local(page, local) = assumed.source else {
                return None;
            };
            let local = self.derivation.local(page, local);
            let between = source.get(local.span.end..own.span.start)?;
            let is_left = page == own.page && local.is_of_special_case() && has_title(between);
            let said = source.get(local.span.range())?;
            (is_left && !local.means).then(|| said.to_owned())
        })
    }

    /// Whether a hypothesis is not in effect where the step stands, and nothing that the step cites or follows from was concluded under it.
    fn is_carried_by_nothing(
        &self,
        place: (usize, usize),
        found: &Found,
        premises: &[usize],
    ) -> bool {
        let own = &self.derivation.equations[self.at];
        let in_effect = || own.locals.iter().chain(&own.told).chain(&own.named);
        let is_here = own.page == place.0 && in_effect().any(|&local| local == place.1);
        let carries = |premise: &usize| {
            let offer = self.auditor.offer(self.at, *premise);
            offer.is_some_and(|own| own.under.contains(&place))
        };
        let used = found
            .judged
            .assumed
            .iter()
            .filter_map(|own| match own.source {
                Source::Equation(premise) => Some(premise),
                _ => None,
            });
        !is_here && !premises.iter().any(carries) && !used.into_iter().any(|own| carries(&own))
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

    /// What is displayed and not cited, said of one moment: "Initially, at $t = 0$, we have $$x = 0$$"
    fn displayed_of_a_moment(&self, found: &Found, premises: &[usize]) -> Option<String> {
        let is_of_moment = |own: &&Assumed| match own.source {
            Source::Equation(premise) => {
                !premises.contains(&premise)
                    && self.derivation.equations[premise].told_extent == Extent::Moment
            }
            _ => false,
        };
        let mut assumed = found.judged.assumed.iter();
        assumed
            .find(is_of_moment)
            .map(|own| plain_formula(&own.formula))
    }

    /// Whether a step that was proved is of something that its last sentence says the meaning of, and does not go on from what is said before:
    /// "The area $A = x^2$ is, by (1),".
    fn turns_to_something(&self, found: &Found) -> bool {
        let equation = &self.derivation.equations[self.at];
        let Some(last) = equation.said_last else {
            return false;
        };
        let is_named = |own: &Assumed| match own.source {
            Source::Local(page, local) => {
                let local = self.derivation.local(page, local);
                local.is_told && local.span.start >= last.start
            }
            _ => false,
        };
        let source = &self.derivation.pages[equation.page].document.source;
        found.judged.assumed.iter().any(is_named)
            && !goes_on(source.get(last.range()).unwrap_or_default())
    }

    /// Whether a hypothesis is part of what a sentence says of a place or a case that stands after the display before and is not the last:
    /// "At $t = 1$ the body is at $x = v$."
    fn is_told_of_another_case(&self, place: (usize, usize), goal: &Goal) -> bool {
        let equation = &self.derivation.equations[self.at];
        let own = self.derivation.local(place.0, place.1);
        !own.means
            && !is_of_example(own, goal)
            && own.is_equation()
            && equation.page == place.0
            && (equation.said_last).is_some_and(|last| own.span.end <= last.start)
            && self.derivation.is_said_since(self.at, own.span)
            && self.derivation.is_said_of_a_place(place)
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
        if local.means || is_of_example(local, goal) {
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

/// Whether a paragraph begins in a text with words in bold that end in a full stop or a colon.
fn has_title(text: &str) -> bool {
    let mut lines = text.lines();
    lines.any(|line| {
        let marks = [("**", "**"), ("__", "__"), ("\\textbf{", "}")];
        let title = marks.into_iter().find_map(|(open, close)| {
            let (title, rest) = line.trim_start().strip_prefix(open)?.split_once(close)?;
            Some((title.trim_end(), rest))
        });
        let ends = |own: &str| own.ends_with(['.', ':']);
        title.is_some_and(|(title, rest)| ends(title) || rest.starts_with(['.', ':']))
    })
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
            value => value.free_symbols().iter().any(Symbol::is_unit) && is_number(own),
        })
    };
    is_number(&goal.formula) && local.formulas.iter().any(|own| sets_number(own))
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
