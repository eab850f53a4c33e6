//! `init`: the declarations that documents lack.

use std::path::PathBuf;

use super::args::Format;
use super::run::Done;
use super::{Failure, input};
use crate::report::declarations;

/// The symbols of documents with what is left to declare, as text that can be pasted into them.
///
/// # Errors
/// A document that cannot be read; a format for programs.
pub(super) fn init(paths: &[PathBuf], stdin: Option<&str>, format: Format) -> Done {
    if format != Format::Human {
        return Err(Failure::new(format!(
            "`init` writes comments to be pasted into a document, not `--format {}`",
            format.word()
        ))
        .help("`cradle-verify check --format json` has every equation for programs"));
    }
    let derivation = input::derivation(paths, stdin)?;
    Ok((declarations(&derivation).into(), false))
}
