//! Audits again whenever a document changes, or a file that one takes in. Files are looked at a few times a second: their names, times and
//! lengths.

use std::collections::BTreeSet;
use std::io::IsTerminal;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Duration;

use super::args::Args;
use super::config::{self, Configs};
use super::input::{self, Look};
use super::{Failure, output, refuse, run};

/// How long is waited between two looks.
const PAUSE: Duration = Duration::from_millis(200);
/// Clears a terminal and what was scrolled away.
const CLEAR: &str = "\x1b[2J\x1b[3J\x1b[H";

/// Goes on until Ctrl-C, or until nobody reads any more.
pub fn watch(args: &Args, paths: &[PathBuf]) -> ExitCode {
    if paths.iter().any(|path| path == Path::new("-")) {
        let failure = Failure::new("`--watch` cannot watch standard input");
        return refuse(&failure.help("name a file or a directory"), args.color);
    }
    let terminal = std::io::stdout().is_terminal() && args.output.is_none();
    // Where documents cannot be read, what they took in before.
    let mut taken_in = Look::new();
    loop {
        let before = look(args, paths);
        for (path, own) in &mut taken_in {
            *own = input::seen(path);
        }
        let done = run::run_looking(args, &mut taken_in);
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
        let is_same = |(path, own): (&PathBuf, &_)| input::seen(path) == *own;
        while look(args, paths) == before && taken_in.iter().all(is_same) {
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
    files
        .into_iter()
        .map(|file| (file.clone(), input::seen(&file)))
        .collect()
}
