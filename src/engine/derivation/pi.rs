//! π where a document has the letter for something else: a profit, `\pi = p q - c q`, a reduced pressure, "$\pi = p/p_c$", "Let $\pi$ be
//! the osmotic pressure".
//!
//! It is the number unless it is declared, or the first that is said of it is what it is. What says so late, `\pi = \frac{C}{2 r}` after
//! `C = 2 \pi r`, speaks of the number, and so does what takes a sine of it.

use crate::algebra::{Expr, Formula, Symbol};
use crate::document::Inline;
use crate::notation::{read_expr, read_formulas};

use super::Equation;
use super::equation::{formulas, of_page};
use super::page::Page;

/// What is said of the number.
const CIRCLE: [&str; 9] = [
    "number",
    "constant",
    "circle",
    "circumference",
    "ratio",
    "3.14",
    "usual",
    "angle",
    "radian",
];

/// Makes `\pi` a symbol, one that may be any real number, where a document gives it a meaning of its own; `own` are its pages.
pub(super) fn recognize(own: &[usize], pages: &mut [Page], equations: &[Equation]) {
    let pi = Symbol::new("\\pi");
    let mut said = None;
    for &at in own {
        // Pages of Markdown have letters of their own.
        if !pages[at].document.is_latex {
            said = None;
        }
        said = said.or_else(|| first_said(&pi, &pages[at], &equations[of_page(at, equations)]));
        if said == Some(Use::Defined) && !pages[at].is_declared(&pi) {
            pages[at].domains.entry(pi.clone()).or_default();
        }
    }
}

/// What is said of the letter.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Use {
    /// What it stands for.
    Defined,
    /// Something else.
    Used,
}

/// What a page says of it first; that it takes a sine of it counts wherever it does.
fn first_said(pi: &Symbol, page: &Page, equations: &[Equation]) -> Option<Use> {
    let source = &page.document.source;
    if !source.contains("\\pi") && !source.contains('π') {
        return None;
    }
    let mut all: Vec<(usize, Use)> = Vec::new();
    for equation in equations {
        for formula in equation.statements().iter().flat_map(formulas) {
            all.extend(use_of(pi, &formula).map(|own| (equation.body.start, own)));
        }
    }
    let inline = page.document.prose().flat_map(|prose| &prose.math);
    for math in inline {
        let own = use_inline(pi, source, math);
        all.extend(own.map(|own| (math.body.start, own)));
        if let Some((introduced, leads_back)) = introduced(source, math) {
            // "where $\pi$ is the profit" is said of the display before.
            let mut before = equations.iter().map(|own| own.body.start);
            let before = before.rfind(|&at| at < math.body.start);
            let at = before.filter(|_| leads_back).unwrap_or(math.body.start);
            all.insert(0, (at, introduced));
        }
    }
    let first = all.iter().min_by_key(|(at, _)| *at)?.1;
    let angular = |formula: &Formula| {
        let mut terms = formula.terms().into_iter();
        terms.any(|term| term.any(&|part| matches!(part, Expr::Call(_, of) if of.mentions(pi))))
    };
    let mut displayed = equations.iter().flat_map(Equation::statements);
    match displayed.any(|statement| formulas(statement).iter().any(angular)) {
        true => Some(Use::Used),
        false => Some(first),
    }
}

/// What the words around a mere `\pi` say that it is, and whether they go on with what was said before.
fn introduced(source: &str, math: &Inline) -> Option<(Use, bool)> {
    if !matches!(source.get(math.body.range())?.trim(), "\\pi" | "π") {
        return None;
    }
    let before = source.get(..math.span.start)?.trim_end();
    let after = source.get(math.span.end..)?.trim_start();
    let ends_with = |words: &[&str]| {
        let last = before.rsplit(|c: char| !c.is_alphabetic()).next();
        last.is_some_and(|last| words.iter().any(|own| own.eq_ignore_ascii_case(last)))
    };
    let begins_with = |words: &[&str]| {
        words.iter().any(|own| {
            let rest = after.strip_prefix(own);
            rest.is_some_and(|rest| rest.starts_with(char::is_whitespace))
        })
    };
    let lets = ends_with(&["let"]) && begins_with(&["be", "denote", "stand for"]);
    let leads_back = ends_with(&["where", "here", "and", "with"]);
    let says = begins_with(&["is the", "is a", "is its", "denotes", "stands for"]);
    if !lets && !says {
        return None;
    }
    let end = after.find(['.', ';', ':', '\n']).unwrap_or(after.len());
    let words = after[..end].to_lowercase();
    let is_number = CIRCLE.iter().any(|own| words.contains(own));
    let own = if is_number { Use::Used } else { Use::Defined };
    Some((own, leads_back))
}

fn use_inline(pi: &Symbol, source: &str, math: &Inline) -> Option<Use> {
    let text = source.get(math.body.range())?;
    if !text.contains("\\pi") && !text.contains('π') {
        return None;
    }
    if let Ok(statements) = read_formulas(source, math.body) {
        let all: Vec<Formula> = statements.iter().flat_map(formulas).collect();
        return all.iter().find_map(|formula| use_of(pi, formula));
    }
    match read_expr(source, math.body) {
        // By itself it is only named.
        Ok(Expr::Symbol(_)) => None,
        Ok(term) => term.mentions(pi).then_some(Use::Used),
        Err(_) => None,
    }
}

fn use_of(pi: &Symbol, formula: &Formula) -> Option<Use> {
    if !formula.terms().iter().any(|term| term.mentions(pi)) {
        return None;
    }
    let defines = matches!(
        formula.as_equation(),
        Some((Expr::Symbol(left), right))
            if left == pi && !right.mentions(pi) && !right.free_symbols().is_empty()
    );
    Some(if defines { Use::Defined } else { Use::Used })
}
