//! Numbers and ranges of tags in directives.

use cradle_verify::document::{Attribute, Directive, Premise};

use super::{directives, read};

/// The bound of a declaration, if it is one.
fn bound(text: &str) -> Option<String> {
    let document = read(&format!("<!-- check: symbols x: >= {text} -->"));
    match directives(&document)[..] {
        [Directive::Symbols { attributes, .. }] if document.problems.is_empty() => {
            match &attributes[0].value {
                Attribute::Interval { lower, .. } => lower.as_ref().map(|b| b.value.to_string()),
                _ => None,
            }
        }
        _ => None,
    }
}

#[test]
fn numbers_are_exact() {
    for (text, value) in [
        ("1/2", "1/2"),
        (" -0.25 ", "-1/4"),
        ("− 3", "-3"),
        (r"\frac{2}{4}", "1/2"),
        (".5", "1/2"),
    ] {
        assert_eq!(bound(text).as_deref(), Some(value), "{text}");
    }
}

#[test]
fn what_is_not_a_number_is_refused() {
    let long = "9".repeat(501);
    for text in [
        "",
        "1/0",
        "1.",
        "x",
        "1e5",
        "--1",
        "1/2/3",
        r"\frac{1}",
        ".",
        &long,
    ] {
        assert_eq!(bound(text), None, "{text}");
    }
    assert!(bound(&long[1..]).is_some());
}

/// The bounds of figures, if they are any.
fn figures(text: &str) -> Option<String> {
    let document = read(&format!("<!-- check: data x: {text}, \"a book\" -->"));
    match directives(&document)[..] {
        [Directive::Data { low, high, .. }] => Some(format!("{low} {high}")),
        _ => {
            assert_eq!(document.problems.len(), 1, "{text}");
            None
        }
    }
}

#[test]
fn figures_are_exact() {
    for (text, bounds) in [
        ("[200e9, 215e9]", "200000000000 215000000000"),
        ("9.81 ± 0.03", "489/50 246/25"),
        ("-1e-2 \\pm 1e-2", "-1/50 0"),
        ("1/3", "1/3 1/3"),
    ] {
        assert_eq!(figures(text).as_deref(), Some(bounds), "{text}");
    }
}

#[test]
fn what_is_no_figure_is_refused() {
    for text in [
        "", "[2, 1]", "[1 2]", "1 ± -1", "e5", "1e", "1e400", "1e1/2", "x", "[1, 2", "5 GPa",
    ] {
        assert_eq!(figures(text), None, "{text}");
    }
}

/// The tags that a range of equations stands for.
fn range(first: &str, last: &str) -> Vec<String> {
    let document = read(&format!("<!-- check: from ({first})–({last}) -->"));
    let [Directive::From(premises)] = directives(&document)[..] else {
        panic!("{:?}", document.problems);
    };
    let tag = |premise: &Premise| match premise {
        Premise::Tag(tag) => tag.clone(),
        other => panic!("{other:?}"),
    };
    premises.iter().map(|premise| tag(&premise.value)).collect()
}

#[test]
fn only_numeric_ranges_in_order_expand() {
    assert_eq!(range("2", "5"), ["2", "3", "4", "5"]);
    assert_eq!(range("5", "2"), ["5", "2"]);
    assert_eq!(range("A.1", "A.3"), ["A.1", "A.3"]);
    let far = "99999999999999999999";
    assert_eq!(range("1", far), ["1", far]);
    assert_eq!(range("0", "18446744073709551615").len(), 2);
}
