//! Numbers and lists as a figure's text has them.

use num_traits::{Signed, Zero};

use crate::algebra::{BigInt, BigRational};

/// So many decimals are written even where a fraction is shorter.
const FEW_DECIMALS: usize = 12;
/// No more than these are tried.
const MOST_DECIMALS: usize = 100;

/// `a`, `a and b`, `a, b and c`.
pub(super) fn list(items: &[String]) -> String {
    match items {
        [] => String::new(),
        [one] => one.clone(),
        [all @ .., last] => format!("{} and {last}", all.join(", ")),
    }
}

/// An exact number as one would write it: `0.98`, `−1/3`, with a true minus sign.
///
/// ```
/// use cradle_verify::{cradle::parse_exact, figures::exact};
/// let written = |text| exact(&parse_exact(text).unwrap());
/// assert_eq!((written("98/100"), written("-1/3")), ("0.98".into(), "−1/3".into()));
/// assert_eq!(written("0.99999999999999999999"), "0.99999999999999999999");
/// assert_eq!(written("1/1073741824"), "1/1073741824");
/// ```
pub fn exact(value: &BigRational) -> String {
    let sign = if value.is_negative() { "−" } else { "" };
    let value = value.abs();
    let fraction = value.to_string();
    let mut scaled = value;
    for decimals in 0..=MOST_DECIMALS.min(fraction.len().max(FEW_DECIMALS)) {
        if scaled.is_integer() {
            return format!("{sign}{}", decimal(scaled.numer(), decimals));
        }
        scaled *= BigInt::from(10);
    }
    format!("{sign}{fraction}")
}

/// Numbers of one list, each as [`exact`] has it, the decimal ones with as many decimals as the one that needs most. What
/// is longer than so many characters, or a fraction, stands as it is, and makes nothing else longer.
///
/// ```
/// use cradle_verify::{cradle::parse_exact, figures::alike};
/// let list = ["0.98", "9/10", "1", "1/3", "0.999999999"].map(|text| parse_exact(text).unwrap());
/// assert_eq!(alike(&list, 6), ["0.98", "0.90", "1.00", "1/3", "0.999999999"]);
/// ```
pub fn alike(values: &[BigRational], longest: usize) -> Vec<String> {
    let written: Vec<String> = values.iter().map(exact).collect();
    let is_short = |text: &&String| text.chars().count() <= longest && !text.contains('/');
    let most = written.iter().filter(is_short).map(|text| decimals(text));
    let most = most.max().unwrap_or(0);
    let padded = |text: &String| match is_short(&text) {
        true => with_decimals(text, most),
        false => text.clone(),
    };
    written.iter().map(padded).collect()
}

/// How many digits stand behind the point.
fn decimals(text: &str) -> usize {
    text.split_once('.').map_or(0, |(_, behind)| behind.len())
}

/// A decimal number with so many digits behind the point, where it has fewer.
fn with_decimals(text: &str, wanted: usize) -> String {
    let lacking = wanted.saturating_sub(decimals(text));
    let point = match lacking > 0 && !text.contains('.') {
        true => ".",
        false => "",
    };
    format!("{text}{point}{}", "0".repeat(lacking))
}

/// A number rounded to so many decimals, half away from 0, by exact arithmetic; with a hyphen for a minus.
///
/// ```
/// use cradle_verify::algebra::{BigInt, BigRational};
/// use cradle_verify::figures::rounded;
/// let third = BigRational::new(BigInt::from(-1), BigInt::from(3));
/// assert_eq!(rounded(&third, 4), "-0.3333");
/// assert_eq!(rounded(&(third * BigInt::from(3)), 4), "-1");
/// ```
pub fn rounded(value: &BigRational, decimals: usize) -> String {
    let scale = num_traits::pow(BigInt::from(10), decimals);
    let digits = (value.abs() * scale).round().to_integer();
    let text = decimal(&digits, decimals);
    let text = match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.'),
        false => &text,
    };
    match value.is_negative() && !digits.is_zero() {
        true => format!("-{text}"),
        false => text.to_owned(),
    }
}

/// Digits with a point so many places from the right.
fn decimal(digits: &BigInt, decimals: usize) -> String {
    let digits = format!("{digits:0>width$}", width = decimals + 1);
    let (whole, part) = digits.split_at(digits.len() - decimals);
    match part {
        "" => whole.to_owned(),
        part => format!("{whole}.{part}"),
    }
}
