//! The exact algebra against second opinions: `BigRational`, evaluation at points, and a naive evaluator of terms.

mod effort;

use std::collections::hash_map::DefaultHasher;
use std::hash::{Hash, Hasher};

use cradle_verify::algebra::{
    Atom, Atoms, BigInt, BigRational, EvaluateError, Expr, Fraction, Lowering, Monomial,
    Polynomial, Rational, Symbol, Values, Var,
};
use cradle_verify::document::Span;
use cradle_verify::notation::read_expr;
use cradle_verify::sorted::{Map, Set};
use num_traits::{One, Pow, Signed, Zero};
use proptest::prelude::*;

fn hash(value: &impl Hash) -> u64 {
    let mut hasher = DefaultHasher::new();
    value.hash(&mut hasher);
    hasher.finish()
}

/// Every operation on two numbers, against `BigRational`.
fn agree(a: &BigRational, b: &BigRational) {
    let (x, y) = (Rational::from(a), Rational::from(b));
    assert_eq!(x.to_big(), *a);
    assert_eq!(Rational::from(a.clone()), x);
    let same = |ours: Rational, theirs: BigRational, what: &str| {
        assert_eq!(ours.to_big(), theirs, "{a} {what} {b}");
        // Canonical: equality, hash and the questions depend on the value alone.
        let fresh = Rational::from(theirs.clone());
        assert_eq!(ours, fresh, "{a} {what} {b}");
        assert_eq!(hash(&ours), hash(&fresh), "{a} {what} {b}");
        assert_eq!(ours.to_string(), theirs.to_string());
        assert_eq!(ours.is_zero(), theirs.is_zero());
        assert_eq!(ours.is_one(), theirs.is_one());
        assert_eq!(ours.is_integer(), theirs.is_integer());
        assert_eq!(ours.is_positive(), theirs.is_positive());
        assert_eq!(ours.is_negative(), theirs.is_negative());
        assert_eq!(ours.numer(), *theirs.numer());
        assert_eq!(ours.denom(), *theirs.denom());
        assert!(ours.to_big().denom().is_positive());
    };
    same(&x + &y, a + b, "+");
    same(&x - &y, a - b, "-");
    same(&x * &y, a * b, "*");
    same(-&x, -a, "negated");
    same(x.abs(), a.abs(), "abs");
    if !b.is_zero() {
        same(&x / &y, a / b, "/");
        same(y.recip(), b.recip(), "recip");
    }
    let mut sum = x.clone();
    sum += &y;
    same(sum, a + b, "+=");
    let mut difference = x.clone();
    difference -= &y;
    same(difference, a - b, "-=");
    let mut product = x.clone();
    product *= &y;
    same(product, a * b, "*=");
    assert_eq!(x.cmp(&y), a.cmp(b), "{a} <=> {b}");
    assert_eq!(x == y, a == b);
    if x == y {
        assert_eq!(hash(&x), hash(&y));
    }
}

/// Integers around 0 and around everything that a machine integer could stumble over.
fn boundary_integers() -> Vec<BigInt> {
    let centres: [i128; 9] = [
        0,
        i64::MAX.into(),
        i64::MIN.into(),
        u64::MAX.into(),
        -i128::from(u64::MAX),
        1 << 32,
        // ⌊√(2^63)⌋
        3_037_000_499,
        -3_037_000_499,
        i128::MAX - 2,
    ];
    let around = |centre: i128| (-1..=1).map(move |d| BigInt::from(centre + d));
    centres.into_iter().flat_map(around).collect()
}

#[test]
fn rationals_agree_with_bigrational_at_the_limits_of_machine_integers() {
    let integers = boundary_integers();
    let mut values: Set<BigRational> = Set::new();
    for n in &integers {
        values.insert(BigRational::from_integer(n.clone()));
        if !n.is_zero() {
            values.insert(BigRational::new(BigInt::one(), n.clone()));
            values.insert(BigRational::new(BigInt::from(i64::MAX), n.clone()));
            values.insert(BigRational::new(n.clone(), BigInt::from(i64::MAX)));
            values.insert(BigRational::new(n.clone(), BigInt::from(6)));
        }
    }
    for a in &values {
        for b in &values {
            agree(a, b);
        }
    }
}

#[test]
fn sums_that_come_back_from_beyond_the_limit_are_small_again() {
    let limit = Rational::from(BigInt::from(i64::MAX));
    let beyond = &limit + &Rational::one();
    let back = &beyond - &Rational::one();
    assert_eq!(back, limit);
    assert_eq!(hash(&back), hash(&limit));
    let least = -&beyond;
    assert_eq!(least.numer(), BigInt::from(i64::MIN));
    assert_eq!(-&least, beyond);
    assert_eq!(least.recip().recip(), least);
}

#[test]
fn ratio_is_in_lowest_terms_with_a_positive_denominator() {
    for n in [i32::MIN, -6, -1, 0, 1, 4, i32::MAX] {
        for d in [i32::MIN, -6, -1, 1, 4, i32::MAX] {
            let expected = BigRational::new(n.into(), d.into());
            assert_eq!(Rational::ratio(n, d).to_big(), expected);
            assert_eq!(Rational::ratio(n, d), Rational::from(expected));
        }
    }
}

fn big() -> impl Strategy<Value = BigRational> {
    let part = prop_oneof![
        any::<i8>().prop_map(BigInt::from),
        any::<i64>().prop_map(BigInt::from),
        (i64::MAX - 3..=i64::MAX).prop_map(BigInt::from),
        (i64::MIN..=i64::MIN + 3).prop_map(BigInt::from),
        any::<i128>().prop_map(BigInt::from),
    ];
    (part.clone(), part).prop_map(|(n, d)| match d.is_zero() {
        true => BigRational::from_integer(n),
        false => BigRational::new(n, d),
    })
}

fn vars() -> [Var; 3] {
    let mut atoms = Atoms::default();
    ["x", "y", "z"].map(|name| atoms.var(Atom::Symbol(Symbol::new(name))))
}

fn small() -> impl Strategy<Value = Rational> {
    (-6i32..7, 1i32..5).prop_map(|(n, d)| Rational::ratio(n, d))
}

fn polynomial() -> impl Strategy<Value = Polynomial> {
    let term = (small(), [0u32..3, 0..3, 0..3]);
    prop::collection::vec(term, 0..5).prop_map(|terms| {
        let mut sum = Polynomial::zero();
        for (coefficient, exponents) in terms {
            let powers = vars().into_iter().zip(exponents);
            let monomial = powers.fold(Monomial::one(), |product, (var, exponent)| {
                product.times(&Monomial::power(var, exponent))
            });
            sum = sum.plus(&Polynomial::term(monomial, coefficient));
        }
        sum
    })
}

fn at(point: &[Rational; 3]) -> impl Fn(Var) -> Option<Rational> {
    let pairs: Map<Var, Rational> = vars().into_iter().zip(point.clone()).collect();
    move |var| pairs.get(&var).cloned()
}

fn evaluated(polynomial: &Polynomial, point: &[Rational; 3]) -> Rational {
    let value = polynomial.evaluate(at(point)).expect("small enough");
    value.expect("a value for every unknown")
}

fn fraction_at(fraction: &Fraction, point: &[Rational; 3]) -> Option<Rational> {
    let below = evaluated(
        &fraction.expanded_denominator().expect("small enough"),
        point,
    );
    (!below.is_zero()).then(|| evaluated(fraction.numerator(), point) / below)
}

fn fraction() -> impl Strategy<Value = Fraction> {
    (polynomial(), polynomial()).prop_map(|(above, below)| {
        let below = Fraction::from(below).recip().expect("small enough");
        let above = Fraction::from(above);
        match below {
            Some(below) => above.times(&below).expect("small enough"),
            None => above,
        }
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(256))]

    #[test]
    fn rationals_agree_with_bigrational(a in big(), b in big()) {
        agree(&a, &b);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn polynomials_are_a_ring(p in polynomial(), q in polynomial(), r in polynomial()) {
        let times = |a: &Polynomial, b: &Polynomial| a.times(b).expect("small enough");
        prop_assert_eq!(p.plus(&q), q.plus(&p));
        prop_assert_eq!(p.plus(&q).plus(&r), p.plus(&q.plus(&r)));
        prop_assert_eq!(p.plus(&Polynomial::zero()), p.clone());
        prop_assert_eq!(p.plus(&p.negated()), Polynomial::zero());
        prop_assert_eq!(p.minus(&q), p.plus(&q.negated()));
        prop_assert_eq!(times(&p, &q), times(&q, &p));
        prop_assert_eq!(times(&times(&p, &q), &r), times(&p, &times(&q, &r)));
        prop_assert_eq!(times(&p, &Polynomial::one()), p.clone());
        prop_assert_eq!(times(&p, &Polynomial::zero()), Polynomial::zero());
        prop_assert_eq!(times(&p, &q.plus(&r)), times(&p, &q).plus(&times(&p, &r)));
        prop_assert_eq!(p.pow(0).expect("small"), Polynomial::one());
        prop_assert_eq!(p.pow(3).expect("small"), times(&p, &times(&p, &p)));
        prop_assert_eq!(hash(&p.plus(&q)), hash(&q.plus(&p)));
        // No term of a polynomial is 0.
        prop_assert!(p.minus(&q).terms().all(|(_, c)| !c.is_zero()));
    }

    #[test]
    fn division_undoes_multiplication(p in polynomial(), q in polynomial(), r in polynomial()) {
        let product = p.times(&q).expect("small enough");
        if q.is_zero() {
            prop_assert_eq!(product.divided_by(&q), None);
        } else {
            prop_assert_eq!(product.divided_by(&q), Some(p));
        }
        // Long ones are held against a prime first.
        let sum = product.plus(&r);
        let long = sum.times(&q).expect("small enough");
        if !q.is_zero() {
            prop_assert_eq!(long.divided_by(&q), Some(sum));
        }
        if q.as_constant().is_none() {
            prop_assert_eq!(long.plus(&Polynomial::one()).divided_by(&q), None);
        }
        // What divides exactly multiplies back.
        if let Some(quotient) = r.divided_by(&q) {
            prop_assert_eq!(quotient.times(&q).expect("small enough"), r);
        }
    }

    #[test]
    fn evaluation_respects_sums_products_and_substitution(
        p in polynomial(), q in polynomial(), point in [small(), small(), small()],
    ) {
        let (a, b) = (evaluated(&p, &point), evaluated(&q, &point));
        prop_assert_eq!(evaluated(&p.plus(&q), &point), &a + &b);
        prop_assert_eq!(evaluated(&p.minus(&q), &point), &a - &b);
        prop_assert_eq!(evaluated(&p.times(&q).expect("small"), &point), &a * &b);
        prop_assert_eq!(evaluated(&p.scaled(&b), &point), &a * &b);
        for (position, var) in vars().into_iter().enumerate() {
            let mut moved = point.clone();
            moved[position] = b.clone();
            let put_in = p.substitute(var, &q).expect("small enough");
            prop_assert_eq!(evaluated(&put_in, &point), evaluated(&p, &moved));
            let powers = p.in_powers_of(var);
            let mut sum = Polynomial::zero();
            for (exponent, part) in powers.iter().enumerate() {
                prop_assert_eq!(part.degree_in(var), 0);
                sum = sum.plus(&part.times_term(&Monomial::power(var, exponent as u32), &Rational::one()));
            }
            prop_assert_eq!(sum, p.clone());
        }
    }

    #[test]
    fn derivative_obeys_the_rules_of_sums_and_products(p in polynomial(), q in polynomial()) {
        let times = |a: &Polynomial, b: &Polynomial| a.times(b).expect("small enough");
        for var in vars() {
            let (dp, dq) = (p.derivative(var), q.derivative(var));
            prop_assert_eq!(p.plus(&q).derivative(var), dp.plus(&dq));
            let product = times(&dp, &q).plus(&times(&p, &dq));
            prop_assert_eq!(times(&p, &q).derivative(var), product);
        }
    }

    /// The order of monomials is total, respects products, and has 1 at its bottom: division relies on it.
    #[test]
    fn monomials_are_ordered_compatibly_with_products(
        exponents in [[0u32..4, 0..4, 0..4], [0..4, 0..4, 0..4], [0..4, 0..4, 0..4]],
    ) {
        let [a, b, c] = exponents.map(|exponents| {
            vars().into_iter().zip(exponents).fold(Monomial::one(), |product, (var, exponent)| {
                product.times(&Monomial::power(var, exponent))
            })
        });
        prop_assert_eq!(a.cmp(&b), a.times(&c).cmp(&b.times(&c)));
        prop_assert_eq!(a.cmp(&b).is_eq(), a == b);
        prop_assert_eq!(a.cmp(&b), b.cmp(&a).reverse());
        prop_assert!(Monomial::one() <= a);
        prop_assert_eq!(a.times(&b).divided_by(&b), Some(a.clone()));
        prop_assert_eq!(a.gcd(&b).times(&a.lcm(&b)), a.times(&b));
        prop_assert_eq!(a.times(&a).sqrt(), Some(a));
    }

    #[test]
    fn fractions_agree_with_their_values(
        f in fraction(), g in fraction(), point in [small(), small(), small()], exponent in 0u32..3,
    ) {
        if let (Some(a), Some(b)) = (fraction_at(&f, &point), fraction_at(&g, &point)) {
            let value = |fraction: &Fraction| fraction_at(fraction, &point);
            prop_assert_eq!(value(&f.plus(&g).expect("small")), Some(&a + &b));
            prop_assert_eq!(value(&f.times(&g).expect("small")), Some(&a * &b));
            prop_assert_eq!(value(&f.negated()), Some(-&a));
            let power = (0..exponent).fold(Rational::one(), |product, _| &product * &a);
            prop_assert_eq!(value(&f.pow(exponent).expect("small")), Some(power));
            match f.recip().expect("small") {
                None => prop_assert!(f.is_zero()),
                Some(inverse) => if !a.is_zero() {
                    prop_assert_eq!(value(&inverse), Some(a.recip()));
                }
            }
        }
        prop_assert!(f.plus(&f.negated()).expect("small").is_zero());
        for (factor, exponent) in f.denominator() {
            prop_assert!(exponent > 0 && factor.as_constant().is_none());
            prop_assert_eq!(factor.monic(), factor.clone());
        }
    }
}

type Point = Map<Symbol, BigRational>;

/// The value of a term by the definition of each operation; `None` where it is not defined.
fn naive(expr: &Expr, at: &Point) -> Option<BigRational> {
    Some(match expr {
        Expr::Number(number) => number.clone(),
        Expr::Symbol(symbol) => at.get(symbol)?.clone(),
        Expr::Element { sequence, index } => {
            let position = at.get(index)?;
            at.get(&Symbol::new(format!("{sequence}_{position}")))?
                .clone()
        }
        Expr::Sum(terms) => {
            let mut sum = BigRational::zero();
            for term in terms.iter() {
                sum += naive(term, at)?;
            }
            sum
        }
        Expr::Product(factors) => {
            let mut product = BigRational::one();
            for factor in factors.iter() {
                product *= naive(factor, at)?;
            }
            product
        }
        Expr::Negate(inner) => -naive(inner, at)?,
        Expr::Quotient(above, below) => {
            let (above, below) = (naive(above, at)?, naive(below, at)?);
            if below.is_zero() {
                return None;
            }
            above / below
        }
        Expr::Power(base, exponent) => {
            let (base, exponent) = (naive(base, at)?, naive(exponent, at)?);
            let exponent =
                i32::try_from(exponent.is_integer().then(|| exponent.to_integer())?).ok()?;
            if base.is_zero() && exponent < 0 {
                return None;
            }
            Pow::pow(base, exponent)
        }
        Expr::Series {
            index,
            from,
            to,
            body,
        } => {
            let (from, to) = (naive(from, at)?, naive(to, at)?);
            let mut sum = BigRational::zero();
            let mut position = from;
            while position <= to {
                let mut inner = at.clone();
                inner.insert(index.clone(), position.clone());
                sum += naive(body, &inner)?;
                position += BigRational::one();
            }
            sum
        }
        _ => return None,
    })
}

fn expr() -> impl Strategy<Value = Expr> {
    let leaf = prop_oneof![
        (-4i64..5, 1i64..4).prop_map(|(n, d)| Expr::Number(BigRational::new(n.into(), d.into()))),
        prop::sample::select(vec!["x", "y", "z", "i"]).prop_map(Expr::symbol),
        prop::sample::select(vec!["i", "j"]).prop_map(|index| Expr::Element {
            sequence: Symbol::new("u"),
            index: Symbol::new(index),
        }),
    ];
    leaf.prop_recursive(4, 24, 3, |inner| {
        let several = prop::collection::vec(inner.clone(), 2..4);
        prop_oneof![
            several.clone().prop_map(|all| Expr::Sum(all.into())),
            several.prop_map(|all| Expr::Product(all.into())),
            inner.clone().prop_map(|e| Expr::Negate(e.into())),
            (inner.clone(), inner.clone()).prop_map(|(a, b)| Expr::Quotient(a.into(), b.into())),
            (inner.clone(), -2i32..4)
                .prop_map(|(a, n)| Expr::Power(a.into(), Expr::integer(n).into())),
            (
                prop::sample::select(vec!["i", "j"]),
                1i32..3,
                0i32..4,
                inner
            )
                .prop_map(|(index, from, to, body)| Expr::Series {
                    index: Symbol::new(index),
                    from: Expr::integer(from).into(),
                    to: Expr::integer(to).into(),
                    body: body.into(),
                }),
        ]
    })
}

/// The whole term under sums over both indices, so that no index is left free.
fn closed() -> impl Strategy<Value = Expr> {
    expr().prop_map(|body| {
        ["i", "j"]
            .into_iter()
            .fold(body, |body, index| Expr::Series {
                index: Symbol::new(index),
                from: Expr::integer(1).into(),
                to: Expr::integer(2).into(),
                body: body.into(),
            })
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// A term has the value that its rational function has, and is defined where no divisor noted on the way vanishes.
    #[test]
    fn lowering_keeps_the_value(
        expr in closed(),
        numbers in prop::collection::vec((-5i64..6, 1i64..4), 6),
    ) {
        let names = ["x", "y", "z", "u_1", "u_2", "u_3"];
        let values: Point = names.iter().zip(&numbers)
            .map(|(name, &(n, d))| (Symbol::new(*name), BigRational::new(n.into(), d.into())))
            .collect();
        let mut atoms = Atoms::default();
        let sequences = Set::new();
        let mut lowering = Lowering {
            sequences: &sequences,
            constants: &sequences,
            ..Lowering::plain(&mut atoms)
        };
        let expected = naive(&expr, &values);
        let Ok(fraction) = lowering.lower(&expr) else {
            // Too large, or a division by what is always 0.
            return Ok(());
        };
        let conditions = lowering.conditions;
        prop_assert!(conditions.zero.is_empty());
        let value_of = |polynomial: &Polynomial| {
            let value = polynomial.evaluate(|var| match atoms.atom(var) {
                Atom::Symbol(symbol) => values.get(symbol).map(Rational::from),
                other => panic!("{other:?} in a term without functions"),
            });
            value.expect("small enough").expect("a value for every symbol")
        };
        let defined = conditions.nonzero.iter().all(|divisor| !value_of(divisor).is_zero());
        prop_assert_eq!(defined, expected.is_some());
        if let Some(expected) = expected {
            let below = value_of(&fraction.expanded_denominator().expect("small enough"));
            prop_assert!(!below.is_zero());
            prop_assert_eq!((value_of(fraction.numerator()) / below).to_big(), expected);
        }
    }
}

#[test]
fn a_limit_has_a_value_only_where_it_is_known_to_be_one() {
    let falling = r"\lim_{x \to \infty} \exp(-k x)";
    let falling = read_expr(falling, Span::new(0, falling.len())).expect("a limit");
    let at = |rate: i64| {
        let rate = BigRational::from_integer(rate.into());
        let values = Values {
            symbols: [(Symbol::new("k"), rate)].into_iter().collect(),
            still: true,
            ..Values::default()
        };
        values.value(&falling)
    };
    assert_eq!(at(1), Ok(BigRational::zero()));
    // There it grows beyond all bounds.
    assert!(matches!(at(-1), Err(EvaluateError::Unsupported(_))));
}
