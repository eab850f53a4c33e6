//! Cases that are counted: "Either $x > 0$ or $x < 0$. In the first case", "We distinguish two cases, $a = b$ and $a \neq b$."

use super::super::prose::{Placed, lead};
use super::super::words::Words;
use super::super::{Supposition, SuppositionKind};
use super::mathematics::stated;

/// A sentence with one of these counts what is stated in it.
static COUNTING: Words = Words::of(&["either", "cases", "possibilities", "alternatives", "or"]);
/// Which of them comes next, by its place; the last one has none.
const ORDINALS: &[(&str, Option<usize>)] = &[
    ("first", Some(0)),
    ("former", Some(0)),
    ("second", Some(1)),
    ("third", Some(2)),
    ("fourth", Some(3)),
    ("last", None),
    ("latter", None),
    ("other", None),
];

/// What sentences count, and which of that they take up, in order.
pub(super) fn read(source: &str, tokens: &[Placed<'_>]) -> Vec<Supposition> {
    let mut found = Vec::new();
    for sentence in tokens.split(|(token, _)| token.is_stop()) {
        if sentence.iter().any(|(token, _)| token.is_among(&COUNTING)) {
            found.extend(counted(source, sentence));
        } else {
            found.extend(taken_up(sentence));
        }
    }
    found
}

/// The relations of a sentence that counts some.
fn counted(source: &str, sentence: &[Placed<'_>]) -> Vec<Supposition> {
    let stated = sentence
        .iter()
        .filter_map(|(token, _)| stated(source, *token));
    let kind = SuppositionKind::Alternative;
    let counted: Vec<Supposition> = stated.map(|body| Supposition { kind, body }).collect();
    match counted.len() {
        0 | 1 => Vec::new(),
        _ => counted,
    }
}

/// "In the first case", with which a sentence begins.
fn taken_up(sentence: &[Placed<'_>]) -> Option<Supposition> {
    let begins = |(token, _): &Placed<'_>| token.is_among(&["and", "but", "while", "whereas"]);
    let sentence = &sentence[lead(sentence)..];
    let sentence = &sentence[sentence.iter().take_while(|own| begins(own)).count()..];
    let [(at, start), (the, _), (which, _), (case, end), ..] = sentence else {
        return None;
    };
    let is_phrase = at.is_among(&["in", "for"])
        && the.is_among(&["the"])
        && case.is_among(&["case", "possibility", "alternative"]);
    let (_, place) = ORDINALS
        .iter()
        .find(|(own, _)| is_phrase && which.is_among(&[*own]))?;
    Some(Supposition {
        kind: SuppositionKind::TakenUp(*place),
        body: start.to(*end),
    })
}
