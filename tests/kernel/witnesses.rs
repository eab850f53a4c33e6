//! Counterexamples that are none.

use cradle_verify::kernel::{Claim, Domain, Reject, check_model};

use super::claims::*;

/// A whole number from 1 on.
fn natural() -> Domain {
    Domain {
        integer: true,
        lower: Some((number(1), false)),
        ..Domain::default()
    }
}

#[test]
fn counterexample_is_accepted() {
    let claim = claim(&["x^2 = 4"], "x = 2");
    assert_eq!(refuted(&claim, point(&[("x", -2)])), Ok(()));
}

#[test]
fn point_where_the_goal_is_true_is_rejected() {
    let claim = claim(&["x^2 = 4"], "x = 2");
    let verdict = refuted(&claim, point(&[("x", 2)]));
    assert_eq!(verdict, Err(Reject::GoalNotFalse));
}

#[test]
fn point_where_a_premise_is_false_is_rejected() {
    let claim = claim(&["y = y", "x^2 = 4"], "x = 2");
    let verdict = refuted(&claim, point(&[("x", 3), ("y", 0)]));
    assert_eq!(verdict, Err(Reject::PremiseFalse(1)));
}

#[test]
fn each_relation_is_evaluated_as_it_is_meant() {
    for (relation, below, same, above) in [
        ("=", false, true, false),
        (r"\neq", true, false, true),
        ("<", true, false, false),
        (r"\leq", true, true, false),
        (">", false, false, true),
        (r"\geq", false, true, true),
    ] {
        for (value, truth) in [(-1, below), (0, same), (1, above)] {
            let goal = claim(&[], &format!("x {relation} 0"));
            let expected = if truth {
                Err(Reject::GoalNotFalse)
            } else {
                Ok(())
            };
            assert_eq!(refuted(&goal, point(&[("x", value)])), expected);
            let premise = claim(&[&format!("x {relation} 0")], "1 = 0");
            let expected = if truth {
                Ok(())
            } else {
                Err(Reject::PremiseFalse(0))
            };
            assert_eq!(refuted(&premise, point(&[("x", value)])), expected);
        }
    }
}

#[test]
fn goal_that_is_not_defined_is_not_false() {
    let claim = claim(&[], r"\frac{1}{x} = 5");
    let verdict = refuted(&claim, point(&[("x", 0)]));
    assert_eq!(verdict, Err(Reject::GoalNotFalse));
    assert_eq!(refuted(&claim, point(&[("x", 1)])), Ok(()));
}

#[test]
fn goal_is_not_defined_even_where_its_denominator_cancels() {
    let claim = claim(&[], r"\frac{x^2}{x} = 1");
    let verdict = refuted(&claim, point(&[("x", 0)]));
    assert_eq!(verdict, Err(Reject::GoalNotFalse));
}

#[test]
fn premise_that_is_not_defined_is_not_true() {
    let claim = claim(&[r"\frac{x}{x} = 1"], r"x \neq 0");
    let verdict = refuted(&claim, point(&[("x", 0)]));
    assert_eq!(verdict, Err(Reject::PremiseFalse(0)));
}

#[test]
fn sign_of_a_quotient_is_that_of_the_quotient() {
    let claim = claim(&[], r"\frac{1}{x} > 0");
    assert_eq!(refuted(&claim, point(&[("x", -2)])), Ok(()));
    let verdict = refuted(&claim, point(&[("x", 2)]));
    assert_eq!(verdict, Err(Reject::GoalNotFalse));
    let claim = super::claims::claim(&[], r"\frac{1}{1 - 2x} > \frac{1}{(x - 3)^2}");
    assert_eq!(refuted(&claim, point(&[("x", 1)])), Ok(()));
    let verdict = refuted(&claim, point(&[("x", 0)]));
    assert_eq!(verdict, Err(Reject::GoalNotFalse));
}

#[test]
fn value_outside_of_its_domain_is_rejected() {
    let bounded = |lower: Option<(i64, bool)>, upper: Option<(i64, bool)>| Domain {
        lower: lower.map(|(bound, strict)| (number(bound), strict)),
        upper: upper.map(|(bound, strict)| (number(bound), strict)),
        ..Domain::default()
    };
    let nonzero = Domain {
        nonzero: true,
        ..Domain::default()
    };
    let integer = Domain {
        integer: true,
        ..Domain::default()
    };
    for (domain, inside, outside) in [
        (bounded(Some((1, true)), None), (2, 1), (1, 1)),
        (bounded(Some((1, false)), None), (1, 1), (1, 2)),
        (bounded(None, Some((1, true))), (1, 2), (1, 1)),
        (bounded(None, Some((1, false))), (1, 1), (2, 1)),
        (nonzero, (1, 2), (0, 1)),
        (integer, (3, 1), (1, 2)),
    ] {
        let claim = claim(&[], "x = 7").domain("x", domain);
        let at = |(above, below)| point(&[]).fraction("x", above, below);
        assert_eq!(refuted(&claim, at(inside)), Ok(()));
        let verdict = refuted(&claim, at(outside));
        assert_eq!(verdict, Err(Reject::OutsideDomain));
    }
}

#[test]
fn domain_of_a_symbol_that_was_put_in_still_holds() {
    let claim = claim(&["y = 2 x"], "x = 5").domain("y", positive());
    let at = |x| point(&[("x", x)]).unfolding(&[0]);
    assert_eq!(refuted(&claim, at(1)), Ok(()));
    assert!(matches!(
        refuted(&claim, at(-1)),
        Err(Reject::PremiseFalse(_) | Reject::OutsideDomain)
    ));
}

#[test]
fn integer_that_was_put_in_is_still_an_integer() {
    let integer = Domain {
        integer: true,
        ..Domain::default()
    };
    let claim = claim(&[r"n = \frac{x}{2}"], "x = 5").domain("n", integer);
    assert_eq!(refuted(&claim, point(&[("x", 4)]).unfolding(&[0])), Ok(()));
    let verdict = refuted(&claim, point(&[("x", 3)]).unfolding(&[0]));
    assert_eq!(verdict, Err(Reject::OutsideDomain));
}

#[test]
fn contradictory_domain_has_no_point() {
    let nowhere = Domain {
        lower: Some((number(1), true)),
        upper: Some((number(1), false)),
        ..Domain::default()
    };
    let claim = claim(&[], "x = 7").domain("x", nowhere);
    let verdict = refuted(&claim, point(&[("x", 1)]));
    assert_eq!(verdict, Err(Reject::OutsideDomain));
}

#[test]
fn missing_value_is_rejected() {
    let goal = claim(&[], "x + y = 7");
    assert_eq!(refuted(&goal, point(&[("x", 1)])), Err(Reject::NoValue));
    let premise = claim(&["y = 1"], "x = 7");
    assert_eq!(refuted(&premise, point(&[("x", 1)])), Err(Reject::NoValue));
}

#[test]
fn premise_without_an_exact_meaning_is_never_true() {
    for premise in [r"x \approx 1", r"x \gg y"] {
        let claim = claim(&[premise], "x = 7");
        let verdict = refuted(&claim, point(&[("x", 1), ("y", 1)]));
        assert_eq!(verdict, Err(Reject::NoValue), "{premise}");
    }
}

#[test]
fn scaling_premise_is_true_at_a_point_where_its_sides_are_not_zero() {
    let claim = claim(&[r"x \sim y"], "x = 7");
    let at = |x, y| refuted(&claim, point(&[("x", x), ("y", y)]));
    assert_eq!(at(1, 5), Ok(()));
    assert_eq!(at(1, 0), Err(Reject::PremiseFalse(0)));
}

#[test]
fn what_cannot_be_computed_exactly_has_no_value() {
    for goal in [
        r"\sin(x) = 7",
        r"\sqrt{2} = 7",
        "(-x)^{1/3} = 7",
        "P(x) = 7",
        r"\int_0^1 \sin(t) \, dt = x",
    ] {
        let claim = claim(&[], goal).sequence("u");
        let at = point(&[("x", 1), ("n", 1), ("t", 1)]).list("u", &[1]);
        assert_eq!(refuted(&claim, at), Err(Reject::NoValue), "{goal}");
    }
    for goal in [r"\sqrt{-x} = 7", r"\sum_{i=1}^{n} \frac{1}{u_i} = 7"] {
        let claim = claim(&[], goal).sequence("u");
        let at = point(&[("x", 1), ("n", 1)]).list("u", &[1]);
        assert_eq!(refuted(&claim, at), Err(Reject::GoalNotFalse), "{goal}");
    }
}

#[test]
fn roots_and_functions_with_exact_values_are_computed() {
    for (goal, accepted) in [
        (r"\sqrt{x} = 2", false),
        (r"\sqrt{x} = -2", true),
        ("x^{3/2} = 8", false),
        ("x^{-1/2} = 1/2", false),
        ("|x - 5| = 1", false),
        ("|x - 5| = -1", true),
        (r"\lceil x/3 \rceil = 2", false),
        (r"\lfloor x/3 \rfloor = 1", false),
        (r"\lfloor -x/3 \rfloor = -2", false),
        ("x^n = 64", false),
        ("n^x = 64", true),
    ] {
        let claim = claim(&[], goal);
        let expected = if accepted {
            Ok(())
        } else {
            Err(Reject::GoalNotFalse)
        };
        let verdict = refuted(&claim, point(&[("x", 4), ("n", 3)]));
        assert_eq!(verdict, expected, "{goal}");
    }
}

fn mean() -> cradle_verify::kernel::Claim {
    claim(&[r"\sum_{i=1}^{n} u_i = 6"], r"\sum_{i=1}^{n} u_i^2 = 12").sequence("u")
}

#[test]
fn sequence_is_summed_up_to_its_count() {
    let at = |n, list: &[i64]| point(&[("n", n)]).list("u", list);
    assert_eq!(refuted(&mean(), at(2, &[1, 5])), Ok(()));
    // What lies beyond the count is not summed.
    assert_eq!(refuted(&mean(), at(2, &[1, 5, 100])), Ok(()));
    let verdict = refuted(&mean(), at(3, &[2, 2, 2]));
    assert_eq!(verdict, Err(Reject::GoalNotFalse));
    let verdict = refuted(&mean(), at(2, &[1, 1]));
    assert_eq!(verdict, Err(Reject::PremiseFalse(0)));
}

#[test]
fn list_that_is_too_short_is_rejected() {
    let verdict = refuted(&mean(), point(&[("n", 3)]).list("u", &[1, 5]));
    assert_eq!(verdict, Err(Reject::NoValue));
}

#[test]
fn list_that_is_missing_is_rejected() {
    assert_eq!(refuted(&mean(), point(&[("n", 2)])), Err(Reject::NoValue));
}

#[test]
fn count_that_is_no_natural_number_is_rejected() {
    let list = [1, 5];
    let verdict = refuted(&mean(), point(&[]).fraction("n", 3, 2).list("u", &list));
    assert_eq!(verdict, Err(Reject::NoValue));
    let verdict = refuted(&mean(), point(&[("n", -1)]).list("u", &list));
    assert_eq!(verdict, Err(Reject::NoValue));
    assert_eq!(
        refuted(&mean(), point(&[]).list("u", &list)),
        Err(Reject::NoValue)
    );
}

#[test]
fn element_outside_of_its_domain_is_rejected() {
    let mut claim = mean();
    claim.sequences.insert(symbol("u"), positive());
    let verdict = refuted(&claim, point(&[("n", 2)]).list("u", &[-1, 7]));
    assert_eq!(verdict, Err(Reject::OutsideDomain));
    // Even where it is beyond the count.
    let verdict = refuted(&claim, point(&[("n", 2)]).list("u", &[1, 5, -1]));
    assert_eq!(verdict, Err(Reject::OutsideDomain));
}

#[test]
fn element_at_a_position_is_that_of_the_list() {
    let claim = claim(&[r"\sum_{i=1}^{n} u_i = 6"], "u_2 = 1").sequence("u");
    let at = |list: &[i64]| point(&[("n", 2)]).list("u", list);
    assert_eq!(refuted(&claim, at(&[1, 5])), Ok(()));
    assert_eq!(refuted(&claim, at(&[5, 1])), Err(Reject::GoalNotFalse));
    // A symbol of the same name says nothing.
    let mut both = at(&[5, 1]);
    both.symbols.insert(symbol("u_2"), number(9));
    assert_eq!(refuted(&claim, both), Err(Reject::GoalNotFalse));
}

#[test]
fn equal_elements_are_compared_up_to_the_count_only() {
    let claim = claim(&[r"u_1 = u_2 = \dots = u_n"], "u_1 = 3").sequence("u");
    let at = |list: &[i64]| point(&[("n", 2)]).list("u", list);
    assert_eq!(refuted(&claim, at(&[4, 4])), Ok(()));
    assert_eq!(refuted(&claim, at(&[4, 4, 9])), Ok(()));
    assert_eq!(refuted(&claim, at(&[4, 5])), Err(Reject::PremiseFalse(0)));
    assert_eq!(refuted(&claim, at(&[3, 3])), Err(Reject::GoalNotFalse));
}

#[test]
fn slope_is_chosen_where_nothing_else_is_said() {
    let claim = claim(&[], r"\frac{ds}{dx} = 1");
    assert_eq!(
        refuted(&claim, point(&[("x", 0)]).slope("s", "x", 2)),
        Ok(())
    );
    let verdict = refuted(&claim, point(&[("x", 0)]).slope("s", "x", 1));
    assert_eq!(verdict, Err(Reject::GoalNotFalse));
}

#[test]
fn slope_of_what_is_spoken_of_elsewhere_is_not_chosen() {
    for hypothesis in ["s = 3", r"\frac{ds}{dt} = 3", r"\frac{d}{dx}[2 s] = 3"] {
        let claim = claim(&[hypothesis], r"\frac{ds}{dx} = 1");
        let at = point(&[("s", 3), ("x", 0), ("t", 0)]);
        let verdict = refuted(&claim, at.slope("s", "x", 2).slope("s", "t", 3));
        assert!(
            matches!(verdict, Err(Reject::NoValue | Reject::PremiseFalse(_))),
            "{hypothesis}: {verdict:?}"
        );
    }
}

#[test]
fn slope_of_a_law_must_satisfy_it() {
    let claim = claim(&[r"\frac{ds}{dx} = 2 k"], r"\frac{ds}{dx} = 1");
    let at = |slope| point(&[("k", 1), ("x", 0)]).slope("s", "x", slope);
    assert_eq!(refuted(&claim, at(2)), Ok(()));
    assert_eq!(refuted(&claim, at(3)), Err(Reject::PremiseFalse(0)));
}

#[test]
fn slope_of_a_law_may_stand_on_either_side() {
    let claim = claim(&[r"2 k = \frac{ds}{dx}"], r"\frac{ds}{dx} = 1");
    let at = point(&[("k", 1), ("x", 0)]).slope("s", "x", 2);
    assert_eq!(refuted(&claim, at), Ok(()));
}

#[test]
fn slope_is_not_chosen_by_a_law_that_is_not_solved_for_it() {
    for law in [
        r"(\frac{ds}{dx})^2 = 4",
        r"\frac{ds}{dx} = k \frac{ds}{dx}",
        r"k \frac{ds}{dx} = \frac{ds}{dx}",
    ] {
        let claim = claim(&[law], r"\frac{ds}{dx} = 1");
        let at = point(&[("k", 1), ("x", 0)]).slope("s", "x", 2);
        assert_eq!(refuted(&claim, at), Err(Reject::NoValue), "{law}");
    }
}

#[test]
fn slope_is_not_chosen_where_two_laws_speak_of_it() {
    let laws = [r"\frac{ds}{dx} = 2 k", r"\frac{ds}{dx} = k + 1"];
    let claim = claim(&laws, r"\frac{ds}{dx} = 1");
    let at = || point(&[("k", 1), ("x", 0)]).slope("s", "x", 2);
    assert_eq!(refuted(&claim, at()), Err(Reject::NoValue));
    // What is so at this point is no law.
    assert_eq!(refuted(&claim.at_point(1), at()), Ok(()));
}

#[test]
fn slope_of_what_is_spoken_of_at_the_point_is_not_chosen() {
    for hypothesis in ["s = 3", "2 s = 6", r"\frac{dw}{ds} = 1"] {
        let claim = claim(&[hypothesis], r"\frac{ds}{dx} = 1").at_point(0);
        let at = point(&[("s", 3), ("w", 0), ("x", 0)]);
        let verdict = refuted(&claim, at.slope("s", "x", 2).slope("w", "s", 1));
        assert_eq!(verdict, Err(Reject::NoValue), "{hypothesis}");
    }
}

#[test]
fn slope_of_what_has_a_domain_is_chosen_unless_that_is_a_point() {
    let goal = || claim(&[], r"\frac{ds}{dx} = 1");
    let at = || point(&[("s", 1), ("x", 0)]).slope("s", "x", 2);
    let only = Domain {
        lower: Some((number(1), false)),
        upper: Some((number(1), false)),
        ..Domain::default()
    };
    let integer = Domain {
        integer: true,
        ..Domain::default()
    };
    for (domain, chosen) in [
        (Domain::default(), true),
        (positive(), true),
        (only, false),
        (integer, false),
    ] {
        let elsewhere = goal().domain("s", domain.clone());
        let verdict = refuted(&elsewhere, at());
        assert_eq!(verdict.is_ok(), chosen, "{domain:?}: {verdict:?}");
    }
}

#[test]
fn slope_of_what_no_law_moves_is_0() {
    let still = claim(&[], r"\frac{dk}{dx} = 1");
    assert_eq!(refuted(&still, point(&[("x", 1)])), Ok(()));
    let moved = claim(&["x = 2 k"], r"\frac{dk}{dx} = 1");
    let verdict = refuted(&moved, point(&[("x", 2), ("k", 1)]));
    assert_eq!(verdict, Err(Reject::NoValue));
    // A definition that was put in says nothing any more.
    let defined = claim(&["y = x^2"], r"\frac{dk}{dx} = y");
    let at = point(&[("x", 1)]).unfolding(&[0]);
    assert_eq!(refuted(&defined, at), Ok(()));
}

#[test]
fn limit_has_its_value_where_what_is_held_in_it_does_not_move() {
    let claim = claim(&[], r"\lim_{x \to 0} s x = 1");
    assert_eq!(refuted(&claim, point(&[("s", 1), ("x", 1)])), Ok(()));
    let at = point(&[("s", 1), ("x", 1)]).slope("s", "x", 1);
    assert_eq!(refuted(&claim, at), Err(Reject::NoValue));
}

#[test]
fn index_of_a_sum_that_another_runs_up_to_needs_no_value() {
    let nested = r"0 \sum_{i=1}^{n} \sum_{j=1}^{i} u_j = 1";
    let claim = claim(&[], nested).sequence("u");
    let verdict = refuted(&claim, point(&[("n", 2)]).list("u", &[1, 1]));
    // The sum is not known to have a value; that is all that is wrong.
    assert_eq!(verdict, Err(Reject::GoalNotFalse));
}

#[test]
fn divisor_that_is_always_0_is_named() {
    let claim = claim(&[], r"\frac{1}{x - x} = 1");
    let verdict = refuted(&claim, point(&[("x", 1)]));
    assert_eq!(verdict, Err(Reject::DivisionByZero));
}

#[test]
fn numbers_beyond_all_bounds_are_refused() {
    let claim = claim(&[], "x^{1000000} = 1");
    assert_eq!(refuted(&claim, point(&[("x", 3)])), Err(Reject::TooLarge));
}

#[test]
fn model_makes_the_premises_true_whatever_the_goal_says() {
    let claim = claim(&["x^2 = 4"], r"\frac{1}{0 y} = 1").domain("x", positive());
    let model = check_model(&claim, point(&[("x", 2)]));
    assert_eq!(model.map(|m| m.point().clone()), Ok(point(&[("x", 2)])));
    let outside = check_model(&claim, point(&[("x", -2)])).map(|_| ());
    assert_eq!(outside, Err(Reject::OutsideDomain));
    let untrue = check_model(&claim, point(&[("x", 3)])).map(|_| ());
    assert_eq!(untrue, Err(Reject::PremiseFalse(0)));
    let missing = check_model(&claim, point(&[])).map(|_| ());
    assert_eq!(missing, Err(Reject::NoValue));
}

#[test]
fn power_with_a_natural_exponent_has_a_value_at_any_base() {
    let false_one = claim(&[], "x^n = 8").domain("n", natural());
    assert_eq!(refuted(&false_one, point(&[("x", -2), ("n", 3)])), Ok(()));
    assert_eq!(refuted(&false_one, point(&[("x", 0), ("n", 3)])), Ok(()));
    let true_one = claim(&[], "x^n = -8").domain("n", natural());
    let verdict = refuted(&true_one, point(&[("x", -2), ("n", 3)]));
    assert_eq!(verdict, Err(Reject::GoalNotFalse));
}

#[test]
fn power_of_what_is_not_positive_has_no_value_where_its_exponent_is_any_number() {
    let verdict = |domain: Domain| {
        let claim = claim(&[], "x^n = 8").domain("n", domain);
        refuted(&claim, point(&[("x", -2), ("n", 3)]))
    };
    assert_eq!(verdict(Domain::default()), Err(Reject::GoalNotFalse));
    let below = |claim: Claim, n| refuted(&claim, point(&[("x", 0), ("n", n)]));
    let whole = || Domain {
        integer: true,
        ..Domain::default()
    };
    assert_eq!(verdict(whole()), Ok(()));
    // 1/0 is no number, whatever it is multiplied with.
    for goal in ["x^n = 8", "0 x^n = 8", "x^{n - 2} = 8", "0 x^{n - 2} = 8"] {
        let claim = || claim(&[], goal);
        let declared = claim().domain("n", whole());
        assert!(below(declared, -1).is_err(), "{goal}");
        let declared = claim().domain("n", natural());
        let defined = below(declared, 1).is_ok();
        assert_eq!(defined, !goal.contains("- 2"), "{goal}");
    }
}

#[test]
fn sum_is_evaluated_term_by_term() {
    let sum = |goal: &str| claim(&[], goal).domain("n", natural());
    let at = |n, x| point(&[("n", n), ("x", x)]);
    let wrong = sum(r"\sum_{i=1}^{n} i^2 x = n^2 x");
    assert_eq!(refuted(&wrong, at(2, 1)), Ok(()));
    assert_eq!(refuted(&wrong, at(1, 1)), Err(Reject::GoalNotFalse));
    let empty = sum(r"\sum_{i=1}^{n-1} x^i = 1");
    assert_eq!(refuted(&empty, at(1, 3)), Ok(()));
    // A term that has no value: for i = 2, for x = 0, and where the sum would go backwards.
    for (goal, n, x) in [
        (r"\sum_{i=1}^{n} \frac{1}{i - 2} = 1", 3, 1),
        (r"\sum_{i=1}^{n} \frac{i}{x} = 1", 3, 0),
        (r"\sum_{i=5}^{n} i = 1", 1, 1),
        (r"\sum_{i=1}^{n} \frac{i (i - 2)}{i - 2} = 1", 3, 1),
    ] {
        assert!(refuted(&sum(goal), at(n, x)).is_err(), "{goal}");
    }
}
