//! What the text that leads on to a display names without supposing it plainly: "An object at $g = 2 f$ is thus imaged at", "only
//! the decaying term survives, $C = 0$, and", "Rolling means $a = r b$. Adding (1) and (2),".
//!
//! A step that does not follow otherwise is tried with it. It is said of that display alone.

use super::super::conclusion;
use super::super::prose::{Placed, Token, begins_with, ends_sentence};
use super::super::words::Words;
use super::super::{Named, Span};
use super::around::{follows, is_taken_from, says_where};
use super::cases::COMPARED;
use super::denial::Denial;
use super::mathematics::{is_number, is_zero, relates};
use super::words::{BESIDE, DISPUTING, KNOWN, NAMED_BEFORE, RETRACTING, ROOTS};

/// In a sentence with one of these, what is named is not so, or one of several.
static ELSEWHERE: Words = Words::of(&[
    "either",
    "neither",
    "nor",
    "longer",
    "drop",
    "dropping",
    "relax",
    "relaxing",
    "removing",
    "lifting",
    "excluded",
    "excluding",
    "except",
    "trivial",
    "would",
    "could",
    "might",
    "difference",
    "earlier",
    "forgot",
    "last",
    "neglected",
    "previous",
    "previously",
    "violated",
    "violates",
    "was",
    "were",
    "whereas",
    "while",
]);
/// A relation after one of these is so at another time, unless the sentence goes on from it: "The block rises until $m g h = K$, which
/// gives".
static AT_ANOTHER_TIME: Words = Words::of(&["until", "before", "after"]);
/// After a comma these go on from what stands before: "After the last payment $M = 0$, so".
static TAKING_UP: Words = Words::of(&["which", "whence", "so", "hence", "thus", "therefore"]);
static SOLVING: Words = Words::of(&["solve", "solving", "solved", "solves"]);
/// A sentence that begins with one of these goes on with the one before.
static GOING_ON: Words = Words::of(&["there", "then", "here", "hence", "thus", "therefore", "so"]);
/// A number that follows one of these is that of a case.
static SETTING: Words = Words::of(&["for", "when", "if"]);
/// A sentence that begins with one of these sets the scene for the one that goes on from there.
static SCENES: Words = Words::of(&["let", "suppose", "assume", "consider", "imagine", "take"]);
/// Before these words may stand.
static AND_NOW: Words = Words::of(&["now", "next", "then", "finally", "again", "us"]);
/// What is said before one of these is of a case that is over.
pub const GENERAL: [&str; 7] = [
    "general",
    "generally",
    "otherwise",
    "arbitrary",
    "any",
    "all",
    "every",
];
/// A sentence with one of these leaves the case that the one before sets, too.
static LEAVING: Words = Words::of(&["later", "elsewhere", "for", "when", "if"]);
/// No more is taken up, of no more sentences.
const MOST_NAMED: usize = 4;
const MOST_SENTENCES: usize = 4;

/// What these say is near the truth, or is so at times, is what one goes on with.
static NEAR_THE_TRUTH: Words = Words::of(&[
    "approximation",
    "approximate",
    "approximately",
    "hypothesis",
    "should",
    "often",
    "sometimes",
]);

/// The relations that the text before a display names, the nearest sentences first.
pub(in crate::document) fn read(source: &str, tokens: &[Placed<'_>]) -> Vec<Named> {
    let ends = |token: &Placed<'_>| ends_sentence(source, token) || token.0.is_stop();
    let is_value = |own: &Named| source.get(own.body.range()).is_some_and(is_number);
    let leaves = |(token, _): &Placed<'_>| token.is_among(&LEAVING) || token.is_among(&GENERAL);
    let (mut named, mut runs_on, mut is_lost) = (Vec::new(), true, false);
    let (mut all, mut said) = (Vec::new(), 0);
    // "The second body is at rest, $v = 0$. From (1)": that it is 0 is said of the next sentence, too.
    let is_zero = |own: &Named| source.get(own.body.range()).is_some_and(is_zero);
    for (back, sentence) in tokens.rsplit(ends).take(MOST_SENTENCES).enumerate() {
        let own = of_sentence(source, sentence);
        all.extend_from_slice(&own);
        // A number is said in its sentence, and in the one that goes on from there.
        let is_case = |own: &Named| {
            let is_set = || is_under(own.body, sentence) || sets_scene(sentence) || is_zero(own);
            said == 1 && !is_lost && is_set()
        };
        let own = own.into_iter();
        named.extend(own.filter(|own| runs_on || !is_value(own) || is_case(own)));
        runs_on = back == 0 && begins_with(sentence, &GOING_ON);
        // A case that is set in a sentence of its own: "For $c = -1$ nothing is left. (1) becomes".
        // "Solving for $A$" leaves none.
        let is_solved = |at: usize| follows(at, sentence, &SOLVING);
        let mut words = sentence.iter().enumerate();
        is_lost |= words.any(|(at, own)| leaves(own) && !is_solved(at));
        let has_words = sentence.iter().any(|own| matches!(own.0, Token::Word(_)));
        said += usize::from(has_words);
    }
    named.truncate(MOST_NAMED);
    // "Let $y = x^3$ in the first case and $y = x^2$ in the second": neither.
    let parts = |own: &Named| source.get(own.body.range())?.split_once('=');
    let rivals = |a: &Named, b: &Named| match (parts(a), parts(b)) {
        (Some(a), Some(b)) => a.0.trim() == b.0.trim() && a.1.trim() != b.1.trim(),
        _ => false,
    };
    named.retain(|own| !all.iter().any(|other| rivals(own, other)));
    named
}

/// The relations that a sentence names, in order.
fn of_sentence(source: &str, sentence: &[Placed<'_>]) -> Vec<Named> {
    let text = |body: Span| source.get(body.range()).unwrap_or_default();
    let is_math = |(token, _): &Placed<'_>| matches!(token, Token::Math(_));
    if !sentence.iter().any(is_math) {
        return Vec::new();
    }
    let has = |words: &Words| sentence.iter().any(|(token, _)| token.is_among(words));
    let disputes =
        |(token, _): &Placed<'_>| token.is_among(&DISPUTING) && !token.is_among(&NEAR_THE_TRUTH);
    if [&COMPARED, &RETRACTING, &KNOWN, &ELSEWHERE]
        .into_iter()
        .any(has)
        || sentence.iter().any(disputes)
    {
        return Vec::new();
    }
    let mut named = Vec::new();
    let (mut is_drawn, mut elsewhen) = (false, false);
    let mut denial = Denial::None;
    for (at, (token, _)) in sentence.iter().enumerate() {
        match *token {
            Token::Word(_) => {
                is_drawn |= conclusion::draws_on(*token);
                elsewhen |= token.is_among(&AT_ANOTHER_TIME);
                denial = denial.past_word(at, sentence);
            }
            mark @ Token::Mark('(' | ',') => {
                // "Before the collision the second body is at rest, $v = 0$" goes on from there.
                elsewhen = false;
                denial = denial.past_mark(mark);
            }
            token if token.cites() => is_drawn = true,
            Token::Math(body) => {
                // "The derivative at $t = 0$" is of that moment alone.
                let is_place = follows(at, sentence, &NAMED_BEFORE)
                    && !says_where(at, sentence)
                    && is_number(text(body));
                let is_then = !elsewhen || is_taken_up(at, sentence);
                // "But $a = b$" goes on, "all but $a = b$" leaves out.
                let is_beside = at > 1 && follows(at, sentence, &BESIDE);
                let is_taken = is_taken_from(&sentence[at..]);
                let is_so = match denial {
                    Denial::None => true,
                    Denial::Before => is_zero(text(body)),
                    Denial::Here | Denial::Whole => false,
                };
                // "Dividing by $t$ (the root $t = 0$ is the throw itself)" goes on with another.
                let is_root = follows(at, sentence, &ROOTS) && is_number(text(body));
                let is_said = !is_place && !is_beside && is_then && !is_taken && is_so && !is_root;
                if relates(text(body)) && is_said {
                    named.push(Named { body, is_drawn });
                }
            }
            _ => {}
        }
    }
    named
}

/// Whether the sentence goes on from the mathematics at `index`: "…, which with (2) gives".
fn is_taken_up(index: usize, sentence: &[Placed<'_>]) -> bool {
    let mut after = sentence[index + 1..].iter().map(|(token, _)| *token);
    match after.next() {
        Some(Token::Mark(',')) => after.next().is_some_and(|own| own.is_among(&TAKING_UP)),
        _ => false,
    }
}

/// Whether a sentence sets the scene: "Now let a ray in air ($n_1 = 1$) hit a plate of index $n_2 = n$."
fn sets_scene(sentence: &[Placed<'_>]) -> bool {
    let mut words = sentence.iter().map(|(token, _)| token);
    let first = words.find(|token| !token.is_among(&AND_NOW) && !token.is_mark(','));
    first.is_some_and(|token| token.is_among(&SCENES))
}

/// Whether a sentence sets what stands at a place as a case: "For $c = -1$ nothing is left", "It is back when $y = 0$", "It is least when
/// $\cos x = -1$, that is $x = \pi$".
fn is_under(body: Span, sentence: &[Placed<'_>]) -> bool {
    let at = sentence.partition_point(|(_, span)| span.end <= body.start);
    let rest = said_before(at, sentence);
    follows(at, sentence, &SETTING) || rest.is_some_and(|said| follows(said, sentence, &SETTING))
}

/// The mathematics that what stands at a place says again: "$\cos x = -1$, that is, $x = \pi$".
fn said_before(at: usize, sentence: &[Placed<'_>]) -> Option<usize> {
    let is_comma = |token: &Placed<'_>| token.0 == Token::Mark(',');
    let mut before = (0..at).rev().filter(|&at| !is_comma(&sentence[at]));
    let mut next = || before.next();
    let is = |at: usize, word: &str| sentence[at].0.is_among(&[word]);
    let (is_so, that) = (next()?, next()?);
    let said = next()?;
    let is_math = matches!(sentence[said].0, Token::Math(_));
    (is(is_so, "is") && is(that, "that") && is_math).then_some(said)
}
