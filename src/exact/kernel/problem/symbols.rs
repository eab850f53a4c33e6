//! What a claim says of its symbols: which name sequences, which depend on nothing, which say how many elements there are.

use num_traits::Zero;

use super::super::{Claim, Hypothesis, Standing};
use crate::algebra::{Expr, Formula, Symbol};
use crate::sorted::Set;

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

/// The symbols that name sequences, declared or not, and those that say how many elements there are. A sum up to the index of another
/// says nothing of the symbol outside of it.
pub(in crate::kernel) fn sequences_and_counts(claim: &Claim) -> (Set<Symbol>, Set<Symbol>) {
    let mut found = Sums {
        sequences: claim.sequences.keys().cloned().collect(),
        ..Sums::default()
    };
    for formula in claim.formulas() {
        let terms = formula.terms().into_iter();
        terms.for_each(|term| found.collect(term));
        if let Formula::AllEqual { sequence, to, .. } = formula {
            found.sequences.insert(sequence.clone());
            if let Expr::Symbol(count) = to {
                found.counts.insert(count.clone());
            }
        }
    }
    (found.sequences, found.counts)
}

/// What sums are of.
#[derive(Default)]
struct Sums<'a> {
    sequences: Set<Symbol>,
    counts: Set<Symbol>,
    /// The indices and variables of what is around.
    bound: Vec<&'a Symbol>,
}

impl<'a> Sums<'a> {
    fn collect(&mut self, expr: &'a Expr) {
        match expr {
            // Most terms are one of these.
            Expr::Symbol(_) | Expr::Number(_) => return,
            Expr::Sum(terms) | Expr::Product(terms) => {
                return terms.iter().for_each(|term| self.collect(term));
            }
            Expr::Quotient(a, b) | Expr::Power(a, b) => {
                self.collect(a);
                return self.collect(b);
            }
            Expr::Element { sequence, .. } => {
                self.sequences.insert(sequence.clone());
            }
            Expr::Series { to, .. } => {
                if let Expr::Symbol(count) = &**to
                    && !self.bound.contains(&count)
                {
                    self.counts.insert(count.clone());
                }
            }
            _ => {}
        }
        let scope = expr.binder().and_then(|_| expr.scope());
        let Some((own, body, outside)) = scope else {
            return expr.children().for_each(|child| self.collect(child));
        };
        outside.into_iter().for_each(|e| self.collect(e));
        self.bound.push(own);
        self.collect(body);
        self.bound.pop();
    }
}
