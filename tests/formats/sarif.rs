//! SARIF: as its schema says, with fingerprints that stay.

use std::collections::BTreeSet;
use std::path::Path;

use serde_json::{Value, json};

use super::schema::faults;
use super::{code, err, hostile, json as read, out, run, run_in, well};
use crate::common::pages_of_each_kind;

fn schema() -> Value {
    serde_json::from_str(include_str!("../schemas/sarif-2.1.0.json")).unwrap()
}

pub(super) fn sarif(folder: &Path, args: &[&str]) -> Value {
    let output = run_in(folder, &[args, &["--format", "sarif"]].concat());
    assert!(code(&output) <= 1, "{}", err(&output));
    read(&output)
}

pub(super) fn results(log: &Value) -> Vec<Value> {
    log["runs"][0]["results"].as_array().unwrap().clone()
}

fn fingerprints(log: &Value) -> BTreeSet<String> {
    let key = "/partialFingerprints/cradleVerify~1v2";
    let all = results(log);
    let set: BTreeSet<String> = all
        .iter()
        .map(|r| r.pointer(key).unwrap().as_str().unwrap().to_owned())
        .collect();
    assert_eq!(set.len(), all.len(), "two results are one");
    set
}

#[test]
fn every_log_is_as_the_schema_says() {
    let schema = schema();
    let folder = hostile("hostile-sarif");
    std::fs::write(folder.join("empty.md"), "").unwrap();
    let root = super::root();
    let pages = pages_of_each_kind();
    let paths = pages.iter().map(|page| page.path.as_str());
    let pages: Vec<&str> = ["check"].into_iter().chain(paths).collect();
    for (place, args) in [
        (root, &[][..]),
        (root, &["check", "docs/examples/well.md"]),
        (root, &pages[..]),
        (&folder, &["check", "."]),
        (&folder, &["check", "empty.md"]),
    ] {
        let log = sarif(place, args);
        assert_eq!(faults(&log, &schema), Vec::<String>::new(), "{args:?}");
        for result in results(&log) {
            let index = result["ruleIndex"].as_u64().unwrap();
            let rule = &log["runs"][0]["tool"]["driver"]["rules"][index as usize];
            assert_eq!(rule["id"], result["ruleId"]);
            assert_eq!(rule["defaultConfiguration"]["level"], result["level"]);
            let place = &result["locations"][0]["physicalLocation"];
            let uri = place["artifactLocation"]["uri"].as_str().unwrap();
            assert!(
                !uri.starts_with('/') && !uri.contains('\\') && !uri.contains(' '),
                "{uri}"
            );
            let at = |name: &str| place["region"][name].as_u64().unwrap();
            let (start, end) = (
                (at("startLine"), at("startColumn")),
                (at("endLine"), at("endColumn")),
            );
            assert!(start.0 >= 1 && start.1 >= 1 && start <= end, "{place}");
        }
    }
}

#[test]
fn the_schema_is_not_met_by_anything() {
    let schema = schema();
    let log = sarif(super::root(), &["check", "docs/examples/well.md"]);
    for (pointer, wrong) in [
        ("/version", json!("2.0.0")),
        ("/runs/0/columnKind", json!("bytes")),
        ("/runs/0/results/0/level", json!("fatal")),
        ("/runs/0/results/0/message", json!({})),
        ("/runs/0/results/0/ruleIndex", json!(-2)),
        (
            "/runs/0/results/0/locations/0/physicalLocation/region/startLine",
            json!(0),
        ),
        (
            "/runs/0/results/0/locations/0/physicalLocation/artifactLocation/uri",
            json!("a b"),
        ),
        ("/runs/0/results/0/partialFingerprints", json!({ "a": 1 })),
        ("/runs/0/tool", json!({})),
    ] {
        let mut log = log.clone();
        *log.pointer_mut(pointer).expect(pointer) = wrong;
        assert!(!faults(&log, &schema).is_empty(), "{pointer}");
    }
}

#[test]
fn the_result_of_the_example() {
    let log = sarif(super::root(), &["check", "docs/examples/well.md"]);
    let text = serde_json::to_string_pretty(&log["runs"][0]["results"]).unwrap();
    insta::assert_snapshot!("sarif", text);
    let result = &results(&log)[0];
    assert_eq!(log["runs"][0]["columnKind"], "unicodeCodePoints");
    assert_eq!(result["properties"]["counterexample"]["v"], "1");
}

#[test]
fn fingerprints_stay_where_lines_move_and_go_where_the_formula_does() {
    let (folder, text) = well("fingerprints");
    let page = folder.join("well.md");
    let before = fingerprints(&sarif(&folder, &["check", "well.md"]));
    // Three paragraphs further down, other white space, another way to type the same.
    let moved = format!("Some words.\n\n\nMore.\n\n{text}").replace(r"\frac{v}{3}", r"  \frac v 3");
    std::fs::write(&page, moved).unwrap();
    assert_eq!(fingerprints(&sarif(&folder, &["check", "well.md"])), before);
    std::fs::rename(&page, folder.join("other.md")).unwrap();
    assert_eq!(
        fingerprints(&sarif(&folder, &["check", "other.md"])),
        before
    );
    std::fs::write(&page, text.replace(r"\frac{v}{3}", r"\frac{v}{4}")).unwrap();
    assert!(fingerprints(&sarif(&folder, &["check", "well.md"])).is_disjoint(&before));
}

#[test]
fn paths_are_told_from_where_the_program_was_started() {
    let (folder, _) = well("paths");
    let whole = folder.join("well.md");
    let relative = sarif(&folder, &["check", "./well.md"]);
    let absolute = sarif(&folder, &["check", whole.to_str().unwrap()]);
    let uri = "/locations/0/physicalLocation/artifactLocation/uri";
    for log in [relative, absolute] {
        assert_eq!(results(&log)[0].pointer(uri), Some(&json!("well.md")));
    }
}

#[test]
fn rules_say_what_the_reference_says() {
    let log = read(&run(&["--format", "sarif"]));
    let rules = log["runs"][0]["tool"]["driver"]["rules"]
        .as_array()
        .unwrap()
        .clone();
    assert!(rules.len() > 10);
    for rule in rules {
        let id = rule["id"].as_str().unwrap();
        let explained = out(&run(&["explain", id]));
        let help = rule["help"]["text"].as_str().unwrap();
        assert!(explained.ends_with(&format!("\n\n{help}\n")), "{id}");
        assert!(
            rule["fullDescription"]["text"].as_str().unwrap().len() > 20,
            "{id}"
        );
    }
}

#[test]
fn what_a_baseline_knows_is_unchanged() {
    let (folder, text) = well("sarif-baseline");
    let args = ["check", "well.md", "--baseline", "b.json"];
    run_in(&folder, &[&args[..], &["--update-baseline"]].concat());
    let slip = text.replace(r"\frac{v^2}{2 g}", r"\frac{v^2}{5 g}");
    std::fs::write(folder.join("well.md"), slip).unwrap();
    let log = sarif(&folder, &args);
    assert_eq!(faults(&log, &schema()), Vec::<String>::new());
    let all = results(&log);
    let states: Vec<&str> = all
        .iter()
        .map(|r| r["baselineState"].as_str().unwrap())
        .collect();
    assert_eq!(states, ["new", "unchanged"]);
}
