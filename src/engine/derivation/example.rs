//! Numerical examples, "With $m = 3$ kg and $g = 9.8$ m/s² (6) yields": where their values are in effect.
//!
//! What comes to a number puts them in for as long as no others are given. What speaks of their symbols and comes to no number is said of
//! any values again, and so is what comes after it.

use std::ops::Range;

use crate::algebra::{Expr, Formula, Symbol};
use crate::sorted::Set;

use super::equation::formulas;
use super::reader::Reader;
use super::rows::{self, Part};
use super::supposed::Local;

impl Reader<'_> {
    /// What was just supposed are values of an example: of formulas, and of no moment that displays spoke of before.
    pub(super) fn begin_example(&mut self, new: Range<usize>) {
        if let Some(last) = self.equations.last() {
            let (locals, start) = (&self.page.locals, last.span.start);
            let is_over = |local: &Local| local.is_momentary() && local.span.start < start;
            self.active.retain(|&at| !is_over(&locals[at]));
        }
        for local in &mut self.page.locals[new.clone()] {
            local.is_figure = true;
        }
        self.running.extend(new);
    }

    /// Ends the examples whose symbols a display speaks of that comes to no number.
    pub(super) fn leave_examples(&mut self, display: &[Part]) {
        let locals = &self.page.locals;
        let is_left = |at: &usize| locals[*at].is_figure && !self.running.contains(at);
        let mut figures = self.active.iter().copied().filter(is_left).peekable();
        if figures.peek().is_none() {
            return;
        }
        if display.iter().any(comes_to_a_number) {
            drop(figures);
            return self.leave_other_figures(display);
        }
        let said: Set<Symbol> = rows::said(display).flat_map(|own| own.names()).collect();
        if figures.any(|at| !locals[at].names().is_disjoint(&said)) {
            self.example = locals.len();
        }
    }

    /// Leaves the values before the last display of which the words since then tell others: "and a mass $m = 5$ kg needs".
    pub(super) fn leave_old_values(&mut self, named: &[usize]) {
        let Some(last) = self.equations.last() else {
            return;
        };
        let (locals, start) = (&self.page.locals, last.span.start);
        if !self.active.iter().any(|&at| locals[at].is_figure) {
            return;
        }
        let told = named.iter().chain(&self.told).map(|&at| &locals[at]);
        let told: Vec<&Local> = told.filter(|own| own.span.start > start).collect();
        let is_old = |local: &Local| {
            let is_other = |own: &&Local| {
                !own.values().is_disjoint(&local.values()) && own.formulas != local.formulas
            };
            local.is_figure && local.span.start < start && told.iter().any(is_other)
        };
        self.active.retain(|&at| !is_old(&locals[at]));
    }

    /// Leaves what has another value from a display on: "If instead $w = 4$, then $$k = 48$$".
    fn leave_other_figures(&mut self, display: &[Part]) {
        let said: Vec<Formula> = rows::said(display).collect();
        let is_said = |symbol: &Symbol| {
            let mut left = said.iter().filter_map(|own| Some(own.as_equation()?.0));
            left.any(|own| matches!(own, Expr::Symbol(own) if own == symbol))
        };
        let (locals, running) = (&self.page.locals, &self.running);
        let is_other = |local: &Local| {
            let restated = local.formulas.iter().all(|own| said.contains(own));
            local.is_figure && !restated && local.values().iter().any(is_said)
        };
        self.active
            .retain(|at| running.contains(at) || !is_other(&locals[*at]));
    }

    /// What is supposed where a row of a display stands.
    pub(super) fn in_effect(&self, part: &Part) -> Vec<usize> {
        let locals = &self.page.locals;
        let is_over =
            |at: usize| locals[at].is_figure && at < self.example && !self.running.contains(&at);
        match self.active.iter().any(|&at| is_over(at)) && !comes_to_a_number(part) {
            true => (self.active.iter().copied())
                .filter(|&at| !is_over(at))
                .collect(),
            false => self.active.clone(),
        }
    }
}

/// Whether what a row states ends with a number.
fn comes_to_a_number(part: &Part) -> bool {
    let is_number = |term: &Expr| {
        let is_unit = |own: &Symbol| own.is_unit();
        term.is_arithmetic() && term.free_symbols().iter().all(is_unit)
    };
    let ends = |own: &Formula| match own {
        Formula::Relation { right, .. } => is_number(right),
        Formula::AllEqual { .. } => false,
    };
    let mut statements = part.statements.iter().flatten();
    statements.any(|own| formulas(own).last().is_some_and(ends))
}
