//! What a question may cost: budgets inside budgets, and what becomes of them in a panic.

use cradle_verify::algebra::effort::{altogether, is_exhausted, is_spent, within};
use cradle_verify::algebra::{Polynomial, Rational};

/// Does a number of units of work: a product of two terms is one.
fn work(units: usize) {
    let term = Polynomial::constant(Rational::from(2));
    for _ in 0..units {
        let _ = term.times(&term);
    }
}

#[test]
fn a_question_inside_another_has_a_budget_of_its_own() {
    within(10, || {
        work(4);
        within(3, || {
            work(2);
            assert!(!is_spent());
            work(3);
            assert!(is_spent());
        });
        assert!(!is_spent());
        work(5);
        assert!(!is_spent());
        work(1);
        assert!(is_spent());
    });
    assert!(!is_spent());
}

#[test]
fn a_panic_does_not_leave_its_budget_behind() {
    let broken = std::panic::catch_unwind(|| within(0, || assert!(!is_spent(), "on purpose")));
    assert!(broken.is_err());
    assert!(!is_spent());
}

#[test]
fn there_is_no_more_altogether_than_is_said() {
    altogether(10, || {
        within(8, || work(6));
        assert!(!is_exhausted());
        // What is left of it is less than this asks for.
        within(8, || {
            work(3);
            assert!(!is_spent());
            work(1);
            assert!(is_spent());
        });
        assert!(is_exhausted());
        within(8, || assert!(is_spent()));
    });
    assert!(!is_exhausted());
    within(8, || assert!(!is_spent()));
}
