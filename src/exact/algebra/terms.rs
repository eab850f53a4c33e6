//! The terms of a polynomial.

use std::cmp::Ordering;
use std::hash::{Hash, Hasher};
use std::ops::Deref;
use std::sync::Arc;

use smallvec::SmallVec;

use super::{Monomial, Rational};

/// A product of powers with its coefficient.
pub type Term = (Monomial, Rational);
/// Terms as they are put together: where it comes to one, no place is asked for.
pub type Made = SmallVec<[Term; 1]>;

/// Most polynomials are a single term, which needs no place of its own. What others consist of is shared: they are copied more often than
/// they are made.
#[derive(Clone, Debug, Default)]
pub enum Terms {
    #[default]
    None,
    One(Term),
    Several(Arc<[Term]>),
}

impl Deref for Terms {
    type Target = [Term];
    #[inline]
    fn deref(&self) -> &[Term] {
        match self {
            Terms::None => &[],
            Terms::One(term) => std::slice::from_ref(term),
            Terms::Several(terms) => terms,
        }
    }
}

impl From<Vec<Term>> for Terms {
    fn from(mut terms: Vec<Term>) -> Self {
        match terms.len() {
            0 | 1 => terms.pop().map_or(Terms::None, Terms::One),
            _ => Terms::Several(terms.into()),
        }
    }
}

impl From<Made> for Terms {
    fn from(mut terms: Made) -> Self {
        match terms.spilled() {
            false => terms.pop().map_or(Terms::None, Terms::One),
            true => terms.into_vec().into(),
        }
    }
}

impl PartialEq for Terms {
    #[inline]
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Terms::Several(own), Terms::Several(other)) => Arc::ptr_eq(own, other) || own == other,
            _ => **self == **other,
        }
    }
}

impl Eq for Terms {}

impl PartialOrd for Terms {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Terms {
    fn cmp(&self, other: &Self) -> Ordering {
        (**self).cmp(&**other)
    }
}

impl Hash for Terms {
    fn hash<H: Hasher>(&self, state: &mut H) {
        (**self).hash(state);
    }
}
