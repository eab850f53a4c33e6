//! The words that introduce a supposition, and how far it reaches then.

use super::super::conclusion;
use super::super::prose::{Placed, Token};
use super::super::words::Words;
use super::super::{Span, SuppositionKind};
use super::around::{follows, is_at_a_place, leads_to_citation};
use super::mathematics::{differs, is_bound, is_chain, is_value, relates, stated};
use super::reach::Reach;
use super::words::{COMPARING, CONCLUDING, DEFINING, NEGATING};

/// Words between "taking" and what is taken: "taking the non-trivial solution $…$".
const PATIENCE: usize = 6;
/// Words and commas between "if" and what it supposes: "If the bob is released from the horizontal, $u = 0$, then".
const MOST_DESCRIBED: usize = 12;
/// So many tokens after a display may be its unit.
const LONGEST_UNIT: usize = 3;
/// How many words may stand between "for" and what it supposes.
pub(super) const MOST_DESCRIBING: usize = 3;

/// Between what is put in and where.
const INTO: [&str; 2] = ["in", "into"];

/// These may introduce a supposition; so may those that define.
static INTRODUCING: Words = Words::of(&[
    "let",
    "at",
    "for",
    "when",
    "whenever",
    "where",
    "since",
    "as",
    "with",
    "because",
    "if",
    "case",
    "setting",
    "putting",
    "inserting",
    "substituting",
    "using",
    "limit",
    "situation",
    "take",
    "pick",
    "consider",
    "examine",
    "assume",
    "suppose",
    "assuming",
    "supposing",
    "taking",
    "provided",
    "given",
]);

/// What one does with a case: "Consider the limit $m = 0$", "Let us look at the special case $a = b$".
static LOOKING_AT: Words = Words::of(&[
    "consider", "examine", "take", "treat", "study", "discuss", "check", "look", "turn", "inspect",
    "try", "imagine",
]);
/// Between that and the word "case".
static BEFORE_A_CASE: Words = Words::of(&[
    "the",
    "a",
    "first",
    "now",
    "next",
    "then",
    "also",
    "again",
    "finally",
    "special",
    "particular",
    "limiting",
    "extreme",
    "opposite",
    "simple",
    "simplest",
    "symmetric",
    "important",
    "second",
    "third",
]);

/// The supposition that the word at `index` introduces.
pub(super) fn introduced(
    source: &str,
    word: &str,
    index: usize,
    tokens: &[Placed<'_>],
    begun: bool,
) -> Option<(SuppositionKind, Reach)> {
    if !INTRODUCING.has(word) && !DEFINING.has(word) {
        return None;
    }
    let after = |by: usize| tokens.get(index + by).map(|(token, _)| *token);
    let direct = matches!(after(1), Some(Token::Math(_)));
    let that = matches!(after(1), Some(Token::Word("that")));
    let comma = matches!(after(2), Some(Token::Mark(',')));
    // "For $u = c$ this gives": what comes is said of the case.
    let referred = after(2).is_some_and(|token| {
        token.cites() || token.is_among(&["this", "it", "we", "one", "equation"])
    });
    let text = |body: Span| source.get(body.range()).unwrap_or_default();
    let next = |is: fn(&str) -> bool| match after(1) {
        Some(Token::Math(body)) => is(text(body)),
        _ => false,
    };
    let value = || next(is_value);
    // At the beginning of a clause; "and for $x < 0$".
    let bounds = || {
        let begins = !begun
            || matches!(tokens[..index].last(), Some((Token::Mark(','), _)))
            || only_joins(&tokens[..index]);
        let quantified = matches!(
            after(1),
            Some(Token::Word("every" | "all" | "any" | "each"))
        );
        begins
            && match after(if quantified { 2 } else { 1 }) {
                Some(Token::Math(body)) => is_bound(text(body)),
                _ => false,
            }
    };
    // "For equal springs $k_1 = k_2$, …"
    let described = || {
        let words = |token: &&Placed<'_>| matches!(token.0, Token::Word(_));
        let rest = tokens.get(index + 1..).unwrap_or_default();
        let between = rest.iter().take(MOST_DESCRIBING).take_while(words).count();
        match rest.get(between..between + 2) {
            Some([(Token::Math(body), _), (Token::Mark(',') | Token::Stop, _)]) => {
                is_value(text(*body))
            }
            _ => false,
        }
    };
    let negated = || follows(index, tokens, &NEGATING);
    let by_us = || !begun || follows(index, tokens, &["we", "us", "now", "and"]);
    // "From (1) with $a = b$ …"
    let cites = |token: Option<&Placed<'_>>| token.is_some_and(|(token, _)| token.cites());
    let cited = || cites(tokens[..index].last());
    // "By (1), for $e = 1$, …"
    let cited_before = || {
        let mut known = tokens[..index].iter().rev();
        cites(known.find(|(token, _)| !token.is_mark(',')))
    };
    let capital =
        matches!(tokens[index].0, Token::Word(word) if word.starts_with(char::is_uppercase));
    // In the middle of a sentence that only a display can have begun.
    let goes_on = || {
        let comma = |token: &Placed<'_>| matches!(token.0, Token::Mark(',' | ';'));
        !capital && tokens[..index].iter().all(comma)
    };
    let joined = |short| Reach::Joined {
        patience: PATIENCE,
        comma: false,
        found: false,
        short,
    };
    let case = SuppositionKind::case(false);
    let rest = &tokens[index + 1..];
    let listed = || length_of_list(source, word, rest);
    let introduced = match word {
        "let" if !begun || direct => Some((SuppositionKind::Let, Reach::Sentence)),
        // "At $s = K$ the rate is half of its maximum." is said and done with.
        "at" if !begun && direct && (is_set_off(rest) || runs_on(rest)) => {
            Some((case, joined(true)))
        }
        // "which is zero at $s = 2f$, where"
        "at" | "for" | "when" if value() && comes_to_there(index, tokens) => {
            Some((case, joined(true)))
        }
        // That two things differ is no value that something could be made true with.
        "for" | "when" | "where" | "since" | "as" | "with" if next(differs) && !goes_on() => {
            Some((SuppositionKind::Let, joined(true)))
        }
        "for" | "with" | "setting" | "putting" | "inserting" if !begun && listed() >= 2 => {
            Some((case, Reach::List { left: listed() }))
        }
        "if" if is_equivalence(&tokens[index..]) => None,
        "if" | "when" | "whenever" if is_condition(source, index, tokens) => {
            Some((case, Reach::Sentence))
        }
        // "For $N = 3$ the values are …" tells of an example; a comma sets a case.
        "for" | "when"
            if value()
                && (!begun && (comma || referred)
                    || (!begun || cited_before() || only_joins(&tokens[..index]))
                        && leads_to_display(source, index, tokens)) =>
        {
            Some((case, joined(true)))
        }
        // "The stone lands when $y = 0$, hence"
        "when" if value() && concludes_at_once(index, tokens) => Some((case, joined(true))),
        "for" if !begun && described() => Some((case, joined(true))),
        "case" | "limit" | "situation" if value() && is_looked_at(&tokens[..index]) => {
            Some((SuppositionKind::case(true), joined(true)))
        }
        "case" if comma && value() && !is_compared(index, tokens) => Some((case, joined(true))),
        // What is put in at one place is said of the next display alone.
        "setting" | "putting" if !begun && next(is_chain) && leads_to_citation(rest, &INTO) => {
            let put = SuppositionKind::Case {
                runs_on: false,
                is_put_in: true,
            };
            Some((put, joined(true)))
        }
        "setting" | "putting" | "substituting" | "inserting" | "using"
            if !begun && value() && !is_at_a_place(source, index + 1, tokens) =>
        {
            Some((case, joined(true)))
        }
        "with" if (!begun && capital || cited()) && value() => Some((case, joined(true))),
        // "Hence, with $\ell = D/v$,", "so that with $q = 0$"
        "with"
            if value()
                && (only_joins(&tokens[..index]) || draws_just_before(&tokens[..index]))
                && leads_to_display(source, index, tokens) =>
        {
            Some((case, joined(true)))
        }
        // "Take $a = 2$, $b = 3$ and $c = 4$. We get"
        "take" | "pick" | "consider" | "examine" if by_us() && listed() >= 1 => {
            Some((SuppositionKind::case(true), Reach::List { left: listed() }))
        }
        word if DEFINING.has(word) && by_us() && listed() >= 2 => {
            Some((SuppositionKind::Let, Reach::List { left: listed() }))
        }
        // "we put $m = 0$ in (1)"
        word if DEFINING.has(word) && by_us() && value() && leads_to_citation(rest, &INTO) => {
            Some((case, joined(true)))
        }
        word if DEFINING.has(word) && !begun && value() && names_each(source, rest) => {
            Some((SuppositionKind::Let, Reach::Sentence))
        }
        word if DEFINING.has(word) && by_us() && value() => {
            Some((SuppositionKind::Let, joined(true)))
        }
        "where" | "with" | "for" if (value() || next(is_bound)) && goes_on() => {
            Some((SuppositionKind::Define, Reach::Sentence))
        }
        // "With $M > 0$ and $w > 0$ we get", "For every $\mu > 0$,"
        "with" | "for" | "since" | "as" | "because" if bounds() && runs_on(rest) => {
            Some((case, joined(true)))
        }
        // "Suppose first that the lift is at rest, $a = 0$": of two cases.
        "assume" | "suppose" if is_first(rest) => Some((case, Reach::Sentence)),
        "assume" | "suppose" if !begun => Some((SuppositionKind::Assume, Reach::Sentence)),
        "assume" | "suppose" | "assuming" | "supposing" | "taking" => {
            Some((SuppositionKind::Assume, joined(false)))
        }
        "provided" if direct || that => Some((SuppositionKind::Assume, joined(false))),
        "given" if that => Some((SuppositionKind::Assume, joined(false))),
        _ => None,
    };
    introduced.filter(|_| !negated())
}

/// Whether a sentence says after the first and the last of its equations what they are put for: "Put $u = T - T_0$ for the excess temperature and
/// $P = \pi D$ for the perimeter".
fn names_each(source: &str, rest: &[Placed<'_>]) -> bool {
    let length = rest.iter().position(|(token, _)| token.is_stop());
    let sentence = &rest[..length.unwrap_or(rest.len())];
    let is_put = |at: &usize| stated(source, sentence[*at].0).is_some();
    let all: Vec<usize> = (0..sentence.len()).filter(is_put).collect();
    let is_named = |at: &usize| {
        let next = sentence.get(at + 1);
        next.is_some_and(|(token, _)| token.is_among(&["for"]))
    };
    matches!(&all[..], [first, .., last] if is_named(first) && is_named(last))
}

/// Whether "first" comes next: "Suppose first that".
fn is_first(rest: &[Placed<'_>]) -> bool {
    rest.first()
        .is_some_and(|(own, _)| own.is_among(&["first"]))
}

/// Whether the word at `index` puts what the sentence goes on to display under a condition: "If $u = c$, then", "If the load is doubled,
/// $F' = 2 F$, it becomes".
pub(super) fn is_condition(source: &str, index: usize, tokens: &[Placed<'_>]) -> bool {
    let rest = tokens.get(index..).unwrap_or_default();
    if is_equivalence(rest) {
        return is_condition(source, index + 3, tokens);
    }
    let Some(((word, _), on)) = rest.split_first() else {
        return false;
    };
    let is_if = word.is_among(&["if"]);
    if !is_if && !word.is_among(&["when", "whenever"]) {
        return false;
    }
    let before = index.checked_sub(1).map(|before| tokens[before].0);
    // "The roots coincide if $D = 0$. Then", "if and only if $D = 0$, that is,"
    let only = || follows(index, tokens, &["only"]);
    let goes_on = goes_on_then(on) || only() && concludes_at_once(index, tokens);
    // A bullet.
    let after_bullet = matches!(before, Some(Token::Dash))
        && index
            .checked_sub(2)
            .is_none_or(|bullet| tokens[bullet].0.is_stop());
    let begins = after_bullet
        || matches!(before, None | Some(Token::Stop | Token::Mark(',')))
        || follows(
            index,
            tokens,
            &[
                "so", "that", "and", "but", "hence", "thus", "then", "allowed", "whereas", "while",
                "yet", "or", "else",
            ],
        );
    let describes = |(token, _): &&Placed<'_>| match token {
        Token::Word(word) => {
            !conclusion::draws(word) && !token.is_among(&NEGATING) && !token.is_among(&CONCLUDING)
        }
        token => token.is_mark(','),
    };
    let words = on.iter().take(MOST_DESCRIBED).take_while(describes).count();
    // "When $t = 0$" is said of a moment.
    let states = matches!(on.get(words), Some((Token::Math(body), _))
    if source.get(body.range()).is_some_and(|own| {
        relates(own) && (is_if || is_bound(own) || differs(own))
    }));
    states && (begins && !on.iter().any(|(token, _)| token.is_stop()) || goes_on)
}

/// Whether these begin with the first "if" of "if and only if".
fn is_equivalence(rest: &[Placed<'_>]) -> bool {
    matches!(rest, [_, (and, _), (only, _), (own, _), ..]
        if and.is_among(&["and"]) && only.is_among(&["only"]) && own.is_among(&["if"]))
}

/// Whether the next sentence, which is the last one, goes on from what these say: "Then", "In this case".
pub(super) fn goes_on_then(rest: &[Placed<'_>]) -> bool {
    let Some(end) = rest.iter().position(|(token, _)| token.is_stop()) else {
        return false;
    };
    let next = &rest[end + 1..];
    if next.iter().any(|(token, _)| token.is_stop()) {
        return false;
    }
    match next {
        [(at, _), (this, _), (case, _), ..] if at.is_among(&["in"]) => {
            this.is_among(&["this", "that"]) && case.is_among(&["case"])
        }
        next => next.iter().any(|(token, _)| token.is_among(&["then"])),
    }
}

/// Whether these words begin a sentence with the case that is looked at next: "consider the", "Let us now look at the special".
fn is_looked_at(before: &[Placed<'_>]) -> bool {
    let of_case = |(token, _): &&Placed<'_>| token.is_among(&BEFORE_A_CASE);
    let described = before.iter().rev().take_while(of_case).count();
    let before = &before[..before.len() - described];
    let verb = match before {
        [before @ .., (at, _)] if at.is_among(&["at", "to"]) => before,
        before => before,
    };
    verb.last()
        .is_some_and(|(token, _)| token.is_among(&LOOKING_AT))
}

/// Whether what is said is compared with the case at `index`: "unlike in the case", "as opposed to the case".
fn is_compared(index: usize, tokens: &[Placed<'_>]) -> bool {
    let before = tokens[..index].iter().rev().take(MOST_DESCRIBING + 1);
    let mut words = before.take_while(|(token, _)| matches!(token, Token::Word(_)));
    words.any(|(token, _)| token.is_among(&COMPARING))
}

/// Whether nothing else is said between the value after a word and a display: "For $N = 3$ the value is", "By (1), for $e = 1$".
fn leads_to_display(source: &str, index: usize, tokens: &[Placed<'_>]) -> bool {
    let rest = tokens.get(index + 2..).unwrap_or_default();
    let says = |(token, _): &Placed<'_>| match token {
        Token::Word(word) => NEGATING.has(word) || matches!(*word, "and" | "or"),
        token => token.is_stop() || stated(source, *token).is_some(),
    };
    !rest.iter().any(says)
}

/// Whether a comma comes after the formulas that a sentence begins with.
fn is_set_off(rest: &[Placed<'_>]) -> bool {
    let listed =
        |(token, _): &&Placed<'_>| matches!(token, Token::Math(_)) || token.is_among(&["and"]);
    let after = rest.iter().find(|token| !listed(token));
    after.is_some_and(|(token, _)| token.is_mark(','))
}

/// Whether the rest of a sentence leads on to a display, and denies nothing.
fn runs_on(rest: &[Placed<'_>]) -> bool {
    let stops = |(token, _): &Placed<'_>| {
        token.is_stop() || token.is_among(&NEGATING) || token.is_among(&["or"])
    };
    !rest.iter().any(stops)
}

/// Whether a sentence goes on with these: "and".
fn only_joins(before: &[Placed<'_>]) -> bool {
    let joins = |token: &Placed<'_>| {
        token.0.is_among(&["and", "but", "while", "whereas"]) || token.0.is_mark(',')
    };
    let unit = before.iter().take_while(|token| !joins(token));
    let unit = unit.take_while(|(token, _)| is_unit_word(*token)).count();
    let before = &before[unit..];
    !before.is_empty() && unit <= LONGEST_UNIT && before.iter().all(joins)
}

/// Whether a sentence has just begun to draw a conclusion: "Hence, with".
fn draws_just_before(before: &[Placed<'_>]) -> bool {
    let mut before = before.iter().rev();
    let last = before.find(|token| !token.0.is_mark(','));
    last.is_some_and(|(token, _)| {
        token.is_among(&["so", "hence", "thus", "therefore", "that", "then", "which"])
    })
}

/// Whether a word may be of the unit of what a display says: "watts, and for $R = 3 r$".
fn is_unit_word(token: Token<'_>) -> bool {
    match token {
        Token::Word(word) => {
            let is_small = word.starts_with(char::is_lowercase);
            is_small && !conclusion::draws(word) && !token.is_among(&NEGATING)
        }
        _ => token.is_mark('/'),
    }
}

/// Whether what follows from the value after the word at `index` comes next: ", hence", ", that is", ", so that".
fn concludes_at_once(index: usize, tokens: &[Placed<'_>]) -> bool {
    let rest = tokens.get(index + 2..).unwrap_or_default();
    let [(Token::Mark(','), _), (Token::Word(word), _), ..] = rest else {
        return false;
    };
    let no_more = |(token, _): &Placed<'_>| !matches!(token, Token::Stop | Token::Math(_));
    (conclusion::draws(word) || matches!(*word, "that" | "then")) && rest.iter().all(no_more)
}

/// Whether the text ends with the value that follows a word and a "where": what comes next is said of that place.
fn comes_to_there(index: usize, tokens: &[Placed<'_>]) -> bool {
    let rest = tokens.get(index + 2..).unwrap_or_default();
    let mut rest = rest.iter().map(|(token, _)| *token);
    let mut next = rest.next();
    if next == Some(Token::Mark(',')) {
        next = rest.next();
    }
    next == Some(Token::Word("where")) && rest.next().is_none()
}

/// How many values are listed after a word: 3 in "With $a = 2$, $b = 3$ and $c = 4$ we get".
///
/// "For $t = 0$, $s = 0$" and "For $t = 0$, $s = 0$ and $v = 0$." say what is so at that time.
fn length_of_list(source: &str, word: &str, rest: &[Placed<'_>]) -> usize {
    let says = |at: usize| match rest.get(at) {
        Some((Token::Math(body), _)) => {
            let text = source.get(body.range()).unwrap_or_default();
            is_value(text) || differs(text)
        }
        _ => false,
    };
    let (mut length, mut at, mut joined) = (0, 0, false);
    while says(at) {
        length += 1;
        let comma = matches!(rest.get(at + 1), Some((Token::Mark(','), _)));
        let next = at + 1 + usize::from(comma);
        joined = matches!(rest.get(next), Some((Token::Word("and"), _)));
        match says(next + usize::from(joined)) && (comma || joined) {
            true => at = next + usize::from(joined),
            false => break,
        }
        if joined {
            length += 1;
            break;
        }
    }
    let goes_on = !matches!(rest.get(at + 1), Some((Token::Stop, _)));
    match word != "for" || joined && goes_on {
        true => length,
        false => 0,
    }
}
