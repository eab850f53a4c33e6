//! Files that are there whole or not at all.

use std::fs::{self, OpenOptions};
use std::io::Write;
use std::path::Path;

use super::Failure;

/// Writes a file: first under another name beside it, then it takes the place of what was there.
///
/// # Errors
/// The directory is not there or not writable, or what is to be replaced is no file.
pub(super) fn write(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    let failed = |problem: &dyn std::fmt::Display| {
        Failure::new(format!(
            "`{}` could not be written: {problem}",
            path.display()
        ))
    };
    let Some(name) = path.file_name() else {
        return Err(failed(&"it names no file"));
    };
    if let Ok(there) = fs::metadata(path)
        && !there.is_file()
    {
        return Err(failed(&"there is something of this name that is no file"));
    }
    let mut beside = std::ffi::OsString::from(".");
    beside.push(name);
    beside.push(format!(".{}.part", std::process::id()));
    let beside = path.with_file_name(beside);
    let mut options = OpenOptions::new();
    options.write(true).create_new(true);
    let mut file = options.open(&beside).map_err(|error| failed(&error))?;
    let done = file
        .write_all(bytes)
        .and_then(|()| file.sync_all())
        .and_then(|()| fs::rename(&beside, path));
    done.map_err(|error| {
        // What is left of an attempt is in nobody's way, but of no use either.
        let _ = fs::remove_file(&beside);
        failed(&error)
    })
}
