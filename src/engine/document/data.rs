//! `data NAMES: VALUE, "SOURCE"` and `numeric`.

use num_traits::{Signed, ToPrimitive};

use super::attribute::split;
use super::directive::trim;
use super::number::rational;
use super::{Directive, Problem, Span};
use crate::algebra::{BigInt, BigRational};

/// Larger powers of ten belong to no quantity.
const MOST_DIGITS: u32 = 300;
const EXAMPLE: &str = "for example `data R: [9.9e-3, 10.1e-3], \"measured\"` or `data g: 9.81 ± 0.03, \"geodesy\"`, in SI units";

/// Reads the rest of a `data` clause.
pub(super) fn data(source: &str, clause: Span, body: Span) -> Result<Directive, Problem> {
    let text = &source[body.range()];
    let cited = text.split_once('"').and_then(|(head, rest)| {
        let cited = rest.strip_suffix('"')?.trim();
        (!cited.is_empty() && !cited.contains('"')).then_some((head.len(), cited.to_owned()))
    });
    let Some((length, cited)) = cited else {
        let message = "figures need a source, in quotation marks at the end";
        return Err(Problem::new(clause, message, EXAMPLE));
    };
    let head = trim(source, Span::new(body.start, body.start + length));
    let comma = source[head.range()].strip_suffix(',');
    let head = trim(
        source,
        Span::new(head.start, head.end - usize::from(comma.is_some())),
    );
    let [names, value] = split(source, head, b':', "{")[..] else {
        let message = "figures need one `:` between their symbols and what they are";
        return Err(Problem::new(clause, message, EXAMPLE));
    };
    let names = split(source, names, b',', "{([");
    if names.iter().any(|name| name.start >= name.end) {
        return Err(Problem::new(clause, "a symbol's name is missing", EXAMPLE));
    }
    let Some((low, high)) = bounds(&source[value.range()]) else {
        let span = match value.start < value.end {
            true => value,
            false => clause,
        };
        let message = "this is no number, and no numbers between bounds";
        return Err(Problem::new(span, message, EXAMPLE));
    };
    Ok(Directive::Data {
        names,
        low,
        high,
        source: cited,
    })
}

/// Reads the rest of a `numeric` clause: nothing, or `within` a share of the right side.
pub(super) fn numeric(source: &str, body: Span) -> Result<Directive, Problem> {
    let text = &source[body.range()];
    if text.is_empty() {
        return Ok(Directive::Numeric(None));
    }
    let share = text.strip_prefix("within ").and_then(figure);
    match share.filter(|share| !share.is_negative()) {
        Some(share) => Ok(Directive::Numeric(Some(share))),
        None => Err(Problem::new(
            body,
            "`numeric` stands alone, or says how near `≈` is meant",
            "for example `numeric within 0.01`: to one per cent of the right side",
        )),
    }
}

/// `[a, b]`, `a ± b` or `a`.
fn bounds(text: &str) -> Option<(BigRational, BigRational)> {
    if let Some(inside) = text.strip_prefix('[') {
        let (low, high) = inside.strip_suffix(']')?.split_once(',')?;
        let (low, high) = (figure(low)?, figure(high)?);
        return (low <= high).then_some((low, high));
    }
    for sign in ["±", "\\pm", "+-", "+/-"] {
        if let Some((middle, error)) = text.split_once(sign) {
            let (middle, error) = (figure(middle)?, figure(error)?);
            return (!error.is_negative()).then(|| (&middle - &error, &middle + &error));
        }
    }
    let value = figure(text)?;
    Some((value.clone(), value))
}

/// An exact number, with or without a power of ten: `200e9`, `1/2`.
fn figure(text: &str) -> Option<BigRational> {
    let Some((digits, exponent)) = text.split_once(['e', 'E']) else {
        return rational(text);
    };
    let exponent = rational(exponent).filter(BigRational::is_integer)?;
    let size = exponent.abs().to_integer().to_u32();
    let scale = BigInt::from(10).pow(size.filter(|&size| size <= MOST_DIGITS)?);
    let digits = rational(digits)?;
    Some(match exponent.is_negative() {
        true => digits / scale,
        false => digits * scale,
    })
}
