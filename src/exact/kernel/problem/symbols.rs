//! What a claim says of its symbols: which name sequences, which depend on nothing, which say how many elements there are.

use num_traits::Zero;

use super::super::{Claim, Hypothesis, Standing};
use crate::algebra::{Expr, Formula, Symbol};
use crate::sorted::Set;

/// The symbols that name sequences, declared or not.
pub(in crate::kernel) fn sequences(claim: &Claim) -> Set<Symbol> {
    let mut all = Formula::sequences_of(claim.formulas());
    all.extend(claim.sequences.keys().cloned());
    all
}

/// A derivative by what is always a whole number: there is none.
pub(super) fn by_whole_number(claim: &Claim) -> Option<Expr> {
    let whole = |symbol: &Symbol| claim.domains.get(symbol).is_some_and(|d| d.integer);
    if !claim.domains.values().any(|domain| domain.integer) {
        return None;
    }
    fn find(term: &Expr, whole: &impl Fn(&Symbol) -> bool) -> Option<Expr> {
        match term {
            Expr::Derivative { variable, .. } | Expr::Partial { variable, .. }
                if whole(variable) =>
            {
                Some(term.clone())
            }
            term => term.children().find_map(|child| find(child, whole)),
        }
    }
    let mut terms = claim.formulas().flat_map(Formula::terms);
    terms.find_map(|term| find(term, &whole))
}

/// The symbols that depend on no variable, and the sequences whose elements do not.
pub(super) fn constants(claim: &Claim, named: &[&Symbol], pi: bool) -> Set<Symbol> {
    let declared = claim.domains.iter().filter(|(_, d)| d.constant);
    // `x` may be something else than the elements `x_i`.
    let sequences = (claim.sequences.iter()).filter(|(s, d)| d.constant && !named.contains(s));
    let symbols = declared.chain(sequences).map(|(symbol, _)| symbol.clone());
    symbols.chain(pi.then(|| Symbol::new("\\pi"))).collect()
}

/// The symbols of which a premise says throughout that they do not depend on another, `dk/ds = 0`, by which is integrated or which goes
/// to a limit.
pub(super) fn still(claim: &Claim) -> Set<(Symbol, Symbol)> {
    let integrated = |variable: &Symbol| {
        let over = |part: &Expr| match part {
            Expr::Integral { variable: own, .. } | Expr::Limit { variable: own, .. } => {
                own == variable
            }
            _ => false,
        };
        let mut terms = claim.formulas().flat_map(Formula::terms);
        terms.any(|term| term.any(&over))
    };
    let laws = claim.hypotheses.iter();
    let laws = laws.filter(|own| own.standing == Standing::Identity);
    let pair = |law: &Hypothesis| match law.formula.as_equation()? {
        (Expr::Derivative { body, variable }, Expr::Number(zero)) if zero.is_zero() => {
            match &**body {
                Expr::Symbol(symbol) if integrated(variable) => {
                    Some((symbol.clone(), variable.clone()))
                }
                _ => None,
            }
        }
        _ => None,
    };
    laws.filter_map(pair).collect()
}

/// The symbols that say how many elements there are. A sum up to the index of another says nothing of the symbol
/// outside of it.
pub(super) fn counts(claim: &Claim) -> Set<Symbol> {
    fn collect<'a>(expr: &'a Expr, bound: &mut Vec<&'a Symbol>, found: &mut Set<Symbol>) {
        if let Expr::Series { to, .. } = expr
            && let Expr::Symbol(count) = &**to
            && !bound.contains(&count)
        {
            found.insert(count.clone());
        }
        let scope = expr.binder().and_then(|_| expr.scope());
        let Some((own, body, outside)) = scope else {
            let children = expr.children();
            return children.for_each(|child| collect(child, bound, found));
        };
        outside.into_iter().for_each(|e| collect(e, bound, found));
        bound.push(own);
        collect(body, bound, found);
        bound.pop();
    }
    let mut found = Set::new();
    for formula in claim.formulas() {
        formula
            .terms()
            .into_iter()
            .for_each(|term| collect(term, &mut Vec::new(), &mut found));
        if let Formula::AllEqual {
            to: Expr::Symbol(count),
            ..
        } = formula
        {
            found.insert(count.clone());
        }
    }
    found
}
