//! Points at which functions have values, and forgeries of such points.

use cradle_verify::algebra::{BigRational, Expr, Function};
use cradle_verify::document::Span;
use cradle_verify::kernel::{Assignment, Claim, Domain, Reject};
use cradle_verify::notation::read_expr;
use cradle_verify::sorted::Map;

use super::claims::*;

fn ratio(n: i64, d: i64) -> BigRational {
    BigRational::new(n.into(), d.into())
}

fn term(text: &str) -> Expr {
    read_expr(text, Span::new(0, text.len())).expect("a term")
}

/// A point that gives functions of arguments values.
fn with(symbols: &[(&str, i64)], calls: &[(Function, &str, BigRational)]) -> Assignment {
    let call = |(function, argument, value): &(Function, &str, BigRational)| {
        (Expr::Call(*function, term(argument).into()), value.clone())
    };
    Assignment {
        functions: calls.iter().map(call).collect(),
        ..point(symbols)
    }
}

fn angle(
    argument: &'static str,
    sine: (i64, i64),
    cosine: (i64, i64),
) -> Vec<(Function, &'static str, BigRational)> {
    vec![
        (Function::Sin, argument, ratio(sine.0, sine.1)),
        (Function::Cos, argument, ratio(cosine.0, cosine.1)),
    ]
}

fn between(lower: (i64, i64), upper: (i64, i64)) -> Domain {
    Domain {
        lower: Some((ratio(lower.0, lower.1), true)),
        upper: Some((ratio(upper.0, upper.1), true)),
        ..Domain::default()
    }
}

fn wrong() -> Claim {
    claim(&[], "\\sin(x) = \\cos(x)")
}

#[test]
fn point_of_the_circle_is_an_angle() {
    let at = with(&[], &angle("x", (3, 5), (4, 5)));
    assert_eq!(refuted(&wrong(), at), Ok(()));
}

#[test]
fn point_off_the_circle_is_none() {
    let at = with(&[], &angle("x", (3, 5), (3, 4)));
    assert_eq!(refuted(&wrong(), at), Err(Reject::NoSuchValue));
}

#[test]
fn sine_without_cosine_is_rejected() {
    for function in [Function::Sin, Function::Cos] {
        let at = with(&[], &[(function, "x", ratio(3, 5))]);
        assert_eq!(refuted(&wrong(), at), Err(Reject::NoPartner));
    }
}

#[test]
fn angle_with_a_value_is_not_open() {
    let at = with(&[("x", 1)], &angle("x", (3, 5), (4, 5)));
    assert_eq!(refuted(&wrong(), at), Err(Reject::NotPrivate));
}

#[test]
fn angle_that_occurs_elsewhere_is_not_open() {
    for (premises, goal) in [
        (vec!["x = 1"], "\\sin(x) = \\cos(x)"),
        (vec!["y = x"], "\\sin(x) = \\cos(x)"),
        (vec![], "\\sin(x) = x"),
        (vec![], "\\sin(x) < x"),
        (vec![], "\\sin(x) = \\exp(x)"),
        (vec![], "\\sin(x) = |x|"),
        (vec!["y = \\sin(x^2)"], "\\sin(x) = y"),
        (vec!["y = \\sin(x + 1)"], "\\sin(x) = y"),
        (vec!["y = \\sin(\\frac{x}{2})"], "\\sin(x) = y"),
    ] {
        let at = with(&[("y", 1)], &angle("x", (3, 5), (4, 5)));
        let verdict = refuted(&claim(&premises, goal), at);
        assert!(
            matches!(verdict, Err(Reject::NotPrivate | Reject::NoValue)),
            "{premises:?} ⊢ {goal}: {verdict:?}"
        );
    }
}

#[test]
fn two_angles_of_one_symbol_are_rejected() {
    let claim = claim(&[], "\\sin(x) = \\sin(2 x)");
    let mut both = angle("x", (3, 5), (4, 5));
    assert_eq!(refuted(&claim, with(&[], &both)), Ok(()));
    both.extend(angle("2 x", (3, 5), (4, 5)));
    assert_eq!(refuted(&claim, with(&[], &both)), Err(Reject::NotPrivate));
}

#[test]
fn factor_of_an_angle_must_not_vanish() {
    let claim = claim(&[], "\\sin(w t) = \\cos(w t)");
    let at = |w| with(&[("w", w)], &angle("w t", (3, 5), (4, 5)));
    assert_eq!(refuted(&claim, at(2)), Ok(()));
    assert_eq!(refuted(&claim, at(0)), Err(Reject::NotPrivate));
}

#[test]
fn whole_number_is_no_angle_of_choice() {
    let integer = Domain {
        integer: true,
        ..Domain::default()
    };
    let at = with(&[], &angle("x", (3, 5), (4, 5)));
    assert_eq!(
        refuted(&wrong().domain("x", integer), at),
        Err(Reject::NotPrivate)
    );
}

#[test]
fn angle_lies_in_its_domain() {
    let acute = angle("x", (3, 5), (4, 5));
    let obtuse = angle("x", (3, 5), (-4, 5));
    for (domain, calls, verdict) in [
        (positive(), &acute, Ok(())),
        (positive(), &obtuse, Ok(())),
        (between((0, 1), (8, 5)), &acute, Ok(())),
        (between((0, 1), (3, 2)), &acute, Ok(())),
        (between((0, 1), (13, 20)), &acute, Ok(())),
        (
            between((0, 1), (16, 25)),
            &acute,
            Err(Reject::OutsideDomain),
        ),
        (between((0, 1), (8, 5)), &obtuse, Err(Reject::OutsideDomain)),
        (between((1, 1), (8, 5)), &acute, Err(Reject::OutsideDomain)),
        (between((3, 2), (22, 7)), &obtuse, Ok(())),
        (between((12, 5), (5, 2)), &obtuse, Ok(())),
        (
            between((5, 2), (22, 7)),
            &obtuse,
            Err(Reject::OutsideDomain),
        ),
    ] {
        let claim = wrong().domain("x", domain.clone());
        assert_eq!(refuted(&claim, with(&[], calls)), verdict, "{domain:?}");
    }
}

#[test]
fn premise_may_bound_an_angle_by_pi() {
    let claim = |premise| claim(&[premise, "x > 0"], "\\sin(x) = \\cos(x)");
    let at = || with(&[], &angle("x", (3, 5), (4, 5)));
    assert_eq!(refuted(&claim("x < \\frac{\\pi}{2}"), at()), Ok(()));
    assert_eq!(refuted(&claim("x < \\frac{\\pi}{4}"), at()), Ok(()));
    let steeper = with(&[], &angle("x", (4, 5), (3, 5)));
    let verdict = refuted(&claim("x < \\frac{\\pi}{4}"), steeper);
    assert_eq!(verdict, Err(Reject::OutsideDomain));
}

#[test]
fn exponential_is_positive_and_on_the_side_of_its_exponent() {
    let claim = || claim(&[], "\\exp(x) = 7");
    let at = |value| with(&[], &[(Function::Exp, "x", value)]);
    let negative = Domain {
        upper: Some((ratio(0, 1), true)),
        ..Domain::default()
    };
    assert_eq!(refuted(&claim(), at(ratio(1, 2))), Ok(()));
    assert_eq!(refuted(&claim(), at(ratio(0, 1))), Err(Reject::NoSuchValue));
    assert_eq!(
        refuted(&claim(), at(ratio(-1, 2))),
        Err(Reject::NoSuchValue)
    );
    for (domain, value, verdict) in [
        (positive(), ratio(2, 1), Ok(())),
        (positive(), ratio(1, 1), Err(Reject::OutsideDomain)),
        (positive(), ratio(1, 2), Err(Reject::OutsideDomain)),
        (negative.clone(), ratio(1, 2), Ok(())),
        (negative, ratio(2, 1), Err(Reject::OutsideDomain)),
        (
            between((0, 1), (1, 1)),
            ratio(2, 1),
            Err(Reject::OutsideDomain),
        ),
        (between((-1, 1), (1, 1)), ratio(1, 1), Ok(())),
    ] {
        let claim = claim().domain("x", domain);
        assert_eq!(refuted(&claim, at(value)), verdict);
    }
}

#[test]
fn logarithm_takes_any_value_of_something_positive() {
    let claim = || claim(&[], "\\ln x = 7");
    let at = |value| with(&[], &[(Function::Ln, "x", value)]);
    assert_eq!(refuted(&claim(), at(ratio(-2, 1))), Ok(()));
    assert_eq!(
        refuted(&claim().domain("x", positive()), at(ratio(2, 1))),
        Ok(())
    );
    let above = Domain {
        lower: Some((ratio(1, 1), true)),
        ..Domain::default()
    };
    let verdict = refuted(&claim().domain("x", above.clone()), at(ratio(-2, 1)));
    assert_eq!(verdict, Err(Reject::OutsideDomain));
    assert_eq!(
        refuted(&claim().domain("x", above), at(ratio(2, 1))),
        Ok(())
    );
}

#[test]
fn product_with_a_power_of_what_is_left_open_has_the_sign_of_the_rest() {
    let claim = |premise: &str| claim(&[premise], "\\ln x = 7").domain("x", positive());
    let at = |value| with(&[], &[(Function::Ln, "x", value)]);
    assert_eq!(refuted(&claim("x^2 > 0"), at(ratio(1, 1))), Ok(()));
    assert_eq!(refuted(&claim("x^3 \\neq 0"), at(ratio(1, 1))), Ok(()));
    // The logarithm is positive above 1, and negative below.
    assert_eq!(refuted(&claim("x^2 (x - 1) > 0"), at(ratio(1, 1))), Ok(()));
    let below = at(ratio(-1, 1));
    assert_eq!(
        refuted(&claim("x^2 (x - 1) > 0"), below),
        Err(Reject::OutsideDomain)
    );
    assert_eq!(
        refuted(&claim("-x^2 > 0"), at(ratio(1, 1))),
        Err(Reject::PremiseFalse(0))
    );
    assert_eq!(
        refuted(&claim("x^2 = 4"), at(ratio(1, 1))),
        Err(Reject::NotPrivate)
    );
}

#[test]
fn functions_of_known_numbers_have_their_own_values() {
    let at = || point(&[("x", 0)]);
    assert_eq!(refuted(&claim(&[], "\\sin(x) = 1"), at()), Ok(()));
    assert_eq!(refuted(&claim(&[], "\\exp(x) = 2"), at()), Ok(()));
    assert_eq!(
        refuted(&claim(&[], "\\cos(x) = 1"), at()),
        Err(Reject::GoalNotFalse)
    );
    let one = || point(&[("x", 1)]);
    assert_eq!(refuted(&claim(&[], "\\ln x = 1"), one()), Ok(()));
    assert_eq!(
        refuted(&claim(&[], "\\sin x = 0"), one()),
        Err(Reject::NoValue)
    );
    assert_eq!(refuted(&claim(&[], "\\sin(\\pi x) = 1"), one()), Ok(()));
}

#[test]
fn pi_has_no_value_but_its_own() {
    let claim = claim(&[], "\\pi = 3");
    assert_eq!(refuted(&claim, point(&[])), Ok(()));
    let forged = point(&[("\\pi", 4)]);
    assert_eq!(refuted(&claim, forged), Err(Reject::OutsideDomain));
    let declared = claim.domain("\\pi", positive());
    assert_eq!(refuted(&declared, point(&[("\\pi", 4)])), Ok(()));
    assert_eq!(refuted(&declared, point(&[])), Err(Reject::NoValue));
}

#[test]
fn what_digits_of_pi_do_not_tell_is_rejected() {
    let below = claim(&[], "\\pi < \\frac{22}{7}");
    assert_eq!(refuted(&below, point(&[])), Err(Reject::GoalNotFalse));
    let near = "\\pi < 3.1415926535897932384650";
    assert_eq!(refuted(&claim(&[], near), point(&[])), Err(Reject::NoValue));
    let premise = claim(&["7 \\pi = 22"], "x = 1");
    let verdict = refuted(&premise, point(&[("x", 2)]));
    assert_eq!(verdict, Err(Reject::PremiseFalse(0)));
}

#[test]
fn value_may_be_a_polynomial_in_pi() {
    let claim = || claim(&["A = \\pi r^2"], "A = 2 \\pi r^2");
    let at = |r, parts: &[i64]| Assignment {
        in_pi: Map::from([(symbol("A"), parts.iter().map(|&c| number(c)).collect())]),
        ..point(&[("r", r)])
    };
    assert_eq!(refuted(&claim(), at(2, &[0, 4])), Ok(()));
    assert_eq!(
        refuted(&claim(), at(2, &[0, 3])),
        Err(Reject::PremiseFalse(0))
    );
    let negative = claim().domain("A", positive());
    assert_eq!(refuted(&negative, at(2, &[0, 4])), Ok(()));
    let declared = claim().domain("\\pi", positive());
    assert_eq!(refuted(&declared, at(2, &[0, 4])), Err(Reject::NoValue));
}

/// A claim about roots, at a point with multiples of powers of π.
fn refuted_in_pi(premise: &str, goal: &str, values: &[(&str, &[i64])]) -> Result<(), Reject> {
    let parts = |all: &[i64]| all.iter().map(|&c| number(c)).collect();
    let at = Assignment {
        in_pi: values
            .iter()
            .map(|&(name, all)| (symbol(name), parts(all)))
            .collect(),
        ..point(&[])
    };
    refuted(&claim(&[premise], goal), at)
}

#[test]
fn roots_of_multiples_of_powers_of_pi() {
    let square = |t: &[i64], c: &[i64]| {
        refuted_in_pi(
            "c = \\sqrt{4 \\pi t}",
            "c = \\sqrt{\\pi t}",
            &[("t", t), ("c", c)],
        )
    };
    assert_eq!(square(&[0, 1], &[0, 2]), Ok(()));
    assert_eq!(square(&[0, 9], &[0, 6]), Ok(()));
    assert_eq!(square(&[0, 0, 0, 1], &[0, 0, 2]), Ok(()));
    assert_eq!(square(&[0, 1], &[0, 3]), Err(Reject::PremiseFalse(0)));
    assert_eq!(square(&[0, 1], &[0, -2]), Err(Reject::PremiseFalse(0)));
    // Neither 2 π² nor π² + π is a square, nor is π.
    assert_eq!(square(&[0, 2], &[0, 2]), Err(Reject::NoValue));
    assert_eq!(square(&[1, 1], &[0, 2]), Err(Reject::NoValue));
    assert_eq!(square(&[0, 0, 1], &[0, 2]), Err(Reject::NoValue));
    assert!(square(&[0, -1], &[0, 2]).is_err());
}

#[test]
fn roots_of_quotients_and_of_higher_order() {
    let quotient = |t: &[i64], c: &[i64]| {
        let (premise, goal) = (
            "c = \\sqrt{\\frac{\\pi^4}{t}}",
            "c = 2 \\sqrt{\\frac{\\pi^4}{t}}",
        );
        refuted_in_pi(premise, goal, &[("t", t), ("c", c)])
    };
    assert_eq!(quotient(&[0, 0, 4], &[0, 1]), Err(Reject::PremiseFalse(0)));
    assert_eq!(quotient(&[0, 0, 1], &[0, 1]), Ok(()));
    assert_eq!(quotient(&[0, 1], &[0, 1]), Err(Reject::NoValue));
    assert_eq!(
        quotient(&[0, 0, 0, 0, 0, 0, 1], &[0, 1]),
        Err(Reject::NoValue)
    );
    assert_eq!(quotient(&[1, 0, 1], &[0, 1]), Err(Reject::NoValue));
    let cube = |t: &[i64], c: &[i64]| {
        let (premise, goal) = ("c = \\sqrt[3]{\\pi + t}", "c = 2 \\sqrt[3]{\\pi + t}");
        refuted_in_pi(premise, goal, &[("t", t), ("c", c)])
    };
    assert_eq!(cube(&[0, -1, 0, 8], &[0, 2]), Ok(()));
    assert_eq!(cube(&[0, -1, 8], &[0, 2]), Err(Reject::NoValue));
    // A power of such a root.
    let at: &[(&str, &[i64])] = &[("t", &[0, -1, 0, 8]), ("c", &[0, 0, 4])];
    let power = refuted_in_pi("c = (\\pi + t)^{2/3}", "c = 2 (\\pi + t)^{2/3}", at);
    assert_eq!(power, Ok(()));
}
