//! Words in parentheses that are the number of no display: "Exercise 1 (Heron). Let" cites nothing.

use std::collections::BTreeSet;

use crate::document::{Citation, Prose};

/// A shorter one, "(A)", "(ii)", may be the number of a display on another page.
const FEWEST_LETTERS: usize = 4;
/// The numbers that are written out.
const TAGS: [&str; 2] = ["\\tag{", "\\tag*{"];

/// The words that are numbers of displays: `\tag{Newton}`.
pub(super) struct Names(BTreeSet<String>);

impl Names {
    /// Those of a document.
    pub(super) fn of(source: &str) -> Names {
        let tags = TAGS
            .iter()
            .flat_map(|command| source.split(command).skip(1));
        let tags = tags.filter_map(|rest| Some(rest.split_once('}')?.0));
        Names(tags.map(|tag| unparenthesised(tag).to_owned()).collect())
    }

    /// A text without what it cites by words that are no such numbers; nothing where it cites nothing so.
    pub(super) fn without_asides(&self, prose: &Prose) -> Option<Prose> {
        let cites = |own: &Citation| !self.is_aside(own);
        if prose.citations.iter().all(cites) {
            return None;
        }
        let count = |own: &[Citation]| own.iter().filter(|own| cites(own)).count();
        let before = prose.citations.len() - prose.closing;
        let mut prose = prose.clone();
        prose.closing = count(&prose.citations[before..]);
        prose.tail = count(&prose.citations[..prose.tail]);
        prose.citations.retain(cites);
        Some(prose)
    }

    fn is_aside(&self, citation: &Citation) -> bool {
        let tag = citation.tag.as_str();
        let is_word =
            tag.len() >= FEWEST_LETTERS && tag.chars().all(|c| c.is_alphabetic() || c == '-');
        is_word && !citation.explicit && !citation.key && !self.0.contains(tag)
    }
}

fn unparenthesised(tag: &str) -> &str {
    let tag = tag.trim();
    let inner = tag.strip_prefix('(').and_then(|tag| tag.strip_suffix(')'));
    inner.unwrap_or(tag)
}
