//! `symbols NAMES: ATTRIBUTES`.

use super::directive::trim;
use super::nearest::nearest;
use super::number::rational;
use super::{Attribute, Bound, Directive, Problem, Span};
use crate::notation::Spanned;

const DOMAINS: [&str; 7] = [
    "real",
    "positive",
    "nonnegative",
    "nonzero",
    "integer",
    "natural",
    "constant",
];
/// What may stand before `constant` in the name of a dimension.
const CONSTANTS: [&str; 5] = ["spring", "gas", "gravitational", "boltzmann", "diffusion"];
const HELP: &str = "an attribute is a dimension (`mass`, `M L^{-1/2} T^{-2}`), a domain (`real`, \
                    `positive`, `nonnegative`, `nonzero`, `integer`, `natural`, `constant`), `Euler's number`, an \
                    interval (`in [0, 1]`) or a bound (`>= 1`)";
/// Relation signs of a bound: whether it is a lower one, and strict. Longer ones first.
const BOUNDS: [(&str, bool, bool); 14] = [
    (">=", true, false),
    ("\\geqslant", true, false),
    ("\\geq", true, false),
    ("\\ge", true, false),
    ("≥", true, false),
    ("\\gt", true, true),
    (">", true, true),
    ("<=", false, false),
    ("\\leqslant", false, false),
    ("\\leq", false, false),
    ("\\le", false, false),
    ("≤", false, false),
    ("\\lt", false, true),
    ("<", false, true),
];

/// Reads a declaration that stands by itself, `NAMES: ATTRIBUTES`, by the grammar of a `symbols` clause: the names and what
/// they are declared to be, as far as that can be read, and what is wrong with the rest.
pub fn declaration(source: &str) -> (Vec<Span>, Vec<Spanned<Attribute>>, Vec<Problem>) {
    let whole = trim(source, Span::new(0, source.len()));
    let mut problems = Vec::new();
    match symbols(source, whole, whole, &mut problems) {
        Ok(Directive::Symbols { names, attributes }) => (names, attributes, problems),
        Ok(_) => (Vec::new(), Vec::new(), problems),
        Err(problem) => {
            problems.push(problem);
            (Vec::new(), Vec::new(), problems)
        }
    }
}

/// Reads the rest of a `symbols` clause. One wrong attribute does not hide the others.
pub(super) fn symbols(
    source: &str,
    clause: Span,
    body: Span,
    problems: &mut Vec<Problem>,
) -> Result<Directive, Problem> {
    let parts = split(source, body, b':', "{");
    let [names, attributes] = parts[..] else {
        let message = "a declaration needs one `:` between its symbols and their attributes";
        return Err(Problem::new(
            clause,
            message,
            "for example `symbols m_1, m_2: mass, positive`",
        ));
    };
    let names = split(source, names, b',', "{([");
    if let Some(empty) = names.iter().find(|name| name.start >= name.end) {
        let span = Span::new(clause.start.max(empty.start.saturating_sub(1)), empty.end);
        let help = "for example `symbols m_1, m_2: mass, positive`";
        return Err(Problem::new(span, "a symbol's name is missing", help));
    }
    let mut read = Vec::new();
    for span in split(source, attributes, b',', "{([") {
        match attribute(&source[span.range()]) {
            Ok(value) => read.push(Spanned { value, span }),
            Err((message, help)) => {
                let span = if span.start < span.end { span } else { clause };
                problems.push(Problem::new(span, message, help));
            }
        }
    }
    if read.is_empty() && problems.is_empty() {
        return Err(Problem::new(clause, "an attribute is missing", HELP));
    }
    let attributes = read;
    Ok(Directive::Symbols { names, attributes })
}

/// The trimmed parts between `separator`s that are in none of the brackets that `nests` opens; `[`
/// may close with `)`.
pub(super) fn split(source: &str, span: Span, separator: u8, nests: &str) -> Vec<Span> {
    let bytes = source.as_bytes();
    let (mut from, mut at, mut depth) = (span.start, span.start, 0_usize);
    let mut parts = Vec::new();
    while at < span.end {
        match bytes[at] {
            b'\\' => at += 1,
            open @ (b'{' | b'(' | b'[') if nests.as_bytes().contains(&open) => depth += 1,
            b'}' => depth = depth.saturating_sub(1),
            b')' | b']' if nests.len() > 1 => depth = depth.saturating_sub(1),
            byte if byte == separator && depth == 0 => {
                parts.push(trim(source, Span::new(from, at)));
                from = at + 1;
            }
            _ => {}
        }
        at += 1;
    }
    parts.push(trim(source, Span::new(from.min(span.end), span.end)));
    parts
}

/// An attribute, or what is wrong and what to write.
fn attribute(text: &str) -> Result<Attribute, (String, String)> {
    let shown: String = text.chars().take(40).collect();
    let error = |what: &str, help: &str| Err((format!("`{shown}` {what}"), help.to_owned()));
    match text {
        "" => return Err(("an attribute is missing".to_owned(), HELP.to_owned())),
        "real" => return Ok(Attribute::Real),
        "positive" => return Ok(Attribute::Positive),
        "nonnegative" => return Ok(Attribute::Nonnegative),
        "nonzero" => return Ok(Attribute::Nonzero),
        "integer" => return Ok(Attribute::Integer),
        "natural" => return Ok(Attribute::Natural),
        "constant" => return Ok(Attribute::Constant),
        "Euler's number" | "Euler’s number" => return Ok(Attribute::Euler),
        _ => {}
    }
    for (sign, is_lower, strict) in BOUNDS {
        if let Some(rest) = text
            .strip_prefix(sign)
            .filter(|rest| !rest.starts_with(char::is_alphabetic))
        {
            let Some(value) = rational(rest) else {
                return error("is not a bound", "a bound is an exact number: `>= 1/2`");
            };
            let bound = Some(Bound { value, strict });
            let (lower, upper) = if is_lower {
                (bound, None)
            } else {
                (None, bound)
            };
            return Ok(Attribute::Interval { lower, upper });
        }
    }
    for sign in ["in", "\\in", "∈"] {
        if let Some(rest) = text.strip_prefix(sign)
            && rest.starts_with([' ', '\t', '\n', '\r', '[', '('])
        {
            return match interval(rest.trim()) {
                Some(read) => Ok(read),
                None => error(
                    "is not an interval",
                    "an interval holds numbers between exact bounds: `in [0, 1/2)`, `in (0, \\infty)`",
                ),
            };
        }
    }
    if ["\\neq", "\\ne", "≠", "!="]
        .iter()
        .any(|sign| text.starts_with(sign))
    {
        return error(
            "is not an attribute",
            "write `nonzero`, or use an `assuming` clause",
        );
    }
    // A slip in a domain word would otherwise pass for a dimension, and lose the domain.
    let slips = if text.len() < 9 { 1 } else { 2 };
    if let Some(domain) = nearest(text, &DOMAINS, slips) {
        return error("is not an attribute", &format!("did you mean `{domain}`?"));
    }
    let is_name = |begin: &str| {
        text.strip_suffix(" constant")
            .is_some_and(|rest| rest == begin)
    };
    let domain = text.split_whitespace().find(|word| DOMAINS.contains(word));
    if let Some(domain) = domain.filter(|_| !CONSTANTS.iter().any(|begin| is_name(begin))) {
        return error(
            "is not an attribute",
            &format!("write `{domain}`, with a comma before what follows"),
        );
    }
    if !is_dimension(text) {
        return error("is not an attribute", HELP);
    }
    Ok(Attribute::Dimension(text.to_owned()))
}

/// `[0, 1)`, `(0, \infty)`; `None` if malformed or empty.
fn interval(text: &str) -> Option<Attribute> {
    let open = text.chars().next().filter(|c| matches!(c, '[' | '('))?;
    let close = text.chars().last().filter(|c| matches!(c, ']' | ')'))?;
    let (low, high) = text.get(1..text.len().checked_sub(1)?)?.split_once(',')?;
    let end = |text: &str, infinite: &[&str], strict: bool| match text.trim() {
        text if infinite.contains(&text) => strict.then_some(None),
        text => rational(text).map(|value| Some(Bound { value, strict })),
    };
    let lower = end(low, &["-\\infty", "-∞", "−∞", "-infinity"], open == '(')?;
    let infinite = ["\\infty", "+\\infty", "∞", "+∞", "infinity", "+infinity"];
    let upper = end(high, &infinite, close == ')')?;
    if let (Some(lower), Some(upper)) = (&lower, &upper) {
        let point = !lower.strict && !upper.strict;
        if lower.value > upper.value || (lower.value == upper.value && !point) {
            return None;
        }
    }
    Some(Attribute::Interval { lower, upper })
}

/// Whether this could be a dimension: `angular velocity`, `M L^{-1/2} T^{-2}`, `energy/temperature`. What it says is
/// read where its meaning is known.
fn is_dimension(text: &str) -> bool {
    let begins = |c: char| c.is_alphabetic() || matches!(c, '\\' | '(' | '1');
    let goes_on =
        |c: char| c.is_alphanumeric() || c.is_whitespace() || "\\^{}()/*·×+-−⁻ᐟ,".contains(c);
    text.starts_with(begins) && text.contains(char::is_alphabetic) && text.chars().all(goes_on)
}
