//! The `check:` comments, clause by clause. What cannot be read is a problem at the very word.

use super::nearest::nearest;
use super::number::expand_range;
use super::{Directive, Premise, Problem, Span};
use super::{attribute, data};
use crate::notation::Spanned;

/// The words that begin a clause.
const KEYWORDS: [&str; 14] = [
    "given",
    "law",
    "definition",
    "model",
    "derived",
    "from",
    "claim",
    "assuming",
    "let",
    "symbols",
    "symbol",
    "declare",
    "data",
    "numeric",
];
const HELP: &str = "a clause begins with `given`, `derived`, `from`, `claim`, `assuming`, `let`, \
                    `symbols`, `data` or `numeric`; clauses are separated by `;`";

/// What a comment is.
#[derive(Debug)]
pub(super) enum Comment {
    /// None of our business.
    Other,
    /// Surely meant for us.
    Misspelt(Problem),
    /// Clauses, and what is wrong with the others.
    Directives(Vec<Spanned<Directive>>, Vec<Problem>),
}

/// Reads the inside of a comment.
pub(super) fn read(source: &str, body: Span) -> Comment {
    let body = trim(source, body);
    let text = &source[body.range()];
    let word = &text[..word_length(text)];
    let rest = text[word.len()..].trim_start();
    if word == "check"
        && let Some(clauses) = rest.strip_prefix(':')
    {
        return clauses_of(source, Span::new(body.end - clauses.len(), body.end));
    }
    if word.len() < 4 || word.len() > 6 {
        return Comment::Other;
    }
    let next = rest.trim_start_matches(|c: char| c.is_ascii_punctuation() || c.is_whitespace());
    let next = &next[..word_length(next)];
    let slips = if rest.starts_with(':') { 1 } else { 2 };
    let directive = rest.starts_with(':') || KEYWORDS.contains(&next);
    if !directive || nearest(word, &["check"], slips).is_none() {
        return Comment::Other;
    }
    Comment::Misspelt(Problem::new(
        Span::new(body.start, body.start + word.len()),
        format!("`{word}` begins no directive"),
        "did you mean `check:`?",
    ))
}

fn clauses_of(source: &str, body: Span) -> Comment {
    let (mut clauses, mut problems) = (Vec::new(), Vec::new());
    for span in split(source, body) {
        match clause(source, span, &mut problems) {
            Ok(value) => clauses.push(Spanned { value, span }),
            Err(problem) => problems.push(problem),
        }
    }
    if clauses.is_empty() && problems.is_empty() {
        problems.push(Problem::new(body, "this directive is empty", HELP));
    }
    Comment::Directives(clauses, problems)
}

/// The clauses: separated by `;`, by a line break before a keyword, by a comma before a keyword.
fn split(source: &str, body: Span) -> Vec<Span> {
    let bytes = source.as_bytes();
    let mut spans = Vec::new();
    let (mut from, mut at, mut braces) = (body.start, body.start, 0_usize);
    while at < body.end {
        let ends = match bytes[at] {
            // A source is quoted, whatever stands in it.
            b'"' => {
                at += source[at + 1..body.end].find('"').map_or(0, |end| end + 1);
                false
            }
            b'\\' => {
                at += 1;
                false
            }
            b'{' => {
                braces += 1;
                false
            }
            b'}' => {
                braces = braces.saturating_sub(1);
                false
            }
            b';' => braces == 0,
            b'\n' | b'\r' => keyword(&source[at + 1..body.end], 1).is_some(),
            b',' => braces == 0 && keyword(&source[at + 1..body.end], 0).is_some(),
            _ => false,
        };
        if ends {
            spans.push(Span::new(from, at));
            from = at + 1;
            braces = 0;
        }
        at += 1;
    }
    spans.push(Span::new(from.min(body.end), body.end));
    let trimmed = spans.into_iter().map(|span| trim(source, span));
    trimmed.filter(|span| span.start < span.end).collect()
}

/// The keyword that `text` begins with, give or take `slips` letters of a longer one.
fn keyword(text: &str, slips: usize) -> Option<&'static str> {
    let text = text.trim_start_matches([' ', '\t']);
    let word = &text[..word_length(text)];
    let after = text[word.len()..].chars().next();
    if word.is_empty() || !after.is_none_or(|c| c.is_whitespace() || matches!(c, ';' | ',' | ':')) {
        return None;
    }
    let slips = if word.len() < 4 { 0 } else { slips };
    nearest(word, &KEYWORDS, slips).filter(|keyword| slips > 0 || *keyword == word)
}

fn clause(source: &str, span: Span, problems: &mut Vec<Problem>) -> Result<Directive, Problem> {
    let text = &source[span.range()];
    let word = &text[..word_length(text)];
    let body = trim(source, Span::new(span.start + word.len(), span.end));
    match word {
        "given" | "law" | "definition" | "model" => nothing(word, source, body, Directive::Given),
        "derived" => nothing(word, source, body, Directive::Derived),
        "from" => premises(source, span, body),
        "claim" => {
            let value = name(source, span, body)?;
            Ok(Directive::Claim(Spanned { value, span: body }))
        }
        "assuming" => formulas(word, span, body).map(Directive::Assuming),
        "let" => formulas(word, span, body).map(Directive::Let),
        "symbols" | "symbol" | "declare" => attribute::symbols(source, span, body, problems),
        "data" => data::data(source, span, body),
        "numeric" => data::numeric(source, body),
        _ => {
            let length = text.find(|c: char| c.is_whitespace() || c == ',');
            let length = word.len().max(if word.is_empty() {
                length.unwrap_or(text.len())
            } else {
                0
            });
            let wrong = Span::new(span.start, span.start + length);
            let written: String = text[..length].chars().take(40).collect();
            let help = match nearest(word, &KEYWORDS, 2) {
                Some(keyword) => format!("did you mean `{keyword}`?"),
                None => HELP.to_owned(),
            };
            Err(Problem::new(
                wrong,
                format!("`{written}` is not a directive"),
                help,
            ))
        }
    }
}

fn nothing(word: &str, source: &str, body: Span, read: Directive) -> Result<Directive, Problem> {
    if source[body.range()].is_empty() {
        return Ok(read);
    }
    let message = format!("`{word}` stands alone");
    Err(Problem::new(body, message, "separate clauses with `;`"))
}

fn formulas(word: &str, span: Span, body: Span) -> Result<Span, Problem> {
    if body.start < body.end {
        return Ok(body);
    }
    let message = format!("`{word}` needs a formula");
    Err(Problem::new(
        span,
        message,
        format!("for example `{word} m = 1`"),
    ))
}

/// A claim's name: letters, digits, `-` and `.`.
fn name(source: &str, clause: Span, body: Span) -> Result<String, Problem> {
    let text = &source[body.range()];
    let named = |c: char| c.is_alphanumeric() || matches!(c, '-' | '.');
    if !text.is_empty() && text.chars().all(named) {
        return Ok(text.to_owned());
    }
    let span = if text.is_empty() { clause } else { body };
    let help = "a name has letters, digits, `-` and `.`, such as `claim cauchy-equality`";
    Err(Problem::new(span, "a claim needs a name", help))
}

/// `(42), (43)`, `(2)–(5)`, `(42) and claim x`, `nothing`.
fn premises(source: &str, clause: Span, body: Span) -> Result<Directive, Problem> {
    const HELP: &str =
        "write `from (42), (43)`, `from (2)–(5)`, `from claim NAME` or `from nothing`";
    if &source[body.range()] == "nothing" {
        return Ok(Directive::From(Vec::new()));
    }
    let mut premises: Vec<Spanned<Premise>> = Vec::new();
    let mut at = body.start;
    loop {
        let premise = trim(source, Span::new(at, body.end));
        let text = &source[premise.range()];
        if let Some(rest) = text.strip_prefix("claim ") {
            let start = premise.end - rest.trim_start().len();
            let length = source[start..premise.end].find(|c: char| c.is_whitespace() || c == ',');
            let named = Span::new(start, length.map_or(premise.end, |length| start + length));
            let value = Premise::Claim(name(source, premise, named)?);
            let span = Span::new(premise.start, named.end);
            premises.push(Spanned { value, span });
            at = named.end;
        } else {
            let (first, end) = tag(text).ok_or_else(|| {
                let length = text.find(|c: char| c.is_whitespace()).unwrap_or(text.len());
                let wrong = Span::new(premise.start, premise.start + length);
                let wrong = if text.is_empty() { clause } else { wrong };
                Problem::new(wrong, "a premise is missing or cannot be read", HELP)
            })?;
            let rest = text[end..].trim_start();
            let after = ["--", "-", "–", "—", "to "]
                .iter()
                .find_map(|dash| rest.strip_prefix(dash));
            let last = after.and_then(|after| tag(after.trim_start()).map(|found| (after, found)));
            at = premise.start + end;
            let tags = match last {
                Some((after, (last, length))) => {
                    at = premise.end - after.trim_start().len() + length;
                    expand_range(first, last)
                }
                None => vec![first.to_owned()],
            };
            let span = Span::new(premise.start, at);
            premises.extend(tags.into_iter().map(|tag| Spanned {
                value: Premise::Tag(tag),
                span,
            }));
        }
        let rest = trim(source, Span::new(at, body.end));
        let text = &source[rest.range()];
        if text.is_empty() {
            return Ok(Directive::From(premises));
        }
        let comma = text.strip_prefix(',').map_or(text, str::trim_start);
        let next = ["and ", "and\n", "and\r"]
            .iter()
            .find_map(|and| comma.strip_prefix(and));
        let next = next.unwrap_or(comma);
        if next.len() == text.len() {
            return Err(Problem::new(
                rest,
                "a premise is missing or cannot be read",
                HELP,
            ));
        }
        at = rest.end - next.len();
    }
}

/// `(42)` or `\eqref{key}` at the start of `text`: the tag, and where it ends.
fn tag(text: &str) -> Option<(&str, usize)> {
    let (rest, close) = match text.strip_prefix('(') {
        Some(rest) => (rest, ')'),
        None => (text.strip_prefix("\\eqref{")?, '}'),
    };
    let (inside, _) = rest.split_once(close)?;
    let tag = inside.trim();
    let plain = !tag.is_empty() && !tag.contains(['(', '{', ',', '\n', '\r']);
    plain.then_some((tag, text.len() - rest.len() + inside.len() + 1))
}

fn word_length(text: &str) -> usize {
    text.find(|c: char| !c.is_alphabetic())
        .unwrap_or(text.len())
}

/// The span without the white space around it.
pub(super) fn trim(source: &str, span: Span) -> Span {
    let text = source.get(span.range()).unwrap_or_default();
    let start = span.end - text.trim_start().len();
    Span::new(start, (span.start + text.trim_end().len()).max(start))
}
