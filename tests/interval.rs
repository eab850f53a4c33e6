//! Intervals contain what they stand for, and the report's numeric claim agrees with the integration of the impact.

use cradle_verify::algebra::{BigRational, Function};
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

type Float = fn(f64) -> f64;

/// The functions, and what the processor makes of them.
const FUNCTIONS: [(Function, Float); 8] = [
    (Function::Sin, f64::sin),
    (Function::Cos, f64::cos),
    (Function::Tan, f64::tan),
    (Function::ArcSin, f64::asin),
    (Function::ArcCos, f64::acos),
    (Function::ArcTan, f64::atan),
    (Function::Exp, f64::exp),
    (Function::Ln, f64::ln),
];

proptest! {
    #[test]
    fn functions_are_rounded_outwards((a, x) in with_a_point(), scale in prop_oneof![Just(1i64), Just(50), Just(4000)]) {
        let scaled = |end: &BigRational| end / ratio(scale, 1);
        let a = Interval::new(scaled(a.low()), scaled(a.high())).unwrap();
        let x = scaled(&x);
        for (function, float) in FUNCTIONS {
            let (Some(all), Some(one)) = (a.under(function), Interval::exactly(x.clone()).under(function)) else {
                continue;
            };
            let value = float(x.to_f64().unwrap());
            let (low, high) = (one.low().to_f64().unwrap(), one.high().to_f64().unwrap());
            let error = 1e-14 * (1.0 + value.abs() * value.abs());
            prop_assert!(low - error <= value && value <= high + error, "{function:?} of {x}: {value} in {one}");
            prop_assert!(high - low <= 1e-8 * (1.0 + value.abs()), "{function:?} of {x}: {one} is wide");
            prop_assert!(all.low() <= one.high() && one.low() <= all.high(), "{function:?} of {a} and {x}");
        }
    }

    #[test]
    fn a_logarithm_is_undone_by_the_exponential((a, x) in with_a_point()) {
        if a.is_positive() {
            let back = a.under(Function::Ln).unwrap().under(Function::Exp).unwrap();
            prop_assert!(back.contains(&x));
        }
    }
}

#[test]
fn a_function_has_no_value_where_it_has_none() {
    let at = |p: i64, q: i64| Interval::exactly(ratio(p, q));
    let none = [
        (Function::Ln, at(0, 1)),
        (Function::Ln, at(-1, 2)),
        (Function::ArcSin, at(3, 2)),
        (Function::ArcCos, at(-3, 2)),
        (Function::Exp, at(1_000_000, 1)),
        (Function::Sin, at(i64::MAX, 1)),
        // A cosine that may be 0.
        (
            Function::Tan,
            Interval::new(ratio(1, 1), ratio(2, 1)).unwrap(),
        ),
    ];
    for (function, argument) in none {
        assert_eq!(argument.under(function), None, "{function:?} of {argument}");
    }
    let sine = Interval::new(ratio(0, 1), ratio(10, 1))
        .unwrap()
        .under(Function::Sin);
    assert_eq!(sine, Interval::new(ratio(-1, 1), ratio(1, 1)));
    assert_eq!(
        at(1, 1)
            .under(Function::ArcCos)
            .map(|own| own.contains(&ratio(0, 1))),
        Some(true)
    );
    assert_eq!(at(-7, 2).under(Function::Ceiling), Some(at(-3, 1)));
    assert_eq!(at(-7, 2).under(Function::Floor), Some(at(-4, 1)));
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
