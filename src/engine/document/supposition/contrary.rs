//! Proofs by contradiction: "Suppose, on the contrary, that $a = d$. Then", and where that is over: "which contradicts (1)".
//!
//! What is supposed for the sake of a contradiction is a case that ends with it.

use super::super::prose::{Placed, ends_sentence};
use super::super::words::Words;
use super::super::{Supposition, SuppositionKind};
use super::mathematics::stated;

/// These suppose.
const SUPPOSING: &[&str] = &["suppose", "assume", "assuming"];
/// With one of these it is for the sake of a contradiction.
const CONTRARY: &[&str] = &["contrary", "contradiction"];
/// These say that what was supposed cannot be.
static CONTRADICTED: Words = Words::of(&[
    "contradiction",
    "contradicts",
    "contradicting",
    "contradictory",
    "absurd",
    "impossible",
]);

/// What the sentences suppose for the sake of a contradiction, and where they say that it is reached, in order.
pub(super) fn read(source: &str, tokens: &[Placed<'_>]) -> Vec<Supposition> {
    let says = |(token, _): &Placed<'_>| token.is_among(&CONTRADICTED) || token.is_among(CONTRARY);
    if !tokens.iter().any(says) {
        return Vec::new();
    }
    let mut found = Vec::new();
    for sentence in tokens.split_inclusive(|token| ends_sentence(source, token)) {
        let among = |words: &[&str]| sentence.iter().any(|(token, _)| token.is_among(words));
        if among(SUPPOSING) {
            let doubted = among(&["or", "not", "cannot"]);
            let mut stated = sentence
                .iter()
                .filter_map(|(token, _)| stated(source, *token));
            if let (Some(body), None) = (stated.next(), stated.next())
                && among(CONTRARY)
                && !doubted
            {
                let kind = SuppositionKind::Contrary;
                found.push(Supposition { kind, body });
            }
        } else if let Some(&(_, body)) = sentence
            .iter()
            .find(|(token, _)| token.is_among(&CONTRADICTED))
        {
            let kind = SuppositionKind::Contradicted;
            found.push(Supposition { kind, body });
        }
    }
    found
}
