//! Every equation of the report that is true must be true of the balls, and those that are not must be false of them.

use std::collections::BTreeSet;
use std::sync::OnceLock;

use cradle_verify::algebra::{BigRational, EvaluateError, Relation};
use cradle_verify::audit::Verdict;
use cradle_verify::cradle::{Law, Scenario, efficiency, with_restitution};
use cradle_verify::derivation::{Checker, Point};
use cradle_verify::proofs;
use num_traits::{One, Signed, Zero};
use proptest::collection::vec;
use proptest::prelude::*;

use super::physics::*;

/// The equations of pages 3.1 to 3.6, true of every elastic collision with a ball at rest.
pub const UNEQUAL: &[&str] = &[
    "42",
    "43",
    "44",
    "45",
    "46",
    "47",
    "48",
    "49",
    "50",
    "51",
    "52",
    "53",
    "54",
    "55",
    "56",
    "57",
    "58",
    "mass-ratio",
    "59",
    "60",
    "61",
    "62",
    "63",
    "64",
];
/// What is given on pages 2.1 and 2.5: true of every collision of identical balls.
const IDENTICAL: &[&str] = &[
    "momentum-identical",
    "restitution",
    "total-loss",
    "28",
    "40",
    "energy-after",
    "loss-is-heat-and-sound",
    "loss-at-rest",
    "momentum-centred",
    "restitution-centred",
    "energy-centred",
    "loss-centred",
    "loss-printed",
    "half-the-energy",
    "one-loss",
    "after-at-rest",
    "energy-after-centred",
    "after-centred",
    "balance-at-rest",
];
/// What is said of the same collisions, and true of perfectly elastic ones alone.
const ELASTIC_ONLY: &[&str] = &["27", "41", "balance-from-loss"];
/// What page 4.2 makes of that: true of two balls that meet again and again only if nothing is lost.
const DECAY: &[&str] = &["energy-decay"];
/// What page 1.4 concludes from the two laws: true of every list that they allow.
pub const TOTALS: &[&str] = &["17", "18", "19", "20", "21", "22"];
/// What it goes on to say: true of real cradles.
const REAL: &[&str] = &["23", "24", "25", "26", "n-in-n-out"];
const FIVE: &[&str] = &["1", "2", "3", "4"];
const SCENARIOS: &[&str] = &[
    "5", "6", "7", "8", "9", "10", "11", "12", "13", "14", "15", "16",
];
const SLOPE: &[&str] = &["65", "66", "67", "68"];
const BEST: &[&str] = &["69", "70", "maximum", "maximum-only-at-one", "heavy-target"];
const TWINS: &[&str] = &["33", "effective-radius", "twin-radius"];
/// What says nothing of one point: scaling relations compare two situations, integrals run over a whole contact.
/// `tests/properties/scaling.rs` compares situations.
const NOT_AT_A_POINT: &[&str] = &["largest-compression", "contact-time", "35", "36", "39"];

/// The report, read once.
pub fn report() -> &'static Checker {
    static REPORT: OnceLock<Checker> = OnceLock::new();
    REPORT.get_or_init(proofs::checker)
}

/// Whether every relation of an equation is true at a point.
pub fn holds(page: &Checker, label: &str, at: &Point) -> bool {
    let sides = page.sides_at(label, at);
    let sides = sides.unwrap_or_else(|error| panic!("({label}): {error}"));
    sides.iter().all(|s| s.holds)
}

fn five(velocities: &[BigRational], mass: &BigRational, v0: &BigRational) -> Point {
    let point = Point::new()
        .with_ratio("m", mass.clone())
        .with_ratio("v_0", v0.clone());
    let all = (1..).zip(velocities);
    all.fold(point, |point, (ball, v)| {
        point.with_ratio(&format!("v_{ball}"), v.clone())
    })
}

#[test]
fn every_equation_that_holds_is_held_against_the_physics() {
    let groups = [
        UNEQUAL,
        IDENTICAL,
        ELASTIC_ONLY,
        DECAY,
        TOTALS,
        REAL,
        FIVE,
        SCENARIOS,
        SLOPE,
        BEST,
        TWINS,
        NOT_AT_A_POINT,
        &["cauchy-equality"],
    ];
    let tested: BTreeSet<&str> = groups.concat().into_iter().collect();
    let report = report();
    for entry in &report.audit().entries {
        let label = report.derivation().equations[entry.equation].label();
        let label = label.expect("every equation of the report has a number or a name");
        if matches!(entry.verdict, Verdict::Holds | Verdict::Fails) {
            assert!(tested.contains(label), "({label}) is nowhere evaluated");
        }
    }
}

#[test]
fn what_cannot_be_evaluated_is_said_by_name() {
    let report = report();
    let point = Point::new().with("k", 1).with("\\delta", 4).with("e", 2);
    let error = |label: &str, point: &Point| report.sides_at(label, point).unwrap_err();
    assert!(matches!(error("29", &point), EvaluateError::Unsupported(_)));
    assert!(matches!(
        error(
            "compression-scale",
            &point.clone().with("\\delta_{\\max}", 1)
        ),
        EvaluateError::Undecidable(Relation::Scales)
    ));
    assert_eq!(
        error("n-in-n-out", &point).to_string(),
        "`n` has no value at this point"
    );
    assert_eq!(
        error("28", &point).to_string(),
        "`E_0` has no value at this point"
    );
    let massless = ["m_1", "m_2", "v_0", "v'_1", "v'_2"].iter();
    let massless = massless.fold(Point::new(), |point, name| point.with(name, 0));
    assert!(matches!(
        error("54", &massless),
        EvaluateError::DivisionByZero(_)
    ));
    let short = Point::new().with("k", 3).with_list("u", [ratio(1, 2)]);
    assert_eq!(
        error("19", &short).to_string(),
        "`u` has 1 elements at this point, and element 2 is needed"
    );
    assert!(matches!(
        error("19", &Point::new().with("x +", 1)),
        EvaluateError::Unreadable { .. }
    ));
    assert_eq!(
        error("99", &point).to_string(),
        "there is no equation of the number or name `99`"
    );
    let circular = Point::new()
        .with_term("E_0", "m")
        .with_term("m", "E_0")
        .with("v_0", 1);
    assert!(matches!(error("28", &circular), EvaluateError::Circular(_)));
    let unknown = Point::new().with("\\mu", 1).with("\\eta", 1);
    assert_eq!(
        error("68", &unknown).to_string(),
        "nothing at this point says how `\\eta` depends on `\\mu`"
    );
    let known = unknown.with_slope("\\eta", "\\mu", ratio(0, 1));
    assert!(holds(report, "68", &known));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn unequal_balls(m1 in positive(), m2 in positive(), v0 in nonzero()) {
        let report = report();
        let at = unequal(&m1, &m2, &v0);
        for label in UNEQUAL {
            prop_assert!(holds(report, label, &at), "({})", label);
        }
    }

    #[test]
    fn identical_balls(m in positive(), v0 in nonzero(), e in restitution(), heat in restitution()) {
        let report = report();
        let at = identical(&m, &v0, &e, &heat);
        for label in IDENTICAL {
            prop_assert!(holds(report, label, &at), "({})", label);
        }
        for label in ELASTIC_ONLY {
            prop_assert_eq!(holds(report, label, &at), e.is_one(), "({})", label);
        }
    }

    #[test]
    fn two_balls_that_meet_again(m in positive(), v0 in nonzero(), e in restitution(), n in 1usize..5) {
        let (mut one, mut two) = with_restitution(&m, &m, &v0, &BigRational::zero(), &e);
        for _ in 1..n {
            (one, two) = with_restitution(&m, &m, &-one, &-two, &e);
        }
        let energy = |v: &BigRational| &m * v * v / whole(2);
        let at = Point::new()
            .with("n", n)
            .with_ratio("e", e.clone())
            .with_ratio("E_0", energy(&v0))
            .with_ratio("E_n", energy(&one) + energy(&two));
        for label in DECAY {
            prop_assert_eq!(holds(report(), label, &at), e.is_one(), "({})", label);
        }
    }

    #[test]
    fn five_equal_balls(m in positive(), v0 in nonzero(), direction in vec(any_number(), 5)) {
        let mut before = vec![BigRational::zero(); 5];
        before[0] = v0.clone();
        let page = report();
        let at = five(&scattered(before, &direction), &m, &v0);
        for label in FIVE {
            prop_assert!(holds(page, label, &at), "({})", label);
        }
    }

    #[test]
    fn five_balls_that_break_the_laws(m in positive(), v0 in nonzero(), after in vec(any_number(), 5)) {
        let page = report();
        let at = five(&after, &m, &v0);
        let sum: BigRational = after.iter().sum();
        let squares: BigRational = after.iter().map(|v| v * v).sum();
        for (label, true_here) in [("1", sum == v0), ("2", sum == v0),
            ("3", squares == &v0 * &v0), ("4", squares == &v0 * &v0)] {
            prop_assert_eq!(holds(page, label, &at), true_here, "({})", label);
        }
    }

    #[test]
    fn scenarios(v0 in nonzero()) {
        let page = report();
        let at = Point::new().with_ratio("v_0", v0.clone());
        for name in Scenario::BUILT_IN {
            let unit = Scenario::built_in(name).unwrap();
            let scaled = |v: &nalgebra::DVector<BigRational>| v.map(|v| v * &v0);
            let own = Scenario::new(unit.masses().clone(), scaled(unit.before()), scaled(unit.after())).unwrap();
            for law in Law::ALL {
                let labels = unit.equations(law);
                // Energies are counted per half a mass.
                let units = if law == Law::Momentum { 1 } else { 2 };
                let before = law.quantity(own.masses(), own.before()) * whole(units);
                let after = law.quantity(own.masses(), own.after()) * whole(units);
                let first = page.sides_at(labels[0], &at).unwrap();
                prop_assert_eq!(&first[0].left, &before, "{} {:?}", name, law);
                let last = match labels {
                    [_] => first[0].right.clone(),
                    _ => page.sides_at(labels[1], &at).unwrap()[0].left.clone(),
                };
                prop_assert_eq!(last, after.clone(), "{} {:?}", name, law);
                let mut said = labels.iter().flat_map(|label| page.sides_at(label, &at).unwrap());
                let said = said.all(|s| s.holds == (s.relation == Relation::Equal));
                prop_assert_eq!(said, before == after, "{} {:?}", name, law);
            }
        }
    }

    #[test]
    fn lists_that_both_laws_allow(cradle in conserved()) {
        let page = report();
        let at = cradle.point();
        for label in TOTALS {
            prop_assert!(holds(page, label, &at), "({})", label);
        }
        for label in ["23", "24"] {
            prop_assert_eq!(holds(page, label, &at), cradle.after.len() == cradle.moving, "({})", label);
        }
    }

    #[test]
    fn lines_of_balls_that_collide(cradle in collided()) {
        let page = report();
        let at = cradle.point();
        for label in TOTALS.iter().chain(REAL) {
            prop_assert!(holds(page, label, &at), "({})", label);
        }
    }

    #[test]
    fn cauchy_and_schwarz_for_any_list(list in vec(any_number(), 1..8)) {
        let page = report();
        let alike = list.iter().all(|u| *u == list[0]);
        let at = Point::new().with("k", list.len()).with_list("u", list);
        prop_assert!(holds(page, "19", &at));
        let sides = page.sides_at("cauchy-equality", &at).unwrap();
        prop_assert_eq!(sides[0].holds, alike);
        prop_assert_eq!(sides[1..].iter().all(|s| s.holds), alike);
    }

    #[test]
    fn the_slope_of_the_efficiency(mu in positive(), tiny in 1u32..40) {
        let page = report();
        let at = Point::new().with_ratio("\\mu", mu.clone()).with_term("\\eta", "4\\mu / (1+\\mu)^2");
        let step = whole(2).pow(-(tiny as i32));
        let quotient = (efficiency(&(&mu + &step)) - efficiency(&mu)) / &step;
        for label in SLOPE {
            for sides in page.sides_at(label, &at).unwrap() {
                prop_assert!(sides.holds, "({})", label);
                // |d²η/dμ²| = 8 |μ − 2| / (1 + μ)⁴ is less than 16 for μ > 0.
                prop_assert!((&quotient - &sides.left).abs() <= &step * whole(8), "({})", label);
                prop_assert!((&quotient - &sides.right).abs() <= &step * whole(8), "({})", label);
            }
        }
    }

    #[test]
    fn the_best_target(mu in positive()) {
        let page = report();
        let at = Point::new()
            .with_ratio("\\mu", mu.clone())
            .with_ratio("\\eta", efficiency(&mu))
            .with_ratio("\\eta_{\\max}", efficiency(&BigRational::one()));
        prop_assert!(holds(page, "maximum", &at));
        prop_assert!(holds(page, "70", &at));
        for label in ["69", "maximum-only-at-one"] {
            for sides in page.sides_at(label, &at).unwrap() {
                prop_assert_eq!(sides.holds, mu.is_one(), "({})", label);
            }
        }
        let limit = Point::new().with_term("\\eta", "4\\mu / (1+\\mu)^2");
        prop_assert!(holds(page, "heavy-target", &limit));
        prop_assert!(efficiency(&mu) < whole(4) / &mu);
    }

    #[test]
    fn twin_spheres(modulus in positive(), radius in positive(), nu in restitution()) {
        prop_assume!(!nu.is_one());
        let page = report();
        let compliance = (BigRational::one() - &nu * &nu) / &modulus * whole(2);
        let at = ["E", "E_1", "E_2"].iter().fold(Point::new(), |p, s| p.with_ratio(s, modulus.clone()));
        let at = ["\\nu", "\\nu_1", "\\nu_2"].iter().fold(at, |p, s| p.with_ratio(s, nu.clone()));
        let at = ["R", "R_1", "R_2"].iter().fold(at, |p, s| p.with_ratio(s, &radius * &radius * whole(2)));
        let at = at.with_ratio("E^*", compliance.recip()).with_ratio("R^*", &radius * &radius)
            .with_ratio("k", ratio(4, 3) / &compliance * &radius);
        for label in ["30", "31", "32", "effective-radius"] {
            prop_assert!(holds(page, label, &at), "({})", label);
        }
        let halves = page.sides_at("33", &at).unwrap();
        prop_assert_eq!((halves[0].holds, halves[1].holds), (false, true));
    }
}
