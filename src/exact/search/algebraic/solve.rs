//! Roots: real ones isolated, and those that a field has.

use super::polynomial_in;
use crate::algebra::{Rational, Univariate, Var, sum_of_signs};
use crate::kernel::Field;
use crate::search::values::{rational_roots, square_root};
use crate::sorted;

/// Intervals are halved so often at most, all together.
const MOST_HALVINGS: usize = 256;
/// Roots of a higher degree are not adjoined.
pub const HIGHEST_DEGREE: usize = 8;
/// Sizes beyond this many bits are not looked at.
const LONGEST_BOUND: u64 = 64;

/// The polynomials that a root may be a root of: without multiple roots and without rational ones, as far as they are
/// seen, and with `x² − r` taken out where it divides a polynomial in `x²`.
fn pieces(polynomial: &Univariate) -> Vec<Univariate> {
    let common = polynomial.gcd(&polynomial.derivative());
    let Some((mut rest, _)) = polynomial.divided_by(&common) else {
        return Vec::new();
    };
    rest = rest.monic();
    let mut found = Vec::new();
    for root in rational(&rest) {
        let factor = Univariate::new([-root, Rational::one()]);
        rest = rest.divided_by(&factor).map_or(rest, |d| d.0);
    }
    let odd = |p: &Univariate| {
        p.coefficients()
            .iter()
            .skip(1)
            .step_by(2)
            .any(|c| !c.is_zero())
    };
    if rest.degree() > 2 && !odd(&rest) {
        let squares = Univariate::new(rest.coefficients().iter().step_by(2).cloned());
        for square in rational(&squares) {
            let factor = Univariate::new([-square, Rational::zero(), Rational::one()]);
            rest = rest.divided_by(&factor).map_or(rest, |d| d.0);
            found.push(factor);
        }
    }
    found.push(rest);
    found.retain(|p| p.degree() > 1);
    found
}

/// The rational roots, as far as they are quickly found.
pub fn rational(polynomial: &Univariate) -> Vec<Rational> {
    let var = some_unknown();
    rational_roots(&polynomial_in(var, polynomial), var).unwrap_or_default()
}

/// An unknown of a polynomial in nothing else.
fn some_unknown() -> Var {
    crate::algebra::Atoms::default().var(crate::algebra::Atom::Symbol(crate::algebra::Symbol::new(
        "x",
    )))
}

/// The fields of the irrational roots of a polynomial, the simplest first.
pub fn fields(polynomial: &Univariate) -> Vec<Field> {
    if polynomial.degree() > 2 * HIGHEST_DEGREE || polynomial.bits() > 2 * LONGEST_BOUND {
        return Vec::new();
    }
    let pieces = pieces(polynomial).into_iter();
    let mut all: Vec<Field> = pieces
        .filter(|p| p.degree() <= HIGHEST_DEGREE)
        .flat_map(|p| isolated(&p))
        .collect();
    sorted::sort_by_key(&mut all, |field| {
        let (low, high) = field.ends();
        let middle = low + high;
        let degree = field.polynomial().degree();
        (degree, middle.is_negative(), middle.abs())
    });
    all
}

/// Each real root of a polynomial between two numbers, no more than 1 apart and of one sign.
fn isolated(polynomial: &Univariate) -> Vec<Field> {
    let remainders = polynomial.signed_remainders(&polynomial.derivative());
    // Cauchy: no root is greater than 1 + max |c_k| of a monic polynomial.
    let sizes = polynomial.monic();
    let sizes = sizes.coefficients().iter().map(Rational::abs);
    let size = sizes.max().unwrap_or_else(Rational::zero);
    if size.numer().bits() > LONGEST_BOUND {
        return Vec::new();
    }
    let mut bound = Rational::from(2);
    while bound <= &size + &Rational::one() {
        bound = &bound + &bound;
    }
    let half = Rational::ratio(1, 2);
    let mut open = vec![(-&bound, bound)];
    let mut found = Vec::new();
    for _ in 0..MOST_HALVINGS {
        let Some((low, high)) = open.pop() else {
            break;
        };
        let signed = !(low.is_negative() && high.is_positive());
        match sum_of_signs(&remainders, &low, &high) {
            0 => {}
            1 if signed && &high - &low <= Rational::one() => {
                found.extend(Field::new(polynomial.clone(), low, high));
            }
            _ => {
                let mut middle = (&low + &high) * &half;
                while polynomial.at(&middle).is_zero() {
                    middle = (&low + &middle) * &half;
                }
                open.extend([(low, middle.clone()), (middle, high)]);
            }
        }
    }
    found
}

/// The roots in a field of a polynomial with coefficients in it, as far as they are found there; the constant one
/// first.
pub fn roots_in(field: &Field, mut coefficients: Vec<Univariate>) -> Vec<Univariate> {
    while coefficients.last().is_some_and(|c| field.sign(c).is_eq()) {
        coefficients.pop();
    }
    let [rest @ .., lead] = coefficients.as_slice() else {
        return Vec::new();
    };
    let Some(inverse) = lead.inverse_modulo(field.polynomial()) else {
        return Vec::new();
    };
    let monic = |c: &Univariate| field.times(c, &inverse).ok();
    let Some(rest) = rest.iter().map(monic).collect::<Option<Vec<_>>>() else {
        return Vec::new();
    };
    let negated = |value: &Univariate| value.scaled(&-Rational::one());
    let one = Univariate::constant(Rational::one());
    match rest.as_slice() {
        [c] => vec![negated(c)],
        [c, b] => {
            // y = −b/2 ± √(b²/4 − c)
            let half = b.scaled(&Rational::ratio(1, 2));
            let Ok(square) = field.times(&half, &half) else {
                return Vec::new();
            };
            let inside = square.minus(c);
            match root_in(field, &inside) {
                Some(root) => vec![root.minus(&half), negated(&root.plus(&half))],
                None => Vec::new(),
            }
        }
        _ => {
            let numbers = rest.iter().map(Univariate::as_constant);
            let numbers: Option<Vec<Rational>> = numbers.collect();
            let numbers = numbers.map(|all| {
                let whole = all.into_iter().chain([Rational::one()]);
                rational(&Univariate::new(whole))
            });
            let found = numbers.unwrap_or_default().into_iter();
            let mut found: Vec<Univariate> = found.map(Univariate::constant).collect();
            // The same equation once more has the same root.
            let own = Univariate::unknown();
            for candidate in [own.clone(), negated(&own)] {
                let mut whole = rest.iter().chain([&one]).rev();
                let value = whole.try_fold(Univariate::default(), |sum, c| {
                    Some(field.times(&sum, &candidate).ok()?.plus(c))
                });
                if value.is_some_and(|value| field.sign(&value).is_eq()) {
                    found.push(candidate);
                }
            }
            found
        }
    }
}

/// A square root that lies in the field itself, not negative.
fn root_in(field: &Field, value: &Univariate) -> Option<Univariate> {
    let root = match (
        value.as_constant(),
        field.polynomial().monic().coefficients(),
    ) {
        (Some(value), _) if square_root(&value).is_some() => {
            Univariate::constant(square_root(&value)?)
        }
        // s = 2α + b has the square b² − 4c.
        (_, [c, b, _]) => {
            let two = Rational::from(2);
            let s = Univariate::new([b.clone(), two.clone()]);
            let d = b * b - Rational::from(4) * c;
            let at = |k: usize| value.coefficients().get(k).cloned();
            let (u, v) = (at(0).unwrap_or_else(Rational::zero), at(1));
            let v = v.unwrap_or_else(Rational::zero) / &two;
            let u = u - &v * b;
            if v.is_zero() {
                s.scaled(&square_root(&(u / d))?)
            } else {
                // u + v s = (m + v s / 2m)², where m² = (u ± √(u² − d v²)) / 2.
                let norm = square_root(&(&u * &u - &d * &v * &v))?;
                let halves = [(&u + &norm) / &two, (&u - &norm) / &two];
                let m = halves.iter().find_map(square_root);
                let m = m.filter(|m| !m.is_zero())?;
                let slope = v / (&two * &m);
                s.scaled(&slope).plus(&Univariate::constant(m))
            }
        }
        _ => return None,
    };
    Some(match field.sign(&root).is_lt() {
        true => root.scaled(&-Rational::one()),
        false => root,
    })
}
