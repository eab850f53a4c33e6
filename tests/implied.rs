//! What follows in the place of a failing equation: right physics, broken in one place, is mended.

use cradle_verify::audit::{Audit, Entry, Verdict};
use cradle_verify::derivation::Derivation;
use cradle_verify::notation::{latex_formula, plain};

use crate::common;

fn last(source: &str) -> Entry {
    let audit = Audit::of(&Derivation::from_markdown("page.md", source));
    audit.entries.last().expect("an equation").clone()
}

/// What follows, and the ratio of what is printed to it.
fn instead(source: &str) -> (String, Option<String>) {
    let entry = last(source);
    assert_eq!(entry.verdict, Verdict::Fails);
    let implied = entry.implied.expect("something follows");
    let ratio = implied.ratio.as_ref().map(plain);
    (latex_formula(&implied.proven.claim().goal), ratio)
}

const CARTS: &str = r"
<!-- check: symbols M, m: mass, positive
symbols v, w: velocity
symbols Q: energy -->
<!-- check: law -->
$$ m v = (M + m) w \tag{1} $$
<!-- check: definition -->
$$ Q = \frac12 m v^2 - \frac12 (M + m) w^2 \tag{2} $$
<!-- check: derived; from (1), (2) -->
";

#[test]
fn a_forgotten_half_is_named() {
    let page = format!(r"{CARTS} $$ Q = \frac{{M m}}{{M + m}} v^2 \tag{{3}} $$");
    let (formula, ratio) = instead(&page);
    assert_eq!(formula, r"Q = \frac{M m}{2 (M + m)} v^2");
    assert_eq!(ratio.as_deref(), Some("2"));
}

#[test]
fn a_wrong_sign_is_named() {
    let page = format!(r"{CARTS} $$ Q = -\frac{{M m}}{{2 (M + m)}} v^2 \tag{{3}} $$");
    assert_eq!(instead(&page).1.as_deref(), Some("−1"));
}

#[test]
fn what_is_printed_may_be_wrong_in_more_than_a_factor() {
    let page = format!(r"{CARTS} $$ Q = \frac{{M m}}{{2 (M - m)}} v^2 \tag{{3}} $$");
    let (formula, ratio) = instead(&page);
    assert_eq!(formula, r"Q = \frac{M m v^2}{2 (M + m)}");
    // A ratio that is neither a number nor a short product helps nobody.
    assert_eq!(ratio, None);
}

#[test]
fn other_symbols_are_used_only_where_those_printed_do_not_suffice() {
    let page = format!(r"{CARTS} $$ Q = \frac12 M w \tag{{3}} $$");
    let entry = last(&page);
    assert_ne!(entry.verdict, Verdict::Holds);
}

#[test]
fn premises_that_leave_the_symbol_open_give_nothing() {
    let page = r"
<!-- check: symbols x, y: positive -->
<!-- check: law -->
$$ x + y + z = 3 \tag{1} $$
<!-- check: derived; from (1) -->
$$ x \geq 5 \tag{2} $$
";
    let entry = last(page);
    assert_eq!(entry.verdict, Verdict::Fails);
    assert!(entry.implied.is_none());
}

/// The findings on a page, as a person reads them.
fn findings(source: &str) -> String {
    let derivation = Derivation::from_markdown("page.md", source);
    common::human(&derivation)
}

#[test]
fn a_law_in_the_middle_of_a_text_is_told_how_to_be_one() {
    let law = "nothing before it speaks of k; if it is a law, a model or a definition, write `<!-- check: law -->` above it";
    let spring = "<!-- check: law -->\n$$ F = a + b \\tag{1} $$\n\nHence\n\n";
    let said = findings(&format!("{spring}$$ F = k x \\tag{{2}} $$\n"));
    assert!(said.contains(law), "{said}");
    // Neither where something is cited, nor where every symbol has occurred, nor where it is a law.
    for other in [
        "From (1):\n\n$$ F = k x \\tag{2} $$\n",
        "$$ F = a b \\tag{2} $$\n",
        "<!-- check: law -->\n$$ F = k x \\tag{2} $$\n",
    ] {
        let said = findings(&format!("{spring}{other}"));
        assert!(!said.contains("nothing before it speaks of"), "{said}");
    }
}

#[test]
fn of_an_approximation_no_side_is_said_to_have_a_value() {
    let told = findings(
        "$$ y = 2 x $$\n\nFor small $x$ we have\n\n$$ \\frac{1}{\\sqrt{1 + x}} \\approx 1 - \\frac{x}{2} + \\frac34 x^2 $$\n",
    );
    assert!(
        told.contains("the two sides have different series"),
        "{told}"
    );
    assert!(told.contains("has another series"), "{told}");
    assert!(!told.contains("at the point below"), "{told}");
    let told = findings(
        "$$ v = \\frac{a t}{1 + b t} \\tag{1} $$\n\nAs $t \\to \\infty$, by (1)\n\n$$ v \\approx \\frac{2 a}{b} $$\n",
    );
    assert!(told.contains("left 1, right 2 at a = 1, b = 1"), "{told}");
}
