//! The rows of a display, with what belongs to each.

use super::super::directive::trim;
use super::super::{Layout, Row, Span};
use super::ends::bracketed;
use super::names::Rows;

/// A row as it is found.
#[derive(Default)]
pub(super) struct Found {
    pub pieces: Vec<Span>,
    pub keys: Vec<String>,
    pub tag: Option<String>,
    pub unnumbered: bool,
    /// How far it counts equations on by itself.
    pub counted: i64,
    /// What stands before its mathematics: directives at these places, prose.
    pub before: Vec<Before>,
}

pub(super) enum Before {
    Directive(usize),
    Words(Span),
}

/// The rows of a display.
pub(super) fn rows(text: &str, body: Span, kind: Rows) -> Vec<Found> {
    let mut rows = vec![Found::default()];
    let (mut at, mut from, mut depth) = (body.start, body.start, 0_usize);
    let mut environments = 0_usize;
    // Ends a piece of the last row.
    fn cut(text: &str, rows: &mut [Found], from: usize, to: usize) {
        let piece = trim(text, Span::new(from, to.max(from)));
        if let (true, Some(row)) = (piece.start < piece.end, rows.last_mut()) {
            row.pieces.push(piece);
        }
    }
    while at < body.end {
        let rest = &text[at..body.end];
        let first = rest.as_bytes()[0];
        if first == b'%' {
            cut(text, &mut rows, from, at);
            if let Some(row) = rows.last_mut() {
                row.before.push(Before::Directive(at));
            }
            at += rest.find('\n').map_or(rest.len(), |length| length + 1);
            from = at;
            continue;
        }
        if first != b'\\' {
            depth = match first {
                b'{' => depth + 1,
                b'}' => depth.saturating_sub(1),
                _ => depth,
            };
            at += rest.chars().next().map_or(1, char::len_utf8);
            continue;
        }
        let command = &rest[1..];
        let letters = command
            .find(|c: char| !c.is_ascii_alphabetic())
            .unwrap_or(command.len());
        let name = &command[..letters];
        let after = at + 1 + letters.max(command.chars().next().map_or(0, char::len_utf8));
        let argument = |at: usize| {
            let rest = &text[at..body.end];
            let blank = rest.len() - rest.trim_start().len();
            let length = bracketed(&rest[blank..], '{', '}')?;
            let start = at + blank;
            Some((Span::new(start + 1, start + length - 1), start + length))
        };
        match name {
            "" if command.starts_with('\\')
                && depth == 0
                && environments == 0
                && kind != Rows::One =>
            {
                cut(text, &mut rows, from, at);
                at = row_end(&text[..body.end], after);
                from = at;
                if kind != Rows::Broken {
                    rows.push(Found::default());
                }
            }
            "begin" => {
                environments += 1;
                at = after;
            }
            "end" => {
                environments = environments.saturating_sub(1);
                at = after;
            }
            "label" | "tag" => {
                let starred = text[after..].starts_with('*');
                let Some((inside, end)) = argument(after + usize::from(starred)) else {
                    // The notation says what is wrong with it.
                    at = after;
                    continue;
                };
                cut(text, &mut rows, from, at);
                let inside = text[inside.range()].trim();
                if let Some(row) = rows.last_mut() {
                    match name {
                        "label" => row.keys.push(inside.to_owned()),
                        _ => row.tag = Some(bare(inside).to_owned()),
                    }
                }
                (at, from) = (end, end);
            }
            "addtocounter" | "stepcounter" | "refstepcounter" => {
                let by = |at| match name {
                    "addtocounter" => {
                        let (value, end) = argument(at)?;
                        Some((text[value.range()].trim().parse().ok()?, end))
                    }
                    _ => Some((1, at)),
                };
                let counter = argument(after);
                let counted = counter.and_then(|(own, end)| Some((own, by(end)?)));
                let Some((counter, (by, end))) = counted else {
                    at = after;
                    continue;
                };
                cut(text, &mut rows, from, at);
                if let Some(row) = rows.last_mut()
                    && text[counter.range()].trim() == "equation"
                {
                    row.counted = row.counted.saturating_add(by);
                }
                (at, from) = (end, end);
            }
            "notag" | "nonumber" | "displaybreak" | "allowdisplaybreaks" => {
                cut(text, &mut rows, from, at);
                if let (Some(row), true) = (rows.last_mut(), name.starts_with("no")) {
                    row.unnumbered = true;
                }
                (at, from) = (after, after);
                if !name.starts_with("no") {
                    at = row_end(&text[..body.end], after);
                    from = at;
                }
            }
            "intertext" | "shortintertext" => {
                let Some((inside, end)) = argument(after) else {
                    at = after;
                    continue;
                };
                cut(text, &mut rows, from, at);
                // It ends the row that it stands in, as if `\\\\` stood before it.
                if rows.last().is_some_and(|row| !row.pieces.is_empty()) {
                    rows.push(Found::default());
                }
                if let Some(row) = rows.last_mut() {
                    row.before.push(Before::Words(inside));
                }
                (at, from) = (end, end);
            }
            _ => at = after,
        }
    }
    cut(text, &mut rows, from, body.end);
    rows
}

/// The rows of an environment that stands in Markdown, where nothing is counted.
pub(in crate::document) fn uncounted(text: &str, body: Span, kind: Rows) -> Layout {
    let rows = rows(text, body, kind).into_iter();
    let rows = rows.filter(|row| !row.pieces.is_empty());
    Layout {
        rows: rows
            .map(|row| Row {
                pieces: row.pieces,
                number: row.tag,
                keys: row.keys,
            })
            .collect(),
        columns: kind == Rows::Columns,
        group: None,
        obstacle: None,
    }
}

/// A number without its parentheses and dollars.
fn bare(tag: &str) -> &str {
    let tag = tag.trim_matches('$').trim();
    let inside = tag.strip_prefix('(').and_then(|tag| tag.strip_suffix(')'));
    inside.unwrap_or(tag)
}

/// Past the star and the length after `\\`.
fn row_end(text: &str, mut at: usize) -> usize {
    at += usize::from(text[at..].starts_with('*'));
    let rest = &text[at..];
    if let Some((length, _)) = rest.strip_prefix('[').and_then(|rest| rest.split_once(']')) {
        let plain = |c: char| c.is_ascii_alphanumeric() || ".-+\\ ".contains(c);
        if length.len() < 24
            && length.chars().all(plain)
            && length.contains(|c: char| c.is_ascii_digit())
        {
            at += length.len() + 2;
        }
    }
    at
}
