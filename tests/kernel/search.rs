//! What the search says of random small claims, against a naive evaluation at every point of a grid.

use cradle_verify::algebra::{BigRational, Expr, Formula, Relation};
use cradle_verify::kernel::{Assignment, Claim};
use cradle_verify::search::{Decision, decide};
use num_traits::{One, Zero};
use proptest::prelude::*;

use super::claims::*;

const NAMES: [&str; 3] = ["x", "y", "z"];

/// The value of a term of sums, products, quotients and natural powers; `None` where it is not defined.
fn value(expr: &Expr, at: &[BigRational; 3]) -> Option<BigRational> {
    Some(match expr {
        Expr::Number(number) => number.clone(),
        Expr::Symbol(symbol) => {
            let position = NAMES.iter().position(|n| *n == symbol.name())?;
            at[position].clone()
        }
        Expr::Sum(terms) => {
            let mut sum = BigRational::zero();
            for term in terms.iter() {
                sum += value(term, at)?;
            }
            sum
        }
        Expr::Product(factors) => {
            let mut product = BigRational::one();
            for factor in factors.iter() {
                product *= value(factor, at)?;
            }
            product
        }
        Expr::Negate(inner) => -value(inner, at)?,
        Expr::Quotient(above, below) => {
            let below = value(below, at)?;
            if below.is_zero() {
                return None;
            }
            value(above, at)? / below
        }
        Expr::Power(base, exponent) => {
            let exponent = value(exponent, at)?;
            if !exponent.is_integer() {
                return None;
            }
            let base = value(base, at)?;
            let exponent = i32::try_from(exponent.numer()).ok()?;
            if base.is_zero() && exponent < 0 {
                return None;
            }
            num_traits::Pow::pow(base, exponent)
        }
        _ => return None,
    })
}

fn is_true(formula: &Formula, at: &[BigRational; 3]) -> Option<bool> {
    let Formula::Relation {
        left,
        relation,
        right,
    } = formula
    else {
        return None;
    };
    let (left, right) = (value(left, at)?, value(right, at)?);
    Some(match relation {
        Relation::Equal => left == right,
        Relation::NotEqual => left != right,
        Relation::Less => left < right,
        Relation::LessOrEqual => left <= right,
        Relation::Greater => left > right,
        Relation::GreaterOrEqual => left >= right,
        _ => return None,
    })
}

fn premises_hold(claim: &Claim, at: &[BigRational; 3]) -> bool {
    let inside = NAMES.iter().zip(at).all(|(name, value)| {
        let domain = claim.domains.get(&symbol(name));
        domain.is_none_or(|d| d.contains(value))
    });
    let mut hypotheses = claim.hypotheses.iter();
    inside && hypotheses.all(|h| is_true(&h.formula, at) == Some(true))
}

/// A grid point at which the claim is plainly false.
fn counterexample(claim: &Claim) -> Option<[BigRational; 3]> {
    let grid: Vec<BigRational> = (-3..=3)
        .map(number)
        .chain([ratio(1, 2), ratio(-1, 2), ratio(3, 2), ratio(1, 3)])
        .collect();
    for x in &grid {
        for y in &grid {
            for z in &grid {
                let at = [x.clone(), y.clone(), z.clone()];
                if premises_hold(claim, &at) && is_true(&claim.goal, &at) != Some(true) {
                    return Some(at);
                }
            }
        }
    }
    None
}

/// A rational point that differs from one with irrational values by next to nothing.
fn nearby(point: &Assignment) -> [BigRational; 3] {
    let own = point.algebraic.as_ref().expect("a root");
    let eval = |list: &[BigRational], x: &BigRational| {
        let terms = list.iter().rev();
        terms.fold(BigRational::zero(), |sum, c| sum * x + c)
    };
    let (mut low, mut high) = (own.low.clone(), own.high.clone());
    let rising = eval(&own.polynomial, &high) > BigRational::zero();
    for _ in 0..100 {
        let middle = (&low + &high) / number(2);
        match (eval(&own.polynomial, &middle) > BigRational::zero()) == rising {
            true => high = middle,
            false => low = middle,
        }
    }
    NAMES.map(|name| {
        let irrational = own.symbols.get(&symbol(name));
        match irrational {
            Some(value) => eval(value, &low),
            None => point
                .symbols
                .get(&symbol(name))
                .cloned()
                .unwrap_or_else(BigRational::one),
        }
    })
}

/// Whether a formula is as true, or as false, as numbers nearby can tell.
fn may_be(formula: &Formula, at: &[BigRational; 3], truth: bool) -> bool {
    let Formula::Relation {
        left,
        relation,
        right,
    } = formula
    else {
        return false;
    };
    let (Some(left), Some(right)) = (value(left, at), value(right, at)) else {
        return false;
    };
    let difference = left - right;
    let near = |d: &BigRational| *d < ratio(1, 1 << 40) && *d > ratio(-1, 1 << 40);
    let positive = difference > BigRational::zero();
    match (relation, truth) {
        (Relation::Equal, true) | (Relation::NotEqual, false) => near(&difference),
        (Relation::Equal, false) | (Relation::NotEqual, true) => !near(&difference),
        (Relation::Less, true) | (Relation::GreaterOrEqual, false) => !positive,
        (Relation::Greater, true) | (Relation::LessOrEqual, false) => positive,
        (Relation::Less, false) | (Relation::GreaterOrEqual, true) => positive || near(&difference),
        (Relation::Greater, false) | (Relation::LessOrEqual, true) => {
            !positive || near(&difference)
        }
        _ => false,
    }
}

/// Compares what is decided with what is so; a premise that was found to be missing is taken for granted.
fn compare(claim: &Claim) -> Result<(), TestCaseError> {
    match decide(claim.clone(), &[]) {
        Decision::Proven { derived, .. } => {
            prop_assert_eq!(counterexample(derived.proven.claim()), None);
        }
        Decision::Refuted(refuted) => {
            prop_assert!(refuted.witness().unfold.is_empty());
            if refuted.witness().algebraic.is_some() {
                let at = nearby(refuted.witness());
                for hypothesis in &claim.hypotheses {
                    prop_assert!(may_be(&hypothesis.formula, &at, true));
                }
                prop_assert!(may_be(&claim.goal, &at, false));
                return Ok(());
            }
            let free = |name: &str| !claim.free_symbols().contains(&&symbol(name));
            let at = NAMES.map(|name| {
                let value = refuted.witness().symbols.get(&symbol(name));
                value.cloned().unwrap_or_else(|| {
                    assert!(free(name), "{name} has no value");
                    number(1)
                })
            });
            // Symbols that do not occur may be outside of their domains here.
            let mut claim = claim.clone();
            claim.domains.retain(|s, _| !free(s.name()));
            prop_assert!(premises_hold(&claim, &at));
            prop_assert_eq!(is_true(&claim.goal, &at), Some(false));
        }
        Decision::Open(_) => {}
    }
    Ok(())
}

fn monomial() -> impl Strategy<Value = String> {
    prop_oneof![
        3 => prop::sample::select(NAMES.to_vec()).prop_map(String::from),
        2 => (prop::sample::select(NAMES.to_vec()), prop::sample::select(NAMES.to_vec()))
            .prop_map(|(a, b)| format!("{a} {b}")),
        1 => Just("1".to_string()),
    ]
}

fn polynomial() -> impl Strategy<Value = String> {
    prop::collection::vec((-2i64..3, monomial()), 1..4).prop_map(|terms| {
        let terms: Vec<String> = terms.iter().map(|(c, m)| format!("({c}) {m}")).collect();
        terms.join(" + ")
    })
}

fn relation() -> impl Strategy<Value = &'static str> {
    prop_oneof![
        4 => Just("="),
        1 => Just(r"\neq"),
        1 => Just(r"\geq"),
        1 => Just(">"),
        1 => Just(r"\leq"),
        1 => Just("<"),
    ]
}

fn side() -> impl Strategy<Value = String> {
    prop_oneof![
        4 => polynomial(),
        1 => (polynomial(), prop::sample::select(NAMES.to_vec()))
            .prop_map(|(p, below)| format!(r"\frac{{{p}}}{{{below}}}")),
    ]
}

fn relations(most: usize) -> impl Strategy<Value = Vec<String>> {
    let one = (side(), relation(), side()).prop_map(|(a, r, b)| format!("{a} {r} {b}"));
    prop::collection::vec(one, 0..most)
}

fn build(hypotheses: &[String], goal: &str, positives: [bool; 3]) -> Claim {
    let named: Vec<&str> = hypotheses.iter().map(String::as_str).collect();
    let mut built = claim(&named, goal);
    for (name, _) in NAMES
        .iter()
        .zip(positives)
        .filter(|(_, positive)| *positive)
    {
        built = built.domain(name, positive());
    }
    built
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn what_is_decided_of_random_claims_is_so(
        hypotheses in relations(4),
        (left, relation, right) in (side(), relation(), side()),
        positives in any::<[bool; 3]>(),
    ) {
        compare(&build(&hypotheses, &format!("{left} {relation} {right}"), positives))?;
    }

    /// A combination of the hypotheses follows. With 1 added it contradicts them, so it may be proven only where they
    /// contradict one another.
    #[test]
    fn combination_of_the_hypotheses_is_proven_and_its_perturbation_is_not(
        rows in prop::collection::vec((polynomial(), polynomial(), -2i64..3), 1..3),
        positives in any::<[bool; 3]>(),
    ) {
        let hypotheses: Vec<String> = rows.iter().map(|(a, b, _)| format!("{a} = {b}")).collect();
        let goal: Vec<String> = rows.iter()
            .map(|(a, b, c)| format!("({c}) (({a}) - ({b}))"))
            .collect();
        let goal = goal.join(" + ");
        let follows = build(&hypotheses, &format!("{goal} = 0"), positives);
        let decision = decide(follows.clone(), &[]);
        prop_assert!(
            matches!(&decision, Decision::Proven { conditions, .. } if conditions.is_empty()),
            "{:?}", decision
        );
        compare(&follows)?;
        compare(&build(&hypotheses, &format!("{goal} = 1"), positives))?;
    }

    /// `c (p − q)² ≥ 0` and its perturbation `c (p − q)² ≥ 1`, false wherever p = q.
    #[test]
    fn square_is_not_negative_and_that_is_all(p in polynomial(), q in polynomial(), c in 1i64..4) {
        compare(&build(&[], &format!(r"{c} (({p}) - ({q}))^2 \geq 0"), [false; 3]))?;
        compare(&build(&[], &format!(r"{c} (({p}) - ({q}))^2 > 0"), [false; 3]))?;
        let same = build(&[format!("{p} = {q}")], &format!(r"{c} (({p}) - ({q}))^2 \geq 1"), [false; 3]);
        compare(&same)?;
    }
}
