//! Systems of equations behind a brace: `\left\{ \begin{aligned} a &= b \\ c &= d \end{aligned} \right.` says what its rows say; and so does
//! one in a box, `\boxed{\begin{aligned} … \end{aligned}}`.

use super::super::commands;
use super::{Kind, Token};

/// The environments that stand behind such a brace, besides `array`.
const ROWS: [&str; 3] = ["aligned", "gathered", "split"];
/// What an `array` of equations is read as.
const GATHERED: &str = "gathered";

/// Takes away the braces before systems of equations.
pub(super) fn without_braces<'s>(raw: Vec<Token<'s>>) -> Vec<Token<'s>> {
    if !raw.windows(3).any(opens) {
        return raw;
    }
    let mut out = Vec::with_capacity(raw.len());
    let mut at = 0;
    while let Some(token) = raw.get(at) {
        match system_at(&raw, at) {
            Some((body, end)) => {
                out.extend(body);
                at = end;
            }
            None => {
                out.push(*token);
                at += 1;
            }
        }
    }
    out
}

/// `\left\{ \begin{…}`, `\boxed{\begin{…}`
fn opens(three: &[Token]) -> bool {
    let [left, brace, begin] = three else {
        return false;
    };
    let begun = |name: &str| name == "array" || ROWS.contains(&name);
    if is_boxed(left) {
        return brace.kind == Kind::Open
            && matches!(begin.kind, Kind::Begin(name) if ROWS.contains(&name));
    }
    matches!(left.kind, Kind::Command("left"))
        && matches!(brace.kind, Kind::Command("{" | "lbrace"))
        && matches!(begin.kind, Kind::Begin(name) if begun(name))
}

fn is_boxed(token: &Token) -> bool {
    token.kind == Kind::Command("boxed")
}

/// The environment of the system that begins at a place, and the place after its `\right.`, or after its box.
fn system_at<'s>(raw: &[Token<'s>], at: usize) -> Option<(Vec<Token<'s>>, usize)> {
    let begin = at + 2;
    if !opens(raw.get(at..=begin)?) {
        return None;
    }
    let finish = end_of(raw, begin)?;
    if is_boxed(&raw[at]) {
        let closed = raw.get(finish + 1)?.kind == Kind::Close;
        return closed.then(|| (raw[begin..=finish].to_vec(), finish + 2));
    }
    let closing = raw.get(finish + 1..finish + 3)?;
    let closed = closing[0].kind == Kind::Command("right") && closing[1].kind == Kind::Char('.');
    let mut body = raw[begin..=finish].to_vec();
    if body[0].kind == Kind::Begin("array") {
        body = gathered(&body)?;
    }
    closed.then_some((body, finish + 3))
}

/// Where the environment that begins at a place ends.
fn end_of(raw: &[Token], begin: usize) -> Option<usize> {
    let mut depth = 0_usize;
    for (at, token) in raw.iter().enumerate().skip(begin) {
        match token.kind {
            Kind::Begin(_) => depth += 1,
            Kind::Finish(_) => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return Some(at);
        }
    }
    None
}

/// An `array` with one column, or with a relation sign in the second of three, as rows of equations.
fn gathered<'s>(array: &[Token<'s>]) -> Option<Vec<Token<'s>>> {
    let close = array.iter().position(|token| token.kind == Kind::Close)?;
    let (columns, rows) = (array.get(2..close)?, &array[close + 1..array.len() - 1]);
    let plain = |token: &Token| matches!(token.kind, Kind::Letter('l' | 'c' | 'r'));
    if array[1].kind != Kind::Open || !columns.iter().all(plain) {
        return None;
    }
    let fits = match columns.len() {
        1 => !rows.iter().any(|token| token.kind == Kind::Char('&')),
        3 => rows.split(|token| token.kind == Kind::Row).all(is_equation),
        _ => false,
    };
    let renamed = |token: &Token<'s>, kind| Token { kind, ..*token };
    let mut all = vec![renamed(&array[0], Kind::Begin(GATHERED))];
    all.extend(rows);
    all.push(renamed(array.last()?, Kind::Finish(GATHERED)));
    fits.then_some(all)
}

/// Whether a row is `a & = & b`, or empty.
fn is_equation(row: &[Token]) -> bool {
    let cells: Vec<&[Token]> = row.split(|token| token.kind == Kind::Char('&')).collect();
    match cells.as_slice() {
        [only] => only.is_empty(),
        [_, [sign], _] => match sign.kind {
            Kind::Char('=' | '<' | '>') => true,
            Kind::Command(name) => commands::relation(name).is_some(),
            _ => false,
        },
        _ => false,
    }
}
