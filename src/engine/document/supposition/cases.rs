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
/// Which of several cases comes next.
const ORDINALS: &[&str] = &["first", "second", "third", "fourth", "last", "other"];
/// A sentence with one of these speaks of another case than the one that it names.
pub(super) static COMPARED: Words = Words::of(&[
    "unlike", "contrast", "contrary", "except", "unless", "only", "whether", "or", "than",
    "opposed", "figure",
]);
/// So many words may say what the case is.
const MOST_WORDS: usize = 8;

/// Whether the mathematics at `index` says which case comes next: "Case 2: $x < 0$.", "Second case. $x < 0$", "(ii) $x < 0$.".
pub(super) fn is_labelled(index: usize, tokens: &[Placed<'_>]) -> bool {
    let mark = |(token, _): &Placed<'_>| matches!(token, Token::Mark(':') | Token::Stop);
    let marks = |rest: &[Placed<'_>]| rest.iter().rev().take_while(|own| mark(own)).count();
    let begins = |rest: &[Placed<'_>]| {
        let before = rest.iter().rev().map(|(token, _)| *token);
        let mut before = before.skip_while(|token| matches!(token, Token::Mark('*') | Token::Dash));
        before.next().is_none_or(Token::is_stop)
    };
    let short = |token: &Token<'_>| match token {
        Token::Number(_) => true,
        Token::Word(label) | Token::Tag(label) => {
            let is_roman = label
                .chars()
                .all(|c| matches!(c, 'i' | 'v' | 'x' | 'I' | 'V' | 'X'));
            is_roman || label.len() == 1 && label.starts_with(char::is_alphabetic)
        }
        _ => false,
    };
    let before = &tokens[..index];
    let unmarked = &before[..before.len() - marks(before)];
    match unmarked {
        // "Case 2:", "Special case 1:"
        [rest @ .., (case, _), (label, _)] if case.is_among(&["case"]) && short(label) => {
            let described = matches!(rest, [.., (own, _)] if own.is_among(&["special"]));
            begins(&rest[..rest.len() - usize::from(described)])
        }
        // "Second case:"
        [rest @ .., (which, _), (case, _)] if case.is_among(&["case"]) => {
            unmarked.len() < before.len() && which.is_among(ORDINALS) && begins(rest)
        }
        [rest @ .., (label @ Token::Tag(_), _)] => short(label) && begins(rest),
        // "(ii)"
        [
            rest @ ..,
            (Token::Mark('('), _),
            (label, _),
            (Token::Mark(')'), _),
        ] => short(label) && begins(rest),
        _ => false,
    }
}

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
