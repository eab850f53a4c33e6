//! What convinces a reader: counterexamples that do without conventions, and what a repair needs besides.

use cradle_verify::audit::Audit;
use cradle_verify::derivation::Derivation;

use crate::common;

/// The value of a symbol at the counterexample to the only equation that is wrong.
fn value(page: &str, symbol: &str) -> String {
    let audit = Audit::of(&Derivation::from_markdown("page.md", page));
    let (_, refuted) = audit.entries.iter().find_map(|e| e.refuted()).expect(page);
    let mut values = refuted.witness().symbols.iter();
    let (_, value) = values.find(|(own, _)| own.name() == symbol).expect(symbol);
    value.to_string()
}

const SUM: &str = r"
<!-- check: symbols n: integer, >= 0; symbols p: in [0, 1] -->

<!-- check: from nothing; derived -->
$$ \sum_{i=0}^{n} p^i \leq p (n + 1) \tag{1} $$
";

#[test]
fn nothing_is_0_that_is_raised_to_a_power_of_0() {
    assert_ne!(value(SUM, "p"), "0");
}

#[test]
fn where_nothing_else_is_false_a_power_of_0_is_1() {
    let page = SUM
        .replace("p (n + 1)", "0")
        .replace("<!-- check: from", "Let $p = 0$.\n\n<!-- check: from");
    assert_eq!(value(&page, "p"), "0");
}

/// The line of help of the only equation that is wrong.
fn help(page: &str) -> String {
    let derivation = Derivation::from_markdown("page.md", page);
    let text = common::human(&derivation);
    let line = text.lines().find_map(|line| line.split_once("help: "));
    line.expect(&text).1.to_owned()
}

#[test]
fn what_a_repair_needs_is_told_of_the_symbols_in_it() {
    let page = r"
The laws are
$$ m a = F \tag{1} $$
and
$$ p = m v \tag{2} $$
Hence
$$ a = \frac{m}{F} \tag{3} $$
";
    assert_eq!(
        help(page),
        r"what follows is `a = \frac{F}{m}`, if m ≠ 0; only a fraction is upside down"
    );
    let stated = page.replace("Hence", "Hence, for $m \\neq 0$,");
    assert!(!help(&stated).contains(", if"), "{}", help(&stated));
}
