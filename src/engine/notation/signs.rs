//! What is said of two things at once, `x_\pm = a \pm b` or `x_{1,2} = a \pm b`, as two statements: one with all upper signs, and one
//! with all lower ones.

use super::lexer::{Kind, Token};

/// Tokens in which what is said with signs in an index is said twice, once with either.
pub(super) fn apart(tokens: Vec<Token<'_>>) -> Vec<Token<'_>> {
    if !tokens.iter().any(is_sign) {
        return tokens;
    }
    let mut all = Vec::with_capacity(2 * tokens.len());
    let mut depth = 0_usize;
    let parts = tokens.split_inclusive(|token| {
        match token.kind {
            Kind::Open | Kind::Begin(_) | Kind::Char('(' | '[') => depth += 1,
            Kind::Close | Kind::Finish(_) | Kind::Char(')' | ']') => {
                depth = depth.saturating_sub(1);
            }
            _ => {}
        }
        depth == 0 && matches!(token.kind, Kind::Wide | Kind::And | Kind::Char(',' | ';'))
    });
    for part in parts {
        let relates = |token: &Token<'_>| matches!(token.kind, Kind::Relation(..));
        let (upper, lower) = (with(part, false), with(part, true));
        match (upper, lower, part.last()) {
            (Some(mut upper), Some(lower), Some(&last)) if part.iter().any(relates) => {
                // A full stop ends both.
                let ends = |token: &Token<'_>| token.kind == Kind::Char('.');
                while upper.last().is_some_and(ends) {
                    upper.pop();
                }
                all.extend(upper);
                all.push(Token {
                    kind: Kind::Wide,
                    ..last
                });
                all.extend(lower);
            }
            _ => match in_numbers(part) {
                Some(numbers) => all.extend(numbers),
                None => all.extend(part),
            },
        }
    }
    all
}

/// `x = a \pm b = -0.40 \pm 0.30j`: what `x` is, and what each of the two comes to in complex numbers. `1.5 \pm 0.1` has no unit, and is one value.
fn in_numbers<'s>(part: &[Token<'s>]) -> Option<Vec<Token<'s>>> {
    let equals = |token: &Token<'_>| matches!(token.kind, Kind::Relation(..));
    let mut signs = (0..part.len()).filter(|&at| equals(&part[at]));
    let (Some(first), Some(second), None) = (signs.next(), signs.next(), signs.next()) else {
        return None;
    };
    let (name, of, numbers) = (&part[..first], &part[first + 1..second], &part[second..]);
    let has_sign = |tokens: &[Token<'_>]| tokens.iter().any(is_sign);
    let is_unit = |token: &Token<'_>| matches!(token.kind, Kind::Letter('i' | 'j'));
    let is_number = |token: &Token<'_>| {
        let plain = matches!(
            token.kind,
            Kind::Number(_) | Kind::Quantity(..) | Kind::Upright(_) | Kind::Text(_) | Kind::Wide
        );
        plain || is_unit(token) || is_sign(token) || equals(token) || is_part_of_a_number(token)
    };
    let complex = numbers.iter().any(is_unit) && numbers.iter().all(is_number);
    if has_sign(name) || !has_sign(of) || !has_sign(numbers) || !complex {
        return None;
    }
    let parted = |lower| {
        let sign = |token: &Token<'s>| match is_sign(token) {
            true => signed(*token, lower),
            false => *token,
        };
        part[first + 1..].iter().map(sign).collect::<Vec<_>>()
    };
    let wide = Token {
        kind: Kind::Wide,
        ..part[second]
    };
    let mut upper = parted(false);
    while upper.last().is_some_and(ends_a_statement) {
        upper.pop();
    }
    let said = part[..second].iter().copied();
    Some(
        said.chain([wide])
            .chain(upper)
            .chain([wide])
            .chain(parted(true))
            .collect(),
    )
}

/// Whether a token may stand in a number with its units, or ends a statement.
fn is_part_of_a_number(token: &Token<'_>) -> bool {
    matches!(token.kind, Kind::Char('-' | '.' | ',' | ';' | '/' | '^'))
}

fn ends_a_statement(token: &Token<'_>) -> bool {
    matches!(token.kind, Kind::Char('.' | ',' | ';') | Kind::Wide)
}

/// A `\pm` or `\mp` as one of both signs.
fn signed(token: Token<'_>, lower: bool) -> Token<'_> {
    let minus = (token.kind == Kind::Command("mp")) != lower;
    let kind = Kind::Char(if minus { '-' } else { '+' });
    Token { kind, ..token }
}

fn is_sign(token: &Token<'_>) -> bool {
    matches!(token.kind, Kind::Command("pm" | "mp"))
}

/// A statement with one of both signs throughout; `None` where no index tells them apart.
fn with<'s>(part: &[Token<'s>], lower: bool) -> Option<Vec<Token<'s>>> {
    let (mut read, mut at, mut indexed) = (Vec::with_capacity(part.len()), 0, false);
    let has_sign = part.iter().any(is_sign);
    while let Some(&token) = part.get(at) {
        let signed = |token: Token<'s>| signed(token, lower);
        let braced = |kind: Kind<'s>| Token { kind, ..token };
        let kinds: Vec<Kind<'s>> = part[at..].iter().take(6).map(|own| own.kind).collect();
        let is_index = matches!(token.kind, Kind::Char('_' | '^'));
        match kinds[..] {
            [_, Kind::Command("pm" | "mp"), ..] if is_index => {
                let index = [token, braced(Kind::Open), signed(part[at + 1])];
                read.extend(index);
                read.push(braced(Kind::Close));
                (indexed, at) = (true, at + 2);
            }
            [_, Kind::Open, Kind::Command("pm" | "mp"), Kind::Close, ..] if is_index => {
                let index = [token, part[at + 1], signed(part[at + 2]), part[at + 3]];
                read.extend(index);
                (indexed, at) = (true, at + 4);
            }
            [
                Kind::Char('_'),
                Kind::Open,
                Kind::Number("1"),
                Kind::Char(','),
                Kind::Number("2"),
                Kind::Close,
            ] if has_sign => {
                let number = part[at + if lower { 4 } else { 2 }];
                read.extend([token, part[at + 1], number, part[at + 5]]);
                (indexed, at) = (true, at + 6);
            }
            _ => {
                read.push(match is_sign(&token) {
                    true => signed(token),
                    false => token,
                });
                at += 1;
            }
        }
    }
    indexed.then_some(read)
}
