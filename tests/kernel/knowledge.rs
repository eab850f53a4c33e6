//! What is seen of a sign by inspection, and what is not.

use cradle_verify::kernel::Knowledge;

use super::claims::*;

/// What some hypotheses say about terms in `x`, `y` and `z`.
struct Known {
    proving: Proving,
    knowledge: Knowledge,
}

fn known(hypotheses: &[&str]) -> Known {
    let proving = Proving::new(claim(hypotheses, "x + y + z = 0"));
    let knowledge = Knowledge::new(&proving.problem.facts);
    Known { proving, knowledge }
}

impl Known {
    /// Whether a term is seen to be positive, not to be negative, not to vanish.
    fn signs(&self, text: &str) -> [bool; 3] {
        let p = self.proving.p(text);
        [
            self.knowledge.is_positive(&p),
            self.knowledge.is_nonnegative(&p),
            self.knowledge.is_nonzero(&p),
        ]
    }

    fn are(&self, signs: [bool; 3], terms: &[&str]) {
        for text in terms {
            assert_eq!(self.signs(text), signs, "{text}");
        }
    }
}

const NOTHING: [bool; 3] = [false, false, false];
const POSITIVE: [bool; 3] = [true, true, true];
const NOT_NEGATIVE: [bool; 3] = [false, true, false];
const NOT_ZERO: [bool; 3] = [false, false, true];

#[test]
fn even_powers_and_positive_numbers_need_no_hypothesis() {
    let k = known(&[]);
    k.are(POSITIVE, &["2", "x^2 + 1", "x^2 y^4 + z^2 + 3"]);
    k.are(NOT_NEGATIVE, &["0", "x^2", "x^2 + y^2", "x^2 y^4"]);
    k.are(NOT_ZERO, &["-2", "-x^2 - 1"]);
    k.are(
        NOTHING,
        &["x", "x^3", "x^2 y", "-x^2", "x^2 - 1", "x^2 + x + 1"],
    );
}

#[test]
fn what_is_not_negative_and_does_not_vanish_is_positive() {
    let k = known(&[
        "x \\leq y",
        "x \\neq y",
        "z \\leq 0",
        "x z \\leq 0",
        "x \\neq 0",
    ]);
    k.are(POSITIVE, &["y - x", "2 y - 2 x"]);
    // It is not said of `z` that it does not vanish, nor of `x` that it is positive.
    k.are(NOT_NEGATIVE, &["-z", "-x z"]);
    k.are(NOT_ZERO, &["x", "x - y"]);
    let k = known(&[
        "z \\leq 0",
        "z \\neq 0",
        "x^2 z \\geq 0",
        "x z - y z \\leq 0",
        "x - y \\neq 0",
    ]);
    k.are(POSITIVE, &["-z", "y z - x z"]);
    k.are(NOT_NEGATIVE, &["x^2 z"]);
}

#[test]
fn terms_of_positive_symbols_are_positive() {
    let k = known(&["x > 0", "y > 0"]);
    k.are(
        POSITIVE,
        &["x", "2 x", "x y^3", "x + y", "x + z^2", "x z^2 + y"],
    );
    k.are(NOT_NEGATIVE, &["x z^2"]);
    k.are(NOT_ZERO, &["-x", "-x y", "-x - y"]);
    k.are(NOTHING, &["x - y", "x + z", "x z", "z"]);
}

#[test]
fn terms_of_symbols_that_are_not_negative_may_vanish() {
    let k = known(&[r"x \geq 0", r"y \geq 0"]);
    k.are(POSITIVE, &["x + 1", "x y + 1"]);
    k.are(NOT_NEGATIVE, &["x", "x y", "x^3", "x + y"]);
    k.are(NOTHING, &["-x", "x - y", "x - 1"]);
}

#[test]
fn bound_above_0_makes_a_symbol_positive() {
    for bound in ["x > 1", r"x \geq 1", "2 x > 3", "1 < x"] {
        known(&[bound]).are(POSITIVE, &["x", "x^3", "x + 1"]);
    }
}

#[test]
fn bound_below_0_or_from_above_says_nothing_of_a_sign() {
    for bound in ["x > -1", r"x \geq -1", "x < 1", "-x > 0", "x < -1"] {
        let k = known(&[bound]);
        assert!(!k.signs("x")[1], "{bound}");
        assert!(!k.signs("x^3")[1], "{bound}");
    }
}

#[test]
fn bound_on_a_square_or_on_two_symbols_is_none_on_one() {
    for bound in ["x^2 + x > 0", r"x^2 + x \geq 1", r"x + y \geq 0", "x y > 0"] {
        let k = known(&[bound]);
        assert!(!k.signs("x")[1], "{bound}");
        assert!(!k.signs("y")[1], "{bound}");
    }
}

#[test]
fn equation_says_nothing_of_a_sign() {
    known(&["x = 1", "y - z = 0"]).are(NOTHING, &["x", "y - z", "y"]);
}

#[test]
fn positive_multiple_of_what_is_known_is_known() {
    let k = known(&["y - z > 0"]);
    k.are(POSITIVE, &["y - z", "3 y - 3 z"]);
    k.are(NOT_ZERO, &["z - y"]);
    k.are(NOTHING, &["y + z", "x y - x z"]);
    let k = known(&[r"y - z \geq 0"]);
    k.are(NOT_NEGATIVE, &["y - z", "3 y - 3 z"]);
    k.are(NOTHING, &["z - y"]);
    let k = known(&[r"y - z \neq 0"]);
    k.are(NOT_ZERO, &["y - z", "3 y - 3 z", "z - y"]);
    k.are(NOTHING, &["y + z", "x y - x z"]);
}

#[test]
fn positive_symbol_before_what_is_known_is_taken_out() {
    let k = known(&["x > 0", "y - z > 0"]);
    k.are(POSITIVE, &["x y - x z", "2 x^3 y - 2 x^3 z"]);
    k.are(NOT_ZERO, &["x z - x y"]);
    let k = known(&["x > 0", r"y - z \neq 0"]);
    k.are(NOT_ZERO, &["x y - x z", "x z - x y"]);
}

#[test]
fn symbol_that_does_not_vanish_has_no_sign() {
    let k = known(&[r"x \neq 0"]);
    k.are(POSITIVE, &["x^2", "x^2 + y^2", "x^2 + x^4"]);
    k.are(NOT_ZERO, &["x", "-x", "x^3", "x y^2 + x", "-x^2"]);
    k.are(NOTHING, &["x + 1", "x y", "x^2 + y"]);
}

#[test]
fn product_that_does_not_vanish_has_no_factor_that_does() {
    for product in [r"x y \neq 0", "x y > 0", r"x y z - x y \neq 0"] {
        let k = known(&[product]);
        k.are(NOT_ZERO, &["x", "y", "x y^2"]);
        assert!(!k.signs("z")[2], "{product}");
    }
    known(&[r"x y - x z \neq 0"]).are(NOT_ZERO, &["x y - x z", "x"]);
    known(&[r"x y \geq 0"]).are(NOTHING, &["x", "y"]);
}

#[test]
fn difference_of_squares_has_the_sign_of_both_its_factors() {
    let known = known(&["x > y", "x > 0", "y > 0"]);
    known.are(POSITIVE, &["x^2 - y^2", "x^4 - y^4", "3 x^3 - 3 x y^2"]);
    // The other way round it is negative, which it is not to be taken for positive for; and no square is a cube.
    known.are(NOT_ZERO, &["y^2 - x^2"]);
    known.are(NOTHING, &["x^5 - y^5", "x^2 - 2 y^2", "x^2 - z^2"]);
}

#[test]
fn sum_of_products_with_what_is_positive_is() {
    let known = known(&["x < 1", "y > 0", "z > 0"]);
    known.are(
        POSITIVE,
        &[
            "z - z x + y",
            "2 - x",
            "y - x y",
            "2 z + 3 y - 3 x y - z x",
            "5 y z - 5 x y z",
        ],
    );
    known.are(
        NOTHING,
        &[
            "z - z x - y",
            "z - 2 z x + y",
            "x - x^2 + y",
            "z + z x + y - 1",
        ],
    );
    // One takes three products, and the other four.
    known.are(POSITIVE, &["y + z + y z - x y - x z - x y z"]);
    known.are(
        NOTHING,
        &["y + z + y z + y^2 z - x y - x z - x y z - x y^2 z"],
    );
    // What is long is not looked through.
    let long = |powers: u32| {
        let rest: Vec<String> = (1..=powers).map(|k| format!("z^{{{k}}}")).collect();
        format!("y - x y + {}", rest.join(" + "))
    };
    known.are(POSITIVE, &[&long(10)]);
    known.are(NOTHING, &[&long(11)]);
    // With what is only not negative nothing is made positive.
    let weak = self::known(&["x < 1", "y \\geq 0"]);
    weak.are(NOTHING, &["y - x y"]);
    let cubes = self::known(&["x > y", "x > 0", "y > 0"]);
    cubes.are(POSITIVE, &["x^3 - y^3"]);
}

#[test]
fn difference_of_squares_needs_both_factors() {
    // −2 < 1, and yet 1 < 4.
    let known = known(&["x > y", "x > 0"]);
    known.are(NOTHING, &["x^2 - y^2"]);
}

#[test]
fn no_factor_of_what_does_not_vanish_does() {
    let known = known(&["x^2 y - x^2 z \\neq 0"]);
    known.are(NOT_ZERO, &["y - z", "2 z - 2 y", "x", "x^3", "x y - x z"]);
    known.are(NOTHING, &["y", "z", "y + z", "x y + x z", "y^2 - z"]);
    // The product may have a sign that its factors have not.
    let positive = self::known(&["x y - x z > 0"]);
    positive.are(NOT_ZERO, &["y - z", "x"]);
}
