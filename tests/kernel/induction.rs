//! Proofs for every element of a sequence, and those that are none.

use cradle_verify::algebra::Moved;
use cradle_verify::kernel::{
    Assignment, Certificate, Claim, Domain, ForEvery, Instance, Part, Proof, Reasoning, Reject,
    at_the_index, check_for_every, refute_for_every,
};
use cradle_verify::sorted::{Map, Set};

use super::claims::*;

fn from(start: i64) -> Domain {
    Domain {
        lower: Some((number(start), false)),
        integer: true,
        ..Domain::default()
    }
}

/// A claim about every `n` from `start` on; the hypotheses `throughout` are said of every `n`.
fn for_every(start: i64, claim: Claim, throughout: &[usize]) -> ForEvery {
    let mut claim = claim;
    claim.domains.insert(symbol("n"), from(start));
    ForEvery {
        claim,
        index: symbol("n"),
        throughout: throughout.iter().copied().collect(),
        elements: Map::new(),
        varying: Set::new(),
    }
}

/// `S_{n+1} = S_n + d` for every `n ≥ start` ⊢ the goal.
fn steps(start: i64, goal: &str) -> ForEvery {
    for_every(start, claim(&["S_{n+1} = S_n + d"], goal), &[0])
}

fn at(hypothesis: usize, at: Moved) -> Instance {
    Instance { hypothesis, at }
}

/// A part of which the goal is the sum of some hypotheses, each with its cofactor.
fn part(
    claim: &ForEvery,
    goal: Moved,
    supposed: u32,
    instances: &[Instance],
    cofactors: &[(usize, &str)],
) -> Result<Part, Reject> {
    let (ordinary, _) = claim.part(goal, supposed, instances)?;
    let proving = Proving::new(ordinary);
    Ok(Part {
        instances: instances.to_vec(),
        certificate: conclusion(proving.combination(&[], 1, cofactors)),
    })
}

fn conclusion(conclusion: Proof) -> Certificate {
    Certificate {
        rates: Vec::new(),
        unfold: Vec::new(),
        lemmas: Vec::new(),
        conclusion,
    }
}

/// A part with a proof of another claim: it is rejected before anybody looks at that.
fn unproved(instances: &[Instance]) -> Part {
    Part {
        instances: instances.to_vec(),
        certificate: conclusion(Proof::Combination {
            multiplier: Vec::new(),
            power: 1,
            cofactors: Vec::new(),
        }),
    }
}

fn checked(claim: &ForEvery, bases: Vec<Part>, step: Part) -> Result<(), Reject> {
    let holds = check_for_every(claim.clone(), Reasoning::Induction { bases, step })?;
    assert_eq!(holds.claim(), claim);
    Ok(())
}

const BASE: Moved = Moved::To(0);
const STEP: Moved = Moved::By(1);

fn right_step(claim: &ForEvery) -> Part {
    let here = [at(0, Moved::By(0))];
    part(claim, STEP, 1, &here, &[(0, "1"), (1, "1")]).expect("a step")
}

#[test]
fn base_and_step_are_accepted() {
    let claim = steps(0, "S_n = S_0 + n d");
    let base = part(&claim, BASE, 0, &[], &[]).unwrap();
    assert_eq!(checked(&claim, vec![base], right_step(&claim)), Ok(()));
}

#[test]
fn induction_without_a_base_is_rejected() {
    let claim = steps(0, "S_n = S_0 + n d + 1");
    let step = right_step(&claim);
    assert_eq!(checked(&claim, Vec::new(), step), Err(Reject::NoBase));
}

#[test]
fn base_that_is_false_is_rejected() {
    let claim = steps(0, "S_n = S_0 + n d + 1");
    let base = part(&claim, BASE, 0, &[], &[]).unwrap();
    let step = right_step(&claim);
    assert_eq!(
        checked(&claim, vec![base], step),
        Err(Reject::IdentityFails)
    );
}

#[test]
fn step_with_the_wrong_coefficient_is_rejected() {
    let claim = steps(0, "S_n = S_0 + 2 n d");
    let base = part(&claim, BASE, 0, &[], &[]).unwrap();
    let step = right_step(&claim);
    assert_eq!(
        checked(&claim, vec![base], step),
        Err(Reject::IdentityFails)
    );
}

#[test]
fn base_is_at_the_first_index_and_nowhere_else() {
    // From 1 on, nothing is said of the step from 0 to 1.
    let claim = steps(1, "S_n = S_0 + n d");
    let step = right_step(&claim);
    let base = part(&claim, BASE, 0, &[], &[]).unwrap();
    let found = checked(&claim, vec![base], step.clone());
    assert_eq!(found, Err(Reject::IdentityFails));
    let before = unproved(&[at(0, Moved::To(0))]);
    let found = checked(&claim, vec![before], step);
    assert_eq!(found, Err(Reject::OutOfRange(0)));
}

#[test]
fn premise_is_not_used_before_the_first_element() {
    // At n = 0 this would speak of `S_{-1}`.
    let claim = for_every(0, claim(&["S_n = S_{n-1} + d"], "S_n = S_0 + n d"), &[0]);
    for early in [Moved::To(0), Moved::By(0)] {
        let instances = [at(0, early)];
        let part = claim.part(STEP, 1, &instances);
        assert_eq!(part.unwrap_err(), Reject::OutOfRange(0));
    }
    let base = part(&claim, BASE, 0, &[], &[]).unwrap();
    let next = [at(0, Moved::By(1))];
    let step = part(&claim, STEP, 1, &next, &[(0, "1"), (1, "1")]).unwrap();
    assert_eq!(checked(&claim, vec![base], step), Ok(()));
}

#[test]
fn premise_at_one_index_is_not_moved() {
    let mut claim = steps(0, "S_n = S_0 + n d");
    claim.throughout.clear();
    let constant = Domain {
        constant: true,
        ..Domain::default()
    };
    claim.claim.domains.insert(symbol("d"), constant);
    let base = part(&claim, BASE, 0, &[], &[]).unwrap();
    for moved in [Moved::By(0), Moved::By(1), Moved::To(3)] {
        let step = unproved(&[at(0, moved)]);
        let found = checked(&claim, vec![base.clone()], step);
        assert_eq!(found, Err(Reject::NotThroughout(0)));
    }
}

#[test]
fn value_of_the_index_is_not_among_the_premises_of_a_step() {
    // `n = 0` would make the step from 0 to 1 a step from n to n + 1.
    let claim = for_every(0, claim(&["n = 0", "S_1 = S_0"], "S_n = S_0"), &[]);
    let (step, _) = claim.part(STEP, 1, &[]).unwrap();
    assert_eq!(step.hypotheses.len(), 2, "S_1 = S_0, and what is supposed");
}

#[test]
fn symbol_tied_to_the_index_by_a_premise_at_one_index_is_rejected() {
    let premises = ["S_{n+1} = S_n + d", "d = n"];
    let claim = for_every(0, claim(&premises, "S_n = S_0 + n d"), &[0]);
    let step = unproved(&[at(0, Moved::By(0))]);
    let found = checked(&claim, vec![unproved(&[])], step);
    assert_eq!(found, Err(Reject::MayRun(symbol("d"))));
}

#[test]
fn symbol_tied_to_the_index_through_another_is_rejected() {
    let premises = ["S_{n+1} = S_n + d", "d = c", "c^2 = n"];
    let claim = for_every(0, claim(&premises, "S_n = S_0 + n d"), &[0]);
    let found = checked(&claim, vec![unproved(&[])], unproved(&[]));
    assert_eq!(found, Err(Reject::MayRun(symbol("d"))));
}

#[test]
fn symbol_that_is_said_to_vary_is_rejected_unless_it_is_constant() {
    let mut claim = steps(0, "S_n = S_0 + n d");
    claim.varying.insert(symbol("d"));
    let found = checked(&claim, vec![unproved(&[])], unproved(&[]));
    assert_eq!(found, Err(Reject::MayRun(symbol("d"))));
}

#[test]
fn index_that_does_not_run_is_rejected() {
    let bounded = Domain {
        upper: Some((number(9), false)),
        ..from(0)
    };
    let real = Domain {
        integer: false,
        ..from(0)
    };
    let fixed = Domain {
        constant: true,
        ..from(0)
    };
    let without_0 = Domain {
        nonzero: true,
        ..from(0)
    };
    for domain in [bounded, real, fixed, without_0, from(-1), Domain::default()] {
        let mut claim = steps(0, "S_n = S_0 + n d");
        claim.claim.domains.insert(symbol("n"), domain);
        let found = checked(&claim, vec![unproved(&[])], unproved(&[]));
        assert_eq!(found, Err(Reject::NoRun(symbol("n"))));
    }
}

#[test]
fn subscripts_that_are_not_read_are_not_moved() {
    for premise in ["S_{2n} = S_n + d", "S_{n,1} = S_n", "S_{in} = S_n"] {
        let claim = for_every(0, claim(&[premise], "S_n = S_0"), &[0]);
        let part = claim.part(STEP, 1, &[at(0, Moved::By(1))]);
        assert_eq!(part.unwrap_err(), Reject::Unmovable, "{premise}");
    }
}

#[test]
fn what_is_differentiated_or_unknown_is_not_moved() {
    for premise in [
        r"\frac{dS_n}{dx} = S_{n+1}",
        "F(n) = S_n",
        r"\int_0^1 S_n dx = S_{n+1}",
    ] {
        let claim = for_every(0, claim(&[premise], "S_n = S_0"), &[0]);
        let part = claim.part(STEP, 1, &[at(0, Moved::By(1))]);
        assert_eq!(part.unwrap_err(), Reject::Unmovable, "{premise}");
    }
}

#[test]
fn domain_of_the_elements_does_not_reach_before_the_first_index() {
    let mut claim = steps(1, "S_n = S_0");
    claim.elements.insert(symbol("S"), positive());
    let (base, _) = claim.part(Moved::To(1), 0, &[]).unwrap();
    assert!(base.domains.contains_key(&symbol("S_1")));
    assert!(!base.domains.contains_key(&symbol("S_0")));
}

#[test]
fn each_of_several_bases_is_wanted() {
    let premises = ["F_{n+2} = F_n", "F_0 = 1", "F_1 = 1"];
    let claim = for_every(0, claim(&premises, "F_n = 1"), &[0]);
    let base = |number, which| part(&claim, Moved::To(number), 0, &[], &[(which, "1")]).unwrap();
    let here = [at(0, Moved::By(0))];
    let step = part(&claim, Moved::By(2), 2, &here, &[(2, "1"), (3, "1")]).unwrap();
    let bases = vec![base(0, 0), base(1, 1)];
    assert_eq!(checked(&claim, bases, step.clone()), Ok(()));
    // With one base the step goes from n to n + 1.
    let found = checked(&claim, vec![base(0, 0)], step.clone());
    assert!(found.is_err());
    let same = vec![base(0, 0), base(0, 0)];
    assert_eq!(checked(&claim, same, step), Err(Reject::IdentityFails));
}

#[test]
fn premises_at_other_indices_need_no_induction() {
    let claim = steps(0, "S_{n+2} = S_n + 2 d");
    let both = [at(0, Moved::By(0)), at(0, Moved::By(1))];
    let part = part(&claim, Moved::By(0), 0, &both, &[(0, "1"), (1, "1")]).unwrap();
    assert!(check_for_every(claim, Reasoning::Direct(part)).is_ok());
}

#[test]
fn value_of_what_is_supposed_is_not_supposed() {
    // At n = 1 there is nothing to divide by; that x is not 0 must not be learnt from what is said of n.
    let premises = ["x S_{n+1} = x S_n"];
    let claim = for_every(1, claim(&premises, "S_n + x^{n-1} = S_1 + x^{n-1}"), &[0]);
    let base = part(&claim, Moved::To(1), 0, &[], &[]).unwrap();
    let step = unproved(&[at(0, Moved::By(0))]);
    let found = checked(&claim, vec![base], step);
    // Nothing is learnt of x, so the step is looked at; it is none.
    assert_eq!(found, Err(Reject::IdentityFails));
}

fn first(symbols: &[(&str, i64)]) -> Assignment {
    point(symbols)
}

fn against(claim: &ForEvery, number: u32, symbols: &[(&str, i64)]) -> Result<(), Reject> {
    let point = at_the_index(claim, number, first(symbols));
    refute_for_every(claim, number, point).map(|_| ())
}

#[test]
fn first_elements_refute() {
    let claim = steps(0, "S_n = S_0 + 2 n d");
    // What is said at the index itself speaks of the element after the next, too.
    let symbols = [("S_0", 0), ("S_1", 1), ("S_2", 2), ("S_3", 3), ("d", 1)];
    assert_eq!(against(&claim, 1, &symbols), Ok(()));
    assert_eq!(against(&claim, 0, &symbols), Err(Reject::GoalNotFalse));
}

#[test]
fn elements_that_break_the_premise_before_the_index_refute_nothing() {
    let claim = steps(0, "S_n = S_0 + n d");
    let symbols = [("S_0", 0), ("S_1", 5), ("S_2", 6), ("d", 1)];
    let found = against(&claim, 1, &symbols);
    assert!(matches!(found, Err(Reject::PremiseFalse(_))), "{found:?}");
}

#[test]
fn elements_that_leave_their_domain_later_refute_nothing() {
    // Positive for ever, it cannot fall by 1 each time.
    let mut claim = for_every(0, claim(&["S_{n+1} = S_n - 1"], "S_0 = 7"), &[0]);
    claim.elements.insert(symbol("S"), positive());
    let symbols = [("S_0", 5), ("S_1", 4), ("S_2", 3)];
    assert_eq!(against(&claim, 0, &symbols), Err(Reject::MayEnd));
    claim.elements.clear();
    assert_eq!(against(&claim, 0, &symbols), Ok(()));
}

#[test]
fn two_equations_for_the_same_elements_may_not_go_on() {
    let premises = ["S_{n+1} = 2 S_n", "S_{n+1} = S_n + n"];
    let claim = for_every(0, claim(&premises, "S_0 = 7"), &[0, 1]);
    let symbols = [("S_0", 0), ("S_1", 0), ("S_2", 0)];
    assert_eq!(against(&claim, 0, &symbols), Err(Reject::MayEnd));
}

#[test]
fn what_nothing_gives_may_stay_as_it_is() {
    let premises = ["S_n^2 = S_0^2"];
    let claim = for_every(0, claim(&premises, "S_n = 7"), &[0]);
    assert_eq!(against(&claim, 0, &[("S_0", 1)]), Ok(()));
    let premises = ["n S_n^2 = n S_0^2"];
    let claim = for_every(0, super::claims::claim(&premises, "S_n = 7"), &[0]);
    assert_eq!(against(&claim, 0, &[("S_0", 1)]), Err(Reject::MayEnd));
}
