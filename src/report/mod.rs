//! What people and programs see of an audit.
//!
//! A [`Report`] is a derivation with its audit. Each view is a file of its own: `human` puts together the
//! whole page from `line` (an equation each), `diagnostic` (a finding each, in the author's own text) and
//! `summary`; `explain` writes out one equation's evidence so that it can be checked by hand; `json` is
//! for programs; `html` is all of it as a page for a browser. `words` has what all of them say alike.
//!
//! The views for editors and for continuous integration list a [`remark::Remark`] each: `short`, `github`, `sarif` and
//! `junit`. `codes` says how grave each is, `baseline` which are known.
//!
//! `declarations` is for authors: what is left to declare, from `symbols` and what `settling` finds.
//!
//! Every view is a `String` with colours in it; whoever prints it leaves them out where they are not wanted.

pub mod baseline;
pub mod codes;
mod declarations;
pub mod diagnostic;
mod dimension;
pub mod evidence;
pub mod explain;
mod fingerprint;
mod fix;
mod github;
pub mod graph;
pub mod html;
pub mod human;
pub mod implied;
mod induction;
mod json;
mod junit;
pub mod line;
pub mod near;
mod numeric;
mod place;
pub mod proof;
pub mod remark;
mod sarif;
mod scaling;
mod settling;
mod short;
mod style;
pub mod summary;
mod symbols;
mod words;

use crate::audit::{Audit, Entry, Note};
use crate::derivation::Derivation;

pub use declarations::declarations;
pub use fix::Fix;
pub use github::github;
pub use short::short;

/// A derivation with its audit: what every view looks at.
#[derive(Clone, Copy, Debug)]
pub struct Report<'a> {
    /// What was read.
    pub derivation: &'a Derivation,
    /// What was found of it.
    pub audit: &'a Audit,
    /// The paths that were asked for, to be repeated in what a reader may type next; none for the built-in report.
    pub paths: &'a [String],
}

impl Report<'_> {
    /// How many findings there are, places that could not be read included.
    pub fn findings(&self) -> usize {
        self.unread() + self.audit.entries.iter().map(findings_of).sum::<usize>()
    }

    /// How much there is to mend besides equations, on all pages.
    pub fn unread(&self) -> usize {
        let pages = 0..self.derivation.pages.len();
        pages.map(|page| self.problems(page)).sum()
    }

    /// How much there is to mend on a page besides equations: what could not be read, and suppositions that compare
    /// what differs in dimension.
    fn problems(&self, page: usize) -> usize {
        let supposed = self.audit.dimensions.suppositions.keys();
        let supposed = supposed.filter(|(own, _)| *own == page).count();
        self.derivation.pages[page].problems.len() + supposed
    }

    /// What to type to see an equation's evidence in full.
    pub fn replay(&self, at: usize) -> Option<String> {
        let mut command = format!("cradle-verify explain {}", self.equation(at).label()?);
        for path in self.paths {
            match path.contains(|c: char| c.is_whitespace() || "'\"$`\\&;|<>()*?[]#~!".contains(c))
            {
                true => command += &format!(" '{}'", path.replace('\'', "'\\''")),
                false => command += &format!(" {path}"),
            }
        }
        Some(command)
    }
}

/// How many things there are to mend about one entry: what belongs to its failing is counted with that.
fn findings_of(entry: &Entry) -> usize {
    let fails = entry.is_wrong() && !entry.fails_as_marked();
    let apart = |note: &&Note| note.is_finding() && !(fails && belongs_to_failing(note));
    usize::from(fails) + entry.notes.iter().filter(apart).count()
}

/// Said together with a counterexample rather than by itself.
fn belongs_to_failing(note: &Note) -> bool {
    matches!(note, Note::UnstatedCondition(_) | Note::WrongMark(_))
}
