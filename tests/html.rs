//! The page for a browser: whole, well-formed, and harmless whatever is in the documents.

mod browser;
mod contrast;
mod formulas;
mod hash;
mod hostile;
mod latex;
mod structure;
mod typeset;

use crate::common;
use std::sync::LazyLock;

use hostile::{HOSTILE_PAGES, hostile_names};

use cradle_verify::audit::Audit;
use cradle_verify::derivation::Derivation;
use cradle_verify::document::Document;
use cradle_verify::proofs;
use cradle_verify::report::Report;
use cradle_verify::report::html::Pictures;

/// The page of some documents, each a path and a text.
fn page_of(documents: &[(&str, &str)]) -> String {
    let read = |(path, source): &(&str, &str)| Document::markdown(*path, *source);
    page(&Derivation::new(documents.iter().map(read).collect()))
}

fn page(derivation: &Derivation) -> String {
    common::reported(derivation, |report| report.html(&Pictures::default()))
}

/// The page of the report that ships inside, as the program writes it.
fn written() -> String {
    let done = common::run(&["report"]);
    assert_eq!(common::code(&done), 1, "the report has findings");
    common::out(&done)
}

/// The same, written once for all tests that look at it.
fn built_in() -> &'static str {
    static PAGE: LazyLock<String> = LazyLock::new(written);
    &PAGE
}

/// Equations that hold, each with a number and with mathematics in the text before it.
fn thousands(count: usize) -> String {
    let one = |at: usize| {
        format!(
            "By algebra, for $x_{{{at}}}$,\n\n$$ (x + {at})^2 = x^2 + {} x + {} \\tag{{{at}}} $$\n\n",
            2 * at,
            at * at
        )
    };
    (1..=count).map(one).collect()
}

/// The page as XML, which it is without its first line.
fn tree(page: &str) -> roxmltree::Document<'_> {
    let body = page.strip_prefix("<!DOCTYPE html>\n").unwrap();
    roxmltree::Document::parse(body).unwrap_or_else(|error| panic!("{error}"))
}

fn has_class(node: &roxmltree::Node<'_, '_>, class: &str) -> bool {
    let own = node.attribute("class").unwrap_or("");
    own.split_whitespace().any(|own| own == class)
}

/// The text of an element and of all that is in it.
fn text_of(node: roxmltree::Node<'_, '_>) -> String {
    node.descendants()
        .filter(|n| n.is_text())
        .filter_map(|n| n.text())
        .collect()
}

#[test]
fn the_same_input_gives_the_same_bytes() {
    assert_eq!(built_in(), written());
    let derivation = proofs::report();
    let alone = Audit::by(&derivation, 1, &Default::default());
    let report = |audit| Report {
        derivation: &derivation,
        audit,
        paths: &[],
    };
    let several = Audit::by(&derivation, 4, &Default::default());
    let none = Pictures::default();
    assert_eq!(report(&alone).html(&none), report(&several).html(&none));
}
