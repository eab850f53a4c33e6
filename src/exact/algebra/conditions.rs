//! Conditions: denominators, bases of roots and of powers, limits.

use std::ops::{Deref, DerefMut};

use super::{Expr, Polynomial};
use crate::sorted::Set;

/// What must be so for a term to have the value that it is given. Most terms have one whatever their symbols stand for: then nothing is
/// kept.
#[derive(Clone, Debug, Default)]
pub struct Conditions(Option<Box<Needed>>);

/// What must be so, of each kind.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Needed {
    /// Denominators: they must not vanish.
    pub nonzero: Set<Polynomial>,
    /// Derivatives of what was held constant: they must vanish, and not at one point only.
    pub zero: Set<Polynomial>,
    /// What an even root is taken of: it must not be negative.
    pub nonnegative: Set<Polynomial>,
    /// What a logarithm or a symbolic power is taken of: it must be positive.
    pub positive: Set<Polynomial>,
    /// What a power with a whole exponent that may be negative is taken of: it must not vanish. Where such a power is
    /// asserted it may all the same, for the exponent need not be negative.
    pub bases: Set<Polynomial>,
    /// What a limit has another value for where it vanishes, or none: it must not, but that there is a limit does not say so.
    pub away: Set<Polynomial>,
    /// Terms of which it is not known whether they have a value: a limit that may not exist.
    pub doubtful: Set<Expr>,
}

static NOTHING: Needed = Needed {
    nonzero: Set::new(),
    zero: Set::new(),
    nonnegative: Set::new(),
    positive: Set::new(),
    bases: Set::new(),
    away: Set::new(),
    doubtful: Set::new(),
};

impl Deref for Conditions {
    type Target = Needed;
    #[inline]
    fn deref(&self) -> &Needed {
        self.0.as_deref().unwrap_or(&NOTHING)
    }
}

impl DerefMut for Conditions {
    #[inline]
    fn deref_mut(&mut self) -> &mut Needed {
        self.0.get_or_insert_default()
    }
}

impl PartialEq for Conditions {
    fn eq(&self, other: &Self) -> bool {
        **self == **other
    }
}

impl Eq for Conditions {}

impl Conditions {
    pub(super) fn extend(&mut self, other: Conditions) {
        let Some(other) = other.0 else {
            return;
        };
        self.nonzero.extend(other.nonzero);
        self.zero.extend(other.zero);
        self.nonnegative.extend(other.nonnegative);
        self.positive.extend(other.positive);
        self.bases.extend(other.bases);
        self.away.extend(other.away);
        self.doubtful.extend(other.doubtful);
    }

    /// The same of other polynomials.
    pub(super) fn map(self, mut change: impl FnMut(&Polynomial) -> Polynomial) -> Conditions {
        let mut all = |own: Set<Polynomial>| own.iter().map(&mut change).collect();
        let changed = self.0.map(|own| {
            Box::new(Needed {
                nonzero: all(own.nonzero),
                zero: all(own.zero),
                nonnegative: all(own.nonnegative),
                positive: all(own.positive),
                bases: all(own.bases),
                away: all(own.away),
                doubtful: own.doubtful,
            })
        });
        Conditions(changed)
    }
}

impl Needed {
    /// What must not vanish.
    pub fn divisors(&self) -> impl Iterator<Item = &Polynomial> {
        self.nonzero.iter().chain(&self.bases).chain(&self.away)
    }

    /// Every polynomial that some condition is about.
    pub(super) fn polynomials(&self) -> impl Iterator<Item = &Polynomial> {
        let signs = self.nonnegative.iter().chain(&self.positive);
        self.divisors().chain(&self.zero).chain(signs)
    }
}
