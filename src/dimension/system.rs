//! Linear equations between exponents, solved one after another as they come.

use std::collections::BTreeMap;

use crate::algebra::Rational;
use crate::kernel::dimension::{Form, Unknown};

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
    reduced_by: BTreeMap<usize, Rational>,
}

/// How an equation fits those before it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Fit {
    /// It follows from them, or says something new.
    Good,
    /// It does not: which equations, and how often each must be taken for all unknowns to cancel. The new one is
    /// not listed; it is taken once.
    Bad(BTreeMap<usize, Rational>),
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
    fn reduce(&self, mut form: Form) -> (Form, BTreeMap<usize, Rational>) {
        let mut by: BTreeMap<usize, Rational> = BTreeMap::new();
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
    fn trace(&self, reduced_by: &BTreeMap<usize, Rational>) -> BTreeMap<usize, Rational> {
        let mut sources = BTreeMap::new();
        let mut rows: BTreeMap<usize, Rational> =
            reduced_by.iter().map(|(row, n)| (*row, -n)).collect();
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::{Base, Dimension};

    fn form(unknowns: &[(usize, i32)], length: i32) -> Form {
        Form {
            known: Dimension::of(&[(Base::Length, length)]),
            unknowns: unknowns
                .iter()
                .map(|&(u, n)| (Unknown(u), Rational::from(n)))
                .collect(),
        }
    }

    #[test]
    fn equations_in_any_order_are_solved() {
        let mut system = System::default();
        assert_eq!(system.add(form(&[(0, 1), (1, -1)], 0), 10), Fit::Good);
        assert_eq!(system.add(form(&[(1, 1), (2, -2)], 0), 11), Fit::Good);
        assert_eq!(system.add(form(&[(2, 1)], -1), 12), Fit::Good);
        assert_eq!(system.value(&form(&[(0, 1)], 0)), form(&[], 2));
        assert_eq!(system.add(form(&[(0, 1)], -2), 13), Fit::Good);
    }

    #[test]
    fn what_disagrees_is_traced_to_its_sources_with_their_multipliers() {
        let mut system = System::default();
        let forms = [
            form(&[(0, 1), (1, -1)], 0),
            form(&[(3, 1)], 5),
            form(&[(1, 1), (2, -2)], 0),
            form(&[(2, 1)], -1),
        ];
        for (at, form) in forms.iter().enumerate() {
            assert_eq!(system.add(form.clone(), at), Fit::Good);
        }
        let last = form(&[(0, 3)], 1);
        let Fit::Bad(sources) = system.add(last.clone(), 9) else {
            panic!()
        };
        assert_eq!(sources.keys().copied().collect::<Vec<_>>(), [0, 2, 3]);
        let mut total = last;
        for (at, times) in &sources {
            total.multiply(&forms[*at], times);
        }
        assert_eq!(
            total.dimension(),
            Some(&Dimension::of(&[(Base::Length, 7)]))
        );
    }

    #[test]
    fn going_back_forgets_what_came_after() {
        let mut system = System::default();
        system.add(form(&[(0, 1)], -1), 0);
        let mark = system.mark();
        system.add(form(&[(1, 1), (0, -1)], 0), 1);
        system.rewind(mark);
        assert_eq!(system.value(&form(&[(1, 1)], 0)), form(&[(1, 1)], 0));
        assert_eq!(system.value(&form(&[(0, 1)], 0)), form(&[], 1));
    }
}
