//! Comments: HTML to Markdown, directives to us.

use super::{Item, Problem, Scanner, Span};
use crate::document::directive::{self, Comment};

/// HTML whose inside no browser shows as text.
const OPAQUE: [&str; 4] = ["<pre", "<script", "<style", "<textarea"];

impl Scanner<'_> {
    /// `<!--` where the outline saw no HTML: still a comment after other HTML on the line, or if
    /// it ends in its paragraph. If not, it is shown as text.
    pub(super) fn loose_comment(&mut self) {
        let open = self.at;
        let close = self.comment_end.find(self.bytes, open + 2);
        let paragraph = self.blank_line.find(self.bytes, open);
        if let Some(close) = close
            && (open < self.html_until || paragraph.is_none_or(|blank| close < blank))
        {
            return self.closed_comment(close + 3);
        }
        if let Comment::Directives(..) | Comment::Misspelt(_) = directive::read(
            self.source,
            Span::new(open + 4, paragraph.unwrap_or(self.bytes.len())),
        ) {
            self.problem(
                Span::new(open, open + 4),
                "this comment does not end in its paragraph, so it is no comment",
                "close it with `-->`, without a blank line before, or begin it on its own line",
            );
        }
        self.at = open + 4;
    }

    /// A comment that ends at `end`.
    pub(super) fn closed_comment(&mut self, end: usize) {
        let span = Span::new(self.at, end);
        match self.directives(span) {
            Some(item) => {
                self.hand_over_prose(span.start);
                self.items.push(item);
                self.prose_from = end;
            }
            None => self.hidden.push(span),
        }
        self.at = end;
        self.forget_passed();
    }

    /// What a comment declares, if it is ours.
    pub(super) fn directives(&mut self, span: Span) -> Option<Item> {
        let body = Span::new(
            span.start + 4,
            span.end.saturating_sub(3).max(span.start + 4),
        );
        match directive::read(self.source, body) {
            Comment::Other => None,
            Comment::Misspelt(problem) => {
                self.problems.push(problem);
                None
            }
            Comment::Directives(clauses, problems) => {
                self.problems.extend(problems);
                Some(Item::Directives { clauses, span })
            }
        }
    }

    /// A block of HTML: comments are read in it, equations are not.
    pub(super) fn html_block(&mut self, span: Span) {
        let text = &self.source[self.at..span.end];
        let indent = text.len() - text.trim_start().len();
        let text = text.trim_start().to_ascii_lowercase();
        if text.starts_with("<!--") {
            self.at += indent;
            self.html_until = span.end;
            return self.block_comment(span.end);
        }
        if OPAQUE.iter().any(|tag| text.starts_with(tag)) {
            return self.hide_until(span.end);
        }
        let mut shown = self.at;
        while shown < span.end && self.at < span.end {
            let rest = &self.bytes[self.at..];
            if rest.starts_with(b"<!--") {
                if shown < self.at {
                    self.hidden.push(Span::new(shown, self.at));
                }
                match self.comment_end.find(self.bytes, self.at + 2) {
                    Some(close) => self.closed_comment(close + 3),
                    None => self.block_comment(span.end),
                }
                shown = self.at;
            } else if rest.starts_with(b"$$") {
                self.problems.push(Problem::new(
                    Span::new(self.at, self.at + 2),
                    "an equation in a block of HTML is not read",
                    "leave a blank line between the HTML and the equation",
                ));
                self.at += 2 + self.closing_in_html(span.end);
            } else {
                self.at += 1;
            }
        }
        if shown < self.at {
            self.hidden.push(Span::new(shown, self.at));
        }
        self.forget_passed();
    }

    /// How far behind a `$$` in HTML the one that closes it ends, if no comment begins before.
    fn closing_in_html(&self, until: usize) -> usize {
        let rest = self.bytes.get(self.at + 2..until).unwrap_or_default();
        let stop = (0..rest.len())
            .find(|&at| rest[at..].starts_with(b"$$") || rest[at..].starts_with(b"<!--"));
        stop.filter(|&at| rest[at] == b'$').map_or(0, |at| at + 2)
    }

    /// A comment that begins a block, which hides everything up to `end` if it is never closed.
    fn block_comment(&mut self, end: usize) {
        match self.comment_end.find(self.bytes, self.at + 2) {
            Some(close) => self.closed_comment(close + 3),
            None => {
                self.problem(
                    Span::new(self.at, self.at + 4),
                    "this comment is never closed: it hides all that follows",
                    "close it with `-->`",
                );
                self.hide_until(end);
            }
        }
    }
}
