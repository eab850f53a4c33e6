//! JUnit's XML: well-formed whatever the page holds, a case for each statement.

use std::collections::BTreeMap;

use super::{code, err, hostile, out, run, run_in};

/// An element's name and attributes, and how deep it is.
struct Element {
    depth: usize,
    name: String,
    attributes: BTreeMap<String, String>,
}

/// Reads XML as far as it is used, and takes nothing that is not well-formed.
fn elements(text: &str) -> Vec<Element> {
    let allowed = |c: char| matches!(c, '\n' | '\t') || !c.is_control() && c != '\u{fffe}';
    assert!(text.chars().all(allowed), "{text:?}");
    let rest = text
        .strip_prefix("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n")
        .unwrap();
    let (mut found, mut open) = (Vec::new(), Vec::<String>::new());
    for piece in rest.split('<').skip(1) {
        let (tag, content) = piece.split_once('>').expect("a tag that ends");
        assert!(!content.contains('>'), "a bare `>` in {content:?}");
        entities(content);
        if let Some(name) = tag.strip_prefix('/') {
            assert_eq!(open.pop().as_deref(), Some(name));
            continue;
        }
        let (tag, closed) = match tag.strip_suffix('/') {
            Some(tag) => (tag, true),
            None => (tag, false),
        };
        let (name, mut rest) = tag.split_once(' ').unwrap_or((tag, ""));
        let mut attributes = BTreeMap::new();
        while let Some((key, after)) = rest.split_once("=\"") {
            let (value, after) = after.split_once('"').expect("a value that ends");
            entities(value);
            attributes.insert(key.trim().to_owned(), value.to_owned());
            rest = after;
        }
        assert_eq!(rest.trim(), "", "{tag}");
        let depth = open.len();
        let name = name.to_owned();
        if !closed {
            open.push(name.clone());
        }
        found.push(Element {
            depth,
            name,
            attributes,
        });
    }
    assert!(open.is_empty(), "{open:?}");
    found
}

fn entities(text: &str) {
    for after in text.split('&').skip(1) {
        let known = ["amp;", "lt;", "gt;", "quot;"];
        assert!(known.iter().any(|own| after.starts_with(own)), "{text:?}");
    }
}

fn counted(all: &[Element]) {
    let number =
        |element: &Element, name: &str| -> usize { element.attributes[name].parse().unwrap() };
    let suites = || all.iter().filter(|e| e.name == "testsuite");
    for (name, element) in [
        ("tests", "testcase"),
        ("failures", "failure"),
        ("errors", "error"),
        ("skipped", "skipped"),
    ] {
        let written = all.iter().filter(|e| e.name == element).count();
        assert_eq!(number(&all[0], name), written, "{name}");
        assert_eq!(
            suites().map(|s| number(s, name)).sum::<usize>(),
            written,
            "{name}"
        );
    }
}

#[test]
fn the_suite_of_the_example() {
    let output = run(&["check", "docs/examples/well.md", "--format", "junit"]);
    assert_eq!(code(&output), 1);
    insta::assert_snapshot!("junit", out(&output));
    counted(&elements(&out(&output)));
}

#[test]
fn the_report_has_a_suite_for_each_page_and_a_case_for_each_statement() {
    let all = elements(&out(&run(&["--format", "junit"])));
    counted(&all);
    let suites = all.iter().filter(|e| e.name == "testsuite").count();
    let pages = std::fs::read_dir(super::root().join("proofs/report")).unwrap();
    assert_eq!(suites, pages.count());
    let json = super::json(&run(&["--format", "json"]));
    let statements: usize = json["documents"]
        .as_array()
        .unwrap()
        .iter()
        .map(|d| d["equations"].as_array().unwrap().len())
        .sum();
    let plain = |e: &&Element| e.name == "testcase" && !e.attributes["name"].contains('[');
    assert_eq!(all.iter().filter(plain).count(), statements);
    assert!(all.iter().all(|e| e.depth <= 3));
}

#[test]
fn each_verdict_has_its_outcome() {
    let folder = super::folder("junit-verdicts");
    let page = "<!-- check: law -->\n$$ a = b + c \\tag{1} $$\n\nBy (1):\n\n$$ a - b = c \\tag{2} $$\n\nBy (1):\n\n\
        $$ a = c \\tag{3} $$\n\n$$ \\foo = 1 \\tag{4} $$\n\n<!-- check: derived -->\n$$ \\sin x = \\cos x \\tag{5} $$\n";
    std::fs::write(folder.join("page.md"), page).unwrap();
    let text = out(&run_in(&folder, &["check", "page.md", "--format", "junit"]));
    let all = elements(&text);
    counted(&all);
    let outcome = |name: &str| {
        let at = all
            .iter()
            .position(|e| e.attributes.get("name").is_some_and(|n| n == name));
        let after = all.get(at.unwrap_or_else(|| panic!("{name}: {text}")) + 1);
        after
            .filter(|e| e.depth == 3)
            .map_or("passed", |e| e.name.as_str())
    };
    assert_eq!(outcome("equation (1)"), "passed");
    assert_eq!(outcome("equation (2)"), "passed");
    assert_eq!(outcome("equation (3)"), "failure");
    assert_eq!(outcome("equation (4)"), "error");
    assert_eq!(outcome("equation (5)"), "skipped");
}

#[test]
fn no_page_can_end_a_text() {
    let folder = hostile("hostile-junit");
    let output = run_in(&folder, &["check", ".", "--format", "junit"]);
    assert_eq!(code(&output), 1, "{}", err(&output));
    counted(&elements(&out(&output)));
}

#[test]
fn what_does_not_fail_the_run_is_no_failure() {
    for (level, failures) in [("error", true), ("never", false)] {
        let args = [
            "check",
            "docs/examples/well.md",
            "--format",
            "junit",
            "--fail-on",
            level,
        ];
        let output = run(&args);
        assert_eq!(code(&output) == 1, failures, "{level}");
        assert_eq!(out(&output).contains("<failure"), failures, "{level}");
    }
}
