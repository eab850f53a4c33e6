//! The scanner that decides what is an equation: one pass over the raw bytes.
//!
//! Code, fences and comments that begin outside mathematics hide what is in them; inside
//! mathematics nothing does. The outline cannot know that, so where the two disagree the displays
//! just found are blanked out of what the outline sees, and the document is scanned again. Each
//! round settles at least the first disagreement: what comes after code that only seemed to begin
//! in a display is not trusted, and not blanked, before the next round. [`ROUNDS`] bounds the time,
//! and a document that needs more is told so.
//!
//! **Invariant:** every `$$` outside code, comments and front matter lies in a display or in a
//! problem.

mod colons;
mod comment;
mod fences;
mod inline;

use super::outline::{Excluded, Kind, Outline, Title, front_matter};
use super::supposition::titled;
use super::{Inline, prose};
use super::{Item, Problem, Span};
use crate::sorted;
use fences::Finder;

/// A guess: real documents need one round, or two.
const ROUNDS: usize = 16;

/// What was read.
#[derive(Debug, Default)]
pub(super) struct Reading {
    pub items: Vec<Item>,
    pub problems: Vec<Problem>,
}

/// Reads a whole document.
pub(super) fn read(source: &str) -> Reading {
    let from = front_matter(source);
    let mut blanked: Vec<Span> = Vec::new();
    let mut never_closed = None;
    let mut round = 0;
    loop {
        round += 1;
        let outline = Outline::read(source, from, &blanked);
        let mut scanner = Scanner::new(source, &outline, &blanked, never_closed);
        scanner.run();
        let stale = blanked
            .iter()
            .find(|span| scanner.displays.binary_search(span).is_err());
        let disputed = scanner.spilt.or(scanner.disputed).or(stale.copied());
        if let Some(disputed) = disputed {
            if round < ROUNDS {
                let trusted = scanner.spilt;
                blanked = scanner.displays;
                blanked.retain(|display| trusted.is_none_or(|last| *display <= last));
                continue;
            }
            scanner.problem(
                disputed,
                "code or HTML is entangled with equations here, and may have been misread",
                "leave a blank line between them, and close every fence, back-tick and comment",
            );
        } else if never_closed.is_none()
            && let Some(culprit) = scanner.culprit()
        {
            never_closed = Some(culprit);
            blanked.clear();
            round = 0;
            continue;
        }
        sorted::sort_by_key(&mut scanner.problems, |problem| problem.span);
        return Reading {
            items: scanner.items,
            problems: scanner.problems,
        };
    }
}

struct Scanner<'a> {
    source: &'a str,
    bytes: &'a [u8],
    outline: &'a Outline,
    blanked: &'a [Span],
    /// A `$$` that is known not to be closed by the next one.
    never_closed: Option<usize>,
    at: usize,
    /// Where the prose not yet handed over begins.
    prose_from: usize,
    /// Inline math and hidden text in that prose.
    inline: Vec<Inline>,
    hidden: Vec<Span>,
    next_excluded: usize,
    next_heading: usize,
    /// An underlined title with a display fence in it: perhaps only the first lines of a display.
    doubtful_title: Option<Span>,
    /// Up to here an HTML block goes on, so `<!--` is certainly a comment.
    html_until: usize,
    comment_end: Finder,
    blank_line: Finder,
    items: Vec<Item>,
    problems: Vec<Problem>,
    /// Every `$$` and `\[` display, read or not, in order.
    displays: Vec<Span>,
    /// The fewest colons of a fence that no line of colons closes any more.
    open_colons: usize,
    /// The last opening `$$` that nothing closes.
    unclosed: Option<usize>,
    /// The first display in which the outline saw code or HTML begin that ends after it, so that
    /// what follows may have been misread.
    spilt: Option<Span>,
    /// The first display in which it saw a quotation or a heading: no harm beyond the display.
    disputed: Option<Span>,
}

impl<'a> Scanner<'a> {
    fn new(
        source: &'a str,
        outline: &'a Outline,
        blanked: &'a [Span],
        never_closed: Option<usize>,
    ) -> Self {
        Scanner {
            source,
            bytes: source.as_bytes(),
            outline,
            blanked,
            never_closed,
            at: 0,
            prose_from: 0,
            inline: Vec::new(),
            hidden: Vec::new(),
            next_excluded: 0,
            next_heading: 0,
            doubtful_title: None,
            html_until: 0,
            comment_end: Finder::new(|tail| tail.starts_with(b"-->")),
            blank_line: Finder::new(fences::begins_blank_line),
            items: Vec::new(),
            problems: Vec::new(),
            displays: Vec::new(),
            open_colons: usize::MAX,
            unclosed: None,
            spilt: None,
            disputed: None,
        }
    }

    fn run(&mut self) {
        while self.at < self.bytes.len() {
            if let Some(title) = self.heading_here() {
                self.heading(title);
            } else if let Some(excluded) = self.excluded_here() {
                self.excluded(excluded);
            } else {
                match self.bytes[self.at] {
                    b'$' => self.dollar(),
                    b'\\' => self.backslash(),
                    b'<' if self.rest().starts_with("<!--") => self.loose_comment(),
                    b':' if self.rest().starts_with(":::") => self.colons(),
                    _ => self.at = self.next_sign(),
                }
            }
        }
        self.hand_over_prose(self.bytes.len());
    }

    /// Where the next sign stands that may begin something: up to there is plain text.
    fn next_sign(&self) -> usize {
        let outline = self.outline;
        let heading = outline.headings.get(self.next_heading);
        let excluded = outline.excluded.get(self.next_excluded);
        let starts = [heading.map(|own| own.span), excluded.map(|own| own.span)];
        let starts = starts.into_iter().flatten().map(|span| span.start);
        let (from, until) = (self.at + 1, starts.min().unwrap_or(self.bytes.len()));
        let text = self.bytes.get(from..until).unwrap_or_default();
        let is_sign = |byte: &u8| matches!(byte, b'$' | b'\\' | b'<' | b':');
        from + text.iter().position(is_sign).unwrap_or(text.len())
    }

    fn rest(&self) -> &'a str {
        self.source.get(self.at..).unwrap_or_default()
    }

    fn problem(&mut self, span: Span, message: impl Into<String>, help: &str) {
        self.problems.push(Problem::new(span, message, help));
    }

    /// The heading that begins here. Those that began inside mathematics are none.
    fn heading_here(&mut self) -> Option<&'a Title> {
        let headings = &self.outline.headings;
        while headings.get(self.next_heading)?.span.start < self.at {
            self.next_heading += 1;
        }
        let title = headings.get(self.next_heading)?;
        if title.span.start > self.at {
            return None;
        }
        self.next_heading += 1;
        if title.underlined && self.bare_fence(title.content).is_some() {
            self.doubtful_title = Some(title.span);
            return None;
        }
        Some(title)
    }

    /// The code or HTML that we are at, or in by a hair.
    fn excluded_here(&mut self) -> Option<Excluded> {
        let excluded = &self.outline.excluded;
        while excluded.get(self.next_excluded)?.span.end <= self.at {
            self.next_excluded += 1;
        }
        let next = *excluded.get(self.next_excluded)?;
        (next.span.start <= self.at).then(|| {
            self.next_excluded += 1;
            next
        })
    }

    fn heading(&mut self, title: &Title) {
        self.hand_over_prose(title.span.start);
        if let Some(open) = self.bare_fence(title.content) {
            self.problem(
                Span::new(open, title.content.end),
                "an equation displayed in a heading is not read",
                "display it below the heading",
            );
        }
        let (mut text, mut from) = (String::new(), title.content.start);
        let mut comments = Vec::new();
        for excluded in &self.outline.excluded[self.next_excluded..] {
            let Excluded { span, kind } = *excluded;
            if span.start >= title.content.end {
                break;
            }
            if matches!(kind, Kind::InlineHtml) && self.source[span.range()].starts_with("<!--") {
                text.push_str(self.source.get(from..span.start).unwrap_or_default());
                from = span.end;
                comments.push(span);
            }
        }
        text.push_str(self.source.get(from..title.content.end).unwrap_or_default());
        self.items.push(Item::Heading {
            level: title.level,
            title: without_attributes(text.trim()).to_owned(),
            cases: titled::read(self.source, title.content),
            span: self.trimmed(title.span),
        });
        for comment in comments {
            let item = self.directives(comment);
            self.items.extend(item);
        }
        self.at = title.span.end.max(self.at + 1);
        self.forget_passed();
        self.prose_from = self.at;
    }

    /// The first display fence of a title that is not in code.
    fn bare_fence(&self, title: Span) -> Option<usize> {
        let text = self.source.get(title.range())?;
        let mut excluded = self.outline.excluded[self.next_excluded..]
            .iter()
            .peekable();
        text.match_indices(['$', '\\'])
            .map(|(at, _)| title.start + at)
            .filter(|&at| matches!(&self.bytes[at..], [b'$', b'$', ..] | [b'\\', b'[', ..]))
            .find(|&at| {
                while excluded.next_if(|next| next.span.end <= at).is_some() {}
                excluded.peek().is_none_or(|next| next.span.start > at)
            })
    }

    fn excluded(&mut self, Excluded { span, kind }: Excluded) {
        match kind {
            Kind::Code => self.hide_until(span.end),
            Kind::InlineHtml if self.rest().starts_with("<!--") => self.closed_comment(span.end),
            Kind::InlineHtml => self.hide_until(span.end),
            Kind::HtmlBlock => self.html_block(span),
            Kind::MathFence { body } => self.math_fence(span, body),
        }
    }

    /// Passes over text in which nothing is cited.
    fn hide_until(&mut self, end: usize) {
        let end = end.max(self.at + 1).min(self.bytes.len());
        self.hidden.push(Span::new(self.at, end));
        self.at = end;
    }

    /// Whatever the outline saw begin before here, in text that we have read ourselves, is nothing.
    fn forget_passed(&mut self) {
        let excluded = &self.outline.excluded;
        while excluded
            .get(self.next_excluded)
            .is_some_and(|next| next.span.start < self.at)
        {
            self.next_excluded += 1;
        }
    }

    /// Ends the prose before an item.
    fn hand_over_prose(&mut self, end: usize) {
        let mut span = self.trimmed(Span::new(self.prose_from, end.max(self.prose_from)));
        let inline = std::mem::take(&mut self.inline);
        let mut hidden = std::mem::take(&mut self.hidden);
        // A comment between a sentence and the display to which it leads on ends no paragraph.
        while let Some(last) =
            hidden.pop_if(|last| last.end == span.end && span.start <= last.start)
        {
            span = self.trimmed(Span::new(span.start, last.start));
        }
        if span.start == span.end {
            return;
        }
        let targets = &self.outline.targets;
        let first = targets.partition_point(|target| target.start < span.start);
        hidden.extend(
            targets[first..]
                .iter()
                .take_while(|target| target.start < span.end),
        );
        sorted::sort(&mut hidden);
        let prose = prose::read(self.source, span, &inline, &hidden);
        self.items.push(Item::Prose(prose.into()));
    }

    fn trimmed(&self, span: Span) -> Span {
        let text = self.source.get(span.range()).unwrap_or_default();
        let blank = |c: char| c.is_whitespace() || c == '\u{feff}';
        let start = span.end - text.trim_start_matches(blank).len();
        Span::new(
            start,
            (span.start + text.trim_end_matches(blank).len()).max(start),
        )
    }
}

/// A title without the attributes that Pandoc and Quarto let follow it: `Results {#sec:results .unnumbered}`.
fn without_attributes(title: &str) -> &str {
    let Some((text, inside)) = title.strip_suffix('}').and_then(|t| t.rsplit_once('{')) else {
        return title;
    };
    let is_attribute =
        |word: &str| word == "-" || word.starts_with(['#', '.']) || word.contains('=');
    let mut words = inside.split_whitespace().peekable();
    let attributes = words.peek().is_some() && words.all(is_attribute);
    match attributes && (text.is_empty() || text.ends_with(char::is_whitespace)) {
        true => text.trim_end(),
        false => title,
    }
}
