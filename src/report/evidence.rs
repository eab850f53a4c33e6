//! Terms evaluated at a counterexample, in exact numbers.
//!
//! It repeats in its own way what the kernel has done to accept the witness: a reader sees both sides as numbers.

use std::collections::{BTreeMap, BTreeSet};

use num_traits::{Signed, ToPrimitive, Zero};

use crate::algebra::{
    Atoms, BigRational, Conditions, Expr, Formula, Fraction, Function, Lowering, Polynomial,
    Symbol, expr_of_atom, expr_of_fraction,
};
use crate::kernel::{Assignment, Claim, definition};

use super::words;

/// A definite sum longer than this is not written out.
const LONGEST_SUM: i64 = 512;

/// A point, with what is needed to evaluate the terms of a claim at it.
#[derive(Clone, Debug)]
pub struct Point<'a> {
    claim: &'a Claim,
    at: &'a Assignment,
    defined: BTreeMap<Symbol, Expr>,
}

impl<'a> Point<'a> {
    /// The point that an assignment gives, the definitions that it puts in included.
    pub fn new(claim: &'a Claim, at: &'a Assignment) -> Self {
        let hypotheses = at.unfold.iter().filter_map(|&h| claim.hypotheses.get(h));
        let mut defined = BTreeMap::new();
        for hypothesis in hypotheses {
            let known = |formula: &Formula| {
                let mut formula = formula.clone();
                for (symbol, term) in &defined {
                    formula = formula.map_terms(|t| t.substitute(symbol, term));
                }
                formula
            };
            if let Some((symbol, term)) = definition(&known(&hypothesis.formula)) {
                defined.insert(symbol, term);
            }
        }
        Point { claim, at, defined }
    }

    /// `v₀ = 1`, `u = (1, 1, 4)`: every value that was chosen.
    pub fn values(&self) -> Vec<(String, String)> {
        let symbols = self.at.symbols.iter();
        let mut all: Vec<(String, String)> = symbols
            .map(|(symbol, value)| (words::symbol(symbol), number(value)))
            .collect();
        for (sequence, elements) in &self.at.sequences {
            let elements: Vec<String> = elements.iter().map(number).collect();
            all.push((
                words::symbol(sequence),
                format!("({})", elements.join(", ")),
            ));
        }
        for ((symbol, variable), value) in &self.at.derivatives {
            let name = format!("d{}/d{}", words::symbol(symbol), words::symbol(variable));
            all.push((name, number(value)));
        }
        all
    }

    /// The values of the symbols of one formula, as a list.
    pub fn values_of(&self, formula: &Formula) -> String {
        let wanted: BTreeSet<String> = formula
            .free_symbols()
            .iter()
            .chain(&formula.sequences())
            .map(words::symbol)
            .collect();
        let values = self.values().into_iter();
        let values: Vec<String> = values
            .filter(|(name, _)| wanted.contains(name))
            .map(|(name, value)| format!("{name} = {value}"))
            .collect();
        values.join(", ")
    }

    /// The value of a term; `None` where this simple evaluator finds none.
    pub fn value(&self, term: &Expr) -> Option<BigRational> {
        match term {
            Expr::Number(value) => Some(value.clone()),
            Expr::Symbol(symbol) => self.symbol(symbol),
            Expr::Sum(terms) => terms.iter().map(|t| self.value(t)).sum(),
            Expr::Product(factors) => factors.iter().map(|f| self.value(f)).product(),
            Expr::Negate(inner) => Some(-self.value(inner)?),
            Expr::Quotient(above, below) => {
                let (above, below) = (self.value(above)?, self.value(below)?);
                (!below.is_zero()).then(|| above / below)
            }
            Expr::Power(base, exponent) => {
                let (base, exponent) = (self.value(base)?, self.value(exponent)?);
                let power = Expr::Power(Expr::Number(base).into(), Expr::Number(exponent).into());
                let value = self.lowered(&power)?.0.as_constant()?;
                Some(value.to_big())
            }
            Expr::Series {
                index,
                from,
                to,
                body,
            } => {
                let from = self.value(from).filter(|v| v.is_integer())?.to_i64()?;
                let to = self.value(to).filter(|v| v.is_integer())?.to_i64()?;
                if to.checked_sub(from)? > LONGEST_SUM {
                    return None;
                }
                (from..=to)
                    .map(|at| self.value(&body.at_index(index, u32::try_from(at).unwrap_or(0))))
                    .sum()
            }
            Expr::Call(function, argument) => {
                let argument = self.value(argument)?;
                match function {
                    Function::Abs => Some(argument.abs()),
                    Function::Ceiling => Some(argument.ceil()),
                    Function::Floor => Some(argument.floor()),
                    _ => None,
                }
            }
            Expr::Derivative { .. } | Expr::Limit { .. } => self.limit(term),
            Expr::Element { .. } | Expr::Apply(..) | Expr::Integral { .. } => None,
        }
    }

    fn symbol(&self, symbol: &Symbol) -> Option<BigRational> {
        if let Some(value) = self.at.symbols.get(symbol) {
            return Some(value.clone());
        }
        if let Some(term) = self.defined.get(symbol) {
            return self.value(term);
        }
        let (name, subscript) = symbol.name().rsplit_once('_')?;
        let elements = self.at.sequences.get(&Symbol::new(name))?;
        let digits = subscript.trim_start_matches('{').trim_end_matches('}');
        let position: usize = digits.parse().ok()?;
        elements.get(position.checked_sub(1)?).cloned()
    }

    fn unfolded(&self, term: &Expr) -> Expr {
        let defined = self.defined.iter();
        defined.fold(term.clone(), |term, (symbol, value)| {
            term.substitute(symbol, value)
        })
    }

    /// A term with its derivatives and limits taken, as a quotient of polynomials.
    pub fn computed(&self, term: &Expr) -> Option<Expr> {
        let (value, atoms) = self.lowered(&self.unfolded(term))?;
        Some(expr_of_fraction(&value, &atoms))
    }

    /// Derivatives and limits are taken of the term, not of its value.
    fn limit(&self, term: &Expr) -> Option<BigRational> {
        let unfolded = self.unfolded(term);
        let (value, atoms) = self.lowered(&unfolded)?;
        let mut result = self.polynomial(value.numerator(), &atoms)?;
        for (factor, exponent) in value.denominator() {
            let below = self.polynomial(&factor.pow(exponent).ok()?, &atoms)?;
            if below.is_zero() {
                return None;
            }
            result /= below;
        }
        Some(result)
    }

    fn polynomial(&self, polynomial: &Polynomial, atoms: &Atoms) -> Option<BigRational> {
        let value = polynomial.evaluate(|var| {
            let term = expr_of_atom(atoms.atom(var));
            let value = match &term {
                Expr::Derivative { body, variable } => match &**body {
                    Expr::Symbol(own) => {
                        let chosen = self.at.derivatives.get(&(own.clone(), variable.clone()));
                        chosen.cloned().or_else(|| Some(BigRational::zero()))
                    }
                    _ => None,
                },
                Expr::Limit { .. } => None,
                _ => self.value(&term),
            };
            value.map(Into::into)
        });
        value.ok()?.map(|value| value.to_big())
    }

    fn lowered(&self, term: &Expr) -> Option<(Fraction, Atoms)> {
        let constant = |d: &crate::kernel::Domain| d.constant || d.integer;
        let domains = self.claim.domains.iter();
        let constants = domains.filter(|(_, d)| constant(d)).map(|(s, _)| s.clone());
        let mut atoms = Atoms::default();
        let value = Lowering {
            atoms: &mut atoms,
            sequences: &self.claim.sequences.keys().cloned().collect(),
            constants: &constants.collect(),
            conditions: Conditions::default(),
        }
        .lower(term)
        .ok()?;
        Some((value, atoms))
    }

    /// The two sides of a relation, where both have a value.
    pub fn sides(&self, formula: &Formula) -> Option<(BigRational, BigRational)> {
        match formula {
            Formula::Relation { left, right, .. } => Some((self.value(left)?, self.value(right)?)),
            Formula::AllEqual { .. } => None,
        }
    }
}

/// A number as printed: `−1/3`.
pub fn number(value: &BigRational) -> String {
    match value.is_negative() {
        true => format!("−{}", -value),
        false => value.to_string(),
    }
}
