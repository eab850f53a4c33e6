//! Repairs that a program can apply: text for a place in the document, which the kernel has seen to follow.

use crate::audit::{Entry, Judged, Outcome};
use crate::derivation::Source;
use crate::document::Span;
use crate::notation::latex;

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
    /// It is offered only where it mends the equation: nothing that it is judged from is wrong, no other link fails, and none
    /// speaks of the side that is replaced, but the next one where that has been proved of what is put in.
    pub(super) fn fix(&self, entry: &Entry) -> Option<Fix> {
        let (message, proven) = implied::instead_plainly(entry)?;
        let (judged, _) = entry.refuted()?;
        if entry.mended.as_ref().is_some_and(|m| !m.under.is_empty()) {
            return None;
        }
        let goal = &judged.goal;
        let (first, second) = proven.claim().goal.as_equation()?;
        let (left, right) = goal.formula.as_equation()?;
        let (before, after) = goal.sides;
        // One side stays as it is printed.
        let (span, term) = match () {
            () if left == first && right != second => (after, second),
            () if right == second && left != first => (before, first),
            () if right == first && left != second => (before, second),
            () => return None,
        };
        let at = entry.equation;
        let neighbour = match span == after {
            true => self.derivation.link_after(at, goal),
            false => self.derivation.link_before(at, goal),
        };
        let mends_next = entry.mended.as_ref().is_some_and(|m| m.next.is_some());
        if before == after || neighbour.is_some() && !(mends_next && span == after) {
            return None;
        }
        let is_wrong =
            |j: &&Judged| !j.outcome.is_proven() && !matches!(j.outcome, Outcome::Defined);
        let mut wrong = entry.judged.iter().filter(is_wrong);
        let is_mended = |j: &Judged| {
            let next = neighbour.as_ref().map(|next| next.span);
            j.goal.span == goal.span || next == Some(j.goal.span)
        };
        let is_false = |e: &Entry| e.is_mistake() || !e.rests_on.is_empty();
        let from_false = judged.assumed.iter().any(|a| match a.source {
            Source::Equation(premise) => self.audit.of_equation(premise).iter().any(is_false),
            _ => false,
        });
        if from_false || self.statement(entry)?.clauses.len() != 1 || !wrong.all(is_mended) {
            return None;
        }
        let page = self.equation(entry.equation).page;
        // What is said of complex numbers is judged by their parts, and not printed so.
        if !self.derivation.pages[page].complex.is_empty() {
            return None;
        }
        let document = &self.derivation.pages[page].document;
        // Over several rows an author has aligned it; what is put in would undo that.
        if document.text(span).contains(['&', '%']) || document.text(span).contains(r"\\") {
            return None;
        }
        let source = &document.source;
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
