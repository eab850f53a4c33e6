//! Files that are replaced as a whole: who reads one sees the old text or the new, and never half of it.

use std::io::Write;
use std::path::Path;

use super::Failure;

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
