//! Whether prose goes on with the display before it: "which by (2) is", "Comparing this with (1)".

use super::super::inserted::INSERTING;
use super::super::prose::{Placed, Token, ends_sentence};
use super::draws_on;

/// With these a sentence whose end stands after a display says what that comes from.
const FROM: [&str; 12] = [
    "by",
    "from",
    "using",
    "via",
    "through",
    "with",
    "because",
    "since",
    "due",
    "according",
    "thanks",
    "where",
];

/// Whether the first sentence is about the display before it: "which by (2) is"; or the last one is.
pub(in crate::document) fn is_relative(tokens: &[Placed<'_>], last: &[Placed<'_>]) -> bool {
    let first = tokens
        .iter()
        .find(|(token, _)| !matches!(token, Token::Mark(',' | ';')));
    matches!(first, Some((Token::Word("which"), _)))
        || works_on_it(last)
        || works_on_this(tokens)
        || puts_this_in(last)
}

/// "Substituting back into (6)", "putting this into (1)": what is put in is what stands before.
fn puts_this_in(last: &[Placed<'_>]) -> bool {
    const WHAT: &[&str] = &[
        "this", "these", "result", "results", "value", "values", "back",
    ];
    let Some(at) = last.iter().position(|own| own.0.is_among(INSERTING)) else {
        return false;
    };
    let rest = &last[at + 1..];
    let named = rest.iter().take_while(|own| own.0.is_among(WHAT)).count();
    matches!(rest.get(named..), Some([(into, _), (cited, _), ..])
        if named > 0 && into.is_among(&["in", "into"]) && cited.cites())
}

/// "Comparing this with (1)", "At the top, $r = a$, this gives with (1)", "With (1) this can be written as", "and when this is used in (1)": where
/// nothing else is said after the display before, that is what is meant.
fn works_on_this(tokens: &[Placed<'_>]) -> bool {
    const WORKED_ON_THIS: &[&str] = &["comparing", "combining", "equating"];
    const PUT_IN: &[&str] = &["used", "inserted", "substituted", "put"];
    const REWORKED: &[&str] = &[
        "brought",
        "written",
        "rewritten",
        "put",
        "cast",
        "expressed",
        "simplified",
        "reduced",
        "rearranged",
        "recast",
    ];
    let words =
        |sentence: &&[Placed<'_>]| sentence.iter().any(|own| matches!(own.0, Token::Word(_)));
    let mut sentences = tokens.split(|own| own.0.is_stop()).filter(words);
    let (Some(sentence), None) = (sentences.next(), sentences.next()) else {
        return false;
    };
    let gives = |pair: &[Placed<'_>]| pair[0].0.is_among(&["this"]) && draws_on(pair[1].0);
    let is_reworked = |own: &[Placed<'_>]| {
        matches!(own, [(this, _), (may, _), (be, _), (reworked, _)]
            if this.is_among(&["this"]) && may.is_among(&["can", "may"]) && be.is_among(&["be"]) && reworked.is_among(REWORKED))
    };
    // "and when this is used in (2) one gets"
    let is_put_in = |own: &[Placed<'_>]| {
        matches!(own, [(this, _), (is, _), (put, _), (into, _)]
            if this.is_among(&["this"]) && is.is_among(&["is"]) && put.is_among(PUT_IN) && into.is_among(&["in", "into"]))
    };
    let this_gives = || {
        sentence.windows(2).any(gives)
            || sentence
                .windows(4)
                .any(|own| is_reworked(own) || is_put_in(own))
    };
    let is_worked_on = matches!(sentence, [(works, _), (this, _), (with, _), ..]
        if works.is_among(WORKED_ON_THIS) && this.is_among(&["this"]) && with.is_among(&["with", "to", "and"]));
    is_worked_on || this_gives()
}

/// What is done with the display before where nothing else is named: "Differentiating with respect to time and using (1)".
const WORKED_ON: [&str; 7] = [
    "differentiating",
    "integrating",
    "squaring",
    "rearranging",
    "simplifying",
    "expanding",
    "solving",
];
/// Between what is done and what it is done with.
const WORKED_WITH: [&str; 5] = ["using", "with", "by", "inserting", "substituting"];

/// Whether the last sentence begins with what is done, names nothing that it is done to, and goes on with what is used for it.
fn works_on_it(last: &[Placed<'_>]) -> bool {
    let Some(((first, _), rest)) = last.split_first() else {
        return false;
    };
    if !first.is_among(&WORKED_ON) {
        return false;
    }
    // "with respect to" names no means.
    let is_means = |at: usize| {
        let of = rest
            .get(at + 1)
            .is_some_and(|(next, _)| next.is_among(&["respect"]));
        rest[at].0.is_among(&WORKED_WITH) && !of
    };
    let Some(means) = (0..rest.len()).find(|&at| is_means(at)) else {
        return false;
    };
    let is_object = |(token, _): &Placed<'_>| token.cites();
    !rest[..means].iter().any(is_object)
}

/// Whether a text goes on with what was said before the display before it, and concludes nothing: "and perpendicular to it".
pub(in crate::document) fn goes_on_with_and(
    tokens: &[Placed<'_>],
    concludes: Option<bool>,
) -> bool {
    let begins = matches!(tokens.first(), Some((Token::Word("and" | "while"), _)));
    let mut all = tokens.iter();
    let is_one = !all.any(|(token, _)| token.is_stop() || token.cites());
    begins && is_one && concludes == Some(false)
}

/// Whether a text goes on with the sentence that the display before it stands in, up to the next one: "and the variance (1) is then".
pub(in crate::document) fn joins(tokens: &[Placed<'_>]) -> bool {
    let first = tokens.first().map(|(token, _)| *token);
    let goes_on = match first {
        Some(Token::Word(word)) => word.starts_with(char::is_lowercase),
        _ => false,
    };
    goes_on && !tokens.iter().any(|(token, _)| token.is_stop())
}

/// The end of a sentence that a display stands in, if the text goes on with it: up to the full stop.
pub(in crate::document) fn tail<'t, 'a>(
    source: &str,
    tokens: &'t [Placed<'a>],
) -> &'t [Placed<'a>] {
    let ends = |token: &Placed<'_>| ends_sentence(source, token);
    let goes_on = |word: &str| word.starts_with(char::is_lowercase);
    match (tokens.first(), tokens.iter().position(ends)) {
        (Some((Token::Word(word), _)), Some(end)) if goes_on(word) => &tokens[..end],
        _ => &[],
    }
}

/// Whether the end of a sentence says what the display in it comes from: "by (2)". In "where (5) follows from" it says that of what it cites.
pub(in crate::document) fn says_from(tail: &[Placed<'_>]) -> bool {
    const FOLLOWS: &[&str] = &["follows", "comes", "results", "is", "was", "has", "holds"];
    let first = tail.first().map(|(token, _)| *token);
    let cited = tail.iter().position(|(token, _)| token.cites());
    let follows = cited
        .and_then(|at| tail.get(at + 1))
        .is_some_and(|(next, _)| next.is_among(FOLLOWS));
    let is_where = matches!(first, Some(Token::Word("where")));
    matches!(first, Some(Token::Word(word)) if FROM.contains(&word)) && !(is_where && follows)
}
