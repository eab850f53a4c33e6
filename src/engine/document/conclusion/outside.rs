//! What a step is said to come from, where that is in no display: "Normalisation gives", "By similar triangles,", "Neglecting friction we
//! get", "The string does not stretch. Hence".

use super::super::prose::{Placed, Token};
use super::super::words::Words;
use super::words::{OF_ALGEBRA, WORKED};
use super::{draws_on, last_sentence};

/// After what is named first, these say that something comes from it.
static GIVING: Words = Words::of(&[
    "gives", "give", "gave", "yields", "yield", "yielded", "implies", "imply", "requires",
    "require", "demands", "demand", "tells", "tell", "says", "say", "shows", "show", "leads",
    "lead", "fixes", "fix", "provides", "provide", "predicts", "predict",
]);
/// Before what something comes from.
static FROM: Words = Words::of(&[
    "by",
    "from",
    "using",
    "applying",
    "under",
    "through",
    "via",
    "according",
    "due",
    "thanks",
    "invoking",
]);
/// These point back to what is displayed, or to how one works with it.
static BACK: Words = Words::of(&[
    "this",
    "that",
    "it",
    "which",
    "these",
    "those",
    "both",
    "them",
    "they",
    "former",
    "latter",
    "first",
    "second",
    "third",
    "last",
    "previous",
    "preceding",
    "earlier",
    "above",
    "below",
    "following",
    "next",
    "here",
    "there",
    "same",
    "other",
    "one",
    "definition",
    "definitions",
    "formula",
    "formulas",
    "formulae",
    "relation",
    "relations",
    "eq",
    "eqs",
    "line",
    "lines",
    "step",
    "steps",
    "identity",
    "inequality",
    "substitution",
    "elimination",
    "differentiation",
    "integration",
    "rearrangement",
    "simplification",
    "insertion",
    "comparison",
    "division",
    "multiplication",
    "addition",
    "subtraction",
    "expansion",
    "factorisation",
    "factorization",
    "combination",
    "evaluation",
    "iteration",
    "induction",
    "inspection",
    "algebra",
    "calculus",
    "arithmetic",
    "chain",
    "quotient",
    "binomial",
    "quadratic",
    "rule",
    "logarithm",
    "logarithms",
    "exponential",
    "exponentials",
    "reciprocal",
    "reciprocals",
    "limit",
    "limits",
    "value",
    "values",
    "number",
    "numbers",
    "data",
    "example",
    "case",
    "cases",
    "part",
    "parts",
    "each",
    "now",
    "general",
    "particular",
    "addition",
    "fact",
    "total",
    "turn",
    "summary",
    "short",
    "detail",
    "contrast",
    "practice",
    "words",
    "way",
    "order",
    "instance",
    "simplicity",
    "consequence",
    "conclusion",
    "brief",
    "once",
    "end",
    "effect",
    "full",
    "place",
    "hand",
    "form",
    "units",
]);
/// What is done with displays, besides what is worked with them.
static DONE: Words = Words::of(&[
    "taking",
    "inverting",
    "working",
    "cubing",
    "doubling",
    "halving",
    "calculating",
    "computing",
    "minimising",
    "minimizing",
    "maximising",
    "maximizing",
    "optimising",
    "optimizing",
    "replacing",
    "introducing",
    "choosing",
    "setting",
    "putting",
    "letting",
    "writing",
    "noting",
    "recalling",
    "considering",
    "looking",
    "going",
    "returning",
    "starting",
    "inserting",
    "repeating",
    "continuing",
    "proceeding",
    "treating",
    "reading",
    "defining",
    "being",
    "having",
    "using",
    "applying",
    "invoking",
    "according",
    "combining",
    "following",
    "depending",
    "beginning",
    "turning",
    "changing",
    "varying",
    "keeping",
    "holding",
    "grouping",
    "cancelling",
    "carrying",
    "telescoping",
]);
/// Before the circumstances in which something is so.
static IN: Words = Words::of(&[
    "in", "at", "for", "on", "near", "during", "after", "before", "within", "without", "inside",
    "outside",
]);
/// What is "fixed by normalisation".
static SETTLED: Words = Words::of(&[
    "fixed",
    "given",
    "determined",
    "governed",
    "described",
    "dictated",
    "limited",
]);
/// What is "found from the angle of the string".
static FOUND: Words = Words::of(&[
    "found",
    "obtained",
    "follows",
    "calculated",
    "computed",
    "read",
]);
/// What is known is not derived where that is said.
const KNOWN: [&[&str]; 6] = [
    &["is", "known"],
    &["well", "known"],
    &["turns", "out"],
    &["can", "be", "shown"],
    &["can", "show"],
    &["we", "know"],
];
/// "As a fraction of", "as before": no reason comes after "as".
static NO_REASON: Words = Words::of(&[
    "a", "an", "in", "before", "above", "for", "expected", "required", "well", "usual", "long",
    "soon", "to", "stated", "claimed", "promised", "desired", "seen", "shown", "follows", "of",
    "at", "is",
]);
/// Nobody says how things are with these: "We now turn to the speed."
static OF_AUTHORS: Words = Words::of(&["we", "us", "let", "i", "now", "our", "consider"]);

/// A clause that says how something is has no fewer words.
const LEAST_CLAUSE: usize = 3;
/// What is named has no more words.
const MOST_NAMED: usize = 9;

/// Whether a sentence names what the next display comes from, and that is in no display.
pub(super) fn is_named(sentence: &[Placed<'_>]) -> bool {
    is_subject(sentence)
        || is_source(sentence)
        || is_circumstance(sentence)
        || is_clause(sentence)
        || is_known(sentence)
}

/// Whether words speak of what is outside of all displays, and of that alone.
fn is_outside(words: &[Placed<'_>]) -> bool {
    let is_word = |(token, _): &Placed<'_>| matches!(token, Token::Word(_));
    let count = words.iter().filter(|own| is_word(own)).count();
    let points_back = |(token, _): &Placed<'_>| {
        token.is_among(&BACK)
            || token.is_among(&WORKED)
            || token.is_among(&OF_ALGEBRA)
            || draws_on(*token)
    };
    (1..=MOST_NAMED).contains(&count) && !words.iter().any(points_back)
}

/// "Normalisation gives", "Similar triangles then yield".
fn is_subject(sentence: &[Placed<'_>]) -> bool {
    let gives = |(token, _): &Placed<'_>| token.is_among(&GIVING);
    let Some(verb) = sentence.iter().position(gives) else {
        return false;
    };
    let mut subject = &sentence[..verb];
    while let [before @ .., (last, _)] = subject
        && last.is_among(&[
            "then",
            "now",
            "also",
            "immediately",
            "directly",
            "thus",
            "therefore",
        ])
    {
        subject = before;
    }
    let begins = subject.first();
    !begins.is_some_and(|(first, _)| {
        is_done(*first) || first.is_among(&FROM) || first.is_among(&OF_AUTHORS)
    }) && is_outside(subject)
}

/// "By similar triangles,", "From the geometry we read off", "In the steady state we find"; "The constant is fixed by normalisation:".
fn is_source(sentence: &[Placed<'_>]) -> bool {
    let names = |from: usize| {
        let rest = sentence.get(from..).unwrap_or_default();
        !rest.is_empty() && is_outside(&rest[..opening(rest)])
    };
    let settles = |pair: &[Placed<'_>]| {
        let [(verb, _), (by, _)] = pair else {
            return false;
        };
        verb.is_among(&SETTLED) && by.is_among(&["by"])
            || verb.is_among(&FOUND) && by.is_among(&["from"])
    };
    // "At the maximum" alone says where, "in the steady state we find" draws on it.
    let back = |(token, _): &Placed<'_>| token.is_among(&["it", "this", "they", "which", "these"]);
    let draws = || {
        let draws = sentence.iter().any(|(token, _)| draws_on(*token));
        draws && !sentence.iter().any(back)
    };
    let begins = |(first, _): &Placed<'_>| first.is_among(&FROM) || first.is_among(&IN) && draws();
    sentence.first().is_some_and(begins) && names(1)
        || (sentence.windows(2).position(settles)).is_some_and(|at| names(at + 2))
}

/// "Neglecting friction we get", "Requiring that all of them add up to one,".
fn is_circumstance(sentence: &[Placed<'_>]) -> bool {
    let Some((first @ Token::Word(word), _)) = sentence.first() else {
        return false;
    };
    word.ends_with("ing") && !is_done(*first) && is_outside(&sentence[..opening(sentence)])
}

/// Whether a participle says what is done with displays.
fn is_done(first: Token<'_>) -> bool {
    first.is_among(&WORKED) || first.is_among(&DONE)
}

/// How much a sentence says before its main clause begins.
fn opening(sentence: &[Placed<'_>]) -> usize {
    let ends = |(token, _): &Placed<'_>| {
        token.is_mark(',')
            || token.is_mark(':')
            || token.is_among(&["we", "one", "it", "that", "there", "is", "are"])
            || token.is_among(&GIVING)
            || draws_on(*token)
    };
    sentence
        .iter()
        .skip(1)
        .position(ends)
        .map_or(sentence.len(), |at| at + 1)
}

/// "As the probabilities add up to one,": a clause with a reason in it.
fn is_clause(sentence: &[Placed<'_>]) -> bool {
    let Some(((first, _), rest)) = sentence.split_first() else {
        return false;
    };
    let comma = rest.iter().position(|(token, _)| token.is_mark(','));
    let clause = &rest[..comma.unwrap_or(0)];
    let begins = clause
        .first()
        .is_some_and(|(token, _)| !token.is_among(&NO_REASON));
    first.is_among(&["as"]) && begins && says_how_it_is(clause)
}

/// "It is known that", "It turns out that".
fn is_known(sentence: &[Placed<'_>]) -> bool {
    KNOWN.iter().any(|phrase| {
        sentence.windows(phrase.len()).any(|own| {
            own.iter()
                .zip(*phrase)
                .all(|((token, _), word)| token.is_among(&[*word]))
        })
    })
}

/// Whether the last sentence only draws a conclusion, from one before it that says in words how things are: "The string does not stretch.
/// Hence", "The probabilities add up to one. This gives".
pub(super) fn is_stated_before(before: &[Placed<'_>], last: &[Placed<'_>]) -> bool {
    let begins = last
        .first()
        .is_some_and(|(token, _)| draws_on(*token) || token.is_among(&["this", "that"]));
    let draws = last.iter().any(|(token, _)| draws_on(*token));
    let is_short = last.len() <= LEAST_CLAUSE;
    let stated = last_sentence(before).unwrap_or_default();
    begins && draws && is_short && says_how_it_is(stated)
}

/// Whether words say how things are, and not what is done.
fn says_how_it_is(words: &[Placed<'_>]) -> bool {
    let is_word = |(token, _): &&Placed<'_>| matches!(token, Token::Word(_));
    let speaks_otherwise = |(token, _): &Placed<'_>| {
        token.is_among(&OF_AUTHORS) || token.is_among(&OF_ALGEBRA) || draws_on(*token)
    };
    words.iter().filter(is_word).count() >= LEAST_CLAUSE && !words.iter().any(speaks_otherwise)
}
