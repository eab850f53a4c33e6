//! Roots and fractional powers: what is known of them, and what is not.

use cradle_verify::kernel::{
    Claim, Domain, Fact, Lemma, Origin, PositiveTerm, Proof, Reject, Sign,
};

use super::claims::*;

fn nonnegative() -> Domain {
    Domain {
        lower: Some((number(0), false)),
        ..Domain::default()
    }
}

fn natural() -> Domain {
    Domain {
        integer: true,
        ..nonnegative()
    }
}

/// How many facts say what a root or a power is.
fn known_of_powers(claim: &Claim) -> usize {
    let problem = Proving::new(claim.clone()).problem;
    let own = problem.origins.iter().filter(|o| **o == Origin::Powers);
    own.count()
}

#[test]
fn root_of_a_square_is_the_symbol_only_where_it_is_positive() {
    for text in [
        r"\sqrt{z^2} = z",
        r"(z^2)^{3/2} = z^3",
        r"(z^6)^{1/2} = z^3",
    ] {
        let goal = || claim(&[], text);
        assert_eq!(
            Proving::new(goal().domain("z", positive())).trivially(),
            Ok(())
        );
        let anything = Proving::new(goal());
        assert!(anything.trivially().is_err(), "{text}");
        // And indeed:
        assert_eq!(refuted(&goal(), point(&[("z", -2)])), Ok(()), "{text}");
    }
}

#[test]
fn sum_of_a_root_and_its_base_is_not_taken_for_nonzero() {
    // (√(z²) − z)(√(z²) + z) = 0 is known of every z; dividing by the second factor needs more. √(z²) is read as |z|.
    let real = Proving::new(claim(&[], r"\sqrt{z^2} = z"));
    let squared = real.p(r"\lvert z \rvert^2 - z^2");
    let own = |fact: &cradle_verify::kernel::Fact| {
        fact.sign == Sign::Zero && fact.polynomial.monic() == squared.monic()
    };
    let square = real.problem.facts.iter().position(own);
    let forged = cradle_verify::kernel::Proof::Combination {
        multiplier: real.factors(&[(r"\lvert z \rvert + z", 1)]),
        power: 1,
        cofactors: vec![(square.expect("the square of |z|"), real.p("1"))],
    };
    assert!(matches!(real.checked(forged), Err(Reject::MayVanish(_))));
}

#[test]
fn nothing_is_known_of_the_root_of_what_may_be_negative() {
    let root = || claim(&[], r"\sqrt{z}^2 = z");
    assert_eq!(known_of_powers(&root()), 0);
    assert!(known_of_powers(&root().domain("z", nonnegative())) > 0);
    // A premise that speaks of the root says that there is one.
    assert!(known_of_powers(&claim(&[r"w = \sqrt{z - 1}"], "w^2 = z - 1")) > 0);
    let needed = Proving::new(claim(&[], r"\sqrt{z} = \sqrt{z}")).trivially();
    assert!(needed.is_err(), "√z has no value for a negative z");
}

#[test]
fn root_of_a_product_needs_more_than_the_sign_of_the_product() {
    let goal = || claim(&[], r"\sqrt{y z} = \sqrt{y} \sqrt{z}");
    let both = goal().domain("y", positive()).domain("z", positive());
    assert_eq!(Proving::new(both).trivially(), Ok(()));
    for lone in ["y", "z"] {
        assert!(
            Proving::new(goal().domain(lone, positive()))
                .trivially()
                .is_err()
        );
    }
}

#[test]
fn odd_root_of_what_may_be_negative_is_left_alone() {
    let cubed = || claim(&[], r"(z^3)^{1/3} = z");
    assert_eq!(
        Proving::new(cubed().domain("z", positive())).trivially(),
        Ok(())
    );
    assert!(Proving::new(cubed()).trivially().is_err());
}

#[test]
fn point_must_give_a_root_a_rational_value() {
    let goal = claim(&[], r"\sqrt{x} = x").domain("x", positive());
    assert_eq!(refuted(&goal, point(&[("x", 4)])), Ok(()));
    assert_eq!(refuted(&goal, point(&[("x", 2)])), Err(Reject::NoValue));
    assert_eq!(
        refuted(&goal, point(&[("x", 1)])),
        Err(Reject::GoalNotFalse)
    );
    assert_eq!(
        refuted(&goal, point(&[("x", -4)])),
        Err(Reject::OutsideDomain)
    );
    // Without the domain a root of something negative has no value, which is no counterexample.
    let anywhere = claim(&[], r"\sqrt{x} = x");
    assert!(refuted(&anywhere, point(&[("x", -4)])).is_err());
}

#[test]
fn symbolic_power_is_taken_apart_for_naturals_or_a_positive_base() {
    let doubled = || claim(&[], "b^{2 n} = (b^n)^2");
    let read = |claim: Claim| Proving::new(claim).trivially();
    let counting = || Domain {
        lower: Some((number(1), false)),
        ..natural()
    };
    assert_eq!(read(doubled().domain("n", counting())), Ok(()));
    // 0^0 is 1, as it is at points.
    assert_eq!(read(doubled().domain("n", natural())), Ok(()));
    assert_eq!(read(doubled().domain("b", positive())), Ok(()));
    assert!(read(doubled()).is_err());
    // At n = −1 and b = 0 it would be 1 = 0 · b^(−1).
    let next = || claim(&[], "b^{n + 1} = b^n b");
    assert_eq!(read(next().domain("n", counting())), Ok(()));
    assert!(read(next()).is_err());
    // Broken in one place.
    let wrong = claim(&[], "b^{n + 2} = b^n b").domain("n", counting());
    assert!(read(wrong).is_err());
}

#[test]
fn power_with_exponent_0_says_nothing_of_its_base() {
    // At n = 0 and b = 0 the premise is true: nothing follows for b.
    let goal = claim(&["y = b^n"], r"b \neq 0").domain("n", natural());
    let p = Proving::new(goal.clone());
    let nonzero = p.problem.facts.iter().any(|f| f.sign == Sign::NonZero);
    assert!(!nonzero, "the premise has a value everywhere");
    // 0^0 is 1 at points too, and nothing else.
    let at = |y| point(&[("y", y), ("b", 0), ("n", 0)]);
    assert_eq!(refuted(&goal, at(1)), Ok(()));
    assert_eq!(refuted(&goal, at(0)), Err(Reject::PremiseFalse(0)));
}

#[test]
fn power_with_a_whole_exponent_says_nothing_of_its_base() {
    // Each has a value at b = 0 for some exponents, and below 0 for all others.
    let whole = || Domain {
        integer: true,
        ..Domain::default()
    };
    for premise in ["y = b^{n m}", "y = b^{n - 1}", "y = b^k", "y = b^{2 k + n}"] {
        let goal = claim(&[premise], "b > 0")
            .domain("n", natural())
            .domain("m", natural())
            .domain("k", whole());
        let said = |f: &Fact| matches!(f.sign, Sign::NonZero | Sign::Positive);
        let facts = Proving::new(goal).problem.facts;
        assert!(!facts.iter().any(said), "{premise}: {facts:?}");
    }
    // What is to be shown must have a value: b may be 0.
    let quotient = || claim(&[], "b^{k + 1} = b^k b").domain("k", whole());
    assert!(Proving::new(quotient()).trivially().is_err());
    let nonzero = Domain {
        nonzero: true,
        ..Domain::default()
    };
    assert_eq!(
        Proving::new(quotient().domain("b", nonzero)).trivially(),
        Ok(())
    );
}

#[test]
fn symbol_that_is_put_in_is_not_read_as_a_power_of_its_root() {
    // x is positive by declaration; z, which is put in for it, is not: the domain speaks of z then.
    let goal = claim(&["x = z"], r"\sqrt{x^2} = z").domain("x", positive());
    let read = Proving::unfolding(goal.clone(), &[0]);
    let about_z = read
        .problem
        .origins
        .iter()
        .any(|o| *o == Origin::Domain(symbol("x")));
    assert!(about_z, "the domain of x is kept");
    assert!(read.trivially().is_err());
    assert!(refuted(&goal, point(&[("x", -1), ("z", -1)])).is_err());
}

#[test]
fn sign_with_a_whole_exponent_is_1_or_minus_1() {
    let whole = || Domain {
        integer: true,
        ..Domain::default()
    };
    for goal in ["(-1)^{2 k} = 1", "(-1)^{2 k + 1} = -1", "(-2)^{2 k} = 4^k"] {
        let goal = || claim(&[], goal);
        let says = |proving: Proving| {
            let facts = &proving.problem.facts;
            facts.iter().any(|fact| fact.sign == Sign::Zero)
        };
        assert!(says(Proving::new(goal().domain("k", whole()))));
        // For k = 1/2 there is no such power.
        assert!(!says(Proving::new(goal().domain("k", positive()))));
    }
    // What is known of the sign is known of no other base.
    let other = claim(&[], "(-2 x)^{2 k} = 1").domain("k", whole());
    let other = other.domain("x", positive());
    let proving = Proving::new(other);
    let zero = proving
        .problem
        .facts
        .iter()
        .filter(|f| f.sign == Sign::Zero);
    assert_eq!(zero.count(), 1);
}

#[test]
fn power_of_0_is_0_where_its_exponent_is_positive() {
    let power = |domain: Domain, goal: &str| {
        let claim = claim(&[], goal).domain("n", domain);
        Proving::new(claim).trivially()
    };
    let from_1 = || Domain {
        lower: Some((number(1), false)),
        ..natural()
    };
    assert_eq!(power(from_1(), "0^n = 0"), Ok(()));
    assert_eq!(power(natural(), "0^{n + 1} = 0"), Ok(()));
    // 0^0 is 1, and 0^{-1} is nothing.
    assert!(power(natural(), "0^n = 0").is_err());
    assert!(power(from_1(), "0^{n - 1} = 0").is_err());
    assert!(power(positive(), "0^n = 0").is_err());
}

/// `v = b √x` from `v² = b² x`, with what may be forged about the root: a lemma on `lemma`, the one that is named for it by
/// its distance from the first, and what is said of the power.
fn root_by_its_base(lemma: &str, sign: Sign, named: usize, said: &str) -> Result<(), Reject> {
    let own = claim(&["v^2 = b^2 x"], r"v = b \sqrt{x}");
    let own = own.domain("v", positive()).domain("b", positive());
    let mut p = Proving::new(own);
    let first = p.problem.facts.len();
    let squares = PositiveTerm {
        squares: vec![p.p("v")],
        ..one()
    };
    p.lemmas.push(Lemma {
        fact: Fact {
            polynomial: p.p(lemma),
            sign,
        },
        proof: p.positivity(&[("b", 2)], vec![squares], &[(0, "-1")]),
    });
    let root = p.p(r"\sqrt{x}");
    let power = root.vars()[0];
    let fact = |polynomial, sign| Fact { polynomial, sign };
    for fact in [fact(p.p(said), Sign::Zero), fact(root.clone(), sign)] {
        let base = first + named;
        let proof = Proof::OfPower { power, base };
        p.lemmas.push(Lemma { fact, proof });
    }
    let multiplier = p.factors(&[(r"v + b \sqrt{x}", 1)]);
    p.checked(Proof::Combination {
        multiplier,
        power: 1,
        cofactors: vec![(0, p.p("1")), (first + 1, p.p("-b^2"))],
    })
}

#[test]
fn what_a_root_is_follows_once_its_base_is_proved_not_to_be_negative() {
    let square = r"\sqrt{x}^2 - x";
    let with = root_by_its_base;
    assert_eq!(with("x", Sign::NonNegative, 0, square), Ok(()));
    assert_eq!(with("x", Sign::Positive, 0, square), Ok(()));
    // The lemma is on something else, or there is none.
    assert_eq!(
        with("x - v", Sign::NonNegative, 0, square),
        Err(Reject::IdentityFails)
    );
    assert!(matches!(
        with("x", Sign::NonNegative, 7, square),
        Err(Reject::NoSuchFact(_))
    ));
    // More is said of the root than it is.
    for said in [r"\sqrt{x} - x", r"\sqrt{x}^2 - 2 x", r"\sqrt{x}"] {
        assert_eq!(
            with("x", Sign::NonNegative, 0, said),
            Err(Reject::WrongKind),
            "{said}"
        );
    }
}

#[test]
fn nothing_is_said_of_a_root_whose_base_has_no_sign() {
    let mut p = Proving::new(claim(&["y \\geq 0", "z = 0"], r"\sqrt{x}^2 = x"));
    let power = p.p(r"\sqrt{x}").vars()[0];
    let fact = Fact {
        polynomial: p.p(r"\sqrt{x}^2 - x"),
        sign: Sign::Zero,
    };
    let of_power = |power, base| Proof::OfPower { power, base };
    // That `y` is not negative says nothing of `x`, and that `z` is 0 is no sign.
    let base = p.hypothesis(0);
    let verdicts = [
        (of_power(power, base), Reject::MayBeNegative(term("x"))),
        (
            of_power(power, p.hypothesis(1)),
            Reject::NoSuchFact(p.hypothesis(1)),
        ),
        (of_power(power, 99), Reject::NoSuchFact(99)),
        // Neither a symbol nor what is not there is a power.
        (of_power(p.p("y").vars()[0], base), Reject::WrongKind),
    ];
    for (proof, reject) in verdicts {
        p.lemmas = vec![Lemma {
            fact: fact.clone(),
            proof,
        }];
        assert_eq!(p.trivially(), Err(reject));
    }
    let foreign = Proving::new(claim(&[], r"\sqrt{a} + b + c + d + x + y + z = 0"));
    let last = foreign.problem.atoms.iter().map(|(var, _)| var).last();
    let proof = of_power(last.expect("there are some"), base);
    p.lemmas = vec![Lemma { fact, proof }];
    assert_eq!(p.trivially(), Err(Reject::NoSuchUnknown));
}
