//! Displays: `$$`, `\[`, the `math` code fence; and bare environments.

use super::{Item, Scanner, Span};

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
        let quoted = self.quoted(span);
        let in_title = self
            .doubtful_title
            .is_some_and(|title| title.end > span.start);
        let settled = self.blanked.binary_search(&span).is_ok();
        self.compare_outline(span, in_title && !settled);
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
            self.items.push(Item::Display {
                span,
                body,
                layout: None,
            });
        }
        self.at = span.end;
        self.forget_passed();
        self.prose_from = span.end;
    }

    /// Notes what the outline believes to begin inside a display and to end after it.
    fn compare_outline(&mut self, span: Span, disputed: bool) {
        let spills = |other: Span| {
            let end = self.trimmed(other).end;
            other.start > span.start && other.start < span.end && end > span.end
        };
        let excluded = self.outline.excluded[self.next_excluded..].iter();
        let spilt = excluded
            .map(|excluded| excluded.span)
            .take_while(|other| other.start < span.end)
            .any(spills);
        let headings = self.outline.headings[self.next_heading..].iter();
        let heading = headings
            .map(|title| title.span)
            .take_while(|other| other.start < span.end)
            .any(spills);
        let quotes = &self.outline.quotes;
        let quote = quotes.partition_point(|quote| quote.start <= span.start);
        let quotes = quotes[quote..].iter().copied();
        let quote = quotes
            .take_while(|other| other.start < span.end)
            .any(spills);
        if spilt {
            self.spilt.get_or_insert(span);
        }
        if heading || quote || disputed {
            self.disputed.get_or_insert(span);
        }
    }

    /// Whether a display begins in a quotation.
    fn quoted(&self, span: Span) -> bool {
        let quotes = &self.outline.quotes;
        let quote = quotes.partition_point(|quote| quote.start <= span.start);
        quote > 0 && quotes[quote - 1].end > span.start
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
        let quoted = self.quoted(span);
        let body = self.trimmed(body);
        let empty = body.start >= body.end;
        let span = self.trimmed(span);
        let bare = empty && written.len() > fence && written.ends_with(mark);
        if !closed && !bare {
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
            self.items.push(Item::Display {
                span,
                body,
                layout: None,
            });
        }
        self.at = span.end.max(self.at + 1);
        self.prose_from = self.at;
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
