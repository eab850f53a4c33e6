//! The numbers that a person would try first.

use std::sync::LazyLock;

use num_traits::{One, Signed};

use crate::algebra::{BigInt, BigRational, Polynomial, Rational, Var};
use crate::sorted;

/// Numbers to try, with their cost: the simpler the cheaper.
pub fn candidates() -> &'static [(u32, Rational)] {
    static CANDIDATES: LazyLock<Vec<(u32, Rational)>> = LazyLock::new(listed);
    &CANDIDATES
}

fn listed() -> Vec<(u32, Rational)> {
    let ratio = |p: i32, q: i32| Rational::ratio(p, q);
    let by_cost: [(u32, &[(i32, i32)]); 6] = [
        (0, &[(1, 1)]),
        (1, &[(0, 1), (2, 1), (-1, 1)]),
        (2, &[(1, 2), (3, 1), (-2, 1)]),
        (3, &[(-1, 2), (3, 2), (1, 3), (2, 3), (4, 1), (-3, 1)]),
        (4, &[(-1, 3), (-2, 3), (1, 4), (3, 4), (5, 1), (6, 1)]),
        (
            5,
            &[
                (-3, 2),
                (4, 3),
                (5, 3),
                (1, 5),
                (2, 5),
                (3, 5),
                (4, 5),
                (7, 1),
                (8, 1),
                (9, 1),
                (-4, 1),
            ],
        ),
    ];
    let all = by_cost
        .iter()
        .flat_map(|(cost, list)| list.iter().map(move |&(p, q)| (*cost, ratio(p, q))));
    all.collect()
}

/// The rational roots of a polynomial in one unknown; `None` where they were not all looked for.
pub fn rational_roots(polynomial: &Polynomial, var: Var) -> Option<Vec<Rational>> {
    let mut coefficients = vec![Rational::zero(); polynomial.degree_in(var) as usize + 1];
    for (monomial, coefficient) in polynomial.terms() {
        let exponent = monomial.exponent(var);
        if exponent != monomial.degree() {
            return None;
        }
        coefficients[exponent as usize] = coefficient.clone();
    }
    let mut roots = Vec::new();
    if coefficients.first().is_some_and(|c| c.is_zero()) {
        roots.push(Rational::zero());
        let first = coefficients.iter().position(|c| !c.is_zero())?;
        coefficients.drain(..first);
    }
    match coefficients.as_slice() {
        [] | [_] => {}
        [b, a] => roots.push(-b / a),
        [c, b, a] => {
            let four = Rational::from(4);
            if let Some(root) = square_root(&(b * b - four * a * c)) {
                let twice = a + a;
                roots.push((&root - b) / &twice);
                roots.push(-(b + &root) / &twice);
            }
        }
        // x^n = c, with the middle missing.
        [c, middle @ .., a] if middle.iter().all(Rational::is_zero) => {
            let n = coefficients.len() as u32 - 1;
            roots.extend(nth_roots(&(-c / a), n));
        }
        _ => {
            // Rational root theorem, for numbers whose divisors are quickly found.
            let common = coefficients
                .iter()
                .fold(BigInt::one(), |l, c| num_integer::lcm(l, c.denom()));
            let integer = |c: &Rational| (c * Rational::from(common.clone())).numer();
            let (last, lead) = (
                integer(coefficients.first()?),
                integer(coefficients.last()?),
            );
            for p in divisors(&last)? {
                for q in divisors(&lead)? {
                    for numerator in [p.clone(), -p.clone()] {
                        let root = Rational::from(BigRational::new(numerator, q.clone()));
                        let value = coefficients
                            .iter()
                            .rev()
                            .fold(Rational::zero(), |sum, c| sum * &root + c);
                        if value.is_zero() {
                            roots.push(root);
                        }
                    }
                }
            }
        }
    }
    sorted::sort_by_key(&mut roots, simplicity);
    roots.dedup();
    Some(roots)
}

/// Smaller is simpler: by size of the parts, positive before negative.
pub fn simplicity(value: &Rational) -> (BigInt, bool) {
    (value.numer().abs() + value.denom(), value.is_negative())
}

/// The root of the square of a rational number.
pub fn square_root(value: &Rational) -> Option<Rational> {
    if value.is_negative() {
        return None;
    }
    let (p, q) = (value.numer().sqrt(), value.denom().sqrt());
    (&p * &p == value.numer() && &q * &q == value.denom()).then(|| BigRational::new(p, q).into())
}

fn nth_roots(value: &Rational, n: u32) -> Vec<Rational> {
    let (p, q) = (value.numer().abs().nth_root(n), value.denom().nth_root(n));
    if p.pow(n) != value.numer().abs() || q.pow(n) != value.denom() {
        return Vec::new();
    }
    let root = Rational::from(BigRational::new(p, q));
    match (value.is_negative(), n % 2) {
        (true, 1) => vec![-root],
        (true, _) => Vec::new(),
        (false, 1) => vec![root],
        (false, _) => vec![root.clone(), -root],
    }
}

fn divisors(value: &BigInt) -> Option<Vec<BigInt>> {
    use num_traits::ToPrimitive;
    let value = value.abs().to_u64().filter(|v| (1..=10_000).contains(v))?;
    Some(
        (1..=value)
            .filter(|d| value % d == 0)
            .map(BigInt::from)
            .collect(),
    )
}
