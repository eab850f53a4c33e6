//! Partial derivatives.
//!
//! **Statement.** `\left(\frac{\partial f}{\partial x}\right)_{y, z}` is the derivative of `f` by `x` along the line on which `y` and `z` do not
//! change. Of a term it is made, by the rules of differentiation, of those of its symbols: 1 of `x`, 0 of what is held fixed and of what is
//! declared constant, and of any other symbol an unknown. So it is where nothing is told to be held fixed, too: all other symbols then have
//! unknown slopes. Two of them that are taken in the same variables may be taken in either order (Schwarz).

use super::lower::{Lowered, Lowering};
use super::{Expr, Symbol};
use crate::sorted::Set;

impl Expr {
    /// What is differentiated partially, outermost first, by variables of which it is not told what is held fixed; and these.
    pub fn without_partials(&self) -> (Vec<Symbol>, &Expr) {
        let (mut variables, mut inner) = (Vec::new(), self);
        while let Expr::Partial {
            body,
            variable,
            held: None,
        } = inner
        {
            variables.push(variable.clone());
            inner = body;
        }
        (variables, inner)
    }
}

/// What is told to be held fixed while a partial derivative is taken, if anything is.
#[derive(Clone, Debug)]
pub struct Held(Option<Box<[Symbol]>>);

impl Held {
    pub(super) fn holds(&self, symbol: &Symbol) -> bool {
        self.0.as_ref().is_some_and(|held| held.contains(symbol))
    }

    /// The partial derivative of an unknown, which is one itself; where the order is free, what comes first by name is done last.
    pub(super) fn slope_of(&self, body: Expr, variable: &Symbol) -> Expr {
        match body {
            Expr::Partial {
                body: inner,
                variable: first,
                held,
            } if first < *variable && are_of_one_set((&first, &held), (variable, &self.0)) => {
                Expr::Partial {
                    body: self.slope_of((*inner).clone(), variable).into(),
                    variable: first,
                    held,
                }
            }
            // What is a function of the variable alone does not depend on anything else.
            Expr::Apply(_, ref arguments) if matches!(&arguments[..], [Expr::Symbol(own)] if own == variable) => {
                body.differentiated_by(variable)
            }
            body => Expr::Partial {
                body: body.into(),
                variable: variable.clone(),
                held: self.0.clone(),
            },
        }
    }
}

/// Whether two partial derivatives are taken in the same variables: each holds the other's fixed, and both the same besides.
fn are_of_one_set(
    a: (&Symbol, &Option<Box<[Symbol]>>),
    b: (&Symbol, &Option<Box<[Symbol]>>),
) -> bool {
    let all = |(variable, held): (&Symbol, &Option<Box<[Symbol]>>)| {
        let held = held.as_ref()?.iter();
        Some(held.chain([variable]).cloned().collect::<Set<Symbol>>())
    };
    all(a) == all(b)
}

impl Lowering<'_> {
    /// The value of a partial derivative, `held` being what is told to be held fixed.
    pub(super) fn partial(
        &mut self,
        body: &Expr,
        variable: &Symbol,
        held: Option<&[Symbol]>,
    ) -> Lowered {
        let held = Held(held.map(Into::into));
        self.differentiated(body, variable, Some(held))
    }
}
