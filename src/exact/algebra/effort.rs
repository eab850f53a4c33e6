//! How much work exact arithmetic may still do for the question at hand.
//!
//! Each operation on polynomials is bounded by itself; a question that asks for very many of them is bounded here. Work is
//! counted, not timed, so the same question comes to the same end on any machine. One unit is about one product of two terms
//! with small coefficients.

use std::cell::Cell;

thread_local! {
    static LEFT: Cell<u64> = const { Cell::new(u64::MAX) };
    /// What was spent of all budgets that are over, and what that may come to.
    static SPENT: Cell<u64> = const { Cell::new(0) };
    static CEILING: Cell<u64> = const { Cell::new(u64::MAX) };
}

/// What is restored when a question is answered, also where that ends in a panic.
struct Before {
    left: u64,
    /// What there was for the question.
    own: u64,
}

impl Drop for Before {
    fn drop(&mut self) {
        let spent = self.own - LEFT.replace(self.left);
        SPENT.set(SPENT.get().saturating_add(spent));
    }
}

/// Does something with a budget of its own, whatever is left outside: there nothing is taken off.
///
/// Once it is used up, what could grow answers [`TooLarge`](super::TooLarge).
pub fn within<R>(budget: u64, work: impl FnOnce() -> R) -> R {
    let own = budget.min(CEILING.get().saturating_sub(SPENT.get()));
    let _before = Before {
        left: LEFT.replace(own),
        own,
    };
    work()
}

/// Does something with three quarters of what is left, which is taken off: the rest is kept for what comes after.
pub fn with_most<R>(work: impl FnOnce() -> R) -> R {
    let left = LEFT.get();
    with_share(left - left / 4, work)
}

/// Does something with no more than this of what is left, which is taken off.
pub fn with_at_most<R>(budget: u64, work: impl FnOnce() -> R) -> R {
    with_share(budget.min(LEFT.get()), work)
}

/// Does something with a share of what is left; what it leaves of that is added to the rest, also where it ends in a panic.
fn with_share<R>(share: u64, work: impl FnOnce() -> R) -> R {
    struct Rest(u64);
    impl Drop for Rest {
        fn drop(&mut self) {
            LEFT.set(LEFT.get().saturating_add(self.0));
        }
    }
    let _rest = Rest(LEFT.replace(share) - share);
    work()
}

/// Does something for which there is no more than this, with all the budgets of their own that there are in it.
pub fn altogether<R>(budget: u64, work: impl FnOnce() -> R) -> R {
    struct Outside(u64);
    impl Drop for Outside {
        fn drop(&mut self) {
            CEILING.set(self.0);
        }
    }
    let outside = CEILING.get();
    let _outside = Outside(outside);
    CEILING.set(outside.min(SPENT.get().saturating_add(budget)));
    within(budget, work)
}

/// Whether nothing is left of what there is altogether.
pub fn is_exhausted() -> bool {
    SPENT.get() >= CEILING.get()
}

/// Takes some of what is left.
#[inline]
pub(super) fn spend(units: usize) {
    LEFT.set(LEFT.get().saturating_sub(units as u64));
}

/// Whether nothing is left.
#[inline]
pub fn is_spent() -> bool {
    LEFT.get() == 0
}
