//! Remarks beside a statement: `\qquad n = 1, 2, 3, \dots`, `n \in \mathbb{N}`, `(y > 0)`, `(\text{for all } x > 1)`.

use super::{Clause, Kind, Parser};
use crate::algebra::{Relation, Symbol, split_subscript};
use crate::notation::{Run, Statement, commands};

impl Parser<'_> {
    /// Takes a remark about the statement before it; says whether there was one.
    pub(super) fn aside(&mut self, about: &mut Statement) -> bool {
        let start = self.at;
        let open = self.accept(Kind::Char('('));
        // Of what is no index `x = 1, 2` says which values it may have.
        let is_index = |run: &Run| run.to.is_none() || has_index(about, &run.symbol);
        if let Some(run) = self.run()
            && is_index(&run)
            && self.ends_aside(open)
        {
            about.runs.push(run);
            return true;
        }
        self.at = start;
        open && self.bracketed_condition(about)
    }

    /// `(y > 0)`: a condition of the statement, which is a single clause.
    fn bracketed_condition(&mut self, about: &mut Statement) -> bool {
        let start = self.at;
        let (before, choices) = (self.before.len(), self.choices.len());
        let bound = self.bound.len();
        self.advance();
        if self.quantifies() {
            let mut under = Vec::new();
            let read = self.inside(false, |own| own.quantifier(&mut under)).is_ok();
            if read && about.clauses.len() == 1 && self.ends_aside(true) {
                about.under.extend(under);
                about.runs.append(&mut self.runs);
                about
                    .quantified
                    .extend(std::mem::take(&mut self.quantified));
                return true;
            }
            self.runs.clear();
            self.quantified.clear();
            self.at = start + 1;
        }
        let names = self.shared_names();
        let clause = self.inside(false, Self::clause).ok();
        let shared = clause.as_ref().map(|clause| self.share(&names, clause));
        if let Some(Ok(shared)) = shared
            && let Some(Clause::Chain { sides, links }) = clause
            && about.clauses.len() == 1
            && links.iter().all(|link| !link.questioned)
            && self.cases.is_empty()
            && self.ends_aside(true)
        {
            about.under.extend(shared);
            about.under.push(Clause::Chain { sides, links });
            return true;
        }
        self.at = start;
        self.cases.clear();
        self.pending = None;
        self.before.truncate(before);
        self.choices.truncate(choices);
        self.bound.truncate(bound);
        false
    }

    /// Takes the `)` where one is open; whether nothing more is said.
    pub(super) fn ends_aside(&mut self, open: bool) -> bool {
        let closed = !open || self.accept(Kind::Char(')'));
        let end = matches!(
            self.peek(),
            Kind::End
                | Kind::Wide
                | Kind::Row
                | Kind::Finish(_)
                | Kind::BoxClose
                | Kind::Char(',' | ';' | '.')
        );
        closed && end
    }

    /// `n = 1, 2, \dots` or `n \in \mathbb{N}`
    pub(super) fn run(&mut self) -> Option<Run> {
        if !self.is_letter(self.at) {
            return None;
        }
        let name = self.single_letter().ok()?;
        let symbol = Symbol::new(name.canonical());
        let (from, to) = match self.peek() {
            Kind::Command("in") => {
                self.advance();
                (self.whole_numbers()?, None)
            }
            Kind::Relation(Relation::Equal, false) => {
                self.advance();
                let start = self.at;
                match self.counted_both_ways() {
                    true => (None, None),
                    false => {
                        self.at = start;
                        let (from, to) = self.counted_out()?;
                        (Some(from), to)
                    }
                }
            }
            _ => return None,
        };
        Some(Run { symbol, from, to })
    }

    /// `\mathbb{N}`, `\mathbb{N}_0`, `\mathbb{Z}`: the first of them, if there is one.
    pub(super) fn whole_numbers(&mut self) -> Option<Option<i64>> {
        if !self.accept(Kind::Command("mathbb")) {
            return None;
        }
        let braced = self.accept(Kind::Open);
        let Kind::Letter(set) = self.peek() else {
            return None;
        };
        self.advance();
        if braced && !self.accept(Kind::Close) {
            return None;
        }
        match (set, self.peek(), self.kind(self.at + 1)) {
            ('Z', ..) => Some(None),
            ('N', Kind::Char('_'), Kind::Number("0")) => {
                self.at += 2;
                Some(Some(0))
            }
            ('N', Kind::Char('_'), _) => None,
            ('N', ..) => Some(Some(1)),
            _ => None,
        }
    }

    /// `0, \pm 1, \pm 2, \dots`: all whole numbers, or all but 0.
    fn counted_both_ways(&mut self) -> bool {
        if self.peek() == Kind::Number("0") {
            self.advance();
            if !self.accept(Kind::Char(',')) {
                return false;
            }
        }
        let mut count = 0;
        while self.accept(Kind::Command("pm")) {
            count += 1;
            let Kind::Number(text) = self.peek() else {
                return false;
            };
            if text.parse() != Ok(count) {
                return false;
            }
            self.advance();
            if !self.accept(Kind::Char(',')) {
                return count > 1;
            }
        }
        let Kind::Command(name) = self.peek() else {
            return false;
        };
        let is_endless = count > 0 && commands::is_dots(name);
        if is_endless {
            self.advance();
        }
        is_endless
    }

    /// `1, 2, 3, \dots`: the first of numbers that follow one another, and the last, where they end: `1, 2`.
    fn counted_out(&mut self) -> Option<(i64, Option<i64>)> {
        let mut numbers: Vec<i64> = Vec::new();
        let mut last = None;
        loop {
            match self.peek() {
                Kind::Number(text) => numbers.push(text.parse().ok()?),
                Kind::Command(name) if commands::is_dots(name) && numbers.len() > 1 => {
                    self.advance();
                    break;
                }
                _ => return None,
            }
            self.advance();
            if !self.accept(Kind::Char(',')) {
                last = numbers.last().copied().filter(|_| numbers.len() > 1);
                last?;
                break;
            }
        }
        let first = *numbers.first()?;
        let rising = (first..).zip(&numbers).all(|(own, number)| own == *number);
        rising.then_some((first, last))
    }
}

/// Whether names in a statement have an index.
fn has_index(statement: &Statement, index: &Symbol) -> bool {
    let chains = statement.clauses.iter().filter_map(|clause| match clause {
        Clause::Chain { sides, .. } => Some(sides),
        _ => None,
    });
    let mut terms = chains.flatten().map(|side| &side.expr);
    terms.any(|term| {
        let names = term.free_symbols();
        let mut below = names.iter().filter_map(|own| split_subscript(own.name()));
        below.any(|(_, below)| below == index.name())
    })
}
