//! Rows and cells: `aligned`, `cases`, matrices, and a formula of several rows.

use super::line::Line;
use super::{DEEPEST, Ends, Setter};

/// How an environment is laid out.
struct Layout {
    open: &'static str,
    close: &'static str,
    /// The alignment of each column, the last one for all that follow; centred where there is none.
    columns: &'static [&'static str],
    class: &'static str,
}

impl Layout {
    const ALIGNED: Layout = Layout {
        open: "",
        close: "",
        columns: &["r", "l"],
        class: " class=\"aligned\" displaystyle=\"true\"",
    };

    fn of(name: &str) -> Layout {
        let fenced = |open, close| Layout {
            open,
            close,
            columns: &[],
            class: "",
        };
        match name.trim_end_matches('*') {
            "pmatrix" => fenced("(", ")"),
            "bmatrix" => fenced("[", "]"),
            "Bmatrix" => fenced("{", "}"),
            "vmatrix" => fenced("|", "|"),
            "Vmatrix" => fenced("‖", "‖"),
            "matrix" | "smallmatrix" | "array" | "tabular" | "gathered" | "gather" | "multline" => {
                fenced("", "")
            }
            "cases" | "dcases" => Layout {
                open: "{",
                columns: &["l", "l"],
                class: " class=\"cases\"",
                ..fenced("", "")
            },
            "rcases" => Layout {
                close: "}",
                columns: &["l", "l"],
                class: " class=\"cases\"",
                ..fenced("", "")
            },
            _ => Layout::ALIGNED,
        }
    }

    /// The alignment of a column; of pairs of columns, each is like the first.
    fn column(&self, at: usize) -> Option<&'static str> {
        let count = self.columns.len();
        self.columns.get(at.checked_rem(count)?).copied()
    }
}

impl Setter<'_> {
    /// An environment, behind its `\begin`.
    pub(super) fn environment(&mut self) -> String {
        let name = self.raw();
        let mut specified = Vec::new();
        match name.trim_end_matches('*') {
            "array" | "tabular" => {
                self.options();
                specified = self.raw().chars().filter_map(aligned).collect();
            }
            "alignedat" | "alignat" => {
                self.raw();
            }
            "aligned" | "gathered" | "split" => self.options(),
            _ => {}
        }
        if self.depth >= DEEPEST {
            return String::new();
        }
        let layout = Layout::of(name);
        self.environments += 1;
        let rows = self.nested(|own| own.rows(Ends::Cell));
        self.environments -= 1;
        if self.take("\\end") {
            self.raw();
        }
        let table = table(rows, |at| match specified.is_empty() {
            true => layout.column(at),
            false => specified.get(at).copied(),
        });
        let fence = |shown: &str, form: &str| match shown {
            "" => String::new(),
            shown => format!("<mo form=\"{form}\" stretchy=\"true\">{shown}</mo>"),
        };
        match table {
            Table::One(line) => format!("<mrow>{line}</mrow>"),
            Table::Several(rows) => format!(
                "<mrow>{}<mtable{}>{rows}</mtable>{}</mrow>",
                fence(layout.open, "prefix"),
                layout.class,
                fence(layout.close, "postfix")
            ),
        }
    }

    /// A whole formula, which may go over several rows.
    pub(super) fn formula(&mut self) -> String {
        if !self.rest.contains("\\\\") {
            return self.line(Ends::Whole, false).markup;
        }
        self.environments += 1;
        let rows = self.rows(Ends::Rows);
        self.environments -= 1;
        match table(rows, |at| Layout::ALIGNED.column(at)) {
            Table::One(line) => line,
            Table::Several(rows) => {
                format!("<mtable{}>{rows}</mtable>", Layout::ALIGNED.class)
            }
        }
    }

    /// Rows of cells, up to what ends them.
    fn rows(&mut self, ends: Ends) -> Vec<Vec<Line>> {
        let mut rows = vec![Vec::new()];
        loop {
            let goes_on = rows.last().is_some_and(|row: &Vec<Line>| !row.is_empty());
            let cell = self.line(ends, goes_on);
            if let Some(row) = rows.last_mut() {
                row.push(cell);
            }
            if self.take("&") {
                continue;
            }
            if !self.take("\\\\") {
                break;
            }
            self.take("*");
            self.options();
            rows.push(Vec::new());
        }
        rows.retain(|row| row.iter().any(|cell| !cell.is_empty()));
        rows
    }
}

/// What rows come to.
enum Table {
    /// A single one, which needs no table.
    One(String),
    Several(String),
}

fn table(rows: Vec<Vec<Line>>, column: impl Fn(usize) -> Option<&'static str>) -> Table {
    if rows.len() < 2 && rows.iter().all(|row| row.len() < 3) {
        let cells = rows.into_iter().flatten();
        return Table::One(cells.map(|cell| cell.markup).collect());
    }
    let cell = |(at, cell): (usize, Line)| match column(at) {
        Some(side) => format!("<mtd class=\"{side}\">{}</mtd>", cell.markup),
        None => format!("<mtd>{}</mtd>", cell.markup),
    };
    let row = |row: Vec<Line>| {
        let cells: String = row.into_iter().enumerate().map(cell).collect();
        format!("<mtr>{cells}</mtr>")
    };
    Table::Several(rows.into_iter().map(row).collect())
}

/// The alignment that a letter of `\begin{array}{lcr}` asks for.
fn aligned(letter: char) -> Option<&'static str> {
    match letter {
        'l' => Some("l"),
        'r' => Some("r"),
        'c' => Some("c"),
        _ => None,
    }
}
