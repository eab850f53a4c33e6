//! Text with mathematics in it.

use super::font;
use crate::notation::unbraced;

/// How much smaller sub- and superscripts are.
pub(super) const SCRIPT: f64 = 0.7;
/// Between a letter and its prime, in ems.
const PRIME_GAP: f64 = 0.07;

/// A line of text as pieces of one kind each.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rich(pub Vec<Run>);

/// Text of one kind.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    /// The text.
    pub text: String,
    /// A variable.
    pub italic: bool,
    /// On the line, below it or above it.
    pub level: Level,
    /// By how much it begins before the end of the last, in ems of the line: an index stands under a prime.
    pub back: f64,
}

/// Where a piece of text stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Level {
    /// On the line.
    Base,
    /// A subscript.
    Sub,
    /// A superscript.
    Super,
}

impl Level {
    /// The size, of the line's.
    pub(super) fn scale(self) -> f64 {
        match self {
            Level::Base => 1.0,
            _ => SCRIPT,
        }
    }

    /// How far below the line, in ems of the line.
    fn drop(self) -> f64 {
        match self {
            Level::Base => 0.0,
            Level::Sub => 0.2,
            Level::Super => -0.34,
        }
    }
}

impl Run {
    /// How far below the line, in ems of the line; an index under a prime keeps clear of it.
    pub(super) fn drop(&self) -> f64 {
        match self.back > 0.0 {
            true => self.level.drop() + 0.06,
            false => self.level.drop(),
        }
    }

    /// The width, for a line of size 1.
    pub(super) fn width(&self) -> f64 {
        font::width(&self.text, self.italic) * self.level.scale() - self.back
    }
}

impl Rich {
    /// Words.
    pub fn words(text: &str) -> Rich {
        Rich::default().and(text)
    }

    /// Mathematics alone; see [`Rich::math`].
    pub fn formula(text: &str) -> Rich {
        Rich::default().math(text)
    }

    /// Goes on with words.
    #[must_use]
    pub fn and(mut self, text: &str) -> Rich {
        self.push(text.to_owned(), false, Level::Base, 0.0);
        self
    }

    /// Goes on with another text.
    #[must_use]
    pub fn join(mut self, other: Rich) -> Rich {
        self.0.extend(other.0);
        self
    }

    /// Goes on with mathematics in the notation of [`plain`](crate::notation::plain): `v′₁ = E_{after}^(2 n)`.
    ///
    /// Single letters are variables, an index behind a prime stands under it, and no line is broken in it.
    #[must_use]
    pub fn math(mut self, text: &str) -> Rich {
        let text: Vec<char> = text.chars().collect();
        let mut at = 0;
        let mut primes = 0.0;
        while let Some(&character) = text.get(at) {
            let next = text.get(at + 1).copied();
            if let Some((level, script)) = script(character) {
                let back = if level == Level::Sub { primes } else { 0.0 };
                self.push(script.to_string(), script.is_alphabetic(), level, back);
                (at, primes) = (at + 1, 0.0);
                continue;
            }
            if let ('_' | '^', Some(next)) = (character, next) {
                let level = match character {
                    '_' => Level::Sub,
                    _ => Level::Super,
                };
                let (content, after) = grouped(&text, at + 1, next);
                let italic = content.chars().count() == 1 && is_variable(next);
                let back = if level == Level::Sub { primes } else { 0.0 };
                match level {
                    Level::Super => self.scripted(&content),
                    _ => self.push(content, italic, level, back),
                }
                (at, primes) = (after, 0.0);
                continue;
            }
            let is_word = |c: Option<&char>| c.is_some_and(char::is_ascii_alphabetic);
            let in_word = is_word(text.get(at + 1)) || at > 0 && is_word(text.get(at - 1));
            let italic = is_variable(character) && !(in_word && character.is_ascii());
            let shown = if character == ' ' {
                '\u{a0}'
            } else {
                character
            };
            // The arm of a slanted letter keeps clear of the prime behind it.
            let gap = match character == '′' && primes == 0.0 {
                true => PRIME_GAP,
                false => 0.0,
            };
            self.push(shown.to_string(), italic, Level::Base, -gap);
            primes = match character {
                '′' => primes + gap + font::width("′", false),
                _ => 0.0,
            };
            at += 1;
        }
        self
    }

    /// A superscript with variables in it.
    fn scripted(&mut self, content: &str) {
        for character in content.chars() {
            let shown = if character == ' ' {
                '\u{2009}'
            } else {
                character
            };
            self.push(shown.to_string(), is_variable(character), Level::Super, 0.0);
        }
    }

    fn push(&mut self, text: String, italic: bool, level: Level, back: f64) {
        if text.is_empty() {
            return;
        }
        match self.0.last_mut() {
            Some(last) if (last.italic, last.level) == (italic, level) && back == 0.0 => {
                last.text.push_str(&text);
            }
            _ => self.0.push(Run {
                text,
                italic,
                level,
                back,
            }),
        }
    }

    /// The width, for a line of size 1.
    pub fn width(&self) -> f64 {
        self.0.iter().map(Run::width).sum()
    }

    /// One line of text, without braces: for those who cannot see what stands high or low.
    ///
    /// ```
    /// use cradle_verify::figures::rich::Rich;
    /// assert_eq!(Rich::formula("v_1^2 = e² E_{after}").plain().replace('\u{a0}', " "), "v₁² = e² E_after");
    /// assert_eq!(Rich::formula("δ^(3/2) + E_n").plain().replace('\u{a0}', " "), "δ^(3/2) + Eₙ");
    /// ```
    pub fn plain(&self) -> String {
        let mut text = String::new();
        // A script may be several runs: letters in it slant, digits do not.
        for runs in self.0.chunk_by(|a, b| a.level == b.level) {
            let content: String = runs.iter().map(|run| run.text.as_str()).collect();
            match runs[0].level {
                Level::Base => text += &content,
                level => text += &lettered(level, &content.replace('\u{2009}', "\u{a0}")),
            }
        }
        text
    }

    /// Broken at spaces into lines no wider than so many ems, as far as there are spaces.
    pub(super) fn lines(&self, width: f64) -> Vec<Rich> {
        let mut lines = vec![Rich::default()];
        // Of the line that is being filled.
        let mut filled = 0.0;
        for word in self.split() {
            let line = lines.last_mut().expect("there is a line");
            let more = word.width();
            let ended = word.0.last().is_some_and(|run| run.text.ends_with(' '));
            let space = if ended { font::width(" ", false) } else { 0.0 };
            if !line.0.is_empty() && filled + more - space > width {
                lines.push(word);
                filled = more;
            } else {
                *line = std::mem::take(line).join(word);
                filled += more;
            }
        }
        lines
    }

    /// The words, each with the spaces after it.
    fn split(&self) -> Vec<Rich> {
        let mut words = vec![Rich::default()];
        for run in &self.0 {
            for piece in run.text.split_inclusive(' ') {
                let word = words.last_mut().expect("there is a word");
                word.push(piece.to_owned(), run.italic, run.level, run.back);
                if piece.ends_with(' ') {
                    words.push(Rich::default());
                }
            }
        }
        words
    }
}

/// Letters that stand for quantities; capital Δ and Σ are signs.
fn is_variable(character: char) -> bool {
    character.is_ascii_alphabetic() || ('α'..='ω').contains(&character)
}

/// What stands in braces or parentheses behind `_` or `^`, and where it ends; else one character.
fn grouped(text: &[char], at: usize, first: char) -> (String, usize) {
    let close = match first {
        '{' => '}',
        '(' => ')',
        _ => return (first.to_string(), at + 1),
    };
    let end = text[at..].iter().position(|&c| c == close);
    let end = end.map_or(text.len(), |length| at + length);
    (text[at + 1..end].iter().collect(), end + 1)
}

/// Characters that are subscripts themselves, and what they are on the line.
const SUB: [&str; 2] = ["₀₁₂₃₄₅₆₇₈₉ₙₖᵢⱼ", "0123456789nkij"];
/// The same for superscripts.
const SUPER: [&str; 2] = ["⁰¹²³⁴⁵⁶⁷⁸⁹ⁿ⁻", "0123456789n−"];

/// The character of one row that stands where another has its place in the other row.
fn across(character: char, from: &str, to: &str) -> Option<char> {
    to.chars().nth(from.chars().position(|c| c == character)?)
}

/// A character that is itself a script, as an ordinary one.
fn script(character: char) -> Option<(Level, char)> {
    let on_the_line = |[scripts, plain]: [&str; 2]| across(character, scripts, plain);
    let sub = on_the_line(SUB).map(|c| (Level::Sub, c));
    sub.or_else(|| on_the_line(SUPER).map(|c| (Level::Super, c)))
}

/// A script in a line of text: `₁`, `^n`, `_after`, `^(3/2)`.
fn lettered(level: Level, content: &str) -> String {
    let ([scripts, plain], sign, [open, close]) = match level {
        Level::Super if content.chars().count() > 1 => (SUPER, '^', ['(', ')']),
        Level::Super => (SUPER, '^', ['{', '}']),
        _ => (SUB, '_', ['{', '}']),
    };
    let letters = content.chars().map(|c| across(c, plain, scripts));
    match letters.collect::<Option<String>>() {
        Some(letters) => letters,
        None => unbraced(&format!("{sign}{open}{content}{close}")),
    }
}
