//! Values as terms that a person would write: `(n - 1)/(n + 1) v_0`.

use num_integer::Integer;
use num_traits::Signed;

use crate::algebra::{
    Atoms, BigInt, Expr, Fraction, Monomial, Polynomial, Rational, Univariate, Var, expr_of,
    expr_of_fraction, factors, product_of, raised,
};
use crate::sorted::Map;

/// A value in lowest terms, what does not depend on the number that runs as factors behind the rest.
pub(super) fn term(value: &Fraction, parameter: Var, atoms: &Atoms) -> Expr {
    reduced(value, parameter)
        .map(|(above, below)| split(&above, &below, parameter, atoms))
        .unwrap_or_else(|| expr_of_fraction(value, atoms))
}

/// `1 - k` rather than `-k + 1`.
fn sum(polynomial: &Polynomial, atoms: &Atoms) -> Expr {
    let sum = expr_of(polynomial, atoms);
    if let Expr::Sum(terms) = &sum
        && let Some(at) = terms.iter().position(|t| !matches!(t, Expr::Negate(_)))
    {
        let mut terms = terms.to_vec();
        terms[..=at].rotate_right(1);
        return Expr::Sum(terms.into());
    }
    sum
}

fn split(above: &Polynomial, below: &Polynomial, parameter: Var, atoms: &Atoms) -> Expr {
    let behind = above.content().without(parameter);
    let behind = Polynomial::term(behind, Rational::one());
    let above = above.divided_by(&behind).unwrap_or_default();
    let (sign, above) = match sum(&above, atoms) {
        Expr::Negate(above) => (true, (*above).clone()),
        above => (false, above),
    };
    let quotient = match below.as_constant() {
        Some(one) if one.is_one() => above,
        _ => {
            let factors = factors_of(below).into_iter();
            let factors = factors.map(|(factor, power)| raised(sum(&factor, atoms), power));
            Expr::Quotient(above.into(), product_of(factors.collect()).into())
        }
    };
    let whole = match behind.as_constant() {
        Some(_) => quotient,
        None => joined(quotient, expr_of(&behind, atoms)),
    };
    match sign {
        true => Expr::Negate(whole.into()),
        false => whole,
    }
}

fn joined(first: Expr, behind: Expr) -> Expr {
    let parts = |term: Expr| match term {
        Expr::Product(factors) => factors.to_vec(),
        term => vec![term],
    };
    match first.is_one() {
        true => behind,
        false => product_of(parts(first).into_iter().chain(parts(behind)).collect()),
    }
}

/// The factors of a polynomial with whole coefficients, its number before them.
fn factors_of(polynomial: &Polynomial) -> Vec<(Polynomial, u32)> {
    let number = polynomial
        .leading()
        .map_or_else(Rational::one, |l| l.1.clone());
    let own = factors(polynomial);
    // Where the factors are monic, the number in front is a factor of its own; else it is left within the one sum.
    let monic = polynomial.monic().terms().all(|(_, c)| c.is_integer());
    match (monic, own.len()) {
        (true, _) => {
            let number = (!number.is_one() || own.is_empty()).then(|| {
                let number = Polynomial::constant(number);
                (number, 1)
            });
            number.into_iter().chain(own).collect()
        }
        (false, _) => vec![(polynomial.clone(), 1)],
    }
}

/// Numerator and denominator without a common factor, with whole coefficients; `None` where the denominator depends on more
/// than the number that runs.
fn reduced(value: &Fraction, parameter: Var) -> Option<(Polynomial, Polynomial)> {
    let below = value.expanded_denominator().ok()?;
    if below.vars().iter().any(|&var| var != parameter) {
        return None;
    }
    let mut parts: Map<Monomial, Vec<(u32, Rational)>> = Map::new();
    for (monomial, coefficient) in value.numerator().terms() {
        let own = parts.entry(monomial.without(parameter)).or_default();
        own.push((monomial.exponent(parameter), coefficient.clone()));
    }
    let parts: Vec<(Monomial, Univariate)> = parts
        .into_iter()
        .map(|(monomial, terms)| (monomial, univariate(&terms)))
        .collect();
    let own: Vec<(u32, Rational)> = below
        .terms()
        .map(|(m, c)| (m.exponent(parameter), c.clone()))
        .collect();
    let below = univariate(&own);
    let common = parts
        .iter()
        .fold(below.clone(), |gcd, (_, part)| gcd.gcd(part));
    let polynomial = |part: &Univariate| {
        let (quotient, _) = part.divided_by(&common)?;
        let terms = (0..).zip(quotient.coefficients());
        let sum = terms.fold(Polynomial::zero(), |sum, (power, coefficient)| {
            let term = Polynomial::term(Monomial::power(parameter, power), coefficient.clone());
            sum.plus(&term)
        });
        Some(sum)
    };
    let mut above = Polynomial::zero();
    for (monomial, part) in &parts {
        above = above.plus(&polynomial(part)?.times_term(monomial, &Rational::one()));
    }
    let below = polynomial(&below)?;
    let scale = whole(&above, &below);
    Some((above.scaled(&scale), below.scaled(&scale)))
}

fn univariate(terms: &[(u32, Rational)]) -> Univariate {
    let degree = terms.iter().map(|term| term.0).max().unwrap_or(0);
    Univariate::new((0..=degree).map(|power| {
        let own = terms.iter().filter(|term| term.0 == power);
        own.fold(Rational::zero(), |sum, term| sum + &term.1)
    }))
}

/// The least number that makes all coefficients of two polynomials whole and coprime, the leading one below positive.
fn whole(above: &Polynomial, below: &Polynomial) -> Rational {
    let coefficients = || above.terms().chain(below.terms()).map(|term| term.1);
    let denominator = coefficients().fold(BigInt::from(1), |lcm, c| lcm.lcm(&c.denom()));
    let numerator = coefficients().fold(BigInt::from(0), |gcd, c| gcd.gcd(&c.numer()));
    let sign = match below.leading().is_some_and(|(_, c)| c.is_negative()) {
        true => BigInt::from(-1),
        false => BigInt::from(1),
    };
    let scale = Rational::from(denominator) / Rational::from(numerator.abs().max(BigInt::from(1)));
    scale * Rational::from(sign)
}
