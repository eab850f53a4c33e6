//! Lines of balls, pair by pair: the order of encounters, and what is refused.

use cradle_verify::algebra::BigRational;
use cradle_verify::cradle::{Chain, ChainError};
use cradle_verify::cradle::{list_text, parse_exact, parse_list};
use nalgebra::DVector;
use num_traits::One;

fn chain(masses: &str, velocities: &str, e: &str) -> Result<Chain, ChainError> {
    Chain::new(
        parse_list(masses).unwrap(),
        parse_list(velocities).unwrap(),
        parse_exact(e).unwrap(),
    )
}

#[test]
fn the_leftmost_approaching_pair_meets_first() {
    let mut line = chain("1, 1, 1, 1", "2, 1, 4, 3", "1").unwrap();
    let lefts: Vec<usize> = line
        .settle(9)
        .unwrap()
        .iter()
        .map(|encounter| encounter.left)
        .collect();
    assert_eq!(lefts, [0, 2]);
    assert_eq!(list_text(line.velocities()), "(1, 2, 3, 4)");
}

#[test]
fn three_balls_that_stick_never_come_to_rest_relative_to_one_another() {
    let mut line = chain("1, 1, 1", "1, 0, 0", "0").unwrap();
    assert_eq!(line.settle(50), Err(ChainError::TooManyCollisions(50)));
    assert!(line.is_approaching());
}

#[test]
fn a_budget_that_is_just_enough_is_enough() {
    assert_eq!(
        chain("1, 1, 1", "1, 0, 0", "1")
            .unwrap()
            .settle(2)
            .unwrap()
            .len(),
        2
    );
    assert_eq!(
        chain("1, 1, 1", "1, 0, 0", "1").unwrap().settle(1),
        Err(ChainError::TooManyCollisions(1))
    );
    assert_eq!(chain("1, 1", "0, 1", "1").unwrap().settle(0), Ok(vec![]));
}

#[test]
fn what_cannot_be_a_line_of_balls_is_refused() {
    assert_eq!(
        Chain::new(
            DVector::from_vec(vec![]),
            DVector::from_vec(vec![]),
            BigRational::one()
        )
        .unwrap_err(),
        ChainError::NoBalls
    );
    let says = |masses, velocities, e| chain(masses, velocities, e).unwrap_err().to_string();
    assert_eq!(
        says("1, 1", "1", "1"),
        "each ball needs a mass and a velocity, but masses are 2 and velocities 1"
    );
    assert_eq!(
        says("1, 0", "1, 0", "1"),
        "ball 2 has the mass 0: it must be positive"
    );
    assert_eq!(
        says("1, 1", "1, 0", "1.1"),
        "a coefficient of restitution lies between 0 and 1, and 11/10 does not"
    );
}
