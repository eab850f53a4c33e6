//! Units that stand in the text right after a formula: "with $v = 20$ km/s", "$a = 1.0$ mm", "at $\theta = 30$ degrees".
//!
//! The page leaves them out of its mathematics, and calculates without them. So a number is brought to the units of the SI, of which
//! all others are products, and no unit is added to it: `a = 1.0` of "1.0 mm" is `a = 0.001`.

use std::borrow::Cow;

use num_traits::{One, Zero};

use super::parser::quantity_of;
use super::unit::{Unit, raised_figure};
use super::{Before, BeforeKind, Clause, Statement, figures, unit};
use crate::algebra::{BigRational, Expr, Symbol};
use crate::document::Span;
use crate::sorted::Map;

/// Between a formula and its unit, and between units.
const SPACES: &[&str] = &[" ", "~", "\u{a0}", "\u{202f}", "\\,", "\\ ", "\\;", "\n"];
/// Words that spell units, too: attoseconds, attometres, picohenries.
const ORDINARY: &[&str] = &["as", "am", "a", "pH", "d"];
const DEGREES: &[&str] = &["°", "degree", "degrees", "deg"];
/// No unit has more letters, or parts.
const LONGEST: usize = 24;
const MOST_PARTS: usize = 6;

/// What the number of a formula is multiplied by.
enum Factor {
    /// How much of the SI the unit is, and of what.
    Unit(Unit),
    Degrees,
}

/// Brings the number that statements end in to the units of the SI, if the text goes on with another one.
pub(super) fn in_si(source: &str, body: Span, statements: &mut [Statement]) {
    let Some(statement) = statements.last_mut() else {
        return;
    };
    let Some(Clause::Chain { sides, .. }) = statement.clauses.last_mut() else {
        return;
    };
    let Some(side) = sides.last_mut() else {
        return;
    };
    if let Some((number, by)) = micro(source, body, &side.expr) {
        side.expr = times(number, by);
        return;
    }
    if !is_counted(&side.expr) {
        return;
    }
    let by = match factor_after(source, body.end).or_else(|| factor_of_pair(source, body)) {
        Some(Factor::Unit(unit)) if !unit.number.is_one() => unit.number,
        Some(Factor::Degrees) => {
            side.expr = figures::degrees(side.expr.clone());
            let before = Before {
                name: Symbol::new("\\pi"),
                span: side.span,
                kind: BeforeKind::Degrees,
            };
            return statement.before.push(before);
        }
        _ => return,
    };
    side.expr = times(side.expr.clone(), by);
}

/// Whether a term is worked out from nothing but numbers.
fn is_counted(term: &Expr) -> bool {
    let is_number = |term: &Expr| match term {
        Expr::Number(value) => !value.is_zero(),
        _ => false,
    };
    match term {
        Expr::Negate(inner) => is_number(inner.as_ref()),
        Expr::Product(factors) => factors.iter().all(|own| match own {
            Expr::Power(base, _) => is_number(base),
            own => is_number(own),
        }),
        own => is_number(own),
    }
}

fn times(term: Expr, by: BigRational) -> Expr {
    match term {
        Expr::Number(value) => Expr::Number(value * by),
        Expr::Negate(inner) if matches!(*inner, Expr::Number(_)) => {
            Expr::Negate(times(inner.as_ref().clone(), by).into())
        }
        own => Expr::Product([own, Expr::Number(by)].into()),
    }
}

/// The number of `$d = 0.3\ \mu$m`, and how much of the SI the unit is: the sign of its prefix stands in the formula.
fn micro(source: &str, body: Span, term: &Expr) -> Option<(Expr, BigRational)> {
    let Expr::Product(factors) = term else {
        return None;
    };
    let is_micro = |own: &Expr| matches!(own, Expr::Symbol(name) if name.name() == "\\mu");
    let (_, number) = factors.split_last().filter(|(last, _)| is_micro(last))?;
    let number = match number {
        [only] => only.clone(),
        several => Expr::Product(several.into()),
    };
    let before = source.get(..body.end)?.strip_suffix("\\mu")?;
    let is_spaced = SPACES.iter().any(|own| before.ends_with(own));
    let after = after_formula(source, body.end)?;
    if !is_counted(&number) || !is_spaced || !after.starts_with(|c: char| c.is_ascii_alphabetic()) {
        return None;
    }
    Some((number, unit_at(&format!("µ{}", beginning(after)))?.number))
}

fn factor_after(source: &str, end: usize) -> Option<Factor> {
    let rest = &with_signs(after_formula(source, end)?);
    let (spaced, spaces) = without_spaces(rest);
    let word = &spaced[..length_of_name(spaced)];
    if DEGREES.contains(&word) {
        let scale = without_spaces(&spaced[word.len()..]).0;
        let is_scale = word == "°" && scale.starts_with(['C', 'F']);
        return (!is_scale).then_some(Factor::Degrees);
    }
    let is_sign = spaced.starts_with(['%', '\\']);
    // `$L = 80\,$mm`
    let is_spaced = SPACES.iter().any(|own| source[..end].ends_with(own));
    if spaces == 0 && !is_sign && !is_spaced {
        return None;
    }
    unit_or_per_unit(spaced).map(Factor::Unit)
}

/// What two decimals are said to be per that stand side by side: "$\beta = 0.50$ and $\gamma = 0.20$ per day".
fn factor_of_pair(source: &str, body: Span) -> Option<Factor> {
    let decimal = |text: &str| {
        let (_, value) = text.split_once('=')?;
        let value = value.trim().trim_start_matches('-');
        let (whole, part) = value.split_once('.')?;
        let digits = |own: &str| !own.is_empty() && own.bytes().all(|c| c.is_ascii_digit());
        (digits(whole) && digits(part)).then_some(())
    };
    let rest = beginning(after_formula(source, body.end)?).trim_start();
    let (other, after) = rest
        .strip_prefix("and")?
        .trim_start()
        .strip_prefix('$')?
        .split_once('$')?;
    decimal(source.get(body.range())?)?;
    decimal(other)?;
    let after = after.trim_start();
    let unit = after.starts_with("per ").then(|| unit_or_per_unit(after))?;
    unit.map(Factor::Unit)
}

/// The unit that a text begins with, `t/a`, or what it is per: `$\lambda = 18$ per hour`.
fn unit_or_per_unit(text: &str) -> Option<Unit> {
    match text.strip_prefix("per ") {
        Some(below) => {
            let mut unit = Unit::one();
            unit.times(&unit_at(without_spaces(below).0)?, -1)?;
            Some(unit)
        }
        None => unit_at(text),
    }
}

/// Whether a unit stands beside a formula that ends there.
pub(crate) fn is_in_units(source: &str, end: usize) -> bool {
    factor_after(source, end).is_some()
}

/// The units of the SI in which the number of a formula is that ends there, if the text goes on with a unit.
pub(crate) fn si_beside(source: &str, end: usize) -> Option<Expr> {
    match factor_after(source, end)? {
        Factor::Unit(mut unit) => {
            unit.number = BigRational::one();
            Some(quantity_of(None, &unit))
        }
        Factor::Degrees => None,
    }
}

/// Whether the units that stand beside formulas, which end there, are of one system, so that figures in them can be reckoned with as they are
/// written: tonnes and years, and not hours and minutes.
pub(crate) fn are_of_one_system(source: &str, ends: &[usize]) -> bool {
    let unit = |&end: &usize| {
        let rest = with_signs(after_formula(source, end)?).into_owned();
        unit_or_per_unit(without_spaces(&rest).0)
    };
    let mut open: Vec<Unit> = ends.iter().filter_map(unit).collect();
    let mut known: Map<Symbol, BigRational> = Map::new();
    while !open.is_empty() {
        // A unit with one base that is not known yet says how much of that is one.
        let settles = |own: &Unit| {
            let mut unknown = own.factors().filter(|(base, _)| !known.contains_key(base));
            let first = unknown.next();
            unknown.next().is_none() && first.is_none_or(|(_, power)| power.abs() == 1)
        };
        let Some(at) = open.iter().position(settles) else {
            return false;
        };
        let own = open.remove(at);
        let mut left = own.number.clone();
        let mut unknown = None;
        for (base, power) in own.factors() {
            match known.get(&base) {
                Some(size) => left /= size.pow(power),
                None => unknown = Some((base, power)),
            }
        }
        match unknown {
            Some((base, power)) => {
                known.insert(base, left.pow(power));
            }
            None if left.is_one() => {}
            None => return false,
        }
    }
    true
}

/// What stands behind a formula in the text that ends there.
fn after_formula(source: &str, end: usize) -> Option<&str> {
    let rest = source.get(end..)?;
    match rest.strip_prefix('$') {
        Some(rest) => (!rest.starts_with('$')).then_some(rest),
        None => rest.strip_prefix("\\)"),
    }
}

/// As much of a text as the longest unit may take.
fn beginning(text: &str) -> &str {
    let end = text.char_indices().nth(LONGEST * MOST_PARTS);
    &text[..end.map_or(text.len(), |(at, _)| at)]
}

/// The beginning of a text, with the letters of units that are put as mathematics as they are read: `µF` of `$\mu$F`.
fn with_signs(text: &str) -> Cow<'_, str> {
    const SIGNS: [(&str, &str); 4] = [
        ("$\\mu$", "µ"),
        ("\\textmu ", "µ"),
        ("\\textmu{}", "µ"),
        ("$\\Omega$", "Ω"),
    ];
    let begin = beginning(text);
    match SIGNS.iter().any(|(spelt, _)| begin.contains(spelt)) {
        true => (SIGNS.iter())
            .fold(begin.to_owned(), |text, (spelt, sign)| {
                text.replace(spelt, sign)
            })
            .into(),
        false => text.into(),
    }
}

/// The unit that a text begins with.
fn unit_at(text: &str) -> Option<Unit> {
    let (mut rest, mut spelt, mut found) = (text, String::new(), None);
    let one = BigRational::one();
    for _ in 0..MOST_PARTS {
        let length = length_of_name(rest);
        let (name, after) = rest.split_at(length);
        if name.is_empty() || ORDINARY.contains(&name) {
            break;
        }
        let Some(symbol) = symbol_of(name) else {
            break;
        };
        spelt.push_str(&symbol);
        let (power, after) = power_at(after);
        spelt.push_str(&power);
        let open = spelt.matches('(').count() > spelt.matches(')').count();
        let after = match after.strip_prefix(')') {
            Some(after) if open => {
                spelt.push(')');
                after
            }
            _ => after,
        };
        // Whether K stands below the stroke in `kJ/kg K` is not clear, and makes no odds.
        let is_one = unit::read(&symbol).is_ok_and(|own| own.number == one);
        match unit::read(&spelt) {
            Ok(unit) => found = Some(unit),
            Err(_) if found.is_some() && is_one => {}
            Err(_) => return None,
        }
        let (next, spaces) = without_spaces(after);
        rest = match next.strip_prefix('/') {
            Some(below) => {
                let below = without_spaces(below).0;
                spelt.push('/');
                match below.strip_prefix('(') {
                    Some(inner) => {
                        spelt.push('(');
                        inner
                    }
                    None => below,
                }
            }
            None => match next.strip_prefix("per ") {
                Some(below) if spaces > 0 => {
                    spelt.push('/');
                    below
                }
                _ => {
                    spelt.push('.');
                    let dot = next.strip_prefix('·').or(next.strip_prefix("$\\cdot$"));
                    match dot {
                        Some(next) => without_spaces(next).0,
                        None if spaces > 0 => next,
                        None => break,
                    }
                }
            },
        };
    }
    found
}

/// Units in words with spaces or strokes between them as one unit is spelt, `N.m./rad.` of "N m/rad"; nothing of other words.
pub(super) fn spelt(words: &str) -> Option<String> {
    let mut spelt = String::new();
    let parted = ["/", "(", ")"]
        .into_iter()
        .fold(words.to_owned(), |words, sign| {
            words.replace(sign, &format!(" {sign} "))
        });
    for word in parted.split_whitespace() {
        match word {
            "per" | "/" if !spelt.is_empty() => spelt.push('/'),
            "(" | ")" => spelt.push_str(word),
            "\\AA" => spelt.push_str("Å."),
            _ => {
                let (name, after) = word.split_at(length_of_name(word));
                let (power, after) = power_at(after);
                if name.is_empty() || ORDINARY.contains(&name) || !after.is_empty() {
                    return None;
                }
                spelt.push_str(&symbol_of(name)?);
                spelt.push_str(&power);
                spelt.push('.');
            }
        }
    }
    Some(spelt)
}

/// The letters of a unit, or its sign.
fn length_of_name(text: &str) -> usize {
    let sign = ["\\%", "%", "°"]
        .into_iter()
        .find(|sign| text.starts_with(sign));
    if let Some(sign) = sign {
        return sign.len();
    }
    let end = text.find(|c: char| !c.is_alphabetic());
    match end.unwrap_or(text.len()) {
        length if length <= LONGEST => length,
        _ => 0,
    }
}

/// The symbol of a unit that is written as such or as a word: `km` of "kilometres".
pub(super) fn symbol_of(name: &str) -> Option<String> {
    if name == "\\%" || name == "%" {
        return Some("%".to_owned());
    }
    if unit::is_symbol(&name.replace('μ', "µ")) {
        return Some(name.to_owned());
    }
    let spelt = |word: &str| unit::symbol(word).map(str::to_owned);
    let plural = |word: &str| {
        spelt(word)
            .or_else(|| spelt(word.strip_suffix('s')?))
            .or_else(|| {
                spelt(&format!(
                    "{}re",
                    word.strip_suffix('s').unwrap_or(word).strip_suffix("er")?
                ))
            })
    };
    let word = name.to_lowercase();
    plural(&word).or_else(|| {
        let split = (4..=5).filter_map(|at| Some((word.get(..at)?, word.get(at..)?)));
        let mut split = split.filter_map(|(prefix, rest)| Some((unit::prefix(prefix)?, rest)));
        let (prefix, rest) = split.next()?;
        Some(format!("{prefix}{}", plural(rest)?))
    })
}

/// The power of a unit, `²`, `^{-1}`, `$^{-1}$`, as siunitx writes it, and what follows it.
fn power_at(text: &str) -> (String, &str) {
    let digits = text.strip_prefix('⁻').unwrap_or(text);
    let length = digits
        .find(|c| raised_figure(c).is_none())
        .unwrap_or(digits.len());
    if length > 0 {
        let number: String = digits[..length]
            .chars()
            .filter_map(|c| raised_figure(c).map(|digit| digit.to_string()))
            .collect();
        let sign = if digits.len() < text.len() { "-" } else { "" };
        return (format!("^{{{sign}{number}}}"), &digits[length..]);
    }
    let inner = match text.strip_prefix("$^") {
        Some(inner) => inner.split_once('$'),
        None => text.strip_prefix('^').map(|inner| {
            let end = match inner.strip_prefix('{') {
                Some(braced) => braced.find('}').map_or(0, |at| at + 2),
                None => inner
                    .find(|c: char| c != '-' && !c.is_ascii_digit())
                    .unwrap_or(inner.len()),
            };
            inner.split_at(end)
        }),
    };
    match inner {
        Some((power, after)) => {
            let bare = power.trim_start_matches('{').trim_end_matches('}');
            (format!("^{{{bare}}}"), after)
        }
        None => match text.strip_prefix(" squared") {
            Some(after) => ("^{2}".to_owned(), after),
            None => (String::new(), text),
        },
    }
}

fn without_spaces(text: &str) -> (&str, usize) {
    let (mut rest, mut count) = (text, 0);
    while let Some(after) = SPACES.iter().find_map(|space| rest.strip_prefix(space)) {
        (rest, count) = (after, count + 1);
    }
    (rest, count)
}
