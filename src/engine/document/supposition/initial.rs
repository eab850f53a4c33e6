//! Initial and boundary conditions: "With $w = w_0$ at $x = 0$ we get", "Setting $F = m g$ at $v = u$".
//!
//! What is so at one value of something is no value for good: it tells what constants are, and nothing of what varies.

use super::super::prose::{Placed, Token, ends_sentence};
use super::super::words::Words;
use super::super::{Span, Supposition, SuppositionKind};
use super::mathematics::is_value;
use crate::algebra::Expr;
use crate::notation::read_expr;

/// A sentence with one of these before a condition makes use of it.
static USING: Words = Words::of(&[
    "with",
    "let",
    "set",
    "setting",
    "put",
    "putting",
    "use",
    "using",
    "insert",
    "inserting",
    "since",
    "because",
    "as",
    "condition",
    "conditions",
    "require",
    "requires",
    "requiring",
    "demand",
    "demanding",
    "impose",
    "imposing",
    "given",
    "from",
    "if",
]);
/// Between "at" and where that is: "at the time $t = 0$".
static PLACES: Words = Words::of(&[
    "the", "time", "instant", "moment", "place", "point", "end", "wall", "surface",
]);
/// No more words stand there.
const MOST_BETWEEN: usize = 3;
/// No more words lead from what makes use of a condition to it.
const MOST_BEFORE: usize = 40;
/// A sentence gives no more conditions for one place.
const MOST_CONDITIONS: usize = 4;

/// The conditions that prose makes use of, with where they are met.
pub(super) fn read(source: &str, tokens: &[Placed<'_>]) -> Vec<Supposition> {
    let mut found = Vec::new();
    for (at, (token, _)) in tokens.iter().enumerate() {
        if !token.is_among(&["at", "when"]) {
            continue;
        }
        let Some(place) = place_after(source, &tokens[at + 1..]) else {
            continue;
        };
        let (conditions, first) = conditions_before(source, &tokens[..at]);
        let before = tokens[..first].iter().rev().take(MOST_BEFORE);
        let mut sentence =
            before.take_while(|token| !ends_sentence(source, token) && !token.0.is_stop());
        if sentence.any(|(token, _)| token.is_among(&USING)) {
            found.extend(conditions.into_iter().map(|body| Supposition {
                kind: SuppositionKind::Initial(place),
                body,
            }));
        }
    }
    found
}

/// The value of a symbol with which a text goes on: "the time $t = 0$".
fn place_after(source: &str, tokens: &[Placed<'_>]) -> Option<Span> {
    let words = tokens.iter().take(MOST_BETWEEN);
    let words = words
        .take_while(|(token, _)| token.is_among(&PLACES))
        .count();
    let Token::Math(place) = tokens.get(words)?.0 else {
        return None;
    };
    let left = left_of_equation(source, place)?;
    matches!(left, Expr::Symbol(_)).then_some(place)
}

/// The equations with which a text ends, "$w = 0$ and $w' = 0$", and where the first of them stands.
fn conditions_before(source: &str, tokens: &[Placed<'_>]) -> (Vec<Span>, usize) {
    let (mut conditions, mut first) = (Vec::new(), tokens.len());
    while let Some(at) = first.checked_sub(1)
        && let Token::Math(body) = tokens[at].0
        && left_of_equation(source, body).is_some()
        && conditions.len() < MOST_CONDITIONS
    {
        conditions.push(body);
        first = at;
        let joins = at.checked_sub(1).map(|before| tokens[before].0);
        if joins.is_some_and(|own| own.is_among(&["and"]) || own.is_mark(',')) {
            first -= 1;
        }
    }
    // What joins the first to what stands before it is none of theirs.
    (conditions, first)
}

/// The left side of a single equation.
fn left_of_equation(source: &str, body: Span) -> Option<Expr> {
    let text = source.get(body.range())?;
    let equals = text.find('=').filter(|_| is_value(text))?;
    read_expr(source, Span::new(body.start, body.start + equals)).ok()
}
