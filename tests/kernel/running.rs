//! Points of claims with limits and integrals, and forgeries of such points: laws that hold at one place alone.

use cradle_verify::kernel::{Claim, Reject};

use super::claims::*;

/// The charge at a voltage, and the work of bringing it there; all is constant but what runs.
fn charged(law: &str, goal: &str) -> Claim {
    let work = r"W = \int_0^2 U \, dq";
    let fixed = ["C", "U"].into_iter();
    fixed.fold(claim(&[law, work], goal), |claim, name| {
        claim.domain(name, constant())
    })
}

#[test]
fn what_stands_in_an_integral_is_tied_to_nothing_that_runs() {
    let at = || point(&[("C", 1), ("U", 1), ("q", 1), ("W", 2)]);
    let wrong = "W = 3 U";
    assert_eq!(refuted(&charged("C = U", wrong), at()), Ok(()));
    assert_eq!(
        refuted(&charged("C U = q", wrong), at()),
        Err(Reject::NoCourse)
    );
    assert_eq!(
        refuted(&charged("C U = q^2", wrong), at()),
        Err(Reject::NoCourse)
    );
    // At the point alone it may be so.
    let here = charged("C U = q", wrong).at_point(0);
    assert_eq!(refuted(&here, at()), Ok(()));
}

#[test]
fn what_does_not_stand_there_may_keep_up() {
    let at = |others: &[(&str, i64)]| {
        let own = [("C", 1), ("U", 1), ("q", 1), ("W", 2)];
        point(&[own.as_slice(), others].concat())
    };
    let wrong = "W = 3 U";
    assert_eq!(refuted(&charged("D U = q", wrong), at(&[("D", 1)])), Ok(()));
    // Two laws and one unknown, and two unknowns of which the same is said twice.
    let two = |laws: &[&str]| {
        let mut all = charged(laws[0], wrong);
        for law in &laws[1..] {
            all.hypotheses.extend(claim(&[law], "0 = 0").hypotheses);
        }
        all
    };
    let both = at(&[("D", 1), ("F", 1)]);
    let judged = |laws: &[&str]| refuted(&two(laws), both.clone());
    assert_eq!(judged(&["D U = q", "D + q = 2"]), Err(Reject::NoCourse));
    assert_eq!(
        judged(&["D + F = 2 q", "D + F + q = 3"]),
        Err(Reject::NoCourse)
    );
    assert_eq!(judged(&["D + F = 2 q", "D - F = U - q"]), Ok(()));
    // What moves with it takes others along, and these nothing that stands in the integral.
    assert_eq!(judged(&["D U = q", "F = D"]), Ok(()));
    assert_eq!(judged(&["D U = q", "U = D"]), Err(Reject::NoCourse));
}

#[test]
fn what_cannot_be_solved_for_does_not_keep_up() {
    let at = |d: i64| point(&[("C", 1), ("U", 1), ("q", 0), ("W", 2), ("D", d)]);
    let tied = charged("D^2 = q", "W = 3 U");
    assert_eq!(refuted(&tied, at(0)), Err(Reject::NoCourse));
    let other = charged("D^2 = q + 1", "W = 3 U");
    assert_eq!(refuted(&other, at(1)), Ok(()));
}

#[test]
fn bounds_that_are_reached_may_be_crossed() {
    let at = |q: i64| point(&[("C", 1), ("U", 1), ("q", q), ("W", 2)]);
    let bounded = charged(r"q \geq 0", "W = 3 U");
    assert_eq!(refuted(&bounded, at(1)), Ok(()));
    assert_eq!(refuted(&bounded, at(0)), Err(Reject::NoCourse));
}

#[test]
fn limits_run_too() {
    let law = r"\frac{1}{s} + \frac{1}{r} = \frac{1}{f}";
    let image = claim(&[law], r"\lim_{s \to \infty} r = f")
        .domain("r", constant())
        .domain("f", constant());
    let at = point(&[("s", 2), ("r", 2), ("f", 1)]);
    assert_eq!(refuted(&image, at), Err(Reject::NoCourse));
}

#[test]
fn what_is_constant_is_so_along_the_way_only_if_the_laws_let_it_be() {
    let slope = |laws: &[&str]| {
        claim(laws, r"\frac{d}{dh} \left[ v^2 \right] = -1")
            .domain("v", constant())
            .domain("c", constant())
    };
    let at = || point(&[("v", 1), ("h", 0), ("c", 1)]);
    assert_eq!(refuted(&slope(&["v^2 = c"]), at()), Ok(()));
    let tied = slope(&["v^2 + h = c"]);
    assert_eq!(refuted(&tied, at()), Err(Reject::NoCourse));
    assert_eq!(refuted(&tied.at_point(0), at()), Ok(()));
}
