//! One rule after the other: a proof that is accepted, then the proofs that are not.

use cradle_verify::kernel::{Fact, Lemma, PositiveTerm, Proof, Reject, SeriesSquare, Sign};
use proptest::prelude::*;

use super::claims::*;

/// `x y = 2 x`, `x ≠ 0` ⊢ `y = 2`.
fn divided_out() -> Proving {
    Proving::new(claim(&["x y = 2 x", r"x \neq 0"], "y = 2"))
}

#[test]
fn linear_combination_is_accepted() {
    let p = Proving::new(claim(&["a + b = 3", "a - b = 1"], "a = 2"));
    let proof = p.combination(&[], 1, &[(0, "1/2"), (1, "1/2")]);
    assert_eq!(p.checked(proof), Ok(()));
}

#[test]
fn combination_with_a_wrong_coefficient_is_rejected() {
    let p = Proving::new(claim(&["a + b = 3", "a - b = 1"], "a = 2"));
    let proof = p.combination(&[], 1, &[(0, "1/2"), (1, "1/3")]);
    assert_eq!(p.checked(proof), Err(Reject::IdentityFails));
}

#[test]
fn combination_that_leaves_out_a_premise_is_rejected() {
    let p = Proving::new(claim(&["a + b = 3", "a - b = 1"], "a = 2"));
    let proof = p.combination(&[], 1, &[(0, "1/2")]);
    assert_eq!(p.checked(proof), Err(Reject::IdentityFails));
}

#[test]
fn premise_named_twice_counts_twice() {
    let p = Proving::new(claim(&["a + b = 3", "a - b = 1"], "a = 2"));
    let proof = p.combination(&[], 1, &[(0, "1/4"), (1, "1/2"), (0, "1/4")]);
    assert_eq!(p.checked(proof), Ok(()));
    let proof = p.combination(&[], 1, &[(0, "1/2"), (1, "1/2"), (0, "1/2")]);
    assert_eq!(p.checked(proof), Err(Reject::IdentityFails));
}

#[test]
fn multiplier_known_not_to_vanish_is_accepted() {
    let p = divided_out();
    let proof = p.combination(&[("x", 1)], 1, &[(0, "1")]);
    assert_eq!(p.checked(proof), Ok(()));
}

#[test]
fn multiplier_that_may_vanish_is_rejected() {
    let p = Proving::new(claim(&["x y = 2 x", r"x \geq 0"], "y = 2"));
    let proof = p.combination(&[("x", 1)], 1, &[(0, "1")]);
    assert_eq!(p.checked(proof), Err(Reject::MayVanish(term("x"))));
}

#[test]
fn multiplier_zero_is_rejected() {
    let p = divided_out();
    let proof = p.combination(&[("0", 1)], 1, &[]);
    assert_eq!(p.checked(proof), Err(Reject::MayVanish(term("0"))));
}

#[test]
fn multiplier_is_judged_even_to_the_power_0() {
    let p = Proving::new(claim(&["a = 0"], "a = 0"));
    let proof = p.combination(&[("a", 0)], 1, &[(0, "1")]);
    assert_eq!(p.checked(proof), Err(Reject::MayVanish(term("a"))));
}

#[test]
fn empty_multiplier_is_1_and_not_0() {
    let p = divided_out();
    let proof = p.combination(&[], 1, &[(0, "1")]);
    assert_eq!(p.checked(proof), Err(Reject::IdentityFails));
}

#[test]
fn sum_of_two_factors_that_do_not_vanish_may_vanish() {
    let p = Proving::new(claim(&[r"x \neq 0", r"y \neq 0", "(x + y) z = 0"], "z = 0"));
    let proof = p.combination(&[("x + y", 1)], 1, &[(2, "1")]);
    assert!(matches!(p.checked(proof), Err(Reject::MayVanish(_))));
}

#[test]
fn product_of_factors_that_do_not_vanish_is_accepted() {
    let p = Proving::new(claim(&[r"x \neq 0", r"y \neq 0", "x^2 y z = 0"], "z = 0"));
    let proof = p.combination(&[("x^2 y", 1)], 1, &[(2, "1")]);
    assert_eq!(p.checked(proof), Ok(()));
}

#[test]
fn power_of_the_goal_is_accepted() {
    let p = Proving::new(claim(&["x^2 = 0"], "x = 0"));
    assert_eq!(p.checked(p.combination(&[], 2, &[(0, "1")])), Ok(()));
}

#[test]
fn power_0_of_the_goal_is_rejected() {
    let p = Proving::new(claim(&["x^2 = 0"], "x = 0"));
    let proof = p.combination(&[], 0, &[(0, "1")]);
    assert_eq!(p.checked(proof), Err(Reject::ZeroPower));
    // Even where 1 is a combination of contradictory premises.
    let p = Proving::new(claim(&["x = 0", "x = 1"], "y = 0"));
    let proof = p.combination(&[], 0, &[(0, "1"), (1, "-1")]);
    assert_eq!(p.checked(proof), Err(Reject::ZeroPower));
}

#[test]
fn contradictory_equations_prove_anything() {
    let p = Proving::new(claim(&["x = 0", "x = 1"], "y = 0"));
    let proof = p.combination(&[], 1, &[(0, "y"), (1, "-y")]);
    assert_eq!(p.checked(proof), Ok(()));
}

#[test]
fn fact_out_of_range_is_rejected() {
    let p = divided_out();
    let proof = Proof::Combination {
        multiplier: p.factors(&[("x", 1)]),
        power: 1,
        cofactors: vec![(99, p.p("1"))],
    };
    assert_eq!(p.checked(proof), Err(Reject::NoSuchFact(99)));
}

#[test]
fn inequality_is_no_equation() {
    for hypothesis in [r"y \neq 2", r"y \geq 2", "y > 2", r"y \leq 2", "y < 2"] {
        let p = Proving::new(claim(&[hypothesis], "y = 2"));
        let proof = p.combination(&[], 1, &[(0, "1")]);
        assert_eq!(p.checked(proof), Err(Reject::NoSuchFact(0)), "{hypothesis}");
    }
}

#[test]
fn relations_without_an_exact_meaning_give_no_fact() {
    for hypothesis in [r"y \approx 2", r"y \gg 2"] {
        let p = Proving::new(claim(&[hypothesis], "y = 2"));
        assert!(p.problem.facts.is_empty(), "{hypothesis}");
    }
}

#[test]
fn scaling_relation_says_at_one_point_that_its_sides_are_sizes_and_no_more() {
    for hypothesis in [r"y \sim 2 x", r"y \propto 2 x"] {
        let p = Proving::new(claim(&[hypothesis], "y = 2 x"));
        let sides = Fact {
            polynomial: p.p("2 x y"),
            sign: Sign::NonZero,
        };
        assert_eq!(p.problem.facts, vec![sides], "{hypothesis}");
    }
}

#[test]
fn goal_without_an_exact_meaning_is_rejected() {
    use cradle_verify::kernel::{Candidate, Certificate, check};
    let certificate = Certificate {
        rates: Vec::new(),
        unfold: vec![],
        lemmas: vec![],
        conclusion: divided_out().combination(&[], 1, &[]),
    };
    for goal in [r"y \approx y", r"y \sim y", r"y \propto y", r"y \ll y"] {
        let proof = Candidate::Proof(certificate.clone());
        let verdict = check(claim(&[], goal), proof).map(|_| ());
        assert_eq!(verdict, Err(Reject::UnsupportedRelation), "{goal}");
    }
}

#[test]
fn non_vanishing_is_accepted() {
    let p = Proving::new(claim(&["x y = 1"], r"x \neq 0"));
    assert_eq!(p.checked(p.non_vanishing(&[], "y", &[(0, "-1")])), Ok(()));
}

#[test]
fn non_vanishing_forgeries_are_rejected() {
    let p = Proving::new(claim(&["x y = 1"], r"x \neq 0"));
    let wrong = p.non_vanishing(&[], "y", &[(0, "1")]);
    assert_eq!(p.checked(wrong), Err(Reject::IdentityFails));
    let begged = p.non_vanishing(&[("x", 1)], "1", &[]);
    assert_eq!(p.checked(begged), Err(Reject::MayVanish(term("x"))));
    let nothing = p.non_vanishing(&[("0", 1)], "0", &[]);
    assert_eq!(p.checked(nothing), Err(Reject::MayVanish(term("0"))));
}

#[test]
fn proof_of_another_kind_than_the_goal_is_rejected() {
    let goals = [
        ("x = 0", Sign::Zero),
        (r"x \neq 0", Sign::NonZero),
        (r"x \geq 0", Sign::NonNegative),
        ("x > 0", Sign::Positive),
    ];
    for (goal, sign) in goals {
        let p = Proving::new(claim(&[], goal));
        let positivity = || p.positivity(&[], vec![], &[]);
        let proofs = [
            (p.combination(&[], 1, &[]), vec![Sign::Zero]),
            (p.non_vanishing(&[], "0", &[]), vec![Sign::NonZero]),
            (positivity(), vec![Sign::NonNegative, Sign::Positive]),
            (Proof::Square(positivity().into()), vec![Sign::Zero]),
            (
                Proof::Larger {
                    larger: p.p("0"),
                    squares: positivity().into(),
                },
                vec![Sign::NonNegative, Sign::Positive],
            ),
            (
                Proof::BothBounds {
                    below: positivity().into(),
                    above: positivity().into(),
                },
                vec![Sign::Zero],
            ),
        ];
        for (proof, fits) in proofs {
            let verdict = p.checked(proof.clone());
            assert!(verdict.is_err());
            let wrong_kind = verdict == Err(Reject::WrongKind);
            assert_eq!(wrong_kind, !fits.contains(&sign), "{goal}: {proof:?}");
        }
    }
}

#[test]
fn inner_proof_of_another_kind_is_rejected() {
    let p = Proving::new(claim(&[], "x = 0"));
    let inner = p.combination(&[], 1, &[]);
    let proof = Proof::Square(inner.clone().into());
    assert_eq!(p.checked(proof), Err(Reject::WrongKind));
    let proof = Proof::BothBounds {
        below: inner.clone().into(),
        above: inner.into(),
    };
    assert_eq!(p.checked(proof), Err(Reject::WrongKind));
}

/// `b ≤ a`, or `b < a`, from `b² ≤ a²`.
fn smaller_square(premises: &[&str], goal: &str, larger: &str) -> Result<(), Reject> {
    let p = Proving::new(claim(premises, goal));
    let term = PositiveTerm {
        facts: vec![p.hypothesis(0)],
        ..one()
    };
    p.checked(Proof::Larger {
        larger: p.p(larger),
        squares: p.positivity(&[], vec![term], &[]).into(),
    })
}

#[test]
fn what_has_no_greater_square_is_no_greater() {
    let nonnegative = ["b^2 \\leq a^2", "a \\geq 0"];
    assert_eq!(smaller_square(&nonnegative, "b \\leq a", "a"), Ok(()));
    let strict = ["b^2 < a^2", "a \\geq 0"];
    assert_eq!(smaller_square(&strict, "b < a", "a"), Ok(()));
    assert_eq!(
        smaller_square(&nonnegative, "b < a", "a"),
        Err(Reject::NotStrict)
    );
    assert_eq!(
        smaller_square(&["b^2 \\leq a^2"], "b \\leq a", "a"),
        Err(Reject::MayBeNegative(term("a")))
    );
    assert_eq!(
        smaller_square(&["b^2 \\leq a^2", "b \\geq 0"], "b \\leq a", "a"),
        Err(Reject::MayBeNegative(term("a")))
    );
    assert_eq!(
        smaller_square(&["b^2 \\leq a^2 + 1", "a \\geq 0"], "b \\leq a", "a"),
        Err(Reject::IdentityFails)
    );
    assert_eq!(
        smaller_square(&nonnegative, "b \\leq a", "2 a"),
        Err(Reject::IdentityFails)
    );
}

/// `a² + b² ≥ 2ab`.
fn means() -> (Proving, PositiveTerm) {
    let p = Proving::new(claim(&[], r"a^2 + b^2 \geq 2 a b"));
    let square = PositiveTerm {
        squares: vec![p.p("a - b")],
        ..one()
    };
    (p, square)
}

#[test]
fn square_is_accepted() {
    let (p, square) = means();
    assert_eq!(p.checked(p.positivity(&[], vec![square], &[])), Ok(()));
}

#[test]
fn square_of_the_wrong_thing_is_rejected() {
    let (p, mut square) = means();
    square.squares = vec![p.p("a + b")];
    let proof = p.positivity(&[], vec![square], &[]);
    assert_eq!(p.checked(proof), Err(Reject::IdentityFails));
}

#[test]
fn negative_coefficient_is_rejected() {
    let p = Proving::new(claim(&[], r"2 a b \geq a^2 + b^2"));
    let square = PositiveTerm {
        coefficient: (-1).into(),
        squares: vec![p.p("a - b")],
        ..one()
    };
    let proof = p.positivity(&[], vec![square], &[]);
    assert_eq!(p.checked(proof), Err(Reject::NegativeCoefficient));
}

#[test]
fn square_alone_does_not_make_a_goal_strict() {
    let p = Proving::new(claim(&[], r"a^2 + b^2 > 2 a b"));
    let square = PositiveTerm {
        squares: vec![p.p("a - b")],
        ..one()
    };
    let proof = p.positivity(&[], vec![square], &[]);
    assert_eq!(p.checked(proof), Err(Reject::NotStrict));
}

#[test]
fn square_of_what_does_not_vanish_is_strict() {
    let p = Proving::new(claim(&[r"a - b \neq 0"], r"a^2 + b^2 > 2 a b"));
    let square = PositiveTerm {
        squares: vec![p.p("a - b")],
        ..one()
    };
    assert_eq!(p.checked(p.positivity(&[], vec![square], &[])), Ok(()));
}

#[test]
fn term_with_coefficient_0_is_not_strict() {
    let p = Proving::new(claim(&["a = 0"], "a > 0"));
    let nothing = PositiveTerm {
        coefficient: 0.into(),
        ..one()
    };
    let proof = p.positivity(&[], vec![nothing], &[(0, "1")]);
    assert_eq!(p.checked(proof), Err(Reject::NotStrict));
}

#[test]
fn goal_without_a_term_is_not_strict() {
    let p = Proving::new(claim(&["a = 0"], "a > 0"));
    let proof = p.positivity(&[], vec![], &[(0, "1")]);
    assert_eq!(p.checked(proof), Err(Reject::NotStrict));
}

#[test]
fn weak_inequality_does_not_make_a_goal_strict() {
    for (relation, verdict) in [(">", Ok(())), (r"\geq", Err(Reject::NotStrict))] {
        let p = Proving::new(claim(&[&format!("a {relation} 1")], "a > 1"));
        let fact = PositiveTerm {
            facts: vec![p.hypothesis(0)],
            ..one()
        };
        assert_eq!(p.checked(p.positivity(&[], vec![fact], &[])), verdict);
    }
}

#[test]
fn product_of_a_strict_and_a_weak_fact_is_not_strict() {
    let p = Proving::new(claim(&["a > 0", r"b \geq 0"], "a b > 0"));
    let both = PositiveTerm {
        facts: vec![p.hypothesis(0), p.hypothesis(1)],
        ..one()
    };
    let proof = p.positivity(&[], vec![both], &[]);
    assert_eq!(p.checked(proof), Err(Reject::NotStrict));
}

#[test]
fn series_is_never_strict() {
    let p =
        Proving::new(claim(&[], r"n \sum_{i=1}^{n} u_i^2 > (\sum_{i=1}^{n} u_i)^2").sequence("u"));
    let proof = p.positivity(&[], vec![spread("n", "u")], &[]);
    assert_eq!(p.checked(proof), Err(Reject::NotStrict));
}

#[test]
fn equation_is_no_inequality() {
    let p = Proving::new(claim(&["a = 1"], r"a \geq 1"));
    let fact = PositiveTerm {
        facts: vec![p.hypothesis(0)],
        ..one()
    };
    let proof = p.positivity(&[], vec![fact], &[]);
    assert_eq!(p.checked(proof), Err(Reject::NoSuchFact(0)));
    assert_eq!(p.checked(p.positivity(&[], vec![], &[(0, "1")])), Ok(()));
}

#[test]
fn unequal_is_no_inequality() {
    let p = Proving::new(claim(&[r"a \neq 1"], r"a \geq 1"));
    let fact = PositiveTerm {
        facts: vec![p.hypothesis(0)],
        ..one()
    };
    let proof = p.positivity(&[], vec![fact], &[]);
    assert_eq!(p.checked(proof), Err(Reject::NoSuchFact(0)));
}

#[test]
fn inequality_fact_out_of_range_is_rejected() {
    let p = Proving::new(claim(&["a > 1"], r"a \geq 1"));
    let fact = PositiveTerm {
        facts: vec![1],
        ..one()
    };
    let proof = p.positivity(&[], vec![fact], &[]);
    assert_eq!(p.checked(proof), Err(Reject::NoSuchFact(1)));
}

#[test]
fn factor_that_may_be_negative_is_rejected() {
    for (hypothesis, accepted) in [(r"a \geq 0", true), (r"a \neq 0", false), ("a < 0", false)] {
        let p = Proving::new(claim(&[hypothesis], r"a^3 \geq 0"));
        let factor = |exponent| PositiveTerm {
            factors: p.factors(&[("a", exponent)]),
            ..one()
        };
        let verdict = p.checked(p.positivity(&[], vec![factor(3)], &[]));
        match accepted {
            true => assert_eq!(verdict, Ok(())),
            false => assert_eq!(verdict, Err(Reject::MayBeNegative(term("a")))),
        }
        // An even power needs no sign, but is another power.
        let verdict = p.checked(p.positivity(&[], vec![factor(2)], &[]));
        assert_eq!(verdict, Err(Reject::IdentityFails));
    }
}

#[test]
fn difference_of_positive_things_may_be_negative() {
    let p = Proving::new(claim(&["a > 0", "b > 0"], r"a - b \geq 0"));
    let factor = PositiveTerm {
        factors: p.factors(&[("a - b", 1)]),
        ..one()
    };
    let proof = p.positivity(&[], vec![factor], &[]);
    assert!(matches!(p.checked(proof), Err(Reject::MayBeNegative(_))));
}

#[test]
fn multiplier_of_an_inequality_must_be_positive() {
    let goal = r"y \geq 0";
    for (known, accepted) in [
        ("x > 0", true),
        (r"x \geq 0", false),
        (r"x \neq 0", false),
        ("x < 0", false),
    ] {
        let p = Proving::new(claim(&[r"x y \geq 0", known], goal));
        let fact = || PositiveTerm {
            facts: vec![p.hypothesis(0)],
            ..one()
        };
        let verdict = p.checked(p.positivity(&[("x", 1)], vec![fact()], &[]));
        match accepted {
            true => assert_eq!(verdict, Ok(())),
            false => assert_eq!(verdict, Err(Reject::MayBeNegative(term("x")))),
        }
    }
}

#[test]
fn even_power_of_what_does_not_vanish_is_a_positive_multiplier() {
    for (known, accepted) in [(r"x \neq 0", true), (r"x \geq 0", false)] {
        let p = Proving::new(claim(&[r"x^2 y \geq 0", known], r"y \geq 0"));
        let fact = PositiveTerm {
            facts: vec![p.hypothesis(0)],
            ..one()
        };
        let verdict = p.checked(p.positivity(&[("x", 2)], vec![fact], &[]));
        match accepted {
            true => assert_eq!(verdict, Ok(())),
            false => assert_eq!(verdict, Err(Reject::MayBeNegative(term("x")))),
        }
    }
}

#[test]
fn both_bounds_are_needed() {
    let p = Proving::new(claim(&[r"a \geq b", r"a \leq b"], "a = b"));
    let bound = |at| {
        let fact = PositiveTerm {
            facts: vec![p.hypothesis(at)],
            ..one()
        };
        Box::new(p.positivity(&[], vec![fact], &[]))
    };
    let proof = |below, above| Proof::BothBounds {
        below: bound(below),
        above: bound(above),
    };
    assert_eq!(p.checked(proof(0, 1)), Ok(()));
    for (below, above) in [(0, 0), (1, 1), (1, 0)] {
        let verdict = p.checked(proof(below, above));
        assert_eq!(verdict, Err(Reject::IdentityFails), "{below} {above}");
    }
}

#[test]
fn vanishing_sum_of_squares_makes_its_terms_vanish() {
    let p = Proving::new(claim(&["a^2 + b^2 = 0"], "a = 0"));
    let square = |of| PositiveTerm {
        squares: vec![p.p(of)],
        ..one()
    };
    let proof = |of, cofactor| {
        let inner = p.positivity(&[], vec![square(of)], &[(0, cofactor)]);
        Proof::Square(inner.into())
    };
    assert_eq!(p.checked(proof("b", "-1")), Ok(()));
    assert_eq!(p.checked(proof("b", "1")), Err(Reject::IdentityFails));
    assert_eq!(p.checked(proof("a", "-1")), Err(Reject::IdentityFails));
}

#[test]
fn vanishing_difference_of_squares_does_not() {
    let p = Proving::new(claim(&["a^2 - b^2 = 0"], "a = 0"));
    let square = PositiveTerm {
        coefficient: (-1).into(),
        squares: vec![p.p("b")],
        ..one()
    };
    let inner = p.positivity(&[], vec![square], &[(0, "-1")]);
    let verdict = p.checked(Proof::Square(inner.into()));
    assert_eq!(verdict, Err(Reject::NegativeCoefficient));
}

/// `n Σu² − (Σu)²`.
fn spread(count: &str, sequence: &str) -> PositiveTerm {
    PositiveTerm {
        series: vec![SeriesSquare {
            count: symbol(count),
            f: vec![(symbol(sequence), 1)],
            g: vec![],
        }],
        ..one()
    }
}

#[test]
fn cauchy_schwarz_is_accepted() {
    let p = Proving::new(
        claim(&[], r"n \sum_{i=1}^{n} u_i^2 \geq (\sum_{i=1}^{n} u_i)^2").sequence("u"),
    );
    let proof = p.positivity(&[], vec![spread("n", "u")], &[]);
    assert_eq!(p.checked(proof), Ok(()));
    let goal = r"\sum_{i=1}^{n} u_i^2 \sum_{i=1}^{n} w_i^2 \geq (\sum_{i=1}^{n} u_i w_i)^2";
    let p = Proving::new(claim(&[], goal).sequence("u").sequence("w"));
    let mut both = spread("n", "u");
    both.series[0].g = vec![(symbol("w"), 1)];
    assert_eq!(p.checked(p.positivity(&[], vec![both], &[])), Ok(()));
}

#[test]
fn cauchy_schwarz_backwards_is_rejected() {
    let p = Proving::new(
        claim(&[], r"n \sum_{i=1}^{n} u_i^2 \leq (\sum_{i=1}^{n} u_i)^2").sequence("u"),
    );
    let proof = p.positivity(&[], vec![spread("n", "u")], &[]);
    assert_eq!(p.checked(proof), Err(Reject::IdentityFails));
    let mut negative = spread("n", "u");
    negative.coefficient = (-1).into();
    let proof = p.positivity(&[], vec![negative], &[]);
    assert_eq!(p.checked(proof), Err(Reject::NegativeCoefficient));
}

#[test]
fn cauchy_schwarz_over_another_number_of_elements_is_rejected() {
    let goal = r"n \sum_{i=1}^{k} u_i^2 \geq (\sum_{i=1}^{k} u_i)^2";
    let p = Proving::new(claim(&[], goal).sequence("u"));
    let proof = p.positivity(&[], vec![spread("k", "u")], &[]);
    assert_eq!(p.checked(proof), Err(Reject::IdentityFails));
    let proof = p.positivity(&[], vec![spread("n", "u")], &[]);
    assert_eq!(p.checked(proof), Err(Reject::NoSuchSum));
}

#[test]
fn power_0_of_a_sequence_is_left_out_of_a_sum() {
    let goal = r"n \sum_{i=1}^{n} u_i^2 \geq (\sum_{i=1}^{n} u_i)^2";
    let p = Proving::new(claim(&[], goal).sequence("u").sequence("w"));
    let mut square = spread("n", "u");
    square.series[0].f.push((symbol("w"), 0));
    assert_eq!(p.checked(p.positivity(&[], vec![square], &[])), Ok(()));
}

#[test]
fn symbol_that_counts_nothing_is_no_count() {
    let p = Proving::new(claim(&[], r"n^2 \geq n^2"));
    let mut square = spread("n", "u");
    square.series[0].f = vec![];
    let proof = p.positivity(&[], vec![square], &[]);
    assert_eq!(p.checked(proof), Err(Reject::NoSuchSum));
}

#[test]
fn exponents_of_a_sum_may_not_overflow() {
    let goal = r"n \sum_{i=1}^{n} u_i^2 \geq (\sum_{i=1}^{n} u_i)^2";
    let p = Proving::new(claim(&[], goal).sequence("u"));
    let mut huge = spread("n", "u");
    huge.series[0].f = vec![(symbol("u"), u32::MAX)];
    let proof = p.positivity(&[], vec![huge], &[]);
    assert_eq!(p.checked(proof), Err(Reject::TooLarge));
}

#[test]
fn powers_beyond_all_bounds_are_refused() {
    let p = Proving::new(claim(&["x = 1"], "x = 1"));
    let proof = p.combination(&[], u32::MAX, &[(0, "1")]);
    assert_eq!(p.checked(proof), Err(Reject::TooLarge));
}

#[test]
fn unknown_that_the_claim_does_not_have_is_rejected_wherever_it_is() {
    let goals = ["x = 0", r"x \neq 0", r"x \geq 0"];
    let [zero, nonzero, nonnegative] = goals.map(|goal| Proving::new(claim(&[], goal)));
    // The first that is not there.
    let foreign = Proving::new(claim(&[], "a = b")).p("b");
    let combination = |multiplier, cofactors| Proof::Combination {
        multiplier,
        power: 1,
        cofactors,
    };
    let non_vanishing = |certain, cofactor, cofactors| Proof::NonVanishing {
        certain,
        cofactor,
        cofactors,
    };
    let positivity = |multiplier, terms, cofactors| Proof::Positivity {
        multiplier,
        terms,
        cofactors,
    };
    let factor = || vec![(foreign.clone(), 1)];
    let cofactor = || vec![(0, foreign.clone())];
    let as_factor = || PositiveTerm {
        factors: factor(),
        ..one()
    };
    let as_square = PositiveTerm {
        squares: vec![foreign.clone()],
        ..one()
    };
    let foreign_bound = || Box::new(positivity(vec![], vec![as_factor()], vec![]));
    let own_bound = || Box::new(zero.positivity(&[], vec![], &[]));
    let bounds = |below, above| Proof::BothBounds { below, above };
    for (p, proof) in [
        (&zero, combination(factor(), vec![])),
        (&zero, combination(vec![], cofactor())),
        (&zero, bounds(foreign_bound(), own_bound())),
        (&zero, bounds(own_bound(), foreign_bound())),
        (&zero, Proof::Square(foreign_bound())),
        (&nonzero, non_vanishing(factor(), zero.p("1"), vec![])),
        (&nonzero, non_vanishing(vec![], foreign.clone(), vec![])),
        (&nonzero, non_vanishing(vec![], zero.p("1"), cofactor())),
        (&nonnegative, positivity(factor(), vec![], vec![])),
        (&nonnegative, positivity(vec![], vec![as_factor()], vec![])),
        (&nonnegative, positivity(vec![], vec![as_square], vec![])),
        (&nonnegative, positivity(vec![], vec![], cofactor())),
    ] {
        let verdict = p.checked(proof.clone());
        assert_eq!(verdict, Err(Reject::NoSuchUnknown), "{proof:?}");
        // In a lemma as well.
        let mut p = p.clone();
        let fact = p.problem.goal.clone();
        p.lemmas.push(Lemma { fact, proof });
        let verdict = p.checked(p.combination(&[], 1, &[]));
        assert_eq!(verdict, Err(Reject::NoSuchUnknown));
    }
    let mut p = zero.clone();
    p.lemmas.push(Lemma {
        fact: Fact {
            polynomial: foreign.clone(),
            sign: Sign::Zero,
        },
        proof: p.combination(&[], 1, &[]),
    });
    assert_eq!(p.trivially(), Err(Reject::NoSuchUnknown));
}

#[test]
fn lemma_is_a_fact_for_what_comes_after() {
    let mut p = Proving::new(claim(&["x y = 1", "x z = 0"], "z = 0"));
    let first = p.problem.facts.len();
    p.lemmas.push(Lemma {
        fact: Fact {
            polynomial: p.p("x"),
            sign: Sign::NonZero,
        },
        proof: p.non_vanishing(&[], "y", &[(0, "-1")]),
    });
    p.lemmas.push(Lemma {
        fact: Fact {
            polynomial: p.p("z"),
            sign: Sign::Zero,
        },
        proof: p.combination(&[("x", 1)], 1, &[(1, "1")]),
    });
    let proof = |at| Proof::Combination {
        multiplier: vec![],
        power: 1,
        cofactors: vec![(at, p.p("1"))],
    };
    assert_eq!(p.checked(proof(first + 1)), Ok(()));
    assert_eq!(p.checked(proof(first)), Err(Reject::NoSuchFact(first)));
    // The other way round the first lemma has nothing to stand on.
    let mut reversed = p.clone();
    reversed.lemmas.reverse();
    assert_eq!(
        reversed.checked(proof(first)),
        Err(Reject::MayVanish(term("x")))
    );
}

#[test]
fn lemma_that_names_itself_or_a_later_one_is_rejected() {
    let p = Proving::new(claim(&["x = x"], "z = 0"));
    let first = p.problem.facts.len();
    let begging = |at| Lemma {
        fact: p.problem.goal.clone(),
        proof: Proof::Combination {
            multiplier: vec![],
            power: 1,
            cofactors: vec![(at, p.p("1"))],
        },
    };
    for at in [first, first + 1] {
        let mut p = p.clone();
        p.lemmas = vec![begging(at), begging(first)];
        let verdict = p.checked(begging(first).proof);
        assert_eq!(verdict, Err(Reject::NoSuchFact(at)));
    }
}

#[test]
fn false_lemma_is_rejected_even_if_it_is_not_used() {
    let mut p = Proving::new(claim(&["z = 0"], "z = 0"));
    p.lemmas.push(Lemma {
        fact: Fact {
            polynomial: p.p("1"),
            sign: Sign::Zero,
        },
        proof: p.combination(&[], 1, &[(0, "1")]),
    });
    let proof = p.combination(&[], 1, &[(0, "1")]);
    assert_eq!(p.checked(proof), Err(Reject::IdentityFails));
}

#[test]
fn lemma_of_another_sign_than_its_proof_is_rejected() {
    let mut p = Proving::new(claim(&["x y = 1"], r"x^2 > 0"));
    p.lemmas.push(Lemma {
        fact: Fact {
            polynomial: p.p("x"),
            sign: Sign::Positive,
        },
        proof: p.non_vanishing(&[], "y", &[(0, "-1")]),
    });
    let square = PositiveTerm {
        squares: vec![p.p("x")],
        ..one()
    };
    let proof = p.positivity(&[], vec![square], &[]);
    assert_eq!(p.checked(proof.clone()), Err(Reject::WrongKind));
    p.lemmas[0].fact.sign = Sign::NonZero;
    assert_eq!(p.checked(proof), Ok(()));
}

#[test]
fn each_reason_to_reject_is_told_in_its_own_words() {
    let x = || term("x");
    let reasons = [
        Reject::NotUnfoldable(0),
        Reject::NoSuchFact(0),
        Reject::UnsupportedRelation,
        Reject::WrongKind,
        Reject::IdentityFails,
        Reject::MayVanish(x()),
        Reject::MayBeNegative(x()),
        Reject::NegativeCoefficient,
        Reject::NotStrict,
        Reject::ZeroPower,
        Reject::MayVary(x()),
        Reject::MayHaveNoValue(x()),
        Reject::NoSuchUnknown,
        Reject::NoSuchSum,
        Reject::NoValue,
        Reject::PremiseFalse(0),
        Reject::OutsideDomain,
        Reject::GoalNotFalse,
        Reject::DivisionByZero,
        Reject::TooLarge,
    ];
    let told: std::collections::BTreeSet<String> =
        reasons.iter().map(|reason| reason.to_string()).collect();
    assert_eq!(told.len(), reasons.len());
    assert!(told.iter().all(|words| !words.is_empty()));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// `Σ c_k (a_k x + b_k y + d_k) = 0` follows; with one coefficient changed it does not.
    #[test]
    fn combination_by_construction_is_accepted_and_its_perturbation_is_not(
        rows in prop::collection::vec((-9i64..10, -9i64..10, -9i64..10, -9i64..10), 1..5),
        which in 0usize..4,
        change in 1i64..9,
    ) {
        let hypotheses: Vec<String> = rows.iter()
            .map(|(a, b, d, _)| format!("({a}) x + ({b}) y z + ({d}) z^2 = 0"))
            .collect();
        let total = |part: fn(&(i64, i64, i64, i64)) -> i64| -> i64 {
            rows.iter().map(|row| row.3 * part(row)).sum()
        };
        let goal = format!(
            "({}) x + ({}) y z + ({}) z^2 = 0",
            total(|r| r.0), total(|r| r.1), total(|r| r.2)
        );
        let named: Vec<&str> = hypotheses.iter().map(String::as_str).collect();
        let p = Proving::new(claim(&named, &goal));
        let texts: Vec<String> = rows.iter().map(|row| format!("{}", row.3)).collect();
        let mut cofactors: Vec<(usize, &str)> = texts.iter().map(String::as_str).enumerate().collect();
        prop_assert_eq!(p.checked(p.combination(&[], 1, &cofactors)), Ok(()));
        let at = which % rows.len();
        let changed = format!("{}", rows[at].3 + change);
        cofactors[at].1 = &changed;
        let harmless = (rows[at].0, rows[at].1, rows[at].2) == (0, 0, 0);
        let expected = if harmless { Ok(()) } else { Err(Reject::IdentityFails) };
        prop_assert_eq!(p.checked(p.combination(&[], 1, &cofactors)), expected);
    }
}
