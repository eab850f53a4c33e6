//! Text of other views made fit for the page: back-ticks to code, colours left out, formulas and scripts set.

use crate::algebra::{Expr, Formula};
use crate::document::Span;
use crate::notation::{
    Statement, escape, mathml, mathml_formula, mathml_statement, plain, read_expr, read_formulas,
    typeset,
};

/// So many bytes of markup are a formula that may be wider than a telephone.
const LONG: usize = 400;

/// A formula in a line of text.
pub(super) fn formula(formula: &Formula) -> String {
    format!("<math>{}</math>", mathml_formula(formula))
}

/// A term in a line of text.
pub(super) fn term(expr: &Expr) -> String {
    format!("<math>{}</math>", mathml(expr))
}

/// A statement on lines of its own, as it was understood.
pub(super) fn understood(statement: &Statement) -> String {
    display(&mathml_statement(statement))
}

/// Mathematics on lines of its own, as it was typed.
pub(super) fn typed(source: &str) -> String {
    display(&typeset(source))
}

fn display(markup: &str) -> String {
    format!("<math display=\"block\">{markup}</math>")
}

/// Mathematics in a line of an author's text, as it was typed.
pub(super) fn inline(source: &str) -> String {
    narrow(format!("<math>{}</math>", typeset(source)))
}

/// A formula that may be wider than a telephone, in a box of its own in which it scrolls; others stay in the line.
fn narrow(math: String) -> String {
    match math.len() > LONG {
        true => format!("<span class=\"wide\">{math}</span>"),
        false => math,
    }
}

/// Where mathematics stands between single dollars, with them and without.
pub(super) fn dollars(text: &str) -> Vec<(Span, Span)> {
    let mut found = Vec::new();
    let mut places = text.match_indices('$').map(|(at, _)| at);
    while let Some(open) = places.next() {
        let Some(close) = places.next() else { break };
        if close > open + 1 {
            found.push((Span::new(open, close + 1), Span::new(open + 1, close)));
        }
    }
    found
}

/// Mathematics where there is room for characters only, as a terminal has it.
pub(super) fn in_characters(source: &str) -> String {
    match read_expr(source, Span::new(0, source.len())) {
        Ok(expr) => escape(&plain(&expr)),
        Err(_) => untagged(&typeset(source)),
    }
}

/// The text of markup, without its tags.
pub(super) fn untagged(markup: &str) -> String {
    let mut pieces = markup.split('<');
    let first = pieces.next().unwrap_or_default().to_owned();
    pieces.fold(first, |text, piece| {
        text + piece.split_once('>').map_or("", |(_, after)| after)
    })
}

/// Escaped, `E_{after}`, `E_n` and `v^(3/2)` with their scripts below and above the line.
pub(super) fn scripted(text: &str) -> String {
    let mut shown = String::with_capacity(text.len());
    // Up to `done` everything is in `shown`.
    let mut done = 0;
    for (at, _) in text.match_indices(['_', '^']) {
        let hangs_on_something = text[..at].ends_with(|c: char| !c.is_whitespace());
        if at < done || !hangs_on_something {
            continue;
        }
        let letter = || letter(&text[..at], &text[at..]);
        if let Some((element, inside, length)) = script(&text[at..]).or_else(letter) {
            shown += &escape(&text[done..at]);
            shown += &format!("<{element}>{}</{element}>", escape(inside));
            done = at + length;
        }
    }
    shown + &escape(&text[done..])
}

/// The script that a text begins with: its element, what is in it, and how long it is with its brackets.
fn script(text: &str) -> Option<(&'static str, &str, usize)> {
    let (element, close) = match text.get(..2)? {
        "_{" => ("sub", '}'),
        "^{" => ("sup", '}'),
        "^(" => ("sup", ')'),
        _ => return None,
    };
    // The search ends with what has no place in a script, so that all of them together take one walk over the text.
    let end = text[2..].find(['{', '}', '(', ')', '\\', '$', '\n'])?;
    let inside = &text[2..2 + end];
    (text[2 + end..].starts_with(close) && end > 0).then_some((element, inside, end + 3))
}

/// A script of one letter or digit behind a name of one letter, `E_n` and `ΔE_n`, or a power, `2^n`. Paths and names of several letters
/// have none.
fn letter<'a>(before: &str, text: &'a str) -> Option<(&'static str, &'a str, usize)> {
    let inside = text
        .get(1..)?
        .chars()
        .next()
        .filter(|c| c.is_alphanumeric())?;
    let end = 1 + inside.len_utf8();
    let is_part = |c: char| c.is_alphabetic() || c.is_ascii_digit() || matches!(c, '_' | '\\');
    let word = before.chars().rev().take_while(|&c| is_part(c));
    let is_short = word.filter(char::is_ascii).count() <= 1;
    let is_power = text.starts_with('^');
    // Behind the name of a file comes its ending.
    let rest = &text[end..];
    let goes_on = rest.strip_prefix('.').unwrap_or(rest).starts_with(is_part);
    let element = if is_power { "sup" } else { "sub" };
    ((is_short || is_power) && !goes_on).then(|| (element, &text[1..end], end))
}

/// Escaped, scripts set, what stands between back-ticks as code: with its scripts, unless it is LaTeX.
pub(super) fn ticked(text: &str) -> String {
    between_ticks(text, coded)
}

fn coded(code: &str) -> String {
    let shown = match code.contains('\\') {
        true => escape(code),
        false => scripted(code),
    };
    format!("<code>{shown}</code>")
}

/// The same, but what is a formula in LaTeX is set.
pub(super) fn ticked_and_set(text: &str) -> String {
    between_ticks(text, |code| {
        let is_formula = code.contains(['\\', '=', '<', '>', '_', '^']);
        let read = read_formulas(code, Span::new(0, code.len()));
        match read {
            Ok(statements) if is_formula && !statements.is_empty() => {
                let set: Vec<String> = statements.iter().map(mathml_statement).collect();
                format!(
                    "<span class=\"wide\"><math>{}</math></span>",
                    set.join("<mo>,</mo>")
                )
            }
            _ => match read_expr(code, Span::new(0, code.len())) {
                Ok(expr) if is_formula => narrow(term(&expr)),
                _ => coded(code),
            },
        }
    })
}

fn between_ticks(text: &str, shown: impl Fn(&str) -> String) -> String {
    let parts: Vec<&str> = text.split('`').collect();
    if parts.len().is_multiple_of(2) {
        return scripted(text);
    }
    let part = |(at, part): (usize, &&str)| match at % 2 {
        0 => scripted(part),
        _ => shown(part),
    };
    parts.iter().enumerate().map(part).collect()
}

/// The first letter large.
pub(super) fn capital(text: &str) -> String {
    let mut letters = text.chars();
    match letters.next() {
        Some(first) => first.to_uppercase().chain(letters).collect(),
        None => String::new(),
    }
}
