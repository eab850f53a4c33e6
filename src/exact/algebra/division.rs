//! Division of polynomials in several unknowns, where it leaves no remainder.
//!
//! Quotient and remainder come out term by term, from the greatest down. What is taken off at each term is not subtracted from all that is
//! left: the products of divisor and quotient wait in a heap until it is their turn (S. C. Johnson, "Sparse polynomial arithmetic", 1974).
//!
//! Most divisions fail, and what is long fails late. So it is divided first in one unknown, with numbers for all others, modulo a prime:
//! what divides divides there too.

use std::collections::BinaryHeap;

use super::effort::{is_spent, spend};
use super::residue::{PRIME, inverse, power, times};
use super::terms::{Made, Term};
use super::{Monomial, Polynomial, Rational, Var};

/// What is shorter is divided as soon as it is looked at.
const LEAST_TERMS: usize = 12;
/// In an unknown of which there are higher powers nothing is tried.
const HIGHEST_POWER: u32 = 64;

/// `dividend / divisor` of several terms, greatest term first; `None` where there is a remainder, or where all work allowed is done before.
pub(super) fn exact_quotient(dividend: &Polynomial, divisor: &Polynomial) -> Option<Made> {
    let (lead, coefficient) = divisor.leading()?;
    if dividend.len() >= LEAST_TERMS && !may_divide(divisor, dividend) {
        return None;
    }
    // From the greatest down, without the first.
    let below: Vec<(&Monomial, &Rational)> = divisor.terms().rev().skip(1).collect();
    let mut own = dividend.terms().rev().peekable();
    let mut quotient = Made::new();
    // Each product with the place of its factor in the divisor and in the quotient.
    let mut waiting: BinaryHeap<(Monomial, usize, usize)> = BinaryHeap::new();
    loop {
        let next = match (own.peek(), waiting.peek()) {
            (None, None) => return Some(quotient),
            (Some((m, _)), None) => (*m).clone(),
            (None, Some((m, ..))) => m.clone(),
            (Some((m, _)), Some((n, ..))) => (*m).max(n).clone(),
        };
        let mut left = match own.next_if(|(m, _)| **m == next) {
            Some((_, c)) => c.clone(),
            None => Rational::zero(),
        };
        while let Some((_, i, j)) = waiting.peek().filter(|own| own.0 == next).cloned() {
            waiting.pop();
            spend(1);
            let (monomial, factor): &Term = &quotient[j];
            left -= &(below[i].1 * factor);
            if let Some((n, _)) = below.get(i + 1) {
                waiting.push((n.times(monomial), i + 1, j));
            }
        }
        if is_spent() {
            return None;
        }
        if left.is_zero() {
            continue;
        }
        let monomial = next.divided_by(lead)?;
        if let Some((n, _)) = below.first() {
            waiting.push((n.times(&monomial), 0, quotient.len()));
        }
        quotient.push((monomial, &left / coefficient));
    }
}

/// Whether one polynomial can divide another: what cannot divide modulo a prime, with numbers for all unknowns but one, cannot.
///
/// The divisor's leading coefficient is a unit there, so that a quotient has a residue, too.
fn may_divide(divisor: &Polynomial, dividend: &Polynomial) -> bool {
    let is_unit = |(_, c): (&Monomial, &Rational)| c.residue().is_some_and(|c| c != 0);
    if !divisor.leading().is_some_and(is_unit) {
        return true;
    }
    let vars = divisor.vars().into_iter();
    let Some(var) = vars.min_by_key(|&var| divisor.degree_in(var)) else {
        return true;
    };
    if dividend.degree_in(var).max(divisor.degree_in(var)) > HIGHEST_POWER {
        return true;
    }
    spend(dividend.len());
    let (Some(mut rest), Some(mut below)) = (image(dividend, var), image(divisor, var)) else {
        return true;
    };
    while below.last() == Some(&0) {
        below.pop();
    }
    let Some((lead, others)) = below.split_last() else {
        return true;
    };
    let inverse = inverse(*lead);
    while rest.len() > others.len() {
        let taken = times(rest.pop().unwrap_or(0), inverse);
        let start = rest.len() - others.len();
        for (slot, own) in rest[start..].iter_mut().zip(others) {
            *slot = (*slot + times(PRIME - taken, *own)) % PRIME;
        }
    }
    rest.iter().all(|own| *own == 0)
}

/// The residues of the coefficients of the powers of one unknown, with numbers for all others; `None` where a coefficient has none.
fn image(polynomial: &Polynomial, var: Var) -> Option<Vec<u64>> {
    let mut found = vec![0; polynomial.degree_in(var) as usize + 1];
    for (monomial, coefficient) in polynomial.terms() {
        let mut value = coefficient.residue()?;
        let mut place = 0;
        for &(own, exponent) in monomial.powers() {
            if own == var {
                place = exponent as usize;
            } else {
                value = times(value, power(number(own), exponent.into()));
            }
        }
        found[place] = (found[place] + value) % PRIME;
    }
    Some(found)
}

/// A number for an unknown: any would do, and these are not in a simple relation.
fn number(var: Var) -> u64 {
    let mixed = (var.position() as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    (mixed >> 34) % (PRIME - 1) + 1
}
