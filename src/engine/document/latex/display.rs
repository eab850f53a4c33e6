//! Displays: where each ends, and its rows with their numbers and keys.

use super::super::prose;
use super::super::{Item, Layout, Problem, Row, Span};
use super::ends::{bracket_end, dollars_end, environment_end};
use super::names::Rows;
use super::rows::{self, Before};
use super::scan::Scanner;

impl Scanner<'_> {
    /// `$$ … $$`
    pub(super) fn dollars(&mut self) {
        let open = self.at;
        match dollars_end(self.bytes, open + 2) {
            Ok(close) => {
                self.at = close + 2;
                let body = Span::new(open + 2, close);
                self.display(Span::new(open, close + 2), body, Rows::One, false);
            }
            Err(stop) => self.unended(Span::new(open, open + 2), stop, "`$$`", "`$$`"),
        }
    }

    /// `\[ … \]`
    pub(super) fn bracket(&mut self, open: usize) {
        match bracket_end(self.bytes, open + 2) {
            Ok(close) => {
                self.at = close + 2;
                let body = Span::new(open + 2, close);
                self.display(Span::new(open, close + 2), body, Rows::One, false);
            }
            Err(stop) => self.unended(Span::new(open, open + 2), stop, "`\\[`", "`\\]`"),
        }
    }

    /// `\begin{align} … \end{align}`; `self.at` is behind the beginning.
    pub(super) fn environment(&mut self, open: usize, name: &str, rows: Rows) {
        let plain = name.trim_end_matches('*');
        let begin = Span::new(open, self.at);
        if matches!(plain, "alignat" | "xalignat" | "xxalignat") {
            self.group();
        } else if ["[t]", "[b]", "[c]"]
            .iter()
            .any(|o| self.rest().starts_with(o))
        {
            // A bracket with anything else in it belongs to the equation.
            self.at += 3;
        }
        let from = self.at;
        match environment_end(self.text, from, name) {
            Ok((close, after)) => {
                self.at = after;
                let numbered = plain == name && plain != "displaymath";
                self.display(
                    Span::new(open, after),
                    Span::new(from, close),
                    rows,
                    numbered,
                );
            }
            Err(stop) => {
                let end = format!("`\\end{{{name}}}`");
                self.unended(begin, stop, &format!("`{name}`"), &end);
            }
        }
    }

    /// An environment of mathematics that is not read.
    pub(super) fn unread(&mut self, open: usize, name: &str) {
        let span = Span::new(open, self.at);
        self.problem(
            span,
            format!("the environment `{name}` is not read here"),
            "write the equation in `equation`, `align`, `gather` or `multline`",
        );
        let inner = [
            "aligned",
            "alignedat",
            "gathered",
            "split",
            "cases",
            "multlined",
        ];
        if !name.ends_with('*') && !inner.contains(&name) && !name.ends_with("matrix") {
            self.numbering.lose();
        }
        self.at = match environment_end(self.text, self.at, name) {
            Ok((_, after)) => after,
            Err(stop) => stop.max(self.at),
        };
    }

    /// Something is wrong with where a display ends: what follows up to `stop` is covered by the message.
    fn unended(&mut self, begin: Span, stop: usize, what: &str, close: &str) {
        self.hand_over_prose(begin.start);
        if !what.starts_with("`$") && !what.starts_with("`\\[") && !what.ends_with("*`") {
            self.numbering.lose();
        }
        self.problem(
            begin,
            format!("this {what} is never closed"),
            &format!("close the equation with {close}"),
        );
        self.at = stop.max(begin.end);
        self.prose_again();
    }

    fn display(&mut self, span: Span, body: Span, rows: Rows, numbered: bool) {
        self.catch_up(span.start);
        self.hand_over_prose(span.start);
        self.prose_again();
        let found = rows::rows(self.text, body, rows);
        let empty = found.iter().all(|row| row.pieces.is_empty());
        let obstacle = self.obstacle(span);
        let group = self.subs.last().map(|sub| {
            let keys = sub.keys.clone();
            (sub.number.clone().unwrap_or_default(), keys)
        });
        self.keys
            .extend(group.iter().flat_map(|(_, keys)| keys.iter().cloned()));
        if empty {
            if numbered {
                self.numbering.next_equation();
            }
            return match obstacle {
                Some(problem) => self.problems.push(problem),
                None => self.problem(
                    span,
                    "this display is empty",
                    "write the equation, or remove it",
                ),
            };
        }
        let mut layout = Layout {
            columns: rows == Rows::Columns,
            group: group.filter(|_| numbered),
            obstacle,
            ..Layout::default()
        };
        let mut start = span.start;
        for mut row in found {
            self.numbering.count_on(row.counted);
            let number = match row.tag.take() {
                Some(tag) if tag == "\\theequation" => self.numbering.printed("equation"),
                Some(tag) => Some(tag),
                None if numbered && !row.unnumbered => self.numbering.next_equation(),
                None => None,
            };
            self.keys.extend(row.keys.iter().cloned());
            if !row.before.is_empty() && !row.pieces.is_empty() {
                let first = row.pieces[0].start;
                self.finish(Span::new(start, first), &mut layout);
                start = first;
                self.say(std::mem::take(&mut row.before));
            }
            if !row.pieces.is_empty() {
                layout.rows.push(Row {
                    pieces: row.pieces,
                    number,
                    keys: row.keys,
                });
            }
        }
        self.finish(Span::new(start, span.end), &mut layout);
        self.prose_again();
    }

    /// Hands over the rows so far as a display.
    fn finish(&mut self, span: Span, layout: &mut Layout) {
        let rows = std::mem::take(&mut layout.rows);
        let pieces = || rows.iter().flat_map(|row| &row.pieces);
        let Some(body) = pieces().copied().reduce(Span::to) else {
            return;
        };
        let layout = Layout {
            rows,
            ..layout.clone()
        };
        self.items.push(Item::Display {
            span: Span::new(span.start.min(body.start), span.end.max(body.end)),
            body,
            layout: Some(Box::new(layout)),
        });
    }

    /// What stands before a row.
    fn say(&mut self, before: Vec<Before>) {
        for said in before {
            match said {
                Before::Directive(at) => drop(self.directive(at)),
                Before::Words(span) => {
                    let prose = prose::read(self.text, span, &[], &[]);
                    self.items.push(Item::Prose(prose.into()));
                }
            }
        }
    }

    /// What was found amiss inside a display: the first of it hinders reading, the rest is told.
    fn obstacle(&mut self, span: Span) -> Option<Problem> {
        let mut inside: Vec<Problem> = Vec::new();
        let from = self.amiss.partition_point(|p| p.span.start < span.start);
        let to = self.amiss.partition_point(|p| p.span.start < span.end);
        inside.extend(self.amiss.drain(from..to));
        if inside.is_empty() {
            let at = self
                .obstacles
                .partition_point(|p| p.span.start < span.start);
            let first = self.obstacles.get(at).filter(|p| p.span.start < span.end);
            return first.cloned();
        }
        let rest = inside.split_off(1);
        self.problems.extend(rest);
        inside.pop()
    }
}
