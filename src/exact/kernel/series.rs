//! Sums over all elements of a sequence that cannot be negative, as polynomials in the power sums of a claim.

use super::{BoundedSeries, ElementFactor, ElementSide, Problem, Reject, SeriesSquare};
use crate::algebra::{Atom, Atoms, Polynomial, Rational, Symbol, power_sum};
use crate::sorted;

/// `Σ f² Σ g² − (Σ f g)²`, which is `Σ_{i<j} (f_i g_j − f_j g_i)²`.
pub(super) fn series_square(
    problem: &Problem,
    series: &SeriesSquare,
) -> Result<Polynomial, Reject> {
    let sum = |a: &[(Symbol, u32)], b: &[(Symbol, u32)]| {
        let mut powers: Vec<(Symbol, u32)> = Vec::new();
        for (sequence, exponent) in a.iter().chain(b) {
            match powers.iter_mut().find(|p| p.0 == *sequence) {
                Some(slot) => slot.1 = slot.1.checked_add(*exponent).ok_or(Reject::TooLarge)?,
                None => powers.push((sequence.clone(), *exponent)),
            }
        }
        powers.retain(|p| p.1 > 0);
        sorted::sort(&mut powers);
        total(problem, &series.count, powers)
    };
    be_count(problem, &series.count)?;
    let (f, g) = (&series.f, &series.g);
    Ok(sum(f, f)?.times(&sum(g, g)?)?.minus(&sum(f, g)?.pow(2)?))
}

/// `Σ_i f_i`, or `Σ f Σ g − Σ f g`, which is `Σ_{i≠j} f_i g_j`.
///
/// Neither is negative where no factor of `f` and `g` is, and that is so for all elements in the domain that the
/// claim declares for them: an element less its lower bound, the upper bound less the element, an even power.
pub(crate) fn bounded_series(
    problem: &Problem,
    series: &BoundedSeries,
) -> Result<Polynomial, Reject> {
    be_count(problem, &series.count)?;
    // Of the index of another sum nothing is known outside of it.
    if !problem.is_count(&series.count) {
        return Err(Reject::NoSuchSum);
    }
    // The elements at one index; where a sum is taken, no two indices meet.
    let mut elements = Atoms::default();
    let f = summand(problem, &series.f, &mut elements)?;
    let sum = |summand: &Polynomial, elements: &Atoms| {
        let mut sum = Polynomial::zero();
        for (monomial, coefficient) in summand.terms() {
            let mut powers: Vec<(Symbol, u32)> = Vec::new();
            for &(var, exponent) in monomial.powers() {
                if let Atom::Symbol(sequence) = elements.atom(var) {
                    powers.push((sequence.clone(), exponent));
                }
            }
            sorted::sort(&mut powers);
            sum = sum.plus(&total(problem, &series.count, powers)?.scaled(coefficient));
        }
        Ok::<_, Reject>(sum)
    };
    let Some(g) = &series.g else {
        return sum(&f, &elements);
    };
    let g = summand(problem, g, &mut elements)?;
    let both = sum(&f.times(&g)?, &elements)?;
    Ok(sum(&f, &elements)?
        .times(&sum(&g, &elements)?)?
        .minus(&both))
}

/// A product of factors, none of which is negative, as a polynomial in the elements at one index.
fn summand(
    problem: &Problem,
    factors: &[ElementFactor],
    elements: &mut Atoms,
) -> Result<Polynomial, Reject> {
    let mut product = Polynomial::one();
    for factor in factors {
        let sequence = &factor.sequence;
        let element = Polynomial::var(elements.var(Atom::Symbol(sequence.clone())));
        let domain = problem.element_domain(sequence);
        let bound = |bound: Option<&(crate::algebra::BigRational, bool)>| {
            let (value, _) = bound.ok_or_else(|| Reject::NoSuchBound(sequence.clone()))?;
            Ok::<_, Reject>(Polynomial::constant(Rational::from(value)))
        };
        let base = match factor.side {
            ElementSide::Own if factor.exponent % 2 == 0 => element,
            ElementSide::Own => return Err(Reject::NoSuchBound(sequence.clone())),
            ElementSide::AboveLower => {
                element.minus(&bound(domain.and_then(|d| d.lower.as_ref()))?)
            }
            ElementSide::BelowUpper => {
                bound(domain.and_then(|d| d.upper.as_ref()))?.minus(&element)
            }
        };
        product = product.times(&base.pow(factor.exponent)?)?;
    }
    Ok(product)
}

/// A power sum that occurs in the claim.
fn total(
    problem: &Problem,
    count: &Symbol,
    powers: Vec<(Symbol, u32)>,
) -> Result<Polynomial, Reject> {
    let var = problem.atoms.find(&power_sum(count, powers));
    Ok(Polynomial::var(var.ok_or(Reject::NoSuchSum)?))
}

/// Without a sum over it the symbol might not be a count at all.
fn be_count(problem: &Problem, count: &Symbol) -> Result<(), Reject> {
    let is_count = |atom: &Atom| matches!(atom, Atom::PowerSum { to, .. } if to == count);
    match problem.atoms.iter().any(|(_, atom)| is_count(atom)) {
        true => Ok(()),
        false => Err(Reject::NoSuchSum),
    }
}
