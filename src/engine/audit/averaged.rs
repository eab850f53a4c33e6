//! Means of sequences: `\sum_i (x_i - \bar x)^2 = \sum_i x_i^2 - n \bar x^2`, where a text speaks of means and nothing on the page says what
//! `\bar x` is.
//!
//! **Statement.** $\bar x = \frac1n \sum_{i=1}^n x_i$, the arithmetic mean of what the sum runs over (ISO 3534-1:2006, 1.15). It is what the bar
//! is written for, and it is told that it was taken so.

use crate::algebra::{Expr, Formula, Symbol};
use crate::derivation::{Assumed, Goal, sums_in};
use crate::notation::Through;

use super::judge::{Judge, taken};

/// What is written above the name of a sequence for its mean.
const BARS: [&str; 2] = ["\\bar", "\\overline"];

impl Judge<'_> {
    /// What the means are of which a goal speaks beside the elements of a sequence.
    pub(super) fn averaged(&self, goal: &Goal, assumed: &[Assumed]) -> Vec<Assumed> {
        let page = self.derivation.equations[self.at].page;
        let speaks_of_means = self.derivation.pages[page].speaks_of_means;
        let mut found = Vec::new();
        for sequence in goal.formula.sequences() {
            let bars = BARS.map(|bar| Symbol::new(format!("{bar}{{{sequence}}}")));
            let names = goal.formula.names();
            let Some(mean) = bars.into_iter().find(|own| names.contains(own)) else {
                continue;
            };
            let is_said = assumed.iter().any(|own| own.is_of(&mean));
            if is_said || !speaks_of_means || self.derivation.is_said_what(page, &mean) {
                continue;
            }
            let mut sums = goal.formula.terms().into_iter().flat_map(sums_in);
            if let Some(own) = sums.find(|own| own.sequences.contains(&sequence)) {
                found.push(taken(&mean_of(mean, sequence, own)));
            }
        }
        found
    }
}

fn mean_of(mean: Symbol, sequence: Symbol, through: Through) -> Formula {
    let Through {
        index, from, to, ..
    } = through;
    let count = match from == Expr::integer(1) {
        true => to.clone(),
        false => Expr::Sum(
            [
                to.clone(),
                Expr::Negate(from.clone().into()),
                Expr::integer(1),
            ]
            .into(),
        ),
    };
    let body = Expr::Element {
        sequence,
        index: index.clone(),
    };
    let sum = Expr::Series {
        index,
        from: from.into(),
        to: to.into(),
        body: body.into(),
    };
    Formula::equal(Expr::Symbol(mean), Expr::Quotient(sum.into(), count.into()))
}
