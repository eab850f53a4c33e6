//! What stands around mathematics in its sentence: whether the words before it and after it make it a value, a name, or a place.

use super::super::Span;
use super::super::prose::{Placed, Token};
use super::super::words::Listed;
use super::introduction::MOST_DESCRIBING;
use super::mathematics::{equals_a_name, is_bound, is_number, is_value};
use super::reach::Reach;
use super::words::{KNOWN, NAMED_AFTER, NAMED_BEFORE};

/// What something is that comes "from" something.
const FOUND: [&str; 12] = [
    "follows",
    "follow",
    "results",
    "result",
    "found",
    "obtained",
    "derived",
    "determined",
    "calculated",
    "computed",
    "deduced",
    "known",
];

/// Whether one of these words, in lower case, stands before what is at `index`.
pub(super) fn follows(index: usize, tokens: &[Placed<'_>], words: &(impl Listed + ?Sized)) -> bool {
    let before = index.checked_sub(1).and_then(|before| tokens.get(before));
    before.is_some_and(|(token, _)| token.is_among(words))
}

pub(super) fn follows_comma(index: usize, tokens: &[Placed<'_>]) -> bool {
    let before = index.checked_sub(1).map(|before| tokens[before].0);
    before == Some(Token::Mark(','))
}

/// Whether the words before the mathematics at `index` say that something is found from it: "follows from $y = 0$", "the time after which
/// $y = 0$", "flies until $y = 0$".
pub(super) fn says_where(index: usize, tokens: &[Placed<'_>]) -> bool {
    let is_before = |by: usize, words: &[&str]| {
        let before = index.checked_sub(by).and_then(|before| tokens.get(before));
        before.is_some_and(|(token, _)| token.is_among(words))
    };
    is_before(1, &["until", "till"])
        || is_before(1, &["which"]) && is_before(2, &["at", "after", "for"])
        || is_before(1, &["from"]) && is_before(2, &FOUND)
}

/// Before the name of a place.
const PLACING: [&str; 6] = ["at", "from", "to", "near", "on", "until"];
/// A place is named in no more words, "the" and what stands before that among them: "from the outer edge".
const MOST_OF_A_PLACE: usize = 5;

/// Whether the words before the mathematics at `index` say that it is known: "we are told that", "was measured to be".
pub(super) fn tells_that(index: usize, tokens: &[Placed<'_>]) -> bool {
    let word = |by: usize| match index.checked_sub(by).and_then(|at| tokens.get(at)) {
        Some((token @ Token::Word(_), _)) => Some(*token),
        _ => None,
    };
    let is = |by: usize, words: &[&str]| word(by).is_some_and(|own| own.is_among(words));
    let is_known = |by: usize| word(by).is_some_and(|own| own.is_among(&KNOWN));
    if is(1, &["that"]) {
        let mut before = (2..=MOST_DESCRIBING + 2).take_while(|&by| word(by).is_some());
        return before.any(is_known);
    }
    // "We measured $h = 1.20\,\mathrm{m}$"
    is(1, &["be"]) && is(2, &["to"]) && is_known(3)
        || is(1, &["measured"]) && is(2, &["we", "i", "have"])
}

/// Whether mathematics stands two tokens before what is at `index`: one word is between them.
pub(super) fn ends_before(body: Span, index: usize, tokens: &[Placed<'_>]) -> bool {
    let before = index.checked_sub(2).and_then(|before| tokens.get(before));
    matches!(before, Some((Token::Math(own), _)) if *own == body)
}

/// Whether what stands before the mathematics at `index` makes it a fact of its own: "For a target at rest, $u_2 = 0$, …".
pub(super) fn is_plain(index: usize, tokens: &[Placed<'_>]) -> bool {
    let before = index.checked_sub(1).map(|before| tokens[before].0);
    matches!(before, Some(Token::Mark(',')) | None)
        || follows(index, tokens, &["with", "since", "because", "using", "is"])
}

/// Whether a clause says no more than that nothing changes: "In equilibrium $J = 0$", "and in the steady state $J = 0$".
pub(super) fn is_at_rest(before: &[Placed<'_>]) -> bool {
    let is = |at: usize, words: &[&str]| {
        let at = before.len().checked_sub(at);
        at.is_some_and(|at| before[at].0.is_among(words))
    };
    let named = match () {
        () if is(1, &["equilibrium"]) => 1,
        () if is(1, &["state"]) && is(2, &["steady", "stationary"]) => 2,
        () => return false,
    };
    let article = usize::from(is(named + 1, &["the", "a", "thermal"]));
    is(named + article + 1, &["in", "at"])
}

/// Whether the mathematics at `index` is told where something begins, or what it is called, and supposed to be no value.
///
/// "With $g = G M/R^2$ at the surface" is a value: an origin is a number.
pub(super) fn is_origin(index: usize, math: &str, reach: Reach, tokens: &[Placed<'_>]) -> bool {
    let starts = || reach == Reach::Sentence && follows(index, tokens, &NAMED_BEFORE);
    let after = tokens.get(index + 1).map(|(token, _)| *token);
    let placed = matches!(after, Some(Token::Word("at" | "when"))) && !is_number(math);
    // "Let $v > 0$ be the speed" names it and says its sign, "Let $\mu = a b$ be the reduced mass" what it is.
    let named = || is_named(index, tokens) && !placed && !is_bound(math);
    named() && (is_number(math) || equals_a_name(math)) || starts()
}

/// Whether what comes after the mathematics at `index` says for which number it is so: "$q = q_0$ at $t = 0$".
pub(super) fn is_at_a_value(source: &str, index: usize, tokens: &[Placed<'_>]) -> bool {
    let rest = tokens.get(index + 1..).unwrap_or_default();
    let [(first, _), rest @ ..] = rest else {
        return false;
    };
    let skipped = rest
        .iter()
        .take_while(|(token, _)| token.is_among(&["the", "time", "place", "point"]))
        .count();
    let place = rest.get(skipped).map(|(token, _)| *token);
    first.is_among(&["at", "when"])
        && matches!(place, Some(Token::Math(body))
            if source.get(body.range()).is_some_and(|text| is_value(text) && is_number(text)))
}

/// Whether what comes after the mathematics at `index` says at which place it is so: "Setting $F = m g$ at $v = u$", "$R = 2 b$, at $z = b$".
pub(super) fn is_at_a_place(source: &str, index: usize, tokens: &[Placed<'_>]) -> bool {
    let rest = match tokens.get(index + 1..).unwrap_or_default() {
        [(Token::Mark(','), _), rest @ ..] | rest => rest,
    };
    matches!(rest, [(Token::Word("at"), _), (Token::Math(body), _), ..]
        if source.get(body.range()).is_some_and(is_value))
}

/// Whether what comes after the mathematics at `index` makes it a name.
pub(super) fn is_named(index: usize, tokens: &[Placed<'_>]) -> bool {
    match tokens.get(index + 1) {
        Some((Token::Word(word), _)) => NAMED_AFTER.has(word),
        _ => false,
    }
}

/// Whether the relation that tokens begin with is said to come from a display: "Substituting $w = u - v$ from (2) into (1)". That supposes
/// nothing, and the step that goes on from it follows from the display.
pub(super) fn is_taken_from(tokens: &[Placed<'_>]) -> bool {
    leads_to_citation(tokens, &["from"])
}

/// Whether an equation is cited after the mathematics that tokens begin with, and one of these words: "$m = 0$ in (1)", "$x = 1$ into
/// equation (2)".
pub(super) fn leads_to_citation(tokens: &[Placed<'_>], by: &[&str]) -> bool {
    let [_, (Token::Word(word), _), on @ ..] = tokens else {
        return false;
    };
    let words = |(token, _): &&Placed<'_>| matches!(token, Token::Word(_));
    let cited = on.iter().take(MOST_DESCRIBING).find(|own| !words(own));
    by.contains(word) && cited.is_some_and(|(token, _)| token.cites())
}

/// Whether mathematics says what is so at a place that has no symbol: "from the rim, where $p = p_0$".
pub(super) fn is_said_of_a_place(source: &str, body: Span) -> bool {
    let before = source.get(..body.start).unwrap_or_default();
    let before = before.trim_end_matches(['$', '(', '\\', '`', ' ', '\n', '~']);
    let Some(before) = before.strip_suffix("where") else {
        return false;
    };
    let Some(before) = before.trim_end().strip_suffix(',') else {
        return false;
    };
    let mut words = before.split_whitespace().rev().take(MOST_OF_A_PLACE);
    let is_noun = |word: &str| word.chars().all(|c| c.is_alphabetic() || c == '-');
    let named: Vec<&str> = words.by_ref().take_while(|own| *own != "the").collect();
    let leads = words.next();
    !named.is_empty()
        && named.into_iter().all(is_noun)
        && leads.is_some_and(|own| PLACING.contains(&&*own.to_lowercase()))
}
