use std::cmp::Ordering;
use std::fmt;
use std::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};

use num_integer::Integer;
use num_traits::Signed;

use super::effort::spend;
use super::residue::{PRIME, inverse, times};
use super::{BigInt, BigRational};

/// An exact rational number: two machine integers while they suffice, a [`BigRational`] beyond.
///
/// Canonical: in lowest terms with a positive denominator, and small whenever it fits, so that equality is
/// equality of representations. The coefficients of a derivation nearly always fit, and then an operation
/// allocates nothing.
#[derive(PartialEq, Eq, Hash)]
pub struct Rational(Form);

#[derive(PartialEq, Eq, Hash)]
enum Form {
    /// Numerator and denominator; the numerator is never `i64::MIN`.
    Small(i64, i64),
    Big(Box<BigRational>),
}

/// What is small is copied in place: only for the rest is anything called.
impl Clone for Rational {
    #[inline]
    fn clone(&self) -> Self {
        match &self.0 {
            Form::Small(n, d) => Rational::small(*n, *d),
            Form::Big(value) => Rational::copied(value),
        }
    }
}

impl Rational {
    #[inline]
    fn small(numerator: i64, denominator: i64) -> Self {
        Rational(Form::Small(numerator, denominator))
    }

    #[cold]
    fn copied(value: &BigRational) -> Self {
        Rational(Form::Big(value.clone().into()))
    }

    /// From parts that need not be in lowest terms; the denominator is positive.
    fn reduced(numerator: i128, denominator: i128) -> Self {
        if denominator == 1 {
            return Rational::whole(numerator);
        }
        // Most parts fit in a machine word before they are reduced.
        if let (Ok(n), Ok(d)) = (i64::try_from(numerator), i64::try_from(denominator))
            && n != i64::MIN
        {
            let gcd = n.gcd(&d);
            return Rational::small(n / gcd, d / gcd);
        }
        let gcd = gcd(numerator.unsigned_abs(), denominator.unsigned_abs());
        // A gcd of numbers below 2^127 is below 2^127.
        let (n, d) = match i128::try_from(gcd) {
            Ok(gcd) if gcd > 1 => (numerator / gcd, denominator / gcd),
            _ => (numerator, denominator),
        };
        match (i64::try_from(n), i64::try_from(d)) {
            (Ok(n), Ok(d)) if n != i64::MIN => Rational::small(n, d),
            _ => Rational(Form::Big(BigRational::new_raw(n.into(), d.into()).into())),
        }
    }

    fn whole(value: i128) -> Self {
        match i64::try_from(value) {
            Ok(value) if value != i64::MIN => Rational::small(value, 1),
            _ => Rational(Form::Big(BigRational::from_integer(value.into()).into())),
        }
    }

    fn from_big(value: BigRational) -> Self {
        Rational::if_small(&value).unwrap_or_else(|| Rational(Form::Big(value.into())))
    }

    /// The same number where it is small.
    pub(super) fn if_small(value: &BigRational) -> Option<Self> {
        let (n, d) = (
            value.numer().try_into().ok()?,
            value.denom().try_into().ok()?,
        );
        (n != i64::MIN).then(|| Rational::small(n, d))
    }

    /// As a [`BigRational`].
    pub fn to_big(&self) -> BigRational {
        match &self.0 {
            Form::Small(n, d) => BigRational::new_raw((*n).into(), (*d).into()),
            Form::Big(value) => (**value).clone(),
        }
    }

    /// 0.
    #[inline]
    pub fn zero() -> Self {
        Rational::small(0, 1)
    }

    /// 1.
    #[inline]
    pub fn one() -> Self {
        Rational::small(1, 1)
    }

    /// `numerator / denominator`; the denominator is not 0.
    pub fn ratio(numerator: i32, denominator: i32) -> Self {
        match denominator < 0 {
            true => Rational::reduced(-i128::from(numerator), -i128::from(denominator)),
            false => Rational::reduced(numerator.into(), denominator.into()),
        }
    }

    /// Whether this is 0.
    #[inline]
    pub fn is_zero(&self) -> bool {
        matches!(self.0, Form::Small(0, _))
    }

    /// Whether this is 1.
    pub fn is_one(&self) -> bool {
        matches!(self.0, Form::Small(1, 1))
    }

    /// Whether this is an integer.
    pub fn is_integer(&self) -> bool {
        match &self.0 {
            Form::Small(_, d) => *d == 1,
            Form::Big(value) => value.is_integer(),
        }
    }

    /// As a natural number, where it is one that is not too large.
    pub fn to_u32(&self) -> Option<u32> {
        match &self.0 {
            Form::Small(n, 1) => u32::try_from(*n).ok(),
            // What does not fit in a machine word is no such number.
            _ => None,
        }
    }

    /// Whether this is greater than 0.
    pub fn is_positive(&self) -> bool {
        match &self.0 {
            Form::Small(n, _) => *n > 0,
            Form::Big(value) => value.is_positive(),
        }
    }

    /// Whether this is less than 0.
    pub fn is_negative(&self) -> bool {
        !self.is_zero() && !self.is_positive()
    }

    /// The absolute value.
    pub fn abs(&self) -> Self {
        match self.is_negative() {
            true => -self,
            false => self.clone(),
        }
    }

    /// `1 / self`.
    ///
    /// # Panics
    /// For 0, as division of machine integers does.
    pub fn recip(&self) -> Self {
        match &self.0 {
            Form::Small(0, _) => panic!("division by zero"),
            Form::Small(n, d) if *n > 0 => Rational::small(*d, *n),
            Form::Small(n, d) => Rational::small(-*d, -*n),
            Form::Big(value) => Rational::from_big(value.recip()),
        }
    }

    /// The numerator.
    pub fn numer(&self) -> BigInt {
        match &self.0 {
            Form::Small(n, _) => (*n).into(),
            Form::Big(value) => value.numer().clone(),
        }
    }

    /// The denominator, which is positive.
    pub fn denom(&self) -> BigInt {
        match &self.0 {
            Form::Small(_, d) => (*d).into(),
            Form::Big(value) => value.denom().clone(),
        }
    }

    /// The residue modulo [`PRIME`]; `None` where that divides the denominator.
    pub(super) fn residue(&self) -> Option<u64> {
        let small = |own: i64| u64::try_from(i128::from(own).rem_euclid(PRIME.into())).ok();
        let big = |own: &BigInt| u64::try_from(own.mod_floor(&PRIME.into())).ok();
        let (n, d) = match &self.0 {
            Form::Small(n, d) => (small(*n)?, small(*d)?),
            Form::Big(value) => (big(value.numer())?, big(value.denom())?),
        };
        (d != 0).then(|| times(n, inverse(d)))
    }

    /// The power, unless it would be longer than `bits`.
    pub(super) fn pow(&self, exponent: u32, bits: u64) -> Option<Self> {
        if exponent == 1 && matches!(self.0, Form::Small(..)) {
            return Some(self.clone());
        }
        if matches!(self.0, Form::Small(-1..=1, 1)) {
            return Some(match exponent {
                0 => Rational::one(),
                _ if exponent % 2 == 1 || self.is_zero() => self.clone(),
                _ => Rational::one(),
            });
        }
        // What fits in 64 bits is a power of at most 63 at this point, and far from any bound.
        if let Form::Small(n, d) = &self.0
            && bits >= 1 << 12
            && let (Some(n), Some(d)) = (n.checked_pow(exponent), d.checked_pow(exponent))
            && n != i64::MIN
        {
            return Some(Rational::small(n, d));
        }
        let big = self.to_big();
        let length = big.numer().bits().max(big.denom().bits());
        if length.saturating_mul(exponent.into()) > bits {
            return None;
        }
        // Both parts are powers of coprime numbers, so nothing is left to reduce.
        let (n, d) = (big.numer().pow(exponent), big.denom().pow(exponent));
        Some(Rational::from_big(BigRational::new_raw(n, d)))
    }
}

/// Takes off the budget what an operation on long numbers costs: a gcd takes a step for each bit.
fn counted(a: &BigRational, b: &BigRational) {
    let bits = |x: &BigRational| x.numer().bits().saturating_add(x.denom().bits());
    let bits = bits(a).max(bits(b));
    let words = bits / 64 + 1;
    let units = match a.is_integer() && b.is_integer() {
        true => words,
        false => bits.saturating_mul(words) / 8,
    };
    spend(usize::try_from(units).unwrap_or(usize::MAX));
}

/// Binary for what fits in a machine word, Euclid's to get there.
fn gcd(mut a: u128, mut b: u128) -> u128 {
    loop {
        match (u64::try_from(a), u64::try_from(b)) {
            (Ok(a), Ok(b)) => return a.gcd(&b).into(),
            _ if b == 0 => return a,
            _ => (a, b) = (b, a % b),
        }
    }
}

impl From<BigRational> for Rational {
    fn from(value: BigRational) -> Self {
        Rational::from_big(value)
    }
}

impl From<&BigRational> for Rational {
    fn from(value: &BigRational) -> Self {
        Rational::if_small(value).unwrap_or_else(|| Rational(Form::Big(value.clone().into())))
    }
}

impl From<Rational> for BigRational {
    fn from(value: Rational) -> Self {
        value.to_big()
    }
}

impl From<u64> for Rational {
    fn from(value: u64) -> Self {
        match i64::try_from(value) {
            Ok(value) => Rational::small(value, 1),
            Err(_) => Rational::from(BigInt::from(value)),
        }
    }
}

impl From<u32> for Rational {
    fn from(value: u32) -> Self {
        Rational::small(value.into(), 1)
    }
}

impl From<i32> for Rational {
    fn from(value: i32) -> Self {
        Rational::small(value.into(), 1)
    }
}

impl From<BigInt> for Rational {
    fn from(value: BigInt) -> Self {
        Rational::from_big(BigRational::from_integer(value))
    }
}

impl Ord for Rational {
    fn cmp(&self, other: &Self) -> Ordering {
        match (&self.0, &other.0) {
            (Form::Small(a, b), Form::Small(c, d)) => {
                (i128::from(*a) * i128::from(*d)).cmp(&(i128::from(*c) * i128::from(*b)))
            }
            _ => self.to_big().cmp(&other.to_big()),
        }
    }
}

impl PartialOrd for Rational {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Add for &Rational {
    type Output = Rational;
    #[inline]
    fn add(self, other: &Rational) -> Rational {
        // Most numbers are integers: their sums take no call.
        if let (Form::Small(a, 1), Form::Small(c, 1)) = (&self.0, &other.0)
            && let Some(sum) = a.checked_add(*c).filter(|sum| *sum != i64::MIN)
        {
            return Rational::small(sum, 1);
        }
        sum(self, other)
    }
}

impl Mul for &Rational {
    type Output = Rational;
    #[inline]
    fn mul(self, other: &Rational) -> Rational {
        if let (Form::Small(a, 1), Form::Small(c, 1)) = (&self.0, &other.0)
            && let Some(product) = a.checked_mul(*c).filter(|product| *product != i64::MIN)
        {
            return Rational::small(product, 1);
        }
        product(self, other)
    }
}

/// The sum of any two numbers.
fn sum(a: &Rational, b: &Rational) -> Rational {
    match (&a.0, &b.0) {
        // Nothing to reduce.
        (Form::Small(0, _), Form::Small(..)) => b.clone(),
        (Form::Small(..), Form::Small(0, _)) => a.clone(),
        // Below 2^126 each, so below 2^127 together.
        (Form::Small(a, b), Form::Small(c, d)) => {
            let (a, b, c, d) = (
                i128::from(*a),
                i128::from(*b),
                i128::from(*c),
                i128::from(*d),
            );
            Rational::reduced(a * d + c * b, b * d)
        }
        _ => sum_of_big(&a.to_big(), &b.to_big()),
    }
}

#[cold]
fn sum_of_big(a: &BigRational, b: &BigRational) -> Rational {
    counted(a, b);
    // What num-rational does for integers is a gcd with 1, which takes a step for every bit.
    match a.is_integer() && b.is_integer() {
        true => Rational::from(a.numer() + b.numer()),
        false => Rational::from_big(a + b),
    }
}

/// The product of any two numbers.
fn product(a: &Rational, b: &Rational) -> Rational {
    match (&a.0, &b.0) {
        (Form::Small(1, 1), _) => b.clone(),
        (_, Form::Small(1, 1)) => a.clone(),
        (Form::Small(-1, 1), Form::Small(n, d)) | (Form::Small(n, d), Form::Small(-1, 1)) => {
            Rational::small(-n, *d)
        }
        (Form::Small(a, b), Form::Small(c, d)) => Rational::reduced(
            i128::from(*a) * i128::from(*c),
            i128::from(*b) * i128::from(*d),
        ),
        _ => product_of_big(&a.to_big(), &b.to_big()),
    }
}

/// In lowest terms once each numerator has nothing in common with the other denominator: num-rational looks for more, which is
/// most of its work.
#[cold]
fn product_of_big(a: &BigRational, b: &BigRational) -> Rational {
    counted(a, b);
    if a.is_integer() && b.is_integer() {
        return Rational::from(a.numer() * b.numer());
    }
    let (first, second) = (a.numer().gcd(b.denom()), b.numer().gcd(a.denom()));
    let over = (a.numer() / &first) * (b.numer() / &second);
    let under = (a.denom() / second) * (b.denom() / first);
    Rational::from_big(BigRational::new_raw(over, under))
}

impl Neg for &Rational {
    type Output = Rational;
    fn neg(self) -> Rational {
        match &self.0 {
            Form::Small(n, d) => Rational::small(-n, *d),
            Form::Big(value) => Rational::from_big(-(**value).clone()),
        }
    }
}

impl Sub for &Rational {
    type Output = Rational;
    fn sub(self, other: &Rational) -> Rational {
        self + &-other
    }
}

impl Div for &Rational {
    type Output = Rational;
    fn div(self, other: &Rational) -> Rational {
        Mul::mul(self, &other.recip())
    }
}

/// The same with owned operands.
macro_rules! owned {
    ($($trait:ident $method:ident),*) => {$(
        impl $trait for Rational {
            type Output = Rational;
            fn $method(self, other: Rational) -> Rational {
                (&self).$method(&other)
            }
        }
        impl $trait<&Rational> for Rational {
            type Output = Rational;
            fn $method(self, other: &Rational) -> Rational {
                (&self).$method(other)
            }
        }
        impl $trait<Rational> for &Rational {
            type Output = Rational;
            fn $method(self, other: Rational) -> Rational {
                self.$method(&other)
            }
        }
    )*};
}

owned!(Add add, Sub sub, Mul mul, Div div);

impl Neg for Rational {
    type Output = Rational;
    fn neg(self) -> Rational {
        -&self
    }
}

impl AddAssign<&Rational> for Rational {
    #[inline]
    fn add_assign(&mut self, other: &Rational) {
        *self = &*self + other;
    }
}

impl AddAssign for Rational {
    #[inline]
    fn add_assign(&mut self, other: Rational) {
        *self += &other;
    }
}

impl SubAssign<&Rational> for Rational {
    fn sub_assign(&mut self, other: &Rational) {
        *self = &*self - other;
    }
}

impl SubAssign for Rational {
    fn sub_assign(&mut self, other: Rational) {
        *self -= &other;
    }
}

impl MulAssign<&Rational> for Rational {
    #[inline]
    fn mul_assign(&mut self, other: &Rational) {
        *self = &*self * other;
    }
}

impl MulAssign for Rational {
    #[inline]
    fn mul_assign(&mut self, other: Rational) {
        *self *= &other;
    }
}

impl fmt::Display for Rational {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.0 {
            Form::Small(n, 1) => write!(f, "{n}"),
            Form::Small(n, d) => write!(f, "{n}/{d}"),
            Form::Big(value) => value.fmt(f),
        }
    }
}

impl fmt::Debug for Rational {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}
