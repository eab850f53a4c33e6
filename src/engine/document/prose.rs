//! Prose in words, tags and inline math: what citations and suppositions are read from.

use std::borrow::Cow;

use super::circumstance;
use super::citation;
use super::conclusion;
use super::inserted;
use super::qualities;
use super::quantity;
use super::slope;
use super::supposition;
use super::words::{Listed, Words};
use super::{Citation, Inline, Prose, Span};

/// A piece of prose.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Token<'a> {
    Word(&'a str),
    /// Digits, and what is glued to them: `4a`.
    Number(&'a str),
    /// What is in a pair of parentheses that may be a tag: `42`, `2–5`, `A.3`.
    Tag(&'a str),
    /// The keys of `\ref{…}`, `\eqref{…}`.
    Keys(&'a str),
    /// The two keys of `\crefrange{…}{…}`.
    KeyRange(&'a str, &'a str),
    /// The inside of inline math.
    Math(Span),
    /// `-`, `–`, `—`, `--`
    Dash,
    /// The end of a sentence or of a paragraph.
    Stop,
    /// Any other character.
    Mark(char),
    /// Code, HTML or a link's target.
    Hidden,
}

impl Token<'_> {
    /// Whether it ends a sentence or a paragraph.
    #[inline]
    pub(super) fn is_stop(self) -> bool {
        matches!(self, Token::Stop)
    }

    /// Whether it cites something: a tag, or the keys of labels.
    #[inline]
    pub(super) fn cites(self) -> bool {
        matches!(self, Token::Tag(_) | Token::Keys(_) | Token::KeyRange(..))
    }

    /// Whether it is this mark.
    #[inline]
    pub(super) fn is_mark(self, mark: char) -> bool {
        matches!(self, Token::Mark(own) if own == mark)
    }

    /// Whether it is one of these words, which are in lower case.
    #[inline]
    pub(super) fn is_among(self, words: &(impl Listed + ?Sized)) -> bool {
        match self {
            Token::Word(word) => words.has_in_any_case(word),
            _ => false,
        }
    }
}

/// A word in lower case; most words are written so.
pub(super) fn in_lower_case(word: &str) -> Cow<'_, str> {
    match word.bytes().all(|byte| byte.is_ascii_lowercase()) {
        true => word.into(),
        false => word.to_lowercase().into(),
    }
}

/// A token and where it stands.
pub(super) type Placed<'a> = (Token<'a>, Span);

/// Whether a token ends a sentence, and not only a paragraph.
pub(super) fn ends_sentence(source: &str, (token, span): &Placed<'_>) -> bool {
    token.is_stop() && matches!(source.get(span.range()), Some("." | "?" | "!"))
}

/// Whether one of these words stands at a place.
pub(super) fn among(sentence: &[Placed<'_>], at: usize, words: &(impl Listed + ?Sized)) -> bool {
    let own = sentence.get(at);
    own.is_some_and(|(token, _)| token.is_among(words))
}

/// Whether the first word of a sentence is one of these.
pub(super) fn begins_with(sentence: &[Placed<'_>], words: &(impl Listed + ?Sized)) -> bool {
    let mut tokens = sentence.iter().map(|(token, _)| token);
    let first = tokens.find(|token| matches!(token, Token::Word(_)));
    first.is_some_and(|token| token.is_among(words))
}

/// A sentence may begin with one of these and a comma, and says what it says all the same.
static LEADING: Words = Words::of(&[
    "finally",
    "lastly",
    "first",
    "firstly",
    "second",
    "secondly",
    "third",
    "thirdly",
    "next",
    "now",
    "conversely",
    "similarly",
    "likewise",
    "analogously",
    "correspondingly",
    "moreover",
    "furthermore",
    "additionally",
    "besides",
    "also",
    "again",
    "indeed",
    "clearly",
    "obviously",
    "evidently",
    "naturally",
    "alternatively",
    "specifically",
    "particularly",
    "incidentally",
    "interestingly",
    "however",
    "here",
]);
/// The same of several words.
const LEADING_PHRASES: [&[&str]; 13] = [
    &["in", "particular"],
    &["in", "addition"],
    &["for", "example"],
    &["for", "instance"],
    &["for", "comparison"],
    &["for", "illustration"],
    &["for", "completeness"],
    &["of", "course"],
    &["by", "contrast"],
    &["in", "contrast"],
    &["on", "the", "other", "hand"],
    &["on", "the", "one", "hand"],
    &["as", "it", "should", "be"],
];
/// What begins with one of these and ends at a comma leads on as well: "As a check,", "To test this result,".
const LEADING_ON: [&[&str]; 12] = [
    &["as", "a"],
    &["as", "an"],
    &["as", "another"],
    &["as", "expected"],
    &["as", "it"],
    &["by", "way", "of"],
    &["to", "check"],
    &["to", "test"],
    &["to", "verify"],
    &["to", "illustrate"],
    &["to", "see"],
    &["to", "conclude"],
];
/// No more words lead on.
const MOST_LEADING: usize = 6;

/// How many tokens a sentence begins with that say nothing of what it is about: "As a check,", "Finally,".
pub(super) fn lead(sentence: &[Placed<'_>]) -> usize {
    let is_word = |(token, _): &&Placed<'_>| matches!(token, Token::Word(_));
    let comma = sentence
        .iter()
        .take(MOST_LEADING + 1)
        .take_while(is_word)
        .count();
    if !matches!(sentence.get(comma), Some((Token::Mark(','), _))) {
        return 0;
    }
    let words = &sentence[..comma];
    let begins = |phrase: &[&str]| {
        let mut both = words.iter().zip(phrase);
        words.len() >= phrase.len() && both.all(|((token, _), word)| token.is_among(&[*word]))
    };
    let is = |phrase: &&[&str]| begins(phrase) && words.len() == phrase.len();
    let leads = match words {
        [(token, _)] => token.is_among(&LEADING),
        words => {
            LEADING_PHRASES.iter().any(is)
                || LEADING_ON.iter().any(|phrase| begins(phrase)) && !words.is_empty()
        }
    };
    if leads { comma + 1 } else { 0 }
}

/// Words that end in a full stop which ends no sentence.
const ABBREVIATED: [&str; 14] = [
    "eq", "eqs", "eqn", "eqns", "fig", "figs", "sec", "ref", "refs", "cf", "resp", "vs", "no",
    "approx",
];
/// Two words, each with its point.
const LATIN: [&str; 2] = ["i.e.", "e.g."];
const LATIN_LENGTH: usize = 4;
/// Commands that cite.
const CITING: [&str; 11] = [
    "\\eqref{",
    "\\ref{",
    "\\cref{",
    "\\Cref{",
    "\\autoref{",
    "\\cref*{",
    "\\vref{",
    "\\labelcref{",
    "\\ref*{",
    "\\autoref*{",
    "\\Vref{",
];
/// Commands that cite two equations and all between them.
const CITING_RANGE: [&str; 2] = ["\\crefrange{", "\\Crefrange{"];
/// The environments of lists.
const LISTS: [&str; 3] = ["{itemize}", "{enumerate}", "{description}"];
/// Longer parentheses hold a remark, not a tag.
const LONGEST_TAG: usize = 48;

/// Reads prose; `inline` and `hidden` are in order.
pub(super) fn read(source: &str, span: Span, inline: &[Inline], hidden: &[Span]) -> Prose {
    let tokens = tokens(source, span, inline, hidden);
    let last = conclusion::last_sentence(&tokens).unwrap_or_default();
    let concludes = conclusion::read(last);
    let (suppositions, mentions) = supposition::read(source, &tokens);
    let named = supposition::named::read(source, &tokens);
    let (qualities, changing) = qualities::read(source, &tokens);
    let tail = conclusion::tail(source, &tokens);
    let mut citations = citation::read(&tokens);
    if !citations.is_empty() {
        let closed = closed(source, &tokens, last, concludes);
        let mut used_up = used_up(source, closed.get(tail.len()..).unwrap_or_default());
        used_up.extend(conclusion::source_of(last));
        let is_within = |own: Span, all: &Span| all.start <= own.start && own.end <= all.end;
        citations.retain(|own| !used_up.iter().any(|all| is_within(own.span, all)));
    }
    let in_tail = |citation: &&Citation| {
        tail.last()
            .is_some_and(|(_, at)| citation.span.end <= at.end)
    };
    let in_last = |citation: &&Citation| {
        last.first()
            .is_some_and(|(_, at)| at.start <= citation.span.end)
    };
    Prose {
        span,
        math: inline.to_vec(),
        closing: citations.iter().rev().take_while(in_last).count(),
        tail: citations.iter().take_while(in_tail).count(),
        says_from: conclusion::says_from(tail),
        reasons: conclusion::reasons_in_words(source, before(&tokens, last), last),
        laws_named: conclusion::laws_named(last),
        said_last: whole(last),
        slope: slope::read(last),
        inserted: inserted::read(last, &citations),
        all_vary: conclusion::names_rule_of_factors(last),
        divides: conclusion::divides(last),
        citations,
        suppositions,
        leading: leading(source, &tokens).unwrap_or_default(),
        qualities,
        quantities: quantity::read(source, &tokens),
        subject: quantity::subject(&tokens),
        changing,
        mentions,
        named,
        concludes,
        defines: conclusion::defines(last, concludes),
        is_relative: conclusion::is_relative(&tokens, last),
        says_what_is_meant: conclusion::says_what_is_meant(&tokens) || conclusion::supposes(last),
        announces_laws: conclusion::announces_laws(last, concludes),
        puts_condition: conclusion::puts_condition(source, last),
        replaces: conclusion::replaces(last),
        announces_several: concludes == Some(false) && conclusion::announces_several(last),
        goes_on: conclusion::goes_on_with_and(trimmed(&tokens), concludes),
        joins: conclusion::joins(trimmed(&tokens)),
        extent: circumstance::read(source, &tokens),
        of_places: circumstance::said_of_places(source, &tokens),
    }
}

/// What is said before the last sentence and done with: in paragraphs before it, and in its own unless it concludes.
fn closed<'t, 'a>(
    source: &str,
    tokens: &'t [Placed<'a>],
    last: &[Placed<'_>],
    concludes: Option<bool>,
) -> &'t [Placed<'a>] {
    let ends_paragraph = |(token, span): &Placed<'_>| {
        let text = source.get(span.range()).unwrap_or_default();
        token.is_stop() && text.starts_with(['\n', '\r'])
    };
    let before = before(tokens, last);
    match (concludes, before.iter().rposition(ends_paragraph)) {
        (Some(false), _) => before,
        (_, end) => &before[..end.unwrap_or(0)],
    }
}

/// The sentences that draw their own formula from what they cite: "For carbon (7) gives only $48/169 = 0.284$." What is displayed after them
/// comes from something else.
fn used_up(source: &str, closed: &[Placed<'_>]) -> Vec<Span> {
    let draws = |sentence: &[Placed<'_>]| {
        let cites = sentence.iter().position(|(token, _)| token.cites());
        let after = cites.map_or(&[][..], |at| &sentence[at..]);
        let drawn = after
            .iter()
            .position(|(token, _)| conclusion::draws_on(*token));
        let states = |(token, _): &Placed<'_>| match token {
            Token::Math(body) => {
                let text = source.get(body.range()).unwrap_or_default();
                supposition::relates(text)
            }
            _ => false,
        };
        drawn.is_some_and(|at| after[at..].iter().any(states))
    };
    let sentences = closed.split(|(token, _)| token.is_stop());
    sentences
        .filter(|own| draws(own))
        .filter_map(whole)
        .collect()
}

/// What is said before the last sentence.
fn before<'t, 'a>(tokens: &'t [Placed<'a>], last: &[Placed<'_>]) -> &'t [Placed<'a>] {
    let start = last.first().map(|(_, span)| span.start);
    &tokens[..tokens.partition_point(|(_, span)| Some(span.start) < start)]
}

/// Without the ends of paragraphs around them.
fn trimmed<'t, 'a>(tokens: &'t [Placed<'a>]) -> &'t [Placed<'a>] {
    let says = |(token, _): &Placed<'_>| !token.is_stop();
    match (tokens.iter().position(says), tokens.iter().rposition(says)) {
        (Some(first), Some(last)) => &tokens[first..=last],
        _ => &[],
    }
}

/// The sentence that the text breaks off in.
fn leading(source: &str, tokens: &[Placed<'_>]) -> Option<Span> {
    whole(tokens.rsplit(|token| ends_sentence(source, token)).next()?)
}

pub(super) fn whole(sentence: &[Placed<'_>]) -> Option<Span> {
    Some(sentence.first()?.1.to(sentence.last()?.1))
}

/// Room is made for a word of each so many characters, with the space and the marks after it.
const WORD_LENGTH: usize = 4;

pub(super) fn tokens<'a>(
    source: &'a str,
    span: Span,
    inline: &[Inline],
    hidden: &[Span],
) -> Vec<Placed<'a>> {
    let length = span.end - span.start;
    let mut tokens: Vec<Placed<'a>> = Vec::with_capacity(length / WORD_LENGTH);
    let mut inline = inline.iter().peekable();
    let mut hidden = hidden.iter().peekable();
    let mut at = span.start;
    while at < span.end {
        if hidden.next_if(|hidden| hidden.end <= at).is_some() {
            continue;
        }
        if let Some(hidden) = hidden.next_if(|hidden| hidden.start <= at) {
            let mut token = match source.get(hidden.range()) {
                Some(own) if own.starts_with("\\end{") || begins_list(own) => Token::Stop,
                _ => Token::Hidden,
            };
            if let Some(keys) = role(source, *hidden) {
                // The role's name.
                tokens.pop();
                token = Token::Keys(keys);
            }
            tokens.push((token, *hidden));
            at = hidden.end;
            continue;
        }
        if let Some(math) = inline.next_if(|math| math.span.start <= at) {
            tokens.push((Token::Math(math.body), math.span));
            at = math.span.end.max(at);
            continue;
        }
        let Some(rest) = source.get(at..span.end) else {
            at += 1;
            continue;
        };
        let (token, length) = next(rest, tokens.last(), at);
        let length = length.max(1);
        if let Some(token) = token {
            tokens.push((token, Span::new(at, at + length)));
        }
        at += length;
    }
    tokens
}

/// Whether an environment begins that holds a list.
fn begins_list(rest: &str) -> bool {
    let name = rest.strip_prefix("\\begin");
    name.is_some_and(|name| LISTS.iter().any(|list| name.starts_with(list)))
}

/// The key in MyST's role ``{eq}`mom` ``.
fn role(source: &str, code: Span) -> Option<&str> {
    let before = source.get(..code.start)?;
    let written = source.get(code.range())?;
    let key = written.strip_prefix('`')?.strip_suffix('`')?.trim();
    let named = before.ends_with("{eq}") && !key.is_empty() && !key.contains('`');
    named.then_some(key)
}

/// The token at the start of `rest`, if any, and its length; a word stops before nothing but its
/// own end, so code or math glued to it begins the next token.
fn next<'a>(rest: &'a str, last: Option<&Placed<'a>>, at: usize) -> (Option<Token<'a>>, usize) {
    let Some(first) = rest.chars().next() else {
        return (None, 1);
    };
    let width = first.len_utf8();
    match first {
        '\n' | '\r' if ends_paragraph(rest) => (Some(Token::Stop), width),
        // Braces are around what is emphasized.
        _ if first.is_whitespace() || matches!(first, '*' | '_' | '~' | '>' | '{' | '}') => {
            (None, width)
        }
        // "i.e.", whose points end no sentence
        'i' | 'e' if LATIN.iter().any(|own| rest.starts_with(own)) => {
            (Some(Token::Word(&rest[..LATIN_LENGTH - 1])), LATIN_LENGTH)
        }
        _ if first.is_alphabetic() => {
            let length = word_length(rest);
            (Some(Token::Word(&rest[..length])), length)
        }
        _ if first.is_numeric() => {
            let length = run(rest, |c| {
                c.is_alphanumeric() || matches!(c, '.' | '\'' | '′')
            });
            let length = rest[..length].trim_end_matches('.').len();
            (Some(Token::Number(&rest[..length])), length)
        }
        // `@eq-mom`, as Quarto cites.
        '@' if rest.starts_with("@eq-") => {
            let length = 1 + run(&rest[1..], |c| c.is_alphanumeric() || "-_.:".contains(c));
            let key = rest[1..length].trim_end_matches(['.', ':', '-']);
            (Some(Token::Keys(key)), 1 + key.len())
        }
        '(' if let Some(length) = part_label(rest, last) => (None, length),
        // The number in parentheses that `\eqref` sets.
        '(' if let Some((keys, length)) = in_parentheses(rest) => (Some(Token::Keys(keys)), length),
        '(' => match parenthesis(rest) {
            Some(inside) if !glued(last, at) => (Some(Token::Tag(inside)), inside.len() + 2),
            _ => (Some(Token::Mark('(')), 1),
        },
        '-' if rest.starts_with("--") => (Some(Token::Dash), 2),
        '-' | '–' | '—' => (Some(Token::Dash), width),
        '.' | '!' | '?' => {
            let abbreviated = first == '.'
                && last.is_some_and(|(token, span)| {
                    matches!(token, Token::Word(word)
                        if ABBREVIATED.has_in_any_case(word))
                        && span.end == at
                });
            let after = rest[1..].trim_start_matches(['*', '_', ')', '}', '"', '”', '\'']);
            let ends = after.is_empty() || after.starts_with(char::is_whitespace);
            match ends && !abbreviated {
                true => (Some(Token::Stop), 1),
                false => (Some(Token::Mark(first)), 1),
            }
        }
        '\\' => {
            if let Some((keys, length)) = CITING.iter().find_map(|command| keys(rest, command)) {
                return (Some(Token::Keys(keys)), length);
            }
            for command in CITING_RANGE {
                if let Some(inside) = rest.strip_prefix(command)
                    && let Some((first, after)) = inside.split_once('}')
                    && let Some((last, _)) = after.strip_prefix('{').and_then(|a| a.split_once('}'))
                    && !first.contains(['\n', '{'])
                    && !last.contains(['\n', '{'])
                {
                    let length = command.len() + first.len() + last.len() + 3;
                    return (Some(Token::KeyRange(first, last)), length);
                }
            }
            // Any other command sets words, and is none; an item of a list begins a sentence.
            let name = run(&rest[1..], |c| c.is_ascii_alphabetic());
            let group = || {
                let inside = rest[1 + name..].strip_prefix('{');
                let close = inside.and_then(|own| own.find('}'));
                close.map_or(0, |close| close + 2)
            };
            match &rest[1..1 + name] {
                "item" => return (Some(Token::Stop), 1 + name),
                "end" => return (Some(Token::Stop), 1 + name + group()),
                "begin" if begins_list(rest) => return (Some(Token::Stop), 1 + name + group()),
                _ => {}
            }
            if name > 0 {
                return (None, 1 + name);
            }
            let spaced = rest[1..].starts_with(|c: char| c.is_whitespace() || c == ',');
            let escaped = rest[1..].chars().next().map_or(0, char::len_utf8);
            match spaced {
                true => (None, 1 + escaped),
                false => (Some(Token::Mark('\\')), 1),
            }
        }
        _ => (Some(Token::Mark(first)), width),
    }
}

/// The keys that a command cites, and where it ends.
fn keys<'a>(rest: &'a str, command: &str) -> Option<(&'a str, usize)> {
    let inside = rest.strip_prefix(command)?;
    let end = inside.find(['}', '\n', '{'])?;
    inside[end..]
        .starts_with('}')
        .then(|| (&inside[..end], command.len() + end + 1))
}

/// `(\ref{key})`, and how long it is.
fn in_parentheses(rest: &str) -> Option<(&str, usize)> {
    let (keys, length) = keys(rest.strip_prefix('(')?, "\\ref{")?;
    rest[1 + length..]
        .starts_with(')')
        .then_some((keys, length + 2))
}

/// The length of a label before a part of an exercise, "(a) Energy conservation says", "(ii) Find": no citation.
fn part_label(rest: &str, last: Option<&Placed<'_>>) -> Option<usize> {
    if !matches!(last, None | Some((Token::Stop, _))) {
        return None;
    }
    let (label, after) = rest[1..].split_once(')')?;
    let is_letter = label.len() == 1 && label.bytes().all(|b| b.is_ascii_lowercase());
    let is_roman =
        !label.is_empty() && label.len() <= 4 && label.bytes().all(|b| b"ivx".contains(&b));
    let begins = after
        .trim_start_matches(['*', '_', ' ', '\t'])
        .starts_with(|c: char| c.is_uppercase() || c == '$');
    ((is_letter || is_roman) && begins).then_some(label.len() + 2)
}

fn run(rest: &str, belongs: impl Fn(char) -> bool) -> usize {
    rest.find(|c| !belongs(c)).unwrap_or(rest.len())
}

/// How long the letters and digits are that a text begins with; most of them are ASCII.
fn word_length(rest: &str) -> usize {
    let plain = rest.bytes().take_while(u8::is_ascii_alphanumeric).count();
    match rest.as_bytes().get(plain) {
        Some(byte) if !byte.is_ascii() => plain + run(&rest[plain..], char::is_alphanumeric),
        _ => plain,
    }
}

/// A line end and a blank line after it.
fn ends_paragraph(rest: &str) -> bool {
    let after = rest.strip_prefix("\r\n").unwrap_or(&rest[1..]);
    after
        .trim_start_matches([' ', '\t', '>'])
        .starts_with(['\n', '\r'])
}

/// `f(2)`, `[2](3)`: no citation. But `Eq.(2)` and `Eq(2)` are.
fn glued(last: Option<&Placed<'_>>, at: usize) -> bool {
    last.is_some_and(|(token, span)| {
        span.end == at
            && match token {
                Token::Word(word) => citation::introduces(word).is_none(),
                Token::Number(_) | Token::Math(_) | Token::Hidden | Token::Mark(']') => true,
                _ => false,
            }
    })
}

/// The inside of a parenthesis that may be a tag or several: one word of letters and digits, or
/// numbers with commas and dashes between them.
fn parenthesis(rest: &str) -> Option<&str> {
    let mut length = LONGEST_TAG.min(rest.len());
    while !rest.is_char_boundary(length) {
        length -= 1;
    }
    let inside = rest[1..length].split_once(')')?.0;
    let tag = |c: char| c.is_alphanumeric() || matches!(c, '.' | '\'' | '′' | '-' | '*');
    let list = |c: char| c.is_numeric() || matches!(c, ',' | ' ' | '–' | '—' | '-');
    let word = inside.trim();
    let tagged = word.chars().count() <= 16 && word.chars().all(tag);
    let first = word.chars().next().is_some_and(char::is_alphanumeric);
    (first && (tagged || word.chars().all(list))).then_some(inside)
}
