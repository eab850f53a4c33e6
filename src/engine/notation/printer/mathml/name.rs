//! Canonical names in MathML: `v'_1` is a letter with a prime and an index, `\Delta E_{\text{total}}` two letters.

use super::{mathml, sign};
use crate::algebra::{as_printed, split_subscript};
use crate::notation::commands::{self, ACCENTS, LETTERS, SUBSCRIPTS};
use crate::notation::printer::bracketed::{Bracketed, Piece};
use crate::notation::printer::xml::escape;
use crate::notation::typeset::{Face, accent};

/// Accents within accents, deeper than anybody writes.
const DEEPEST: usize = 16;

const PRIME: &str = "<mo lspace=\"0\" rspace=\"0\">′</mo>";

/// A name in its parts, each as markup.
#[derive(Default)]
pub(super) struct Name {
    /// What its letters look like.
    face: Face,
    /// Letters and words, one element after another.
    letters: Vec<String>,
    /// Primes, which stand on the line: their sign is raised by itself.
    primes: String,
    /// Other marks, raised.
    marks: String,
    /// One element or several.
    pub(super) subscript: Option<String>,
}

impl Name {
    /// Takes a canonical name apart.
    pub(super) fn of(canonical: &str) -> Name {
        let (canonical, _) = as_printed(canonical);
        let canonical = &*canonical;
        let (stem, under) = match split_subscript(canonical) {
            Some((stem, under)) => (stem, Some(under)),
            None => (canonical, None),
        };
        let mut name = Name::default();
        match Bracketed::of(stem) {
            Some(own) => {
                name.letters.push(bracketed(&own));
                name.read(&mut { own.scripts }, 0);
            }
            None => name.read(&mut { stem }, 0),
        }
        name.subscript = under.map(|under| {
            let mut name = Name::default();
            name.read(&mut { under }, 0);
            name.markup()
        });
        name
    }

    /// The name as one element.
    pub(super) fn markup(&self) -> String {
        let base = self.base();
        let under = self.subscript.as_deref().map(grouped);
        match (under, self.marks.is_empty()) {
            (None, true) => base,
            (None, false) => format!("<msup>{base}{}</msup>", grouped(&self.marks)),
            (Some(under), true) => format!("<msub>{base}{under}</msub>"),
            (Some(under), false) => {
                format!("<msubsup>{base}{under}{}</msubsup>", grouped(&self.marks))
            }
        }
    }

    /// Letters and primes as one element.
    fn base(&self) -> String {
        match (self.letters.as_slice(), self.primes.is_empty()) {
            ([only], true) => only.clone(),
            (several, _) => format!("<mrow>{}{}</mrow>", several.concat(), self.primes),
        }
    }

    /// The name raised to a power, which is one element.
    pub(super) fn to_the(&self, exponent: String) -> String {
        let is_word = self.letters.len() > 1;
        if !self.marks.is_empty() || is_word {
            return format!(
                "<msup><mrow><mo>(</mo>{}<mo>)</mo></mrow>{exponent}</msup>",
                self.markup()
            );
        }
        match &self.subscript {
            Some(under) => format!(
                "<msubsup>{}{}{exponent}</msubsup>",
                self.base(),
                grouped(under)
            ),
            None => format!("<msup>{}{exponent}</msup>", self.base()),
        }
    }

    /// Reads on until a brace closes or the text ends.
    fn read(&mut self, rest: &mut &str, depth: usize) {
        while let Some(c) = rest.chars().next() {
            let after = rest.get(c.len_utf8()..).unwrap_or("");
            match c {
                '}' => {
                    *rest = after;
                    return;
                }
                '\\' => {
                    *rest = after;
                    self.command(rest, depth);
                }
                '\'' => {
                    *rest = after;
                    self.primes += PRIME;
                }
                '^' => {
                    *rest = after;
                    let mut mark = Name::default();
                    mark.one_piece(rest, depth);
                    self.marks += &mark.markup();
                }
                '{' if depth < DEEPEST => {
                    *rest = after;
                    self.read(rest, depth + 1);
                }
                '{' | ' ' => *rest = after,
                c if c.is_ascii_digit() => {
                    let end = rest.find(|c: char| !c.is_ascii_digit());
                    let (digits, after) = rest.split_at(end.unwrap_or(rest.len()));
                    *rest = after;
                    self.letters.push(format!("<mn>{digits}</mn>"));
                }
                c => {
                    *rest = after;
                    let kind = if c.is_alphabetic() { "mi" } else { "mo" };
                    let text = self.face.characters(c.encode_utf8(&mut [0; 4]));
                    let text = escape(&text);
                    self.letters.push(format!("<{kind}>{text}</{kind}>"));
                }
            }
        }
    }

    /// What one superscript or accent stands over.
    fn one_piece(&mut self, rest: &mut &str, depth: usize) {
        match rest.chars().next() {
            Some('{') if depth < DEEPEST => {
                *rest = rest.get(1..).unwrap_or("");
                self.read(rest, depth + 1);
            }
            Some('\\') => {
                *rest = rest.get(1..).unwrap_or("");
                self.command(rest, depth);
            }
            Some(c) => {
                let (own, after) = rest.split_at(c.len_utf8());
                *rest = after;
                self.read(&mut { own }, depth);
            }
            None => {}
        }
    }

    fn command(&mut self, rest: &mut &str, depth: usize) {
        let end = rest.find(|c: char| !c.is_ascii_alphabetic());
        let (command, after) = rest.split_at(end.unwrap_or(rest.len()));
        *rest = after;
        if command == "text" || command == "unit" {
            let inside = after.strip_prefix('{').unwrap_or(after);
            let end = inside.find('}').unwrap_or(inside.len());
            let word = inside.get(..end).unwrap_or("");
            *rest = inside.get(end + 1..).unwrap_or("");
            self.letters.push(upright(word));
        } else if commands::find(ACCENTS, command).is_some() {
            let mut inner = Name {
                face: Face::of(command).unwrap_or(Face::Plain),
                ..Name::default()
            };
            inner.one_piece(rest, depth);
            self.letters.push(accented(command, &inner));
        } else if let Some(letter) = commands::find(LETTERS, command) {
            let is_capital = command.starts_with(|c: char| c.is_ascii_uppercase());
            self.letters.push(match is_capital {
                true => upright(letter),
                false => format!("<mi>{letter}</mi>"),
            });
        } else if let Some(sign) = commands::find(SUBSCRIPTS, command) {
            let kind = match sign.chars().all(char::is_alphabetic) {
                true => "mi",
                false => "mo",
            };
            self.letters.push(format!("<{kind}>{sign}</{kind}>"));
        } else {
            let sign = match command {
                "dagger" => "†",
                "star" => "⋆",
                "circ" => "∘",
                other => other,
            };
            self.letters.push(format!("<mo>{}</mo>", escape(sign)));
        }
    }
}

/// A name with its brackets, as one element.
fn bracketed(own: &Bracketed) -> String {
    let written = |text: &str| {
        let mut name = Name::default();
        name.read(&mut { text }, 0);
        name.markup()
    };
    let piece = |piece: Piece| match piece {
        Piece::Term(Ok(term)) => mathml(&term),
        Piece::Term(Err(text)) => written(text),
        Piece::Relation(relation) => sign(relation),
        Piece::Sign(sign) => format!("<mo>{}</mo>", sign.trim()),
    };
    let content: String = match own.is_concentration() {
        true => written(own.content()),
        false => own.pieces().into_iter().map(piece).collect(),
    };
    let head = match own.head {
        "" => String::new(),
        head => written(head),
    };
    let (open, close) = own.around;
    format!("<mrow>{head}<mo>{open}</mo>{content}<mo>{close}</mo></mrow>")
}

/// Text as it was typed: upright, one letter or a word.
fn upright(word: &str) -> String {
    let escaped = escape(word);
    match word.chars().count() {
        1 => format!("<mi mathvariant=\"normal\">{escaped}</mi>"),
        _ if word.chars().all(char::is_alphanumeric) => format!("<mi>{escaped}</mi>"),
        _ => format!("<mtext>{escaped}</mtext>"),
    }
}

fn accented(command: &str, inner: &Name) -> String {
    let base = inner.markup();
    let Some((over, stretchy)) = accent(command) else {
        // Only the face of the letter changes; the style sheet has it.
        return format!("<mrow class=\"{command}\">{base}</mrow>");
    };
    format!("<mover accent=\"true\">{base}<mo stretchy=\"{stretchy}\">{over}</mo></mover>")
}

fn grouped(elements: &str) -> String {
    format!("<mrow>{elements}</mrow>")
}
