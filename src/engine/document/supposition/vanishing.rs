//! What is said to be zero and not written as an equation: "Setting the derivative to zero gives", "which vanishes at $x = a$".

use super::super::conclusion;
use super::super::prose::{Placed, Token};
use super::super::words::Listed;
use super::super::{Span, Supposition, SuppositionKind, Vanishing};
use super::follows;
use super::mathematics::is_value;
use super::words::{DENYING, DOUBTFUL};

/// How many tokens may stand between "setting" or "the derivative" and "zero".
const MOST_BETWEEN: usize = 8;
/// These set something to a value.
const SETTING: &[&str] = &["setting", "set", "putting", "put", "equating", "equate"];
/// What is differentiated has one of these.
const SLOPES: &[&str] = &["derivative", "slope", "gradient"];
/// These say that something is zero.
const VANISHES: &[&str] = &["vanish", "vanishes", "zero", "nought"];

/// What prose says to be zero, in order.
pub(super) fn read(source: &str, tokens: &[Placed<'_>]) -> Vec<Supposition> {
    let mut found = Vec::new();
    for (number, sentence) in tokens.split(|(token, _)| *token == Token::Stop).enumerate() {
        let relative = || of_display(source, sentence);
        // What leads on to a display is said of it.
        let leads = sentence.as_ptr_range().end == tokens.as_ptr_range().end;
        let named = || leads.then(|| named(sentence)).flatten();
        match set(source, sentence).or_else(named) {
            Some(own) => found.push(own),
            None if number == 0 => found.extend(relative()),
            None => {}
        }
    }
    found
}

/// "Setting $F$ to zero", "Setting the derivative equal to zero", "where the derivative vanishes".
fn set(source: &str, sentence: &[Placed<'_>]) -> Option<Supposition> {
    let is_doubtful = |at: usize| {
        // "If we set the derivative to zero, we find" does so.
        let set_by_us = || among(sentence, at, &["if"]) && among(sentence, at + 1, &["we"]);
        among(sentence, at, &DENYING) || among(sentence, at, &DOUBTFUL) && !set_by_us()
    };
    let zero = (0..sentence.len()).find(|&at| is_zero(source, sentence[at].0))?;
    if (0..sentence.len()).any(is_doubtful) {
        return None;
    }
    let near = zero.saturating_sub(MOST_BETWEEN)..zero;
    let slope = near.clone().find(|&at| {
        among(sentence, at, SLOPES) && !follows(at, sentence, &["second", "third", "higher"])
    });
    let sets = near.clone().find(|&at| among(sentence, at, SETTING));
    let (at, kind) = match (sets, slope) {
        (_, Some(slope)) => (slope, Vanishing::Slope),
        (Some(sets), None) => (sets + 1..zero)
            .find_map(|at| match sentence[at].0 {
                Token::Math(_) => Some((at, Vanishing::Term)),
                Token::Word("this" | "it") | Token::Tag(_) | Token::Keys(_) => {
                    Some((at, Vanishing::Display))
                }
                _ => None,
            })
            // "Set equal to zero:"
            .or_else(|| (sets == 0).then_some((sets, Vanishing::Display)))?,
        (None, None) => return None,
    };
    let body = match sentence[at] {
        (Token::Math(body), _) => body,
        (_, span) => span,
    };
    let kind = SuppositionKind::Vanishes(kind);
    Some(Supposition { kind, body })
}

/// With one of these a sentence ends that a display says where of.
const WHERE: [&str; 5] = ["for", "at", "if", "when", "where"];

/// "At the highest point the velocity vanishes, so": what has a name, and is not concluded to be zero.
fn named(sentence: &[Placed<'_>]) -> Option<Supposition> {
    let zero = (1..sentence.len()).find(|&at| {
        among(sentence, at, &["vanishes", "vanish"])
            || among(sentence, at, &["is", "are", "becomes"])
                && among(sentence, at + 1, &["zero", "nought"])
    })?;
    let before = &sentence[..zero];
    let is_doubtful = |at: usize| among(sentence, at, &DENYING) || among(sentence, at, &DOUBTFUL);
    let (Token::Word(noun), body) = sentence[zero - 1] else {
        return None;
    };
    let is_noun = zero >= 2 && among(sentence, zero - 2, &["the", "its", "their"]);
    let is_display = among(sentence, zero - 1, &["this", "it"]);
    // "This vanishes for".
    let says_zero = zero + usize::from(!among(sentence, zero, &["vanishes", "vanish"]));
    let leads = || among(sentence, says_zero + 1, &WHERE) && sentence.len() == says_zero + 2;
    let says = match is_display {
        true => leads(),
        false => is_noun && noun.bytes().all(|b| b.is_ascii_lowercase()),
    };
    if !says || (0..sentence.len()).any(is_doubtful) || conclusion::read(before) == Some(true) {
        return None;
    }
    let kind = SuppositionKind::Vanishes(match is_display {
        true => Vanishing::Display,
        false => Vanishing::Named,
    });
    Some(Supposition { kind, body })
}

/// "…, which vanishes at $x = a$" after a display; also "which is zero when", before one.
fn of_display(source: &str, sentence: &[Placed<'_>]) -> Vec<Supposition> {
    let words = |(token, _): &Placed<'_>| !matches!(token, Token::Mark(',' | ';'));
    let Some(first) = sentence.iter().position(words) else {
        return Vec::new();
    };
    let says = |at: usize, words: &[&str]| among(sentence, first + at, words);
    let after = match () {
        () if !says(0, &["which"]) => return Vec::new(),
        () if says(1, &["vanishes"]) => 2,
        () if says(1, &["is", "becomes"]) && says(2, &["zero"]) => 3,
        () => return Vec::new(),
    };
    // "which is zero at $s = 2 f$, where" sets a case.
    let goes_on = among(sentence, sentence.len() - 1, &["where"]);
    if !says(after, &["at", "when", "where", "for"])
        || goes_on && after + 1 < sentence.len() - first
    {
        return Vec::new();
    }
    let (_, span) = sentence[first];
    let kind = SuppositionKind::Vanishes(Vanishing::Told);
    let mut found = vec![Supposition { kind, body: span }];
    match sentence.get(first + after + 1) {
        Some(&(Token::Math(body), _)) if is_value(text(source, body)) => {
            let kind = SuppositionKind::Fact {
                runs_on: true,
                of_case: true,
            };
            found.push(Supposition { kind, body });
            found
        }
        // "which is zero when" leads to where.
        None => found,
        Some(_) => Vec::new(),
    }
}

fn among(sentence: &[Placed<'_>], at: usize, words: &(impl Listed + ?Sized)) -> bool {
    sentence
        .get(at)
        .is_some_and(|(token, _)| token.is_among(words))
}

fn is_zero(source: &str, token: Token<'_>) -> bool {
    match token {
        Token::Word(_) => token.is_among(VANISHES),
        Token::Number(number) => number == "0",
        Token::Math(body) => text(source, body).trim() == "0",
        _ => false,
    }
}

fn text(source: &str, span: Span) -> &str {
    source.get(span.range()).unwrap_or_default()
}
