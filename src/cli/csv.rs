//! Tables for other programs: comma-separated values, and Markdown.

use std::borrow::Cow;

use crate::cradle::parse_exact;

/// Rows as comma-separated values (RFC 4180, but with bare line feeds). What a spreadsheet would take for a formula begins
/// with an apostrophe.
pub(super) fn csv(rows: &[Vec<String>]) -> String {
    let cell = |text: &String| {
        let text = harmless(text);
        match text.contains([',', '"', '\n', '\r']) {
            true => format!("\"{}\"", text.replace('"', "\"\"")),
            false => text.into_owned(),
        }
    };
    let line = |row: &Vec<String>| row.iter().map(cell).collect::<Vec<_>>().join(",") + "\n";
    rows.iter().map(line).collect()
}

/// Text that no spreadsheet calculates with, unless it is a number.
fn harmless(text: &str) -> Cow<'_, str> {
    match text.starts_with(['=', '+', '-', '@', '\t', '\r']) && parse_exact(text).is_err() {
        true => format!("'{text}").into(),
        false => text.into(),
    }
}

/// Rows as a Markdown table, the first one being its head, with numbers in all columns but the first. What could be markup
/// is escaped.
pub(super) fn markdown(rows: &[Vec<String>]) -> String {
    let line = |row: &Vec<String>| {
        let cells: Vec<String> = row.iter().map(|text| escaped(text)).collect();
        format!("| {} |\n", cells.join(" | "))
    };
    let mut lines = rows.iter().map(line);
    let mut text = lines.next().unwrap_or_default();
    let columns = rows.first().map_or(0, Vec::len);
    text.push_str(&format!(
        "|{}\n",
        " --- |".to_owned() + &" ---: |".repeat(columns.saturating_sub(1))
    ));
    text.extend(lines);
    text
}

pub(super) fn escaped(text: &str) -> String {
    let mut escaped = String::new();
    for character in text.chars() {
        if matches!(
            character,
            '\\' | '|' | '`' | '*' | '_' | '[' | ']' | '<' | '>' | '&' | '$' | '~' | '#' | '!'
        ) {
            escaped.push('\\');
        }
        escaped.push(character);
    }
    escaped
}
