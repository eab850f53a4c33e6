//! What a finding says: nothing that its own counterexample belies, and in the shortest words.

use cradle_verify::derivation::Derivation;

use crate::common;

fn told(source: &str) -> String {
    common::human(&Derivation::from_markdown("page.md", source))
}

#[test]
fn what_holds_under_a_condition_is_not_said_to_be_unproved() {
    let text = told(
        r"
$$ I R = U \tag{1} $$

Hence

$$ I = \frac{U}{R} \tag{2} $$

so the power $P = U I$ is

$$ P = \frac{U^2}{R} \tag{3} $$
",
    );
    assert!(
        text.contains("rests on (2), which holds if R ≠ 0"),
        "{text}"
    );
    assert!(!text.contains("not proved"), "{text}");
}

#[test]
fn a_condition_is_told_of_what_a_power_is_a_power_of() {
    let text = told(
        r"
The power is

$$ P (R^2 + 2 R r + r^2) = U^2 R \tag{1} $$

with constant $U$ and $r$. Hence

$$ P = \frac{U^2 R}{R^2 + 2 R r + r^2} \tag{2} $$
",
    );
    assert!(
        text.contains("holds if R + r ≠ 0, and nothing says so"),
        "{text}"
    );
}

#[test]
fn what_another_link_needs_is_not_said_of_the_one_that_fails() {
    let text = told(
        r"
$$ f = L - d \tag{1} $$

Hence

$$ \frac{1}{f} = \frac{1}{L - d} + \frac{1}{L + d} = \frac{2 L}{L^2 - d^2} \tag{2} $$
",
    );
    assert!(text.contains("✗ fails"), "{text}");
    assert!(!text.contains("follows if also"), "{text}");
}

#[test]
fn units_are_no_variables_of_a_counterexample() {
    let text = told(
        r"
$$ g = \frac{2 h}{t^2} \tag{1} $$

With $h = 1.20\,\mathrm{m}$ and $t = 0.495\,\mathrm{s}$ we get

$$ g = 8.79\,\mathrm{m/s^2} \tag{2} $$
",
    );
    assert!(
        text.contains("counterexample: g = 32000/3267, h = 6/5, t = 99/200\n"),
        "{text}"
    );
    assert!(!text.contains("what follows is"), "{text}");
}

#[test]
fn a_rounded_result_is_told_in_decimals() {
    let text = told(
        r"
$$ g = \frac{2 h}{t^2} \tag{1} $$

With $h = 1.20\,\mathrm{m}$ and $t = 0.495\,\mathrm{s}$ we get

$$ g = 9.79\,\mathrm{m/s^2} \tag{2} $$
",
    );
    assert!(
        text.contains("≈ supported numerically: left 9.7949, right 9.79"),
        "{text}"
    );
}
