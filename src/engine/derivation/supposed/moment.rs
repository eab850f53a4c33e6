//! What is so at one moment, or at one point of a curve: "At the top of its flight $$v = 0$$". All that is said of one moment is left together.

use std::ops::{Range, RangeFrom};

use crate::algebra::{Expr, Formula, Symbol};
use crate::document::{Extent, Span};
use crate::notation::Statement;
use crate::sorted::Set;

use super::super::equation::formulas;
use super::super::page::Page;
use super::super::rows::{self, Part};
use super::Local;

/// That something is so at one moment, or at one point of a curve: "At the top of its flight $$v = 0$$".
#[derive(Clone, Debug)]
pub struct Moment {
    /// The display with which its passage begins, by position on the page: all that is said of one moment is left together.
    pub(super) passage: usize,
    /// The display that says it, by position on the page; none for "At $t = 0$" in the text before.
    pub display: Option<usize>,
    /// What is said to have a value: where the text derives something of it again, that is said of other moments.
    pub(super) subject: Expr,
}

impl Page {
    /// Begins with what is said of one moment: other moments are left, and the cases whose sentence goes on with the display are of
    /// this one, "At $t = 0$ $$v = v_0$$". What is said of the same moment as the display before `goes_on` with its passage, which is
    /// returned.
    pub(in crate::derivation) fn begin_moment(
        &mut self,
        display: usize,
        goes_on: bool,
        cases: &[usize],
        active: &mut Vec<usize>,
    ) -> usize {
        let of = |locals: &[Local], at: usize| locals[at].moment.as_ref().map(|own| own.passage);
        let before = active.iter().rev().find_map(|&at| of(&self.locals, at));
        let passage = before.filter(|_| goes_on).unwrap_or(display);
        for &at in cases {
            let mut said = self.locals[at].formulas.iter();
            let subject = said.find_map(|formula| formula.as_equation());
            self.locals[at].moment = subject.map(|(subject, _)| Moment {
                passage,
                display: None,
                subject: subject.clone(),
            });
        }
        active.retain(|&at| of(&self.locals, at).is_none_or(|own| own == passage));
        passage
    }

    /// What was just supposed is so at the moment whose passage begins there.
    pub(in crate::derivation) fn date(&mut self, new: RangeFrom<usize>, passage: usize) {
        for local in &mut self.locals[new] {
            let mut said = local.formulas.iter();
            let subject = said.find_map(|formula| formula.as_equation());
            local.moment = subject.map(|(subject, _)| Moment {
                passage,
                display: None,
                subject: subject.clone(),
            });
            local.of_case = true;
        }
    }

    /// Leaves what has another value at the moment that was named just now, "Initially $x = 0$, at the end $x = 1$": no display was of that.
    pub(in crate::derivation) fn leave_other_values(
        &mut self,
        new: RangeFrom<usize>,
        active: &mut Vec<usize>,
    ) {
        let subject = |local: &Local| local.moment.as_ref().map(|own| own.subject.clone());
        let named: Vec<Expr> = self.locals[new.clone()]
            .iter()
            .filter_map(subject)
            .collect();
        active.retain(|&at| {
            let local = &mut self.locals[at];
            let is_other = at < new.start && subject(local).is_some_and(|own| named.contains(&own));
            if is_other {
                local.moment = None;
            }
            !is_other
        });
    }

    /// What the text tells for good, it tells of the moment that it speaks of: "Initially $$h = 0$$ and the speed is $v = u$".
    pub(in crate::derivation) fn date_with(&mut self, new: RangeFrom<usize>, active: &[usize]) {
        let moments = active.iter().rev();
        let moment = moments
            .filter_map(|&at| self.locals[at].moment.as_ref())
            .next();
        if let Some(passage) = moment.map(|own| own.passage)
            && self.locals[new.clone()]
                .iter()
                .all(|local| local.set.is_empty())
        {
            self.date(new, passage);
        }
    }

    /// Forgets what was told of moments that are left.
    pub(in crate::derivation) fn forget_moments(&self, active: &[usize], told: &mut Vec<usize>) {
        let passage = |at: &usize| self.locals[*at].moment.as_ref().map(|own| own.passage);
        told.retain(|at| {
            let own = passage(at);
            own.is_none() || active.iter().any(|other| passage(other) == own)
        });
    }

    /// Takes up what a display says of one moment.
    pub(in crate::derivation) fn suppose_at_moment(
        &mut self,
        said: Vec<Formula>,
        (display, span): (usize, Span),
        passage: usize,
        active: &mut Vec<usize>,
    ) -> Range<usize> {
        let start = self.locals.len();
        for formula in said {
            let subject = formula.as_equation().map(|(subject, _)| subject.clone());
            self.locals.push(Local {
                moment: subject.map(|subject| Moment {
                    passage,
                    display: Some(display),
                    subject,
                }),
                of_case: true,
                ..Local::said([formula], span)
            });
        }
        let own = start..self.locals.len();
        active.extend(own.clone());
        own
    }

    /// Leaves the moments of which something is derived again that had a value there, or whose value is said afresh, unless it is that
    /// value: "Hence $v = u - g t = 0$". A law may speak of it: "Energy is conserved: $$E = m v^2/2 + m g h$$".
    pub(in crate::derivation) fn leave_moments(
        &self,
        display: &[Part],
        is_derived: bool,
        active: &mut Vec<usize>,
    ) {
        if active.iter().all(|&at| self.locals[at].moment.is_none()) {
            return;
        }
        let said: Vec<Formula> = rows::said(display).collect();
        let left: Set<usize> = active
            .iter()
            .filter_map(|&at| {
                let own = self.locals[at].moment.as_ref()?;
                let spoken_of = |formula: &Formula| {
                    let mut terms = formula.terms().into_iter();
                    terms.any(|term| speaks_of(term, &own.subject))
                };
                let value = self.locals[at].formulas.first()?.as_equation()?.1;
                let is_number = matches!(value, Expr::Number(_));
                let repeats = |formula: &Formula| match formula.as_equation() {
                    Some((left, right)) => is_number && (left == value || right == value),
                    None => false,
                };
                let says_afresh = |formula: &Formula| {
                    let sides = formula.as_equation();
                    sides.is_some_and(|(left, _)| *left == own.subject)
                };
                let speaks = match is_derived {
                    true => said.iter().any(spoken_of),
                    false => said.iter().any(says_afresh),
                };
                let leaves = speaks && !said.iter().any(repeats);
                leaves.then_some(own.passage)
            })
            .collect();
        active.retain(|&at| {
            let moment = self.locals[at].moment.as_ref();
            moment.is_none_or(|own| !left.contains(&own.passage))
        });
    }

    /// Leaves what else was said of a moment that is left: "At $t = 0$ … At $t = T$".
    pub(in crate::derivation) fn leave_passages(&self, active: &mut Vec<usize>) {
        let passage = |at: usize| self.locals[at].moment.as_ref().map(|own| own.passage);
        let left: Set<usize> = (0..self.locals.len())
            .filter(|&at| !self.locals[at].is_told && !active.contains(&at))
            .filter_map(passage)
            .collect();
        active.retain(|&at| passage(at).is_none_or(|own| !left.contains(&own)));
    }
}

/// What a statement says of one moment: a value of what was spoken of before, or that a term has a number for its value; of a chain,
/// what its ends say. What has a name for that moment, `v_1`, has it for good.
pub(in crate::derivation) fn said_of_moment(
    statement: &Statement,
    extent: Extent,
    is_known: impl Fn(&Symbol) -> bool,
) -> Option<Formula> {
    if !statement.under.is_empty() || statement.clauses.len() != 1 {
        return None;
    }
    let said = formulas(statement);
    let sides: Option<Vec<_>> = said.iter().map(Formula::as_equation).collect();
    let sides = sides?;
    let ((subject, _), (_, value)) = (sides.first()?, sides.last()?);
    let named = value.free_symbols();
    let is_number = named.iter().all(Symbol::is_unit);
    let is_new = || named.iter().any(|symbol| !is_known(symbol));
    let has_value = match subject {
        Expr::Symbol(own) if !is_known(own) => **value == Expr::integer(0),
        Expr::Symbol(_) => is_number || sides.len() == 1 && is_put(value, extent) || is_new(),
        _ => is_number,
    };
    let is_state = subject.free_symbols().iter().any(names_a_state);
    let is_quantity = !subject.free_symbols().is_empty();
    (has_value && is_quantity && !is_state)
        .then(|| Formula::equal((*subject).clone(), (*value).clone()))
}

/// Whether a term speaks of what something is, and not only of how it changes: `I`, and not `dI/dt`.
fn speaks_of(term: &Expr, subject: &Expr) -> bool {
    let changes =
        matches!(term, Expr::Derivative { body, .. } if matches!(**body, Expr::Symbol(_)));
    term == subject || !changes && term.children().any(|child| speaks_of(child, subject))
}

/// Whether a mere name, or at a moment a part of it, is put as a value and not derived: "At the maximum $R = r$" is derived.
pub fn is_put(value: &Expr, extent: Extent) -> bool {
    let is_number = |term: &Expr| matches!(term, Expr::Number(_));
    let is_name = |term: &Expr| matches!(term, Expr::Symbol(_));
    let is_part = match value {
        Expr::Quotient(whole, parts) => is_name(whole) && is_number(parts),
        Expr::Product(factors) => match &factors[..] {
            [times, whole] => is_number(times) && is_name(whole),
            _ => false,
        },
        _ => false,
    };
    match extent {
        Extent::Moment => is_name(value) || is_part,
        Extent::Circumstances => is_name(value),
        _ => false,
    }
}

/// Whether a symbol is a name for a value in one state: `v_1`, `v'`, `v_{\text{top}}`; the component `v_x` is none.
fn names_a_state(symbol: &Symbol) -> bool {
    let name = symbol.name();
    let component = |below: &str| {
        matches!(
            below,
            "x" | "y" | "z" | "r" | "\\theta" | "\\phi" | "\\varphi" | "\\parallel" | "\\perp"
        )
    };
    let below = name.rsplit_once('_').map(|(_, below)| below);
    name.contains('\'') || below.is_some_and(|below| !component(below))
}
