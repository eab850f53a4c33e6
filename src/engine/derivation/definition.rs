//! Definitions: which equations are the first to speak of a symbol, and where the text says what a new symbol means.

use std::collections::BTreeSet;
use std::ops::Range;

use crate::algebra::{Expr, Formula, Relation, Symbol};
use crate::document::Span;
use crate::notation::{Clause, Statement, read_formulas};

use super::Equation;
use super::equation::{conditions, formulas};
use super::page::{Local, Page};

/// Leaves only those as definitions whose symbol occurs nowhere before, in reading order, and notes which symbols are new.
pub(super) fn settle(equations: &mut [Equation]) {
    let mut seen = BTreeSet::new();
    for equation in equations {
        let mut defines = std::mem::take(&mut equation.defines);
        let mut introduces = BTreeSet::new();
        let mut case: Option<Symbol> = None;
        for (part, statement) in equation.statements().iter().enumerate() {
            // All cases of a definition define the same symbol.
            let defined = defined_symbol(statement, &seen, case.as_ref());
            if defined.is_none() {
                defines.remove(&part);
            }
            case = defined.filter(|_| !statement.under.is_empty());
            for symbol in formulas(statement).iter().flat_map(Formula::names) {
                if seen.insert(symbol.clone()) {
                    introduces.insert(symbol);
                }
            }
        }
        (equation.defines, equation.introduces) = (defines, introduces);
    }
}

/// `s`, of `s = …`, where it has not occurred before, on this page or an earlier one, or in the case before only.
fn defined_symbol(
    statement: &Statement,
    seen: &BTreeSet<Symbol>,
    case: Option<&Symbol>,
) -> Option<Symbol> {
    let Some(Clause::Chain { sides, links }) = statement.clauses.first() else {
        return None;
    };
    let (side, link) = (sides.first()?, links.first()?);
    let Expr::Symbol(symbol) = &side.expr else {
        return None;
    };
    let under = conditions(statement);
    let defines = link.relation == Relation::Equal
        && !link.questioned
        && (!seen.contains(symbol) || case == Some(symbol) && !under.is_empty())
        && sides.iter().skip(1).all(|side| !side.expr.mentions(symbol))
        && !under
            .iter()
            .flat_map(Formula::terms)
            .any(|term| term.mentions(symbol));
    defines.then(|| symbol.clone())
}

/// The symbols of the first so many equations and suppositions of a page, gathered when they are asked for.
#[derive(Default)]
pub(super) struct Known {
    symbols: BTreeSet<Symbol>,
    equations: usize,
    locals: usize,
}

impl Known {
    fn learn(&mut self, equations: &[Equation], locals: &[Local]) {
        let newer = equations.get(self.equations..).unwrap_or_default();
        self.symbols
            .extend(newer.iter().flat_map(Equation::symbols));
        let newer = locals.get(self.locals..).unwrap_or_default();
        let said = newer.iter().flat_map(|local| &local.formulas);
        self.symbols
            .extend(said.flat_map(|formula| formula.names()));
        (self.equations, self.locals) = (equations.len(), locals.len());
    }

    /// Whether `s = …` after a display only says what a symbol means that occurs first there. Such an equation can be made
    /// true whatever the symbols on its right are, as long as none of these is what the display defines by it.
    pub fn says_what_is_new(
        &mut self,
        body: Span,
        page: &Page,
        equations: &[Equation],
        last: Range<usize>,
    ) -> bool {
        let Ok(read) = read_formulas(&page.document.source, body) else {
            return false;
        };
        let said: Vec<Formula> = read.iter().flat_map(formulas).collect();
        let [
            Formula::Relation {
                left: Expr::Symbol(symbol),
                relation: Relation::Equal,
                right,
            },
        ] = &said[..]
        else {
            return false;
        };
        let occurs = |formula: &Formula| formula.terms().iter().any(|term| term.mentions(symbol));
        // What stands on the left of an equation of the display.
        let defined = |statement: &Statement| match statement.clauses.first() {
            Some(Clause::Chain { sides, .. }) => match sides.first().map(|side| &side.expr) {
                Some(Expr::Symbol(left)) => left == symbol || right.mentions(left),
                _ => false,
            },
            _ => false,
        };
        self.learn(&equations[..last.start], &page.locals);
        let statements = || {
            equations[last.clone()]
                .iter()
                .flat_map(Equation::statements)
        };
        !right.mentions(symbol)
            && statements()
                .flat_map(formulas)
                .any(|formula| occurs(&formula))
            && !self.symbols.contains(symbol)
            && !statements().any(defined)
    }
}
