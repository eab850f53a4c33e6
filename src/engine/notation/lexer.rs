//! From characters to tokens: the only part of the reader that looks at single bytes.
//!
//! The lexer never fails. What it cannot make out becomes a [`Kind::Bad`] token, so that a `\tag` further on is
//! still found and the parser says what is wrong, at its place. Spacing that means nothing is dropped here;
//! `\quad`, which separates statements, is kept. One pass, no backtracking.

mod argument;
mod space;
mod switch;
mod token;
mod unicode;

use self::space::Gap;
pub(super) use self::space::is_space;
use self::switch::Face;
use super::SyntaxError;
use super::commands::SPACING;
use crate::document::Span;
pub use argument::is_constant_word;
pub(super) use argument::two_groups_follow;
pub(super) use token::{Kind, Lexed, Token};

/// The most characters of words between two braces; it keeps a run of unclosed ones from costing a scan each.
const LONGEST_ARGUMENT: usize = 1000;

/// Room is made for a token of each so many characters.
const LEAST_LENGTH: usize = 2;

/// Reads `source[body]` into tokens.
pub(super) fn lex(source: &str, body: Span) -> Lexed<'_> {
    let mut lexer = Lexer {
        source,
        at: body.start,
        end: body.end,
        spaced: false,
        gap: Gap::default(),
        outside: Gap::default(),
        out: Lexed::default(),
        faces: vec![Face::Plain],
    };
    if source.get(body.start..body.end).is_none() {
        lexer.bad(
            body,
            "this place is not inside the document".to_owned(),
            None,
        );
        return lexer.out;
    }
    let length = body.end - body.start;
    lexer.out.tokens.reserve(length / LEAST_LENGTH);
    while lexer.step() {}
    lexer.out
}

/// Commands of the `physics` package for words with wide spaces around them: `\qand` is `\quad \text{and} \quad`.
const WORDS_APART: [&str; 12] = [
    "qand",
    "qor",
    "qif",
    "qthen",
    "qwhere",
    "qwith",
    "qfor",
    "qgiven",
    "qusing",
    "qsince",
    "qas",
    "qotherwise",
];

struct Lexer<'s> {
    source: &'s str,
    at: usize,
    end: usize,
    /// Whether a space that is printed stands before the next token.
    spaced: bool,
    /// How much space there is before it.
    gap: Gap,
    /// The space before the last brace that opens.
    outside: Gap,
    out: Lexed<'s>,
    /// The typeface in each group that is open here, the whole formula first.
    faces: Vec<Face>,
}

/// After the beginning of these it may be said how high they stand in the line.
const PLACED: [&str; 5] = ["aligned", "gathered", "split", "alignedat", "multlined"];

impl<'s> Lexer<'s> {
    fn rest(&self) -> &'s str {
        self.source.get(self.at..self.end).unwrap_or("")
    }

    fn peek(&self) -> Option<char> {
        self.rest().chars().next()
    }

    fn push(&mut self, start: usize, kind: Kind<'s>) {
        let gap = self.gap;
        if let Some(span) = self.parting(kind) {
            self.out.tokens.push(Token {
                kind: Kind::Wide,
                span,
                spaced: false,
            });
        }
        self.out.tokens.push(Token {
            kind,
            span: Span::new(start, self.at),
            spaced: std::mem::take(&mut self.spaced),
        });
        self.go_on(gap);
    }

    fn bad(&mut self, span: Span, message: String, help: Option<String>) {
        let number = self.out.errors.len();
        self.gap = Gap::default();
        self.out.errors.push(SyntaxError {
            span,
            message,
            help,
        });
        self.out.tokens.push(Token {
            kind: Kind::Bad(number),
            span,
            spaced: std::mem::take(&mut self.spaced),
        });
    }

    /// Takes the longest run of characters that satisfy `keep`.
    fn take(&mut self, keep: impl Fn(char) -> bool) -> &'s str {
        let rest = self.rest();
        let length = rest.find(|c| !keep(c)).unwrap_or(rest.len());
        self.at += length;
        rest.get(..length).unwrap_or("")
    }

    fn step(&mut self) -> bool {
        let start = self.at;
        let Some(c) = self.peek() else { return false };
        if c.is_ascii_digit() {
            self.number(start);
        } else if c.is_ascii_alphabetic() {
            match self.face() {
                Face::Plain => self.letter(start, c),
                face => self.switched(start, face),
            }
        } else if c == '\\' {
            self.at += 1;
            self.command(start);
        } else {
            self.at += c.len_utf8();
            self.other(start, c);
        }
        true
    }

    fn number(&mut self, start: usize) {
        self.take(|c| c.is_ascii_digit());
        let whole = self.at - start;
        while whole <= 3 && self.group_after("\\,") {
            self.at += "\\,000".len();
        }
        let grouped = self.at - start > whole;
        let rest = self.rest();
        if rest.starts_with('.') && rest.chars().nth(1).is_some_and(|c| c.is_ascii_digit()) {
            self.at += 1;
            self.take(|c| c.is_ascii_digit());
        } else if let Some(decimals) = rest.strip_prefix("{,}")
            && decimals.starts_with(|c: char| c.is_ascii_digit())
        {
            let group = self.group_after("{,}") && !grouped && whole <= 3;
            self.at += "{,}".len();
            self.take(|c| c.is_ascii_digit());
            let text = self.source.get(start..self.at).unwrap_or("");
            if group && !text.starts_with('0') {
                let message =
                    format!("whether `{text}` has decimals, or is in thousands, is not clear");
                let help = "write a decimal point, or `\\,` between the groups of a long number";
                return self.bad(Span::new(start, self.at), message, Some(help.to_owned()));
            }
        }
        if let Some(length) = self.power_of_ten(start) {
            let text = self.source.get(start..self.at + length).unwrap_or("");
            let message = format!("whether `{text}` has a power of ten or a factor is not clear");
            let help = "write `\\cdot 10^{-23}`, or `e - 23` with spaces";
            self.at += length;
            return self.bad(Span::new(start, self.at), message, Some(help.to_owned()));
        }
        let text = self.source.get(start..self.at).unwrap_or("");
        self.push(start, Kind::Number(text));
    }

    /// How long the `e-23` of `1.38e-23` is, where a number with decimals goes on like that.
    fn power_of_ten(&self, start: usize) -> Option<usize> {
        let has_decimals = self.source.get(start..self.at)?.contains('.');
        let rest = self.rest();
        let exponent = rest.strip_prefix(['e', 'E'])?;
        let unsigned = exponent.strip_prefix(['+', '-']).unwrap_or(exponent);
        let digits = unsigned.bytes().take_while(u8::is_ascii_digit).count();
        let ends = !unsigned[digits..].starts_with(['^', '.', '_', '!']);
        (has_decimals && digits > 0 && ends).then(|| rest.len() - unsigned.len() + digits)
    }

    /// Whether exactly three digits stand here after what parts them from those before.
    fn group_after(&self, sign: &str) -> bool {
        let digit = |c: &u8| c.is_ascii_digit();
        let rest = self.rest().strip_prefix(sign).map(str::as_bytes);
        rest.is_some_and(|rest| {
            rest.len() >= 3 && rest[..3].iter().all(digit) && !rest.get(3).is_some_and(digit)
        })
    }

    fn letter(&mut self, start: usize, c: char) {
        let before = self
            .source
            .get(..start)
            .and_then(|text| text.chars().next_back());
        let alone = |c: Option<char>| c.is_none_or(|c| c.is_whitespace() || "$,;".contains(c));
        if let Some(after) = self.rest().strip_prefix("and")
            && alone(before)
            && alone(after.chars().next())
        {
            self.at += 3;
            return self.push(start, Kind::And);
        }
        self.at += 1;
        self.push(start, Kind::Letter(c));
    }

    fn other(&mut self, start: usize, c: char) {
        match c {
            '{' => self.open_face(),
            '}' => self.close_face(),
            '&' => self.end_cell(),
            _ => {}
        }
        let kind = match c {
            '{' => Kind::Open,
            '}' => Kind::Close,
            '%' => {
                self.take(|c| c != '\n');
                return;
            }
            '~' => return self.word_space(start),
            c if c.is_whitespace() => return,
            c if c.is_ascii_punctuation() => Kind::Char(c),
            c => return self.unusual(start, c),
        };
        self.push(start, kind);
    }

    fn command(&mut self, start: usize) {
        let mut name = self.take(|c| c.is_ascii_alphabetic());
        if name.is_empty() {
            let Some(c) = self.peek() else {
                let span = Span::new(start, self.at);
                return self.bad(
                    span,
                    "a backslash at the end names no command".to_owned(),
                    None,
                );
            };
            let from = self.at;
            self.at += c.len_utf8();
            name = self.source.get(from..self.at).unwrap_or("");
            if c.is_whitespace() {
                return self.word_space(start);
            }
        }
        match name {
            "\\" => self.row(start),
            "quad" | "qquad" => self.push(start, Kind::Wide),
            _ if is_space(name) => self.space(start, name),
            _ if SPACING.contains(&name) => {}
            "tag" | "label" => self.reference(start, name),
            "text" | "textrm" | "textnormal" | "mbox" | "hbox" => {
                if let Some(words) = self.argument(start, name) {
                    self.words(start, words);
                }
            }
            "qq" => {
                if let Some(words) = self.argument(start, name) {
                    self.words_apart(start, words);
                }
            }
            _ if name.starts_with('q') && WORDS_APART.contains(&name) => {
                self.words_apart(start, &name[1..])
            }
            "color" => self.colour(start, name),
            "textcolor" | "mathcolor" => {
                self.push(start, Kind::Command(name));
                self.colour(start, name);
            }
            "degree" => {
                self.push(start, Kind::Char('^'));
                self.push(start, Kind::Command("circ"));
            }
            "hslash" => self.push(start, Kind::Command("hbar")),
            "mathrm" | "operatorname" => self.upright(start, name),
            "eqref" | "ref" | "cref" | "Cref" | "autoref" => {
                if let Some(keys) = self.argument(start, name) {
                    self.push(start, Kind::Reference(keys));
                }
            }
            "ang" => {
                self.quantity(start, name, true, false);
                self.push(start, Kind::Char('^'));
                self.push(start, Kind::Command("circ"));
            }
            "num" => self.quantity(start, name, true, false),
            // The `physics` package has a command of that name for parentheses that grow.
            "qty" if !two_groups_follow(self.rest()) => self.push(start, Kind::Command(name)),
            "qty" | "SI" => self.quantity(start, name, true, true),
            "unit" | "si" => self.quantity(start, name, false, true),
            "begin" | "end" => {
                if let Some(environment) = self.argument(start, name) {
                    let begin = name == "begin";
                    match begin {
                        true => self.open_face(),
                        false => self.close_face(),
                    }
                    self.push(
                        start,
                        if begin {
                            Kind::Begin(environment)
                        } else {
                            Kind::Finish(environment)
                        },
                    );
                    if begin && PLACED.contains(&environment) {
                        self.position();
                    }
                }
            }
            _ => match switch::face(name) {
                Some(face) => self.switch(start, name, face),
                None => {
                    match name {
                        "left" => self.open_face(),
                        "right" => self.close_face(),
                        _ => {}
                    }
                    self.push(start, Kind::Command(name));
                }
            },
        }
    }

    /// `[t]` after the beginning of what stands in a line says how high it stands.
    fn position(&mut self) {
        let rest = self.rest();
        let trimmed = rest.trim_start();
        if ["[t]", "[b]", "[c]"]
            .iter()
            .any(|own| trimmed.starts_with(own))
        {
            self.at += rest.len() - trimmed.len() + 3;
        }
    }

    /// `\\`, perhaps with a star and a length in brackets, as TeX takes them.
    fn row(&mut self, start: usize) {
        self.end_cell();
        if self.rest().starts_with('*') {
            self.at += 1;
        }
        if let Some((length, _)) = self
            .rest()
            .strip_prefix('[')
            .and_then(|rest| rest.split_once(']'))
        {
            let unit =
                length.trim_start_matches(|c: char| c.is_ascii_digit() || "+-. ".contains(c));
            if ["pt", "em", "ex", "mm", "cm", "jot"].contains(&unit.trim_start_matches('\\').trim())
            {
                self.at += length.len() + 2;
            }
        }
        self.push(start, Kind::Row);
    }
}
