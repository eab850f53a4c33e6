//! Whether prose says that what is displayed next follows: "Hence", "Substituting (3) into (4) gives".

mod announced;
mod going_on;
mod outside;
mod reason;
mod words;

use self::words::{DRAWN, WORKED};
use super::Span;
use super::prose::{Placed, Token, whole};

pub(super) use self::announced::{
    announces_laws, announces_several, defines, replaces, says_what_is_meant, supposes,
};
pub(super) use self::going_on::{goes_on_with_and, is_relative, joins, says_from, tail};
pub(super) use self::reason::{
    divides, laws_named, names_rule_of_factors, puts_condition, reasons_in_words,
};

/// Whether a word, in lower case, draws a conclusion.
pub(super) fn draws(word: &str) -> bool {
    DRAWN.has(word)
}

/// Whether a token is a word that draws a conclusion.
#[inline]
pub(super) fn draws_on(token: Token<'_>) -> bool {
    token.is_among(&DRAWN)
}

/// Whether what is before a verb points back: "this means" draws a conclusion, "break-even means" says what is meant.
pub(super) fn refers(before: &[Placed<'_>]) -> bool {
    let last = before.last();
    last.is_some_and(|(token, _)| token.is_among(&["this", "that", "which", "it"]))
}

/// The last sentence with a word in it.
pub(super) fn last_sentence<'t, 'a>(tokens: &'t [Placed<'a>]) -> Option<&'t [Placed<'a>]> {
    let mut sentences = tokens.split(|(token, _)| token.is_stop());
    sentences.rfind(|sentence| has_words(sentence))
}

fn has_words(sentence: &[Placed<'_>]) -> bool {
    let mut tokens = sentence.iter();
    tokens.any(|(token, _)| matches!(token, Token::Word(_)))
}

/// What leads from a display to the same in other words.
const IN_OTHER_WORDS: [&[&str]; 5] = [
    &["i", "e"],
    &["that", "is"],
    &["in", "other", "words"],
    &["or"],
    &["or", "equivalently"],
];

/// What "from" may come after, or "by", with the display that something comes from.
const FOLLOWING: [&str; 6] = [
    "follows", "follow", "obtained", "found", "solved", "deduced",
];

/// Whether nothing else is said than that the next display says the same: "i.e.", "that is,".
fn says_the_same(sentence: &[Placed<'_>]) -> bool {
    let marks = |(token, _): &&Placed<'_>| !matches!(token, Token::Mark(_) | Token::Stop);
    let words = || sentence.iter().filter(marks);
    IN_OTHER_WORDS.iter().any(|said| {
        let is = |((token, _), word): (&Placed<'_>, &&str)| token.is_among(&[*word]);
        words().count() == said.len() && words().zip(*said).all(is)
    })
}

/// "As a fraction of the initial energy this is": another name for what was displayed.
fn says_it_is(sentence: &[Placed<'_>]) -> bool {
    let begins =
        matches!(sentence, [(own, _), ..] if own.is_among(&["as", "in", "per", "relative"]));
    let ends = matches!(sentence, [.., (this, _), (is, _)]
        if this.is_among(&["this", "that"]) && is.is_among(&["is", "equals"]));
    begins && ends
}

/// Whether a sentence says that what comes after it follows from something, as far as words tell; `None` where nothing is said.
pub(super) fn read(sentence: &[Placed<'_>]) -> Option<bool> {
    if !has_words(sentence) {
        return None;
    }
    if says_the_same(sentence) || says_it_is(sentence) {
        return Some(true);
    }
    let otherwise = |at: usize| {
        let (token, next) = (sentence[at].0, sentence.get(at + 1));
        // "From then on mechanical energy is conserved" tells when.
        let before = at.checked_sub(1).map(|before| sentence[before].0);
        let tells_when = matches!(
            before,
            Some(Token::Word(
                "from" | "From" | "since" | "only" | "till" | "until"
            ))
        );
        // "Momentum is conserved, and so is the energy"
        let adds = |(next, _): &Placed<'_>| next.is_among(&["is", "are", "does", "do"]);
        let source_follows = before.is_some() && token.is_among(&FOLLOWING);
        source_follows && ends_with_from(sentence)
            || token.is_among(&["then"]) && tells_when
            || token.is_among(&["so"]) && next.is_some_and(adds)
            || token.is_among(&["means"]) && !refers(&sentence[..at])
            // "No enzyme gets lost" draws nothing; "one gets" does.
            || token.is_among(&["gets"]) && !before.is_some_and(|own| own.is_among(&["one"]))
    };
    let follows = |at: usize| {
        let token = sentence[at].0;
        // "from which the quantity is", and not "the height from which it falls".
        let from_which =
            || token.is_among(&["which"]) && at == 1 && sentence[0].0.is_among(&["from"]);
        // "We are left with", "This leaves".
        let next_is_with =
            || matches!(sentence.get(at + 1), Some((with, _)) if with.is_among(&["with"]));
        let leaves = token.is_among(&["left"]) && next_is_with()
            || token.is_among(&["leaves"]) && refers(&sentence[..at]);
        let draws = token.is_among(&WORKED) || draws_on(token) || from_which() || leaves;
        draws && !otherwise(at)
    };
    Some((0..sentence.len()).any(follows))
}

/// Whether a sentence ends with "from": what is displayed is what something comes from.
fn ends_with_from(sentence: &[Placed<'_>]) -> bool {
    let words = |(token, _): &&Placed<'_>| matches!(token, Token::Word(_) | Token::Math(_));
    let last = sentence.iter().rev().find(words);
    last.is_some_and(|(token, _)| token.is_among(&["from", "by", "through", "via"]))
}

/// What a sentence cites only to say of what something follows from the display: "The maximum of (5) follows from".
pub(super) fn source_of(sentence: &[Placed<'_>]) -> Option<Span> {
    let at = |own: &Placed<'_>| own.0.is_among(&FOLLOWING);
    let follows = sentence.iter().position(at)?;
    let of = sentence[..follows]
        .iter()
        .position(|(own, _)| own.is_among(&["of"]))?;
    if !ends_with_from(sentence) {
        return None;
    }
    whole(&sentence[of..follows])
}
