//! Definitions put in: which hypotheses are definitions, and where what they define may be put in its place.

use std::sync::Arc;

use super::super::{Claim, Reject, Standing};
use crate::algebra::{Expr, Formula, Symbol, element_parts};
use crate::sorted::Set;

pub(super) type Unfolded = (Vec<(Arc<Formula>, Standing)>, Formula, Vec<(Symbol, Expr)>);

/// Puts hypotheses `symbol = term` in everywhere, in order, and says what each symbol became.
pub(super) fn unfolded(
    claim: &Claim,
    unfold: &[usize],
    sequences: &Set<Symbol>,
) -> Result<Unfolded, Reject> {
    let hypotheses = claim.hypotheses.iter();
    let mut formulas: Vec<_> = hypotheses
        .map(|h| (h.formula.clone(), h.standing))
        .collect();
    let mut goal = claim.goal.clone();
    let mut values: Vec<(Symbol, Expr)> = Vec::new();
    for &position in unfold {
        let (formula, standing) = formulas.get(position).ok_or(Reject::NoSuchFact(position))?;
        if let Some((applied, term)) = applied_definition(formula) {
            // A law about a function holds for all of its arguments, under an integral too.
            let captured = |f: &Formula| f.terms().iter().any(|t| captures(t, &term));
            let throughout = *standing == Standing::Identity;
            if !throughout || formulas.iter().map(|f| &*f.0).chain([&goal]).any(captured) {
                return Err(Reject::NotUnfoldable(position));
            }
            for (formula, _) in &mut formulas {
                *formula = formula.map_terms(|t| t.replace(&applied, &term)).into();
            }
            goal = goal.map_terms(|t| t.replace(&applied, &term));
            for (_, value) in &mut values {
                *value = value.replace(&applied, &term);
            }
            continue;
        }
        let (symbol, term) = definition(formula).ok_or(Reject::NotUnfoldable(position))?;
        let all = || formulas.iter().map(|f| &*f.0).chain([&goal]);
        let moving = |f: &Formula| f.terms().iter().any(|t| moves(t, &symbol));
        let captured = |f: &Formula| f.terms().iter().any(|t| captures(t, &term));
        // An element is named by its sequence too, under a sum and in the sequence's domain.
        let element = element_parts(&symbol).map(|parts| parts.0);
        let named = sequences.contains(&symbol) || element.is_some_and(|e| sequences.contains(&e));
        let derived_by = |f: &Formula| f.terms().iter().any(|t| is_variable(t, &symbol));
        let stuck = *standing == Standing::AtPoint && all().any(moving);
        if stuck || named || all().any(captured) || all().any(derived_by) {
            return Err(Reject::NotUnfoldable(position));
        }
        let pointwise = *standing == Standing::AtPoint;
        for (formula, standing) in &mut formulas {
            if !formula.terms().iter().any(|t| t.mentions(&symbol)) {
                continue;
            }
            let changed = formula.map_terms(|t| t.substitute(&symbol, &term));
            // A law into which a value was put says something of this point only.
            if pointwise && changed != **formula {
                *standing = Standing::AtPoint;
            }
            *formula = changed.into();
        }
        goal = goal.map_terms(|t| t.substitute(&symbol, &term));
        for (_, value) in &mut values {
            *value = value.substitute(&symbol, &term);
        }
        values.push((symbol, term));
    }
    Ok((formulas, goal, values))
}

/// `symbol = term`, the term not mentioning the symbol.
pub fn definition(formula: &Formula) -> Option<(Symbol, Expr)> {
    let (left, right) = formula.as_equation()?;
    let solved = |a: &Expr, b: &Expr| match a {
        Expr::Symbol(symbol) if !b.mentions(symbol) => Some((symbol.clone(), b.clone())),
        _ => None,
    };
    solved(left, right).or_else(|| solved(right, left))
}

/// `F(x) = term`, the term not mentioning the function and no lone symbol.
pub(crate) fn applied_definition(formula: &Formula) -> Option<(Expr, Expr)> {
    let (left, right) = formula.as_equation()?;
    if definition(formula).is_some() {
        return None;
    }
    let solved = |a: &Expr, b: &Expr| match a {
        Expr::Apply(function, _) if !b.mentions(function) => Some((a.clone(), b.clone())),
        _ => None,
    };
    solved(left, right).or_else(|| solved(right, left))
}

/// Whether a symbol stands where it is differentiated, integrated or taken to a limit, or is what that is done by.
fn moves(term: &Expr, symbol: &Symbol) -> bool {
    term.any(&|part| match part {
        Expr::Derivative { .. }
        | Expr::Partial { .. }
        | Expr::Limit { .. }
        | Expr::Integral { .. } => part.mentions(symbol),
        _ => false,
    })
}

/// Whether a symbol is what is differentiated by, is held fixed meanwhile, goes to a limit or is integrated over: putting a term in its
/// place elsewhere would sever the two.
fn is_variable(term: &Expr, symbol: &Symbol) -> bool {
    term.any(&|part| match part {
        Expr::Series { .. } => false,
        Expr::Partial { variable, .. } => variable == symbol || part.held().contains(symbol),
        _ => part.binder() == Some(symbol),
    })
}

/// Whether a sum binds an index that occurs in `value` outside of any sum of its own.
fn captures(term: &Expr, value: &Expr) -> bool {
    term.any(&|part| matches!(part, Expr::Series { index, .. } if is_free(index, value)))
}

fn is_free(index: &Symbol, term: &Expr) -> bool {
    match term {
        Expr::Series { .. } => term.scope().is_some_and(|(own, body, outside)| {
            let mut outside = outside.into_iter();
            own != index && is_free(index, body) || outside.any(|e| is_free(index, e))
        }),
        Expr::Symbol(own) | Expr::Apply(own, _) if own == index => true,
        Expr::Element {
            sequence,
            index: own,
        } => sequence == index || own == index,
        _ => term.binder() == Some(index) || term.children().any(|e| is_free(index, e)),
    }
}
