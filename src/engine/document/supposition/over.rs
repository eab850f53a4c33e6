//! Sentences that lead on from a case and say that it is over: "For general $x$", "Whatever $x$ is,", "In all other cases", "If this
//! condition is not met,", "Away from $x = 1$,".

use super::super::prose::{Placed, Token, among};
use super::super::words::Words;
use super::super::{Span, Supposition, SuppositionKind};
use super::introduction::goes_on_then;
use super::mathematics::{is_letters, stated, text};

/// After these, what stands there may be anything: "for every value of $x$".
static FREEING: Words = Words::of(&[
    "general",
    "arbitrary",
    "any",
    "every",
    "all",
    "other",
    "whatever",
    "regardless",
    "irrespective",
    "independent",
    "independently",
    "matter",
    "function",
]);
/// Before these, too: "Let $x$ vary".
static FREE: Words = Words::of(&[
    "general",
    "arbitrary",
    "open",
    "free",
    "unrestricted",
    "vary",
    "varies",
    "variable",
]);
/// So many tokens may stand between such a word and what may be anything.
const MOST_BETWEEN: usize = 5;
/// These leave out what comes next.
const LEAVING_OUT: &[&str] = &["away", "apart", "aside", "except", "excluding", "unless"];
/// These no longer suppose what comes next.
const DROPPING: &[&str] = &[
    "dropping", "drop", "relaxing", "relax", "lifting", "lift", "removing", "remove",
];
/// These stand for what was supposed: "If this condition is not met".
const SUPPOSED: &[&str] = &[
    "this",
    "that",
    "it",
    "these",
    "the",
    "condition",
    "conditions",
    "assumption",
    "restriction",
    "case",
];
/// These say of it that it is so.
const MET: &[&str] = &[
    "met",
    "satisfied",
    "fulfilled",
    "true",
    "so",
    "hold",
    "valid",
    "the",
];

/// The cases that are over, sentence by sentence.
pub(super) fn read(source: &str, tokens: &[Placed<'_>]) -> Vec<Supposition> {
    let mut found = Vec::new();
    let mut start = 0;
    for sentence in tokens.split(|(token, _)| token.is_stop()) {
        let end = start + sentence.len();
        if end == tokens.len() || goes_on_then(&tokens[start..]) {
            found.extend(of_sentence(source, sentence));
        }
        start = end + 1;
    }
    found
}

fn of_sentence(source: &str, sentence: &[Placed<'_>]) -> Vec<Supposition> {
    if let Some((kind, body)) = (0..sentence.len()).find_map(|at| left_at(source, sentence, at)) {
        return vec![Supposition { kind, body }];
    }
    let states = |(token, _): &Placed<'_>| stated(source, *token).is_some();
    if sentence.iter().any(states) {
        return Vec::new();
    }
    let freed = (0..sentence.len()).filter_map(|at| freed_at(source, sentence, at));
    let kind = SuppositionKind::Arbitrary;
    freed.map(|body| Supposition { kind, body }).collect()
}

/// The letter that stands at a place, if it may be anything.
fn freed_at(source: &str, sentence: &[Placed<'_>], at: usize) -> Option<Span> {
    let Token::Math(body) = sentence[at].0 else {
        return None;
    };
    let is_near =
        |near: &[Placed<'_>], words: &Words| near.iter().any(|(token, _)| token.is_among(words));
    let before = &sentence[at.saturating_sub(MOST_BETWEEN)..at];
    let after = &sentence[at + 1..sentence.len().min(at + 1 + MOST_BETWEEN)];
    let is_math = |(token, _): &Placed<'_>| matches!(token, Token::Math(_));
    // Of two letters the nearer one is meant.
    let before = &before[before.iter().rposition(is_math).map_or(0, |math| math + 1)..];
    let after = &after[..after.iter().position(is_math).unwrap_or(after.len())];
    let is_free = is_near(before, &FREEING) || is_near(after, &FREE);
    (is_free && is_letters(text(source, body))).then_some(body)
}

/// What words at a place leave behind.
fn left_at(source: &str, sentence: &[Placed<'_>], at: usize) -> Option<(SuppositionKind, Span)> {
    let is = |by: usize, words: &[&str]| among(sentence, at + by, words);
    let skip = |by: usize, words: &[&str]| by + usize::from(is(by, words));
    let span = sentence[at].1;
    let states = |by: usize| {
        let token = sentence.get(at + by).map(|(token, _)| *token);
        token.is_some_and(|token| stated(source, token).is_some())
    };
    match () {
        () if is(0, LEAVING_OUT) => {
            let by = skip(1, &["from", "for", "in", "at", "where"]);
            let case = skip(
                skip(by, &["this", "that", "the"]),
                &["special", "particular"],
            );
            match () {
                () if case > by && is(case, &["case"]) => Some((SuppositionKind::Otherwise, span)),
                () if states(by) => Some((SuppositionKind::Elsewhere, span)),
                () => None,
            }
        }
        () if is(0, DROPPING) && states(1) => Some((SuppositionKind::General, span)),
        () if is(0, &["in"]) && is(1, &["all", "any", "every", "the"]) => {
            let rest = is(2, &["other", "remaining"]) && is(3, &["case", "cases"]);
            let several = !is(1, &["the"]) || is(3, &["cases"]);
            (rest && several).then_some((SuppositionKind::Otherwise, span))
        }
        () if is(0, &["if", "when", "where"]) => {
            let noun = skip(1, SUPPOSED);
            let verb = skip(noun, SUPPOSED);
            let not = skip(verb, &["is", "are", "does", "do"]);
            let denied =
                is(not, &["not"]) && (is(not + 1, MET) || not == 1 && ends(sentence, at + 2));
            (denied && (noun > 1 || not == 1)).then_some((SuppositionKind::Otherwise, span))
        }
        () => None,
    }
}

/// Whether a clause ends at a place.
fn ends(sentence: &[Placed<'_>], at: usize) -> bool {
    sentence.get(at).is_none_or(|(token, _)| token.is_mark(','))
}
