//! Cases in words with a value beside them: "In the frictionless case ($\mu = 0$),", "For the special case $a = b$ we have", "Without
//! friction ($\mu = 0$) this becomes".
//!
//! Such a sentence leads on to a display, which is said of that case.

use super::super::prose::{Placed, Token, lead};
use super::super::words::Words;
use super::super::{Supposition, SuppositionKind};
use super::denial::DENIALS;
use super::mathematics::{is_value, stated};
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

/// Whether what is at `index` says which case comes next: "Case 2: $x < 0$.", "Second case ($x < 0$)", "(ii) $x < 0$.", "The case $x < 0$:",
/// or an item of a list begins with it, "- $x < 0$: Then".
pub(super) fn is_labelled(source: &str, index: usize, tokens: &[Placed<'_>]) -> bool {
    let before = &tokens[..index];
    // "Case 2.", "Case 2 ("
    let mark = |token: &Token<'_>| {
        token.is_stop() || matches!(token, Token::Mark(':' | '(' | ']') | Token::Dash)
    };
    let marks = |rest: &[Placed<'_>]| rest.iter().rev().take_while(|(own, _)| mark(own)).count();
    let unmarked = &before[..before.len() - marks(before)];
    let is_marked = unmarked.len() < before.len();
    let begins = |rest: &[Placed<'_>]| {
        let before = rest.iter().rev().map(|(token, _)| *token);
        let mut before =
            before.skip_while(|token| matches!(token, Token::Mark('*' | '[') | Token::Dash));
        before.next().is_none_or(Token::is_stop)
    };
    let is_case = |token: &Token<'_>| token.is_among(&["case"]);
    match unmarked {
        // "Case 2:", "Special case 1:"
        [rest @ .., (case, _), (label, _)] if is_case(case) && is_short(label) => {
            let described = matches!(rest, [.., (own, _)] if own.is_among(&["special"]));
            begins(&rest[..rest.len() - usize::from(described)])
        }
        // "Second case:"
        [rest @ .., (which, _), (case, _)] if is_case(case) && which.is_among(ORDINALS) => {
            is_marked && begins(rest)
        }
        // "The case $x < 0$:"
        [rest @ .., (the, _), (case, _)] if is_case(case) && the.is_among(&["the", "special"]) => {
            !is_marked && begins(rest) && is_set_off(index, tokens)
        }
        [rest @ .., (case, _)] if is_case(case) => begins(rest) && is_set_off(index, tokens),
        [rest @ .., (label @ Token::Tag(_), _)] => is_short(label) && begins(rest),
        // "(ii)"
        [
            rest @ ..,
            (Token::Mark('('), _),
            (label, _),
            (Token::Mark(')'), _),
        ] => is_short(label) && begins(rest),
        _ => begins_item(source, before) && is_set_off(index, tokens),
    }
}

/// "1", "ii", "B".
fn is_short(label: &Token<'_>) -> bool {
    match label {
        Token::Number(_) => true,
        Token::Word(label) | Token::Tag(label) => {
            let is_roman = label
                .chars()
                .all(|c| matches!(c, 'i' | 'v' | 'x' | 'I' | 'V' | 'X'));
            is_roman || label.len() == 1 && label.starts_with(char::is_alphabetic)
        }
        _ => false,
    }
}

/// Whether an item of a list begins after these: "- ", "1. ", `\item`.
fn begins_item(source: &str, before: &[Placed<'_>]) -> bool {
    let starts = |rest: &[Placed<'_>]| rest.last().is_none_or(|(token, _)| token.is_stop());
    match before {
        [rest @ .., (Token::Dash, _)] => starts(rest),
        [rest @ .., (Token::Number(_), _), (Token::Stop, _)] => starts(rest),
        [.., (Token::Stop, item)] => {
            (source.get(item.range())).is_some_and(|own| own.starts_with("\\item"))
        }
        _ => false,
    }
}

/// Whether what is at `index` is all that is said of a case, and something of it comes next: "$x < 0$. Then", "$x < 0$: Here".
fn is_set_off(index: usize, tokens: &[Placed<'_>]) -> bool {
    let rest = &tokens[index + 1..];
    let marks = rest
        .iter()
        .take_while(|(token, _)| token.is_stop() || matches!(token, Token::Mark(':' | ')' | ',')))
        .count();
    marks > 0 && marks < rest.len()
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
        Some((token, _)) => token.is_among(GOING_ON) || token.cites(),
    };
    let among = |words: &Words| sentence.iter().any(|(token, _)| token.is_among(words));
    // "For equal springs, $a = b$, (1) says" disputes nothing.
    let mut named = sentence.iter().take(words + 1);
    let disputed = named.any(|(token, _)| token.is_among(&DISPUTING));
    let states = |(token, _): &Placed<'_>| stated(source, *token).is_some();
    let is_case = first.is_among(BEGINNING) && (1..=MOST_WORDS).contains(&words);
    let is_sure = ![&COMPARED, &BESIDE, &KNOWN, &DENIALS]
        .into_iter()
        .any(among)
        && !disputed
        && !rest.iter().any(states);
    let value = source.get(body.range()).is_some_and(is_value);
    (is_case && goes_on && is_sure && value).then_some(Supposition {
        kind: SuppositionKind::case(true),
        body: *body,
    })
}
