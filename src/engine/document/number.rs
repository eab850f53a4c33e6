//! The exact numbers that a declaration may contain, and the ranges that a citation may.

use crate::algebra::{BigInt, BigRational};

/// Longer numbers are refused: reading digits takes quadratic time.
const MOST_DIGITS: usize = 500;
/// A longer range is a slip of the pen; only its ends are read.
const LONGEST_RANGE: u64 = 1000;

/// An integer, a fraction `1/2` or `\frac{1}{2}`, or a decimal, with or without a sign.
pub(super) fn rational(text: &str) -> Option<BigRational> {
    let text = text.trim();
    let (negative, magnitude) = match text.strip_prefix(['-', '−']) {
        Some(rest) => (true, rest),
        None => (false, text.strip_prefix('+').unwrap_or(text)),
    };
    let value = match fraction(magnitude.trim()) {
        Some((over, under)) => {
            let under = decimal(under.trim())?;
            if under == BigRational::from_integer(0.into()) {
                return None;
            }
            decimal(over.trim())? / under
        }
        None => decimal(magnitude.trim())?,
    };
    Some(if negative { -value } else { value })
}

fn fraction(text: &str) -> Option<(&str, &str)> {
    for command in ["\\frac", "\\tfrac", "\\dfrac"] {
        if let Some(rest) = text.strip_prefix(command) {
            let inner = rest.trim().strip_prefix('{')?.strip_suffix('}')?;
            let (over, under) = inner.split_once('}')?;
            return Some((over, under.trim().strip_prefix('{')?));
        }
    }
    text.split_once('/')
}

fn decimal(text: &str) -> Option<BigRational> {
    let (whole, part) = text.split_once('.').unwrap_or((text, ""));
    let digits = [whole, part].concat();
    let plain = digits.bytes().all(|byte| byte.is_ascii_digit());
    if digits.is_empty() || digits.len() > MOST_DIGITS || !plain || text.ends_with('.') {
        return None;
    }
    let scale = BigInt::from(10).pow(u32::try_from(part.len()).ok()?);
    Some(BigRational::new(digits.parse().ok()?, scale))
}

/// The tags from `first` to `last` when both are numbers in order, otherwise just the two.
pub(super) fn expand_range(first: &str, last: &str) -> Vec<String> {
    let whole = |tag: &str| tag.parse::<u64>().ok().filter(|_| !tag.starts_with('+'));
    match (whole(first), whole(last)) {
        (Some(low), Some(high)) if low < high && high - low <= LONGEST_RANGE => {
            let mut tags = vec![first.to_owned()];
            tags.extend((low + 1..high).map(|number| number.to_string()));
            tags.push(last.to_owned());
            tags
        }
        _ => vec![first.to_owned(), last.to_owned()],
    }
}
