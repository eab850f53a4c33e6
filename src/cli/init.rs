//! `init`: the declarations that documents lack.

use std::path::Path;

use super::args::{Args, Format};
use super::{Failure, output};
use crate::config::Config;
use crate::derivation::Derivation;
use crate::report::{configuration, configuration_with, declarations};

/// Nothing is written for programs, and nothing that somebody has written is replaced.
pub(super) fn possible(args: &Args, toml: bool) -> Result<(), Failure> {
    let written =
        |path: &std::path::PathBuf| std::fs::metadata(path).is_ok_and(|own| own.len() > 0);
    if let Some(path) = args.output.as_ref().filter(|path| toml && written(path)) {
        let failure = Failure::new(format!("`{}` has something in it already", path.display()));
        return Err(failure.help(
            "`--update` adds to it what it does not declare yet, and leaves the rest as it is",
        ));
    }
    match args.format {
        Format::Human => Ok(()),
        format => Err(Failure::new(format!(
            "`init` writes declarations to be completed by their author, not `--format {}`",
            format.word()
        ))
        .help("`cradle-verify check --format json` has every equation for programs")),
    }
}

/// A `cradle.toml` with the symbols in it that it does not declare yet.
pub(super) fn update(
    derivation: &Derivation,
    files: &[String],
    path: &Path,
) -> Result<String, Failure> {
    let shown = path.display().to_string();
    let existing = match std::fs::read_to_string(path) {
        Ok(text) => text,
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => String::new(),
        Err(error) => return Err(Failure::new(format!("`{shown}` cannot be read: {error}"))),
    };
    if existing.trim().is_empty() {
        return Ok(configuration(derivation, files));
    }
    let config = Config::read(&shown, &existing).map_err(|_| {
        Failure::new(format!(
            "`{shown}` is no `cradle.toml` that could be added to"
        ))
        .help("`cradle-verify check --config` says what is wrong with it")
    })?;
    let known = config.beside.symbols.iter().map(|own| own.symbol.clone());
    let (text, new) = configuration_with(&existing, &known.collect::<Vec<_>>(), derivation);
    // However the author has written it, nothing but new rows may be in it.
    if Config::read(&shown, &text).is_err() {
        return Err(Failure::new(format!(
            "nothing can be added to `[symbols]` in `{shown}` as it is written"
        ))
        .help("leave out `-o`, and add what is printed"));
    }
    output::say(&match new {
        0 => format!("{shown} declares all symbols already\n"),
        1 => format!("added 1 symbol to {shown}\n"),
        _ => format!("added {new} symbols to {shown}\n"),
    });
    Ok(text)
}

/// The symbols of documents with what is left to declare: as comments that can be pasted into them, or as a `cradle.toml`.
pub(super) fn init(derivation: &Derivation, files: &[String], toml: bool) -> String {
    match toml {
        true => configuration(derivation, files),
        false => declarations(derivation),
    }
}
