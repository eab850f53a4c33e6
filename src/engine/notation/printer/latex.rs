//! Canonical LaTeX.
//!
//! The law: `read_expr(latex(e)) == e` for every term in the form in which the reader makes terms, that is:
//!
//! - numbers are nonnegative and have a finite decimal numeral, except that the exponent of a root is `1/n`;
//! - sums and products have two or more items; a sum in a sum, or a product in a product, stands in parentheses;
//! - names are canonical, bound indices are single letters, and a symbol whose subscript holds the index of a sum
//!   around it is an [`Expr::Element`];
//! - the arguments of an unknown function are symbols or elements.
//!
//! Any other term is printed too, as what it is worth: `-2` for a negative number, `\frac{1}{3}` for a third.

use super::decimal;
use super::partial::Slope;
use crate::algebra::{
    BigRational, Expr, Formula, Function, LimitPoint, Relation, Symbol, split_subscript,
};
use crate::notation::commands;
use crate::notation::parser::{is_minus_one, stem, with_subscript};
use crate::notation::{Clause, Connective, Mark, Statement};
use num_traits::{One, Signed};

/// A term in canonical LaTeX.
pub fn latex(expr: &Expr) -> String {
    let Expr::Sum(terms) = expr else {
        return signed(expr);
    };
    let mut text = String::new();
    for (at, term) in terms.iter().enumerate() {
        match term {
            Expr::Negate(inner) => {
                text.push_str(if at == 0 { "-" } else { " - " });
                text.push_str(&product(inner));
            }
            term => {
                if at > 0 {
                    text.push_str(" + ");
                }
                text.push_str(&product(term));
            }
        }
    }
    text
}

/// A statement that is true or false at a point, in LaTeX.
pub fn latex_formula(formula: &Formula) -> String {
    match formula {
        Formula::Relation {
            left,
            relation,
            right,
        } => {
            format!(
                "{} {} {}",
                latex(left),
                relation_latex(*relation),
                latex(right)
            )
        }
        Formula::AllEqual {
            sequence,
            to,
            value,
        } => all_equal(sequence, to, value.as_ref()),
    }
}

/// A whole statement in LaTeX, with its label and its mark.
pub fn latex_statement(statement: &Statement) -> String {
    let mut text = String::new();
    if let Some(label) = &statement.label {
        text.push_str(&format!("\\text{{{label}: }} "));
    }
    for (at, clause) in statement.clauses.iter().enumerate() {
        if let Some(connective) = at
            .checked_sub(1)
            .and_then(|at| statement.connectives.get(at))
        {
            text.push_str(match connective.value {
                Connective::Implies => " \\Rightarrow ",
                Connective::Equivalent => " \\iff ",
            });
        }
        text.push_str(&latex_clause(clause));
    }
    for (at, condition) in statement.under.iter().enumerate() {
        text.push_str(match at {
            0 => " \\quad \\text{if } ",
            _ => " \\text{ and } ",
        });
        text.push_str(&latex_clause(condition));
    }
    match statement.mark.as_ref().map(|mark| mark.value) {
        Some(Mark::Tick) => text.push_str(" \\quad \\checkmark"),
        Some(Mark::Cross) => text.push_str(" \\quad \\times"),
        None => {}
    }
    text
}

fn latex_clause(clause: &Clause) -> String {
    match clause {
        Clause::Chain { sides, links } => {
            let mut text = String::new();
            for (at, side) in sides.iter().enumerate() {
                if let Some(link) = at.checked_sub(1).and_then(|at| links.get(at)) {
                    let sign = relation_latex(link.relation);
                    let sign = if link.questioned {
                        format!("\\stackrel{{?}}{{{sign}}}")
                    } else {
                        sign.to_owned()
                    };
                    text.push_str(&format!(" {sign} "));
                }
                text.push_str(&latex(&side.expr));
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

fn all_equal(sequence: &Symbol, to: &Expr, value: Option<&Expr>) -> String {
    let last = with_subscript(&name(sequence), &latex(to));
    let value = value.map_or(String::new(), |value| format!(" = {}", latex(value)));
    format!(
        "{} = \\dots = {last}{value}",
        with_subscript(&name(sequence), "1")
    )
}

/// A relation sign in LaTeX.
pub fn relation_latex(relation: Relation) -> &'static str {
    match relation {
        Relation::Equal => "=",
        Relation::NotEqual => "\\neq",
        Relation::Less => "<",
        Relation::LessOrEqual => "\\leq",
        Relation::Greater => ">",
        Relation::GreaterOrEqual => "\\geq",
        Relation::Scales => "\\sim",
        Relation::Proportional => "\\propto",
        Relation::Approximately => "\\approx",
        Relation::Tends => "\\to",
        Relation::MuchLess => "\\ll",
        Relation::MuchGreater => "\\gg",
    }
}

fn signed(expr: &Expr) -> String {
    match expr {
        Expr::Negate(inner) => format!("-{}", product(inner)),
        Expr::Number(number) if number.is_negative() => format!("-{}", numeral(&-number)),
        _ => product(expr),
    }
}

/// A term as it stands between `+` signs.
fn product(expr: &Expr) -> String {
    let Expr::Product(factors) = expr else {
        return if is_signed(expr) {
            parentheses(expr)
        } else {
            factor(expr, true)
        };
    };
    let mut text = String::new();
    for (at, item) in factors.iter().enumerate() {
        let printed = factor(item, at + 1 == factors.len());
        if let Some(before) = at.checked_sub(1).and_then(|at| factors.get(at)) {
            text.push_str(if needs_dot(before, item, &printed) {
                " \\cdot "
            } else {
                " "
            });
        }
        text.push_str(&printed);
    }
    text
}

pub(super) fn is_signed(expr: &Expr) -> bool {
    matches!(expr, Expr::Sum(_) | Expr::Negate(_))
        || matches!(expr, Expr::Number(n) if n.is_negative())
}

/// Whether two factors side by side would be read as something else.
fn needs_dot(before: &Expr, item: &Expr, printed: &str) -> bool {
    let differential = |symbol: &Symbol| {
        matches!(symbol.name(), "d" | "\\text{d}") || symbol.name().ends_with("\\Delta")
    };
    if printed.starts_with(|c: char| c.is_ascii_digit()) {
        return true;
    }
    // `2 [\text{A}]` may have a unit.
    if printed.starts_with('[') && matches!(before, Expr::Number(_)) {
        return true;
    }
    // `[\text{H} \text{F}]` is a concentration, `\text{Re}(Z) \text{Im}(Z)` is none.
    let is_word = |own: &Symbol| own.name().starts_with("\\text{") && !own.is_part();
    if printed.starts_with("\\text{") && stem(before).is_some_and(is_word) {
        return true;
    }
    let grouped = printed.starts_with('(') || printed.starts_with("\\left(");
    if let Some(name) = stem(before).map(Symbol::name)
        && (commands::is_applied(name) || grouped && commands::is_word(name))
    {
        return true;
    }
    match before {
        Expr::Number(_) => {
            printed.starts_with("\\frac")
                && !matches!(item, Expr::Derivative { .. } | Expr::Partial { .. })
        }
        Expr::Symbol(symbol) if differential(symbol) => true,
        // `f^{-1}(x)` would be an inverse function.
        Expr::Power(base, exponent) if is_minus_one(exponent) => {
            matches!(**base, Expr::Symbol(_) | Expr::Element { .. }) && grouped
        }
        Expr::Symbol(_) | Expr::Element { .. } => {
            matches!(item, Expr::Power(base, _) if matches!(**base, Expr::Symbol(_) | Expr::Element { .. }))
                && printed.starts_with('(')
        }
        _ => false,
    }
}

/// A term as a factor; `last` says whether what runs on to the right may stand bare.
fn factor(expr: &Expr, last: bool) -> String {
    match expr {
        Expr::Sum(_) | Expr::Negate(_) | Expr::Product(_) => parentheses(expr),
        Expr::Number(number) if number.is_negative() => parentheses(expr),
        Expr::Number(number) => numeral(number),
        Expr::Symbol(symbol) => name(symbol).into_owned(),
        Expr::Element { sequence, index } => with_subscript(&name(sequence), &name(index)),
        Expr::Quotient(over, under) => format!("\\frac{{{}}}{{{}}}", latex(over), latex(under)),
        Expr::Power(base, exponent) => power(base, exponent),
        Expr::Call(function, argument) => call(*function, argument),
        Expr::Apply(function, arguments) => {
            let arguments: Vec<String> = arguments.iter().map(latex).collect();
            format!("{}({})", &name(function), arguments.join(", "))
        }
        Expr::Derivative { body, variable } if variable.is_change() => match **body {
            Expr::Symbol(_) => differential(&latex(body)),
            _ => format!("d{}", parentheses(body)),
        },
        // What ends in a parenthesis, `\text{Re}(Z)`, is differentiated as a value of a function is.
        Expr::Derivative { body, variable } if matches!(&**body, Expr::Symbol(own) if !own.name().ends_with(')')) =>
        {
            format!(
                "\\frac{{{}}}{{{}}}",
                differential(&latex(body)),
                differential(&name(variable))
            )
        }
        Expr::Partial { .. } => match Slope::of(expr) {
            slope if slope.held.is_empty() && !slope.is_of_a_name() && !last => parentheses(expr),
            slope => slope.latex(),
        },
        _ if !last => parentheses(expr),
        Expr::Derivative { body, variable } => {
            format!(
                "\\frac{{d}}{{{}}} \\left[ {} \\right]",
                differential(&name(variable)),
                latex(body)
            )
        }
        Expr::Series {
            index,
            from,
            to,
            body,
        } => {
            let (from, to) = (latex(from), latex(to));
            format!(
                "\\sum_{{{} = {from}}}^{{{to}}} {}",
                &name(index),
                product(body)
            )
        }
        Expr::Limit {
            body,
            variable,
            point,
        } => {
            let point = match point {
                LimitPoint::Finite(point) => latex(point),
                LimitPoint::PlusInfinity => "\\infty".to_owned(),
                LimitPoint::MinusInfinity => "-\\infty".to_owned(),
            };
            format!(
                "\\lim_{{{} \\to {point}}} {}",
                &name(variable),
                product(body)
            )
        }
        Expr::Integral {
            body,
            variable,
            from,
            to,
        } => {
            let plain = product(body);
            let hidden = |part: &str| part == "d" || part.starts_with("\\text{d}");
            let closed = matches!(**body, Expr::Integral { .. })
                || plain.ends_with("\\Delta")
                || plain
                    .split(|c: char| c.is_whitespace() || "()[]^_".contains(c))
                    .any(hidden);
            // Not printed anew: integrals in integrals would be printed twice as often at each depth.
            let body = if closed && !is_signed(body) {
                enclosed(&plain)
            } else {
                plain
            };
            let differential = differential(&name(variable));
            format!(
                "\\int_{{{}}}^{{{}}} {body} \\, {differential}",
                latex(from),
                latex(to)
            )
        }
    }
}

fn differential(name: &str) -> String {
    format!("d{name}")
}

fn numeral(number: &BigRational) -> String {
    decimal(number).unwrap_or_else(|| format!("\\frac{{{}}}{{{}}}", number.numer(), number.denom()))
}

fn parentheses(expr: &Expr) -> String {
    enclosed(&latex(expr))
}

fn enclosed(inner: &str) -> String {
    if ["\\frac", "\\sum", "\\int", "\\left"]
        .iter()
        .any(|tall| inner.contains(tall))
    {
        format!("\\left( {inner} \\right)")
    } else {
        format!("({inner})")
    }
}

fn call(function: Function, argument: &Expr) -> String {
    let inner = latex(argument);
    let (open, close) = match function {
        Function::Abs => ("\\left| ", " \\right|"),
        Function::Ceiling => ("\\left\\lceil ", " \\right\\rceil"),
        Function::Floor => ("\\left\\lfloor ", " \\right\\rfloor"),
        Function::Sin => ("\\sin\\left( ", " \\right)"),
        Function::Cos => ("\\cos\\left( ", " \\right)"),
        Function::Tan => ("\\tan\\left( ", " \\right)"),
        Function::ArcSin => ("\\arcsin\\left( ", " \\right)"),
        Function::ArcCos => ("\\arccos\\left( ", " \\right)"),
        Function::ArcTan => ("\\arctan\\left( ", " \\right)"),
        Function::Exp => ("\\exp\\left( ", " \\right)"),
        Function::Ln => ("\\ln\\left( ", " \\right)"),
    };
    format!("{open}{inner}{close}")
}

fn power(base: &Expr, exponent: &Expr) -> String {
    if let Expr::Number(number) = exponent
        && !number.is_integer()
        && number.numer().is_one()
    {
        let degree = number.denom().to_string();
        let degree = if degree == "2" {
            String::new()
        } else {
            format!("[{degree}]")
        };
        return format!("\\sqrt{degree}{{{}}}", latex(base));
    }
    let base = match base {
        Expr::Symbol(symbol) => raised_name(&name(symbol)),
        Expr::Element { sequence, index } => {
            raised_name(&with_subscript(&name(sequence), &name(index)))
        }
        Expr::Number(number) if !number.is_negative() && decimal(number).is_some() => {
            numeral(number)
        }
        Expr::Call(Function::Abs | Function::Ceiling | Function::Floor, _) => factor(base, true),
        Expr::Apply(function, arguments)
            if !arguments.iter().any(raised) && !exponent.mentions(function) =>
        {
            factor(base, true)
        }
        _ => parentheses(base),
    };
    let exponent = match exponent {
        Expr::Negate(inner) => slashed(inner).map(|text| format!("-{text}")),
        _ => slashed(exponent),
    }
    .unwrap_or_else(|| latex(exponent));
    if exponent.chars().count() == 1 {
        format!("{base}^{exponent}")
    } else {
        // `a^{\text{KE}}` would be a name with a label.
        match exponent.starts_with("\\text{") && exponent.ends_with('}') {
            true => format!("{base}^{{{{{exponent}}}}}"),
            false => format!("{base}^{{{exponent}}}"),
        }
    }
}

/// A fraction of two numerals, as it looks best in an exponent.
fn slashed(expr: &Expr) -> Option<String> {
    let Expr::Quotient(over, under) = expr else {
        return None;
    };
    match (&**over, &**under) {
        (Expr::Number(over), Expr::Number(under)) => {
            Some(format!("{}/{}", decimal(over)?, decimal(under)?))
        }
        _ => None,
    }
}

fn raised(expr: &Expr) -> bool {
    matches!(expr, Expr::Symbol(symbol) if symbol.name().contains(['^', ' ']))
}

/// A name that can take a superscript without a second one on the page.
pub(super) fn raised_name(name: &str) -> String {
    let stem = split_subscript(name).map_or(name, |(stem, _)| stem);
    // `\langle x \rangle^2`
    if stem.ends_with([']', ')']) || stem.ends_with("\\rangle") {
        name.to_owned()
    } else if name.contains('^') || name.contains(' ') {
        format!("({name})")
    } else if name.contains('\'') {
        format!("{{{name}}}")
    } else {
        name.to_owned()
    }
}

/// A name as it is printed.
fn name(symbol: &Symbol) -> std::borrow::Cow<'_, str> {
    crate::algebra::as_printed(symbol.name()).0
}
