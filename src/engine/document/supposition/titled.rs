//! Headings that name a case, which all below them is said of: "Case 2: $x < 0$", "The case $m_1 = m_2$", "Negative $x$",
//! "Underdamped motion ($\gamma < \omega_0$)".

use super::super::prose::{Placed, Token};
use super::super::words::Words;
use super::super::{Supposition, SuppositionKind};
use super::compared;
use super::mathematics::{differs, is_bound, is_number, is_value, relates};
use super::words::DISPUTING;

/// A heading that states more names no case.
const MOST_NAMED: usize = 4;
/// What a heading with one of these says is not only said of what is below it.
static COMPARING: Words = Words::of(&[
    "or", "versus", "vs", "to", "from", "why", "not", "no", "than", "proof", "without", "excluded",
    "unless",
]);
/// A heading with one of these names a case.
const OF_A_CASE: &[&str] = &["case", "cases", "for", "if", "when", "regime", "where"];
/// These say of two things by their names that they are equal.
const ALIKE: &[&str] = &["equal", "identical", "same", "like", "symmetric"];

/// The cases that a heading names.
pub(in crate::document) fn read(source: &str, tokens: &[Placed<'_>]) -> Vec<Supposition> {
    let has = |words: &[&str]| tokens.iter().any(|(token, _)| token.is_among(words));
    let doubted = tokens
        .iter()
        .any(|(token, _)| token.is_among(&COMPARING) || token.is_among(&DISPUTING));
    if doubted {
        return Vec::new();
    }
    let named = compared::of_title(tokens);
    if !named.is_empty() {
        return named;
    }
    let (of_case, alike) = (has(OF_A_CASE), has(ALIKE));
    let says = |text: &str| match of_case {
        true => relates(text),
        // "Work and heat ($W = Q$)" names a law.
        false => is_bound(text) || differs(text) || is_value(text) && (is_number(text) || alike),
    };
    let found = tokens.iter().enumerate().filter_map(|(at, (token, _))| {
        let Token::Math(body) = *token else {
            return None;
        };
        // "Underdamped motion, $\gamma < \omega_0$", "Elastic collisions ($e = 1$)"
        let set_off = matches!(tokens[..at].last(), Some((Token::Mark(',' | '(' | ':'), _)));
        let text = source.get(body.range())?;
        (says(text) && (of_case || set_off)).then_some(Supposition {
            kind: SuppositionKind::Case { runs_on: false },
            body,
        })
    });
    let found: Vec<Supposition> = found.take(MOST_NAMED + 1).collect();
    match found.len() > MOST_NAMED {
        true => Vec::new(),
        false => found,
    }
}
