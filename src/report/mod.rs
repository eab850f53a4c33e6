//! What people and programs see of an audit.
//!
//! A [`Report`] is a derivation with its audit. Each view is a file of its own: [`human`] puts together the
//! whole page from [`line`] (an equation each), [`diagnostic`] (a finding each, in the author's own text) and
//! [`summary`]; [`explain`] writes out one equation's evidence so that it can be checked by hand; [`json`] is
//! for programs. `words` has what all of them say alike.
//!
//! Every view is a `String` with colours in it; whoever prints it leaves them out where they are not wanted.

pub mod diagnostic;
pub mod evidence;
pub mod explain;
pub mod human;
pub mod json;
pub mod line;
pub mod proof;
mod style;
pub mod summary;
mod words;

use crate::audit::Audit;
use crate::derivation::Derivation;

/// A derivation with its audit: what every view looks at.
#[derive(Clone, Copy, Debug)]
pub struct Report<'a> {
    /// What was read.
    pub derivation: &'a Derivation,
    /// What was found of it.
    pub audit: &'a Audit,
}

impl Report<'_> {
    /// How many findings there are: entries with something to mend, and places that could not be read.
    pub fn findings(&self) -> usize {
        let unread: usize = self.derivation.pages.iter().map(|p| p.problems.len()).sum();
        self.audit.findings().count() + unread
    }
}
