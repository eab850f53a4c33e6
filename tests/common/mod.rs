//! The program from outside, for every test that starts it.

use std::collections::BTreeSet;
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::sync::OnceLock;

use cradle_verify::audit::Audit;
use cradle_verify::derivation::Derivation;
use cradle_verify::document::Document;
use cradle_verify::report::Report;
use serde_json::Value;

/// The root of the repository.
pub fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// What is seen in the report on a derivation.
pub fn reported<T>(derivation: &Derivation, look: impl FnOnce(&Report<'_>) -> T) -> T {
    let audit = Audit::of(derivation);
    look(&Report {
        derivation,
        audit: &audit,
        paths: &[],
    })
}

/// What people read of it, without colours.
pub fn human(derivation: &Derivation) -> String {
    reported(derivation, plain)
}

fn plain(report: &Report<'_>) -> String {
    anstream::adapter::strip_str(&report.human(false)).to_string()
}

/// The verdicts of documents, in a word each.
pub fn verdicts_of(documents: Vec<Document>) -> Vec<&'static str> {
    let audit = Audit::of(&Derivation::new(documents));
    let entries = audit.entries.iter();
    entries.map(|entry| entry.verdict.word()).collect()
}

/// The verdicts of a page in Markdown.
pub fn verdicts(text: &str) -> Vec<&'static str> {
    verdicts_of(vec![Document::markdown("page.md", text)])
}

/// The verdict on the last statement of a page in Markdown.
pub fn last(text: &str) -> &'static str {
    last_noted(text).0
}

/// The same, and the codes of its notes.
pub fn last_noted(text: &str) -> (&'static str, Vec<&'static str>) {
    let audit = Audit::of(&Derivation::from_markdown("page.md", text));
    let last = audit.entries.last().expect("a statement");
    let codes = last.notes.iter().map(|note| note.code()).collect();
    (last.verdict.word(), codes)
}

/// A page of the tests, and what an audit of it alone says.
pub struct Audited {
    /// From the root of the repository.
    pub path: String,
    pub source: String,
    pub derivation: Derivation,
    pub audit: Audit,
}

impl Audited {
    fn read(path: &Path) -> Audited {
        let source = std::fs::read_to_string(path).unwrap();
        let path = path.strip_prefix(root()).unwrap().display().to_string();
        let derivation = Derivation::from_markdown(&path, &source);
        let audit = Audit::of(&derivation);
        Audited {
            path,
            source,
            derivation,
            audit,
        }
    }

    /// What people read of it, without colours.
    pub fn human(&self) -> String {
        plain(&Report {
            derivation: &self.derivation,
            audit: &self.audit,
            paths: &[],
        })
    }

    /// The verdicts of its statements, and the codes of their notes.
    fn said(&self) -> impl Iterator<Item = &'static str> + '_ {
        self.audit.entries.iter().flat_map(|entry| {
            let notes = entry.notes.iter().map(|note| note.code());
            notes.chain([entry.verdict.word()])
        })
    }
}

/// The pages of `tests/pages/`: each is audited once for all tests that ask something of every page.
pub fn pages() -> &'static [Audited] {
    static PAGES: OnceLock<Vec<Audited>> = OnceLock::new();
    PAGES.get_or_init(|| {
        let entries = std::fs::read_dir(root().join("tests/pages")).unwrap();
        let mut paths: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
        paths.retain(|path| path.extension().is_some_and(|extension| extension == "md"));
        paths.sort();
        paths.iter().map(|path| Audited::read(path)).collect()
    })
}

/// Enough of them to show every verdict and every note that any of them shows.
pub fn pages_of_each_kind() -> Vec<&'static Audited> {
    let mut seen = BTreeSet::new();
    let mut pages: Vec<&Audited> = pages().iter().collect();
    pages.retain(|page| {
        let before = seen.len();
        seen.extend(page.said());
        seen.len() > before
    });
    pages
}

/// The program with its arguments, at the root of the repository, in colours only where it finds a terminal.
pub fn command(args: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_cradle-verify"));
    command
        .args(args)
        .current_dir(root())
        .env_remove("NO_COLOR");
    command
}

/// Runs the program at the root of the repository.
pub fn run(args: &[&str]) -> Output {
    command(args).output().unwrap()
}

/// Runs the program in a folder.
pub fn run_in(folder: &Path, args: &[&str]) -> Output {
    command(args).current_dir(folder).output().unwrap()
}

/// Runs the program with standard input.
pub fn piped(args: &[&str], input: &str) -> Output {
    let mut child = command(args)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut open = child.stdin.take().unwrap();
    // Who is refused at once has ended before anything is read.
    match open.write_all(input.as_bytes()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => panic!("{error}"),
        _ => drop(open),
    }
    child.wait_with_output().unwrap()
}

/// With what the program ended, which it did by itself and not by a signal.
pub fn code(output: &Output) -> i32 {
    let code = output.status.code();
    code.expect("ended by itself, not by a signal")
}

/// What it said.
pub fn out(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).unwrap()
}

/// What it complained of.
pub fn err(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

/// What it said, as JSON.
pub fn json(output: &Output) -> Value {
    serde_json::from_slice(&output.stdout).unwrap_or_else(|error| {
        panic!("{error}: {}{}", out(output), err(output));
    })
}

/// An empty folder of a test's own.
pub fn folder(test: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(test);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    folder
}
