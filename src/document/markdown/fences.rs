//! `$$`, `\[`, `$`, `\(`, the `math` code fence and bare environments.

use super::{Inline, Item, Scanner, Span};

/// Environments that LaTeX displays, without their star.
const DISPLAYED: [&str; 11] = [
    "equation",
    "align",
    "alignat",
    "gather",
    "multline",
    "eqnarray",
    "flalign",
    "displaymath",
    "math",
    "dmath",
    "subequations",
];

/// Finds the next place that matches. The answer is kept: asking again from further on costs
/// nothing until that place is passed, so a scan that asks everywhere still takes linear time.
pub(super) struct Finder {
    matches: fn(&[u8]) -> bool,
    answer: Option<(usize, Option<usize>)>,
}

impl Finder {
    pub(super) fn new(matches: fn(&[u8]) -> bool) -> Self {
        Finder {
            matches,
            answer: None,
        }
    }

    pub(super) fn find(&mut self, bytes: &[u8], from: usize) -> Option<usize> {
        if let Some((asked, found)) = self.answer
            && asked <= from
            && found.is_none_or(|found| found >= from)
        {
            return found;
        }
        let found = (from..bytes.len()).find(|&at| (self.matches)(&bytes[at..]));
        self.answer = Some((from, found));
        found
    }
}

/// The end of a line, and the next line blank (but for the mark of a quotation).
pub(super) fn begins_blank_line(tail: &[u8]) -> bool {
    let after = match tail {
        [b'\r', b'\n', ..] => return false,
        [b'\n' | b'\r', after @ ..] => after,
        _ => return false,
    };
    let text = after
        .iter()
        .find(|byte| !matches!(byte, b' ' | b'\t' | b'>'));
    matches!(text, Some(b'\n' | b'\r'))
}

impl Scanner<'_> {
    /// At a `$`.
    pub(super) fn dollar(&mut self) {
        let open = self.at;
        if self.bytes.get(open + 1) != Some(&b'$') {
            if !self.coded_inline() {
                self.inline_dollar();
            }
            return;
        }
        let close = (self.never_closed != Some(open))
            .then(|| closing(self.bytes, open + 2))
            .flatten();
        match close {
            Some(close) => self.display(Span::new(open, close + 2), 2),
            None => {
                self.unclosed = Some(open);
                self.problem(
                    Span::new(open, open + 2),
                    "this `$$` is never closed",
                    "close the equation with `$$`, or write `\\$\\$` for two dollar signs",
                );
                self.at = open + 2;
            }
        }
    }

    /// At a `\`: the start of math, or a character escaped.
    pub(super) fn backslash(&mut self) {
        let open = self.at;
        match self.bytes.get(open + 1) {
            Some(b'[') => match bracket_closing(self.bytes, open + 2) {
                Some(close) => self.display(Span::new(open, close + 2), 2),
                None => {
                    self.problem(
                        Span::new(open, open + 2),
                        "this `\\[` is never closed",
                        "close the equation with `\\]`; for a bracket in text write `[`",
                    );
                    self.at = open + 2;
                }
            },
            Some(b'(') => self.inline_parenthesis(),
            Some(b'b') => self.bare_environment(),
            _ => self.at = open + 2,
        }
    }

    /// A `$$` or `\[` display whose fences are `fence` bytes long.
    fn display(&mut self, span: Span, fence: usize) {
        self.hand_over_prose(span.start);
        self.displays.push(span);
        let within = |other: Span| other.start > span.start && other.start < span.end;
        let spills = |other: Span| within(other) && other.end > span.end;
        let outline = self.outline;
        let excluded = outline.excluded[self.next_excluded..].iter();
        let headings = outline.headings[self.next_heading..].iter();
        let quotes = &outline.quotes;
        let quote = quotes.partition_point(|quote| quote.start <= span.start);
        let quoted = quote > 0 && quotes[quote - 1].end > span.start;
        let in_title = self
            .doubtful_title
            .is_some_and(|title| title.end > span.start);
        let settled = self.blanked.binary_search(&span).is_ok();
        let spilt = excluded
            .map(|excluded| excluded.span)
            .take_while(|other| other.start < span.end)
            .any(spills)
            || headings
                .map(|title| title.span)
                .take_while(|other| other.start < span.end)
                .any(spills)
            || quotes[quote..]
                .iter()
                .copied()
                .take_while(|other| other.start < span.end)
                .any(spills);
        if spilt || (in_title && !settled) {
            self.disputed.get_or_insert(span);
        }
        let body = self.trimmed(Span::new(span.start + fence, span.end - fence));
        let lines = &self.bytes[body.range()];
        if body.start >= body.end {
            self.problem(
                span,
                "this display is empty",
                "write the equation, or remove it",
            );
        } else if quoted && lines.iter().any(|byte| matches!(byte, b'\n' | b'\r')) {
            self.quoted_lines(span);
        } else if in_title && settled {
            self.problem(
                span,
                "an equation displayed in a heading is not read",
                "leave a blank line between it and the line of `=` or `-`",
            );
        } else {
            self.items.push(Item::Display { span, body });
        }
        self.at = span.end;
        self.forget_passed();
        self.prose_from = span.end;
    }

    fn quoted_lines(&mut self, span: Span) {
        self.problem(
            span,
            "an equation on several lines of a quotation is not read",
            "write it on one line, or outside the quotation",
        );
    }

    /// A fenced block in the language `math`.
    pub(super) fn math_fence(&mut self, span: Span, body: Span) {
        self.hand_over_prose(span.start);
        let written = self.source.get(span.range()).unwrap_or_default().trim_end();
        let mark = written.chars().next().unwrap_or('`');
        let fence = written.len() - written.trim_start_matches(mark).len();
        let after = self.source.get(body.end..span.end).unwrap_or_default();
        let after = after.trim_matches(|c: char| c.is_whitespace() || c == '>');
        let closed = after.len() >= fence && after.chars().all(|c| c == mark);
        let quotes = &self.outline.quotes;
        let quote = quotes.partition_point(|quote| quote.start <= span.start);
        let quoted = quote > 0 && quotes[quote - 1].end > span.start;
        let body = self.trimmed(body);
        let empty = body.start >= body.end;
        let span = self.trimmed(span);
        if !closed && !(empty && written.len() > fence && written.ends_with(mark)) {
            let fence = Span::new(span.start, span.start + fence);
            self.problem(
                fence,
                "this `math` block is never closed",
                "close it with the same fence",
            );
        } else if empty {
            self.problem(
                span,
                "this display is empty",
                "write the equation, or remove it",
            );
        } else if quoted && self.source[body.range()].contains(['\n', '\r']) {
            self.quoted_lines(span);
        } else {
            self.items.push(Item::Display { span, body });
        }
        self.at = span.end.max(self.at + 1);
        self.prose_from = self.at;
    }

    /// ``$`a = b`$``, as some hosts write inline math.
    fn coded_inline(&mut self) -> bool {
        let excluded = &self.outline.excluded[self.next_excluded..];
        let Some(code) = excluded.first().map(|code| code.span) else {
            return false;
        };
        let opened = code.start == self.at + 1 && self.bytes.get(code.start) == Some(&b'`');
        if !opened || self.bytes.get(code.end) != Some(&b'$') {
            return false;
        }
        let text = &self.source[code.range()];
        let ticks = text.len() - text.trim_start_matches('`').len();
        let body = Span::new(code.start + ticks, code.end.saturating_sub(ticks));
        self.next_excluded += 1;
        self.inline_found(Span::new(self.at, code.end + 1), body);
        true
    }

    /// `$a = b$`, unless it is `$5 and $6`.
    fn inline_dollar(&mut self) {
        let open = self.at;
        let blank = |at: usize| self.bytes.get(at).is_none_or(u8::is_ascii_whitespace);
        let close = self.inline_end(open + 1, |tail| tail[0] == b'$');
        match close {
            Some(close)
                if !blank(open + 1)
                    && !blank(close - 1)
                    && self.bytes.get(close + 1) != Some(&b'$')
                    && !self.bytes.get(close + 1).is_some_and(u8::is_ascii_digit) =>
            {
                self.inline_found(Span::new(open, close + 1), Span::new(open + 1, close));
            }
            _ => self.at = open + 1,
        }
    }

    /// `\(a = b\)`
    fn inline_parenthesis(&mut self) {
        let open = self.at;
        match self.inline_end(open + 2, |tail| tail.starts_with(b"\\)")) {
            Some(close) => {
                self.inline_found(Span::new(open, close + 2), Span::new(open + 2, close))
            }
            None => self.at = open + 2,
        }
    }

    fn inline_found(&mut self, span: Span, body: Span) {
        self.inline.push(Inline { span, body });
        self.at = span.end;
        self.forget_passed();
    }

    /// Where inline math ends: in its paragraph, before any other math, and not across the edge of
    /// code or HTML.
    fn inline_end(&mut self, from: usize, closes: fn(&[u8]) -> bool) -> Option<usize> {
        let paragraph = self
            .blank_line
            .find(self.bytes, from)
            .unwrap_or(self.bytes.len());
        let excluded = self.outline.excluded.get(self.next_excluded);
        let limit = excluded.map_or(paragraph, |next| paragraph.min(next.span.start));
        let mut at = from;
        while at < limit {
            let tail = &self.bytes[at..];
            if closes(tail) {
                return Some(at);
            }
            match tail {
                [b'$', ..] | [b'\\', b'(' | b'[', ..] => return None,
                [b'\\', ..] => at += 2,
                _ => at += 1,
            }
        }
        None
    }

    /// `\begin{align}` outside a display.
    fn bare_environment(&mut self) {
        let open = self.at;
        self.at = open + 2;
        let rest = self.source.get(open..).unwrap_or_default();
        let Some(inner) = rest.strip_prefix("\\begin{") else {
            return;
        };
        let letters = inner.bytes().take_while(u8::is_ascii_alphabetic).count();
        let star = usize::from(inner.as_bytes().get(letters) == Some(&b'*'));
        let name = &inner[..letters + star];
        if !DISPLAYED.contains(&&inner[..letters])
            || inner.as_bytes().get(name.len()) != Some(&b'}')
        {
            return;
        }
        let begin = Span::new(open, open + "\\begin{}".len() + name.len());
        self.problem(
            begin,
            "LaTeX environments outside $$ are not read yet",
            "write the equation between `$$` and `$$`",
        );
        self.at = begin.end;
        // Its inside is no prose, if it is clear where it ends.
        if let Some(end) = self.environment_end.find(self.bytes, begin.end)
            && let Some(after) = self.source[end..].strip_prefix("\\end{")
            && after
                .strip_prefix(name)
                .is_some_and(|rest| rest.starts_with('}'))
            && !self.source[begin.end..end].contains("$$")
            && self
                .outline
                .excluded
                .get(self.next_excluded)
                .is_none_or(|next| next.span.start >= end)
        {
            self.hide_until(end + "\\end{}".len() + name.len());
            self.forget_passed();
        }
    }

    /// The `$$` that was not closed, if one was not. It need not be the last: had an earlier one
    /// lost its partner, every display after it would be the text between two equations, paragraph
    /// ends included.
    pub(super) fn culprit(&self) -> Option<usize> {
        let last = self.unclosed?;
        let paragraphs = |display: &&Span| {
            let text = &self.bytes[display.range()];
            text.starts_with(b"$$") && (0..text.len()).any(|at| begins_blank_line(&text[at..]))
        };
        let suspects = self.displays.iter().rev().take_while(paragraphs);
        Some(suspects.last().map_or(last, |display| display.start))
    }
}

/// The `$$` that closes a display.
fn closing(bytes: &[u8], from: usize) -> Option<usize> {
    let mut at = from;
    loop {
        match bytes.get(at..)? {
            [b'$', b'$', ..] => return Some(at),
            [] => return None,
            [b'\\', ..] => at += 2,
            _ => at += 1,
        }
    }
}

/// The `\]` that closes a display; there is none beyond another display's opening.
fn bracket_closing(bytes: &[u8], from: usize) -> Option<usize> {
    let mut at = from;
    loop {
        match bytes.get(at..)? {
            [b'\\', b']', ..] => return Some(at),
            [] | [b'$', b'$', ..] | [b'\\', b'[', ..] => return None,
            [b'\\', ..] => at += 2,
            _ => at += 1,
        }
    }
}
