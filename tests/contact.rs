//! Contact mechanics in floating point, held against what is known exactly.

use cradle_verify::cradle::contact::energies::{FAR, RADIATION_FACTOR};
use cradle_verify::cradle::contact::impact::damping_number;
use cradle_verify::cradle::contact::law::{CONTACT_TIME, WEAK_LOSS};
use cradle_verify::cradle::contact::scaling::power_law;
use cradle_verify::cradle::contact::{
    Air, Contact, ContactError, End, Impact, Interval, Material, Numeric, Parameter, Quantity,
    TouchingBalls, exponent, heat_against_sound,
};

/// Two steel balls of some 2 cm across, in SI. `beta` is the damping in its natural unit.
fn steel(beta: f64) -> Impact {
    let elastic = Impact {
        mass: 0.033,
        speed: 1.0,
        contact: Contact {
            stiffness: 1e10,
            damping: 0.0,
        },
        end: End::Recovered,
    };
    let reduced = elastic.mass / 2.0;
    let depth = elastic.contact.largest_compression(reduced, elastic.speed);
    let unit = reduced * elastic.speed / depth.powf(1.5);
    Impact {
        contact: elastic.contact.damped(beta * unit),
        ..elastic
    }
}

fn close(a: f64, b: f64, share: f64) -> bool {
    (a - b).abs() <= share * b.abs()
}

#[test]
fn an_elastic_impact_is_as_deep_and_as_long_as_hertz_says() {
    let impact = steel(0.0);
    let rebound = impact.run().unwrap();
    let (reduced, speed) = (impact.mass / 2.0, impact.speed);
    let depth = impact.contact.largest_compression(reduced, speed);
    assert!(
        rebound.compression.agrees_with(depth),
        "{}",
        rebound.compression
    );
    assert!(close(rebound.compression.value, depth, 1e-12));
    let time = CONTACT_TIME * depth / speed;
    assert!(rebound.duration.agrees_with(time), "{}", rebound.duration);
    assert!(close(rebound.duration.value, time, 1e-10));
    // All relative motion is elastic energy then.
    let stored = impact.contact.stored(depth);
    assert!(close(stored, 0.5 * reduced * speed * speed, 1e-12));
}

#[test]
fn an_elastic_impact_loses_nothing_and_exchanges_the_velocities() {
    let rebound = steel(0.0).run().unwrap();
    assert_eq!(rebound.dissipated.value, 0.0);
    assert!(
        rebound.kinetic_loss.agrees_with(0.0),
        "{}",
        rebound.kinetic_loss
    );
    assert!(rebound.kinetic_loss.error < 1e-9 * 0.0165);
    assert!(rebound.restitution.agrees_with(1.0));
    assert!(rebound.velocities[0].agrees_with(0.0) && rebound.velocities[1].agrees_with(1.0));
}

#[test]
fn heat_is_the_kinetic_energy_lost_and_what_is_still_stored() {
    for beta in [1e-6, 1e-3, 0.1, 1.0, 5.0] {
        for end in [End::Recovered, End::Released] {
            let rebound = Impact { end, ..steel(beta) }.run().unwrap();
            let (loss, heat, stored) = (rebound.kinetic_loss, rebound.dissipated, rebound.stored);
            let error = loss.error + heat.error + stored.error;
            let gap = loss.value - heat.value - stored.value;
            assert!(gap.abs() <= error, "β = {beta}, {end:?}: {gap} > {error}");
            assert!(error < 1e-8 * 0.0165, "β = {beta}, {end:?}: {error}");
            // Nothing is stored where the compression is back to 0, and something is where only the force is.
            assert_eq!(
                stored.value > 1e-30,
                end == End::Released,
                "β = {beta}, {end:?}"
            );
            let momentum = rebound.velocities[0].value + rebound.velocities[1].value;
            assert!(close(momentum, 1.0, 1e-13));
        }
    }
}

#[test]
fn weak_damping_loses_what_the_elastic_path_says() {
    let impact = steel(1e-6);
    let heat = impact.run().unwrap().dissipated;
    let expected = impact.contact.weak_loss(impact.mass / 2.0, impact.speed);
    assert!(close(heat.value, expected, 2e-6), "{heat} {expected}");
}

/// **Source.** Ramírez, Pöschel, Brilliantov and Schwager, *Phys. Rev. E* 60, 4465 (1999): `C₂ = (3/5) C₁²`.
#[test]
fn restitution_falls_with_damping_as_the_series_says() {
    for beta in [1e-3, 3e-3, 1e-2] {
        let e = steel(beta).run().unwrap().restitution;
        let first = WEAK_LOSS * beta;
        let series = 1.0 - first + 0.6 * first * first;
        assert!((e.value - series).abs() < first.powi(3), "β = {beta}: {e}");
    }
}

#[test]
fn damping_is_found_back_from_restitution() {
    for e in [0.05, 0.3, 0.9, 0.98, 0.999] {
        let rebound = steel(damping_number(e).unwrap()).run().unwrap();
        assert!(
            (rebound.restitution.value - e).abs() < 1e-9,
            "{e}: {}",
            rebound.restitution
        );
    }
    for e in [0.0, 1.0, -1.0, 2.0, f64::NAN] {
        assert!(matches!(
            damping_number(e),
            Err(ContactError::NoSuchRestitution(_))
        ));
    }
}

/// What exact scaling says, and what the integrated impacts say. Rows: compression, duration, heat; columns: `v0`, `m`,
/// `k`, `γ`.
#[test]
fn measured_exponents_are_those_of_exact_scaling() {
    let exact = [
        [4.0 / 5.0, 2.0 / 5.0, -2.0 / 5.0, 0.0],
        [-1.0 / 5.0, 2.0 / 5.0, -2.0 / 5.0, 0.0],
        [11.0 / 5.0, 3.0 / 5.0, -3.0 / 5.0, 1.0],
    ];
    for (quantity, exact) in Quantity::ALL.into_iter().zip(exact) {
        for (parameter, exact) in Parameter::ALL.into_iter().zip(exact) {
            let measured = exponent(quantity, parameter, &steel(1e-5), 3.0).unwrap();
            let told = format!("{quantity:?} with {parameter:?}: {measured}, not {exact}");
            assert!(measured.agrees_with(exact), "{told}");
            assert!(measured.error < 2e-4, "{told}");
        }
    }
}

/// The report's heat, `γ m^{1/2} k^{−3/2} v0^{6/5}`, is not what the impacts do.
#[test]
fn the_reports_exponents_of_heat_are_far_off() {
    for (parameter, reported) in [
        (Parameter::Speed, 6.0 / 5.0),
        (Parameter::Mass, 1.0 / 2.0),
        (Parameter::Stiffness, -3.0 / 2.0),
    ] {
        let measured = exponent(Quantity::Dissipated, parameter, &steel(1e-5), 3.0).unwrap();
        assert!((measured.value - reported).abs() > 100.0 * measured.error);
    }
}

#[test]
fn strong_damping_widens_the_error_rather_than_passing_for_the_power_law() {
    let weak = exponent(Quantity::Dissipated, Parameter::Speed, &steel(1e-4), 2.0).unwrap();
    let strong = exponent(Quantity::Dissipated, Parameter::Speed, &steel(1e-2), 2.0).unwrap();
    assert!(weak.agrees_with(2.2) && strong.agrees_with(2.2));
    assert!(strong.error > 30.0 * weak.error);
}

#[test]
fn a_line_through_an_exact_power_law_is_exact() {
    let points = [1.0, 2.0, 5.0, 9.0].map(|x: f64| {
        let value = 3.0 * x.powf(-0.7);
        (
            x,
            Numeric {
                value,
                error: 1e-9 * value,
            },
        )
    });
    let slope = power_law(&points);
    assert!(slope.agrees_with(-0.7) && slope.error < 1e-8, "{slope}");
}

#[test]
fn what_is_no_impact_is_refused() {
    let impact = steel(0.1);
    for wrong in [
        Impact {
            mass: 0.0,
            ..impact
        },
        Impact {
            speed: -1.0,
            ..impact
        },
        Impact {
            speed: f64::INFINITY,
            ..impact
        },
        Impact {
            contact: impact.contact.damped(-1.0),
            ..impact
        },
        Impact {
            contact: impact.contact.damped(f64::NAN),
            ..impact
        },
    ] {
        assert!(
            matches!(wrong.run(), Err(ContactError::NotPositive { .. })),
            "{wrong:?}"
        );
    }
    // So strong a damping that the ball creeps: an end or an error, but no hang.
    let _ = steel(1e9).run();
    assert!(Contact::of_twins(2e11, 0.6, 0.01).is_err());
    assert!(Contact::of_twins(-1.0, 0.3, 0.01).is_err());
}

fn parting(masses: &[f64], velocities: &[f64]) -> Vec<Numeric> {
    let line = TouchingBalls::new(masses.to_vec(), velocities.to_vec()).unwrap();
    line.part().unwrap().velocities
}

#[test]
fn one_ball_into_a_touching_line_is_nearly_one_ball_out() {
    // Known to four digits. The last of three is 0.99455: it has been printed with its fourth digit rounded either way.
    let three = [-0.0710, 0.0764, 0.9946];
    let five = [-0.0711, -0.0303, -0.0145, 0.1270, 0.9888];
    for (known, tolerance) in [(&three[..], 0.6e-4), (&five[..], 0.5e-4)] {
        let line = TouchingBalls::equal(known.len(), 1).unwrap();
        let end = line.part().unwrap();
        for (velocity, known) in end.velocities.iter().zip(known) {
            assert!(
                (velocity.value - known).abs() < tolerance,
                "{velocity}, not {known}"
            );
            assert!(velocity.error < 1e-7, "{velocity}");
        }
        assert!(end.momentum_drift.abs() < 1e-13, "{}", end.momentum_drift);
        assert!(end.energy_drift.abs() < 1e-8, "{}", end.energy_drift);
    }
}

#[test]
fn two_touching_balls_exchange_velocities_as_if_they_collided_in_an_instant() {
    for (m1, m2) in [(1.0, 1.0), (1.0, 3.0), (1000.0, 1.0)] {
        let end = parting(&[m1, m2], &[1.0, 0.0]);
        assert!(end[0].agrees_with((m1 - m2) / (m1 + m2)), "{}", end[0]);
        assert!(end[1].agrees_with(2.0 * m1 / (m1 + m2)), "{}", end[1]);
    }
}

#[test]
fn touching_balls_look_the_same_from_a_moving_train_and_in_other_units() {
    let plain = parting(&[1.0; 4], &[1.0, 0.0, 0.0, 0.0]);
    let aboard = parting(&[7.0; 4], &[100.0, 50.0, 50.0, 50.0]);
    for (plain, aboard) in plain.iter().zip(aboard) {
        let error = 50.0 * plain.error + aboard.error;
        assert!((50.0 * plain.value + 50.0 - aboard.value).abs() <= error);
    }
}

/// With a gap between every two, the light ball would have to be hit again and again; here it is passed from one to the other.
#[test]
fn a_light_ball_between_two_heavy_ones_rattles_until_they_part() {
    let end = parting(&[1.0, 1e-3, 1.0], &[1.0, 0.0, 0.0]);
    assert!((end[2].value - 1.0).abs() < 1e-3);
    assert!(end.windows(2).all(|pair| pair[0].value <= pair[1].value));
}

#[test]
fn balls_that_move_as_one_or_part_stay_as_they_are() {
    assert_eq!(TouchingBalls::equal(5, 5).unwrap().part().unwrap().steps, 0);
    let values: Vec<f64> = parting(&[1.0, 2.0], &[-1.0, 2.0])
        .iter()
        .map(|v| v.value)
        .collect();
    assert_eq!(values, [-1.0, 2.0]);
}

#[test]
fn what_is_no_line_of_touching_balls_is_refused() {
    let refused = |masses: &[f64], velocities: &[f64]| {
        TouchingBalls::new(masses.to_vec(), velocities.to_vec())
            .unwrap_err()
            .to_string()
    };
    assert!(refused(&[], &[]).contains("each ball needs a mass and a velocity"));
    assert!(refused(&[1.0], &[1.0, 0.0]).contains("masses are 1 and velocities 2"));
    assert!(refused(&[1.0, 0.0], &[1.0, 0.0]).contains("the mass must be positive"));
    assert!(refused(&[1.0], &[f64::NAN]).contains("velocity"));
    assert!(refused(&[1.0, 1e9], &[1.0, 0.0]).contains("1.0e9 times the mass"));
    assert!(refused(&[1.0; 201], &[1.0; 201]).contains("201 balls"));
}

fn click(ball: &Material, factor: Interval) -> cradle_verify::cradle::contact::Estimate {
    heat_against_sound(ball, Interval::new(0.5, 1.0), &Air::INDOORS, factor).unwrap()
}

#[test]
fn steel_balls_turn_far_more_into_heat_than_into_sound() {
    let estimate = click(&Material::STEEL, RADIATION_FACTOR);
    assert!(estimate.heat_far_exceeds_sound());
    assert!(estimate.least_ratio > 20.0, "{}", estimate.least_ratio);
    // The quotient of the intervals alone is a weaker statement of the same.
    assert!(estimate.least_ratio >= (estimate.heat / estimate.sound).low());
    // Some 60 µs, a hundredth of a joule brought, a few per cent of it lost.
    assert!(estimate.duration.contains(65e-6), "{}", estimate.duration);
    assert!(
        estimate.loss.low() > 1e-5 && estimate.loss.high() < 2e-3,
        "{}",
        estimate.loss
    );
}

#[test]
fn the_claim_depends_on_the_factor_of_the_sound_and_says_how_far() {
    let unknown = Interval::new(0.01, 100.0);
    let estimate = click(&Material::STEEL, unknown);
    assert!(
        !estimate.heat_far_exceeds_sound(),
        "{}",
        estimate.least_ratio
    );
    let tolerated = Interval::new(0.01, 0.999 * estimate.tolerated_factor);
    assert!(click(&Material::STEEL, tolerated).heat_far_exceeds_sound());
    assert!(
        !click(
            &Material::STEEL,
            Interval::exactly(1.01 * estimate.tolerated_factor)
        )
        .heat_far_exceeds_sound()
    );
    // Balls so perfect that sound might be everything: no estimate.
    let perfect = Material {
        restitution: Interval::new(0.999, 0.9999),
        ..Material::STEEL
    };
    let refused = heat_against_sound(&perfect, Interval::exactly(1.0), &Air::INDOORS, unknown);
    assert!(
        matches!(refused, Err(ContactError::NotPositive { .. })),
        "{refused:?}"
    );
}

/// One ball with figures within the intervals, integrated in SI: every result lies in the interval that was claimed for it.
#[test]
fn an_integrated_click_lies_within_the_estimate() {
    let estimate = click(&Material::STEEL, RADIATION_FACTOR);
    for (radius, density, young, poisson, e, speed) in [
        (0.01, 7850.0, 210e9, 0.29, 0.95, 0.7),
        (0.0099, 7700.0, 215e9, 0.31, 0.9899, 0.5),
        (0.0101, 8000.0, 200e9, 0.27, 0.9001, 1.0),
    ] {
        let mass = 4.0 / 3.0 * std::f64::consts::PI * f64::powi(radius, 3) * density;
        let elastic = Contact::of_twins(young, poisson, radius).unwrap();
        let depth = elastic.largest_compression(mass / 2.0, speed);
        let damping = damping_number(e).unwrap() * mass / 2.0 * speed / depth.powf(1.5);
        let contact = elastic.damped(damping);
        let impact = Impact {
            mass,
            speed,
            contact,
            end: End::Recovered,
        };
        let rebound = impact.run().unwrap();
        assert!(
            estimate.loss.contains(rebound.dissipated.value),
            "{}",
            rebound.dissipated
        );
        assert!(estimate.heat.contains(rebound.dissipated.value * 0.999));
        assert!(
            estimate.duration.contains(rebound.duration.value),
            "{}",
            rebound.duration
        );
        assert!(
            estimate.damping.contains(damping),
            "{damping}: {}",
            estimate.damping
        );
        let sound = 1.2 / 343.0 * f64::powi(radius, 4) * speed * speed / rebound.duration.value;
        assert!(estimate.sound.contains(sound));
        assert!(rebound.dissipated.value / (10.0 * sound) >= estimate.least_ratio);
        assert!(rebound.dissipated.value > FAR * sound);
    }
}

/// The 1.39 in the bound on the radiation factor: `τ ∫a² dt / v0²`, by Simpson's rule over `u = √(1 − x)`.
#[test]
fn the_acceleration_of_an_impact_is_not_far_from_steady() {
    // ∫a² dt = (5/8)² · 2 ∫ x³ / √(1 − x^{5/2}) dx in units of v0² and δ_max/v0, for each ball.
    let integrand = |u: f64| {
        let x = 1.0 - u * u;
        match u < 1e-6 {
            true => 2.0 / 2.5f64.sqrt(),
            false => 2.0 * u * x.powi(3) / (1.0 - x.powf(2.5)).sqrt(),
        }
    };
    let steps = 2000;
    let sum: f64 = (0..=steps)
        .map(|i| {
            let weight = if i == 0 || i == steps {
                1.0
            } else {
                2.0 + 2.0 * f64::from(i % 2)
            };
            weight * integrand(f64::from(i) / f64::from(steps))
        })
        .sum();
    let shape = CONTACT_TIME * 2.0 * (25.0 / 64.0) * sum / f64::from(steps) / 3.0;
    assert!((shape - 1.392).abs() < 1e-3, "{shape}");
    let bound = 4.0 * std::f64::consts::PI / 3.0 * shape;
    assert!(bound < RADIATION_FACTOR.high(), "{bound}");
}
