//! docs/ci.md and docs/guide.md: each of their commands is run in order, in a folder with their pages, and says what is shown.

use std::path::Path;
use std::process::Command;

use super::{folder, root};

/// Commands with what they print; `…` stands for any number of lines.
fn commands(page: &str) -> Vec<(usize, String, Vec<String>)> {
    let mut found: Vec<(usize, String, Vec<String>)> = Vec::new();
    let mut inside = false;
    for (at, line) in page.lines().enumerate() {
        match line.strip_prefix("```") {
            Some("console") => inside = true,
            Some(_) => inside = false,
            None if !inside => {}
            None => match (line.strip_prefix("$ "), found.last_mut()) {
                (Some(command), _) => found.push((at + 1, command.to_owned(), Vec::new())),
                (None, Some((.., shown))) => shown.push(line.trim_end().to_owned()),
                (None, None) => panic!("line {}: output without a command", at + 1),
            },
        }
    }
    found
}

/// Whether lines are as shown.
fn matches(shown: &[String], said: &[&str]) -> bool {
    match shown.split_first() {
        None => said.is_empty(),
        Some((first, rest)) if first == "…" => {
            (0..=said.len()).any(|skipped| matches(rest, &said[skipped..]))
        }
        Some((first, rest)) => said.first() == Some(&first.as_str()) && matches(rest, &said[1..]),
    }
}

/// Runs the commands of a page in a folder, and compares what they say.
fn follow(page: &str, folder: &Path) {
    let text = std::fs::read_to_string(root().join(page)).unwrap();
    let commands = commands(&text);
    assert!(commands.len() >= 10, "{page} has lost its commands");
    let program = Path::new(env!("CARGO_BIN_EXE_cradle-verify"))
        .parent()
        .unwrap();
    let path = std::env::var_os("PATH").unwrap_or_default();
    let path = std::env::join_paths(
        [program.to_owned()]
            .into_iter()
            .chain(std::env::split_paths(&path)),
    )
    .unwrap();
    let mut last = 0;
    for (line, command, shown) in commands {
        let output = Command::new("sh")
            .args(["-c", &format!("(exit {last}); {command} 2>&1")])
            .current_dir(folder)
            .env("PATH", &path)
            .output()
            .unwrap();
        last = output.status.code().expect("an exit code");
        let said = String::from_utf8(output.stdout).unwrap();
        let said: Vec<&str> = said.lines().map(str::trim_end).collect();
        assert!(
            matches(&shown, &said),
            "{page}:{line}: {command}\nsaid: {said:#?}"
        );
    }
}

#[test]
fn every_command_of_the_guide_says_what_is_shown() {
    let folder = folder("guide");
    std::fs::create_dir(folder.join("report")).unwrap();
    std::fs::copy(
        root().join("docs/examples/well.md"),
        folder.join("report/well.md"),
    )
    .unwrap();
    follow("docs/ci.md", &folder);
}

#[test]
fn every_command_of_the_first_audit_says_what_is_shown() {
    let folder = folder("first-audit");
    std::fs::create_dir_all(folder.join("docs/examples")).unwrap();
    for page in ["kinematics-wrong.md", "rc-circuit-wrong.tex"] {
        let page = Path::new("docs/examples").join(page);
        std::fs::copy(root().join(&page), folder.join(&page)).unwrap();
    }
    follow("docs/guide.md", &folder);
}

#[test]
fn the_files_of_the_guide_are_those_of_the_repository() {
    // No YAML reader is worth its weight here: what matters is that nothing of a caller's is put into a script.
    let action = std::fs::read_to_string(root().join("action.yml")).unwrap();
    let mut script = false;
    let mut scripts = 0;
    for line in action.lines() {
        let indent = line.len() - line.trim_start().len();
        if line.trim_start().starts_with("run:") {
            (script, scripts) = (true, scripts + 1);
        } else if script && indent <= 6 && !line.trim().is_empty() {
            script = false;
        }
        assert!(
            !(script && line.contains("${{")),
            "an input in a script: {line}"
        );
    }
    assert!(scripts >= 2, "the action has lost its scripts");
    let hooks = std::fs::read_to_string(root().join(".pre-commit-hooks.yaml")).unwrap();
    assert!(hooks.contains("entry: cradle-verify check"));
    // Whatever is read is checked, and nothing else that pre-commit calls TeX, such as packages.
    let files = r"files: '\.(md|markdown|qmd|tex|ipynb)$'";
    assert_eq!(hooks.matches(files).count(), hooks.matches("- id:").count());
    let workflow = std::fs::read_to_string(root().join(".github/workflows/ci.yml")).unwrap();
    assert!(workflow.contains("run: .ci/run"));
}
