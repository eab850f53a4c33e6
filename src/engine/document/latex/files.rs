//! The files that a document takes in.

use super::assemble::{Assembler, Frame};
use super::token::{Place, Token};

/// Where the files that a document names are looked for.
pub trait Library {
    /// The bytes of the file of this path, if there is such a file.
    fn open(&self, path: &str) -> Option<Vec<u8>>;
}

/// No files: for a text that stands alone.
impl Library for () {
    fn open(&self, _: &str) -> Option<Vec<u8>> {
        None
    }
}

/// A file in a file is as deep as most documents go.
const DEPTH: usize = 32;
/// More files are a mistake.
const FILES: usize = 2000;
/// The most bytes that a document may have, all files together.
const BYTES: usize = 64 << 20;

/// How a file is taken in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum How {
    /// `\input`: as if it stood there.
    Input,
    /// `\include`: a page of its own.
    Include,
    /// `\usepackage`: if it is there.
    Package,
}

impl Assembler<'_> {
    /// `\InputIfFileExists{file}{before}{otherwise}`, `\IfFileExists{file}{then}{otherwise}`
    pub(super) fn if_exists(&mut self, command: Token, name: &str) {
        let file = self.file_name().unwrap_or_default();
        let (Some(then), Some(otherwise)) = (self.argument(), self.argument()) else {
            let message = format!("an argument of `\\{name}` is missing, or never closed");
            return self.missing(command.origin, message, "give it in braces");
        };
        let exists = !self.find(file.trim(), How::Input).is_empty();
        if exists && name == "InputIfFileExists" {
            self.take_in(command, &file, How::Input);
        }
        let tokens = if exists { then } else { otherwise };
        self.frames.push(Frame::Tokens { tokens, at: 0 });
    }

    /// The files that a name may mean, with what is in them.
    fn find(&self, name: &str, how: How) -> Vec<(String, Vec<u8>)> {
        let own = match self.innermost_file() {
            Some(file) => folder(&self.origin.files[file].path).to_owned(),
            None => String::new(),
        };
        let root = folder(&self.origin.files[0].path).to_owned();
        let mut folders = vec![own];
        if folders[0] != root {
            folders.push(root);
        }
        let mut found: Vec<(String, Vec<u8>)> = Vec::new();
        for folder in folders {
            let base = match name.starts_with('/') {
                true => name.to_owned(),
                false => normal(&format!("{folder}{name}")),
            };
            let endings: &[&str] = match how {
                How::Package => &[".sty"],
                _ => &[".tex", ""],
            };
            let bytes = endings.iter().find_map(|ending| {
                let path = format!("{base}{ending}");
                self.library.open(&path).map(|bytes| (path, bytes))
            });
            found.extend(bytes);
        }
        found.dedup_by(|a, b| a.0 == b.0);
        found
    }

    /// Takes in the file that a command names.
    pub(super) fn take_in(&mut self, command: Token, name: &str, how: How) {
        let name = name.trim();
        let mut found = self.find(name, how).into_iter();
        let Some((path, bytes)) = found.next() else {
            if how != How::Package {
                let help = "paths are relative to the file that names them, or to the main file";
                self.missing(command.origin, format!("there is no file `{name}`"), help);
            }
            return;
        };
        if let Some((other, _)) = found.next().filter(|(_, other)| *other != bytes) {
            let message = format!("`{name}` may be `{path}` or `{other}`");
            self.missing(command.origin, message, "rename one of them");
            return;
        }
        let open = self.open_files();
        if open
            .iter()
            .any(|&file| self.origin.files[file].path == path)
        {
            let message = format!("`{path}` takes in itself");
            return self.missing(command.origin, message, "leave this out");
        }
        self.bytes += bytes.len();
        if open.len() >= DEPTH || self.origin.files.len() >= FILES || self.bytes > BYTES {
            let message = "the document takes in more files than are read";
            return self.missing(command.origin, message, "check it in parts");
        }
        match super::super::decode(&bytes) {
            Ok(text) => {
                let package = how == How::Package;
                self.open_file(path, text.into(), how == How::Include, package);
            }
            Err(error) => {
                let message = format!("`{path}` is {error}");
                self.missing(command.origin, message, "save it as UTF-8 and try again");
            }
        }
    }

    /// The name that an `\input` gives: in braces, or up to a space.
    pub(super) fn file_name(&mut self) -> Option<String> {
        self.skip_blank();
        let first = self.next_token()?;
        if self.text(first) == "{" {
            let inside = self.group_after(first)?;
            return Some(self.spelt(&inside));
        }
        let mut name = self.text(first).to_owned();
        while let Some(token) = self.next_token() {
            let text = self.text(token);
            if text.starts_with(|c: char| c.is_whitespace() || c == '\\') {
                self.put_back(token);
                break;
            }
            name.push_str(text);
        }
        Some(name)
    }

    /// A file's first place, for what is wrong with all of it.
    pub(super) fn start_of(file: usize) -> Place {
        Place::new(file, 0, 0)
    }
}

/// The folder of a path, with the stroke at its end.
fn folder(path: &str) -> &str {
    path.rfind('/').map_or("", |at| &path[..=at])
}

/// The same path without `.` and, where it can be told, `..` in it.
fn normal(path: &str) -> String {
    let mut parts: Vec<&str> = Vec::new();
    for (at, part) in path.split('/').enumerate() {
        match part {
            "." if at > 0 => {}
            ".." if parts
                .last()
                .is_some_and(|last| !matches!(*last, ".." | "." | "")) =>
            {
                parts.pop();
            }
            part => parts.push(part),
        }
    }
    parts.join("/")
}
