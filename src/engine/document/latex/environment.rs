//! `\begin` and `\end` in text.

use super::super::Span;
use super::names::{self, UNREAD};
use super::scan::{Scanner, Sub};
use crate::document::Inline;

/// Environments in which nothing is said: pictures and lists of literature.
const SILENT: &[&str] = &[
    "tikzpicture",
    "pgfpicture",
    "picture",
    "thebibliography",
    "circuitikz",
];

impl Scanner<'_> {
    /// `\begin{…}` in text or in the preamble.
    pub(super) fn begin(&mut self, open: usize) {
        let Some(name) = self.group() else { return };
        let name = self.text[name.range()].trim();
        if name == "document" {
            self.preamble = false;
            self.prose_from = self.at;
            (self.inline, self.hidden) = (Vec::new(), Vec::new());
            return;
        }
        if self.preamble {
            return;
        }
        self.depth = 0;
        let plain = name.trim_end_matches('*');
        if let Some(rows) = names::display(plain) {
            return self.environment(open, name, rows);
        }
        match plain {
            "subequations" => {
                self.catch_up(open);
                let (number, equation, format) = self.numbering.begin_sub();
                self.subs.push(Sub {
                    number,
                    keys: Vec::new(),
                    equation,
                    format,
                });
            }
            "math" => {
                let close = self
                    .rest()
                    .find("\\end{math}")
                    .map(|length| self.at + length);
                let Some(close) = close else {
                    self.problem(
                        Span::new(open, self.at),
                        "this `math` is never ended",
                        "end it with `\\end{math}`",
                    );
                    return;
                };
                let body = Span::new(self.at, close);
                self.at = close + "\\end{math}".len();
                self.inline.push(Inline {
                    span: Span::new(open, self.at),
                    body,
                });
                return;
            }
            "appendix" => self.numbering.appendix(),
            "appendices" => self.numbering.begin_appendices(),
            _ if SILENT.contains(&plain) => {
                let end = format!("\\end{{{name}}}");
                match self.rest().find(&end) {
                    Some(length) => self.at += length + end.len(),
                    None => self.problem(
                        Span::new(open, self.at),
                        format!("this `{name}` is never ended"),
                        "end it",
                    ),
                }
            }
            _ if UNREAD.contains(&name) || UNREAD.contains(&plain) => self.unread(open, name),
            _ => self.options(),
        }
        self.hide(open);
    }

    pub(super) fn end(&mut self, open: usize) {
        let Some(name) = self.group() else { return };
        self.depth = 0;
        match self.text[name.range()].trim() {
            "subequations" => {
                if let Some(sub) = self.subs.pop() {
                    self.numbering.end_sub(sub.equation, sub.format);
                }
            }
            "appendices" => self.numbering.end_appendices(),
            "document" => {
                self.hand_over_prose(open);
                self.at = self.bytes.len();
                self.prose_from = self.at;
                return;
            }
            name if names::display(name.trim_end_matches('*')).is_some() => {
                let message = format!("this ends `{name}`, which was not begun here");
                self.problem(
                    Span::new(open, self.at),
                    message,
                    "begin it, or leave this out",
                );
            }
            _ => {}
        }
        self.hide(open);
    }
}
