//! Names and terms with a running index: `E_n`, `E_{n+1}`, `E_0`, and what becomes of them where the index is moved.

use std::slice;

use num_traits::{One, Zero};

use super::symbol::split_subscript;
use super::{BigRational, Expr, Symbol};

/// An offset or a number in a subscript has no more figures than this.
const MOST_FIGURES: usize = 4;

/// What a subscript says of an index.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// `E_3`: the element with this number, if `E` is a sequence at all.
    Number(u32),
    /// `E_{n+1}`: the element so far from the index.
    Running(i64),
    /// `E_{2n}`, `E_{n,0}`: it depends on the index in a way that is not read.
    Unclear,
}

/// Where an index is moved to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Moved {
    /// `n` becomes this number.
    To(u32),
    /// `n` becomes `n` and this number more.
    By(u32),
}

impl Symbol {
    /// Whether it can be the index of a sequence: a letter without marks.
    pub fn can_be_index(&self) -> bool {
        let name = self.name();
        let letters = name.strip_prefix('\\').unwrap_or(name);
        letters.bytes().all(|b| b.is_ascii_alphabetic())
            && !letters.is_empty()
            && (letters.len() == 1 || name.starts_with('\\'))
    }

    /// The name without its subscript, and what that says of an index; `None` where it says nothing.
    pub fn place(&self, index: &Symbol) -> Option<(Symbol, Place)> {
        if self.is_bracketed() && speaks_of(self.name(), index.name()) {
            return Some((self.clone(), Place::Unclear));
        }
        let (stem, text) = split_subscript(self.name())?;
        let figures = |text: &str| {
            let plain = text.bytes().all(|b| b.is_ascii_digit()) && text.len() <= MOST_FIGURES;
            // `007` is no number but a name.
            let number: u32 = text.parse().ok().filter(|_| plain)?;
            (number.to_string() == text).then_some(number)
        };
        let offset = || {
            let Some(rest) = text.strip_prefix(index.name()) else {
                let (number, rest) = text.split_once('+')?;
                return figures(number)
                    .filter(|_| rest == index.name())
                    .map(i64::from);
            };
            let (ahead, back) = (rest.strip_prefix('+'), rest.strip_prefix('-'));
            match (ahead, back) {
                (Some(number), _) => figures(number).map(i64::from),
                (_, Some(number)) => figures(number).map(|number| -i64::from(number)),
                _ => rest.is_empty().then_some(0),
            }
        };
        let place = match figures(text) {
            Some(number) => Place::Number(number),
            None => match offset() {
                Some(offset) => Place::Running(offset),
                None if speaks_of(text, index.name()) => Place::Unclear,
                None => return None,
            },
        };
        Some((Symbol::new(stem), place))
    }
}

/// The element of a sequence so far from its index.
pub fn running_symbol(sequence: &Symbol, index: &Symbol, offset: i64) -> Symbol {
    let name = match offset {
        0 if index.name().chars().count() == 1 => format!("{sequence}_{index}"),
        0 => format!("{sequence}_{{{index}}}"),
        _ => format!("{sequence}_{{{index}{offset:+}}}"),
    };
    Symbol::new(name)
}

/// Whether a letter stands in a subscript, outside of upright text. A run of letters, `in`, may be a word or indices:
/// each of them counts.
fn speaks_of(text: &str, letter: &str) -> bool {
    let mut rest = text;
    while let Some(c) = rest.chars().next() {
        let token = match c {
            '\\' => {
                let letters = rest[1..].bytes().take_while(u8::is_ascii_alphabetic);
                &rest[..1 + letters.count()]
            }
            _ => &rest[..c.len_utf8()],
        };
        if token == letter {
            return true;
        }
        rest = &rest[token.len()..];
        if token == "\\text" {
            let end = rest.find('}').map_or(rest.len(), |at| at + 1);
            rest = &rest[end..];
        }
    }
    false
}

impl Expr {
    /// Whether a term depends on an index, by itself or through the name of a symbol.
    pub fn depends_on(&self, index: &Symbol) -> bool {
        let named = |symbol: &Symbol| {
            symbol == index
                || matches!(
                    symbol.place(index),
                    Some((_, Place::Running(_) | Place::Unclear))
                )
        };
        self.any(&|part| match part {
            Expr::Symbol(own) | Expr::Apply(own, _) => named(own),
            Expr::Element { sequence, index } => named(sequence) || named(index),
            _ => part.binder().is_some_and(named),
        })
    }

    /// The same term for another value of an index; `None` where that cannot be said: under a derivative, in a function
    /// of which nothing is known, in a subscript that is not read, where a sum binds the index.
    pub fn moved(&self, index: &Symbol, to: Moved) -> Option<Expr> {
        if !self.depends_on(index) {
            return Some(self.clone());
        }
        match self {
            Expr::Symbol(own) if own == index => Some(index_at(index, 0, to)),
            Expr::Symbol(own) => match own.place(index)? {
                (stem, Place::Running(offset)) => {
                    element_at(&stem, index, offset, to).map(Expr::Symbol)
                }
                _ => None,
            },
            Expr::Element { .. }
            | Expr::Apply(..)
            | Expr::Derivative { .. }
            | Expr::Partial { .. }
            | Expr::Limit { .. }
            | Expr::Integral { .. } => None,
            Expr::Series { index: own, .. } if own == index => None,
            _ => {
                let mut whole = true;
                let moved = self.map_children(|child| {
                    child.moved(index, to).unwrap_or_else(|| {
                        whole = false;
                        child.clone()
                    })
                });
                whole.then(|| tidied(moved))
            }
        }
    }
}

/// `n` and so much more, moved.
fn index_at(index: &Symbol, more: u32, to: Moved) -> Expr {
    match to {
        Moved::To(number) => Expr::integer(number + more),
        Moved::By(0) if more == 0 => Expr::Symbol(index.clone()),
        Moved::By(number) => {
            Expr::Sum([Expr::Symbol(index.clone()), Expr::integer(number + more)].into())
        }
    }
}

/// An element of a sequence, moved; there are none with negative numbers.
pub fn element_at(stem: &Symbol, index: &Symbol, offset: i64, to: Moved) -> Option<Symbol> {
    match to {
        Moved::To(number) => {
            let number = u32::try_from(i64::from(number) + offset).ok()?;
            Some(element_symbol(stem, number))
        }
        Moved::By(number) => Some(running_symbol(stem, index, i64::from(number) + offset)),
    }
}

/// Numbers put together, as one would write them: `n + 1 + 1` is `n + 2`, `2 · 1` is 2.
fn tidied(term: Expr) -> Expr {
    match term {
        Expr::Sum(terms) => {
            let mut number = BigRational::zero();
            let mut rest = Vec::new();
            let flat = terms.iter().flat_map(|term| match term {
                Expr::Sum(inner) => inner,
                other => slice::from_ref(other),
            });
            for term in flat {
                match term {
                    Expr::Number(value) => number += value,
                    Expr::Negate(inner) if let Expr::Number(value) = &**inner => number -= value,
                    other => rest.push(other.clone()),
                }
            }
            if !number.is_zero() || rest.is_empty() {
                rest.push(Expr::Number(number));
            }
            match rest.len() {
                1 => rest.remove(0),
                _ => Expr::Sum(rest.into()),
            }
        }
        Expr::Product(factors) => {
            let number = |factor: &Expr| match factor {
                Expr::Number(value) => Some(value.clone()),
                _ => None,
            };
            match factors.iter().map(number).collect::<Option<Vec<_>>>() {
                Some(numbers) => Expr::Number(numbers.into_iter().product()),
                None => Expr::Product(factors),
            }
        }
        Expr::Negate(inner) => match &*inner {
            Expr::Number(value) => Expr::Number(-value),
            _ => Expr::Negate(inner),
        },
        Expr::Quotient(above, below) => match (&*above, &*below) {
            (Expr::Number(above), Expr::Number(below)) if !below.is_zero() => {
                Expr::Number(above / below)
            }
            _ => Expr::Quotient(above, below),
        },
        Expr::Power(base, exponent) => match &*exponent {
            Expr::Number(value) if value.is_one() => (*base).clone(),
            _ => Expr::Power(base, exponent),
        },
        other => other,
    }
}

/// `u` and 3, for the symbol `u_3`; `None` for a symbol that cannot name an element.
pub fn element_parts(symbol: &Symbol) -> Option<(Symbol, u32)> {
    let (name, position) = element_name(symbol)?;
    Some((Symbol::new(name), position))
}

/// The same, the name borrowed.
pub(super) fn element_name(symbol: &Symbol) -> Option<(&str, u32)> {
    let (name, subscript) = symbol.name().rsplit_once('_')?;
    let digits = match subscript.strip_prefix('{') {
        Some(braced) => braced.strip_suffix('}')?,
        None => subscript,
    };
    let plain = digits.bytes().all(|b| b.is_ascii_digit()) && !digits.starts_with('0');
    let position = digits.parse().ok().filter(|_| plain)?;
    Some((name, position))
}

/// `u_3`, as a symbol.
pub fn element_symbol(sequence: &Symbol, position: u32) -> Symbol {
    match position {
        // Most are one of these, and put together without much ado.
        0..=9 => {
            let digit = &"0123456789"[position as usize..][..1];
            Symbol::new([sequence.name(), "_", digit].concat())
        }
        _ => Symbol::new(format!("{sequence}_{{{position}}}")),
    }
}
