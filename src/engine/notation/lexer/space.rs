//! Spaces that the author asked for. A few narrow ones in a row, `~~~~` or `\;\;\;`, part two statements as `\quad` does.
//!
//! What stands on both sides of a gap is a product only where the gap is no wider than a space between words, for nobody sets factors so
//! far apart. Beside a sign, `a\;\;=\;\;b`, a gap parts nothing.

use super::{Kind, Lexer};
use crate::document::Span;
use crate::notation::commands;

/// The width of a gap from which on it parts what stands before it from what stands behind it, in eighteenths of a quad.
const PARTING: i32 = 10;
/// The same after a number, which may stand further from its unit.
const PARTING_NUMBER: i32 = 18;
/// A quad in these.
const QUAD: i32 = 18;
/// A length that is not known, or stretches: surely a wide one.
const STRETCHING: i32 = 10 * QUAD;
/// No gap counts for more, so that no sum of them overflows.
const WIDEST: i32 = 1_000 * QUAD;

/// The space since the last token.
#[derive(Clone, Copy, Default)]
pub(super) struct Gap {
    width: i32,
    /// Where it begins and ends.
    span: Option<Span>,
}

/// How wide a command is that does nothing but leave space, in eighteenths of a quad.
fn width(command: &str) -> Option<i32> {
    Some(match command {
        "!" | "negthinspace" => -3,
        "negmedspace" => -4,
        "negthickspace" => -5,
        "," | "thinspace" => 3,
        ":" | ">" | "medspace" => 4,
        ";" | "thickspace" => 5,
        " " | "space" | "nobreakspace" => 6,
        "enspace" | "enskip" => 9,
        "hfill" | "hfil" => STRETCHING,
        _ => return None,
    })
}

/// How a command says how wide it is.
#[derive(Clone, Copy)]
enum Length {
    /// `\hspace{1cm}`
    Braces,
    /// `\kern 3pt`
    Plain,
    /// `\phantom{x}`: as wide as what stands there.
    Content,
    /// `\vphantom{x}`: of no width, whatever stands there.
    None,
}

fn length(command: &str) -> Option<Length> {
    Some(match command {
        "hspace" | "mspace" => Length::Braces,
        "hskip" | "kern" | "mkern" | "mskip" => Length::Plain,
        "phantom" | "hphantom" => Length::Content,
        "vphantom" | "vspace" => Length::None,
        _ => return None,
    })
}

/// Whether a command leaves space and does nothing else.
pub(in crate::notation) fn is_space(command: &str) -> bool {
    width(command).is_some() || length(command).is_some()
}

/// Whether such a token may be a factor by itself.
fn is_factor(kind: Kind) -> bool {
    matches!(
        kind,
        Kind::Letter(_)
            | Kind::Number(_)
            | Kind::Quantity(..)
            | Kind::Upright(_)
            | Kind::Operator(_)
            | Kind::Text(_)
    )
}

/// Whether a gap after such a token parts something: it ends what may be a factor.
fn ends_factor(kind: Kind) -> bool {
    match kind {
        Kind::Close | Kind::Finish(_) => true,
        Kind::Char(c) => ")]'!".contains(c),
        Kind::Command(name) => {
            matches!(
                name,
                "}" | "rbrace" | "rbrack" | "rvert" | "rceil" | "rfloor"
            ) || commands::find(commands::LETTERS, name).is_some()
        }
        _ => is_factor(kind),
    }
}

/// Whether a gap before such a token parts something.
fn begins_factor(kind: Kind) -> bool {
    match kind {
        Kind::Open | Kind::Begin(_) => true,
        Kind::Char(c) => "([".contains(c),
        // What is coloured may begin with a factor.
        Kind::Command("textcolor" | "mathcolor" | "smash") => true,
        Kind::Command(name) => commands::begins_term(name),
        _ => is_factor(kind),
    }
}

/// Whether a command sets what it applies to as a sign, and nothing where that is nothing.
fn is_spacing(kind: Kind) -> bool {
    matches!(
        kind,
        Kind::Command("mathrel" | "mathbin" | "mathop" | "mathord")
    )
}

impl<'s> Lexer<'s> {
    fn widen(&mut self, start: usize, by: i32) {
        let own = Span::new(start, self.at);
        self.gap.width = (self.gap.width + by).clamp(-WIDEST, WIDEST);
        self.gap.span = Some(self.gap.span.map_or(own, |before| before.to(own)));
        self.spaced |= by > 0;
    }

    /// A space between words: `~`, `\ `.
    pub(super) fn word_space(&mut self, start: usize) {
        self.widen(start, 6);
    }

    /// Takes a command that leaves space, behind its name.
    pub(super) fn space(&mut self, start: usize, name: &str) {
        if let Some(by) = width(name) {
            return self.widen(start, by);
        }
        let Some(length) = length(name) else { return };
        match length {
            Length::Plain => match self.dimension() {
                Some(by) => self.widen(start, by),
                None => {
                    let message = format!("`\\{name}` needs a length after it");
                    let help = "write `\\quad`".to_owned();
                    self.bad(Span::new(start, self.at), message, Some(help));
                }
            },
            Length::Braces => {
                if self.rest().starts_with('*') {
                    self.at += 1;
                }
                if let Some(text) = self.argument(start, name) {
                    let (by, rest) = dimension(text).unwrap_or((STRETCHING, ""));
                    let stretches = !rest.trim().is_empty();
                    self.widen(start, if stretches { STRETCHING } else { by });
                }
            }
            Length::Content | Length::None => {
                if self.rest().starts_with('*') {
                    self.at += 1;
                }
                let Some(text) = self.argument(start, name) else {
                    return;
                };
                let wide = matches!(length, Length::Content) && !text.trim().is_empty();
                self.widen(start, if wide { STRETCHING } else { 0 });
            }
        }
    }

    /// Takes the length that stands here, perhaps with what it stretches by.
    fn dimension(&mut self) -> Option<i32> {
        let (by, rest) = dimension(self.rest())?;
        self.at = self.end - rest.len();
        for word in ["plus", "minus"] {
            if let Some(after) = self.rest().trim_start().strip_prefix(word) {
                self.at = self.end - dimension(after)?.1.len();
            }
        }
        Some(by)
    }

    /// Goes on with the gap before the token that was pushed, where that closes braces around nothing but space: they part it no more than
    /// they show.
    pub(super) fn go_on(&mut self, gap: Gap) {
        let mut kinds = self.out.tokens.iter().rev().map(|token| token.kind);
        match (kinds.next(), kinds.next()) {
            // A wide one stands there as a token.
            (Some(Kind::Open), Some(Kind::Wide)) => self.outside = Gap::default(),
            (Some(Kind::Open), _) => self.outside = gap,
            (Some(Kind::Close), Some(Kind::Open)) => {
                self.gap.width = (self.outside.width + gap.width).clamp(-WIDEST, WIDEST);
                self.gap.span = match (self.outside.span, gap.span) {
                    (Some(before), Some(own)) => Some(before.to(own)),
                    (before, own) => before.or(own),
                };
            }
            _ => {}
        }
    }

    /// The wide space that stands for the gap before a token of this kind, if it parts that from what stands before.
    pub(super) fn parting(&mut self, next: Kind) -> Option<Span> {
        let Gap { width, span } = std::mem::take(&mut self.gap);
        let span = span.filter(|_| width >= PARTING)?;
        let mut tokens = self.out.tokens.as_slice();
        while let [rest @ .., open, close] = tokens
            && (open.kind, close.kind) == (Kind::Open, Kind::Close)
        {
            tokens = match rest {
                [rest @ .., sign] if is_spacing(sign.kind) => rest,
                _ => rest,
            };
        }
        let before = tokens.last()?.kind;
        let least = match before {
            Kind::Number(_) => PARTING_NUMBER,
            _ => PARTING,
        };
        (width >= least && ends_factor(before) && begins_factor(next)).then_some(span)
    }
}

/// A length as TeX takes it, `1.5 cm`, in eighteenths of a quad, and what follows it; a quad is ten points wide.
fn dimension(text: &str) -> Option<(i32, &str)> {
    let text = text.trim_start();
    let (negative, text) = match text.strip_prefix('-') {
        Some(rest) => (true, rest.trim_start()),
        None => (false, text),
    };
    let digits = text
        .find(|c: char| !c.is_ascii_digit() && c != '.')
        .unwrap_or(text.len());
    let (figures, rest) = text.split_at(digits);
    let (whole, part) = figures.split_once('.').unwrap_or((figures, ""));
    if whole.is_empty() && part.is_empty() {
        return None;
    }
    // A thousand is more than wide; tenths are near enough.
    let whole: i32 = match whole.len() {
        0 => 0,
        1..=3 => whole.parse().ok()?,
        _ => 999,
    };
    let tenth = part
        .bytes()
        .next()
        .map_or(0, |digit| i32::from(digit.saturating_sub(b'0')));
    let tenths = whole * 10 + tenth;
    let rest = rest.trim_start();
    let (unit, rest) = rest.split_at_checked(2)?;
    let of_unit = match unit {
        "mu" => 1,
        "pt" | "bp" => 2,
        "ex" => 8,
        "mm" => 5,
        "em" => QUAD,
        "pc" => 22,
        "cm" => 51,
        "in" => 130,
        "fi" => return Some((STRETCHING, rest.trim_start_matches('l'))),
        _ => return None,
    };
    let width = tenths.saturating_mul(of_unit) / 10;
    Some((if negative { -width } else { width }, rest))
}
