//! Roots of both sides: what an equation between two positive products says below a common power.

use num_traits::One;

use super::prove::Prover;
use super::tracked::{Tracked, cofactors, listed};
use crate::algebra::{Atom, BigInt, BigRational, Expr, Monomial, Polynomial, Rational, TooLarge};
use crate::kernel::{Fact, Proof, Sign};

/// Prime factors under a root are looked for up to this.
const LARGEST_PRIME: u32 = 100;
const HIGHEST_POWER: u32 = 120;
const MOST_BITS: u64 = 512;

/// `M = k N` from `M^g = k^g N^g`, where all unknowns are positive: the left side less the right is `M − k N` times
/// `Σ M^i (k N)^(g−1−i)`, which is positive.
pub fn root_of(element: &Tracked, prover: &Prover) -> Result<Option<(Fact, Proof)>, TooLarge> {
    let mut terms = element.polynomial.terms();
    let (Some((m, c)), Some((n, d)), None) = (terms.next(), terms.next(), terms.next()) else {
        return Ok(None);
    };
    if c.is_negative() == d.is_negative() {
        return Ok(None);
    }
    let common = m.gcd(n);
    let (Some(left), Some(right)) = (m.divided_by(&common), n.divided_by(&common)) else {
        return Ok(None);
    };
    let knowledge = &prover.knowledge;
    let both = left.times(&right).times(&common);
    let ratio = -(d / c);
    if !knowledge.monomial_is_positive(&both)
        || ratio.numer().bits() + ratio.denom().bits() > MOST_BITS
    {
        return Ok(None);
    }
    let exponents = left.powers().iter().chain(right.powers()).map(|p| p.1);
    let power = exponents.fold(0, num_integer::gcd);
    let orders = (2..=power.min(HIGHEST_POWER))
        .rev()
        .filter(|g| power % g == 0);
    for order in orders {
        let Some(factor) = NumberRoot::find(&ratio, order, prover)? else {
            continue;
        };
        let (left, right) = (rooted(&left, order), rooted(&right, order));
        // The square of something negative is positive too.
        if !knowledge.is_positive(&left) || !knowledge.is_positive(&right) {
            continue;
        }
        let scaled = factor.value.times(&right)?;
        let goal = left.minus(&scaled);
        // (M − k N) Σ = (M^g − c N^g) − (k^g − c) N^g
        let sum = beside_difference(&left, &scaled, order)?;
        let common = Polynomial::term(common, c.clone());
        let mut multiplier = element.multiplier.clone();
        for factor in [common.clone(), sum] {
            if factor.as_constant().is_none_or(|c| !c.is_one()) {
                *multiplier.entry(factor).or_insert(0) += 1;
            }
        }
        let mut used = element.cofactors()?;
        let mut outer = common.times(&right.pow(order)?)?;
        for (factor, exponent) in &element.multiplier {
            outer = outer.times(&factor.pow(*exponent)?)?;
        }
        for (at, cofactor) in factor.excess {
            let slot = used.entry(at).or_default();
            *slot = slot.minus(&cofactor.times(&outer)?);
        }
        let proof = Proof::Combination {
            multiplier: listed(&multiplier),
            power: 1,
            cofactors: cofactors(&used),
        };
        let fact = Fact {
            polynomial: goal,
            sign: Sign::Zero,
        };
        return Ok(Some((fact, proof)));
    }
    Ok(None)
}

/// What `a − b` is multiplied by to be `a^g − b^g`: `Σ a^i b^(g−1−i)`.
pub fn beside_difference(
    left: &Polynomial,
    right: &Polynomial,
    power: u32,
) -> Result<Polynomial, TooLarge> {
    (0..power).try_fold(Polynomial::zero(), |sum, i| {
        Ok(sum.plus(&left.pow(i)?.times(&right.pow(power - 1 - i)?)?))
    })
}

fn rooted(monomial: &Monomial, order: u32) -> Polynomial {
    let powers = monomial.powers().iter();
    let root = powers.fold(Monomial::one(), |all, &(var, exponent)| {
        all.times(&Monomial::power(var, exponent / order))
    });
    Polynomial::term(root, Rational::one())
}

/// The root of a positive number by the roots of primes that there are.
struct NumberRoot {
    value: Polynomial,
    /// `value^order − number` as a combination of facts.
    excess: Vec<(usize, Polynomial)>,
}

impl NumberRoot {
    fn find(number: &Rational, order: u32, prover: &Prover) -> Result<Option<Self>, TooLarge> {
        // n/d = n d^(g−1) / d^g
        let below = number.denom();
        if below.bits() * u64::from(order) > 8 * MOST_BITS {
            return Ok(None);
        }
        let mut left: BigInt = number.numer() * below.pow(order - 1);
        let mut outside = BigInt::one();
        let mut value = Polynomial::one();
        let mut facts: Vec<(usize, Polynomial, Polynomial)> = Vec::new();
        for prime in 2..=LARGEST_PRIME {
            let mut exponent = 0;
            while (&left % prime) == BigInt::ZERO {
                left /= prime;
                exponent += 1;
            }
            outside *= BigInt::from(prime).pow(exponent / order);
            let exponent = exponent % order;
            if exponent == 0 {
                continue;
            }
            let common = num_integer::gcd(exponent, order);
            let (exponent, own) = (exponent / common, order / common);
            let unit = BigRational::new(BigInt::one(), own.into());
            let written = Expr::Power(Expr::integer(prime).into(), Expr::Number(unit).into());
            let Some(var) = prover.atoms.find(&Atom::Opaque(written)) else {
                return Ok(None);
            };
            let root = Polynomial::var(var);
            let prime = Polynomial::constant(prime.into());
            let says = root.pow(own)?.minus(&prime);
            let fact = |f: &Fact| f.sign == Sign::Zero && f.polynomial == says;
            let Some(at) = prover.facts.iter().position(fact) else {
                return Ok(None);
            };
            // A = t^own and B = prime: A^e − B^e = (A − B) Σ A^j B^(e−1−j), with e = exponent · order / own.
            value = value.times(&root.pow(exponent)?)?;
            let whole = exponent * common;
            let above = root.pow(own)?;
            let sum = beside_difference(&above, &prime, whole)?;
            for (_, cofactor, _) in &mut facts {
                *cofactor = cofactor.times(&prime.pow(whole)?)?;
            }
            let before = facts
                .iter()
                .try_fold(Polynomial::one(), |p, f| p.times(&f.2))?;
            facts.push((at, before.times(&sum)?, above.pow(whole)?));
        }
        let rest = left.nth_root(order);
        if rest.pow(order) != left {
            return Ok(None);
        }
        let outside = Rational::from(BigRational::new(outside * rest, below));
        let mut scale = Polynomial::constant(outside.clone());
        value = value.times(&scale)?;
        scale = scale.pow(order)?;
        let excess = facts
            .into_iter()
            .map(|(at, cofactor, _)| Ok((at, cofactor.times(&scale)?)));
        Ok(Some(NumberRoot {
            value,
            excess: excess.collect::<Result<_, TooLarge>>()?,
        }))
    }
}
