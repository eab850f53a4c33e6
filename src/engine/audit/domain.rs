//! Domains beside formulas: `s = \frac{1}{2} a t^2, \qquad t \geq 0` says where the formula is meant, and no more.

use crate::algebra::{Expr, Formula, Relation, Symbol};
use crate::derivation::goals;
use crate::notation::{Clause, Side, Statement};

/// The statements of a display that say where the ones before them are meant, by position.
pub(super) fn domains(statements: &[Statement]) -> Vec<usize> {
    let is_domain = |&at: &usize| {
        let before = &statements[..at];
        bounded(&statements[at]).is_some_and(|symbol| {
            before.iter().any(|own| speaks_of(own, symbol))
                && !before.iter().any(|own| gives(own, symbol))
        })
    };
    (1..statements.len()).filter(is_domain).collect()
}

/// The symbol of which a statement says no more than between what numbers it lies: `t \geq 0`, `0 \leq x \leq L`.
fn bounded(statement: &Statement) -> Option<&Symbol> {
    let [Clause::Chain { sides, links }] = &statement.clauses[..] else {
        return None;
    };
    let is_plain =
        statement.under.is_empty() && statement.mark.is_none() && statement.label.is_none();
    let is_order = |relation| {
        matches!(
            relation,
            Relation::Less | Relation::LessOrEqual | Relation::Greater | Relation::GreaterOrEqual
        )
    };
    if !is_plain
        || !links
            .iter()
            .all(|link| is_order(link.relation) && !link.questioned)
    {
        return None;
    }
    let is_number = |side: &Side| side.expr.free_symbols().iter().all(Symbol::is_unit);
    let is_end = |side: &Side| is_number(side) || matches!(side.expr, Expr::Symbol(_));
    let symbol = match &sides[..] {
        [own, end] | [end, own] if is_number(end) => own,
        [low, own, high] if is_end(low) && is_end(high) => own,
        _ => return None,
    };
    match &symbol.expr {
        Expr::Symbol(symbol) => Some(symbol),
        _ => None,
    }
}

fn speaks_of(statement: &Statement, symbol: &Symbol) -> bool {
    let goals = goals(statement);
    goals
        .iter()
        .any(|goal| goal.formula.free_symbols().contains(symbol))
}

/// Whether a statement says what a symbol is: a bound beside it may be a result.
fn gives(statement: &Statement, symbol: &Symbol) -> bool {
    let is_side = |formula: &Formula| {
        let mut terms = formula.terms().into_iter();
        terms.any(|term| matches!(term, Expr::Symbol(own) if own == symbol))
    };
    goals(statement).iter().any(|goal| is_side(&goal.formula))
}
