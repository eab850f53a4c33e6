//! Going through the text put together: sections, prose, directives, and where displays are.

use std::collections::BTreeSet;

use super::super::directive::{self, Comment};
use super::super::prose;
use super::super::supposition::titled;
use super::super::{Item, Problem, Span};
use super::ends::{bracketed, ends_paragraph};
use super::names;
use super::numbering::Numbering;
use crate::document::Inline;
use crate::sorted;

/// `subequations` that are being read.
pub(super) struct Sub {
    pub number: Option<String>,
    pub keys: Vec<String>,
    pub equation: i64,
    pub format: String,
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
    pub lost: Vec<usize>,
    /// The keys of equations, and those of other things.
    pub keys: BTreeSet<String>,
    pub elsewhere: BTreeSet<String>,
    pub preamble: bool,
    pub prose_from: usize,
    pub inline: Vec<Inline>,
    pub hidden: Vec<Span>,
    /// How many braces are open in the paragraph.
    pub depth: usize,
    /// Up to here a stray sign of mathematics has been told of.
    pub quiet: usize,
}

impl<'a> Scanner<'a> {
    pub(super) fn run(&mut self) {
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
                let starred = self.star();
                if let (Some(child), Some(parent)) = (self.group(), self.group()) {
                    let (child, parent) = (
                        self.text[child.range()].trim(),
                        self.text[parent.range()].trim(),
                    );
                    match name {
                        "counterwithin" if starred => self.numbering.within(child, parent),
                        "counterwithout" if starred => self.numbering.apart(child, parent),
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
            "frontmatter" | "mainmatter" | "backmatter" => {
                self.numbering.matter(name == "mainmatter");
            }
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
            self.numbering.heading(counter);
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
            cases: titled::read(self.text, title),
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
        sorted::sort(&mut hidden);
        let prose = prose::read(self.text, span, &inline, &hidden);
        self.items.push(Item::Prose(prose.into()));
    }

    /// From here on prose goes on.
    pub(super) fn prose_again(&mut self) {
        self.prose_from = self.at;
    }

    /// `\ref` cites figures and sections too.
    pub(super) fn drop_citations_of_other_things(&mut self) {
        let other = |key: &String| self.elsewhere.contains(key) && !self.keys.contains(key);
        for item in &mut self.items {
            if let Item::Prose(prose) = item {
                prose.drop_citations(|c| c.key && other(&c.tag));
            }
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
