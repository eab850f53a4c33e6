//! Sorted vectors, and trees of places, do what the trees of the standard library do.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Bound;

use cradle_verify::sorted::{self, Map, Set, Tree};
use proptest::collection::vec;
use proptest::prelude::*;

/// Entries with keys that often come again, and that come in any order.
fn entries() -> impl Strategy<Value = Vec<(u8, u16)>> {
    vec((0u8..60, any::<u16>()), 0..90)
}

fn bound() -> impl Strategy<Value = Bound<u8>> {
    prop_oneof![
        Just(Bound::Unbounded),
        (0u8..60).prop_map(Bound::Included),
        (0u8..60).prop_map(Bound::Excluded),
    ]
}

/// A tree panics where a range ends before it begins; here it is empty.
fn is_a_range(start: &Bound<u8>, end: &Bound<u8>) -> bool {
    match (start, end) {
        (Bound::Unbounded, _) | (_, Bound::Unbounded) => true,
        (Bound::Excluded(a), Bound::Excluded(b)) => a < b,
        (Bound::Included(a) | Bound::Excluded(a), Bound::Included(b) | Bound::Excluded(b)) => {
            a <= b
        }
    }
}

proptest! {
    #[test]
    fn maps_are_collected_as_trees_are(entries in entries()) {
        let (map, tree): (Map<_, _>, BTreeMap<_, _>) =
            (entries.iter().copied().collect(), entries.iter().copied().collect());
        prop_assert!(map.iter().eq(&tree));
        prop_assert!(map.keys().eq(tree.keys()) && map.values().eq(tree.values()));
        prop_assert_eq!(map.first_key_value(), tree.first_key_value());
        prop_assert_eq!(map.last_key_value(), tree.last_key_value());
        prop_assert_eq!(format!("{map:?}"), format!("{tree:?}"));
        prop_assert!(map.clone().into_values().eq(tree.clone().into_values()));
        prop_assert!(map.into_keys().eq(tree.into_keys()));
    }

    #[test]
    fn maps_change_as_trees_do(entries in entries(), more in entries(), gone in vec(0u8..60, 0..40)) {
        let (mut map, mut tree): (Map<_, _>, BTreeMap<_, _>) = (Map::new(), BTreeMap::new());
        for (key, value) in entries {
            prop_assert_eq!(map.insert(key, value), tree.insert(key, value));
        }
        for &key in &gone {
            prop_assert_eq!(map.remove(&key), tree.remove(&key));
        }
        for (key, value) in more.iter().copied() {
            let own = *map.entry(key).or_insert(value);
            prop_assert_eq!(own, *tree.entry(key).or_insert(value));
            prop_assert_eq!(map.get(&key), tree.get(&key));
            prop_assert_eq!(map.contains_key(&value.to_le_bytes()[0]), tree.contains_key(&value.to_le_bytes()[0]));
        }
        map.extend(more.iter().copied());
        tree.extend(more.iter().copied());
        map.values_mut().for_each(|value| *value /= 2);
        tree.values_mut().for_each(|value| *value /= 2);
        map.retain(|key, value| (u16::from(*key) + *value) % 3 > 0);
        tree.retain(|key, value| (u16::from(*key) + *value) % 3 > 0);
        prop_assert_eq!(map.pop_first(), tree.pop_first());
        prop_assert!(map.into_iter().eq(tree));
    }

    #[test]
    fn maps_are_compared_as_trees_are(a in entries(), b in entries()) {
        let (one, other): (Map<_, _>, Map<_, _>) = (a.iter().copied().collect(), b.iter().copied().collect());
        let (first, second): (BTreeMap<_, _>, BTreeMap<_, _>) = (a.into_iter().collect(), b.into_iter().collect());
        prop_assert_eq!(one.cmp(&other), first.cmp(&second));
        prop_assert_eq!(one == other, first == second);
    }

    #[test]
    fn sets_do_as_trees_do(a in vec(0u8..60, 0..90), b in vec(0u8..60, 0..90), gone in vec(0u8..60, 0..40)) {
        let (mut set, mut tree): (Set<_>, BTreeSet<_>) = (a.iter().copied().collect(), a.iter().copied().collect());
        let (other, second): (Set<_>, BTreeSet<_>) = (b.iter().copied().collect(), b.iter().copied().collect());
        prop_assert!(set.iter().eq(&tree));
        prop_assert!(set.union(&other).eq(tree.union(&second)));
        prop_assert!(set.difference(&other).eq(tree.difference(&second)));
        prop_assert_eq!(set.is_disjoint(&other), tree.is_disjoint(&second));
        for element in &gone {
            prop_assert_eq!(set.contains(element), tree.contains(element));
            prop_assert_eq!(set.remove(element), tree.remove(element));
        }
        for element in b {
            prop_assert_eq!(set.insert(element), tree.insert(element));
        }
        prop_assert_eq!((set.first(), set.last(), set.len()), (tree.first(), tree.last(), tree.len()));
        prop_assert_eq!(set.pop_first(), tree.pop_first());
        set.retain(|element| element % 3 > 0);
        tree.retain(|element| element % 3 > 0);
        prop_assert!(set.into_iter().eq(tree));
    }

    #[test]
    fn ranges_are_those_of_trees(entries in entries(), start in bound(), end in bound()) {
        let (map, set): (Map<_, _>, Set<u8>) = (entries.iter().copied().collect(), entries.iter().map(|e| e.0).collect());
        let tree: BTreeMap<_, _> = entries.into_iter().collect();
        let (own, keys) = (map.range((start, end)), set.range((start, end)));
        match is_a_range(&start, &end) {
            true => {
                prop_assert!(own.eq(tree.range((start, end))));
                prop_assert!(keys.eq(tree.range((start, end)).map(|e| e.0)));
            }
            false => prop_assert!(own.len() == 0 && keys.len() == 0),
        }
    }

    #[test]
    fn what_grows_does_as_trees_do(entries in entries(), more in entries()) {
        let (mut own, mut tree): (Tree<_, _>, BTreeMap<_, _>) = (Tree::new(), BTreeMap::new());
        for (key, value) in entries {
            prop_assert_eq!(own.insert(key, value), tree.insert(key, value));
        }
        for (key, value) in more.iter().copied() {
            own.entry(key).and_modify(|value| *value /= 3).or_insert(value);
            tree.entry(key).and_modify(|value| *value /= 3).or_insert(value);
            prop_assert_eq!(own.get_key_value(&key), tree.get_key_value(&key));
            prop_assert_eq!(own.get_mut(&(key + 1)), tree.get_mut(&(key + 1)));
            prop_assert_eq!(own.contains_key(&(key + 1)), tree.contains_key(&(key + 1)));
        }
        prop_assert!(own.iter().eq(&tree));
        prop_assert!(own.keys().eq(tree.keys()) && own.values().eq(tree.values()));
        prop_assert_eq!((own.len(), own.is_empty()), (tree.len(), tree.is_empty()));
        prop_assert_eq!(format!("{own:?}"), format!("{tree:?}"));
        let again: Tree<_, _> = tree.iter().rev().map(|(key, value)| (*key, *value)).collect();
        prop_assert_eq!(&own, &again);
        prop_assert!(own.into_entries().eq(tree));
    }

    #[test]
    fn sorting_does_as_the_library_does(mut items in vec((0u8..20, any::<u8>()), 0..90)) {
        let (mut by_key, mut by_comparison, mut all) = (items.clone(), items.clone(), items.clone());
        sorted::sort_by_key(&mut by_key, |item| item.0);
        sorted::sort_by(&mut by_comparison, |a, b| b.0.cmp(&a.0));
        sorted::sort(&mut all);
        items.sort_by_key(|item| item.0);
        prop_assert_eq!(&by_key, &items);
        items.sort();
        prop_assert_eq!(all, items);
        by_key.sort_by_key(|item| std::cmp::Reverse(item.0));
        prop_assert_eq!(by_comparison, by_key);
    }
}
