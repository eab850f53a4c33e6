//! Documents from files, directories and standard input.

use std::io::Read;
use std::path::{Path, PathBuf};

use crate::derivation::Derivation;
use crate::document::{Document, in_order, read_bytes};

use super::Failure;

/// What standard input is called where nothing else is said.
const STANDARD_INPUT: &str = "standard input";

/// Reads all documents at some paths as one derivation; `stdin` is what standard input is called.
///
/// # Errors
/// A path that is not there, a directory without documents, a file that is not text.
pub fn derivation(paths: &[PathBuf], stdin: Option<&str>) -> Result<Derivation, Failure> {
    if stdin.is_some() && !paths.iter().any(|path| path == Path::new("-")) {
        return Err(
            Failure::new("`--stdin-filename` names standard input, which is not read")
                .help("`-` as a path reads it"),
        );
    }
    let files = files(paths)?;
    let stdin = stdin.unwrap_or(STANDARD_INPUT);
    let documents = in_order(&files, |file| read(file, stdin));
    Ok(Derivation::new(
        documents.into_iter().collect::<Result<_, _>>()?,
    ))
}

/// The files at some paths, each once, in reading order.
///
/// # Errors
/// A path that is not there, a directory without documents.
pub fn files(paths: &[PathBuf]) -> Result<Vec<PathBuf>, Failure> {
    let mut files: Vec<PathBuf> = Vec::new();
    for path in paths {
        let found = documents(path)?;
        files.extend(
            found
                .into_iter()
                .filter(|f| !paths.contains(f) || f == path),
        );
    }
    let mut seen = std::collections::BTreeSet::new();
    files.retain(|file| seen.insert(file.clone()));
    Ok(files)
}

/// The Markdown files at a path: itself, or all below a directory, sorted.
fn documents(path: &Path) -> Result<Vec<PathBuf>, Failure> {
    if path == Path::new("-") {
        return Ok(vec![path.to_owned()]);
    }
    let about = std::fs::metadata(path).map_err(|error| unread(path, &error))?;
    if !about.is_dir() {
        return Ok(vec![path.to_owned()]);
    }
    let mut found = Vec::new();
    let mut open = vec![path.to_owned()];
    while let Some(folder) = open.pop() {
        let entries = std::fs::read_dir(&folder).map_err(|error| unread(&folder, &error))?;
        for entry in entries {
            let entry = entry.map_err(|error| unread(&folder, &error))?;
            let kind = entry.file_type().map_err(|error| unread(&folder, &error))?;
            let own = entry.path();
            // A link to a directory is not followed: it may lead back.
            if kind.is_dir() {
                open.push(own);
            } else if own
                .extension()
                .is_some_and(|e| e.eq_ignore_ascii_case("md"))
                && own.is_file()
            {
                found.push(own);
            }
        }
    }
    found.sort();
    match found.is_empty() {
        true => Err(Failure::new(format!(
            "there is no Markdown document in `{}`",
            path.display()
        ))
        .help("documents are files whose names end in `.md`")),
        false => Ok(found),
    }
}

fn read(path: &Path, stdin: &str) -> Result<Document, Failure> {
    let mut bytes = Vec::new();
    if path == Path::new("-") {
        std::io::stdin()
            .lock()
            .read_to_end(&mut bytes)
            .map_err(|error| Failure::new(format!("standard input cannot be read: {error}")))?;
    } else {
        bytes = std::fs::read(path).map_err(|error| unread(path, &error))?;
    }
    let name = match path == Path::new("-") {
        true => stdin.to_owned(),
        false => path.display().to_string(),
    };
    read_bytes(name.clone(), &bytes).map_err(|error| {
        Failure::new(format!("`{name}` is {error}")).help("save it as UTF-8 and try again")
    })
}

fn unread(path: &Path, error: &std::io::Error) -> Failure {
    match error.kind() {
        std::io::ErrorKind::NotFound => Failure::new(format!(
            "there is no file or directory `{}`",
            path.display()
        )),
        _ => Failure::new(format!("`{}` cannot be read: {error}", path.display())),
    }
}
