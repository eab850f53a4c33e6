//! Displays: `$$`, `\[`, the `math` code fence; and bare environments.

use super::{Item, Kind, Scanner, Span};
use crate::document::latex::{displaying, environment_end, uncounted};
use crate::document::{Layout, Row};

/// Environments that LaTeX displays and that are not read, without their star.
const UNREAD: [&str; 6] = [
    "dmath",
    "IEEEeqnarray",
    "empheq",
    "dgroup",
    "subeqnarray",
    "numcases",
];

/// The most characters of a line behind a display that may be its key.
const LONGEST_KEY: usize = 128;

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
            Some(b'[') => self.bracket(1),
            Some(b'(') => self.inline_parenthesis(1),
            // As it is written for a processor that takes one of the two away.
            Some(b'\\') => match self.bytes.get(open + 2) {
                Some(b'[') => self.bracket(2),
                Some(b'(') => self.inline_parenthesis(2),
                _ => self.at = open + 2,
            },
            Some(b'b') => self.bare_environment(),
            _ => self.at = open + 2,
        }
    }

    /// At a `\[` with so many backslashes.
    fn bracket(&mut self, signs: usize) {
        let (open, fence) = (self.at, signs + 1);
        let closes = ["\\]", "\\\\]"][signs - 1];
        match bracket_closing(self.bytes, open + fence, closes.as_bytes()) {
            Some(close) => self.display(Span::new(open, close + fence), fence),
            None => {
                let begins = closes.replace(']', "[");
                self.problem(
                    Span::new(open, open + fence),
                    format!("this `{begins}` is never closed"),
                    &format!("close the equation with `{closes}`; for a bracket in text write `[`"),
                );
                self.at = open + fence;
            }
        }
    }

    /// A `$$` or `\[` display whose fences are `fence` bytes long.
    fn display(&mut self, span: Span, fence: usize) {
        let body = self.trimmed(Span::new(span.start + fence, span.end - fence));
        let (key, end) = self.key_after(span.end);
        match self.numbered_rows(body) {
            Some((body, layout)) if key.is_none() => {
                self.displayed(span, body, Some(Box::new(layout)), end);
            }
            _ => {
                let layout = key.map(|key| keyed(body, key));
                self.displayed(span, body, layout, end);
            }
        }
    }

    /// The key after a display: `(mom)` as MyST writes it, `{#eq-mom}` as Quarto does; and where it ends.
    fn key_after(&self, from: usize) -> (Option<String>, usize) {
        let rest = self.source.get(from..).unwrap_or_default();
        // A line that goes on for longer holds no key.
        let length = rest
            .char_indices()
            .take(LONGEST_KEY)
            .find(|(_, c)| matches!(c, '\n' | '\r'));
        let short = || (rest.len() < LONGEST_KEY).then_some(rest.len());
        let Some(length) = length.map(|(at, _)| at).or_else(short) else {
            return (None, from);
        };
        let line = &rest[..length];
        let text = line.trim();
        let inside = match text.strip_prefix("{#") {
            Some(rest) => rest.split_once('}').and_then(|(inside, after)| {
                // Further attributes may follow the key.
                let key = inside.split_whitespace().next()?;
                after.trim().is_empty().then_some(key)
            }),
            None => text
                .strip_prefix('(')
                .and_then(|rest| rest.strip_suffix(')')),
        };
        let plain = |key: &&str| {
            !key.is_empty()
                && key
                    .chars()
                    .all(|c| c.is_alphanumeric() || "-_.:".contains(c))
        };
        match inside.filter(plain) {
            Some(key) => (Some(key.to_owned()), from + line.trim_end().len()),
            None => (None, from),
        }
    }

    /// A display with its mathematics; what follows is read from `end` on.
    pub(super) fn displayed(
        &mut self,
        span: Span,
        body: Span,
        layout: Option<Box<Layout>>,
        end: usize,
    ) {
        self.hand_over_prose(span.start);
        self.displays.push(span);
        let quoted = self.quoted(span);
        let in_title = self
            .doubtful_title
            .is_some_and(|title| title.end > span.start);
        let settled = self.blanked.binary_search(&span).is_ok();
        self.compare_outline(span, in_title && !settled);
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
            self.items.push(Item::Display { span, body, layout });
        }
        self.at = end;
        self.forget_passed();
        self.prose_from = end;
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
        let argument = self.argument_of_directive(span);
        let (key, body) = self.options(body);
        let below = self.trimmed(body);
        let empty_below = below.start >= below.end;
        let body = match empty_below {
            true => argument,
            false => below,
        };
        let empty = body.start >= body.end;
        let span = self.trimmed(span);
        let bare = empty_below && written.len() > fence && written.ends_with(mark);
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
        } else if !empty_below && argument.start < argument.end {
            self.problem(
                argument,
                "an equation on the line of `{math}` is read only where none stands below it",
                "write all of it below that line",
            );
        } else if quoted && self.source[body.range()].contains(['\n', '\r']) {
            self.quoted_lines(span);
        } else {
            let layout = key.map(|key| keyed(body, key));
            self.items.push(Item::Display { span, body, layout });
        }
        self.at = span.end.max(self.at + 1);
        self.prose_from = self.at;
    }

    /// What stands behind `{math}` on the first line of a MyST block.
    fn argument_of_directive(&self, block: Span) -> Span {
        let text = self.source.get(block.range()).unwrap_or_default();
        let line = text.split(['\n', '\r']).next().unwrap_or_default();
        let end = block.start + line.len();
        let start = line
            .find("{math}")
            .map(|at| block.start + at + "{math}".len());
        self.trimmed(Span::new(start.unwrap_or(end), end))
    }

    /// The options that a MyST block may begin with, `:label: mom` or `label: mom` between lines of `---`: the key, and the rest of the
    /// block.
    pub(super) fn options(&self, body: Span) -> (Option<String>, Span) {
        let (mut key, mut from) = (None, body.start);
        let text = self.source.get(body.range()).unwrap_or_default();
        if let Some((options, rest)) = fenced_options(text) {
            let named = options.lines().filter_map(|line| line.split_once(':'));
            let mut keys = named.filter(|(name, _)| matches!(name.trim(), "label" | "name"));
            let key = keys
                .next()
                .map(|(_, value)| value.trim().trim_matches(['"', '\'']));
            return (
                key.map(str::to_owned),
                Span::new(body.end - rest.len(), body.end),
            );
        }
        for line in text.split_inclusive('\n') {
            let Some((name, value)) = line
                .trim()
                .strip_prefix(':')
                .and_then(|option| option.split_once(':'))
            else {
                break;
            };
            if name == "label" || name == "name" {
                key = Some(value.trim().to_owned());
            }
            from += line.len();
        }
        (key, Span::new(from, body.end.max(from)))
    }

    /// The rows of a display that is one `\begin{align}` and in which several have a number of their own.
    fn numbered_rows(&self, body: Span) -> Option<(Span, Layout)> {
        let text = self.source.get(body.range())?;
        let inner = text.strip_prefix("\\begin{")?;
        let (name, _) = inner.split_once('}')?;
        let rows = displaying(name.trim_end_matches('*'))?;
        let begin = body.start + "\\begin{}".len() + name.len();
        let (close, end) = environment_end(self.source, begin, name).ok()?;
        if end != body.end || text.matches("\\tag").count() < 2 {
            return None;
        }
        let inside = self.trimmed(Span::new(begin, close));
        Some((inside, uncounted(self.source, inside, rows)))
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
        if inner.as_bytes().get(name.len()) != Some(&b'}') {
            return;
        }
        let begin = Span::new(open, open + "\\begin{}".len() + name.len());
        if UNREAD.contains(&&inner[..letters]) {
            self.problem(
                begin,
                format!("the environment `{name}` is not read"),
                "write the equation between `$$` and `$$`",
            );
        }
        let Some(rows) = displaying(&inner[..letters]) else {
            return;
        };
        self.at = begin.end;
        let hindered = |end: usize| {
            let next = self.outline.excluded.get(self.next_excluded);
            next.is_some_and(|next| {
                next.span.start < end
                    && next.span.start > open
                    && !matches!(next.kind, Kind::InlineHtml)
            })
        };
        match environment_end(self.source, begin.end, name) {
            Ok((_, end)) if hindered(end) => self.problem(
                begin,
                format!("code begins in this `{name}`"),
                "write the equation between `$$` and `$$`",
            ),
            Ok((close, end)) => {
                let mut inside = Span::new(begin.end, close);
                if matches!(&inner[..letters], "alignat" | "xalignat" | "xxalignat")
                    && let Some(columns) = self.source[inside.range()].find('}')
                {
                    inside.start += columns + 1;
                }
                let body = self.trimmed(inside);
                let layout = uncounted(self.source, body, rows);
                self.displayed(Span::new(open, end), body, Some(Box::new(layout)), end);
            }
            Err(_) => self.problem(
                begin,
                format!("this `{name}` is never ended"),
                &format!("end it with `\\end{{{name}}}`"),
            ),
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

/// The options between two lines of `---`, and what stands below them.
fn fenced_options(text: &str) -> Option<(&str, &str)> {
    let is_fence = |line: &str| line.trim() == "---";
    let mut lines = text.split_inclusive('\n');
    let first = lines.next().filter(|line| is_fence(line))?;
    let mut end = first.len();
    for line in lines {
        if is_fence(line) {
            return Some((&text[first.len()..end], &text[end + line.len()..]));
        }
        end += line.len();
    }
    None
}

/// The layout of a display that has a key.
pub(super) fn keyed(body: Span, key: String) -> Box<Layout> {
    Box::new(Layout {
        rows: vec![Row {
            pieces: vec![body],
            number: None,
            keys: vec![key],
        }],
        ..Layout::default()
    })
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
fn bracket_closing(bytes: &[u8], from: usize, closes: &[u8]) -> Option<usize> {
    let mut at = from;
    loop {
        match bytes.get(at..)? {
            tail if tail.starts_with(closes) => return Some(at),
            [] | [b'$', b'$', ..] | [b'\\', b'[', ..] => return None,
            [b'\\', ..] => at += 2,
            _ => at += 1,
        }
    }
}
