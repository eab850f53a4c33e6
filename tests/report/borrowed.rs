//! Which equations are named for a step that does not follow from what it cites: no more than it needs, and none that fails.

use cradle_verify::derivation::Derivation;

use crate::common;

/// What is said of an equation, in its line.
fn said(page: &str, number: &str) -> String {
    let derivation = Derivation::from_markdown("page.md", page);
    let text = common::reported(&derivation, |report| report.lines(true));
    let text = anstream::adapter::strip_str(&text).to_string();
    let line = text.lines().find(|line| line.contains(number));
    let words = line.expect(&text).split_whitespace();
    words.skip(1).collect::<Vec<_>>().join(" ")
}

const LENSES: &str = r"
<!-- check: symbols f, f_1, f_2, a, b, c: nonzero; symbols x, y, M: real -->

<!-- check: law -->
$$ \frac{1}{f} = \frac{1}{a} + \frac{1}{b}, \qquad M = -\frac{b}{a} \tag{1} $$

<!-- check: definition -->
$$ x = a - f, \qquad y = b - f \tag{2} $$

By (1) and (2)
$$ x y = f^2 \tag{3} $$

and by (1) and (2)
$$ M = -\frac{y}{f} \tag{4} $$

Two lenses:

<!-- check: law -->
$$ \frac{1}{f_1} = \frac{1}{a} + \frac{1}{c}, \qquad \frac{1}{f_2} = \frac{1}{b} - \frac{1}{c} \tag{5} $$

By (1) and (5)
$$ \frac{1}{f} = \frac{1}{f_1} + \frac{1}{f_2} \tag{6} $$

hence, by (6),
$$ f = \frac{f_1 f_2}{f_1 + f_2} \tag{7} $$
";

#[test]
fn no_more_is_named_than_is_needed() {
    assert_eq!(said(LENSES, "(7)"), "✓ holds from (6)");
    let slip = LENSES.replace(
        r"\frac{1}{f_1} + \frac{1}{f_2} \tag{6}",
        r"\frac{1}{f_1} - \frac{1}{f_2} \tag{6}",
    );
    assert_eq!(
        said(&slip, "(7)"),
        "✓ holds miscited: follows from (1) and (5), not (6)"
    );
}

const DIMER: &str = r"
<!-- check: symbols K, c, a, b: positive; symbols x: in (0, 1) -->

<!-- check: law -->
$$ K = \frac{b^2}{a} \tag{1} $$

<!-- check: law -->
$$ a = c (1 - x), \qquad b = 2 c x \tag{2} $$

By (1) and (2)
$$ K = \frac{4 c x^2}{1 - x} \tag{3} $$

By (3)
$$ x^2 < \frac{K}{4 c} \tag{4} $$
";

#[test]
fn what_fails_is_not_needed_where_it_follows_without() {
    assert_eq!(said(DIMER, "(4)"), "✓ holds from (3)");
    for wrong in [
        r"\frac{4 c^2 x^2}{1 - x}",
        r"\frac{4 c x^3}{1 - x}",
        r"\frac{4 c x^2}{1 + x}",
    ] {
        let slip = DIMER.replace(r"\frac{4 c x^2}{1 - x}", wrong);
        assert_eq!(
            said(&slip, "(4)"),
            "✓ holds miscited: follows from (1) and (2), not (3)",
            "{wrong}"
        );
    }
}

#[test]
fn what_contradicts_itself_contradicts_more_than_nothing() {
    for (symbols, display) in [
        ("v: nonzero; symbols w: real", r"v = w, \qquad v = 2 w"),
        ("v, w: positive", "v + w = 0"),
    ] {
        let page = format!(
            "<!-- check: symbols {symbols} -->\n\n<!-- check: law -->\n$$ {display} \\tag{{1}} $$\n"
        );
        let derivation = Derivation::from_markdown("page.md", &page);
        let text = common::human(&derivation);
        let title = text.lines().find(|line| line.starts_with("error"));
        let title = title.expect(&text);
        assert!(title.contains("for no values that"), "{title}");
        assert!(!text.contains("contradicts nothing"), "{text}");
    }
}
