//! What the equations of a page say of what depends on what.

use crate::algebra::{Expr, Formula, Symbol};
use crate::sorted::{Map, Set};

use super::{is_partial, name_of};

/// A formula for a name, `E = \frac12 m v^2`, or for a function, `y(x, t) = A \sin(k x - \omega t)`.
pub(super) struct Given {
    pub of: Expr,
    /// It stands behind the term, `p x + q y = m`.
    is_last: bool,
    /// The chain of equations that it stands in.
    pub chain: usize,
    pub symbols: Set<Symbol>,
    /// The sequences in it: `y_i` is not `y`.
    pub sequences: Set<Symbol>,
    /// Those of them that are nothing but summands: `T` and `V` in `T - V`.
    pub summands: Set<Symbol>,
}

/// What the equations of a page say of what depends on what.
#[derive(Default)]
pub(super) struct Said {
    pub formulas: Vec<Given>,
    /// What is differentiated partially.
    pub dependent: Set<Symbol>,
    /// What is differentiated by partially, or is an argument: these do not depend on each other.
    pub independent: Set<Symbol>,
    /// What is differentiated otherwise.
    pub moving: Set<Symbol>,
    /// What the formulas that speak of a symbol are of.
    spoken_of_in: Map<Symbol, Set<Symbol>>,
    /// What depends on a symbol by its formulas, once that was asked.
    leading: Map<Symbol, Set<Symbol>>,
    /// Partial derivatives of terms that hold fixed what the equation does not speak of as changing.
    pub presumed: Set<Expr>,
    /// What is not clear, with the variable.
    pub unclear: Set<(Symbol, Symbol)>,
}

impl Said {
    /// Learns from terms that are equal to each other.
    pub(super) fn learn(&mut self, sides: &[&Expr], chain: usize) {
        for (at, of) in sides.iter().enumerate() {
            self.see(of);
            let Some(name) = name_of(of) else { continue };
            let others = sides.iter().enumerate().filter(|(other, _)| *other != at);
            for (_, term) in others {
                let says_nothing = matches!(term, Expr::Number(_)) || name_of(term).is_some();
                if !says_nothing && !term.mentions(name) && !term.any(&is_partial) {
                    self.formulas.push(Given {
                        of: (*of).clone(),
                        is_last: sides.len() == 2 && at == 1,
                        chain,
                        symbols: term.free_symbols(),
                        sequences: Formula::sequences_in(term),
                        summands: summands(term),
                    });
                }
            }
        }
    }

    fn see(&mut self, term: &Expr) {
        match term {
            Expr::Partial { body, variable, .. } => {
                self.dependent.extend(name_of(body).cloned());
                self.independent.insert(variable.clone());
                self.independent.extend(term.held().iter().cloned());
            }
            Expr::Derivative { body, .. } => self.moving.extend(name_of(body).cloned()),
            Expr::Apply(_, arguments) => {
                let names = arguments.iter().filter_map(|own| match own {
                    Expr::Symbol(name) => Some(name.clone()),
                    _ => None,
                });
                self.independent.extend(names);
            }
            _ => {}
        }
        term.children().for_each(|child| self.see(child));
    }

    pub(super) fn look_up(&mut self) {
        // What ties several of the variables is a constraint, and no formula for what it keeps them at.
        let independent = &self.independent;
        let ties = |given: &Given| {
            let mut variables = given
                .symbols
                .iter()
                .filter(|own| independent.contains(*own));
            variables.nth(1).is_some()
        };
        self.formulas
            .retain(|given| !(given.is_last && ties(given)));
        for given in &self.formulas {
            let Some(name) = name_of(&given.of) else {
                continue;
            };
            for symbol in &given.symbols {
                let known = self.spoken_of_in.entry(symbol.clone()).or_default();
                known.insert(name.clone());
            }
        }
    }

    /// What depends on a symbol by its formula, or by that of something in it, and is no variable itself.
    pub(super) fn leading_to(&mut self, variable: &Symbol) -> Set<Symbol> {
        if let Some(known) = self.leading.get(variable) {
            return known.clone();
        }
        let mut found = Set::new();
        let mut open = vec![variable.clone()];
        while let Some(symbol) = open.pop() {
            let Some(names) = self.spoken_of_in.get(&symbol) else {
                continue;
            };
            for name in names {
                if !self.independent.contains(name) && found.insert(name.clone()) {
                    open.push(name.clone());
                }
            }
        }
        self.leading.insert(variable.clone(), found.clone());
        found
    }
}

/// The symbols that are summands of a term and stand nowhere else in it.
fn summands(term: &Expr) -> Set<Symbol> {
    let Expr::Sum(terms) = term else {
        return Set::new();
    };
    let (mut found, mut elsewhere) = (Set::new(), Set::new());
    for own in terms.iter() {
        match own {
            Expr::Symbol(name) => {
                found.insert(name.clone());
            }
            Expr::Negate(inner) if matches!(**inner, Expr::Symbol(_)) => {
                found.append(&mut inner.free_symbols());
            }
            other => elsewhere.append(&mut other.free_symbols()),
        }
    }
    found.retain(|own| !elsewhere.contains(own));
    found
}
