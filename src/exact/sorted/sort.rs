//! Sorting by one function for all kinds of things.
//!
//! The standard library's sort is compiled anew for each type that is sorted, and is longer than most of what calls it. Here
//! numbers are sorted, and the things exchanged as these say.

use std::cmp::Ordering;

/// So many things are put in their places one by one.
const FEW: usize = 24;

/// Sorts by a comparison; what is equal stays in its order.
pub fn sort_by<T>(items: &mut [T], mut compare: impl FnMut(&T, &T) -> Ordering) {
    if items.len() > FEW {
        let order = order(items.len(), &mut |a, b| compare(&items[a], &items[b]));
        for (a, b) in exchanges(order) {
            items.swap(a, b);
        }
        return;
    }
    for end in 1..items.len() {
        let mut at = end;
        while at > 0 && compare(&items[at - 1], &items[at]).is_gt() {
            items.swap(at - 1, at);
            at -= 1;
        }
    }
}

/// Sorts by a part of each thing, or by something worked out from it; what is equal stays in its order.
pub fn sort_by_key<T, K: Ord>(items: &mut [T], key: impl Fn(&T) -> K) {
    sort_by(items, |a, b| key(a).cmp(&key(b)));
}

/// Sorts; what is equal stays in its order.
pub fn sort<T: Ord>(items: &mut [T]) {
    sort_by(items, T::cmp);
}

/// The numbers below `len` in the order of what they stand for.
fn order(len: usize, compare: &mut dyn FnMut(usize, usize) -> Ordering) -> Vec<usize> {
    let mut order: Vec<usize> = (0..len).collect();
    order.sort_by(|&a, &b| compare(a, b));
    order
}

/// The exchanges that bring everything to its place: to each place what `order` says is now at another.
fn exchanges(mut order: Vec<usize>) -> Vec<(usize, usize)> {
    let mut exchanges = Vec::new();
    for start in 0..order.len() {
        let mut at = start;
        // What was at the start goes along the cycle until it is at its place.
        while order[at] != start {
            let from = std::mem::replace(&mut order[at], at);
            exchanges.push((at, from));
            at = from;
        }
        order[at] = at;
    }
    exchanges
}
