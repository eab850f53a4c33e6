use super::{Expr, Rational};
use crate::sorted::Map;

/// The seven bases of the SI, in the order in which dimensions are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Base {
    /// M
    Mass,
    /// L
    Length,
    /// T
    Time,
    /// I
    Current,
    /// Θ
    Temperature,
    /// N
    Amount,
    /// J
    Luminosity,
}

impl Base {
    /// All of them.
    pub const ALL: [Base; 7] = [
        Base::Mass,
        Base::Length,
        Base::Time,
        Base::Current,
        Base::Temperature,
        Base::Amount,
        Base::Luminosity,
    ];
}

/// A product of powers of the bases.
///
/// Exponents are rational, or rational multiples of an opaque term: the dimension of `V^\gamma`, with `V` a volume,
/// is Length to the power 3γ. Canonical: no exponent is 0, so equality is equality of dimensions.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Dimension(Map<(Base, Option<Expr>), Rational>);

impl Dimension {
    /// That of pure numbers.
    pub fn none() -> Self {
        Dimension::default()
    }

    /// That of one base.
    pub fn base(base: Base) -> Self {
        Dimension(Map::from([((base, None), Rational::one())]))
    }

    /// From integer exponents of the bases.
    pub fn of(exponents: &[(Base, i32)]) -> Self {
        let mut dimension = Dimension::none();
        for &(base, exponent) in exponents {
            dimension.multiply(&Dimension::base(base), &Rational::from(exponent));
        }
        dimension
    }

    /// Whether it is that of pure numbers.
    pub fn is_none(&self) -> bool {
        self.0.is_empty()
    }

    /// Multiplies by a power of another.
    pub fn multiply(&mut self, other: &Dimension, power: &Rational) {
        for (coordinate, exponent) in &other.0 {
            let own = self.0.entry(coordinate.clone());
            let own = own.or_insert_with(Rational::zero);
            *own += exponent * power;
            if own.is_zero() {
                self.0.remove(coordinate);
            }
        }
    }

    /// `self / other`.
    pub fn over(&self, other: &Dimension) -> Dimension {
        let mut quotient = self.clone();
        quotient.multiply(other, &-Rational::one());
        quotient
    }

    /// A power.
    pub fn power(&self, exponent: &Rational) -> Dimension {
        let mut power = Dimension::none();
        power.multiply(self, exponent);
        power
    }

    /// The power with an opaque exponent; nothing where an exponent is opaque already.
    pub fn opaque_power(&self, exponent: &Expr) -> Option<Dimension> {
        let coordinates = self.0.iter().map(|((base, opaque), value)| match opaque {
            None => Some(((*base, Some(exponent.clone())), value.clone())),
            Some(_) => None,
        });
        coordinates.collect::<Option<_>>().map(Dimension)
    }

    /// The exponent of a base, where it has no opaque part.
    pub fn exponent(&self, base: Base) -> Option<Rational> {
        let opaque =
            |((own, opaque), _): (&(Base, Option<Expr>), _)| *own == base && opaque.is_some();
        if self.0.iter().any(opaque) {
            return None;
        }
        Some(
            self.0
                .get(&(base, None))
                .cloned()
                .unwrap_or_else(Rational::zero),
        )
    }

    /// The exponents of a base: rational multiples of 1 (`None`) and of opaque terms.
    pub fn exponents(&self, base: Base) -> impl Iterator<Item = (Option<&Expr>, &Rational)> {
        let own = self.0.iter().filter(move |((own, _), _)| *own == base);
        own.map(|((_, opaque), value)| (opaque.as_ref(), value))
    }
}
