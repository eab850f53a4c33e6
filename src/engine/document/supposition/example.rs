//! The values of a numerical example: "With $m = 3$ kg, $g = 9.8$ m/s² and a load $F = 50$ N, (6) yields", "For a numerical example take
//! $T_1 = 300$ K and $T_3 = 2700$ K. From (12)".
//!
//! Several numbers that one sentence lists, each for a symbol or for a term, are put in by the displays after it that come to numbers.

use super::super::conclusion;
use super::super::prose::{Placed, Token, ends_sentence};
use super::super::words::Words;
use super::super::{Span, Supposition, SuppositionKind};
use super::mathematics::{is_figure, is_value, relates, stated, text};
use super::words::{DENYING, NEGATING, RETRACTING};

/// A list of values follows one of these, with a few words between: "a slab with density $\rho = 2$".
static LISTING: Words = Words::of(&[
    "with",
    "for",
    "take",
    "takes",
    "taking",
    "let",
    "put",
    "putting",
    "set",
    "setting",
    "consider",
    "considering",
    "choose",
    "choosing",
    "assume",
    "assuming",
    "suppose",
    "supposing",
    "use",
    "using",
    "given",
    "insert",
    "inserting",
    "substituting",
    "if",
]);
/// A sentence with one of these gives an example, be it of one value.
static EXAMPLES: Words = Words::of(&[
    "example",
    "instance",
    "illustration",
    "numerical",
    "numerically",
    "numbers",
    "concreteness",
]);
/// Between two values these say that no list goes on there.
static PARTING: Words = Words::of(&[
    "or", "then", "so", "is", "are", "was", "were", "be", "has", "have", "had", "where", "if",
    "when", "but", "versus", "instead", "than", "to", "from", "until", "at", "while", "whereas",
    "after", "before", "for", "becomes", "up", "down",
]);
/// Before a list these say that it is not so; what goes on from one may well say what would be so with it.
static DOUBTED: Words = Words::of(&["would", "could", "might"]);
/// Before a list, and in what goes on from it, these say that it is not so.
static DISPUTED: Words = Words::of(&[
    "unlike",
    "either",
    "neither",
    "whether",
    "contrary",
    "contrast",
    "unless",
    "until",
    "tried",
    "mistakenly",
]);
/// So many words lead from what begins a list to the first value: "for a steel ruler of length".
const MOST_LEADING: usize = 8;
/// So many tokens stand between two values: ` kg m`$^{-3}$`, and a mean density`.
const MOST_BETWEEN: usize = 9;
/// So many tokens a unit has.
const LONGEST_UNIT: usize = 6;
/// In a longer sentence nothing is looked for.
const LONGEST: usize = 200;

/// Takes up the values of examples as what they are, whatever else was told by them; and says whether any were added at the end.
pub(super) fn take_up(
    source: &str,
    tokens: &[Placed<'_>],
    found: &mut Vec<Supposition>,
    mentions: &mut Vec<Span>,
) -> bool {
    let known = found.len();
    use SuppositionKind::{Fact, Meaning};
    let is_math = |(token, _): &Placed<'_>| matches!(token, Token::Math(_));
    let mut start = 0;
    while start < tokens.len() {
        let stop = tokens[start..]
            .iter()
            .position(|(token, _)| token.is_stop());
        let end = stop.map_or(tokens.len(), |stop| start + stop);
        let sentence = &tokens[start..end];
        let leads = end == tokens.len();
        let asks = stop.is_some() && source.get(tokens[end].1.range()) == Some("?");
        // A sentence that only ends a paragraph may be a heading.
        let ends = leads || ends_sentence(source, &tokens[end]);
        start = end + 1;
        if !sentence.iter().any(is_math) || sentence.len() > LONGEST || asks || !ends {
            continue;
        }
        let bodies = listed(source, sentence, leads);
        // What is set all through, "Set $m = 1$ and $k = 1$", is no example.
        let is_set = |body: &Span| {
            let own = found.iter().find(|own| own.body == *body);
            own.is_some_and(|own| !matches!(own.kind, Fact { .. } | Meaning))
        };
        if !bodies.iter().all(is_set) {
            bodies
                .into_iter()
                .for_each(|body| put_in(body, found, mentions));
        }
    }
    found.len() > known
}

/// Says of inline mathematics that it is a value of an example, unless more is known of it.
fn put_in(body: Span, found: &mut Vec<Supposition>, mentions: &mut Vec<Span>) {
    use SuppositionKind::{Case, Fact, Meaning};
    let kind = SuppositionKind::Figure;
    mentions.retain(|own| *own != body);
    match found.iter_mut().find(|own| own.body == body) {
        Some(own) if matches!(own.kind, Case { .. } | Fact { .. } | Meaning) => own.kind = kind,
        Some(_) => {}
        None => found.push(Supposition { kind, body }),
    }
}

/// The values that a sentence lists, if it says that they are those of an example.
fn listed(source: &str, sentence: &[Placed<'_>], leads: bool) -> Vec<Span> {
    let value = |at: usize| match sentence[at].0 {
        Token::Math(body) => {
            let text = text(source, body);
            (is_value(text) && is_figure(text)).then_some(body)
        }
        _ => None,
    };
    let Some(first) = (0..sentence.len()).find(|&at| value(at).is_some()) else {
        return Vec::new();
    };
    let mut bodies = Vec::new();
    let mut last = first;
    while let Some(body) = value(last) {
        bodies.push(body);
        let rest = &sentence[last + 1..];
        let next = rest
            .iter()
            .take(MOST_BETWEEN)
            .position(|(token, _)| stated(source, *token).is_some());
        match next {
            Some(between) if goes_on(source, &rest[..between]) => last += between + 1,
            _ => break,
        }
    }
    let after = &sentence[last + usize::from(value(last).is_some())..];
    let is_one = bodies.len() == 1;
    let is_example = || sentence.iter().any(|(token, _)| token.is_among(&EXAMPLES));
    let ends = after.len() <= unit(source, after);
    let is_list = (!is_one || is_example() && ends && !leads)
        && (leads || ends)
        && introduced(&sentence[..first])
        && is_sure(source, after)
        && !bodies
            .iter()
            .any(|body| text(source, *body).trim_end().ends_with("= 0"))
        && !gives_two(source, &bodies);
    match is_list {
        true => bodies,
        false => Vec::new(),
    }
}

/// Whether what stands between two values joins them to a list: a unit, a comma or an "and", and what the next one is of.
fn goes_on(source: &str, between: &[Placed<'_>]) -> bool {
    let unit = unit(source, between);
    let rest = &between[unit..];
    let joins = |(token, _): &Placed<'_>| token.is_mark(',') || token.is_among(&["and", "with"]);
    let names = |(token, _): &Placed<'_>| match token {
        Token::Word(word) => {
            !token.is_among(&PARTING)
                && !token.is_among(&DENYING)
                && !token.is_among(&NEGATING)
                && !conclusion::draws(word)
        }
        Token::Math(_) => true,
        token => token.is_mark(',') || matches!(token, Token::Dash),
    };
    rest.first().is_some_and(joins) && rest.iter().all(names)
}

/// How many tokens the unit has that a value ends in: "kg", "m/s²", "kg m$^{-3}$", "per year".
fn unit(source: &str, tokens: &[Placed<'_>]) -> usize {
    let is_part = |(token, span): &&Placed<'_>| match token {
        Token::Word(word) => {
            !token.is_among(&PARTING)
                && !token.is_among(&["and", "with", "we"])
                && !conclusion::draws(word)
        }
        Token::Number(_) | Token::Dash => true,
        Token::Math(body) => !relates(text(source, *body)),
        Token::Mark(_) => matches!(
            source.get(span.range()),
            Some("/" | "%" | "°" | "·" | "^" | "Ω" | "µ" | "(" | ")")
        ),
        _ => false,
    };
    tokens.iter().take(LONGEST_UNIT).take_while(is_part).count()
}

/// Whether the words before a list begin one: none, "Example:", or "For a steel ruler with".
fn introduced(before: &[Placed<'_>]) -> bool {
    let is_word = |(token, _): &Placed<'_>| {
        let disputed = token.is_among(&DISPUTED) || token.is_among(&NEGATING);
        matches!(token, Token::Word(_)) && !disputed
    };
    let heads = match before {
        [] => return true,
        [words @ .., (colon, _)] if colon.is_mark(':') => words,
        _ => &[],
    };
    if !heads.is_empty() {
        return heads.len() <= MOST_LEADING && heads.iter().all(is_word);
    }
    let lists = before
        .iter()
        .rposition(|(token, _)| token.is_among(&LISTING));
    let disputed = |(token, _): &Placed<'_>| {
        token.is_among(&DISPUTED)
            || token.is_among(&DOUBTED)
            || token.is_among(&NEGATING)
            || token.is_among(&RETRACTING)
    };
    lists.is_some_and(|at| {
        let between = &before[at + 1..];
        let draws = |(token, _): &Placed<'_>| conclusion::draws_on(*token);
        between.len() <= MOST_LEADING
            && between.iter().all(|own| is_word(own) || own.0.is_mark(','))
            && !between.iter().any(draws)
            && !before.iter().any(disputed)
    })
}

/// Whether what comes after a list goes on from it: neither is the last value one of a place or a moment, "$x = 2$ at $t = 0$", nor is it denied.
fn is_sure(source: &str, after: &[Placed<'_>]) -> bool {
    let unit = after.iter().take(LONGEST_UNIT);
    let at = unit
        .take_while(|(token, _)| !token.is_among(&["at", "when"]))
        .count();
    let placed = match (after.get(at), after.get(at + 1)) {
        (Some((token, _)), Some((Token::Math(body), _))) => {
            token.is_among(&["at", "when"]) && relates(text(source, *body))
        }
        _ => false,
    };
    let denies = |(token, _): &Placed<'_>| {
        token.is_among(&DISPUTED) || token.is_among(&["not", "never", "cannot", "or"])
    };
    !placed && !after.iter().any(denies)
}

/// Whether two of the values are of the same thing: then neither is that of all that follows.
fn gives_two(source: &str, bodies: &[Span]) -> bool {
    let left = |body: &Span| {
        text(source, *body)
            .split('=')
            .next()
            .unwrap_or_default()
            .trim()
    };
    let mut rest = bodies;
    while let [first, others @ ..] = rest {
        if others.iter().any(|other| left(other) == left(first)) {
            return true;
        }
        rest = others;
    }
    false
}
