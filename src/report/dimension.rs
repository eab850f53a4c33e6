//! Dimensions in words: `Energy`, `Mass × Length² × Time⁻²`, two of them in columns, a change of units.

use crate::algebra::{Base, BigRational, Dimension, Expr, Rational, Symbol};
use crate::audit::Entry;
use crate::derivation::formulas;
use crate::dimension::{base_letter, base_name, names_of};
use crate::kernel::dimension::{Form, Rescaling};
use crate::notation::plain;

use super::{Report, words};

/// What a change of units does to one of two things: `the left side`, by how much.
pub(super) type Grown<'a> = (&'a str, &'a BigRational);

impl Report<'_> {
    /// The dimensions of the relations of a statement, each once, where they are known.
    pub(super) fn dimensions(&self, entry: &Entry) -> Vec<String> {
        let mut all: Vec<String> = Vec::new();
        for formula in self.statement(entry).map(formulas).unwrap_or_default() {
            let dimensions = &self.audit.dimensions;
            let Some(agreement) = dimensions.agreement(self.derivation, entry.equation, &formula)
            else {
                continue;
            };
            for form in agreement
                .sides()
                .iter()
                .flatten()
                .filter(|f| f.dimension().is_some())
            {
                let said = in_full(form);
                if !all.contains(&said) {
                    all.push(said);
                }
            }
        }
        all
    }
}

/// `Mass × Length² × Time⁻² [= Energy, Torque]`
fn in_full(form: &Form) -> String {
    let line = columns(&[(String::new(), form)], &[]).concat();
    line.trim().replace("  [", " [")
}

/// How a dimension is called in a sentence: by its name, or as a product.
pub(super) fn called(form: &Form, unknowns: &[Symbol]) -> String {
    match form.dimension().map(names_of).unwrap_or_default().first() {
        Some(&"pure number") => "a pure number".into(),
        Some(name) => (*name).to_owned(),
        None => cells(form, unknowns)
            .into_iter()
            .flatten()
            .collect::<Vec<_>>()
            .join(" × "),
    }
}

/// The same, by every usual name that a dimension has: `Energy or Torque`.
pub(super) fn every_name(form: &Form, unknowns: &[Symbol]) -> String {
    match form.dimension().map(names_of).unwrap_or_default() {
        names if names.len() > 1 => names.join(" or "),
        _ => called(form, unknowns),
    }
}

/// Dimensions one under another, equal bases in one column, with their names.
pub(super) fn columns(rows: &[(String, &Form)], unknowns: &[Symbol]) -> Vec<String> {
    let width = |texts: &mut dyn Iterator<Item = usize>| texts.max().unwrap_or(0);
    let labels = width(&mut rows.iter().map(|(label, _)| label.chars().count()));
    let all: Vec<Vec<Option<String>>> =
        rows.iter().map(|(_, form)| cells(form, unknowns)).collect();
    let count = width(&mut all.iter().map(Vec::len));
    let cell =
        |row: &[Option<String>], at: usize| row.get(at).cloned().flatten().unwrap_or_default();
    let mut lines: Vec<String> = rows
        .iter()
        .map(|(label, _)| format!("{label:<labels$} "))
        .collect();
    let mut begun = vec![false; rows.len()];
    for at in 0..count {
        let size = width(&mut all.iter().map(|row| cell(row, at).chars().count()));
        if size == 0 {
            continue;
        }
        let any = begun.iter().any(|b| *b);
        for (row, line) in lines.iter_mut().enumerate() {
            let text = cell(&all[row], at);
            let joined = if begun[row] && !text.is_empty() {
                " × "
            } else {
                "   "
            };
            *line += if any { joined } else { "" };
            *line += &format!("{text:<size$}");
            begun[row] |= !text.is_empty();
        }
    }
    for ((_, form), line) in rows.iter().zip(&mut lines) {
        let names = form
            .dimension()
            .map(names_of)
            .unwrap_or_default()
            .join(", ");
        match (names.as_str(), form.is_none()) {
            ("" | "Mass" | "Length" | "Time" | "Current" | "Temperature" | "Amount", _) => {}
            (_, true) => *line += "  [a pure number]",
            (names, false) => *line += &format!("  [= {names}]"),
        }
    }
    lines
        .into_iter()
        .map(|line| line.trim_end().to_owned())
        .collect()
}

/// `Mass`, `Length²`: a place for each base and each unknown, empty where it does not occur.
fn cells(form: &Form, unknowns: &[Symbol]) -> Vec<Option<String>> {
    let mut cells: Vec<Option<String>> = Vec::new();
    for base in Base::ALL {
        let terms: Vec<(Option<&Expr>, &Rational)> = form.known.exponents(base).collect();
        cells.push(match terms.as_slice() {
            [] => None,
            [(None, exponent)] => Some(format!("{}{}", base_name(base), raised(exponent))),
            terms => Some(format!("{}^({})", base_name(base), sum(terms))),
        });
    }
    for (unknown, exponent) in &form.unknowns {
        let name = unknowns
            .get(unknown.0)
            .map_or_else(|| "?".into(), words::symbol);
        cells.push(Some(format!("[{name}]{}", raised(exponent))));
    }
    cells
}

fn raised(exponent: &Rational) -> String {
    if exponent.is_one() {
        return String::new();
    }
    if !exponent.is_integer() {
        return format!("^({exponent})").replace('-', "−");
    }
    let superscript = |c: char| match c {
        '-' => '⁻',
        digit => digit
            .to_digit(10)
            .and_then(|d| "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().nth(d as usize))
            .unwrap_or(digit),
    };
    exponent.to_string().chars().map(superscript).collect()
}

/// `3 γ − 1`
fn sum(terms: &[(Option<&Expr>, &Rational)]) -> String {
    let mut text = String::new();
    for (opaque, factor) in terms.iter().rev() {
        let negative = factor.is_negative();
        text += match (text.is_empty(), negative) {
            (true, false) => "",
            (true, true) => "−",
            (false, false) => " + ",
            (false, true) => " − ",
        };
        let size = factor.abs();
        text += &match opaque {
            None => size.to_string(),
            Some(term) if size.is_one() => plain(term),
            Some(term) => format!("{size} {}", plain(term)),
        };
    }
    text
}

/// `M L^{2} T^{-2}`, as a declaration would spell it; nothing where it could not.
pub(super) fn declared(form: &Form) -> Option<String> {
    let dimension = form.dimension()?;
    let mut factors = Vec::new();
    for base in Base::ALL {
        let exponent = dimension.exponent(base)?;
        match exponent.is_one() {
            true => factors.push(base_letter(base).to_owned()),
            false if exponent.is_zero() => {}
            false => factors.push(format!("{}^{{{exponent}}}", base_letter(base))),
        }
    }
    Some(match factors.is_empty() {
        true => "dimensionless".into(),
        false => factors.join(" "),
    })
}

/// What the right side lacks or has too much of, given left over right, where that has a name or is a power of
/// something with a name.
pub(super) fn missing_factor(quotient: &Dimension) -> Option<String> {
    let inverse = Dimension::none().over(quotient);
    let lacks = |name: String| format!("lacks a factor with the dimension {name}");
    let exceeds = |name: String| format!("has a factor with the dimension {name} too many");
    let (missing, extra) = (simple(quotient), simple(&inverse));
    missing.map(lacks).or_else(|| extra.map(exceeds))
}

fn simple(quotient: &Dimension) -> Option<String> {
    const NAMED: [&str; 8] = [
        "Length",
        "Time",
        "Mass",
        "Velocity",
        "Acceleration",
        "Force",
        "Energy",
        "Density",
    ];
    if let Some(name) = names_of(quotient)
        .first()
        .filter(|name| NAMED.contains(name))
    {
        return Some((*name).to_owned());
    }
    [
        "Length",
        "Time",
        "Mass",
        "Temperature",
        "Current",
        "Velocity",
    ]
    .iter()
    .find_map(|name| {
        let base = crate::dimension::named(&name.to_lowercase())?;
        let ratio = Base::ALL.into_iter().find_map(|b| {
            let own = base.exponent(b).filter(|e| !e.is_zero())?;
            Some(quotient.exponent(b)? / own)
        })?;
        let fits = ratio.is_positive() && base.power(&ratio) == *quotient;
        fits.then(|| format!("{name}{}", raised(&ratio)))
    })
}

/// `measure length in half metres: the left side becomes 4 times as large, the right side 2 times as large`.
pub(super) fn change_of_units(rescaling: &Rescaling, left: &str, right: &str) -> String {
    let (quantity, unit) = match rescaling.base {
        Base::Mass => ("mass", "kilogram"),
        Base::Length => ("length", "metre"),
        Base::Time => ("time", "second"),
        Base::Current => ("current", "ampere"),
        Base::Temperature => ("temperature", "kelvin"),
        Base::Amount => ("amount", "mole"),
        Base::Luminosity => ("luminous intensity", "candela"),
    };
    let units = match rescaling.factor.to_string().as_str() {
        "2" => format!("half {unit}s"),
        "4" => format!("quarter {unit}s"),
        factor => format!("units of 1/{factor} {unit}"),
    };
    let one = BigRational::from_integer(1.into());
    let grown = |(what, factor): Grown<'_>| match factor {
        factor if *factor == one => format!("{what} stays as it is"),
        factor if *factor > one => format!("{what} becomes {factor} times as large"),
        factor => format!("{what} becomes {factor} of what it was"),
    };
    let first = grown((left, &rescaling.left));
    let second = match rescaling.left > one && rescaling.right > one {
        true => format!("{right} {} times", rescaling.right),
        false => grown((right, &rescaling.right)),
    };
    format!("measure {quantity} in {units}: {first}, {second}")
}
