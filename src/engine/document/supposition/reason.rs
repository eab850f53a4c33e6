//! Whether what is told is given as a reason: "since $a = b$", "Since no heat is lost, $a = b$".

use super::super::Span;
use super::super::words::Listed;
use super::words::REASONS;

/// Whether the word before mathematics gives it as a reason: "since $a = b$".
pub fn is_reason(source: &str, body: Span) -> bool {
    let before = source.get(..body.start).unwrap_or_default();
    let before = before.trim_end_matches(|c: char| !c.is_alphabetic());
    let word = before.rsplit(|c: char| !c.is_alphabetic()).next();
    // "They have the same size where $s = t$" says at which place.
    let is_place = |word: &str| {
        let before = before[..before.len() - word.len()].trim_end();
        word == "where" && before.ends_with(char::is_alphabetic)
    };
    word.is_some_and(|word| REASONS.has_in_any_case(word) && !is_place(word))
        || follows_a_reason(source, body)
}

/// Whether the clause before mathematics gives a reason in words: "Since no heat is lost, $a = b$".
fn follows_a_reason(source: &str, body: Span) -> bool {
    let before = source.get(..body.start).unwrap_or_default();
    let before =
        before.trim_end_matches(|c: char| c.is_whitespace() || matches!(c, '$' | '(' | '\\'));
    let Some(before) = before.strip_suffix(',') else {
        return false;
    };
    let clause = before.rsplit([',', '.', ';', ':', '$', '}', ')']).next();
    let mut words = clause.unwrap_or_default().split_whitespace();
    let (first, next) = (words.next(), words.next());
    let rest = words.count();
    let is =
        |word: Option<&str>, among: &[&str]| word.is_some_and(|word| among.has_in_any_case(word));
    // "As a check," gives none.
    let describes = is(
        next,
        &[
            "a", "an", "in", "for", "we", "to", "with", "can", "shown", "expected",
        ],
    );
    is(first, &["since", "because"]) && rest > 0 || is(first, &["as"]) && rest > 1 && !describes
}
