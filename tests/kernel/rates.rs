//! Laws that are differentiated, and what may not be.

use cradle_verify::kernel::{
    Candidate, Certificate, Claim, Domain, Obligation, Origin, Problem, Proof, Rate, Reject, Sign,
    check,
};

use super::claims::*;

const GOAL: &str = r"x \frac{dx}{dt} + y \frac{dy}{dt} = 0";

fn circle() -> Claim {
    claim(&["x^2 + y^2 = r^2"], GOAL).domain("r", constant())
}

fn rate(fact: usize, variable: &str) -> Rate {
    Rate {
        fact,
        variable: symbol(variable),
    }
}

fn problem(claim: &Claim) -> Problem {
    Problem::new(claim, &[]).expect("a claim that can be read")
}

/// What the kernel says of the goal as half of the first fact after the problem's own.
fn halved(claim: Claim, rates: Vec<Rate>) -> Result<(), Reject> {
    let own = Proving::new(claim.clone());
    let certificate = Certificate {
        unfold: Vec::new(),
        rates,
        lemmas: Vec::new(),
        conclusion: Proof::Combination {
            multiplier: Vec::new(),
            power: 1,
            cofactors: vec![(own.problem.facts.len(), own.p("1/2"))],
        },
    };
    check(claim, Candidate::Proof(certificate)).map(|_| ())
}

#[test]
fn law_holds_at_all_times() {
    assert_eq!(halved(circle(), vec![rate(0, "t")]), Ok(()));
    assert_eq!(halved(circle(), vec![]), Err(Reject::NoSuchFact(1)));
    // With a radius that may grow it is another fact.
    let grows = claim(&["x^2 + y^2 = r^2"], GOAL);
    assert_eq!(
        halved(grows, vec![rate(0, "t")]),
        Err(Reject::IdentityFails)
    );
    // By another variable everything is something else.
    assert_eq!(
        halved(circle(), vec![rate(0, "s")]),
        Err(Reject::IdentityFails)
    );
}

#[test]
fn what_is_said_of_one_point_has_no_slope() {
    let claim = circle().at_point(0);
    assert_eq!(halved(claim, vec![rate(0, "t")]), Err(Reject::NoRate(0)));
}

#[test]
fn only_equations_that_are_premises_are_differentiated() {
    let claim = claim(&["x^2 > y^2", "x = y"], GOAL).domain("x", positive());
    let problem = problem(&claim);
    for (fact, origin) in problem.origins.iter().enumerate() {
        let result = problem.with_rates(&[rate(fact, "t")]).map(|_| ());
        let is_law = *origin == Origin::Hypothesis(1);
        let expected = if is_law {
            Ok(())
        } else {
            Err(Reject::NoSuchFact(fact))
        };
        assert_eq!(result, expected);
    }
    let beyond = problem.facts.len();
    let result = problem.with_rates(&[rate(beyond, "t")]).map(|_| ());
    assert_eq!(result, Err(Reject::NoSuchFact(beyond)));
}

#[test]
fn slope_is_differentiated_again() {
    let claim = claim(&["y = t^3"], r"\frac{d^2 y}{dt^2} = 6 t");
    let problem = problem(&claim);
    let own = problem.facts.len();
    let twice = problem.with_rates(&[rate(0, "t"), rate(own, "t")]);
    let twice = twice.expect("a law");
    assert_eq!(twice.origins[own..], [Origin::Rate(0), Origin::Rate(0)]);
    assert_eq!(twice.facts[own + 1].sign, Sign::Zero);
    let (above, goal) = (&twice.facts[own + 1].polynomial, &twice.goal.polynomial);
    assert_eq!(above.monic(), goal.monic());
}

#[test]
fn by_a_whole_number_nothing_is_differentiated() {
    let whole = || Domain {
        integer: true,
        ..Domain::default()
    };
    let squares = claim(&["z = n^2"], "z = 2 n").domain("n", whole());
    let result = problem(&squares).with_rates(&[rate(0, "n")]).map(|_| ());
    assert_eq!(result, Err(Reject::NoRate(0)));
    // Nor is a derivative by one read.
    let slope = r"\frac{dz}{dn}";
    let asked = claim(&["z = n^2"], &format!("{slope} = 2 n")).domain("n", whole());
    let read = Problem::new(&asked, &[]).map(|_| ());
    assert_eq!(read, Err(Reject::MayHaveNoValue(term(slope))));
    // Nor by what never changes.
    let claim = circle().domain("t", constant());
    assert_eq!(halved(claim, vec![rate(0, "t")]), Err(Reject::NoRate(0)));
}

#[test]
fn what_may_have_no_slope_is_not_differentiated() {
    let slope = |law: &str, domain: Option<Domain>| {
        let mut claim = claim(&[law], r"\frac{dx}{dt} = 0");
        if let Some(domain) = domain {
            claim = claim.domain("x", domain);
        }
        let fact = |origin: &Origin| *origin == Origin::Hypothesis(0);
        let problem = problem(&claim);
        let at = problem.origins.iter().position(fact).expect("a fact");
        problem.with_rates(&[rate(at, "t")]).map(|_| ())
    };
    for law in [
        r"\lceil x \rceil = y",
        r"\lvert x \rvert = y",
        r"\sqrt{x} = y",
    ] {
        assert_eq!(slope(law, None), Err(Reject::NoRate(0)), "{law}");
    }
    assert_eq!(slope(r"\lvert x \rvert = y", Some(positive())), Ok(()));
    assert_eq!(slope(r"\sin x = y", None), Ok(()));
    assert_eq!(slope(r"\frac{1}{x} = y", None), Ok(()));
}

#[test]
fn counterexamples_are_read_without_slopes() {
    let read = Obligation::new(circle(), Vec::new()).expect("a claim that can be read");
    assert_eq!(read.problem().facts.len(), 1);
}
