//! LaTeX documents: what TeX would set is found without running TeX.
//!
//! Two steps. `assemble` puts the text together: comments, verbatim text and the branches of conditions that are not
//! taken go, files that are input come in, the author's macros are put in, and every byte remembers where it comes from.
//! `scan` then goes through the text and finds displays, sections, prose and the `% check:` comments; `numbering` counts
//! as LaTeX counts, so that findings speak the numbers of the printed page; `display` takes a display apart into rows.
//!
//! What is not understood is told at its place. Where it stands inside a display, that equation is not read at all (its
//! [`Layout::obstacle`](super::Layout::obstacle)): a reader that guessed what an unknown macro does would misread it.
//!
//! **Invariant:** every display that TeX would set outside comments and verbatim text lies in an item or in a problem.
//! Macros are put in within bounds of steps and size, and nothing recurses on the machine's stack.

mod assemble;
mod conditional;
mod define;
mod dispatch;
mod display;
mod ends;
mod environment;
mod expand;
mod files;
mod inline;
mod names;
mod numbering;
mod omit;
mod pages;
mod rows;
mod scan;
mod token;

pub(super) use ends::environment_end;
pub use files::Library;
pub(super) use names::display as displaying;
pub(super) use rows::uncounted;

use std::sync::Arc;

use super::Document;

/// Reads a document with all that it takes in.
pub(super) fn read(path: String, source: Arc<str>, library: &dyn Library) -> Vec<Document> {
    let text = assemble::assemble(path, source, library);
    pages::documents(text)
}
