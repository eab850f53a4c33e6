//! The same work on several things, by several threads: no result depends on how many.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, OnceLock, PoisonError};

/// More threads than this would mostly wait for one another.
const MOST_THREADS: usize = 8;
/// How many were asked for; 0 where nobody did.
static ASKED_FOR: AtomicUsize = AtomicUsize::new(0);
/// How many processors there are.
static PROCESSORS: OnceLock<usize> = OnceLock::new();

/// How many threads work where there is enough to do: as many as were asked for, else as many as there are processors.
///
/// No result depends on it.
pub fn threads() -> usize {
    let asked_for = match ASKED_FOR.load(Ordering::Relaxed) {
        // To count them takes some fifteen questions to the system.
        0 => {
            *PROCESSORS.get_or_init(|| std::thread::available_parallelism().map_or(1, |n| n.get()))
        }
        threads => threads,
    };
    asked_for.min(MOST_THREADS)
}

/// From now on at most so many threads work in this process; 0 stands for as many as there are processors.
pub fn use_threads(most: usize) {
    ASKED_FOR.store(most, Ordering::Relaxed);
}

/// Does the same to each of some items, several at a time, and hands the results over in their order.
pub fn in_order<T: Send, R: Send + Sync>(
    items: impl IntoIterator<Item = T>,
    work: impl Fn(T) -> R + Sync,
) -> Vec<R> {
    let items: Vec<Mutex<Option<T>>> = items.into_iter().map(|i| Mutex::new(Some(i))).collect();
    let done: Vec<OnceLock<R>> = items.iter().map(|_| OnceLock::new()).collect();
    let next = AtomicUsize::new(0);
    let take = || {
        loop {
            let at = next.fetch_add(1, Ordering::Relaxed);
            let Some(item) = items.get(at) else {
                return;
            };
            // Each is taken once.
            if let Some(item) = item.lock().unwrap_or_else(PoisonError::into_inner).take() {
                let _ = done[at].set(work(item));
            }
        }
    };
    std::thread::scope(|scope| {
        for _ in 1..threads().min(items.len()) {
            scope.spawn(take);
        }
        take();
    });
    done.into_iter().filter_map(OnceLock::into_inner).collect()
}
