//! Scaling relations: combinations of exponents and pairs of situations, forged in one thing each.

use cradle_verify::algebra::Rational;
use cradle_verify::kernel::{
    Alike, Claim, Combination, Domain, Reject, ScalingCandidate, ScalingProof, ScalingVerdict,
    Situations, Size, check_scaling,
};
use cradle_verify::search::{ScalingDecision, decide_scaling};
use cradle_verify::sorted::Map;

use super::claims::*;

fn rational(text: &str) -> Rational {
    let (above, below) = text.split_once('/').unwrap_or((text, "1"));
    Rational::ratio(above.parse().unwrap(), below.parse().unwrap())
}

fn combination(parts: &[(usize, &str)]) -> Combination {
    parts.iter().map(|&(at, c)| (at, rational(c))).collect()
}

fn proved(claim: &Claim, parts: &[(usize, &str)]) -> Result<(), Reject> {
    let proof = ScalingProof {
        alike: Vec::new(),
        combination: combination(parts),
    };
    checked(claim, ScalingCandidate::Proof(proof))
}

fn checked(claim: &Claim, candidate: ScalingCandidate) -> Result<(), Reject> {
    check_scaling(claim.clone(), candidate).map(drop)
}

/// Two situations from `quantity`, the value in the first, and the exponent of 2 by which it grows.
fn pair(values: &[(&str, &str, &str)]) -> Situations {
    let of = |&(name, first, doublings): &(&str, &str, &str)| {
        let first = Size::from(rational(first));
        let growth = Size::power(Rational::from(2), rational(doublings));
        let second = first.times(&growth, &Rational::one());
        (term(name), (first, second))
    };
    Situations {
        aside: Vec::new(),
        values: values.iter().map(of).collect(),
    }
}

fn refuted(claim: &Claim, situations: Situations) -> Result<(), Reject> {
    checked(claim, ScalingCandidate::Counterexample(situations))
}

/// `E = ½ m v²`, `m ~ ρ r³` ⊢ `E ~ ρ r³ v²`.
fn energy() -> Claim {
    claim(
        &["E = \\frac12 m v^2", "m \\sim \\rho r^3"],
        "E \\sim \\rho r^3 v^2",
    )
}

#[test]
fn combination_of_exponents_is_accepted() {
    assert_eq!(proved(&energy(), &[(0, "1"), (1, "1")]), Ok(()));
}

#[test]
fn combination_with_a_wrong_coefficient_is_rejected() {
    let forged = [(0, "1"), (1, "1/2")];
    assert_eq!(proved(&energy(), &forged), Err(Reject::IdentityFails));
}

#[test]
fn combination_that_leaves_out_a_premise_is_rejected() {
    assert_eq!(proved(&energy(), &[(0, "1")]), Err(Reject::IdentityFails));
}

#[test]
fn premise_that_is_not_there_is_rejected() {
    let forged = [(0, "1"), (1, "1"), (2, "1")];
    assert_eq!(proved(&energy(), &forged), Err(Reject::NoSuchFact(2)));
}

#[test]
fn inequality_has_no_exponents() {
    let claim = claim(&["x < y"], "x \\sim y");
    assert_eq!(proved(&claim, &[(0, "1")]), Err(Reject::NoSuchFact(0)));
}

#[test]
fn approximation_has_no_exponents() {
    let claim = claim(&["x \\approx y"], "x \\sim y");
    assert_eq!(proved(&claim, &[(0, "1")]), Err(Reject::NoSuchFact(0)));
}

#[test]
fn equation_is_no_scaling_relation() {
    let claim = claim(&["x \\sim y"], "x = y");
    assert_eq!(
        proved(&claim, &[(0, "1")]),
        Err(Reject::UnsupportedRelation)
    );
}

#[test]
fn sum_is_not_its_first_term() {
    let claim = claim(&["F = A + B"], "F \\sim A");
    assert_eq!(proved(&claim, &[(0, "1")]), Err(Reject::IdentityFails));
}

fn alike(hypotheses: &[&str], combinations: Vec<Combination>) -> Result<(), Reject> {
    let claim = claim(hypotheses, "F \\sim A");
    let proof = ScalingProof {
        alike: vec![Alike {
            term: term("A + B"),
            combinations,
        }],
        combination: combination(&[(0, "1"), (hypotheses.len(), "1"), (1, "-1")]),
    };
    checked(&claim, ScalingCandidate::Proof(proof))
}

#[test]
fn sum_of_what_is_alike_is_as_its_terms() {
    let premises = ["F = A + B", "A \\sim B"];
    assert_eq!(alike(&premises, vec![combination(&[(1, "1")])]), Ok(()));
}

#[test]
fn sum_whose_terms_are_not_shown_to_be_alike_is_rejected() {
    let premises = ["F = A + B", "A \\sim B"];
    let wrong = vec![combination(&[(1, "-1")])];
    assert_eq!(alike(&premises, wrong), Err(Reject::IdentityFails));
    assert_eq!(alike(&premises, Vec::new()), Err(Reject::IdentityFails));
    let circular = vec![combination(&[(0, "1")])];
    assert_eq!(alike(&premises, circular), Err(Reject::IdentityFails));
}

#[test]
fn product_is_no_sum_whose_terms_could_be_alike() {
    let claim = claim(&[], "A \\sim B");
    let proof = ScalingProof {
        alike: vec![Alike {
            term: term("A B"),
            combinations: Vec::new(),
        }],
        combination: Vec::new(),
    };
    assert_eq!(
        checked(&claim, ScalingCandidate::Proof(proof)),
        Err(Reject::NotAProduct(term("A B")))
    );
}

#[test]
fn value_at_one_point_says_nothing_of_what_is_integrated() {
    let premises = ["E = \\int_0^T P(t) \\, dt", "P(t) \\sim Q"];
    let throughout = claim(&premises, "E \\sim Q T");
    let forged = throughout.clone().at_point(1);
    let parts = [(0, "1"), (1, "1")];
    assert_eq!(proved(&throughout, &parts), Ok(()));
    assert_eq!(proved(&forged, &parts), Err(Reject::NoSuchFact(1)));
}

#[test]
fn integral_from_elsewhere_than_zero_is_no_product() {
    let claim = claim(&["E = \\int_S^T Q \\, dt"], "E \\sim Q T");
    assert_eq!(proved(&claim, &[(0, "1")]), Err(Reject::IdentityFails));
}

#[test]
fn integral_that_has_no_value_is_no_product() {
    let claim = claim(&["E = \\int_0^T \\frac{q}{t^2} \\, dt"], "E \\sim q T^{-1}");
    assert_eq!(proved(&claim, &[(0, "1")]), Err(Reject::IdentityFails));
}

#[test]
fn two_integrals_over_one_variable_do_not_make_their_limits_alike() {
    let premises = [
        "E = \\int_0^T q \\, dt",
        "F = \\int_0^S q \\, dt",
        "x = c t",
    ];
    let claim = claim(&premises, "S \\sim T");
    for row in 3..5 {
        assert_eq!(proved(&claim, &[(row, "1")]), Err(Reject::NoSuchFact(row)));
    }
}

#[test]
fn proportionality_hides_what_is_constant() {
    let open = claim(&["x \\propto y"], "x \\sim y");
    assert_eq!(proved(&open, &[(0, "1")]), Err(Reject::NoSuchFact(0)));
    let same = claim(&["x \\propto y"], "x \\propto y");
    assert_eq!(proved(&same, &[(0, "1")]), Ok(()));
    let named = claim(&["x \\propto y"], "k x \\propto k y").domain("k", constant());
    // k divides out of the goal, but the goal speaks of situations in which it varies.
    assert_eq!(proved(&named, &[(0, "1")]), Err(Reject::NoSuchFact(0)));
}

#[test]
fn constant_varies_between_situations_unless_the_relation_holds_it() {
    let scales = claim(&["x = k y"], "x \\sim y").domain("k", constant());
    assert_eq!(proved(&scales, &[(0, "1")]), Err(Reject::IdentityFails));
    let proportional = claim(&["x = k y"], "x \\propto y").domain("k", constant());
    assert_eq!(proved(&proportional, &[(0, "1")]), Ok(()));
    let named = claim(&["x = k y"], "x \\propto y k^2").domain("k", constant());
    assert_eq!(proved(&named, &[(0, "1")]), Err(Reject::IdentityFails));
}

#[test]
fn declared_pi_is_a_quantity() {
    let number = claim(&["x = \\pi y"], "x \\sim y");
    assert_eq!(proved(&number, &[(0, "1")]), Ok(()));
    let quantity = number.domain("\\pi", positive());
    assert_eq!(proved(&quantity, &[(0, "1")]), Err(Reject::IdentityFails));
}

/// `E = ½ m v²` ⊬ `E ~ m v`.
fn slip() -> Claim {
    claim(&["E = \\frac12 m v^2"], "E \\sim m v")
}

#[test]
fn two_situations_are_accepted() {
    let situations = pair(&[("E", "1/2", "2"), ("m", "1", "0"), ("v", "1", "1")]);
    assert_eq!(refuted(&slip(), situations), Ok(()));
}

#[test]
fn premise_that_is_false_in_the_first_situation_is_noticed() {
    let situations = pair(&[("E", "1", "2"), ("m", "1", "0"), ("v", "1", "1")]);
    assert_eq!(refuted(&slip(), situations), Err(Reject::PremiseFalse(0)));
}

#[test]
fn premise_that_is_false_in_the_second_situation_is_noticed() {
    let situations = pair(&[("E", "1/2", "3"), ("m", "1", "0"), ("v", "1", "1")]);
    assert_eq!(refuted(&slip(), situations), Err(Reject::PremiseFalse(0)));
}

#[test]
fn goal_that_stays_true_is_no_counterexample() {
    let situations = pair(&[("E", "1/2", "1"), ("m", "1", "1"), ("v", "1", "0")]);
    assert_eq!(refuted(&slip(), situations), Err(Reject::GoalNotFalse));
}

#[test]
fn quantity_without_a_value_is_noticed() {
    let situations = pair(&[("E", "1/2", "2"), ("v", "1", "1")]);
    assert_eq!(refuted(&slip(), situations), Err(Reject::NoValue));
}

#[test]
fn sizes_are_positive() {
    let mut situations = pair(&[("E", "1/2", "2"), ("m", "1", "0"), ("v", "1", "1")]);
    let minus = Size::from(rational("-1"));
    situations.values.insert(term("m"), (minus.clone(), minus));
    assert_eq!(refuted(&slip(), situations), Err(Reject::OutsideDomain));
}

#[test]
fn situation_outside_of_a_domain_is_noticed() {
    let unit = Domain {
        lower: Some((number(0), false)),
        upper: Some((number(1), false)),
        ..Domain::default()
    };
    let claim = claim(&["x = e^2 y"], "x \\sim e y").domain("e", unit);
    let inside = pair(&[("x", "1/16", "2"), ("e", "1/4", "1"), ("y", "1", "0")]);
    assert_eq!(refuted(&claim, inside), Ok(()));
    let outside = pair(&[("x", "1", "2"), ("e", "1", "1"), ("y", "1", "0")]);
    assert_eq!(refuted(&claim, outside), Err(Reject::OutsideDomain));
}

#[test]
fn inequality_is_looked_at_in_both_situations() {
    let claim = claim(&["x \\leq 3"], "y \\sim x");
    let fine = pair(&[("x", "1", "1"), ("y", "1", "0")]);
    assert_eq!(refuted(&claim, fine), Ok(()));
    let beyond = pair(&[("x", "2", "1"), ("y", "1", "0")]);
    assert_eq!(refuted(&claim, beyond), Err(Reject::PremiseFalse(0)));
}

#[test]
fn approximation_is_known_nowhere() {
    let claim = claim(&["x \\approx y"], "x \\sim y");
    let situations = pair(&[("x", "1", "1"), ("y", "1", "0")]);
    assert_eq!(refuted(&claim, situations), Err(Reject::NoValue));
}

#[test]
fn sum_is_evaluated() {
    let claim = claim(&["F = A + B"], "F \\sim A");
    let mut situations = pair(&[("F", "3", "0"), ("A", "1", "1"), ("B", "2", "0")]);
    let four = Size::from(rational("4"));
    let three = Size::from(rational("3"));
    assert_eq!(
        refuted(&claim, situations.clone()),
        Err(Reject::PremiseFalse(0))
    );
    situations.values.insert(term("F"), (three, four));
    assert_eq!(refuted(&claim, situations), Ok(()));
}

#[test]
fn premise_is_set_aside_only_if_nothing_else_speaks_of_it() {
    let apart = claim(&["F = A + B", "y = x^2"], "y \\sim x");
    let values = [
        ("A", "1", "0"),
        ("B", "1", "0"),
        ("x", "1", "1"),
        ("y", "1", "2"),
    ];
    let mut situations = pair(&values);
    situations.aside = vec![0];
    assert_eq!(refuted(&apart, situations.clone()), Ok(()));
    let spoken_of = claim(&["F = A + B", "y = x^2"], "y \\sim F x");
    assert_eq!(
        refuted(&spoken_of, situations.clone()),
        Err(Reject::NotSetAside(0))
    );
    let difference = claim(&["F = \\sqrt{A - B}", "y = x^2"], "y \\sim x");
    assert_eq!(
        refuted(&difference, situations.clone()),
        Err(Reject::NotSetAside(0))
    );
    let bounded = apart.domain(
        "F",
        Domain {
            upper: Some((number(1), false)),
            ..Domain::default()
        },
    );
    assert_eq!(refuted(&bounded, situations), Err(Reject::NotSetAside(0)));
}

#[test]
fn function_has_one_value_for_the_same_arguments() {
    let claim = claim(&[], "F(x) \\sim F(y)");
    let same = pair(&[
        ("F(x)", "1", "1"),
        ("F(y)", "1", "0"),
        ("x", "1", "0"),
        ("y", "1", "0"),
    ]);
    assert_eq!(refuted(&claim, same), Err(Reject::NoValue));
    let apart = pair(&[
        ("F(x)", "1", "1"),
        ("F(y)", "1", "0"),
        ("x", "1", "0"),
        ("y", "3", "0"),
    ]);
    assert_eq!(refuted(&claim, apart), Ok(()));
}

#[test]
fn pi_stays_what_it_is() {
    let claim = claim(&["x = \\pi y^2"], "x \\sim y");
    let changed = pair(&[("x", "1", "1"), ("\\pi", "1", "1"), ("y", "1", "0")]);
    assert_eq!(refuted(&claim, changed), Err(Reject::OutsideDomain));
    let mut values = Map::new();
    let one = Size::one();
    let four = Size::from(rational("4")).times(&Size::pi(), &Rational::one());
    values.insert(term("x"), (Size::pi(), four));
    values.insert(term("\\pi"), (Size::pi(), Size::pi()));
    values.insert(term("y"), (one, Size::from(rational("2"))));
    let situations = Situations {
        aside: Vec::new(),
        values,
    };
    assert_eq!(refuted(&claim, situations), Ok(()));
}

#[test]
fn what_is_held_must_not_change() {
    let claim = claim(&["x = k y"], "x \\propto y").domain("k", constant());
    let situations = pair(&[("x", "1", "1"), ("k", "1", "1"), ("y", "1", "0")]);
    assert_eq!(refuted(&claim, situations), Err(Reject::OutsideDomain));
}

#[test]
fn what_is_constant_is_taken_out_of_a_slope() {
    let own = claim(&["F = \\frac{d}{dx}\\left[k x^2\\right]"], "F \\sim k x");
    // What may move has a slope of its own, and the whole is a sum then.
    assert!(proved(&own, &[(0, "1")]).is_err());
    let held = own.domain("k", constant());
    assert_eq!(proved(&held, &[(0, "1")]), Ok(()));
}

#[test]
fn what_stands_still_has_no_slope() {
    let premises = ["E = \\int_0^T x \\, dt", "v \\sim \\frac{dx}{dt}"];
    let claim = claim(&premises, "E \\sim v");
    let situations = pair(&[
        ("E", "1", "1"),
        ("T", "1", "0"),
        ("x", "1", "1"),
        ("v", "1", "0"),
        ("t", "1", "1"),
    ]);
    assert_eq!(refuted(&claim, situations), Err(Reject::NoValue));
}

#[test]
fn sequence_is_not_two_numbers() {
    let claim = claim(&["u_1 \\sim x"], "x \\sim y").sequence("u");
    let situations = pair(&[("u_1", "1", "1"), ("x", "1", "1"), ("y", "1", "0")]);
    assert_eq!(refuted(&claim, situations), Err(Reject::NoValue));
}

/// What the search makes of a claim.
fn decided(claim: &Claim) -> &'static str {
    match decide_scaling(claim) {
        ScalingDecision::Proven(_) => "holds",
        ScalingDecision::Refuted { .. } => "fails",
        ScalingDecision::Open(_) => "undecided",
    }
}

#[test]
fn unrelated_hypotheses_prove_nothing() {
    let premises = [
        "a \\sim b^2",
        "F = A + B",
        "c < d",
        "E = \\int_0^T P(t) \\, dt",
    ];
    assert_eq!(decided(&claim(&premises, "x \\sim y")), "fails");
}

#[test]
fn what_is_found_goes_through_the_kernel() {
    let claim = energy();
    let ScalingDecision::Proven(proven) = decide_scaling(&claim) else {
        panic!("not proved");
    };
    let again = ScalingCandidate::Proof(proven.proof().clone());
    let verdict = check_scaling(proven.claim().clone(), again);
    assert!(matches!(verdict, Ok(ScalingVerdict::Proven(_))));
}

#[test]
fn repair_is_proved_itself() {
    let ScalingDecision::Refuted { repair, .. } = decide_scaling(&slip()) else {
        panic!("not refuted");
    };
    let repair = repair.expect("a repair");
    let wanted = formula("E \\sim m v^2");
    let (found, wanted) = (&repair.proven.claim().goal, &wanted);
    assert_eq!(
        decided(&claim(&["E = \\frac12 m v^2"], "E \\sim m v^2")),
        "holds"
    );
    assert_eq!(
        cradle_verify::notation::latex_formula(found),
        cradle_verify::notation::latex_formula(wanted)
    );
    assert!(!repair.one_of_many);
}

/// `base^exponent` and powers of others, as whoever forges a certificate may write them.
fn size(powers: &[(i32, (i32, i32))]) -> Size {
    let power = |(base, (above, below)): &(i32, (i32, i32))| {
        (Rational::from(*base), Rational::ratio(*above, *below))
    };
    Size {
        powers: powers.iter().map(power).collect(),
        pi: Rational::zero(),
    }
}

#[test]
fn one_power_is_compared_however_long_it_is() {
    use std::cmp::Ordering::{Equal, Greater, Less};
    let against = |powers: &[(i32, (i32, i32))]| size(powers).against_one();
    assert_eq!(against(&[(2, (1_000_003, 999_999))]), Ok(Greater));
    assert_eq!(against(&[(2, (-1_000_003, 999_999))]), Ok(Less));
    assert_eq!(against(&[(2, (0, 1))]), Ok(Equal));
    assert_eq!(against(&[(1, (5, 1))]), Ok(Equal));
    assert_eq!(size(&[(2, (1_000_003, 999_999))]).is_one(), Ok(false));
    // What is not positive is computed: its power may be 1.
    assert_eq!(against(&[(-1, (2, 1))]), Ok(Equal));
    assert_eq!(against(&[(-2, (3, 1))]), Ok(Less));
    assert_eq!(against(&[(2, (1, 2)), (3, (-1, 2))]), Ok(Less));
    let with_pi = Size {
        pi: Rational::one(),
        ..size(&[(2, (1, 1))])
    };
    assert_eq!(with_pi.is_one(), Ok(false));
    assert!(with_pi.against_one().is_err());
}

#[test]
fn absolute_value_of_something_negative_is_positive() {
    let plain = claim(&["y = \\left| -x \\right|"], "y \\sim x^2");
    let situations = pair(&[("y", "1", "1"), ("x", "1", "1")]);
    assert!(refuted(&plain, situations).is_ok());
    let root = claim(&["y = \\left| (-x)^{1/3} \\right|"], "y \\sim x");
    let situations = pair(&[("y", "1", "1"), ("x", "1", "3")]);
    assert!(refuted(&root, situations).is_ok());
}

#[test]
fn slope_has_no_value_in_two_situations() {
    // A slope grows as the quotient does; that it is the quotient nobody says.
    let claim = claim(&["v = \\frac{dx}{dt}"], "v \\sim x");
    let situations = pair(&[("v", "1", "1"), ("x", "1", "0"), ("t", "1", "-1")]);
    assert_eq!(refuted(&claim, situations), Err(Reject::NoValue));
}
