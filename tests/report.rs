//! What is said of an audit: the whole output for the built-in report, as snapshots, so that a change of any verdict or word shows up
//! here; and how single things are told.

mod algebraic;
mod borrowed;
mod convincing;
mod families;
mod induction;
mod numeric;
mod partial;
mod shared;
mod shifted;
mod wording;

use cradle_verify::proofs;

use crate::common;

#[test]
fn the_page_for_people() {
    let derivation = proofs::report();
    let text = common::human(&derivation);
    insta::assert_snapshot!("human", text);
}

#[test]
fn the_page_for_programs() {
    let derivation = proofs::report();
    let text = common::reported(&derivation, |report| {
        serde_json::to_string_pretty(&report.json()).unwrap()
    });
    insta::assert_snapshot!("json", text);
}

#[test]
fn every_page_of_the_directories_is_embedded_in_order() {
    for (folder, pages) in [
        ("proofs/report", proofs::PAGES),
        ("proofs/corrected", proofs::corrected::PAGES),
    ] {
        let own = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
        let mut names: Vec<String> = std::fs::read_dir(own)
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .filter(|name| name.ends_with(".md"))
            .map(|name| format!("{folder}/{name}"))
            .collect();
        names.sort();
        let embedded: Vec<&str> = pages.iter().map(|page| page.0).collect();
        assert_eq!(embedded, names);
    }
}
