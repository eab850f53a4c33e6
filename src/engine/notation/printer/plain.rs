//! One line of plain text for a terminal: `v′₁ = (m₁ - m₂)/(m₁ + m₂) v₀`.
//!
//! Digits in scripts have their own characters; anything else stands after `_` or `^`, as in `E_{total}` and `δ^(3/2)`.

use super::bracketed::{Bracketed, Piece};
use super::decimal;
use crate::algebra::{Expr, Formula, Function, LimitPoint, Relation, Symbol};
use crate::notation::commands::{self, ACCENTS, LETTERS, SUBSCRIPTS};
use crate::notation::{Clause, Connective, Statement};
use num_traits::{One, Signed};

/// A symbol as one line of text: `θ₀`.
pub fn plain_symbol(symbol: &Symbol) -> String {
    plain(&Expr::Symbol(symbol.clone()))
}

/// A term as one line of text.
pub fn plain(expr: &Expr) -> String {
    match expr {
        Expr::Sum(terms) => {
            let mut text = String::new();
            for (at, term) in terms.iter().enumerate() {
                let (sign, term) = match term {
                    Expr::Negate(inner) => ("−", &**inner),
                    term => ("+", term),
                };
                match (at, sign) {
                    (0, "+") => {}
                    (0, sign) => text.push_str(sign),
                    (_, sign) => text.push_str(&format!(" {sign} ")),
                }
                text.push_str(&product(term));
            }
            text
        }
        Expr::Negate(inner) => format!("−{}", product(inner)),
        Expr::Number(number) if number.is_negative() => {
            format!("−{}", plain(&Expr::Number(-number)))
        }
        _ => product(expr),
    }
}

/// A statement as one line of text.
pub fn plain_statement(statement: &Statement) -> String {
    let mut text = String::new();
    for (at, clause) in statement.clauses.iter().enumerate() {
        if at > 0 {
            text += match statement.connectives[at - 1].value {
                Connective::Implies => " ⇒ ",
                Connective::Equivalent => " ⇔ ",
            };
        }
        text += &plain_clause(clause);
    }
    for (at, condition) in statement.under.iter().enumerate() {
        text += if at == 0 { " if " } else { " and " };
        text += &plain_clause(condition);
    }
    text
}

fn plain_clause(clause: &Clause) -> String {
    match clause {
        Clause::Chain { sides, links } => {
            let mut text = sides
                .first()
                .map_or(String::new(), |side| plain(&side.expr));
            for (link, side) in links.iter().zip(sides.iter().skip(1)) {
                text += " ";
                text += relation_sign(link.relation);
                text += " ";
                text += &plain(&side.expr);
            }
            text
        }
        Clause::AllEqual {
            sequence,
            to,
            value,
            ..
        } => all_equal(sequence, to, value.as_ref().map(|side| &side.expr)),
    }
}

/// A formula as one line of text.
pub fn plain_formula(formula: &Formula) -> String {
    match formula {
        Formula::Relation {
            left,
            relation,
            right,
        } => {
            format!(
                "{} {} {}",
                plain(left),
                relation_sign(*relation),
                plain(right)
            )
        }
        Formula::AllEqual {
            sequence,
            to,
            value,
        } => all_equal(sequence, to, value.as_ref()),
    }
}

fn all_equal(sequence: &Symbol, to: &Expr, value: Option<&Expr>) -> String {
    let stem = name(sequence.name());
    let value = value.map_or(String::new(), |value| format!(" = {}", plain(value)));
    format!("{stem}₁ = … = {stem}{}{value}", subscript(&plain(to)))
}

fn relation_sign(relation: Relation) -> &'static str {
    match relation {
        Relation::Equal => "=",
        Relation::NotEqual => "≠",
        Relation::Less => "<",
        Relation::LessOrEqual => "≤",
        Relation::Greater => ">",
        Relation::GreaterOrEqual => "≥",
        Relation::Scales => "~",
        Relation::Proportional => "∝",
        Relation::Approximately => "≈",
        Relation::Tends => "→",
        Relation::MuchLess => "≪",
        Relation::MuchGreater => "≫",
    }
}

fn product(expr: &Expr) -> String {
    match expr {
        Expr::Product(factors) => {
            let mut text = String::new();
            for (at, item) in factors.iter().enumerate() {
                let printed = factor(item, at + 1 == factors.len());
                let digit = printed.starts_with(|c: char| c.is_ascii_digit());
                text.push_str(if at == 0 {
                    ""
                } else if digit {
                    "·"
                } else {
                    " "
                });
                text.push_str(&printed);
            }
            text
        }
        Expr::Quotient(over, under) => format!("{}/{}", of_stroke(over), of_stroke(under)),
        Expr::Sum(_) | Expr::Negate(_) => format!("({})", plain(expr)),
        _ => factor(expr, true),
    }
}

/// What needs no parentheses beside `/` or under `^`.
fn atom(expr: &Expr) -> String {
    match expr {
        Expr::Quotient(..)
        | Expr::Product(_)
        | Expr::Series { .. }
        | Expr::Limit { .. }
        | Expr::Integral { .. } => {
            format!("({})", plain(expr))
        }
        _ => factor(expr, false),
    }
}

fn factor(expr: &Expr, last: bool) -> String {
    match expr {
        Expr::Number(number) if !number.is_negative() => match decimal(number) {
            Some(numeral) => numeral,
            None => format!("({number})"),
        },
        Expr::Symbol(symbol) => name(symbol.name()),
        Expr::Element { sequence, index } => {
            format!("{}_{}", name(sequence.name()), name(index.name()))
        }
        Expr::Power(base, exponent) => power(base, exponent),
        Expr::Call(function, argument) => {
            let inner = plain(argument);
            match function {
                Function::Sin => format!("sin({inner})"),
                Function::Cos => format!("cos({inner})"),
                Function::Tan => format!("tan({inner})"),
                Function::ArcSin => format!("arcsin({inner})"),
                Function::ArcCos => format!("arccos({inner})"),
                Function::ArcTan => format!("arctan({inner})"),
                Function::Exp => format!("exp({inner})"),
                Function::Ln => format!("ln({inner})"),
                Function::Abs => format!("|{inner}|"),
                Function::Ceiling => format!("⌈{inner}⌉"),
                Function::Floor => format!("⌊{inner}⌋"),
            }
        }
        Expr::Apply(function, arguments) => {
            let arguments: Vec<String> = arguments.iter().map(plain).collect();
            format!("{}({})", name(function.name()), arguments.join(", "))
        }
        Expr::Derivative { body, variable } if variable.is_change() => match **body {
            Expr::Symbol(_) => format!("d{}", plain(body)),
            _ => format!("d({})", plain(body)),
        },
        Expr::Derivative { body, variable } if matches!(**body, Expr::Symbol(_)) => {
            format!("d{}/d{}", plain(body), name(variable.name()))
        }
        Expr::Derivative { body, variable } => {
            format!("d/d{} [{}]", name(variable.name()), plain(body))
        }
        Expr::Partial { body, variable, .. } => {
            let variable = name(variable.name());
            let slope = match **body {
                Expr::Symbol(_) => format!("∂{}/∂{variable}", plain(body)),
                _ => format!("∂/∂{variable} [{}]", plain(body)),
            };
            let held: Vec<String> = expr.held().iter().map(|own| name(own.name())).collect();
            match held.is_empty() {
                true => slope,
                false => format!("({slope})_{{{}}}", held.join(", ")),
            }
        }
        Expr::Sum(_)
        | Expr::Negate(_)
        | Expr::Product(_)
        | Expr::Quotient(..)
        | Expr::Number(_) => {
            format!("({})", plain(expr))
        }
        _ if !last => format!("({})", plain(expr)),
        Expr::Series {
            index,
            from,
            to,
            body,
        } => {
            format!(
                "Σ_{{{}={}}}^{{{}}} {}",
                name(index.name()),
                plain(from),
                plain(to),
                product(body)
            )
        }
        Expr::Limit {
            body,
            variable,
            point,
        } => {
            let point = match point {
                LimitPoint::Finite(point) => plain(point),
                LimitPoint::PlusInfinity => "∞".to_owned(),
                LimitPoint::MinusInfinity => "−∞".to_owned(),
            };
            format!(
                "lim_{{{}→{point}}} {}",
                name(variable.name()),
                product(body)
            )
        }
        Expr::Integral {
            body,
            variable,
            from,
            to,
        } => {
            let (from, to) = (plain(from), plain(to));
            format!(
                "∫_{{{from}}}^{{{to}}} {} d{}",
                product(body),
                name(variable.name())
            )
        }
    }
}

/// What stands beside a stroke; a slope has one of its own.
fn of_stroke(expr: &Expr) -> String {
    match expr {
        Expr::Derivative { .. } | Expr::Partial { .. } => format!("({})", plain(expr)),
        expr => atom(expr),
    }
}

fn power(base: &Expr, exponent: &Expr) -> String {
    if let Expr::Number(number) = exponent
        && !number.is_integer()
        && number.numer().is_one()
    {
        let root = match number.denom().to_string().as_str() {
            "2" => "√".to_owned(),
            degree => format!("{}√", superscript_digits(degree).unwrap_or_default()),
        };
        return format!("{root}{}", atom(base));
    }
    let base = match base {
        Expr::Power(..) | Expr::Derivative { .. } | Expr::Partial { .. } => {
            format!("({})", plain(base))
        }
        _ => atom(base),
    };
    let exponent = plain(exponent);
    match superscript_digits(&exponent) {
        Some(digits) => format!("{base}{digits}"),
        None if exponent.chars().count() == 1 => format!("{base}^{exponent}"),
        None => format!("{base}^({exponent})"),
    }
}

fn superscript_digits(text: &str) -> Option<String> {
    let digits = "⁰¹²³⁴⁵⁶⁷⁸⁹";
    text.chars()
        .map(|c| match c {
            '−' => Some('⁻'),
            c => c
                .to_digit(10)
                .and_then(|digit| digits.chars().nth(digit as usize)),
        })
        .collect()
}

/// Text in the notation of [`plain`] for those who do not read LaTeX: no braces around what stands high or low, and
/// parentheses where its end would not be seen.
///
/// ```
/// # use cradle_engine::notation::unbraced;
/// assert_eq!(unbraced("E_{after} = e² E₀"), "E_after = e² E₀");
/// assert_eq!(unbraced("Σ_{i=1}^{k} u_i"), "Σ_(i=1)^k u_i");
/// ```
pub fn unbraced(text: &str) -> String {
    let mut shown = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(at) = rest.find("_{").into_iter().chain(rest.find("^{")).min() {
        let (before, script) = rest.split_at(at);
        let Some(end) = script.find('}') else {
            break;
        };
        let (sign, content) = (&script[..1], &script[2..end]);
        rest = &script[end + 1..];
        let is_word = content.chars().all(char::is_alphanumeric) && !content.is_empty();
        let is_seen = !rest.starts_with(char::is_alphanumeric);
        shown += before;
        shown += sign;
        shown += &match is_word && is_seen {
            true => content.to_owned(),
            false => format!("({content})"),
        };
    }
    shown + rest
}

fn subscript(text: &str) -> String {
    let digits: Option<String> = text
        .chars()
        .map(|c| c.to_digit(10).and_then(|d| char::from_u32(0x2080 + d)))
        .collect();
    match digits {
        Some(digits) => digits,
        None if text.chars().count() == 1 => format!("_{text}"),
        None => format!("_{{{text}}}"),
    }
}

/// A canonical name as text: `v'_1` is `v′₁`, `\Delta E_{\text{total}}` is `ΔE_{total}`.
fn name(canonical: &str) -> String {
    use crate::algebra::{as_printed, split_subscript};
    let (canonical, _) = as_printed(canonical);
    let canonical = &*canonical;
    if let Some(own) = Bracketed::of(canonical) {
        return bracketed(&own);
    }
    match split_subscript(canonical) {
        Some((stem, under)) => format!("{}{}", letters(stem), subscript(&letters(under))),
        None => letters(canonical),
    }
}

/// `⟨x²⟩`, `Cov(X, Y)`, `P(X > 3)`, `[CO₃²⁻]`.
fn bracketed(own: &Bracketed) -> String {
    let content: String = match own.is_concentration() {
        true => species(own.content()),
        false => own.pieces().iter().map(piece).collect(),
    };
    let (open, close) = own.around;
    // What is below the brackets is read as it is below a letter.
    let scripts = name(&format!("x{}", own.scripts));
    let scripts = scripts.strip_prefix('x').unwrap_or("");
    format!("{}{open}{content}{close}{scripts}", letters(own.head))
}

fn piece(piece: &Piece) -> String {
    match piece {
        Piece::Term(Ok(term)) => plain(term),
        Piece::Term(Err(text)) => letters(text),
        Piece::Relation(relation) => format!(" {} ", relation_sign(*relation)),
        Piece::Sign(sign) => (*sign).to_owned(),
    }
}

/// A chemical formula: `CO₃²⁻`.
fn species(canonical: &str) -> String {
    let (word, charge) = canonical.split_once('^').unwrap_or((canonical, ""));
    let below = |c: char| match c.to_digit(10) {
        Some(digit) => char::from_u32(0x2080 + digit).unwrap_or(c),
        None => c,
    };
    let above = |c: char| match c {
        '+' => Some("⁺".to_owned()),
        '-' => Some("⁻".to_owned()),
        c => superscript_digits(&c.to_string()),
    };
    let word = letters(word).chars().map(below).collect::<String>();
    word + &charge.chars().filter_map(above).collect::<String>()
}

fn letters(mut rest: &str) -> String {
    let mut text = String::with_capacity(rest.len());
    // Each accent waits for the brace that closes over its letter.
    let mut waiting: Vec<&str> = Vec::new();
    while let Some(c) = rest.chars().next() {
        rest = rest.get(c.len_utf8()..).unwrap_or("");
        match c {
            '\\' => {
                let length = rest
                    .find(|c: char| !c.is_ascii_alphabetic())
                    .unwrap_or(rest.len());
                let (command, after) = rest.split_at(length);
                rest = after;
                let letter = commands::find(LETTERS, command)
                    .or_else(|| commands::find(SUBSCRIPTS, command));
                if let Some(accent) = commands::find(ACCENTS, command) {
                    waiting.push(accent);
                    rest = rest.strip_prefix('{').unwrap_or(rest);
                } else if let Some(letter) = letter {
                    text.push_str(letter);
                } else if command == "dagger" {
                    text.push('†');
                } else if command == "star" {
                    text.push('⋆');
                } else if command == "circ" {
                    text.push('°');
                } else if command == "text" || command == "unit" {
                    waiting.push("");
                    rest = rest.strip_prefix('{').unwrap_or(rest);
                }
            }
            '}' => text.push_str(waiting.pop().unwrap_or("")),
            '\'' => text.push('′'),
            // The label of `E^{\text{kin}}`.
            '^' if rest.trim_start_matches('{').starts_with("\\text") => text.push('^'),
            '^' | '{' => {}
            ' ' if waiting.is_empty() => {}
            c => text.push(c),
        }
    }
    text
}
