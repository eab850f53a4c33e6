//! Values that the text before a step tells in words that were not taken for a supposition: "Our firm has $a = 100$ and $c = 40$. By (1) the
//! price is therefore".
//!
//! What comes to a number is not refuted as if they were not there: either with them, or not at all.

use crate::algebra::{Expr, Formula, Symbol};
use crate::derivation::{Assumed, Goal, formulas};
use crate::document::Item;
use crate::notation::read_formulas;
use crate::search::Decision;
use crate::sorted::Set;

use super::super::Outcome;
use super::super::judge::{Found, Judge, step};

impl Judge<'_> {
    /// Refutes what comes to a number with the values that the text since the last display tells, or leaves it open.
    pub(in crate::audit) fn heed_values_told(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        found: &mut Found,
    ) {
        let comes_to_number = match goal.formula.as_equation() {
            Some((_, right)) => is_number(right),
            None => false,
        };
        if !found.judged.outcome.is_refuted() || !comes_to_number {
            return;
        }
        let values = self.values_told(assumed);
        if values.is_empty() {
            return;
        }
        let names = values
            .iter()
            .filter_map(|own| Some(own.formula.as_equation()?.0));
        let told: Vec<String> = names
            .filter_map(|own| match own {
                Expr::Symbol(symbol) => Some(format!("`{symbol}`")),
                _ => None,
            })
            .collect();
        let told = told.join(", ");
        let all: Vec<Assumed> = assumed.iter().cloned().chain(values).collect();
        match self.decide_from(&all, &goal.formula) {
            // There is a point at which all of them are so.
            Some(Decision::Refuted(refuted)) => {
                found.judged.outcome = Outcome::Refuted(refuted.into());
                found.judged.assumed = all;
            }
            Some(Decision::Proven { .. }) if !self.is_contradictory(&all, goal) => {
                found.leave_open(format!(
                    "it follows with the numbers that the text names for {told}, and does not plainly suppose: write “Let” before them"
                ));
            }
            _ => found.leave_open(format!(
                "it may follow with the numbers that the text names for {told}"
            )),
        }
    }

    /// The values that the text since the last display gives symbols of the premises that have none.
    fn values_told(&self, assumed: &[Assumed]) -> Vec<Assumed> {
        let own = &self.derivation.equations[self.at];
        let document = &self.derivation.pages[own.page].document;
        let spoken: Set<Symbol> = assumed.iter().flat_map(|a| a.formula.names()).collect();
        let has_value = |symbol: &Symbol| {
            let mut all = assumed.iter().filter_map(|a| a.formula.as_equation());
            all.any(|(left, right)| {
                matches!(left, Expr::Symbol(s) if s == symbol) && is_number(right)
            })
        };
        let here = (document.items).partition_point(|item| item.span().start < own.span.start);
        let before = document.items[..here].iter().rev();
        let since =
            before.take_while(|item| !matches!(item, Item::Display { .. } | Item::Heading { .. }));
        let texts = since.filter_map(|item| match item {
            Item::Prose(prose) => Some(prose),
            _ => None,
        });
        let bodies = texts.flat_map(|prose| prose.math.iter().map(|math| math.body));
        let read = bodies.filter_map(|body| read_formulas(&document.source, body).ok());
        let said: Vec<Formula> = read.flatten().flat_map(|s| formulas(&s)).collect();
        let is_new = |formula: &&Formula| match formula.as_equation() {
            Some((Expr::Symbol(symbol), right)) => {
                is_number(right) && spoken.contains(symbol) && !has_value(symbol)
            }
            _ => false,
        };
        said.iter().filter(is_new).map(step).collect()
    }
}

fn is_number(term: &Expr) -> bool {
    term.is_arithmetic() && term.free_symbols().iter().all(Symbol::is_unit)
}
