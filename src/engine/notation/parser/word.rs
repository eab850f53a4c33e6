//! Letters that spell something and that TeX sets as a product: `x = A cos \omega t`, `v = at\ or\ v = 0`, `intensity`.

use super::name::PROSE;
use super::{Doubt, DoubtKind, Kind, Parser};
use crate::document::Span;
use crate::notation::Spelt;

/// The functions that are read nowhere but after a backslash, the longer ones first.
const FUNCTIONS: [&str; 12] = [
    "arcsin", "arccos", "arctan", "sinh", "cosh", "tanh", "sqrt", "sin", "cos", "tan", "exp", "log",
];
/// So many letters may stand beside the name of a function: `mgsinx`.
const BESIDE: usize = 3;
/// Words that are no product by accident, besides those that join statements.
const WORDS: [&str; 37] = [
    "abs", "area", "arg", "avg", "cost", "cot", "csc", "det", "eff", "flux", "gain", "heat", "kin",
    "lg", "lim", "load", "loss", "mass", "max", "mean", "min", "net", "out", "path", "pot", "rate",
    "rest", "rms", "sec", "sgn", "sign", "size", "time", "tot", "unit", "wave", "work",
];
/// Words that are hardly factors where the author sets them off by plain spaces, which do not print: `a if c > 0`.
const JOINING: [&str; 3] = ["if", "iff", "or"];
/// Units that are hardly products of single letters after a number: `5\,kg`.
const UNITS: [&str; 27] = [
    "kg", "km", "cm", "mm", "nm", "Hz", "kHz", "MHz", "GHz", "Pa", "hPa", "kPa", "MPa", "GPa",
    "kJ", "MJ", "kW", "MW", "GW", "kWh", "kN", "kV", "eV", "keV", "MeV", "GeV", "mol",
];
/// So many letters with a vowel among them are a word.
const LONG: usize = 5;

impl Parser<'_> {
    /// Remembers the letters since `start` that spell something. What stands in subscripts is a name however it is spelt.
    pub(super) fn doubt_letters(&mut self, start: usize) {
        let (mut at, end) = (start, self.at);
        while at < end {
            match self.kind(at) {
                Kind::Char('_') => at = self.after_script(at + 1),
                Kind::Letter(_) => {
                    let after = self.after_letters(at);
                    self.doubt_run(at, after);
                    at = after;
                }
                _ => at += 1,
            }
        }
    }

    /// The token after the script that begins here.
    fn after_script(&self, at: usize) -> usize {
        match self.kind(at) {
            Kind::Open => self.after_group(at).unwrap_or(at + 1),
            _ => at + 1,
        }
    }

    /// The token after the letters that stand side by side from here on, without a space.
    fn after_letters(&self, from: usize) -> usize {
        let mut at = from + 1;
        let is_next = |at: usize| {
            let spans = self.tokens.get(at - 1).zip(self.tokens.get(at));
            let touch = spans.is_some_and(|(before, own)| before.span.end == own.span.start);
            touch && matches!(self.kind(at), Kind::Letter(_))
        };
        while is_next(at) {
            at += 1;
        }
        at
    }

    fn doubt_run(&mut self, from: usize, after: usize) {
        if after - from < 2 {
            return;
        }
        let letters = (from..after).filter_map(|at| match self.kind(at) {
            Kind::Letter(letter) => Some(letter),
            _ => None,
        });
        let word: String = letters.collect();
        let spelt = match function_in(&word) {
            Some(function) => Some(Spelt::Function(function)),
            None if JOINING.contains(&word.as_str()) && self.is_loose(from, after) => {
                Some(Spelt::Between)
            }
            None if PROSE.contains(&word.as_str()) && self.is_apart(from, after) => {
                Some(Spelt::Between)
            }
            None if UNITS.contains(&word.as_str()) && self.is_counted(from) => Some(Spelt::Unit),
            None if word == "mod" => Some(Spelt::Remainder),
            None => is_word(&word).then_some(Spelt::Word),
        };
        if let (Some(spelt), Some(first), Some(last)) =
            (spelt, self.tokens.get(from), self.tokens.get(after - 1))
        {
            let span: Span = first.span.to(last.span);
            let kind = DoubtKind::Letters { word, spelt };
            self.doubts.push(Doubt { span, kind });
        }
    }

    /// Whether a number stands before what begins here.
    fn is_counted(&self, from: usize) -> bool {
        let before = from.checked_sub(1).map(|before| self.kind(before));
        matches!(before, Some(Kind::Number(_)))
    }

    /// Whether spaces of any kind part what stands from `from` up to `after` from letters or numbers on both sides.
    fn is_loose(&self, from: usize, after: usize) -> bool {
        let part = |at: usize| {
            let spans = at.checked_sub(1).and_then(|before| self.tokens.get(before));
            let spans = spans.zip(self.tokens.get(at));
            spans.is_some_and(|(before, own)| before.span.end < own.span.start)
        };
        let ends = |at: usize| {
            let is_sign = |c: char| "=<>+-*/".contains(c);
            match self.kind(at) {
                Kind::Char(c) => !is_sign(c),
                Kind::Relation(..) | Kind::End | Kind::Row => false,
                _ => true,
            }
        };
        part(from) && part(after) && ends(from - 1) && ends(after)
    }

    /// Whether spaces that are printed set off what stands from `from` up to `after`: `a \ or\ b`, `\quad if c > 0`.
    fn is_apart(&self, from: usize, after: usize) -> bool {
        let spaced = |at: usize| self.tokens.get(at).is_some_and(|token| token.spaced);
        let wide = |at: Option<usize>| at.is_some_and(|at| self.kind(at) == Kind::Wide);
        let goes_on = match self.kind(after) {
            Kind::Wide | Kind::Letter(_) | Kind::Number(_) => true,
            Kind::Command(_) => self.starts_name(after),
            _ => false,
        };
        (spaced(from) || wide(from.checked_sub(1))) && (spaced(after) || goes_on)
    }
}

/// The function whose name is spelt in letters, perhaps beside others: `Acos`, `sinx`, `RTln`.
fn function_in(word: &str) -> Option<&'static str> {
    let near = |name: &&str| word.contains(name) && word.len() <= name.len() + BESIDE;
    let short =
        || (word.starts_with("ln") || word.ends_with("ln")) && word.len() <= "ln".len() + BESIDE;
    let found = FUNCTIONS.into_iter().find(near);
    found.or_else(|| short().then_some("ln"))
}

/// Whether letters are a word rather than a product.
fn is_word(word: &str) -> bool {
    let vowel = |letter: char| "aeiouAEIOU".contains(letter);
    let known = |words: &[&str]| words.contains(&word);
    word.len() >= LONG && word.contains(vowel) || known(&WORDS) || word.len() > 2 && known(PROSE)
}
