//! The formats for editors and continuous integration, from outside: each is read as its readers read it.

mod baseline;
mod codes;
mod config;
mod escapes;
mod fingerprint;
mod fixes;
mod guide;
mod input;
mod junit;
mod lines;
mod pattern;
mod sarif;
mod schema;

use std::path::PathBuf;

use crate::common::{self, code, command, err, json, out, piped, root, run, run_in};

/// What can go wrong in names and texts, all at once.
const HOSTILE: &str = "# ]]> <b> & \"\n\n<!-- check: nonsense \u{1b}[31m ]]> ::error::x -->\n\n\
    <!-- check: derived -->\n$$ 1 + 1 = 3 \\tag{]]>::warning file=x::\u{7}%0A} $$\n\n\
    <!-- check: derived -->\n$$ a = \\foo<&> \u{1b}[2J $$\n\n<!-- check: derived -->\n$$ b = \n c \\tag{2} $$\n";

/// A name for the same, where the system allows it.
const HOSTILE_NAME: &str = "a,b::c%0A\n::error::<x>&\u{1b}.md";

/// An empty folder of a test's own.
fn folder(test: &str) -> PathBuf {
    common::folder(&format!("formats/{test}"))
}

/// The example of the README in a folder of a test's own.
fn well(test: &str) -> (PathBuf, String) {
    let folder = folder(test);
    let text = std::fs::read_to_string(root().join("docs/examples/well.md")).unwrap();
    std::fs::write(folder.join("well.md"), &text).unwrap();
    (folder, text)
}

/// A folder with a page of which everything is wrong, its name included.
fn hostile(test: &str) -> PathBuf {
    let folder = folder(test);
    std::fs::write(folder.join("page.md"), HOSTILE).unwrap();
    if cfg!(unix) {
        std::fs::write(folder.join(HOSTILE_NAME), HOSTILE).unwrap();
    }
    folder
}
