//! Counterexamples for every number at once.

use cradle_verify::algebra::{Expr, Symbol};
use cradle_verify::audit::{Audit, Counterexamples, counterexamples};
use cradle_verify::derivation::Derivation;
use cradle_verify::notation::latex;
use cradle_verify::proofs;

use crate::common;

const PAGE: &str = include_str!("../pages/families.md");

/// What is found of an equation, by its number or name: of the first of its links that is refuted.
fn family(derivation: &Derivation, label: &str) -> Option<Counterexamples> {
    let audit = Audit::of(derivation);
    let at = derivation
        .equations
        .iter()
        .position(|e| e.label() == Some(label));
    let entry = &audit.of_equation(at.unwrap())[0];
    let (judged, _) = entry.refuted()?;
    counterexamples(derivation, entry.equation, judged)
}

fn page() -> Derivation {
    Derivation::from_markdown("families.md", PAGE)
}

/// The elements of a sequence: how many are alike, and what they are.
fn elements(found: &Counterexamples, sequence: &str) -> Vec<String> {
    let groups = found.fails.family().groups.iter();
    let sequence = Symbol::new(sequence);
    groups
        .map(|g| format!("{}: {}", latex(&g.size), latex(&g.elements[&sequence])))
        .collect()
}

fn value(found: &Counterexamples, symbol: &str) -> String {
    let term: &Expr = &found.fails.family().symbols[&Symbol::new(symbol)];
    latex(term)
}

#[test]
fn more_balls_leave_than_came_in_for_every_number_of_them() {
    let derivation = proofs::report();
    let text = common::reported(&derivation, |report| {
        let at = derivation
            .equations
            .iter()
            .position(|e| e.tag.as_deref() == Some("23"));
        report.explain(at.unwrap())
    });
    insta::assert_snapshot!("explain_23", text);
}

#[test]
fn what_is_given_and_not_cited_is_true_for_all_of_them() {
    let derivation = proofs::report();
    let found = family(&derivation, "23").unwrap();
    let tags = found
        .besides
        .iter()
        .map(|&at| derivation.equations[at].tag.as_deref());
    // (17) and (18) each write their sum twice, and that both ways are the same is no news.
    assert!(tags.eq([Some("17"), Some("18")]));
    let cited = family(&derivation, "n-in-n-out").unwrap();
    assert_eq!(cited.fails.family(), found.fails.family());
    assert!(cited.besides.is_empty());
}

#[test]
fn one_element_makes_up_for_all_others() {
    let found = family(&page(), "2").unwrap();
    assert_eq!(elements(&found, "x"), ["1: 1 - k", "k - 1: 1"]);
    assert_eq!(found.fails.family().least, 2);
    let first = &found.fails.first().witness().sequences[&Symbol::new("x")];
    assert_eq!(first.len(), 2);
}

#[test]
fn two_elements_stand_by_themselves_where_one_is_not_enough() {
    let found = family(&page(), "4").unwrap();
    assert_eq!(elements(&found, "x"), ["1: -1", "k - 2: 0", "1: 1"]);
}

#[test]
fn what_is_no_count_stays_free() {
    let found = family(&page(), "8").unwrap();
    assert_eq!(
        elements(&found, "u"),
        [r"1: \frac{2 - k}{k} v_0", r"k - 1: \frac{2}{k} v_0"]
    );
    assert_eq!(found.fails.family().least, 3);
    assert!(
        !found
            .fails
            .family()
            .symbols
            .contains_key(&Symbol::new("v_0"))
    );
}

#[test]
fn totals_are_told_by_what_they_are_totals_of() {
    let found = family(&page(), "12").unwrap();
    assert_eq!(value(&found, "M"), "k");
    assert_eq!(value(&found, "P"), "k + 1");
}

#[test]
fn there_is_none_for_few_elements_or_what_holds() {
    assert!(family(&page(), "14").is_none());
    assert!(family(&page(), "7").is_none());
    let text = common::reported(&page(), |report| report.explain(13));
    assert!(text.contains("Counterexample\n"), "{text}");
    assert!(!text.contains("Counterexample for"), "{text}");
}

#[test]
fn there_is_none_where_the_elements_would_be_irrational() {
    let page = "<!-- check: symbols k: natural -->\n<!-- check: law -->\n$$ \\sum_{i=1}^k x_i = 0 \\tag{1} $$\n\n\
                <!-- check: law -->\n$$ \\sum_{i=1}^k x_i^2 = 2 \\tag{2} $$\n\nBy (1) and (2)\n\n$$ k \\le 2 \\tag{3} $$\n";
    let derivation = Derivation::from_markdown("page.md", page);
    let audit = Audit::of(&derivation);
    assert!(audit.of_equation(2)[0].refuted().is_some());
    assert!(family(&derivation, "3").is_none());
}

#[test]
fn a_count_that_begins_late_is_run_through_from_there() {
    let page = "<!-- check: symbols k: integer, >= 3 -->\n<!-- check: law -->\n$$ \\sum_{i=1}^k x_i = 0 \\tag{1} $$\n\n\
                By (1)\n\n$$ \\sum_{i=1}^k x_i^2 = 0 \\tag{2} $$\n";
    let found = family(&Derivation::from_markdown("page.md", page), "2");
    assert_eq!(found.map(|found| found.fails.family().least), Some(3));
}

#[test]
fn other_symbols_keep_their_values_where_not_all_will_do() {
    let page = "<!-- check: symbols k: natural -->\n<!-- check: law -->\n$$ a > b \\tag{1} $$\n\n\
                <!-- check: law -->\n$$ \\sum_{i=1}^k x_i = k a \\tag{2} $$\n\nBy (1) and (2)\n\n$$ \\sum_{i=1}^k x_i < k b \\tag{3} $$\n";
    let derivation = Derivation::from_markdown("page.md", page);
    let found = family(&derivation, "3").unwrap();
    assert!(found.fails.family().symbols.contains_key(&Symbol::new("a")));
}
