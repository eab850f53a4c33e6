//! What people and programs see of an audit.
//!
//! A [`Report`] is a derivation with its audit. Each view is a file of its own: `human` puts together the
//! whole page from `line` (an equation each), `diagnostic` (a finding each, in the author's own text) and
//! `summary`; `explain` writes out one equation's evidence so that it can be checked by hand; `json` is
//! for programs; `html` is all of it as a page for a browser. `words` has what all of them say alike.
//!
//! The views for editors and for continuous integration list a [`remark::Remark`] each: `short`, `github`, `sarif` and
//! `junit`. `baseline` says which are known.
//!
//! `codes` says how grave each code is, `levels` how grave an author wants it; `amiss` lays out what is wrong with an
//! author's configuration, `beside` where a document says otherwise than that.
//!
//! `declarations` is for authors: what is left to declare, from `symbols` and what `settling` finds.
//!
//! Every view is a `String` with colours in it; whoever prints it leaves them out where they are not wanted.

mod algebraic;
mod amiss;
pub mod baseline;
mod beside;
pub mod codes;
mod configuration;
mod declarations;
pub mod diagnostic;
mod dimension;
pub mod evidence;
pub mod explain;
mod family;
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
mod levels;
pub mod line;
mod meant;
pub mod near;
mod numeric;
mod place;
pub mod proof;
mod reading;
pub mod remark;
mod sarif;
mod scaling;
mod settling;
mod short;
mod style;
pub mod summary;
mod symbols;
mod words;

use crate::audit::{Audit, Note};
use crate::derivation::Derivation;

pub use amiss::amiss;
pub use configuration::{configuration, configuration_with};
pub use declarations::declarations;
pub use fix::Fix;
pub use github::github;
pub use meant::meant;
pub use short::short;
pub use style::uncoloured;

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
        let entries = self.audit.entries.iter();
        self.unread() + entries.map(|entry| self.findings_of(entry)).sum::<usize>()
    }

    /// How much there is to mend besides equations, on all pages.
    pub fn unread(&self) -> usize {
        let pages = 0..self.derivation.pages.len();
        pages.map(|page| self.problems(page)).sum()
    }

    /// How much there is to mend on a page besides equations: what could not be read, suppositions that compare
    /// what differs in dimension, and what is declared otherwise beside the document.
    fn problems(&self, page: usize) -> usize {
        let own = self.derivation.pages.get(page);
        let supposed = self.audit.dimensions.suppositions.keys();
        let supposed = supposed.filter(|(own, _)| *own == page).count();
        let numbers = [
            ("unreadable", own.map_or(0, |page| page.problems.len())),
            ("ill-dimensioned", supposed),
            (beside::CODE, own.map_or(0, |page| page.clashes.len())),
        ];
        let told = numbers.into_iter().filter(|(code, number)| {
            *number > 0 && self.level(page, code) > Some(codes::Level::Note)
        });
        told.map(|(_, number)| number).sum()
    }

    /// What to type to see an equation's evidence in full.
    pub fn replay(&self, at: usize) -> String {
        let label = match self.equation(at).label() {
            Some(label) => label.to_owned(),
            None => quoted(&self.place(at)),
        };
        let mut command = format!("cradle-verify explain {label}");
        for path in self.paths {
            command += &format!(" {}", quoted(path));
        }
        command
    }
}

/// A text as a shell takes it for one word.
fn quoted(text: &str) -> String {
    match text.contains(|c: char| c.is_whitespace() || "'\"$`\\&;|<>()*?[]#~!".contains(c)) {
        true => format!("'{}'", text.replace('\'', "'\\''")),
        false => text.to_owned(),
    }
}

/// Said together with a counterexample rather than by itself.
fn belongs_to_failing(note: &Note) -> bool {
    matches!(note, Note::UnstatedCondition(_) | Note::WrongMark(_))
}
