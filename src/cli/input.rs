//! Documents from files, directories and standard input.

use std::collections::{BTreeMap, BTreeSet};
use std::io::Read;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};
use std::time::SystemTime;

use crate::derivation::{Beside, Derivation};
use crate::document::{Document, Library, Problem, Span, decode};

use super::Failure;
use super::config::Configs;
use crate::parallel::in_order;
use crate::sorted::{self, Tree};

/// What standard input is called where nothing else is said.
const STANDARD_INPUT: &str = "standard input";
/// The endings of documents.
const ENDINGS: [&str; 5] = ["md", "markdown", "qmd", "tex", "ipynb"];
/// Nobody writes a longer document.
const MOST_BYTES: u64 = 256 << 20;

/// What can be seen of files without reading them: when they were changed, and how long they are. `None` where there is none.
pub type Look = BTreeMap<PathBuf, Option<(SystemTime, u64)>>;

/// What can be seen of one.
pub(super) fn seen(path: &Path) -> Option<(SystemTime, u64)> {
    let about = std::fs::metadata(path).ok()?;
    Some((about.modified().ok()?, about.len()))
}

/// The files on this machine, remembering which were asked for.
#[derive(Default)]
struct Disk {
    opened: Mutex<BTreeSet<PathBuf>>,
    /// What was seen of each before it was read, and of what was not there.
    looks: Mutex<Look>,
}

impl Library for Disk {
    fn open(&self, path: &str) -> Option<Vec<u8>> {
        let path = Path::new(path);
        if let Ok(mut looks) = self.looks.lock() {
            looks.entry(path.to_owned()).or_insert_with(|| seen(path));
        }
        let about = std::fs::metadata(path).ok()?;
        if !about.is_file() || about.len() > MOST_BYTES {
            return None;
        }
        let bytes = std::fs::read(path).ok()?;
        if let Ok(mut opened) = self.opened.lock() {
            opened.insert(same(path));
        }
        Some(bytes)
    }
}

/// What was read.
#[derive(Debug)]
pub struct Documents {
    /// All documents as one derivation.
    pub derivation: Derivation,
    /// The files that they are in, those that they take in among them; each in one spelling.
    pub files: BTreeSet<PathBuf>,
    /// What was seen of the files that documents take in, or would if they were there.
    pub taken_in: Look,
}

/// Reads all documents at some paths as one derivation. `stdin` is what standard input is called, and its ending says
/// what it is written in.
///
/// A LaTeX file that another one takes in is read there, and not by itself.
///
/// # Errors
/// A path that is not there, a directory without documents, a file that is not text.
pub fn derivation(
    paths: &[PathBuf],
    stdin: Option<&str>,
    configs: &mut Configs,
) -> Result<Documents, Failure> {
    if stdin.is_some() && !paths.iter().any(|path| path == Path::new("-")) {
        return Err(
            Failure::new("`--stdin-filename` names standard input, which is not read")
                .help("`-` as a path reads it"),
        );
    }
    let files = files(paths)?;
    let stdin = stdin.unwrap_or(STANDARD_INPUT);
    let beside = files.iter().map(|file| {
        let name = if file == Path::new("-") {
            Path::new(stdin)
        } else {
            file
        };
        Ok(configs
            .of(name)?
            .map(|found| Arc::clone(&found.config.beside)))
    });
    let beside: Vec<Option<Arc<Beside>>> = beside.collect::<Result<_, Failure>>()?;
    let read = in_order(&files, |file| {
        let disk = Disk::default();
        let (name, bytes) = bytes(file, stdin)?;
        let documents = match read(&name, &bytes, &disk) {
            // What a directory holds besides is audited all the same.
            Err(failure) if !paths.contains(file) => vec![unreadable(name, failure)],
            read => read?,
        };
        let looks = disk.looks.into_inner().unwrap_or_default();
        let opened = disk.opened.into_inner().unwrap_or_default();
        Ok(((documents, opened), looks))
    });
    let read: Vec<_> = read.into_iter().collect::<Result<_, Failure>>()?;
    let (read, looks): (Vec<_>, Vec<Look>) = read.into_iter().unzip();
    let own: Vec<PathBuf> = files.iter().map(|file| same(file)).collect();
    let opened = read.iter().flat_map(|(_, opened)| opened);
    let all: BTreeSet<PathBuf> = own.iter().chain(opened).cloned().collect();
    let mut openers: Tree<&PathBuf, Vec<usize>> = Tree::new();
    for (at, (_, opened)) in read.iter().enumerate() {
        for path in opened {
            openers.entry(path).or_default().push(at);
        }
    }
    let taken_in: Vec<bool> = (0..files.len())
        .map(|at| {
            // Of two that take in each other the first is read.
            let mut by = openers.get(&own[at]).into_iter().flatten();
            by.any(|&other| other != at && !(at < other && read[at].1.contains(&own[other])))
        })
        .collect();
    let documents = read.into_iter().zip(taken_in).zip(beside);
    let documents = documents.filter(|((_, taken_in), _)| !taken_in);
    // What a document takes in, it takes in with what stands beside itself.
    let documents = documents.flat_map(|(((documents, _), _), beside)| {
        let own = move |document| (document, beside.clone());
        documents.into_iter().map(own)
    });
    Ok(Documents {
        derivation: Derivation::beside(documents.collect()),
        files: all,
        taken_in: looks.into_iter().flatten().collect(),
    })
}

/// The files at some paths, each once however it is spelt, in reading order.
///
/// # Errors
/// A path that is not there, a directory without documents.
pub fn files(paths: &[PathBuf]) -> Result<Vec<PathBuf>, Failure> {
    let mut files: Vec<PathBuf> = Vec::new();
    // A file that is named itself stands where it is named, and not where its folder is.
    let named: BTreeSet<PathBuf> = paths.iter().map(|path| same(path)).collect();
    for path in paths {
        let found = documents(path)?;
        let fresh = |f: &PathBuf| f == path || !named.contains(&same(f));
        files.extend(found.into_iter().filter(fresh));
    }
    let mut seen = BTreeSet::new();
    files.retain(|file| seen.insert(same(file)));
    Ok(files)
}

/// A path in one spelling, if the file is there.
pub(super) fn same(path: &Path) -> PathBuf {
    path.canonicalize().unwrap_or_else(|_| path.to_owned())
}

/// The documents at a path: itself, or all below a directory, sorted.
fn documents(path: &Path) -> Result<Vec<PathBuf>, Failure> {
    if path == Path::new("-") {
        return Ok(vec![path.to_owned()]);
    }
    let about = std::fs::metadata(path).map_err(|error| unread(path, &error))?;
    if !about.is_dir() {
        return Ok(vec![path.to_owned()]);
    }
    let found = below(path)?;
    match found.is_empty() {
        true => Err(Failure::new(format!(
            "there is no Markdown document in `{}`, no LaTeX document and no notebook",
            path.display()
        ))
        .help(
            "documents are files whose names end in `.md`, `.markdown`, `.qmd`, `.tex` or `.ipynb`",
        )),
        false => Ok(found),
    }
}

/// All documents below a directory, sorted.
///
/// # Errors
/// A directory that cannot be read.
pub(super) fn below(path: &Path) -> Result<Vec<PathBuf>, Failure> {
    let mut found = Vec::new();
    let mut open = vec![path.to_owned()];
    while let Some(folder) = open.pop() {
        let entries = std::fs::read_dir(&folder).map_err(|error| unread(&folder, &error))?;
        for entry in entries {
            let entry = entry.map_err(|error| unread(&folder, &error))?;
            let kind = entry.file_type().map_err(|error| unread(&folder, &error))?;
            let own = entry.path();
            // A link to a directory is not followed: it may lead back. Nor is the copy that Jupyter keeps.
            if kind.is_dir() && !own.ends_with(".ipynb_checkpoints") {
                open.push(own);
            } else if ending(&own).is_some_and(|e| ENDINGS.contains(&e.as_str()))
                && (own.is_file() || is_lost(&own))
            {
                found.push(own);
            }
        }
    }
    sorted::sort(&mut found);
    Ok(found)
}

/// Whether a link leads nowhere: whoever reads it is told so. The locks that Emacs makes are such links, and no documents.
fn is_lost(path: &Path) -> bool {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    path.is_symlink() && std::fs::metadata(path).is_err() && !name.starts_with(".#")
}

fn ending(path: &Path) -> Option<String> {
    path.extension().map(|e| e.to_string_lossy().to_lowercase())
}

/// What a file holds, with the name that it is called by.
fn bytes(path: &Path, stdin: &str) -> Result<(String, Vec<u8>), Failure> {
    let is_stdin = path == Path::new("-");
    let bytes = match is_stdin {
        true => start_of(std::io::stdin().lock())
            .map_err(|error| Failure::new(format!("standard input cannot be read: {error}")))?,
        false => std::fs::File::open(path)
            .and_then(start_of)
            .map_err(|error| unread(path, &error))?,
    };
    let name = match is_stdin {
        true => stdin.to_owned(),
        false => path.display().to_string(),
    };
    Ok((name, bytes))
}

/// All of a document, and of what is longer, or has no end, so much that this can be told.
fn start_of(from: impl Read) -> std::io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    from.take(MOST_BYTES + 1).read_to_end(&mut bytes)?;
    Ok(bytes)
}

fn read(name: &str, bytes: &[u8], disk: &Disk) -> Result<Vec<Document>, Failure> {
    if bytes.len() as u64 > MOST_BYTES {
        let most = MOST_BYTES >> 20;
        let failure = Failure::new(format!("`{name}` is longer than {most} MB"));
        return Err(
            failure.help("a document is a text that somebody writes; name the files that are")
        );
    }
    let text = decode(bytes).map_err(|error| {
        Failure::new(format!("`{name}` is {error}")).help("save it as UTF-8 and try again")
    })?;
    match ending(Path::new(name)).as_deref() {
        Some("tex" | "ltx" | "latex") => Ok(Document::latex(name, text, disk)),
        Some("ipynb") => Document::notebook(name.to_owned(), text)
            .map(|document| vec![document])
            .map_err(|error| Failure::new(format!("`{name}` is {error}"))),
        _ if name == STANDARD_INPUT && is_latex(text) => Ok(Document::latex(name, text, disk)),
        _ => Ok(vec![Document::markdown(name, text)]),
    }
}

/// A document of which only that it could not be read is known.
fn unreadable(name: String, failure: Failure) -> Document {
    let mut document = Document::markdown(name, "");
    document.problems.push(Problem {
        span: Span::default(),
        message: failure.message,
        help: failure.help,
    });
    document
}

/// Whether a text without a name is a LaTeX document: it begins with a command or a comment of TeX, and says where the document begins
/// or of which class it is. A page of Markdown may show that too, but begins otherwise.
fn is_latex(text: &str) -> bool {
    let mut lines = text.lines().map(str::trim_start);
    let begins = lines.clone().find(|line| !line.is_empty());
    let says = |line: &str| {
        ["\\documentclass", "\\begin{document}"]
            .iter()
            .any(|own| line.starts_with(own))
    };
    begins.is_some_and(|line| line.starts_with(['\\', '%'])) && lines.any(says)
}

fn unread(path: &Path, error: &std::io::Error) -> Failure {
    match error.kind() {
        std::io::ErrorKind::NotFound if path.is_symlink() => Failure::new(format!(
            "`{}` is a link that leads to no file",
            path.display()
        )),
        std::io::ErrorKind::NotFound => Failure::new(format!(
            "there is no file or directory `{}`",
            path.display()
        )),
        _ => Failure::new(format!("`{}` cannot be read: {error}", path.display())),
    }
}
