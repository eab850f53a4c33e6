//! What a general Markdown reader is believed about: where code, HTML, quotations, links and
//! headings are. It is never asked what an equation is.
//!
//! It is shown the source with the displays that are already known blanked out, so that a `#`, a
//! back-tick or an `=` alone on its line cannot mean anything inside mathematics.

mod directives;

use std::ops::Range;

use pulldown_cmark::{CodeBlockKind, Event, Options, Parser, Tag, TagEnd};

use super::Span;
use crate::sorted;

/// Directives in directives are hardly ever deeper.
const DEPTH: usize = 8;

/// The parts of a document in which, or because of which, text is not plain text.
#[derive(Debug, Default)]
pub(super) struct Outline {
    /// Headings in order.
    pub headings: Vec<Title>,
    /// Code and HTML in order.
    pub excluded: Vec<Excluded>,
    /// Outermost quotations in order.
    pub quotes: Vec<Span>,
    /// Targets of links in order: text in which nothing is cited.
    pub targets: Vec<Span>,
}

/// A heading.
#[derive(Debug)]
pub(super) struct Title {
    pub level: u8,
    pub span: Span,
    pub content: Span,
    /// `Title` over `=====`, rather than `# Title`.
    pub underlined: bool,
}

/// Text that is not Markdown's.
#[derive(Clone, Copy, Debug)]
pub(super) struct Excluded {
    pub span: Span,
    pub kind: Kind,
}

/// Why text is excluded.
#[derive(Clone, Copy, Debug)]
pub(super) enum Kind {
    Code,
    /// A fenced block in the language `math`, or MyST's `{math}`, which may hold an equation on its first line: an equation after all.
    MathFence {
        body: Span,
    },
    HtmlBlock,
    InlineHtml,
}

impl Outline {
    /// The outline of the source from byte `from` on, `blanked` counting as one long word each.
    pub(super) fn read(source: &str, from: usize, blanked: &[Span]) -> Outline {
        let mut text = blank(source, from, blanked);
        let mut frames: Vec<Span> = Vec::new();
        for _ in 0..DEPTH {
            let found = directives_in(&text);
            if found.is_empty() {
                break;
            }
            for block in found {
                let frame = directives::frame(&text, block);
                let silent = frame.silent.iter().filter(|span| span.start < span.end);
                frames.extend(silent.map(|span| shift(&span.range(), from)));
                for line in frame.lines {
                    text.replace_range(line.range(), &unseen(&text[line.range()]));
                }
            }
        }
        let mut outline = Outline::of(&text, from);
        let code = |span| Excluded {
            span,
            kind: Kind::Code,
        };
        outline.excluded.extend(frames.into_iter().map(code));
        if from > 0 {
            outline.excluded.push(code(Span::new(0, from)));
        }
        sorted::sort_by_key(&mut outline.excluded, |excluded| excluded.span);
        outline
    }

    /// The outline of a text whose places are counted from `from`.
    fn of(text: &str, from: usize) -> Outline {
        let mut outline = Outline::default();
        let parser = Parser::new_ext(text, Options::empty());
        for (_, definition) in parser.reference_definitions().iter() {
            outline.targets.push(shift(&definition.span, from));
        }
        let mut quoted = 0_usize;
        let mut math: Option<(Span, Option<Span>)> = None;
        let mut title: Option<Title> = None;
        // For each open link, where its text ends so far.
        let mut links: Vec<usize> = Vec::new();
        for (event, range) in parser.into_offset_iter() {
            let span = shift(&range, from);
            if let Some(title) = &mut title
                && span.start >= title.content.end
                && span != title.span
            {
                title.content = match title.content {
                    untouched if untouched.start == untouched.end => span,
                    content => content.to(span),
                };
            }
            let mut exclude = |kind| outline.excluded.push(Excluded { span, kind });
            match event {
                Event::Start(Tag::Heading { level, .. }) => {
                    let written = text.get(range).unwrap_or_default().trim();
                    title = Some(Title {
                        level: level as u8,
                        span,
                        content: Span::new(span.start, span.start),
                        underlined: written.contains(['\n', '\r']),
                    });
                }
                Event::End(TagEnd::Heading(_)) => outline.headings.extend(title.take()),
                Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(language)))
                    if language.trim() == "math" || language.trim().starts_with("{math}") =>
                {
                    math = Some((span, None));
                }
                Event::Start(Tag::CodeBlock(_)) | Event::Code(_) => exclude(Kind::Code),
                Event::End(TagEnd::CodeBlock) => {
                    if let Some((span, body)) = math.take() {
                        let body = body.unwrap_or(Span::new(span.end, span.end));
                        let kind = Kind::MathFence { body };
                        outline.excluded.push(Excluded { span, kind });
                    }
                }
                Event::Text(_) => {
                    if let Some((_, body)) = &mut math {
                        *body = Some(body.map_or(span, |body| body.to(span)));
                    }
                }
                Event::Start(Tag::HtmlBlock) => exclude(Kind::HtmlBlock),
                Event::InlineHtml(_) => exclude(Kind::InlineHtml),
                Event::Start(Tag::BlockQuote(_)) => {
                    if quoted == 0 {
                        outline.quotes.push(span);
                    }
                    quoted += 1;
                }
                Event::End(TagEnd::BlockQuote(_)) => quoted = quoted.saturating_sub(1),
                Event::Start(Tag::Link { .. } | Tag::Image { .. }) => links.push(span.start),
                Event::End(TagEnd::Link | TagEnd::Image) => {
                    if let Some(end) = links.pop() {
                        outline.targets.push(Span::new(end, span.end));
                    }
                }
                _ => {}
            }
            if let Some(end) = links.last_mut()
                && span.start > *end
            {
                *end = span.end;
            }
        }
        sorted::sort(&mut outline.targets);
        outline
    }
}

/// The outermost directives that hold Markdown.
fn directives_in(text: &str) -> Vec<Span> {
    // Most documents have none, and are not read twice.
    if !["```{", "~~~{", "``` {", "~~~ {"]
        .iter()
        .any(|fence| text.contains(fence))
    {
        return Vec::new();
    }
    let events = Parser::new_ext(text, Options::empty()).into_offset_iter();
    let found = events.filter_map(|(event, range)| match event {
        Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(language))) => {
            directives::holds_markdown(&language).then(|| shift(&range, 0))
        }
        _ => None,
    });
    found.collect()
}

/// As many bytes of nothing on as many lines.
fn unseen(text: &str) -> String {
    let line_end = |byte| matches!(byte, b'\n' | b'\r');
    let bytes = text.bytes();
    bytes
        .map(|byte| {
            if line_end(byte) {
                char::from(byte)
            } else {
                ' '
            }
        })
        .collect()
}

fn shift(range: &Range<usize>, by: usize) -> Span {
    Span::new(range.start + by, range.end + by)
}

/// The source from `from`, every byte of the blanked spans an `x`, line ends included.
fn blank(source: &str, from: usize, blanked: &[Span]) -> String {
    let mut text = String::with_capacity(source.len() - from);
    let mut at = from;
    for span in blanked {
        text.push_str(source.get(at..span.start).unwrap_or_default());
        text.extend(std::iter::repeat_n('x', span.end - span.start));
        at = span.end;
    }
    text.push_str(source.get(at..).unwrap_or_default());
    text
}

/// Where the document proper begins: after a byte order mark and YAML or TOML front matter. A rule
/// `---` that happens to come first is not front matter: a `key:` must follow.
pub fn front_matter(source: &str) -> usize {
    let start = source.len() - source.trim_start_matches('\u{feff}').len();
    let mut lines = source[start..].split_inclusive('\n');
    let Some(fence @ ("---" | "+++")) = lines.next().map(str::trim_end) else {
        return start;
    };
    let mut at = start + source[start..].find('\n').map_or(0, |end| end + 1);
    for (index, line) in lines.enumerate() {
        at += line.len();
        let text = line.trim_end();
        if text == fence || (fence == "---" && text == "...") {
            return if index > 0 { at } else { start };
        }
        let separator = if fence == "---" { ':' } else { '=' };
        if index == 0 && !text.contains(separator) {
            return start;
        }
    }
    start
}
