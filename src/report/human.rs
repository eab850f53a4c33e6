//! The whole page for people: a line for each equation, the findings explained, the summary.

use super::Report;
use super::diagnostic::LaidOut;
use super::remark::Known;
use super::style::{BOLD, DIM, paint};
use crate::parallel::in_order;
use crate::sorted;

impl Report<'_> {
    /// The page, with colours in it. `show_understood` adds to each line what was read.
    pub fn human(&self, show_understood: bool) -> String {
        self.human_but(show_understood, &Known::new())
    }

    /// The page without what is known of its findings.
    pub fn human_but(&self, show_understood: bool, known: &Known) -> String {
        let first_to_share = self.first_to_share(known);
        let names = self.width_of_names();
        let entries = 0..self.audit.entries.len();
        let pieces = [Piece::Elsewhere, Piece::Summary].into_iter();
        // All of it in one go: to begin several times takes longer than some of these.
        let mut written = in_order(
            pieces.chain(entries.map(Piece::Entry)),
            |piece| match piece {
                Piece::Elsewhere => (String::new(), self.told_elsewhere(known)),
                Piece::Summary => (self.summary(), Vec::new()),
                Piece::Entry(at) => (
                    self.shown(at, names, show_understood),
                    self.told_of_entry(at, &first_to_share[at], known),
                ),
            },
        )
        .into_iter();
        let mut next = || written.next().unwrap_or_default();
        let (elsewhere, summary) = (next().1, next().0);
        let (lines, of_entries): (Vec<String>, Vec<Vec<LaidOut>>) = written.unzip();
        let mut findings: Vec<LaidOut> = elsewhere;
        findings.extend(of_entries.into_iter().flatten());
        sorted::sort_by_key(&mut findings, |finding| finding.place);
        let findings: String = findings.into_iter().map(|finding| finding.text).collect();
        let mut text = self.under_titles(&lines);
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
        let entries = 0..self.audit.entries.len();
        let lines: Vec<String> = entries
            .map(|at| self.shown(at, names, show_understood))
            .collect();
        self.under_titles(&lines)
    }

    /// The line of an entry, and with it what was understood where that is asked for.
    fn shown(&self, at: usize, names: usize, show_understood: bool) -> String {
        let entry = &self.audit.entries[at];
        let mut text = self.line(entry, names);
        if show_understood {
            text += &self.understood(entry, names);
        }
        text
    }

    /// Lines, one for each entry, under the title of each page.
    fn under_titles(&self, lines: &[String]) -> String {
        let mut text = String::new();
        let mut lines = self.audit.entries.iter().zip(lines).peekable();
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
            // Entries are in the order of their pages.
            while let Some((_, line)) =
                lines.next_if(|(entry, _)| self.equation(entry.equation).page <= at)
            {
                text += line;
            }
            text.push('\n');
        }
        text
    }
}

/// What a page for people is put together from.
enum Piece {
    /// What is found elsewhere than in equations.
    Elsewhere,
    Summary,
    /// The line of an entry, and what is found there.
    Entry(usize),
}
