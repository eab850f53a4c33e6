use crate::algebra::{Dimension, Rational, Symbol};
use crate::sorted::Map;

/// A dimension that nobody has declared, by number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Unknown(pub usize);

/// What is said of the dimension of a symbol.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Said {
    /// It is declared.
    Declared(Dimension),
    /// It is to be found out.
    Unknown(Unknown),
}

/// What is said of the symbols of a formula. Of a symbol that is not listed nothing is said, and with it nothing
/// is compared.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Scope {
    /// The symbols.
    pub symbols: Map<Symbol, Said>,
    /// The sequences, apart from symbols of the same name.
    pub sequences: Map<Symbol, Said>,
}

/// A dimension with unknowns in it: a known one times powers of unknown ones.
///
/// Multiplying dimensions adds exponents, so this is a linear form, and all that is asked of it is linear algebra.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Form {
    /// The known factor.
    pub known: Dimension,
    /// The power of each unknown; none is 0.
    pub unknowns: Map<Unknown, Rational>,
}

impl Form {
    /// What is said, as a form.
    pub fn said(said: &Said) -> Form {
        match said {
            Said::Declared(dimension) => Form::known(dimension.clone()),
            Said::Unknown(unknown) => Form {
                known: Dimension::none(),
                unknowns: Map::from([(*unknown, Rational::one())]),
            },
        }
    }

    /// Without unknowns.
    pub fn known(known: Dimension) -> Form {
        Form {
            known,
            unknowns: Map::new(),
        }
    }

    /// The dimension, where no unknown is left.
    pub fn dimension(&self) -> Option<&Dimension> {
        self.unknowns.is_empty().then_some(&self.known)
    }

    /// Whether it is the dimension of pure numbers.
    pub fn is_none(&self) -> bool {
        self.unknowns.is_empty() && self.known.is_none()
    }

    /// Multiplies by a power of another.
    pub fn multiply(&mut self, other: &Form, power: &Rational) {
        self.known.multiply(&other.known, power);
        for (unknown, exponent) in &other.unknowns {
            let own = self.unknowns.entry(*unknown).or_insert_with(Rational::zero);
            *own += exponent * power;
            if own.is_zero() {
                self.unknowns.remove(unknown);
            }
        }
    }

    /// `self / other`.
    pub fn over(&self, other: &Form) -> Form {
        let mut quotient = self.clone();
        quotient.multiply(other, &-Rational::one());
        quotient
    }

    /// A power.
    pub fn power(&self, exponent: &Rational) -> Form {
        let mut power = Form::default();
        power.multiply(self, exponent);
        power
    }

    /// With what is known of its unknowns put in, once.
    pub fn with(&self, solution: &Map<Unknown, Form>) -> Form {
        let mut solved = Form::known(self.known.clone());
        for (unknown, exponent) in &self.unknowns {
            match solution.get(unknown) {
                Some(value) => solved.multiply(value, exponent),
                None => solved.multiply(&Form::said(&Said::Unknown(*unknown)), exponent),
            }
        }
        solved
    }
}
