//! Codes: what `explain` says of them, and what they make of the exit code.

use std::collections::BTreeSet;

use cradle_verify::report::codes::{CODES, Level};

use super::{code, err, folder, json, out, root, run, run_in};
use crate::common::{Audited, pages, pages_of_each_kind};

/// The entries of the reference, read in another way than the program does.
fn entries() -> Vec<(String, String)> {
    let page = std::fs::read_to_string(root().join("docs/notes.md")).unwrap();
    let mut entries: Vec<(String, String)> = Vec::new();
    for line in page.lines() {
        if let Some(heading) = line.strip_prefix("## ") {
            // A section without a code belongs to the reference alone.
            let code = heading.strip_prefix('`').and_then(|h| h.strip_suffix('`'));
            match code {
                Some(code) => entries.push((code.to_owned(), String::new())),
                None => break,
            }
        } else if let Some((_, text)) = entries.last_mut() {
            *text += line;
            *text += "\n";
        }
    }
    entries
}

#[test]
fn explain_prints_the_entry_of_the_reference() {
    let entries = entries();
    assert_eq!(entries.len(), CODES.len());
    for (name, text) in entries {
        let output = run(&["explain", &name]);
        assert_eq!(code(&output), 0, "{}", err(&output));
        let printed = out(&output);
        let (first, rest) = printed.split_once("\n\n").unwrap();
        assert_eq!(first.split_whitespace().next(), Some(name.as_str()));
        assert_eq!(rest.trim(), text.trim());
        assert_eq!(
            json(&run(&["explain", &name, "--format", "json"]))["text"],
            text.trim()
        );
    }
}

#[test]
fn the_table_of_the_reference_has_the_levels() {
    let page = std::fs::read_to_string(root().join("docs/notes.md")).unwrap();
    for level in [Level::Error, Level::Warning, Level::Note] {
        let start = format!("| {level} | ");
        let row = page
            .lines()
            .find_map(|line| line.strip_prefix(&start))
            .unwrap();
        let told: BTreeSet<&str> = row.split('`').skip(1).step_by(2).collect();
        let own = CODES.iter().filter(|(_, own)| *own == Some(level));
        assert_eq!(told, own.map(|(code, _)| *code).collect(), "{level}");
    }
}

#[test]
fn a_finding_has_the_level_of_its_code_on_the_page_for_people() {
    let text: String = pages().iter().map(Audited::human).collect();
    let mut seen = BTreeSet::new();
    for line in text.lines() {
        for level in ["error", "warning"] {
            let own = line
                .strip_prefix(level)
                .and_then(|rest| rest.strip_prefix('['));
            let Some((code, _)) = own.and_then(|rest| rest.split_once(']')) else {
                continue;
            };
            let known = CODES.iter().find(|(own, _)| *own == code).expect(code);
            assert_eq!(known.1.map(Level::word), Some(level), "{line}");
            seen.insert(code.to_owned());
        }
    }
    assert!(seen.len() > 6, "{seen:?}");
}

#[test]
fn an_equation_comes_before_a_code_and_a_slip_is_answered() {
    assert!(out(&run(&["explain", "23"])).starts_with("Equation (23)"));
    assert!(out(&run(&["explain", "error[fails]"])).starts_with("fails  error"));
    for (slip, meant) in [
        ("miscitd", "miscited"),
        ("Undecided", "undecided"),
        ("il-dimensioned", "ill-dimensioned"),
    ] {
        let output = run(&["explain", slip]);
        assert_eq!(code(&output), 2);
        assert!(
            err(&output).contains(&format!("perhaps {meant} is meant")),
            "{}",
            err(&output)
        );
    }
    let output = run(&["explain", "xyzzy-plugh"]);
    assert_eq!(code(&output), 2);
    assert!(
        err(&output).contains("the code of a finding"),
        "{}",
        err(&output)
    );
    let own = folder("named-as-a-code");
    let page = "<!-- check: given; claim fails -->\n$$ a = b $$\n";
    std::fs::write(own.join("page.md"), page).unwrap();
    let text = out(&run_in(&own, &["explain", "fails", "page.md"]));
    assert!(text.contains("read as"), "{text}");
}

#[test]
fn the_exit_code_is_as_the_level_says() {
    let own = folder("levels");
    let pages = [
        ("error", "<!-- check: derived -->\n$$ 1 = 2 \\tag{1} $$\n"),
        (
            "warning",
            "<!-- check: law -->\n$$ k x^2 = m \\tag{1} $$\n\nBy (1):\n\n$$ k = \\frac{m}{x^2} \\tag{2} $$\n",
        ),
        (
            "note",
            "<!-- check: derived -->\n$$ |x + y| \\leq |x| + |y| \\tag{1} $$\n",
        ),
        ("nothing", "<!-- check: law -->\n$$ a = b \\tag{1} $$\n"),
    ];
    for (at, (name, page)) in pages.iter().enumerate() {
        std::fs::write(own.join("page.md"), page).unwrap();
        for (allowed, level) in ["error", "warning", "note", "never"].iter().enumerate() {
            let output = run_in(&own, &["check", "page.md", "--fail-on", level]);
            let fails = at <= allowed && *level != "never" && *name != "nothing";
            assert_eq!(
                code(&output),
                i32::from(fails),
                "{name} at {level}: {}",
                out(&output)
            );
        }
        let plain = code(&run_in(&own, &["check", "page.md"]));
        assert_eq!(plain, i32::from(at <= 1), "{name}");
    }
}

#[test]
fn the_default_is_to_fail_on_what_is_counted_as_a_finding() {
    let mut codes = BTreeSet::new();
    for page in pages_of_each_kind() {
        let output = run(&["check", &page.path]);
        let text = out(&output);
        let needs = text.contains(" needs mending") || text.contains(" need mending");
        assert_eq!(code(&output) == 1, needs, "{}", page.path);
        codes.insert(code(&output));
    }
    assert_eq!(codes, BTreeSet::from([0, 1]));
}

#[test]
fn flags_stand_behind_their_command() {
    let output = run(&["--fail-on", "error", "check", "docs/examples/well.md"]);
    assert_eq!(code(&output), 2);
    assert!(
        err(&output).contains("behind the command"),
        "{}",
        err(&output)
    );
    for args in [
        &["--scenario", "A"][..],
        &["scenario", "--before", "1", "--after", "1"],
        &["simulate"],
        &["explain", "23"],
        &["explain", "fails"],
    ] {
        for format in ["short", "sarif", "github", "junit"] {
            let output = run(&[args, &["--format", format]].concat());
            assert_eq!(code(&output), 2, "{args:?}");
            assert!(
                err(&output).contains(&format!("`--format {format}`")),
                "{}",
                err(&output)
            );
            assert!(out(&output).is_empty());
        }
    }
}
