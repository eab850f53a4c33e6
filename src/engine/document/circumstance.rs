//! Of how much the display after a piece of text is said: of one moment ("At the top of its flight"), of one point of a curve ("The
//! minimum is where"), under circumstances ("For a symmetric arrangement"), or of all that the page is about.
//!
//! The words that begin the sentence tell, and the one that it ends with; in doubt it is said throughout.

use super::conclusion;
use super::prose::{Placed, Token, begins_with, ends_sentence, lead, whole};
use super::{Extent, Span};

/// These begin a sentence about one moment.
const MOMENTS: &[&str] = &["initially", "originally", "when", "once"];
/// With one of these before them, "before" and "after" name a moment; by themselves what lasts: "After the collision".
const SHORTLY: &[&str] = &[
    "just",
    "immediately",
    "right",
    "shortly",
    "directly",
    "soon",
];
/// These begin a sentence about circumstances.
const CIRCUMSTANCES: &[&str] = &["for", "in", "on", "during", "under", "before", "after"];
/// After "at", "for" and their like, these single nothing out: "At all times", "In general", "In other words".
const NOTHING: &[&str] = &[
    "all",
    "any",
    "every",
    "each",
    "arbitrary",
    "least",
    "most",
    "no",
    "some",
    "same",
    "this",
    "that",
    "general",
    "particular",
    "fact",
    "other",
    "contrast",
    "addition",
    "total",
    "short",
    "sum",
    "terms",
    "example",
    "instance",
    "comparison",
    "both",
];
/// After "at", these name a regime or a place as good as another, and no moment: "At low temperature", "At a distance".
const REGIMES: &[&str] = &[
    "constant", "fixed", "given", "equal", "low", "high", "small", "large", "short", "long",
    "room", "normal", "standard", "a", "an", "these", "those", "such", "thermal",
];
/// A sentence with one of these is about where something is greatest or least.
const EXTREMA: &[&str] = &[
    "maximum",
    "minimum",
    "extremum",
    "optimum",
    "maxima",
    "minima",
    "extrema",
    "stationary",
    "maximal",
    "minimal",
    "optimal",
    "extremal",
];
/// These put a condition.
const CONDITIONS: &[&str] = &[
    "condition",
    "conditions",
    "require",
    "requires",
    "demand",
    "demands",
];

/// Of how much the display after these tokens is said; `None` where nothing is said between it and the one before.
///
/// A sentence that has come to its end says nothing of what is displayed after it.
pub(super) fn read(source: &str, tokens: &[Placed<'_>]) -> Option<Extent> {
    let says = |(token, _): &Placed<'_>| {
        matches!(token, Token::Word(_) | Token::Math(_) | Token::Number(_))
    };
    let last = tokens.iter().rposition(says)?;
    let ends = |token: &Placed<'_>| ends_sentence(source, token);
    if tokens[last..].iter().any(ends) {
        return Some(Extent::Throughout);
    }
    let start = tokens[..last]
        .iter()
        .rposition(|(token, _)| matches!(token, Token::Stop | Token::Mark(';')))
        .map_or(0, |stop| stop + 1);
    let sentence = &tokens[start..=last];
    let begin = sentence.iter().position(says).unwrap_or_default();
    Some(of_sentence(&sentence[begin..]))
}

/// Of how much is said what comes after the words with which a sentence begins.
pub(super) fn of_sentence(sentence: &[Placed<'_>]) -> Extent {
    let sentence = &sentence[lead(sentence)..];
    let among = |at: usize, words: &[&str]| {
        sentence
            .get(at)
            .is_some_and(|(token, _)| token.is_among(words))
    };
    let has = |words: &[&str]| (0..sentence.len()).any(|at| among(at, words));
    if (0..sentence.len()).all(|at| among(at, &["and", "also", "as", "well"])) {
        return Extent::AsBefore;
    }
    if ends_in_a_clause(sentence) || says_what_it_means(sentence) || has(CONDITIONS) {
        return Extent::Condition;
    }
    let begins = match () {
        () if among(0, &["at"]) => match () {
            () if among(1, NOTHING) || among(2, &["same"]) => Extent::Throughout,
            () if among(1, REGIMES) => Extent::Circumstances,
            () => Extent::Moment,
        },
        () if among(0, MOMENTS) => Extent::Moment,
        () if among(0, &["as"]) && among(1, &["soon"]) => Extent::Moment,
        () if among(0, SHORTLY) && among(1, &["before", "after", "as", "when"]) => Extent::Moment,
        // "After a long time"
        () if among(0, &["after"]) && has(&["time", "while"]) => Extent::Moment,
        () if among(0, CIRCUMSTANCES) && !among(1, NOTHING) && !among(2, NOTHING) => {
            Extent::Circumstances
        }
        () => Extent::Throughout,
    };
    match begins {
        Extent::Throughout => begins,
        _ if has(EXTREMA) => Extent::Condition,
        _ => begins,
    }
}

/// The sentences that say what is so at a place or in a case, with a formula for each: "At $t = 1$ the body is at $x = v$.", "The place is
/// $x = v$ when $t = 1$." What is only set, "Let $m = a$ for the first and $M = 3 a$ for the second", is meant for what comes.
pub(super) fn said_of_places(source: &str, tokens: &[Placed<'_>]) -> Vec<Span> {
    const PLACES: &[&str] = &["at", "when", "if", "for"];
    const SETTING: &[&str] = &["let", "suppose", "assume", "take", "consider", "we"];
    let equalities = |(token, _): &Placed<'_>| match token {
        Token::Math(body) => source
            .get(body.range())
            .map_or(0, |own| own.matches('=').count()),
        _ => 0,
    };
    let names_place = |sentence: &[Placed<'_>]| {
        let mut before = None;
        sentence.iter().any(|(token, _)| {
            let is_place = before.is_some_and(|own: Token<'_>| own.is_among(PLACES));
            // "At time $t = 1$"
            if !token.is_among(&["time"]) {
                before = Some(*token);
            }
            is_place && matches!(token, Token::Math(_))
        })
    };
    let sentences = tokens.split(|(token, _)| token.is_stop());
    let said = sentences.filter(|sentence| {
        names_place(sentence)
            && sentence.iter().map(equalities).sum::<usize>() > 1
            && !begins_with(sentence, SETTING)
    });
    said.filter_map(whole).collect()
}

/// Whether a word's meaning is a condition: "Break-even means".
fn says_what_it_means(sentence: &[Placed<'_>]) -> bool {
    let means = sentence
        .iter()
        .rposition(|(token, _)| token.is_among(&["means"]));
    means.is_some_and(|at| {
        let rest = sentence[at + 1..].iter();
        at > 0 && !conclusion::refers(&sentence[..at]) && rest.count() <= 1
    })
}

/// Whether the display is in a clause that says where or when: "The minimum is where", "is reached when". After a comma a "where" says
/// what is meant.
fn ends_in_a_clause(sentence: &[Placed<'_>]) -> bool {
    let Some(((Token::Word(last), _), before)) = sentence.split_last() else {
        return false;
    };
    let joined = matches!(before.last(), Some((Token::Word(_) | Token::Math(_), _)));
    joined && before.len() > 1 && matches!(*last, "where" | "when")
}
