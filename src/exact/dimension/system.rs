//! Linear equations between exponents, solved one after another as they come.

use std::collections::BTreeMap;

use crate::algebra::Rational;
use crate::kernel::dimension::{Form, Unknown};
use crate::sorted::Map;

/// An equation that leaves more unknowns open than this says too little to be worth keeping.
const MOST_OPEN: usize = 48;

/// Solved equations. Each new one is reduced by those before it, so nothing is ever solved again.
#[derive(Clone, Debug, Default)]
pub(super) struct System {
    rows: Vec<Row>,
    /// Which row an unknown is solved by.
    solved: BTreeMap<Unknown, usize>,
}

/// `unknown = value`, and where that comes from.
#[derive(Clone, Debug)]
struct Row {
    unknown: Unknown,
    /// In unknowns that were open when the row was made.
    value: Form,
    /// The equation, by the caller's number.
    source: usize,
    /// The power of the unknown in the equation once reduced.
    divisor: Rational,
    /// The rows that it was reduced by, and how often.
    reduced_by: Map<usize, Rational>,
}

/// How an equation fits those before it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Fit {
    /// It follows from them, or says something new.
    Good,
    /// It does not: which equations, and how often each must be taken for all unknowns to cancel. The new one is
    /// not listed; it is taken once.
    Bad(Map<usize, Rational>),
}

impl System {
    /// How many rows there are, to be gone back to.
    pub fn mark(&self) -> usize {
        self.rows.len()
    }

    /// Forgets all rows after a mark.
    pub fn rewind(&mut self, mark: usize) {
        for row in self.rows.drain(mark..) {
            self.solved.remove(&row.unknown);
        }
    }

    /// Takes up the equation that a form is the dimension of pure numbers.
    pub fn add(&mut self, form: Form, source: usize) -> Fit {
        let (form, reduced_by) = self.reduce(form);
        // The newest unknown is solved for: those before it are rather known.
        let Some((&unknown, divisor)) = form.unknowns.last_key_value() else {
            return match form.known.is_none() {
                true => Fit::Good,
                false => Fit::Bad(self.trace(&reduced_by)),
            };
        };
        if form.unknowns.len() > MOST_OPEN {
            return Fit::Good;
        }
        let divisor = divisor.clone();
        let mut value = form.power(&-divisor.recip());
        value.unknowns.remove(&unknown);
        self.solved.insert(unknown, self.rows.len());
        self.rows.push(Row {
            unknown,
            value,
            source,
            divisor,
            reduced_by,
        });
        Fit::Good
    }

    /// A form with all that is known put in.
    pub fn value(&self, form: &Form) -> Form {
        self.reduce(form.clone()).0
    }

    /// Puts rows in until none applies. A row mentions nothing that was solved before it, so this ends.
    fn reduce(&self, mut form: Form) -> (Form, Map<usize, Rational>) {
        let mut by: Map<usize, Rational> = Map::new();
        while let Some((unknown, row)) = form
            .unknowns
            .keys()
            .find_map(|unknown| Some((*unknown, *self.solved.get(unknown)?)))
        {
            let power = form
                .unknowns
                .remove(&unknown)
                .unwrap_or_else(Rational::zero);
            form.multiply(&self.rows[row].value, &power);
            *by.entry(row).or_insert_with(Rational::zero) += power;
        }
        (form, by)
    }

    /// The equations behind a reduction: a row is a multiple of its equation, less the rows that reduced it.
    fn trace(&self, reduced_by: &Map<usize, Rational>) -> Map<usize, Rational> {
        let mut sources = Map::new();
        let mut rows: Map<usize, Rational> = reduced_by.iter().map(|(row, n)| (*row, -n)).collect();
        while let Some((at, times)) = rows.pop_last() {
            let row = &self.rows[at];
            let times = times / &row.divisor;
            if times.is_zero() {
                continue;
            }
            for (before, n) in &row.reduced_by {
                *rows.entry(*before).or_insert_with(Rational::zero) -= &times * n;
            }
            sources.insert(row.source, times);
        }
        sources
    }
}
