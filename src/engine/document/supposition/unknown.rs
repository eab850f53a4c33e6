//! What is solved for: "Solving (14) for $w$ we obtain". It has no value any more that was put in for it before.

use super::super::prose::{Placed, Token};
use super::super::words::Words;
use super::super::{Supposition, SuppositionKind};
use super::mathematics::is_letters;

/// These solve for something.
static SOLVING: Words = Words::of(&["solving", "solve", "solved", "solves", "solution"]);
/// How many words and citations may stand between that and "for".
const MOST_BETWEEN: usize = 6;

/// The letters that sentences solve for, in order.
pub(super) fn read(source: &str, tokens: &[Placed<'_>]) -> Vec<Supposition> {
    let solves = |at: &usize| tokens[*at].0.is_among(&SOLVING);
    let unknown = |at: usize| {
        let rest = &tokens[at + 1..];
        let between = |(token, _): &&Placed<'_>| {
            !token.is_stop() && !token.is_mark(',') && !token.is_among(&["for"])
        };
        let between = rest.iter().take_while(between).count();
        match rest.get(between..between + 2) {
            Some([(own, _), (Token::Math(body), _)])
                if own.is_among(&["for"]) && between <= MOST_BETWEEN =>
            {
                source
                    .get(body.range())
                    .is_some_and(is_letters)
                    .then_some(*body)
            }
            _ => None,
        }
    };
    let found = (0..tokens.len()).filter(solves).filter_map(unknown);
    found
        .map(|body| Supposition {
            kind: SuppositionKind::SolvedFor,
            body,
        })
        .collect()
}
