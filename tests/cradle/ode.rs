//! The integrator: its order, the places that it finds, and when it gives up.

use cradle_verify::cradle::contact::ContactError;
use cradle_verify::cradle::ode::{Moment, System};
use nalgebra::{Const, Vector1, Vector2, Vector3};

type Swing = fn(&Vector2<f64>) -> Vector2<f64>;

/// A pendulum of small swings: place and velocity.
fn pendulum(tolerance: f64) -> System<Swing, Const<2>> {
    System {
        slope: |y| Vector2::new(y[1], -y[0]),
        scale: Vector2::new(1.0, 1.0),
        tolerance,
    }
}

/// How long an error is; `norm` needs more of `nalgebra` than we build.
fn size(error: Vector2<f64>) -> f64 {
    error.dot(&error).sqrt()
}

#[test]
fn half_a_step_makes_a_thirty_second_of_the_error() {
    let swing = pendulum(1.0);
    let error = |steps: usize| {
        let h = 1.0 / steps as f64;
        let end = (0..steps).fold(Vector2::new(1.0, 0.0), |y, _| swing.leap(&y, h).0);
        size(end - Vector2::new(1f64.cos(), -1f64.sin()))
    };
    let order = (error(10) / error(20)).log2();
    assert!((order - 5.0).abs() < 0.1, "{order}");
}

#[test]
fn the_error_of_one_step_is_seen_at_order_five() {
    let swing = pendulum(1.0);
    let seen = |h: f64| size(swing.leap(&Vector2::new(1.0, 0.0), h).1);
    let order = (seen(0.1) / seen(0.05)).log2();
    assert!((order - 5.0).abs() < 0.1, "{order}");
}

#[test]
fn a_pendulum_passes_the_lowest_point_a_quarter_of_a_period_after_the_highest() {
    // Time is a third unknown, so that the event is found in it as in everything else.
    let system = System {
        slope: |y: &Vector3<f64>| Vector3::new(y[1], -y[0], 1.0),
        scale: Vector3::new(1.0, 1.0, 1.0),
        tolerance: 1e-13,
    };
    let start = Moment::start(Vector3::new(1.0, 0.0, 0.0), 10.0);
    let end = system.until(start, |y| y[0]).unwrap();
    assert!(end.state[0].abs() < 1e-15);
    assert!((end.state[2] - std::f64::consts::FRAC_PI_2).abs() < 1e-12);
}

#[test]
fn what_runs_off_to_infinity_is_given_up() {
    let system = System {
        slope: |y: &Vector1<f64>| Vector1::new(y[0] * y[0]),
        scale: Vector1::new(1.0),
        tolerance: 1e-9,
    };
    let start = Moment::start(Vector1::new(1.0), 0.1);
    assert!(matches!(
        system.until(start, |_| 1.0),
        Err(ContactError::TooManySteps(_))
    ));
}
