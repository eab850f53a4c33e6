//! How a claim becomes facts: definitions put in, divisors, domains, derivatives, limits and sums.

use cradle_verify::algebra::{Expr, Formula, Relation};
use cradle_verify::kernel::{Domain, Fact, Lemma, Origin, PositiveTerm, Problem, Reject, Sign};

use super::claims::*;

#[test]
fn definition_is_put_in_under_a_derivative() {
    let claim = claim(&["y = x^2"], r"\frac{dy}{dx} = 2 x");
    assert_eq!(Proving::unfolding(claim.clone(), &[0]).trivially(), Ok(()));
    let verdict = Proving::new(claim).trivially();
    assert_eq!(verdict, Err(Reject::IdentityFails));
}

#[test]
fn value_at_a_point_is_not_put_in_under_a_derivative_or_limit() {
    for goal in [r"\frac{dy}{dx} = 0", r"\lim_{x \to 0} y = 4"] {
        let claim = claim(&["y = 4"], goal).at_point(0);
        let verdict = Problem::new(&claim, &[0]).map(|_| ());
        assert_eq!(verdict, Err(Reject::NotUnfoldable(0)), "{goal}");
    }
}

#[test]
fn value_at_a_point_may_be_put_in_elsewhere() {
    let claim = claim(&["y = 4"], "y^2 = 16").at_point(0);
    assert_eq!(Proving::unfolding(claim, &[0]).trivially(), Ok(()));
}

#[test]
fn what_is_no_definition_is_not_put_in() {
    for hypothesis in ["y^2 = 4", "y = y + x", r"y \leq 4", "2 = 4"] {
        let claim = claim(&[hypothesis], "y = 2");
        let verdict = Problem::new(&claim, &[0]).map(|_| ());
        assert_eq!(verdict, Err(Reject::NotUnfoldable(0)), "{hypothesis}");
    }
}

#[test]
fn definition_is_put_in_once() {
    let claim = claim(&["y = x"], "y = x");
    let verdict = Problem::new(&claim, &[0, 0]).map(|_| ());
    assert_eq!(verdict, Err(Reject::NotUnfoldable(0)));
}

#[test]
fn definition_that_is_not_there_is_rejected() {
    let claim = claim(&["y = x"], "y = x");
    let verdict = Problem::new(&claim, &[1]).map(|_| ());
    assert_eq!(verdict, Err(Reject::NoSuchFact(1)));
}

#[test]
fn variable_of_a_derivative_is_not_put_in() {
    let claim = claim(&["x = 2"], r"\frac{dy}{dx} = 0");
    let verdict = Problem::new(&claim, &[0]).map(|_| ());
    assert_eq!(verdict, Err(Reject::NotUnfoldable(0)));
}

#[test]
fn symbol_of_the_name_of_an_index_is_put_in_outside_of_the_sum() {
    let goal = r"i + \sum_{i=1}^{n} i u_i = 3 + \sum_{j=1}^{n} j u_j";
    let claim = claim(&["i = 3"], goal).sequence("u");
    assert!(Problem::new(&claim, &[0]).is_ok());
}

#[test]
fn element_is_not_put_in_where_its_sequence_is_spoken_of() {
    let declared = claim(&["u_1 = 5"], "u_1 = 5").sequence("u");
    let summed = claim(&["u_1 = 5"], r"\sum_{i=1}^{n} u_i = 5");
    for claim in [declared, summed] {
        let verdict = Problem::new(&claim, &[0]).map(|_| ());
        assert_eq!(verdict, Err(Reject::NotUnfoldable(0)));
    }
    let mere_subscript = claim(&["u_1 = 5"], "u_1 = 5");
    assert!(Problem::new(&mere_subscript, &[0]).is_ok());
}

#[test]
fn definition_that_names_a_bound_index_is_not_put_in() {
    let claim = claim(&["y = i"], r"\sum_{i=1}^{n} y u_i = 0").sequence("u");
    let verdict = Problem::new(&claim, &[0]).map(|_| ());
    assert_eq!(verdict, Err(Reject::NotUnfoldable(0)));
}

#[test]
fn circular_definitions_do_not_prove_one_another() {
    let claim = claim(&["y = x", "x = y"], "y = 0");
    // After the first, the second says x = x.
    let verdict = Problem::new(&claim, &[0, 1]).map(|_| ());
    assert_eq!(verdict, Err(Reject::NotUnfoldable(1)));
    let verdict = Proving::unfolding(claim, &[0]).trivially();
    assert_eq!(verdict, Err(Reject::IdentityFails));
}

#[test]
fn goal_must_be_defined() {
    let verdict = Proving::new(claim(&[], r"\frac{x}{x} = 1")).trivially();
    assert_eq!(verdict, Err(Reject::MayVanish(term("x"))));
    let known = claim(&[r"x \neq 0"], r"\frac{x}{x} = 1");
    assert_eq!(Proving::new(known).trivially(), Ok(()));
    let domain = claim(&[], r"\frac{x}{x} = 1").domain("x", positive());
    assert_eq!(Proving::new(domain).trivially(), Ok(()));
}

#[test]
fn divisor_may_be_shown_not_to_vanish_by_a_lemma() {
    let mut p = Proving::new(claim(&["x y = 1"], r"\frac{x}{x} = 1"));
    p.lemmas.push(Lemma {
        fact: Fact {
            polynomial: p.p("x"),
            sign: Sign::NonZero,
        },
        proof: p.non_vanishing(&[], "y", &[(0, "-1")]),
    });
    assert_eq!(p.trivially(), Ok(()));
}

#[test]
fn divisors_that_cancel_or_are_multiplied_by_0_still_count() {
    for goal in [
        r"\frac{x y}{x} = y",
        r"0 \cdot \frac{1}{x} = 0",
        r"\frac{1}{x} - \frac{1}{x} = 0",
        r"x \cdot x^{-1} = 1",
        r"\left(\frac{1}{x}\right)^0 = 1",
    ] {
        let verdict = Proving::new(claim(&[], goal)).trivially();
        assert_eq!(verdict, Err(Reject::MayVanish(term("x"))), "{goal}");
    }
}

#[test]
fn what_a_premise_divides_by_does_not_vanish() {
    let p = Proving::new(claim(&[r"\frac{y}{x} = 3"], r"x \neq 0"));
    assert_eq!(p.checked(p.non_vanishing(&[("x", 1)], "1", &[])), Ok(()));
    // What the goal divides by is not known by that alone.
    let p = Proving::new(claim(&[r"x y = 3 x"], r"\frac{x y}{x} = 3"));
    let verdict = p.checked(p.combination(&[], 1, &[]));
    assert_eq!(verdict, Err(Reject::MayVanish(term("x"))));
}

#[test]
fn division_by_an_expression_that_is_always_0_is_named() {
    for goal in [r"\frac{1}{x - x} = 1", "0^{-1} = 1"] {
        let verdict = Problem::new(&claim(&[], goal), &[]).map(|_| ());
        assert_eq!(verdict, Err(Reject::DivisionByZero), "{goal}");
    }
}

#[test]
fn terms_beyond_all_bounds_are_refused() {
    for goal in [r"(x + y)^{5000} = 1", r"\sum_{i=1}^{5000} i = 1"] {
        let verdict = Problem::new(&claim(&[], goal), &[]).map(|_| ());
        assert_eq!(verdict, Err(Reject::TooLarge), "{goal}");
    }
}

#[test]
fn sign_of_a_quotient_takes_the_denominator_into_account() {
    let p = Proving::new(claim(&[r"\frac{1}{x} > 0"], "x > 0"));
    let fact = PositiveTerm {
        facts: vec![p.hypothesis(0)],
        ..one()
    };
    assert_eq!(p.checked(p.positivity(&[], vec![fact], &[])), Ok(()));
    let p = Proving::new(claim(&[], r"\frac{1}{x} > 0").domain("x", positive()));
    let factor = PositiveTerm {
        factors: p.factors(&[("x", 1)]),
        ..one()
    };
    assert_eq!(p.checked(p.positivity(&[], vec![factor], &[])), Ok(()));
    // With the square below there is nothing left but a constant.
    let p = Proving::new(claim(&[r"x \neq 0"], r"\frac{1}{x^2} > 0"));
    assert_eq!(p.checked(p.positivity(&[], vec![one()], &[])), Ok(()));
}

#[test]
fn derivatives_of_rational_functions_are_computed() {
    for (goal, accepted) in [
        (r"\frac{d}{dx}[x^3] = 3 x^2", true),
        (r"\frac{d}{dx}[x^3] = 3 x", false),
        (
            r"\frac{d}{dx}\left[\frac{1}{x}\right] = -\frac{1}{x^2}",
            true,
        ),
        (
            r"\frac{d}{dx}\left[\frac{1}{x}\right] = \frac{1}{x^2}",
            false,
        ),
        (r"\frac{d}{dx}[k x] = k", true),
        (r"\frac{d}{dx}[y x] = y", false),
        (r"\frac{d}{dx}[y x] = y + x \frac{dy}{dx}", true),
        (r"2 x \frac{d}{dx}[\sqrt{x}] = \sqrt{x}", true),
        (r"2 x \frac{d}{dx}[\sqrt{x}] = 1", false),
    ] {
        let claim = claim(&["x > 0"], goal).domain("k", constant());
        let expected = if accepted {
            Ok(())
        } else {
            Err(Reject::IdentityFails)
        };
        assert_eq!(Proving::new(claim).trivially(), expected, "{goal}");
    }
}

#[test]
fn limits_of_rational_functions_are_computed() {
    for (goal, accepted) in [
        (r"\lim_{x \to 0} (k + x) = k", true),
        (r"\lim_{x \to 0} (k + x) = x", false),
        (
            r"\lim_{x \to \infty} \frac{1 + k x}{2 x} = \frac{k}{2}",
            true,
        ),
        (r"\lim_{x \to \infty} \frac{1 + k x}{2 x} = 0", false),
    ] {
        let claim = claim(&[r"x \neq 0"], goal).domain("k", constant());
        let expected = if accepted {
            Ok(())
        } else {
            Err(Reject::IdentityFails)
        };
        assert_eq!(Proving::new(claim).trivially(), expected, "{goal}");
    }
}

#[test]
fn limit_that_may_not_exist_proves_nothing() {
    let claim = claim(&[], r"\lim_{x \to \infty} k x = \lim_{x \to \infty} k x");
    let verdict = Proving::new(claim.domain("k", constant())).trivially();
    assert!(matches!(verdict, Err(Reject::MayHaveNoValue(_))));
}

#[test]
fn symbol_held_in_a_limit_must_be_known_not_to_vary() {
    let goal = r"\lim_{x \to 0} s x = 0";
    let verdict = Proving::new(claim(&[], goal)).trivially();
    assert_eq!(verdict, Err(Reject::MayVary(term(r"\frac{ds}{dx}"))));
    let fixed = claim(&[], goal).domain("s", constant());
    assert_eq!(Proving::new(fixed).trivially(), Ok(()));
    let law = claim(&[r"\frac{ds}{dx} = 0"], goal);
    assert_eq!(Proving::new(law).trivially(), Ok(()));
}

#[test]
fn law_into_which_a_value_was_put_holds_at_this_point_only() {
    let goal = r"\lim_{x \to 0} s x = 0";
    let law = claim(&[r"\frac{ds}{dx} = k", "k = 0"], goal);
    assert_eq!(Proving::unfolding(law.clone(), &[1]).trivially(), Ok(()));
    let verdict = Proving::unfolding(law.at_point(1), &[1]).trivially();
    assert_eq!(verdict, Err(Reject::MayVary(term(r"\frac{ds}{dx}"))));
    // A law that does not speak of what was put in remains one.
    let other = claim(&[r"\frac{ds}{dx} = 0", "k = 0"], goal).at_point(1);
    assert_eq!(Proving::unfolding(other, &[1]).trivially(), Ok(()));
}

#[test]
fn limit_in_a_premise_is_no_fact_where_something_was_held() {
    let p = Proving::new(claim(&[r"\lim_{x \to 0} (s + x) = 3"], "s = 3"));
    assert!(p.problem.facts.is_empty());
    let fixed = claim(&[r"\lim_{x \to 0} (s + x) = 3"], "s = 3").domain("s", constant());
    let p = Proving::new(fixed);
    assert_eq!(p.checked(p.combination(&[], 1, &[(0, "1")])), Ok(()));
}

#[test]
fn domain_is_said_in_as_few_formulas_as_needed() {
    let domain = |lower: Option<(i64, bool)>, upper: Option<(i64, bool)>, nonzero| Domain {
        lower: lower.map(|(bound, strict)| (number(bound), strict)),
        upper: upper.map(|(bound, strict)| (number(bound), strict)),
        nonzero,
        ..Domain::default()
    };
    let unequal = (Relation::NotEqual, 0);
    let (above, from) = (Relation::Greater, Relation::GreaterOrEqual);
    let (below, up_to) = (Relation::Less, Relation::LessOrEqual);
    for (domain, said) in [
        (domain(None, None, false), vec![]),
        (domain(None, None, true), vec![unequal]),
        (domain(Some((0, true)), None, false), vec![(above, 0)]),
        (domain(Some((0, true)), None, true), vec![(above, 0)]),
        (domain(Some((0, false)), None, false), vec![(from, 0)]),
        (
            domain(Some((0, false)), None, true),
            vec![(from, 0), unequal],
        ),
        (domain(Some((1, false)), None, true), vec![(from, 1)]),
        (
            domain(Some((-1, true)), None, true),
            vec![(above, -1), unequal],
        ),
        (domain(None, Some((1, true)), false), vec![(below, 1)]),
        (
            domain(None, Some((1, false)), true),
            vec![(up_to, 1), unequal],
        ),
        (
            domain(Some((-1, false)), Some((2, true)), false),
            vec![(from, -1), (below, 2)],
        ),
    ] {
        let formula = |(relation, bound)| Formula::Relation {
            left: term("x"),
            relation,
            right: Expr::Number(number(bound)),
        };
        let said: Vec<Formula> = said.into_iter().map(formula).collect();
        assert_eq!(domain.formulas(&term("x")), said, "{domain:?}");
    }
}

#[test]
fn domain_of_a_sequence_is_that_of_each_element_spoken_of() {
    let mut claim = claim(&[], "u_2 > 0").sequence("u");
    let p = Proving::new(claim.clone());
    assert!(p.problem.facts.is_empty());
    claim.sequences.insert(symbol("u"), positive());
    let p = Proving::new(claim);
    assert_eq!(p.problem.origins, [Origin::Domain(symbol("u"))]);
    let fact = PositiveTerm {
        facts: vec![0],
        ..one()
    };
    assert_eq!(p.checked(p.positivity(&[], vec![fact], &[])), Ok(()));
}

#[test]
fn sum_of_even_powers_is_not_negative_and_no_other() {
    for (sum, accepted) in [
        (r"\sum_{i=1}^{n} u_i^2", true),
        (r"\sum_{i=1}^{n} u_i^2 w_i^4", true),
        (r"\sum_{i=1}^{n} u_i", false),
        (r"\sum_{i=1}^{n} u_i^3", false),
        (r"\sum_{i=1}^{n} u_i w_i", false),
        (r"\sum_{i=1}^{n} u_i^2 w_i", false),
    ] {
        let claim = claim(&[], &format!(r"{sum} \geq 0"));
        let p = Proving::new(claim.sequence("u").sequence("w"));
        let itself = PositiveTerm {
            factors: vec![(p.problem.goal.polynomial.clone(), 1)],
            ..one()
        };
        let verdict = p.checked(p.positivity(&[], vec![itself], &[]));
        match accepted {
            true => assert_eq!(verdict, Ok(()), "{sum}"),
            false => assert!(matches!(verdict, Err(Reject::MayBeNegative(_))), "{sum}"),
        }
    }
}

#[test]
fn sums_of_the_identity_of_lagrange_are_unknowns_of_the_claim() {
    let goal = r"\sum_{i=1}^{n} u_i^3 = \sum_{i=1}^{n} w_i^3";
    let p = Proving::new(claim(&[], goal).sequence("u").sequence("w"));
    for sum in ["u_i", "w_i", "u_i^2", "w_i^2", "u_i w_i"] {
        p.p(&format!(r"\sum_{{i=1}}^{{n}} {sum}"));
    }
    p.p("n");
}

#[test]
fn count_is_not_negative() {
    let p = Proving::new(claim(&[], r"n + 0 \sum_{i=1}^{n} u_i \geq 0").sequence("u"));
    let count = PositiveTerm {
        factors: p.factors(&[("n", 1)]),
        ..one()
    };
    assert_eq!(p.checked(p.positivity(&[], vec![count], &[])), Ok(()));
}

#[test]
fn index_of_a_sum_that_another_runs_up_to_is_no_count_outside_of_it() {
    let nested = r"\sum_{i=1}^{n} \sum_{j=1}^{i} u_j = 3";
    for (hypotheses, counted) in [
        (vec![nested], false),
        (vec![nested, r"\sum_{j=1}^{i} u_j = 3"], true),
        (vec![r"\sum_{i=1}^{i} u_i = 3"], true),
    ] {
        let p = Proving::new(claim(&hypotheses, r"i \geq 0").sequence("u"));
        let count = PositiveTerm {
            factors: p.factors(&[("i", 1)]),
            ..one()
        };
        let expected = match counted {
            true => Ok(()),
            false => Err(Reject::MayBeNegative(term("i"))),
        };
        let verdict = p.checked(p.positivity(&[], vec![count], &[]));
        assert_eq!(verdict, expected, "{hypotheses:?}");
    }
}

#[test]
fn equal_elements_give_every_power_sum() {
    let goal = r"\sum_{i=1}^{n} u_i^3 = n w^3";
    let equal = claim(&[r"u_1 = u_2 = \dots = u_n = w"], goal).sequence("u");
    let p = Proving::new(equal);
    let cube = p.problem.goal.polynomial.clone();
    let at = p.problem.facts.iter().position(|f| f.polynomial == cube);
    let proof = cradle_verify::kernel::Proof::Combination {
        multiplier: vec![],
        power: 1,
        cofactors: vec![(at.expect("a fact about the cubes"), p.p("1"))],
    };
    assert_eq!(p.checked(proof), Ok(()));
}

#[test]
fn elements_equal_up_to_another_count_say_nothing() {
    let goal = r"\sum_{i=1}^{m} u_i^3 = m w^3";
    let equal = claim(&[r"u_1 = u_2 = \dots = u_n = w"], goal).sequence("u");
    let p = Proving::new(equal);
    let cube = p.problem.goal.polynomial.clone();
    assert!(p.problem.facts.iter().all(|f| f.polynomial != cube));
}

#[test]
fn vanishing_sum_of_squares_is_not_a_vanishing_sum_of_cubes() {
    let goal = r"\sum_{i=1}^{n} u_i^3 = 0";
    let p = Proving::new(claim(&[r"\sum_{i=1}^{n} u_i^2 = 0"], goal).sequence("u"));
    let verdict = p.checked(p.combination(&[], 1, &[(0, "1")]));
    assert_eq!(verdict, Err(Reject::IdentityFails));
    // Odd sums may be negative.
    let p = Proving::new(claim(&[], r"\sum_{i=1}^{n} u_i^3 \geq 0").sequence("u"));
    let factor = PositiveTerm {
        factors: vec![(p.problem.goal.polynomial.clone(), 1)],
        ..one()
    };
    let verdict = p.checked(p.positivity(&[], vec![factor], &[]));
    assert!(matches!(verdict, Err(Reject::MayBeNegative(_))));
}

#[test]
fn sums_over_different_numbers_of_elements_differ() {
    let goal = r"\sum_{i=1}^{n} u_i = \sum_{i=1}^{m} u_i";
    let verdict = Proving::new(claim(&[], goal).sequence("u")).trivially();
    assert_eq!(verdict, Err(Reject::IdentityFails));
    let renamed = r"\sum_{i=1}^{n} u_i = \sum_{j=1}^{n} u_j";
    assert_eq!(
        Proving::new(claim(&[], renamed).sequence("u")).trivially(),
        Ok(())
    );
}

#[test]
fn product_of_sums_is_not_the_sum_of_products() {
    let goal = r"\sum_{i=1}^{n} u_i w_i = \sum_{i=1}^{n} u_i \sum_{i=1}^{n} w_i";
    let claim = claim(&[], goal).sequence("u").sequence("w");
    let verdict = Proving::new(claim).trivially();
    assert_eq!(verdict, Err(Reject::IdentityFails));
}

#[test]
fn root_of_a_square_is_not_taken_to_be_the_base() {
    for goal in [
        r"\sqrt{x^2} = x",
        r"\sqrt{x} \sqrt{y} = \sqrt{x y}",
        "(-8)^{1/3} = 2",
    ] {
        let verdict = Proving::new(claim(&[], goal)).trivially();
        assert!(verdict.is_err(), "{goal}");
    }
}

#[test]
fn root_under_an_integral_needs_limits_that_are_not_negative() {
    let bare = claim(
        &[],
        r"\int_a^b \sqrt{s} \sqrt{s} \, ds = \frac{b^2 - a^2}{2}",
    );
    let p = Proving::new(bare.clone());
    let verdict = p.checked(p.combination(&[], 1, &[]));
    assert!(matches!(verdict, Err(Reject::MayBeNegative(_))));
    let p = Proving::new(bare.domain("a", positive()).domain("b", positive()));
    assert_eq!(p.checked(p.combination(&[], 1, &[])), Ok(()));
}

#[test]
fn only_declared_constants_come_out_of_an_integral() {
    let bare = claim(&[], r"\int_0^1 k f \, dt = k \int_0^1 f \, dt");
    let p = Proving::new(bare.clone());
    assert_eq!(
        p.checked(p.combination(&[], 1, &[])),
        Err(Reject::IdentityFails)
    );
    let p = Proving::new(bare.domain("k", constant()));
    assert_eq!(p.checked(p.combination(&[], 1, &[])), Ok(()));
}

#[test]
fn what_is_divided_by_in_an_integrand_must_not_vanish_between_the_limits() {
    for integrand in [r"\frac{s}{s}", r"\frac{2 s}{s + s}"] {
        let bare = claim(&[], &format!(r"\int_a^b {integrand} \, ds = b - a"));
        let p = Proving::new(bare.clone());
        let product = Expr::Product([term("a"), term("b")].into());
        assert_eq!(
            p.checked(p.combination(&[], 1, &[])),
            Err(Reject::MayBeNegative(product))
        );
        let p = Proving::new(bare.domain("a", positive()).domain("b", positive()));
        assert_eq!(p.checked(p.combination(&[], 1, &[])), Ok(()));
    }
    // Here it does, whatever is known.
    for wrong in [
        r"\int_{-1}^1 \frac{1}{s^2} \, ds = -2",
        r"\int_{-1}^1 \frac{1}{s} \, ds = 0",
        r"\int_0^1 \frac{1}{s^2} \, ds = 1",
        r"\int_0^2 \frac{1}{s - 1} \, ds = 0",
    ] {
        let p = Proving::new(claim(&[], wrong));
        assert_eq!(
            p.checked(p.combination(&[], 1, &[])),
            Err(Reject::IdentityFails),
            "{wrong}"
        );
    }
}

#[test]
fn law_about_a_function_is_put_in_under_an_integral_if_it_holds_throughout() {
    let laws = ["P(t) = 2 q"];
    let bare = claim(&laws, r"\int_0^1 P(t) \, dt = 2 \int_0^1 q \, dt");
    let p = Proving::unfolding(bare.clone(), &[0]);
    assert_eq!(p.checked(p.combination(&[], 1, &[])), Ok(()));
    let here = bare.at_point(0);
    assert_eq!(
        Problem::new(&here, &[0]).map(drop),
        Err(Reject::NotUnfoldable(0))
    );
}
