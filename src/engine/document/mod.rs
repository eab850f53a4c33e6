//! Documents as their authors wrote them: where the displayed equations are, what is said between
//! them, and what the `check:` comments declare. Every byte keeps its place.
//!
//! Nothing here knows mathematics. A document becomes a list of [`Item`]s in source order and a
//! list of [`Problem`]s; **whatever looks like an equation ends up in one of the two**. A general
//! Markdown reader is asked only where code, HTML and headings are (`outline`): it would take a
//! `$$` block with a blank line for prose, so it never decides what an equation is. The scanner
//! (`markdown`) does that on the raw bytes; `prose` then reads citations and suppositions,
//! `directive` the comments. A LaTeX document (`latex`) is first put together from its files and
//! macros, a notebook (`notebook`) from its cells; `origin` leads back to what the author saved.

mod attribute;
mod circumstance;
mod citation;
mod conclusion;
mod data;
mod directive;
mod inserted;
mod item;
mod latex;
mod markdown;
mod moved;
mod nearest;
mod notebook;
mod number;
mod origin;
mod outline;
mod prose;
mod qualities;
mod quantity;
mod slope;
mod source;
mod span;
mod supposition;
mod tables;
mod words;
pub(crate) use supposition::{GENERAL, is_everywhere, is_reason, is_tried};

use std::sync::Arc;

pub use attribute::declaration;
pub(crate) use citation::above_signs;
pub use inserted::Inserted;
pub use item::{
    Attribute, Bound, Citation, Directive, Extent, Inline, Item, Layout, Named, Premise, Problem,
    Prose, Qualities, Row, Slope, Supposition, SuppositionKind, Vanishing,
};
pub use latex::Library;
pub use nearest::nearest;
pub use notebook::NotANotebook;
pub use origin::{Cell, File, Origin};
pub use outline::front_matter;
pub use quantity::{Quantity, Subject};
pub use source::{NotUtf8, Position, next_command};
pub use span::Span;
pub use tables::{Cell as TableCell, TableRow};

/// A document, read.
#[derive(Clone, Debug)]
pub struct Document {
    /// Where it came from, as it should be named in findings.
    pub path: String,
    /// The text that its spans are places in: that of the file, or what was put together.
    pub source: Arc<str>,
    /// Headings, displays, directives and the prose between them, in source order.
    pub items: Vec<Item>,
    /// Declarations of the preamble, which hold here too; their problems are told elsewhere.
    pub inherited: Vec<Item>,
    /// What could not be read, in source order.
    pub problems: Vec<Problem>,
    /// It was written in LaTeX, which counts equations itself.
    pub is_latex: bool,
    /// Where the text comes from. Documents of one LaTeX run share it.
    pub origin: Arc<Origin>,
    /// A file beside it that speaks of it too; its places are those past the end of the text.
    pub beside: Option<Arc<File>>,
}

impl Document {
    /// The text between headings, displays and directives, in source order.
    pub fn prose(&self) -> impl Iterator<Item = &Prose> {
        self.items.iter().filter_map(|item| match item {
            Item::Prose(prose) => Some(&**prose),
            _ => None,
        })
    }

    /// The mathematics in the text, in source order.
    pub fn inline(&self) -> impl Iterator<Item = &Inline> {
        self.prose().flat_map(|prose| &prose.math)
    }

    /// The mathematics in the text from one place to another, in source order.
    pub fn inline_between(&self, from: usize, to: usize) -> impl Iterator<Item = &Inline> {
        let first = self.items.partition_point(|item| item.span().end <= from);
        let within = self.items[first..].iter();
        let within = within.take_while(move |item| item.span().start < to);
        let math = within.flat_map(|item| match item {
            Item::Prose(prose) => prose.math.as_slice(),
            _ => &[],
        });
        math.filter(move |math| from <= math.span.start && math.span.end <= to)
    }

    /// Reads a Markdown document. Never fails: what is amiss is in [`Document::problems`].
    pub fn markdown(path: impl Into<String>, source: impl Into<Arc<str>>) -> Document {
        let source = source.into();
        let path = path.into();
        let reading = markdown::read(&source);
        Document {
            origin: Arc::new(Origin::whole(path.clone(), source.clone())),
            path,
            source,
            items: reading.items,
            inherited: Vec::new(),
            problems: reading.problems,
            is_latex: false,
            beside: None,
        }
    }

    /// Reads a LaTeX document with all that it inputs: one document for the file itself, and one for every file that it
    /// takes in by `\include`. Never fails: what is amiss is in [`Document::problems`].
    ///
    /// `library` is asked for the files that it names; it finds none for a text that stands alone.
    pub fn latex(
        path: impl Into<String>,
        source: impl Into<Arc<str>>,
        library: &dyn Library,
    ) -> Vec<Document> {
        latex::read(path.into(), source.into(), library)
    }

    /// Reads the Markdown cells of a Jupyter notebook; their places are lines and columns of the cell.
    ///
    /// # Errors
    /// The text is no notebook.
    pub fn notebook(path: impl Into<String>, text: &str) -> Result<Document, NotANotebook> {
        notebook::read(path.into(), text)
    }

    /// The file that a span comes from, and where in it.
    pub fn written_at(&self, span: Span) -> (&File, Span) {
        let past = self.source.len() + 1;
        if let (Some(file), Some(start)) = (&self.beside, span.start.checked_sub(past)) {
            return (file, Span::new(start, span.end.saturating_sub(past)));
        }
        let (file, span) = self.origin.of(span);
        // There is always a first file.
        (
            self.origin.files.get(file).unwrap_or(&self.origin.files[0]),
            span,
        )
    }

    /// A place in the file beside it as a place of the document.
    pub fn beside_at(&self, span: Span) -> Span {
        let past = self.source.len() + 1;
        Span::new(past + span.start, past + span.end)
    }

    /// The path, line and column of a span, for an editor to go to.
    pub fn place(&self, span: Span) -> (&str, Position) {
        let (file, span) = self.written_at(span);
        (&file.path, file.position(span.start))
    }

    /// The line and column of a byte in its file; past the end, those of the end.
    pub fn position(&self, offset: usize) -> Position {
        self.place(Span::new(offset, offset)).1
    }

    /// The text of a span; empty if the span is not one of this document's.
    pub fn text(&self, span: Span) -> &str {
        self.source.get(span.range()).unwrap_or_default()
    }

    /// What the author wrote for a span, before any macro was put in.
    pub fn written(&self, span: Span) -> &str {
        let (file, span) = self.written_at(span);
        file.source.get(span.range()).unwrap_or_default()
    }
}

/// The bytes of a document as text, which must be UTF-8.
///
/// # Errors
/// They are not.
pub fn decode(bytes: &[u8]) -> Result<&str, NotUtf8> {
    source::decode(bytes)
}

/// Reads a Markdown document from bytes, which must be UTF-8.
pub fn read_bytes(path: impl Into<String>, bytes: &[u8]) -> Result<Document, NotUtf8> {
    Ok(Document::markdown(path, source::decode(bytes)?))
}
