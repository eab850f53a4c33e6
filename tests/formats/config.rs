//! `cradle.toml`: what is read of it, which one counts, what it changes, and where its errors are.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use cradle_verify::audit::Audit;
use cradle_verify::config::Config;
use cradle_verify::derivation::{Beside, Derivation};
use cradle_verify::document::Document;
use cradle_verify::report::{Report, amiss, configuration};
use serde_json::{Value, json};
use toml::de::{DeTable, DeValue};

use super::schema::faults;
use super::{code, err, folder, json, out, root, run, run_in};

/// A page that a configuration has something to say to: (2) compares what differs in dimension, once dimensions are known.
const PAGE: &str = "<!-- check: law -->\n$$ s = v t \\tag{1} $$\n\nBy (1),\n\n$$ v = \\frac{s}{t} \\tag{2} $$\n\n\
                    By (1),\n\n$$ s + v = v t + v \\tag{3} $$\n";

/// A folder with files, which is a repository of its own.
fn repository(test: &str, files: &[(&str, &str)]) -> PathBuf {
    let folder = folder(&format!("config-{test}"));
    std::fs::create_dir_all(folder.join(".git")).unwrap();
    for (path, text) in files {
        let path = folder.join(path);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, text).unwrap();
    }
    folder
}

fn short(folder: &Path, args: &[&str]) -> String {
    let output = run_in(folder, &[args, &["--format", "short"]].concat());
    assert!(code(&output) < 2, "{}", err(&output));
    out(&output)
}

/// What is wrong with a configuration, as it is shown.
fn refused(text: &str) -> String {
    let wrong = Config::read("cradle.toml", text).expect_err(text);
    anstream::adapter::strip_str(&amiss(&wrong)).to_string()
}

/// The value that a text is in JSON.
fn value(table: &DeTable<'_>) -> Value {
    fn one(value: &DeValue<'_>) -> Value {
        match value {
            DeValue::String(text) => json!(text),
            DeValue::Integer(number) => json!(number.as_str().parse::<i64>().unwrap()),
            DeValue::Boolean(truth) => json!(truth),
            DeValue::Array(all) => all.iter().map(|item| one(item.get_ref())).collect(),
            DeValue::Table(table) => self::value(table),
            other => panic!("{other:?} is in no example"),
        }
    }
    let entries = table.iter();
    entries
        .map(|(key, own)| (key.get_ref().to_string(), one(own.get_ref())))
        .collect::<serde_json::Map<String, Value>>()
        .into()
}

/// What the schema has against a text.
fn against_schema(text: &str) -> Vec<String> {
    let schema = std::fs::read_to_string(root().join("docs/config.schema.json")).unwrap();
    let schema: Value = serde_json::from_str(&schema).unwrap();
    let table = DeTable::parse(text).unwrap();
    faults(&value(table.get_ref()), &schema)
}

/// What stands in fenced blocks of a language on a page.
fn blocks(page: &str, language: &str) -> Vec<String> {
    let text = std::fs::read_to_string(root().join(page)).unwrap();
    let begin = format!("```{language}\n");
    let parts = text.split(begin.as_str()).skip(1);
    parts
        .map(|part| part.split("```").next().unwrap().to_owned())
        .collect()
}

#[test]
fn the_examples_are_read_and_are_as_the_schema_says() {
    let examples = blocks("docs/config.md", "toml");
    assert!(!examples.is_empty());
    for text in examples {
        let config =
            Config::read("cradle.toml", &text).unwrap_or_else(|_| panic!("{}", refused(&text)));
        assert!(!config.beside.symbols.is_empty());
        assert_eq!(against_schema(&text), Vec::<String>::new());
    }
}

#[test]
fn what_the_schema_rejects_is_rejected() {
    for text in [
        "simbols = 1",
        "symbols = [\"m\"]",
        "given = \"3\"",
        "given = [3]",
        "files = 1",
        "[severity]\nfail = \"error\"",
        "[severity]\nholds = \"error\"",
        "[severity]\nfails = \"bad\"",
        "[severity]\nfails = 1",
        "[budget]\npoint = 1",
        "[budget]\npoints = 0",
        "[budget]\npoints = 1000000",
        "[budget]\npoints = \"1\"",
        "[symbols]\nm = 1",
        "[symbols.m]\nx = \"mass\"",
    ] {
        assert!(!against_schema(text).is_empty(), "{text}");
        assert!(Config::read("cradle.toml", text).is_err(), "{text}");
    }
    let schema = std::fs::read_to_string(root().join("docs/config.schema.json")).unwrap();
    let schema: Value = serde_json::from_str(&schema).unwrap();
    let codes = schema["properties"]["severity"]["properties"]
        .as_object()
        .unwrap();
    let told = cradle_verify::report::codes::CODES.iter();
    let mut told: Vec<&str> = told
        .filter(|(_, level)| level.is_some())
        .map(|(code, _)| *code)
        .collect();
    told.sort_unstable();
    let mut codes: Vec<&str> = codes.keys().map(String::as_str).collect();
    codes.sort_unstable();
    assert_eq!(codes, told);
}

#[test]
fn errors_are_shown_where_they_are_with_what_was_meant() {
    let cases: [(&str, &[&str]); 5] = [
        (
            "gvien = [\"3\"]\n\n[severity]\nmiscitd = \"of\"\nuncited = \"of\"\n",
            &[
                "error: `gvien` is no key of this file\n --> cradle.toml:1:1\n",
                "1 | gvien = [\"3\"]\n  | ^^^^^\n  |\n  = help: did you mean `given`?",
                "--> cradle.toml:4:1\n",
                "did you mean `miscited`?",
                "--> cradle.toml:5:12\n",
                "did you mean `off`?",
            ],
        ),
        (
            "[symbols]\n'\\mu' = \"masss, positve\"\n\"m_1 m_2\" = \"mass\"\n\"lambda_0\" = \"positive\"\n",
            &[
                "write `\\lambda` for λ",
                "error: `masss` is the name of no dimension\n --> cradle.toml:2:10\n",
                "error: `positve` is not an attribute\n --> cradle.toml:2:17\n",
                "did you mean `positive`?",
                "error: this is a term, not a single symbol\n --> cradle.toml:3:2\n",
                "error: this is a term, not a single symbol\n --> cradle.toml:4:2\n",
            ],
        ),
        (
            "[symbols]\nm = \"mass\"\n\"m, v\" = \"velocity\"\n\"\\\\nu\" = \"frequenzy\"\n",
            &[
                "error: `m` is declared with two dimensions\n --> cradle.toml:3:2\n",
                "error: `frequenzy` is the name of no dimension\n --> cradle.toml:4:11\n",
            ],
        ),
        (
            "[symbols]\nx = \"in [0, 1]\"\n\"x, y\" = \">= 2\"\n",
            &["error: no number is all that `x` is declared to be\n --> cradle.toml:3:2\n"],
        ),
        // Of what is no TOML the first slip is told alone.
        (
            "given = [\"3\"\n[symbols\n",
            &[
                "error: this is no TOML: missing comma between array elements, expected `,`\n --> cradle.toml:2:1\n",
            ],
        ),
    ];
    for (text, expected) in cases {
        let said = refused(text);
        for part in expected {
            assert!(said.contains(part), "{part}\n{said}");
        }
        let errors = expected.iter().filter(|part| part.contains("-->")).count();
        assert_eq!(said.matches("error: ").count(), errors, "{said}");
    }
}

#[test]
fn a_text_that_is_no_configuration_ends_in_an_error_and_not_in_a_panic() {
    for text in [
        "\0",
        "[",
        "= 1",
        "[symbols]\nm = \"positive, <= 0\"",
        "[symbols]\n\"\" = \"\"",
        "[symbols]\nx = \"\"",
        "[symbols]\n\"a:b\" = \"mass\"",
        "[symbols]\n\"a,\" = \"mass\"",
        "files = [\"\"]",
        "files = [\"a\\\\b\"]",
        "given = [\"\"]",
        "a.b.c = 1",
        "[symbols]\n\"\"\"δ\\u00e9\"\"\" = \"δ\"",
        "[symbols]\n'δ}' = 'in [1, 0]'",
        "symbols = {}\n[symbols]",
    ] {
        assert!(!refused(text).is_empty(), "{text}");
    }
    let deep = format!("a = {}", "[".repeat(20_000));
    assert!(Config::read("cradle.toml", &deep).is_err());
    assert!(Config::read("cradle.toml", "").is_ok());
}

/// The `symbols` clauses of a page as the table of a configuration, and the page without them.
fn moved(source: &str) -> (String, String) {
    let (mut table, mut left) = (String::from("[symbols]\n"), String::new());
    for line in source.lines() {
        let clause = line
            .trim_start_matches(['%', ' '])
            .trim_start_matches("check:")
            .trim_start();
        match clause.strip_prefix("symbols ") {
            Some(clause) if !line.contains("-->") => {
                let (names, attributes) = clause.split_once(": ").unwrap();
                // Nothing in a name but its backslashes needs to be escaped.
                let names = names.replace('\\', "\\\\");
                table += &format!("\"{names}\" = '''{attributes}'''\n");
                // What is left of a comment in LaTeX must not go on with nothing.
                left += if line.trim_start().starts_with('%') {
                    "\n"
                } else {
                    "check-free\n"
                };
            }
            _ => left += &format!("{line}\n"),
        }
    }
    (
        table,
        left.replace("<!-- check:\ncheck-free", "<!-- \ncheck-free"),
    )
}

fn read(path: &str, source: &str, beside: Option<Arc<Beside>>) -> Derivation {
    let documents = match path.ends_with(".tex") {
        true => Document::latex(path, source, &()),
        false => vec![Document::markdown(path, source)],
    };
    Derivation::beside(
        documents
            .into_iter()
            .map(|own| (own, beside.clone()))
            .collect(),
    )
}

/// What an audit says of each statement, by verdict and notes.
fn said(derivation: &Derivation) -> Vec<String> {
    let entries = Audit::of(derivation).entries.into_iter();
    let told = entries.map(|entry| {
        let codes: Vec<&str> = entry.notes.iter().map(|note| note.code()).collect();
        let equation = derivation.equations[entry.equation].reference();
        format!("{equation} {} {}", entry.verdict.word(), codes.join(" "))
    });
    told.collect()
}

fn examples() -> Vec<(String, String)> {
    let entries = std::fs::read_dir(root().join("docs/examples")).unwrap();
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    let read = |path: PathBuf| {
        (
            path.display().to_string(),
            std::fs::read_to_string(path).unwrap(),
        )
    };
    paths.into_iter().map(read).collect()
}

#[test]
fn a_declaration_says_the_same_beside_a_document_as_in_it() {
    let mut number = 0;
    for (path, source) in examples() {
        let (table, left) = moved(&source);
        let config =
            Config::read("cradle.toml", &table).unwrap_or_else(|_| panic!("{}", refused(&table)));
        number += config.beside.symbols.len();
        let beside = read(&path, &left, Some(config.beside));
        assert_eq!(
            said(&beside),
            said(&read(&path, &source, None)),
            "{path}\n{table}"
        );
    }
    assert!(number > 40, "{number} declarations were moved");
}

#[test]
fn what_init_writes_changes_no_verdict() {
    for (path, source) in examples() {
        let fewer = source
            .lines()
            .filter(|line| !line.contains("symbols") || line.contains("check:"));
        let fewer = fewer.collect::<Vec<_>>().join("\n");
        for source in [source, fewer] {
            let before = read(&path, &source, None);
            let text = configuration(&before, std::slice::from_ref(&path));
            let config =
                Config::read("cradle.toml", &text).unwrap_or_else(|_| panic!("{}", refused(&text)));
            let after = read(&path, &source, Some(config.beside));
            assert_eq!(said(&after), said(&before), "{path}\n{text}");
            assert!(
                after.pages.iter().all(|page| page.clashes.is_empty()),
                "{path}\n{text}"
            );
            let again = configuration(&after, &[]);
            assert!(!again.contains("\n[symbols]"), "{path}\n{again}");
        }
    }
}

#[test]
fn init_says_where_a_dimension_has_several_names() {
    let page = "<!-- check: symbols F: force; symbols r: length -->\n\n<!-- check: law -->\n$$ W = F r \\tag{1} $$\n\n\
                Twice\n\n$$ q' = \\mu W \\tag{2} $$\n";
    let folder = repository("init", &[("a.md", page)]);
    let toml = out(&run_in(&folder, &["init", "a.md", "--toml"]));
    for line in [
        "#   W    a.md:4  not declared; the equations give Energy or Torque\n",
        "\nfiles = [\"a.md\"]\n\n[symbols]\n",
        "\nW = \"energy\"    # or torque, which has the same dimension\n",
        "\n\"q'\" = \"real\"   # says nothing: put a dimension and a domain in its place\n",
        "\n'\\mu' = \"real\"  # says nothing: put a dimension and a domain in its place\n",
    ] {
        assert!(toml.contains(line), "{line}\n{toml}");
    }
    let comments = out(&run_in(&folder, &["init", "a.md"]));
    let line = "  W    a.md:4  not declared; the equations give Energy or Torque\n";
    assert!(comments.contains(line), "{comments}");
    run_in(&folder, &["init", "a.md", "--toml", "-o", "cradle.toml"]);
    // What is written is found, and its places are told.
    let again = out(&run_in(&folder, &["init"]));
    assert!(
        again.contains("declared in cradle.toml:14:1: Energy or Torque"),
        "{again}"
    );
}

#[test]
fn the_nearest_one_counts_as_far_as_the_repository_goes() {
    let files = [
        (
            "cradle.toml",
            "[symbols]\ns = \"length\"\nv = \"velocity\"\n",
        ),
        ("a/b/page.md", PAGE),
        ("a/c/page.md", PAGE),
        ("a/c/cradle.toml", ""),
    ];
    let folder = repository("nearest", &files);
    assert!(short(&folder, &["check", "a/b"]).contains("ill-dimensioned"));
    assert!(
        !short(&folder, &["check", "a/c"]).contains("ill-dimensioned"),
        "not mixed"
    );
    assert!(!short(&folder, &["check", "a/b", "--no-config"]).contains("ill-dimensioned"));
    assert!(
        !short(&folder, &["check", "a/b", "--config", "a/c/cradle.toml"])
            .contains("ill-dimensioned")
    );
    assert!(
        short(&folder, &["check", "a/c", "--config", "cradle.toml"]).contains("ill-dimensioned")
    );
    // From below, the file is shown as somebody there would write it.
    std::fs::write(folder.join("cradle.toml"), "[symbls]\n").unwrap();
    let wrong = run_in(&folder.join("a/b"), &["check", "page.md"]);
    assert_eq!(code(&wrong), 2);
    assert!(
        err(&wrong).contains("--> ../../cradle.toml:1:2"),
        "{}",
        err(&wrong)
    );
    // A repository within is one of its own, and outside of any only the folder itself counts.
    std::fs::create_dir_all(folder.join("a/b/.git")).unwrap();
    assert!(!short(&folder, &["check", "a/b"]).contains("ill-dimensioned"));
}

#[test]
fn standard_input_has_the_configuration_of_its_name() {
    let config = "[symbols]\ns = \"length\"\nv = \"velocity\"\n";
    let folder = repository("stdin", &[("a/cradle.toml", config), ("a/page.md", PAGE)]);
    let checked = |name: &str| {
        let mut child = std::process::Command::new(env!("CARGO_BIN_EXE_cradle-verify"))
            .args(["check", "-", "--stdin-filename", name, "--format", "short"])
            .current_dir(&folder)
            .stdin(std::fs::File::open(folder.join("a/page.md")).unwrap())
            .stdout(std::process::Stdio::piped())
            .spawn()
            .unwrap();
        let mut text = String::new();
        std::io::Read::read_to_string(&mut child.stdout.take().unwrap(), &mut text).unwrap();
        child.wait().unwrap();
        text
    };
    assert!(checked("a/page.md").contains("ill-dimensioned"));
    assert!(!checked("page.md").contains("ill-dimensioned"));
}

#[test]
fn a_clash_shows_both_places_and_the_document_counts() {
    let config = "given = [\"2\"]\n\n[symbols]\ns = \"length, in [0, 1]\"\nv = \"velocity\"\nt = \"positive\"\n";
    let page = format!(
        "<!-- check: symbols s: temperature, >= 2; symbols t: nonnegative -->\n\n{}",
        PAGE.replace("By (1),\n\n$$ v", "<!-- check: from (1) -->\n\n$$ v")
    );
    let folder = repository("clash", &[("cradle.toml", config), ("page.md", &page)]);
    assert_eq!(
        short(&folder, &["check", "page.md"]),
        "page.md:1:21: warning[clashing-declaration]: `s` has another dimension here than at cradle.toml:4:1\n\
         page.md:1:21: warning[clashing-declaration]: `s` is allowed values here that cradle.toml:4:1 rules out\n\
         page.md:1:51: warning[clashing-declaration]: `t` is allowed values here that cradle.toml:6:1 rules out\n\
         page.md:6:13: warning[clashing-declaration]: `2` is derived here, and given by cradle.toml:1:11\n\
         page.md:12:4: error[ill-dimensioned]: equation (3) adds Temperature to Velocity\n"
    );
    let human = out(&run_in(&folder, &["check", "page.md"]));
    for part in [
        " --> page.md:1:21\n",
        "symbols t: nonnegative -->\n  |                     ^ this counts in the document\n",
        " ::: cradle.toml:4:1\n  |\n4 | s = \"length, in [0, 1]\"\n  | - the file says otherwise\n",
    ] {
        assert!(human.contains(part), "{part}\n{human}");
    }
    let sarif = json(&run_in(&folder, &["check", "page.md", "--format", "sarif"]));
    let results = sarif["runs"][0]["results"].as_array().unwrap();
    let clash = results
        .iter()
        .find(|r| r["ruleId"] == "clashing-declaration")
        .unwrap();
    let related = &clash["relatedLocations"][0]["physicalLocation"];
    assert_eq!(related["artifactLocation"]["uri"], "cradle.toml");
    assert_eq!(related["region"]["startLine"], 4);
    let all = json(&run_in(&folder, &["check", "page.md", "--format", "json"]));
    assert_eq!(all["documents"][0]["problems"].as_array().unwrap().len(), 4);
    // Where documents are meant to differ, somebody says so.
    std::fs::write(
        folder.join("cradle.toml"),
        format!("{config}\n[severity]\nclashing-declaration = \"off\"\n"),
    )
    .unwrap();
    assert!(!short(&folder, &["check", "page.md"]).contains("clashing"));
}

#[test]
fn what_is_narrowed_or_added_is_no_clash() {
    let config = "[symbols]\nx = \"positive\"\nn = \"count\"\ne = \"Euler's number\"\n";
    let page = "<!-- check: symbols x: in (1, 2]; symbols n: natural; symbols e: Euler's number -->\n\n\
                <!-- check: law -->\n$$ y = n x \\tag{1} $$\n\n<!-- check: derived -->\n$$ y > 1 \\tag{2} $$\n";
    let folder = repository("narrowed", &[("cradle.toml", config), ("page.md", page)]);
    assert_eq!(short(&folder, &["check", "page.md"]), "");
    let explained = out(&run_in(&folder, &["explain", "2", "page.md"]));
    assert!(
        explained.contains("x ≤ 2") && !explained.contains("cradle.toml"),
        "{explained}"
    );
}

#[test]
fn what_narrows_agrees_and_what_widens_does_not() {
    for (beside, own, agrees) in [
        ("in [0, 1]", "positive", true),
        ("positive", "> 2", true),
        ("in [0, 1]", "real", true),
        // 0 is let in again.
        ("positive", "in [0, 1]", false),
        // Nothing is left.
        ("in [0, 1]", "> 2", false),
    ] {
        let config = format!("[symbols]\nx = \"{beside}\"\n");
        let config = Config::read("cradle.toml", &config).unwrap();
        let page = format!("<!-- check: symbols x: {own} -->\n");
        let derivation = read("page.md", &page, Some(config.beside));
        let clashes = &derivation.pages[0].clashes;
        assert_eq!(clashes.is_empty(), agrees, "{beside}; {own}: {clashes:?}");
    }
}

#[test]
fn explain_says_where_a_declaration_was_found() {
    let config = "[symbols]\na = \"positive\"\nb = \"positive\"\n";
    let page =
        "<!-- check: symbols b: >= 1 -->\n\n<!-- check: derived -->\n$$ a + b > 0 \\tag{1} $$\n";
    let folder = repository("explain", &[("cradle.toml", config), ("page.md", page)]);
    let explained = out(&run_in(&folder, &["explain", "1", "page.md"]));
    assert!(
        explained.contains("a > 0   declared, cradle.toml:2:1"),
        "{explained}"
    );
    assert!(explained.contains("b ≥ 1   declared\n"), "{explained}");
    let page = out(&run_in(&folder, &["report", "page.md"]));
    assert!(page.contains("declared, cradle.toml:2:1"));
}

#[test]
fn equations_are_given_by_number_key_and_name() {
    let tex = "\\documentclass{article}\\begin{document}\nText.\\begin{equation} p = m v \\end{equation}\nThen\n\
               \\begin{equation}\\label{eq:f} f = m a \\end{equation}\nand\n% check: claim power; derived\n\
               \\[ P = f v \\]\n\\begin{equation} m a v = P \\end{equation}\\end{document}\n";
    let folder = repository(
        "given",
        &[
            ("paper.tex", tex),
            (
                "cradle.toml",
                "given = [\"eq:f\", \"claim power\", \" (1) \", \"9\"]\n",
            ),
        ],
    );
    let output = run_in(&folder, &["check", "paper.tex"]);
    let text = out(&output);
    assert_eq!(text.matches("· given").count(), 2, "{text}");
    assert!(
        text.contains("`claim power` is derived here, and given by cradle.toml:1:19"),
        "{text}"
    );
    assert_eq!(
        err(&output),
        "note: cradle.toml:1:43: `given` names `9`, and no equation that was read is called so\n"
    );
}

#[test]
fn levels_are_as_the_author_wants_them_in_every_format() {
    let page = "<!-- check: symbols m: mass -->\n<!-- check: law -->\n$$ p = m v \\tag{1} $$\n\nBy (1),\n\n$$ v = \\frac{p}{m} \\tag{2} $$\n\n\
                <!-- check: derived; from nothing -->\n$$ 1 + 1 = 3 \\tag{3} $$\n";
    let folder = repository("severity", &[("page.md", page)]);
    let set = |text: &str| {
        std::fs::write(folder.join("cradle.toml"), format!("[severity]\n{text}")).unwrap()
    };
    let levels = |format: &str| out(&run_in(&folder, &["check", "page.md", "--format", format]));
    let exit = |args: &[&str]| code(&run_in(&folder, &[&["check", "page.md"], args].concat()));

    set("unstated-condition = \"error\"\nfails = \"note\"\n");
    let text = levels("short");
    assert!(
        text.contains("error[unstated-condition]") && text.contains("note[fails]"),
        "{text}"
    );
    let github = levels("github");
    assert!(
        github.contains("::error file=page.md,line=7")
            && github.contains("::notice file=page.md,line=10"),
        "{github}"
    );
    let sarif: Value = serde_json::from_str(&levels("sarif")).unwrap();
    let results = sarif["runs"][0]["results"].as_array().unwrap();
    let of: BTreeMap<&str, &str> = results
        .iter()
        .map(|r| (r["ruleId"].as_str().unwrap(), r["level"].as_str().unwrap()))
        .collect();
    assert_eq!((of["unstated-condition"], of["fails"]), ("error", "note"));
    let junit = levels("junit");
    assert!(
        junit.contains("failures=\"1\" errors=\"0\" skipped=\"1\""),
        "{junit}"
    );
    assert_eq!(exit(&["--fail-on", "error"]), 1);

    // A verdict is what it is, whatever it is called.
    set("unstated-condition = \"off\"\nfails = \"note\"\n");
    let human = out(&run_in(&folder, &["check", "page.md"]));
    assert!(
        human.contains("✗ fails") && human.contains("1 refuted"),
        "{human}"
    );
    assert!(
        human.contains("1 statement is wrong, which is a note here"),
        "{human}"
    );
    assert!(
        !human.contains("not stated") && !human.contains("Findings"),
        "{human}"
    );
    assert_eq!((exit(&[]), exit(&["--fail-on", "note"])), (0, 1));

    set("unstated-condition = \"off\"\nfails = \"off\"\n");
    assert_eq!(
        (exit(&["--fail-on", "note"]), levels("short")),
        (0, String::new())
    );

    // What is otherwise good to know is a finding where somebody wants that.
    let open =
        "<!-- check: derived; from nothing -->\n$$ \\int_0^1 \\sin x^2 \\, dx = q \\tag{1} $$\n";
    std::fs::write(folder.join("page.md"), open).unwrap();
    set("undecided = \"error\"\n");
    let human = out(&run_in(&folder, &["check", "page.md"]));
    assert!(
        human.contains("error[undecided]: equation (1) is undecided"),
        "{human}"
    );
    assert!(human.contains("1 finding needs mending"), "{human}");
    assert_eq!(exit(&["--fail-on", "error"]), 1);
}

#[test]
fn a_baseline_knows_what_is_told() {
    let folder = repository(
        "baseline",
        &[
            (
                "page.md",
                "<!-- check: derived; from nothing -->\n$$ 1 + 1 = 3 \\tag{1} $$\n",
            ),
            ("cradle.toml", ""),
        ],
    );
    let args = [
        "check",
        "page.md",
        "--baseline",
        "known.json",
        "--format",
        "short",
    ];
    let set = |level: &str| {
        std::fs::write(
            folder.join("cradle.toml"),
            format!("[severity]\nfails = \"{level}\"\n"),
        )
        .unwrap()
    };
    let update = || {
        err(&run_in(
            &folder,
            &[&args[..], &["--update-baseline"]].concat(),
        ))
    };
    set("off");
    assert!(update().contains("1 statement, 0 findings"));
    set("note");
    assert!(update().contains("1 statement, 0 findings"));
    set("off");
    let gone = run_in(&folder, &args);
    assert!(
        err(&gone).contains("gone     (1)  fails") && code(&gone) == 0,
        "{}",
        err(&gone)
    );
    assert!(update().contains("0 findings"));
    // A new note fails nothing, and a new error does.
    set("note");
    assert_eq!(code(&run_in(&folder, &args)), 0);
    set("error");
    assert_eq!(code(&run_in(&folder, &args)), 1);
    assert!(update().contains("1 statement, 1 finding"));
    assert_eq!(code(&run_in(&folder, &args)), 0);
}

#[test]
fn a_budget_only_leaves_undecided_what_was_refuted() {
    let config = |points: usize| {
        Config::read("cradle.toml", &format!("[budget]\npoints = {points}\n"))
            .unwrap()
            .beside
    };
    let mut left = 0;
    for (path, source) in examples() {
        let verdicts = |beside| {
            let derivation = read(&path, &source, beside);
            let entries = Audit::of(&derivation).entries.into_iter();
            entries
                .map(|entry| entry.verdict.word())
                .collect::<Vec<_>>()
        };
        let before = verdicts(None);
        for points in [1, 20] {
            for (own, usual) in verdicts(Some(config(points))).iter().zip(&before) {
                let less = (*own, *usual) == ("undecided", "fails");
                assert!(own == usual || less, "{path}: {own}, usually {usual}");
                left += usize::from(less);
            }
        }
    }
    assert!(left > 0, "the budget limits nothing");
}

#[test]
fn check_without_a_path_reads_the_files_that_are_listed() {
    let files = [
        (
            "cradle.toml",
            "files = [\"one.md\", \"parts/**/*.md\", \"more\"]\n",
        ),
        (
            "one.md",
            "<!-- check: derived; from nothing -->\n$$ 1 + 1 = 3 \\tag{1} $$\n",
        ),
        ("parts/a/b.md", "$$ x = 1 \\tag{2} $$\n"),
        ("parts/a/notes.txt", "no document"),
        ("more/c.md", "$$ y = 1 \\tag{3} $$\n"),
        ("other/d.md", "$$ z = 1 \\tag{4} $$\n"),
    ];
    let folder = repository("files", &files);
    let output = run_in(&folder, &["check"]);
    let text = out(&output);
    for path in ["one.md", "parts/a/b.md", "more/c.md"] {
        assert!(text.contains(path), "{text}");
    }
    assert!(!text.contains("d.md"), "{text}");
    // What is to be typed next works as it is printed.
    assert!(
        text.contains("`cradle-verify explain 1 --config cradle.toml`"),
        "{text}"
    );
    let explained = run_in(&folder, &["explain", "1", "--config", "cradle.toml"]);
    assert!(
        out(&explained).starts_with("Equation (1)  one.md"),
        "{}",
        out(&explained)
    );
    // From a folder below, too.
    assert!(out(&run_in(&folder.join("more"), &["check"])).contains("../one.md"));
    // The bare command is about the report that ships inside, whatever stands here, and so is `explain`.
    assert_eq!(run_in(&folder, &[]).stdout, run(&[]).stdout);
    assert_eq!(
        run_in(&folder, &["explain", "23"]).stdout,
        run(&["explain", "23"]).stdout
    );
}

#[test]
fn what_is_not_there_is_said_where_it_is_named() {
    let folder = repository(
        "missing",
        &[
            (
                "cradle.toml",
                "files = [\"a.md\", \"gone.md\", \"*.tex\"]\n",
            ),
            ("a.md", PAGE),
        ],
    );
    let output = run_in(&folder, &["check"]);
    assert_eq!((code(&output), out(&output).as_str()), (2, ""));
    let said = err(&output);
    assert!(
        said.contains("--> cradle.toml:1:19") && said.contains("--> cradle.toml:1:30"),
        "{said}"
    );
    for (config, reason) in [
        ("", "lists no `files`"),
        ("files = []", "lists no document"),
    ] {
        std::fs::write(folder.join("cradle.toml"), config).unwrap();
        let said = err(&run_in(&folder, &["check"]));
        assert!(said.contains(reason), "{said}");
    }
    std::fs::remove_file(folder.join("cradle.toml")).unwrap();
    for (args, reason) in [
        (&["check"][..], "no document is named"),
        (&["init"], "no document is named"),
        (&["check", "--stdin-filename", "x.md"], "which is not read"),
        (
            &["check", "a.md", "--config", "gone.toml"],
            "there is no configuration `gone.toml`",
        ),
        (&["--config", "cradle.toml"], "this reads none"),
        (&["simulate", "--no-config"], "this reads none"),
        (&["check", "--no-config"], "no document is named"),
    ] {
        let output = run_in(&folder, args);
        assert_eq!(code(&output), 2, "{args:?}");
        assert!(err(&output).contains(reason), "{args:?} {}", err(&output));
    }
}

#[test]
fn a_report_counts_what_its_configuration_calls_a_finding() {
    let source = "<!-- check: derived; from nothing -->\n$$ 1 + 1 = 3 \\tag{1} $$\n";
    let config = Config::read("cradle.toml", "[severity]\nfails = \"note\"\n").unwrap();
    for (beside, findings) in [(None, 1), (Some(config.beside), 0)] {
        let derivation = read("page.md", source, beside);
        let audit = Audit::of(&derivation);
        let report = Report {
            derivation: &derivation,
            audit: &audit,
            paths: &[],
        };
        assert_eq!(report.findings(), findings);
    }
}
