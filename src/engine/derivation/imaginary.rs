//! The imaginary unit where nobody declares it: what is said with it is said of complex numbers, and claims here are about real ones.
//!
//! `i` is the unit where it stands in the exponent of an exponential, where the text says that something is complex, or that $i^2 = -1$;
//! so is `\mathrm i`. A letter that counts somewhere, as in `\sum_i`, is not taken for it.

use std::collections::BTreeSet;

use crate::algebra::{Expr, Formula, Function, Symbol};

use super::equation::formulas;
use super::page::Page;
use super::{Equation, complex};

/// The letters that stand for it; the upright ones for nothing else.
const UNITS: [(&str, bool); 4] = [
    ("i", false),
    ("j", false),
    ("\\text{i}", true),
    ("\\text{j}", true),
];
/// Words of texts about complex numbers.
const SAID: [&str; 6] = [
    "imaginary",
    "complex",
    "impedance",
    "impedances",
    "phasor",
    "phasors",
];
/// Finds the unit, and takes apart what is said with it; `own` are the pages of one document.
pub(super) fn recognize(own: &[usize], pages: &mut [Page], equations: &mut [Equation]) {
    let mut said: Vec<Formula> = Vec::new();
    for &at in own
        .iter()
        .filter(|&&at| may_speak_of_one(&pages[at], at, equations))
    {
        let of_page = super::equation::of_page(at, equations);
        let statements = equations[of_page].iter().flat_map(Equation::statements);
        said.extend(statements.flat_map(formulas));
        let locals = pages[at].locals.iter().flat_map(|local| &local.formulas);
        said.extend(locals.map(|formula| (**formula).clone()));
    }
    let named: BTreeSet<Symbol> = said.iter().flat_map(Formula::names).collect();
    let is_unit = |&(name, upright): &(&str, bool)| {
        let unit = Symbol::new(name);
        let is_declared = own.iter().any(|&at| pages[at].is_declared(&unit));
        let is_meant =
            || upright || is_told(own, pages) || said.iter().any(|own| shows(own, &unit));
        named.contains(&unit)
            && !is_declared
            && !said.iter().any(|own| counts(own, &unit))
            && is_meant()
    };
    let units = UNITS.iter().filter(|unit| is_unit(unit));
    let units: BTreeSet<Symbol> = units.map(|&(name, _)| Symbol::new(name)).collect();
    if !units.is_empty() {
        complex::take_apart(own, pages, equations, &units);
    }
}

/// Whether one of the letters stands by itself in the displays of a page.
fn may_speak_of_one(page: &Page, at: usize, equations: &[Equation]) -> bool {
    let of_page = super::equation::of_page(at, equations);
    equations[of_page].iter().any(|equation| {
        let text = page.document.text(equation.body);
        text.split(|c: char| !c.is_alphabetic())
            .any(|word| matches!(word, "i" | "j") || word.starts_with(['i', 'j']) && word.len() < 4)
    })
}

/// Whether the text speaks of complex numbers.
fn is_told(own: &[usize], pages: &[Page]) -> bool {
    own.iter().any(|&at| {
        let document = &pages[at].document;
        let mut prose = document.prose();
        prose.any(|prose| {
            let mut words = document
                .text(prose.span)
                .split(|c: char| !c.is_alphabetic());
            words.any(|word| SAID.iter().any(|own| own.eq_ignore_ascii_case(word)))
        })
    })
}

/// Whether a formula can only mean the unit: `e^{i k x}`, `i^2 = -1`.
fn shows(formula: &Formula, unit: &Symbol) -> bool {
    let is_unit = |term: &Expr| matches!(term, Expr::Symbol(own) if own == unit);
    let turns =
        |part: &Expr| matches!(part, Expr::Call(Function::Exp, inner) if inner.mentions(unit));
    let says = formula.as_equation().is_some_and(|(left, right)| {
        let squared =
            matches!(left, Expr::Power(base, two) if is_unit(base) && **two == Expr::integer(2));
        let minus_one = matches!(right, Expr::Negate(one) if **one == Expr::integer(1))
            || *right == Expr::integer(-1);
        squared && minus_one
    });
    let adds = |part: &Expr| is_beside_a_number(part, unit);
    let shown = |part: &Expr| turns(part) || adds(part);
    says || formula.terms().into_iter().any(|term| term.any(&shown))
}

/// Whether a decimal of times the unit is added to a number, `-0.40 + 0.30j`: no quantity is.
fn is_beside_a_number(term: &Expr, unit: &Symbol) -> bool {
    let Expr::Sum(terms) = term else {
        return false;
    };
    let mut decimals = false;
    let mut is_number = |own: &Expr| match own {
        Expr::Number(number) => {
            decimals |= !number.is_integer();
            true
        }
        _ => false,
    };
    let (mut bare, mut times) = (false, false);
    for own in terms.iter() {
        let own = match own {
            Expr::Negate(inner) => inner,
            own => own,
        };
        match own {
            Expr::Product(factors) => {
                let is_unit = |own: &Expr| matches!(own, Expr::Symbol(own) if own == unit);
                times |= factors.iter().any(is_unit) && factors.iter().any(&mut is_number);
            }
            own => bare |= is_number(own),
        }
    }
    bare && times && decimals
}

/// Whether a symbol is spelt as the imaginary unit is.
pub(crate) fn is_imaginary_unit(symbol: &Symbol) -> bool {
    UNITS.iter().any(|(name, _)| *name == symbol.name())
}

/// Whether a letter counts in a formula, or numbers something.
fn counts(formula: &Formula, letter: &Symbol) -> bool {
    let binds = |part: &Expr| {
        let numbers = matches!(part, Expr::Element { index, .. } if index == letter);
        numbers || part.binder() == Some(letter)
    };
    formula.terms().into_iter().any(|term| term.any(&binds))
}
