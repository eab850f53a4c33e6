//! Inline math: `$a = b$`, `\(a = b\)` and ``$`a = b`$``. Only what prose supposes is read from it.

use super::{Inline, Scanner, Span};

impl Scanner<'_> {
    /// ``$`a = b`$``, as some hosts write inline math.
    pub(super) fn coded_inline(&mut self) -> bool {
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
    pub(super) fn inline_dollar(&mut self) {
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

    /// `\(a = b\)`, with so many backslashes.
    pub(super) fn inline_parenthesis(&mut self, signs: usize) {
        let (open, fence) = (self.at, signs + 1);
        let closes: fn(&[u8]) -> bool = match signs {
            1 => |tail| tail.starts_with(b"\\)"),
            _ => |tail| tail.starts_with(b"\\\\)"),
        };
        match self.inline_end(open + fence, closes) {
            Some(close) => {
                let span = Span::new(open, close + fence);
                self.inline_found(span, Span::new(open + fence, close));
            }
            None => self.at = open + fence,
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
}
