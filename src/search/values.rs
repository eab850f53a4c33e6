//! The numbers that a person would try first.

use num_traits::{One, Signed, Zero};

use crate::algebra::{BigInt, BigRational, Polynomial, Var};

/// Numbers to try, with their cost: the simpler the cheaper.
pub fn candidates() -> Vec<(u32, BigRational)> {
    let ratio = |p: i64, q: i64| BigRational::new(p.into(), q.into());
    let by_cost: [(u32, &[(i64, i64)]); 6] = [
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
pub fn rational_roots(polynomial: &Polynomial, var: Var) -> Option<Vec<BigRational>> {
    let mut coefficients: Vec<BigRational> = polynomial
        .in_powers_of(var)
        .iter()
        .map(|c| c.as_constant())
        .collect::<Option<_>>()?;
    let mut roots = Vec::new();
    if coefficients.first().is_some_and(|c| c.is_zero()) {
        roots.push(BigRational::zero());
        let first = coefficients.iter().position(|c| !c.is_zero())?;
        coefficients.drain(..first);
    }
    match coefficients.as_slice() {
        [] | [_] => {}
        [b, a] => roots.push(-b / a),
        [c, b, a] => {
            let four = BigRational::from_integer(4.into());
            if let Some(root) = square_root(&(b * b - four * a * c)) {
                let twice = a + a;
                roots.push((-b + &root) / &twice);
                roots.push((-b - &root) / &twice);
            }
        }
        // x^n = c, with the middle missing.
        [c, middle @ .., a] if middle.iter().all(Zero::is_zero) => {
            let n = coefficients.len() as u32 - 1;
            roots.extend(nth_roots(&(-c / a), n));
        }
        _ => {
            // Rational root theorem, for numbers whose divisors are quickly found.
            let common = coefficients
                .iter()
                .fold(BigInt::one(), |l, c| num_integer::lcm(l, c.denom().clone()));
            let integer = |c: &BigRational| (c * &common).to_integer();
            let (last, lead) = (
                integer(coefficients.first()?),
                integer(coefficients.last()?),
            );
            for p in divisors(&last)? {
                for q in divisors(&lead)? {
                    for root in [
                        BigRational::new(p.clone(), q.clone()),
                        BigRational::new(-p.clone(), q.clone()),
                    ] {
                        let value = coefficients
                            .iter()
                            .rev()
                            .fold(BigRational::zero(), |sum, c| sum * &root + c);
                        if value.is_zero() {
                            roots.push(root);
                        }
                    }
                }
            }
        }
    }
    roots.sort_by(|a, b| simplicity(a).cmp(&simplicity(b)));
    roots.dedup();
    Some(roots)
}

/// Smaller is simpler: by size of the parts, positive before negative.
pub fn simplicity(value: &BigRational) -> (BigInt, bool) {
    (value.numer().abs() + value.denom(), value.is_negative())
}

fn square_root(value: &BigRational) -> Option<BigRational> {
    if value.is_negative() {
        return None;
    }
    let (p, q) = (value.numer().sqrt(), value.denom().sqrt());
    (&p * &p == *value.numer() && &q * &q == *value.denom()).then(|| BigRational::new(p, q))
}

fn nth_roots(value: &BigRational, n: u32) -> Vec<BigRational> {
    let (p, q) = (value.numer().abs().nth_root(n), value.denom().nth_root(n));
    if p.pow(n) != value.numer().abs() || q.pow(n) != *value.denom() {
        return Vec::new();
    }
    let root = BigRational::new(p, q);
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
