//! Tables of the text, in cells: rows between `|` in Markdown, a `tabular` in LaTeX.

use super::{Document, Inline, Span};

/// Where tables of LaTeX begin and end: `tabular`, `tabular*`, `tabularx`, `longtable`.
const BEGINNINGS: [&str; 2] = ["\\begin{tabular", "\\begin{longtable"];
const ENDS: [&str; 2] = ["\\end{tabular", "\\end{longtable"];
/// No table is looked through further.
const MOST_ROWS: usize = 200;
/// A table with more columns lists measurements, and no quantities.
const MOST_CELLS: usize = 8;

/// A row of a table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TableRow {
    /// Its cells.
    pub cells: Vec<Cell>,
    /// What heads each of its columns.
    pub heads: Vec<Cell>,
}

/// A cell of a table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cell {
    /// Where it stands.
    pub span: Span,
    /// The mathematics in it.
    pub math: Vec<Inline>,
    /// What stands around that.
    pub words: String,
}

impl Document {
    /// The rows of its tables below their heads, in source order.
    pub fn table_rows(&self) -> Vec<TableRow> {
        let mut found = Vec::new();
        if !self.may_have_tables() {
            return found;
        }
        let inline: Vec<Inline> = self.inline().copied().collect();
        for rows in self.tables(&inline) {
            let mut rows = rows
                .into_iter()
                .filter(|cells| !is_line(&self.source, cells));
            let Some(heads) = rows.next().map(|cells| self.cells(cells, &inline)) else {
                continue;
            };
            // A table without a head begins with its first row.
            found.push(TableRow {
                cells: heads.clone(),
                heads: Vec::new(),
            });
            found.extend(rows.take(MOST_ROWS).map(|cells| TableRow {
                cells: self.cells(cells, &inline),
                heads: heads.clone(),
            }));
        }
        found.retain(|row| (2..=MOST_CELLS).contains(&row.cells.len()));
        found
    }

    /// A look that costs little: most documents have none.
    fn may_have_tables(&self) -> bool {
        match self.is_latex {
            true => BEGINNINGS.iter().any(|own| self.source.contains(own)),
            false => self.source.lines().any(is_row),
        }
    }

    /// The tables, each as rows of cells.
    fn tables(&self, inline: &[Inline]) -> Vec<Vec<Vec<Span>>> {
        let source = &*self.source;
        let mut tables = Vec::new();
        if self.is_latex {
            let (begins, ends) = (places(source, &BEGINNINGS), places(source, &ENDS));
            let mut at = 0;
            for begin in begins {
                if begin < at {
                    continue;
                }
                let end = ends.get(ends.partition_point(|end| *end < begin));
                let end = end.copied().unwrap_or(source.len());
                let rows = self.parted(Span::new(begin, end), "\\\\", inline);
                let cells = rows.into_iter().map(|row| self.parted(row, "&", inline));
                tables.push(cells.collect());
                at = end;
            }
            return tables;
        }
        let (mut at, mut open) = (0, false);
        for line in source.split_inclusive('\n') {
            let span = Span::new(at, at + line.trim_end().len());
            at += line.len();
            if !is_row(line) {
                open = false;
                continue;
            }
            let mut cells = self.parted(span, "|", inline);
            // Before the first sign and behind the last one there is nothing.
            cells.remove(0);
            if cells
                .last()
                .is_some_and(|own| source[own.range()].trim().is_empty())
            {
                cells.pop();
            }
            match tables.last_mut() {
                Some(rows) if open => rows.push(cells),
                _ => tables.push(vec![cells]),
            }
            open = true;
        }
        tables
    }

    /// A piece of the text, parted by a sign that stands in no mathematics and behind no backslash.
    fn parted(&self, span: Span, sign: &str, inline: &[Inline]) -> Vec<Span> {
        let text = &self.source[span.range()];
        let mut parts = Vec::new();
        let mut start = span.start;
        for (at, _) in text.match_indices(sign) {
            let at = span.start + at;
            let next = inline.partition_point(|own| own.span.end <= at);
            let is_within = inline.get(next).is_some_and(|own| own.span.start < at);
            if is_within || self.source[..at].ends_with('\\') {
                continue;
            }
            parts.push(Span::new(start, at));
            start = at + sign.len();
        }
        parts.push(Span::new(start, span.end));
        parts
    }

    fn cells(&self, spans: Vec<Span>, inline: &[Inline]) -> Vec<Cell> {
        let cells = spans.into_iter().map(|span| self.cell(span, inline));
        cells.collect()
    }

    fn cell(&self, span: Span, inline: &[Inline]) -> Cell {
        let mut words = String::new();
        let mut math = Vec::new();
        let mut at = span.start;
        let first = inline.partition_point(|own| own.span.start < span.start);
        let within = inline[first..].iter();
        for own in within.take_while(|own| own.span.end <= span.end) {
            words.push_str(&self.source[at..own.span.start]);
            math.push(*own);
            at = own.span.end;
        }
        words.push_str(&self.source[at..span.end]);
        let words = without_rules(&words).trim().to_owned();
        Cell { span, math, words }
    }
}

/// Whether a line is one of a table in Markdown.
fn is_row(line: &str) -> bool {
    line.trim_start().starts_with('|')
}

/// Where these stand, in order.
fn places(source: &str, of: &[&str]) -> Vec<usize> {
    let all = of.iter().flat_map(|own| source.match_indices(own));
    let mut all: Vec<usize> = all.map(|own| own.0).collect();
    all.sort_unstable();
    all
}

/// Whether a row is the line below a head: `|---|:-:|`.
fn is_line(source: &str, cells: &[Span]) -> bool {
    let is_rule = |own: &Span| {
        let text = source[own.range()].trim();
        text.contains('-') && text.bytes().all(|byte| matches!(byte, b'-' | b':'))
    };
    cells.iter().all(is_rule)
}

/// A cell without the rules that LaTeX draws before it, and without what begins the table.
fn without_rules(text: &str) -> &str {
    let mut text = text.trim_start();
    while let Some(rest) = text.strip_prefix('\\') {
        let name = rest.bytes().take_while(u8::is_ascii_alphabetic).count();
        let is_rule = rest[..name].ends_with("rule") || &rest[..name] == "hline";
        text = match (&rest[..name], rest[name..].rsplit_once('}')) {
            ("begin", Some((_, rest))) => rest.trim_start(),
            _ if is_rule => rest[name..].trim_start(),
            _ => return text,
        };
    }
    text
}
