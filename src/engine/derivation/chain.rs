//! Chains over several rows: which link a relation goes on with, and which goes on with it.

use super::{Derivation, Goal, goals};
use crate::algebra::Formula;

impl Derivation {
    /// The link of which the left side of a goal is the end: the value of that side is said there.
    pub fn link_before(&self, at: usize, goal: &Goal) -> Option<Goal> {
        let row = self.equations[at].continues > 0;
        let rows = [Some(at), at.checked_sub(1).filter(|_| row)];
        self.link(rows, |other| other.sides.1 == goal.sides.0)
    }

    /// The link that goes on with the right side of a goal.
    pub fn link_after(&self, at: usize, goal: &Goal) -> Option<Goal> {
        let row = |next: usize| self.equations.get(next).is_some_and(|e| e.continues > 0);
        let rows = [Some(at), Some(at + 1).filter(|&next| row(next))];
        self.link(rows, |other| other.sides.0 == goal.sides.1)
    }

    fn link(&self, rows: [Option<usize>; 2], joins: impl Fn(&Goal) -> bool) -> Option<Goal> {
        let statements = rows.into_iter().flatten();
        let statements = statements.flat_map(|row| self.equations[row].statements());
        // The two sides of what is said of a whole sequence are one place.
        let is_link = |goal: &Goal| matches!(goal.formula, Formula::Relation { .. });
        let mut links = statements.flat_map(goals).filter(is_link);
        links.find(joins)
    }
}
