//! Counts of which nobody says so: what a sum runs to, and the index of a recurrence, is a natural number whether that is said or not.

use std::cell::LazyCell;
use std::collections::BTreeSet;

use crate::algebra::{BigRational, Expr, Formula, Place, Symbol, split_subscript};

use crate::kernel::Domain;
use crate::sorted::Tree;

use super::Equation;
use super::equation::formulas;
use super::page::Page;
use super::running::{Offsets, family, numbered, offsets, recurs};

/// Gives what can only be a count, and is declared to be nothing else, the domain of one.
///
/// The first of them is 1, or such that a recurrence begins with the first element that has a number: where there is an `E_0`,
/// `E_{n+1} = e^2 E_n` begins with `n = 0`.
pub(super) fn infer(page: &mut Page, equations: &[Equation]) {
    let mut counts = BTreeSet::new();
    let mut steps: Vec<(Symbol, Symbol, i64)> = Vec::new();
    // What is known for a count by its letter where a sequence is given in terms of it.
    let usual = Symbol::new("n");
    let begun = LazyCell::new(|| numbered(equations, &usual));
    // What the author says to run through whole numbers, and from which on.
    let mut said_to_run: Tree<Symbol, (Option<i64>, Option<i64>)> = Tree::new();
    for statement in equations.iter().flat_map(Equation::statements) {
        for run in &statement.runs {
            let known = said_to_run.entry(run.symbol.clone());
            let (from, to) = known.or_insert((run.from, run.to));
            *from = (*from).min(run.from);
            *to = to.zip(run.to).map(|(one, other)| one.max(other));
            counts.insert(run.symbol.clone());
        }
        for formula in formulas(statement) {
            for term in formula.terms() {
                limits(term, &mut Vec::new(), &mut counts);
            }
            if let Some(stem) = family(&formula, &usual)
                && begun.contains(&stem)
            {
                steps.push((usual.clone(), stem, 0));
                counts.insert(usual.clone());
            }
            for (index, offsets) in recurrences(&formula) {
                let least = offsets.into_iter().map(|(stem, (least, _))| (stem, least));
                steps.extend(least.map(|(stem, least)| (index.clone(), stem, least)));
                counts.insert(index);
            }
        }
    }
    let said = |symbol: &Symbol| {
        let own = page.domains.get(symbol);
        own.is_some_and(|domain| *domain != Domain::default())
    };
    counts.retain(|symbol| !said(symbol));
    if counts.is_empty() {
        return;
    }
    let mut first: Tree<Symbol, i64> = Tree::new();
    for name in equations.iter().flat_map(Equation::symbols) {
        for (index, stem, offset) in &steps {
            if let Some((own, Place::Number(number))) = name.place(index)
                && own == *stem
            {
                let begins = (i64::from(number) - offset).max(0);
                let least = first.entry(index.clone()).or_insert(1);
                *least = begins.min(*least);
            }
        }
    }
    for symbol in counts {
        let (least, last) = match said_to_run.get(&symbol) {
            Some(run) => *run,
            None => (Some(first.get(&symbol).copied().unwrap_or(1)), None),
        };
        let domain = page.domains.entry(symbol).or_default();
        domain.integer = true;
        let bound = |own: i64| (BigRational::from_integer(own.into()), false);
        domain.lower = least.map(bound);
        domain.upper = last.map(bound);
    }
}

/// The indices of which a formula is a recurrence, each with the sequences that run with it and their least and greatest offsets.
pub(super) fn recurrences(formula: &Formula) -> Vec<(Symbol, Offsets)> {
    if let Formula::Relation { left, right, .. } = formula
        && !left.any(&may_be_shifted)
        && !right.any(&may_be_shifted)
    {
        return Vec::new();
    }
    let indices: BTreeSet<Symbol> = formula.names().iter().filter_map(shifted).collect();
    let running = indices.into_iter().map(|index| {
        let offsets = offsets(formula, &index);
        (index, offsets)
    });
    running.filter(|(_, offsets)| recurs(offsets)).collect()
}

/// The symbols to which, or from which, sums run: `n` of `\sum_{i=1}^{n+1}`. An index is none outside of its sum.
fn limits<'a>(term: &'a Expr, bound: &mut Vec<&'a Symbol>, found: &mut BTreeSet<Symbol>) {
    let Expr::Series {
        index,
        from,
        to,
        body,
    } = term
    else {
        let runs = match term {
            Expr::Limit { variable, .. } => Some(variable),
            _ => None,
        };
        bound.extend(runs);
        (term.children()).for_each(|child| limits(child, bound, found));
        bound.truncate(bound.len() - usize::from(runs.is_some()));
        return;
    };
    for limit in [from, to] {
        let symbols = limit.free_symbols();
        // Of `2 n` and `n + m` more than one thing could be meant.
        if let (Some(symbol), 1) = (symbols.first(), symbols.len())
            && matches!(**limit, Expr::Symbol(_) | Expr::Sum(_))
            && !bound.contains(&symbol)
        {
            found.insert(symbol.clone());
        }
        limits(limit, bound, found);
    }
    bound.push(index);
    limits(body, bound, found);
    bound.pop();
}

/// Whether a part of a term may speak of an `E_{n+1}`, as far as it is seen without looking closer: few do.
fn may_be_shifted(part: &Expr) -> bool {
    match part {
        Expr::Symbol(own) => own.name().bytes().any(|sign| matches!(sign, b'+' | b'-')),
        Expr::Number(_)
        | Expr::Sum(_)
        | Expr::Product(_)
        | Expr::Quotient(..)
        | Expr::Power(..)
        | Expr::Negate(_)
        | Expr::Call(..) => false,
        _ => true,
    }
}

/// `n` of `E_{n+1}`.
fn shifted(symbol: &Symbol) -> Option<Symbol> {
    let (_, text) = split_subscript(symbol.name())?;
    let (index, offset) = text.split_once(['+', '-'])?;
    let figures = !offset.is_empty() && offset.bytes().all(|b| b.is_ascii_digit());
    let index = Symbol::new(index);
    (figures && index.can_be_index()).then_some(index)
}
