//! `cradle.toml`: what an author says once for several documents. `docs/config.md` and `docs/config.schema.json` say the same.
//!
//! A text becomes a [`Config`], or a list of all that is wrong with it, each with its place ([`Amiss`]). Declarations are
//! read by the parser of the `symbols` directive, so that there is one grammar. Nothing here opens a file: which file counts
//! is said by the command line.

mod pattern;
mod symbols;
mod table;

use std::sync::Arc;

use toml::Spanned as Toml;
use toml::de::{DeTable, DeValue};

use crate::derivation::{Beside, Budget, Severity};
use crate::document::nearest;
use crate::document::{File, Problem, Span};
use crate::notation::Spanned;
use crate::report::codes::{self, CODES};
use crate::sorted::{self, Tree};

pub use pattern::{Pattern, matches};
use table::{Entry, Reader};

/// What the file is called.
pub const NAME: &str = "cradle.toml";
/// What may stand at the top of it.
const KEYS: [&str; 5] = ["symbols", "given", "files", "severity", "budget"];
/// What may be limited.
const BUDGETS: [&str; 1] = ["points"];
/// The words for how grave something is.
const SEVERITIES: [(&str, Severity); 4] = [
    ("error", Severity::Error),
    ("warning", Severity::Warning),
    ("note", Severity::Note),
    ("off", Severity::Off),
];
/// Ten times as many points as are tried without a limit: a search must end.
pub const MOST_POINTS: usize = 15_000;

/// A configuration, read.
#[derive(Clone, Debug)]
pub struct Config {
    /// What holds in every document that it stands beside.
    pub beside: Arc<Beside>,
    /// The documents that belong together, as patterns told from its own folder; `None` where it lists none.
    pub files: Option<Vec<Spanned<Pattern>>>,
}

/// What is wrong with a configuration: nothing is read by half.
#[derive(Clone, Debug)]
pub struct Amiss {
    /// The file.
    pub file: Arc<File>,
    /// What is wrong, in the order of the file; never empty.
    pub problems: Vec<Problem>,
}

impl Config {
    /// Reads the text of a configuration; `path` is what it is called in findings.
    ///
    /// # Errors
    /// All that is wrong with it: what is no TOML, keys that are not known, values that say nothing.
    pub fn read(path: &str, text: &str) -> Result<Config, Amiss> {
        let file = Arc::new(File::new(path, text));
        let mut reader = Reader::new(text);
        let (root, errors) = DeTable::parse_recoverable(text);
        // One slip makes many: what comes after the first is guesswork.
        if let Some(error) = errors.first() {
            let at = error.span().unwrap_or_default();
            reader.complain(
                Span::new(at.start, at.end),
                format!("this is no TOML: {}", error.message().trim()),
                "https://toml.io says how it is written",
            );
        }
        let mut config = Config {
            beside: Arc::new(Beside {
                file: Arc::clone(&file),
                symbols: Vec::new(),
                given: Vec::new(),
                severity: Tree::new(),
                budget: Budget::default(),
            }),
            files: None,
        };
        // What is no TOML has no keys that could be trusted.
        if reader.problems.is_empty() {
            config = read(&mut reader, root.get_ref(), config.beside);
        }
        sorted::sort_by_key(&mut reader.problems, |problem| problem.span);
        match reader.problems.is_empty() {
            true => Ok(config),
            false => Err(Amiss {
                file,
                problems: reader.problems,
            }),
        }
    }
}

fn read(reader: &mut Reader<'_>, root: &DeTable<'_>, beside: Arc<Beside>) -> Config {
    let mut beside = Arc::unwrap_or_clone(beside);
    let mut files = None;
    for entry in reader.entries(root) {
        match entry.key {
            "symbols" => beside.symbols = symbols::read(reader, &entry),
            "given" => beside.given = reader.texts(&entry, "`given = [\"3\", \"eq:momentum\"]`"),
            "files" => files = patterns(reader, &entry),
            "severity" => beside.severity = severities(reader, &entry),
            "budget" => beside.budget = budget(reader, &entry),
            _ => reader.unknown(&entry, "is no key of this file", &KEYS),
        }
    }
    for label in &beside.given {
        if label.value.trim().is_empty() {
            let help =
                "an equation is named by its number, `3`, its key, `eq:momentum`, or as a claim";
            reader.complain(label.span, "this names no equation".into(), help);
        }
    }
    reader.problems.extend(beside.problems());
    Config {
        beside: Arc::new(beside),
        files,
    }
}

fn patterns(reader: &mut Reader<'_>, entry: &Entry<'_, '_>) -> Option<Vec<Spanned<Pattern>>> {
    let texts = reader.texts(entry, "`files = [\"paper.tex\", \"chapters/*.md\"]`");
    let mut patterns = Vec::new();
    for text in texts {
        match Pattern::new(&text.value) {
            Ok(value) => patterns.push(Spanned {
                value,
                span: text.span,
            }),
            Err(message) => reader.complain(text.span, message, pattern::HELP),
        }
    }
    Some(patterns)
}

fn severities(reader: &mut Reader<'_>, entry: &Entry<'_, '_>) -> Tree<String, Severity> {
    let mut severities = Tree::new();
    let words = SEVERITIES.map(|(word, _)| word);
    for entry in reader.table(entry, "`[severity]`, and below it `uncited = \"warning\"`") {
        let Some((code, usual)) = CODES.iter().find(|(code, _)| *code == entry.key) else {
            let all: Vec<&str> = reported().collect();
            reader.unknown(&entry, "is no code of a finding or note", &all);
            continue;
        };
        if usual.is_none() {
            let message = format!("`{code}` is a verdict of which nothing is reported");
            reader.complain(entry.key_span, message, "leave it out");
            continue;
        }
        let Some(word) = reader.text(
            &entry,
            "`\"error\"`, `\"warning\"`, `\"note\"` or `\"off\"`",
        ) else {
            continue;
        };
        match SEVERITIES.iter().find(|(own, _)| *own == word.value) {
            Some((_, severity)) => drop(severities.insert((*code).to_owned(), *severity)),
            None => {
                let help = match nearest(&word.value, &words, 2) {
                    Some(near) => format!("did you mean `{near}`?"),
                    None => "it is `error`, `warning`, `note` or `off`".into(),
                };
                let message = format!("`{}` says not how grave it is", shown(&word.value));
                reader.complain(word.span, message, help);
            }
        }
    }
    severities
}

/// The codes that may be told.
fn reported() -> impl Iterator<Item = &'static str> {
    let all = CODES.iter();
    all.filter(|(code, _)| codes::level(code).is_some())
        .map(|(code, _)| *code)
}

fn budget(reader: &mut Reader<'_>, entry: &Entry<'_, '_>) -> Budget {
    let mut budget = Budget::default();
    for entry in reader.table(entry, "`[budget]`, and below it `points = 500`") {
        match entry.key {
            "points" => budget.points = reader.number(&entry, MOST_POINTS),
            _ => reader.unknown(&entry, "is nothing that has a limit", &BUDGETS),
        }
    }
    budget
}

/// Text for a message: no longer than somebody reads.
fn shown(text: &str) -> String {
    text.chars().take(40).collect()
}

/// The place of something in the file.
fn place<T>(of: &Toml<T>) -> Span {
    let at = of.span();
    Span::new(at.start, at.end)
}

/// What a value is, for a message.
fn kind(value: &DeValue<'_>) -> &'static str {
    match value {
        DeValue::String(_) => "a text",
        DeValue::Integer(_) => "a whole number",
        DeValue::Float(_) => "a decimal number",
        DeValue::Boolean(_) => "a truth value",
        DeValue::Datetime(_) => "a date",
        DeValue::Array(_) => "a list",
        DeValue::Table(_) => "a table",
    }
}
