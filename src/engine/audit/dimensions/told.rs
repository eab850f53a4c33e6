//! The units in which a text gives its quantities, where no dimension is declared: `\rho = 998\,\mathrm{kg/m^3}`.
//!
//! Many texts leave units out where they calculate, so nothing is learnt from one equation about another. A statement in symbols is at fault
//! where it disagrees with itself once these have the dimensions that the text gives them in.

use std::sync::Arc;

use crate::algebra::{Dimension, Expr, Formula, Function, Rational, Symbol};
use crate::derivation::{Derivation, Source, formulas};
use crate::dimension::{Inference, Reading};
use crate::kernel::dimension::Scope;
use crate::notation::{has_decimals, has_units, is_figures, measured};
use crate::sorted::Tree;

use super::{Dimensions, is_crossed_out, scope};

/// What a text gives with units, by symbol: in which dimension, and the words for it.
pub type Told = Tree<Symbol, (Dimension, Formula)>;

impl Dimensions {
    /// Holds each statement against the units that its page tells.
    pub(super) fn told(derivation: &Derivation) -> Dimensions {
        let mut all = Dimensions::default();
        for page in 0..derivation.pages.len() {
            let told = told(derivation, page);
            if !told.is_empty() {
                let dimensions = told.iter().map(|(own, (of, _))| (own.clone(), of.clone()));
                let scope = scope(derivation, page, &dimensions.collect(), &mut all);
                all.alone(derivation, page, &Arc::new(scope));
            }
            all.told.push(told);
        }
        all
    }

    /// Each statement of a page by itself.
    fn alone(&mut self, derivation: &Derivation, page: usize, scope: &Arc<Scope>) {
        for at in derivation.equations_of(page) {
            for (part, statement) in derivation.equations[at].statements().iter().enumerate() {
                let compared = formulas(statement).into_iter().filter(is_symbolic);
                let readings: Vec<Reading> = compared
                    .map(|formula| Reading {
                        formula,
                        scope: Arc::clone(scope),
                    })
                    .collect();
                let crossed = is_crossed_out(statement);
                let read = Inference::default().read(&readings, &Source::Equation(at), crossed);
                if let Err(conflict) = read {
                    self.conflicts.insert((at, part), *conflict);
                }
            }
        }
    }
}

/// What a page tells with units, but for what it gives in several dimensions, or once without units.
fn told(derivation: &Derivation, page: usize) -> Told {
    let locals = derivation.pages[page].locals.iter();
    let supposed = locals.flat_map(|local| local.formulas.iter().map(|own| Formula::clone(own)));
    let last = derivation.equations_of(page).last();
    let printed = last
        .map(|at| derivation.figures_before(at))
        .unwrap_or_default();
    let printed = printed.into_iter().map(|own| own.goal.formula);
    let mut found: Tree<Symbol, Option<(Dimension, Formula)>> = Tree::new();
    for formula in supposed.chain(printed) {
        let Some((Expr::Symbol(symbol), value)) = formula.as_equation() else {
            continue;
        };
        if !is_figures(value) || *value == Expr::integer(0) {
            continue;
        }
        let own = dimension_of(value).filter(|_| has_units(value));
        let own = own.map(|own| (own, formula.clone()));
        let known = found.entry(symbol.clone()).or_insert_with(|| own.clone());
        let dimension = |of: &Option<(Dimension, Formula)>| of.as_ref().map(|(own, _)| own.clone());
        if dimension(known) != dimension(&own) {
            *known = None;
        }
    }
    let found = found.iter();
    found
        .filter_map(|(symbol, own)| Some((symbol.clone(), own.clone()?)))
        .collect()
}

/// The dimension of so many units.
fn dimension_of(quantity: &Expr) -> Option<Dimension> {
    let one = Rational::from(1);
    match quantity {
        Expr::Number(_) => Some(Dimension::none()),
        Expr::Negate(inner) => dimension_of(inner),
        Expr::Symbol(unit) => measured(unit).map(Dimension::base),
        Expr::Product(factors) => {
            let mut all = Dimension::none();
            for factor in factors.iter() {
                all.multiply(&dimension_of(factor)?, &one);
            }
            Some(all)
        }
        Expr::Quotient(over, under) => Some(dimension_of(over)?.over(&dimension_of(under)?)),
        Expr::Power(base, exponent) => match &**exponent {
            Expr::Number(exponent) => {
                Some(dimension_of(base)?.power(&Rational::from(exponent.clone())))
            }
            _ => None,
        },
        _ => None,
    }
}

/// Whether a formula is said in symbols, but for a side that is so many units: no numbers are put in, and no unit may be left out.
fn is_symbolic(formula: &Formula) -> bool {
    let is_quantity = |term: &Expr| has_units(term) && dimension_of(term).is_some();
    let is_plain = |term: &Expr| {
        let is_figure = is_figures(term) && *term != Expr::integer(0);
        !is_figure && !has_units(term) && !has_decimals(term) && !term.any(&may_lack_units)
    };
    let mut terms = formula.terms().into_iter();
    terms.all(|term| is_quantity(term) || is_plain(term))
}

/// Whether a part of a term may be a number of units, or is a logarithm of one: `5 + 2 t`, `\ln p`.
fn may_lack_units(part: &Expr) -> bool {
    let is_one = |own: &Expr| *own == Expr::integer(1) || *own == Expr::integer(-1);
    let is_number = |own: &Expr| match own {
        Expr::Negate(inner) => matches!(**inner, Expr::Number(_)) && !is_one(inner),
        own => matches!(own, Expr::Number(_)) && !is_one(own),
    };
    match part {
        Expr::Sum(terms) => terms.iter().any(is_number),
        Expr::Call(Function::Ln, of) => !matches!(**of, Expr::Quotient(..)),
        _ => false,
    }
}
