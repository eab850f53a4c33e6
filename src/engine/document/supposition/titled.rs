//! Headings that name a case, which all below them is said of: "Case 2: $x < 0$", "The case $m_1 = m_2$", "Negative $x$",
//! "Underdamped motion ($\gamma < \omega_0$)".

use super::super::prose::{self, Placed, Token};
use super::super::words::Words;
use super::super::{Inline, Span, Supposition, SuppositionKind};
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
pub(in crate::document) fn read(source: &str, title: Span) -> Vec<Supposition> {
    let inline = inline(source, title);
    match inline.is_empty() {
        true => Vec::new(),
        false => named(source, &prose::tokens(source, title, &inline, &[])),
    }
}

/// The mathematics in a heading: `$…$`, `\(…\)`.
fn inline(source: &str, title: Span) -> Vec<Inline> {
    let mut found = Vec::new();
    let mut at = title.start;
    while let Some(rest) = source.get(at..title.end) {
        let Some(open) = rest.find(['$', '\\']) else {
            break;
        };
        let (begin, rest) = (at + open, &rest[open..]);
        let closes = match rest {
            _ if rest.starts_with("\\(") => "\\)",
            _ if rest.starts_with('$') => "$",
            // Another command, or a sign that is escaped.
            _ => {
                let escaped = rest[1..].chars().next().map_or(0, char::len_utf8);
                at = begin + 1 + escaped;
                continue;
            }
        };
        let Some(length) = rest[closes.len()..].find(closes) else {
            break;
        };
        let body = Span::new(begin + closes.len(), begin + closes.len() + length);
        at = body.end + closes.len();
        found.push(Inline {
            span: Span::new(begin, at),
            body,
        });
    }
    found
}

fn named(source: &str, tokens: &[Placed<'_>]) -> Vec<Supposition> {
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
            kind: SuppositionKind::case(false),
            body,
        })
    });
    let found: Vec<Supposition> = found.take(MOST_NAMED + 1).collect();
    match found.len() > MOST_NAMED {
        true => Vec::new(),
        false => found,
    }
}
