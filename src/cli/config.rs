//! Which `cradle.toml` counts for which document, and what documents one lists.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::args::Args;
use super::{Failure, input};
use crate::config::{Amiss, Config, NAME, matches};
use crate::derivation::Derivation;
use crate::document::{Problem, decode};
use crate::report::amiss;
use crate::sorted::Tree;

/// Nobody writes a longer one.
const MOST_BYTES: u64 = 1 << 20;

/// A configuration that was found.
#[derive(Clone, Debug)]
pub struct Found {
    /// Its path as it is shown.
    pub path: PathBuf,
    /// What it says.
    pub config: Arc<Config>,
}

/// The configurations of a run, each read once.
#[derive(Debug)]
pub struct Configs {
    /// `--config FILE`
    named: Option<PathBuf>,
    /// `--no-config`
    none: bool,
    read: Tree<PathBuf, Arc<Config>>,
    of_folder: Tree<PathBuf, Option<Found>>,
}

impl Configs {
    /// As the arguments have it.
    pub fn new(args: &Args) -> Configs {
        Configs {
            named: args.config.clone(),
            none: args.no_config,
            read: Tree::new(),
            of_folder: Tree::new(),
        }
    }

    /// The configuration for a document: the one that is named, or the nearest one.
    ///
    /// # Errors
    /// It cannot be read.
    pub fn of(&mut self, document: &Path) -> Result<Option<Found>, Failure> {
        self.in_folder(document.parent().unwrap_or(Path::new("")))
    }

    /// The configuration for the documents of a folder. The nearest one is that of the folder itself or of one around it,
    /// as far as the repository goes; where there is none, of the folder itself alone.
    fn in_folder(&mut self, folder: &Path) -> Result<Option<Found>, Failure> {
        if self.none {
            return Ok(None);
        }
        if let Some(path) = self.named.clone() {
            let config = self.read(&path)?;
            return Ok(Some(Found { path, config }));
        }
        if let Some(known) = self.of_folder.get(folder) {
            return Ok(known.clone());
        }
        let found = match nearest(folder) {
            Some(path) => {
                let config = self.read(&path)?;
                Some(Found { path, config })
            }
            None => None,
        };
        self.of_folder.insert(folder.to_owned(), found.clone());
        Ok(found)
    }

    /// The files that were read, each in one spelling.
    pub(super) fn files(&self) -> impl Iterator<Item = PathBuf> {
        self.read.keys().map(|path| input::same(path))
    }

    fn read(&mut self, path: &Path) -> Result<Arc<Config>, Failure> {
        if let Some(known) = self.read.get(path) {
            return Ok(Arc::clone(known));
        }
        let shown = path.display().to_string();
        let failed = |error: &std::io::Error| match error.kind() {
            std::io::ErrorKind::NotFound => {
                Failure::new(format!("there is no configuration `{shown}`"))
            }
            _ => Failure::new(format!("`{shown}` cannot be read: {error}")),
        };
        let about = std::fs::metadata(path).map_err(|error| failed(&error))?;
        if !about.is_file() || about.len() > MOST_BYTES {
            return Err(Failure::new(format!("`{shown}` is no configuration"))
                .help("docs/config.md says what stands in one"));
        }
        let bytes = std::fs::read(path).map_err(|error| failed(&error))?;
        let text = decode(&bytes).map_err(|error| {
            Failure::new(format!("`{shown}` is {error}")).help("save it as UTF-8 and try again")
        })?;
        let config = Arc::new(Config::read(&shown, text).map_err(|wrong| refused(&wrong))?);
        self.read.insert(path.to_owned(), Arc::clone(&config));
        Ok(config)
    }

    /// The documents that the configuration of this folder lists, or the one that is named; and where it is.
    ///
    /// # Errors
    /// There is none, it lists none, or what it lists is not there.
    pub fn listed(&mut self) -> Result<(Vec<PathBuf>, PathBuf), Failure> {
        let Some(found) = self.in_folder(Path::new(""))? else {
            return Err(Failure::new("no document is named").help(format!(
                "`cradle-verify check paper.md`, or a `{NAME}` here that lists `files`; `cradle-verify` alone audits the \
                 report that ships inside"
            )));
        };
        let Some(patterns) = &found.config.files else {
            return Err(Failure::new(format!(
                "no document is named, and `{}` lists no `files`",
                found.path.display()
            ))
            .help("`files = [\"paper.tex\", \"chapters/*.md\"]`, above its tables"));
        };
        let base = found.path.parent().unwrap_or(Path::new(""));
        let mut files: Vec<PathBuf> = Vec::new();
        let mut problems = Vec::new();
        for pattern in patterns {
            let own = listed(base, &pattern.value)?;
            if own.is_empty() {
                problems.push(Problem::new(
                    pattern.span,
                    format!("there is no document `{}`", pattern.value.text()),
                    "it is told from the folder of this file",
                ));
            }
            files.extend(
                own.into_iter()
                    .filter(|file| !files.contains(file))
                    .collect::<Vec<_>>(),
            );
        }
        if patterns.is_empty() {
            return Err(Failure::new(format!(
                "`{}` lists no document",
                found.path.display()
            )));
        }
        let file = Arc::clone(&found.config.beside.file);
        match problems.is_empty() {
            true => Ok((files, found.path)),
            false => Err(refused(&Amiss { file, problems })),
        }
    }
}

/// The documents that a pattern means, sorted.
fn listed(base: &Path, pattern: &crate::config::Pattern) -> Result<Vec<PathBuf>, Failure> {
    let (folder, rest) = pattern.folder();
    let path = match folder {
        "" => base.to_owned(),
        folder => base.join(folder),
    };
    let Some(rest) = rest else {
        return Ok(match path.exists() {
            true => vec![path],
            false => Vec::new(),
        });
    };
    let here = match path.as_os_str().is_empty() {
        true => Path::new("."),
        false => &path,
    };
    if !here.is_dir() {
        return Ok(Vec::new());
    }
    let inside = |file: PathBuf| file.strip_prefix(here).map(Path::to_owned).ok();
    let inside = input::below(here)?.into_iter().filter_map(inside);
    let meant = |file: &PathBuf| {
        let parts = file
            .components()
            .map(|part| part.as_os_str().to_string_lossy());
        matches(rest, &parts.collect::<Vec<_>>().join("/"))
    };
    Ok(inside.filter(meant).map(|file| path.join(file)).collect())
}

/// The nearest configuration, as it is shown.
fn nearest(folder: &Path) -> Option<PathBuf> {
    let here = match folder.as_os_str().is_empty() {
        true => Path::new("."),
        false => folder,
    };
    let own = here.canonicalize().ok()?;
    let around: Vec<&Path> = own.ancestors().collect();
    let root = around
        .iter()
        .position(|folder| folder.join(".git").exists());
    let most = root.map_or(1, |root| root + 1);
    let mut found = around
        .into_iter()
        .take(most)
        .map(|folder| folder.join(NAME));
    found.find(|path| path.is_file()).map(|path| shown(&path))
}

/// The configurations that count, or would if they were there, for documents of some folders and for this one: what a watch
/// looks at.
pub(super) fn candidates(args: &Args, folders: &BTreeSet<PathBuf>) -> Vec<PathBuf> {
    match (&args.config, args.no_config) {
        (_, true) => Vec::new(),
        (Some(path), _) => vec![path.clone()],
        (None, _) => {
            let here = PathBuf::new();
            let own = folders.iter().chain([&here]);
            let own = own.flat_map(|folder| nearest(folder).into_iter().chain([folder.join(NAME)]));
            own.collect::<BTreeSet<PathBuf>>().into_iter().collect()
        }
    }
}

/// A path as somebody here would write it.
fn shown(path: &Path) -> PathBuf {
    let here = std::env::current_dir().and_then(std::fs::canonicalize);
    let Ok(here) = here else {
        return path.to_owned();
    };
    if let Ok(inside) = path.strip_prefix(&here) {
        return inside.to_owned();
    }
    let folder = path.parent().unwrap_or(path);
    match here.strip_prefix(folder) {
        Ok(down) => {
            let mut up: PathBuf = down.components().map(|_| "..").collect();
            up.push(NAME);
            up
        }
        Err(_) => path.to_owned(),
    }
}

fn refused(wrong: &Amiss) -> Failure {
    let path = &wrong.file.path;
    Failure {
        excerpt: Some(amiss(wrong)),
        ..Failure::new(format!(
            "`{path}` cannot be followed, so nothing was checked"
        ))
        .help("docs/config.md says what stands in it; `--no-config` leaves it out")
    }
}

/// Says which of the equations that a configuration calls given were met nowhere: of what is read now, that is; they may
/// stand in documents that were not asked for.
pub(super) fn unmet(derivation: &Derivation) -> String {
    let mut text = String::new();
    let mut told: Vec<&Arc<crate::derivation::Beside>> = Vec::new();
    for page in &derivation.pages {
        let Some(beside) = &page.beside else { continue };
        if told.iter().any(|own| Arc::ptr_eq(own, beside)) {
            continue;
        }
        told.push(beside);
        let governed = derivation.pages.iter().filter(|other| {
            other
                .beside
                .as_ref()
                .is_some_and(|own| Arc::ptr_eq(own, beside))
        });
        for (at, label) in beside.given.iter().enumerate() {
            if governed.clone().any(|page| page.given.contains(&at)) {
                continue;
            }
            let place = beside.file.position(label.span.start);
            text += &format!(
                "note: {}:{}:{}: `given` names `{}`, and no equation that was read is called so\n",
                beside.file.path, place.line, place.column, label.value
            );
        }
    }
    text
}
