//! Partial derivatives of polynomials, taken term by term here; then one coefficient is changed.

use cradle_verify::audit::Audit;
use cradle_verify::derivation::Derivation;
use proptest::prelude::*;

/// A sum of terms `c x^a y^b m^d`, each given by its numbers.
type Terms = Vec<(i64, u32, u32, u32)>;

fn written(terms: &Terms) -> String {
    let term = |(c, a, b, d): &(i64, u32, u32, u32)| format!("({c}) x^{a} y^{b} m^{d}");
    let all: Vec<String> = terms.iter().map(term).collect();
    all.join(" + ")
}

/// By `x`, the rest held fixed.
fn slope(terms: &Terms) -> Terms {
    let by_x = |&(c, a, b, d): &(i64, u32, u32, u32)| (c * i64::from(a), a - 1, b, d);
    terms.iter().map(by_x).collect()
}

fn verdict(function: &Terms, slope: &Terms) -> &'static str {
    let text = format!(
        "<!-- check: law -->\n\n$$ f = {} \\tag{{1}} $$\n\nBy (1),\n\n$$ \\frac{{\\partial f}}{{\\partial x}} = {} $$\n",
        written(function),
        written(slope)
    );
    let audit = Audit::of(&Derivation::from_markdown("page.md", &text));
    audit.entries[1].verdict.word()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, ..ProptestConfig::default() })]

    #[test]
    fn a_right_slope_holds_and_a_wrong_one_fails(
        terms in prop::collection::vec((1..5i64, 1..4u32, 1..3u32, 1..3u32), 1..4),
        which in 0..4usize,
        by in 1..4i64,
    ) {
        let right = slope(&terms);
        prop_assert_eq!(verdict(&terms, &right), "holds");
        let mut wrong = right;
        let which = which % wrong.len();
        wrong[which].0 += by;
        prop_assert_eq!(verdict(&terms, &wrong), "fails");
    }
}
