//! LaTeX documents: sections, paragraphs, lists, and the commands that prose is usually set with.
//!
//! The walk goes item by item, so that no display can be lost. Text is set command by command: what is known as it looks in print, of what
//! is not known the text of its arguments. Groups may reach over mathematics and citations, but end with their paragraph. Comments, macros
//! and verbatim text have gone when the text was put together.

use crate::document::{Document, Item, Span};
use crate::notation::escape;

use super::super::{Page, words};
use super::latex_reader::Reader;
use super::latex_words::{self, Command};
use super::spots::{Kind, Piece, Spots};

/// Tags and lists within each other, deeper than anybody writes.
const DEEPEST: usize = 16;

pub(super) fn walk(page: &Page<'_>, at: usize) -> String {
    let document = &page.report.derivation.pages[at].document;
    let mut spots = Spots::of(page, at);
    let mut setter = Setter::new(page, words::inline);
    for item in &document.items {
        let span = item.span();
        for missed in spots.missed(span.start) {
            setter.display(missed);
        }
        match item {
            Item::Heading { level, title, .. } => {
                let level = (*level + 2).min(6);
                let math = words::inline;
                let set = heading(page, document, &Heading { title, span, math });
                setter.end_paragraph();
                setter.end_lists();
                setter.block(&format!("<h{level}>{set}</h{level}>\n"));
            }
            Item::Prose(_) => spots.pass(&span.range(), |piece| setter.piece(document, &piece)),
            Item::Display { .. } => spots.pass(&span.range(), |piece| {
                if let Piece::Spot(spot) = piece
                    && let Kind::Display(at) = spot.kind
                {
                    setter.display(at);
                }
            }),
            Item::Directives { .. } => {}
        }
    }
    for missed in spots.missed(usize::MAX) {
        setter.display(missed);
    }
    setter.finished()
}

/// A heading with its mathematics: from its source, where that has an argument in braces.
pub(super) fn heading(page: &Page<'_>, document: &Document, heading: &Heading<'_>) -> String {
    let written = document.text(heading.span);
    let argument = written.split_once('{').and_then(|(_, rest)| {
        let rest = rest.trim_end();
        rest.strip_suffix('}')
    });
    let mut setter = Setter::new(page, heading.math);
    setter.in_line = true;
    setter.line(argument.unwrap_or(heading.title));
    setter.finished()
}

/// A heading, and how its mathematics is set.
pub(super) struct Heading<'t> {
    pub title: &'t str,
    pub span: Span,
    pub math: fn(&str) -> String,
}

/// What is being written.
struct Setter<'p, 'a> {
    page: &'p Page<'a>,
    /// How mathematics is set.
    math: fn(&str) -> String,
    out: String,
    /// Without paragraphs.
    in_line: bool,
    paragraph: bool,
    /// What closes each group that is open.
    groups: Vec<&'static str>,
    lists: Vec<List>,
}

impl<'p, 'a> Setter<'p, 'a> {
    fn new(page: &'p Page<'a>, math: fn(&str) -> String) -> Self {
        Setter {
            page,
            math,
            out: String::new(),
            in_line: false,
            paragraph: false,
            groups: Vec::new(),
            lists: Vec::new(),
        }
    }

    fn finished(mut self) -> String {
        self.end_paragraph();
        self.end_lists();
        self.out
    }

    /// A piece of text, or what stands in it.
    fn piece(&mut self, document: &Document, piece: &Piece<'_>) {
        match piece {
            Piece::Text(text) => self.text(text),
            Piece::Spot(spot) => match spot.kind {
                Kind::Math(body) => self.write(&(self.math)(document.text(body))),
                Kind::Cited(at) => match document.text(spot.span) {
                    // A command, which says itself what it cites.
                    command if command.starts_with('\\') => self.text(command),
                    number => self.link(at, number),
                },
                Kind::Display(at) => self.display(at),
            },
        }
    }

    /// Text with mathematics between dollars.
    fn line(&mut self, text: &str) {
        let mut at = 0;
        for (span, body) in words::dollars(text) {
            self.text(text.get(at..span.start).unwrap_or_default());
            self.write(&(self.math)(text.get(body.range()).unwrap_or_default()));
            at = span.end;
        }
        self.text(text.get(at..).unwrap_or_default());
    }

    /// Text without mathematics.
    fn text(&mut self, text: &str) {
        let mut reader = Reader { rest: text };
        while let Some(c) = reader.rest.chars().next() {
            if let Some((typed, shown)) = latex_words::ligature(reader.rest) {
                reader.skip(typed.len());
                self.write(shown);
                continue;
            }
            match c {
                '\\' => {
                    reader.skip(1);
                    let name = reader.name();
                    self.command(name, &mut reader);
                }
                '{' => {
                    reader.skip(1);
                    self.groups.push("");
                }
                '}' => {
                    reader.skip(1);
                    self.end_group();
                }
                '~' => {
                    reader.skip(1);
                    self.write("\u{a0}");
                }
                c if c.is_whitespace() => {
                    let blank = reader.run(char::is_whitespace);
                    match blank.matches('\n').count() {
                        0 | 1 => self.write(blank),
                        _ => self.end_paragraph(),
                    }
                }
                '-' => {
                    reader.skip(1);
                    self.write("-");
                }
                _ => {
                    let plain = reader.run(|c| !c.is_whitespace() && !"\\{}~-`'".contains(c));
                    self.write(&escape(plain));
                }
            }
        }
    }

    fn command(&mut self, name: &str, reader: &mut Reader<'_>) {
        let Some(command) = latex_words::command(name) else {
            // What is not known: the text of its arguments, which are groups.
            reader.options();
            return;
        };
        // A space behind a word only ends it.
        if name.starts_with(|c: char| c.is_ascii_alphabetic()) {
            reader.blank();
        }
        match command {
            Command::Around(before, after) => {
                if reader.take("{") {
                    self.begin_group(before, after);
                }
            }
            Command::Switch(before, after) => {
                if self.groups.last() == Some(&"") {
                    self.groups.pop();
                    self.begin_group(before, after);
                }
            }
            Command::Sign(sign) => {
                self.write(sign);
                if sign.starts_with("<br") {
                    reader.take("*");
                    reader.options();
                }
            }
            Command::Accent(mark) => {
                let argument = reader.argument();
                let mut letters = argument.trim_start_matches('\\').chars();
                if let Some(letter) = letters.next() {
                    self.write(&escape(&format!("{letter}{mark}{}", letters.as_str())));
                }
            }
            Command::Dropped(arguments) => {
                reader.options();
                for _ in 0..arguments {
                    reader.argument();
                }
            }
            Command::Numbers(parentheses) => self.cited(reader.argument(), parentheses),
            Command::Keys => {
                let note = reader.options();
                reader.options();
                let note = note.map_or(String::new(), |note| format!(", {note}"));
                let keys: Vec<&str> = reader.argument().split(',').map(str::trim).collect();
                let shown = format!("[{}{note}]", keys.join(", "));
                self.write(&escape(&shown.replace('~', "\u{a0}")));
            }
            Command::Code => {
                let code = escape(reader.argument());
                self.write(&format!("<code>{code}</code>"));
            }
            Command::Begin => self.begin(reader),
            Command::End => {
                if latex_words::list(reader.argument()).is_some() {
                    self.end_list();
                }
            }
            Command::Item => {
                self.end_paragraph();
                self.entry();
                if let Some(name) = reader.options() {
                    self.write(&format!("<strong>{}</strong> ", escape(name)));
                    reader.blank();
                }
            }
            Command::Paragraph => self.end_paragraph(),
        }
    }

    /// The numbers of equations on the page, as links; the keys of anything else.
    fn cited(&mut self, keys: &str, parentheses: bool) {
        for (at, key) in keys.split(',').map(str::trim).enumerate() {
            if at > 0 {
                self.write(", ");
            }
            let equation = self.page.anchors.by_key(key);
            let number = equation.and_then(|at| self.page.report.equation(at).label());
            let shown = match parentheses {
                true => format!("({})", number.unwrap_or(key)),
                false => number.unwrap_or(key).to_owned(),
            };
            match equation {
                Some(equation) => self.link(equation, &shown),
                None => self.write(&escape(&shown)),
            }
        }
    }

    fn link(&mut self, equation: usize, shown: &str) {
        let target = self.page.anchors.equation(equation);
        self.write(&format!("<a href=\"#{target}\">{}</a>", escape(shown)));
    }

    fn begin(&mut self, reader: &mut Reader<'_>) {
        let environment = reader.argument();
        if let Some((opening, closing)) = latex_words::list(environment) {
            reader.options();
            self.begin_list(opening, closing);
        } else {
            reader.options();
            for _ in 0..latex_words::arguments(environment) {
                reader.argument();
            }
        }
    }

    /// Markup within a paragraph, which begins with it where there is none.
    fn write(&mut self, markup: &str) {
        let is_blank = markup.chars().all(|c| c.is_whitespace() && c != '\u{a0}');
        if is_blank && !self.paragraph {
            if self.in_line && !self.out.is_empty() {
                self.out += markup;
            }
            return;
        }
        if !self.in_line && !self.paragraph {
            self.within_list();
            self.out += "<p>";
            self.paragraph = true;
        }
        self.out += markup;
    }

    fn begin_group(&mut self, before: &str, after: &'static str) {
        let tags = self.groups.iter().filter(|close| !close.is_empty());
        if tags.count() >= DEEPEST {
            self.groups.push("");
            return;
        }
        self.write(before);
        self.groups.push(after);
    }

    fn end_group(&mut self) {
        self.out += self.groups.pop().unwrap_or_default();
    }

    /// Ends the paragraph and all groups in it; their braces still pair.
    fn end_paragraph(&mut self) {
        for close in self.groups.iter_mut().rev() {
            self.out += std::mem::take(close);
        }
        if std::mem::take(&mut self.paragraph) {
            self.out.truncate(self.out.trim_end().len());
            self.out += "</p>\n";
        }
    }

    /// Something that is no part of a paragraph.
    fn block(&mut self, markup: &str) {
        self.end_paragraph();
        self.within_list();
        self.out += markup;
    }

    fn display(&mut self, at: usize) {
        self.block(&self.page.equation(at));
    }

    fn begin_list(&mut self, opening: &str, closing: &'static str) {
        if self.lists.len() < DEEPEST {
            self.block(opening);
            self.lists.push(List {
                closing,
                entry: false,
            });
        }
    }

    /// In a list everything stands in an entry.
    fn within_list(&mut self) {
        if self.lists.last().is_some_and(|list| !list.entry) {
            self.entry();
        }
    }

    /// Begins an entry of the innermost list.
    fn entry(&mut self) {
        if let Some(list) = self.lists.last_mut() {
            self.out += if list.entry { "</li>\n<li>" } else { "<li>" };
            list.entry = true;
        }
    }

    fn end_list(&mut self) {
        self.end_paragraph();
        if let Some(list) = self.lists.pop() {
            self.out += if list.entry { "</li>\n" } else { "" };
            self.out += list.closing;
        }
    }

    fn end_lists(&mut self) {
        while !self.lists.is_empty() {
            self.end_list();
        }
    }
}

/// A list that is open.
struct List {
    closing: &'static str,
    /// Whether an entry is.
    entry: bool,
}
