//! What a statement, and a remark about it, is known by from one run to the next.
//!
//! A fingerprint is made of what is said and not of where: the content of a statement as canonical LaTeX. Moving a paragraph,
//! another number, or another way to type the same formula changes none; another formula does.

use crate::audit::Entry;
use crate::notation::latex_statement;
use crate::sorted::Tree;

use super::Report;

/// The hash of Fowler, Noll and Vo (FNV-1a, 64 bits): the same on every machine and in every version.
fn hash(parts: &[&str]) -> u64 {
    let mut hash: u64 = 0xcbf2_9ce4_8422_2325;
    for part in parts {
        // The end of a part counts, so that `ab`, `c` is not `a`, `bc`.
        for byte in part.bytes().chain([0xff]) {
            hash = (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }
    hash
}

/// The fingerprint of something said, `0123456789abcdef`.
pub(super) fn fingerprint(parts: &[&str]) -> String {
    format!("{:016x}", hash(parts))
}

/// Numbers what has the same hash, in reading order.
#[derive(Debug, Default)]
pub(super) struct Fingerprints {
    seen: Tree<String, usize>,
}

impl Fingerprints {
    /// `0123456789abcdef`, with `:2` behind the second that is the same.
    pub(super) fn of(&mut self, parts: &[&str]) -> String {
        let own = fingerprint(parts);
        let seen = self.seen.entry(own.clone()).or_default();
        *seen += 1;
        match *seen {
            1 => own,
            more => format!("{own}:{more}"),
        }
    }
}

impl Report<'_> {
    /// What an entry states, as it is compared: canonical LaTeX, or the author's words where they could not be read.
    pub(super) fn content(&self, entry: usize) -> String {
        let entry = &self.audit.entries[entry];
        match self.statement(entry) {
            Some(statement) => latex_statement(statement),
            None => {
                let equation = self.equation(entry.equation);
                let document = &self.derivation.pages[equation.page].document;
                let text = spaced(document.text(equation.body));
                match &equation.tag {
                    // The number is no part of what is said.
                    Some(tag) => text
                        .replace(&format!("\\tag{{{tag}}}"), "")
                        .trim_end()
                        .to_owned(),
                    None => text,
                }
            }
        }
    }

    /// The number or name of an entry's equation, with the part of a display that states several things.
    pub(super) fn key(&self, entry: usize) -> String {
        let entry = &self.audit.entries[entry];
        let equation = self.equation(entry.equation);
        let label = match (&equation.tag, &equation.name) {
            (Some(tag), _) => format!("({tag})"),
            (None, Some(name)) => name.clone(),
            (None, None) => String::new(),
        };
        self.with_part(entry, label)
    }

    /// The name that the author gave an entry's equation, a claim's or a key, with the part as above; empty where there is none.
    pub(super) fn given_name(&self, entry: usize) -> String {
        let entry = &self.audit.entries[entry];
        let equation = self.equation(entry.equation);
        match equation.name.as_ref().or(equation.keys.first()) {
            Some(name) => self.with_part(entry, name.clone()),
            None => String::new(),
        }
    }

    fn with_part(&self, entry: &Entry, label: String) -> String {
        match self.part_of(entry) {
            None => label,
            Some((part, parts)) => format!("{label} {part}/{parts}").trim_start().to_owned(),
        }
    }
}

/// The same words with one space between them.
pub(super) fn spaced(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}
