//! `init`: the declarations that documents lack.

use super::Failure;
use super::args::{Args, Format};
use crate::derivation::Derivation;
use crate::report::{configuration, declarations};

/// Nothing is written for programs, and nothing that somebody has written is replaced.
pub(super) fn possible(args: &Args, toml: bool) -> Result<(), Failure> {
    let written =
        |path: &std::path::PathBuf| std::fs::metadata(path).is_ok_and(|own| own.len() > 0);
    if let Some(path) = args.output.as_ref().filter(|path| toml && written(path)) {
        let failure = Failure::new(format!("`{}` has something in it already", path.display()));
        return Err(failure.help("leave out `-o`, and add what is printed"));
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

/// The symbols of documents with what is left to declare: as comments that can be pasted into them, or as a `cradle.toml`.
pub(super) fn init(derivation: &Derivation, files: &[String], toml: bool) -> String {
    match toml {
        true => configuration(derivation, files),
        false => declarations(derivation),
    }
}
