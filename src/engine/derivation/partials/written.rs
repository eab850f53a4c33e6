//! In which symbols the formula for what is differentiated is written.

use crate::algebra::{Expr, Symbol};
use crate::sorted::Set;

use super::super::names::undotted;
use super::name_of;
use super::said::{Given, Said};

/// A formula leads through at most so many others to the variable.
const MOST_STEPS: usize = 8;

/// In which symbols a formula is written.
enum Written {
    /// In the variables and these.
    In(Set<Symbol>),
    /// Not in all of the variables.
    Elsewhere,
    /// Something besides the variables may depend on them, too.
    Unclear,
}

impl Said {
    /// What a name is given as, and in which symbols: in a formula that is written in all of these variables, or leads to them.
    ///
    /// Of several one is meant in whose symbols the equation is written.
    pub(super) fn formula(
        &mut self,
        name: &Symbol,
        variables: &[Symbol],
        others: &[&Expr],
    ) -> Option<(Expr, Set<Symbol>)> {
        let leading: Vec<Set<Symbol>> = variables.iter().map(|own| self.leading_to(own)).collect();
        let own = self.formulas.iter();
        let own: Vec<&Given> = own
            .filter(|given| name_of(&given.of) == Some(name))
            .collect();
        let found: Vec<Written> = own
            .iter()
            .map(|given| self.written_in(name, given, variables, &leading))
            .collect();
        let all = || {
            let both = own.iter().zip(&found);
            both.filter_map(|(given, found)| match found {
                Written::In(symbols) => Some((*given, symbols)),
                _ => None,
            })
        };
        let spoken: Set<Symbol> = others.iter().flat_map(|own| own.free_symbols()).collect();
        let covers = |symbols: &Set<Symbol>| spoken.iter().all(|own| symbols.contains(own));
        let meant = all()
            .find(|(_, symbols)| covers(symbols))
            .or_else(|| all().next());
        let is_clear = meant.is_some_and(|(first, meant)| {
            own.iter().zip(&found).all(|(given, found)| {
                let is_same = match found {
                    Written::In(symbols) => {
                        let same = self.is_the_same(symbols, meant);
                        symbols == meant || same || self.is_the_same(meant, symbols)
                    }
                    Written::Elsewhere => self.is_the_same(&given.symbols, meant),
                    Written::Unclear => false,
                };
                given.of == first.of && (is_same || given.chain == first.chain)
            })
        });
        let meant = meant.map(|(given, symbols)| {
            let sequences = given.sequences.iter().cloned();
            let all = symbols.iter().cloned().chain(sequences);
            (given.of.clone(), all.collect())
        });
        if !is_clear && !own.is_empty() {
            let slopes = variables.iter().map(|own| (name.clone(), own.clone()));
            self.unclear.extend(slopes);
        }
        meant
    }

    /// The symbols that a formula in these symbols is written in, once what depends on the variables is put in.
    fn written_in(
        &self,
        name: &Symbol,
        given: &Given,
        variables: &[Symbol],
        leading: &[Set<Symbol>],
    ) -> Written {
        // Of a coordinate whose velocity stands in it, a Lagrangian is written without it if it is cyclic.
        let is_written = |symbols: &Set<Symbol>, variable: &Symbol| {
            let is_velocity = |own: &Symbol| undotted(own).as_ref() == Some(variable);
            symbols.contains(variable) || symbols.iter().any(is_velocity)
        };
        let (mut symbols, mut summands) = (given.symbols.clone(), given.summands.clone());
        for _ in 0..MOST_STEPS {
            let mut further: Set<Symbol> = Set::new();
            for (variable, leading) in variables.iter().zip(leading) {
                let mut open = symbols
                    .iter()
                    .filter(|own| !variables.contains(own) && leading.contains(*own))
                    .peekable();
                if open.peek().is_some() && is_written(&symbols, variable) {
                    return Written::Unclear;
                }
                further.extend(open.cloned());
            }
            if further.is_empty() {
                let carried = |own: &&Symbol| !variables.contains(own);
                let mut carried = symbols.iter().filter(carried);
                return if carried.any(|own| own == name || self.dependent.contains(own)) {
                    Written::Unclear
                } else if variables.iter().all(|own| is_written(&symbols, own)) {
                    Written::In(self.put_in(symbols, summands, variables))
                } else {
                    Written::Elsewhere
                };
            }
            // `W = \frac12 k x^2` does not speak of the time, be `x` given in terms of it.
            if !further.iter().all(|own| summands.contains(own)) {
                return Written::Unclear;
            }
            for name in further {
                let of_it = |given: &&Given| name_of(&given.of) == Some(&name);
                let mut formulas = self.formulas.iter().filter(of_it);
                let first = formulas.next();
                let Some(first) = first.filter(|own| formulas.all(|o| o.symbols == own.symbols))
                else {
                    return Written::Unclear;
                };
                symbols.remove(&name);
                summands.remove(&name);
                summands.retain(|own| !first.symbols.contains(own));
                let new = first.summands.iter();
                summands.extend(new.filter(|own| !symbols.contains(*own)).cloned());
                symbols.extend(first.symbols.iter().cloned());
            }
        }
        Written::Unclear
    }

    /// With the summands put in that are written in what else the page differentiates by: `V` has to be so for `\frac{\partial L}{\partial x}`, and
    /// cannot be held fixed by itself beside that.
    fn put_in(
        &self,
        mut symbols: Set<Symbol>,
        summands: Set<Symbol>,
        variables: &[Symbol],
    ) -> Set<Symbol> {
        for name in summands {
            let of_it = |given: &&Given| name_of(&given.of) == Some(&name);
            let mut formulas = self.formulas.iter().filter(of_it);
            let Some(first) = formulas.next() else {
                continue;
            };
            let mut own = first.symbols.iter();
            if !variables.contains(&name)
                && !self.independent.contains(&name)
                && formulas.all(|other| other.symbols == first.symbols)
                && own.clone().any(|own| self.independent.contains(own))
                && !own.any(|own| self.dependent.contains(own))
            {
                symbols.remove(&name);
                symbols.extend(first.symbols.iter().cloned());
            }
        }
        symbols
    }

    /// Whether what is written in some symbols is the same function of others, once what it names is put in.
    fn is_the_same(&self, own: &Set<Symbol>, others: &Set<Symbol>) -> bool {
        let is_named = |own: &Symbol| {
            let mut formulas = self.formulas.iter();
            formulas.any(|other| {
                name_of(&other.of) == Some(own)
                    && other.symbols.iter().all(|symbol| others.contains(symbol))
            })
        };
        let mut all = own.iter();
        all.all(|own| others.contains(own) || is_named(own))
    }

    /// The symbols of what stands under a derivative, where an equation says in them what that comes to.
    pub(super) fn evaluated(
        &mut self,
        body: &Expr,
        variables: &[Symbol],
        others: &[&Expr],
    ) -> Option<Set<Symbol>> {
        let symbols = body.free_symbols();
        let is_in_these = |term: &&&Expr| {
            let own = term.free_symbols();
            !own.is_empty() && own.iter().all(|symbol| symbols.contains(symbol))
        };
        let written = others.iter().filter(|term| name_of(term).is_none());
        let says = written.clone().count() > 0 && written.clone().all(|term| is_in_these(&term));
        let explicit = variables.iter().all(|own| symbols.contains(own));
        let free = symbols.iter().all(|own| !self.dependent.contains(own));
        let leading: Vec<Set<Symbol>> = variables.iter().map(|own| self.leading_to(own)).collect();
        let depends =
            |own: &Symbol| self.moving.contains(own) || leading.iter().any(|all| all.contains(own));
        let mut carried = symbols.iter().filter(|own| !variables.contains(own));
        (says && explicit && free && !carried.any(depends)).then_some(symbols)
    }

    /// What else is held fixed where it is told that some of it is: the other letters of a formula for it that is written in just what is told
    /// and the variable, as far as nothing on the page speaks of them as changing. `p = \frac{n R T}{V}` has `n` and `R` besides `T` and `V`.
    pub(super) fn parameters(
        &mut self,
        name: &Symbol,
        variable: &Symbol,
        told: &[Symbol],
        constant: &impl Fn(&Symbol) -> bool,
    ) -> Option<Vec<Symbol>> {
        let mut variables = told.to_vec();
        variables.push(variable.clone());
        let is_written = |given: &&Given| {
            name_of(&given.of) == Some(name)
                && variables.iter().all(|own| given.symbols.contains(own))
        };
        let mut all = self.formulas.iter().filter(is_written);
        let symbols = all.next()?.symbols.clone();
        if !all.all(|own| own.symbols == symbols) {
            return None;
        }
        let others = symbols.iter();
        let others = others.filter(|own| !variables.contains(own) && !constant(own));
        let others: Vec<Symbol> = others.cloned().collect();
        let leading: Vec<Set<Symbol>> = variables.iter().map(|own| self.leading_to(own)).collect();
        let changes = |own: &Symbol| {
            self.independent.contains(own)
                || self.dependent.contains(own)
                || self.moving.contains(own)
                || leading.iter().any(|all| all.contains(own))
        };
        (!others.iter().any(changes)).then_some(others)
    }
}
