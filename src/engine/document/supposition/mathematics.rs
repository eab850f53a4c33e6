//! What inline mathematics states, as far as its signs tell.

use crate::algebra::{Expr, Symbol};
use crate::document::Span;
use crate::document::prose::Token;
use crate::notation::read_expr;

/// These say that something is zero.
const ZERO: &[&str] = &["vanish", "vanishes", "zero", "nought"];

/// What stands at a place in the source.
pub(super) fn text(source: &str, span: Span) -> &str {
    source.get(span.range()).unwrap_or_default()
}

/// The relation that a token is.
pub(in crate::document) fn stated(source: &str, token: Token<'_>) -> Option<Span> {
    match token {
        Token::Math(body) if relates(text(source, body)) => Some(body),
        _ => None,
    }
}

/// Whether a token says that something is zero, in a word or a sign.
pub(super) fn says_zero(source: &str, token: Token<'_>) -> bool {
    match token {
        Token::Number(number) => number == "0",
        Token::Math(body) => text(source, body).trim() == "0",
        word => word.is_among(ZERO),
    }
}

/// Whether inline math is a slope with a slash, or begins with one: `dw/dx`.
pub(super) fn is_slope(math: &str) -> bool {
    let math = math.trim();
    math.starts_with('d') && math.contains("/d")
}

/// Whether inline math says that something is a number: `x = 0`.
pub(super) fn is_number(math: &str) -> bool {
    let value = math.rsplit('=').next().unwrap_or(math);
    let value = ["\\frac", "\\tfrac", "\\dfrac", "\\pi"]
        .iter()
        .fold(value.to_owned(), |v, f| v.replace(f, ""));
    !value.contains(char::is_alphabetic)
}

/// Whether inline math says that a symbol is zero: `x = 0`.
pub(super) fn is_zero(math: &str) -> bool {
    let sides = math.split_once('=');
    sides
        .is_some_and(|(name, value)| is_letters(name.trim()) && matches!(value.trim(), "0" | "0.0"))
}

/// Whether inline math says that something is a number, be it in a unit or with a power of ten: `r = 0.5\ \Omega`, `n = 8.5 \times 10^{28}`.
pub(super) fn is_figure(math: &str) -> bool {
    let Some((left, value)) = math.split_once('=') else {
        return false;
    };
    let value_start = math.len() - value.len();
    let digits =
        value.trim_start_matches(|c: char| c.is_whitespace() || matches!(c, '-' | '\\' | ','));
    let begins = digits.starts_with(|c: char| c.is_ascii_digit() || c == '.')
        || ["frac", "tfrac", "dfrac", "sqrt"]
            .iter()
            .any(|own| digits.starts_with(own));
    let is_exact = |symbol: &Symbol| symbol.is_unit();
    let number = || match read_expr(math, Span::new(value_start, math.len())) {
        Ok(value) => value.free_symbols().iter().all(is_exact),
        Err(_) => false,
    };
    begins && !left.trim_start().starts_with(|c: char| c.is_ascii_digit()) && number()
}

/// Whether inline math says that something is something else that has a name: `x = a`.
pub(super) fn equals_a_name(math: &str) -> bool {
    let start = math.rfind('=').map_or(0, |at| at + 1);
    let value = read_expr(math, Span::new(start, math.len()));
    matches!(value, Ok(Expr::Symbol(_)))
}

/// Whether inline math is nothing but letters, or functions of letters: "Let $x$, $u_1, \dots, u_n$ and $f(x)$".
pub(super) fn is_letters(math: &str) -> bool {
    let dots = |part: &str| matches!(part.trim(), "\\dots" | "\\ldots" | "\\cdots");
    let letter = |part: &str| {
        let term = read_expr(part, Span::new(0, part.len()));
        matches!(term, Ok(Expr::Symbol(_) | Expr::Apply(..)))
    };
    math.split(',').all(|part| dots(part) || letter(part))
}

/// Whether inline math is one equation. "For $x > 0$, … For $x < 0$, …" goes through cases: neither holds from there on.
pub(super) fn is_value(math: &str) -> bool {
    signs_of_equality(math) == Some(1)
}

/// Whether inline math sets several things equal to each other, `x_{n+1} = x_n = x`.
pub(super) fn is_chain(math: &str) -> bool {
    signs_of_equality(math).is_some_and(|signs| signs > 1)
}

/// How many signs `=` inline math has that relates things by these alone.
fn signs_of_equality(math: &str) -> Option<usize> {
    let alone = relates(math) && !relates(&math.replace('=', " "));
    alone.then(|| math.matches('=').count())
}

/// Whether inline math is one inequality, which bounds what it speaks of.
pub(super) fn is_bound(math: &str) -> bool {
    relates(math) && !math.contains('=')
}

/// Whether inline math says that two things differ.
pub(super) fn differs(math: &str) -> bool {
    let not = ["\\neq", "\\ne", "≠"]
        .iter()
        .find_map(|sign| math.split_once(sign));
    not.is_some_and(|(left, right)| !relates(left) && !relates(right))
}

/// Whether inline math states a relation, and no inference: a relation sign outside braces.
pub(in crate::document) fn relates(math: &str) -> bool {
    let mut depth = 0_usize;
    let mut relation = false;
    let mut chars = math.char_indices();
    while let Some((at, c)) = chars.next() {
        match c {
            '{' => depth += 1,
            '}' => depth = depth.saturating_sub(1),
            '=' | '≡' | '<' | '>' | '≠' | '≤' | '≥' | '⩽' | '⩾' => {
                relation |= depth == 0
            }
            '⇒' | '⇔' => return false,
            '\\' => {
                let name = &math[at + 1..];
                let name = &name[..name
                    .find(|c: char| !c.is_ascii_alphabetic())
                    .unwrap_or(name.len())];
                match name {
                    "equiv" | "coloneqq" | "neq" | "ne" | "le" | "leq" | "ge" | "geq" | "lt"
                    | "gt" | "leqslant" | "geqslant" => relation |= depth == 0,
                    "Rightarrow" | "implies" | "iff" | "Leftrightarrow" | "therefore" => {
                        return false;
                    }
                    "left" | "right" => drop(chars.nth(name.len())),
                    "" => drop(chars.next()),
                    _ => {}
                }
            }
            _ => {}
        }
    }
    relation
}
