//! From characters to tokens: the only part of the reader that looks at single bytes.
//!
//! The lexer never fails. What it cannot make out becomes a [`Kind::Bad`] token, so that a `\tag` further on is
//! still found and the parser says what is wrong, at its place. Spacing that means nothing is dropped here;
//! `\quad`, which separates statements, is kept. One pass, no backtracking.

mod switch;

use self::switch::Face;
use super::commands::{PRINTED, SPACING};
use super::{Connective, Mark, Spanned, SyntaxError};
use crate::algebra::{Relation, Symbol};
use crate::document::Span;

/// The most characters of words between two braces; it keeps a run of unclosed ones from costing a scan each.
const LONGEST_ARGUMENT: usize = 1000;

/// What a token is. `Copy`, borrowing its text from the source.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind<'s> {
    /// One letter.
    Letter(char),
    /// Digits, perhaps with a decimal point or `{,}` between them, or `\,` between groups of three.
    Number(&'s str),
    /// `\name`, without the backslash.
    Command(&'s str),
    /// `\qty{3}{m}`: a number and a unit, either of which may be empty.
    Quantity(&'s str, &'s str),
    /// `\text{…}`: words.
    Text(&'s str),
    /// `\mathrm{…}`, `\operatorname{…}`: an upright name.
    Upright(&'s str),
    /// `\operatorname{…}` of a function that is not known: an upright name that must not be taken as a factor.
    Operator(&'s str),
    /// `\eqref{…}`: keys.
    Reference(&'s str),
    /// Any other character.
    Char(char),
    /// `{`
    Open,
    /// `}`
    Close,
    /// `\\`
    Row,
    /// `\quad` or `\qquad`
    Wide,
    /// `&` between a case and its condition. Made by `fold`.
    Cell,
    /// `\begin{…}`
    Begin(&'s str),
    /// `\end{…}`
    Finish(&'s str),
    /// The word `and` outside `\text`.
    And,
    /// The error of this number, kept in [`Lexed::errors`].
    Bad(usize),
    /// A whole relation sign, questioned or not. Made by `fold`, as are the next four.
    Relation(Relation, bool),
    /// `\Rightarrow`, `\iff`
    Connective(Connective),
    /// ✓ or ✗
    Mark(Mark),
    /// `\boxed{` around one or more whole clauses.
    BoxOpen,
    /// Its `}`.
    BoxClose,
    /// The end of the formula.
    End,
}

/// A token and its place.
#[derive(Clone, Copy, Debug)]
pub(super) struct Token<'s> {
    pub(super) kind: Kind<'s>,
    pub(super) span: Span,
    /// Whether a thin space, or a like one that the author asked for, stands before it.
    pub(super) spaced: bool,
}

/// All that the lexer found.
#[derive(Default)]
pub(super) struct Lexed<'s> {
    pub(super) tokens: Vec<Token<'s>>,
    pub(super) tags: Vec<Spanned<String>>,
    pub(super) labels: Vec<Spanned<String>>,
    pub(super) errors: Vec<SyntaxError>,
}

impl<'s> Lexed<'s> {
    /// Adds what was found further on.
    pub(super) fn append(&mut self, other: Lexed<'s>) {
        let before = self.errors.len();
        self.tokens
            .extend(other.tokens.into_iter().map(|token| Token {
                kind: match token.kind {
                    Kind::Bad(number) => Kind::Bad(number + before),
                    kind => kind,
                },
                ..token
            }));
        self.tags.extend(other.tags);
        self.labels.extend(other.labels);
        self.errors.extend(other.errors);
    }
}

/// Reads `source[body]` into tokens.
pub(super) fn lex(source: &str, body: Span) -> Lexed<'_> {
    let mut lexer = Lexer {
        source,
        at: body.start,
        end: body.end,
        spaced: false,
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
    while lexer.step() {}
    lexer.out
}

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

/// Whether a text begins with options and two groups, as after siunitx's `\qty[…]{3}{m}`.
pub(super) fn two_groups_follow(text: &str) -> bool {
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

/// ` const.` is `const`.
fn unabbreviated(text: &str) -> &str {
    let word = text.trim().trim_end_matches('.');
    match CONSTANT.contains(&word) {
        true => word,
        false => text,
    }
}

/// Whether words that begin so state a condition.
fn states_condition(word: &str) -> bool {
    ["for", "For", "if", "when", "whenever", "provided"].contains(&word)
}

struct Lexer<'s> {
    source: &'s str,
    at: usize,
    end: usize,
    /// Whether a space that is printed stands before the next token.
    spaced: bool,
    out: Lexed<'s>,
    /// The typeface in each group that is open here, the whole formula first.
    faces: Vec<Face>,
}

impl<'s> Lexer<'s> {
    fn rest(&self) -> &'s str {
        self.source.get(self.at..self.end).unwrap_or("")
    }

    fn peek(&self) -> Option<char> {
        self.rest().chars().next()
    }

    fn push(&mut self, start: usize, kind: Kind<'s>) {
        self.out.tokens.push(Token {
            kind,
            span: Span::new(start, self.at),
            spaced: std::mem::take(&mut self.spaced),
        });
    }

    fn bad(&mut self, span: Span, message: String, help: Option<String>) {
        let number = self.out.errors.len();
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
        let text = self.source.get(start..self.at).unwrap_or("");
        self.push(start, Kind::Number(text));
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
            '−' => Kind::Char('-'),
            '·' => Kind::Command("cdot"),
            '×' => Kind::Command("times"),
            '…' | '⋯' => Kind::Command("dots"),
            '′' | '’' => Kind::Char('\''),
            '≠' => Kind::Command("neq"),
            '≤' => Kind::Command("leq"),
            '≥' => Kind::Command("geq"),
            '✓' | '✔' => Kind::Mark(Mark::Tick),
            '✗' | '✘' => Kind::Mark(Mark::Cross),
            '%' => {
                self.take(|c| c != '\n');
                return;
            }
            '~' => {
                self.spaced = true;
                return;
            }
            c if c.is_whitespace() => return,
            c if c.is_ascii_punctuation() => Kind::Char(c),
            c => {
                let mut letters = super::commands::LETTERS.iter();
                let help = match c {
                    '°' => Some(
                        "write `^\\circ` in the angle of a sine, and a temperature in kelvin"
                            .into(),
                    ),
                    c => letters
                        .find(|(_, shown)| shown.chars().eq([c]) || (c == 'µ' && *shown == "μ"))
                        .map(|(name, _)| format!("write `\\{name}`")),
                };
                let span = Span::new(start, self.at);
                return self.bad(span, format!("the character `{c}` is not known"), help);
            }
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
                self.spaced = true;
                return;
            }
        }
        match name {
            "\\" => self.row(start),
            "quad" | "qquad" => self.push(start, Kind::Wide),
            _ if SPACING.contains(&name) => self.spaced |= PRINTED.contains(&name),
            "tag" | "label" => self.reference(start, name),
            "text" | "textrm" | "textnormal" | "mbox" => {
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
            "mathrm" | "operatorname" => self.upright(start, name),
            "eqref" | "ref" | "cref" | "Cref" | "autoref" => {
                if let Some(keys) = self.argument(start, name) {
                    self.push(start, Kind::Reference(keys));
                }
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

    /// `\text{for all $x > 1$}`: mathematics in words that state a condition is that of the formula. Other words are taken as they are.
    fn words(&mut self, start: usize, words: &'s str) {
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

    /// Words with wide spaces around them.
    fn words_apart(&mut self, start: usize, words: &'s str) {
        self.push(start, Kind::Wide);
        self.push(start, Kind::Text(words));
        self.push(start, Kind::Wide);
    }

    /// The raw text between the braces that follow.
    fn argument(&mut self, start: usize, name: &str) -> Option<&'s str> {
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

    fn reference(&mut self, start: usize, name: &'s str) {
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
    fn quantity(&mut self, start: usize, name: &'s str, number: bool, unit: bool) {
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

    fn upright(&mut self, start: usize, name: &'s str) {
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

    fn upright_text(&mut self, start: usize, name: &str, text: &'s str) {
        if name == "operatorname" && super::commands::is_function(text) {
            self.push(start, Kind::Command(text));
        } else if !text.is_empty() && text.chars().all(|c| c.is_ascii_alphanumeric()) {
            let kind = match name {
                "operatorname" => Kind::Operator(text),
                _ => Kind::Upright(text),
            };
            self.push(start, kind);
        } else if name != "operatorname" && !text.is_empty() && super::unit::read(text).is_ok() {
            self.push(start, Kind::Quantity("", text));
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
