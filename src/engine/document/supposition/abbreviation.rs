//! A name for a term, given in words: "The ratio $z/a$ is called $u$", "We abbreviate $z/a$ as $u$", "Writing $u$ for $z/a$", "Let $u$ be
//! the ratio $z/a$".
//!
//! What is put in the place of something that has a name, "Replacing $m$ by $2 m$", is not understood.

use super::super::prose::{Placed, Token};
use super::super::words::Words;
use super::super::{Span, Supposition, SuppositionKind};
use super::mathematics::{is_letters, relates};

/// Between a term and its name: "is called", "is denoted by".
static CALLED: Words = Words::of(&["called", "denoted", "abbreviated", "named", "written"]);
/// Before a term that is given a name, or before the name.
static NAMING: Words = Words::of(&[
    "abbreviate",
    "abbreviating",
    "denote",
    "denoting",
    "write",
    "writing",
    "call",
    "calling",
    "name",
    "naming",
    "replace",
    "replacing",
]);
/// These put something in the place of something else.
static REPLACING: Words = Words::of(&[
    "replace",
    "replacing",
    "exchange",
    "exchanging",
    "interchanging",
    "swapping",
]);
/// Between a name and its term: "Let $u$ denote".
const DENOTING: &[&[&str]] = &[&["denote"], &["be"], &["stand", "for"], &["represent"]];
/// So many words say what kind of term it is: "denote the ratio $z/a$ by $u$".
const MOST_WORDS: usize = 3;

/// The names that are given to terms.
pub(super) fn read(source: &str, tokens: &[Placed<'_>]) -> Vec<Supposition> {
    let text = |body: Span| source.get(body.range()).unwrap_or_default();
    let is_name = |body: Span| is_letters(text(body)) && !text(body).contains(',');
    let is_term = |body: Span| !is_letters(text(body)) && !relates(text(body));
    let mut found = Vec::new();
    for (at, (token, _)) in tokens.iter().enumerate() {
        let Token::Math(first) = *token else {
            continue;
        };
        let rest = &tokens[at + 1..];
        let words = rest
            .iter()
            .take(MOST_WORDS + 1)
            .take_while(|(token, _)| matches!(token, Token::Word(_)))
            .count();
        let Some((Token::Math(second), _)) = rest.get(words) else {
            continue;
        };
        let between = &rest[..words];
        let has_named = || {
            let before = tokens[..at].iter().rev().take(MOST_WORDS + 1);
            let mut before = before.take_while(|(token, _)| matches!(token, Token::Word(_)));
            before.any(|(token, _)| token.is_among(&NAMING))
        };
        let is_called = match between {
            // "We call $z/a$ the ratio $u$"
            [(the, _), _] if the.is_among(&["the"]) => has_named(),
            [(be, _), (called, _)] | [(be, _), (called, _), _] => {
                be.is_among(&["is", "are"]) && called.is_among(&CALLED)
            }
            [(by, _)] => by.is_among(&["as", "by"]) && has_named(),
            _ => false,
        };
        let is_let = || {
            let before = at.checked_sub(1).map(|before| tokens[before].0);
            let denotes = DENOTING.iter().any(|verb| {
                let said = |(token, word): (&Placed<'_>, &&str)| token.0.is_among(&[*word]);
                let rest = between.get(verb.len()..).unwrap_or_default();
                let is_kind = match rest {
                    [] => true,
                    [(the, _), _] => the.is_among(&["the"]),
                    _ => false,
                };
                is_kind && between.iter().zip(*verb).all(said)
            });
            before.is_some_and(|token| token.is_among(&["let"])) && denotes
        };
        let replaces = || {
            let before = at.checked_sub(1).map(|before| tokens[before].0);
            let by = matches!(between, [(by, _)] if by.is_among(&["by", "with", "and"]));
            before.is_some_and(|token| token.is_among(&REPLACING)) && by
        };
        let is_for = || {
            let follows = |(token, _): &Placed<'_>| token.is_among(&NAMING);
            let named = at.checked_sub(1).and_then(|before| tokens.get(before));
            let begins = between
                .first()
                .is_some_and(|(token, _)| token.is_among(&["for"]));
            named.is_some_and(follows) && begins
        };
        let (name, term) = match () {
            () if is_called && is_term(first) && is_name(*second) => (*second, first),
            () if is_name(first) && is_term(*second) && (is_for() || is_let()) => (first, *second),
            () if replaces() => {
                let kind = SuppositionKind::Unread;
                found.push(Supposition { kind, body: first });
                continue;
            }
            () => continue,
        };
        found.push(Supposition {
            kind: SuppositionKind::Abbreviation(term),
            body: name,
        });
    }
    found
}
