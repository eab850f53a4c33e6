//! Tables of TOML entry by entry, in the order of the file; what is not as it should be is a problem at its place.

use toml::Spanned as Toml;
use toml::de::{DeTable, DeValue};

use super::{kind, place, shown};
use crate::document::nearest;
use crate::document::{Problem, Span};
use crate::notation::Spanned;
use crate::sorted;

/// A key with its value.
pub(super) struct Entry<'t, 'i> {
    pub key: &'t str,
    /// With its quotes, where it has some.
    pub key_span: Span,
    pub value: &'t Toml<DeValue<'i>>,
}

/// A file that is being read, and what was found wrong with it so far.
pub(super) struct Reader<'s> {
    pub source: &'s str,
    pub problems: Vec<Problem>,
}

impl<'s> Reader<'s> {
    pub fn new(source: &'s str) -> Self {
        Reader {
            source,
            problems: Vec::new(),
        }
    }

    pub fn complain(&mut self, span: Span, message: String, help: impl Into<String>) {
        self.problems.push(Problem::new(span, message, help));
    }

    /// A key that is none of those that may stand here.
    pub fn unknown(&mut self, entry: &Entry<'_, '_>, what: &str, keys: &[&str]) {
        let key = entry.key;
        let help = match nearest(key, keys, slips(key)) {
            Some(near) => format!("did you mean `{near}`?"),
            None if keys.len() > 6 => "docs/notes.md lists them".into(),
            None => {
                let all: Vec<String> = keys.iter().map(|key| format!("`{key}`")).collect();
                format!("there is {}", all.join(", "))
            }
        };
        self.complain(entry.key_span, format!("`{}` {what}", shown(key)), help);
    }

    /// The entries of a table.
    pub fn entries<'t, 'i>(&self, table: &'t DeTable<'i>) -> Vec<Entry<'t, 'i>> {
        let all = table.iter().map(|(key, value)| Entry {
            key: key.get_ref().as_ref(),
            key_span: place(key),
            value,
        });
        let mut all: Vec<Entry<'t, 'i>> = all.collect();
        sorted::sort_by_key(&mut all, |entry| entry.key_span);
        all
    }

    /// The entries of a value that must be a table.
    pub fn table<'t, 'i>(&mut self, entry: &Entry<'t, 'i>, example: &str) -> Vec<Entry<'t, 'i>> {
        match entry.value.get_ref() {
            DeValue::Table(table) => self.entries(table),
            other => {
                self.mistaken(entry, other, "a table", example);
                Vec::new()
            }
        }
    }

    /// A value that must be a text, with the place of what stands between its quotes.
    pub fn text(&mut self, entry: &Entry<'_, '_>, example: &str) -> Option<Spanned<String>> {
        match entry.value.get_ref() {
            DeValue::String(text) => Some(self.inside(text, place(entry.value))),
            other => {
                self.mistaken(entry, other, "a text", example);
                None
            }
        }
    }

    /// A value that must be a list of texts.
    pub fn texts(&mut self, entry: &Entry<'_, '_>, example: &str) -> Vec<Spanned<String>> {
        let DeValue::Array(all) = entry.value.get_ref() else {
            self.mistaken(entry, entry.value.get_ref(), "a list of texts", example);
            return Vec::new();
        };
        let mut texts = Vec::new();
        for one in all.iter() {
            match one.get_ref() {
                DeValue::String(text) => texts.push(self.inside(text, place(one))),
                other => {
                    let message = format!(
                        "`{}` is a list of texts, and this is {}",
                        entry.key,
                        kind(other)
                    );
                    self.complain(place(one), message, format!("write {example}"));
                }
            }
        }
        texts
    }

    /// A value that must be a whole number from 1 on.
    pub fn number(&mut self, entry: &Entry<'_, '_>, most: usize) -> Option<usize> {
        let help = format!("it is a whole number from 1 to {most}");
        let DeValue::Integer(number) = entry.value.get_ref() else {
            self.mistaken(entry, entry.value.get_ref(), "a whole number", &help);
            return None;
        };
        let read = usize::from_str_radix(number.as_str(), number.radix()).ok();
        let read = read.filter(|number| (1..=most).contains(number));
        if read.is_none() {
            let message = format!("`{}` cannot be {number}", entry.key);
            self.complain(place(entry.value), message, help);
        }
        read
    }

    fn mistaken(&mut self, entry: &Entry<'_, '_>, is: &DeValue<'_>, wanted: &str, help: &str) {
        let message = format!(
            "`{}` is {wanted}, and this is {}",
            shown(entry.key),
            kind(is)
        );
        let help = match help.starts_with('`') {
            true => format!("write {help}"),
            false => help.to_owned(),
        };
        self.complain(place(entry.value), message, help);
    }

    /// A text with its place: what stands between the quotes, and all of it where it is spelt with escapes.
    pub fn inside(&self, text: &str, whole: Span) -> Spanned<String> {
        let written = self.source.get(whole.range()).unwrap_or_default();
        let span = match written.find(text) {
            Some(at) => Span::new(whole.start + at, whole.start + at + text.len()),
            None => whole,
        };
        Spanned {
            value: text.to_owned(),
            span,
        }
    }
}

/// How many letters a misspelt key may be off.
fn slips(key: &str) -> usize {
    (key.chars().count() / 3).clamp(1, 3)
}
