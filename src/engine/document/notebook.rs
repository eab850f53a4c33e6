//! Jupyter notebooks: their Markdown cells, one after another. A place is a line and column of a cell.

use std::collections::BTreeMap;
use std::fmt;
use std::sync::Arc;

use serde_json::value::RawValue;

use super::markdown;
use super::origin::{Cell, File};
use super::source::line_starts;
use super::{Document, Origin, Span};

/// A file that is no notebook, and why.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NotANotebook(String);

impl fmt::Display for NotANotebook {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "no Jupyter notebook: {}", self.0)
    }
}

impl std::error::Error for NotANotebook {}

/// Reads the Markdown cells of a notebook.
pub(super) fn read(path: String, text: &str) -> Result<Document, NotANotebook> {
    let text = text.trim_start_matches('\u{feff}');
    let notebook: serde_json::Value =
        serde_json::from_str(text).map_err(|error| NotANotebook(error.to_string()))?;
    // Before its fourth format a notebook had work sheets.
    let Some(cells) = notebook.get("cells").and_then(|cells| cells.as_array()) else {
        let message = "it has no list of cells (nbformat 4)";
        return Err(NotANotebook(message.to_owned()));
    };
    let mut source = String::new();
    let mut origin = Origin::default();
    let (mut items, mut problems) = (Vec::new(), Vec::new());
    let mut saved = saved_lines(text).unwrap_or_default().into_iter();
    for (number, cell) in (1..).zip(cells) {
        let saved = saved.next().unwrap_or_default();
        if cell.get("cell_type").and_then(|kind| kind.as_str()) != Some("markdown") {
            continue;
        }
        let Some(written) = cell.get("source").and_then(lines) else {
            let message = format!("cell {number} has no text");
            return Err(NotANotebook(message));
        };
        // Each cell is read by itself: what is not closed in one does not reach into the next.
        let reading = markdown::read(&written);
        let start = source.len();
        origin.push(
            start,
            origin.files.len(),
            Span::new(0, written.len() + 1),
            true,
        );
        source.push_str(&written);
        source.push('\n');
        items.extend(reading.items.into_iter().map(|item| item.moved(start)));
        problems.extend(reading.problems.into_iter().map(|mut problem| {
            problem.span = problem.span.shifted(start);
            problem
        }));
        let cell = Cell {
            notebook: path.clone(),
            number,
            saved,
        };
        origin.files.push(File::of_notebook(cell, written));
    }
    if origin.files.is_empty() {
        origin.files.push(File::new(path.clone(), ""));
    }
    Ok(Document {
        path,
        source: source.into(),
        items,
        inherited: Vec::new(),
        beside: None,
        problems,
        is_latex: false,
        origin: Arc::new(origin),
    })
}

/// A cell's text: one string, or a list of lines.
fn lines(source: &serde_json::Value) -> Option<String> {
    match source {
        serde_json::Value::String(text) => Some(text.clone()),
        serde_json::Value::Array(lines) => lines.iter().map(|line| line.as_str()).collect(),
        _ => None,
    }
}

/// The lines of a notebook on which the lines of each cell stand. Its text is gone through once more, for what has been
/// read of it does not say where it stood.
fn saved_lines(text: &str) -> Option<Vec<Vec<usize>>> {
    let starts = line_starts(text.as_bytes());
    // Each piece of the text lies in it.
    let line = |piece: &RawValue| {
        let before = (piece.get().as_ptr() as usize).saturating_sub(text.as_ptr() as usize);
        starts.partition_point(|&start| start <= before)
    };
    let cells = *members(text)?.get("cells")?;
    let cells: Vec<&RawValue> = serde_json::from_str(cells.get()).ok()?;
    let of_cell = |cell: &&RawValue| -> Option<Vec<usize>> {
        let source = *members(cell.get())?.get("source")?;
        let pieces = serde_json::from_str(source.get()).unwrap_or_else(|_| vec![source]);
        let (mut saved, mut begins) = (Vec::new(), true);
        for piece in pieces {
            let written: String = serde_json::from_str(piece.get()).ok()?;
            for part in written.split_inclusive('\n') {
                saved.extend(begins.then(|| line(piece)));
                begins = part.ends_with('\n');
            }
        }
        Some(saved)
    };
    Some(
        cells
            .iter()
            .map(|cell| of_cell(cell).unwrap_or_default())
            .collect(),
    )
}

/// The members of an object, each as it is written.
fn members(text: &str) -> Option<BTreeMap<String, &RawValue>> {
    serde_json::from_str(text).ok()
}
