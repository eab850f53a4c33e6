//! Exact numbers read from text: `2`, `-1`, `2/3`, `0.5`, `1e-3`.
//!
//! A decimal is the rational that it spells, `0.1` being one tenth and not the nearest binary fraction. Length and
//! exponent are bounded, for a few characters such as `1e999999999` could otherwise ask for all of memory.

use std::fmt;
use std::str::FromStr;

use nalgebra::DVector;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Zero, pow};

/// The longest number that is read, in characters.
pub const MAX_LENGTH: usize = 100;
/// The largest power of ten that is read, up or down.
pub const MAX_EXPONENT: usize = 100;
/// The longest list that is read.
pub const MAX_ITEMS: usize = 1000;

/// Why a text is not an exact number. The text is the guilty one, trimmed: of a list, the item.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NumberError {
    /// Nothing is there.
    Empty,
    /// Not a number in any accepted notation.
    NotANumber(String),
    /// A fraction over zero.
    DividesByZero(String),
    /// More than [`MAX_LENGTH`] characters; how many.
    TooLong(usize),
    /// A power of ten beyond [`MAX_EXPONENT`].
    ExponentTooLarge(String),
    /// More than [`MAX_ITEMS`] numbers in a list; how many.
    TooManyItems(usize),
}

impl fmt::Display for NumberError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NumberError::Empty => write!(
                f,
                "a number is missing: write one like `2`, `-1`, `2/3`, `0.5` or `1e-3`"
            ),
            NumberError::NotANumber(text) => {
                write!(
                    f,
                    "`{text}` is not a number: write one like `2`, `-1`, `2/3`, `0.5` or `1e-3`"
                )
            }
            NumberError::DividesByZero(text) => write!(f, "`{text}` divides by zero"),
            NumberError::TooLong(length) => {
                write!(
                    f,
                    "a number of {length} characters is too long: at most {MAX_LENGTH} are read"
                )
            }
            NumberError::ExponentTooLarge(text) => {
                write!(
                    f,
                    "`{text}` has too large an exponent: at most {MAX_EXPONENT}, up or down, is read"
                )
            }
            NumberError::TooManyItems(count) => {
                write!(
                    f,
                    "a list of {count} numbers is too long: at most {MAX_ITEMS} are read"
                )
            }
        }
    }
}

impl std::error::Error for NumberError {}

/// The rational that a text spells: an integer, a decimal, perhaps with an exponent, or a fraction of two such.
///
/// ```
/// use cradle_verify::cradle::parse_exact;
/// assert_eq!(parse_exact("0.5"), parse_exact("1/2"));
/// assert_eq!(parse_exact("1e-3").unwrap().to_string(), "1/1000");
/// assert_eq!(parse_exact("1/0").unwrap_err().to_string(), "`1/0` divides by zero");
/// ```
///
/// # Errors
/// [`NumberError`], with the text at fault.
pub fn parse_exact(text: &str) -> Result<BigRational, NumberError> {
    let text = text.trim();
    let length = text.chars().count();
    if length == 0 {
        return Err(NumberError::Empty);
    }
    if length > MAX_LENGTH {
        return Err(NumberError::TooLong(length));
    }
    let Some((numerator, denominator)) = text.split_once('/') else {
        return decimal(text, text);
    };
    let (numerator, denominator) = (
        decimal(numerator.trim(), text)?,
        decimal(denominator.trim(), text)?,
    );
    if denominator.is_zero() {
        return Err(NumberError::DividesByZero(text.to_owned()));
    }
    Ok(numerator / denominator)
}

/// The numbers of a list parted by commas: `1, 0, -1/3`.
///
/// ```
/// use cradle_verify::cradle::{list_text, parse_list};
/// assert_eq!(list_text(&parse_list("1, 0.5,-2/4").unwrap()), "(1, 1/2, -1/2)");
/// ```
///
/// # Errors
/// The [`NumberError`] of the first item that is not a number.
pub fn parse_list(text: &str) -> Result<DVector<BigRational>, NumberError> {
    let count = text.split(',').count();
    if count > MAX_ITEMS {
        return Err(NumberError::TooManyItems(count));
    }
    Ok(DVector::from_vec(
        text.split(',').map(parse_exact).collect::<Result<_, _>>()?,
    ))
}

/// A list of numbers as printed: `(1, 0, -1/3)`.
pub fn list_text(values: &DVector<BigRational>) -> String {
    let items: Vec<String> = values.iter().map(BigRational::to_string).collect();
    format!("({})", items.join(", "))
}

/// `[sign] digits [. digits] [e [sign] digits]`, with a digit before or after the point. `whole` is for the message.
fn decimal(text: &str, whole: &str) -> Result<BigRational, NumberError> {
    let bad = || NumberError::NotANumber(whole.to_owned());
    let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let (negative, mantissa) = signed(mantissa);
    let (integer, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits = format!("{integer}{fraction}");
    let (shrinks, exponent) = signed(exponent);
    if !all_digits(&digits) || !all_digits(exponent) {
        return Err(bad());
    }
    // All digits, so only its size can keep the exponent from being read.
    let exponent = exponent.parse().ok().filter(|size| *size <= MAX_EXPONENT);
    let exponent: usize =
        exponent.ok_or_else(|| NumberError::ExponentTooLarge(whole.to_owned()))?;
    let magnitude = BigInt::from_str(&digits).map_err(|_| bad())?;
    let scale = pow(BigInt::from(10), exponent);
    let mut value = BigRational::new(magnitude, pow(BigInt::from(10), fraction.len()));
    value = if shrinks {
        value / scale
    } else {
        value * scale
    };
    Ok(if negative { -value } else { value })
}

/// Takes the sign off, `-` or the typographer's `−`: whether it was a minus, and the rest.
fn signed(text: &str) -> (bool, &str) {
    match text.strip_prefix(['-', '−']) {
        Some(rest) => (true, rest),
        None => (false, text.strip_prefix('+').unwrap_or(text)),
    }
}

fn all_digits(text: &str) -> bool {
    !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit())
}
