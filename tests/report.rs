//! The whole output for the built-in report, as snapshots: a change of any verdict or word shows up here.

use cradle_verify::audit::Audit;
use cradle_verify::proofs;
use cradle_verify::report::Report;

#[test]
fn the_page_for_people() {
    let derivation = proofs::report();
    let audit = Audit::of(&derivation);
    let report = Report {
        derivation: &derivation,
        audit: &audit,
        paths: &[],
    };
    let text = anstream::adapter::strip_str(&report.human(false)).to_string();
    insta::assert_snapshot!("human", text);
}

#[test]
fn the_page_for_programs() {
    let derivation = proofs::report();
    let audit = Audit::of(&derivation);
    let report = Report {
        derivation: &derivation,
        audit: &audit,
        paths: &[],
    };
    let text = serde_json::to_string_pretty(&report.json()).unwrap();
    insta::assert_snapshot!("json", text);
}
