//! The report that ships inside the program: what the bare command audits.

use crate::derivation::Derivation;
use crate::document::Document;

/// The pages in reading order: the path of each, and its text.
pub const PAGES: &[(&str, &str)] = &[
    (
        "proofs/report/1.2-conservation-laws.md",
        include_str!("../proofs/report/1.2-conservation-laws.md"),
    ),
    (
        "proofs/report/1.3-scenarios.md",
        include_str!("../proofs/report/1.3-scenarios.md"),
    ),
    (
        "proofs/report/1.4-n-balls-in-n-balls-out.md",
        include_str!("../proofs/report/1.4-n-balls-in-n-balls-out.md"),
    ),
    (
        "proofs/report/2.1-restitution.md",
        include_str!("../proofs/report/2.1-restitution.md"),
    ),
    (
        "proofs/report/2.2-hertz-contact.md",
        include_str!("../proofs/report/2.2-hertz-contact.md"),
    ),
    (
        "proofs/report/2.3-heat.md",
        include_str!("../proofs/report/2.3-heat.md"),
    ),
    (
        "proofs/report/2.4-sound.md",
        include_str!("../proofs/report/2.4-sound.md"),
    ),
    (
        "proofs/report/2.5-energy-balance.md",
        include_str!("../proofs/report/2.5-energy-balance.md"),
    ),
    (
        "proofs/report/3.1-unequal-masses.md",
        include_str!("../proofs/report/3.1-unequal-masses.md"),
    ),
    (
        "proofs/report/3.5-mass-ratio.md",
        include_str!("../proofs/report/3.5-mass-ratio.md"),
    ),
    (
        "proofs/report/3.6-efficiency.md",
        include_str!("../proofs/report/3.6-efficiency.md"),
    ),
    (
        "proofs/report/3.7-maximum.md",
        include_str!("../proofs/report/3.7-maximum.md"),
    ),
    (
        "proofs/report/4.2-energy-decay.md",
        include_str!("../proofs/report/4.2-energy-decay.md"),
    ),
];

/// The whole report, read as one derivation.
pub fn report() -> Derivation {
    let pages = PAGES.iter();
    Derivation::new(
        pages
            .map(|&(path, source)| Document::markdown(path, source))
            .collect(),
    )
}

/// One page's text, by its path.
pub fn page(path: &str) -> Option<&'static str> {
    PAGES
        .iter()
        .find(|(own, _)| *own == path)
        .map(|&(_, source)| source)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_page_of_the_directory_is_embedded_in_order() {
        let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("proofs/report");
        let mut names: Vec<String> = std::fs::read_dir(folder)
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .filter(|name| name.ends_with(".md"))
            .map(|name| format!("proofs/report/{name}"))
            .collect();
        names.sort();
        let embedded: Vec<&str> = PAGES.iter().map(|page| page.0).collect();
        assert_eq!(embedded, names);
    }
}
