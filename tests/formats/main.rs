//! The formats for editors and continuous integration, from outside: each is read as its readers read it.

mod baseline;
mod codes;
mod config;
mod guide;
mod input;
mod junit;
mod lines;
mod sarif;
mod schema;

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use serde_json::Value;

/// What can go wrong in names and texts, all at once.
const HOSTILE: &str = "# ]]> <b> & \"\n\n<!-- check: nonsense \u{1b}[31m ]]> ::error::x -->\n\n\
    <!-- check: derived -->\n$$ 1 + 1 = 3 \\tag{]]>::warning file=x::\u{7}%0A} $$\n\n\
    <!-- check: derived -->\n$$ a = \\foo<&> \u{1b}[2J $$\n\n<!-- check: derived -->\n$$ b = \n c \\tag{2} $$\n";

/// A name for the same, where the system allows it.
const HOSTILE_NAME: &str = "a,b::c%0A\n::error::<x>&\u{1b}.md";

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Runs the program in a folder.
fn run_in(folder: &Path, args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_cradle-verify"))
        .args(args)
        .current_dir(folder)
        .env_remove("NO_COLOR")
        .output()
        .unwrap()
}

/// Runs the program at the root of the repository.
fn run(args: &[&str]) -> Output {
    run_in(root(), args)
}

/// Runs the program with standard input.
fn piped(args: &[&str], input: &str) -> Output {
    let mut child = Command::new(env!("CARGO_BIN_EXE_cradle-verify"))
        .args(args)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    child
        .stdin
        .take()
        .unwrap()
        .write_all(input.as_bytes())
        .unwrap();
    child.wait_with_output().unwrap()
}

fn code(output: &Output) -> i32 {
    output
        .status
        .code()
        .expect("ended by itself, not by a signal")
}

fn out(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).unwrap()
}

fn err(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

fn json(output: &Output) -> Value {
    serde_json::from_slice(&output.stdout).unwrap_or_else(|error| {
        panic!("{error}: {}{}", out(output), err(output));
    })
}

/// An empty folder of a test's own.
fn folder(test: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR"))
        .join("formats")
        .join(test);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    folder
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
