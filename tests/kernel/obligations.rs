//! A claim that is read once, for several candidates.

use cradle_verify::algebra::{Expr, Function};
use cradle_verify::kernel::{Candidate, Certificate, Checked, Claim, Obligation, Reject};

use super::claims::*;

fn substituted() -> Claim {
    claim(&["z = z", "y = x + 1"], "y^2 = 4")
}

#[test]
fn obligation_says_what_was_read() {
    for unfold in [vec![], vec![1]] {
        let read =
            Obligation::new(substituted(), unfold.clone()).expect("a claim that can be read");
        assert_eq!(read.claim(), &substituted());
        assert_eq!(read.unfold(), unfold);
        let problem = Proving::unfolding(substituted(), &unfold).problem;
        assert_eq!(read.problem().facts, problem.facts);
        assert_eq!(read.problem().goal, problem.goal);
    }
}

#[test]
fn candidate_is_judged_by_what_it_puts_in_itself() {
    let at = |x, y| point(&[("x", x), ("y", y), ("z", 0)]);
    for unfold in [vec![], vec![1]] {
        let read = Obligation::new(substituted(), unfold).expect("a claim that can be read");
        let verdict = |point| read.check(Candidate::Counterexample(point)).map(|_| ());
        assert_eq!(verdict(at(2, 3)), Ok(()));
        assert_eq!(verdict(at(2, 5)), Err(Reject::PremiseFalse(1)));
        // Where y is put in, its value is not looked at.
        assert_eq!(verdict(at(2, 5).unfolding(&[1])), Ok(()));
        assert_eq!(verdict(at(1, 5).unfolding(&[1])), Err(Reject::GoalNotFalse));
        let model = |point| read.model(point).map(|_| ());
        assert_eq!(model(at(1, 2)), Ok(()));
        assert_eq!(model(at(1, 5)), Err(Reject::PremiseFalse(1)));
        assert_eq!(model(at(1, 5).unfolding(&[1])), Ok(()));
    }
}

#[test]
fn proof_is_judged_by_what_it_puts_in_itself() {
    let goal = claim(&["y = x + 1"], "y^2 = (x + 1)^2");
    let conclusion = Proving::new(goal.clone()).combination(&[], 1, &[]);
    for unfold in [vec![], vec![0]] {
        let read = Obligation::new(goal.clone(), unfold).expect("a claim that can be read");
        let verdict = |unfold: &[usize]| {
            let certificate = Certificate {
                rates: Vec::new(),
                unfold: unfold.to_vec(),
                lemmas: vec![],
                conclusion: conclusion.clone(),
            };
            read.check(Candidate::Proof(certificate)).map(|_| ())
        };
        assert_eq!(verdict(&[0]), Ok(()));
        assert_eq!(verdict(&[]), Err(Reject::IdentityFails));
        assert_eq!(verdict(&[1]), Err(Reject::NoSuchFact(1)));
    }
}

#[test]
fn a_counterexample_at_which_more_is_positive_is_one() {
    let goal = r"\ln \frac{q}{p} = 2";
    let posed = |premises: &[&str]| {
        let claim = claim(premises, goal);
        Obligation::new(claim, Vec::new()).expect("a claim")
    };
    let found = |premises: &[&str]| {
        let mut point = point(&[("z", 1)]);
        for (name, value) in [("p", 0), ("q", 1)] {
            let call = Expr::Call(Function::Ln, term(name).into());
            point.functions.insert(call, number(value));
        }
        match posed(premises).check(Candidate::Counterexample(point)) {
            Ok(Checked::Refuted(refuted)) => refuted,
            other => panic!("{premises:?}: {other:?}"),
        }
    };
    let both = found(&["p > 0", "q > 0"]);
    assert_eq!(posed(&[]).refuted_by_fewer(&both), Ok(()));
    assert_eq!(posed(&["p > 0"]).refuted_by_fewer(&both), Ok(()));
    let other = posed(&["p = q"]).refuted_by_fewer(&both);
    assert_eq!(other, Err(Reject::OfAnotherClaim));
    // Nothing else may be said besides, and of nothing else.
    for premises in [
        &["p > 0", "q > 0", "z > 0"][..],
        &["p > 0", "q > 0", "1 = 1"],
        &["p > 0", "q > 0", r"\pi > 0"],
    ] {
        let verdict = posed(&[]).refuted_by_fewer(&found(premises));
        assert_eq!(verdict, Err(Reject::OfAnotherClaim), "{premises:?}");
    }
}

/// A counterexample where symbols are numbers besides is one, and none where anything else is said of them.
#[test]
fn a_counterexample_at_numbers_is_one() {
    let posed = |premises: &[&str]| {
        Obligation::new(claim(premises, "x + y = 3"), Vec::new()).expect("a claim")
    };
    let found = |premises: &[&str]| {
        let at = point(&[("x", 1), ("y", 1), ("w", 1)]);
        match posed(premises).check(Candidate::Counterexample(at)) {
            Ok(Checked::Refuted(refuted)) => refuted,
            other => panic!("{premises:?}: {other:?}"),
        }
    };
    let own = posed(&[]);
    assert_eq!(own.refuted_by_fewer(&found(&["x = 1"])), Ok(()));
    assert_eq!(own.refuted_by_fewer(&found(&["x = 1", "y = 1"])), Ok(()));
    for premises in [&["x = y"][..], &["1 = x"], &["x + y = 2"], &["w = 1"]] {
        let verdict = own.refuted_by_fewer(&found(premises));
        assert_eq!(verdict, Err(Reject::OfAnotherClaim), "{premises:?}");
    }
}

/// The opposite may follow from which numbers symbols are at the point, and from no others.
#[test]
fn equation_is_refuted_by_its_opposite_at_numbers() {
    use cradle_verify::search::{Effort, prove_posed};

    let opposite = |premises: &[&str], unfold: &[usize]| {
        let claim = claim(premises, r"\ln x \neq y");
        let posed = Obligation::new(claim, unfold.to_vec()).expect("a claim");
        prove_posed(&posed, Effort::Full)
            .expect("it follows")
            .proven
    };
    let posed = |premises: &[&str], unfold: &[usize]| {
        let claim = claim(premises, r"\ln x = y");
        Obligation::new(claim, unfold.to_vec()).expect("a claim")
    };
    let own = posed(&[], &[]);
    let at = |x, y| point(&[("x", x), ("y", y)]);
    let proven = opposite(&["x = 2", "y = 1"], &[0, 1]);
    assert!(own.refuted_by_opposite(&proven, at(2, 1)).is_ok());
    // At the point they are other numbers, or none.
    for other in [at(2, 3), at(3, 1), point(&[("x", 2)])] {
        let verdict = own.refuted_by_opposite(&proven, other);
        assert_eq!(verdict.err(), Some(Reject::OfAnotherClaim));
    }
    // What a hypothesis says that is put in is no other number because the point says so.
    let defined = posed(&["x = 3"], &[0]);
    let proven = opposite(&["x = 3", "x = 2", "y = 1"], &[0, 2]);
    let mut there = at(2, 1);
    there.unfold = vec![0];
    let verdict = defined.refuted_by_opposite(&proven, there.clone());
    assert_eq!(verdict.err(), Some(Reject::OfAnotherClaim));
    // Nor is there a hypothesis that is not there.
    there.unfold = vec![1];
    let verdict = defined.refuted_by_opposite(&proven, there);
    assert_eq!(verdict.err(), Some(Reject::NotUnfoldable(1)));
}

/// An equation is refuted by its opposite where the hypotheses are true at a point, and by nothing else.
#[test]
fn equation_is_refuted_by_its_opposite() {
    use cradle_verify::search::{Effort, prove_unconditionally};

    let opposite = |premises: &[&str], goal: &str| {
        let derived = prove_unconditionally(claim(premises, goal), Effort::Full);
        derived.expect("it follows").proven
    };
    let posed = |premises: &[&str], goal: &str| {
        Obligation::new(claim(premises, goal), Vec::new()).expect("a claim")
    };
    let one = || point(&[("x", 1)]);
    let proven = opposite(&["x > 0"], r"x + \ln 2 \neq 0");
    let own = posed(&["x > 0"], r"x + \ln 2 = 0");
    let refuted = own
        .refuted_by_opposite(&proven, one())
        .expect("it is false");
    assert_eq!(refuted.claim(), own.claim());
    assert_eq!(refuted.witness(), &one());
    // Where no point is, anything follows.
    let nowhere = own.refuted_by_opposite(&proven, point(&[("x", -1)]));
    assert_eq!(nowhere.err(), Some(Reject::PremiseFalse(0)));
    assert_eq!(
        own.refuted_by_opposite(&proven, point(&[])).err(),
        Some(Reject::NoValue)
    );
    // The opposite of another equation, or from more, says nothing of this one.
    let other = posed(&["x > 0"], r"x + \ln 3 = 0");
    let more = posed(&[], r"x + \ln 2 = 0");
    for claim in [other, more] {
        let verdict = claim.refuted_by_opposite(&proven, one());
        assert_eq!(verdict.err(), Some(Reject::OfAnotherClaim));
    }
    // What is proved is no proof that it is false.
    let same = opposite(&["x > 0"], r"x + \ln 2 > 0");
    let inequality = |relation: &str| posed(&["x > 0"], &format!(r"x + \ln 2 {relation} 0"));
    let verdict = inequality(">").refuted_by_opposite(&same, one());
    assert_eq!(verdict.err(), Some(Reject::OfAnotherClaim));
    let verdict = inequality(r"\leq").refuted_by_opposite(&same, one());
    assert!(verdict.is_ok(), "{verdict:?}");
    // Of all elements of a sequence nothing else is the opposite.
    let all = opposite(&["u_1 = \\dots = u_k"], "u_1 = \\dots = u_k");
    let elements = posed(&["u_1 = \\dots = u_k"], "u_1 = \\dots = u_k");
    let verdict = elements.refuted_by_opposite(&all, point(&[("k", 0)]));
    assert_eq!(verdict.err(), Some(Reject::OfAnotherClaim));
}
