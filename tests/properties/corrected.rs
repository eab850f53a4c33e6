//! The corrected pages against the physics in `src/cradle`: what they derive must be true of the balls.

use std::collections::BTreeSet;
use std::sync::OnceLock;

use cradle_verify::algebra::BigRational;
use cradle_verify::audit::Verdict;
use cradle_verify::cradle::{efficiency, elastic, with_restitution};
use cradle_verify::derivation::{Checker, Point};
use cradle_verify::proofs::corrected;
use num_traits::{One, Signed, Zero};
use proptest::prelude::*;

use super::pages::holds;
use super::physics::*;

const COLLISION: &[&str] = &[
    "N1",
    "N2",
    "N3",
    "N4",
    "something-changes",
    "N5",
    "N6",
    "N7",
    "N8",
    "nothing-is-lost",
];
const LINE: &[&str] = &[
    "N9", "at-first", "at-last", "N10", "N11", "N12", "N13", "N14", "N15", "N16", "N17", "N18",
];
const SPEED: &[&str] = &["P1", "P2", "P3", "P4", "P5", "P6", "P7"];
const FAMILY: &[&str] = &["F1", "F2", "F3", "F4", "F5", "F6", "F7", "F8", "F9"];
const ONE_IN: &[&str] = &["F11", "F12", "F13"];
const RESTITUTION: &[&str] = &[
    "R1",
    "R2",
    "R3",
    "R4",
    "R5",
    "R6",
    "R7",
    "R8",
    "at-most-half",
    "R9",
    "R10",
    "R11",
    "R12",
    "R13",
    "R14",
    "R15",
    "R16",
    "R17",
    "R18",
];
const CONTACT: &[&str] = &["C1", "C2", "C3", "C4", "C5", "C6", "C7", "C8"];
const MAXIMUM: &[&str] = &[
    "M1", "M2", "M3", "M4", "M5", "M6", "M7", "M8", "M10", "M11", "M12", "M14",
];
const DECAY: &[&str] = &[
    "D2", "D4", "D5", "D6", "D7", "D8", "D9", "D10", "D11", "D12", "D13", "D14", "D15", "D16",
];
/// True or not as two masses are equal, or two numbers of balls.
const EQUIVALENT: &[&str] = &["F10", "M9", "M13"];
/// `D1` and `D3`, evaluated by themselves: they speak of one click more, or of two.
const ONE_MORE: &[&str] = &["D1", "D3"];

fn pages() -> &'static Checker {
    static PAGES: OnceLock<Checker> = OnceLock::new();
    PAGES.get_or_init(corrected::checker)
}

#[test]
fn every_corrected_equation_that_holds_is_held_against_the_physics() {
    let groups = [
        COLLISION,
        LINE,
        SPEED,
        FAMILY,
        ONE_IN,
        RESTITUTION,
        CONTACT,
        MAXIMUM,
        DECAY,
        EQUIVALENT,
        ONE_MORE,
    ];
    let tested: BTreeSet<&str> = groups.concat().into_iter().collect();
    let pages = pages();
    for entry in &pages.audit().entries {
        let label = pages.derivation().equations[entry.equation].label();
        let label = label.expect("every equation has a number or a name");
        // Scaling relations compare two situations: the exponents are held against integrated collisions.
        if entry.verdict == Verdict::Holds && !label.starts_with('H') {
            assert!(tested.contains(label), "({label}) is nowhere evaluated");
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn two_equal_balls_exchange_velocities(m in positive(), a in any_number(), b in any_number(), sums in any_number()) {
        prop_assume!(a != b);
        let (a2, b2) = elastic(&m, &m, &a, &b);
        let mut at = Point::new()
            .with_ratio("m", m)
            .with_ratio("a_t", a.clone())
            .with_ratio("b_t", b.clone())
            .with_ratio("a'_t", a2.clone())
            .with_ratio("b'_t", b2.clone());
        for (power, name) in (1..=4).zip(["P", "Q", "R", "T"]) {
            let before = a.pow(power) + b.pow(power);
            let after = a2.pow(power) + b2.pow(power);
            at = at
                .with_ratio(&format!("{name}_0"), &sums + before.clone())
                .with_ratio(&format!("{name}_t"), &sums + before)
                .with_ratio(&format!("{name}_{{t+1}}"), &sums + after);
        }
        for label in COLLISION {
            prop_assert!(holds(pages(), label, &at), "({})", label);
        }
    }

    #[test]
    fn as_many_balls_leave_as_come_in(cradle in collided()) {
        let mut after = cradle.after.clone();
        after.resize(cradle.balls, BigRational::zero());
        let shares = after.iter().map(|u| u / &cradle.v0);
        let at = Point::new()
            .with("N", cradle.balls)
            .with("n", cradle.moving)
            .with("k", cradle.after.len())
            .with_ratio("v_0", cradle.v0.clone())
            .with_list("w", vec![cradle.v0.clone(); cradle.moving]);
        let at = (1..=4).zip(["P", "Q", "R", "T"]).fold(at, |at, (power, name)| {
            let sum = |all: &[BigRational]| all.iter().map(|u| u.pow(power)).sum::<BigRational>();
            at.with_ratio(&format!("{name}_0"), whole(cradle.moving) * cradle.v0.pow(power))
                .with_ratio(&format!("{name}_t"), sum(&after))
        });
        let at = at
            .with_list("x", shares.collect::<Vec<_>>())
            .with_list("u", after);
        for label in LINE.iter().chain(SPEED) {
            prop_assert!(holds(pages(), label, &at), "({})", label);
        }
    }

    #[test]
    fn other_outcomes_conserve_momentum_and_energy(n in 1usize..5, r in 1usize..5, v0 in positive()) {
        let all = whole(n + r);
        let fast = whole(2 * n) / all * &v0;
        let slow = &fast - &v0;
        let at = Point::new()
            .with("N", n + r)
            .with("n", n)
            .with("r", r)
            .with_ratio("v_0", v0)
            .with_ratio("P", slow.clone())
            .with_ratio("Q", fast.clone())
            .with_list("p", vec![slow.clone(); n])
            .with_list("q", vec![fast.clone(); r]);
        for label in FAMILY {
            prop_assert!(holds(pages(), label, &at), "({})", label);
        }
        for sides in pages().sides_at("F10", &at).unwrap() {
            prop_assert_eq!(sides.holds, n == r);
        }
        if n == 1 {
            for label in ONE_IN {
                prop_assert_eq!(holds(pages(), label, &at), *label != "F13" || r > 1, "({})", label);
            }
        }
    }

    #[test]
    fn one_imperfect_click(m in positive(), v0 in nonzero(), e in restitution()) {
        let (w1, w2) = with_restitution(&m, &m, &v0, &BigRational::zero(), &e);
        let energy = |v: &BigRational| &m * v * v / whole(2);
        let half = &v0 / whole(2);
        let (c1, c2) = (&w1 - &half, &w2 - &half);
        let (before, after) = (energy(&v0), energy(&w1) + energy(&w2));
        let (centred, left) = (energy(&half) * whole(2), energy(&c1) + energy(&c2));
        let at = Point::new()
            .with_ratio("m", m.clone())
            .with_ratio("v_0", v0)
            .with_ratio("e", e)
            .with_ratio("v'_1", w1)
            .with_ratio("v'_2", w2)
            .with_ratio("u'_1", c1)
            .with_ratio("u'_2", c2)
            .with_ratio("\\Delta E", &before - &after)
            .with_ratio("E_0", before)
            .with_ratio("E'", after)
            .with_ratio("\\Delta E_{\\text{cm}}", &centred - &left)
            .with_ratio("E_{\\text{cm}}", centred)
            .with_ratio("E'_{\\text{cm}}", left);
        for label in RESTITUTION {
            prop_assert!(holds(pages(), label, &at), "({})", label);
        }
    }

    #[test]
    fn identical_spheres(modulus in positive(), radius in positive(), nu in restitution()) {
        prop_assume!(!nu.is_one());
        let compliance = (BigRational::one() - &nu * &nu) / &modulus * whole(2);
        let at = ["E", "E_1", "E_2"].iter().fold(Point::new(), |p, s| p.with_ratio(s, modulus.clone()));
        let at = ["\\nu", "\\nu_1", "\\nu_2"].iter().fold(at, |p, s| p.with_ratio(s, nu.clone()));
        let at = ["R", "R_1", "R_2"].iter().fold(at, |p, s| p.with_ratio(s, &radius * &radius * whole(2)));
        let at = at.with_ratio("E^*", compliance.recip()).with_ratio("R^*", &radius * &radius)
            .with_ratio("k", ratio(4, 3) / &compliance * &radius);
        for label in CONTACT {
            prop_assert!(holds(pages(), label, &at), "({})", label);
        }
    }

    #[test]
    fn no_target_is_better_than_a_twin(m1 in positive(), m2 in positive(), v0 in nonzero()) {
        let at = unequal(&m1, &m2, &v0);
        for label in MAXIMUM {
            prop_assert!(holds(pages(), label, &at), "({})", label);
        }
        for label in ["M9", "M13"] {
            for sides in pages().sides_at(label, &at).unwrap() {
                prop_assert_eq!(sides.holds, m1 == m2, "({})", label);
            }
        }
        prop_assert!(efficiency(&(m2 / m1)) <= BigRational::one());
    }

    /// Two balls that swing back and meet again, click by click.
    #[test]
    fn the_energy_after_n_clicks(m in positive(), v0 in nonzero(), e in restitution(), n in 1usize..5) {
        let (mut one, mut two) = with_restitution(&m, &m, &v0, &BigRational::zero(), &e);
        for _ in 1..n {
            (one, two) = with_restitution(&m, &m, &-one, &-two, &e);
        }
        let (later, latest) = with_restitution(&m, &m, &-one.clone(), &-two.clone(), &e);
        let energy = |v: &BigRational| &m * v * v / whole(2);
        let share = (BigRational::one() + &e * &e) / whole(2);
        let first = energy(&v0);
        let centre = |a: &BigRational, b: &BigRational| (a + b) / whole(2);
        let at = Point::new()
            .with("n", n)
            .with_ratio("m", m.clone())
            .with_ratio("e", e)
            .with_ratio("c_0", &v0 / whole(2))
            .with_ratio("w_0", v0.clone())
            .with_ratio("v_0", v0)
            .with_ratio("c_n", centre(&one, &two))
            .with_ratio("w_n", &two - &one)
            .with_ratio("c_{n+1}", centre(&later, &latest))
            .with_ratio("w_{n+1}", &latest - &later)
            .with_ratio("K_n", energy(&one) + energy(&two))
            .with_ratio("K_0", first.clone())
            .with_ratio("E_1", &share * &first)
            .with_ratio("E_n", share.pow(n as i32) * &first)
            .with_ratio("E_{n+1}", share.pow(n as i32 + 1) * &first)
            .with_ratio("E_{n+2}", share.pow(n as i32 + 2) * &first)
            .with_ratio("E_0", first.abs());
        for label in DECAY.iter().chain(ONE_MORE) {
            prop_assert!(holds(pages(), label, &at), "({})", label);
        }
    }
}
