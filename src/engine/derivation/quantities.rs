//! The quantities that a text names symbols as: "a rod of length $L$", "where $T(x)$ is the temperature".

use crate::algebra::{Expr, Symbol};
use crate::dimension;
use crate::document::{Quantity, Subject};
use crate::notation::read_symbol;

use super::equation::first_goal;
use super::page::Page;
use super::qualities::named;
use super::rows::Part;
use super::supposed::is_number;

/// What may stand after the symbol that a text gives a name to.
const RELATIONS: [&str; 7] = ["\\ll", "\\gg", "\\approx", "\\le", "\\ge", "\\in", "\\neq"];

impl Page {
    /// Whether a symbol stands for a number, or for so much of a unit, and is declared to be nothing else.
    pub fn is_number(&self, symbol: &Symbol) -> bool {
        is_number(symbol) && !self.domains.contains_key(symbol)
    }

    /// Whether a symbol stands for neither a number nor a unit.
    pub fn is_quantity(&self, symbol: &Symbol) -> bool {
        !symbol.is_unit() && !self.is_number(symbol)
    }

    /// Takes up what prose says that symbols are. Of what it says to be quantities of two kinds neither is kept.
    pub(super) fn name_quantities(&mut self, quantities: &[Quantity]) {
        for quantity in quantities {
            for symbol in self.symbols_of(quantity) {
                let known = self.quantities.entry(symbol).or_insert(Some(*quantity));
                let kind = |own: &Quantity| dimension::named(own.name);
                if known
                    .as_ref()
                    .is_some_and(|own| kind(own) != kind(quantity))
                {
                    *known = None;
                }
            }
        }
    }

    /// Takes up what the words before a display call the symbol that it gives: "The kinetic energy is $$K = \\frac12 m v^2$$". What they said of it
    /// before counts.
    pub(super) fn name_subject(&mut self, subject: Subject, display: &Part) {
        let Some(goal) = display.statements.iter().flatten().find_map(first_goal) else {
            return;
        };
        let Some((Expr::Symbol(symbol) | Expr::Apply(symbol, _), _)) = goal.formula.as_equation()
        else {
            return;
        };
        if subject.may_be(symbol.name()) && !self.quantities.contains_key(symbol) {
            let side = goal.sides.0;
            let quantity = Quantity {
                name: subject.name,
                body: side,
                first: side,
                is_explained: true,
            };
            self.quantities.insert(symbol.clone(), Some(quantity));
        }
    }

    /// What a name is said of: symbols, or a function where the text gives its argument.
    fn symbols_of(&self, quantity: &Quantity) -> Vec<Symbol> {
        let source = &self.document.source;
        let symbols = named(source, quantity.body);
        if !symbols.is_empty() {
            return symbols;
        }
        let text = source.get(quantity.body.range()).unwrap_or_default();
        // "the speed $v \ll c$", "the temperature $T(x)$"
        let end = text.find(['=', '<', '>', '(', '+', '-']);
        let end = end
            .into_iter()
            .chain(RELATIONS.iter().filter_map(|own| text.find(own)))
            .min();
        let name = end.and_then(|end| read_symbol(&text[..end]).ok());
        name.into_iter().collect()
    }
}
