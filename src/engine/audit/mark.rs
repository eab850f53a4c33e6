//! The author's ✓ and ✗: whether they are right.

use crate::algebra::{Formula, Relation};
use crate::notation::{Mark, Statement};

use super::{Entry, Judged, Note, Verdict};

/// Whether the author's ✓ or ✗ is right.
pub(super) fn mark(statement: &Statement, entry: &mut Entry) {
    let Some(mark) = &statement.mark else {
        return;
    };
    // `a ≠ b ✗` crosses out the law `a = b` that the author tested, and says so twice.
    let denied = entry.judged.iter().any(|j| {
        matches!(
            &j.goal.formula,
            Formula::Relation {
                relation: Relation::NotEqual,
                ..
            }
        )
    });
    let right = match (mark.value, entry.verdict) {
        (_, Verdict::Undecided) => return,
        (Mark::Tick, verdict) => verdict == Verdict::Holds,
        (Mark::Cross, Verdict::Holds) => denied,
        (Mark::Cross, _) => crossed_out_rightly(entry),
    };
    if !right {
        entry.notes.push(Note::WrongMark(mark.value));
    }
}

/// Where the author asks with `\stackrel{?}{=}`, that link alone is crossed out; the others must hold.
fn crossed_out_rightly(entry: &Entry) -> bool {
    let refuted = |j: &&Judged| j.outcome.is_refuted();
    match entry.judged.iter().any(|j| j.goal.questioned) {
        true => entry
            .judged
            .iter()
            .filter(refuted)
            .all(|j| j.goal.questioned),
        false => true,
    }
}
