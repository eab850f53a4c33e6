//! The rows of an environment within a display: one number for all, and steps one after another.
//!
//! `aligned` and its like have one number however many rows they have. Rows that say something of their own are equations
//! that share it, each following the one before, and who cites the number cites all of them.

use crate::document::Span;
use crate::notation::Statement;

use super::equation::Among;
use super::rows::Part;

/// The environments whose rows are steps. Those of `cases` hold together or are alternatives.
const NESTED: &[&str] = &["aligned", "alignedat", "gathered", "split"];

/// Nobody writes more steps below one number; each is judged from those before it.
const MOST_ROWS: usize = 64;

/// The equations of a display that is one such environment and no more than that.
pub(super) fn by_rows(source: &str, display: Part) -> Vec<Part> {
    match &display.statements {
        Ok(statements) if is_nested(&source[display.body.range()]) => {
            let rows = rows(source, statements);
            if !(2..=MOST_ROWS).contains(&rows.len()) {
                return vec![display];
            }
            let all = statements.len();
            let row = |(before, row): (usize, &[Statement])| {
                let span = row.iter().map(|own| own.span).reduce(Span::to);
                Part {
                    tag: display.tag.clone(),
                    keys: display.keys.clone(),
                    group: display.group.clone(),
                    body: span.unwrap_or(display.body),
                    statements: Ok(row.to_vec()),
                    continues: display.continues,
                    among: Some(Among { before, all }),
                }
            };
            rows.into_iter().map(row).collect()
        }
        _ => vec![display],
    }
}

/// Whether a display begins with an environment of [`NESTED`], and has no other.
fn is_nested(display: &str) -> bool {
    const BEGIN: &str = "\\begin{";
    let Some(inside) = display.trim_start().strip_prefix(BEGIN) else {
        return false;
    };
    let is_known = |name: &&str| {
        let rest = inside.strip_prefix(*name);
        rest.is_some_and(|rest| rest.starts_with('}'))
    };
    NESTED.iter().any(is_known) && !inside.contains(BEGIN)
}

/// The statements by the rows they begin in, each row with the number of those before it.
fn rows<'a>(source: &str, statements: &'a [Statement]) -> Vec<(usize, &'a [Statement])> {
    let begins_row = |pair: &[Statement]| {
        let between = pair[0].span.end..pair[1].span.start;
        source
            .get(between)
            .is_some_and(|text| text.contains("\\\\"))
    };
    let ends = (1..statements.len()).filter(|&at| begins_row(&statements[at - 1..=at]));
    let mut rows = Vec::new();
    let mut start = 0;
    for end in ends.chain([statements.len()]) {
        rows.push((start, &statements[start..end]));
        start = end;
    }
    rows
}
