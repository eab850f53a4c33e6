//! Numbers with units as siunitx writes them: `\qty{9.81}{m/s^2}`, `\unit{\metre\per\second}`.

use super::{DEEPEST, Ends, Face, Setter};
use crate::notation::unit;

/// Between a number and its unit.
const THIN: &str = "<mspace width=\"0.17em\"/>";

impl Setter<'_> {
    /// A quantity, behind the name of its command.
    pub(super) fn quantity(&mut self, name: &str) -> String {
        self.skip_blank();
        self.options();
        let number = match name {
            "unit" | "si" => String::new(),
            _ => self.numeral(),
        };
        let unit = match name {
            "num" => String::new(),
            "ang" => "<mi>°</mi>".to_owned(),
            _ => {
                let text = self.raw();
                self.within(&spelt(text).unwrap_or_else(|| text.replace(['.', '~'], "\\,")))
            }
        };
        let between = match name {
            "qty" | "SI" => THIN,
            _ => "",
        };
        format!("<mrow>{number}{between}{unit}</mrow>")
    }

    /// A number in braces; `1.6e-19` has a power of ten.
    fn numeral(&mut self) -> String {
        let text = self.raw().trim();
        match text.split_once(['e', 'E']) {
            Some((number, power)) => format!(
                "{}<mo>×</mo><msup><mn>10</mn><mrow>{}</mrow></msup>",
                self.within(number),
                self.within(power)
            ),
            None => self.within(text),
        }
    }

    /// Upright mathematics that stands in an argument.
    fn within(&self, source: &str) -> String {
        if self.depth >= DEEPEST {
            return String::new();
        }
        let mut inner = Setter {
            depth: self.depth + 1,
            face: Face::Upright,
            ..Setter::of(source)
        };
        inner.line(Ends::Whole, false).markup
    }
}

/// A unit that is spelt with macros, `\kilo\metre\per\second\squared`, in letters; `None` where others are among them.
fn spelt(text: &str) -> Option<String> {
    let mut letters = String::new();
    // Whether what comes next is divided by, and its power.
    let (mut below, mut power) = (false, 1);
    let mut macros = text
        .split('\\')
        .map(str::trim)
        .filter(|name| !name.is_empty());
    let mut next = macros.next();
    while let Some(name) = next {
        next = macros.next();
        match name {
            "per" => below = true,
            "square" => power = 2,
            "cubic" => power = 3,
            _ if unit::prefix(name).is_some() => letters += unit::prefix(name)?,
            _ => {
                letters += unit::symbol(name)?;
                let raised = match next {
                    Some("squared") => 2,
                    Some("cubed") => 3,
                    Some(other) => match other.strip_prefix("tothe{") {
                        Some(inside) => inside.strip_suffix('}')?.trim().parse().ok()?,
                        None => 0,
                    },
                    None => 0,
                };
                if raised != 0 {
                    (power, next) = (raised, macros.next());
                }
                letters += &match (std::mem::take(&mut below), std::mem::replace(&mut power, 1)) {
                    (true, power) => format!("^{{-{power}}}"),
                    (false, 1) => String::new(),
                    (false, power) => format!("^{{{power}}}"),
                };
                letters += "\\,";
            }
        }
    }
    (!letters.is_empty()).then_some(letters)
}
