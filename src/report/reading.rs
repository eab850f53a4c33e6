//! What is said of other readings of an equation: both as they are read, and what each comes to.

use annotate_snippets::Level;

use crate::audit::{Entry, Note, OtherReading, Verdict};
use crate::notation::{Choice, plain_statement};

use super::Report;

impl Report<'_> {
    /// Another reading as a clause: how it is read, and what another way would come to.
    pub(super) fn read_otherwise(&self, own: usize, other: &OtherReading) -> String {
        let would = match (other.verdict, other.otherwise) {
            (_, Verdict::Holds) => "would hold",
            (Verdict::IllDimensioned, _) => "would be well-dimensioned",
            _ => "would fail",
        };
        let (read, otherwise) = (plain_statement(&other.read), plain_statement(&other.other));
        match other.equation == own {
            true => format!("read as `{read}`; as `{otherwise}` it {would}"),
            false => {
                let cited = self.reference(other.equation);
                format!("{cited} is read as `{read}`; with `{otherwise}` this {would}")
            }
        }
    }

    /// The same as a help, with the place and what to write.
    pub(super) fn other_reading(&self, entry: &Entry) -> Vec<(Level<'static>, String)> {
        let others = entry.notes.iter().filter_map(|note| match note {
            Note::OtherReading(other) if !note.is_quiet() => {
                let write = match other.choice {
                    Choice::Below(_) => "write `\\frac{…}{…}`, or parentheses below the stroke",
                    Choice::FirstName | Choice::Group => "put the argument of the function in parentheses",
                    Choice::OfValue => "put the power directly after the function, or the whole value in parentheses",
                    Choice::Product => "write `\\cdot` before the parenthesis",
                };
                let page = self.equation(other.equation).page;
                let text = self.derivation.pages[page].document.written(other.span);
                let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
                let place = self.place_of(page, other.span);
                let read = self.read_otherwise(entry.equation, other);
                let text = format!(
                    "`{text}` at {place} can be taken in two ways: {read}; if that is meant, {write}"
                );
                Some((Level::HELP, text))
            }
            _ => None,
        });
        others.collect()
    }
}
