//! What prose says of symbols by adjectives: "where $g$ is constant", "with a constant force $F$", "the constants $a$ and $b$", "where $a$ and
//! $b$ are positive", "where $n$ is a positive integer"; and which it says change: "the mass $m$ grows".
//!
//! Steps may be proved with it, so in doubt nothing is read. What says it is followed by the end of a clause, and in the whole sentence is
//! no condition, no denial, no comparison, no other case and nothing that changes.

use super::conclusion;
use super::prose::{Placed, Token, begins_with, ends_sentence};
use super::words::Words;
use super::{Attribute, Bound, Qualities, Span};
use crate::algebra::BigRational;

/// So many words may stand between a symbol and the adjective, or between that and a symbol.
const MOST_BETWEEN: usize = 5;
/// These say that what they stand before is what comes after.
const LINKING: [&str; 9] = [
    "is", "are", "be", "being", "remains", "remain", "stays", "stay", "as",
];
/// These and adjectives may stand between.
const DESCRIBING: [&str; 27] = [
    "a",
    "an",
    "the",
    "all",
    "both",
    "two",
    "three",
    "some",
    "real",
    "arbitrary",
    "given",
    "known",
    "unknown",
    "certain",
    "universal",
    "physical",
    "material",
    "numerical",
    "dimensionless",
    "spring",
    "gas",
    "gravitational",
    "decay",
    "rate",
    "force",
    "damping",
    "coupling",
];
/// What can be positive or constant: "positive numbers".
const THINGS: [&str; 14] = [
    "number",
    "numbers",
    "real",
    "reals",
    "quantity",
    "quantities",
    "parameter",
    "parameters",
    "coefficient",
    "coefficients",
    "length",
    "lengths",
    "mass",
    "masses",
];
/// Before a symbol these make it a part of what is spoken of: "the rate of change of $x$ is constant".
const OF_A_PART: [&str; 12] = [
    "of", "to", "between", "from", "by", "in", "over", "at", "on", "along", "than", "per",
];
/// Without a verb these say that what comes next is said of the symbols after them: "with $k$ constant".
const JOINING: [&str; 5] = ["with", "assuming", "taking", "treating", "considering"];
/// These may stand before "constant force $F$".
const LEADING: [&str; 13] = [
    "with", "under", "by", "of", "for", "a", "an", "the", "some", "two", "three", "and", "let",
];
/// No noun between "constant" and a symbol is one of these: of something else it is said.
const OF_ANOTHER: [&str; 36] = [
    "mean",
    "means",
    "average",
    "fluctuation",
    "fluctuations",
    "amplitude",
    "fraction",
    "multiple",
    "multiples",
    "order",
    "term",
    "factor",
    "function",
    "ratio",
    "rate",
    "part",
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
    "and",
    "or",
    "times",
    "is",
    "are",
    "that",
    "which",
    "where",
    "each",
];
/// After a comma these go on with what was said.
const QUALIFYING: [&str; 6] = ["which", "that", "for", "with", "as", "times"];
/// In a sentence with one of these nothing is told for a fact.
static DOUBTFUL: Words = Words::of(&[
    "if",
    "when",
    "whenever",
    "whether",
    "unless",
    "until",
    "while",
    "once",
    "long",
    "not",
    "no",
    "non",
    "never",
    "cannot",
    "would",
    "were",
    "could",
    "might",
    "may",
    "nor",
    "neither",
    "either",
    "or",
    "hardly",
    "scarcely",
    "rarely",
    "seldom",
    "barely",
    "usually",
    "initially",
    "initial",
    "first",
    "second",
    "third",
    "finally",
    "eventually",
    "almost",
    "nearly",
    "roughly",
    "approximately",
    "practically",
    "piecewise",
    "locally",
    "spatially",
    "anything",
    "but",
    "only",
    "except",
    "apart",
    "aside",
    "more",
    "less",
    "though",
    "although",
    "despite",
    "wrongly",
    "says",
    "say",
    "think",
    "thinks",
    "thought",
    "believe",
    "believes",
    "believed",
    "claim",
    "claims",
    "show",
    "shows",
    "shown",
    "see",
    "prove",
    "proves",
    "must",
    "require",
    "requires",
    "demand",
    "demands",
    "expect",
    "case",
    "cases",
    "contrast",
    "contrary",
    "differs",
    "different",
    "unlike",
    "without",
    "instead",
    "rather",
    "nothing",
    "nowhere",
    "away",
    "drop",
    "dropping",
    "assumption",
    "exercise",
    "repeat",
    "compare",
    "another",
    "other",
    "later",
    "effective",
    "instantaneous",
    "becomes",
    "replace",
    "replaced",
    "promote",
    "held",
    "longer",
]);
/// These say that something changes.
static CHANGING: Words = Words::of(&[
    "vary",
    "varies",
    "varying",
    "varied",
    "variable",
    "variation",
    "change",
    "changes",
    "changing",
    "depend",
    "depends",
    "depending",
    "dependent",
    "grow",
    "grows",
    "growing",
    "increase",
    "increases",
    "increasing",
    "decrease",
    "decreases",
    "decreasing",
    "drift",
    "drifts",
    "loses",
    "shrinks",
    "function",
]);
/// These deny what a sentence says.
const DENYING: [&str; 8] = [
    "not",
    "no",
    "non",
    "never",
    "cannot",
    "without",
    "independent",
    "hardly",
];
/// After these a fact is told whatever else the sentence concludes.
const TELLING: [&str; 5] = ["where", "with", "since", "as", "because"];
/// A sentence that begins with one of these is about the one before.
const REFERRING: [&str; 6] = ["it", "this", "that", "they", "these", "in"];

/// What prose says of symbols, in order, and which it says change.
pub(super) fn read(source: &str, tokens: &[Placed<'_>]) -> (Vec<Qualities>, Vec<Span>) {
    let (mut found, mut changing) = (Vec::new(), Vec::new());
    let sentences = tokens.split_inclusive(|token| ends_sentence(source, token));
    let mut following = sentences.clone().skip(1);
    for sentence in sentences {
        let next = following.next().unwrap_or_default();
        let (main, reason) = sentence.split_at(begin_of_reason(sentence));
        let (main, supposed) = main.split_at(begin_of_supposition(main));
        for part in [main, supposed, reason] {
            let has = |words: &[&str]| part.iter().any(|token| token.0.is_among(words));
            let changes = part.iter().any(|token| token.0.is_among(&CHANGING));
            if (changes || has(&["constant", "constants", "fixed"])) && changes != has(&DENYING) {
                changing.extend(part.iter().filter_map(|token| match token.0 {
                    Token::Math(body) => Some(body),
                    _ => None,
                }));
            }
            let mut told = of_sentence(part);
            if !told.is_empty() && !is_doubtful(source, part) && !takes_back(next) {
                let goes_on = goes_on(sentence);
                told.iter_mut().for_each(|own| own.goes_on = goes_on);
                found.extend(told);
            }
        }
    }
    (found, changing)
}

/// Where the clause begins that gives a reason for what a sentence says: "Now $A$ depends on $r$ only, since $V$ is fixed".
fn begin_of_reason(sentence: &[Placed<'_>]) -> usize {
    let begins = |&at: &usize| {
        sentence[at].0.is_among(&["since", "because"]) && sentence[at - 1].0.is_mark(',')
    };
    (1..sentence.len())
        .rev()
        .find(begins)
        .unwrap_or(sentence.len())
}

/// Where the clause begins in which a sentence supposes something besides: "We write $G = p/\ell$ and assume that the velocity depends on $r$".
fn begin_of_supposition(sentence: &[Placed<'_>]) -> usize {
    let begins = |&at: &usize| {
        sentence[at].0.is_among(&["assume", "suppose"]) && sentence[at - 1].0.is_among(&["and"])
    };
    (1..sentence.len()).find(begins).unwrap_or(sentence.len())
}

/// Whether a sentence tells no fact.
fn is_doubtful(source: &str, sentence: &[Placed<'_>]) -> bool {
    let asks = |(_, span): &Placed<'_>| source.get(span.range()) == Some("?");
    let doubts = |token: &Placed<'_>| token.0.is_among(&DOUBTFUL) || token.0.is_among(&CHANGING);
    sentence.last().is_some_and(asks) || sentence.iter().any(doubts)
}

/// "It is not.", "This leads nowhere."
fn takes_back(next: &[Placed<'_>]) -> bool {
    let denies = |token: &Placed<'_>| {
        token.0.is_among(&DOUBTFUL)
            || token.0.is_among(&CHANGING)
            || token.0.is_among(&["false", "wrong"])
    };
    begins_with(next, &REFERRING) && next.iter().any(denies)
}

/// What a sentence says of symbols, if it tells a fact.
fn of_sentence(sentence: &[Placed<'_>]) -> Vec<Qualities> {
    let mut found = Vec::new();
    for (at, &(token, _)) in sentence.iter().enumerate() {
        let Some(own) = attributes(token) else {
            continue;
        };
        let (before, after) = (&sentence[..at], &sentence[at + 1..]);
        let named = said_before(before, own.clone(), after)
            .or_else(|| named_after(before, own.clone(), after))
            .or_else(|| of_word(before, own, after));
        let Some(said) = named else {
            continue;
        };
        if tells(&sentence[..said.begin]) {
            found.extend(said.bodies.into_iter().map(|body| Qualities {
                body,
                by_name: said.by_name,
                attributes: said.attributes.clone(),
                of_case: said.of_case,
                goes_on: goes_on(sentence),
            }));
        }
    }
    found
}

/// Whether a sentence is one that the display before it is in: "…, where $g$ is constant."
fn goes_on(sentence: &[Placed<'_>]) -> bool {
    let first = sentence
        .iter()
        .find(|token| !matches!(token.0, Token::Mark(_)));
    matches!(first, Some((Token::Word(word), _)) if word.starts_with(char::is_lowercase))
}

/// What an adjective, or what is counted by it, says.
fn attributes(token: Token<'_>) -> Option<Vec<Attribute>> {
    let zero = |strict| Bound {
        value: BigRational::from_integer(0.into()),
        strict,
    };
    let among = |words: &[&str]| token.is_among(words);
    Some(match () {
        () if among(&["constant", "constants", "fixed"]) => vec![Attribute::Constant],
        () if among(&["positive"]) => vec![Attribute::Positive],
        () if among(&["nonnegative"]) => vec![Attribute::Nonnegative],
        () if among(&["nonzero"]) => vec![Attribute::Nonzero],
        () if among(&["negative"]) => vec![Attribute::Interval {
            lower: None,
            upper: Some(zero(true)),
        }],
        () if among(&["integer", "integers"]) => vec![Attribute::Integer],
        () => return None,
    })
}

/// What is said of what, and the token with which that begins.
struct Said {
    bodies: Vec<Span>,
    attributes: Vec<Attribute>,
    begin: usize,
    of_case: bool,
    by_name: bool,
}

/// "$A$ and $B$ are positive constants": what stands before the adjective and is said to be so, with all that is said and the token with which
/// the list of it begins.
fn said_before(before: &[Placed<'_>], own: Vec<Attribute>, after: &[Placed<'_>]) -> Option<Said> {
    // The last of several adjectives tells.
    let things = after
        .iter()
        .take_while(|token| token.0.is_among(&THINGS))
        .count();
    if things > 1 || !ends_clause(&after[things..]) {
        return None;
    }
    let is_word = |token: &&Placed<'_>| matches!(token.0, Token::Word(_));
    let words = before
        .iter()
        .rev()
        .take(MOST_BETWEEN + 1)
        .take_while(is_word)
        .count();
    let (list, between) = before.split_at(before.len() - words);
    let (linked, described) = match between.split_first() {
        Some((first, rest)) if first.0.is_among(&LINKING) => (true, rest),
        _ => (false, between),
    };
    let mut all = Vec::new();
    for &(token, _) in described {
        match attributes(token) {
            Some(more) => all.extend(more),
            None if token.is_among(&DESCRIBING) => {}
            None => return None,
        }
    }
    all.extend(own);
    let (bodies, begin) = list_that_ends(list)?;
    let introduced = begin.checked_sub(1).map(|at| list[at].0);
    let is_part = introduced.is_some_and(|token| token.is_among(&OF_A_PART));
    let joined = introduced.is_some_and(|token| token.is_among(&JOINING));
    (!is_part && (linked || joined)).then_some(Said {
        bodies,
        attributes: all,
        begin,
        of_case: false,
        by_name: false,
    })
}

/// "A constant force $F$": what is named after the adjective.
fn named_after(before: &[Placed<'_>], own: Vec<Attribute>, after: &[Placed<'_>]) -> Option<Said> {
    let is_word = |token: &&Placed<'_>| matches!(token.0, Token::Word(_));
    let words = after.iter().take_while(is_word).count();
    let (between, list) = after.split_at(words);
    // "The constant of integration $C$"
    let nouns = match between.split_first() {
        Some((first, rest)) if first.0.is_among(&["of"]) && !rest.is_empty() => rest,
        _ => between,
    };
    let constant = own == [Attribute::Constant];
    let mut all = Vec::new();
    let mut said = before.iter().rev();
    let mut last = said.next().map(|token| token.0);
    if let Some(more) = last.and_then(attributes) {
        all.extend(more);
        last = said.next().map(|token| token.0);
    }
    all.extend(own);
    // "For positive $x$" is a case, and "at constant $T$" a process.
    let leads = last.is_none_or(|token| match token {
        Token::Word("for" | "For") => constant,
        Token::Word(_) => token.is_among(&LEADING) || constant && token.is_among(&DESCRIBING),
        token => token.is_mark(','),
    });
    let of_another = |token: &Placed<'_>| token.0.is_among(&OF_ANOTHER);
    if !leads || nouns.len() > 2 || nouns.iter().any(of_another) {
        return None;
    }
    let (bodies, rest) = list_that_begins(list)?;
    // "A spring with spring constant $k$ stores"
    let goes_on = rest.first().is_some_and(|own| {
        let qualifies = [&OF_ANOTHER[..], &OF_A_PART, &LINKING, &QUALIFYING];
        matches!(own.0, Token::Word(_)) && !qualifies.iter().any(|words| own.0.is_among(*words))
    });
    // "For a constant force $F$ and an initial velocity $v_0$"
    let has_article = |own: &Placed<'_>| own.0.is_among(&["a", "an", "the", "no"]);
    let is_joined = begins_with(rest, &["and"]) && rest.get(1).is_some_and(has_article);
    (goes_on || is_joined || ends_clause(rest)).then_some(Said {
        bodies,
        attributes: all,
        begin: before.len(),
        of_case: last.is_some_and(|token| token.is_among(&["with", "under", "for"])),
        by_name: false,
    })
}

/// "For a fixed volume, differentiating (2) gives", "With the volume fixed,": what a display may say the value of. "At constant
/// temperature" is a process.
fn of_word(before: &[Placed<'_>], own: Vec<Attribute>, after: &[Placed<'_>]) -> Option<Said> {
    if own != [Attribute::Constant] || !ends_phrase(after) && !ends_phrase(after.get(1..)?) {
        return None;
    }
    let words = |tokens: &[Placed<'_>], words: &[&[&str]]| {
        tokens.len() == words.len()
            && tokens
                .iter()
                .zip(words)
                .all(|(token, own)| token.0.is_among(*own))
    };
    let is_noun = |(token, _): &Placed<'_>| matches!(token, Token::Word(word) if word.bytes().all(|b| b.is_ascii_lowercase()));
    const CASES: &[&str] = &["for", "with", "under", "given"];
    let noun = match ends_phrase(after) {
        false => {
            let is_case = words(before, &[CASES]) || words(before, &[CASES, &["a", "the"]]);
            after.first().filter(|own| is_case && is_noun(own))?
        }
        true => {
            let (noun, begin) = match before {
                [begin @ .., noun, is] if is.0.is_among(&["is", "being", "held", "kept"]) => {
                    (noun, begin)
                }
                [begin @ .., noun] => (noun, begin),
                [] => return None,
            };
            const HELD: &[&str] = &["with", "since", "because", "keeping", "holding", "as"];
            let is_case = words(begin, &[HELD, &["the"]]) || words(begin, &[&["the"]]);
            Some(noun).filter(|own| is_case && is_noun(own))?
        }
    };
    Some(Said {
        bodies: vec![noun.1],
        attributes: own,
        begin: 0,
        of_case: true,
        by_name: true,
    })
}

/// Whether a phrase at the beginning of a sentence, or the sentence, has come to its end.
fn ends_phrase(rest: &[Placed<'_>]) -> bool {
    matches!(
        rest.first(),
        None | Some((Token::Stop | Token::Mark(','), _))
    )
}

/// Whether a clause has come to its end.
fn ends_clause(rest: &[Placed<'_>]) -> bool {
    match rest.first().map(|token| token.0) {
        None | Some(Token::Stop | Token::Mark(';' | ':')) => true,
        Some(Token::Mark(',')) => {
            let next = rest.get(1).map(|token| token.0);
            !next.is_some_and(|token| token.is_among(&QUALIFYING) || token.is_among(&OF_A_PART))
        }
        _ => false,
    }
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

/// The mathematics of a list that begins with the tokens, and what comes after it.
fn list_that_begins<'t, 'a>(tokens: &'t [Placed<'a>]) -> Option<(Vec<Span>, &'t [Placed<'a>])> {
    let mut list = Vec::new();
    let mut rest = tokens;
    loop {
        let ((Token::Math(body), _), others) = rest.split_first()? else {
            return None;
        };
        list.push(*body);
        let joining = others.iter().take_while(|token| joins(token)).count();
        let goes_on = matches!(others.get(joining), Some((Token::Math(_), _)));
        // "a constant $k$, $F = k x$" names one.
        let has_and = |tokens: &[Placed<'_>]| tokens.iter().any(|token| token.0.is_among(&["and"]));
        if joining == 0 || !goes_on || !has_and(others) {
            return Some((list, others));
        }
        rest = &others[joining..];
    }
}

fn joins(token: &Placed<'_>) -> bool {
    token.0.is_mark(',') || token.0.is_among(&["and"])
}

/// Whether what comes after these words of a sentence is told, and not concluded.
fn tells(before: &[Placed<'_>]) -> bool {
    let telling = before.iter().rposition(|token| token.0.is_among(&TELLING));
    let clause = &before[telling.map_or(0, |at| at + 1)..];
    let draws = |(token, _): &Placed<'_>| conclusion::draws_on(*token);
    !clause.iter().any(draws)
}
