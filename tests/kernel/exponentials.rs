//! Points at which exponentials are powers of `e`, which is transcendental.

use cradle_verify::algebra::{Expr, Function};
use cradle_verify::kernel::{Assignment, Reject};

use super::claims::*;

/// `exp` of numbers: a point gives symbols values, and nothing else.
fn at(values: &[(&str, (i64, i64))]) -> Assignment {
    let mut point = point(&[]);
    for &(name, (above, below)) in values {
        point.symbols.insert(symbol(name), ratio(above, below));
    }
    point
}

#[test]
fn an_equation_between_powers_of_e_is_told_by_its_coefficients() {
    let goal = |text: &str| claim(&[], text);
    let one = at(&[("x", (1, 1))]);
    assert_eq!(refuted(&goal(r"\exp x = 1 + x"), one.clone()), Ok(()));
    assert_eq!(refuted(&goal(r"x \exp x = 2 \exp x"), one.clone()), Ok(()));
    let verdict = refuted(&goal(r"x \exp x = \exp x"), one);
    assert_eq!(verdict, Err(Reject::GoalNotFalse));
    // Both are powers of what has the greatest common exponent.
    let parts = at(&[("x", (1, 2)), ("y", (1, 3))]);
    let same = refuted(&goal(r"(\exp x)^2 = (\exp y)^3"), parts.clone());
    assert_eq!(same, Err(Reject::GoalNotFalse));
    assert_eq!(refuted(&goal(r"(\exp x)^3 = (\exp y)^2"), parts), Ok(()));
}

#[test]
fn which_of_two_is_greater_is_told_by_bounds() {
    let one = || at(&[("x", (1, 1))]);
    for (goal, is_false) in [
        (r"\exp x > 3", true),
        (r"\exp x > 2", false),
        (r"1000000 \exp x > 2718282", true),
        (r"1000000 \exp x > 2718281", false),
        (r"(\exp x)^2 - 8 > 0", true),
        (r"(\exp x)^2 - 7 > 0", false),
    ] {
        let expected = match is_false {
            true => Ok(()),
            false => Err(Reject::GoalNotFalse),
        };
        assert_eq!(refuted(&claim(&[], goal), one()), expected, "{goal}");
    }
}

#[test]
fn what_is_no_positive_number_of_the_point_has_no_exponential() {
    let goal = |text: &str| claim(&[], text);
    for (value, reason) in [((-1, 1), Reject::NoValue), ((50, 1), Reject::TooLarge)] {
        let verdict = refuted(&goal(r"\exp x = 1 + x"), at(&[("x", value)]));
        assert_eq!(verdict, Err(reason), "{value:?}");
    }
    // Of 0 it is 1, whatever else is said.
    let verdict = refuted(&goal(r"\exp x = 1 + x"), at(&[("x", (0, 1))]));
    assert_eq!(verdict, Err(Reject::GoalNotFalse));
    let high = refuted(&goal(r"\exp(60 x) = x"), at(&[("x", (1, 60))]));
    assert_eq!(high, Err(Reject::TooLarge));
    // An exponential is no rational number, and of one there is no exponential here.
    let twice = refuted(&goal(r"\exp(\exp x) = x"), at(&[("x", (1, 1))]));
    assert_eq!(twice, Err(Reject::NoValue));
}

#[test]
fn no_premise_is_taken_for_true_beside_powers_of_e() {
    let claim = claim(&[r"y = \exp x"], "x = 2");
    let verdict = refuted(&claim, at(&[("x", (1, 1)), ("y", (3, 1))]));
    assert_eq!(verdict, Err(Reject::PremiseFalse(0)));
}

#[test]
fn e_stands_beside_no_other_number_of_its_kind() {
    // Nobody knows how `e` and π belong together.
    let verdict = refuted(&claim(&[], r"\exp x = \pi"), at(&[("x", (1, 1))]));
    assert_eq!(verdict, Err(Reject::NoValue));
    // A symbol left open may be any that has this sine, or exponential: how that of another number compares is not told.
    let call = |function, text: &str| Expr::Call(function, term(text).into());
    let mut open = at(&[("x", (1, 1))]);
    open.functions.insert(call(Function::Sin, "y"), number(0));
    open.functions.insert(call(Function::Cos, "y"), number(1));
    let verdict = refuted(&claim(&[], r"\exp x = \sin y"), open);
    assert_eq!(verdict, Err(Reject::NoValue));
    let mut open = at(&[("x", (1, 1))]);
    open.functions.insert(call(Function::Exp, "y"), number(2));
    let verdict = refuted(&claim(&[], r"\exp x = \exp y"), open);
    assert_eq!(verdict, Err(Reject::NoValue));
}

#[test]
fn no_other_function_is_taken_of_a_power_of_e() {
    // The sine of `e` is not that of π.
    for forged in [r"\sin(\exp x) \neq 0", r"\cos(\exp x) > 0"] {
        let verdict = refuted(&claim(&[], forged), at(&[("x", (1, 1))]));
        assert!(verdict.is_err(), "{forged}: {verdict:?}");
    }
}
