//! How much work exact arithmetic may still do for the question at hand.
//!
//! Each operation on polynomials is bounded by itself; a question that asks for very many of them is bounded here. Work is
//! counted, not timed, so the same question comes to the same end on any machine. One unit is about one product of two terms
//! with small coefficients.

use std::cell::Cell;

thread_local! {
    static LEFT: Cell<u64> = const { Cell::new(u64::MAX) };
}

/// What is restored when a question is answered, also where that ends in a panic.
struct Before(u64);

impl Drop for Before {
    fn drop(&mut self) {
        LEFT.set(self.0);
    }
}

/// Does something with a budget of its own, whatever is left outside: there nothing is taken off.
///
/// Once it is used up, what could grow answers [`TooLarge`](super::TooLarge).
pub fn within<R>(budget: u64, work: impl FnOnce() -> R) -> R {
    let _before = Before(LEFT.replace(budget));
    work()
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
