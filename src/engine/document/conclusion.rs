//! Whether prose says that what is displayed next follows: "Hence", "Substituting (3) into (4) gives".

use super::Span;
use super::prose::{Placed, Token, ends_sentence};
use super::supposition::relates;
use super::words::Words;

/// What comes after these is drawn from what was said before. With one of them a sentence no longer supposes anything, either.
static DRAWN: Words = Words::of(&[
    "then",
    "so",
    "hence",
    "thus",
    "therefore",
    "whence",
    "gives",
    "give",
    "giving",
    "yields",
    "yield",
    "yielding",
    "implies",
    "imply",
    "implying",
    "follows",
    "becomes",
    "become",
    "obtain",
    "obtains",
    "recover",
    "recovers",
    "get",
    "find",
    "prove",
    "check",
    "verify",
    "means",
    "derive",
    "compute",
    "determine",
    "solve",
    "leads",
    "reduces",
    "deduce",
    "conclude",
    "consequently",
    "accordingly",
]);
/// What is done with equations that stand already; and words for what is true of itself.
static WORKED: Words = Words::of(&[
    "obtained",
    "gets",
    "gave",
    "yielded",
    "follow",
    "finds",
    "found",
    "recovered",
    "recovering",
    "leading",
    "reduce",
    "reducing",
    "simplify",
    "simplifies",
    "simplifying",
    "simplified",
    "rearrange",
    "rearranges",
    "rearranging",
    "rearranged",
    "solving",
    "solved",
    "substitute",
    "substituting",
    "substitution",
    "insert",
    "inserting",
    "eliminate",
    "eliminating",
    "plugging",
    "plug",
    "expand",
    "expanding",
    "factor",
    "factoring",
    "divide",
    "dividing",
    "multiply",
    "multiplying",
    "adding",
    "subtracting",
    "differentiate",
    "differentiating",
    "integrate",
    "integrating",
    "combine",
    "combining",
    "equating",
    "comparing",
    "squaring",
    "cancelling",
    "canceling",
    "collecting",
    "evaluating",
    "rewrite",
    "rewriting",
    "rewritten",
    "result",
    "results",
    "equivalently",
    "thereby",
    "identity",
    "identities",
    "always",
    "must",
    "deduced",
]);

/// What comes after these is what something is meant by.
static DEFINING: Words = Words::of(&[
    "define",
    "defines",
    "defined",
    "definition",
    "denote",
    "denotes",
    "denoted",
    "call",
    "called",
    "introduce",
    "introducing",
    "abbreviate",
    "abbreviation",
    "let",
    "set",
    "setting",
    "put",
    "notation",
]);

/// These divide.
const DIVIDING: [&str; 6] = [
    "divide", "divides", "dividing", "divided", "division", "ratio",
];
/// Rules for slopes that nobody needs for a factor that is constant.
const OF_FACTORS: [&str; 3] = ["product", "quotient", "leibniz"];
/// What physics brings along, and no equation before need have said.
static LAWS: Words = Words::of(&[
    "law",
    "laws",
    "conservation",
    "conserved",
    "principle",
    "principles",
    "postulate",
    "postulates",
    "postulated",
    "theorem",
    "condition",
    "balance",
    "equilibrium",
    "symmetry",
    "moments",
    "torques",
    "assume",
    "assumes",
    "assuming",
    "assumption",
    "assumptions",
    "suppose",
    "require",
    "requires",
    "demand",
    "demands",
]);
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
/// A reason that speaks of these is worked out of equations: "The masses cancel, so".
static OF_ALGEBRA: Words = Words::of(&[
    "cancel",
    "cancels",
    "drop",
    "drops",
    "vanish",
    "vanishes",
    "term",
    "terms",
    "side",
    "sides",
    "factor",
    "factors",
    "denominator",
    "denominators",
    "numerator",
    "numerators",
    "root",
    "roots",
    "square",
    "squares",
    "product",
    "products",
    "equation",
    "equations",
    "expression",
    "expressions",
    "derivative",
    "integral",
    "coefficients",
    "discriminant",
    "exponents",
]);
/// A reason has no fewer words.
const LEAST_REASON: usize = 3;
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

/// Whether a word, in lower case, draws a conclusion.
pub(super) fn draws(word: &str) -> bool {
    DRAWN.has(word)
}

/// Whether a token is a word that draws a conclusion.
#[inline]
pub(super) fn draws_on(token: Token<'_>) -> bool {
    token.is_among(&DRAWN)
}

/// Whether what is before a verb points back: "this means" draws a conclusion, "break-even means" says what is meant.
pub(super) fn refers(before: &[Placed<'_>]) -> bool {
    let last = before.last();
    last.is_some_and(|(token, _)| token.is_among(&["this", "that", "which", "it"]))
}

/// Whether the first sentence is about the display before it: "which by (2) is"; or the last one is.
pub(super) fn is_relative(tokens: &[Placed<'_>], last: &[Placed<'_>]) -> bool {
    let first = tokens
        .iter()
        .find(|(token, _)| !matches!(token, Token::Mark(',' | ';')));
    matches!(first, Some((Token::Word("which"), _))) || works_on_it(last) || works_on_this(tokens)
}

/// "Comparing this with (1)", "At the top, $r = a$, this gives with (1)": where nothing else is said after the display before, that is what
/// is meant.
fn works_on_this(tokens: &[Placed<'_>]) -> bool {
    const WORKED_ON_THIS: &[&str] = &["comparing", "combining", "equating"];
    let words =
        |sentence: &&[Placed<'_>]| sentence.iter().any(|own| matches!(own.0, Token::Word(_)));
    let mut sentences = tokens.split(|own| own.0.is_stop()).filter(words);
    let (Some(sentence), None) = (sentences.next(), sentences.next()) else {
        return false;
    };
    let gives = |pair: &[Placed<'_>]| pair[0].0.is_among(&["this"]) && draws_on(pair[1].0);
    let this_gives = || sentence.windows(2).any(gives);
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
    let is_object = |(token, _): &Placed<'_>| {
        matches!(token, Token::Tag(_) | Token::Keys(_) | Token::KeyRange(..))
    };
    !rest[..means].iter().any(is_object)
}

/// Of these several are announced together: "The two conditions of equilibrium are".
static SEVERAL: Words = Words::of(&[
    "equations",
    "relations",
    "laws",
    "conditions",
    "constraints",
    "formulas",
    "formulae",
    "principles",
    "rules",
    "balances",
]);

/// Whether the last sentence announces several laws, and draws them from nothing: "The two conditions are", "We have the following
/// equations.", "$a$ and $b$ are defined by".
pub(super) fn announces_laws(last: &[Placed<'_>], concludes: Option<bool>) -> bool {
    if concludes != Some(false) {
        return false;
    }
    let has = |words: &[&'static str]| last.iter().any(|(token, _)| token.is_among(words));
    let ends = last.iter().rev().find_map(|(token, _)| match token {
        Token::Word(word) => Some(*word),
        _ => None,
    });
    let cites = |(token, _): &Placed<'_>| matches!(token, Token::Tag(_) | Token::Keys(_));
    // "The semi-major axis $a$ and the eccentricity $e$ are defined through"
    let symbols = last.iter().filter(|own| matches!(own.0, Token::Math(_)));
    let defines = has(&["are"]) && has(&["defined"]) && symbols.count() > 1;
    let announces = ends == Some("are") || has(&["following"]);
    (defines || announces && last.iter().any(|(token, _)| token.is_among(&SEVERAL)))
        && !last.iter().any(cites)
}

/// Whether the last sentence announces several things by their names, "The variance and the optimal share are".
pub(super) fn announces_several(last: &[Placed<'_>]) -> bool {
    let has = |word: &'static str| last.iter().any(|(token, _)| token.is_among(&[word]));
    let plain = |(token, _): &Placed<'_>| {
        matches!(token, Token::Word(_) | Token::Math(_) | Token::Mark(','))
    };
    matches!(last, [.., (are, _)] if are.is_among(&["are"])) && has("and") && last.iter().all(plain)
}

/// With one of these a clause ends that says what something is.
const NAMES: [&str; 4] = ["is", "are", "denotes", "means"];

/// Whether nothing but a "where" or "with" leads on to the display, or a "where" with the name of something: "where the initial energy
/// is". It says what is meant in the one before.
pub(super) fn says_what_is_meant(tokens: &[Placed<'_>]) -> bool {
    let mut said = tokens
        .iter()
        .filter(|(token, _)| !matches!(token, Token::Mark(',' | ';' | ':')));
    let first = said.next().map(|(token, _)| *token);
    let plain = |(token, _): &Placed<'_>| matches!(token, Token::Word(_)) && !draws_on(*token);
    match first {
        Some(Token::Word("where")) => {
            let last = said.clone().next_back();
            said.all(plain) && last.is_none_or(|(last, _)| last.is_among(&NAMES))
        }
        Some(Token::Word("with")) => said.next().is_none(),
        _ => false,
    }
}

/// Whether the last sentence says what is meant by what comes after it.
pub(super) fn defines(last: &[Placed<'_>], concludes: Option<bool>) -> bool {
    // "From the definition of restitution it follows that" defines nothing.
    let is_reason = concludes == Some(true);
    let defining = |(token, _): &Placed<'_>| {
        token.is_among(&DEFINING) && !(is_reason && token.is_among(&["definition"]))
    };
    last.iter().any(defining)
}

/// The last sentence with a word in it.
pub(super) fn last_sentence<'t, 'a>(tokens: &'t [Placed<'a>]) -> Option<&'t [Placed<'a>]> {
    let mut sentences = tokens.split(|(token, _)| token.is_stop());
    sentences.rfind(|sentence| has_words(sentence))
}

fn has_words(sentence: &[Placed<'_>]) -> bool {
    let mut tokens = sentence.iter();
    tokens.any(|(token, _)| matches!(token, Token::Word(_)))
}

/// Whether the last sentence divides one equation by another: what it divides by is meant not to vanish.
pub(super) fn divides(last: &[Placed<'_>]) -> bool {
    last.iter().any(|(token, _)| token.is_among(&DIVIDING))
}

/// Whether the last sentence names the rule for the slope of a product, of which every factor changes.
pub(super) fn names_rule_of_factors(last: &[Placed<'_>]) -> bool {
    let is_rule = |(token, _): &Placed<'_>| token.is_among(&["rule", "rules"]);
    // "Leibniz' rule", "the product and chain rules".
    let mut from = (0..last.len()).filter(|&at| last[at].0.is_among(&OF_FACTORS));
    from.any(|at| last[at + 1..].iter().take(3).any(is_rule))
}

/// Whether the last sentence gives a reason that is no equation: a law by its name, or words after "since".
pub(super) fn reasons_in_words(source: &str, last: &[Placed<'_>]) -> bool {
    let among = |words: &'static [&str]| move |(token, _): &Placed<'_>| token.is_among(words);
    let is_equation = |own: &Placed<'_>| is_equation(source, own);
    let since = last.iter().position(among(&BECAUSE));
    let reason = since.map(|since| &last[since + 1..]);
    let is_said = |words: &[Placed<'_>]| !words.is_empty() && !words.iter().any(is_equation);
    reason.is_some_and(is_said)
        || names_a_law(last) && is_said(last)
        || is_said(last) && puts_circumstances(last)
        || is_said(last) && concludes_from_words(last)
}

/// Whether it is an equation, or cites one.
fn is_equation(source: &str, (token, _): &Placed<'_>) -> bool {
    match token {
        Token::Math(body) => source.get(body.range()).is_some_and(relates),
        token => matches!(token, Token::Tag(_) | Token::Keys(_) | Token::KeyRange(..)),
    }
}

/// Whether a law is named that may be a reason. "This gives Snell's law" names what is concluded.
fn names_a_law(sentence: &[Placed<'_>]) -> bool {
    laws(sentence).next().is_some()
}

/// The names of laws that the last sentence gives for a reason: "conservation of momentum", "Newton's second law".
pub(super) fn laws_named(last: &[Placed<'_>]) -> Vec<Span> {
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
pub(super) fn puts_condition(source: &str, last: &[Placed<'_>]) -> bool {
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

/// Whether a text goes on with what was said before the display before it, and concludes nothing: "and perpendicular to it".
pub(super) fn goes_on_with_and(tokens: &[Placed<'_>], concludes: Option<bool>) -> bool {
    let begins = matches!(tokens.first(), Some((Token::Word("and" | "while"), _)));
    let is_one = !tokens.iter().any(|(token, _)| {
        matches!(
            token,
            Token::Stop | Token::Tag(_) | Token::Keys(_) | Token::KeyRange(..)
        )
    });
    begins && is_one && concludes == Some(false)
}

/// Whether a text goes on with the sentence that the display before it stands in, up to the next one: "and the variance (1) is then".
pub(super) fn joins(tokens: &[Placed<'_>]) -> bool {
    let first = tokens.first().map(|(token, _)| *token);
    let goes_on = match first {
        Some(Token::Word(word)) => word.starts_with(char::is_lowercase),
        _ => false,
    };
    goes_on && !tokens.iter().any(|(token, _)| token.is_stop())
}

/// "No heat is lost, so": a sentence that draws one conclusion, from words that say how things are.
fn concludes_from_words(sentence: &[Placed<'_>]) -> bool {
    let Some(so) = sentence
        .iter()
        .position(|(token, _)| token.is_among(&THEREFORE))
    else {
        return false;
    };
    let works = |(token, _): &Placed<'_>| {
        draws_on(*token) || token.is_among(&WORKED) || token.is_among(&OF_ALGEBRA)
    };
    let reason = &sentence[..so];
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

/// The end of a sentence that a display stands in, if the text goes on with it: up to the full stop.
pub(super) fn tail<'t, 'a>(source: &str, tokens: &'t [Placed<'a>]) -> &'t [Placed<'a>] {
    let ends = |token: &Placed<'_>| ends_sentence(source, token);
    let goes_on = |word: &str| word.starts_with(char::is_lowercase);
    match (tokens.first(), tokens.iter().position(ends)) {
        (Some((Token::Word(word), _)), Some(end)) if goes_on(word) => &tokens[..end],
        _ => &[],
    }
}

/// Whether the end of a sentence says what the display in it comes from: "by (2)".
pub(super) fn says_from(tail: &[Placed<'_>]) -> bool {
    let first = tail.first().map(|(token, _)| *token);
    matches!(first, Some(Token::Word(word)) if FROM.contains(&word))
}

/// What leads from a display to the same in other words.
const IN_OTHER_WORDS: [&[&str]; 5] = [
    &["i", "e"],
    &["that", "is"],
    &["in", "other", "words"],
    &["or"],
    &["or", "equivalently"],
];

/// Whether nothing else is said than that the next display says the same: "i.e.", "that is,".
fn says_the_same(sentence: &[Placed<'_>]) -> bool {
    let marks = |(token, _): &&Placed<'_>| !matches!(token, Token::Mark(_) | Token::Stop);
    let words = || sentence.iter().filter(marks);
    IN_OTHER_WORDS.iter().any(|said| {
        let is = |((token, _), word): (&Placed<'_>, &&str)| token.is_among(&[*word]);
        words().count() == said.len() && words().zip(*said).all(is)
    })
}

/// "As a fraction of the initial energy this is": another name for what was displayed.
fn says_it_is(sentence: &[Placed<'_>]) -> bool {
    let begins =
        matches!(sentence, [(own, _), ..] if own.is_among(&["as", "in", "per", "relative"]));
    let ends = matches!(sentence, [.., (this, _), (is, _)]
        if this.is_among(&["this", "that"]) && is.is_among(&["is", "equals"]));
    begins && ends
}

/// Whether a sentence says that what comes after it follows from something, as far as words tell; `None` where nothing is said.
pub(super) fn read(sentence: &[Placed<'_>]) -> Option<bool> {
    if !has_words(sentence) {
        return None;
    }
    if says_the_same(sentence) || says_it_is(sentence) {
        return Some(true);
    }
    let otherwise = |at: usize| {
        let (token, next) = (sentence[at].0, sentence.get(at + 1));
        // "From then on mechanical energy is conserved" tells when.
        let before = at.checked_sub(1).map(|before| sentence[before].0);
        let tells_when = matches!(
            before,
            Some(Token::Word(
                "from" | "From" | "since" | "only" | "till" | "until"
            ))
        );
        // "Momentum is conserved, and so is the energy"
        let adds = |(next, _): &Placed<'_>| next.is_among(&["is", "are", "does", "do"]);
        token.is_among(&["then"]) && tells_when
            || token.is_among(&["so"]) && next.is_some_and(adds)
            || token.is_among(&["means"]) && !refers(&sentence[..at])
    };
    let follows = |at: usize| {
        let token = sentence[at].0;
        token.is_among(&WORKED) || draws_on(token) && !otherwise(at)
    };
    Some((0..sentence.len()).any(follows))
}
