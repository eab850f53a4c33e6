//! Cases that are counted: "Either $x > 0$ or $x < 0$. In the first case", "We distinguish two cases, $a = b$ and $a \neq b$."

use super::super::prose::{Placed, Token, lead};
use super::super::words::Words;
use super::super::{Span, Supposition, SuppositionKind};
use super::mathematics::stated;
use crate::sorted::Set;

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

/// The values that something is given side by side: "setting $x = 0$ and $x = L$".
pub(super) fn both(source: &str, tokens: &[Placed<'_>]) -> Set<Span> {
    let mut found = Set::new();
    let mut last: Option<(Span, &str, &str)> = None;
    for (token, _) in tokens {
        match *token {
            Token::Math(body) => {
                let text = source.get(body.range()).unwrap_or_default();
                let sides = text.split_once('=').map(|(of, is)| (of.trim(), is.trim()));
                let own = sides.map(|(of, is)| (body, of, is));
                if let (Some((before, of, is)), Some((_, own, value))) = (last, own)
                    && of == own
                    && is != value
                {
                    found.extend([before, body]);
                }
                last = own;
            }
            token if token.is_among(&["and", "or"]) || token.is_mark(',') => {}
            _ => last = None,
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
