//! Which equations before one speak of the same symbols.

use std::collections::BTreeSet;
use std::ops::Range;

use crate::algebra::{Expr, Formula, Symbol};
use crate::document::Inline;
use crate::notation::{Statement, read_expr};
use crate::sorted::Set;

use super::Derivation;
use super::equation::{formulas, says_of};

/// So many equations before are looked at for what a section before says.
const MOST_BEFORE: usize = 256;
/// So many equations that speak of a symbol are looked at for what says what it is.
const MOST_SPEAKING: usize = 64;

impl Derivation {
    /// Whether any equation of a page speaks of a symbol.
    pub fn is_spoken_of(&self, page: usize, symbol: &Symbol) -> bool {
        self.mentions[page].get(symbol).is_some()
    }

    /// Whether an equation of the same page that stands before another speaks of a symbol.
    pub fn is_spoken_of_before(&self, at: usize, symbol: &Symbol) -> bool {
        self.speaking_before(at, symbol).next().is_some()
    }

    /// The equations of the same page that stand before another and speak of a symbol.
    pub fn speaking_before(&self, at: usize, symbol: &Symbol) -> impl Iterator<Item = usize> {
        let all = self.mentions[self.equations[at].page].get(symbol);
        let all = all.into_iter().flatten().copied();
        all.take_while(move |&other| other < at)
    }

    /// The first equation that says just this.
    pub fn stating(&self, formula: &Formula) -> Option<usize> {
        let pages = 0..self.pages.len();
        let mut stating = pages.map(|page| self.stating_among(&self.equations_of(page), formula));
        stating.find_map(|stating| stating)
    }

    /// Whether a section before that of an equation says just this, not too far back: here it would be said of another case,
    /// `P = \frac{\pi^2 E I}{L^2}` of a strut with other ends.
    pub fn is_of_section_before(&self, at: usize, formula: &Formula) -> bool {
        let end = self.section_start(at);
        let start = self.equations_of(self.equations[at].page).start;
        let near = start.max(end.saturating_sub(MOST_BEFORE))..end;
        self.stating_among(&near, formula).is_some()
    }

    /// The first among some equations of a page that says just this: of those that speak of what the fewest do.
    fn stating_among(&self, among: &Range<usize>, formula: &Formula) -> Option<usize> {
        let page = self.equations.get(among.start)?.page;
        let names = formula.names().into_iter();
        let speaking =
            names.map(|own| self.mentions[page].get(&own).map_or(&[][..], Vec::as_slice));
        let speaking = speaking.min_by_key(|own| own.len())?.iter().copied();
        let says = |own: &Statement| formulas(own).contains(formula);
        let mut near = speaking.filter(|at| among.contains(at));
        near.find(|&at| self.equations[at].statements().iter().any(says))
    }

    /// Whether an equation of a page says what a symbol is, among the first that speak of it.
    pub fn is_said_what(&self, page: usize, symbol: &Symbol) -> bool {
        let speaking = self.mentions[page].get(symbol).into_iter().flatten();
        let statements = |&at: &usize| self.equations[at].statements().iter();
        let mut said = speaking
            .take(MOST_SPEAKING)
            .flat_map(statements)
            .flat_map(formulas);
        said.any(|own| says_of(&own, symbol))
    }

    /// Whether the text between a display and the one before it names a symbol, and nothing is understood that it says of it: "for a loan of
    /// size $L$", "the angle $\gamma$", or "friction $f = \mu N$" where nothing else speaks of `f`. What does is `spoken_of`.
    pub fn is_named_in_words(&self, at: usize, symbol: &Symbol, spoken_of: &Set<Symbol>) -> bool {
        let own = &self.equations[at];
        let document = &self.pages[own.page].document;
        let is_other = |side: &Expr| match side {
            Expr::Symbol(own) => own != symbol && !spoken_of.contains(own),
            _ => false,
        };
        let of_other = |formula: &Formula| {
            let sides = formula.as_equation();
            sides.is_some_and(|(left, right)| is_other(left) || is_other(right))
        };
        let locals = own.locals.iter().chain(&own.told).chain(&own.named);
        let said = locals.flat_map(|&local| &self.local(own.page, local).formulas);
        let mut said = said.filter(|said| said.names().contains(symbol)).peekable();
        if said.peek().is_some() {
            return said.all(|said| of_other(said));
        }
        self.inline_before(at).any(|math| {
            let named = read_expr(&document.source, math.body);
            matches!(named, Ok(Expr::Symbol(own)) if own == *symbol)
        })
    }

    /// The last sentence before a display, as it is written.
    pub fn leading(&self, at: usize) -> Option<&str> {
        let own = &self.equations[at];
        let source = &self.pages[own.page].document.source;
        source.get(own.said_last?.range())
    }

    /// The words of that sentence, in small letters.
    pub fn leading_words(&self, at: usize) -> Vec<String> {
        words_of(self.leading(at).unwrap_or_default()).collect()
    }

    /// The text between a display and the one before it, as it is written.
    pub fn text_before(&self, at: usize) -> &str {
        let own = &self.equations[at];
        let before = self.before_display(at);
        let from = before.map_or(0, |before| self.equations[before].span.end);
        let source = &self.pages[own.page].document.source;
        source.get(from..own.span.start).unwrap_or_default()
    }

    /// The mathematics in the text between a display and the one before it.
    pub fn inline_before(&self, at: usize) -> impl Iterator<Item = &Inline> {
        let own = &self.equations[at];
        let before = self.before_display(at);
        let from = before.map_or(0, |before| self.equations[before].span.end);
        let document = &self.pages[own.page].document;
        document.inline_between(from, own.span.start)
    }

    /// What is written on either side of mathematics in the text before an equation, as far as its sentence goes.
    pub fn sentence_around(&self, at: usize, math: &Inline) -> (&str, &str) {
        let (own, before) = (&self.equations[at], self.before_display(at));
        let from = before.map_or(0, |before| self.equations[before].span.end);
        let source = &self.pages[own.page].document.source;
        let text = |from: usize, to: usize| source.get(from..to).unwrap_or_default();
        let before = text(from, math.span.start);
        let after = text(math.span.end, own.span.start);
        // A point within a number, or a name, has no space after it.
        let ends = |text: &str, at: usize| text[at + 1..].starts_with(char::is_whitespace);
        let mut stops = before.rmatch_indices('.');
        let start = stops.find(|&(at, _)| ends(before, at));
        let mut stops = after.match_indices('.');
        let end = stops.find(|&(at, _)| ends(after, at));
        (
            &before[start.map_or(0, |(at, _)| at + 1)..],
            &after[..end.map_or(after.len(), |(at, _)| at)],
        )
    }

    /// Where the last of some words ends in the text before an equation, and 0 where there is none.
    pub fn last_word_before(&self, at: usize, words: &[&str]) -> usize {
        let text = self.text_before(at);
        let mut last = 0;
        let mut begins = 0;
        while let Some(word) = text[begins..].find(is_of_word) {
            let start = begins + word;
            let length = text[start..].find(|c| !is_of_word(c));
            begins = length.map_or(text.len(), |length| start + length);
            let word = &text[start..begins];
            if words.iter().any(|own| own.eq_ignore_ascii_case(word)) {
                last = self.equations[at].span.start - text.len() + begins;
            }
        }
        last
    }

    /// The equations before `at` that share symbols with it, where these were spoken of last: the two nearest, then those that are solved for a
    /// symbol, then the rest, each the nearest first.
    pub fn relatives(&self, at: usize, most: usize) -> Vec<usize> {
        let speaking = |wanted: &Set<Symbol>| {
            let mut fresh: BTreeSet<usize> = BTreeSet::new();
            for symbol in wanted {
                for page in self.speaking_of(symbol, at) {
                    let all = &self.mentions[page][symbol];
                    let before = &all[..all.partition_point(|&other| other < at)];
                    fresh.extend(before.iter().rev().take(most));
                }
            }
            fresh
        };
        // What defines the symbols, and what defines those of the definitions.
        let mut wanted = self.spoken_of[at].clone();
        wanted.extend(self.told_of(at));
        let mut found = speaking(&wanted);
        let symbols = found.iter().flat_map(|&other| &self.spoken_of[other]);
        found.extend(speaking(&symbols.cloned().collect()));
        // "With friction (1) is replaced by"
        let is_replaced = |other: &usize| self.replaced.get(other).is_some_and(|&by| by < at);
        found.retain(|other| !is_replaced(other));
        let mut order: Vec<usize> = found.into_iter().rev().take(most).collect();
        let solved = |at: &usize| self.equations[*at].is_solved();
        let rest = order.split_off(order.len().min(2));
        let (first, last): (Vec<usize>, Vec<usize>) = rest.into_iter().partition(solved);
        order.into_iter().chain(first).chain(last).collect()
    }

    /// The symbols by which the text tells what others are that an equation speaks of: of `\bar M = n_0 M/n` also `n`.
    fn told_of(&self, at: usize) -> Set<Symbol> {
        let own = &self.equations[at];
        if own.told.is_empty() && own.named.is_empty() {
            return Set::new();
        }
        let symbols = own.symbols();
        let locals = &self.pages[own.page].locals;
        let told = own.told.iter().chain(&own.named).map(|&at| &locals[at]);
        // What is concluded from what is told of a case is said of that alone.
        let formulas = told
            .filter(|local| !local.of_case)
            .flat_map(|local| &local.formulas);
        let mut told = Set::new();
        for formula in formulas {
            let names = formula.names();
            if !names.is_disjoint(&symbols) {
                told.extend(names);
            }
        }
        told
    }

    /// The pages to look for a symbol of equation `at`: its own and those that this cites, as far as they speak
    /// of the symbol before; if they do not, the last page that did.
    fn speaking_of(&self, symbol: &Symbol, at: usize) -> Vec<usize> {
        let own = self.equations[at].page;
        let speaks = |&page: &usize| {
            let all = self.mentions[page].get(symbol);
            all.is_some_and(|all| all.first().is_some_and(|&first| first < at))
        };
        let near: Vec<usize> = self.neighbours[own]
            .iter()
            .copied()
            .filter(speaks)
            .collect();
        if !near.is_empty() {
            return near;
        }
        let pages = self
            .pages_of
            .get(symbol)
            .map(Vec::as_slice)
            .unwrap_or_default();
        let before = pages.partition_point(|&page| page < own);
        pages[..before].last().copied().into_iter().collect()
    }
}

/// The words of a text, in small letters.
pub fn words_of(text: &str) -> impl Iterator<Item = String> + '_ {
    let words = text.split(|c| !is_of_word(c));
    let words = words.filter(|word| !word.is_empty());
    words.map(str::to_lowercase)
}

/// Whether one of some words stands among others, and one of the next right after it.
pub fn in_a_row(words: &[String], first: &[&str], next: &[&str]) -> bool {
    let are_these = |pair: &[String]| first.contains(&&*pair[0]) && next.contains(&&*pair[1]);
    words.windows(2).any(are_these)
}

/// "no-slip" denies nothing.
fn is_of_word(c: char) -> bool {
    c.is_alphabetic() || c == '-'
}
