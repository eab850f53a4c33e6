//! Figures with units in lines without: `Q = 2.0 \cdot 4200` after "For $m = 2.0\,\mathrm{kg}$ and $c = 4200\,\mathrm{J/(kg\,K)}$".
//!
//! Who reckons in units of the SI may leave them out. What follows so follows; of what does not nothing is said, for other units may be
//! meant.

use crate::algebra::{Expr, Formula};
use crate::derivation::{Assumed, Goal, Source};
use crate::document::Span;
use crate::notation::{are_of_one_system, has_units, in_si, read_expr};
use crate::search::{Decision, Effort};

use super::super::judge::{Found, Judge};

/// Why nothing is said of what numbers with and without units speak against.
pub(in crate::audit) const OTHER_UNITS: &str =
    "it may be meant in the units that stand beside the figures before";

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

    /// Leaves open what was refuted with figures in units of the SI, and is not with the numbers that are written beside others:
    /// "$K = 500$ t" and `N = 250`.
    pub(in crate::audit) fn heed_other_units(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        found: &mut Found,
    ) {
        if !found.judged.outcome.is_refuted() {
            return;
        }
        let written = |own: &Assumed| self.in_its_own_unit(own).unwrap_or_else(|| own.clone());
        let as_written: Vec<Assumed> = assumed.iter().map(written).collect();
        if as_written == assumed || !self.is_in_one_system(assumed) {
            return;
        }
        let decision = self.decide_from(&as_written, &goal.formula);
        if !matches!(decision, Some(Decision::Refuted(_))) {
            found.leave_open(OTHER_UNITS);
        }
    }

    /// Whether the units of figures in the text are of one system.
    fn is_in_one_system(&self, assumed: &[Assumed]) -> bool {
        let here = self.derivation.equations[self.at].page;
        let figure = |own: &Assumed| match own.source {
            Source::Local(page, local) if page == here => Some(self.derivation.local(page, local)),
            _ => None,
        };
        let figures = assumed.iter().filter_map(figure);
        let ends: Vec<usize> = figures.map(|own| own.span.end).collect();
        are_of_one_system(&self.derivation.pages[here].document.source, &ends)
    }

    /// What the text says that a symbol is, in units that leave the number as it is written.
    fn without_units(&self, figure: &Assumed) -> Option<Assumed> {
        let (_, value) = figure.formula.as_equation()?;
        let bare = in_si(value);
        self.as_written(figure, |written| is_same(&bare, written))
    }

    /// The same with the number that is written beside a unit that is none of the SI.
    fn in_its_own_unit(&self, figure: &Assumed) -> Option<Assumed> {
        let (_, value) = figure.formula.as_equation()?;
        let is_number = value.free_symbols().is_empty();
        is_number.then(|| self.as_written(figure, |written| !is_same(value, written)))?
    }

    /// What the text says that a symbol is with the number that is written, if that is as asked.
    fn as_written(&self, figure: &Assumed, is_meant: impl Fn(&Expr) -> bool) -> Option<Assumed> {
        let Source::Local(page, local) = figure.source else {
            return None;
        };
        let (Expr::Symbol(_), value) = figure.formula.as_equation()? else {
            return None;
        };
        let span = self.derivation.local(page, local).span;
        let source = &self.derivation.pages[page].document.source;
        let text = source.get(span.range())?;
        let written = number_written(text)?;
        is_meant(&written).then(|| Assumed {
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

/// The number that stands after the sign of equality in `h = 0.10`, without a power of ten beside it.
pub(in crate::audit) fn number_written(text: &str) -> Option<Expr> {
    let number = text.split_once('=')?.1.trim_start();
    let end = number.find(|c: char| !(c.is_ascii_digit() || c == '.'));
    let number = number.get(..end.unwrap_or(number.len()))?;
    let power = text.contains("10^") || text.contains("\\times") || text.contains("\\cdot");
    let read = || read_expr(number, Span::new(0, number.len())).ok();
    (!power).then(read)?
}
