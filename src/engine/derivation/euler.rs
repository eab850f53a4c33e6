//! Euler's number where nobody declares it: what `e` is, is seen from all that a document says of it.
//!
//! It is the number where it is nowhere anything but the base of powers such as `e^{-t/\tau}`, in a denominator by itself, or in `\ln e`.
//! Whatever else is said of it, `1 - e^2`, `e v`, "where $e$ is", makes it a symbol; so do powers that only count, `e^{2n}`,
//! for a coefficient of restitution is raised to them.
//!
//! A charge $e$ is raised to no power like $-\kappa r$ or $-t/\tau$. Where there is one, such powers are the number's beside a symbol `e`,
//! unless `e` stands where both could be meant: `U/e`, `\ln e`.

use num_traits::Signed;

use crate::algebra::{BigInt, Expr, Formula, Function, Symbol};
use crate::document::Prose;
use crate::notation::{read_expr, read_formulas};

use super::Equation;
use super::equation::{all_terms, conditions, each_side, formulas, of_pages};
use super::page::Page;

/// The letters that mostly count something.
const COUNTING: [&str; 4] = ["j", "k", "n", "N"];
/// `e^{3/2}` may be a root of the cube of a quantity.
const LARGEST_ROOT: u32 = 4;
/// Words that say what `e` is, where it stands in their sentence.
const SAID: [&str; 3] = ["Euler", "natural log", "2.718"];

/// How a document speaks of `e`.
#[derive(Clone, Copy, Default)]
struct Use {
    /// As the base of a power that only the number can be meant by.
    number: bool,
    /// As something else.
    other: bool,
    /// As the base of a power to which no quantity is raised: `e^{-\kappa r}`.
    sure: bool,
    /// Where both the number and a quantity could be meant.
    either: bool,
}

impl Use {
    /// Whether it is the number wherever it stands.
    fn is_the_number(&self) -> bool {
        self.number && !self.other
    }

    /// Whether it is the number as the base of powers, and something else besides.
    fn is_both(&self) -> bool {
        self.other && self.sure && !self.either
    }
}

/// Reads `e` as the number where it can be nothing else, and `\mathrm e` wherever it is not declared; `own` are the pages of one
/// document.
pub(super) fn recognize(own: &[usize], pages: &mut [Page], equations: &mut [Equation]) {
    let italic = Symbol::new("e");
    let upright = Symbol::new("\\text{e}");
    let found = used(own, pages, equations);
    for &at in own {
        let page = &mut pages[at];
        if found.is_the_number() {
            page.euler.insert(italic.clone());
        }
        page.has_both_e = found.is_both();
        if !page.is_declared(&upright) {
            page.euler.insert(upright.clone());
        }
    }
    let speaks = |term: &Expr| term.mentions(&italic) || term.mentions(&upright);
    for equation in of_pages(own, equations) {
        let page = &pages[equation.page];
        for statement in equation.statements.iter_mut().flatten() {
            each_side(statement, &mut |term, _| {
                if speaks(term) {
                    *term = page.with_exponentials(term);
                }
            });
        }
    }
    for &at in own {
        let mut locals = std::mem::take(&mut pages[at].locals);
        for formula in locals.iter_mut().flat_map(|local| &mut local.formulas) {
            if formula.terms().into_iter().any(speaks) {
                let read = formula.map_terms(|term| pages[at].with_exponentials(term));
                *formula = read.into();
            }
        }
        pages[at].locals = locals;
    }
}

/// How a document speaks of an `e` that it does not declare.
fn used(own: &[usize], pages: &[Page], equations: &[Equation]) -> Use {
    let mut found = Use::default();
    let e = Symbol::new("e");
    let speaks_of_it = |&at: &usize| {
        let of_page = super::equation::of_page(at, equations);
        let mut terms = all_terms(&pages[at], &equations[of_page]);
        terms.any(|term| term.mentions(&e))
    };
    if !own.iter().any(speaks_of_it) {
        return found;
    }
    for &at in own {
        let page = &pages[at];
        if page.is_declared(&e) || page.euler.contains(&e) {
            return Use::default();
        }
        let of_page = super::equation::of_page(at, equations);
        for statement in equations[of_page].iter().flat_map(Equation::statements) {
            for formula in formulas(statement).iter().chain(&conditions(statement)) {
                found.see_formula(formula, page);
            }
        }
        for formula in page.locals.iter().flat_map(|local| &local.formulas) {
            found.see_formula(formula, page);
        }
    }
    if found.is_the_number() || found.is_both() {
        for &at in own {
            let page = &pages[at];
            for prose in page.document.prose() {
                found.see_prose(prose, page);
            }
        }
    }
    found
}

impl Use {
    fn see_formula(&mut self, formula: &Formula, page: &Page) {
        if let Formula::AllEqual { sequence, .. } = formula {
            self.other |= sequence.name() == "e";
        }
        for term in formula.terms() {
            self.see(term, page);
        }
    }

    /// Mathematics in a line of text: `$e$` by itself is spoken of as something that has a meaning here.
    fn see_prose(&mut self, prose: &Prose, page: &Page) {
        let source = &page.document.source;
        for inline in &prose.math {
            let body = inline.body;
            if !source
                .get(body.range())
                .is_some_and(|text| text.contains('e'))
            {
                continue;
            }
            if let Ok(term) = read_expr(source, body) {
                let says = |word: &str| page.document.text(prose.span).contains(word);
                let is_alone = matches!(&term, Expr::Symbol(symbol) if symbol.name() == "e");
                if !(is_alone && SAID.into_iter().any(says)) {
                    self.see(&term, page);
                }
            } else if let Ok(statements) = read_formulas(source, body) {
                for formula in statements.iter().flat_map(formulas) {
                    self.see_formula(&formula, page);
                }
            } else {
                self.other |= speaks_of_e(source.get(body.range()).unwrap_or_default());
            }
        }
    }

    fn see(&mut self, term: &Expr, page: &Page) {
        let is_e = |term: &Expr| matches!(term, Expr::Symbol(symbol) if symbol.name() == "e");
        match term {
            Expr::Power(base, exponent) if is_e(base) => {
                match number(exponent) {
                    Some(Power::Whole(value)) => self.other |= value.is_positive(),
                    Some(Power::Root) => self.other = true,
                    Some(Power::Decimal) => self.number = true,
                    None if counts(exponent, page) => self.other = true,
                    None => {
                        self.number = true;
                        self.sure |= is_no_count(exponent);
                    }
                }
                self.see(exponent, page);
            }
            Expr::Quotient(above, below) if is_e(below) => {
                self.either = true;
                self.see(above, page);
            }
            Expr::Call(Function::Ln, argument) if is_e(argument) => self.either = true,
            Expr::Symbol(symbol) => self.other |= symbol.name() == "e",
            Expr::Element { sequence, index } => {
                self.other |= sequence.name() == "e" || index.name() == "e";
            }
            Expr::Apply(function, _) if function.name() == "e" => self.other = true,
            term => {
                self.other |= term.binder().is_some_and(|bound| bound.name() == "e");
                term.children().for_each(|child| self.see(child, page));
            }
        }
    }
}

/// Whether mathematics that could not be read speaks of `e` other than as the base of a power: `e \in (0, 1)`.
fn speaks_of_e(text: &str) -> bool {
    let glued = |c: Option<char>| c.is_some_and(|c| c.is_alphabetic() || c == '\\');
    text.match_indices('e').any(|(at, _)| {
        let before = text[..at].chars().next_back();
        let after = text[at + 1..].trim_start();
        !glued(before) && !glued(text[at + 1..].chars().next()) && !after.starts_with('^')
    })
}

/// An exponent that is a number.
enum Power {
    Whole(BigInt),
    /// A quantity is seldom raised to one, `e^{-0.631}`.
    Decimal,
    /// A root, or what is worked out first.
    Root,
}

fn number(exponent: &Expr) -> Option<Power> {
    match exponent {
        Expr::Number(value) if value.is_integer() => Some(Power::Whole(value.to_integer())),
        Expr::Number(value) if *value.denom() > LARGEST_ROOT.into() => Some(Power::Decimal),
        Expr::Negate(inner) => number(inner).map(|own| match own {
            Power::Whole(value) => Power::Whole(-value),
            own => own,
        }),
        term => term.free_symbols().is_empty().then_some(Power::Root),
    }
}

/// Whether nothing but Euler's number is raised to a power: less than nothing of a product, or a quotient.
fn is_no_count(exponent: &Expr) -> bool {
    match exponent {
        Expr::Negate(inner) => matches!(**inner, Expr::Product(_) | Expr::Quotient(..)),
        Expr::Product(factors) => factors.iter().any(|own| matches!(own, Expr::Quotient(..))),
        exponent => matches!(exponent, Expr::Quotient(..)),
    }
}

impl Page {
    /// A term with the powers of Euler's number as exponentials.
    pub(super) fn with_exponentials(&self, term: &Expr) -> Expr {
        let is_power = |exponent: &Expr| match number(exponent) {
            Some(Power::Whole(value)) => value.is_negative(),
            Some(Power::Decimal) => true,
            Some(Power::Root) => false,
            None => !counts(exponent, self),
        };
        self.exponentials(term, &is_power)
    }

    fn exponentials(&self, term: &Expr, is_power: &dyn Fn(&Expr) -> bool) -> Expr {
        let is_euler =
            |term: &Expr| matches!(term, Expr::Symbol(symbol) if self.euler.contains(symbol));
        let is_both = |term: &Expr| matches!(term, Expr::Symbol(own) if own.name() == "e");
        let raised = |exponent: Expr| Expr::Call(Function::Exp, exponent.into());
        match term {
            Expr::Power(base, exponent)
                if is_euler(base) || self.has_both_e && is_both(base) && is_power(exponent) =>
            {
                raised(self.exponentials(exponent, is_power))
            }
            term if is_euler(term) => raised(Expr::integer(1)),
            // A number is not held fixed.
            Expr::Partial {
                body,
                variable,
                held: Some(held),
            } => {
                let held = held.iter().filter(|own| !self.euler.contains(*own));
                let held: Box<[Symbol]> = held.cloned().collect();
                Expr::Partial {
                    body: self.exponentials(body, is_power).into(),
                    variable: variable.clone(),
                    held: (!held.is_empty()).then_some(held),
                }
            }
            term => term.map_children(|child| self.exponentials(child, is_power)),
        }
    }
}

/// Whether an exponent is a whole number of times that something is done.
fn counts(exponent: &Expr, page: &Page) -> bool {
    let counted = |symbol: &Symbol| {
        let domain = page.domains.get(symbol);
        COUNTING.contains(&symbol.name()) || domain.is_some_and(|domain| domain.integer)
    };
    let divided = exponent.any(&|part| matches!(part, Expr::Quotient(..) | Expr::Call(..)));
    !divided && exponent.free_symbols().iter().all(counted)
}
