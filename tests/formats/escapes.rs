//! What stands in the way of a format is escaped in it, and places are told as programs want them.

use std::path::Path;

use cradle_verify::derivation::Derivation;
use cradle_verify::document::{Document, Position};
use cradle_verify::report::codes::Level;
use cradle_verify::report::remark::{Known, Remark, Subject};
use cradle_verify::report::{github, short};
use serde_json::json;

use crate::common;

/// A page with one thing to remark on.
fn page(path: &str) -> Derivation {
    let source = "<!-- check: derived -->\n$$ 1 + 1 = 3 $$\n";
    Derivation::new(vec![Document::markdown(path, source)])
}

/// A remark on the first line.
fn remark(path: &str, title: &str) -> Remark {
    let place = Position { line: 1, column: 1 };
    Remark {
        level: Level::Error,
        code: "fails",
        title: title.to_owned(),
        subject: Subject::Page(0, 0),
        page: 0,
        path: path.to_owned(),
        place: (place, place),
        saved: None,
        context: Vec::new(),
        said: Vec::new(),
        fix: None,
        fingerprint: String::new(),
        known: false,
    }
}

#[test]
fn nothing_leaves_its_line() {
    assert_eq!(
        short(&[remark("a.md", "a\r\nb\u{1b}[31m\u{202e}")]),
        "a.md:1:1: error[fails]: a  b\u{fffd}[31m\u{fffd}\n"
    );
}

#[test]
fn what_would_end_a_part_is_escaped_for_github() {
    let mut remark = remark("a,b::c%\n", "a::b,%");
    remark.said = vec![("help".to_owned(), "c".to_owned())];
    assert_eq!(
        github(&[remark]),
        "::error file=a%2Cb%3A%3Ac%25 ,line=1,endLine=1,col=1,endColumn=1,title=fails::a::b,%25%0Ahelp: c\n"
    );
}

#[test]
fn nothing_ends_an_attribute_or_a_text_for_junit() {
    let name = "a<b>&\"]]>\u{0}\u{1b}[0m\u{ffff}";
    let escaped = "a&lt;b&gt;&amp;&quot;]]&gt;[0m";
    let derivation = page("page.md");
    let text = common::reported(&derivation, |report| {
        report.junit(&[remark(name, name)], Some(Level::Error), Path::new("/"))
    });
    assert!(text.contains(&format!("message=\"{escaped}\"")), "{text}");
    assert!(text.contains(&format!(">{escaped}:1:1\n")), "{text}");
}

#[test]
fn paths_are_told_from_one_folder_and_are_uris_where_those_are_asked_for() {
    let here = Path::new("/home/me/report");
    for (path, relative, uri) in [
        ("./a/./b.md", "a/b.md", "a/b.md"),
        ("/home/me/report/a/b.md", "a/b.md", "a/b.md"),
        (
            "/elsewhere/b.md",
            "/elsewhere/b.md",
            "file:///elsewhere/b.md",
        ),
        ("../b.md", "../b.md", "../b.md"),
        ("standard input", "standard input", "standard%20input"),
        ("a b/ü%:.md", "a b/ü%:.md", "a%20b/%C3%BC%25%3A.md"),
    ] {
        let derivation = page(path);
        common::reported(&derivation, |report| {
            let remarks = report.remarks(here, &Known::new());
            assert_eq!(remarks[0].path, relative);
            let log = json!(report.sarif(&remarks, false));
            let place = "/runs/0/results/0/locations/0/physicalLocation/artifactLocation/uri";
            assert_eq!(log.pointer(place), Some(&json!(uri)));
        });
    }
}
