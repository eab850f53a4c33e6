//! What a sentence announces: several laws, or what is meant by something.

use super::super::prose::{Placed, Token};
use super::super::words::Words;
use super::draws_on;
use super::words::DEFINING;

/// Of these several are announced together: "The two conditions of equilibrium are".
static SEVERAL: Words = Words::of(&[
    "equations",
    "relations",
    "laws",
    "conditions",
    "constraints",
    "formulas",
    "formulae",
    "principles",
    "rules",
    "balances",
]);

/// Whether the last sentence announces several laws, and draws them from nothing: "The two conditions are", "We have the following
/// equations.", "$a$ and $b$ are defined by".
pub(in crate::document) fn announces_laws(last: &[Placed<'_>], concludes: Option<bool>) -> bool {
    if concludes != Some(false) {
        return false;
    }
    let has = |words: &[&'static str]| last.iter().any(|(token, _)| token.is_among(words));
    let ends = last.iter().rev().find_map(|(token, _)| match token {
        Token::Word(word) => Some(*word),
        _ => None,
    });
    let cites = |(token, _): &Placed<'_>| token.cites();
    // "The semi-major axis $a$ and the eccentricity $e$ are defined through"
    let symbols = last.iter().filter(|own| matches!(own.0, Token::Math(_)));
    let defines = has(&["are"]) && has(&["defined"]) && symbols.count() > 1;
    let announces = ends == Some("are") || has(&["following"]);
    (defines || announces && last.iter().any(|(token, _)| token.is_among(&SEVERAL)))
        && !last.iter().any(cites)
}

/// Whether the last sentence announces several things by their names, "The variance and the optimal share are".
pub(in crate::document) fn announces_several(last: &[Placed<'_>]) -> bool {
    let has = |word: &'static str| last.iter().any(|(token, _)| token.is_among(&[word]));
    let plain = |(token, _): &Placed<'_>| {
        matches!(token, Token::Word(_) | Token::Math(_) | Token::Mark(','))
    };
    matches!(last, [.., (are, _)] if are.is_among(&["are"])) && has("and") && last.iter().all(plain)
}

/// With one of these a clause ends that says what something is.
const NAMES: [&str; 4] = ["is", "are", "denotes", "means"];

/// Whether nothing but a "where" or "with" leads on to the display, or a "where" with the name of something: "where the initial energy
/// is". It says what is meant in the one before.
pub(in crate::document) fn says_what_is_meant(tokens: &[Placed<'_>]) -> bool {
    let mut said = tokens
        .iter()
        .filter(|(token, _)| !matches!(token, Token::Mark(',' | ';' | ':')));
    let first = said.next().map(|(token, _)| *token);
    let plain = |(token, _): &Placed<'_>| matches!(token, Token::Word(_)) && !draws_on(*token);
    match first {
        Some(Token::Word("where")) => {
            let last = said.clone().next_back();
            said.all(plain) && last.is_none_or(|(last, _)| last.is_among(&NAMES))
        }
        Some(Token::Word("with")) => said.next().is_none(),
        _ => false,
    }
}

/// A sentence that ends with one of these supposes what it displays.
const SUPPOSING: [&str; 10] = [
    "let",
    "suppose",
    "assume",
    "choose",
    "require",
    "demand",
    "impose",
    "prescribe",
    "if",
    "provided",
];
/// A sentence that ends with one of these, and perhaps an "is", says what is displayed of its own accord.
const IMPOSED: [&str; 4] = ["constraint", "condition", "restriction", "given"];

/// Whether the last sentence supposes what comes after it: "Now let", "We require that", "No current flows if", "The constraint is".
pub(in crate::document) fn supposes(last: &[Placed<'_>]) -> bool {
    let words = |(token, _): &&Placed<'_>| matches!(token, Token::Word(_));
    let plain = |(token, _): &&Placed<'_>| token.is_among(&["that", "is", "reads"]);
    let end = last.iter().rev().take_while(|own| plain(own)).count();
    let Some((before, [(verb, _)])) = last[..last.len() - end].split_last_chunk::<1>() else {
        return false;
    };
    let denied = before
        .iter()
        .any(|(token, _)| token.is_among(&["not", "never", "cannot", "no"]));
    let draws = before.iter().any(|(token, _)| draws_on(*token));
    let is_verb = verb.is_among(&SUPPOSING)
        || verb.is_among(&IMPOSED) && before.iter().all(|own| words(&own));
    // "No current flows if"
    let is_condition = verb.is_among(&["if", "provided"]);
    // "It is zero if" says what is to be solved for.
    let vanishes = before
        .iter()
        .any(|(token, _)| token.is_among(&["zero", "vanishes", "vanish"]));
    is_verb && !draws && !vanishes && (is_condition || !denied)
}

/// Whether the last sentence says that what comes after it takes the place of what it cites: "With friction (1) is replaced by", "Instead of
/// (1) we have".
pub(in crate::document) fn replaces(last: &[Placed<'_>]) -> bool {
    let cites = |(token, _): &Placed<'_>| token.cites();
    let words = |(token, _): &&Placed<'_>| matches!(token, Token::Word(_));
    let mut from_end = last.iter().rev().filter(words);
    let ends = |own: Option<&Placed<'_>>, words: &[&str]| {
        own.is_some_and(|(token, _)| token.is_among(words))
    };
    let replaced = ends(from_end.next(), &["by", "with"]) && ends(from_end.next(), &["replaced"]);
    let instead = || {
        let mut all = last.windows(3);
        all.any(|own| match own {
            [(one, _), (of, _), cited] => {
                let instead = one.is_among(&["instead", "place"]) && of.is_among(&["of"]);
                instead && cites(cited)
            }
            _ => false,
        })
    };
    replaced && last.iter().any(cites) || instead()
}

/// Whether the last sentence says what is meant by what comes after it.
pub(in crate::document) fn defines(last: &[Placed<'_>], concludes: Option<bool>) -> bool {
    // "From the definition of restitution it follows that" defines nothing.
    let is_reason = concludes == Some(true);
    let defining = |(token, _): &Placed<'_>| {
        token.is_among(&DEFINING) && !(is_reason && token.is_among(&["definition"]))
    };
    last.iter().any(defining)
}
