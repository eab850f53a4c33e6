//! Commands with an argument in braces that is not read as mathematics: words, upright names, quantities, keys.

use super::{Kind, LONGEST_ARGUMENT, Lexer, lex};
use crate::algebra::Symbol;
use crate::document::Span;
use crate::notation::{Spanned, commands, unit};

/// The most characters of an option in brackets.
const LONGEST_OPTION: usize = 100;

/// What stands in the place of a constant that has no name.
const CONSTANT: [&str; 6] = [
    "const", "Const", "constant", "Constant", "konst", "konstant",
];

/// Whether a symbol is a word that stands for some constant, whichever that is: `\text{const}`.
pub fn is_constant_word(symbol: &Symbol) -> bool {
    let word = symbol.name().strip_prefix("\\text{");
    let word = word.and_then(|word| word.strip_suffix('}'));
    word.is_some_and(|word| CONSTANT.contains(&word))
}

/// Whether a text begins with options and two groups, as after siunitx's `\qty[…]{3}{m}`.
pub(in crate::notation) fn two_groups_follow(text: &str) -> bool {
    let text = text.trim_start();
    let text = match text.strip_prefix('[').and_then(|own| own.split_once(']')) {
        Some((_, rest)) => rest.trim_start(),
        None => text,
    };
    behind_group(text).is_some_and(|rest| rest.trim_start().starts_with('{'))
}

/// What stands behind the group that a text begins with.
fn behind_group(text: &str) -> Option<&str> {
    let mut depth = 0usize;
    for (offset, c) in text.char_indices().take(LONGEST_ARGUMENT) {
        match c {
            '{' => depth += 1,
            '}' => depth = depth.checked_sub(1)?,
            _ => {}
        }
        if depth == 0 {
            return (c == '}').then(|| &text[offset + 1..]);
        }
    }
    None
}

/// Where something is constant that is so wherever the page speaks of it.
const EVERYWHERE: [&str; 7] = [
    "along a streamline",
    "along the streamline",
    "along any streamline",
    "along streamlines",
    "of the motion",
    "throughout",
    "everywhere",
];

/// ` const.` is `const`, and so is `constant along a streamline`.
fn unabbreviated(text: &str) -> &str {
    let words = text.trim().trim_end_matches('.');
    let (word, rest) = words.split_once(' ').unwrap_or((words, ""));
    let is_whole = rest.is_empty() || EVERYWHERE.contains(&rest.trim());
    match is_whole && CONSTANT.contains(&word) {
        true => word,
        false => text,
    }
}

/// Whether words that begin so state a condition.
fn states_condition(word: &str) -> bool {
    ["for", "For", "if", "when", "whenever", "provided"].contains(&word)
}

impl<'s> Lexer<'s> {
    /// `\text{for all $x > 1$}`: mathematics in words that state a condition is that of the formula. Other words are taken as they are.
    pub(super) fn words(&mut self, start: usize, words: &'s str) {
        let pieces: Vec<&str> = words.split('$').collect();
        let first = words.split_whitespace().next();
        if pieces.len() < 3
            || pieces.len().is_multiple_of(2)
            || !first.is_some_and(states_condition)
        {
            return self.push(start, Kind::Text(unabbreviated(words)));
        }
        let end = self.at;
        let mut from = end - "}".len() - words.len();
        for (number, piece) in pieces.into_iter().enumerate() {
            let span = Span::new(from, from + piece.len());
            let sign = |c: char| c.is_whitespace() || ".,;:".contains(c);
            match number % 2 == 1 || piece.chars().all(sign) {
                true => self.out.append(lex(self.source, span)),
                false => {
                    self.at = span.end;
                    self.push(span.start, Kind::Text(piece));
                }
            }
            from = span.end + "$".len();
        }
        self.at = end;
    }

    /// Words with wide spaces around them.
    pub(super) fn words_apart(&mut self, start: usize, words: &'s str) {
        self.push(start, Kind::Wide);
        self.push(start, Kind::Text(words));
        self.push(start, Kind::Wide);
    }

    /// The raw text between the braces that follow.
    pub(super) fn argument(&mut self, start: usize, name: &str) -> Option<&'s str> {
        self.take(char::is_whitespace);
        if self.peek() != Some('{') {
            let span = Span::new(start, self.at);
            self.bad(
                span,
                format!("`\\{name}` needs braces after it"),
                Some(format!("write `\\{name}{{…}}`")),
            );
            return None;
        }
        let open = self.at;
        let mut depth = 0usize;
        for (offset, c) in self.rest().char_indices().take(LONGEST_ARGUMENT) {
            match c {
                '{' => depth += 1,
                '}' => depth -= 1,
                _ => continue,
            }
            if depth == 0 {
                self.at = open + offset + 1;
                return self.source.get(open + 1..open + offset);
            }
        }
        let is_long = self.rest().chars().nth(LONGEST_ARGUMENT).is_some();
        let message = match is_long {
            true => format!("this brace is not closed within {LONGEST_ARGUMENT} characters"),
            false => "this brace is never closed".to_owned(),
        };
        // An unclosed brace would hide the rest of the formula, its `\tag` too: go on behind it.
        self.at = open + 1;
        self.bad(Span::new(open, open + 1), message, None);
        None
    }

    pub(super) fn reference(&mut self, start: usize, name: &'s str) {
        if name == "tag" && self.rest().starts_with('*') {
            self.at += 1;
        }
        let Some(text) = self.argument(start, name) else {
            return;
        };
        let text = text.trim();
        let bare = text
            .strip_prefix('(')
            .and_then(|text| text.strip_suffix(')'))
            .unwrap_or(text);
        let span = Span::new(start, self.at);
        let found = Spanned {
            value: if name == "tag" { bare } else { text }.to_owned(),
            span,
        };
        let (list, what) = match name {
            "tag" => (
                &mut self.out.tags,
                "an equation has one number: this is a second `\\tag`",
            ),
            _ => (
                &mut self.out.labels,
                "an equation has one key: this is a second `\\label`",
            ),
        };
        list.push(found);
        if list.len() > 1 {
            self.bad(span, what.to_owned(), None);
        }
    }

    /// `\qty{9.81}{m/s^2}`, `\num{1.6e-19}`, `\unit{m}`, perhaps with options, which only change how it looks.
    pub(super) fn quantity(&mut self, start: usize, name: &'s str, number: bool, unit: bool) {
        self.take(char::is_whitespace);
        if let Some((options, _)) = self
            .rest()
            .strip_prefix('[')
            .and_then(|r| r.split_once(']'))
        {
            self.at += options.len() + 2;
        }
        let mut argument = |wanted: bool| match wanted {
            true => self.argument(start, name).map(str::trim),
            false => Some(""),
        };
        let (Some(number), Some(unit)) = (argument(number), argument(unit)) else {
            return;
        };
        let (whole, decimals) = number.split_once('.').unwrap_or((number, "0"));
        let digits = |part: &str| !part.is_empty() && part.bytes().all(|b| b.is_ascii_digit());
        let kind = match digits(whole) && digits(decimals) && unit.is_empty() {
            true => Kind::Number(number),
            false => Kind::Quantity(number, unit),
        };
        self.push(start, kind);
    }

    /// The name of a colour, which means nothing: `{red}`, `[rgb]{1,0,0}`.
    pub(super) fn colour(&mut self, start: usize, name: &str) {
        self.take(char::is_whitespace);
        let near = self
            .rest()
            .chars()
            .take(LONGEST_OPTION)
            .position(|c| c == ']');
        if self.peek() == Some('[')
            && let Some(length) = near
        {
            let after = self.rest().char_indices().nth(length + 1);
            self.at = after.map_or(self.end, |(offset, _)| self.at + offset);
        }
        self.argument(start, name);
    }

    pub(super) fn upright(&mut self, start: usize, name: &'s str) {
        if self.rest().starts_with('*') {
            self.at += 1;
        }
        self.take(char::is_whitespace);
        let text = match self.peek() {
            Some(c) if c.is_ascii_alphabetic() => {
                let from = self.at;
                self.at += 1;
                self.source.get(from..self.at)
            }
            _ => self.argument(start, name),
        };
        if let Some(text) = text.map(|text| unabbreviated(text.trim())) {
            self.upright_text(start, name, text);
        }
    }

    pub(super) fn upright_text(&mut self, start: usize, name: &str, text: &'s str) {
        if name == "operatorname" && commands::is_function(text) {
            self.push(start, Kind::Command(text));
        } else if !text.is_empty() && text.chars().all(|c| c.is_ascii_alphanumeric()) {
            let kind = match name {
                "operatorname" => Kind::Operator(text),
                _ => Kind::Upright(text),
            };
            self.push(start, kind);
        } else if name != "operatorname" && !text.is_empty() && unit::read(text).is_ok() {
            self.push(start, Kind::Quantity("", text));
        } else if name == "mathrm" && is_chemical(text) {
            self.push(start, Kind::Upright(text));
        } else {
            let span = Span::new(start, self.at);
            self.bad(
                span,
                format!("`\\{name}{{{text}}}` is no name: only letters and digits are read in it"),
                None,
            );
        }
    }
}

/// Whether a text is a chemical formula: letters, and numbers below the line, `H_2O`, `C_{12}H_{22}O_{11}`, perhaps with a charge, `CO_3^{2-}`.
fn is_chemical(text: &str) -> bool {
    let (text, charge) = text.split_once('^').unwrap_or((text, "+"));
    let charge = match charge.strip_prefix('{') {
        Some(braced) => braced.strip_suffix('}'),
        None => Some(charge).filter(|own| own.len() == 1),
    };
    let number = charge.and_then(|charge| charge.strip_suffix(['+', '-']));
    if !number.is_some_and(|number| number.bytes().all(|b| b.is_ascii_digit())) {
        return false;
    }
    let mut parts = text.split('_');
    let letters = |text: &str| text.chars().all(|c| c.is_ascii_alphanumeric());
    let digits = |text: &str| !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit());
    let starts = parts
        .next()
        .is_some_and(|first| letters(first) && first.starts_with(|c: char| c.is_ascii_uppercase()));
    starts
        && parts.all(|part| match part.strip_prefix('{') {
            Some(braced) => braced
                .split_once('}')
                .is_some_and(|(number, rest)| digits(number) && letters(rest)),
            None => part.starts_with(|c: char| c.is_ascii_digit()) && letters(part),
        })
}
