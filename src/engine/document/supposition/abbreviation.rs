//! A name for a term, given in words: "The ratio $z/a$ is called $u$", "We abbreviate $z/a$ as $u$", "Writing $u$ for $z/a$".

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
]);
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
            [(be, _), (called, _)] | [(be, _), (called, _), _] => {
                be.is_among(&["is", "are"]) && called.is_among(&CALLED)
            }
            [(by, _)] => by.is_among(&["as", "by"]) && has_named(),
            _ => false,
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
            () if is_name(first) && is_term(*second) && is_for() => (first, *second),
            () => continue,
        };
        found.push(Supposition {
            kind: SuppositionKind::Abbreviation(term),
            body: name,
        });
    }
    found
}
