//! Equations between products by their logarithms: accepted, then with something in it that may not be positive, may vanish or is
//! another equation.

use cradle_verify::kernel::{Claim, Domain, Fact, Lemma, Origin, Proof, Reject, Sign};

use super::claims::*;

/// `x^p = y^p ⊢ x = y`
fn injective() -> Claim {
    claim(&["x^p = y^p"], "x = y")
}

fn all_positive(mut claim: Claim, names: &[&str]) -> Claim {
    for name in names {
        claim = claim.domain(name, positive());
    }
    claim
}

/// Where the logarithms of a premise stand among the facts.
fn taken(p: &Proving) -> Option<usize> {
    let mut origins = p.problem.origins.iter();
    origins.position(|origin| matches!(origin, Origin::Logarithms(_)))
}

/// `factor · (\ln x - \ln y) = times · (p \ln x - p \ln y)`, up to the sign that the reading chose.
fn by_logarithms(p: &Proving, factor: &str, times: &str) -> Proof {
    let fact = taken(p).expect("the premise equates what is positive");
    let goal = p
        .problem
        .goal_in_logarithms
        .clone()
        .expect("so does the goal");
    let own = p.p("p").times(&goal).expect("small");
    let times = match own == p.problem.facts[fact].polynomial {
        true => times.to_owned(),
        false => format!("-{times}"),
    };
    Proof::Logarithms(combined(p, &[(factor, 1)], (fact, &times)).into())
}

/// `multiplier · goal = times · fact`
fn combined(p: &Proving, multiplier: &[(&str, u32)], (fact, times): (usize, &str)) -> Proof {
    Proof::Combination {
        multiplier: p.factors(multiplier),
        power: 1,
        cofactors: vec![(fact, p.p(times))],
    }
}

#[test]
fn what_is_positive_is_equal_where_the_logarithms_are() {
    let p = Proving::new(all_positive(injective(), &["x", "y", "p"]));
    assert_eq!(p.checked(by_logarithms(&p, "p", "1")), Ok(()));
    let wrong = by_logarithms(&p, "p", "2");
    assert_eq!(p.checked(wrong), Err(Reject::IdentityFails));
}

#[test]
fn factor_of_logarithms_must_not_vanish() {
    // 1 = 2^0 · 1 says nothing of 2.
    let p = Proving::new(all_positive(injective(), &["x", "y"]));
    let proof = by_logarithms(&p, "p", "1");
    assert_eq!(p.checked(proof), Err(Reject::MayVanish(term("p"))));
}

#[test]
fn nothing_is_taken_of_what_may_be_negative() {
    let nonnegative = || Domain {
        lower: Some((number(0), false)),
        ..Domain::default()
    };
    let scaled = || all_positive(claim(&["c x^p = y^p"], "c x = y"), &["x", "y", "p"]);
    assert!(taken(&Proving::new(scaled().domain("c", positive()))).is_some());
    for claim in [scaled(), scaled().domain("c", nonnegative())] {
        let p = Proving::new(claim);
        assert_eq!(taken(&p), None);
        assert_eq!(p.problem.goal_in_logarithms, None);
        let inner = p.combination(&[], 1, &[]);
        let proof = Proof::Logarithms(inner.into());
        assert_eq!(p.checked(proof), Err(Reject::WrongKind));
    }
    // That there are the powers says that their bases are positive, where the exponent is any number; not for a whole one.
    assert!(taken(&Proving::new(injective())).is_some());
    let natural = Domain {
        integer: true,
        ..positive()
    };
    assert_eq!(taken(&Proving::new(injective().domain("p", natural))), None);
}

#[test]
fn logarithms_are_taken_of_two_products_with_opposite_signs_only() {
    let names = ["x", "y", "p"];
    for goal in ["x + y = 0", "x^2 = y + 1", "x = 0"] {
        let p = Proving::new(all_positive(claim(&["x^p = y^p"], goal), &names));
        assert_eq!(p.problem.goal_in_logarithms, None, "{goal}");
    }
    for premise in ["x^p + y^p = 0", "x^p = y^p + 1"] {
        let p = Proving::new(all_positive(claim(&[premise], "x = y"), &names));
        assert_eq!(taken(&p), None, "{premise}");
    }
    // Nor of what is no equation; what else is one does not matter.
    let p = Proving::new(all_positive(claim(&["x^p = y^p"], r"x \geq y"), &names));
    assert_eq!(p.problem.goal_in_logarithms, None);
    assert!(taken(&p).is_some());
    for premise in [r"x^p \geq y^p", r"x^p \neq y^p", "x^p > y^p"] {
        let p = Proving::new(all_positive(claim(&[premise], "x = y"), &names));
        assert_eq!(taken(&p), None, "{premise}");
        assert!(p.problem.goal_in_logarithms.is_some());
    }
    // Where nothing is raised to a power, and no logarithm is spoken of, there is none.
    let p = Proving::new(all_positive(claim(&["x = 2 y"], "x^2 = 4 y^2"), &names));
    assert_eq!((taken(&p), &p.problem.goal_in_logarithms), (None, &None));
    // Of what logarithms are spoken of they are taken, and of nothing else.
    let spoken = |premise| {
        Proving::new(all_positive(
            claim(&[premise], r"\ln x = \ln 2 + \ln y"),
            &names,
        ))
    };
    assert!(taken(&spoken("x = 2 y")).is_some());
    assert_eq!(taken(&spoken("x p = 2 y")), None);
}

#[test]
fn exponent_that_may_have_no_value_is_left_alone() {
    let goal = |names: &[&str]| {
        let claim = all_positive(claim(&["x = y^p"], "x^{1/p} = y"), names);
        Proving::new(claim).problem.goal_in_logarithms
    };
    assert!(goal(&["x", "y", "p"]).is_some());
    assert!(goal(&["x", "y"]).is_none());
}

#[test]
fn logarithms_prove_no_other_equation_than_the_goal() {
    let p = Proving::new(all_positive(injective(), &["x", "y", "p"]));
    let fact = |polynomial| Fact {
        polynomial,
        sign: Sign::Zero,
    };
    let with = |text: &str| {
        let mut own = p.clone();
        own.lemmas.push(Lemma {
            fact: fact(p.p(text)),
            proof: by_logarithms(&p, "p", "1"),
        });
        own.checked(by_logarithms(&p, "p", "1"))
    };
    assert_eq!(with("x - 2 y"), Err(Reject::WrongKind));
    // `x ≠ y` follows from nothing of the kind.
    let apart = Proving::new(all_positive(
        claim(&["x^p = y^p"], r"x \neq y"),
        &["x", "y", "p"],
    ));
    let inner = apart.combination(&[], 1, &[]);
    let proof = Proof::Logarithms(inner.into());
    assert_eq!(apart.checked(proof), Err(Reject::WrongKind));
}

#[test]
fn exponentials_are_positive_whatever_their_exponents_are() {
    let p = Proving::new(claim(&[r"\exp(a) = \exp(b)"], "a = b"));
    let fact = taken(&p).expect("both are positive");
    let times = match p.problem.facts[fact].polynomial == p.problem.goal.polynomial {
        true => "1",
        false => "-1",
    };
    assert_eq!(p.checked(combined(&p, &[], (fact, times))), Ok(()));
    // Of a factor that may be negative there is no logarithm: c = 0 makes it true for all a and b.
    let p = Proving::new(claim(&[r"c \exp(a) = c \exp(b)"], "a = b"));
    assert_eq!(taken(&p), None);
}

#[test]
fn premise_that_something_is_positive_takes_powers_apart() {
    let apart = |premises: &[&str]| Proving::new(claim(premises, "(x y)^p = x^p y^p")).trivially();
    assert_eq!(apart(&["x > 0", "y > 0"]), Ok(()));
    assert_eq!(apart(&["0 < x", "1 < y"]), Ok(()));
    for premises in [
        &["x > 0"][..],
        &[r"x \geq 0", "y > 0"],
        &["x > -1", "y > 0"],
        &["x < 0", "y > 0"],
        &["x = 1", "y > 0"],
        &[r"x \neq 0", "y > 0"],
    ] {
        assert!(apart(premises).is_err(), "{premises:?}");
    }
    // What is integrated over is something else of that name.
    let bound = claim(&["x > 0"], r"\int_{-1}^{1} (x^2)^{1/2} \, dx = 0");
    assert!(Proving::new(bound).trivially().is_err());
}

/// What is divided by before logarithms are taken must not vanish.
#[test]
fn common_factor_is_divided_by_where_it_does_not_vanish() {
    let halved = |premises: &[&str]| {
        let all: Vec<&str> = premises
            .iter()
            .copied()
            .chain([r"c \exp(k t) = 2 c"])
            .collect();
        taken(&Proving::new(claim(&all, r"k t = \ln 2"))).is_some()
    };
    assert!(halved(&[r"c \neq 0"]));
    assert!(!halved(&[]));
}

/// Both bounds of each logarithm, and none of what is no prime number or too great.
#[test]
fn logarithms_of_numbers_lie_between_bounds() {
    let false_at = |goal: &str| refuted(&claim(&[], goal), point(&[]));
    for (prime, below, above) in [
        ("2", "693147180", "693147181"),
        ("3", "1098612288", "1098612289"),
        ("7", "1945910149", "1945910150"),
        ("999983", "13815493557", "13815493559"),
    ] {
        let part = format!(r"1000000000 \ln {prime}");
        for (goal, verdict) in [
            (format!("{part} < {below}"), Ok(())),
            (format!("{part} > {below}"), Err(Reject::GoalNotFalse)),
            (format!("{part} > {above}"), Ok(())),
            (format!("{part} < {above}"), Err(Reject::GoalNotFalse)),
        ] {
            assert_eq!(false_at(&goal), verdict, "{goal}");
        }
        let p = Proving::new(claim(&[], &format!(r"\ln {prime} > 0")));
        let bounds = p.problem.facts.iter();
        let bounds =
            bounds.filter(|fact| fact.sign == Sign::Positive && fact.polynomial.len() == 2);
        assert_eq!(bounds.count(), 2, "{prime}");
    }
    // 1000003 is prime, too.
    assert_eq!(false_at(r"\ln 1000003 < 13"), Err(Reject::NoValue));
    let great = Proving::new(claim(&[], r"\ln 1000003 > 0"));
    assert!(great.problem.facts.is_empty());
}

/// The logarithm of a prime number is transcendental: an equation is told by its coefficients.
#[test]
fn equation_in_one_logarithm_is_told_by_its_coefficients() {
    let at_two = |goal: &str| refuted(&claim(&[], goal), point(&[("x", 2)]));
    assert_eq!(at_two(r"x \ln 2 = 3 \ln 2"), Ok(()));
    assert_eq!(at_two(r"(\ln 2)^2 = x \ln 2"), Ok(()));
    assert_eq!(at_two(r"\ln 4 = x \ln 2"), Err(Reject::GoalNotFalse));
    let premise = claim(&[r"1000 \ln 2 = 693 + x"], "x = 3");
    assert_eq!(
        refuted(&premise, point(&[("x", 2)])),
        Err(Reject::PremiseFalse(0))
    );
}

/// Nobody knows how two such numbers belong together.
#[test]
fn logarithm_of_a_number_stands_beside_no_other_number_of_its_kind() {
    let at_one = |goal: &str| refuted(&claim(&[], goal), point(&[("x", 1)]));
    for goal in [
        r"\ln 2 = \ln 3",
        r"\ln 2 = \pi",
        r"\ln 2 = \exp x",
        r"\exp x = \ln 2",
        r"\sin(\ln 2) = 0",
        r"\sin(\ln 2) \neq 0",
    ] {
        let verdict = at_one(goal);
        assert!(
            matches!(verdict, Err(Reject::NoValue)),
            "{goal}: {verdict:?}"
        );
    }
}
