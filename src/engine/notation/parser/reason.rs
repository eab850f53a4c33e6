//! Reasons beside a statement: `a &= b && \text{by (1)}`. They say nothing but what is cited, which is read with the display; a reason in
//! words may be a premise, and is refused.

use super::{Kind, Parser};

/// Words before what is cited.
const CITING: &[&str] = &["by", "from", "using", "see", "with", "via", "cf."];
/// Other words with which a reason begins.
const GIVING: &[&str] = &["since", "because", "as", "due", "for"];
/// Words between what is cited.
const BESIDE: &[&str] = &[
    "and",
    "or",
    "&",
    "eq.",
    "eqs.",
    "equation",
    "equations",
    "eq",
    "eqs",
    "also",
];
/// What begins a citation by its key.
const KEYS: &[&str] = &["\\eqref{", "\\ref{", "(\\ref{", "\\cref{", "\\autoref{"];

/// Whether words beside a statement give a reason for it.
pub(super) fn gives_reason(words: &str) -> bool {
    let first = pieces(words).next();
    first.is_some_and(|first| {
        let first = first.to_lowercase();
        CITING.contains(&first.as_str()) || GIVING.contains(&first.as_str())
    })
}

impl Parser<'_> {
    /// Takes the reason that stands here, if it does no more than cite equations; says whether there was one.
    pub(super) fn reason(&mut self) -> bool {
        let start = self.at;
        let Kind::Text(words) = self.peek() else {
            return false;
        };
        let Some(mut cited) = cited(words) else {
            return false;
        };
        self.advance();
        loop {
            match self.peek() {
                Kind::Reference(_) => cited += 1,
                Kind::Text(words) if matches!(words.trim(), "and" | "," | ")" | "") => {}
                _ => break,
            }
            self.advance();
        }
        let ends = matches!(
            self.peek(),
            Kind::End
                | Kind::Wide
                | Kind::Row
                | Kind::Finish(_)
                | Kind::BoxClose
                | Kind::Char(',' | ';' | '.')
                | Kind::Relation(..)
        );
        if cited == 0 || !ends {
            self.at = start;
            return false;
        }
        true
    }
}

fn pieces(words: &str) -> impl Iterator<Item = &str> {
    let words = words.trim().trim_start_matches(['(', '[']);
    words
        .split(|c: char| c.is_whitespace() || c == '~')
        .filter(|piece| !piece.is_empty())
}

/// How many citations words consist of, after one that introduces them; `None` where they say something else.
fn cited(words: &str) -> Option<usize> {
    let words = words.trim();
    let inside = words.strip_prefix('(').or(words.strip_prefix('['));
    let inside = match inside {
        Some(inside) => inside.strip_suffix([')', ']']).unwrap_or(inside),
        None => words,
    };
    let mut pieces = pieces(inside).map(|piece| piece.trim_end_matches([',', ';']));
    let first = pieces.next()?.to_lowercase();
    if !CITING.contains(&first.as_str()) {
        return None;
    }
    let mut cited = 0;
    for piece in pieces {
        let tag = |own: &str| own.len() > 2 && own.starts_with('(') && own.ends_with(')');
        let key = |own: &str| KEYS.iter().any(|key| own.starts_with(key)) && own.contains('}');
        if tag(piece) || key(piece) {
            cited += 1;
        } else if !BESIDE.contains(&piece.to_lowercase().as_str()) {
            return None;
        }
    }
    Some(cited)
}
