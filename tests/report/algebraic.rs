//! Points with irrational values, in words and for programs.

use cradle_verify::algebra::{BigRational, Symbol};
use cradle_verify::audit::{Audit, Outcome};
use cradle_verify::derivation::Derivation;
use cradle_verify::kernel::{Algebraic, Assignment, Candidate, Checked, check};
use cradle_verify::report::Report;
use cradle_verify::report::evidence::Point;
use serde_json::json;

/// A point with values in powers of the root of a polynomial.
fn point(polynomial: &[i64], low: i64, high: i64, values: &[(&str, &[i64])]) -> Assignment {
    let whole = |n: i64| BigRational::from_integer(n.into());
    let list = |all: &[i64]| all.iter().map(|&n| whole(n)).collect::<Vec<_>>();
    let values = values.iter().map(|&(s, v)| (Symbol::new(s), list(v)));
    Assignment {
        algebraic: Some(Box::new(Algebraic {
            polynomial: list(polynomial),
            low: whole(low),
            high: whole(high),
            symbols: values.collect(),
            ..Algebraic::default()
        })),
        ..Assignment::default()
    }
}

/// How a point is shown to people and to programs: as a counterexample to what is false everywhere.
fn shown(point: &Assignment) -> [Vec<(String, String)>; 2] {
    let names = point.algebraic.iter().flat_map(|own| own.symbols.keys());
    let sum = names.map(Symbol::name).collect::<Vec<_>>().join(" + ");
    let page = format!("<!-- check: derived -->\n$$ {sum} = {sum} + 1 $$\n");
    let derivation = Derivation::from_markdown("page.md", &page);
    let mut audit = Audit::of(&derivation);
    let (_, refuted) = audit.entries[0].refuted().expect(&page);
    let claim = refuted.claim().clone();
    let people = Point::new(&claim, point).values();
    let checked = check(claim.clone(), Candidate::Counterexample(point.clone()));
    let Ok(Checked::Refuted(refuted)) = checked else {
        panic!("{checked:?}");
    };
    audit.entries[0].judged[0].outcome = Outcome::Refuted(refuted.into());
    let report = Report {
        derivation: &derivation,
        audit: &audit,
        paths: &[],
    };
    let view = json!(report.json());
    let witness = &view["documents"][0]["equations"][0]["witness"];
    let witness = witness.as_object().expect("a counterexample").iter();
    let text = |value: &serde_json::Value| value.as_str().unwrap().to_owned();
    let programs = witness.map(|(name, value)| (name.clone(), text(value)));
    [people, programs.collect()]
}

fn of((name, value): (&str, &str)) -> (String, String) {
    (name.to_owned(), value.to_owned())
}

#[test]
fn square_roots_are_written_in_closed_form() {
    for (polynomial, low, high, value, people, programs) in [
        (&[-2, 0, 1][..], 1, 2, &[0, 1][..], "√2", "sqrt(2)"),
        (&[-2, 0, 1], -2, -1, &[0, 1], "−√2", "-sqrt(2)"),
        (&[-20, 0, 1], 4, 5, &[0, 1], "2 √5", "2*sqrt(5)"),
        (&[-1, 0, 2], 0, 1, &[0, 1], "√2/2", "sqrt(2)/2"),
        (&[-1, -1, 1], 1, 2, &[0, 1], "(1 + √5)/2", "(1+sqrt(5))/2"),
        (&[-1, -1, 1], -1, 0, &[0, 1], "(1 − √5)/2", "(1-sqrt(5))/2"),
        (&[-2, 0, 1], 1, 2, &[3, -2], "3 − 2 √2", "3-2*sqrt(2)"),
        (&[-2, 0, 1], 1, 2, &[-1, 1], "√2 − 1", "-1+sqrt(2)"),
        (&[-2, 0, 1], 1, 2, &[7, 0, 3], "13", "13"),
    ] {
        let [said, typed] = shown(&point(polynomial, low, high, &[("x", value)]));
        assert_eq!(said, [of(("x", people))]);
        assert_eq!(typed, [of(("x", programs))]);
    }
}

#[test]
fn other_roots_have_a_name_and_a_decimal() {
    let values: [(&str, &[i64]); 2] = [("x", &[0, 1]), ("y", &[1, 0, 1])];
    let [said, typed] = shown(&point(&[-2, 0, 0, 1], 1, 2, &values));
    let x = of(("x", "the root of x³ − 2 in (1, 2) (≈ 1.2599)"));
    assert_eq!(said, [x, of(("y", "x² + 1 (≈ 2.5874)"))]);
    let x = of(("x", "root of x^3-2 in [1,2]"));
    assert_eq!(
        typed,
        [x, of(("y", "x^2+1 for x = root of x^3-2 in [1,2]"))]
    );
    let [said, _] = shown(&point(&[-2, 0, 0, 1], 1, 2, &values[1..]));
    let alpha = of(("α", "the root of α³ − 2 in (1, 2) (≈ 1.2599)"));
    assert_eq!(said, [alpha, of(("y", "α² + 1 (≈ 2.5874)"))]);
}
