//! Points of claims with limits and integrals, and forgeries of such points: laws that hold at one place alone.

use cradle_verify::algebra::{Expr, Function};
use cradle_verify::kernel::{Assignment, Claim, Reject};

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

/// A law that is turned back where it stands, `4 \sqrt D - D` at its most, or says nothing of what it would lead, `D - |D|`, lets nothing run on.
#[test]
fn what_a_root_or_an_absolute_value_takes_back_is_not_led() {
    let judged = |law: &str, lead: i64| {
        let at = point(&[("C", 1), ("U", 1), ("q", 1), ("W", 2), ("D", lead)]);
        refuted(&charged(law, "W = 3 U"), at)
    };
    assert_eq!(judged(r"4 \sqrt{D} - D + q = 5", 4), Err(Reject::NoCourse));
    assert_eq!(judged(r"4 \sqrt{D} - D + q = 4", 1), Ok(()));
    let turned = r"2 \sqrt{\frac{1}{D}} + D + q = 4";
    assert_eq!(judged(turned, 1), Err(Reject::NoCourse));
    assert_eq!(judged(r"2 \sqrt{\frac{1}{D}} + 2 D + q = 5", 1), Ok(()));
    assert_eq!(judged("D - |D| + q = 1", 1), Err(Reject::NoCourse));
    assert_eq!(judged("D - |U| + q = 1", 1), Ok(()));
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

/// `x = A cos(w t)` put into `m x'' + k x = 0`, with all but the time constant; at a moment at which the wave is nought, or not.
fn swinging(others: &[&str], wave: (i64, i64), symbols: &[(&str, i64)]) -> Result<(), Reject> {
    let laws = ["x = A \\cos(w t)", "m \\frac{d^2 x}{dt^2} + k x = 0"];
    let laws: Vec<&str> = laws.iter().chain(others).copied().collect();
    let swings = ["A", "w", "m"].into_iter();
    let swings = swings.fold(claim(&laws, "w^2 = 2 k/m"), |claim, name| {
        claim.domain(name, constant())
    });
    let call = |function, value| (Expr::Call(function, term("w t").into()), number(value));
    let point = Assignment {
        unfold: vec![0],
        functions: [call(Function::Sin, wave.0), call(Function::Cos, wave.1)]
            .into_iter()
            .collect(),
        ..point(symbols)
    };
    refuted(&swings, point)
}

#[test]
fn what_is_nought_with_what_does_not_move_put_in_is_so_all_along() {
    let at = |k| [("A", 1), ("w", 1), ("m", 1), ("k", k)];
    assert_eq!(swinging(&[], (1, 0), &at(1)), Ok(()));
    assert_eq!(swinging(&[], (0, 1), &at(1)), Ok(()));
    // At one moment alone it may be nought because the wave is.
    assert_eq!(swinging(&[], (1, 0), &at(2)), Err(Reject::NoCourse));
}

#[test]
fn what_moves_is_not_put_in() {
    let at = [("A", 1), ("w", 1), ("m", 1), ("k", 1), ("q", 1)];
    // `k` moves with the time, and so `m x'' + k x` does not stay nought.
    assert_eq!(
        swinging(&["k = \\sin(w t)"], (1, 0), &at),
        Err(Reject::NoCourse)
    );
    // It need not where something else can.
    assert_eq!(swinging(&["k = q \\sin(w t)"], (1, 0), &at), Ok(()));
    // Of `q` alone that says nothing.
    assert_eq!(swinging(&["q = \\sin(w t)"], (1, 0), &at), Ok(()));
    // Nor where `k` is tied to what moves.
    assert_eq!(
        swinging(&["q = \\sin(w t)", "k = q"], (1, 0), &at),
        Err(Reject::NoCourse)
    );
}
