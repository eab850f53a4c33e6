//! What is left to declare, as a `cradle.toml` to be completed.
//!
//! Beside several documents a declaration holds in all of them, so only that is proposed which all that speak of a symbol
//! leave to be said alike; the rest is a comment. Saved as it is, it changes no verdict.

use crate::algebra::Symbol;
use crate::derivation::{Derivation, Page};
use crate::dimension::{names_of, parse};

use super::declarations::{Clause, Listed, listed};
use super::{place, words};
use crate::sorted::Tree;

/// The symbols of all pages, and a table of what is left to declare. `files` are the documents as they are asked for; they
/// are listed where no configuration lists them already.
pub fn configuration(derivation: &Derivation, files: &[String]) -> String {
    let pages = listed(derivation);
    let mut text = String::new();
    for page in &pages {
        for line in &page.lines {
            text += &format!("# {}\n", place::one_line(line));
        }
        text += "#\n";
    }
    // One that is empty may just be being written.
    let says = |page: &Page| {
        page.beside
            .as_ref()
            .is_some_and(|own| !own.file.source.trim().is_empty())
    };
    let has_one = derivation.pages.iter().any(says);
    let proposes = pages.iter().any(|page| !page.clauses.is_empty());
    let files: Vec<String> = files
        .iter()
        .filter(|file| *file != "-" && !file.contains(['*', '?', '\\']))
        .map(|file| quoted(file))
        .collect();
    match has_one {
        true if !proposes => {}
        true => {
            text += "# There is a cradle.toml already: add to its `[symbols]` what stands below.\n"
        }
        false if files.is_empty() => {}
        false => text += &format!("\nfiles = [{}]\n", files.join(", ")),
    }
    let (rows, apart) = rows(derivation, &pages);
    if !rows.is_empty() {
        text += "\n[symbols]\n";
    }
    for line in rows.into_iter().map(|(_, row)| row).chain(apart) {
        text += &format!("{line}\n");
    }
    text
}

/// What a `cradle.toml` says, and below its `[symbols]` a row for each symbol of which it does not say anything yet, with their number.
/// Whatever is there stays as it is.
pub fn configuration_with(
    existing: &str,
    known: &[Symbol],
    derivation: &Derivation,
) -> (String, usize) {
    let (rows, _) = rows(derivation, &listed(derivation));
    let new = rows
        .into_iter()
        .filter(|(symbol, _)| !known.contains(symbol));
    let new: Vec<String> = new.map(|(_, row)| row).collect();
    if new.is_empty() {
        return (existing.to_owned(), 0);
    }
    let mut lines: Vec<&str> = existing.lines().collect();
    let is_header = |line: &&str| line.trim_start().starts_with('[');
    let table = lines.iter().position(|line| {
        line.trim().strip_prefix("[symbols]").is_some_and(|rest| {
            let rest = rest.trim_start();
            rest.is_empty() || rest.starts_with('#')
        })
    });
    let at = match table {
        Some(header) => {
            let next = lines[header + 1..].iter().position(is_header);
            let end = next.map_or(lines.len(), |length| header + 1 + length);
            let said = |line: &&str| !line.trim().is_empty() && !line.trim_start().starts_with('#');
            let last = lines[header..end].iter().rposition(said);
            header + last.unwrap_or(0) + 1
        }
        None => {
            lines.extend(["", "[symbols]"]);
            lines.len()
        }
    };
    let count = new.len();
    lines.splice(at..at, new.iter().map(String::as_str));
    (lines.join("\n") + "\n", count)
}

/// A row of the table for each symbol of which all pages that speak of it leave the same to be said; and what there is to say of the others.
fn rows(derivation: &Derivation, pages: &[Listed]) -> (Vec<(Symbol, String)>, Vec<String>) {
    let mut of_symbol: Tree<&Symbol, Vec<(usize, &Clause)>> = Tree::new();
    let mut order: Vec<&Symbol> = Vec::new();
    for (at, page) in pages.iter().enumerate() {
        for clause in &page.clauses {
            let all = of_symbol.entry(&clause.symbol).or_default();
            if all.is_empty() {
                order.push(&clause.symbol);
            }
            all.push((at, clause));
        }
    }
    let mut rows: Vec<(Symbol, String, String)> = Vec::new();
    let mut apart: Vec<String> = Vec::new();
    for symbol in order {
        let all = &of_symbol[symbol];
        let (_, first) = all[0];
        if all.iter().all(|(_, clause)| clause.text == first.text) {
            let row = format!("{} = {}", key(symbol.name()), quoted(&first.text));
            rows.push((symbol.clone(), row, remark(first)));
            continue;
        }
        let said = all.iter().map(|(at, clause)| {
            let path = &derivation.pages[*at].document.path;
            let text = if clause.is_known {
                clause.text.as_str()
            } else {
                "nothing"
            };
            format!("{text} in {path}")
        });
        let said = words::list(said.collect());
        apart.push(place::one_line(&format!(
            "# {}: the equations give {said}; declare it in the documents",
            symbol.name()
        )));
    }
    let width = rows.iter().filter(|(_, _, remark)| !remark.is_empty());
    let width = width
        .map(|(_, row, _)| row.chars().count())
        .max()
        .unwrap_or(0);
    let rows = rows.into_iter().map(|(symbol, row, remark)| {
        let row = match remark.is_empty() {
            true => row,
            false => format!("{row:<width$}  # {remark}"),
        };
        (symbol, row)
    });
    (rows.collect(), apart)
}

/// What the author should know of a proposal.
fn remark(clause: &Clause) -> String {
    if !clause.is_known {
        return "says nothing: put a dimension and a domain in its place".into();
    }
    let names = parse(&clause.text)
        .map(|own| names_of(&own))
        .unwrap_or_default();
    let others: Vec<String> = names
        .iter()
        .skip(1)
        .map(|name| name.to_lowercase())
        .collect();
    match others.is_empty() {
        true => String::new(),
        false => format!("or {}, which has the same dimension", others.join(", ")),
    }
}

/// A key of TOML.
fn key(name: &str) -> String {
    let bare = |c: char| c.is_ascii_alphanumeric() || matches!(c, '_' | '-');
    match !name.is_empty() && name.chars().all(bare) {
        true => name.to_owned(),
        false => quoted(name),
    }
}

/// A text of TOML, as plainly as can be.
fn quoted(text: &str) -> String {
    let plain = |without: &[char]| !text.contains(without) && !text.chars().any(char::is_control);
    if plain(&['"', '\\']) {
        return format!("\"{text}\"");
    }
    if plain(&['\'']) {
        return format!("'{text}'");
    }
    let mut escaped = String::new();
    for c in text.chars() {
        match c {
            '"' | '\\' => escaped.extend(['\\', c]),
            c if c.is_control() => escaped += &format!("\\u{:04X}", u32::from(c)),
            c => escaped.push(c),
        }
    }
    format!("\"{escaped}\"")
}
