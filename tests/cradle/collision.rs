//! Two balls, at the ends of what they can do.

use cradle_verify::algebra::BigRational;
use cradle_verify::cradle::parse_exact;
use cradle_verify::cradle::{efficiency, elastic, with_restitution};

fn q(text: &str) -> BigRational {
    parse_exact(text).unwrap()
}

#[test]
fn a_ball_against_a_wall_nearly_turns_round() {
    let (back, wall) = elastic(&q("1"), &q("1e9"), &q("1"), &q("0"));
    assert_eq!(back, q("-999999999/1000000001"));
    assert_eq!(wall, q("2/1000000001"));
}

#[test]
fn balls_that_stick_move_with_their_centre_of_mass() {
    let (v1, v2) = with_restitution(&q("1"), &q("3"), &q("2"), &q("-2"), &q("0"));
    assert_eq!((v1, v2), (q("-1"), q("-1")));
}

#[test]
fn an_ever_heavier_ball_takes_ever_less() {
    assert_eq!(efficiency(&q("1")), q("1"));
    assert_eq!(efficiency(&q("99")), q("99/2500"));
    assert!(efficiency(&q("1e6")) < q("1e-5"));
}

#[test]
#[should_panic(expected = "must be positive")]
fn a_massless_ball_is_refused() {
    let _ = elastic(&q("0"), &q("1"), &q("1"), &q("0"));
}
