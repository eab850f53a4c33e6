//! What the kernel once accepted and must not.

use super::claims::*;
use cradle_verify::algebra::*;
use cradle_verify::kernel::*;

fn integer() -> Domain {
    Domain {
        integer: true,
        ..Domain::default()
    }
}
macro_rules! hole {
    ($name:ident, $body:expr) => {
        #[test]
        fn $name() {
            let r: Result<(), Reject> = $body;
            println!("{} => {:?}", stringify!($name), r);
            assert!(r.is_err(), "ACCEPTED");
        }
    };
}

hole!(
    derivative_of_bound_element_is_zero,
    Proving::new(claim(&[], r"\sum_{i=1}^{n} \frac{d}{dt}[u_i] = 0").sequence("u")).trivially()
);
hole!(
    derivative_of_sum_is_zero,
    Proving::new(
        claim(&[], r"\frac{d}{dt}\left[\sum_{i=1}^{n} u_i\right] = 0")
            .sequence("u")
            .domain("n", integer())
    )
    .trivially()
);
hole!(
    derivative_of_integral_zero,
    Proving::new(claim(&[], r"\frac{d}{dx}\left[\int_0^x x \, dx\right] = 0")).trivially()
);
hole!(
    derivative_of_integral_p_zero,
    Proving::new(claim(
        &[],
        r"\frac{d}{dt}\left[\int_0^t P(t) \, dt\right] = 0"
    ))
    .trivially()
);
hole!(
    nested_upper_limit,
    Proving::new(
        claim(
            &[],
            r"\sum_{i=1}^{n} \sum_{j=1}^{i} u_j = n \sum_{j=1}^{i} u_j"
        )
        .sequence("u")
    )
    .trivially()
);
/// That a symbol is not 0, because what a law says would have no value otherwise.
fn nonzero_by(law: &str, symbol: &str, fixed: &str) -> Result<(), Reject> {
    let goal = format!(r"{symbol} \neq 0");
    let p = Proving::new(claim(&[law], &goal).domain(fixed, constant()));
    p.checked(p.non_vanishing(&[(symbol, 1)], "1", &[]))
}
hole!(
    limit_in_hypothesis_bounds_free_variable,
    nonzero_by(r"\lim_{h \to 0} \frac{h x}{h} = y", "h", "x")
);
// Of 0/x there is a limit at 0.
hole!(
    limit_in_hypothesis_bounds_its_place,
    nonzero_by(r"\lim_{x \to z} \frac{a}{x} = 0", "z", "a")
);
hole!(
    limit_that_says_its_place_is_positive,
    nonzero_by(r"y = \lim_{t \to b} \sqrt{t} \sin t", "b", "b")
);
hole!(
    limit_in_hypothesis_of_what_is_not_continuous,
    Proving::new(claim(&[r"y = \lim_{t \to 0} \frac{\sin t}{t}"], "y = 7")).trivially()
);
hole!(held_by_pointwise_derivative, {
    let c = claim(&[r"\frac{ds}{dx} = 0"], r"\lim_{x \to 0} s x = 0").at_point(0);
    Proving::new(c).trivially()
});
hole!(held_by_pointwise_lemma, {
    let c = claim(&[r"\frac{ds}{dx} = k", "k = 0"], r"\lim_{x \to 0} s x = 0").at_point(1);
    let mut p = Proving::new(c);
    let f = p.p(r"\frac{ds}{dx}");
    let proof = p.combination(&[], 1, &[(0, "1"), (1, "1")]);
    p.lemmas.push(Lemma {
        fact: Fact {
            polynomial: f,
            sign: Sign::Zero,
        },
        proof,
    });
    p.trivially()
});
hole!(
    negative_count_ones_refuted,
    refuted(
        &claim(&["n = -3"], r"\sum_{i=1}^{n} 1 = 0"),
        point(&[("n", -3)])
    )
);
hole!(
    half_count_ones,
    refuted(
        &claim(&["n = 1/2"], r"\sum_{i=1}^{n} 1 = 0"),
        point(&[]).fraction("n", 1, 2)
    )
);
hole!(
    cancelled_sum_refuted,
    refuted(
        &claim(&[], r"\sum_{i=1}^{n} u_i - \sum_{i=1}^{n} u_i + n \geq 0").sequence("u"),
        point(&[("n", -3)])
    )
);
hole!(even_power_symbolic_proven, {
    let p = Proving::new(claim(&["x = -1", "n = 1/2"], r"x^{2n} \geq 0"));
    let t = PositiveTerm {
        factors: vec![(p.problem.goal.polynomial.clone(), 1)],
        ..one()
    };
    p.checked(p.positivity(&[], vec![t], &[]))
});
hole!(
    element_unfolded_out_of_sum,
    refuted(
        &claim(&["u_1 = 5", "n = 1"], r"\sum_{i=1}^{n} u_i = 5").sequence("u"),
        point(&[("n", 1)]).list("u", &[7]).unfolding(&[0])
    )
);
hole!(
    element_unfolded_out_of_explicit_sum,
    refuted(
        &claim(&["u_1 = 5"], r"\sum_{i=1}^{2} u_i = 5 + u_2"),
        point(&[("u_1", 7), ("u_2", 0)]).unfolding(&[0])
    )
);
hole!(
    element_domain_in_sum,
    refuted(
        &claim(&[], r"\sum_{i=1}^{2} u_i > 0")
            .sequence("u")
            .domain("u_1", positive())
            .domain("u_2", positive()),
        point(&[]).list("u", &[-1, -1])
    )
);
hole!(
    slope_of_element_all_equal,
    refuted(
        &claim(&[r"u_1 = u_2 = \dots = u_3 = 0"], r"\frac{du_1}{dx} = 0"),
        point(&[("u_1", 0), ("u_2", 0), ("u_3", 0), ("x", 0)]).slope("u_1", "x", 1)
    )
);
hole!(
    slope_of_element_sum,
    refuted(
        &claim(&[r"\sum_{i=1}^{1} u_i = 0"], r"\frac{du_1}{dx} = 0"),
        point(&[("u_1", 0), ("x", 0)]).slope("u_1", "x", 1)
    )
);
hole!(
    slope_of_element_zero_all_equal,
    refuted(
        &claim(
            &[r"u_1 = u_2 = \dots = u_3 = w", "w=x"],
            r"\frac{du_1}{dx} = 1"
        ),
        point(&[("u_1", 0), ("u_2", 0), ("u_3", 0), ("x", 0)])
            .unfolding(&[1])
            .slope("u_1", "x", 0)
    )
);
hole!(
    binder_in_bounds_unfold,
    refuted(
        &claim(&["x = 2"], r"\sum_{x=1}^{x} 1 = 2"),
        point(&[("x", 5)]).unfolding(&[0])
    )
);
hole!(
    negative_index_elements,
    Proving::new(claim(&[], r"\sum_{i=-1}^{0} u_i = 2 u_0")).trivially()
);
hole!(
    element_as_count,
    refuted(
        &claim(&[], r"\sum_{j=1}^{u_3} 1 = u_3").sequence("u"),
        point(&[("u_3", 2)]).list("u", &[1, 1, 1])
    )
);
hole!(
    limit_variable_unfolded,
    refuted(
        &claim(&["x = c", "y = x"], r"\lim_{x \to 0} y = 0").domain("c", constant()),
        point(&[("c", 1), ("x", 1)]).unfolding(&[0, 1])
    )
);
hole!(
    goal_root_of_negative,
    Proving::new(claim(&["x = -1"], r"\sqrt{x} = \sqrt{x}")).trivially()
);
hole!(
    goal_ln_negative,
    Proving::new(claim(&[], r"\ln(-1) = \ln(-1)")).trivially()
);
hole!(foreign_var_panics, {
    let p = Proving::new(claim(&[], "x = 0"));
    let q = Proving::new(claim(&[], "a + b + c + d = 0"));
    p.checked(Proof::Combination {
        multiplier: vec![(q.p("d"), 1)],
        power: 1,
        cofactors: vec![],
    })
});
hole!(
    integer_depends,
    Proving::new(claim(&["n x = 1"], r"\lim_{x \to 0} n x = 0").domain("n", integer())).trivially()
);
hole!(sum_with_bound_denominators, {
    let p = Proving::new(
        claim(
            &[r"\sum_{i=1}^{n} \frac{1}{u_i} = c"],
            r"\sum_{i=1}^{m} \frac{1}{u_i} = \sum_{i=1}^{m} \frac{1}{u_i}",
        )
        .sequence("u"),
    );
    p.trivially()
});
hole!(
    degenerate_domain_slope,
    refuted(
        &claim(&[], r"\frac{ds}{dx} = 0").domain(
            "s",
            Domain {
                lower: Some((number(1), false)),
                upper: Some((number(1), false)),
                ..Domain::default()
            }
        ),
        point(&[("x", 0), ("s", 1)]).slope("s", "x", 1)
    )
);
hole!(
    plus_sign_subscript,
    Proving::new({
        let mut c = claim(&[], "a = a").sequence("u");
        c.goal = Formula::equal(Expr::symbol("u_{+1}"), Expr::symbol("u_1"));
        c
    })
    .trivially()
);
hole!(
    zero_sign_subscript,
    Proving::new({
        let mut c = claim(&[], "a = a").sequence("u");
        c.goal = Formula::equal(Expr::symbol("u_{01}"), Expr::symbol("u_1"));
        c
    })
    .trivially()
);
hole!(
    element_by_itself,
    refuted(
        &claim(&[], r"\frac{du_1}{du_1} = 1").sequence("u"),
        point(&[]).list("u", &[1])
    )
);
hole!(
    element_by_itself2,
    refuted(
        &claim(&[], r"\frac{d}{du_1}[u_1^2] = 2 u_1").sequence("u"),
        point(&[]).list("u", &[1])
    )
);
hole!(
    sum_by_element,
    Proving::new(
        claim(&[], r"\frac{d}{du_1}\left[\sum_{i=1}^{n} u_i\right] = 0")
            .sequence("u")
            .domain("n", integer())
    )
    .trivially()
);
hole!(
    integer_varies_a,
    Proving::new(claim(&["n = 2 x"], r"\frac{dn}{dx} = 0").domain("n", integer())).trivially()
);
hole!(
    negative_count_sum_refuted,
    refuted(
        &claim(&["n = -1"], r"\sum_{i=1}^{n} u_i = 5").sequence("u"),
        point(&[]).unfolding(&[0])
    )
);
hole!(element_put_in_outside_of_its_sequence, {
    let mut c = claim(&["u_1 = -5"], "x = 1");
    c.sequences.insert(symbol("u"), positive());
    refuted(&c, point(&[("x", 2)]).unfolding(&[0]))
});
hole!(
    element_of_an_undeclared_sequence,
    refuted(
        &claim(&[r"u_1 = u_2 = \dots = u_n = 4", "n = 2"], "u_1 = 4"),
        point(&[("n", 2), ("u_1", 9)]).list("u", &[4, 4])
    )
);
hole!(bound_index_is_no_count, {
    let nested = r"\sum_{i=1}^{n} \sum_{j=1}^{i} u_j = 3";
    let p = Proving::new(claim(&["i = -1", nested], r"0 \geq 1").sequence("u"));
    let i = p.p("i");
    let not_negative = |f: &Fact| f.polynomial == i && f.sign == Sign::NonNegative;
    let at = p.problem.facts.iter().position(not_negative);
    let t = PositiveTerm {
        facts: vec![at.unwrap_or(99)],
        ..one()
    };
    p.checked(p.positivity(&[], vec![t], &[(0, "-1")]))
});
hole!(slope_of_an_element_that_is_an_integer, {
    let mut c = claim(&[], r"\frac{du_1}{dx} = 0");
    c.sequences.insert(symbol("u"), integer());
    refuted(&c, point(&[("x", 0)]).list("u", &[1]).slope("u_1", "x", 1))
});
