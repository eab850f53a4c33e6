//! Cases in words with a value beside them: "In the frictionless case ($\mu = 0$),", "For the special case $a = b$ we have", "Without
//! friction ($\mu = 0$) this becomes".
//!
//! Such a sentence leads on to a display, which is said of that case.

use super::super::prose::{Placed, Token, lead};
use super::super::words::Words;
use super::super::{Supposition, SuppositionKind};
use super::denial::DENIALS;
use super::mathematics::{is_value, relates};
use super::words::{BESIDE, DISPUTING, KNOWN};

/// A sentence about a case begins with one of these.
const BEGINNING: &[&str] = &[
    "for",
    "in",
    "if",
    "when",
    "without",
    "with",
    "on",
    "neglecting",
    "ignoring",
];
/// What is said then: "this becomes", "we have", "one gets", "it is", "equation (1) reads".
const GOING_ON: &[&str] = &["this", "we", "one", "it", "then", "equation", "the"];
/// A sentence with one of these speaks of another case than the one that it names.
pub(super) static COMPARED: Words = Words::of(&[
    "unlike", "contrast", "contrary", "except", "unless", "only", "whether", "or", "than",
    "opposed", "figure",
]);
/// So many words may say what the case is.
const MOST_WORDS: usize = 8;

/// The value in the last sentence, where that names a case with it.
pub(super) fn read(source: &str, tokens: &[Placed<'_>]) -> Option<Supposition> {
    let sentence = tokens.rsplit(|(token, _)| token.is_stop()).next()?;
    // "As a check, for a massless pulley, $M = 0$, this is"
    let sentence = &sentence[lead(sentence)..];
    let mut rest = sentence.iter();
    let (first, _) = rest.next()?;
    let is_word = |token: &&Placed<'_>| matches!(token.0, Token::Word(_));
    let words = rest.clone().take_while(is_word).count();
    let rest = &rest.as_slice()[words..];
    let rest = match rest {
        [(Token::Mark(',' | '('), _), rest @ ..] => rest,
        rest => rest,
    };
    let [(Token::Math(body), _), rest @ ..] = rest else {
        return None;
    };
    let rest = match rest {
        [(Token::Mark(')'), _), rest @ ..] => rest,
        rest => rest,
    };
    let (comma, rest) = match rest {
        [(Token::Mark(','), _), rest @ ..] => (true, rest),
        rest => (false, rest),
    };
    let goes_on = match rest.first() {
        None => comma,
        Some((token, _)) => {
            token.is_among(GOING_ON) || matches!(token, Token::Tag(_) | Token::Keys(_))
        }
    };
    let among = |words: &Words| sentence.iter().any(|(token, _)| token.is_among(words));
    // "For equal springs, $a = b$, (1) says" disputes nothing.
    let mut named = sentence.iter().take(words + 1);
    let disputed = named.any(|(token, _)| token.is_among(&DISPUTING));
    let states = |(token, _): &Placed<'_>| match token {
        Token::Math(other) => source.get(other.range()).is_some_and(relates),
        _ => false,
    };
    let is_case = first.is_among(BEGINNING) && (1..=MOST_WORDS).contains(&words);
    let is_sure = ![&COMPARED, &BESIDE, &KNOWN, &DENIALS]
        .into_iter()
        .any(among)
        && !disputed
        && !rest.iter().any(states);
    let value = source.get(body.range()).is_some_and(is_value);
    (is_case && goes_on && is_sure && value).then_some(Supposition {
        kind: SuppositionKind::Case { runs_on: true },
        body: *body,
    })
}
