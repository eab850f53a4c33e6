//! Terms evaluated at a counterexample, in exact numbers.
//!
//! It repeats in its own way what the kernel has done to accept the witness: a reader sees both sides as numbers.

use num_traits::{One, Signed};

use crate::algebra::{
    Atoms, BigRational, Expr, Formula, Lowering, Symbol, Values, as_printed, effort,
    expr_of_fraction,
};
use crate::audit::Judged;
use crate::derivation::values_at;
use crate::kernel::{Assignment, Claim, in_powers_of_pi, with_constant_functions};
use crate::notation::plain;
use crate::search::without_rational_points;
use crate::sorted::Set;

use super::algebraic::{Exact, Root};
use super::words;

/// A side that takes more work is not evaluated again to be shown, as [`effort`] counts it.
const MOST_WORK: u64 = 2_000_000;

/// A point, with what is needed to evaluate the terms of a claim at it.
#[derive(Clone, Debug)]
pub struct Point<'a> {
    claim: &'a Claim,
    at: &'a Assignment,
    values: Values,
    root: Option<Root<'a>>,
}

impl<'a> Point<'a> {
    /// The point that an assignment gives, the definitions that it puts in included.
    pub fn new(claim: &'a Claim, at: &'a Assignment) -> Self {
        let values = values_at(claim, at);
        let root = Root::of(at);
        Point {
            claim,
            at,
            values,
            root,
        }
    }

    /// `v₀ = 1`, `u = (1, 1, 4)`: every value that was chosen.
    pub fn values(&self) -> Vec<(String, String)> {
        let symbols = self.at.symbols.iter();
        // Figures are in units of the SI, and no page names by what its differentials are taken.
        let symbols = symbols.filter(|(own, value)| !own.is_unit() || !value.is_one());
        let symbols = symbols.filter(|(own, _)| !own.is_change());
        let mut all: Vec<(String, String)> = symbols
            .map(|(symbol, value)| (self.label(symbol), number(value)))
            .collect();
        for (sequence, elements) in &self.at.sequences {
            let elements: Vec<String> = elements.iter().map(number).collect();
            all.push((
                words::symbol(sequence),
                format!("({})", elements.join(", ")),
            ));
        }
        for ((symbol, variable), value) in &self.at.derivatives {
            let name = match variable.is_change() {
                true => format!("d{}", words::symbol(symbol)),
                false => format!("d{}/d{}", words::symbol(symbol), words::symbol(variable)),
            };
            all.push((name, number(value)));
        }
        for ((symbol, variable), higher) in self.at.course.iter().flat_map(|c| &c.higher) {
            let differentiated = |body: Expr| Expr::Derivative {
                body: body.into(),
                variable: variable.clone(),
            };
            let mut term = differentiated(Expr::Symbol(symbol.clone()));
            for value in higher {
                term = differentiated(term);
                all.push((plain(&term), number(value)));
            }
        }
        for (symbol, parts) in &self.at.in_pi {
            all.push((words::symbol(symbol), plain(&in_powers_of_pi(parts))));
        }
        for (call, value) in &self.at.functions {
            all.push((plain(call), number(value)));
        }
        all.extend(self.root.iter().flat_map(Root::values));
        all
    }

    /// What is to be said of a point that is not rational: that there is none, where that is known.
    pub fn remark(&self) -> Option<String> {
        self.root.as_ref()?;
        Some(match without_rational_points(self.claim, &self.at.unfold) {
            Some(term) => format!(
                "only irrational points exist: {} = 0 has no rational solution",
                plain(&term)
            ),
            None => "no rational point was found".into(),
        })
    }

    /// The values of the symbols of one formula, as a list.
    pub fn values_of(&self, formula: &Formula) -> String {
        let symbols = formula.free_symbols();
        let calls = self.at.functions.keys();
        let calls = calls.filter(|call| call.free_symbols().is_subset(&symbols));
        let wanted: Set<String> = symbols
            .iter()
            .chain(&formula.sequences())
            .map(|symbol| self.label(symbol))
            .chain(calls.map(plain))
            .chain(self.root.iter().filter_map(|root| root.name_for(&symbols)))
            .collect();
        let values = self.values().into_iter();
        let values: Vec<String> = values
            .filter(|(name, _)| wanted.contains(name))
            .map(|(name, value)| format!("{name} = {value}"))
            .collect();
        values.join(", ")
    }

    /// A symbol as it is printed, told apart from another here that is printed alike.
    fn label(&self, symbol: &Symbol) -> String {
        let own = as_printed(symbol.name()).0;
        // What is printed alike begins alike.
        let begins_alike = |other: &Symbol| other.name().bytes().next() == own.bytes().next();
        let others = self.at.symbols.keys();
        let mut others = others.filter(|other| *other != symbol && begins_alike(other));
        match others.any(|other| as_printed(other.name()).0 == own) {
            true => words::symbol_apart(symbol),
            false => words::symbol(symbol),
        }
    }

    /// A term with its derivatives and limits taken, as a quotient of polynomials.
    pub fn computed(&self, term: &Expr) -> Option<Expr> {
        let mut atoms = Atoms::default();
        let value = Lowering {
            sequences: &self.claim.sequences.keys().cloned().collect(),
            constants: &self.values.constants,
            ..Lowering::plain(&mut atoms)
        }
        .lower(&self.values.unfolded(term))
        .ok()?;
        Some(expr_of_fraction(&value, &atoms))
    }

    /// The two sides of what was judged; nothing of a law into which something else was put, nor of series, for it is other sides that stand
    /// on the page.
    pub fn sides_judged(&self, judged: &Judged) -> Option<(Exact, Exact)> {
        let is_printed = judged.solution().is_none() && !judged.is_expanded();
        let is_printed = is_printed && !judged.is_of_change();
        is_printed.then(|| self.sides(&judged.goal.formula))?
    }

    /// The two sides of a relation, where both have a value.
    pub fn sides(&self, formula: &Formula) -> Option<(Exact, Exact)> {
        match formula {
            Formula::Relation { left, right, .. } => {
                let given = |term: &Expr| {
                    let calls = self.at.functions.iter();
                    let term = with_constant_functions(term, &self.at.functions);
                    calls.fold(term, |term, (call, value)| {
                        term.replace(call, &Expr::Number(value.clone()))
                    })
                };
                // A value of a function at the point says nothing of its slope there.
                let moves = |part: &Expr| match part {
                    Expr::Derivative { body, .. } => {
                        let mut calls = self.at.functions.keys();
                        calls.any(|call| body.any(&|part| part == call))
                    }
                    _ => false,
                };
                if [left, right].into_iter().any(|term| term.any(&moves)) {
                    return None;
                }
                let value = |term| match &self.root {
                    Some(root) => root.value_of(term, &self.values),
                    None => effort::within(MOST_WORK, || {
                        self.values.value(&given(term)).ok().map(Exact::Rational)
                    }),
                };
                Some((value(left)?, value(right)?))
            }
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
