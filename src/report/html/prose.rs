//! The documents themselves: text, mathematics in it, and every display with its verdict.
//!
//! `spots` lists what of the text is not text, in order of place: displays, mathematics in a line, citations. Two
//! walks go over the text between them: `markdown` as a Markdown reader sees it, `plain` item by item for sources of
//! any other kind. Both leave the spots to `Spots::pass`, so that no display can be lost between them.

mod markdown;
mod plain;
mod spots;

use super::{Page, anchors};

impl Page<'_> {
    /// A document with all its equations.
    pub(super) fn document(&self, at: usize) -> String {
        let page = &self.report.derivation.pages[at];
        let id = anchors::document(at);
        let path = crate::notation::escape(&page.document.path);
        let mut text = format!(
            "<article id=\"{id}\" aria-labelledby=\"{id}-path\">\n<p class=\"path\" id=\"{id}-path\">{path}</p>\n"
        );
        if page.title.is_empty() {
            text += &format!("<h3>{path}</h3>\n");
        }
        text += &match markdown::reads(&page.document) {
            true => markdown::walk(self, at),
            false => plain::walk(self, at),
        };
        for problem in &page.problems {
            let place = self.report.place_of(at, problem.span);
            let help = problem
                .help
                .as_deref()
                .map_or(String::new(), |h| format!(": {h}"));
            text += &format!(
                "<p class=\"problem\"><strong>not read</strong> {}: {}{}</p>\n",
                crate::notation::escape(&place),
                super::words::ticked(&problem.message),
                super::words::ticked(&help)
            );
        }
        text + "</article>\n"
    }
}
