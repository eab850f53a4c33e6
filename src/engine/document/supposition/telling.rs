//! What a sentence tells in passing, and supposes nothing by: a fact, what is known, what is so at one moment.

use super::super::prose::{Token, in_lower_case};
use super::super::words::Words;
use super::super::{Extent, Span, SuppositionKind, circumstance};
use super::around::{
    ends_before, follows, is_at_a_place, is_at_a_value, is_at_rest, is_named, is_plain, tells_that,
};
use super::denial::DENIALS;
use super::mathematics::{differs, is_bound, is_number, is_value, relates};
use super::reason::finds_constant;
use super::words::{HYPOTHETICAL, MOMENTARY, NAMED_AFTER, NAMED_BEFORE, REASONS, UNDECIDED};
use super::{Reader, is_fact};

/// With these circumstances become formulas.
static FROM_WORDS: Words = Words::of(&[
    "so",
    "hence",
    "thus",
    "therefore",
    "means",
    "implies",
    "requires",
    "condition",
    "constraint",
    "says",
    "states",
    "demands",
]);

/// In a sentence with more words and formulas nothing is told.
const LONGEST_SENTENCE: usize = 200;

impl Reader<'_> {
    /// Whether the sentence introduces the letter at `index`: "Let $v$ be", "Here $v$ denotes".
    pub(super) fn introduces(&self, index: usize) -> bool {
        let lets = matches!(self.sentence.active, Some((SuppositionKind::Let, _)));
        match self.tokens.get(index + 1) {
            Some((Token::Word(word), _)) => {
                lets && NAMED_AFTER.has(word) || matches!(*word, "denotes" | "denote")
            }
            _ => false,
        }
    }

    /// Whether what the sentence says before the token at `index` is said of one moment or place; in doubt it is.
    pub(super) fn is_of_moment(&self, index: usize) -> bool {
        let before = self
            .tokens
            .get(self.sentence.first..index)
            .unwrap_or_default();
        if before.len() > LONGEST_SENTENCE {
            return true;
        }
        // A moment of inertia is none.
        let is_of = |at: usize| {
            let next = before.get(at + 1);
            before[at].0.is_among(&["moment"]) && next.is_some_and(|(own, _)| own.is_among(&["of"]))
        };
        let names = |at: usize| before[at].0.is_among(&MOMENTARY) && !is_of(at);
        (0..before.len()).any(names) || circumstance::of_sentence(before) == Extent::Moment
    }

    /// Whether the sentence tells what number something is at one moment: "At the turning points $v = 0$, so".
    pub(super) fn is_momentary(&self, index: usize, body: Span) -> bool {
        let text = self.text(body);
        let own = &self.sentence;
        let is_value = is_value(text) && is_number(text) && !is_named(index, self.tokens);
        if !is_value || own.active.is_some() || own.doubtful || own.concluded || !own.begun {
            return false;
        }
        match self.is_silent() {
            true => {
                let before = &self.tokens[own.first..index];
                let says = matches!(before.last(), Some((Token::Word(_) | Token::Mark(','), _)));
                let is_place = follows(index, self.tokens, &NAMED_BEFORE);
                says && !is_place && circumstance::of_sentence(before) == Extent::Moment
            }
            false => self.joins(index, |kind| kind == SuppositionKind::Moment),
        }
    }

    /// Whether the sentence tells plainly that a relation is known.
    pub(super) fn is_known(&self, index: usize) -> bool {
        let own = &self.sentence;
        if own.active.is_some() || own.doubtful || !own.factual || is_named(index, self.tokens) {
            return false;
        }
        tells_that(index, self.tokens) || self.joins(index, |kind| kind == SuppositionKind::Known)
    }

    /// Whether an "and" joins the mathematics at `index` to what was supposed just before it, if that is of such a kind.
    fn joins(&self, index: usize, is: impl Fn(SuppositionKind) -> bool) -> bool {
        let last = self.found.last().filter(|last| is(last.kind));
        follows(index, self.tokens, &["and"])
            && last.is_some_and(|last| ends_before(last.body, index, self.tokens))
    }

    /// Whether the sentence ends with an equation that it draws from circumstances, and from no formula: "The string does not slip, so
    /// $a = R \alpha$."
    pub(super) fn draws_from_words(&self, index: usize, body: Span) -> bool {
        let (own, text) = (&self.sentence, self.text(body));
        let is_equation = is_value(text) && !is_number(text) && !is_bound(text);
        let ends = (self.tokens.get(index + 1)).is_none_or(|(token, _)| token.is_stop());
        let before = &self.tokens[own.first..index];
        if own.active.is_some() || own.doubtful || own.special || !is_equation || !ends {
            return false;
        }
        let Some(drawn) = (before.iter()).rposition(|(token, _)| token.is_among(&FROM_WORDS))
        else {
            return false;
        };
        let is_formula = |token: Token<'_>| match token {
            Token::Math(body) => relates(self.text(body)),
            token => token.cites(),
        };
        let is_open = |token: Token<'_>| match token {
            Token::Word(word) => {
                let word = in_lower_case(word);
                UNDECIDED.has(&word) || HYPOTHETICAL.has(&word)
            }
            _ => false,
        };
        let denies = |token: Token<'_>| token.is_among(&DENIALS);
        !before
            .iter()
            .any(|(token, _)| is_formula(*token) || is_open(*token))
            && !before[drawn.saturating_sub(1)..]
                .iter()
                .any(|(token, _)| denies(*token))
            && !self.is_of_moment(index)
    }

    /// Whether the sentence tells that a constant of integration is nought.
    pub(super) fn finds_constant(&self, body: Span) -> bool {
        let own = &self.sentence;
        !own.doubtful && own.active.is_none() && finds_constant(self.source, body)
    }

    /// Whether a relation is a fact that the sentence tells in passing.
    pub(super) fn tells(&self, index: usize, body: Span) -> bool {
        let (own, text) = (&self.sentence, self.text(body));
        if own.active.is_some() || own.doubtful || !own.factual {
            return false;
        }
        // "At $\mu = 1$, $\eta = 1$" says what follows there.
        let mut others = self.found[own.start..].iter();
        let follows_here =
            own.concluded || others.any(|s| !is_fact(s.kind) && !s.kind.leaves_cases());
        if follows_here && !follows(index, self.tokens, &REASONS) {
            return false;
        }
        // "as it is for $x = 0$" compares, "for $x > 0$ it grows" goes through cases.
        let bounds = is_bound(text) && !differs(text);
        let plainly = match is_number(text) && !bounds {
            true => {
                // What a slope is there is said of a moment.
                let is_slope = text.contains("\\frac") || text.contains("dot");
                is_plain(index, self.tokens)
                    || !is_slope && is_at_rest(&self.tokens[own.first..index])
                    || self.joins(index, is_fact)
            }
            false => !(bounds && follows(index, self.tokens, &["for"])),
        };
        // "which starts with $I = I_0$ at $t = 0$" is so then.
        let is_then = is_at_a_value(self.source, index, self.tokens)
            || is_at_a_place(self.source, index, self.tokens);
        // "The magnification $M = f/s$ is": what is no number is no origin.
        let is_name = is_number(text) && is_named(index, self.tokens);
        plainly && !is_name && !is_then && !follows(index, self.tokens, &NAMED_BEFORE)
    }
}
