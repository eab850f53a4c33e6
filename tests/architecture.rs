//! The rules of ARCHITECTURE.md that a reader of the sources can check, checked.

use std::path::{Path, PathBuf};

/// What all may name.
const COMMON: &str = "sorted";
/// Modules, and what else of the crate each may name.
const MAY_USE: &[(&str, &[&str])] = &[
    (COMMON, &[]),
    ("parallel", &[]),
    ("algebra", &[]),
    ("kernel", &["algebra"]),
    ("interval", &["algebra"]),
    ("document", &["algebra", "notation"]),
    ("notation", &["algebra", "interval", "document"]),
    ("dimension", &["algebra", "kernel"]),
    (
        "derivation",
        &[
            "algebra",
            "dimension",
            "document",
            "kernel",
            "notation",
            "parallel",
        ],
    ),
    ("search", &["algebra", "kernel"]),
    ("sampling", &["algebra"]),
    ("cradle", &[]),
    (
        "figures",
        &["algebra", "audit", "derivation", "notation", "parallel"],
    ),
    ("config", &["derivation", "document", "notation", "report"]),
];

/// The modules that are exact.
const EXACT: &[&str] = &[
    COMMON,
    "parallel",
    "algebra",
    "kernel",
    "document",
    "notation",
    "derivation",
    "dimension",
    "search",
    "interval",
    "audit",
];

/// Libraries, and the only modules that may know them.
const KNOWN_TO: &[(&str, &[&str])] = &[
    ("serde", &["sorted", "report", "cli"]),
    ("serde_json", &["document", "report", "cli"]),
    ("anstyle", &["report", "cli"]),
    ("anstream", &["cli"]),
    ("annotate_snippets", &["report"]),
    ("clap", &["cli"]),
    ("clap_complete", &["cli"]),
    ("clap_mangen", &["cli"]),
    ("nalgebra", &["cradle", "cli"]),
    ("pulldown_cmark", &["document", "report"]),
    ("toml", &["config"]),
    ("tiny_skia", &["figures"]),
    ("ttf_parser", &["figures"]),
    ("miniz_oxide", &["figures"]),
    ("crc32fast", &["figures"]),
    ("mimalloc", &["memory"]),
];

/// A line of code, without its comment.
struct Line {
    place: String,
    module: String,
    code: String,
}

fn files(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        match path.is_dir() {
            true => files(&path, found),
            false => found.push(path),
        }
    }
}

fn lines() -> Vec<Line> {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut all = Vec::new();
    files(&source, &mut all);
    all.sort();
    let mut lines = Vec::new();
    for path in all
        .iter()
        .filter(|p| p.extension().is_some_and(|e| e == "rs"))
    {
        let own = path.strip_prefix(&source).unwrap();
        let packages = ["exact", "engine"].iter();
        let within = packages
            .filter_map(|package| own.strip_prefix(package).ok())
            .next();
        let within = within.unwrap_or(own);
        let first = within.components().next().unwrap().as_os_str();
        // The handle on a derivation stands at the end of the pipeline, though in this folder.
        let module = match within.starts_with("derivation/checker") {
            true => "checker".to_owned(),
            false => first.to_str().unwrap().trim_end_matches(".rs").to_owned(),
        };
        for (at, text) in std::fs::read_to_string(path).unwrap().lines().enumerate() {
            let code = match text.trim_start().starts_with("//") {
                true => "",
                false => text,
            };
            lines.push(Line {
                place: format!("src/{}:{}", own.display(), at + 1),
                module: module.clone(),
                code: code.to_owned(),
            });
        }
    }
    assert!(lines.len() > 5_000, "the sources were not found");
    lines
}

/// The words of a line: what a path is made of.
fn words(code: &str) -> impl Iterator<Item = &str> {
    code.split(|c: char| !c.is_alphanumeric() && c != '_')
}

/// The modules of this crate that a line names by `crate::…`.
fn named(code: &str) -> Vec<&str> {
    let after = code.split("crate::").skip(1);
    after.filter_map(|rest| words(rest).next()).collect()
}

#[test]
fn modules_name_only_what_they_may() {
    let lines = lines();
    for (module, allowed) in MAY_USE {
        let own: Vec<&Line> = lines.iter().filter(|l| l.module == *module).collect();
        assert!(!own.is_empty(), "there is no module `{module}`");
        for line in own {
            for other in named(&line.code) {
                assert!(
                    [*module, COMMON].contains(&other) || allowed.contains(&other),
                    "{}: `{module}` names `{other}`",
                    line.place
                );
            }
            // `use crate::{…}` over several modules would hide what it names.
            assert!(
                !line.code.contains("crate::{"),
                "{}: import each module by itself",
                line.place
            );
        }
    }
}

#[test]
fn only_the_end_of_the_pipeline_knows_the_search() {
    let lines = lines();
    let knows = lines.iter().filter(|l| named(&l.code).contains(&"search"));
    for line in knows {
        assert!(
            ["search", "audit", "checker", "report", "cli"].contains(&line.module.as_str()),
            "{}",
            line.place
        );
    }
}

#[test]
fn each_library_is_known_where_it_belongs() {
    for line in lines() {
        for (library, modules) in KNOWN_TO {
            let path = format!("{library}::");
            let named = line.code.contains(&path) && words(&line.code).any(|word| word == *library);
            assert!(
                !named || modules.contains(&line.module.as_str()),
                "{}: `{library}` belongs to {modules:?}",
                line.place
            );
        }
    }
}

#[test]
fn exact_modules_have_no_floating_point() {
    let lines = lines();
    // In the cradle only contacts that take time are numeric; `sampling` says what is worth asking the kernel, and nothing else.
    let numeric = ["src/cradle/contact/", "src/cradle/ode.rs"];
    let exact = |line: &&Line| {
        EXACT.contains(&line.module.as_str())
            || line.module == "cradle" && !numeric.iter().any(|own| line.place.starts_with(own))
    };
    for line in lines.iter().filter(exact) {
        let float = words(&line.code).find(|word| {
            ["f32", "f64"].contains(word) || word.ends_with("_f32") || word.ends_with("_f64")
        });
        assert_eq!(float, None, "{}", line.place);
    }
}

/// Floating point tells in one place alone what is tried first: no verdict rests on it.
#[test]
fn only_the_search_for_slips_knows_of_sampling() {
    for line in lines() {
        if words(&line.code).any(|word| word == "sampling") {
            let may = ["src/engine/audit/slip/samples.rs", "src/engine/lib.rs"];
            let is_there = may.iter().any(|own| line.place.starts_with(own));
            assert!(is_there, "{}", line.place);
        }
    }
}

#[test]
fn nothing_is_unsafe() {
    for line in lines() {
        let word = words(&line.code).find(|word| *word == "unsafe");
        assert_eq!(word, None, "{}", line.place);
    }
}

#[test]
fn no_test_stands_where_none_is_run() {
    // The crate is not compiled a second time for tests (`[lib] test = false`), so one in it would never run.
    for line in lines() {
        for attribute in ["#[test]", "cfg(test", "proptest!"] {
            let is_there = line.code.contains(attribute);
            assert!(!is_there, "{}: tests are in `tests/`", line.place);
        }
    }
}

#[test]
fn every_file_of_tests_is_named_in_the_one_above_it() {
    let tests = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests");
    let mut all = Vec::new();
    files(&tests, &mut all);
    let sources = all
        .iter()
        .filter(|p| p.extension().is_some_and(|e| e == "rs"));
    for path in sources.filter(|path| !path.ends_with("all.rs")) {
        let (folder, name) = match path.ends_with("mod.rs") {
            true => (
                path.parent().unwrap().parent().unwrap(),
                path.parent().unwrap(),
            ),
            false => (path.parent().unwrap(), path.as_path()),
        };
        let above = [
            folder.join("all.rs"),
            folder.join("mod.rs"),
            folder.with_extension("rs"),
        ];
        let above = above
            .iter()
            .find(|above| above.exists())
            .expect("a file above");
        let named = format!("mod {};", name.file_stem().unwrap().to_str().unwrap());
        let text = std::fs::read_to_string(above).unwrap();
        let is_named = text.lines().any(|line| line == named);
        assert!(is_named, "{} lacks `{named}`", above.display());
    }
}

#[test]
fn the_kernel_reads_no_file_and_prints_nothing() {
    for line in lines().iter().filter(|l| l.module == "kernel") {
        for word in [
            "std::fs",
            "std::io",
            "std::env",
            "println!",
            "print!",
            "eprintln!",
        ] {
            assert!(!line.code.contains(word), "{}: {word}", line.place);
        }
    }
}

#[test]
fn the_code_map_knows_each_module_and_no_file_that_is_gone() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let map = std::fs::read_to_string(root.join("ARCHITECTURE.md")).unwrap();
    let map = map.split("## Code map").nth(1).expect("a code map");
    let map = map.split("\n## ").next().unwrap();
    let lines = lines();
    let modules: std::collections::BTreeSet<&str> =
        lines.iter().map(|l| l.module.as_str()).collect();
    for module in modules
        .iter()
        .filter(|m| !["lib", "main", "checker"].contains(m))
    {
        let known =
            ["src", "src/exact", "src/engine"].map(|folder| format!("### `{folder}/{module}"));
        assert!(
            known.iter().any(|heading| map.contains(heading)),
            "ARCHITECTURE.md does not know `{module}`"
        );
    }
    // `name.rs` in the section of a folder is a file of that folder.
    let mut folder = String::new();
    for line in map.lines() {
        if let Some(heading) = line.strip_prefix("### `") {
            folder = heading.split('`').next().unwrap().to_owned();
            assert!(root.join(&folder).exists(), "{folder} is gone");
        } else if let Some(row) = line.strip_prefix("| `") {
            let name = row.split('`').next().unwrap();
            let path = root.join(&folder).join(name);
            assert!(path.exists(), "{folder}{name} is gone");
        }
    }
}

#[test]
fn each_note_has_an_entry_in_the_reference_and_the_other_way_round() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let source = std::fs::read_to_string(root.join("src/engine/audit/entry.rs")).unwrap();
    let codes = source.split("fn code(").nth(1).expect("Note::code");
    let codes = codes.split("\n    }\n").next().unwrap();
    let mut codes: std::collections::BTreeSet<&str> = codes.split('"').skip(1).step_by(2).collect();
    codes.extend(cradle_verify::audit::Verdict::ALL.map(cradle_verify::audit::Verdict::word));
    // The one code of what is no statement.
    codes.insert("clashing-declaration");
    let page = std::fs::read_to_string(root.join("docs/notes.md")).unwrap();
    let entries = page.lines().filter_map(|line| line.strip_prefix("## `"));
    let entries: std::collections::BTreeSet<&str> =
        entries.map(|line| line.trim_end_matches('`')).collect();
    assert_eq!(codes, entries);
    let known = cradle_verify::report::codes::CODES.iter();
    assert_eq!(
        known
            .map(|(code, _)| *code)
            .collect::<std::collections::BTreeSet<_>>(),
        entries
    );
}
