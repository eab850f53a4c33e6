//! Domains beside formulas: `s = \frac{1}{2} a t^2, \qquad t \geq 0` says where the formula is meant, and no more.

use crate::algebra::{Expr, Formula, Relation, Symbol};
use crate::derivation::{first_goal, goals};
use crate::notation::{Clause, Side, Statement};

/// The statements of a display that say where the ones before them are meant, by position.
pub(super) fn domains(statements: &[Statement]) -> Vec<usize> {
    let is_domain = |&at: &usize| {
        let before = &statements[..at];
        bounded(&statements[at]).is_some_and(|(symbol, ends)| {
            let is_of = match ends {
                Ends::Plain => speaks_of,
                Ends::Terms => is_function_of,
            };
            before.iter().any(|own| is_of(own, symbol))
                && !before.iter().any(|own| gives(own, symbol))
        })
    };
    (1..statements.len()).filter(is_domain).collect()
}

/// Between what a symbol is said to lie.
enum Ends {
    /// Numbers or symbols: `0 \leq x \leq L`.
    Plain,
    /// Terms of any kind, which may be results: `a E < x < E`.
    Terms,
}

/// The symbol of which a statement says no more than between what it lies: `t \geq 0`, `0 \leq x \leq L`.
fn bounded(statement: &Statement) -> Option<(&Symbol, Ends)> {
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
    let (symbol, ends) = match &sides[..] {
        [own, end] | [end, own] if is_number(end) => (own, Ends::Plain),
        [low, own, high] if is_end(low) && is_end(high) => (own, Ends::Plain),
        [_, own, _] => (own, Ends::Terms),
        _ => return None,
    };
    match &symbol.expr {
        Expr::Symbol(symbol) => Some((symbol, ends)),
        _ => None,
    }
}

/// Whether a statement says what a function of a symbol is, `f(x) = …`, or how much of something lies by it, `P(E)\,dE = …`.
fn is_function_of(statement: &Statement, symbol: &Symbol) -> bool {
    let own = Expr::Symbol(symbol.clone());
    let is_of_it = |part: &Expr| match part {
        Expr::Apply(_, arguments) => arguments.contains(&own),
        part => part.as_differential() == Some(&own),
    };
    let first = first_goal(statement);
    let sides = first.as_ref().and_then(|own| own.formula.as_equation());
    sides.is_some_and(|(left, _)| left.any(&is_of_it))
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
