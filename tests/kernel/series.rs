//! Sums of what the domain of the elements keeps from being negative: accepted, then forged.

use cradle_verify::algebra::BigRational;
use cradle_verify::kernel::{
    BoundedSeries, Claim, Domain, ElementFactor, ElementSide, PositiveTerm, Reject,
};

use super::claims::*;

use ElementSide::{AboveLower, BelowUpper, Own};

fn bound(value: i64, strict: bool) -> Option<(BigRational, bool)> {
    Some((BigRational::from_integer(value.into()), strict))
}

/// A claim about a sequence with elements from `lower` to `upper`.
fn within(lower: Option<i64>, upper: Option<i64>, goal: &str) -> Proving {
    let mut claim: Claim = claim(&[], goal);
    let domain = Domain {
        lower: lower.and_then(|b| bound(b, false)),
        upper: upper.and_then(|b| bound(b, false)),
        ..Domain::default()
    };
    claim.sequences.insert(symbol("x"), domain);
    Proving::new(claim)
}

fn product(factors: &[(ElementSide, u32)]) -> Vec<ElementFactor> {
    let factor = |&(side, exponent): &(ElementSide, u32)| ElementFactor {
        sequence: symbol("x"),
        side,
        exponent,
    };
    factors.iter().map(factor).collect()
}

/// `Σ_i f_i`, or `Σ_{i≠j} f_i g_j`.
fn sum(
    count: &str,
    f: &[(ElementSide, u32)],
    g: Option<&[(ElementSide, u32)]>,
) -> Vec<PositiveTerm> {
    vec![PositiveTerm {
        bounded: vec![BoundedSeries {
            count: symbol(count),
            f: product(f),
            g: g.map(product),
        }],
        ..one()
    }]
}

const SHARES: &str = r"\sum_{i=1}^{n} x_i \geq \sum_{i=1}^{n} x_i^2";

#[test]
fn shares_exceed_their_squares() {
    let p = within(Some(0), Some(1), SHARES);
    let terms = sum("n", &[(AboveLower, 1), (BelowUpper, 1)], None);
    assert_eq!(p.checked(p.positivity(&[], terms, &[])), Ok(()));
}

#[test]
fn bounds_elsewhere_than_at_0_and_1_are_those_declared() {
    // (x − 2)(5 − x) = −x² + 7 x − 10
    let goal = r"7 \sum_{i=1}^{n} x_i \geq \sum_{i=1}^{n} x_i^2 + 10 n";
    let both = [(AboveLower, 1), (BelowUpper, 1)];
    let p = within(Some(2), Some(5), goal);
    assert_eq!(
        p.checked(p.positivity(&[], sum("n", &both, None), &[])),
        Ok(())
    );
    let p = within(Some(2), Some(6), goal);
    assert_eq!(
        p.checked(p.positivity(&[], sum("n", &both, None), &[])),
        Err(Reject::IdentityFails)
    );
}

#[test]
fn pairs_of_different_elements_are_accepted() {
    let goal = r"(\sum_{i=1}^{n} x_i)^2 \geq \sum_{i=1}^{n} x_i^2";
    let terms = || sum("n", &[(AboveLower, 1)], Some(&[(AboveLower, 1)]));
    let p = within(Some(0), None, goal);
    assert_eq!(p.checked(p.positivity(&[], terms(), &[])), Ok(()));
    // −1 and 1 have the sum 0.
    let p = within(None, None, goal);
    assert_eq!(
        p.checked(p.positivity(&[], terms(), &[])),
        Err(Reject::NoSuchBound(symbol("x")))
    );
}

#[test]
fn bound_that_is_not_declared_is_rejected() {
    let terms = || sum("n", &[(AboveLower, 1), (BelowUpper, 1)], None);
    for (lower, upper) in [(None, Some(1)), (Some(0), None), (None, None)] {
        let p = within(lower, upper, SHARES);
        let verdict = p.checked(p.positivity(&[], terms(), &[]));
        assert_eq!(verdict, Err(Reject::NoSuchBound(symbol("x"))));
    }
    // Declared of one element it says nothing of the others.
    let mut one_alone = claim(&[], r"x_1 + \sum_{i=1}^{n} x_i \geq x_1").sequence("x");
    let lower = bound(0, false);
    let domain = Domain {
        lower,
        ..Domain::default()
    };
    one_alone = one_alone.domain("x_1", domain);
    let p = Proving::new(one_alone);
    let terms = sum("n", &[(AboveLower, 1)], None);
    assert_eq!(
        p.checked(p.positivity(&[], terms, &[])),
        Err(Reject::NoSuchBound(symbol("x")))
    );
}

#[test]
fn bound_to_the_power_0_must_be_declared_too() {
    let p = within(None, None, r"\sum_{i=1}^{n} x_i^2 \geq 0");
    let terms = sum("n", &[(Own, 2), (BelowUpper, 0)], None);
    assert_eq!(
        p.checked(p.positivity(&[], terms, &[])),
        Err(Reject::NoSuchBound(symbol("x")))
    );
}

#[test]
fn even_power_needs_no_bound_and_an_odd_one_does() {
    let p = within(None, None, r"\sum_{i=1}^{n} x_i^4 \geq 0");
    let terms = sum("n", &[(Own, 4)], None);
    assert_eq!(p.checked(p.positivity(&[], terms, &[])), Ok(()));
    let p = within(Some(0), None, r"\sum_{i=1}^{n} x_i^3 \geq 0");
    let terms = sum("n", &[(Own, 3)], None);
    assert_eq!(
        p.checked(p.positivity(&[], terms, &[])),
        Err(Reject::NoSuchBound(symbol("x")))
    );
}

#[test]
fn sum_turned_round_is_rejected() {
    let p = within(
        Some(0),
        Some(1),
        r"\sum_{i=1}^{n} x_i \leq \sum_{i=1}^{n} x_i^2",
    );
    let factors = [(AboveLower, 1), (BelowUpper, 1)];
    let terms = sum("n", &factors, None);
    assert_eq!(
        p.checked(p.positivity(&[], terms, &[])),
        Err(Reject::IdentityFails)
    );
    let mut negative = sum("n", &factors, None);
    negative[0].coefficient = (-1).into();
    assert_eq!(
        p.checked(p.positivity(&[], negative, &[])),
        Err(Reject::NegativeCoefficient)
    );
}

#[test]
fn sum_of_bounds_is_never_strict() {
    // There may be no elements.
    let mut strict = claim(&[], r"\sum_{i=1}^{n} x_i > 0");
    let lower = bound(0, true);
    let domain = Domain {
        lower,
        ..Domain::default()
    };
    strict.sequences.insert(symbol("x"), domain);
    let p = Proving::new(strict);
    let terms = sum("n", &[(AboveLower, 1)], None);
    assert_eq!(
        p.checked(p.positivity(&[], terms, &[])),
        Err(Reject::NotStrict)
    );
}

#[test]
fn sum_that_does_not_occur_is_rejected() {
    let p = within(Some(0), Some(1), SHARES);
    let terms = sum("n", &[(AboveLower, 2), (BelowUpper, 1)], None);
    assert_eq!(
        p.checked(p.positivity(&[], terms, &[])),
        Err(Reject::NoSuchSum)
    );
    let terms = sum("k", &[(AboveLower, 1), (BelowUpper, 1)], None);
    assert_eq!(
        p.checked(p.positivity(&[], terms, &[])),
        Err(Reject::NoSuchSum)
    );
    // A symbol that nothing is summed up to may be anything, −1 for instance.
    let p = within(Some(0), Some(1), r"n \geq 0");
    assert_eq!(
        p.checked(p.positivity(&[], sum("n", &[], None), &[])),
        Err(Reject::NoSuchSum)
    );
}

#[test]
fn index_of_another_sum_counts_nothing_outside_of_it() {
    // The symbol i of the goal may be anything.
    let mut nested = claim(&[r"\sum_{i=1}^{n} \sum_{j=1}^{i} x_j = 3"], r"i \geq 0");
    let (lower, upper) = (bound(0, false), bound(1, false));
    let domain = Domain {
        lower,
        upper,
        ..Domain::default()
    };
    nested.sequences.insert(symbol("x"), domain);
    let p = Proving::new(nested);
    let terms = sum("i", &[], None);
    assert_eq!(
        p.checked(p.positivity(&[], terms, &[])),
        Err(Reject::NoSuchSum)
    );
    let both = [
        sum("i", &[(AboveLower, 1)], None),
        sum("i", &[(BelowUpper, 1)], None),
    ];
    assert_eq!(
        p.checked(p.positivity(&[], both.concat(), &[])),
        Err(Reject::NoSuchSum)
    );
}

#[test]
fn powers_of_bounds_beyond_all_bounds_are_refused() {
    let p = within(Some(0), Some(1), SHARES);
    let terms = sum("n", &[(BelowUpper, u32::MAX)], None);
    assert_eq!(
        p.checked(p.positivity(&[], terms, &[])),
        Err(Reject::TooLarge)
    );
    let terms = sum("n", &[(AboveLower, u32::MAX), (AboveLower, u32::MAX)], None);
    assert!(p.checked(p.positivity(&[], terms, &[])).is_err());
}
