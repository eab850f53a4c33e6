//! Systems with known irrational solutions, drawn at random: what is true at every solution is never refuted, and what
//! is broken in one place is, at a point that plain numbers confirm.

use cradle_verify::algebra::{BigRational, Expr, Formula, Relation, Symbol};
use cradle_verify::kernel::{Assignment, Claim, Domain, Hypothesis, Standing};
use cradle_verify::search::{Decision, decide};
use cradle_verify::sorted::Map;
use num_traits::ToPrimitive;
use proptest::prelude::*;

fn power(name: &str, exponent: usize) -> Expr {
    Expr::Power(Expr::symbol(name).into(), Expr::integer(exponent).into())
}

/// `Σ c_k x^k`, the constant coefficient first.
fn polynomial(coefficients: &[i64]) -> Expr {
    let terms = coefficients.iter().enumerate();
    let terms = terms.map(|(k, &c)| Expr::Product([Expr::integer(c), power("x", k)].into()));
    Expr::Sum(terms.collect())
}

fn at(coefficients: &[i64], x: f64) -> f64 {
    let terms = coefficients.iter().rev();
    terms.fold(0.0, |sum, &c| sum * x + c.to_f64().unwrap())
}

fn claim(premises: Vec<Formula>, goal: Formula, domain: Option<Domain>) -> Claim {
    let assumed = |formula: Formula| Hypothesis {
        formula: formula.into(),
        standing: Standing::Identity,
    };
    Claim {
        domains: domain.map(|d| (Symbol::new("x"), d)).into_iter().collect(),
        sequences: Map::new(),
        hypotheses: premises.into_iter().map(assumed).collect(),
        goal,
    }
}

fn is_zero(coefficients: &[i64]) -> Formula {
    Formula::equal(polynomial(coefficients), Expr::integer(0))
}

/// The value of a symbol at a point, as a machine number.
fn value(point: &Assignment, name: &str) -> f64 {
    let float = |value: &BigRational| value.to_f64().unwrap();
    let symbol = Symbol::new(name);
    if let Some(value) = point.symbols.get(&symbol) {
        return float(value);
    }
    let own = point.algebraic.as_ref().expect("a root");
    let eval = |list: &[BigRational], x: f64| {
        let terms = list.iter().rev();
        terms.fold(0.0, |sum, c| sum * x + float(c))
    };
    let (mut low, mut high) = (float(&own.low), float(&own.high));
    let rising = eval(&own.polynomial, high) > 0.0;
    for _ in 0..80 {
        let middle = (low + high) / 2.0;
        match (eval(&own.polynomial, middle) > 0.0) == rising {
            true => high = middle,
            false => low = middle,
        }
    }
    eval(&own.symbols[&symbol], low)
}

fn has_rational_root(coefficients: &[i64]) -> bool {
    // The coefficients are small and the leading one is 1: the root would be a whole number.
    let value = |x: i64| coefficients.iter().rev().fold(0, |sum, c| sum * x + c);
    (-40..=40).any(|x| value(x) == 0)
}

fn quadratic() -> impl Strategy<Value = [i64; 3]> {
    let drawn = (-9_i64..10, -9_i64..10).prop_map(|(c, b)| [c, b, 1]);
    drawn.prop_filter("two irrational roots", |p| {
        p[1] * p[1] > 4 * p[0] && !has_rational_root(p)
    })
}

fn cubic() -> impl Strategy<Value = [i64; 4]> {
    let drawn = (-7_i64..8, -7_i64..8, -4_i64..5).prop_map(|(d, c, b)| [d, c, b, 1]);
    drawn.prop_filter("irrational roots", |p| !has_rational_root(p))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 32, ..ProptestConfig::default() })]

    /// `y = m x + n` at a root of `x² + b x + c`: `y² = (2 m n − m² b) x + n² − m² c`.
    #[test]
    fn square_of_an_irrational_number_is_known(p in quadratic(), m in 1_i64..5, n in -5_i64..6, off in 1_i64..4) {
        let [c, b, _] = p;
        let y = Formula::equal(Expr::symbol("y"), polynomial(&[n, m]));
        let square = |off: i64| {
            let right = polynomial(&[n * n - m * m * c + off, 2 * m * n - m * m * b]);
            Formula::equal(power("y", 2), right)
        };
        let premises = || vec![is_zero(&p), y.clone()];
        let right = decide(claim(premises(), square(0), None), &[]);
        prop_assert!(matches!(right, Decision::Proven { .. }), "{right:?}");
        let broken = decide(claim(premises(), square(off), None), &[]);
        let Decision::Refuted(refuted) = broken else {
            return Err(TestCaseError::fail(format!("{p:?}: {broken:?}")));
        };
        let x = value(refuted.witness(), "x");
        prop_assert!(at(&p, x).abs() < 1e-6);
    }

    /// `x⁴` at a root of `x³ + b x² + c x + d`.
    #[test]
    fn power_of_a_cubic_root_is_known(p in cubic(), place in 0_usize..3, off in 1_i64..4) {
        let [d, c, b, _] = p;
        let mut fourth = [b * d, b * c - d, b * b - c];
        let goal = |right: &[i64]| Formula::equal(power("x", 4), polynomial(right));
        let right = decide(claim(vec![is_zero(&p)], goal(&fourth), None), &[]);
        prop_assert!(matches!(right, Decision::Proven { .. }), "{right:?}");
        fourth[place] += off;
        let broken = decide(claim(vec![is_zero(&p)], goal(&fourth), None), &[]);
        let Decision::Refuted(refuted) = broken else {
            return Err(TestCaseError::fail(format!("{p:?}: {broken:?}")));
        };
        let x = value(refuted.witness(), "x");
        prop_assert!(at(&p, x).abs() < 1e-6);
        prop_assert!((x.powi(4) - at(&fourth, x)).abs() > 1e-9);
    }

    /// Between whole numbers that enclose the greater root alone, the other is never the witness.
    #[test]
    fn domain_picks_a_root(p in quadratic()) {
        let roots = (p[1] * p[1] - 4 * p[0]).to_f64().unwrap().sqrt();
        let greater = (roots - p[1].to_f64().unwrap()) / 2.0;
        let low = greater.floor();
        prop_assume!(greater - roots < low);
        let number = |value: f64| BigRational::from_integer((value as i64).into());
        let domain = || Domain { lower: Some((number(low), true)), ..Domain::default() };
        let compared = |relation, bound: f64| Formula::Relation {
            left: Expr::symbol("x"),
            relation,
            right: Expr::Number(number(bound)),
        };
        let says = |formula| decide(claim(vec![is_zero(&p)], formula, Some(domain())), &[]);
        for relation in [Relation::Less, Relation::LessOrEqual, Relation::NotEqual] {
            let right = says(compared(relation, low + 1.0));
            prop_assert!(!matches!(right, Decision::Refuted(_)), "{p:?}: {right:?}");
        }
        for (relation, bound) in [(Relation::Less, low), (Relation::Greater, low + 1.0), (Relation::Equal, low + 1.0)] {
            let wrong = says(compared(relation, bound));
            let Decision::Refuted(refuted) = wrong else {
                return Err(TestCaseError::fail(format!("{p:?} {relation:?}: {wrong:?}")));
            };
            prop_assert!((value(refuted.witness(), "x") - greater).abs() < 1e-6);
        }
    }

    /// `x² + y² = n`, where n is no sum of two rational squares: any point has an irrational value.
    #[test]
    fn circle_without_rational_points(n in prop::sample::select(vec![3_i64, 6, 7, 11, 12, 14, 15, 19])) {
        let circle = Formula::equal(Expr::Sum([power("x", 2), power("y", 2)].into()), Expr::integer(n));
        let goal = Formula::equal(Expr::symbol("x"), Expr::symbol("y"));
        let decided = decide(claim(vec![circle], goal, None), &[]);
        let Decision::Refuted(refuted) = decided else {
            return Err(TestCaseError::fail(format!("{n}: {decided:?}")));
        };
        let (x, y) = (value(refuted.witness(), "x"), value(refuted.witness(), "y"));
        prop_assert!((x * x + y * y - n.to_f64().unwrap()).abs() < 1e-6 && (x - y).abs() > 1e-9);
        let rational = |name| refuted.witness().symbols.get(&Symbol::new(name));
        prop_assert!(rational("x").is_none() || rational("y").is_none());
    }
}
