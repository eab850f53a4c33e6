//! `:::{math}`, the fence of colons that MyST has beside the backticks.

use super::fences::keyed;
use super::{Scanner, Span};

impl Scanner<'_> {
    /// At `:::`.
    pub(super) fn colons(&mut self) {
        let open = self.at;
        let rest = self.rest();
        let colons = rest.bytes().take_while(|b| *b == b':').count();
        let line = rest.split(['\n', '\r']).next().unwrap_or_default();
        self.at += colons;
        let Some(after) = line[colons..]
            .trim_start_matches(' ')
            .strip_prefix("{math}")
        else {
            return;
        };
        let first = Span::new(open, open + line.len());
        let before = self.source[..open].rsplit('\n').next().unwrap_or_default();
        if !before.trim_matches([' ', '\t', '>']).is_empty() || !after.trim().is_empty() {
            self.problem(
                first,
                "this `:::{math}` is not read: its line holds something else",
                "begin it on a line of its own, with the equation below",
            );
            return;
        }
        let closing = (colons < self.open_colons)
            .then(|| self.closing_colons(first.end, colons))
            .flatten();
        let Some(closing) = closing else {
            self.open_colons = self.open_colons.min(colons);
            self.problem(
                Span::new(open, open + colons),
                "this `:::{math}` is never closed",
                "close it with a line of as many colons",
            );
            return;
        };
        let from = first.end + self.source[first.end..].find('\n').map_or(0, |at| at + 1);
        let (key, body) = self.options(Span::new(from.min(closing.start), closing.start));
        let body = self.trimmed(body);
        let layout = key.map(|key| keyed(body, key));
        self.displayed(Span::new(open, closing.end), body, layout, closing.end);
    }

    /// The first line after `from` that holds nothing but at least so many colons.
    fn closing_colons(&self, from: usize, colons: usize) -> Option<Span> {
        let mut at = from;
        for line in self.source.get(from..)?.split_inclusive('\n') {
            let text = line.trim_matches(|c: char| c.is_whitespace() || c == '>');
            if text.len() >= colons && text.bytes().all(|b| b == b':') {
                return Some(Span::new(at, at + line.trim_end().len()));
            }
            at += line.len();
        }
        None
    }
}
