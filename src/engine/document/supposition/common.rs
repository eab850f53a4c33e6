//! A name for what several quantities have in common: "Call their common value $u$".

use super::super::prose::{Placed, Token};
use super::super::{Supposition, SuppositionKind};
use super::mathematics::is_letters;

const COMMON: [&str; 2] = ["common", "shared"];
/// Between "the common velocity" and its name: "denote the common velocity by $u$".
const NAMED_BY: [&str; 4] = ["by", "is", "be", "as"];
/// Between a name and "the common velocity": "where $u$ is their common velocity".
/// What is common to terms, and no value of theirs: "with the common denominator $d$".
const NO_VALUES: [&str; 5] = ["denominator", "factor", "divisor", "multiple", "base"];
const BEING: [&str; 5] = ["is", "be", "denotes", "denote", "for"];

/// The letters by which something is named that is common to what was displayed before.
pub(super) fn read(source: &str, tokens: &[Placed<'_>]) -> Vec<Supposition> {
    let among = |at: Option<usize>, words: &[&str]| {
        at.and_then(|at| tokens.get(at))
            .is_some_and(|own| own.0.is_among(words))
    };
    let names = |at: usize| {
        let by = among(at.checked_sub(1), &NAMED_BY);
        let noun = at.checked_sub(1 + usize::from(by));
        let is_word = noun.is_some_and(|noun| matches!(tokens[noun].0, Token::Word(_)));
        let before = is_word && among(noun.and_then(|noun| noun.checked_sub(1)), &COMMON);
        let after = among(Some(at + 1), &BEING) && among(Some(at + 3), &COMMON);
        before && !among(noun, &NO_VALUES) || after && !among(Some(at + 4), &NO_VALUES)
    };
    let letters = tokens
        .iter()
        .enumerate()
        .filter_map(|(at, own)| match own.0 {
            Token::Math(body) if names(at) => Some(body),
            _ => None,
        });
    let is_letter = |body: &_| {
        let text = |body: super::Span| source.get(body.range()).unwrap_or_default();
        is_letters(text(*body)) && !text(*body).contains(',')
    };
    letters
        .filter(is_letter)
        .map(|body| Supposition {
            kind: SuppositionKind::Common,
            body,
        })
        .collect()
}
