//! What is said of more than a special case of which the text told before.

use crate::algebra::{Expr, Formula};

use super::reader::Reader;
use super::rows::{self, Part};
use super::supposed::Local;
use super::{Derivation, formulas};
use crate::document::Span;
use crate::notation::Statement;

/// Words before a relation by which it is a condition, and no law: "equal if $a = b$".
const CONDITIONAL: &[&str] = &[
    "at", "case", "for", "if", "letting", "once", "provided", "putting", "setting", "taking",
    "when", "whenever", "where",
];
/// So many words before it are looked at.
const MOST_WORDS: usize = 6;

impl Derivation {
    /// Whether an equation is of more than a special case that was told before the display before it: of what goes together in that,
    /// it speaks apart. "For equal risks $r = s$ this is $$…$$ Differentiating (1) gives $$V' = 2 w r^2 - …s^2$$" is said of any `r`
    /// and `s`. What is said "in general" is, too.
    pub fn is_beyond(&self, at: usize, (number, local): (usize, usize)) -> bool {
        let equation = &self.equations[at];
        let page = &self.pages[number];
        let local = &page.locals[local];
        let Some(before) = self
            .before_display(at)
            .map(|before| &self.equations[before])
        else {
            return false;
        };
        let is_said = local.is_told || local.is_special;
        if !is_said
            || local.means
            || local.is_momentary()
            || !local.is_equation()
            || equation.page != number
            || local.span.start >= before.span.start
            || !(local.is_case() || is_conditional(&page.document.source, local.span))
        {
            return false;
        }
        let left = page
            .general
            .partition_point(|&place| place < local.span.start);
        if (page.general.get(left)).is_some_and(|&place| place < equation.span.start) {
            return true;
        }
        local.is_parted_by(equation.statements())
    }
}

impl Local {
    /// Whether statements speak of what it gives a special value, `\omega = \omega_0` or `r = 1`, and not of that value.
    fn is_left_for_the_whole<'a>(
        &self,
        statements: impl IntoIterator<Item = &'a Statement>,
    ) -> bool {
        if !self.is_special {
            return false;
        }
        let mut special = self
            .formulas
            .iter()
            .filter_map(|own| match own.as_equation()? {
                (Expr::Symbol(whole), Expr::Symbol(own)) => {
                    own.is_variant_of(whole).then_some((whole, Some(own)))
                }
                (Expr::Symbol(whole), Expr::Number(_)) => Some((whole, None)),
                _ => None,
            });
        let Some((whole, own)) = special.next() else {
            return false;
        };
        let mut arrived = statements.into_iter().filter_map(arrived);
        arrived.any(|formula| {
            let names = formula.names();
            let is_own = own.is_some_and(|own| names.contains(own));
            names.contains(whole) && !is_own
        })
    }

    /// Whether statements speak apart of what it says goes together, and do not say that themselves.
    fn is_parted_by<'a>(&self, statements: impl IntoIterator<Item = &'a Statement>) -> bool {
        let names = self.names();
        let mut statements = statements.into_iter();
        names.len() > 1
            && statements.any(|statement| {
                // On the way to where a chain arrives both may be spoken of.
                let parted = arrived(statement).is_some_and(|own| names.is_subset(&own.names()));
                let said = formulas(statement);
                parted && !self.formulas.iter().any(|own| said.contains(own))
            })
    }
}

/// What the ends of a chain of equations say.
fn arrived(statement: &Statement) -> Option<Formula> {
    let said = formulas(statement);
    let equations: Vec<_> = said.iter().filter_map(Formula::as_equation).collect();
    match &equations[..] {
        [] => None,
        [(left, _), .., (_, right)] | [(left, right)] => {
            Some(Formula::equal((*left).clone(), (*right).clone()))
        }
    }
}

impl Reader<'_> {
    /// Leaves the places that were named before the display before, "at $R = r$, where $$…$$", once a display speaks of both apart; and
    /// what something is in a special case, "at $\omega = \omega_0$", "Suppose that $r = 1$", once a display speaks of it in general.
    pub(super) fn leave_places(&mut self, display: &[Part]) {
        let Some(before) = self.equations.last() else {
            return;
        };
        let locals = &self.page.locals;
        let source = &self.page.document.source;
        let is_place = |local: &Local| {
            local.of_case
                && local.is_special
                && local.moment.is_none()
                && local.is_equation()
                && is_said_of_a_place(source, local.span)
        };
        let said = || rows::statements(display);
        self.active.retain(|&at| {
            let own = &locals[at];
            let is_before = own.span.start < before.span.start;
            let is_beyond =
                || is_place(own) && own.is_parted_by(said()) || own.is_left_for_the_whole(said());
            !(is_before && is_beyond())
        });
        self.page.leave_passages(&mut self.active);
    }
}

/// Whether what comes next is said of the place that is named: "Maximum hence at $R = r$, where".
fn is_said_of_a_place(source: &str, span: Span) -> bool {
    let after = source.get(span.end..).unwrap_or_default();
    let after = after.trim_start_matches(|c: char| c == '$' || c == ',' || c.is_whitespace());
    after
        .strip_prefix("\\)")
        .unwrap_or(after)
        .trim_start_matches([',', ' '])
        .starts_with("where")
}

/// Whether the words right before a relation say that it is a condition.
fn is_conditional(source: &str, span: Span) -> bool {
    let before = source.get(..span.start).unwrap_or_default();
    let before =
        before.trim_end_matches(|c: char| c.is_whitespace() || matches!(c, '$' | '(' | '\\'));
    let clause = before.rsplit(|c: char| !(c.is_alphabetic() || c.is_whitespace() || c == '-'));
    let clause = clause.into_iter().next().unwrap_or_default();
    let words = clause.split_whitespace().rev().take(MOST_WORDS);
    words
        .into_iter()
        .any(|word| CONDITIONAL.contains(&&*word.to_lowercase()))
}
