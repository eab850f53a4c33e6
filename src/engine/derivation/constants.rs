//! Constants that nobody names: `p V = \text{const}` says that `p V` does not change, and not that it is what something else
//! of which the same is said is. So each such word is a constant of its own.

use std::collections::BTreeSet;
use std::sync::Arc;

use crate::algebra::{Expr, Formula, Symbol};
use crate::document::Span;
use crate::notation::is_constant_word;
use crate::sorted::Tree;

use super::Equation;
use super::equation::{each_side, formulas};
use super::page::Page;

/// Gives each constant without a name one that nothing else has, and tells them all: the first of a word is called by the word, the
/// second `\text{const}_2`. What a page declares by such a word is a symbol like any other there.
///
/// A side that stands in two equations, for rows go on with one another, is the same in both; and what a display bounds or orders,
/// `F = \text{const} \cdot x, \text{const} > 0`, is what it spoke of before.
pub(super) fn tell_apart(pages: &mut [Page], equations: &mut [Equation]) -> BTreeSet<Symbol> {
    let words = words(pages, equations);
    let mut names = Names {
        taken: words
            .iter()
            .filter(|s| !is_constant_word(s))
            .cloned()
            .collect(),
        counts: Tree::new(),
        told: BTreeSet::new(),
        last: Tree::new(),
        again: false,
    };
    if words.iter().all(|symbol| names.taken.contains(symbol)) {
        return names.told;
    }
    let mut sides: Tree<(usize, Span), Expr> = Tree::new();
    for equation in equations {
        let page = &mut pages[equation.page];
        if equation.row == 0 {
            names.last.clear();
        }
        let statements = equation.statements.iter_mut().flatten();
        for statement in statements {
            let said = formulas(statement);
            names.again = said.iter().all(|formula| formula.as_equation().is_none());
            each_side(statement, &mut |term, span| {
                if mentions_word(term) {
                    let named = sides.entry((equation.page, span));
                    let named = named.or_insert_with(|| names.named(term, page));
                    term.clone_from(named);
                }
            });
        }
    }
    names.again = false;
    for page in pages {
        for at in 0..page.locals.len() {
            let supposed = page.locals[at].formulas.clone();
            let named = supposed
                .into_iter()
                .map(|formula| match speaks_of_some(&formula) {
                    true => Arc::new(formula.map_terms(|term| names.named(term, page))),
                    false => formula,
                });
            page.locals[at].formulas = named.collect();
        }
    }
    names.told
}

/// Whether a formula speaks of a constant without a name, as it is written.
pub(super) fn speaks_of_some(formula: &Formula) -> bool {
    formula.terms().into_iter().any(mentions_word)
}

fn mentions_word(term: &Expr) -> bool {
    term.any(&|part| matches!(part, Expr::Symbol(symbol) if is_constant_word(symbol)))
}

/// The symbols that begin with such a word.
fn words(pages: &[Page], equations: &[Equation]) -> BTreeSet<Symbol> {
    let stated = equations.iter().flat_map(Equation::symbols);
    let locals = pages.iter().flat_map(|page| &page.locals);
    let all = stated.chain(locals.flat_map(super::supposed::Local::names));
    all.filter(|symbol| symbol.name().starts_with("\\text{"))
        .collect()
}

struct Names {
    /// Names of the author's that look like one of these.
    taken: BTreeSet<Symbol>,
    /// How often each word was met.
    counts: Tree<Symbol, usize>,
    told: BTreeSet<Symbol>,
    /// What each word stood for last in the display.
    last: Tree<Symbol, Symbol>,
    /// Whether it stands for that again.
    again: bool,
}

impl Names {
    fn named(&mut self, term: &Expr, page: &mut Page) -> Expr {
        match term {
            Expr::Symbol(word) if is_constant_word(word) && !page.is_declared(word) => {
                let again = self.last.get(word).filter(|_| self.again).cloned();
                let symbol = again.unwrap_or_else(|| self.next(word));
                self.last.insert(word.clone(), symbol.clone());
                page.domains.entry(symbol.clone()).or_default().constant = true;
                Expr::Symbol(symbol)
            }
            term => term.map_children(|child| self.named(child, page)),
        }
    }

    fn next(&mut self, word: &Symbol) -> Symbol {
        loop {
            let count = self.counts.entry(word.clone()).or_default();
            *count += 1;
            let symbol = match *count {
                1 => word.clone(),
                2..=9 => Symbol::new(format!("{word}_{count}")),
                _ => Symbol::new(format!("{word}_{{{count}}}")),
            };
            if !self.taken.contains(&symbol) {
                self.told.insert(symbol.clone());
                return symbol;
            }
        }
    }
}
