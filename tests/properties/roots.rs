//! Equations between roots and fractional powers of positive symbols, drawn at random: what the kernel accepts agrees with plain numbers,
//! and what agrees by construction is never refuted.
//!
//! The numbers here are machine numbers, at points that no proof speaks of; they stand guard over the kernel's rules, and prove nothing.

use cradle_verify::algebra::{BigRational, Expr, Formula, Relation, Symbol};
use cradle_verify::kernel::{Claim, Domain};
use cradle_verify::search::{Decision, decide};
use cradle_verify::sorted::Map;
use num_traits::{ToPrimitive, Zero};
use proptest::prelude::*;

const NAMES: [&str; 3] = ["x", "y", "d"];
/// Where terms are compared: nothing special about them.
const POINTS: [[f64; 3]; 3] = [[0.37, 2.9, 1.13], [5.3, 0.21, 0.77], [1.9, 1.2, 6.1]];

/// A term whose value is positive wherever its symbols are.
#[derive(Clone, Debug)]
enum Term {
    Number(i64),
    Symbol(usize),
    Sum(Box<Term>, Box<Term>),
    Product(Box<Term>, Box<Term>),
    Quotient(Box<Term>, Box<Term>),
    Power(Box<Term>, i64, i64),
}

use Term::*;

impl Term {
    fn written(&self) -> Expr {
        match self {
            Number(value) => Expr::integer(*value),
            Symbol(at) => Expr::symbol(NAMES[*at]),
            Sum(a, b) => Expr::Sum([a.written(), b.written()].into()),
            Product(a, b) => Expr::Product([a.written(), b.written()].into()),
            Quotient(a, b) => Expr::Quotient(a.written().into(), b.written().into()),
            Power(base, over, under) => {
                let exponent = BigRational::new((*over).into(), (*under).into());
                Expr::Power(base.written().into(), Expr::Number(exponent).into())
            }
        }
    }

    fn at(&self, point: &[f64; 3]) -> f64 {
        match self {
            Number(value) => value.to_f64().unwrap(),
            Symbol(at) => point[*at],
            Sum(a, b) => a.at(point) + b.at(point),
            Product(a, b) => a.at(point) * b.at(point),
            Quotient(a, b) => a.at(point) / b.at(point),
            Power(base, over, under) => base.at(point).powf(*over as f64 / *under as f64),
        }
    }

    /// Another way to write the same, a rule of powers used in every place where one can be.
    fn respelt(&self) -> Term {
        let boxed = |t: &Term| Box::new(t.respelt());
        match self {
            Number(_) | Symbol(_) => self.clone(),
            Sum(a, b) => Sum(boxed(b), boxed(a)),
            Product(a, b) => Product(boxed(b), boxed(a)),
            Quotient(a, b) => Product(boxed(a), Power(boxed(b), -1, 1).into()),
            Power(base, over, under) => match &**base {
                Product(a, b) => Product(
                    Power(boxed(a), *over, *under).into(),
                    Power(boxed(b), *over, *under).into(),
                ),
                Quotient(a, b) => Quotient(
                    Power(boxed(a), *over, *under).into(),
                    Power(boxed(b), *over, *under).into(),
                ),
                Power(inner, p, q) => Power(boxed(inner), over * p, under * q),
                other => Product(
                    boxed(other),
                    Power(boxed(other), over - under, *under).into(),
                ),
            },
        }
    }
}

fn agree(left: &Term, right: &Term) -> bool {
    POINTS.iter().all(|point| {
        let (a, b) = (left.at(point), right.at(point));
        (a - b).abs() <= 1e-9 * a.abs().max(b.abs())
    })
}

fn terms() -> impl Strategy<Value = Term> {
    let leaf = prop_oneof![(0..3_usize).prop_map(Symbol), (1..5_i64).prop_map(Number),];
    leaf.prop_recursive(3, 10, 2, |inner| {
        let boxed = || inner.clone().prop_map(Box::new);
        prop_oneof![
            1 => (boxed(), boxed()).prop_map(|(a, b)| Sum(a, b)),
            2 => (boxed(), boxed()).prop_map(|(a, b)| Product(a, b)),
            1 => (boxed(), boxed()).prop_map(|(a, b)| Quotient(a, b)),
            3 => (boxed(), -3..4_i64, 1..4_i64).prop_map(|(a, p, q)| Power(a, p, q)),
        ]
    })
}

fn decided(left: &Term, right: &Term) -> Decision {
    let positive = Domain {
        lower: Some((BigRational::zero(), true)),
        ..Domain::default()
    };
    let goal = Formula::Relation {
        left: left.written(),
        relation: Relation::Equal,
        right: right.written(),
    };
    let domains = NAMES.map(|name| (Symbol::new(name), positive.clone()));
    let claim = Claim {
        domains: Map::from(domains),
        sequences: Map::new(),
        hypotheses: Vec::new(),
        goal,
    };
    decide(claim, &[])
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 160, ..ProptestConfig::default() })]

    #[test]
    fn what_is_proved_of_roots_agrees_with_numbers(left in terms(), right in terms()) {
        match decided(&left, &right) {
            Decision::Proven { conditions, .. } if conditions.is_empty() => {
                prop_assert!(agree(&left, &right), "{:?} = {:?}", left.written(), right.written());
            }
            _ => {}
        }
    }

    #[test]
    fn another_spelling_of_a_power_is_never_refuted(term in terms()) {
        let other = term.respelt();
        prop_assert!(agree(&term, &other), "the rule itself: {:?}", term);
        let decision = decided(&term, &other);
        prop_assert!(!matches!(decision, Decision::Refuted(_)), "{:?}", term.written());
    }

    #[test]
    fn a_power_spelt_wrongly_is_never_proved(term in terms(), factor in 2..5_i64) {
        let wrong = Product(Number(factor).into(), term.respelt().into());
        let decision = decided(&term, &wrong);
        prop_assert!(!matches!(decision, Decision::Proven { .. }), "{:?}", term.written());
    }
}

#[test]
fn most_spellings_are_proved() {
    // Otherwise the tests above would be easily passed by deciding nothing.
    let x = || Box::new(Symbol(0));
    let y = || Box::new(Symbol(1));
    let all = [
        Power(Product(x(), y()).into(), 1, 2),
        Power(Quotient(x(), y()).into(), 3, 2),
        Power(Power(x(), 2, 1).into(), 1, 3),
        Power(x(), 5, 2),
        Quotient(x(), Power(y(), 1, 2).into()),
    ];
    for term in all {
        let decision = decided(&term, &term.respelt());
        let proven =
            matches!(&decision, Decision::Proven { conditions, .. } if conditions.is_empty());
        assert!(proven, "{term:?}: {decision:?}");
    }
}
