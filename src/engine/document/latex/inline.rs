//! Inline mathematics. Only what prose supposes is read from it.

use super::super::Span;
use super::ends::inline_end;
use super::scan::Scanner;
use crate::document::Inline;

impl Scanner<'_> {
    pub(super) fn inline_dollar(&mut self) {
        let open = self.at;
        match inline_end(self.bytes, open + 1, b"$") {
            Some(close) => {
                self.inline_found(Span::new(open, close + 1), Span::new(open + 1, close))
            }
            None => {
                self.problem(
                    Span::new(open, open + 1),
                    "this `$` is never closed in its paragraph",
                    "close it, or write `\\$` for the sign",
                );
                self.at = open + 1;
            }
        }
    }

    pub(super) fn inline_parenthesis(&mut self, open: usize) {
        match inline_end(self.bytes, open + 2, b"\\)") {
            Some(close) => {
                self.inline_found(Span::new(open, close + 2), Span::new(open + 2, close))
            }
            None => {
                self.problem(
                    Span::new(open, open + 2),
                    "this `\\(` is never closed in its paragraph",
                    "close it with `\\)`",
                );
                self.at = open + 2;
            }
        }
    }

    pub(super) fn inline_found(&mut self, span: Span, body: Span) {
        self.inline.push(Inline { span, body });
        self.at = span.end;
    }
}
