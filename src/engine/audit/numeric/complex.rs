//! Complex numbers with figures put in: `-a + j \sqrt{b} = -0.40 + 0.30j`, weighed a part at a time.

use std::collections::BTreeSet;

use crate::algebra::{Formula, Relation, Symbol};
use crate::derivation::{Goal, is_imaginary_unit, parts_of};
use crate::interval::{Figures, Interval};

use super::{Known, Weighed, decimals, weigh};

/// The imaginary unit in a formula, where what `complex` are may be complex and nothing but it is.
fn unit_in(formula: &Formula, complex: &BTreeSet<Symbol>) -> Option<Symbol> {
    let names = formula.names();
    let mut units = names.into_iter().filter(|own| complex.contains(own));
    let unit = units.next()?;
    (is_imaginary_unit(&unit) && units.next().is_none()).then_some(unit)
}

/// Whether a goal ends in a complex number, `-0.40 + 0.30j`, with nothing on its left side that is not known to be one.
pub(super) fn ends_in_one(goal: &Goal, complex: &BTreeSet<Symbol>) -> bool {
    let Some((_, right)) = goal.formula.as_equation() else {
        return false;
    };
    let is_figure = |own: &Symbol| own.is_unit() || is_imaginary_unit(own);
    goal.suppositions.is_empty()
        && !goal.questioned
        && unit_in(&goal.formula, complex).is_some_and(|unit| right.mentions(&unit))
        && right.free_symbols().iter().all(is_figure)
}

impl Known<'_> {
    /// Weighs an equation between complex numbers; nothing of other goals.
    pub(super) fn weigh_complex(&mut self, goal: &Goal) -> Option<Weighed> {
        let page = &self.derivation.pages[self.pages[0]];
        let unit = unit_in(&goal.formula, &page.complex)?;
        let Formula::Relation {
            left,
            relation: Relation::Equal | Relation::Approximately,
            right,
        } = &goal.formula
        else {
            return Some(Weighed::NoComparison);
        };
        let written = page.document.source.get(goal.sides.1.range())?;
        self.unit = Some(unit.clone());
        let sides = self
            .in_data(left, &mut Vec::new())
            .and_then(|left| Ok((left, self.in_data(right, &mut Vec::new())?)));
        self.unit = None;
        let (left, right) = match sides {
            Ok(sides) => sides,
            Err(error) => return Some(Weighed::NoValue(error)),
        };
        let mut figures: Vec<(Symbol, Interval)> = self.intervals().collect();
        let right = decimals::loosened(&right, &decimals::decimals(written, 1), &mut figures)?;
        let (one, other) = (parts_of(&left, &unit)?, parts_of(&right, &unit)?);
        let figures = Figures::from_iter(figures);
        let mut outcomes = [(one.0, other.0), (one.1, other.1)].map(|(one, other)| {
            match figures.compared(&one, &other) {
                Ok(found) => weigh(Relation::Equal, &found.difference, None, None),
                Err(error) => Weighed::NoValue(error),
            }
        });
        outcomes.sort_by_key(|own| match own {
            Weighed::Contradicted => 0,
            Weighed::Supported => 2,
            _ => 1,
        });
        let [worst, _] = outcomes;
        Some(worst)
    }
}
