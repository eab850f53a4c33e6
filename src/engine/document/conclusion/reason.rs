//! The reason that a sentence gives in words: a law by its name, what is so "since" something, circumstances.

use super::super::Span;
use super::super::prose::{Placed, Token};
use super::super::supposition::stated;
use super::draws_on;
use super::outside;
use super::words::{LAWS, OF_ALGEBRA, WORKED};

/// Between what is done and the law that it is done by: "we obtain from energy conservation".
const LEADING: [&str; 8] = [
    "from", "by", "using", "with", "through", "via", "applying", "of",
];
/// None of these is part of a law's name, nor what comes before it.
const OUTSIDE: [&str; 14] = [
    "from", "by", "using", "with", "through", "via", "applying", "of", "the", "a", "and", "to",
    "this", "since",
];
/// A name has no more words before "law", nor after "conservation of".
const LONGEST_NAME: usize = 4;
/// After these comes a reason.
const BECAUSE: [&str; 2] = ["since", "because"];
/// Between a reason in words and what follows from it: "No heat is lost, so".
const THEREFORE: [&str; 5] = ["so", "hence", "thus", "therefore", "whence"];

/// A reason has no fewer words.
const LEAST_REASON: usize = 3;

/// These divide.
const DIVIDING: [&str; 6] = [
    "divide", "divides", "dividing", "divided", "division", "ratio",
];
/// Rules for slopes that nobody needs for a factor that is constant.
const OF_FACTORS: [&str; 3] = ["product", "quotient", "leibniz"];

/// Whether the last sentence divides one equation by another: what it divides by is meant not to vanish.
pub(in crate::document) fn divides(last: &[Placed<'_>]) -> bool {
    last.iter().any(|(token, _)| token.is_among(&DIVIDING))
}

/// Whether the last sentence names the rule for the slope of a product, of which every factor changes.
pub(in crate::document) fn names_rule_of_factors(last: &[Placed<'_>]) -> bool {
    let is_rule = |(token, _): &Placed<'_>| token.is_among(&["rule", "rules"]);
    // "Leibniz' rule", "the product and chain rules".
    let mut from = (0..last.len()).filter(|&at| last[at].0.is_among(&OF_FACTORS));
    from.any(|at| last[at + 1..].iter().take(3).any(is_rule))
}

/// Whether the last sentence gives a reason that is no equation: a law by its name, words after "since", what something is said to come
/// from, what is known.
///
/// `before` are the sentences before the last one, back to the display before.
pub(in crate::document) fn reasons_in_words(
    source: &str,
    before: &[Placed<'_>],
    last: &[Placed<'_>],
) -> bool {
    let among = |words: &'static [&str]| move |(token, _): &Placed<'_>| token.is_among(words);
    let is_equation = |own: &Placed<'_>| is_equation(source, own);
    let since = last.iter().position(among(&BECAUSE));
    let reason = since.map(|since| &last[since + 1..]);
    let is_said = |words: &[Placed<'_>]| !words.is_empty() && !words.iter().any(is_equation);
    let gives_one = || {
        names_a_law(last)
            || puts_circumstances(last)
            || concludes_from_words(last)
            || outside::is_named(last)
            || outside::is_stated_before(before, last) && !before.iter().any(is_equation)
    };
    reason.is_some_and(is_said) || is_said(last) && gives_one()
}

/// Whether it is an equation, or cites one.
fn is_equation(source: &str, (token, _): &Placed<'_>) -> bool {
    token.cites() || stated(source, *token).is_some()
}

/// Whether a law is named that may be a reason. "This gives Snell's law" names what is concluded.
fn names_a_law(sentence: &[Placed<'_>]) -> bool {
    laws(sentence).next().is_some()
}

/// The names of laws that the last sentence gives for a reason: "conservation of momentum", "Newton's second law".
pub(in crate::document) fn laws_named(last: &[Placed<'_>]) -> Vec<Span> {
    let named = laws(last).filter_map(|law| {
        let joins = |(token, _): &&Placed<'_>| match token {
            Token::Word(_) => !draws_on(*token) && !token.is_among(&OUTSIDE),
            token => matches!(token, Token::Mark('\'' | '’')),
        };
        let before = last[..law].iter().rev().take(LONGEST_NAME);
        let start = law - before.take_while(joins).count();
        let of = last.get(law + 1);
        let end = match of.is_some_and(|(token, _)| token.is_among(&["of"])) {
            true => {
                let after = last[law + 2..].iter().take(LONGEST_NAME);
                law + 1
                    + after
                        .take_while(|own| joins(own) || own.0.is_among(&["the"]))
                        .count()
            }
            false => law,
        };
        Some(last.get(start)?.1.to(last.get(end)?.1))
    });
    named.collect()
}

/// Where laws are named in a sentence that may be reasons.
fn laws(sentence: &[Placed<'_>]) -> impl Iterator<Item = usize> {
    let among = |words: &'static [&str]| move |(token, _): &Placed<'_>| token.is_among(words);
    let concludes =
        |(token, _): &Placed<'_>| draws_on(*token) || token.is_among(&["derived", "derive"]);
    (0..sentence.len()).filter(move |&law| {
        let is_reason = || {
            let verb = sentence[..law].iter().rposition(concludes);
            verb.is_none_or(|verb| sentence[verb..law].iter().any(among(&LEADING)))
        };
        sentence[law].0.is_among(&LAWS) && is_reason()
    })
}

/// Whether the last sentence puts a condition in words alone: what is concluded is so under that.
pub(in crate::document) fn puts_condition(source: &str, last: &[Placed<'_>]) -> bool {
    let is_then = |(token, _): &Placed<'_>| token.is_among(&["then"]);
    let condition = last.iter().position(is_then).map(|then| &last[..then]);
    puts_circumstances(last)
        && condition.is_some_and(|own| !own.iter().any(|own| is_equation(source, own)))
}

/// "If the pressure is read from a manometer, then": circumstances in words, of which something else is so.
fn puts_circumstances(sentence: &[Placed<'_>]) -> bool {
    let begins = sentence
        .first()
        .is_some_and(|(token, _)| token.is_among(&["if"]));
    let then = sentence
        .iter()
        .position(|(token, _)| token.is_among(&["then"]));
    let works = |(token, _): &Placed<'_>| token.is_among(&WORKED) || token.is_among(&["we"]);
    begins && then.is_some_and(|then| then > LEAST_REASON && !sentence[..then].iter().any(works))
}

/// "No heat is lost, so": a sentence that draws one conclusion, from words that say how things are.
fn concludes_from_words(sentence: &[Placed<'_>]) -> bool {
    // "All of them must add up to one, which gives"
    let gives = |at: usize| {
        sentence
            .get(at + 1)
            .is_some_and(|(token, _)| draws_on(*token))
    };
    let concludes = |at: &usize| {
        let token = sentence[*at].0;
        token.is_among(&THEREFORE) || token.is_among(&["which"]) && gives(*at)
    };
    let Some(so) = (0..sentence.len()).find(concludes) else {
        return false;
    };
    let reason = &sentence[..so];
    // "It must be equal to one" is said of what is displayed.
    let back = |(token, _): &Placed<'_>| token.is_among(&["it", "this", "that", "they"]);
    let of_it = reason.iter().any(back);
    let is_work = |token: Token<'_>| {
        token.is_among(&WORKED) && (of_it || !token.is_among(&["must", "always"]))
    };
    let works = |(token, _): &Placed<'_>| {
        draws_on(*token) || is_work(*token) || token.is_among(&OF_ALGEBRA)
    };
    let ends = matches!(
        reason.last(),
        Some((Token::Mark(',' | ';') | Token::Dash, _))
    ) || reason
        .last()
        .is_some_and(|(token, _)| token.is_among(&["and"]));
    let words = reason
        .iter()
        .filter(|own| matches!(own.0, Token::Word(_)))
        .count();
    ends && words >= LEAST_REASON && !reason.iter().any(works)
}
