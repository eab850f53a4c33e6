//! A Markdown document as a Markdown reader sees it, with its displays and its mathematics put back.
//!
//! The reader is shown the source with every formula blanked out to the same length, so that places stay places and
//! nothing inside mathematics can mean emphasis or a table. Tags are opened only when something stands in them, and
//! a display closes what it cannot stand in: a paragraph around it goes on below as another.

use std::collections::{BTreeMap, BTreeSet};

use pulldown_cmark::{Alignment, Event, Options, Parser, Tag, TagEnd};

use crate::document::{Document, Span, front_matter};
use crate::notation::escape;

use super::super::{Page, anchors, words};
use super::spots::{Kind, Piece, Spots};

pub(super) fn walk(page: &Page<'_>, at: usize) -> String {
    let document = &page.report.derivation.pages[at].document;
    let spots = Spots::of(page, at);
    let from = front_matter(&document.source);
    let text = blanked(&document.source, from, &spots);
    let mut walk = Walk {
        page,
        document,
        spots,
        out: String::new(),
        open: Vec::new(),
        head: false,
        columns: Vec::new(),
        column: 0,
        notes: format!("{}:note", anchors::document(at)),
        numbers: BTreeMap::new(),
        noted: BTreeSet::new(),
        linked: 0,
        comment: false,
    };
    let options = Options::ENABLE_TABLES
        | Options::ENABLE_STRIKETHROUGH
        | Options::ENABLE_FOOTNOTES
        | Options::ENABLE_TASKLISTS;
    for (event, range) in Parser::new_ext(&text, options).into_offset_iter() {
        walk.event(event, range.start + from..range.end + from);
    }
    walk.missed(usize::MAX);
    walk.out
}

/// The source from a byte on, each formula a word between dollars, as long as it was.
fn blanked(source: &str, from: usize, spots: &Spots<'_>) -> String {
    let mut text = String::with_capacity(source.len());
    let mut at = from;
    for spot in &spots.all {
        let cited = matches!(spot.kind, Kind::Cited(_));
        if cited || spot.span.start < at {
            continue;
        }
        text += source.get(at..spot.span.start).unwrap_or_default();
        let length = spot.span.end - spot.span.start;
        let inside = length.saturating_sub(2);
        text += if length > 1 { "$" } else { "" };
        text.extend(std::iter::repeat_n('x', inside));
        text += "$";
        at = spot.span.end;
    }
    text + source.get(at..).unwrap_or_default()
}

/// A line of Markdown, as a title is: emphasis, code, and mathematics between dollars.
pub(super) fn line(text: &str, math: fn(&str) -> String) -> String {
    const HEAD: &str = "# ";
    let found = words::dollars(text);
    let mut blank = HEAD.to_owned() + text;
    for (_, body) in &found {
        let inside = body.start + HEAD.len()..body.end + HEAD.len();
        blank.replace_range(inside.clone(), &"x".repeat(inside.len()));
    }
    let mut out = String::new();
    for (event, range) in Parser::new(&blank).into_offset_iter() {
        match event {
            Event::Text(shown) => {
                // Mathematics between dollars is one piece of text, or in one.
                let own = |span: Span| range.contains(&(span.start + HEAD.len()));
                let mut at = range.start - HEAD.len();
                for (span, body) in found.iter().filter(|(span, _)| own(*span)) {
                    out += &escape(text.get(at..span.start).unwrap_or_default());
                    out += &math(text.get(body.range()).unwrap_or_default());
                    at = span.end;
                }
                out += &match at + HEAD.len() == range.start {
                    true => escape(&shown),
                    false => escape(text.get(at..range.end - HEAD.len()).unwrap_or_default()),
                };
            }
            Event::Code(shown) => out += &format!("<code>{}</code>", escape(&shown)),
            Event::Html(shown) | Event::InlineHtml(shown) => out += &escape(&shown),
            Event::Start(Tag::Emphasis) => out += "<em>",
            Event::End(TagEnd::Emphasis) => out += "</em>",
            Event::Start(Tag::Strong) => out += "<strong>",
            Event::End(TagEnd::Strong) => out += "</strong>",
            _ => {}
        }
    }
    out
}

/// A tag that is open.
struct Open {
    opening: String,
    closing: String,
    /// Whether a display must not stand in it.
    is_narrow: bool,
    written: bool,
}

struct Walk<'p, 'a> {
    page: &'p Page<'a>,
    document: &'p Document,
    spots: Spots<'a>,
    out: String,
    open: Vec<Open>,
    /// In the head of a table.
    head: bool,
    /// How the columns of the table are aligned, and which one is next.
    columns: Vec<Alignment>,
    column: usize,
    /// What the footnotes of this document are called in links begins so.
    notes: String,
    /// The number of each footnote, and those that have been set.
    numbers: BTreeMap<String, usize>,
    noted: BTreeSet<usize>,
    /// How many links are open.
    linked: usize,
    /// In a comment that goes on over several lines of HTML.
    comment: bool,
}

impl Walk<'_, '_> {
    fn event(&mut self, event: Event<'_>, range: std::ops::Range<usize>) {
        match event {
            Event::Start(tag) => {
                self.missed(range.start);
                self.start(tag);
            }
            Event::End(tag) => self.end(tag),
            Event::Text(text) => self.text(&text, &range, escape),
            Event::InlineHtml(text) if is_break(&text) => self.write("<br/>\n"),
            Event::FootnoteReference(label) => self.note(&label),
            Event::TaskListMarker(done) => self.write(if done { "☑ " } else { "☐ " }),
            Event::Html(text) | Event::InlineHtml(text) => {
                // Without the markup of comments, and the rest to be seen as it was typed.
                let shown = self.uncommented(&text);
                if shown == *text {
                    self.text(&text, &range, escape);
                    return;
                }
                // Displays in it are kept, and what stands around them is `shown`.
                if self.spots.touches(&range) {
                    self.text("", &range, |_| String::new());
                }
                self.write(&escape(&shown));
            }
            Event::Code(text) => {
                self.missed(range.start);
                self.write(&format!("<code>{}</code>", escape(&text)));
            }
            Event::SoftBreak => self.out.push('\n'),
            Event::HardBreak => self.write("<br/>\n"),
            Event::Rule => self.write("<hr/>\n"),
            _ => {}
        }
    }

    /// Displays that the Markdown reader has not led to.
    fn missed(&mut self, before: usize) {
        for at in self.spots.missed(before) {
            self.display(at);
        }
    }

    /// Text with the spots in it.
    fn text(&mut self, text: &str, range: &std::ops::Range<usize>, shown: impl Fn(&str) -> String) {
        self.missed(range.start);
        if !self.spots.touches(range) {
            self.write(&shown(text));
            return;
        }
        let mut pieces: Vec<Result<String, usize>> = Vec::new();
        let (page, document, linked) = (self.page, self.document, self.linked > 0);
        self.spots.pass(range, |piece| {
            pieces.push(match piece {
                Piece::Text(text) => Ok(shown(text)),
                Piece::Spot(spot) => match spot.kind {
                    Kind::Display(at) => Err(at),
                    Kind::Math(body) => Ok(words::inline(document.text(body))),
                    Kind::Cited(_) if linked => Ok(escape(document.text(spot.span))),
                    Kind::Cited(at) => Ok(format!(
                        "<a href=\"#{}\">{}</a>",
                        page.anchors.equation(at),
                        escape(document.text(spot.span))
                    )),
                },
            });
        });
        for piece in pieces {
            match piece {
                Ok(text) => self.write(&text),
                Err(at) => self.display(at),
            }
        }
    }

    /// Writes markup, after the tags that are waiting. White space opens none.
    fn write(&mut self, text: &str) {
        if text.trim().is_empty() {
            if self.open.last().is_none_or(|open| open.written) {
                self.out += text;
            }
            return;
        }
        self.opened();
        self.out += text;
    }

    fn opened(&mut self) {
        for open in self.open.iter_mut().filter(|open| !open.written) {
            self.out += &open.opening;
            open.written = true;
        }
    }

    fn display(&mut self, at: usize) {
        let narrow = self
            .open
            .iter()
            .rev()
            .take_while(|open| open.is_narrow)
            .count();
        let first = self.open.len() - narrow;
        for open in self.open.iter_mut().skip(first).rev().filter(|o| o.written) {
            self.out += &open.closing;
            open.written = false;
        }
        for open in self.open.iter_mut().take(first).filter(|o| !o.written) {
            self.out += &open.opening;
            open.written = true;
        }
        self.out += &self.page.equation(at);
    }

    /// Opens something: at once what a display may stand in, and else when something is in it.
    fn push(&mut self, opening: impl Into<String>, closing: impl Into<String>, is_narrow: bool) {
        self.open.push(Open {
            opening: opening.into(),
            closing: closing.into(),
            is_narrow,
            written: false,
        });
        if !is_narrow {
            self.opened();
        }
    }

    fn start(&mut self, tag: Tag<'_>) {
        match tag {
            Tag::Paragraph => self.push("<p>", "</p>\n", true),
            Tag::Heading { level, .. } => {
                let level = (level as u8 + 2).min(6);
                self.push(format!("<h{level}>"), format!("</h{level}>\n"), true);
            }
            Tag::BlockQuote(_) => self.push("<blockquote>\n", "</blockquote>\n", false),
            Tag::CodeBlock(_) => self.push("<pre class=\"typed\"><code>", "</code></pre>\n", true),
            Tag::HtmlBlock => {
                self.comment = false;
                self.push("<pre class=\"typed\"><code>", "</code></pre>\n", true);
            }
            Tag::List(Some(start)) => {
                self.push(format!("<ol start=\"{start}\">\n"), "</ol>\n", false);
            }
            Tag::List(None) => self.push("<ul>\n", "</ul>\n", false),
            Tag::Item => self.push("<li>", "</li>\n", false),
            Tag::Table(columns) => {
                self.columns = columns;
                self.push(
                    "<div class=\"scroll\"><table>\n",
                    "</tbody></table></div>\n",
                    false,
                );
            }
            Tag::FootnoteDefinition(label) => {
                let number = self.number_of(&label);
                // Of several notes with one label the first is led to.
                let name = match self.noted.insert(number) {
                    true => format!(" id=\"{}-{number}\"", self.notes),
                    false => String::new(),
                };
                let opening = format!("<div class=\"footnote\"{name}><sup>{number}</sup>\n");
                self.push(opening, "</div>\n", false);
            }
            Tag::TableHead => {
                (self.head, self.column) = (true, 0);
                self.push("<thead><tr>", "</tr></thead>\n<tbody>\n", false);
            }
            Tag::TableRow => {
                self.column = 0;
                self.push("<tr>", "</tr>\n", false);
            }
            Tag::TableCell => {
                let side = match self.columns.get(self.column) {
                    Some(Alignment::Center) => " class=\"c\"",
                    Some(Alignment::Right) => " class=\"r\"",
                    _ => "",
                };
                self.column += 1;
                match self.head {
                    true => self.push(format!("<th scope=\"col\"{side}>"), "</th>", false),
                    false => self.push(format!("<td{side}>"), "</td>", false),
                }
            }
            Tag::Emphasis => self.push("<em>", "</em>", true),
            Tag::Strong => self.push("<strong>", "</strong>", true),
            Tag::Strikethrough => self.push("<del>", "</del>", true),
            Tag::Link { dest_url, .. } => match is_safe(&dest_url) && self.linked == 0 {
                true => {
                    let opening = format!(
                        "<a rel=\"noopener noreferrer\" href=\"{}\">",
                        escape(&dest_url)
                    );
                    self.push(opening, "</a>", true);
                    self.linked += 1;
                }
                false => {
                    self.push("<span>", "</span>", true);
                    self.linked += 1;
                }
            },
            Tag::Image { .. } => self.push("<span class=\"image\">[image: ", "]</span>", true),
            _ => self.push("<span>", "</span>", true),
        }
    }

    fn end(&mut self, tag: TagEnd) {
        match tag {
            TagEnd::TableHead => self.head = false,
            TagEnd::Link => self.linked = self.linked.saturating_sub(1),
            _ => {}
        }
        if let Some(open) = self.open.pop()
            && open.written
        {
            self.out += &open.closing;
        }
    }

    /// A link to a footnote.
    fn note(&mut self, label: &str) {
        let number = self.number_of(label);
        let shown = match self.linked {
            0 => format!("<a href=\"#{}-{number}\">{number}</a>", self.notes),
            _ => number.to_string(),
        };
        self.write(&format!("<sup>{shown}</sup>"));
    }

    /// Footnotes are counted as the text comes to them.
    fn number_of(&mut self, label: &str) -> usize {
        let next = self.numbers.len() + 1;
        *self.numbers.entry(label.to_owned()).or_insert(next)
    }

    /// A line of HTML without what is in comments.
    fn uncommented(&mut self, text: &str) -> String {
        let mut kept = String::new();
        let mut rest = text;
        loop {
            let (sign, other) = if self.comment {
                ("-->", false)
            } else {
                ("<!--", true)
            };
            let Some((before, after)) = rest.split_once(sign) else {
                if !self.comment {
                    kept += rest;
                }
                return kept;
            };
            if !self.comment {
                kept += before;
            }
            self.comment = other;
            rest = after;
        }
    }
}

/// Whether HTML is the end of a line: `<br>`.
fn is_break(html: &str) -> bool {
    let name = html
        .trim_start_matches('<')
        .trim_end_matches(['>', '/', ' ']);
    name.eq_ignore_ascii_case("br")
}

/// Whether a link leads somewhere harmless: to the web, or to a file beside the page.
fn is_safe(target: &str) -> bool {
    if target.is_empty()
        || target.contains(|c: char| c.is_control() || c.is_whitespace() || c == '\\')
    {
        return false;
    }
    let lower = target.to_ascii_lowercase();
    if lower.starts_with("https://") || lower.starts_with("http://") {
        return true;
    }
    // A heading of the document has no name on this page.
    let path = target.split(['/', '?', '#']).next().unwrap_or("");
    !path.contains(':') && !target.starts_with("//") && !target.starts_with('#')
}
