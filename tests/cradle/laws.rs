//! Momentum and kinetic energy of several balls.

use cradle_verify::algebra::BigInt;
use cradle_verify::cradle::{Law, kinetic_energy, momentum};
use cradle_verify::cradle::{parse_exact, parse_list};

#[test]
fn two_balls_moving_as_one_carry_twice_of_both() {
    let masses = parse_list("1, 1").unwrap();
    let (one, both) = (parse_list("1, 0").unwrap(), parse_list("1, 1").unwrap());
    for law in Law::ALL {
        assert_eq!(
            law.quantity(&masses, &both),
            law.quantity(&masses, &one) * BigInt::from(2),
            "{law}"
        );
    }
}

#[test]
fn doubling_every_velocity_doubles_momentum_and_quadruples_energy() {
    let masses = parse_list("2, 3").unwrap();
    let velocities = parse_list("1, -1/2").unwrap();
    let doubled = &velocities + &velocities;
    assert_eq!(
        momentum(&masses, &doubled),
        momentum(&masses, &velocities) * BigInt::from(2)
    );
    assert_eq!(
        kinetic_energy(&masses, &doubled),
        kinetic_energy(&masses, &velocities) * BigInt::from(4)
    );
}

#[test]
fn opposite_motions_cancel_in_momentum_but_not_in_energy() {
    let (masses, velocities) = (parse_list("1, 1").unwrap(), parse_list("1, -1").unwrap());
    assert_eq!(momentum(&masses, &velocities), parse_exact("0").unwrap());
    assert_eq!(
        kinetic_energy(&masses, &velocities),
        parse_exact("1").unwrap()
    );
}
