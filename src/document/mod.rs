//! Documents as their authors wrote them: where the displayed equations are, what is said between
//! them, and what the `check:` comments declare. Every byte keeps its place.
//!
//! Nothing here knows mathematics. A document becomes a list of [`Item`]s in source order and a
//! list of [`Problem`]s; **whatever looks like an equation ends up in one of the two**. A general
//! Markdown reader is asked only where code, HTML and headings are (`outline`): it would take a
//! `$$` block with a blank line for prose, so it never decides what an equation is. The scanner
//! (`markdown`) does that on the raw bytes; `prose` then reads citations and suppositions,
//! `directive` the comments.

mod attribute;
mod citation;
mod data;
mod directive;
mod in_order;
mod item;
mod markdown;
pub(crate) mod nearest;
mod number;
mod outline;
mod prose;
mod source;
mod span;
mod supposition;

use std::sync::Arc;

pub(crate) use in_order::in_order;
pub use item::{
    Attribute, Bound, Citation, Directive, Inline, Item, Premise, Problem, Prose, Supposition,
    SuppositionKind,
};
pub(crate) use outline::front_matter;
pub use source::{NotUtf8, Position};
pub use span::Span;

/// A document, read.
#[derive(Clone, Debug)]
pub struct Document {
    /// Where it came from, as it should be named in findings.
    pub path: String,
    /// The text, byte for byte as its author saved it.
    pub source: Arc<str>,
    /// Headings, displays, directives and the prose between them, in source order.
    pub items: Vec<Item>,
    /// What could not be read, in source order.
    pub problems: Vec<Problem>,
    lines: source::Lines,
}

impl Document {
    /// Reads a Markdown document. Never fails: what is amiss is in [`Document::problems`].
    pub fn markdown(path: impl Into<String>, source: impl Into<Arc<str>>) -> Document {
        let source = source.into();
        let lines = source::Lines::of(&source);
        let reading = markdown::read(&source);
        Document {
            path: path.into(),
            source,
            items: reading.items,
            problems: reading.problems,
            lines,
        }
    }

    /// The line and column of a byte; past the end, those of the end.
    pub fn position(&self, offset: usize) -> Position {
        self.lines.position(&self.source, offset)
    }

    /// The text of a span; empty if the span is not one of this document's.
    pub fn text(&self, span: Span) -> &str {
        self.source.get(span.range()).unwrap_or_default()
    }
}

/// Reads a Markdown document from bytes, which must be UTF-8.
pub fn read_bytes(path: impl Into<String>, bytes: &[u8]) -> Result<Document, NotUtf8> {
    Ok(Document::markdown(path, source::decode(bytes)?))
}
