//! Points at which unknown functions are constant, and forgeries of such points.

use cradle_verify::kernel::{Assignment, Claim, Domain, Reject};

use super::claims::*;

/// A point at which functions are constant.
fn with(symbols: &[(&str, i64)], functions: &[(&str, i64)]) -> Assignment {
    let constant = |&(applied, value): &(&str, i64)| (term(applied), number(value));
    Assignment {
        functions: functions.iter().map(constant).collect(),
        ..point(symbols)
    }
}

/// What is said of `x(t)` where it is 0, beside the law `y = 2 B`.
fn begins_at(premises: &[&str], goal: &str) -> Claim {
    let all: Vec<&str> = [r"\lim_{t \to 0} x(t) = a", "y = 2 B"]
        .into_iter()
        .chain(premises.iter().copied())
        .collect();
    claim(&all, goal).domain("a", constant())
}

#[test]
fn functions_of_which_nothing_else_is_said_may_be_constant() {
    let at = with(&[("a", 3), ("B", 1), ("y", 2)], &[("x(t)", 3)]);
    let judged = |premises: &[&str], goal| refuted(&begins_at(premises, goal), at.clone());
    assert_eq!(judged(&[], "y = B"), Ok(()));
    assert_eq!(judged(&[], "y = 2 B"), Err(Reject::GoalNotFalse));
    assert_eq!(judged(&[r"x(t) \geq 0"], "y = B"), Ok(()));
    assert_eq!(judged(&[r"\frac{d}{dt}[x(t)] = 0"], "y = B"), Ok(()));
    assert_eq!(judged(&[r"\sqrt{x(t) + 1} = 2"], "y = B"), Ok(()));
    assert_eq!(judged(&[], r"\frac{d}{dt}[x(t)] = y"), Ok(()));
    assert_eq!(judged(&[], r"x(s) = a"), Err(Reject::GoalNotFalse));
}

#[test]
fn what_the_hypotheses_say_of_them_must_be_so() {
    let at = with(&[("a", 3), ("B", 1), ("y", 2)], &[("x(t)", 3)]);
    for premise in [
        r"x(t) = 4",
        r"\frac{d}{dt}[x(t)] = 1",
        r"\lim_{t \to \infty} x(t) = 0",
        r"\sqrt{x(t) - 4} = \sqrt{x(t) - 4}",
        r"\frac{1}{x(t) - a} = \frac{1}{x(t) - a}",
        r"\lim_{t \to 0} \frac{x(t)}{t} = \lim_{t \to 0} \frac{x(t)}{t}",
    ] {
        let judged = refuted(&begins_at(&[premise], "y = B"), at.clone());
        assert!(judged.is_err(), "{premise}");
    }
}

/// At one point each of these is true, and along the way it is not: `x(t) = t` has the slope 1.
#[test]
fn what_moves_is_tied_to_no_constant_function() {
    let at = with(&[("t", 1), ("s", 1), ("y", 1)], &[("x(t)", 1)]);
    for law in [
        "x(t) = t",
        "x(t) = s",
        r"x(t) = \exp(t - 1)",
        r"\frac{d}{dt}[x(t)] = \frac{dy}{dt}",
        r"\int_0^1 x(t) \, dt = s",
    ] {
        let judged = refuted(&claim(&[law], r"\frac{d}{dt}[x(t)] = 1"), at.clone());
        assert!(judged.is_err(), "{law}");
    }
    // Nor does a declaration make it one.
    for (law, name) in [("x(t) = t", "t"), ("x(t) = s + r - r", "r")] {
        let goal = r"\frac{d}{dt}[x(t)] = \frac{dx(r)}{dr} + 1";
        let declared = ["s", name].into_iter();
        let declared = declared.fold(claim(&[law], goal), |own, name| {
            own.domain(name, constant())
        });
        let at = with(&[("t", 1), ("s", 1), ("r", 1), ("y", 1)], &[("x(t)", 1)]);
        assert_eq!(refuted(&declared, at), Err(Reject::NoCourse), "{law}");
    }
    // Of a constant it can be said.
    let constant = claim(&["x(t) = s"], r"\frac{d}{dt}[x(t)] = 1").domain("s", constant());
    assert_eq!(refuted(&constant, at), Ok(()));
}

#[test]
fn elements_are_no_constants() {
    let at = with(&[("y", 1), ("k", 2)], &[("x(t)", 1)]).list("u", &[1, 1]);
    let all = claim(&[r"u_1 = \dots = u_k = x(t)"], "y = 2").sequence("u");
    let all = all.domain("k", constant());
    assert!(refuted(&all, at).is_err());
    let tied = claim(&["x(t) = u_1", "u_1 + u_2 = 3"], "y = 2").sequence("u");
    let at = with(&[("y", 1)], &[("x(t)", 1)]).list("u", &[1, 2]);
    assert!(refuted(&tied, at).is_err());
}

#[test]
fn a_constant_function_has_one_value_and_no_other_meaning() {
    let wrong = || claim(&["x(t) = a"], "y = 2").domain("a", constant());
    let good = [("a", 1), ("y", 1)];
    assert_eq!(refuted(&wrong(), with(&good, &[("x(t)", 1)])), Ok(()));
    let two = with(&good, &[("x(t)", 1), ("x(s)", 2)]);
    assert_eq!(refuted(&wrong(), two), Err(Reject::NoValue));
    let negative = Domain {
        upper: Some((number(0), false)),
        ..Domain::default()
    };
    let outside = wrong().domain("x", negative);
    let judged = refuted(&outside, with(&good, &[("x(t)", 1)]));
    assert_eq!(judged, Err(Reject::OutsideDomain));
    // The symbol without an argument is the same function.
    let both = claim(&["x(t) = a", "x = 2 a"], "y = 2").domain("a", constant());
    let judged = refuted(&both, with(&[("a", 1), ("y", 1), ("x", 2)], &[("x(t)", 1)]));
    assert_eq!(judged, Err(Reject::NoValue));
}
