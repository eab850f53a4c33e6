//! Numeric claims: what the figures say of them, and which figures. The ends of intervals are exact; as decimals they are rounded outwards.

use num_traits::{Signed, Zero};

use crate::algebra::{BigInt, BigRational, Formula, Relation};
use crate::audit::{Entry, FAR, Link, Numeric, Weighed};
use crate::interval::{Interval, NoInterval};
use crate::notation::{plain, plain_formula};

use super::Report;
use super::words;

/// How many digits of the end of an interval are shown.
const DIGITS: usize = 3;

/// What is said of a numeric claim in a line.
pub(super) fn headline(numeric: &Numeric) -> String {
    let outcome = numeric.outcome();
    let link = numeric.links.iter().find(|link| link.outcome == *outcome);
    let values = link.and_then(compared);
    match (outcome, values) {
        (Weighed::Supported, Some(values)) => match constants(numeric) {
            Some(constants) => format!("numerically: {values}; taking {constants}"),
            None => format!("numerically: {values}"),
        },
        (Weighed::Supported, None) => "numerically".into(),
        (Weighed::Contradicted, Some(values)) => format!("numerically: {values}"),
        (Weighed::Contradicted, None) => "numerically".into(),
        (Weighed::NotSettled, Some(values)) => format!("the figures do not settle it: {values}"),
        (Weighed::NotSettled, None) => "the figures do not settle it".into(),
        (outcome, _) => format!("not evaluated: {}", reason(outcome)),
    }
}

/// The constants that were put in without being told: `g = 9.81 (standard gravity)`.
fn constants(numeric: &Numeric) -> Option<String> {
    let listed = numeric.data.iter().filter_map(|(symbol, (_, datum))| {
        let (name, value) = (datum.constant?, about(&datum.low));
        Some(format!("{} = {value} ({name})", words::symbol(symbol)))
    });
    let listed: Vec<String> = listed.collect();
    (!listed.is_empty()).then(|| listed.join(" and "))
}

/// `left/right between 23.8 and 61.2`.
fn compared(link: &Link) -> Option<String> {
    let Some((left, right)) = &link.sides else {
        let ratio = link.ratio.as_ref()?;
        return Some(format!("left/right {}", nearly(ratio)));
    };
    if link.goal.rounding.is_some() {
        return Some(format!("left {}, right {}", nearly(left), nearly(right)));
    }
    Some(match &link.ratio {
        Some(ratio) => format!("left/right {}", between(ratio)),
        None => format!("left {}, right {}", between(left), between(right)),
    })
}

/// `9.7949`, of what is one number, or as good as one.
fn nearly(interval: &Interval) -> String {
    match (about(interval.low()), about(interval.high())) {
        (low, high) if low == high => low,
        _ => between(interval),
    }
}

/// `between 23.8 and 61.2`.
pub(super) fn between(interval: &Interval) -> String {
    match interval.low() == interval.high() {
        true => format!("= {}", interval.low()),
        false => format!(
            "between {} and {}",
            decimal(interval.low(), false),
            decimal(interval.high(), true)
        ),
    }
}

fn reason(outcome: &Weighed) -> String {
    match outcome {
        Weighed::NoValue(NoInterval::Unknown(symbol)) => {
            format!("nothing gives a number for {}", words::symbol(symbol))
        }
        Weighed::NoValue(NoInterval::Undefined(term)) => {
            format!("`{}` may be 0, or under a root negative", plain(term))
        }
        Weighed::NoValue(NoInterval::Unsupported(term)) => {
            format!("`{}` is of a kind that is not evaluated", plain(term))
        }
        Weighed::NoValue(NoInterval::TooLarge) => "too much would have to be put in".into(),
        Weighed::NoTolerance => "how near is not stated (`numeric within 0.01`)".into(),
        _ => "this is no relation between numbers".into(),
    }
}

/// What a relation is taken for.
fn measure(link: &Link) -> Option<String> {
    let Formula::Relation { relation, .. } = &link.goal.formula else {
        return None;
    };
    Some(match relation {
        Relation::MuchGreater => format!("`≫` is taken for: at least {FAR} times"),
        Relation::MuchLess => format!("`≪` is taken for: at most 1/{FAR}"),
        Relation::Equal | Relation::Approximately
            if link.near.is_some() && link.goal.rounding.is_some() =>
        {
            "the last digit of the right side is taken for rounded".into()
        }
        Relation::Approximately => {
            let near = link.near.as_ref()?;
            format!("`≈` is taken for: within {near} of the right side")
        }
        Relation::Equal => "`=` is taken for: the figures leave it possible".into(),
        _ => return None,
    })
}

impl Report<'_> {
    /// A numeric claim in full: figures with their sources, what was put in, the intervals.
    pub(super) fn numeric_lines(&self, entry: &Entry) -> String {
        let Some(numeric) = &entry.numeric else {
            return String::new();
        };
        let mut text = String::new();
        for link in &numeric.links {
            text += &format!("\n  To weigh: {}\n", plain_formula(&link.goal.formula));
            let said = match &link.outcome {
                Weighed::Supported => "supported by all figures within their bounds".into(),
                Weighed::Contradicted => "contradicted by all figures within their bounds".into(),
                Weighed::NotSettled => "not settled: it depends on the figures".to_owned(),
                outcome => format!("not evaluated: {}", reason(outcome)),
            };
            text += &format!("    {said}\n");
            text += &measure(link).map_or(String::new(), |measure| format!("    {measure}\n"));
            if let Some((left, right)) = &link.sides {
                text += &format!("    left        {}\n", between(left));
                text += &format!("    right       {}\n", between(right));
            }
            if let Some(ratio) = &link.ratio {
                text += &format!("    left/right  {}\n", between(ratio));
            }
        }
        if !numeric.put_in.is_empty() {
            text += "\n  With\n";
        }
        for (own, value, source) in &numeric.put_in {
            let (name, value) = (plain(own), plain(value));
            text += &format!("    {name} = {value}   {}\n", self.source(source));
        }
        if !numeric.data.is_empty() {
            text += "\n  Figures, in SI units\n";
        }
        for (symbol, (page, datum)) in &numeric.data {
            let value = Interval::new(datum.low.clone(), datum.high.clone());
            let value = value.as_ref().map_or(String::new(), between);
            let place = self.place_of(*page, datum.span);
            let name = words::symbol(symbol);
            text += &format!("    {name} {value}   {}, {place}\n", datum.source);
        }
        text +=
            "\n  This is no proof: it is as good as the figures and the models that are put in.\n";
        text
    }
}

/// A number as a decimal of a few digits, not below it (`up`) or not above it.
pub(super) fn decimal(value: &BigRational, up: bool) -> String {
    if value.is_negative() {
        return format!("−{}", decimal(&-value, !up));
    }
    let rounded = |steps: BigRational| match up {
        true => steps.ceil().to_integer(),
        false => steps.floor().to_integer(),
    };
    in_digits(value, DIGITS, rounded)
}

/// The nearest decimal of five digits.
pub(super) fn about(value: &BigRational) -> String {
    match value.is_negative() {
        true => format!("−{}", about(&-value)),
        false => in_digits(value, 5, |steps| steps.round().to_integer()),
    }
}

/// A number that is not negative, in so many digits.
fn in_digits(value: &BigRational, count: usize, rounded: impl Fn(BigRational) -> BigInt) -> String {
    if value.is_zero() {
        return "0".into();
    }
    let ten = BigRational::from_integer(10.into());
    // `10^exponent ≤ value < 10^(exponent + 1)`
    let length = |n: &BigInt| i32::try_from(n.to_string().len()).unwrap_or(i32::MAX);
    let mut exponent = length(value.numer()) - length(value.denom());
    if value < &num_traits::Pow::pow(&ten, exponent) {
        exponent -= 1;
    }
    let shown = i32::try_from(count).unwrap_or(3) - 1;
    let unit: BigRational = num_traits::Pow::pow(&ten, exponent - shown);
    let mut digits = rounded(value / &unit);
    if digits.to_string().len() > count {
        digits /= 10;
        exponent += 1;
    }
    let text = digits.to_string();
    let trimmed = |text: &str| match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text.to_owned(),
    };
    match exponent {
        0..=5 => {
            let whole = usize::try_from(exponent).unwrap_or(0) + 1;
            match whole >= text.len() {
                true => format!("{text}{}", "0".repeat(whole - text.len())),
                false => trimmed(&format!("{}.{}", &text[..whole], &text[whole..])),
            }
        }
        -3..=-1 => {
            let zeros = usize::try_from(-exponent).unwrap_or(1) - 1;
            trimmed(&format!("0.{}{text}", "0".repeat(zeros)))
        }
        _ => {
            let mantissa = trimmed(&format!("{}.{}", &text[..1], &text[1..]));
            let exponent = exponent.to_string().replace('-', "−");
            format!("{mantissa} × 10^{exponent}")
        }
    }
}
