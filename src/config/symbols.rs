//! `[symbols]`: each entry is a declaration as the `symbols` directive has it, its names for a key and its attributes for a
//! value.

use super::table::{Entry, Reader};
use crate::derivation::Shared;
use crate::document::{Attribute, Span, declaration};
use crate::notation::{Spanned, read_symbol};

/// Reads the table.
pub(super) fn read(reader: &mut Reader<'_>, entry: &Entry<'_, '_>) -> Vec<Shared> {
    let mut symbols = Vec::new();
    let example = "`[symbols]`, and below it `\"m_1, m_2\" = \"mass, positive\"`";
    for entry in reader.table(entry, example) {
        let Some(attributes) = reader.text(&entry, "`v = \"velocity, nonzero\"`") else {
            continue;
        };
        let names = reader.inside(entry.key, entry.key_span);
        symbols.extend(declared(reader, &names, &attributes));
    }
    symbols
}

/// Reads one declaration: put together as a clause, with a way back for each place.
fn declared(
    reader: &mut Reader<'_>,
    names: &Spanned<String>,
    attributes: &Spanned<String>,
) -> Vec<Shared> {
    let clause = format!("{}: {}", names.value, attributes.value);
    let colon = names.value.len();
    let back = |span: Span| {
        let (part, start) = match span.start > colon {
            true => (attributes, colon + 2),
            false => (names, 0),
        };
        let exact = part.span.end - part.span.start == part.value.len();
        let within = |at: usize| part.span.start + at.saturating_sub(start).min(part.value.len());
        match exact {
            // A complaint about the clause as a whole is one about its names.
            true => Span::new(within(span.start), within(span.end)),
            false => part.span,
        }
    };
    let (spans, read, problems) = declaration(&clause);
    for problem in problems {
        let help = problem.help.unwrap_or_default();
        let help = help.replace(
            "`symbols m_1, m_2: mass, positive`",
            "`\"m_1, m_2\" = \"mass, positive\"`",
        );
        reader.complain(back(problem.span), problem.message, help);
    }
    let attributes: Vec<Spanned<Attribute>> = read
        .into_iter()
        .map(|attribute| Spanned {
            span: back(attribute.span),
            ..attribute
        })
        .collect();
    let mut symbols = Vec::new();
    for span in spans {
        match read_symbol(&clause[span.range()]) {
            Ok(symbol) => symbols.push(Shared {
                symbol,
                span: back(span),
                attributes: attributes.clone(),
            }),
            Err(error) => {
                let start = span.start;
                let own = Span::new(start + error.span.start, start + error.span.end);
                reader.complain(back(own), error.message, error.help.unwrap_or_default());
            }
        }
    }
    symbols
}
