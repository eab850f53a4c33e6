//! Elementary functions over intervals: arguments are made small by exact laws, then a Taylor series is summed and its remainder added.

use std::sync::LazyLock;

use num_integer::Integer;
use num_traits::{One, Signed, ToPrimitive, Zero};

use super::{Interval, PI};
use crate::algebra::{BigInt, BigRational, Function};

/// Beyond this an exponential is out of all proportion.
const LARGEST_EXPONENT: i32 = 4096;
/// More quarter turns are not counted, for what is known of π would not tell them apart.
const MOST_TURNS: u64 = 1 << 32;

static LN_2: LazyLock<Interval> = LazyLock::new(|| near_one(&whole(2)));

/// The values of a function; nothing where it may have none, or its argument is out of all proportion.
pub(super) fn call(function: Function, argument: &Interval) -> Option<Interval> {
    let rising = |of: fn(&BigRational) -> Option<Interval>| {
        let (low, high) = (of(&argument.low)?, of(&argument.high)?);
        Interval::new(low.low, high.high)
    };
    match function {
        Function::Sin => sine(argument),
        Function::Cos => sine(&(argument + &quarter())),
        Function::Tan => sine(argument)?.over(&sine(&(argument + &quarter()))?),
        Function::ArcSin => rising(arcsine),
        Function::ArcCos => Some(&quarter() - &rising(arcsine)?),
        Function::ArcTan => rising(arctangent),
        Function::Exp => rising(exponential),
        Function::Ln => rising(logarithm),
        Function::Abs => Some(argument.abs()),
        Function::Ceiling => rising(|x| Some(Interval::exactly(x.ceil()))),
        Function::Floor => rising(|x| Some(Interval::exactly(x.floor()))),
    }
}

fn whole(number: i64) -> BigRational {
    BigRational::from_integer(number.into())
}

/// `π/2`.
fn quarter() -> Interval {
    &*PI * &Interval::exactly(whole(2).recip())
}

/// All that is no further than `distance` from an interval.
fn widened(around: &Interval, distance: &BigRational) -> Interval {
    Interval {
        low: &around.low - distance,
        high: &around.high + distance,
    }
    .trimmed()
}

/// `a₀ + x (a₁ + x (a₂ + …))`.
fn horner(x: &Interval, coefficients: &[BigRational]) -> Interval {
    let zero = Interval::exactly(BigRational::zero());
    let mut rest = coefficients.iter().rev();
    let last = rest.next().cloned().map_or(zero, Interval::exactly);
    rest.fold(last, |sum, own| {
        &Interval::exactly(own.clone()) + &(x * &sum)
    })
}

/// `eˣ`: `x` is halved until it is small, and the result squared as often.
fn exponential(x: &BigRational) -> Option<Interval> {
    if x.is_negative() {
        return exponential(&-x)?.recip();
    }
    if *x > whole(LARGEST_EXPONENT.into()) {
        return None;
    }
    let halvings = x.to_integer().bits() + 2;
    let small = x / BigRational::from_integer(BigInt::one() << halvings);
    // The remainder after `x¹²/12!` is below `2 x¹³/13!`, for `e^(1/4) < 2`.
    let mut factorial = BigRational::one();
    let mut coefficients = vec![BigRational::one()];
    for n in 1..=12 {
        factorial /= whole(n);
        coefficients.push(factorial.clone());
    }
    let small = Interval::exactly(small).trimmed();
    let remainder = small.high.pow(13) * factorial * whole(2) / whole(13);
    let mut value = widened(&horner(&small, &coefficients), &remainder);
    for _ in 0..halvings {
        value = &value * &value;
    }
    Some(value)
}

/// `ln x`: powers of 2 are taken out.
fn logarithm(x: &BigRational) -> Option<Interval> {
    if !x.is_positive() {
        return None;
    }
    let (over, under) = (x.numer().bits(), x.denom().bits());
    let doublings = i64::try_from(over).ok()? - i64::try_from(under).ok()?;
    let scale = BigRational::from_integer(BigInt::one() << doublings.unsigned_abs());
    let rest = match doublings.is_negative() {
        true => x * scale,
        false => x / scale,
    };
    let doublings = Interval::exactly(whole(doublings));
    Some(&near_one(&rest) + &(&doublings * &LN_2))
}

/// `ln x = 2 artanh t` with `t = (x − 1)/(x + 1)`, for `1/2 ≤ x ≤ 2`.
fn near_one(x: &BigRational) -> Interval {
    let t = (x - BigRational::one()) / (x + BigRational::one());
    let t = Interval::exactly(t).trimmed();
    let square = (&t * &t).abs();
    // The remainder after `t²⁹/29` is below `t³¹/31 · 9/8`, for `|t| ≤ 1/3`.
    let coefficients: Vec<BigRational> = (0..15).map(|n| whole(2 * n + 1).recip()).collect();
    let remainder = square.high.pow(15) * whole(9) / whole(8 * 31);
    let series = widened(&horner(&square, &coefficients), &remainder);
    &(&t * &series) * &Interval::exactly(whole(2))
}

/// The sine of what is not much wider than a turn; it is within 1 of 0 in any case.
fn sine(x: &Interval) -> Option<Interval> {
    let all = Interval {
        low: -BigRational::one(),
        high: BigRational::one(),
    };
    let middle = (&x.low + &x.high) / whole(2);
    let turns = (middle * whole(2) / &PI.low).round().to_integer();
    turns.abs().to_u64().filter(|turns| *turns < MOST_TURNS)?;
    let whole_turns = Interval::exactly(BigRational::from_integer(turns.clone()));
    let rest = x - &(&whole_turns * &quarter());
    let middle = (&rest.low + &rest.high) / whole(2);
    let half = (&rest.high - &rest.low) / whole(2);
    if half > BigRational::one() {
        return Some(all);
    }
    let middle = Interval::exactly(middle).trimmed();
    let near = match turns.mod_floor(&4.into()).to_u8() {
        Some(0) => small_sine(&middle),
        Some(1) => small_cosine(&middle),
        Some(2) => -&small_sine(&middle),
        _ => -&small_cosine(&middle),
    };
    // A sine changes by no more than its argument.
    widened(&near, &half).meet(&all)
}

/// `1, −1/(a+1)(a+2), …`: the coefficients of the sine (`first` is 1) and of the cosine (0) in `x²`.
fn alternating(first: i64) -> Vec<BigRational> {
    let mut coefficients = vec![BigRational::one()];
    let mut own = BigRational::one();
    for n in 0..8 {
        let at = first + 2 * n;
        own = -own / whole((at + 1) * (at + 2));
        coefficients.push(own.clone());
    }
    coefficients
}

/// The sine for `|x| < 1`: the terms alternate and become smaller, so what is left out is less than `x¹⁹/19!`, below `2⁻⁵⁶ |x|`.
fn small_sine(x: &Interval) -> Interval {
    let square = (x * x).abs();
    let series = horner(&square, &alternating(1));
    x * &widened(&series, &BigRational::new(1.into(), BigInt::one() << 56_u8))
}

/// The cosine for `|x| < 1`: likewise, `x¹⁸/18!` is below `2⁻⁵²`.
fn small_cosine(x: &Interval) -> Interval {
    let square = (x * x).abs();
    let series = horner(&square, &alternating(0));
    widened(&series, &BigRational::new(1.into(), BigInt::one() << 52_u8))
}

/// `arctan x`: what is beyond 1 is turned over, and the angle halved twice.
fn arctangent(x: &BigRational) -> Option<Interval> {
    if x.is_negative() {
        return Some(-&arctangent(&-x)?);
    }
    if *x > BigRational::one() {
        return Some(&quarter() - &arctangent(&x.recip())?);
    }
    let one = Interval::exactly(BigRational::one());
    let half = BigRational::new(1.into(), 2.into());
    let mut t = Interval::exactly(x.clone()).trimmed();
    for _ in 0..2 {
        // `tan(a/2) = tan a / (1 + √(1 + tan² a))`
        let root = (&one + &(&t * &t)).power(&half)?;
        t = t.over(&(&one + &root))?;
    }
    // `|t| ≤ tan(π/16) < 1/5`, and the terms alternate: what is left out is less than `t²¹/21`.
    let square = (&t * &t).abs();
    let coefficients: Vec<BigRational> = (0..10)
        .map(|n| whole(if n % 2 == 0 { 1 } else { -1 }) / whole(2 * n + 1))
        .collect();
    let remainder = square.high.pow(10) / whole(21);
    let series = widened(&horner(&square, &coefficients), &remainder);
    Some(&(&t * &series) * &Interval::exactly(whole(4)))
}

/// `arcsin x = arctan(x/√(1 − x²))`.
fn arcsine(x: &BigRational) -> Option<Interval> {
    let left = BigRational::one() - x * x;
    if left.is_negative() {
        return None;
    }
    if left.is_zero() {
        return Some(match x.is_negative() {
            true => -&quarter(),
            false => quarter(),
        });
    }
    let root = Interval::exactly(left).power(&BigRational::new(1.into(), 2.into()))?;
    let tangent = Interval::exactly(x.clone()).over(&root)?;
    Interval::new(
        arctangent(&tangent.low)?.low,
        arctangent(&tangent.high)?.high,
    )
}
