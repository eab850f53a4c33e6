//! Directives of MyST whose content is Markdown: ```` ```{note} ````. A general Markdown reader takes them for code.

use super::Span;

/// The directives whose content is read; `{code-block}`, `{python}` and whatever else there is hold code.
const CONTENT: &[&str] = &[
    "admonition",
    "algorithm",
    "aside",
    "assumption",
    "attention",
    "axiom",
    "blockquote",
    "card",
    "caution",
    "conjecture",
    "container",
    "corollary",
    "criterion",
    "danger",
    "definition",
    "deprecated",
    "details",
    "div",
    "dropdown",
    "epigraph",
    "error",
    "example",
    "exercise",
    "figure",
    "glossary",
    "grid",
    "grid-item",
    "grid-item-card",
    "highlights",
    "hint",
    "important",
    "lemma",
    "list-table",
    "margin",
    "note",
    "observation",
    "proof",
    "property",
    "proposition",
    "pull-quote",
    "remark",
    "seealso",
    "sidebar",
    "solution",
    "tab-item",
    "tab-set",
    "table",
    "theorem",
    "tip",
    "todo",
    "toggle",
    "topic",
    "versionadded",
    "versionchanged",
    "warning",
];

/// Whether a fenced block of this language is a directive with Markdown in it.
pub(super) fn holds_markdown(language: &str) -> bool {
    let name = language
        .trim()
        .strip_prefix('{')
        .and_then(|rest| rest.split_once('}'))
        .map(|(name, _)| name.trim());
    name.is_some_and(|name| name.starts_with("prf:") || CONTENT.contains(&name))
}

/// What is no Markdown of such a block: its first line, its options between lines of `---`, and the line that closes it.
pub(super) struct Frame {
    /// The fence and the name: no text at all.
    pub silent: [Span; 3],
    /// Whole lines, which no reader of Markdown is to see.
    pub lines: [Span; 3],
}

/// The frame of a directive at this place of the text.
pub(super) fn frame(text: &str, block: Span) -> Frame {
    let own = &text[block.range()];
    let nothing = Span::new(block.end, block.end);
    let first = own.find(['\n', '\r']).unwrap_or(own.len());
    let name = own[..first].find('}').map_or(first, |at| at + 1);
    let mark = own.chars().next().unwrap_or('`');
    let below = own[first..]
        .find('\n')
        .map_or(own.len(), |at| first + at + 1);
    let mut options = nothing;
    let mut end = below;
    for (at, line) in own[below..].split_inclusive('\n').enumerate() {
        end += line.len();
        match (at, line.trim() == "---") {
            (0, false) => break,
            (0, true) | (_, false) => {}
            (_, true) => {
                options = Span::new(block.start + below, block.start + end);
                break;
            }
        }
    }
    let written = own.trim_end();
    let last = written
        .rfind(['\n', '\r'])
        .map_or(written.len(), |at| at + 1);
    let closing = written[last..].trim_start_matches([' ', '\t', '>']);
    let closes = closing.len() >= 3 && closing.chars().all(|c| c == mark);
    let end = block.start + written.len();
    let closing = match closes {
        true => Span::new(end - closing.len(), end),
        false => nothing,
    };
    let opening = |length| Span::new(block.start, block.start + length);
    Frame {
        silent: [opening(name), options, closing],
        lines: [opening(first), options, closing],
    }
}
