//! The pages of `docs/examples/`: a right one has nothing amiss and nothing left open, and the same page with one slip is
//! found wrong at the slip and nowhere else. The first line of a page with a slip names the equation, `slip: (4)`.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use cradle_verify::audit::{Audit, Verdict};
use cradle_verify::derivation::Derivation;
use cradle_verify::report::Report;

/// The examples in order, without the pages that other documentation is about.
fn pages() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/examples");
    let entries = std::fs::read_dir(folder).unwrap();
    let mut pages: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    pages.retain(|page| page.file_stem().unwrap() != "well");
    pages.sort();
    pages
}

fn read(page: &Path) -> (String, Derivation) {
    let source = std::fs::read_to_string(page).unwrap();
    let path = page.display().to_string();
    let derivation = match page.extension().unwrap().to_str() {
        Some("tex") => Derivation::from_latex(&path, &source),
        _ => Derivation::from_markdown(&path, &source),
    };
    (source, derivation)
}

/// The equation that the first line names.
fn slip(source: &str) -> Option<String> {
    let (_, rest) = source.lines().next()?.split_once("slip: ")?;
    let (name, _) = rest.split_once(')')?;
    Some(format!("{name})"))
}

/// The equations of which something is said.
fn found(derivation: &Derivation, audit: &Audit) -> BTreeSet<String> {
    let entries = audit.entries.iter();
    entries
        .filter(|entry| entry.verdict == Verdict::Undecided || entry.is_finding())
        .chain(audit.entries.iter().filter(|entry| !entry.notes.is_empty()))
        .map(|entry| derivation.equations[entry.equation].reference())
        .collect()
}

#[test]
fn right_pages_are_right_and_slips_are_found_where_they_are() {
    let mut slips = 0;
    for page in pages() {
        let (source, derivation) = read(&page);
        let audit = Audit::of(&derivation);
        let report = Report {
            derivation: &derivation,
            audit: &audit,
            paths: &[],
        };
        let expected: BTreeSet<String> = slip(&source).into_iter().collect();
        let page = page.display();
        assert_eq!(report.unread(), 0, "{page}");
        assert_eq!(found(&derivation, &audit), expected, "{page}");
        assert_eq!(report.findings(), expected.len(), "{page}");
        let wrong = audit.entries.iter().filter(|entry| entry.is_wrong());
        assert_eq!(wrong.count(), expected.len(), "{page}");
        let proved = audit.entries.iter();
        let proved = proved.filter(|entry| entry.verdict == Verdict::Holds);
        assert!(proved.count() >= 4, "{page} proves next to nothing");
        slips += expected.len();
    }
    assert!(slips >= 8, "the examples have lost their slips");
}

/// Two spellings of one page, the slip apart: one line differs.
#[test]
fn every_page_has_a_twin_with_one_line_changed() {
    let mut twins = 0;
    for page in pages() {
        let stem = page.file_stem().unwrap().to_str().unwrap();
        let Some(right) = stem.strip_suffix("-wrong") else {
            let ending = page.extension().unwrap().to_str().unwrap();
            let twin = page.with_file_name(format!("{stem}-wrong.{ending}"));
            assert!(twin.is_file(), "{} is missing", twin.display());
            continue;
        };
        let ending = page.extension().unwrap().to_str().unwrap();
        let right = page.with_file_name(format!("{right}.{ending}"));
        let [(right, _), (wrong, _)] = [read(&right), read(&page)];
        let body = wrong.split_once('\n').unwrap().1.trim_start();
        let changed = right.lines().zip(body.lines()).filter(|(a, b)| a != b);
        assert_eq!(changed.count(), 1, "{}", page.display());
        assert_eq!(right.lines().count(), body.lines().count());
        twins += 1;
    }
    assert!(twins >= 8, "the examples have lost their twins");
}
