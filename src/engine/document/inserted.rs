//! What a sentence puts in elsewhere, and what it puts in again without naming it: "Inserting (10) in (8) gives $$…$$ and inserting it in (7)".

use super::prose::{Placed, Token};
use super::{Citation, Span};

/// These put something in.
pub(super) const INSERTING: &[&str] = &[
    "inserting",
    "insert",
    "substituting",
    "substitute",
    "putting",
    "put",
    "plugging",
];
/// Between that and what is put in.
const BEFORE: &[&str] = &["equation", "eq", "the", "result", "value", "now", "back"];
/// What comes after it: "in (7)".
const INTO: &[&str] = &["in", "into", "back"];

/// What is put in by a text.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Inserted {
    /// The equation that it puts in by its number.
    pub cited: Option<Citation>,
    /// It puts in "it", and names only what that is put in.
    pub again: bool,
}

/// What the last sentence puts in.
pub(super) fn read(last: &[Placed<'_>], citations: &[Citation]) -> Inserted {
    let mut inserted = Inserted::default();
    for (at, (token, _)) in last.iter().enumerate() {
        if !token.is_among(INSERTING) {
            continue;
        }
        let rest = &last[at + 1..];
        let is_between = |own: &&Placed<'_>| own.0.is_among(BEFORE) || own.0.is_mark('.');
        let rest = &rest[rest.iter().take_while(is_between).count()..];
        let into = |at: usize| rest.get(at).is_some_and(|own| own.0.is_among(INTO));
        match rest.first() {
            Some((Token::Tag(_) | Token::Keys(_), span)) if into(1) => {
                inserted.cited = cited_at(*span, citations);
            }
            Some((token, _)) if token.is_among(&["it"]) && into(1) => {
                inserted.again = inserted.cited.is_none();
            }
            _ => {}
        }
    }
    inserted
}

fn cited_at(span: Span, citations: &[Citation]) -> Option<Citation> {
    let mut cited = citations.iter();
    let within = |own: &&Citation| own.span.start < span.end && span.start < own.span.end;
    cited.find(within).cloned()
}
