//! Figures with units in lines without: `Q = 2.0 \cdot 4200` after "For $m = 2.0\,\mathrm{kg}$ and $c = 4200\,\mathrm{J/(kg\,K)}$".
//!
//! Who reckons in units of the SI may leave them out. What follows so follows; of what does not nothing is said, for other units may be
//! meant.

use crate::algebra::{Expr, Formula};
use crate::derivation::{Assumed, Goal, Source};
use crate::document::Span;
use crate::notation::{has_units, read_expr};
use crate::search::Effort;

use super::super::judge::{Found, Judge};

impl Judge<'_> {
    /// Whether a step without units follows from figures whose units are left out.
    pub(in crate::audit) fn follows_without_units(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        found: &mut Found,
    ) -> bool {
        let has_units = |formula: &Formula| formula.terms().into_iter().any(has_units);
        if has_units(&goal.formula) || !assumed.iter().any(|own| has_units(&own.formula)) {
            return false;
        }
        let bare = |own: &Assumed| match has_units(&own.formula) {
            true => self.without_units(own),
            false => Some(own.clone()),
        };
        let all: Option<Vec<Assumed>> = assumed.iter().map(bare).collect();
        all.is_some_and(|all| self.holds_under(goal, all, &[], Effort::Light, found))
    }

    /// What the text says that a symbol is, in units that leave the number as it is written.
    fn without_units(&self, figure: &Assumed) -> Option<Assumed> {
        let Source::Local(page, local) = figure.source else {
            return None;
        };
        let (Expr::Symbol(_), value) = figure.formula.as_equation()? else {
            return None;
        };
        let one = Expr::integer(1);
        let units = value.free_symbols().into_iter();
        let bare = units.fold(value.clone(), |value, unit| value.substitute(&unit, &one));
        let span = self.derivation.local(page, local).span;
        let source = &self.derivation.pages[page].document.source;
        let text = source.get(span.range())?;
        let number = text.split_once('=')?.1;
        let end = number
            .trim_start()
            .find(|c: char| !(c.is_ascii_digit() || c == '.'))?;
        let number = number.trim_start().get(..end)?;
        let written = read_expr(number, Span::new(0, number.len())).ok()?;
        // A power of ten may stand beside it.
        let power = text.contains("10^") || text.contains("\\times") || text.contains("\\cdot");
        (!power && is_same(&bare, &written)).then(|| Assumed {
            formula: figure
                .formula
                .map_terms(|term| match term == value {
                    true => written.clone(),
                    false => term.clone(),
                })
                .into(),
            ..figure.clone()
        })
    }
}

/// Whether two terms are the same number.
fn is_same(one: &Expr, other: &Expr) -> bool {
    let figures = crate::interval::Figures::default();
    match (figures.value(one), figures.value(other)) {
        (Ok(one), Ok(other)) => {
            one.low() == one.high() && one.low() == other.low() && other.low() == other.high()
        }
        _ => false,
    }
}
