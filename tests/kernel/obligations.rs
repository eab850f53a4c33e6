//! A claim that is read once, for several candidates.

use cradle_verify::kernel::{Candidate, Certificate, Claim, Obligation, Reject};

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
