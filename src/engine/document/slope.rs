//! Sentences that take the slope of what they cite: "Differentiating (1) with respect to time we obtain the velocity".

use super::Slope;
use super::prose::{Placed, Token};

/// These take a slope of what comes after them.
const TAKING: &[&str] = &["differentiating", "differentiate", "differentiation"];
/// Between that and what is cited.
const OF: &[&str] = &["of", "equation", "eq", "both", "sides", "expression", "the"];
/// What is called so is a slope by the time.
const RATES: &[&str] = &["velocity", "speed", "acceleration"];

/// The slope that the last sentence takes.
pub(super) fn read(last: &[Placed<'_>]) -> Option<Slope> {
    let takes = last.iter().position(|own| own.0.is_among(TAKING))?;
    let rest = &last[takes + 1..];
    let skipped = |own: &&Placed<'_>| own.0.is_among(OF) || own.0.is_mark('.');
    let of = rest.iter().take_while(skipped).count();
    let (Token::Tag(_) | Token::Keys(_), cited) = *rest.get(of)? else {
        return None;
    };
    let rest = &rest[of + 1..];
    let is_cited = |own: &Placed<'_>| own.0.cites();
    // "Differentiating (1) and inserting (2)" takes more than a slope.
    if rest.iter().any(is_cited) {
        return None;
    }
    let has = |words: &[&str]| rest.iter().any(|own| own.0.is_among(words));
    let respect = rest.iter().position(|own| own.0.is_among(&["respect"]));
    let by = respect.map(|at| &rest[at + 1..]);
    let by = by.map(|by| by.iter().find(|own| !own.0.is_among(&["to", "the"])));
    let (by, by_time) = match by {
        Some(Some((Token::Math(body), _))) => (Some(*body), false),
        Some(by) => (None, by.is_some_and(|own| own.0.is_among(&["time"]))),
        None => (None, has(RATES)),
    };
    Some(Slope {
        cited,
        by,
        by_time,
        twice: has(&["twice"]),
    })
}
