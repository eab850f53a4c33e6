//! Initial and boundary conditions: "With $w = w_0$ at $x = 0$ we get", "Setting $F = m g$ at $v = u$", "At $x = 0$ we have $w = w_0$".
//!
//! What is so at one value of something is no value for good: it tells what constants are, and nothing of what varies.

use super::super::prose::{Placed, Token, ends_sentence};
use super::super::words::Words;
use super::super::{Span, Supposition, SuppositionKind};
use super::mathematics::{is_slope, is_value, relates};
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
    "suppose",
    "supposing",
    "assume",
    "assuming",
    "know",
]);
/// So does a sentence with one of these after it: "$w = 0$ at $x = 0$, so integrating gives".
static CONCLUDING: Words = Words::of(&[
    "so",
    "hence",
    "thus",
    "therefore",
    "then",
    "integrating",
    "integration",
    "integrate",
]);
/// Between "at" and where that is: "at the time $t = 0$", "at the wall $r = R$". A temperature is no place.
static PLACES: Words = Words::of(&[
    "the",
    "time",
    "instant",
    "moment",
    "beginning",
    "start",
    "place",
    "point",
    "position",
    "end",
    "ends",
    "wall",
    "surface",
    "boundary",
    "edge",
    "rim",
    "tip",
    "clamp",
    "support",
    "hinge",
    "plate",
    "plane",
    "interface",
    "axis",
    "centre",
    "center",
    "middle",
    "origin",
    "top",
    "bottom",
    "ground",
    "inlet",
    "outlet",
    "entrance",
    "exit",
    "left",
    "right",
    "upper",
    "lower",
    "inner",
    "outer",
    "free",
    "fixed",
    "far",
    "near",
]);
/// No more words stand there.
const MOST_BETWEEN: usize = 4;
/// Right before what is so at a place that was named first: "At $x = 0$ we have $w = c$".
static BEING: Words = Words::of(&[
    "have", "has", "is", "be", "require", "need", "impose", "that",
]);
/// No more words stand between the two.
const MOST_SAYING: usize = 6;
/// No more words lead from what makes use of a condition to it.
const MOST_BEFORE: usize = 40;
/// A sentence gives no more conditions for one place.
const MOST_CONDITIONS: usize = 4;

/// The conditions that prose makes use of, with where they are met, and those that it tells and makes no use of.
///
/// What is supposed of the moment that a sentence names is none of them.
pub(super) fn read(
    source: &str,
    tokens: &[Placed<'_>],
    supposed: &[Supposition],
) -> (Vec<Supposition>, Vec<Span>) {
    let is_of_moment = |body: &Span| {
        use SuppositionKind::{Case, Moment};
        let mut supposed = supposed.iter().filter(|own| own.body == *body);
        supposed.any(|own| matches!(own.kind, Moment | Case { .. }))
    };
    let (mut found, mut told) = (Vec::new(), Vec::new());
    for (at, (token, _)) in tokens.iter().enumerate() {
        if !token.is_among(&["at", "when"]) {
            continue;
        }
        let Some((place, end)) = place_after(source, &tokens[at + 1..]) else {
            continue;
        };
        let rest = &tokens[at + 1 + end..];
        let (mut conditions, first) = conditions_before(source, &tokens[..at]);
        let mut is_used = uses(source, &tokens[..first], rest);
        if conditions.is_empty() && begins(&tokens[..at]) {
            conditions.extend(condition_after(source, rest).filter(|own| !is_of_moment(own)));
            is_used = true;
        }
        if is_used {
            found.extend(conditions.into_iter().map(|body| Supposition {
                kind: SuppositionKind::Initial(place),
                body,
            }));
        } else {
            told.extend(conditions);
        }
    }
    (found, told)
}

/// Whether a sentence makes use of a condition, by what stands in it before and after.
fn uses(source: &str, before: &[Placed<'_>], after: &[Placed<'_>]) -> bool {
    let own = |token: &&Placed<'_>| !ends_sentence(source, token) && !token.0.is_stop();
    let mut sentence = before.iter().rev().take(MOST_BEFORE).take_while(own);
    let mut rest = after.iter().take_while(own);
    sentence.any(|(token, _)| token.is_among(&USING))
        || rest.any(|(token, _)| token.is_among(&CONCLUDING))
}

/// Whether what stands after these words begins a clause.
fn begins(before: &[Placed<'_>]) -> bool {
    before.last().is_none_or(|(token, _)| {
        let joins = || token.is_mark(',') || token.is_among(&["and", "but", "now"]);
        token.is_stop() || joins()
    })
}

/// What is so at a place that was named first, "At $x = 0$ the charge is $q = c$".
fn condition_after(source: &str, tokens: &[Placed<'_>]) -> Option<Span> {
    let comma = usize::from(tokens.first().is_some_and(|(token, _)| token.is_mark(',')));
    let tokens = &tokens[comma..];
    let is_word = |token: &&Placed<'_>| matches!(token.0, Token::Word(_));
    let words = tokens.iter().take(MOST_SAYING).take_while(is_word).count();
    let (last, _) = tokens.get(words.checked_sub(1)?)?;
    match tokens.get(words)?.0 {
        Token::Math(body) if last.is_among(&BEING) && is_condition(source, body) => Some(body),
        _ => None,
    }
}

/// The value of a symbol with which a text goes on, "the time $t = 0$", and how many tokens that takes.
fn place_after(source: &str, tokens: &[Placed<'_>]) -> Option<(Span, usize)> {
    let words = tokens.iter().take(MOST_BETWEEN);
    let words = words
        .take_while(|(token, _)| token.is_among(&PLACES))
        .count();
    let Token::Math(place) = tokens.get(words)?.0 else {
        return None;
    };
    let left = left_of_equation(source, place)?;
    matches!(left, Expr::Symbol(_)).then_some((place, words + 1))
}

/// The equations with which a text ends, "$w = 0$ and $w' = 0$", and where the first of them stands.
fn conditions_before(source: &str, tokens: &[Placed<'_>]) -> (Vec<Span>, usize) {
    let (mut conditions, mut first) = (Vec::new(), tokens.len());
    while let Some(at) = first.checked_sub(1)
        && let Token::Math(body) = tokens[at].0
        && is_condition(source, body)
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

/// Whether mathematics says that something has a value, or several things the same: `w = 0`, `w = w' = 0`, `dw/dx = 0`.
fn is_condition(source: &str, body: Span) -> bool {
    let text = source.get(body.range()).unwrap_or_default();
    let Some((subjects, _)) = text.rsplit_once('=') else {
        return false;
    };
    let is_subject = |own: &str| is_slope(own) || read_expr(own, Span::new(0, own.len())).is_ok();
    relates(text) && !relates(&text.replace('=', " ")) && subjects.split('=').all(is_subject)
}

/// The left side of a single equation.
fn left_of_equation(source: &str, body: Span) -> Option<Expr> {
    let text = source.get(body.range())?;
    let equals = text.find('=').filter(|_| is_value(text))?;
    read_expr(source, Span::new(body.start, body.start + equals)).ok()
}
