//! Intervals contain what they stand for, and the report's numeric claim agrees with the integration of the impact.

use cradle_verify::algebra::BigRational;
use cradle_verify::cradle::contact::energies::RADIATION_FACTOR;
use cradle_verify::cradle::contact::{Air, Interval as Range, Material, heat_against_sound};
use cradle_verify::interval::Interval;
use cradle_verify::proofs;
use num_traits::{ToPrimitive, Zero};
use proptest::prelude::*;

fn ratio(p: i64, q: i64) -> BigRational {
    BigRational::new(p.into(), q.into())
}

prop_compose! {
    /// An interval and a point in it.
    fn with_a_point()(low in -60i64..60, width in 0i64..40, share in 0i64..=8, q in 1i64..9) -> (Interval, BigRational) {
        let (low, width) = (ratio(low, q), ratio(width, q));
        let point = &low + &width * ratio(share, 8);
        (Interval::new(low.clone(), low + width).unwrap(), point)
    }
}

proptest! {
    #[test]
    fn what_is_computed_contains_what_it_stands_for((a, x) in with_a_point(), (b, y) in with_a_point()) {
        prop_assert!((&a + &b).contains(&(&x + &y)));
        prop_assert!((&a - &b).contains(&(&x - &y)));
        prop_assert!((&a * &b).contains(&(&x * &y)));
        if let Some(quotient) = a.over(&b) {
            prop_assert!(!y.is_zero() && quotient.contains(&(&x / &y)));
        }
    }

    #[test]
    fn roots_are_rounded_outwards((a, x) in with_a_point(), p in 1i64..6, q in 1i64..6) {
        if !a.is_positive() {
            return Ok(());
        }
        // x^(p/q) raised to q again is x^p; the ends were moved apart, never together.
        let root = a.power(&ratio(p, q)).unwrap();
        let exact = num_traits::pow(x, p as usize);
        let power = |end: &BigRational| num_traits::pow(end.clone(), q as usize);
        prop_assert!(power(root.low()) <= exact && exact <= power(root.high()));
        let wide = (root.high() - root.low()) / root.low();
        let own = (a.high() - a.low()) / a.low();
        prop_assert!(!own.is_zero() || wide < ratio(1, 1 << 30), "{} is {} wide", root, wide);
    }
}

#[test]
fn the_numeric_claim_agrees_with_the_integration_of_the_impact() {
    let audit = proofs::report();
    let audit = cradle_verify::audit::Audit::of(&audit);
    let numeric = audit.entries.iter().find_map(|e| e.numeric.as_ref());
    let ratio = numeric.unwrap().links[0].ratio.clone().unwrap();
    let speed = Range::new(0.5, 1.0);
    let integrated = heat_against_sound(&Material::STEEL, speed, &Air::INDOORS, RADIATION_FACTOR);
    let least = integrated.unwrap().least_ratio;
    // Both are lower bounds from the same figures; neither route shares code with the other.
    let own = ratio.low().to_f64().unwrap();
    assert!((own / least - 1.0).abs() < 0.05, "{own} against {least}");
    assert!(own >= 10.0);
}
