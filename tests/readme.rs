//! Every console example of the README is run, and says what the README shows.
//!
//! In a block that starts with `$ cradle-verify …`, a line that is just `…` stands for any number of lines.

use crate::common::{self, root};

const SKIPPED: &str = "…";

struct Example<'a> {
    line: usize,
    command: &'a str,
    shown: Vec<&'a str>,
}

fn readme() -> String {
    std::fs::read_to_string(root().join("README.md")).unwrap()
}

/// The fenced blocks of one language: the line each starts at, and its lines.
fn blocks<'a>(page: &'a str, language: &str) -> Vec<(usize, Vec<&'a str>)> {
    let mut found = Vec::new();
    let mut lines = page.lines().enumerate();
    while let Some((at, line)) = lines.next() {
        let Some(own) = line.strip_prefix("```") else {
            continue;
        };
        let inside = lines
            .by_ref()
            .map(|(_, line)| line)
            .take_while(|line| *line != "```");
        let inside: Vec<&str> = inside.collect();
        if own == language {
            found.push((at + 1, inside));
        }
    }
    found
}

fn examples(page: &str) -> Vec<Example<'_>> {
    let console = blocks(page, "console").into_iter();
    console
        .map(|(line, block)| {
            let (first, shown) = block.split_first().expect("a command");
            Example {
                line,
                command: first
                    .strip_prefix("$ cradle-verify")
                    .unwrap_or_else(|| panic!("line {line}: starts with another command")),
                shown: shown.to_vec(),
            }
        })
        .collect()
}

/// The first line that is shown and not said, if there is one. `…` skips as little as it can.
fn difference(shown: &[&str], said: &[&str]) -> Option<String> {
    let mut at = 0;
    let mut skipping = false;
    for line in shown {
        if *line == SKIPPED {
            skipping = true;
            continue;
        }
        let rest = said.get(at..).unwrap_or_default();
        let found = match skipping {
            true => rest.iter().position(|own| own == line),
            false => (rest.first() == Some(line)).then_some(0),
        };
        match found {
            Some(skipped) => at += skipped + 1,
            None => return Some(format!("shown: {line:?}\nsaid:  {:?}", rest.first())),
        }
        skipping = false;
    }
    let more = said.get(at..).unwrap_or_default();
    let rest = more.iter().find(|line| !line.is_empty());
    match rest {
        Some(line) if !skipping => Some(format!("not shown: {line:?}")),
        _ => None,
    }
}

#[test]
fn each_example_says_what_is_shown() {
    let page = readme();
    let examples = examples(&page);
    assert!(examples.len() >= 5, "the README has lost its examples");
    for example in examples {
        let arguments: Vec<&str> = example.command.split_whitespace().collect();
        let said = common::out(&common::run(&arguments));
        let said: Vec<&str> = said.lines().map(str::trim_end).collect();
        let shown: Vec<&str> = example.shown.iter().map(|line| line.trim_end()).collect();
        if let Some(difference) = difference(&shown, &said) {
            panic!(
                "README.md:{}: `cradle-verify{}`\n{difference}",
                example.line, example.command
            );
        }
    }
}

#[test]
fn the_document_in_the_readme_is_the_example_of_that_name() {
    let page = readme();
    let own = std::fs::read_to_string(root().join("docs/examples/well.md")).unwrap();
    let own: Vec<&str> = own.lines().collect();
    let shown = blocks(&page, "markdown");
    assert!(shown.iter().any(|(_, block)| *block == own));
}

#[test]
fn each_link_leads_somewhere() {
    for name in [
        "README.md",
        "ARCHITECTURE.md",
        "divergences.md",
        "CHANGELOG.md",
    ] {
        let page = std::fs::read_to_string(root().join(name)).unwrap();
        for link in page.split("](").skip(1) {
            let target = link.split(')').next().unwrap();
            if target.contains("://") || target.starts_with('#') {
                continue;
            }
            let path = target.split('#').next().unwrap();
            assert!(root().join(path).exists(), "{name}: {target}");
        }
    }
}

#[test]
fn skipped_lines_are_skipped_and_others_are_not() {
    let said = ["a", "b", "c"];
    assert_eq!(difference(&["a", "…", "c"], &said), None);
    assert_eq!(difference(&["…", "b", "…"], &said), None);
    assert!(difference(&["a", "c"], &said).is_some());
    assert!(difference(&["a", "b"], &said).is_some());
    assert!(difference(&["…", "d"], &said).is_some());
}
