//! What the sentence that leads on to a display names without supposing it plainly: "An object at $g = 2 f$ is thus imaged at", "only
//! the decaying term survives, $C = 0$, and".
//!
//! A step that does not follow otherwise is tried with it. It is said of that display alone.

use super::super::Span;
use super::super::prose::{Placed, Token, ends_sentence};
use super::super::words::Words;
use super::cases::COMPARED;
use super::follows;
use super::mathematics::{is_number, relates};
use super::words::{BESIDE, DISPUTING, KNOWN, NAMED_BEFORE, RETRACTING};

/// In a sentence with one of these, what is named is not so, or one of several.
static ELSEWHERE: Words = Words::of(&[
    "either",
    "neither",
    "nor",
    "otherwise",
    "no",
    "cannot",
    "never",
    "longer",
    "excluding",
    "except",
    "trivial",
    "would",
    "could",
    "might",
    "although",
    "but",
    "difference",
    "earlier",
    "forgot",
    "however",
    "last",
    "neglected",
    "previous",
    "previously",
    "though",
    "violated",
    "violates",
    "was",
    "were",
    "whereas",
    "while",
]);
/// What comes after one of these is so at another time, unless the sentence goes on from it: "The block rises until $m g h = K$, which
/// gives".
static AT_ANOTHER_TIME: Words = Words::of(&["until", "before", "after"]);
/// A sentence that begins with one of these goes on with the one before.
static GOING_ON: Words = Words::of(&["there", "then", "here", "hence", "thus", "therefore", "so"]);
/// No more is taken up.
const MOST_NAMED: usize = 4;

/// The relations in the last sentence, if that goes on with the display after it, and in the one before that it goes on with.
pub(in crate::document) fn read(source: &str, tokens: &[Placed<'_>]) -> Vec<Span> {
    let ends = |token: &Placed<'_>| ends_sentence(source, token) || token.0 == Token::Stop;
    let mut sentences = tokens.rsplit(ends);
    let last = sentences.next().unwrap_or_default();
    let goes_on = last
        .first()
        .is_some_and(|(token, _)| token.is_among(&GOING_ON));
    let before = sentences.next().filter(|_| goes_on).unwrap_or_default();
    let text = |body: Span| source.get(body.range()).unwrap_or_default();
    let mut named = Vec::new();
    for sentence in [before, last] {
        let among = |words: &Words| sentence.iter().any(|(token, _)| token.is_among(words));
        if [
            &COMPARED,
            &DISPUTING,
            &RETRACTING,
            &BESIDE,
            &KNOWN,
            &ELSEWHERE,
        ]
        .into_iter()
        .any(among)
        {
            continue;
        }
        let elsewhen = among(&AT_ANOTHER_TIME);
        named.extend((0..sentence.len()).filter_map(|at| match sentence[at].0 {
            Token::Math(_) if elsewhen && !is_taken_up(at, sentence) => None,
            // "The derivative at $t = 0$" is of that moment alone.
            Token::Math(body) if follows(at, sentence, &NAMED_BEFORE) && is_number(text(body)) => {
                None
            }
            Token::Math(body) => Some(body),
            _ => None,
        }));
    }
    named.retain(|body| relates(text(*body)));
    named.truncate(MOST_NAMED);
    named
}

/// Whether the sentence goes on from the mathematics at `index`: "…, which with (2) gives".
fn is_taken_up(index: usize, sentence: &[Placed<'_>]) -> bool {
    let mut after = sentence[index + 1..].iter().map(|(token, _)| *token);
    match after.next() {
        Some(Token::Mark(',')) => matches!(after.next(), Some(Token::Word("which" | "whence"))),
        _ => false,
    }
}
