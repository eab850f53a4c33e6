//! Points with irrational values, and forgeries of such points.

use cradle_verify::algebra::{Atom, BigRational, Expr, Rational, Univariate};
use cradle_verify::kernel::{
    Algebraic, Assignment, Claim, Domain, Field, Problem, Reject, Standing, check_model,
};

use super::claims::*;

/// Polynomials by their coefficients, the constant one first.
const SQUARE_OF_TWO: [i64; 3] = [-2, 0, 1];

fn numbers(all: &[i64]) -> Vec<BigRational> {
    all.iter().map(|&n| number(n)).collect()
}

/// The root of a polynomial between two numbers, and values in powers of it.
fn root(polynomial: &[i64], low: i64, high: i64, values: &[(&str, &[i64])]) -> Assignment {
    let value = |&(name, value): &(&str, &[i64])| (symbol(name), numbers(value));
    Assignment {
        algebraic: Some(Box::new(Algebraic {
            polynomial: numbers(polynomial),
            low: number(low),
            high: number(high),
            symbols: values.iter().map(value).collect(),
            ..Algebraic::default()
        })),
        ..Assignment::default()
    }
}

/// The same with `x` for the root.
fn x(polynomial: &[i64], low: i64, high: i64) -> Assignment {
    root(polynomial, low, high, &[("x", &[0, 1])])
}

/// A value besides for the root that occurs in a claim.
fn with_root(mut point: Assignment, claim: &Claim, value: &[i64]) -> Assignment {
    let problem = Problem::as_written(claim, &[]).expect("a claim that can be read");
    let mut atoms = problem.atoms.iter();
    let term = atoms.find_map(|(_, atom)| match atom {
        Atom::Opaque(term @ Expr::Power(..)) => Some(term.clone()),
        _ => None,
    });
    let own = point.algebraic.as_mut().expect("a root");
    own.roots
        .insert(term.expect("a root in the claim"), numbers(value));
    point
}

fn wrong() -> Claim {
    claim(&["x^2 = 2"], "x = 1")
}

#[test]
fn irrational_root_is_a_counterexample() {
    assert_eq!(refuted(&wrong(), x(&SQUARE_OF_TWO, 1, 2)), Ok(()));
    assert_eq!(refuted(&wrong(), x(&SQUARE_OF_TWO, -2, -1)), Ok(()));
    let model = check_model(&wrong(), x(&SQUARE_OF_TWO, 1, 2));
    assert!(model.is_ok());
}

#[test]
fn root_of_another_polynomial_is_rejected() {
    let verdict = refuted(&wrong(), x(&[-3, 0, 1], 1, 2));
    assert_eq!(verdict, Err(Reject::PremiseFalse(0)));
}

#[test]
fn polynomial_with_other_roots_besides_is_as_good() {
    // (x² − 2)(x² − 3), between 5/4 and 3/2 and between 3/2 and 2
    let both = [6, 0, -5, 0, 1];
    let between = |low, high| {
        let mut point = x(&both, 0, 0);
        let own = point.algebraic.as_mut().expect("a root");
        (own.low, own.high) = (low, high);
        point
    };
    let first = between(ratio(5, 4), ratio(3, 2));
    assert_eq!(refuted(&wrong(), first), Ok(()));
    let second = between(ratio(3, 2), ratio(2, 1));
    assert_eq!(refuted(&wrong(), second), Err(Reject::PremiseFalse(0)));
}

#[test]
fn interval_without_a_root_is_rejected() {
    for (low, high) in [(2, 3), (0, 1), (2, 1), (1, 1)] {
        let verdict = refuted(&wrong(), x(&SQUARE_OF_TWO, low, high));
        assert_eq!(verdict, Err(Reject::NotIsolated(0)));
    }
    // No real root at all, and no polynomial.
    for polynomial in [&[1, 0, 1][..], &[2], &[], &[0]] {
        let verdict = refuted(&wrong(), x(polynomial, -9, 9));
        assert_eq!(verdict, Err(Reject::NotIsolated(0)));
    }
}

#[test]
fn interval_with_two_roots_is_rejected() {
    let verdict = refuted(&wrong(), x(&SQUARE_OF_TWO, -2, 2));
    assert_eq!(verdict, Err(Reject::NotIsolated(2)));
    // The signs at the ends are those of one root: (x² − 2)(x − 5)(x − 6)(x − 7)
    let three = x(&[420, -214, -174, 105, -18, 1], 4, 8);
    assert_eq!(refuted(&wrong(), three), Err(Reject::NotIsolated(3)));
}

#[test]
fn root_at_an_end_is_rejected() {
    for (low, high) in [(1, 3), (-1, 1)] {
        let verdict = refuted(&wrong(), x(&[-1, 0, 1], low, high));
        assert_eq!(verdict, Err(Reject::RootAtEnd));
    }
}

#[test]
fn root_that_occurs_twice_is_rejected() {
    // (x² − 2)²; and (x − 5)² (x² − 2), the double root elsewhere
    for polynomial in [&[4, 0, -4, 0, 1][..], &[-50, 20, 23, -10, 1]] {
        let verdict = refuted(&wrong(), x(polynomial, 1, 2));
        assert_eq!(verdict, Err(Reject::NotSquarefree));
    }
}

#[test]
fn high_degrees_and_long_numbers_are_refused() {
    let mut high = vec![0; 14];
    (high[0], high[13]) = (-2, 1);
    let verdict = refuted(&wrong(), x(&high, 1, 2));
    assert_eq!(verdict, Err(Reject::TooLarge));
    let mut long = x(&SQUARE_OF_TWO, 1, 2);
    let own = long.algebraic.as_mut().expect("a root");
    own.high = num_traits::Pow::pow(number(2), 300_u32);
    assert_eq!(refuted(&wrong(), long), Err(Reject::TooLarge));
    let powers = root(&SQUARE_OF_TWO, 1, 2, &[("x", &[1; 15])]);
    assert_eq!(refuted(&wrong(), powers), Err(Reject::TooLarge));
    let huge = claim(&[], "x^{5000} = 1");
    let verdict = refuted(&huge, x(&SQUARE_OF_TWO, 1, 2));
    assert_eq!(verdict, Err(Reject::TooLarge));
    let far = claim(&[], "x^{4096} = 1");
    let verdict = refuted(&far, x(&[-3, 0, 1], 1, 2));
    assert_eq!(verdict, Err(Reject::TooLarge));
}

#[test]
fn zero_in_disguise_is_zero() {
    // y = x⁴ − 5 x² + 6 vanishes at √2, though not at every root of (x² − 2)(x² − 7).
    let both = [14, 0, -9, 0, 1];
    let values: [(&str, &[i64]); 2] = [("x", &[0, 1]), ("y", &[6, 0, -5, 0, 1])];
    let point = || root(&both, 1, 2, &values);
    for (goal, verdict) in [
        ("y = 0", Err(Reject::GoalNotFalse)),
        (r"y \neq 0", Ok(())),
        ("y > 0", Ok(())),
        (r"y \ge 0", Err(Reject::GoalNotFalse)),
        (r"\frac{1}{y} = 1", Err(Reject::GoalNotFalse)),
        (r"\frac{y}{y} = 2", Err(Reject::GoalNotFalse)),
    ] {
        assert_eq!(refuted(&claim(&[], goal), point()), verdict, "{goal}");
    }
    // At √7 it does not vanish.
    let other = root(&both, 2, 3, &values);
    assert_eq!(refuted(&claim(&[], "y = 0"), other), Ok(()));
}

#[test]
fn nothing_is_divided_by_what_vanishes_at_the_root() {
    let premise = claim(&[r"\frac{1}{x^2 - 2} = y"], "y = 1");
    let point = root(
        &[14, 0, -9, 0, 1],
        1,
        2,
        &[("x", &[0, 1]), ("y", &[7, 0, 3])],
    );
    assert_eq!(refuted(&premise, point), Err(Reject::PremiseFalse(0)));
}

#[test]
fn signs_are_told_however_close() {
    // √2 lies between 1.414213562373 and 1.414213562374.
    for (goal, verdict) in [
        ("x > 1.414213562373", Err(Reject::GoalNotFalse)),
        ("x < 1.414213562373", Ok(())),
        ("x > 1.414213562374", Ok(())),
        (r"x \le 1.414213562374", Err(Reject::GoalNotFalse)),
        (r"x^2 \le 2", Err(Reject::GoalNotFalse)),
        ("x^2 < 2", Ok(())),
        (r"2 - x^2 \neq 0", Ok(())),
    ] {
        let verdict_found = refuted(&claim(&[], goal), x(&SQUARE_OF_TWO, 1, 2));
        assert_eq!(verdict_found, verdict, "{goal}");
    }
}

#[test]
fn irrational_value_lies_in_its_domain() {
    let between = |low: (i64, i64), high: (i64, i64)| Domain {
        lower: Some((ratio(low.0, low.1), true)),
        upper: Some((ratio(high.0, high.1), true)),
        ..Domain::default()
    };
    let integer = Domain {
        integer: true,
        ..Domain::default()
    };
    let nonzero = Domain {
        nonzero: true,
        ..Domain::default()
    };
    for (domain, value, inside) in [
        (positive(), &[0, 1][..], true),
        (positive(), &[0, -1], false),
        (between((7, 5), (3, 2)), &[0, 1], true),
        (between((3, 2), (2, 1)), &[0, 1], false),
        (integer.clone(), &[0, 1], false),
        // A whole number that is not written as one is not taken for one.
        (integer, &[0, 0, 1], false),
        (nonzero.clone(), &[0, 1], true),
        (nonzero, &[-2, 0, 1], false),
    ] {
        let claim = claim(&[], "x = 17").domain("x", domain.clone());
        let found = refuted(&claim, root(&SQUARE_OF_TWO, 1, 2, &[("x", value)]));
        let expected = if inside {
            Ok(())
        } else {
            Err(Reject::OutsideDomain)
        };
        assert_eq!(found, expected, "{domain:?} {value:?}");
    }
}

#[test]
fn symbol_has_one_value() {
    let mut twice = x(&SQUARE_OF_TWO, 1, 2);
    twice.symbols.insert(symbol("x"), number(1));
    assert_eq!(refuted(&wrong(), twice), Err(Reject::NoValue));
}

#[test]
fn pi_is_no_root() {
    let claim = claim(&[], r"\pi = 3");
    let forged = root(&SQUARE_OF_TWO, 1, 2, &[(r"\pi", &[0, 1])]);
    assert_eq!(refuted(&claim, forged), Err(Reject::NoValue));
    let besides = x(&SQUARE_OF_TWO, 1, 2);
    assert_eq!(refuted(&claim, besides), Err(Reject::NoValue));
}

#[test]
fn root_and_multiples_of_pi_are_not_mixed() {
    let mut mixed = x(&SQUARE_OF_TWO, 1, 2);
    mixed.in_pi.insert(symbol("y"), numbers(&[0, 1]));
    let claim = claim(&["x^2 = 2"], r"y = \pi + 1");
    assert_eq!(refuted(&claim, mixed), Err(Reject::NoValue));
}

#[test]
fn symbol_without_a_value_is_rejected() {
    let claim = claim(&["x^2 = 2"], "x = y");
    let verdict = refuted(&claim, x(&SQUARE_OF_TWO, 1, 2));
    assert_eq!(verdict, Err(Reject::NoValue));
}

#[test]
fn root_of_an_irrational_value_is_checked() {
    let goal = claim(&["x^2 = 2"], r"x = -\sqrt{2}");
    let point = |value: &[i64]| with_root(x(&SQUARE_OF_TWO, 1, 2), &goal, value);
    assert_eq!(refuted(&goal, point(&[0, 1])), Ok(()));
    for forged in [&[0, -1][..], &[0, 2], &[1], &[]] {
        let verdict = refuted(&goal, point(forged));
        assert_eq!(verdict, Err(Reject::NoSuchValue), "{forged:?}");
    }
    let verdict = refuted(&goal, x(&SQUARE_OF_TWO, 1, 2));
    assert_eq!(verdict, Err(Reject::NoValue));
    let same = claim(&["x^2 = 2"], r"x = \sqrt{2}");
    let verdict = refuted(&same, point(&[0, 1]));
    assert_eq!(verdict, Err(Reject::GoalNotFalse));
    // √(y) with y = 6 − 4 √2 = (2 − √2)²
    let inner = claim(&[], r"\sqrt{y} = x");
    let values: [(&str, &[i64]); 2] = [("x", &[0, 1]), ("y", &[6, -4])];
    let nested = |value: &[i64]| with_root(root(&SQUARE_OF_TWO, 1, 2, &values), &inner, value);
    assert_eq!(refuted(&inner, nested(&[2, -1])), Ok(()));
    let verdict = refuted(&inner, nested(&[-2, 1]));
    assert_eq!(verdict, Err(Reject::NoSuchValue));
}

#[test]
fn negative_numbers_have_no_roots() {
    // (−√2)³ = −2 √2, but of a negative number no root is taken.
    let cube = claim(&[], "(0 - 2 x)^{1/3} = 7");
    let point = with_root(x(&SQUARE_OF_TWO, 1, 2), &cube, &[0, -1]);
    assert_eq!(refuted(&cube, point), Err(Reject::NoValue));
    let square = claim(&[], r"\sqrt{1 - x} = 7");
    let point = with_root(x(&SQUARE_OF_TWO, 1, 2), &square, &[0, 1]);
    assert_eq!(refuted(&square, point), Err(Reject::GoalNotFalse));
}

#[test]
fn absolute_value_of_an_irrational_number_is_taken() {
    let point = || root(&SQUARE_OF_TWO, 1, 2, &[("x", &[0, -1])]);
    assert_eq!(refuted(&claim(&["x^2 = 2"], "|x| = x"), point()), Ok(()));
    let verdict = refuted(&claim(&["x^2 = 2"], "|x| = -x"), point());
    assert_eq!(verdict, Err(Reject::GoalNotFalse));
    let verdict = refuted(
        &claim(&["x^2 = 2"], r"|\frac{x}{2}| = -\frac{x}{2}"),
        point(),
    );
    assert_eq!(verdict, Err(Reject::GoalNotFalse));
}

#[test]
fn rounding_needs_a_rational_value() {
    let claim = claim(&["x^2 = 2"], r"\lceil x \rceil = 3");
    let verdict = refuted(&claim, x(&SQUARE_OF_TWO, 1, 2));
    assert_eq!(verdict, Err(Reject::NoValue));
}

#[test]
fn premise_at_the_point_alone_is_one_too() {
    let mut claim = wrong();
    claim = claim.at_point(0);
    assert_eq!(claim.hypotheses[0].standing, Standing::AtPoint);
    assert_eq!(refuted(&claim, x(&SQUARE_OF_TWO, 1, 2)), Ok(()));
}

#[test]
fn field_agrees_with_its_own_arithmetic() {
    let rational = |all: &[i32]| Univariate::new(all.iter().map(|&n| Rational::from(n)));
    let field = Field::new(rational(&[-2, 0, 0, 1]), 1.into(), 2.into()).expect("∛2");
    let root = Univariate::unknown();
    assert_eq!(field.power(&root, 3), Ok(rational(&[2])));
    assert_eq!(field.power(&root, 0), Ok(rational(&[1])));
    assert_eq!(field.power(&root, 4), Ok(rational(&[0, 2])));
    assert_eq!(
        field.times(&root, &rational(&[0, 0, 1])),
        Ok(rational(&[2]))
    );
    // 5/4 < ∛2 < 4/3
    let above = |n, d| field.sign(&root.minus(&Univariate::constant(Rational::ratio(n, d))));
    assert!(above(5, 4).is_gt() && above(4, 3).is_lt());
    assert!(field.sign(&Univariate::default()).is_eq());
}

#[test]
fn multiples_of_pi_are_compared_in_the_field() {
    let two = |claim: &Claim| refuted(claim, x(&SQUARE_OF_TWO, 1, 2));
    assert_eq!(two(&claim(&["x^2 = 2"], r"\pi x = \pi")), Ok(()));
    assert_eq!(two(&claim(&["x^2 = 2"], r"\pi^2 x = 2 \pi^2")), Ok(()));
    // Both summands are positive.
    assert_eq!(two(&claim(&["x^2 = 2"], r"\pi x + x = 0")), Ok(()));
    assert_eq!(two(&claim(&["x^2 = 2"], r"\pi x + x \leq 0")), Ok(()));
}

#[test]
fn what_pi_multiplies_to_nought_is_nought() {
    let two = |claim: &Claim| refuted(claim, x(&SQUARE_OF_TWO, 1, 2));
    let true_there = claim(&["x^2 = 2"], r"\pi x^2 = 2 \pi");
    assert_eq!(two(&true_there), Err(Reject::GoalNotFalse));
    let both = claim(&["x^2 = 2"], r"\pi x^2 - x^2 = 2 \pi - 2");
    assert_eq!(two(&both), Err(Reject::GoalNotFalse));
    let premise = claim(&[r"\pi x = \pi"], "x = 1");
    assert_eq!(two(&premise), Err(Reject::PremiseFalse(0)));
}

#[test]
fn digits_of_pi_are_not_asked_for_in_a_field() {
    let two = |claim: &Claim| refuted(claim, x(&SQUARE_OF_TWO, 1, 2));
    for goal in [
        r"\pi = 2 x",
        r"\pi x = 4",
        r"\pi < 3 x",
        r"\pi^2 x + x = 5 \pi",
    ] {
        let verdict = two(&claim(&["x^2 = 2"], goal));
        assert_eq!(verdict, Err(Reject::NoValue), "{goal}");
    }
}

#[test]
fn pi_that_is_declared_is_no_number_in_a_field() {
    let declared = claim(&["x^2 = 2"], r"\pi x = \pi").domain(r"\pi", Domain::default());
    let verdict = refuted(&declared, x(&SQUARE_OF_TWO, 1, 2));
    assert_eq!(verdict, Err(Reject::NoValue));
}

/// `\sqrt2 \sin x = y` at an angle of choice: its sine is a rational number, the root is none.
fn swinging() -> (Claim, Assignment) {
    let claim = claim(&[], "2^{1/2} \\sin x = y");
    let mut point = root(&SQUARE_OF_TWO, 1, 2, &[]);
    point.symbols.insert(symbol("y"), number(1));
    for (function, value) in [("\\sin x", ratio(3, 5)), ("\\cos x", ratio(4, 5))] {
        point.functions.insert(term(function), value);
    }
    let point = with_root(point, &claim, &[0, 1]);
    (claim, point)
}

#[test]
fn root_and_angle_of_choice_are_looked_at_together() {
    let (claim, point) = swinging();
    assert_eq!(refuted(&claim, point.clone()), Ok(()));
    let mut true_there = point;
    let sine = term("\\sin x");
    let own = true_there.algebraic.as_mut().expect("a root");
    own.symbols
        .insert(symbol("y"), vec![number(0), ratio(3, 5)]);
    true_there.symbols.clear();
    assert_eq!(
        refuted(&claim, true_there.clone()),
        Err(Reject::GoalNotFalse)
    );
    true_there.functions.insert(sine, ratio(4, 5));
    assert_eq!(refuted(&claim, true_there), Err(Reject::NoSuchValue));
}

#[test]
fn angle_with_an_irrational_value_is_none_of_choice() {
    let (claim, mut point) = swinging();
    let own = point.algebraic.as_mut().expect("a root");
    own.symbols.insert(symbol("x"), numbers(&[0, 1]));
    assert_eq!(refuted(&claim, point), Err(Reject::NotPrivate));
}

#[test]
fn bounds_on_an_angle_of_choice_are_met_beside_a_root() {
    let (_, point) = swinging();
    let bounded = |bound: &str| {
        let claim = claim(&[bound], "2^{1/2} \\sin x = y");
        refuted(&claim, point.clone())
    };
    // Some angle with that sine and cosine is greater than 7, and none lies between 1 and 2.
    assert_eq!(bounded("x > 7"), Ok(()));
    let claim = claim(&["x > 1", "x < 2"], "2^{1/2} \\sin x = y");
    assert_eq!(refuted(&claim, point.clone()), Err(Reject::OutsideDomain));
}

#[test]
fn root_and_constant_function_are_not_looked_at_together() {
    let claim = claim(&["f(0) = 1"], "2^{1/2} = y");
    let mut point = root(&SQUARE_OF_TWO, 1, 2, &[]);
    point.symbols.insert(symbol("y"), number(1));
    point.functions.insert(term("f(0)"), number(1));
    let point = with_root(point, &claim, &[0, 1]);
    assert_eq!(refuted(&claim, point), Err(Reject::NoValue));
}
