//! The documents themselves: text, mathematics in it, and every display with its verdict.
//!
//! `spots` lists what of the text is not text, in order of place: displays, mathematics in a line, citations. Two
//! walks go over the text between them: `markdown` as a Markdown reader sees it, `latex` item by item for those in
//! LaTeX. Both leave the spots to `Spots::pass`, so that no display can be lost between them.

mod latex;
mod latex_reader;
mod latex_words;
mod markdown;
mod spots;

use super::{Page, anchors};
use crate::document::Item;
use latex::Heading;

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
        text += &match page.document.is_latex {
            true => latex::walk(self, at),
            false => markdown::walk(self, at),
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

    /// A document's title, with its mathematics set so, or its path.
    pub(super) fn title_of(&self, at: usize, math: fn(&str) -> String) -> String {
        let page = &self.report.derivation.pages[at];
        if page.title.is_empty() {
            return crate::notation::escape(&page.document.path);
        }
        let first = page.document.items.iter().find_map(|item| match item {
            Item::Heading { title, span, .. } => Some((title, *span)),
            _ => None,
        });
        match first {
            Some((title, span)) if page.document.is_latex => {
                latex::heading(self, &page.document, &Heading { title, span, math })
            }
            _ => markdown::line(&page.title, math),
        }
    }
}
