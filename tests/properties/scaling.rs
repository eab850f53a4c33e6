//! Scaling relations that follow by construction, then changed in one exponent.

use cradle_verify::algebra::{BigRational, Expr, Formula, Rational, Relation};
use cradle_verify::kernel::{Claim, Hypothesis, Standing};
use cradle_verify::search::{ScalingDecision, decide_scaling};
use cradle_verify::sorted::Map;
use num_traits::Zero;
use proptest::prelude::*;

const NAMES: [&str; 6] = ["a", "b", "c", "x", "y", "v"];

type Row = Vec<BigRational>;

fn ratio(above: i64, below: i64) -> BigRational {
    BigRational::new(above.into(), below.into())
}

/// `Π s^e` of the positive exponents over that of the negative ones.
fn relation(row: &Row, relation: Relation, number: i64) -> Formula {
    let side = |sign: i64| {
        let mut factors = vec![Expr::integer(if sign > 0 { number } else { 1 })];
        for (name, exponent) in NAMES.iter().zip(row) {
            let exponent = exponent * ratio(sign, 1);
            if exponent > BigRational::zero() {
                factors.push(Expr::Power(
                    Expr::symbol(name).into(),
                    Expr::Number(exponent).into(),
                ));
            }
        }
        factors.push(Expr::integer(1));
        Expr::Product(factors.into())
    };
    Formula::Relation {
        left: side(1),
        relation,
        right: side(-1),
    }
}

fn claim(premises: &[(Row, bool)], goal: &Row) -> Claim {
    let hypotheses = premises.iter().map(|(row, exact)| Hypothesis {
        formula: match exact {
            true => relation(row, Relation::Equal, 3),
            false => relation(row, Relation::Scales, 3),
        }
        .into(),
        standing: Standing::Identity,
    });
    Claim {
        domains: Map::new(),
        sequences: Map::new(),
        hypotheses: hypotheses.collect(),
        goal: relation(goal, Relation::Scales, 1),
    }
}

/// Elimination, written down again.
fn rank(rows: &[Row]) -> usize {
    let mut rows = rows.to_vec();
    let mut rank = 0;
    for column in 0..NAMES.len() {
        let Some(at) = (rank..rows.len()).find(|&at| !rows[at][column].is_zero()) else {
            continue;
        };
        rows.swap(rank, at);
        for other in rank + 1..rows.len() {
            let factor = &rows[other][column] / &rows[rank][column];
            let pivot = rows[rank].clone();
            for (slot, own) in rows[other].iter_mut().zip(&pivot) {
                *slot -= own * &factor;
            }
        }
        rank += 1;
    }
    rank
}

fn follows(premises: &[(Row, bool)], goal: &Row) -> bool {
    let own: Vec<Row> = premises.iter().map(|p| p.0.clone()).collect();
    let mut with = own.clone();
    with.push(goal.clone());
    rank(&own) == rank(&with)
}

fn exponent() -> impl Strategy<Value = BigRational> {
    let below = prop_oneof![Just(1), Just(2), Just(5)];
    (-3_i64..=3, below).prop_map(|(above, below)| ratio(above, below))
}

fn premises() -> impl Strategy<Value = Vec<(Row, bool)>> {
    let row = proptest::collection::vec(exponent(), NAMES.len());
    proptest::collection::vec((row, any::<bool>()), 1..5)
}

/// Whether exact equations contradict one another: then nothing can be refuted.
fn possible(premises: &[(Row, bool)]) -> bool {
    let exact: Vec<Row> = premises
        .iter()
        .filter(|p| p.1)
        .map(|p| p.0.clone())
        .collect();
    rank(&exact) == exact.len()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn what_is_a_combination_of_premises_follows(
        premises in premises(),
        weights in proptest::collection::vec(exponent(), 5),
    ) {
        let mut goal = vec![BigRational::zero(); NAMES.len()];
        for ((row, _), weight) in premises.iter().zip(&weights) {
            for (slot, exponent) in goal.iter_mut().zip(row) {
                *slot += exponent * weight;
            }
        }
        let decision = decide_scaling(&claim(&premises, &goal));
        prop_assert!(matches!(decision, ScalingDecision::Proven(_)), "{decision:?}");
    }

    #[test]
    fn what_is_changed_in_one_exponent_fails_unless_it_still_follows(
        premises in premises(),
        weights in proptest::collection::vec(exponent(), 5),
        place in 0..NAMES.len(),
        change in exponent(),
    ) {
        let mut goal = vec![BigRational::zero(); NAMES.len()];
        for ((row, _), weight) in premises.iter().zip(&weights) {
            for (slot, exponent) in goal.iter_mut().zip(row) {
                *slot += exponent * weight;
            }
        }
        goal[place] += change;
        let decision = decide_scaling(&claim(&premises, &goal));
        match follows(&premises, &goal) {
            true => prop_assert!(matches!(decision, ScalingDecision::Proven(_))),
            false if possible(&premises) => {
                let ScalingDecision::Refuted { refuted, repair } = &decision else {
                    return Err(TestCaseError::fail(format!("{decision:?}")));
                };
                // The two situations, without the kernel.
                let mut sums = Vec::new();
                for row in premises.iter().map(|p| &p.0).chain([&goal]) {
                    let mut grown = BigRational::zero();
                    for (name, exponent) in NAMES.iter().zip(row) {
                        if let Some((first, second)) = refuted.situations().values.get(&Expr::symbol(name)) {
                            let growth = second.over(first);
                            for (base, power) in &growth.powers {
                                prop_assert!(*base == Rational::from(2) || base.is_one());
                                grown += power.to_big() * exponent;
                            }
                        }
                    }
                    sums.push(grown);
                }
                let last = sums.pop().unwrap();
                prop_assert!(sums.iter().all(Zero::is_zero));
                prop_assert!(!last.is_zero());
                if let Some(repair) = repair {
                    prop_assert!(!repair.proven.claim().hypotheses.is_empty());
                }
            }
            false => prop_assert!(!matches!(decision, ScalingDecision::Proven(_))),
        }
    }
}

/// Once found by the property above.
#[test]
fn exponents_with_large_denominators_are_refuted() {
    let row = |exponents: [(i64, i64); 6]| -> Row {
        exponents.iter().map(|(a, b)| ratio(*a, *b)).collect()
    };
    let premises = [
        row([(1, 1), (1, 1), (-1, 1), (-2, 1), (-2, 5), (1, 1)]),
        row([(-2, 1), (1, 1), (-3, 2), (0, 1), (2, 1), (1, 5)]),
        row([(0, 1), (1, 5), (2, 1), (0, 1), (3, 1), (1, 1)]),
        row([(-1, 5), (-2, 5), (2, 5), (-1, 1), (0, 1), (-3, 1)]),
    ];
    let mut goal: Row = premises[1].iter().map(|e| e * ratio(2, 1)).collect();
    goal[3] += ratio(-3, 1);
    let premises = premises.map(|row| (row, false));
    let decision = decide_scaling(&claim(&premises, &goal));
    assert!(
        matches!(decision, ScalingDecision::Refuted { .. }),
        "{decision:?}"
    );
}
