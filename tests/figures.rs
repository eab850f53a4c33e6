//! Figures: the numbers in them against the cradle as code and against formulas, the files against their formats, the
//! commands from outside.

mod numbers;
mod program;
mod writers;

use cradle_verify::derivation::{Checker, Derivation};
use cradle_verify::document::Document;
use cradle_verify::proofs;

/// The report with one text replaced on one page.
fn report_with(page: &str, printed: &str, instead: &str) -> Checker {
    let mut changed = 0;
    let documents = proofs::PAGES.iter().map(|&(path, source)| {
        let source = match path.contains(page) {
            true => {
                changed += source.matches(printed).count();
                source.replace(printed, instead)
            }
            false => source.to_owned(),
        };
        Document::markdown(path, source)
    });
    let derivation = Derivation::new(documents.collect());
    assert_eq!(changed, 1, "`{printed}` is not there once");
    Checker::new(derivation)
}
