//! Decimals for exact numbers: rounded outwards, so that an interval keeps what is in it.

use cradle_verify::derivation::Derivation;

use crate::common;

/// How an interval is told that a figure lies in.
fn told(low: &str, high: &str) -> String {
    let page = format!(
        "<!-- check: data x: [{low}, {high}], \"a table\" -->\n\n<!-- check: numeric within 0.01 -->\n$$ x \\approx 1 $$\n"
    );
    let derivation = Derivation::from_markdown("page.md", &page);
    let text = common::reported(&derivation, |report| report.explain(0));
    let text = anstream::adapter::strip_str(&text).to_string();
    let (_, figures) = text.split_once("Figures, in SI units\n").expect(&text);
    let line = figures.lines().next().unwrap();
    let (told, _) = line.split_once("   a table").expect(line);
    told.trim().to_owned()
}

#[test]
fn decimals_are_rounded_outwards() {
    for (value, below, above) in [
        ("1/3", "0.333", "0.334"),
        ("-1/3", "−0.334", "−0.333"),
        ("9999/10", "999", "1000"),
        ("123456", "123000", "124000"),
        ("215000000", "2.15 × 10^8", "2.15 × 10^8"),
        ("1/99000", "1.01 × 10^−5", "1.02 × 10^−5"),
        ("2", "2", "2"),
        ("0", "0", "0"),
    ] {
        let (least, most) = ("-1e9", "1e9");
        assert_eq!(told(value, most), format!("x between {below} and 1 × 10^9"));
        assert_eq!(
            told(least, value),
            format!("x between −1 × 10^9 and {above}")
        );
    }
    assert_eq!(told("1/3", "1/3"), "x = 1/3");
}
