//! The inverse of the reader: terms as canonical LaTeX, as one line of text for a terminal, and as MathML for a browser.

mod bracketed;
mod latex;
mod mathml;
mod partial;
mod plain;
mod xml;

pub use latex::{latex, latex_formula, latex_statement, relation_latex};
pub use mathml::{mathml, mathml_formula, mathml_statement};
pub use plain::{plain, plain_formula, plain_statement, plain_symbol, unbraced};
pub use xml::{escape, escape_by};

use crate::algebra::{BigInt, BigRational};
use num_integer::Integer;
use num_traits::Signed;

/// The decimal numeral of a nonnegative number that has one.
fn decimal(number: &BigRational) -> Option<String> {
    if number.is_negative() {
        return None;
    }
    if number.is_integer() {
        return Some(number.to_string());
    }
    let places = decimal_places(number)?;
    let scale = BigInt::from(10).pow(u32::try_from(places).ok()?);
    let digits = (number * BigRational::from_integer(scale))
        .to_integer()
        .to_string();
    let digits = format!("{digits:0>width$}", width = places + 1);
    let (whole, decimals) = digits.split_at(digits.len() - places);
    Some(format!("{whole}.{decimals}"))
}

/// How many decimals a number has behind its point; none where it is no decimal.
pub(crate) fn decimal_places(number: &BigRational) -> Option<usize> {
    let (mut twos, mut fives) = (0usize, 0usize);
    let mut rest = number.denom().clone();
    for (prime, count) in [(2, &mut twos), (5, &mut fives)] {
        let prime = BigInt::from(prime);
        while rest.is_multiple_of(&prime) && *count < 4_000 {
            rest /= &prime;
            *count += 1;
        }
    }
    (rest == BigInt::from(1)).then(|| twos.max(fives))
}
