//! Audits again whenever a document changes. Files are looked at a few times a second: their names, times and lengths.

use std::collections::{BTreeMap, BTreeSet};
use std::io::IsTerminal;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::{Duration, SystemTime};

use super::args::Args;
use super::config::{self, Configs};
use super::{Failure, input, output, refuse, run};

/// How long is waited between two looks.
const PAUSE: Duration = Duration::from_millis(200);
/// Clears a terminal and what was scrolled away.
const CLEAR: &str = "\x1b[2J\x1b[3J\x1b[H";

/// What can be seen of the documents without reading them.
type Look = BTreeMap<PathBuf, Option<(SystemTime, u64)>>;

/// Goes on until Ctrl-C, or until nobody reads any more.
pub fn watch(args: &Args, paths: &[PathBuf]) -> ExitCode {
    if paths.iter().any(|path| path == Path::new("-")) {
        let failure = Failure::new("`--watch` cannot watch standard input");
        return refuse(&failure.help("name a file or a directory"), args.color);
    }
    let terminal = std::io::stdout().is_terminal() && args.output.is_none();
    loop {
        let before = look(args, paths);
        let done = run::run(args);
        if terminal {
            let _ = output::data(CLEAR, super::args::Color::Always);
        }
        match done.and_then(|(content, _)| output::deliver(&content, args)) {
            Ok(true) => {}
            Ok(false) => return ExitCode::SUCCESS,
            // The file may just be being written: what is wrong now may be right in a moment.
            Err(failure) => output::talk(&failure, args.color),
        }
        let documents = documents(args, paths).len();
        let plural = if documents == 1 { "" } else { "s" };
        output::say(&format!(
            "watching {documents} document{plural}; Ctrl-C ends\n"
        ));
        while look(args, paths) == before {
            std::thread::sleep(PAUSE);
        }
    }
}

/// The documents that are watched; none while something is wrong with what lists them.
fn documents(args: &Args, paths: &[PathBuf]) -> Vec<PathBuf> {
    let listed = match paths.is_empty() {
        true => Configs::new(args).listed().map(|(files, _)| files),
        false => Ok(paths.to_vec()),
    };
    listed
        .and_then(|paths| input::files(&paths))
        .unwrap_or_default()
}

/// What can be seen of the documents and of what stands beside them.
fn look(args: &Args, paths: &[PathBuf]) -> Look {
    let mut files = documents(args, paths);
    let folders: BTreeSet<PathBuf> = files
        .iter()
        .filter_map(|file| Some(file.parent()?.to_owned()))
        .collect();
    files.extend(config::candidates(args, &folders));
    let seen = |file: &PathBuf| {
        let about = std::fs::metadata(file).ok()?;
        Some((about.modified().ok()?, about.len()))
    };
    files
        .into_iter()
        .map(|file| (file.clone(), seen(&file)))
        .collect()
}
