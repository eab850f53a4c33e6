//! What a power is a power of: that `R^2 + 2 R r + r^2` does not vanish says that `R + r` does not.

use crate::algebra::{Monomial, Polynomial, Rational};

/// Longer polynomials are left as they are.
const MOST_TERMS: usize = 60;

/// The polynomial with leading coefficient 1 of which this is a power, up to a number; itself where it is none.
pub fn base_of_power(polynomial: &Polynomial) -> Polynomial {
    let own = polynomial.monic();
    let degree = own.degree();
    if own.len() < 2 || own.len() > MOST_TERMS {
        return polynomial.clone();
    }
    let exponents = (2..=degree).rev().filter(|k| degree.is_multiple_of(*k));
    let mut roots = exponents.filter_map(|exponent| root(&own, exponent));
    roots.next().unwrap_or_else(|| polynomial.clone())
}

/// The root of a polynomial with leading coefficient 1, term by term from the greatest: what is missing from its power says what comes next.
fn root(polynomial: &Polynomial, exponent: u32) -> Option<Polynomial> {
    let lead = root_of(polynomial.leading()?.0, exponent)?;
    let above = (1..exponent).fold(Monomial::one(), |power, _| power.times(&lead));
    let share = Rational::from(exponent).recip();
    let mut root = Polynomial::term(lead, Rational::one());
    for _ in 0..polynomial.len() {
        let rest = polynomial.minus(&root.pow(exponent).ok()?);
        let Some((monomial, coefficient)) = rest.leading() else {
            return Some(root);
        };
        let next = monomial.divided_by(&above)?;
        // Terms come in order; else there is no end to them.
        if root.terms().next().is_some_and(|(last, _)| *last <= next) {
            return None;
        }
        root = root.plus(&Polynomial::term(next, coefficient * &share));
    }
    None
}

fn root_of(monomial: &Monomial, exponent: u32) -> Option<Monomial> {
    let mut powers = monomial.powers().iter();
    powers.try_fold(Monomial::one(), |root, &(var, power)| {
        let part = power.is_multiple_of(exponent).then_some(power / exponent)?;
        Some(root.times(&Monomial::power(var, part)))
    })
}
