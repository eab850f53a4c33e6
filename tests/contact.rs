//! Contact mechanics in floating point, held against what is known exactly.

use cradle_verify::cradle::contact::impact::damping_number;
use cradle_verify::cradle::contact::law::{CONTACT_TIME, WEAK_LOSS};
use cradle_verify::cradle::contact::scaling::power_law;
use cradle_verify::cradle::contact::{
    Contact, ContactError, End, Impact, Numeric, Parameter, Quantity, exponent,
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
