//! Upper indices, which are spelt as powers are: `T^{\mu\nu}`, `g_{\mu\nu} x^\mu x^\nu`. What can only be an index is refused; what may be a
//! power, `p V^\gamma`, `u_n = u_0 r^n`, is one.

use crate::algebra::{Expr, Symbol, split_subscript};
use crate::document::Span;
use crate::notation::{Statement, SyntaxError};
use crate::sorted::Set;

use super::doubts::{OnPage, standing_in, symbols_in};
use super::equation::formulas;

/// The letters that mostly count something, wherever they stand.
const COUNTING: [&str; 3] = ["k", "n", "N"];
/// Subscripts that are words, not letters side by side.
const WORDS: [&str; 5] = ["in", "min", "kin", "lim", "nm"];

/// What the letters of a display are, as far as it and its page tell.
pub(super) struct Letters<'p> {
    declared: &'p dyn Fn(&Symbol) -> bool,
    /// Those that stand for something on the page.
    on_page: &'p OnPage,
    /// Those that do so in the display.
    here: Set<Symbol>,
    /// Those that are a whole subscript in it: `v_i`.
    alone: Set<Symbol>,
    /// Those that are part of a subscript of several letters: `g_{\mu\nu}`.
    in_company: Set<Symbol>,
    /// Those that are below one factor of a product and above another: `v_k w^k`.
    contracted: Set<Symbol>,
}

impl<'p> Letters<'p> {
    pub(super) fn of(
        statements: &[Statement],
        declared: &'p dyn Fn(&Symbol) -> bool,
        on_page: &'p OnPage,
    ) -> Self {
        let (mut alone, mut in_company) = (Set::new(), Set::new());
        symbols_in(statements, &mut |symbol| {
            let below = below(symbol);
            match below.len() {
                1 => alone.extend(below),
                _ => in_company.extend(below),
            }
        });
        let mut contracted = Set::new();
        for term in statements.iter().flat_map(formulas) {
            let terms = term.terms().into_iter();
            terms.for_each(|term| contractions(term, &mut contracted));
        }
        Letters {
            contracted,
            declared,
            on_page,
            here: standing_in(statements.iter()),
            alone,
            in_company,
        }
    }

    pub(super) fn is_declared(&self, symbol: &Symbol) -> bool {
        (self.declared)(symbol)
    }

    /// Whether the page speaks of concentrations.
    pub(super) fn has_concentrations(&self) -> bool {
        !self.on_page.concentrations.is_empty()
    }

    /// Whether a symbol stands for a quantity in displays.
    pub(super) fn stands(&self, symbol: &Symbol) -> bool {
        self.on_page.quantities.contains(symbol)
    }

    /// Whether a symbol is declared, or stands for something on the page.
    pub(super) fn is_known(&self, symbol: &Symbol) -> bool {
        let OnPage {
            quantities,
            spoken_of,
            ..
        } = self.on_page;
        quantities.contains(symbol) || spoken_of.contains(symbol) || self.is_declared(symbol)
    }

    /// Why these letters above a name are no exponent, if they are none.
    pub(super) fn refusal(
        &self,
        name: &Symbol,
        above: &[Symbol],
        span: Span,
    ) -> Option<SyntaxError> {
        let index = above.iter().find(|letter| self.is_index(name, letter));
        let index = index.or_else(|| above.iter().find(|own| self.is_one_of(name, above, own)))?;
        Some(SyntaxError {
            span,
            message: format!("this may be an index above `{name}`, or a power"),
            help: Some(format!(
                "tensors are not read; where `{index}` is a number, declare it, `symbols {index}: real`"
            )),
        })
    }

    /// Whether a letter above a name is an index below something else in the display, and no quantity.
    fn is_index(&self, name: &Symbol, letter: &Symbol) -> bool {
        let sure =
            || !self.counts(letter) || self.contracted.contains(letter) || !below(name).is_empty();
        let below = self.in_company.contains(letter) || self.alone.contains(letter) && sure();
        let elsewhere = !is_greek(letter) && self.is_elsewhere(letter);
        below && !elsewhere && !self.here.contains(letter) && !self.is_declared(letter)
    }

    /// Whether a letter mostly counts something, so that `r^n` beside `u_n` is a power.
    fn counts(&self, letter: &Symbol) -> bool {
        COUNTING.contains(&letter.name()) || self.on_page.counting.contains(letter)
    }

    /// Whether a letter stands for a quantity on the page. That `i` or `j` runs, or is the imaginary unit, makes no exponent of it.
    fn is_elsewhere(&self, letter: &Symbol) -> bool {
        !matches!(letter.name(), "i" | "j") && self.on_page.quantities.contains(letter)
    }

    /// Whether a letter that nothing else speaks of is one of several indices of a name: `T^{\mu\nu}`, `\delta^i_j`.
    fn is_one_of(&self, name: &Symbol, above: &[Symbol], letter: &Symbol) -> bool {
        let is_known = self.counts(letter) || self.is_elsewhere(letter) || self.is_declared(letter);
        let below = below(name);
        let like = |own: &Symbol| match is_greek(letter) {
            true => is_greek(own),
            false => is_common(own) && is_common(letter),
        };
        !is_known && (above.len() > 1 || !below.is_empty() && below.iter().all(like))
    }
}

fn is_greek(letter: &Symbol) -> bool {
    letter.name().starts_with('\\')
}

/// The Latin letters that indices mostly are.
fn is_common(letter: &Symbol) -> bool {
    matches!(letter.name().as_bytes(), [b'i'..=b'n'])
}

/// The letters that a subscript consists of, perhaps with commas between them; none of a word.
fn below(name: &Symbol) -> Vec<Symbol> {
    let Some((_, text)) = split_subscript(name.name()) else {
        return Vec::new();
    };
    let mut letters = Vec::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let greek = rest.strip_prefix('\\').map(|name| {
            let end = name.find(|c: char| !c.is_ascii_alphabetic());
            1 + end.unwrap_or(name.len())
        });
        let length = greek.unwrap_or(first.len_utf8());
        let (letter, after) = rest.split_at(length);
        match first {
            ',' | ' ' => {}
            '\\' | 'a'..='z' | 'A'..='Z' => letters.push(Symbol::new(letter)),
            _ => return Vec::new(),
        }
        rest = after;
    }
    let plain = text.bytes().all(|b| b.is_ascii_alphabetic());
    let is_word = plain && text.len() > 2 && !letters.iter().all(is_common);
    match is_word || WORDS.contains(&text) {
        true => Vec::new(),
        false => letters,
    }
}

/// The letters that are below one factor of a product and above another.
fn contractions(term: &Expr, found: &mut Set<Symbol>) {
    if let Expr::Product(factors) = term {
        let mut lower = Set::new();
        for factor in factors.iter() {
            if let Expr::Symbol(name) = factor {
                lower.extend(below(name));
            }
        }
        let upper = factors.iter().filter_map(|factor| match factor {
            Expr::Power(_, exponent) => match &**exponent {
                Expr::Symbol(letter) => Some(letter),
                _ => None,
            },
            _ => None,
        });
        found.extend(upper.filter(|own| lower.contains(*own)).cloned());
    }
    term.children().for_each(|child| contractions(child, found));
}

/// The symbols that stand for quantities in a term, not those that are an exponent of a name by themselves.
pub(super) fn standing(term: &Expr, found: &mut Set<Symbol>) {
    match term {
        Expr::Power(base, exponent) => {
            standing(base, found);
            if !is_name(base) || !is_letters(exponent) {
                standing(exponent, found);
            }
        }
        Expr::Symbol(symbol) => {
            found.insert(symbol.clone());
        }
        Expr::Element { index, .. } => found.extend(counted(index)),
        term => {
            match term {
                Expr::Series { index, .. } => found.extend(counted(index)),
                term => found.extend(term.binder().cloned()),
            }
            term.children().for_each(|child| standing(child, found));
        }
    }
}

/// What a sum runs over, unless it is a Greek letter, as indices of tensors are.
fn counted(index: &Symbol) -> Option<Symbol> {
    (!is_greek(index)).then(|| index.clone())
}

/// Whether this is a name that may have indices; Euler's number has none.
fn is_name(base: &Expr) -> bool {
    match base {
        Expr::Symbol(symbol) => !matches!(symbol.name(), "e" | "\\text{e}"),
        base => matches!(base, Expr::Element { .. }),
    }
}

fn is_letters(exponent: &Expr) -> bool {
    match exponent {
        Expr::Product(factors) => factors.iter().all(|own| matches!(own, Expr::Symbol(_))),
        exponent => matches!(exponent, Expr::Symbol(_)),
    }
}
