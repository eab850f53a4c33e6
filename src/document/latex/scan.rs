//! Going through the text put together: sections, prose, directives, and where displays are.

use std::collections::BTreeSet;
use std::sync::Arc;

use super::super::directive::{self, Comment};
use super::super::prose::{self, Inline};
use super::super::{Directive, Document, Item, Problem, Span};
use super::assemble::Assembled;
use super::display::{as_text, stops};
use super::names::{self, UNREAD};
use super::numbering::Numbering;

/// The longest argument that is looked for in text.
const LONGEST_ARGUMENT: usize = 20_000;
/// Environments in which nothing is said: pictures and lists of literature.
const SILENT: &[&str] = &[
    "tikzpicture",
    "pgfpicture",
    "picture",
    "thebibliography",
    "circuitikz",
];

/// `subequations` that are being read.
pub(super) struct Sub {
    pub number: Option<String>,
    pub keys: Vec<String>,
    equation: i64,
    format: String,
}

pub(super) struct Scanner<'a> {
    pub text: &'a str,
    pub bytes: &'a [u8],
    pub at: usize,
    pub numbering: Numbering,
    pub subs: Vec<Sub>,
    pub items: Vec<Item>,
    pub problems: Vec<Problem>,
    /// What was found amiss when the text was put together, in order.
    pub amiss: Vec<Problem>,
    pub obstacles: Vec<Problem>,
    /// Places at which the count of equations is lost, in order.
    lost: Vec<usize>,
    /// The keys of equations, and those of other things.
    pub keys: BTreeSet<String>,
    elsewhere: BTreeSet<String>,
    preamble: bool,
    prose_from: usize,
    inline: Vec<Inline>,
    hidden: Vec<Span>,
    /// How many braces are open in the paragraph.
    depth: usize,
    /// Up to here a stray sign of mathematics has been told of.
    quiet: usize,
}

/// The documents that a text consists of.
pub(super) fn documents(assembled: Assembled) -> Vec<Document> {
    let Assembled {
        text,
        origin,
        mut problems,
        mut obstacles,
        pages,
        lost,
    } = assembled;
    problems.sort_by_key(|problem| problem.span);
    obstacles.sort_by_key(|problem| problem.span);
    let mut scanner = Scanner {
        text: &text,
        bytes: text.as_bytes(),
        at: 0,
        numbering: Numbering::of_class(""),
        subs: Vec::new(),
        items: Vec::new(),
        problems: Vec::new(),
        amiss: problems,
        obstacles,
        lost,
        keys: BTreeSet::new(),
        elsewhere: BTreeSet::new(),
        preamble: text.contains("\\begin{document}"),
        prose_from: 0,
        inline: Vec::new(),
        hidden: Vec::new(),
        depth: 0,
        quiet: 0,
    };
    scanner.run();
    scanner.drop_citations_of_other_things();
    let body = text.find("\\begin{document}").unwrap_or(0);
    let Scanner {
        mut items,
        mut problems,
        amiss,
        ..
    } = scanner;
    problems.extend(amiss);
    problems.sort_by_key(|problem| problem.span);
    items.sort_by_key(|item| item.span().start);
    let declares = |item: &&Item| {
        let Item::Directives { clauses, span } = item else {
            return false;
        };
        let lasting =
            |c: &Directive| matches!(c, Directive::Symbols { .. } | Directive::Data { .. });
        span.start < body && clauses.iter().any(|clause| lasting(&clause.value))
    };
    let inherited: Vec<Item> = items.iter().filter(declares).cloned().collect();
    let source: Arc<str> = text.as_str().into();
    let origin = Arc::new(origin);
    let mut starts = vec![(0, 0)];
    starts.extend(pages);
    let mut documents: Vec<Document> = Vec::new();
    let (mut items, mut problems) = (
        items.into_iter().peekable(),
        problems.into_iter().peekable(),
    );
    for (at, &(_, file)) in starts.iter().enumerate() {
        let end = starts.get(at + 1).map_or(usize::MAX, |next| next.0);
        let mut document = Document {
            path: origin.files[file].path.clone(),
            source: source.clone(),
            items: Vec::new(),
            inherited: match at {
                0 => Vec::new(),
                _ => inherited.clone(),
            },
            problems: Vec::new(),
            is_latex: true,
            origin: origin.clone(),
        };
        while let Some(item) = items.next_if(|item| item.span().start < end) {
            document.items.push(item);
        }
        while let Some(problem) = problems.next_if(|problem| problem.span.start < end) {
            document.problems.push(problem);
        }
        let says = |item: &Item| matches!(item, Item::Display { .. } | Item::Directives { .. });
        if !document.problems.is_empty() || document.items.iter().any(says) {
            documents.push(document);
        }
    }
    if documents.is_empty() {
        documents.push(Document {
            path: origin.files[0].path.clone(),
            source,
            items: Vec::new(),
            inherited: Vec::new(),
            problems: Vec::new(),
            is_latex: true,
            origin,
        });
    }
    documents
}

impl<'a> Scanner<'a> {
    fn run(&mut self) {
        while self.at < self.bytes.len() {
            match self.bytes[self.at] {
                b'%' => {
                    self.hand_over_prose(self.at);
                    let at = self.at;
                    self.at = self.directive(at);
                    self.prose_from = self.at;
                }
                b'\\' => self.command(),
                _ if self.preamble => self.at += 1,
                b'$' if self.bytes.get(self.at + 1) == Some(&b'$') => self.dollars(),
                b'$' => self.inline_dollar(),
                b'{' => {
                    self.depth += 1;
                    self.at += 1;
                }
                b'}' => {
                    self.depth = self.depth.saturating_sub(1);
                    self.at += 1;
                }
                b'\n' if ends_paragraph(&self.bytes[self.at..]) => {
                    self.depth = 0;
                    self.at += 1;
                }
                b'^' | b'_' if self.depth == 0 && self.at >= self.quiet => self.stray(),
                _ => self.at += 1,
            }
        }
        self.hand_over_prose(self.bytes.len());
    }

    pub(super) fn rest(&self) -> &'a str {
        self.text.get(self.at..).unwrap_or_default()
    }

    pub(super) fn problem(&mut self, span: Span, message: impl Into<String>, help: &str) {
        self.problems.push(Problem::new(span, message, help));
    }

    /// A directive at a `%`; where it ends.
    pub(super) fn directive(&mut self, at: usize) -> usize {
        let length = self.text[at..].find('\n').unwrap_or(self.text.len() - at);
        let span = Span::new(at, at + length);
        let signs =
            self.text[span.range()].len() - self.text[span.range()].trim_start_matches('%').len();
        match directive::read(self.text, Span::new(at + signs, span.end)) {
            Comment::Other => {}
            Comment::Misspelt(problem) => self.problems.push(problem),
            Comment::Directives(clauses, problems) => {
                self.problems.extend(problems);
                self.items.push(Item::Directives { clauses, span });
            }
        }
        (span.end + 1).min(self.text.len())
    }

    /// A `^` or `_` in text: whatever it stands in is mathematics that was not seen.
    fn stray(&mut self) {
        let sign = Span::new(self.at, self.at + 1);
        self.problem(
            sign,
            "this belongs to mathematics, and stands in text",
            "an environment that is not known here may display an equation: write it as `equation` or `align`",
        );
        let rest = &self.bytes[self.at..];
        let paragraph = (0..rest.len()).find(|&at| ends_paragraph(&rest[at..]));
        self.quiet = self.at + paragraph.unwrap_or(rest.len());
        self.at += 1;
    }

    fn command(&mut self) {
        let open = self.at;
        let rest = &self.rest()[1..];
        let letters = rest
            .find(|c: char| !c.is_ascii_alphabetic())
            .unwrap_or(rest.len());
        let (name, _) = rest.split_at(letters);
        self.at = open + 1 + letters.max(rest.chars().next().map_or(0, char::len_utf8));
        match name {
            "" if self.preamble => {}
            "" if rest.starts_with('[') => self.bracket(open),
            "" if rest.starts_with('(') => self.inline_parenthesis(open),
            "begin" => self.begin(open),
            "end" => self.end(open),
            "documentclass" => {
                self.options();
                if let Some(class) = self.group() {
                    self.numbering = Numbering::of_class(self.text[class.range()].trim());
                }
            }
            "title" => {
                self.hand_over_prose(open);
                self.options();
                if let Some(title) = self.group() {
                    self.heading_item(1, Span::new(open, self.at), title);
                }
                self.prose_from = self.at;
            }
            "numberwithin" | "counterwithin" | "counterwithout" => {
                self.star();
                if let (Some(child), Some(parent)) = (self.group(), self.group()) {
                    let (child, parent) = (
                        self.text[child.range()].trim(),
                        self.text[parent.range()].trim(),
                    );
                    match name {
                        "counterwithout" => self.numbering.number_without(child, parent),
                        _ => self.numbering.number_within(child, parent),
                    }
                }
                self.hide(open);
            }
            "newcommand" | "renewcommand" | "providecommand" | "DeclareRobustCommand" => {
                if let (Some(counter), Some(format)) = (self.group(), self.group()) {
                    let counter = self.text[counter.range()].trim();
                    self.numbering
                        .set_format(counter, &self.text[format.range()]);
                }
                self.hide(open);
            }
            "setcounter" | "addtocounter" => self.set_counter(open, name),
            "stepcounter" | "refstepcounter" => {
                if let Some(counter) = self.group() {
                    self.numbering.step(self.text[counter.range()].trim());
                }
                self.hide(open);
            }
            _ if self.preamble => {}
            "appendix" => self.numbering.appendix(),
            "label" => {
                if let Some(key) = self.group() {
                    let key = self.text[key.range()].trim().to_owned();
                    match self.subs.last_mut() {
                        Some(sub) => sub.keys.push(key),
                        None => drop(self.elsewhere.insert(key)),
                    }
                }
                self.hide(open);
            }
            "ensuremath" => {
                self.group();
                self.hide(open);
            }
            _ if names::heading(name).is_some() => self.heading(open, name),
            _ => {
                if let Some(arguments) = names::silent(name) {
                    self.star();
                    self.options();
                    for _ in 0..arguments {
                        self.group();
                    }
                    self.hide(open);
                }
            }
        }
    }

    /// `\begin{…}` in text or in the preamble.
    fn begin(&mut self, open: usize) {
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

    fn end(&mut self, open: usize) {
        let Some(name) = self.group() else { return };
        self.depth = 0;
        match self.text[name.range()].trim() {
            "subequations" => {
                if let Some(sub) = self.subs.pop() {
                    self.numbering.end_sub(sub.equation, sub.format);
                }
            }
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

    /// Forgets the count of equations if something is missing between it and here.
    pub(super) fn catch_up(&mut self, to: usize) {
        let missed = self.lost.partition_point(|&at| at <= to);
        if missed > 0 {
            self.lost.drain(..missed);
            self.numbering.lose();
        }
    }

    fn heading(&mut self, open: usize, name: &str) {
        let Some((level, counter)) = names::heading(name) else {
            return;
        };
        self.catch_up(open);
        self.hand_over_prose(open);
        self.depth = 0;
        let starred = self.star();
        self.options();
        if !starred {
            self.numbering.step(counter);
        }
        match self.group() {
            Some(title) => self.heading_item(level, Span::new(open, self.at), title),
            None => self.problem(
                Span::new(open, self.at),
                "the title of this heading is missing or never closed",
                "give it in braces",
            ),
        }
        self.prose_from = self.at;
    }

    fn heading_item(&mut self, level: u8, span: Span, title: Span) {
        let text = &self.text[title.range()];
        for rest in text.split("\\label{").skip(1) {
            let key = rest.split_once('}').map_or(rest, |(key, _)| key);
            self.elsewhere.insert(key.trim().to_owned());
        }
        if let Some(at) = ["$$", "\\[", "\\begin{"].iter().find_map(|d| text.find(d)) {
            let at = title.start + at;
            self.problem(
                Span::new(at, at + 2),
                "an equation displayed in a heading is not read",
                "display it below the heading",
            );
        }
        self.items.push(Item::Heading {
            level,
            title: words(text),
            span,
        });
    }

    fn set_counter(&mut self, open: usize, name: &str) {
        if let (Some(counter), Some(value)) = (self.group(), self.group()) {
            let counter = self.text[counter.range()].trim();
            let text = self.text[value.range()].trim();
            let other = text
                .strip_prefix("\\value{")
                .and_then(|rest| rest.strip_suffix('}'))
                .map(|counter| self.numbering.get(counter.trim()));
            match (other.or_else(|| text.parse().ok()), name) {
                (Some(value), "addtocounter") => {
                    let sum = self.numbering.get(counter).saturating_add(value);
                    self.numbering.set(counter, sum);
                }
                (Some(value), _) => self.numbering.set(counter, value),
                (None, _) if counter == "equation" => {
                    self.numbering.lose();
                    self.problem(
                        value,
                        "this value of the counter is not followed: equations have no numbers from here on",
                        "write a whole number",
                    );
                }
                (None, _) => {}
            }
        }
        self.hide(open);
    }

    /// Text from `open` to here in which nothing is cited.
    pub(super) fn hide(&mut self, open: usize) {
        if !self.preamble {
            self.hidden.push(Span::new(open, self.at));
        }
    }

    fn star(&mut self) -> bool {
        let starred = self.bytes.get(self.at) == Some(&b'*');
        self.at += usize::from(starred);
        starred
    }

    /// Past `[…]`, perhaps several.
    pub(super) fn options(&mut self) {
        while let Some(length) = bracketed(self.rest(), '[', ']') {
            self.at += length;
        }
    }

    /// The inside of the braces that follow, perhaps after spaces; past them.
    pub(super) fn group(&mut self) -> Option<Span> {
        let rest = self.rest();
        let blank = rest.len() - rest.trim_start_matches([' ', '\t', '\n', '\r']).len();
        let length = bracketed(&rest[blank..], '{', '}')?;
        let start = self.at + blank;
        self.at = start + length;
        Some(Span::new(start + 1, self.at - 1))
    }

    /// Ends the prose before an item.
    pub(super) fn hand_over_prose(&mut self, end: usize) {
        let inline = std::mem::take(&mut self.inline);
        let mut hidden = std::mem::take(&mut self.hidden);
        let span = Span::new(self.prose_from, end.max(self.prose_from));
        let span = directive::trim(self.text, span);
        if self.preamble || span.start >= span.end {
            return;
        }
        hidden.sort();
        let prose = prose::read(self.text, span, &inline, &hidden);
        self.items.push(Item::Prose(prose));
    }

    /// From here on prose goes on.
    pub(super) fn prose_again(&mut self) {
        self.prose_from = self.at;
    }

    fn inline_dollar(&mut self) {
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

    fn inline_parenthesis(&mut self, open: usize) {
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

    fn inline_found(&mut self, span: Span, body: Span) {
        self.inline.push(Inline { span, body });
        self.at = span.end;
    }

    /// `\ref` cites figures and sections too.
    fn drop_citations_of_other_things(&mut self) {
        let other = |key: &String| self.elsewhere.contains(key) && !self.keys.contains(key);
        for item in &mut self.items {
            if let Item::Prose(prose) = item {
                prose.citations.retain(|c| !(c.key && other(&c.tag)));
            }
        }
    }
}

/// The length of `[…]` or `{…}` at the start of `rest`, braces in it counted.
pub(super) fn bracketed(rest: &str, open: char, close: char) -> Option<usize> {
    if !rest.starts_with(open) {
        return None;
    }
    let mut depth = 0_usize;
    let mut escaped = false;
    for (at, c) in rest.char_indices().take(LONGEST_ARGUMENT).skip(1) {
        if std::mem::take(&mut escaped) {
            continue;
        }
        match c {
            '\\' => escaped = true,
            c if c == close && depth == 0 => return Some(at + c.len_utf8()),
            '{' => depth += 1,
            '}' => depth = depth.checked_sub(1)?,
            _ => {}
        }
    }
    None
}

/// The end of a line, and the next line blank.
pub(super) fn ends_paragraph(tail: &[u8]) -> bool {
    let [b'\n', after @ ..] = tail else {
        return false;
    };
    let text = after
        .iter()
        .find(|byte| !matches!(byte, b' ' | b'\t' | b'\r'));
    matches!(text, Some(b'\n'))
}

/// Where inline mathematics ends; a `$` in braces belongs to words in it.
fn inline_end(bytes: &[u8], from: usize, closes: &[u8]) -> Option<usize> {
    let (mut at, mut depth) = (from, 0_usize);
    loop {
        let tail = bytes.get(at..)?;
        if depth == 0 && tail.starts_with(closes) {
            return Some(at);
        }
        match tail {
            [] => return None,
            [b'\n', ..] if ends_paragraph(tail) => return None,
            [b'\\', b'[' | b'(', ..] => return None,
            [b'$', ..] if depth == 0 => return None,
            [b'\\', ..] if stops(as_text(tail)) => return None,
            [b'\\', ..] => at += 2,
            [b'{', ..] => (depth, at) = (depth + 1, at + 1),
            [b'}', ..] => (depth, at) = (depth.checked_sub(1)?, at + 1),
            _ => at += 1,
        }
    }
}

/// A title in words.
fn words(text: &str) -> String {
    let mut plain = String::new();
    let mut rest = text;
    while let Some(c) = rest.chars().next() {
        if let Some(command) = rest.strip_prefix('\\') {
            let end = command
                .find(|c: char| !c.is_ascii_alphabetic())
                .unwrap_or(command.len());
            let (name, after) = command.split_at(end);
            rest = match name {
                "label" | "thanks" | "footnote" => match bracketed(after, '{', '}') {
                    Some(length) => &after[length..],
                    None => after,
                },
                "" => {
                    plain.push(' ');
                    &after[after.chars().next().map_or(0, char::len_utf8)..]
                }
                _ => after,
            };
            continue;
        }
        match c {
            '{' | '}' | '$' => {}
            '~' => plain.push(' '),
            c => plain.push(c),
        }
        rest = &rest[c.len_utf8()..];
    }
    plain.split_whitespace().collect::<Vec<_>>().join(" ")
}
