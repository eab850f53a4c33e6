//! Slopes by what the text names that are zero: "Setting the derivatives with respect to $a$ and $b$ to zero gives", "The derivative of
//! $E$ with respect to $x$ vanishes for", "Minimizing $K$ over $q$ yields".

use super::super::conclusion;
use super::super::prose::{Placed, Token, among};
use super::super::words::Words;
use super::super::{Span, Supposition, SuppositionKind};
use super::mathematics::{is_letters, says_zero, text};
use super::words::{DENYING, DOUBTFUL};

/// What is zero is called so.
const SLOPES: &[&str] = &["derivative", "derivatives", "slope", "slopes", "gradient"];
/// A derivative with one of these is another one.
const OTHERS: &[&str] = &["second", "third", "higher", "mixed", "total"];
/// These look for where it is.
static EXTREMIZING: Words = Words::of(&[
    "minimizing",
    "minimising",
    "minimize",
    "minimise",
    "maximizing",
    "maximising",
    "maximize",
    "maximise",
    "extremizing",
    "extremising",
    "optimizing",
    "optimising",
]);
/// So many variables are named at once.
const MOST_VARIABLES: usize = 4;
/// How many tokens may stand between the slope, what it is by, and that it is zero.
const MOST_BETWEEN: usize = 8;

/// The slopes that a sentence says to be zero, one for each variable.
pub(super) fn read(source: &str, sentence: &[Placed<'_>]) -> Vec<Supposition> {
    let Some((start, by)) =
        (0..sentence.len()).find_map(|at| Some((at, begin_of_list(sentence, at)?)))
    else {
        return Vec::new();
    };
    let variables = listed(source, &sentence[by..]);
    let before = &sentence[..start];
    let doubts = |(token, _): &Placed<'_>| token.is_among(&DENYING) || token.is_among(&DOUBTFUL);
    if variables.is_empty() || sentence.iter().any(doubts) {
        return Vec::new();
    }
    let near = start.saturating_sub(MOST_BETWEEN);
    let slope = (near..start).rfind(|&at| among(sentence, at, SLOPES));
    let other = (near..start).any(|at| among(sentence, at, OTHERS));
    let rest = (by..sentence.len()).take(MOST_BETWEEN);
    let mut rest = rest.take_while(|&at| !conclusion::draws_on(sentence[at].0));
    let is_zero = |at: usize| says_zero(source, sentence[at].0);
    let extremizes = before.iter().any(|(token, _)| token.is_among(&EXTREMIZING));
    let is_set = slope.is_some() && !other && rest.any(is_zero);
    if !is_set && !extremizes {
        return Vec::new();
    }
    // "the derivative of (1)", "Minimizing $K$"
    let named = before[slope.unwrap_or(near)..].iter();
    let mut of = named.filter_map(|&(token, span)| match token {
        token if token.cites() => Some(span),
        Token::Math(body) if is_letters(text(source, body)) => Some(body),
        _ => None,
    });
    let of = of.next_back();
    let partial = variables.len() > 1 || before.iter().any(|own| own.0.is_among(&["partial"]));
    let supposed = variables.into_iter().map(|body| Supposition {
        kind: SuppositionKind::StationaryBy { of, partial },
        body,
    });
    supposed.collect()
}

/// Where the list of variables begins, if what comes before it begins at a place: "with respect to", "over".
fn begin_of_list(sentence: &[Placed<'_>], at: usize) -> Option<usize> {
    let says = |at: usize, word: &str| among(sentence, at, &[word]);
    match () {
        () if says(at, "with") && says(at + 1, "respect") && says(at + 2, "to") => Some(at + 3),
        () if says(at, "over") => Some(at + 1),
        () => None,
    }
}

/// "$x$, $y$ and $z$", "both $a$ and $b$"
fn listed(source: &str, rest: &[Placed<'_>]) -> Vec<Span> {
    let mut found = Vec::new();
    for (token, _) in rest {
        match token {
            Token::Math(body) if is_letters(text(source, *body)) => found.push(*body),
            Token::Mark(',') => {}
            token if token.is_among(&["and", "both", "the", "parameters", "parameter"]) => {}
            _ => break,
        }
    }
    found.truncate(MOST_VARIABLES);
    found
}
