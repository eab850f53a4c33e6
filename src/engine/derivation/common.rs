//! A name for what is common to quantities that a display says are equal: "Call their common value $u$".

use crate::algebra::{Expr, Formula, Relation, Symbol};
use crate::document::Span;
use crate::notation::read_expr;

use super::formulas;
use super::qualities::named;
use super::reader::Reader;
use super::supposed::MOST_BEFORE;

impl Reader<'_> {
    /// Takes up a new symbol as the value of all that the nearest display before says are equal.
    pub(super) fn name_what_is_common(&mut self, body: Span) {
        self.spoken_of.learn(&self.equations, &self.page.locals);
        let names = named(&self.page.document.source, body);
        let [name] = &names[..] else {
            return;
        };
        let recent = self.equations.iter().rev().take(MOST_BEFORE);
        let mut statements = recent.flat_map(|own| own.statements());
        let Some(said) = statements.find_map(|own| with_value(&formulas(own), name)) else {
            return;
        };
        // `u` may be what all `u_i` are.
        let speaks = |own: &Formula| own.free_symbols().contains(name);
        let names_elements = || {
            let sequences = said.iter().all(|own| own.sequences().contains(name));
            let mut statements = self.equations.iter().flat_map(|own| own.statements());
            sequences && !statements.any(|own| formulas(own).iter().any(speaks))
        };
        if self.spoken_of.speaks_of(name) && !names_elements() {
            return;
        }
        self.tell_meaning(said, body);
    }

    /// Takes up a new name for a term that words give it: "The ratio $z/a$ is called $u$".
    pub(super) fn name_term(&mut self, body: Span, term: Span) {
        self.spoken_of.learn(&self.equations, &self.page.locals);
        let source = &self.page.document.source;
        let names = named(source, body);
        let ([name], Ok(term)) = (&names[..], read_expr(source, term)) else {
            return;
        };
        if !self.spoken_of.speaks_of(name) && !term.mentions(name) {
            let said = Formula::equal(Expr::Symbol(name.clone()), term);
            self.tell_meaning(vec![said], body);
        }
    }

    /// Tells in passing what a new name means.
    fn tell_meaning(&mut self, said: Vec<Formula>, body: Span) {
        let local = self.page.suppose_meant(said, body);
        let own = &mut self.page.locals[local];
        (own.lasts, own.level) = (false, self.level);
        self.told.push(local);
    }
}

/// What says that quantities are equal, `u_1 = \dots = u_n` or `a = b = c`, with a name for what all of them are.
fn with_value(said: &[Formula], name: &Symbol) -> Option<Vec<Formula>> {
    let value = || Expr::Symbol(name.clone());
    let named = |formula: &Formula| match formula {
        Formula::AllEqual {
            sequence,
            to,
            value: None,
        } => Some(Formula::AllEqual {
            sequence: sequence.clone(),
            to: to.clone(),
            value: Some(value()),
        }),
        Formula::Relation {
            left: left @ Expr::Symbol(_),
            relation: Relation::Equal,
            right: Expr::Symbol(_),
        } => Some(Formula::equal(value(), left.clone())),
        _ => None,
    };
    let all: Option<Vec<Formula>> = said.iter().map(named).collect();
    all.filter(|all| !all.is_empty())
}
