//! Words within mathematics, `\text{for all $n$}`, and arguments that are no mathematics.

use super::signs::{Class, sign, space};
use super::{Ends, Setter};
use crate::notation::escape;

/// The most characters of an argument that is taken as it stands; it keeps a run of unclosed braces from costing a scan each.
const LONGEST: usize = 1000;

impl<'s> Setter<'s> {
    /// The argument of `\text`, as elements side by side.
    pub(super) fn text(&mut self) -> String {
        self.skip_blank();
        if !self.take("{") {
            let own = self.rest.chars().next().filter(|c| !"}&\\$".contains(*c));
            let own = own.map_or(String::new(), |c| c.to_string());
            self.rest = &self.rest[own.len()..];
            return mtext(&own);
        }
        let (mut words, mut markup, mut braces) = (String::new(), String::new(), 0usize);
        while let Some(c) = self.rest.chars().next() {
            self.rest = &self.rest[c.len_utf8()..];
            match c {
                '}' if braces == 0 => break,
                '}' => braces -= 1,
                '{' => braces += 1,
                '$' if self.depth < super::DEEPEST => {
                    markup += &mtext(&std::mem::take(&mut words));
                    markup += &self.nested(|own| own.line(Ends::Dollar, false)).grouped();
                }
                '$' => {}
                '\\' => words += &self.command_in_words(),
                '~' => words.push('\u{a0}'),
                c => words.push(c),
            }
        }
        markup + &mtext(&words)
    }

    /// What a command among words shows.
    fn command_in_words(&mut self) -> String {
        let name = self.name();
        match (name, space(name), sign(name)) {
            ("\\", ..) => " ".to_owned(),
            (_, Some("0"), _) => String::new(),
            (_, Some(_), _) => "\u{a0}".to_owned(),
            (_, _, Some((shown, _))) => shown.to_owned(),
            _ if name.starts_with("text") || name == "emph" || name == "mathrm" => String::new(),
            _ => name.to_owned(),
        }
    }

    /// An argument in braces as it stands, without them; empty where there is none.
    pub(super) fn raw(&mut self) -> &'s str {
        self.skip_blank();
        let Some(inside) = self.rest.strip_prefix('{') else {
            return "";
        };
        let mut depth = 1usize;
        for (at, c) in inside.char_indices().take(LONGEST) {
            match c {
                '{' => depth += 1,
                '}' => depth -= 1,
                _ => continue,
            }
            if depth == 0 {
                self.rest = &inside[at + 1..];
                return &inside[..at];
            }
        }
        self.rest = inside;
        ""
    }

    /// Options in brackets, which say only how something looks.
    pub(super) fn options(&mut self) {
        let near = self.rest.char_indices().take(LONGEST);
        if self.rest.starts_with('[')
            && let Some((at, _)) = near.into_iter().find(|(_, c)| *c == ']')
        {
            self.rest = &self.rest[at + 1..];
        }
    }
}

/// Words as one element, with the spaces at their ends.
pub(super) fn mtext(words: &str) -> String {
    if words.is_empty() {
        return String::new();
    }
    let inner = words.trim();
    let (before, after) = match words.find(inner) {
        Some(at) if !inner.is_empty() => (at > 0, at + inner.len() < words.len()),
        _ => (true, false),
    };
    let blank = |wanted: bool| if wanted { "&#160;" } else { "" };
    format!(
        "<mtext>{}{}{}</mtext>",
        blank(before),
        escape(inner),
        blank(after)
    )
}

/// What a character is to its neighbours.
pub(super) fn character(c: char) -> Class {
    match c {
        '+' | '-' | '−' | '±' | '∓' | '*' | '·' | '×' | '⋅' | '∘' => Class::Binary,
        '=' | '<' | '>' | ':' | '≤' | '≥' | '≠' | '≈' | '∼' | '∝' | '≪' | '≫' | '→' | '⇒' | '∈' => {
            Class::Relation
        }
        '(' | '[' | '⟨' => Class::Open,
        ')' | ']' | '⟩' => Class::Close,
        ',' | ';' => Class::Comma,
        _ => Class::Ordinary,
    }
}
