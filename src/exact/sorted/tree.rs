//! A map for what grows with the document.

use std::borrow::Borrow;
use std::collections::BTreeMap;
use std::collections::btree_map;
use std::fmt;
use std::iter;
use std::ops::Index;

/// A map, its entries in the order of their keys, in which insertions stay cheap however many entries there are.
///
/// A tree is long to compile, and is compiled anew for each type of its keys and values. This one's leads to the places of the
/// values, so that it is compiled once for each type of keys.
#[derive(Clone)]
pub struct Tree<K, V> {
    places: BTreeMap<K, usize>,
    values: Vec<V>,
}

/// The place of a key in a [`Tree`].
pub struct Place<'a, K, V> {
    place: btree_map::Entry<'a, K, usize>,
    values: &'a mut Vec<V>,
}

impl<K, V> Tree<K, V> {
    /// Without entries.
    pub const fn new() -> Self {
        Tree {
            places: BTreeMap::new(),
            values: Vec::new(),
        }
    }

    /// How many entries there are.
    pub fn len(&self) -> usize {
        self.values.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.values.is_empty()
    }

    /// All entries in the order of their keys.
    pub fn iter(&self) -> impl DoubleEndedIterator<Item = (&K, &V)> {
        let at = |(key, place): (_, &usize)| (key, &self.values[*place]);
        self.places.iter().map(at)
    }

    /// All keys in order.
    pub fn keys(&self) -> impl DoubleEndedIterator<Item = &K> {
        self.places.keys()
    }

    /// All values, in the order of their keys.
    pub fn values(&self) -> impl DoubleEndedIterator<Item = &V> {
        self.places.values().map(|place| &self.values[*place])
    }

    /// All entries in the order of their keys, taken out.
    pub fn into_entries(self) -> impl Iterator<Item = (K, V)> {
        let mut values: Vec<Option<V>> = self.values.into_iter().map(Some).collect();
        let taken = move |(key, place): (K, usize)| Some((key, values[place].take()?));
        self.places.into_iter().filter_map(taken)
    }

    /// All values in the order of their keys, without these.
    pub fn into_values(self) -> impl Iterator<Item = V> {
        self.into_entries().map(|(_, value)| value)
    }

    /// Takes all entries out.
    pub fn clear(&mut self) {
        self.places.clear();
        self.values.clear();
    }

    /// All values to be changed, in no particular order.
    pub fn values_mut(&mut self) -> impl Iterator<Item = &mut V> {
        self.values.iter_mut()
    }
}

impl<K: Ord, V> Tree<K, V> {
    /// Whether there is a value for a key.
    pub fn contains_key<Q: Ord + ?Sized>(&self, key: &Q) -> bool
    where
        K: Borrow<Q>,
    {
        self.places.contains_key(key)
    }

    /// The value for a key.
    pub fn get<Q: Ord + ?Sized>(&self, key: &Q) -> Option<&V>
    where
        K: Borrow<Q>,
    {
        self.places.get(key).map(|place| &self.values[*place])
    }

    /// The same, to be changed.
    pub fn get_mut<Q: Ord + ?Sized>(&mut self, key: &Q) -> Option<&mut V>
    where
        K: Borrow<Q>,
    {
        let place = self.places.get(key)?;
        self.values.get_mut(*place)
    }

    /// The key that is equal to something, and its value.
    pub fn get_key_value<Q: Ord + ?Sized>(&self, key: &Q) -> Option<(&K, &V)>
    where
        K: Borrow<Q>,
    {
        let (key, place) = self.places.get_key_value(key)?;
        Some((key, &self.values[*place]))
    }

    /// Gives a key a value; the value that it had.
    pub fn insert(&mut self, key: K, value: V) -> Option<V> {
        match self.places.entry(key) {
            btree_map::Entry::Occupied(place) => {
                Some(std::mem::replace(&mut self.values[*place.get()], value))
            }
            btree_map::Entry::Vacant(place) => {
                place.insert(self.values.len());
                self.values.push(value);
                None
            }
        }
    }

    /// The place of a key, to be looked at or filled.
    pub fn entry(&mut self, key: K) -> Place<'_, K, V> {
        Place {
            place: self.places.entry(key),
            values: &mut self.values,
        }
    }
}

impl<'a, K: Ord, V> Place<'a, K, V> {
    /// The value there, put there first where there is none.
    pub fn or_insert_with(self, value: impl FnOnce() -> V) -> &'a mut V {
        let place = match self.place {
            btree_map::Entry::Occupied(place) => *place.get(),
            btree_map::Entry::Vacant(place) => {
                self.values.push(value());
                *place.insert(self.values.len() - 1)
            }
        };
        &mut self.values[place]
    }

    /// The same with a value at hand.
    pub fn or_insert(self, value: V) -> &'a mut V {
        self.or_insert_with(|| value)
    }

    /// The same with the value of the type.
    pub fn or_default(self) -> &'a mut V
    where
        V: Default,
    {
        self.or_insert_with(V::default)
    }

    /// Changes the value where there is one.
    pub fn and_modify(self, change: impl FnOnce(&mut V)) -> Self {
        if let btree_map::Entry::Occupied(place) = &self.place {
            change(&mut self.values[*place.get()]);
        }
        self
    }
}

impl<K, V> Default for Tree<K, V> {
    fn default() -> Self {
        Tree::new()
    }
}

impl<K: fmt::Debug, V: fmt::Debug> fmt::Debug for Tree<K, V> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_map().entries(self.iter()).finish()
    }
}

impl<K: PartialEq, V: PartialEq> PartialEq for Tree<K, V> {
    fn eq(&self, other: &Self) -> bool {
        self.len() == other.len() && iter::zip(self.iter(), other.iter()).all(|(a, b)| a == b)
    }
}

impl<K: Eq, V: Eq> Eq for Tree<K, V> {}

impl<K: Ord + Borrow<Q>, Q: Ord + ?Sized, V> Index<&Q> for Tree<K, V> {
    type Output = V;

    /// The value for a key.
    ///
    /// # Panics
    /// Where there is none.
    fn index(&self, key: &Q) -> &V {
        self.get(key).expect("the key of an entry")
    }
}

impl<K: Ord, V> Extend<(K, V)> for Tree<K, V> {
    fn extend<I: IntoIterator<Item = (K, V)>>(&mut self, entries: I) {
        for (key, value) in entries {
            self.insert(key, value);
        }
    }
}

impl<K: Ord, V> FromIterator<(K, V)> for Tree<K, V> {
    fn from_iter<I: IntoIterator<Item = (K, V)>>(entries: I) -> Self {
        let mut tree = Tree::new();
        tree.extend(entries);
        tree
    }
}
