//! Points through which something moves, and points through which nothing can.

use cradle_verify::kernel::{Assignment, Claim, Course, Domain, Reject};
use cradle_verify::sorted::Map;

use super::claims::*;

const SECOND: &str = r"\frac{d^2 x}{dt^2}";
const SLOPE: &str = r"\frac{dx}{dt}";

/// A point with what each law leads, and the second derivative of `x`.
fn moving(at: Assignment, second: Option<i64>, leads: &[(usize, &str)]) -> Assignment {
    let second = second.map(|value| ((symbol("x"), symbol("t")), vec![number(value)]));
    Assignment {
        course: Some(Course {
            higher: second.into_iter().collect(),
            leads: leads.iter().map(|&(law, t)| (law, term(t))).collect(),
        }),
        ..at
    }
}

/// `x`, and its slope.
fn at(value: i64, slope: i64) -> Assignment {
    point(&[("x", value)]).slope("x", "t", slope)
}

fn oscillator() -> Claim {
    claim(&[r"\frac{d^2 x}{dt^2} = -x"], r"\frac{d^2 x}{dt^2} = x")
}

#[test]
fn law_of_motion_has_a_solution_through_each_point() {
    for (value, slope) in [(1, 0), (1, 5), (-2, 3)] {
        let point = moving(at(value, slope), Some(-value), &[(0, SECOND)]);
        assert_eq!(refuted(&oscillator(), point), Ok(()));
    }
    let point = moving(at(0, 1), Some(0), &[(0, SECOND)]);
    assert_eq!(refuted(&oscillator(), point), Err(Reject::GoalNotFalse));
    let point = moving(at(1, 0), Some(1), &[(0, SECOND)]);
    assert_eq!(refuted(&oscillator(), point), Err(Reject::PremiseFalse(0)));
    let point = moving(at(1, 0), None, &[(0, SECOND)]);
    assert_eq!(refuted(&oscillator(), point), Err(Reject::NoValue));
}

#[test]
fn law_without_an_unknown_of_its_own_is_rejected() {
    for leads in [
        &[][..],
        &[(0, "x")],
        &[(0, "t")],
        &[(0, SLOPE)],
        &[(0, "x^2")],
    ] {
        let point = moving(at(1, 0), Some(-1), leads);
        assert_eq!(
            refuted(&oscillator(), point),
            Err(Reject::NoCourse),
            "{leads:?}"
        );
    }
}

#[test]
fn what_a_law_holds_still_does_not_move() {
    for (law, goal) in [
        ("x = 3", r"\frac{dx}{dt} = 0"),
        ("x^2 = 9", r"\frac{dx}{dt} = 0"),
        ("x = 2 + t", r"\frac{dx}{dt} = 1"),
    ] {
        for leads in [&[][..], &[(0, SLOPE)], &[(0, "x")], &[(0, "t")]] {
            let point = point(&[("x", 3), ("t", 1)]).slope("x", "t", 7);
            let verdict = refuted(&claim(&[law], goal), moving(point, None, leads));
            assert_eq!(verdict, Err(Reject::NoCourse), "{law}: {leads:?}");
        }
    }
}

#[test]
fn laws_that_say_the_same_of_one_unknown_are_no_two() {
    let circle = claim(&["x^2 + y^2 = 1"], r"x \frac{dx}{dt} + y \frac{dy}{dt} = 0");
    let at = point(&[("x", 1), ("y", 0)]);
    let at = at.slope("x", "t", 1).slope("y", "t", 0);
    for leads in [&[][..], &[(0, SLOPE)], &[(0, r"\frac{dy}{dt}")]] {
        let verdict = refuted(&circle, moving(at.clone(), None, leads));
        assert_eq!(verdict, Err(Reject::NoCourse));
    }
    let twice = claim(&[r"\frac{dx}{dt} = a", r"\frac{dx}{dt} = b"], "a = 2");
    let at = point(&[("a", 1), ("b", 1)]).slope("x", "t", 1);
    let both = moving(at.clone(), None, &[(0, SLOPE), (1, SLOPE)]);
    assert_eq!(refuted(&twice, both), Err(Reject::NoCourse));
    let apart = moving(at, None, &[(0, SLOPE), (1, "b")]);
    assert_eq!(refuted(&twice, apart), Ok(()));
    // Two rows of the matrix are alike.
    let alike = claim(
        &[r"\frac{dx}{dt} + b = 2", r"\frac{dx}{dt} + b = 2"],
        "b = 2",
    );
    let at = point(&[("b", 1)]).slope("x", "t", 1);
    let point = moving(at, None, &[(0, SLOPE), (1, "b")]);
    assert_eq!(refuted(&alike, point), Err(Reject::NoCourse));
}

#[test]
fn bound_is_kept_around_the_point() {
    let bounded = claim(&[r"x \geq 0"], r"\frac{dx}{dt} \geq 0");
    assert_eq!(refuted(&bounded, moving(at(1, -1), None, &[])), Ok(()));
    let edge = refuted(&bounded, moving(at(0, -1), None, &[]));
    assert_eq!(edge, Err(Reject::NoCourse));
    let nonnegative = Domain {
        lower: Some((number(0), false)),
        ..Domain::default()
    };
    let declared = claim(&[], r"\frac{dx}{dt} \geq 0").domain("x", nonnegative);
    let edge = refuted(&declared, moving(at(0, -1), None, &[]));
    assert_eq!(edge, Err(Reject::NoCourse));
}

#[test]
fn what_is_said_of_the_point_alone_holds_nothing_still() {
    let claim = claim(&["x = 3"], r"\frac{dx}{dt} = 0").at_point(0);
    assert_eq!(refuted(&claim, moving(at(3, 7), None, &[])), Ok(()));
}

#[test]
fn numbers_and_what_is_not_followed_do_not_move() {
    let whole = Domain {
        integer: true,
        ..Domain::default()
    };
    let goal = || claim(&[], r"\frac{dx}{dt} = 0");
    assert_eq!(
        refuted(&goal().domain("x", whole), moving(at(3, 7), None, &[])),
        Err(Reject::NoCourse)
    );
    for law in [r"y = |x|", r"y = \sin(x)", r"y = \int_0^1 x s \, ds"] {
        let mut point = moving(at(1, 7), None, &[(0, "y")]);
        point.symbols.insert(symbol("y"), number(1));
        let verdict = refuted(&claim(&[law], r"\frac{dx}{dt} = 0"), point);
        assert!(verdict.is_err(), "{law}");
    }
    // Two variables are none.
    let two = claim(&[], r"\frac{dx}{dt} = \frac{dx}{ds}");
    let point = at(1, 1).slope("x", "s", 2);
    assert_eq!(
        refuted(&two, moving(point, None, &[])),
        Err(Reject::NoCourse)
    );
    // Neither are derivatives of what is constant, or none at all.
    let nothing = claim(&[], "x = 1");
    let point = moving(point_of(2), None, &[]);
    assert_eq!(refuted(&nothing, point), Err(Reject::NoCourse));
}

fn point_of(value: i64) -> Assignment {
    Assignment {
        symbols: Map::from([(symbol("x"), number(value))]),
        ..Assignment::default()
    }
}

const FALL: &str = r"\frac{dy}{dx}";

/// A point of two symbols, with a slope and what each law leads.
fn sloping(x: i64, y: i64, slope: (i64, i64), leads: &[(usize, &str)]) -> Assignment {
    let mut at = point(&[("x", x), ("y", y)]);
    let key = (symbol("y"), symbol("x"));
    at.derivatives.insert(key, ratio(slope.0, slope.1));
    moving(at, None, leads)
}

#[test]
fn law_is_kept_where_its_slope_vanishes_all_along() {
    let hyperbola = claim(&["x y = 6"], r"\frac{dy}{dx} = \frac{y}{x}");
    let leads = [(0, FALL)];
    // y + x dy/dx = 0
    let verdict = refuted(&hyperbola, sloping(2, 3, (-3, 2), &leads));
    assert_eq!(verdict, Ok(()));
    for slope in [(1, 1), (3, 2), (0, 1)] {
        let verdict = refuted(&hyperbola, sloping(2, 3, slope, &leads));
        assert_eq!(verdict, Err(Reject::NoCourse), "{slope:?}");
    }
    // The slope alone is not enough: the law is to be true, too.
    let verdict = refuted(&hyperbola, sloping(2, 5, (-5, 2), &leads));
    assert_eq!(verdict, Err(Reject::PremiseFalse(0)));
    let right = claim(&["x y = 6"], r"\frac{dy}{dx} = -\frac{y}{x}");
    let verdict = refuted(&right, sloping(2, 3, (-3, 2), &leads));
    assert_eq!(verdict, Err(Reject::GoalNotFalse));
}

#[test]
fn law_that_tells_no_slope_lets_none_be_chosen() {
    // At the cusp of `y^2 = x^3`, and where the circle is upright.
    let cusp = claim(&["y^2 = x^3"], r"\frac{dy}{dx} = 0");
    let verdict = refuted(&cusp, sloping(0, 0, (1, 1), &[(0, FALL)]));
    assert_eq!(verdict, Err(Reject::NoCourse));
    let circle = claim(&["x^2 + y^2 = 25"], r"\frac{dy}{dx} = 0");
    let verdict = refuted(&circle, sloping(5, 0, (1, 1), &[(0, FALL)]));
    assert_eq!(verdict, Err(Reject::NoCourse));
    // Two laws tell one slope, and not both of them lead it.
    let two = claim(&["x y = 6", "x + y = 5"], r"\frac{dy}{dx} = 0");
    for leads in [&[(0, FALL)][..], &[(0, FALL), (1, FALL)]] {
        let verdict = refuted(&two, sloping(2, 3, (-3, 2), leads));
        assert_eq!(verdict, Err(Reject::NoCourse), "{leads:?}");
    }
}

#[test]
fn slope_of_what_another_law_moves_is_to_be_known() {
    let claim = claim(&["x y = c", "c = 3 x"], r"\frac{dy}{dx} = 1");
    let mut at = sloping(2, 3, (-3, 2), &[(0, FALL), (1, "c")]);
    at.symbols.insert(symbol("c"), number(6));
    assert_eq!(refuted(&claim, at), Err(Reject::NoCourse));
    // Nor is one of higher order told by the law itself.
    let twice = super::claims::claim(&["x y = 6"], r"\frac{d^2 y}{dx^2} = 0");
    let mut at = sloping(2, 3, (-3, 2), &[(0, r"\frac{d^2 y}{dx^2}")]);
    if let Some(course) = &mut at.course {
        let key = (symbol("y"), symbol("x"));
        course.higher.insert(key, vec![number(7)]);
    }
    assert_eq!(refuted(&twice, at), Err(Reject::NoCourse));
}

#[test]
fn law_with_a_power_of_pi_throughout_has_a_solution() {
    let law = |law: &str| claim(&[law], r"\frac{dx}{dt} = x");
    let at = moving(at(1, -1), None, &[(0, SLOPE)]);
    assert_eq!(refuted(&law(r"\pi^2 \frac{dx}{dt} = -\pi^2 x"), at), Ok(()));
}

#[test]
fn laws_with_a_power_of_pi_that_say_the_same_are_no_two() {
    let laws = |second: &str| {
        claim(
            &[r"\pi \frac{dx}{dt} + \pi \frac{dy}{dt} = 0", second],
            r"\frac{dx}{dt} = 1",
        )
    };
    let slope = |name: &str| format!(r"\frac{{d{name}}}{{dt}}");
    let (first, second) = (slope("x"), slope("y"));
    let at = || {
        let at = point(&[("x", 1), ("y", 1)]);
        let at = at.slope("x", "t", 0).slope("y", "t", 0);
        moving(at, None, &[(0, &first), (1, &second)])
    };
    let same = laws(r"\frac{dx}{dt} + \frac{dy}{dt} = 0");
    assert_eq!(refuted(&same, at()), Err(Reject::NoCourse));
    let other = laws(r"\frac{dx}{dt} - \frac{dy}{dt} = 0");
    assert_eq!(refuted(&other, at()), Ok(()));
    // What is multiplied by different powers of π is not looked at.
    let mixed = laws(r"\pi \frac{dx}{dt} - \frac{dy}{dt} = 0");
    assert_eq!(refuted(&mixed, at()), Err(Reject::NoValue));
}

#[test]
fn sums_of_powers_of_pi_are_not_taken_for_one() {
    let law = r"\pi \frac{dx}{dt} + \frac{dx}{dt} = -\pi x - x";
    let sum = claim(&[law], r"\frac{dx}{dt} = x");
    let at = moving(at(1, -1), None, &[(0, SLOPE)]);
    assert_eq!(refuted(&sum, at), Err(Reject::NoValue));
}

#[test]
fn roots_and_functions_follow_what_moves() {
    let root = claim(
        &[r"\frac{dx}{dt} = -x"],
        r"\frac{d}{dt} \sqrt{x} = \sqrt{x}",
    );
    let leads = [(0, SLOPE)];
    assert_eq!(refuted(&root, moving(at(4, -4), None, &leads)), Ok(()));
    let right = claim(
        &[r"\frac{dx}{dt} = -x"],
        r"\frac{d}{dt} \sqrt{x} = -\frac{1}{2} \sqrt{x}",
    );
    let verdict = refuted(&right, moving(at(4, -4), None, &leads));
    assert_eq!(verdict, Err(Reject::GoalNotFalse));
    let logarithm = claim(&[r"\frac{dx}{dt} = -x"], r"\frac{d}{dt} \ln x = 1");
    assert_eq!(refuted(&logarithm, moving(at(1, -1), None, &leads)), Ok(()));
    // What leads a law may be followed in it: `y = \sqrt x` lets `x` move.
    let led = claim(&[r"y = \sqrt{x}"], r"\frac{dx}{dt} = 0");
    let mut point = moving(at(4, 7), None, &[(0, "y")]);
    point.symbols.insert(symbol("y"), number(2));
    assert_eq!(refuted(&led, point), Ok(()));
}

#[test]
fn a_root_of_nothing_is_not_followed() {
    let root = claim(&[r"\frac{dx}{dt} = \sqrt{x} - 1"], r"\frac{dx}{dt} = 0");
    let leads = [(0, SLOPE)];
    assert_eq!(refuted(&root, moving(at(4, 1), None, &leads)), Ok(()));
    let verdict = refuted(&root, moving(at(0, -1), None, &leads));
    assert_eq!(verdict, Err(Reject::NoCourse));
}

/// `\sqrt x + x = 2` holds `x` still, and so do two laws of which one is the other's square: a matrix that took a root for an unknown of its own
/// would be regular.
#[test]
fn laws_are_differentiated_through_roots() {
    let leads = |laws: &[(usize, &str)], slope: i64| {
        let at = point(&[("x", 1), ("y", 1)]).slope("x", "t", slope);
        moving(at.slope("y", "t", slope), None, laws)
    };
    let (x, y) = (SLOPE, r"\frac{dy}{dt}");
    let goal = r"\frac{dx}{dt} + \frac{dy}{dt} = 0";
    for laws in [
        [r"\sqrt{x} = y", r"x = y^2"],
        [r"\sqrt{x} + x = y + y^2", r"x = y^2"],
        [r"x^{\frac{3}{2}} = y^3", r"x = y^2"],
    ] {
        let claim = claim(&laws, goal);
        for own in [&[(0, x), (1, y)][..], &[(0, y), (1, x)]] {
            let verdict = refuted(&claim, leads(own, 1));
            assert_eq!(verdict, Err(Reject::NoCourse), "{laws:?}");
        }
    }
    // `u` and `w` are two unknowns, but the laws are one: `\sqrt u = w` and `u = w^2` leave both open, and say nothing twice.
    let twice = claim(&[r"\sqrt{u} = w", "u = w^2"], r"\frac{dx}{dt} = 0");
    let at = point(&[("x", 1), ("u", 4), ("w", 2)]).slope("x", "t", 1);
    assert_eq!(refuted(&twice, moving(at, None, &[])), Ok(()));
    // With `x` in both, `u` and `w` are led by them: through the root the rows of the matrix are multiples of each other.
    let tied = claim(
        &[r"\sqrt{u} + x = w", r"u + 2 x w - x^2 = w^2"],
        r"\frac{dx}{dt} = 0",
    );
    let at = point(&[("x", 1), ("u", 4), ("w", 3)]).slope("x", "t", 1);
    let both = moving(at.clone(), None, &[(0, "u"), (1, "w")]);
    assert_eq!(refuted(&tied, both), Err(Reject::NoCourse));
    let both = moving(at, None, &[(0, "w"), (1, "u")]);
    assert_eq!(refuted(&tied, both), Err(Reject::NoCourse));
}

#[test]
fn laws_are_differentiated_through_exponentials_and_logarithms() {
    // At x = y = 0 the exponential of y and y + 1 have the same slope: the first two rows are alike.
    let goal = r"\frac{dx}{dt} = 0";
    let at = || point(&[("x", 0), ("y", 0), ("z", 1)]).slope("x", "t", 1);
    let alike = claim(&[r"z = \exp(y) + x", r"z = 1 + y + x"], goal);
    for leads in [[(0, "y"), (1, "z")], [(0, "z"), (1, "y")]] {
        let verdict = refuted(&alike, moving(at(), None, &leads));
        assert_eq!(verdict, Err(Reject::NoCourse));
    }
    let other = claim(&[r"z = \exp(y) + x", r"z = 1 + 2 y + x"], goal);
    let verdict = refuted(&other, moving(at(), None, &[(0, "z"), (1, "y")]));
    assert_eq!(verdict, Ok(()));
    let at = || point(&[("x", 0), ("y", 1), ("z", 0)]).slope("x", "t", 1);
    let alike = claim(&[r"z = \ln y + x", r"z = y - 1 + x"], goal);
    let verdict = refuted(&alike, moving(at(), None, &[(0, "z"), (1, "y")]));
    assert_eq!(verdict, Err(Reject::NoCourse));
    let other = claim(&[r"z = 2 \ln y + x", r"z = y - 1 + x"], goal);
    let verdict = refuted(&other, moving(at(), None, &[(0, "z"), (1, "y")]));
    assert_eq!(verdict, Ok(()));
}

#[test]
fn what_is_within_a_root_is_looked_at_too() {
    let goal = r"\frac{dx}{dt} = 0";
    for within in [r"\sqrt{1 + |x - 1|}", r"\sqrt{2 + \sin(x - 1)}"] {
        let law = format!("y = {within}");
        let mut point = moving(at(1, 7), None, &[(0, "y")]);
        point.symbols.insert(symbol("y"), number(1));
        let verdict = refuted(&claim(&[&law], goal), point);
        assert!(verdict.is_err(), "{law}");
    }
    // A root of a root is one.
    let mut point = moving(at(16, 7), None, &[(0, "y")]);
    point.symbols.insert(symbol("y"), number(2));
    assert_eq!(
        refuted(&claim(&[r"y = \sqrt{\sqrt{x}}"], goal), point),
        Ok(())
    );
}
