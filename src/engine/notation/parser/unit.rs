//! Units as people write them: `9.81\,\mathrm{m}/\mathrm{s}^2`, `36\,\frac{\mathrm{km}}{\mathrm{h}}`, `4\,\Omega`, `40\,\%`.
//!
//! They are looked for right after a number, and right after another such unit. Upright letters there are a unit if they
//! can be one; a fraction is one if all of it is. `\Omega`, `\mu` and the words of `\text{…}` are names elsewhere too:
//! they are taken only where the author has set a space before the unit. What is taken keeps its names, so that a
//! page that has a symbol of one of them can be refused.

use super::name::PROSE;
use super::quantity::product;
use super::{Before, BeforeKind, Factor, Kind, Parser, Read, Shape, refuse};
use crate::algebra::{Expr, Symbol};
use crate::notation::unit::{self, Last, Unit};
use crate::notation::{beside, commands};

/// A shorter word spells no unit out.
const SHORTEST_WORD: usize = 3;

/// A unit in the tokens.
pub(super) struct Written {
    unit: Unit,
    /// The names that it would be made of, were it none.
    names: Vec<String>,
    /// Whether it is made of what is a name elsewhere and is set no differently here.
    shy: bool,
    /// Whether a power after it is that of a part of it, so that it takes none.
    closed: bool,
    /// That part, where it is known: `\text{m/s}^2`.
    last: Option<Last>,
    /// The place after it.
    end: usize,
}

impl Written {
    fn of(unit: Unit, names: Vec<String>, end: usize) -> Written {
        Written {
            unit,
            names,
            shy: false,
            closed: false,
            last: None,
            end,
        }
    }

    /// Several units in one word, of which a power behind them raises the last alone.
    fn several(text: &str, end: usize) -> Option<Written> {
        let (unit, last) = unit::read_with_last(text).ok()?;
        Some(Written {
            closed: true,
            last,
            ..Written::of(unit, Vec::new(), end)
        })
    }

    /// Multiplies by a power of another unit, which ends at `end`.
    fn times(&mut self, other: Written, power: i32, end: usize) -> Option<()> {
        self.unit.times(&other.unit, power)?;
        self.names.extend(other.names);
        self.shy |= other.shy;
        self.end = end;
        Some(())
    }
}

fn upright(text: &str) -> String {
    format!("\\text{{{text}}}")
}

impl<'s> Parser<'s> {
    /// The unit that stands here, right after a number or another unit.
    pub(super) fn unit_here(&self, after_unit: bool) -> Option<Written> {
        let written = match self.peek() {
            Kind::Command("frac" | "tfrac" | "dfrac" | "sfrac") => self.unit_fraction()?,
            // `5\,\mathrm{m}\,\Omega` may be a velocity, `2\,\Omega t` an angle.
            Kind::Command("Omega") if after_unit || self.is_beside_a_name(self.at + 1) => {
                return None;
            }
            _ => self.unit_word(self.at)?,
        };
        let spaced = self.tokens.get(self.at).is_some_and(|token| token.spaced);
        (spaced || !written.shy).then_some(written)
    }

    /// The unit that goes on with one after a sign: `\cdot\mathrm{m}`, `/\mathrm{s}`.
    pub(super) fn unit_after_sign(&self, after_unit: bool) -> Option<Written> {
        let written = self.unit_word(self.at)?;
        let omega = self.peek() == Kind::Command("Omega");
        (!written.shy || after_unit && !omega).then_some(written)
    }

    /// The unit below a stroke: `/\mathrm{s}`, `/(\mathrm{mol}\,\mathrm{K})`.
    pub(super) fn unit_below(&self, after_unit: bool) -> Option<Written> {
        if self.peek() != Kind::Char('(') {
            return self.unit_after_sign(after_unit);
        }
        let mut written = self.unit_product(self.at + 1)?;
        if self.kind(written.end) != Kind::Char(')') || written.shy && !after_unit {
            return None;
        }
        written.end += 1;
        written.closed = true;
        Some(written)
    }

    /// The unit below a fraction stroke, with whatever stands above it: `\frac{5\,\mathrm{m}}{\mathrm{s}}`.
    pub(super) fn unit_denominator(&self) -> Option<Written> {
        if self.peek() != Kind::Open {
            return None;
        }
        let mut written = self.unit_product(self.at + 1)?;
        if written.shy || self.kind(written.end) != Kind::Close {
            return None;
        }
        written.end += 1;
        Some(written)
    }

    /// Takes a unit with its power. Whether the page has a symbol of that name is looked at later.
    pub(super) fn take_unit(&mut self, written: Written) -> Read<Factor> {
        let start = self.at;
        self.at = written.end;
        for name in written.names {
            self.before.push(Before {
                name: Symbol::new(name),
                span: self.since(start),
                kind: BeforeKind::Unit,
            });
        }
        let mut unit = written.unit;
        if let Some(last) = written.last.filter(|_| written.closed) {
            self.raise_last(&mut unit, &last)?;
        }
        let mut expr = product(None, &unit);
        if self.peek() == Kind::Char('^') && !written.closed {
            let span = self.span();
            match self.superscript()?.power {
                Some(power) => expr = Expr::Power(expr.into(), power.into()),
                None => return refuse(span, "a mark on a unit is not read"),
            }
        }
        Ok(Factor {
            expr,
            shape: Shape::Tight,
            span: self.since(start),
            braces: false,
        })
    }

    /// Takes the power that stands here, if there is one, as that of the last part of a unit.
    pub(super) fn raise_last(&mut self, unit: &mut Unit, last: &Last) -> Read<()> {
        if self.peek() != Kind::Char('^') {
            return Ok(());
        }
        let raised = self.whole_power(self.at).and_then(|(power, end)| {
            unit.raise(last, power)?;
            Some(end)
        });
        match raised {
            Some(end) => self.at = end,
            None => return refuse(self.span(), "this power of a unit is not read"),
        }
        Ok(())
    }

    /// `\mathrm{km}`, `\text{m/s}`, `\Omega`, `\mathrm{k}\Omega`, `\mu\mathrm{m}`, `\%`, without a power.
    fn unit_word(&self, at: usize) -> Option<Written> {
        let written = match self.kind(at) {
            Kind::Command("%") => Written::of(unit::read("%").ok()?, Vec::new(), at + 1),
            Kind::Command("AA") => Written::of(unit::read("Å").ok()?, Vec::new(), at + 1),
            Kind::Command("Omega") => Written {
                shy: true,
                ..Written::of(unit::read("Ω").ok()?, vec!["\\Omega".to_owned()], at + 1)
            },
            Kind::Command("mu") => self.micro(at)?,
            Kind::Upright(text) if unit::is_symbol(text) => {
                Written::of(unit::read(text).ok()?, vec![upright(text)], at + 1)
            }
            Kind::Upright(text) | Kind::Text(text) if self.joins(at, Kind::Command("Omega")) => {
                let prefix = text.trim_start();
                let unit = unit::read(&format!("{prefix}Ω")).ok()?;
                Written {
                    shy: matches!(self.kind(at), Kind::Text(_)) && prefix.len() == text.len(),
                    ..Written::of(unit, vec![upright(prefix), "\\Omega".to_owned()], at + 2)
                }
            }
            Kind::Text(words) => text_unit(words, at + 1)?,
            _ => return None,
        };
        let named = matches!(self.kind(written.end), Kind::Char('_' | '\'' | '('));
        (!named).then_some(written)
    }

    /// `\mu\mathrm{m}`, `\mu\text{m/s}`, with no space between the two.
    fn micro(&self, at: usize) -> Option<Written> {
        let (Kind::Upright(text) | Kind::Text(text) | Kind::Quantity("", text)) = self.kind(at + 1)
        else {
            return None;
        };
        let next = self.tokens.get(at + 1)?;
        if next.spaced || text.starts_with(char::is_whitespace) {
            return None;
        }
        let text = text.trim_end();
        let several = text.contains(|c: char| !c.is_alphanumeric());
        if !several && text != "M" && !unit::is_symbol(text) {
            return None;
        }
        let mut written = Written::several(&format!("µ{text}"), at + 2)?;
        written.names = vec!["\\mu".to_owned(), upright(text)];
        (written.shy, written.closed) = (true, several);
        Some(written)
    }

    /// Whether this stands after the token at this place, and no space between them.
    fn joins(&self, at: usize, kind: Kind) -> bool {
        let next = self.tokens.get(at + 1);
        next.is_some_and(|next| next.kind == kind && !next.spaced)
    }

    /// Whether what stands here makes a symbol of an `\Omega` before it: a script, or a factor that is no number.
    fn is_beside_a_name(&self, at: usize) -> bool {
        match self.kind(at) {
            Kind::Char(c) => "^_'([|".contains(c),
            Kind::Open => true,
            Kind::Command(name) => {
                commands::is_function(name)
                    || self.starts_name(at)
                    || ["frac", "tfrac", "dfrac", "sqrt", "left"].contains(&name)
            }
            _ => self.starts_name(at) && self.unit_word(at).is_none(),
        }
    }

    /// `\frac{\mathrm{m}}{\mathrm{s}^2}`, all of which is units; a 1 may stand above the stroke.
    fn unit_fraction(&self) -> Option<Written> {
        let (open, one) = (self.at + 1, self.kind(self.at + 2) == Kind::Number("1"));
        if self.kind(open) != Kind::Open {
            return None;
        }
        let mut over = match one {
            true => Written::of(Unit::one(), Vec::new(), open + 2),
            false => self.unit_product(open + 1)?,
        };
        if self.kind(over.end) != Kind::Close || self.kind(over.end + 1) != Kind::Open {
            return None;
        }
        let under = self.unit_product(over.end + 2)?;
        if self.kind(under.end) != Kind::Close {
            return None;
        }
        let end = under.end + 1;
        over.times(under, -1, end)?;
        over.closed = true;
        Some(over)
    }

    /// `\mathrm{mol}\,\mathrm{K}`, with powers that are whole numbers.
    fn unit_product(&self, start: usize) -> Option<Written> {
        let mut product = Written::of(Unit::one(), Vec::new(), start);
        loop {
            let dot = product.end > start && self.kind(product.end) == Kind::Command("cdot");
            let at = product.end + usize::from(dot);
            let next = match self.kind(at) {
                Kind::Quantity("", text) => Written {
                    closed: true,
                    ..Written::of(unit::read(text).ok()?, Vec::new(), at + 1)
                },
                _ => match self.unit_word(at) {
                    Some(next) => next,
                    None => return (product.end > start).then_some(product),
                },
            };
            let (power, end) = self.whole_power(next.end)?;
            if next.closed && end > next.end {
                return None;
            }
            product.times(next, power, end)?;
        }
    }

    /// The power that stands here, 1 where there is none, and the place after it.
    fn whole_power(&self, at: usize) -> Option<(i32, usize)> {
        if self.kind(at) != Kind::Char('^') {
            return Some((1, at));
        }
        let figures = |at: usize| match self.kind(at) {
            Kind::Number(text) if text.len() <= 2 => text.parse::<i32>().ok(),
            _ => None,
        };
        if self.kind(at + 1) != Kind::Open {
            return Some((figures(at + 1).filter(|power| *power < 10)?, at + 2));
        }
        let negative = self.kind(at + 2) == Kind::Char('-');
        let number = at + 2 + usize::from(negative);
        let power = figures(number)?;
        let power = if negative { -power } else { power };
        (self.kind(number + 1) == Kind::Close).then_some((power, number + 2))
    }
}

/// `\text{km}`, `\text{ m/s}`, `\text{N m}`: one unit, or several, but no words that are found in a sentence.
fn text_unit(words: &str, end: usize) -> Option<Written> {
    let name = words.trim();
    if PROSE.contains(&name) || name.contains('.') {
        return None;
    }
    if unit::is_symbol(name) {
        // Without a space it is a name after a number, as a name is printed.
        return Some(Written {
            shy: !words.starts_with(char::is_whitespace),
            ..Written::of(unit::read(name).ok()?, vec![upright(name)], end)
        });
    }
    // `2.3\ \text{days}`
    if name.len() >= SHORTEST_WORD
        && let Some(symbol) = beside::symbol_of(name)
    {
        return Some(Written::of(
            unit::read(&symbol).ok()?,
            vec![upright(name)],
            end,
        ));
    }
    let several = name.contains(|c: char| !c.is_alphanumeric());
    if !several {
        return None;
    }
    Written::several(name, end)
        .filter(|_| !name.contains(char::is_whitespace))
        .or_else(|| Written::several(&beside::spelt(name)?, end))
}
