//! What leaves special cases behind: "in general", "without this assumption", "let us return to", "Later".

use super::super::SuppositionKind;
use super::super::prose::{Placed, Token};
use super::super::words::{Listed, is_in_any_case};
use super::words::REGIMES;

/// So many words may stand between "include" and "again".
const MOST_RECALLED: usize = 8;

/// Whether the word at `index` leaves special cases behind: "in general", "in the general case", "without this assumption", "let us
/// return to"; or cases and moments alone: "for arbitrary $w$", "Later", "In between".
pub(super) fn generalizes(
    word: &str,
    index: usize,
    tokens: &[Placed<'_>],
) -> Option<SuppositionKind> {
    use SuppositionKind::{Elsewhere, General, InAllCases, Otherwise};
    let before = |by: usize| match index.checked_sub(by).and_then(|at| tokens.get(at)) {
        Some((Token::Word(word), _)) => *word,
        _ => "",
    };
    let (last, second) = (before(1), before(2));
    let is_one = |word: &str, words: &[&str]| words.has_in_any_case(word);
    let after = |one: &str| is_in_any_case(last, one);
    let is = |said: bool, kind| said.then_some(kind);
    match word {
        "general" => {
            let the = || after("the") && is_one(second, &["in", "to", "for"]);
            is(after("in") || the(), General)
        }
        "generally" => Some(General),
        "assumption" | "restriction" | "supposition" | "condition" | "constraint" => {
            const DROPPING: &[&str] = &[
                "dropping",
                "drop",
                "lifting",
                "lift",
                "relaxing",
                "relax",
                "removing",
                "remove",
                "abandoning",
                "abandon",
                "without",
            ];
            let one = is_one(last, &["this", "that", "the", "our"]);
            is(one && is_one(second, DROPPING), General)
        }
        "to" => is(after("return"), General),
        // "Now we include friction again", "Restoring the friction", "no longer neglecting friction"
        "again" => is(recalls(index, tokens), General),
        "restoring" | "reinstating" | "reinstate" => is(last.is_empty() || after("we"), General),
        "suppose" | "assume" if after("next") => is(second.is_empty(), General),
        "neglect" | "neglecting" | "ignore" | "ignoring" | "assume" | "assuming" => {
            is(after("longer") && is_one(second, &["no"]), General)
        }
        // "Suppose next that", "Next, suppose that", "Now suppose instead": the second of two cases.
        "next" | "instead" => is(is_one(last, &["suppose", "assume"]), General),
        "cases" => is(
            is_one(last, &["all", "both"]) && is_one(second, &["in"]),
            InAllCases,
        ),
        "case" => {
            let each = is_one(last, &["either", "any", "each", "every"]);
            let opposite = is_one(last, &["opposite", "contrary", "converse"]);
            let in_the = is_one(second, &["the"]) && is_one(before(3), &["in"]);
            match each && is_one(second, &["in"]) {
                true => Some(InAllCases),
                false => is(opposite && in_the, Otherwise),
            }
        }
        "reality" | "practice" => is(after("in") && second.is_empty(), General),
        "all" | "any" | "every" if after("at") => is(second.is_empty(), Elsewhere),
        "arbitrary" | "all" | "any" | "every" => is(after("for"), Elsewhere),
        "between" => is(after("in"), Elsewhere),
        "otherwise" | "else" => is(last.is_empty(), Otherwise),
        "later" | "elsewhere" | "meanwhile" => is(last.is_empty(), Elsewhere),
        // "For $x$ below zero" is no place.
        word if REGIMES.has(word) => {
            let before = index.checked_sub(1).map(|before| tokens[before].0);
            let after_math = matches!(before, Some(Token::Math(_)));
            is(last.is_empty() && !after_math, Elsewhere)
        }
        _ => None,
    }
}

/// Whether the words before "again" say that something is taken into account: "Now we include friction again".
fn recalls(index: usize, tokens: &[Placed<'_>]) -> bool {
    const RECALLING: &[&str] = &[
        "include",
        "including",
        "allow",
        "allowing",
        "restore",
        "restoring",
        "admit",
        "reinstate",
        "account",
        "switch",
        "turn",
    ];
    let before = tokens[..index].iter().rev();
    let mut words = before.map_while(|(token, _)| match token {
        Token::Word(_) => Some(*token),
        _ => None,
    });
    words
        .by_ref()
        .take(MOST_RECALLED)
        .any(|word| word.is_among(RECALLING))
}
