//! Tables of exact numbers, as `scenario` and `simulate` print them.

use std::fmt::Write;

use nalgebra::DVector;
use num_rational::BigRational;
use num_traits::Signed;

pub(super) fn strings(values: &DVector<BigRational>) -> Vec<String> {
    values.iter().map(BigRational::to_string).collect()
}

/// A difference, with a plus where it is one.
pub(super) fn signed(value: &BigRational) -> String {
    if value.is_positive() {
        format!("+{value}")
    } else {
        value.to_string()
    }
}

/// Rows with their columns aligned, two spaces in, three between.
pub(super) fn table(rows: &[Vec<String>]) -> String {
    aligned(rows, |_| false)
}

/// The same with numbers in all columns but the first: they end below each other.
pub(super) fn numbered(rows: &[Vec<String>]) -> String {
    aligned(rows, |column| column > 0)
}

fn aligned(rows: &[Vec<String>], at_right: fn(usize) -> bool) -> String {
    let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
    let width = |column: usize| {
        rows.iter()
            .map(|row| row[column].chars().count())
            .max()
            .unwrap_or(0)
    };
    let widths: Vec<usize> = (0..columns).map(width).collect();
    let mut text = String::new();
    for row in rows {
        let cell = |(at, (cell, &width)): (usize, (&String, &usize))| match at_right(at) {
            true => format!("{cell:>width$}"),
            false => format!("{cell:<width$}"),
        };
        let cells: Vec<String> = row.iter().zip(&widths).enumerate().map(cell).collect();
        let _ = writeln!(text, "  {}", cells.join("   ").trim_end());
    }
    text
}
