//! Points at which unknown functions are constant.
//!
//! **Statement.** Let an unknown function `f` have the value `c` everywhere: `f(t)` is `c` for every argument, and so are its limits; its
//! derivatives are 0. A hypothesis about `f` in which constants alone are left, once that is put in, is true throughout if it is true
//! at one point. What else the hypotheses say does not concern `f`.

use super::Reject;
use super::witness::Point;
use crate::algebra::{BigRational, Expr, Formula, Rational, Symbol};
use crate::sorted::{Map, Set};

/// A term in which the unknown functions among these applications are constant.
pub fn with_constant_functions(term: &Expr, functions: &Map<Expr, BigRational>) -> Expr {
    let put_in = term.map_children(|part| with_constant_functions(part, functions));
    match &put_in {
        Expr::Apply(name, _) => {
            let is_own = |own: &&Expr| matches!(own, Expr::Apply(own, _) if own == name);
            let value = functions.keys().find(is_own).map(|own| &functions[own]);
            value.map_or(put_in, |value| Expr::Number(value.clone()))
        }
        Expr::Derivative { body, .. } if is_number(body) => Expr::integer(0),
        Expr::Limit { body, .. } if is_number(body) => (**body).clone(),
        _ => put_in,
    }
}

fn is_number(term: &Expr) -> bool {
    matches!(term, Expr::Number(_))
}

/// The name of an unknown function that is applied.
fn applied(term: &Expr) -> Option<&Symbol> {
    match term {
        Expr::Apply(name, _) => Some(name),
        _ => None,
    }
}

/// What runs in formulas: what functions are applied to, and what is bound or differentiated by.
pub fn running_in<'a>(formulas: impl Iterator<Item = &'a Formula>) -> Set<Symbol> {
    let mut running = Set::new();
    for term in formulas.flat_map(Formula::terms) {
        collect_running(term, &mut running);
    }
    running
}

fn collect_running(term: &Expr, running: &mut Set<Symbol>) {
    if let Expr::Apply(_, arguments) = term {
        running.extend(arguments.iter().flat_map(Expr::free_symbols));
    }
    running.extend(term.binder().cloned());
    (term.children()).for_each(|part| collect_running(part, running));
}

impl Point<'_> {
    /// Whether the unknown functions that the point gives may be constant.
    pub(super) fn functions_may_be_constant(&self) -> Result<(), Reject> {
        let problem = self.problem;
        let given = self.at.functions.iter();
        let given = given.filter_map(|(term, value)| Some((applied(term)?, value)));
        let given: Vec<(&Symbol, &BigRational)> = given.collect();
        if given.is_empty() {
            return Ok(());
        }
        for (at, &(name, value)) in given.iter().enumerate() {
            let domain = self.claim.domains.get(name);
            if domain.is_some_and(|own| !own.contains(value)) {
                return Err(Reject::OutsideDomain);
            }
            // It has one value, and no other meaning.
            let is_plain = |term: &Expr| {
                let plain = |part: &Expr| match part {
                    Expr::Symbol(own) => own == name,
                    Expr::Element { sequence, .. } => sequence == name,
                    part => part.binder() == Some(name),
                };
                term.any(&plain)
            };
            let mut terms = problem.statements().flat_map(Formula::terms);
            if given[..at].iter().any(|own| own.0 == name) || terms.any(is_plain) {
                return Err(Reject::NoValue);
            }
        }
        let running = running_in(problem.statements());
        let is_constant =
            |symbol: &Symbol| self.claim.is_constant(symbol) && !running.contains(symbol);
        let concerned = |term: &Expr| given.iter().any(|own| term.mentions(own.0));
        for (formula, _) in &problem.formulas {
            let terms = formula.terms();
            if !terms.iter().any(|term| concerned(term)) {
                continue;
            }
            let constant = terms.into_iter().all(|term| {
                let left = with_constant_functions(term, &self.at.functions);
                !left.has_elements() && left.free_symbols().iter().all(is_constant)
            });
            if !constant || matches!(**formula, Formula::AllEqual { .. }) {
                return Err(Reject::NoCourse);
            }
        }
        Ok(())
    }

    /// A term that has a value because unknown functions are constant, with these put in.
    pub(super) fn with_functions(&self, term: &Expr) -> Option<Expr> {
        let mut given = self.at.functions.keys().filter_map(applied);
        let concerned = given.any(|name| term.mentions(name));
        concerned.then(|| with_constant_functions(term, &self.at.functions))
    }

    /// Whether a term does not move because unknown functions are constant.
    pub(super) fn stands_still(&self, term: &Expr) -> bool {
        let is_fixed = |own: Expr| own.free_symbols().is_empty() && !own.has_elements();
        self.with_functions(term).is_some_and(is_fixed)
    }

    /// The value of a term with unknown functions put in, where all that it needs is so.
    pub(super) fn with_functions_put_in(&mut self, term: &Expr) -> Result<Rational, Reject> {
        let mut lowering = self.problem.lowering_over(self.atoms.to_mut());
        let value = lowering.lower(term)?;
        let conditions = lowering.conditions;
        match self.is_defined(&conditions)? {
            true => self.fraction(&value)?.ok_or(Reject::NoValue),
            false => Err(Reject::NoValue),
        }
    }
}
