//! The imaginary unit where nobody declares it: what is said with it is said of complex numbers, and claims here are about real ones.
//!
//! `i` is the unit where it stands in the exponent of an exponential, where the text says that something is complex, or that $i^2 = -1$;
//! so is `\mathrm i`. A letter that counts somewhere, as in `\sum_i`, is not taken for it, nor is what is a quantity, "the current $i$", where
//! nothing but words about complex numbers would make a unit of it.

use std::collections::BTreeSet;

use crate::algebra::{Expr, Formula, Function, Symbol};
use crate::document::Span;

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
/// What goes on after a noun.
const AFTER_NOUNS: [&str; 14] = [
    "is",
    "of",
    "was",
    "has",
    "can",
    "may",
    "forms",
    "formed",
    "dissociates",
    "decays",
    "breaks",
    "with",
    "between",
    "then",
];
/// What is said of the unit itself.
const IMAGINARY: [&str; 3] = ["imaginary", "square root", "unit"];
/// Between a letter and what it is said to be.
const LINKING: [&str; 4] = ["is", "be", "denotes", "being"];
/// Words that stand before the unit, and before no name of a quantity.
const BEFORE_UNITS: [&str; 13] = [
    "factor",
    "factors",
    "the",
    "with",
    "unit",
    "number",
    "letter",
    "symbol",
    "powers",
    "that",
    "where",
    "times",
    "multiplying",
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
        let is_told = || {
            is_told(own, pages)
                && !said.iter().any(|own| is_quantity(own, &unit))
                && !is_called_something(own, pages, name)
        };
        let is_meant = || {
            upright
                || said.iter().any(|own| shows(own, &unit))
                || is_beside_planck(own, pages, equations, name)
                || is_told()
        };
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

/// Whether a letter stands before the reduced Planck constant somewhere, `i \hbar`, as in what cannot be read: nothing but the unit does.
fn is_beside_planck(own: &[usize], pages: &[Page], equations: &[Equation], letter: &str) -> bool {
    own.iter().any(|&at| {
        let of_page = super::equation::of_page(at, equations);
        equations[of_page].iter().any(|equation| {
            let text = pages[at].document.text(equation.body);
            let mut before = text.match_indices("\\hbar").map(|(at, _)| &text[..at]);
            before.any(|before| {
                let alone = before.trim_end().strip_suffix(letter);
                alone.is_some_and(|own| !own.ends_with(|c: char| c.is_alphanumeric() || c == '\\'))
            })
        })
    })
}

/// Whether the text speaks of complex numbers.
fn is_told(own: &[usize], pages: &[Page]) -> bool {
    let mut texts = own.iter().flat_map(|&at| {
        let document = &pages[at].document;
        document.prose().map(|prose| document.text(prose.span))
    });
    texts.any(|text| {
        let words: Vec<&str> = text.split(|c: char| !c.is_alphabetic()).collect();
        (0..words.len()).any(|at| {
            let is_said = SAID.iter().any(|own| own.eq_ignore_ascii_case(words[at]));
            is_said && !is_compound(&words, at)
        })
    })
}

/// Whether a word is "complex" and means a chemical one: "the complex ES", "the complex is formed".
fn is_compound(words: &[&str], at: usize) -> bool {
    let before = at.checked_sub(1).map_or("", |at| words[at]);
    let after = words.get(at + 1).map_or("", |word| word);
    let is_determined = ["the", "a", "this", "each", "one"]
        .iter()
        .any(|own| own.eq_ignore_ascii_case(before));
    words[at].eq_ignore_ascii_case("complex")
        && is_determined
        && (after.starts_with(char::is_uppercase) || AFTER_NOUNS.contains(&after))
}

/// Whether the text calls something by a letter, "the current $i$", "where $i$ is the concentration", "lines for different $i$", where it says
/// nothing of an imaginary unit.
fn is_called_something(own: &[usize], pages: &[Page], letter: &str) -> bool {
    let own = own.iter().map(|&at| &pages[at].document);
    let mut texts = own.flat_map(|document| document.prose().map(move |prose| (document, prose)));
    texts.any(|(document, prose)| {
        let bare = (prose.math.iter()).filter(|own| document.text(own.body).trim() == letter);
        bare.into_iter().any(|own| {
            let before = document.text(Span::new(prose.span.start, own.span.start));
            let after = document.text(Span::new(own.span.end, prose.span.end));
            let ends = |c: char| matches!(c, '.' | ';' | ':');
            let sentence = before.rsplit(ends).next().unwrap_or_default();
            let rest = after.split(ends).next().unwrap_or_default();
            let word = sentence.trim_end().rsplit(char::is_whitespace).next();
            let is_named = word.is_some_and(|word| {
                word.len() > 2
                    && word.chars().all(char::is_alphabetic)
                    && !BEFORE_UNITS.contains(&word)
            });
            // "where $i$ is the concentration of the inhibitor"
            let mut follows = rest.split_whitespace();
            let is_said = follows.next().is_some_and(|own| LINKING.contains(&own))
                && follows.next().is_some_and(|own| own == "the");
            (is_named || is_said)
                && ![sentence, rest]
                    .iter()
                    .any(|text| IMAGINARY.iter().any(|own| text.contains(own)))
        })
    })
}

/// Whether a formula can only mean a quantity: one that is differentiated, that depends on another, or that is equal to something.
fn is_quantity(formula: &Formula, letter: &Symbol) -> bool {
    let is_letter = |term: &Expr| matches!(term, Expr::Symbol(own) if own == letter);
    let is_root =
        |term: &Expr| matches!(term, Expr::Power(_, half) if matches!(**half, Expr::Number(_)));
    let is_given = formula.as_equation().is_some_and(|(left, right)| {
        is_letter(left) && !is_root(right) || is_letter(right) && !is_root(left)
    });
    let shown = |part: &Expr| match part {
        Expr::Apply(own, _) => own == letter,
        Expr::Derivative { body, .. } | Expr::Partial { body, .. } => is_letter(body),
        _ => false,
    };
    is_given || formula.terms().into_iter().any(|term| term.any(&shown))
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
