//! Quantities that a table lists: `| $\rho$ | density | $998\,\mathrm{kg/m^3}$ |`, `$m$ & mass & 0.5 & kg \\`.
//!
//! A row tells one number of one symbol, or nothing: rows of several numbers are measurements.

use crate::document::{Document, Span, TableCell as Cell, TableRow};
use crate::notation::{has_units, read_formulas};

use super::values::{Printed, figure};

/// Before a symbol these say that the row is about something else: "speed at $r_1$".
const ABOUT: [&str; 12] = [
    "at", "of", "in", "for", "on", "from", "with", "between", "to", "by", "when", "if",
];

/// What the tables of a document tell.
pub(super) fn tabulated(document: &Document) -> Vec<Printed> {
    let rows = document.table_rows();
    rows.iter().filter_map(|row| told(document, row)).collect()
}

/// What a row tells.
fn told(document: &Document, row: &TableRow) -> Option<Printed> {
    let mut cells = row.cells.iter().enumerate();
    let (of, symbol) = cells.find_map(|(at, cell)| Some((at, symbol(document, cell)?)))?;
    let mut found = None;
    for (at, cell) in row.cells.iter().enumerate().filter(|(at, _)| *at != of) {
        let Some((number, unit)) = number(document, cell) else {
            continue;
        };
        if found.is_some() {
            return None;
        }
        let unit = match unit.is_empty() {
            false => Some(unit),
            true => unit_beside(row, at),
        };
        let number = number.trim();
        let written = match &unit {
            Some(unit) => format!("{symbol} = {number}\\,\\mathrm{{{unit}}}"),
            None => format!("{symbol} = {number}"),
        };
        let read = read_formulas(&written, Span::new(0, written.len())).ok()?;
        let [statement] = &read[..] else {
            return None;
        };
        let goal = figure(statement)?;
        let is_with_units = goal.formula.terms().into_iter().any(has_units);
        if unit.is_some() && !is_with_units {
            return None;
        }
        let span = row.cells[of].span.to(cell.span);
        found = Some(Printed {
            goal,
            span,
            equation: None,
            constant: None,
        });
    }
    found
}

/// The symbol that a cell names: `$m$`, "mass $m$", `$S = \pi r^2$`.
fn symbol<'a>(document: &'a Document, cell: &Cell) -> Option<&'a str> {
    let [math] = cell.math[..] else {
        return None;
    };
    let text = document.text(math.body);
    let is_about = |word: &str| ABOUT.contains(&word.to_lowercase().as_str());
    let is_number = |text: &str| text.trim_start().starts_with(|c: char| c.is_ascii_digit());
    if cell.words.split_whitespace().any(is_about) || is_number(text) {
        return None;
    }
    Some(text.split('=').next().unwrap_or(text).trim())
}

/// The number that a cell is, and the unit beside it.
fn number(document: &Document, cell: &Cell) -> Option<(String, String)> {
    let (number, unit) = match cell.math[..] {
        [math, ..] => {
            let before = Span::new(cell.span.start, math.span.start);
            if !document.text(before).trim().is_empty() {
                return None;
            }
            // `$998$ kg/m$^3$`
            let after = document.text(Span::new(math.span.end, cell.span.end));
            (document.text(math.body).trim(), after.replace('$', ""))
        }
        [] => {
            let words = cell.words.as_str();
            let is_quantity = ["\\SI{", "\\qty{", "\\num{"];
            let end = match is_quantity.iter().any(|own| words.starts_with(own)) {
                true => None,
                false => words.find(|c: char| !c.is_ascii_digit() && c != '.' && c != '-'),
            };
            let (number, unit) = words.split_at(end.unwrap_or(words.len()));
            (number, unit.to_owned())
        }
    };
    let begins = |c: char| c.is_ascii_digit() || matches!(c, '-' | '\\' | '.');
    let is_number = number.starts_with(begins)
        && number.contains(|c: char| c.is_ascii_digit())
        && !number.contains('=');
    is_number.then(|| (number.to_owned(), unit.trim().to_owned()))
}

/// The unit of a number that stands without one: in the cell behind it, at the head of its column, or in parentheses in its row.
fn unit_beside(row: &TableRow, at: usize) -> Option<String> {
    let next = row.cells.get(at + 1).filter(|own| own.math.is_empty());
    let is_unit = |own: &str| {
        let short = own.len() <= 12 && !own.is_empty();
        short && own.starts_with(|c: char| c.is_alphabetic()) && !own.contains(' ')
    };
    let next = next.map(|own| own.words.clone()).filter(|own| is_unit(own));
    let bracketed = |cell: &Cell| {
        let open = cell.words.find(['(', '['])?;
        let rest = &cell.words[open + 1..];
        Some(rest[..rest.find([')', ']']).unwrap_or(rest.len())].to_owned())
    };
    next.or_else(|| row.heads.get(at).and_then(bracketed))
        .or_else(|| row.cells.iter().find_map(bracketed))
}
