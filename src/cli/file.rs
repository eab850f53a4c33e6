//! Files that are replaced as a whole: who reads one sees the old text or the new, and never half of it.

use std::collections::BTreeSet;
use std::io::Write;
use std::path::{Path, PathBuf};

use super::{Failure, input};

/// That what is about to be written is none of the files that were read, each of these in one spelling: nobody wants a
/// document replaced by what is said of it. An empty one may be; nothing is lost with it.
///
/// # Errors
/// It is one of them.
pub fn spare(target: &Path, read: &BTreeSet<PathBuf>) -> Result<(), Failure> {
    let has_text = std::fs::metadata(target).is_ok_and(|about| about.is_file() && about.len() > 0);
    match has_text && read.contains(&input::same(target)) {
        true => Err(Failure::new(format!(
            "`{}` is read, and would be lost if it were written",
            target.display()
        ))
        .help("name another file to write")),
        false => Ok(()),
    }
}

/// Writes a file. What is no regular file, such as `/dev/stdout`, is written to as it is.
///
/// # Errors
/// It cannot be written; then what was there is still there.
pub fn replace(path: &Path, content: impl AsRef<[u8]>) -> Result<(), Failure> {
    let failed = |error: &std::io::Error| {
        Failure::new(format!(
            "`{}` could not be written: {error}",
            path.display()
        ))
    };
    // A link stays a link: what it leads to is replaced.
    let target = std::fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    let about = std::fs::metadata(&target).ok();
    if about.as_ref().is_some_and(std::fs::Metadata::is_dir) {
        return Err(Failure::new(format!(
            "`{}` is a directory, and no file",
            path.display()
        )));
    }
    if about.as_ref().is_some_and(|about| !about.is_file()) {
        return std::fs::write(&target, content.as_ref()).map_err(|error| failed(&error));
    }
    let Some(name) = target.file_name() else {
        return Err(Failure::new(format!("`{}` is no file", path.display())));
    };
    let mut own = std::ffi::OsString::from(".");
    own.push(name);
    own.push(format!(".{}.new", std::process::id()));
    let new = target.with_file_name(own);
    let written = (|| {
        let mut file = std::fs::File::create(&new)?;
        file.write_all(content.as_ref())?;
        if let Some(about) = about {
            file.set_permissions(about.permissions())?;
        }
        file.sync_all()?;
        std::fs::rename(&new, &target)
    })();
    written.map_err(|error| {
        // It may not be there at all.
        let _ = std::fs::remove_file(&new);
        failed(&error)
    })
}
