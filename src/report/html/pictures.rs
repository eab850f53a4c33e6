//! Figures and tables that somebody else has made, put on the page.

use super::words::scripted;
use crate::notation::escape;

/// What is shown besides the documents; nothing, unless somebody has something.
#[derive(Clone, Debug, Default)]
pub struct Pictures {
    /// What the page is called, if not like its documents.
    pub title: Option<String>,
    /// The figures, in order.
    pub figures: Vec<Picture>,
    /// The tables, in order.
    pub tables: Vec<Table>,
}

/// A figure.
#[derive(Clone, Debug)]
pub struct Picture {
    /// An `<svg>` element whose text is escaped already, and whose identifiers no other figure has.
    pub svg: String,
    /// The same for a narrow screen.
    pub narrow: String,
    /// What is said below it, as HTML whose text is escaped already.
    pub caption: String,
}

/// A table of text.
#[derive(Clone, Debug)]
pub struct Table {
    /// What it shows.
    pub title: String,
    /// The names of the columns.
    pub head: Vec<String>,
    /// The cells, row by row; the first of each names its row.
    pub rows: Vec<Vec<String>>,
    /// What is to be said of it.
    pub notes: Vec<String>,
}

impl Pictures {
    pub(super) fn is_empty(&self) -> bool {
        self.figures.is_empty() && self.tables.is_empty()
    }

    pub(super) fn markup(&self) -> String {
        if self.is_empty() {
            return String::new();
        }
        let mut text = String::from(
            "<section id=\"figures\" aria-labelledby=\"figures-title\">\n<h2 id=\"figures-title\">Figures and tables</h2>\n",
        );
        for figure in &self.figures {
            text += &figure.markup();
        }
        self.tables.iter().for_each(|table| text += &table.markup());
        text + "</section>\n"
    }
}

impl Picture {
    fn markup(&self) -> String {
        format!(
            "<figure>\n<div class=\"drawing close broad\">\n{}</div>\n<div class=\"drawing close slim\">\n{}</div>\n\
             <figcaption>{}</figcaption>\n</figure>\n",
            self.svg, self.narrow, self.caption
        )
    }
}

impl Table {
    fn markup(&self) -> String {
        let mut text = format!(
            "<div class=\"scroll\"><table>\n<caption>{}</caption>\n<thead><tr>",
            escape(&self.title)
        );
        for name in &self.head {
            text += &format!("<th scope=\"col\">{}</th>", scripted(name));
        }
        text += "</tr></thead>\n<tbody>\n";
        for row in &self.rows {
            text += "<tr>";
            for (at, cell) in row.iter().enumerate() {
                text += &match at {
                    0 => format!("<th scope=\"row\">{}</th>", escape(cell)),
                    _ => format!("<td>{}</td>", escape(cell)),
                };
            }
            text += "</tr>\n";
        }
        text += "</tbody>\n</table></div>\n";
        for note in &self.notes {
            text += &format!("<p class=\"note\">{}</p>\n", scripted(note));
        }
        text
    }
}
