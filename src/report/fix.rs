//! Repairs that a program can apply: text for a place in the document, which the kernel has seen to follow.

use crate::audit::Entry;
use crate::document::Span;
use crate::notation::{Clause, latex};

use super::Report;
use super::implied;

/// What to write instead, and where.
#[derive(Clone, Debug)]
pub struct Fix {
    /// In words.
    pub message: String,
    /// What is to be replaced.
    pub span: Span,
    /// By what.
    pub text: String,
}

impl Report<'_> {
    /// The repair of an entry, where its premises give one.
    ///
    /// It is offered only where it mends the equation: the side that is replaced ends its chain, so that no other link
    /// speaks of it, and no other link fails.
    pub(super) fn fix(&self, entry: &Entry) -> Option<Fix> {
        let (message, proven) = implied::instead_plainly(entry)?;
        let (judged, _) = entry.refuted()?;
        let wrong = entry.judged.iter().filter(|j| !j.outcome.is_proven());
        let others = wrong.filter(|j| !matches!(j.outcome, crate::audit::Outcome::Defined));
        if others.count() != 1 {
            return None;
        }
        let (first, second) = proven.claim().goal.as_equation()?;
        let (left, right) = judged.goal.formula.as_equation()?;
        let (before, after) = judged.goal.sides;
        // One side stays as it is printed.
        let (span, term) = match () {
            () if left == first && right != second => (after, second),
            () if right == second && left != first => (before, first),
            () if right == first && left != second => (before, second),
            () => return None,
        };
        let statement = self.statement(entry)?;
        let clause = statement.clauses.get(judged.goal.clause)?;
        let Clause::Chain { sides, .. } = clause else {
            return None;
        };
        let ends = [sides.first()?.span, sides.last()?.span];
        if statement.clauses.len() != 1 || before == after || !ends.contains(&span) {
            return None;
        }
        let page = self.equation(entry.equation).page;
        let source = &self.derivation.pages[page].document.source;
        // A command just before must not run into what is written.
        let letter = |c: char| c.is_ascii_alphabetic();
        let previous = source.get(..span.start)?.chars().next_back();
        let space = if previous.is_some_and(letter) {
            " "
        } else {
            ""
        };
        Some(Fix {
            message,
            span,
            text: format!("{space}{}", latex(term)),
        })
    }
}
