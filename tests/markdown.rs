//! Keys and environments in Markdown, notebooks, and which files `check` reads.

use crate::common;
use std::path::PathBuf;

use cradle_verify::derivation::Derivation;
use cradle_verify::document::Document;
use cradle_verify::notation::latex_statement;

use crate::common::{verdicts, verdicts_of};

fn read(source: &str) -> Derivation {
    Derivation::from_markdown("page.md", source)
}

/// Number or key, and what was understood.
fn equations(derivation: &Derivation) -> Vec<String> {
    let shown = derivation.equations.iter().map(|equation| {
        let key = equation.keys.first().map(String::as_str);
        let said = match &equation.statements {
            Ok(all) => all
                .iter()
                .map(latex_statement)
                .collect::<Vec<_>>()
                .join(" | "),
            Err(error) => format!("unreadable: {}", error.message),
        };
        format!("{}: {said}", equation.tag.as_deref().or(key).unwrap_or("-"))
    });
    shown.collect()
}

/// What the last equation is said to follow from, by position, and what is cited and not there.
fn premises_of_last(derivation: &Derivation) -> (Vec<usize>, Vec<String>) {
    let (found, _, unknown) = derivation.premises(derivation.equations.len() - 1);
    let unknown = unknown.iter().map(|u| u.label.clone());
    (found.to_vec(), unknown.collect())
}

#[test]
fn a_myst_block_may_hold_its_equation_on_its_first_line_and_its_options_between_dashes() {
    let derivation = read(
        "```{math} x = y + 1\n```\n\n~~~{math} a = b\n:label: ab\n~~~\n\n```{math}\n---\nlabel: \"mom\"\nnowrap: true\n---\np = m v\n```\n\n\
         ```{math} z = w\nu = v\n```\n\n```{math} never = closed\n",
    );
    let expected = ["-: x = y + 1", "ab: a = b", "mom: p = m v"];
    assert_eq!(equations(&derivation), expected);
    let problems = &derivation.pages[0].problems;
    let told: Vec<&str> = problems.iter().map(|own| own.message.as_str()).collect();
    let expected = [
        "an equation on the line of `{math}` is read only where none stands below it",
        "this `math` block is never closed",
    ];
    assert_eq!(told, expected);
}

#[test]
fn keys_are_written_as_myst_and_as_quarto_write_them_and_cited_so() {
    let derivation = read(
        "```{math}\n:label: mom\n\np = m v\n```\n\n:::{math}\n:label: work\nW = F s\n:::\n\n$$ E = T + V $$ (energy)\n\n$$\nF = m a\n$$ {#eq-force}\n\n\
         ```math\nL = T - V\n```\n\n$$ a = b \\label{tex} $$\n\n\
         With {eq}`mom`, {eq}`energy`, @eq-force and \\eqref{tex}, but not @eq-none,\n\n$$ c = d $$\n",
    );
    assert_eq!(
        equations(&derivation),
        [
            "mom: p = m v",
            "work: W = F s",
            "energy: E = T + V",
            "eq-force: F = m a",
            "-: L = T - V",
            "tex: a = b",
            "-: c = d"
        ]
    );
    let (found, unknown) = premises_of_last(&derivation);
    assert_eq!(found, [0, 2, 3, 5]);
    assert_eq!(unknown, ["(eq-none)"]);
}

#[test]
fn environments_outside_dollars_are_displays() {
    let derivation = read(
        "Text\n\n\\begin{align}\na &= b \\tag{1} \\\\\n  &= c \\tag{2}\n\\end{align}\n\n\
         \\begin{equation*}\nd = e\n\\end{equation*}\nBy (2),\n\\begin{alignat}{2} f &= g & h &= i \\end{alignat}\n",
    );
    assert_eq!(
        equations(&derivation),
        ["1: a = b", "2: b = c", "-: d = e", "-: f = g | h = i"]
    );
    assert_eq!(premises_of_last(&derivation).0, [0, 1]);
    assert!(derivation.pages[0].problems.is_empty());
}

#[test]
fn environments_that_are_not_ended_or_not_read_are_told() {
    for (source, message) in [
        (
            "\\begin{align}\na = b\n\n$$ c = d $$\n",
            "this `align` is never ended",
        ),
        (
            "\\begin{IEEEeqnarray}{rCl} a = b \\end{IEEEeqnarray}\n",
            "the environment `IEEEeqnarray` is not read",
        ),
    ] {
        let derivation = read(source);
        let told: Vec<&str> = derivation.pages[0]
            .problems
            .iter()
            .map(|p| &*p.message)
            .collect();
        assert_eq!(told, [message]);
    }
}

const NOTEBOOK: &str = r##"{
 "cells": [
  {"cell_type": "markdown", "source": ["# Carts\n", "\n", "<!-- check: law -->\n", "$$ p = m v \\tag{1} $$\n"]},
  {"cell_type": "code", "source": ["x = '$$ a = b $$'"]},
  {"cell_type": "markdown", "source": "An unclosed $$ a\n"},
  {"cell_type": "markdown", "source": ["By (1),\n", "$$ v = \\foo $$"]}
 ],
 "nbformat": 4
}"##;

#[test]
fn a_notebook_is_its_markdown_cells_and_places_are_in_them() {
    let document = Document::notebook("carts.ipynb", NOTEBOOK).unwrap();
    let derivation = Derivation::new(vec![document]);
    assert_eq!(
        equations(&derivation),
        ["1: p = m v", r"-: unreadable: `\foo` is not known"]
    );
    let document = &derivation.pages[0].document;
    let error = derivation.equations[1].statements.as_ref().unwrap_err();
    let (path, place) = document.place(error.span);
    assert_eq!(
        (path, place.line, place.column),
        ("carts.ipynb:cell 4", 2, 8)
    );
    let problem = &derivation.pages[0].problems[0];
    assert_eq!(document.place(problem.span).0, "carts.ipynb:cell 3");
    assert_eq!(premises_of_last(&derivation).0, [0]);
}

#[test]
fn programs_are_told_the_lines_of_the_notebook() {
    let folder = Folder::new("saved", &[("d.ipynb", NOTEBOOK)]);
    let said = |format: &str| {
        let output = common::run_in(&folder.0, &["check", "d.ipynb", "--format", format]);
        common::out(&output)
    };
    // Both cells stand on one line each in the file, and columns are no help there.
    let github = said("github");
    for line in [5, 6] {
        let place = format!("::error file=d.ipynb,line={line},endLine={line},title=unreadable::");
        assert!(github.contains(&place), "{github}");
    }
    let log: serde_json::Value = serde_json::from_str(&said("sarif")).unwrap();
    let results = log["runs"][0]["results"].as_array().unwrap();
    let last = &results.last().unwrap()["locations"][0];
    let physical = &last["physicalLocation"];
    assert_eq!(physical["artifactLocation"]["uri"], "d.ipynb");
    assert_eq!(
        physical["region"],
        serde_json::json!({ "startLine": 6, "endLine": 6 })
    );
    assert_eq!(last["logicalLocations"][0]["name"], "cell 4");
    // For people, and for editors that show cells, it is the line of the cell.
    assert!(
        said("short").contains("d.ipynb:cell 4:2:8: "),
        "{}",
        said("short")
    );
}

#[test]
fn what_is_no_notebook_is_refused() {
    for text in [
        "",
        "{}",
        "[]",
        "{\"cells\": 3}",
        "{\"cells\": [{\"cell_type\": \"markdown\"}]}",
        "{\"worksheets\": []}",
    ] {
        assert!(Document::notebook("x.ipynb", text).is_err(), "{text}");
    }
    assert!(Document::notebook("x.ipynb", &"[".repeat(100_000)).is_err());
}

struct Folder(PathBuf);

impl Folder {
    fn new(name: &str, files: &[(&str, &str)]) -> Folder {
        let folder = common::folder(&format!("markdown/{name}"));
        for (path, text) in files {
            let path = folder.join(path);
            std::fs::create_dir_all(path.parent().unwrap()).unwrap();
            std::fs::write(path, text).unwrap();
        }
        Folder(folder)
    }

    fn check(&self, arguments: &[&str]) -> serde_json::Value {
        let arguments = [&["check", "--format", "json"], arguments].concat();
        common::json(&common::run_in(&self.0, &arguments))
    }
}

fn paths(view: &serde_json::Value) -> Vec<&str> {
    let documents = view["documents"].as_array().unwrap().iter();
    documents
        .map(|document| document["path"].as_str().unwrap())
        .collect()
}

#[test]
fn a_directory_is_read_with_all_kinds_of_documents_and_included_files_once() {
    let folder = Folder::new(
        "formats",
        &[
            ("a.md", "$$ a = 1 $$\n"),
            ("b.markdown", "$$ a = 1 $$\n"),
            (
                "c/main.tex",
                "\\documentclass{article}\\begin{document}\\input{part}\n\\[ b = 1 \\]\\end{document}",
            ),
            ("c/part.tex", "\\[ c = \\foo \\]\n"),
            ("d.ipynb", NOTEBOOK),
            ("e.txt", "$$ a = 1 $$\n"),
            ("f.qmd", "$$ a = 1 $$\n"),
        ],
    );
    let view = folder.check(&["."]);
    assert_eq!(
        paths(&view),
        [
            "./a.md",
            "./b.markdown",
            "./c/main.tex",
            "./d.ipynb",
            "./f.qmd"
        ]
    );
    let unread = &view["documents"][2]["equations"][0];
    assert_eq!(unread["file"], "./c/part.tex");
    assert_eq!(unread["notes"][0]["code"], "unreadable");
    assert_eq!(view["summary"]["undecided"], 2);
    // Named twice, it is still read once.
    let view = folder.check(&["c/part.tex", "c/main.tex"]);
    assert_eq!(paths(&view), ["c/main.tex"]);
}

#[test]
fn the_name_of_standard_input_says_what_it_is_written_in() {
    let arguments = [
        "check",
        "-",
        "--stdin-filename",
        "notes.tex",
        "--format",
        "json",
    ];
    let text = "\\begin{equation} a = 1 \\end{equation}\n";
    let view = common::json(&common::piped(&arguments, text));
    assert_eq!(paths(&view), ["notes.tex"]);
    assert_eq!(view["documents"][0]["equations"][0]["tag"], "1");
}

#[test]
fn backslashes_that_are_doubled_for_a_processor_display_as_single_ones_do() {
    let derivation = read(
        "\\\\[ v = g t \\\\]\n\nHere \\\\(g = h\\\\) and C:\\\\x.\n\n\\\\[\n\\begin{aligned} a &= b \\\\ &= c \\end{aligned}\n\\\\]\n\n\\\\[ never = closed\n",
    );
    assert_eq!(equations(&derivation), ["-: v = g t", "-: a = b = c"]);
    let problems = &derivation.pages[0].problems;
    let told: Vec<&str> = problems.iter().map(|own| own.message.as_str()).collect();
    assert_eq!(told, ["this `\\\\[` is never closed"]);
}

#[test]
fn a_myst_directive_in_backticks_holds_markdown_unless_it_holds_code() {
    let derivation = read(
        "````{admonition} By $$ z = 1 $$\n---\nclass: tip\n---\n# Title\n```{math}\n:label: v\nv = 12 g t\n```\n```{code-block} tex\n$$ no = 1 $$\n```\n````\n\n\
         - Item\n\n  ~~~{note}\n  $$ v = 13 g t $$\n  ~~~\n\n  `$$ no = 1 $$`\n\n> ```{prf:proof}\n> $$ w = 1 $$\n> ```\n\n\
         ```{python}\nno = \"$$ a = 1 $$\"\n```\n\n``````{note}\n`````{tip}\n````{hint}\n$$ x = 1 $$\n````\n`````\n``````\n\n```{tip}\n$$ y = 1 $$\n",
    );
    let expected = [
        "-: z = 1",
        "v: v = 12 g t",
        "-: v = 13 g t",
        "-: w = 1",
        "-: x = 1",
        "-: y = 1",
    ];
    assert_eq!(equations(&derivation), expected);
    let problems = &derivation.pages[0].problems;
    assert!(problems.is_empty(), "{problems:?}");
}

#[test]
fn an_equation_in_html_is_told_once() {
    let derivation = read(
        "<div>\n$$ a = 1 $$\n$$ b = 1 $$\n</div>\n\n<div>\n$$ c <!-- check: law --> $$\n</div>\n\n$$ d = 1 $$\n",
    );
    let places: Vec<usize> = derivation.pages[0]
        .problems
        .iter()
        .map(|own| derivation.pages[0].document.place(own.span).1.line)
        .collect();
    assert_eq!(places, [2, 3, 7, 7]);
    assert_eq!(equations(&derivation), ["-: d = 1"]);
}

#[test]
fn text_in_utf_16_is_none_with_and_without_a_mark_at_its_beginning() {
    let text = "\\documentclass{article}";
    let low: Vec<u8> = text.encode_utf16().flat_map(u16::to_le_bytes).collect();
    let high: Vec<u8> = text.encode_utf16().flat_map(u16::to_be_bytes).collect();
    for bytes in [low, high] {
        let error = cradle_verify::document::decode(&bytes).unwrap_err();
        assert!(error.to_string().starts_with("not UTF-8 text"), "{error}");
    }
    for text in ["", "a", "a\0", "a = b\0\0\0", "\0\0\0\0\0\0"] {
        assert!(
            cradle_verify::document::decode(text.as_bytes()).is_ok(),
            "{text:?}"
        );
    }
}

/// What the text of a later cell says is looked for there, and not at the same place of the first one.
#[test]
fn a_page_in_a_later_cell_is_judged_as_by_itself() {
    let pages = [
        // By symmetry something is left open.
        "The best response of the first firm is\n\n$$ x = \\frac{a - b y}{2 b}. \\tag{1} $$\n\nBy symmetry we have\n\n$$ y = \\frac{a - b x}{2 b}. \\tag{2} $$\n",
        // A slope is taken of what is cited by what is named.
        "The height is\n\n$$ y = v t - g t^2. \\tag{1} $$\n\nDifferentiating (1) with respect to $t$ we obtain the velocity\n\n$$ u = v - g t. \\tag{2} $$\n",
        // What is met at a place.
        "The law of motion is\n\n$$ x = A \\cos(w t) + B \\sin(w t). \\tag{1} $$\n\nWith $x = h$ at $t = 0$ we get\n\n$$ A = 2 h. \\tag{2} $$\n",
    ];
    for page in pages {
        let cell = |text: &str| serde_json::json!({ "cell_type": "markdown", "source": text });
        let cells = [cell(&"Notes taken on the way. ".repeat(4)), cell(page)];
        let notebook = serde_json::json!({ "nbformat": 4, "cells": cells }).to_string();
        let alone = verdicts(page);
        let in_cell = verdicts_of(vec![Document::notebook("a.ipynb", &notebook).unwrap()]);
        assert_eq!(in_cell, alone, "{page}");
    }
}
