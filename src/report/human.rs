//! The whole page for people: a line for each equation, the findings explained, the summary.

use super::Report;
use super::remark::Known;
use super::style::{BOLD, DIM, paint};
use crate::parallel::in_order;

impl Report<'_> {
    /// The page, with colours in it. `show_understood` adds to each line what was read.
    pub fn human(&self, show_understood: bool) -> String {
        self.human_but(show_understood, &Known::new())
    }

    /// The page without what is known of its findings.
    pub fn human_but(&self, show_understood: bool, known: &Known) -> String {
        // The findings take longest to write, so they are begun first.
        let parts: [&(dyn Fn() -> String + Sync); 3] = [
            &|| self.diagnostics(known),
            &|| self.lines(show_understood),
            &|| self.summary(),
        ];
        let mut written = in_order(parts, |write| write()).into_iter();
        let mut next = || written.next().unwrap_or_default();
        let (findings, mut text, summary) = (next(), next(), next());
        for (title, part) in [("Findings", findings), ("Summary", summary)] {
            if !part.is_empty() {
                text += &paint(BOLD, title);
                text += "\n\n";
                text += &part;
            }
        }
        text
    }

    /// The lines alone, under the title of each page.
    pub fn lines(&self, show_understood: bool) -> String {
        let names = self.width_of_names();
        let mut text = String::new();
        for (at, page) in self.derivation.pages.iter().enumerate() {
            let path = &page.document.path;
            match page.title.is_empty() {
                true => text += &paint(BOLD, path),
                false => {
                    text += &paint(BOLD, &page.title);
                    text += &paint(DIM, &format!("  {path}"));
                }
            }
            text.push('\n');
            let entries = &self.audit.entries;
            for entry in entries
                .iter()
                .filter(|e| self.equation(e.equation).page == at)
            {
                text += &self.line(entry, names);
                if show_understood {
                    text += &self.understood(entry, names);
                }
            }
            text.push('\n');
        }
        text
    }
}
