//! Declared dimensions: `mass`, `M L^{-1/2} T^{-2}`, `energy/temperature`, `M/(L T)`.

use std::ops::Range;

use crate::algebra::{Base, BigInt, Dimension, Rational};

use super::names::named;

/// The most words in a name, `moment of inertia`.
const LONGEST_NAME: usize = 4;
/// Deeper brackets are a slip of the pen.
const DEEPEST: usize = 16;
/// Longer exponents are too.
const MOST_DIGITS: usize = 6;

/// Why a dimension could not be read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unreadable {
    /// The guilty bytes of the text.
    pub at: Range<usize>,
    /// What is wrong.
    pub message: String,
    /// The guilty word, if it is an unknown name.
    pub word: Option<String>,
}

/// Reads a dimension.
///
/// # Errors
/// The first thing that is not understood.
pub fn parse(text: &str) -> Result<Dimension, Unreadable> {
    let mut parser = Parser {
        text,
        at: 0,
        depth: 0,
    };
    let dimension = parser.product()?;
    match parser.peek() {
        None => Ok(dimension),
        Some(c) => parser.misplaced(c),
    }
}

struct Parser<'a> {
    text: &'a str,
    at: usize,
    depth: usize,
}

type Read<T> = Result<T, Unreadable>;

impl<'a> Parser<'a> {
    fn rest(&self) -> &'a str {
        &self.text[self.at..]
    }

    fn fault<T>(&self, at: Range<usize>, message: impl Into<String>) -> Read<T> {
        Err(Unreadable {
            at,
            message: message.into(),
            word: None,
        })
    }

    fn misplaced<T>(&self, c: char) -> Read<T> {
        let end = self.at + c.len_utf8();
        self.fault(self.at..end, format!("`{c}` has no place in a dimension"))
    }

    /// The next character after white space and signs of multiplication that say nothing.
    fn peek(&mut self) -> Option<char> {
        let trimmed = self.rest().trim_start();
        self.at = self.text.len() - trimmed.len();
        trimmed.chars().next()
    }

    fn accept(&mut self, sign: &str) -> bool {
        self.peek();
        let found = self.rest().starts_with(sign);
        if found {
            self.at += sign.len();
        }
        found
    }

    fn product(&mut self) -> Read<Dimension> {
        let mut product = self.factor()?;
        let mut divided = false;
        loop {
            let start = self.at;
            let times = ["·", "*", "×", "\\cdot", "\\times", "\\,"]
                .iter()
                .any(|sign| self.accept(sign));
            if !times && self.accept("/") {
                let under = self.factor()?;
                product.multiply(&under, &-Rational::one());
                divided = true;
                continue;
            }
            match self.peek() {
                None | Some(')') if !times => return Ok(product),
                _ if divided => {
                    let message = "whether this is divided by too is not clear: use brackets, or negative exponents";
                    let start = self.at.max(start);
                    return self.fault(start..self.text.len(), message);
                }
                _ => product.multiply(&self.factor()?, &Rational::one()),
            }
        }
    }

    fn factor(&mut self) -> Read<Dimension> {
        let start = self.at;
        match self.peek() {
            Some('(') if self.depth < DEEPEST => {
                self.at += 1;
                self.depth += 1;
                let inner = self.product()?;
                self.depth -= 1;
                if !self.accept(")") {
                    return self.fault(start..self.text.len(), "this bracket is not closed");
                }
                Ok(inner.power(&self.exponent()?))
            }
            Some('1') => {
                self.at += 1;
                Ok(Dimension::none())
            }
            Some(c) if c.is_alphabetic() || c == '\\' => self.name(),
            Some(c) => self.misplaced(c),
            None => self.fault(self.at..self.at, "a dimension is missing here"),
        }
    }

    /// A name of some words, or letters of bases; an exponent belongs to the last.
    fn name(&mut self) -> Read<Dimension> {
        let start = self.at;
        let ends = self.words();
        for &end in ends.iter().rev() {
            let name = self.text[start..end].to_lowercase();
            let name = name
                .split([' ', '-'])
                .filter(|w| !w.is_empty())
                .collect::<Vec<_>>()
                .join(" ");
            if let Some(dimension) = named(&name) {
                self.at = end;
                return Ok(dimension.power(&self.exponent()?));
            }
        }
        let end = ends.first().copied().unwrap_or(self.text.len());
        let word = &self.text[start..end];
        let Some(bases) = bases(word) else {
            let whole = &self.text[start..*ends.last().unwrap_or(&end)];
            return Err(Unreadable {
                at: start..start + whole.len(),
                message: format!("`{whole}` is the name of no dimension"),
                word: Some(whole.to_owned()),
            });
        };
        self.at = end;
        let exponent = self.exponent()?;
        let mut product = Dimension::none();
        for (at, base) in bases.iter().enumerate() {
            let last = at + 1 == bases.len();
            let power = if last {
                exponent.clone()
            } else {
                Rational::one()
            };
            product.multiply(&Dimension::base(*base), &power);
        }
        Ok(product)
    }

    /// Where the first word ends, the first two, and so on.
    fn words(&self) -> Vec<usize> {
        let mut ends = Vec::new();
        let mut at = self.at;
        for _ in 0..LONGEST_NAME {
            let rest = &self.text[at..];
            let skipped = match ends.is_empty() {
                true => 0,
                false => rest.len() - rest.trim_start_matches([' ', '-', '\t', '\n']).len(),
            };
            let word = rest[skipped..].strip_prefix('\\').map_or(0, |_| 1);
            let from = skipped + word;
            let length = rest[from..]
                .find(|c: char| !c.is_alphabetic())
                .unwrap_or(rest.len() - from);
            if length == 0 || (!ends.is_empty() && word == 1) {
                break;
            }
            at += from + length;
            ends.push(at);
        }
        ends
    }

    /// `^2`, `^{-1/2}`, `^(1/2)`, `⁻²`; 1 where there is none.
    fn exponent(&mut self) -> Read<Rational> {
        let start = self.at;
        let raised: String = self.rest().chars().map_while(lowered).collect();
        if !raised.is_empty() {
            self.at += self
                .rest()
                .chars()
                .take_while(|c| lowered(*c).is_some())
                .map(char::len_utf8)
                .sum::<usize>();
            return self.number(&raised, start);
        }
        if !self.rest().starts_with('^') {
            return Ok(Rational::one());
        }
        self.at += 1;
        let close = match self.rest().chars().next() {
            Some('{') => Some('}'),
            Some('(') => Some(')'),
            _ => None,
        };
        let inner = match close {
            Some(close) => {
                let Some(end) = self.rest().find(close) else {
                    return self.fault(start..self.text.len(), "this exponent is not closed");
                };
                let inner = &self.rest()[1..end];
                self.at += end + 1;
                inner
            }
            None => {
                let rest = self.rest();
                let sign = usize::from(rest.starts_with(['-', '+']))
                    + if rest.starts_with('−') {
                        '−'.len_utf8()
                    } else {
                        0
                    };
                let digits = rest[sign..]
                    .find(|c: char| !c.is_ascii_digit())
                    .unwrap_or(rest.len() - sign);
                self.at += sign + digits;
                &rest[..sign + digits]
            }
        };
        self.number(inner, start)
    }

    fn number(&self, text: &str, start: usize) -> Read<Rational> {
        let text = text.replace('−', "-").replace(' ', "");
        let (sign, magnitude) = match text.strip_prefix('-') {
            Some(rest) => (-1, rest),
            None => (1, text.strip_prefix('+').unwrap_or(&text)),
        };
        let (over, under) = magnitude.split_once('/').unwrap_or((magnitude, "1"));
        let whole = |digits: &str| -> Option<Rational> {
            let plain = !digits.is_empty()
                && digits.len() <= MOST_DIGITS
                && digits.bytes().all(|b| b.is_ascii_digit());
            plain
                .then(|| digits.parse::<BigInt>().ok().map(Rational::from))
                .flatten()
        };
        match (whole(over), whole(under)) {
            (Some(over), Some(under)) if !under.is_zero() => {
                Ok(Rational::from(sign) * (over / under))
            }
            _ => self.fault(
                start..self.at.max(start + 1),
                "an exponent is a rational number: `^{-1/2}`",
            ),
        }
    }
}

/// The character that a raised one stands for.
fn lowered(c: char) -> Option<char> {
    let at = "⁰¹²³⁴⁵⁶⁷⁸⁹⁻ᐟ".chars().position(|raised| raised == c)?;
    "0123456789-/".chars().nth(at)
}

/// The bases that letters stand for: `M`, `MLT`, `\Theta`, `K`.
fn bases(word: &str) -> Option<Vec<Base>> {
    if word == "\\Theta" {
        return Some(vec![Base::Temperature]);
    }
    let letter = |c: char| match c {
        'M' => Some(Base::Mass),
        'L' => Some(Base::Length),
        'T' => Some(Base::Time),
        'I' => Some(Base::Current),
        'Θ' | 'K' => Some(Base::Temperature),
        'N' => Some(Base::Amount),
        'J' => Some(Base::Luminosity),
        _ => None,
    };
    word.chars().map(letter).collect()
}
