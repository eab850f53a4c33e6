//! Displays: where each ends, and its rows with their numbers and keys.

use super::super::directive::trim;
use super::super::prose;
use super::super::{Item, Layout, Problem, Row, Span};
use super::names::{self, Rows};
use super::scan::{Scanner, bracketed, ends_paragraph};

/// A row as it is found.
#[derive(Default)]
struct Found {
    pieces: Vec<Span>,
    keys: Vec<String>,
    tag: Option<String>,
    unnumbered: bool,
    /// What stands before its mathematics: directives at these places, prose.
    before: Vec<Before>,
}

enum Before {
    Directive(usize),
    Words(Span),
}

impl Scanner<'_> {
    /// `$$ … $$`
    pub(super) fn dollars(&mut self) {
        let open = self.at;
        match dollars_end(self.bytes, open + 2) {
            Ok(close) => {
                self.at = close + 2;
                let body = Span::new(open + 2, close);
                self.display(Span::new(open, close + 2), body, Rows::One, false);
            }
            Err(stop) => self.unended(Span::new(open, open + 2), stop, "`$$`", "`$$`"),
        }
    }

    /// `\[ … \]`
    pub(super) fn bracket(&mut self, open: usize) {
        match bracket_end(self.bytes, open + 2) {
            Ok(close) => {
                self.at = close + 2;
                let body = Span::new(open + 2, close);
                self.display(Span::new(open, close + 2), body, Rows::One, false);
            }
            Err(stop) => self.unended(Span::new(open, open + 2), stop, "`\\[`", "`\\]`"),
        }
    }

    /// `\begin{align} … \end{align}`; `self.at` is behind the beginning.
    pub(super) fn environment(&mut self, open: usize, name: &str, rows: Rows) {
        let plain = name.trim_end_matches('*');
        let begin = Span::new(open, self.at);
        if matches!(plain, "alignat" | "xalignat" | "xxalignat") {
            self.group();
        } else if self.rest().starts_with("[") && matches!(plain, "multline" | "gather" | "align") {
            self.options();
        }
        let from = self.at;
        match environment_end(self.text, from, name) {
            Ok((close, after)) => {
                self.at = after;
                let numbered = plain == name && plain != "displaymath";
                self.display(
                    Span::new(open, after),
                    Span::new(from, close),
                    rows,
                    numbered,
                );
            }
            Err(stop) => {
                let end = format!("`\\end{{{name}}}`");
                self.unended(begin, stop, &format!("`{name}`"), &end);
            }
        }
    }

    /// An environment of mathematics that is not read.
    pub(super) fn unread(&mut self, open: usize, name: &str) {
        let span = Span::new(open, self.at);
        self.problem(
            span,
            format!("the environment `{name}` is not read here"),
            "write the equation in `equation`, `align`, `gather` or `multline`",
        );
        let inner = [
            "aligned",
            "alignedat",
            "gathered",
            "split",
            "cases",
            "multlined",
        ];
        if !name.ends_with('*') && !inner.contains(&name) && !name.ends_with("matrix") {
            self.numbering.lose();
        }
        self.at = match environment_end(self.text, self.at, name) {
            Ok((_, after)) => after,
            Err(stop) => stop.max(self.at),
        };
    }

    /// Something is wrong with where a display ends: what follows up to `stop` is covered by the message.
    fn unended(&mut self, begin: Span, stop: usize, what: &str, close: &str) {
        self.hand_over_prose(begin.start);
        if !what.starts_with("`$") && !what.starts_with("`\\[") && !what.ends_with("*`") {
            self.numbering.lose();
        }
        self.problem(
            begin,
            format!("this {what} is never closed"),
            &format!("close the equation with {close}"),
        );
        self.at = stop.max(begin.end);
        self.prose_again();
    }

    fn display(&mut self, span: Span, body: Span, rows: Rows, numbered: bool) {
        self.catch_up(span.start);
        self.hand_over_prose(span.start);
        self.prose_again();
        let found = self::rows(self.text, body, rows);
        let empty = found.iter().all(|row| row.pieces.is_empty());
        let obstacle = self.obstacle(span);
        let group = self.subs.last().map(|sub| {
            let keys = sub.keys.clone();
            (sub.number.clone().unwrap_or_default(), keys)
        });
        self.keys
            .extend(group.iter().flat_map(|(_, keys)| keys.iter().cloned()));
        if empty {
            if numbered {
                self.numbering.next_equation();
            }
            return match obstacle {
                Some(problem) => self.problems.push(problem),
                None => self.problem(
                    span,
                    "this display is empty",
                    "write the equation, or remove it",
                ),
            };
        }
        let mut layout = Layout {
            columns: rows == Rows::Columns,
            group: group.filter(|_| numbered),
            obstacle,
            ..Layout::default()
        };
        let mut start = span.start;
        for mut row in found {
            let number = match row.tag.take() {
                Some(tag) => Some(tag),
                None if numbered && !row.unnumbered => self.numbering.next_equation(),
                None => None,
            };
            self.keys.extend(row.keys.iter().cloned());
            if !row.before.is_empty() && !row.pieces.is_empty() {
                let first = row.pieces[0].start;
                self.finish(Span::new(start, first), &mut layout);
                start = first;
                self.say(std::mem::take(&mut row.before));
            }
            if !row.pieces.is_empty() {
                layout.rows.push(Row {
                    pieces: row.pieces,
                    number,
                    keys: row.keys,
                });
            }
        }
        self.finish(Span::new(start, span.end), &mut layout);
        self.prose_again();
    }

    /// Hands over the rows so far as a display.
    fn finish(&mut self, span: Span, layout: &mut Layout) {
        let rows = std::mem::take(&mut layout.rows);
        let pieces = || rows.iter().flat_map(|row| &row.pieces);
        let Some(body) = pieces().copied().reduce(Span::to) else {
            return;
        };
        let layout = Layout {
            rows,
            ..layout.clone()
        };
        self.items.push(Item::Display {
            span: Span::new(span.start.min(body.start), span.end.max(body.end)),
            body,
            layout: Some(Box::new(layout)),
        });
    }

    /// What stands before a row.
    fn say(&mut self, before: Vec<Before>) {
        for said in before {
            match said {
                Before::Directive(at) => drop(self.directive(at)),
                Before::Words(span) => {
                    let prose = prose::read(self.text, span, &[], &[]);
                    self.items.push(Item::Prose(prose));
                }
            }
        }
    }

    /// What was found amiss inside a display: the first of it hinders reading, the rest is told.
    fn obstacle(&mut self, span: Span) -> Option<Problem> {
        let mut inside: Vec<Problem> = Vec::new();
        let from = self.amiss.partition_point(|p| p.span.start < span.start);
        let to = self.amiss.partition_point(|p| p.span.start < span.end);
        inside.extend(self.amiss.drain(from..to));
        if inside.is_empty() {
            let at = self
                .obstacles
                .partition_point(|p| p.span.start < span.start);
            let first = self.obstacles.get(at).filter(|p| p.span.start < span.end);
            return first.cloned();
        }
        let rest = inside.split_off(1);
        self.problems.extend(rest);
        inside.pop()
    }
}

/// The rows of a display.
fn rows(text: &str, body: Span, kind: Rows) -> Vec<Found> {
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

/// Whether text begins with what cannot stand in a display.
pub(super) fn stops(text: &str) -> bool {
    if let Some(rest) = text.strip_prefix("\\begin{") {
        let name = rest.split('}').next().unwrap_or_default();
        return names::display(name.trim_end_matches('*')).is_some() || name == "document";
    }
    if text.starts_with("\\end{document}") {
        return true;
    }
    let Some(command) = text.strip_prefix('\\') else {
        return false;
    };
    let letters = command.find(|c: char| !c.is_ascii_alphabetic());
    names::heading(&command[..letters.unwrap_or(command.len())]).is_some()
}

/// The `$$` that closes; or where the search ends.
fn dollars_end(bytes: &[u8], from: usize) -> Result<usize, usize> {
    let (mut at, mut depth, mut words) = (from, 0_usize, false);
    loop {
        match bytes.get(at..).unwrap_or_default() {
            [] => return Err(bytes.len()),
            [b'$', b'$', ..] if !(words && depth > 0) => return Ok(at),
            [b'$', ..] if depth > 0 => {
                words = !words;
                at += 1;
            }
            [b'$', ..] => return Err(at),
            tail @ [b'\n', ..] if ends_paragraph(tail) => return Err(at),
            tail @ [b'\\', b'b' | b'e' | b's' | b'c' | b'p', ..] if stops(as_text(tail)) => {
                return Err(at);
            }
            [b'\\', b'[', ..] => return Err(at),
            [b'\\', ..] => at += 2,
            [b'{', ..] => (depth, at) = (depth + 1, at + 1),
            [b'}', ..] => (depth, at) = (depth.saturating_sub(1), at + 1),
            _ => at += 1,
        }
    }
}

/// The `\]` that closes; or where the search ends.
fn bracket_end(bytes: &[u8], from: usize) -> Result<usize, usize> {
    let mut at = from;
    loop {
        match bytes.get(at..).unwrap_or_default() {
            [] => return Err(bytes.len()),
            [b'\\', b']', ..] => return Ok(at),
            [b'$', b'$', ..] | [b'\\', b'[', ..] => return Err(at),
            tail @ [b'\n', ..] if ends_paragraph(tail) => return Err(at),
            tail @ [b'\\', b'b' | b'e' | b's' | b'c' | b'p', ..] if stops(as_text(tail)) => {
                return Err(at);
            }
            [b'\\', ..] => at += 2,
            _ => at += 1,
        }
    }
}

/// Enough of the text at some bytes to know a command: they begin with one, so on the bound of a character.
pub(super) fn as_text(tail: &[u8]) -> &str {
    let tail = &tail[..tail.len().min(40)];
    match std::str::from_utf8(tail) {
        Ok(text) => text,
        Err(error) => std::str::from_utf8(&tail[..error.valid_up_to()]).unwrap_or_default(),
    }
}

/// The `\end` of an environment, and the place behind it; or where the search ends.
pub(in crate::document) fn environment_end(
    text: &str,
    from: usize,
    name: &str,
) -> Result<(usize, usize), usize> {
    let bytes = text.as_bytes();
    let mut open: Vec<&str> = Vec::new();
    let mut at = from;
    loop {
        match bytes.get(at..).unwrap_or_default() {
            [] => return Err(bytes.len()),
            [b'$', b'$', ..] | [b'\\', b'[', ..] => return Err(at),
            [b'%', rest @ ..] => {
                let line = rest.iter().position(|byte| *byte == b'\n');
                at += line.map_or(rest.len(), |line| line) + 1;
            }
            tail @ [b'\\', b'b' | b'e' | b's' | b'c' | b'p', ..] => {
                if stops(as_text(tail)) {
                    return Err(at);
                }
                let rest = &text[at..];
                let named = |command: &str| -> Option<&str> {
                    let rest = rest.strip_prefix(command)?;
                    let end = rest.bytes().take(64).position(|byte| byte == b'}')?;
                    rest.get(..end)
                };
                if let Some(inner) = named("\\begin{") {
                    open.push(inner);
                } else if let Some(ended) = named("\\end{") {
                    match open.pop() {
                        None if ended.trim() == name => {
                            return Ok((at, at + "\\end{}".len() + ended.len()));
                        }
                        Some(begun) if begun == ended => {}
                        _ => return Err(at),
                    }
                }
                at += 2;
            }
            [b'\\', ..] => at += 2,
            _ => at += 1,
        }
    }
}
