//! Tokens as TeX makes them, each with its place.

use super::super::Span;

/// A part of one of the files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Place {
    pub file: usize,
    pub span: Span,
}

impl Place {
    pub(super) fn new(file: usize, start: usize, end: usize) -> Place {
        Place {
            file,
            span: Span::new(start, end),
        }
    }

    /// From the start of one to the end of another, if both are in one file and in order.
    pub(super) fn to(self, other: Place) -> Place {
        match self.file == other.file && other.span.start >= self.span.start {
            true => Place {
                file: self.file,
                span: self.span.to(other.span),
            },
            false => self,
        }
    }
}

/// A command or a character.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Token {
    /// Where its characters are.
    pub text: Place,
    /// What to point at: for a token that a macro stands for, where the macro was used.
    pub origin: Place,
    /// A command whose meaning was fixed by `\let`: it is not replaced.
    pub frozen: bool,
}

impl Token {
    pub(super) fn written(text: Place) -> Token {
        Token {
            text,
            origin: text,
            frozen: false,
        }
    }
}

/// How long the token is that `rest` begins with: a command, or one character. `at` counts as a letter in a package.
pub(super) fn length(rest: &str, at_is_letter: bool) -> usize {
    let mut chars = rest.chars();
    match chars.next() {
        Some('\\') => {
            let letter = |c: char| c.is_ascii_alphabetic() || (at_is_letter && c == '@');
            let name = &rest[1..];
            let letters = name.find(|c| !letter(c)).unwrap_or(name.len());
            match letters {
                0 => 1 + name.chars().next().map_or(0, char::len_utf8),
                letters => 1 + letters,
            }
        }
        Some(c) => c.len_utf8(),
        None => 0,
    }
}
