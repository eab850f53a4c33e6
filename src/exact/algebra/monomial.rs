use std::cmp::Ordering;
use std::fmt;
use std::hash::{Hash, Hasher};

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
#[derive(Clone, Debug, PartialEq, Eq, Hash, Default)]
pub struct Monomial {
    degree: u32,
    /// Sorted by unknown; no exponent is zero.
    powers: Powers,
}

type Power = (Var, u32);

/// Few products have more than so many unknowns.
const FEW: usize = 4;

/// A list of powers; those that are not few go to the heap.
///
/// Nothing else is done as often as copying, comparing and dropping these: where they are few that takes no call.
enum Powers {
    Few(u8, [Power; FEW]),
    Many(Vec<Power>),
}

impl Clone for Powers {
    #[inline]
    fn clone(&self) -> Self {
        match self {
            Powers::Few(length, powers) => Powers::Few(*length, *powers),
            Powers::Many(powers) => Powers::copied(powers),
        }
    }
}

impl Powers {
    #[cold]
    fn copied(powers: &[Power]) -> Self {
        Powers::Many(powers.to_vec())
    }

    #[inline]
    fn as_slice(&self) -> &[Power] {
        match self {
            Powers::Few(length, powers) => &powers[..usize::from(*length)],
            Powers::Many(powers) => powers,
        }
    }

    #[inline]
    fn push(&mut self, power: Power) {
        if let Powers::Few(length, powers) = self
            && let Some(slot) = powers.get_mut(usize::from(*length))
        {
            *slot = power;
            *length += 1;
        } else {
            self.push_to_heap(power);
        }
    }

    #[cold]
    fn push_to_heap(&mut self, power: Power) {
        match self {
            Powers::Few(_, powers) => *self = Powers::Many([&powers[..], &[power]].concat()),
            Powers::Many(powers) => powers.push(power),
        }
    }
}

impl Default for Powers {
    #[inline]
    fn default() -> Self {
        Powers::Few(0, [(Var(0), 0); FEW])
    }
}

impl PartialEq for Powers {
    #[inline]
    fn eq(&self, other: &Self) -> bool {
        self.as_slice() == other.as_slice()
    }
}

impl Eq for Powers {}

impl Hash for Powers {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.as_slice().hash(state);
    }
}

impl fmt::Debug for Powers {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.as_slice().fmt(f)
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
        let mut power = Monomial::one();
        power.push(var, exponent);
        power
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
        self.powers.as_slice()
    }

    /// The exponent of one unknown.
    #[inline]
    pub fn exponent(&self, var: Var) -> u32 {
        let own = self.powers().iter().find(|p| p.0 >= var);
        own.map_or(0, |p| if p.0 == var { p.1 } else { 0 })
    }

    /// Multiplies by a power of an unknown that comes after all that are in it.
    #[inline]
    fn push(&mut self, var: Var, exponent: u32) {
        if exponent > 0 {
            self.degree += exponent;
            self.powers.push((var, exponent));
        }
    }

    /// Merges the two exponent lists; `join` says what becomes of the two exponents of one unknown.
    fn merge(&self, other: &Self, join: impl Fn(u32, u32) -> u32) -> Self {
        let (mut a, mut b) = (self.powers(), other.powers());
        let mut out = Monomial::one();
        while let ([x, after_x @ ..], [y, after_y @ ..]) = (a, b) {
            match x.0.cmp(&y.0) {
                Ordering::Less => {
                    out.push(x.0, join(x.1, 0));
                    a = after_x;
                }
                Ordering::Greater => {
                    out.push(y.0, join(0, y.1));
                    b = after_y;
                }
                Ordering::Equal => {
                    out.push(x.0, join(x.1, y.1));
                    (a, b) = (after_x, after_y);
                }
            }
        }
        a.iter().for_each(|&(v, e)| out.push(v, join(e, 0)));
        b.iter().for_each(|&(v, e)| out.push(v, join(0, e)));
        out
    }

    /// The product.
    pub fn times(&self, other: &Self) -> Self {
        match (self.is_one(), other.is_one()) {
            (true, _) => other.clone(),
            (_, true) => self.clone(),
            _ => self.merge(other, |a, b| a + b),
        }
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
        if other.is_one() {
            return Some(self.clone());
        }
        other.divides(self).then(|| self.merge(other, |a, b| a - b))
    }

    /// Whether it divides another.
    pub fn divides(&self, other: &Self) -> bool {
        let mut others = other.powers().iter();
        self.powers().iter().all(|&(v, e)| {
            let at_least = others.find(|p| p.0 >= v);
            at_least.is_some_and(|p| p.0 == v && p.1 >= e)
        })
    }

    /// The monomial with one unknown left out.
    pub fn without(&self, var: Var) -> Self {
        let mut rest = Monomial::one();
        let others = self.powers().iter().filter(|power| power.0 != var);
        others.for_each(|&(v, e)| rest.push(v, e));
        rest
    }

    /// The square root, where every exponent is even.
    pub fn sqrt(&self) -> Option<Self> {
        let mut root = Monomial::one();
        for &(v, e) in self.powers() {
            if e % 2 == 1 {
                return None;
            }
            root.push(v, e / 2);
        }
        Some(root)
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
