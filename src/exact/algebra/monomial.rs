use std::cmp::Ordering;

use smallvec::{SmallVec, smallvec};

/// An unknown of a polynomial: the position of its [`Atom`](super::Atom) in an [`Atoms`](super::Atoms) table.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Var(pub(super) u32);

impl Var {
    /// The position in the table.
    pub fn position(self) -> usize {
        self.0 as usize
    }
}

/// A product of powers of unknowns, ordered by total degree and then lexicographically.
#[derive(Debug, PartialEq, Eq, Hash, Default)]
pub struct Monomial {
    degree: u32,
    /// Sorted by unknown; no exponent is zero.
    powers: Powers,
}

/// Few products have more than four unknowns; those that do go to the heap.
type Powers = SmallVec<[(Var, u32); 4]>;

// Copied whole rather than power by power, which is what deriving would do.
impl Clone for Monomial {
    #[inline]
    fn clone(&self) -> Self {
        Monomial {
            degree: self.degree,
            powers: Powers::from_slice(&self.powers),
        }
    }
}

impl Monomial {
    /// The empty product.
    #[inline]
    pub fn one() -> Self {
        Monomial::default()
    }

    /// `var^exponent`.
    pub fn power(var: Var, exponent: u32) -> Self {
        if exponent == 0 {
            return Monomial::one();
        }
        Monomial {
            degree: exponent,
            powers: smallvec![(var, exponent)],
        }
    }

    /// The total degree.
    #[inline]
    pub fn degree(&self) -> u32 {
        self.degree
    }

    /// Whether this is the empty product.
    pub fn is_one(&self) -> bool {
        self.degree == 0
    }

    /// The unknowns with their exponents, in order.
    #[inline]
    pub fn powers(&self) -> &[(Var, u32)] {
        &self.powers
    }

    /// The exponent of one unknown.
    pub fn exponent(&self, var: Var) -> u32 {
        let own = self.powers().iter().find(|p| p.0 >= var);
        own.map_or(0, |p| if p.0 == var { p.1 } else { 0 })
    }

    fn from_powers(powers: Powers) -> Self {
        Monomial {
            degree: powers.iter().map(|p| p.1).sum(),
            powers,
        }
    }

    /// Merges the two exponent lists; `join` says what becomes of the two exponents of one unknown.
    fn merge(&self, other: &Self, join: impl Fn(u32, u32) -> u32) -> Self {
        let (a, b) = (self.powers(), other.powers());
        let mut out = Powers::new();
        let (mut i, mut j) = (0, 0);
        while i < a.len() || j < b.len() {
            let order = match (a.get(i), b.get(j)) {
                (Some(x), Some(y)) => x.0.cmp(&y.0),
                (Some(_), None) => Ordering::Less,
                _ => Ordering::Greater,
            };
            let (var, exponent) = match order {
                Ordering::Less => (a[i].0, join(a[i].1, 0)),
                Ordering::Greater => (b[j].0, join(0, b[j].1)),
                Ordering::Equal => (a[i].0, join(a[i].1, b[j].1)),
            };
            if order.is_le() {
                i += 1;
            }
            if order.is_ge() {
                j += 1;
            }
            if exponent > 0 {
                out.push((var, exponent));
            }
        }
        Monomial::from_powers(out)
    }

    /// The product.
    pub fn times(&self, other: &Self) -> Self {
        self.merge(other, |a, b| a + b)
    }

    /// The least common multiple.
    pub fn lcm(&self, other: &Self) -> Self {
        self.merge(other, u32::max)
    }

    /// The greatest common divisor.
    pub fn gcd(&self, other: &Self) -> Self {
        self.merge(other, u32::min)
    }

    /// `self / other`, where it divides.
    pub fn divided_by(&self, other: &Self) -> Option<Self> {
        let mut own = self.powers().iter();
        let divides = other.powers().iter().all(|&(v, e)| {
            let at_least = own.find(|p| p.0 >= v);
            at_least.is_some_and(|p| p.0 == v && p.1 >= e)
        });
        divides.then(|| self.merge(other, |a, b| a - b))
    }

    /// The monomial with one unknown left out.
    pub fn without(&self, var: Var) -> Self {
        let mut rest = self.clone();
        if let Ok(at) = rest.powers.binary_search_by_key(&var, |p| p.0) {
            rest.degree -= rest.powers.remove(at).1;
        }
        rest
    }

    /// The square root, where every exponent is even.
    pub fn sqrt(&self) -> Option<Self> {
        let even = self.powers.iter().all(|p| p.1 % 2 == 0);
        even.then(|| Monomial::from_powers(self.powers.iter().map(|&(v, e)| (v, e / 2)).collect()))
    }
}

impl Ord for Monomial {
    fn cmp(&self, other: &Self) -> Ordering {
        if self.degree != other.degree {
            return self.degree.cmp(&other.degree);
        }
        // Lexicographic: at the first difference, the monomial with more of the earlier unknown is greater.
        let mut others = other.powers().iter();
        for a in self.powers() {
            match others.next() {
                Some(b) if a == b => {}
                Some(b) if a.0 == b.0 => return a.1.cmp(&b.1),
                Some(b) => return b.0.cmp(&a.0),
                None => return Ordering::Greater,
            }
        }
        match others.next() {
            Some(_) => Ordering::Less,
            None => Ordering::Equal,
        }
    }
}

impl PartialOrd for Monomial {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}
