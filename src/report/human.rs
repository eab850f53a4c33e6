//! The whole page for people: a line for each equation, the findings explained, the summary.

use super::Report;
use super::remark::Known;
use super::style::{BOLD, DIM, paint};

impl Report<'_> {
    /// The page, with colours in it. `show_understood` adds to each line what was read.
    pub fn human(&self, show_understood: bool) -> String {
        self.human_but(show_understood, &Known::new())
    }

    /// The page without what is known of its findings.
    pub fn human_but(&self, show_understood: bool, known: &Known) -> String {
        let mut text = self.lines(show_understood);
        let findings = self.diagnostics(known);
        if !findings.is_empty() {
            text += &paint(BOLD, "Findings");
            text += "\n\n";
            text += &findings;
        }
        text += &paint(BOLD, "Summary");
        text += "\n\n";
        text + &self.summary()
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
