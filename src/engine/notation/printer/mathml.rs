//! Presentation MathML: what a browser typesets and reads aloud.
//!
//! It walks terms as the LaTeX printer does and sets parentheses where that does, so that page and LaTeX say the same.
//! What comes out is a sequence of elements without the `<math>` around them. Names are text to a browser, whatever
//! characters they hold; what is multiplied or applied without a sign is marked so for readers that speak.

mod name;

use num_traits::{One, Signed};

use self::name::Name;
use super::decimal;
use super::latex::is_signed;
use super::xml::escape;
use crate::algebra::{BigRational, Expr, Formula, Function, LimitPoint, Relation, Symbol};
use crate::notation::{Clause, Connective, Mark, Statement, measured};

/// Side by side, and a product.
const TIMES: &str = "<mo>\u{2062}</mo>";
/// A function and its argument.
const APPLIED: &str = "<mo>\u{2061}</mo>";
/// Between a number and its unit, and between units.
const THIN: &str = "<mspace width=\"0.17em\"/>";
const WIDE: &str = "<mspace width=\"2em\"/>";

/// A term.
pub fn mathml(expr: &Expr) -> String {
    let Expr::Sum(terms) = expr else {
        return signed(expr);
    };
    let mut text = String::new();
    for (at, term) in terms.iter().enumerate() {
        let (sign, term) = match term {
            Expr::Negate(inner) => ("<mo>−</mo>", &**inner),
            term if at > 0 => ("<mo>+</mo>", term),
            term => ("", term),
        };
        text += sign;
        text += &product(term);
    }
    text
}

/// A statement that is true or false at a point.
pub fn mathml_formula(formula: &Formula) -> String {
    match formula {
        Formula::Relation {
            left,
            relation,
            right,
        } => format!("{}{}{}", mathml(left), sign(*relation), mathml(right)),
        Formula::AllEqual {
            sequence,
            to,
            value,
        } => all_equal(sequence, to, value.as_ref()),
    }
}

/// A whole statement with its leading words and its author's mark.
pub fn mathml_statement(statement: &Statement) -> String {
    let mut text = String::new();
    if let Some(label) = &statement.label {
        text += &format!("<mtext>{}:</mtext>{WIDE}", escape(label));
    }
    for (at, clause) in statement.clauses.iter().enumerate() {
        let joined = at
            .checked_sub(1)
            .and_then(|at| statement.connectives.get(at));
        text += match joined.map(|connective| connective.value) {
            Some(Connective::Implies) => "<mo>⇒</mo>",
            Some(Connective::Equivalent) => "<mo>⟺</mo>",
            None => "",
        };
        text += &self::clause(clause);
    }
    for (at, condition) in statement.under.iter().enumerate() {
        text += &match at {
            0 => format!("{WIDE}<mtext>if&#160;</mtext>"),
            _ => "<mtext>&#160;and&#160;</mtext>".to_owned(),
        };
        text += &self::clause(condition);
    }
    text += &match statement.mark.as_ref().map(|mark| mark.value) {
        Some(Mark::Tick) => format!("{WIDE}<mtext>✓</mtext>"),
        Some(Mark::Cross) => format!("{WIDE}<mtext>✗</mtext>"),
        None => String::new(),
    };
    text
}

fn clause(clause: &Clause) -> String {
    match clause {
        Clause::Chain { sides, links } => {
            let mut text = String::new();
            for (at, side) in sides.iter().enumerate() {
                if let Some(link) = at.checked_sub(1).and_then(|at| links.get(at)) {
                    let sign = sign(link.relation);
                    text += &match link.questioned {
                        true => format!("<mover>{sign}<mo>?</mo></mover>"),
                        false => sign,
                    };
                }
                text += &mathml(&side.expr);
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
    let element = |index: String| {
        let mut name = Name::of(sequence.name());
        name.subscript = Some(index);
        name.markup()
    };
    let value = value.map_or(String::new(), |value| {
        format!("<mo>=</mo>{}", mathml(value))
    });
    format!(
        "{}<mo>=</mo><mi>⋯</mi><mo>=</mo>{}{value}",
        element("<mn>1</mn>".into()),
        element(row(to))
    )
}

fn sign(relation: Relation) -> String {
    let sign = match relation {
        Relation::Equal => "=",
        Relation::NotEqual => "≠",
        Relation::Less => "&lt;",
        Relation::LessOrEqual => "≤",
        Relation::Greater => "&gt;",
        Relation::GreaterOrEqual => "≥",
        Relation::Scales => "∼",
        Relation::Proportional => "∝",
        Relation::Approximately => "≈",
        Relation::Tends => "→",
        Relation::MuchLess => "≪",
        Relation::MuchGreater => "≫",
    };
    format!("<mo>{sign}</mo>")
}

fn signed(expr: &Expr) -> String {
    match expr {
        Expr::Negate(inner) => format!("<mo>−</mo>{}", product(inner)),
        Expr::Number(number) if number.is_negative() => {
            format!("<mo>−</mo>{}", numeral(&-number))
        }
        _ => product(expr),
    }
}

/// A term as it stands between `+` signs.
fn product(expr: &Expr) -> String {
    let Expr::Product(factors) = expr else {
        return match is_signed(expr) {
            true => parentheses(expr),
            false => factor(expr, true),
        };
    };
    let mut text = String::new();
    for (at, item) in factors.iter().enumerate() {
        if let Some(before) = at.checked_sub(1).and_then(|at| factors.get(at)) {
            text += match shows_dot(before, item) {
                _ if is_unit(item) => THIN,
                true => "<mo>⋅</mo>",
                false => TIMES,
            };
        }
        text += &factor(item, at + 1 == factors.len());
    }
    text
}

/// Whether a term is a unit: a base unit, a power of one, a product of such.
fn is_unit(expr: &Expr) -> bool {
    match expr {
        Expr::Symbol(symbol) => measured(symbol).is_some(),
        Expr::Power(base, _) => is_unit(base),
        Expr::Product(factors) => factors.iter().all(is_unit),
        _ => false,
    }
}

/// Whether two factors side by side would be read as something else.
fn shows_dot(before: &Expr, item: &Expr) -> bool {
    let starts_with_digit = match item {
        Expr::Number(_) => true,
        Expr::Power(base, exponent) => {
            matches!(**base, Expr::Number(_)) && root(exponent).is_none()
        }
        _ => false,
    };
    let is_fraction = matches!(item, Expr::Quotient(..));
    let is_differential =
        |symbol: &Symbol| symbol.name() == "d" || symbol.name().ends_with("\\Delta");
    starts_with_digit
        || matches!(before, Expr::Number(_)) && is_fraction
        || matches!(before, Expr::Symbol(symbol) if is_differential(symbol))
}

/// A term as a factor; `last` says whether what runs on to the right may stand bare.
fn factor(expr: &Expr, last: bool) -> String {
    match expr {
        Expr::Product(_) if is_unit(expr) => product(expr),
        Expr::Sum(_) | Expr::Negate(_) | Expr::Product(_) => parentheses(expr),
        Expr::Number(number) if number.is_negative() => parentheses(expr),
        Expr::Number(number) => numeral(number),
        Expr::Symbol(symbol) => Name::of(symbol.name()).markup(),
        Expr::Element { sequence, index } => element(sequence, index).markup(),
        Expr::Quotient(over, under) => fraction(&mathml(over), &mathml(under)),
        Expr::Power(base, exponent) => power(base, exponent),
        Expr::Call(function, argument) => call(*function, argument),
        Expr::Apply(function, arguments) => {
            let arguments: Vec<String> = arguments.iter().map(mathml).collect();
            format!(
                "{}{APPLIED}<mrow><mo>(</mo>{}<mo>)</mo></mrow>",
                Name::of(function.name()).markup(),
                arguments.join("<mo>,</mo>")
            )
        }
        Expr::Derivative { body, variable } if variable.is_change() => match **body {
            Expr::Symbol(_) => format!("<mi>d</mi>{}", mathml(body)),
            _ => format!("<mi>d</mi>{}", parentheses(body)),
        },
        Expr::Derivative { body, variable } if matches!(**body, Expr::Symbol(_)) => fraction(
            &format!("<mi>d</mi>{}", mathml(body)),
            &differential(variable),
        ),
        Expr::Partial {
            body, held: None, ..
        } if !last && !matches!(**body, Expr::Symbol(_)) => parentheses(expr),
        Expr::Partial { body, variable, .. } => {
            let below = format!("<mi>∂</mi>{}", Name::of(variable.name()).markup());
            let slope = match **body {
                Expr::Symbol(_) => fraction(&format!("<mi>∂</mi>{}", mathml(body)), &below),
                _ => format!(
                    "{}<mrow><mo>[</mo>{}<mo>]</mo></mrow>",
                    fraction("<mi>∂</mi>", &below),
                    mathml(body)
                ),
            };
            let held = expr.held().iter().map(|own| Name::of(own.name()).markup());
            let held: Vec<String> = held.collect();
            match held.is_empty() {
                true => slope,
                false => format!(
                    "<msub><mrow><mo>(</mo>{slope}<mo>)</mo></mrow><mrow>{}</mrow></msub>",
                    held.join("<mo>,</mo>")
                ),
            }
        }
        _ if !last => parentheses(expr),
        Expr::Derivative { body, variable } => format!(
            "{}<mrow><mo>[</mo>{}<mo>]</mo></mrow>",
            fraction("<mi>d</mi>", &differential(variable)),
            mathml(body)
        ),
        Expr::Series {
            index,
            from,
            to,
            body,
        } => format!(
            "<munderover><mo>∑</mo><mrow>{}<mo>=</mo>{}</mrow>{}</munderover>{}",
            Name::of(index.name()).markup(),
            mathml(from),
            row(to),
            product(body)
        ),
        Expr::Limit {
            body,
            variable,
            point,
        } => {
            let point = match point {
                LimitPoint::Finite(point) => mathml(point),
                LimitPoint::PlusInfinity => "<mi>∞</mi>".to_owned(),
                LimitPoint::MinusInfinity => "<mo>−</mo><mi>∞</mi>".to_owned(),
            };
            format!(
                "<munder><mo movablelimits=\"true\">lim</mo><mrow>{}<mo>→</mo>{point}</mrow></munder>{APPLIED}{}",
                Name::of(variable.name()).markup(),
                product(body)
            )
        }
        Expr::Integral {
            body,
            variable,
            from,
            to,
        } => {
            let body = match **body {
                Expr::Integral { .. } => parentheses(body),
                _ => product(body),
            };
            format!(
                "<msubsup><mo>∫</mo>{}{}</msubsup>{body}<mspace width=\"0.17em\"/>{}",
                row(from),
                row(to),
                differential(variable)
            )
        }
    }
}

fn differential(variable: &Symbol) -> String {
    format!("<mi>d</mi>{}", Name::of(variable.name()).markup())
}

fn element(sequence: &Symbol, index: &Symbol) -> Name {
    let mut name = Name::of(sequence.name());
    name.subscript = Some(Name::of(index.name()).markup());
    name
}

fn fraction(over: &str, under: &str) -> String {
    format!("<mfrac><mrow>{over}</mrow><mrow>{under}</mrow></mfrac>")
}

fn numeral(number: &BigRational) -> String {
    match decimal(number) {
        Some(numeral) => format!("<mn>{numeral}</mn>"),
        None => format!(
            "<mfrac><mn>{}</mn><mn>{}</mn></mfrac>",
            number.numer(),
            number.denom()
        ),
    }
}

/// A term as one element.
fn row(expr: &Expr) -> String {
    match expr {
        Expr::Symbol(_) | Expr::Element { .. } => mathml(expr),
        Expr::Number(number) if !number.is_negative() => numeral(number),
        _ => format!("<mrow>{}</mrow>", mathml(expr)),
    }
}

fn parentheses(expr: &Expr) -> String {
    format!("<mrow><mo>(</mo>{}<mo>)</mo></mrow>", mathml(expr))
}

fn call(function: Function, argument: &Expr) -> String {
    let inner = mathml(argument);
    let fenced =
        |open: char, close: char| format!("<mrow><mo>{open}</mo>{inner}<mo>{close}</mo></mrow>");
    let word = match function {
        Function::Abs => {
            return format!(
                "<mrow><mo form=\"prefix\" stretchy=\"true\">|</mo>{inner}<mo form=\"postfix\" stretchy=\"true\">|</mo></mrow>"
            );
        }
        Function::Ceiling => return fenced('⌈', '⌉'),
        Function::Floor => return fenced('⌊', '⌋'),
        Function::Sin => "sin",
        Function::Cos => "cos",
        Function::Tan => "tan",
        Function::ArcSin => "arcsin",
        Function::ArcCos => "arccos",
        Function::ArcTan => "arctan",
        Function::Exp => "exp",
        Function::Ln => "ln",
    };
    format!("<mi>{word}</mi>{APPLIED}{}", fenced('(', ')'))
}

/// The degree of the root that an exponent stands for.
fn root(exponent: &Expr) -> Option<String> {
    match exponent {
        Expr::Number(number) if !number.is_integer() && number.numer().is_one() => {
            Some(number.denom().to_string())
        }
        _ => None,
    }
}

fn power(base: &Expr, exponent: &Expr) -> String {
    match root(exponent).as_deref() {
        Some("2") => return format!("<msqrt>{}</msqrt>", mathml(base)),
        Some(degree) => return format!("<mroot>{}<mn>{degree}</mn></mroot>", row(base)),
        None => {}
    }
    let exponent = raised(exponent);
    let base = match base {
        Expr::Symbol(symbol) => return Name::of(symbol.name()).to_the(exponent),
        Expr::Element { sequence, index } => return element(sequence, index).to_the(exponent),
        Expr::Number(number) if !number.is_negative() && decimal(number).is_some() => {
            numeral(number)
        }
        Expr::Call(Function::Abs | Function::Ceiling | Function::Floor, _) => factor(base, true),
        Expr::Apply(..) => format!("<mrow>{}</mrow>", factor(base, true)),
        _ => parentheses(base),
    };
    format!("<msup>{base}{exponent}</msup>")
}

/// An exponent as one element; a fraction of two numerals lies on its side.
fn raised(exponent: &Expr) -> String {
    let (sign, positive) = match exponent {
        Expr::Negate(inner) => ("<mo>−</mo>", &**inner),
        other => ("", other),
    };
    match positive {
        Expr::Quotient(over, under) => match (&**over, &**under) {
            (Expr::Number(over), Expr::Number(under)) => format!(
                "<mrow>{sign}{}<mo>/</mo>{}</mrow>",
                numeral(over),
                numeral(under)
            ),
            _ => row(exponent),
        },
        _ => row(exponent),
    }
}
