//! The cradle through its public interface: what every collision obeys, and what the scenarios say for themselves.

mod chain;
mod collision;
mod gaps;
mod laws;
mod number;
mod ode;
mod scenario;

use cradle_verify::cli::scenario::{human, json};
use cradle_verify::cradle::{
    Chain, ChainError, Law, Limits, Line, Remark, Scenario, efficiency, elastic, energy_loss,
    kinetic_energy, list_text, momentum, parse_exact, parse_list, with_restitution,
};
use nalgebra::DVector;
use num_rational::BigRational;
use num_traits::{One, Zero, pow};
use proptest::collection::vec;
use proptest::prelude::*;

fn q(text: &str) -> BigRational {
    parse_exact(text).unwrap()
}

fn ratio(numerator: i64, denominator: i64) -> BigRational {
    BigRational::new(numerator.into(), denominator.into())
}

fn list(text: &str) -> DVector<BigRational> {
    parse_list(text).unwrap()
}

fn standing(balls: usize, moving: usize) -> DVector<BigRational> {
    DVector::from_fn(balls, |ball, _| if ball < moving { q("1") } else { q("0") })
}

fn equal(balls: usize) -> DVector<BigRational> {
    DVector::from_element(balls, q("1"))
}

fn mass() -> impl Strategy<Value = BigRational> {
    (1i64..40, 1i64..12).prop_map(|(n, d)| ratio(n, d))
}

fn velocity() -> impl Strategy<Value = BigRational> {
    (-40i64..=40, 1i64..12).prop_map(|(n, d)| ratio(n, d))
}

fn restitution() -> impl Strategy<Value = BigRational> {
    (1i64..12).prop_flat_map(|d| (0..=d).prop_map(move |n| ratio(n, d)))
}

/// Long enough for a few balls, and quick.
const SHORT: Limits = Limits {
    collisions: 40,
    bits: 500,
};

fn line(masses: &DVector<BigRational>, velocities: &DVector<BigRational>, e: &str) -> Line {
    Line::new(Chain::new(masses.clone(), velocities.clone(), q(e)).unwrap())
}

/// A few balls of any masses and velocities.
fn balls() -> impl Strategy<Value = (DVector<BigRational>, DVector<BigRational>)> {
    vec((mass(), velocity()), 1..5).prop_map(|balls| {
        let (masses, velocities) = balls.into_iter().unzip();
        (DVector::from_vec(masses), DVector::from_vec(velocities))
    })
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(64) })]

    #[test]
    fn a_collision_conserves_momentum_and_restitution_sets_the_relative_speed(
        m1 in mass(), m2 in mass(), u1 in velocity(), u2 in velocity(), e in restitution(),
    ) {
        let (v1, v2) = with_restitution(&m1, &m2, &u1, &u2, &e);
        prop_assert_eq!(&m1 * &v1 + &m2 * &v2, &m1 * &u1 + &m2 * &u2);
        prop_assert_eq!(v2 - v1, e * (u1 - u2));
    }

    #[test]
    fn an_elastic_collision_conserves_both(m1 in mass(), m2 in mass(), u1 in velocity(), u2 in velocity()) {
        let (v1, v2) = elastic(&m1, &m2, &u1, &u2);
        let masses = DVector::from_vec(vec![m1, m2]);
        let (before, after) = (DVector::from_vec(vec![u1, u2]), DVector::from_vec(vec![v1, v2]));
        for law in Law::ALL {
            prop_assert_eq!(law.quantity(&masses, &before), law.quantity(&masses, &after));
        }
    }

    #[test]
    fn a_collision_looks_the_same_from_a_moving_train(
        m1 in mass(), m2 in mass(), u1 in velocity(), u2 in velocity(), e in restitution(), train in velocity(),
    ) {
        let (v1, v2) = with_restitution(&m1, &m2, &u1, &u2, &e);
        let aboard = with_restitution(&m1, &m2, &(&u1 - &train), &(&u2 - &train), &e);
        prop_assert_eq!((v1 - &train, v2 - &train), aboard);
        prop_assert_eq!(
            energy_loss(&m1, &m2, &(&u1 - &train), &(&u2 - &train), &e),
            energy_loss(&m1, &m2, &u1, &u2, &e)
        );
    }

    #[test]
    fn an_elastic_collision_filmed_backwards_is_one(m1 in mass(), m2 in mass(), u1 in velocity(), u2 in velocity()) {
        let (v1, v2) = elastic(&m1, &m2, &u1, &u2);
        prop_assert_eq!(elastic(&m1, &m2, &-v1, &-v2), (-u1, -u2));
    }

    #[test]
    fn equal_balls_exchange_velocities(m in mass(), u1 in velocity(), u2 in velocity()) {
        prop_assert_eq!(elastic(&m, &m, &u1, &u2), (u2, u1));
    }

    #[test]
    fn the_energy_lost_is_that_of_the_relative_motion(
        m1 in mass(), m2 in mass(), u1 in velocity(), u2 in velocity(), e in restitution(),
    ) {
        let reduced = &m1 * &m2 / (&m1 + &m2);
        let expected = (q("1") - &e * &e) / q("2") * reduced * (&u1 - &u2) * (&u1 - &u2);
        prop_assert_eq!(energy_loss(&m1, &m2, &u1, &u2, &e), expected);
    }

    /// Not `1 − e²`: half of what the ball brings belongs to the motion of the common centre of mass.
    #[test]
    fn a_ball_that_strikes_an_equal_one_at_rest_loses_half_of_one_minus_e_squared(
        m in mass(), v0 in velocity(), e in restitution(),
    ) {
        let brought = &m * &v0 * &v0 / q("2");
        let lost = energy_loss(&m, &m, &v0, &q("0"), &e);
        prop_assert_eq!(&lost, &((q("1") - &e * &e) / q("2") * &brought));
        prop_assert_eq!(lost == (q("1") - &e * &e) * brought, e.is_one() || v0.is_zero());
    }

    #[test]
    fn efficiency_is_greatest_for_equal_masses_and_only_there(mu in mass()) {
        let eta = efficiency(&mu);
        let one_plus = q("1") + &mu;
        prop_assert_eq!(&eta, &(q("4") * &mu / (&one_plus * &one_plus)));
        prop_assert_eq!(efficiency(&mu.recip()), eta.clone());
        prop_assert!(eta <= q("1"));
        prop_assert_eq!(eta.is_one(), mu.is_one());
    }

    #[test]
    fn an_elastic_chain_conserves_both_and_ends_in_order((masses, before) in balls()) {
        let mut chain = Chain::new(masses.clone(), before.clone(), q("1")).unwrap();
        match chain.settle(60) {
            Ok(_) => prop_assert!(!chain.is_approaching()),
            Err(error) => prop_assert_eq!(error, ChainError::TooManyCollisions(60)),
        }
        for law in Law::ALL {
            prop_assert_eq!(law.quantity(&masses, &before), law.quantity(&masses, chain.velocities()));
        }
    }

    #[test]
    fn an_inelastic_chain_conserves_momentum_and_gains_no_energy((masses, before) in balls(), e in restitution()) {
        let mut chain = Chain::new(masses.clone(), before.clone(), e).unwrap();
        let _ = chain.settle(30);
        prop_assert_eq!(momentum(&masses, &before), momentum(&masses, chain.velocities()));
        prop_assert!(kinetic_energy(&masses, chain.velocities()) <= kinetic_energy(&masses, &before));
    }

    #[test]
    fn equal_elastic_balls_come_out_sorted((_, before) in balls()) {
        let (balls, mut sorted) = (before.len(), before.as_slice().to_vec());
        sorted.sort();
        let mut chain = Chain::new(equal(balls), before, q("1")).unwrap();
        prop_assert!(chain.settle(balls * (balls - 1) / 2).is_ok());
        prop_assert_eq!(chain.velocities().as_slice(), sorted.as_slice());
    }

    #[test]
    fn the_first_pass_hands_on_a_share_at_every_contact(masses in vec(mass(), 2..7), v0 in mass(), e in restitution()) {
        let mut before = standing(masses.len(), 0);
        before[0] = v0.clone();
        let mut chain = Chain::new(DVector::from_vec(masses.clone()), before, e.clone()).unwrap();
        prop_assert_eq!(chain.first_pass().len(), masses.len() - 1);
        let share = |pair: &[BigRational]| (q("1") + &e) * &pair[0] / (&pair[0] + &pair[1]);
        let expected = masses.windows(2).fold(v0, |speed, pair| speed * share(pair));
        prop_assert_eq!(&chain.velocities()[masses.len() - 1], &expected);
    }

    #[test]
    fn what_a_chain_does_is_judged_possible((masses, before) in balls()) {
        let mut chain = Chain::new(masses.clone(), before.clone(), q("1")).unwrap();
        prop_assume!(chain.settle(20).is_ok());
        let outcome = Scenario::new(masses, before, chain.velocities().clone()).unwrap().judge();
        prop_assert!(outcome.holds());
        prop_assert_eq!(outcome.remarks(), [Remark::PairByPairAgrees]);
    }

    #[test]
    fn a_line_with_gaps_conserves_both_and_ends_in_order((masses, before) in balls()) {
        let mut line = line(&masses, &before, "1");
        let events = line.settle(SHORT);
        for law in Law::ALL {
            prop_assert_eq!(law.quantity(&masses, &before), law.quantity(&masses, line.velocities()));
        }
        let Ok(events) = events else { return Ok(()) };
        prop_assert!(events.is_sorted_by(|a, b| a.time <= b.time));
        prop_assert!(line.velocities().iter().is_sorted());
        prop_assert!(events.iter().all(|event| event.time > q("0")));
    }

    #[test]
    fn an_inelastic_line_with_gaps_conserves_momentum_and_gains_no_energy((masses, before) in balls(), e in restitution()) {
        let mut line = Line::new(Chain::new(masses.clone(), before.clone(), e).unwrap());
        let _ = line.settle(SHORT);
        prop_assert_eq!(momentum(&masses, &before), momentum(&masses, line.velocities()));
        prop_assert!(kinetic_energy(&masses, line.velocities()) <= kinetic_energy(&masses, &before));
    }

    /// Without a third ball there is nothing that gaps could decide.
    #[test]
    fn two_balls_need_no_gap(m1 in mass(), m2 in mass(), u1 in velocity(), u2 in velocity(), e in restitution()) {
        let (masses, before) = (DVector::from_vec(vec![m1, m2]), DVector::from_vec(vec![u1, u2]));
        let mut chain = Chain::new(masses, before, e).unwrap();
        let mut line = Line::new(chain.clone());
        let events = line.settle(SHORT).unwrap();
        prop_assert_eq!(chain.settle(1).unwrap(), events.into_iter().map(|e| e.encounter).collect::<Vec<_>>());
    }

    #[test]
    fn the_choice_of_units_decides_nothing(
        (masses, before) in balls(), after in vec(velocity(), 5), m in mass(), v0 in mass(), turned in any::<bool>(),
    ) {
        let after = DVector::from_fn(masses.len(), |ball, _| after[ball].clone());
        let v0 = if turned { -v0 } else { v0 };
        let scaled = Scenario::new(masses.map(|x| x * &m), before.map(|x| x * &v0), after.map(|x| x * &v0)).unwrap();
        let plain = Scenario::new(masses, before, after).unwrap();
        for (a, b) in plain.judge().judgements().iter().zip(scaled.judge().judgements()) {
            prop_assert_eq!(a.holds(), b.holds());
            prop_assert_eq!(a.ratio(), b.ratio());
        }
    }

    #[test]
    fn a_printed_number_reads_back(value in velocity()) {
        prop_assert_eq!(parse_exact(&value.to_string()), Ok(value));
    }
}

#[test]
fn n_in_n_out_for_every_cradle_of_up_to_sixteen_balls() {
    for balls in 1..=16 {
        for arriving in 1..=balls {
            let mut cradle = Chain::new(equal(balls), standing(balls, arriving), q("1")).unwrap();
            let collisions = cradle.settle(256).unwrap();
            assert_eq!(
                collisions.len(),
                arriving * (balls - arriving),
                "{arriving} into {balls}"
            );
            let leaving = DVector::from_fn(balls, |ball, _| {
                q(if ball < balls - arriving { "0" } else { "1" })
            });
            assert_eq!(*cradle.velocities(), leaving, "{arriving} into {balls}");
            let mut apart = line(&equal(balls), &standing(balls, arriving), "1");
            let events = apart.settle(Limits::USUAL).unwrap();
            assert_eq!(events.len(), arriving * (balls - arriving));
            assert_eq!(*apart.velocities(), leaving, "{arriving} into {balls}");
        }
    }
}

/// With gaps the pulse runs ahead of what follows it, for smaller `e` than where the leftmost pair always goes first.
#[test]
fn the_last_ball_of_a_line_with_gaps_leaves_at_the_product_speed() {
    for (e, most) in [("1/2", 6), ("9/10", 16), ("99/100", 16), ("1", 16)] {
        for balls in 2..=most {
            let mut line = line(&equal(balls), &standing(balls, 1), e);
            let passed = |line: &mut Line| line.collide_next().unwrap().encounter.left + 2 == balls;
            let collisions = (0..200).take_while(|_| !passed(&mut line)).count();
            assert!(collisions < 200, "{balls} balls, e = {e}");
            let product = pow((q("1") + q(e)) / q("2"), balls - 1);
            assert_eq!(
                line.velocities()[balls - 1],
                product,
                "{balls} balls, e = {e}"
            );
        }
    }
    // Nothing catches up with it later either, in a cradle of the usual kind.
    let mut cradle = line(&equal(5), &standing(5, 1), "9/10");
    assert_eq!(cradle.settle(Limits::USUAL).unwrap().len(), 10);
    assert_eq!(cradle.velocities()[4], pow(q("19/20"), 4));
}

#[test]
fn a_line_that_never_ends_is_given_up_soon() {
    // Inelastic collapse; and a light ball that rattles between two heavy ones, millions of times.
    let mut sticky = line(&equal(3), &standing(3, 1), "0");
    let refusal = sticky.settle(Limits::USUAL).unwrap_err().to_string();
    assert_eq!(
        refusal,
        "after 1000 collisions the exact numbers are longer than 1000 bits, and the balls may still be colliding"
    );
    let mut rattling = line(&list("1, 1e-12, 1"), &standing(3, 1), "1");
    let refusal = rattling.settle(Limits::USUAL);
    assert!(
        matches!(refusal, Err(ChainError::NumbersTooLong { .. })),
        "{refusal:?}"
    );
    let mut many = line(&equal(400), &standing(400, 200), "1");
    let few = Limits {
        collisions: 500,
        ..Limits::USUAL
    };
    assert_eq!(many.settle(few), Err(ChainError::TooManyCollisions(500)));
}

/// The speed at which the last of a line of equal balls is first struck away, one ball coming in at speed 1.
fn first_speed_of_the_last(balls: usize, e: &str) -> BigRational {
    let mut chain = Chain::new(equal(balls), standing(balls, 1), q(e)).unwrap();
    loop {
        let encounter = chain
            .collide_next()
            .expect("the last ball is struck sooner or later");
        if encounter.left + 2 == balls {
            return encounter.after.1;
        }
    }
}

#[test]
fn the_pulse_arrives_at_its_product_speed_if_nothing_catches_up_with_it() {
    let product = |balls: usize, e| pow((q("1") + q(e)) / q("2"), balls - 1);
    for e in ["0", "1/10", "1/2", "9/10", "1"] {
        assert_eq!(first_speed_of_the_last(2, e), product(2, e), "e = {e}");
        assert_eq!(first_speed_of_the_last(3, e), product(3, e), "e = {e}");
    }
    // With a fourth ball the first two can meet again, and catch up with the third, if e < 3 − 2√2 = 0.1716.
    assert_eq!(first_speed_of_the_last(4, "0.172"), product(4, "0.172"));
    assert!(first_speed_of_the_last(4, "0.171") > product(4, "0.171"));
    // The longer the line, the larger the e for which those behind still catch up.
    assert_eq!(first_speed_of_the_last(6, "2/5"), product(6, "2/5"));
    assert!(first_speed_of_the_last(7, "2/5") > product(7, "2/5"));
}

#[test]
fn the_laws_give_both_verdicts_of_the_report() {
    for (name, momentum_holds, energy_holds) in [
        ('A', true, false),
        ('B', true, true),
        ('C', true, false),
        ('D', true, true),
    ] {
        let outcome = Scenario::built_in(name).unwrap().judge();
        assert_eq!(
            outcome,
            Scenario::built_in(name.to_ascii_lowercase())
                .unwrap()
                .judge()
        );
        let verdicts: Vec<bool> = outcome
            .judgements()
            .iter()
            .map(|judgement| judgement.holds())
            .collect();
        assert_eq!(verdicts, [momentum_holds, energy_holds], "scenario {name}");
        assert_eq!(outcome.holds(), momentum_holds && energy_holds);
    }
}

fn page(masses: &str, before: &str, after: &str) -> String {
    human(
        &Scenario::new(list(masses), list(before), list(after))
            .unwrap()
            .judge(),
    )
}

fn built_in(name: char) -> String {
    human(&Scenario::built_in(name).unwrap().judge())
}

#[test]
fn scenario_a() {
    insta::assert_snapshot!(built_in('A'), @"
    Scenario A: one ball arrives at v0, two leave at v0/2   (m = 1, v0 = 1)

      ball              1   2   3   4     5
      velocity before   1   0   0   0     0
      velocity after    0   0   0   1/2   1/2

      law              before   after   after − before
      momentum         1        1       0                holds   (5)
      kinetic energy   1/2      1/4     -1/4             FAILS   (6)

    Kinetic energy would have to halve (after − before = -1/4 m v0²):
    with perfectly elastic balls, this outcome cannot happen.

      note: elastic collisions, pair by pair, would give (0, 0, 0, 0, 1)
      note: m = 1 and v0 = 1 lose nothing: every momentum scales with m v0, every kinetic energy with m v0²
    ");
}

#[test]
fn scenario_b() {
    insta::assert_snapshot!(built_in('B'), @"
    Scenario B: one ball arrives at v0, one leaves at v0   (m = 1, v0 = 1)

      ball              1   2   3   4   5
      velocity before   1   0   0   0   0
      velocity after    0   0   0   0   1

      law              before   after   after − before
      momentum         1        1       0                holds   (7)
      kinetic energy   1/2      1/2     0                holds   (8)

    Both laws hold: this outcome can happen.

      note: elastic collisions, pair by pair, give just these velocities
      note: m = 1 and v0 = 1 lose nothing: every momentum scales with m v0, every kinetic energy with m v0²
    ");
}

#[test]
fn scenario_c() {
    insta::assert_snapshot!(built_in('C'), @"
    Scenario C: two balls arrive at v0, one leaves at 2 v0   (m = 1, v0 = 1)

      ball              1   2   3   4   5
      velocity before   1   1   0   0   0
      velocity after    0   0   0   0   2

      law              before   after   after − before
      momentum         2        2       0                holds   (9)
      kinetic energy   1        2       +1               FAILS   (10), (11), (12)

    Kinetic energy would have to double (after − before = +m v0²):
    with nothing to supply it, this outcome cannot happen.

      note: elastic collisions, pair by pair, would give (0, 0, 0, 1, 1)
      note: m = 1 and v0 = 1 lose nothing: every momentum scales with m v0, every kinetic energy with m v0²
    ");
}

#[test]
fn scenario_d() {
    insta::assert_snapshot!(built_in('D'), @"
    Scenario D: two balls arrive at v0, two leave at v0   (m = 1, v0 = 1)

      ball              1   2   3   4   5
      velocity before   1   1   0   0   0
      velocity after    0   0   0   1   1

      law              before   after   after − before
      momentum         2        2       0                holds   (13)
      kinetic energy   1        1       0                holds   (14), (15), (16)

    Both laws hold: this outcome can happen.

      note: elastic collisions, pair by pair, give just these velocities
      note: m = 1 and v0 = 1 lose nothing: every momentum scales with m v0, every kinetic energy with m v0²
    ");
}

/// One ball in, three out: momentum, energy and order are all right, so the laws alone do not say "one in, one out".
#[test]
fn one_in_three_out_is_not_forbidden_by_the_laws() {
    insta::assert_snapshot!(page("1, 1, 1", "1, 0, 0", "-1/3, 2/3, 2/3"), @"
    Your scenario: three balls, one moving before and three after

      ball              1      2     3
      velocity before   1      0     0
      velocity after    -1/3   2/3   2/3

      law              before   after   after − before
      momentum         1        1       0                holds
      kinetic energy   1/2      1/2     0                holds

    Both laws hold: they do not forbid this outcome.

      note: the two laws alone do not decide what happens: elastic collisions, pair by pair, give (0, 0, 1)
    ");
}

#[test]
fn unequal_balls_that_break_both_laws() {
    insta::assert_snapshot!(page("1, 5/2", "1, 0", "1/2, -1"), @"
    Your scenario: two balls, one moving before and two after

      ball              1     2
      mass              1     5/2
      velocity before   1     0
      velocity after    1/2   -1

      law              before   after   after − before
      momentum         1        -2      -3               FAILS
      kinetic energy   1/2      11/8    +7/8             FAILS

    Momentum would have to turn round and change by the factor 2 (after − before = -3):
    without a push from outside, this outcome cannot happen.
    Kinetic energy would have to change by the factor 11/4 (after − before = +7/8):
    with nothing to supply it, this outcome cannot happen.

      note: ball 1 would still be faster (1/2) than ball 2 to its right (-1): they would meet again, or pass through each other
      note: elastic collisions, pair by pair, would give (-3/7, 4/7)
    ");
}

#[test]
fn a_ball_that_goes_on_as_if_nothing_were_in_its_way() {
    insta::assert_snapshot!(page("1, 1", "1, 0", "1, 0"), @"
    Your scenario: two balls, one moving before and one after

      ball              1   2
      velocity before   1   0
      velocity after    1   0

      law              before   after   after − before
      momentum         1        1       0                holds
      kinetic energy   1/2      1/2     0                holds

    Both laws hold, and still this outcome cannot happen: the order of the balls forbids it.

      note: ball 1 would still be faster (1) than ball 2 to its right (0): they would meet again, or pass through each other
      note: the two laws alone do not decide what happens: elastic collisions, pair by pair, give (0, 1)
    ");
}

#[test]
fn balls_that_part_cannot_collide() {
    insta::assert_snapshot!(page("1, 1", "-1, 1", "1, -1"), @"
    Your scenario: two balls, two moving before and two after

      ball              1    2
      velocity before   -1   1
      velocity after    1    -1

      law              before   after   after − before
      momentum         0        0       0                holds
      kinetic energy   1        1       0                holds

    Both laws hold, and still this outcome cannot happen: the order of the balls forbids it.

      note: ball 1 would still be faster (1) than ball 2 to its right (-1): they would meet again, or pass through each other
      note: before, no ball is faster than the one on its right: none would meet, and nothing could change
    ");
}

#[test]
fn energy_out_of_nothing() {
    insta::assert_snapshot!(page("1, 1", "0, 0", "-1, 1"), @"
    Your scenario: two balls, none moving before and two after

      ball              1    2
      velocity before   0    0
      velocity after    -1   1

      law              before   after   after − before
      momentum         0        0       0                holds
      kinetic energy   0        1       +1               FAILS

    Kinetic energy would have to come from nothing (after − before = +1):
    with nothing to supply it, this outcome cannot happen.

      note: before, no ball is faster than the one on its right: none would meet, and nothing could change
    ");
}

#[test]
fn programs_get_the_same_in_exact_strings() {
    let outcome = Scenario::built_in('c').unwrap().judge();
    insta::assert_snapshot!(serde_json::to_string_pretty(&json(&outcome)).unwrap(), @r#"
    {
      "after": [
        "0",
        "0",
        "0",
        "0",
        "2"
      ],
      "before": [
        "1",
        "1",
        "0",
        "0",
        "0"
      ],
      "holds": false,
      "laws": [
        {
          "after": "2",
          "before": "2",
          "difference": "0",
          "equations": [
            "9"
          ],
          "holds": true,
          "law": "momentum",
          "ratio": "1"
        },
        {
          "after": "2",
          "before": "1",
          "difference": "1",
          "equations": [
            "10",
            "11",
            "12"
          ],
          "holds": false,
          "law": "kinetic energy",
          "ratio": "2"
        }
      ],
      "masses": [
        "1",
        "1",
        "1",
        "1",
        "1"
      ],
      "possible": false,
      "remarks": [
        "elastic collisions, pair by pair, would give (0, 0, 0, 1, 1)",
        "m = 1 and v0 = 1 lose nothing: every momentum scales with m v0, every kinetic energy with m v0²"
      ],
      "scenario": "C",
      "sentence": "two balls arrive at v0, one leaves at 2 v0"
    }
    "#);
}

#[test]
fn a_remark_gives_up_before_its_numbers_fill_the_page() {
    let (heavy, light) = ("1234567890.123456789", "0.000000123456789");
    let scenario = Scenario::new(
        list(&format!("{heavy}, {light}, {heavy}")),
        list("1, 0, -1"),
        list("0, 0, 0"),
    );
    let outcome = scenario.unwrap().judge();
    let [Remark::PairByPairUnfinished { collisions }] = outcome.remarks() else {
        panic!("{outcome:?}")
    };
    assert!(*collisions < 50, "{collisions}");
}

#[test]
fn numbers_are_listed_as_they_are_read() {
    assert_eq!(list_text(&list("1, 0.50, -2/6")), "(1, 1/2, -1/3)");
}
