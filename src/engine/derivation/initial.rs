//! Initial and boundary conditions of the prose, "With $w = w_0$ at $x = 0$ we get": what a display follows from that says what
//! constants are.

use super::equation::{Equation, formulas};
use super::page::Page;
use super::rows::{self, Part};
use crate::algebra::{Formula, Symbol};
use crate::document::{Span, SuppositionKind};
use crate::notation::read_formulas;
use crate::sorted::Set;

impl Page {
    /// Supposes conditions, and that it is where they are met, for a display that speaks of nothing which varies: neither of what
    /// has these values nor of the place. Of others they say nothing, for these are so elsewhere, too; but what they name is known.
    ///
    /// What is not understood is returned: what follows from conditions that are met at two places, for that is none, and what a law that
    /// speaks of no slopes comes to everywhere by what it is there. A solution of a law of change is checked against the condition.
    pub(super) fn suppose_where_met(
        &mut self,
        conditions: &[(Span, Span)],
        (before, display): (&[Equation], &[Part]),
        active: &mut Vec<usize>,
    ) -> Option<Span> {
        let &(_, first) = conditions.first()?;
        let written = |place: Span| self.document.source.get(place.range());
        let mut places = conditions.iter().map(|own| own.1);
        let other = places.find(|&own| written(own) != written(first));
        let names: Set<Symbol> = rows::said(display).flat_map(|own| own.names()).collect();
        let (start, mut unused) = (self.locals.len(), Vec::new());
        let is_law_of_change = before.last().is_some_and(|law| {
            let mut said = law.statements().iter().flat_map(formulas);
            said.any(|formula| formula.speaks_of_slopes())
        });
        let mut not_understood = other.filter(|_| !is_law_of_change);
        for &(condition, place) in conditions {
            let is_free = |body| {
                let own = self.left_symbols(body);
                own.is_some_and(|own| own.is_disjoint(&names))
            };
            let is_met = other.is_none() && is_free(condition) && is_free(place);
            if !is_met && !is_law_of_change {
                not_understood = Some(condition);
            }
            for body in [condition, place] {
                // Where two are met at one place, that is supposed once.
                if !self.locals[start..].iter().any(|own| own.span == body) {
                    let active = if is_met { &mut *active } else { &mut unused };
                    self.suppose(body, SuppositionKind::Assume, 0, active, false);
                }
            }
        }
        for local in &mut self.locals[start..] {
            local.of_display = true;
        }
        not_understood
    }

    /// The symbols on the left of what inline mathematics says; `None` where it cannot be read.
    fn left_symbols(&self, body: Span) -> Option<Set<Symbol>> {
        let said = read_formulas(&self.document.source, body).ok()?;
        let said: Vec<Formula> = said.iter().flat_map(formulas).collect();
        let left = said.iter().map(|own| Some(own.as_equation()?.0));
        let left: Vec<_> = left.collect::<Option<_>>()?;
        Some(Formula::names_in(left.into_iter()))
    }
}
