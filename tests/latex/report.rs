//! The report on Newton's cradle as its author might have set it, against the built-in pages.

use std::path::Path;

use cradle_verify::audit::Audit;
use cradle_verify::derivation::Derivation;
use cradle_verify::document::{Document, Library};
use cradle_verify::proofs;

struct Disk;

impl Library for Disk {
    fn open(&self, path: &str) -> Option<Vec<u8>> {
        std::fs::read(path).ok()
    }
}

fn typeset() -> Derivation {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/documents/report/main.tex");
    let source = std::fs::read_to_string(&path).unwrap();
    Derivation::new(Document::latex(path.display().to_string(), source, &Disk))
}

/// Number or name, verdict and notes of every statement.
fn verdicts(derivation: &Derivation) -> Vec<String> {
    let audit = Audit::of(derivation);
    let shown = audit.entries.iter().map(|entry| {
        let equation = &derivation.equations[entry.equation];
        let notes: Vec<&str> = entry.notes.iter().map(|note| note.code()).collect();
        let label = equation.label().unwrap_or("-");
        format!("{label} {} {}", entry.verdict.word(), notes.join(" "))
    });
    shown.collect()
}

#[test]
fn the_report_in_latex_has_the_verdicts_of_the_built_in_pages() {
    let typeset = verdicts(&typeset());
    let pages = verdicts(&proofs::report());
    assert!(pages.len() > 100);
    for (ours, theirs) in typeset.iter().zip(&pages) {
        assert_eq!(ours, theirs);
    }
    assert_eq!(typeset.len(), pages.len());
}

#[test]
fn every_equation_of_the_report_is_found_where_its_author_wrote_it() {
    let derivation = typeset();
    for equation in &derivation.equations {
        let document = &derivation.pages[equation.page].document;
        let (file, span) = document.written_at(equation.body);
        let written = &file.source[span.range()];
        // A macro's own text is not at its use: what is shown is what was written there.
        assert!(!written.contains("\\newcommand"), "{written}");
        let (path, place) = document.place(equation.body);
        let line = std::fs::read_to_string(path).unwrap();
        let line = line.lines().nth(place.line - 1).unwrap();
        let column: String = line.chars().skip(place.column - 1).collect();
        let first = written.lines().next().unwrap();
        assert!(
            column.starts_with(first),
            "{path}:{}:{}",
            place.line,
            place.column
        );
    }
}

#[test]
fn the_report_in_latex_has_nothing_that_cannot_be_read() {
    let derivation = typeset();
    assert_eq!(super::problems(&derivation), Vec::<String>::new());
    let unread = derivation
        .equations
        .iter()
        .filter(|e| e.statements.is_err());
    assert_eq!(unread.count(), 0);
}
