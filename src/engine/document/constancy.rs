//! What prose says is constant: "where $g$ is constant", "with $k$ a constant", "a constant force $F$", "the constants $a$ and $b$".
//!
//! Steps may be proved with it, so in doubt nothing is read: not what is concluded ("so $L$ is constant"), not a condition ("if", "when"),
//! not what is constant in one direction or for a while ("along", "during", "at constant $T$"), and not what is only nearly so.

use super::Span;
use super::conclusion;
use super::prose::{Placed, Token};

/// So many words may stand between a symbol and the word that says it is constant, or between that and a symbol.
const MOST_BETWEEN: usize = 4;
/// These say that what they stand before is what comes after.
const LINKING: [&str; 9] = [
    "is", "are", "be", "being", "remains", "remain", "stays", "stay", "as",
];
/// Before a symbol these make it a part of what is spoken of: "the rate of change of $x$ is constant".
const OF_A_PART: [&str; 12] = [
    "of", "to", "between", "from", "by", "in", "over", "at", "on", "along", "than", "per",
];
/// With one of these between a symbol and "constant" it is not told that the symbol is.
const UNSAID: [&str; 34] = [
    "not",
    "never",
    "no",
    "nor",
    "longer",
    "only",
    "almost",
    "nearly",
    "roughly",
    "approximately",
    "practically",
    "piecewise",
    "locally",
    "up",
    "of",
    "to",
    "by",
    "from",
    "than",
    "with",
    "in",
    "at",
    "on",
    "along",
    "for",
    "when",
    "and",
    "or",
    "times",
    "proportional",
    "held",
    "kept",
    "is",
    "are",
];
/// After "constant" these say where, for how long, or what else is constant.
const LIMITING: [&str; 27] = [
    "in",
    "along",
    "on",
    "only",
    "except",
    "during",
    "over",
    "until",
    "unless",
    "if",
    "when",
    "while",
    "within",
    "at",
    "near",
    "times",
    "multiple",
    "multiples",
    "for",
    "but",
    "inside",
    "outside",
    "across",
    "between",
    "after",
    "before",
    "per",
];
/// In a clause with one of these nothing is told for a fact.
const DOUBTFUL: [&str; 33] = [
    "if", "when", "whenever", "whether", "unless", "until", "while", "once", "not", "never", "no",
    "cannot", "would", "were", "could", "might", "show", "shows", "shown", "see", "prove", "must",
    "require", "requires", "demand", "demands", "nor", "neither", "expect", "either", "or", "say",
    "says",
];
/// These begin a clause that tells a fact whatever comes before it.
const TELLING: [&str; 7] = [
    "where", "with", "since", "as", "because", "assuming", "taking",
];

/// The mathematics of which these tokens say that it is constant, in order.
pub(super) fn read(source: &str, tokens: &[Placed<'_>]) -> Vec<Span> {
    let mut found = Vec::new();
    for (at, &(token, _)) in tokens.iter().enumerate() {
        let Token::Word(word) = token else {
            continue;
        };
        let plural = word.eq_ignore_ascii_case("constants");
        if !plural && !word.eq_ignore_ascii_case("constant") {
            continue;
        }
        let (before, after) = (&tokens[..at], &tokens[at + 1..]);
        let named = said_before(before, after).or_else(|| named_after(before, after));
        if let Some((list, begin)) = named
            && tells(source, &tokens[..begin])
            && !is_asked(source, after)
        {
            found.extend(list);
        }
    }
    found
}

/// "$A$ and $B$ are": what stands before "constant" and is said to be so, and the token with which the list of it begins.
fn said_before(before: &[Placed<'_>], after: &[Placed<'_>]) -> Option<(Vec<Span>, usize)> {
    let is_among = |words: &[&str]| after.first().is_some_and(|next| next.0.is_among(words));
    if is_among(&LIMITING) {
        return None;
    }
    let words = before.iter().rev().take(MOST_BETWEEN + 1);
    let words = words
        .take_while(|token| matches!(token.0, Token::Word(_)))
        .count();
    let (own, between) = before.split_at(before.len() - words);
    let (list, begin) = list_that_ends(own)?;
    let introduced = begin.checked_sub(1).map(|at| own[at].0);
    let (linked, described) = match between.split_first() {
        Some((first, rest)) if first.0.is_among(&LINKING) => (true, rest),
        _ => (false, between),
    };
    let unsaid = described.iter().any(|token| token.0.is_among(&UNSAID));
    let is_part = introduced.is_some_and(|token| token.is_among(&OF_A_PART));
    // "With $k$ constant", "assuming $g$ constant": without a verb it is said by what stands before.
    let joined = introduced.is_some_and(|token| {
        token.is_among(&[
            "with",
            "for",
            "assuming",
            "taking",
            "treating",
            "considering",
        ])
    });
    (!unsaid && !is_part && (linked || joined)).then_some((list, begin))
}

/// "Constant acceleration $a$": what is named after "constant", and the token with which that begins.
fn named_after(before: &[Placed<'_>], after: &[Placed<'_>]) -> Option<(Vec<Span>, usize)> {
    let words = after
        .iter()
        .take_while(|token| matches!(token.0, Token::Word(_)))
        .count();
    let (between, list) = after.split_at(words);
    // "The constant of integration $C$"
    let noun = match between.split_first() {
        Some((first, rest)) if first.0.is_among(&["of"]) && !rest.is_empty() => rest,
        _ => between,
    };
    let last = before.last().map(|token| token.0);
    let only_nearly = last.is_some_and(|token| token.is_among(&UNSAID));
    // "At constant $T$": in one process.
    let process = only_nearly
        && !last.is_some_and(|token| token.is_among(&["of", "with", "by", "and", "from", "to"]));
    let limited = |token: &Placed<'_>| {
        token.0.is_among(&UNSAID)
            || token.0.is_among(&LIMITING)
            || token.0.is_among(&LINKING)
            || token.0.is_among(&TELLING)
            || matches!(token.0, Token::Word(word) if conclusion::draws(&word.to_lowercase()))
    };
    if process || words > MOST_BETWEEN || noun.iter().any(limited) {
        return None;
    }
    let list = list_that_begins(list);
    (!list.is_empty()).then_some((list, before.len()))
}

/// The mathematics of a list, "$A$, $B$ and $C$", that ends with the tokens, and the token with which it begins.
fn list_that_ends(tokens: &[Placed<'_>]) -> Option<(Vec<Span>, usize)> {
    let mut list = Vec::new();
    let mut begin = tokens.len();
    let mut at = tokens.len();
    while let Some((Token::Math(body), _)) = at.checked_sub(1).map(|last| tokens[last]) {
        list.push(body);
        begin = at - 1;
        at = begin;
        while at > 0 && joins(&tokens[at - 1]) {
            at -= 1;
        }
        if at == begin {
            break;
        }
    }
    list.reverse();
    (!list.is_empty()).then_some((list, begin))
}

/// The mathematics of a list that begins with the tokens.
fn list_that_begins(tokens: &[Placed<'_>]) -> Vec<Span> {
    let mut list = Vec::new();
    let mut rest = tokens;
    while let Some(((Token::Math(body), _), others)) = rest.split_first() {
        list.push(*body);
        let joining = others.iter().take_while(|token| joins(token)).count();
        // "a constant $k$, $F = k x$" names one.
        let is_joined = others[..joining]
            .iter()
            .any(|token| token.0.is_among(&["and"]));
        let more = others[joining..]
            .iter()
            .any(|token| token.0.is_among(&["and"]));
        if !is_joined && !more {
            break;
        }
        rest = &others[joining..];
    }
    list
}

fn joins(token: &Placed<'_>) -> bool {
    token.0 == Token::Mark(',') || token.0.is_among(&["and"])
}

/// Whether the clause that these tokens begin tells a fact: no condition, no conclusion.
fn tells(source: &str, before: &[Placed<'_>]) -> bool {
    let is_end = |(token, span): &Placed<'_>| {
        *token == Token::Mark(';')
            || *token == Token::Stop && matches!(source.get(span.range()), Some("." | "?" | "!"))
    };
    let start = before.iter().rposition(is_end).map_or(0, |end| end + 1);
    let sentence = &before[start..];
    let telling = sentence
        .iter()
        .rposition(|token| token.0.is_among(&TELLING));
    let clause = &sentence[telling.map_or(0, |at| at + 1)..];
    let doubts = |(token, _): &Placed<'_>| match token {
        Token::Word(word) => {
            let word = word.to_lowercase();
            DOUBTFUL.contains(&word.as_str()) || conclusion::draws(&word)
        }
        _ => false,
    };
    !clause.iter().any(doubts)
}

/// Whether the sentence asks.
fn is_asked(source: &str, after: &[Placed<'_>]) -> bool {
    let mut ends = after.iter().filter(|token| token.0 == Token::Stop);
    ends.next()
        .is_some_and(|(_, span)| source.get(span.range()) == Some("?"))
}
