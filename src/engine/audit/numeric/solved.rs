//! What an equation says that a symbol is: plainly, or solved for it where it occurs once.

use num_traits::Zero;

use crate::algebra::{
    BigRational, Expr, Formula, Function, Symbol, element_parts, split_subscript,
};
use crate::derivation::Assumed;

use super::{Known, is_evaluable};

impl Known<'_> {
    /// What an equation says that a symbol is: plainly, `s = …`, or solved for it.
    pub(super) fn solved(&self, formula: &Formula, symbol: &Symbol, plain: bool) -> Option<Expr> {
        let (left, right) = formula.as_equation()?;
        let is_symbol = |term: &Expr| matches!(term, Expr::Symbol(own) if own == symbol);
        let defines = is_symbol(left) && !right.mentions(symbol);
        if plain || defines {
            return (plain && defines).then(|| self.worked_out(right).unwrap_or(right).clone());
        }
        match (occurrences(left, symbol), occurrences(right, symbol)) {
            (1, 0) => self.isolate(left, right.clone(), symbol),
            (0, 1) => self.isolate(right, left.clone(), symbol),
            _ => None,
        }
    }

    /// What a term comes to that is no arithmetic, where the next link of its chain says so: `\int_a^b p \, dV = n R T \ln\frac{b}{a}`.
    fn worked_out(&self, term: &Expr) -> Option<&Expr> {
        let says = |own: &&Assumed| {
            own.formula
                .as_equation()
                .is_some_and(|(left, _)| left == term)
        };
        match is_evaluable(term) {
            true => None,
            false => Some(self.assumed.iter().find(says)?.formula.as_equation()?.1),
        }
    }

    /// `symbol` from `term = value`, where it occurs once. Divisors are looked at when figures are put in.
    fn isolate(&self, term: &Expr, value: Expr, symbol: &Symbol) -> Option<Expr> {
        let over = |a: Expr, b: Expr| Expr::Quotient(a.into(), b.into());
        match term {
            Expr::Symbol(own) => (own == symbol).then_some(value),
            Expr::Negate(inner) => self.isolate(inner, Expr::Negate(value.into()), symbol),
            Expr::Sum(terms) => {
                let at = terms.iter().position(|t| t.mentions(symbol))?;
                let rest = terms.iter().enumerate().filter(|(other, _)| *other != at);
                let moved = rest.map(|(_, t)| Expr::Negate(t.clone().into()));
                let value = Expr::Sum(std::iter::once(value).chain(moved).collect());
                self.isolate(&terms[at], value, symbol)
            }
            Expr::Product(factors) => {
                let at = factors.iter().position(|t| t.mentions(symbol))?;
                let rest = factors.iter().enumerate().filter(|(other, _)| *other != at);
                let value = rest.fold(value, |value, (_, factor)| over(value, factor.clone()));
                self.isolate(&factors[at], value, symbol)
            }
            Expr::Quotient(above, below) if above.mentions(symbol) => {
                let value = Expr::Product([value, (**below).clone()].into());
                self.isolate(above, value, symbol)
            }
            Expr::Quotient(above, below) => {
                self.isolate(below, over((**above).clone(), value), symbol)
            }
            Expr::Power(base, exponent) => {
                // Only what is declared positive has one root.
                let positive =
                    matches!(&**base, Expr::Symbol(own) if own == symbol && self.is_positive(own));
                let one = Expr::integer(1);
                let inverse = over(one, (**exponent).clone());
                positive.then(|| Expr::Power(value.into(), inverse.into()))
            }
            Expr::Call(Function::Exp, inner) => {
                self.isolate(inner, Expr::Call(Function::Ln, value.into()), symbol)
            }
            Expr::Call(Function::Ln, inner) => {
                self.isolate(inner, Expr::Call(Function::Exp, value.into()), symbol)
            }
            _ => None,
        }
    }

    fn is_positive(&self, symbol: &Symbol) -> bool {
        let mut declared = self
            .pages
            .iter()
            .filter_map(|&page| self.derivation.pages[page].domains.get(symbol));
        let zero = BigRational::zero();
        declared.next().is_some_and(|domain| {
            let lower = domain.lower.as_ref();
            lower.is_some_and(|(low, strict)| *low > zero || *low == zero && *strict)
        })
    }
}

/// What an equation says of an element, of which it speaks with an index: `E_3` by `E_n = E_1/n^2`.
pub(super) fn of_element(formula: &Formula, symbol: &Symbol) -> Option<Expr> {
    let (Expr::Symbol(general), value) = formula.as_equation()? else {
        return None;
    };
    let (stem, index) = split_subscript(general.name())?;
    let index = Symbol::new(index);
    let (own, position) = element_parts(symbol)?;
    if own.name() != stem || !value.mentions(&index) {
        return None;
    }
    let is_other = |other: &Symbol| {
        let inner = split_subscript(other.name()).map(|(_, inner)| inner);
        inner.is_some_and(|inner| inner.contains(index.name()))
    };
    let has_others = value.free_symbols().iter().any(is_other) || value.has_elements();
    (!has_others).then(|| value.substitute(&index, &Expr::integer(position)))
}

fn occurrences(term: &Expr, symbol: &Symbol) -> usize {
    match term {
        Expr::Symbol(own) => usize::from(own == symbol),
        // A binder is never solved.
        _ if term.binder().is_some() => 2 * usize::from(term.mentions(symbol)),
        _ => term
            .children()
            .map(|child| occurrences(child, symbol))
            .sum(),
    }
}
