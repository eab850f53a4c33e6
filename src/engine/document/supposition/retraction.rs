//! What a text takes back: what it tells and then calls wrong, disputes, or says otherwise.

use super::super::prose::{Placed, Token, begins_with, ends_sentence};
use super::super::words::Words;
use super::super::{Span, Supposition, SuppositionKind};
use super::mathematics::is_bound;
use super::words::{BESIDE, DISPUTING, HEADING, REFERRING, RETRACTING};
use super::{is_fact, is_no_meaning};
use crate::sorted::{self, Map, Set};

/// So many words before a relation may say that it is not so there.
const MOST_BESIDE: usize = 3;

/// Takes back what a sentence tells that disputes it, or that the next one does, or the heading before it; and what is supposed, where
/// the next sentence takes it back. What is told is then only named.
pub(super) fn take_back(
    source: &str,
    tokens: &[Placed<'_>],
    found: &mut Vec<Supposition>,
    mentions: &mut Vec<Span>,
) {
    let sentences = tokens.split_inclusive(|token| ends_sentence(source, token));
    let mut next = sentences.clone().skip(1);
    let mut heads = false;
    // In the order of the text.
    let mut said = std::mem::take(found).into_iter().peekable();
    for sentence in sentences {
        let words = sentence
            .iter()
            .filter(|(token, _)| matches!(token, Token::Word(_)));
        let has = |among: &Words| sentence.iter().any(|(token, _)| token.is_among(among));
        let denied = next.next().is_some_and(retracts);
        let disputed = denied || heads || has(&DISPUTING);
        heads = words.count() <= 2 && has(&HEADING);
        let Some((_, last)) = sentence.last() else {
            continue;
        };
        // "Points above the line $y = 2 x$".
        let beside = |body: Span| {
            let before = sentence.partition_point(|(_, span)| span.end <= body.start);
            let near = &sentence[before.saturating_sub(MOST_BESIDE)..before];
            near.iter().any(|(token, _)| token.is_among(&BESIDE))
        };
        let is_taken_back = |own: &Supposition| {
            let supposes = supposes(own);
            // A length is positive whatever is said of it.
            let bounds = source.get(own.body.range()).is_some_and(is_bound);
            let taken = is_fact(own.kind) && disputed || supposes && denied;
            !bounds && (taken || (supposes || is_fact(own.kind)) && beside(own.body))
        };
        let mut own = Vec::new();
        while let Some(next) = said.next_if(|own| own.body.start < last.end) {
            own.push(next);
        }
        let ambiguous = ambiguous(source, &own);
        let is_ambiguous = |own: &Supposition| {
            supposes(own) && sides(source, own.body).is_some_and(|own| ambiguous.contains(own.0))
        };
        for own in own {
            match is_taken_back(&own) || is_ambiguous(&own) {
                false => found.push(own),
                true if is_no_meaning(&own) => mentions.push(own.body),
                true => {}
            }
        }
    }
    found.extend(said);
    sorted::sort(mentions);
}

fn supposes(own: &Supposition) -> bool {
    use SuppositionKind::{Assume, Case, Let};
    matches!(own.kind, Case { .. } | Let | Assume)
}

/// The left sides to which a sentence supposes different right ones: "Let $y = x^3$ in the first case and $y = x^2$ in the second".
fn ambiguous<'a>(source: &'a str, said: &[Supposition]) -> Set<&'a str> {
    let mut first: Map<&str, &str> = Map::new();
    let mut found = Set::new();
    let supposed = said.iter().filter(|own| supposes(own));
    for (left, right) in supposed.filter_map(|own| sides(source, own.body)) {
        if *first.entry(left).or_insert_with(|| right) != right {
            found.insert(left);
        }
    }
    found
}

fn sides(source: &str, body: Span) -> Option<(&str, &str)> {
    let (left, right) = source.get(body.range())?.split_once('=')?;
    Some((left.trim(), right.trim()))
}

/// "This is wrong."
fn retracts(sentence: &[Placed<'_>]) -> bool {
    let mut tokens = sentence.iter().map(|(token, _)| token);
    begins_with(sentence, &REFERRING) && tokens.any(|token| token.is_among(&RETRACTING))
}
