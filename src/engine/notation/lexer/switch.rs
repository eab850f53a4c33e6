//! The old switches of the typeface, `{\rm max}`: each reaches to the end of its group.
//!
//! What is printed alike is one name, so `{\rm max}` is `\mathrm{max}` and `{\bf F}` is `\mathbf{F}`. TeX prints no spaces
//! between letters: several of them side by side are one word where they are upright, and else refused.

use super::{Kind, LONGEST_ARGUMENT, Lexer};
use crate::document::Span;

/// How letters look.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Face {
    /// As they look without a switch.
    Plain,
    /// `\rm`: words.
    Upright,
    /// `\it`: single letters as without a switch.
    Italic,
    /// As under this command: `mathbf`.
    Marked(&'static str),
}

/// The typeface that a command switches to.
pub(super) fn face(command: &str) -> Option<Face> {
    Some(match command {
        "rm" => Face::Upright,
        "it" => Face::Italic,
        "bf" => Face::Marked("mathbf"),
        "sf" => Face::Marked("mathsf"),
        "cal" => Face::Marked("mathcal"),
        _ => return None,
    })
}

impl Lexer<'_> {
    pub(super) fn face(&self) -> Face {
        self.faces.last().copied().unwrap_or(Face::Plain)
    }

    pub(super) fn open_face(&mut self) {
        self.faces.push(self.face());
    }

    pub(super) fn close_face(&mut self) {
        if self.faces.len() > 1 {
            self.faces.pop();
        }
    }

    /// A cell of an environment is a group of its own.
    pub(super) fn end_cell(&mut self) {
        self.faces.pop();
        self.open_face();
    }

    /// `\rm` itself.
    pub(super) fn switch(&mut self, start: usize, name: &str, face: Face) {
        let before = self.out.tokens.last().map(|token| token.kind);
        if let Some(Kind::Char('_' | '^')) = before {
            let message = format!("`\\{name}` switches the typeface, so it cannot be a script");
            let help = format!("put the script in braces: `_{{\\{name} …}}`");
            return self.bad(Span::new(start, self.at), message, Some(help));
        }
        if let Some(current) = self.faces.last_mut() {
            *current = face;
        }
        self.take(char::is_whitespace);
        if face == Face::Upright && before == Some(Kind::Open) {
            self.word(start, name);
        }
    }

    /// `{\rm max}` and, after a number, `{\rm m/s^2}`: the whole group is what `\mathrm` would hold.
    fn word(&mut self, start: usize, name: &str) {
        let rest = self.rest();
        let mut near = rest.char_indices().take(LONGEST_ARGUMENT);
        let Some((length, '}')) = near.find(|(_, c)| "{}".contains(*c)) else {
            return;
        };
        let text = rest.get(..length).unwrap_or("").trim();
        let mut before = self.out.tokens.iter().rev().map(|token| token.kind);
        let counted = matches!(before.nth(1), Some(Kind::Number(_)));
        let plain = !text.is_empty() && text.chars().all(|c| c.is_ascii_alphanumeric());
        if plain || counted {
            self.at += length;
            self.upright_text(start, name, text);
        }
    }

    /// A letter, or a word, in a typeface that was switched to.
    pub(super) fn switched(&mut self, start: usize, face: Face) {
        let word = self.take(|c| c.is_ascii_alphanumeric());
        let rest = self.rest().trim_start();
        let goes_on = rest.starts_with(|c: char| c.is_ascii_alphanumeric());
        if goes_on || face != Face::Upright && word.len() > 1 {
            let message = "TeX sets these letters as one word, so what they are is not clear";
            let help = "write `\\mathrm{…}` around a name of several letters, and nothing around a product";
            let span = Span::new(start, self.at);
            return self.bad(span, message.to_owned(), Some(help.to_owned()));
        }
        let letter = word.chars().next().map(Kind::Letter);
        match (face, letter) {
            (Face::Upright, _) | (_, None) => self.push(start, Kind::Upright(word)),
            (Face::Marked(command), Some(letter)) => {
                for kind in [Kind::Command(command), Kind::Open, letter, Kind::Close] {
                    self.push(start, kind);
                }
            }
            (_, Some(letter)) => self.push(start, letter),
        }
    }
}
