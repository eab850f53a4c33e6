//! LaTeX documents, read end to end: numbers as printed, macros, files, places, and what is refused.

mod files;
mod hostile;
mod macros;
mod numbers;
mod report;

use std::collections::BTreeMap;

use cradle_verify::derivation::Derivation;
use cradle_verify::document::{Document, Library};
use cradle_verify::notation::latex_statement;

/// Files in memory.
#[derive(Default)]
struct Files(BTreeMap<&'static str, Vec<u8>>);

impl Files {
    fn of(files: &[(&'static str, &str)]) -> Files {
        Files(
            files
                .iter()
                .map(|&(path, text)| (path, text.into()))
                .collect(),
        )
    }
}

impl Library for Files {
    fn open(&self, path: &str) -> Option<Vec<u8>> {
        self.0.get(path).cloned()
    }
}

/// A document of its body alone, with the packages that everybody uses.
fn article(body: &str) -> String {
    format!(
        "\\documentclass{{article}}\n\\usepackage{{amsmath}}\n\\begin{{document}}\n{body}\n\\end{{document}}\n"
    )
}

fn read(source: &str) -> Derivation {
    Derivation::from_latex("paper.tex", source)
}

/// Each equation as `number: what was understood`, or the message where it could not be read.
fn equations(derivation: &Derivation) -> Vec<String> {
    let shown = derivation.equations.iter().map(|equation| {
        let said = match &equation.statements {
            Ok(statements) => {
                let all: Vec<String> = statements.iter().map(latex_statement).collect();
                all.join(" | ")
            }
            Err(error) => format!("unreadable: {}", error.message),
        };
        format!("{}: {said}", equation.tag.as_deref().unwrap_or("-"))
    });
    shown.collect()
}

/// The numbers of the equations from which one follows, as `premises` finds them.
fn premises(derivation: &Derivation, number: &str) -> Vec<String> {
    let at = derivation
        .equations
        .iter()
        .position(|e| e.tag.as_deref() == Some(number));
    let (found, _, unknown) = derivation.premises(at.expect("there is such an equation"));
    let known = found
        .iter()
        .map(|&p| derivation.equations[p].tag.clone().unwrap_or_default());
    known
        .chain(unknown.iter().map(|u| format!("unknown {}", u.label)))
        .collect()
}

/// The problems of all pages: message, path and line.
fn problems(derivation: &Derivation) -> Vec<String> {
    let pages = derivation.pages.iter();
    let all = pages.flat_map(|page| page.problems.iter().map(move |problem| (page, problem)));
    let shown = all.map(|(page, problem)| {
        let (path, place) = page.document.place(problem.span);
        format!("{path}:{}: {}", place.line, problem.message)
    });
    shown.collect()
}

/// The document of some files, the first of which is asked for.
fn document_of(files: &[(&'static str, &str)]) -> Vec<Document> {
    Document::latex(files[0].0, files[0].1, &Files::of(files))
}
