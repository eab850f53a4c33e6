//! What a page says of what changes with what: something of which it says so is not taken as constant, cited or not.

use crate::algebra::{Expr, Formula, Symbol};
use crate::derivation::{Derivation, Equation, formulas};

use super::Auditor;
use crate::search::are_tied;
use crate::sorted::Set;

/// So many equations before that speak of a variable are asked what moves with it.
const MOST_LAWS: usize = 64;

/// What some equations and suppositions say of what moves.
#[derive(Default)]
pub(super) struct Moving {
    differentiated: Set<Symbol>,
    /// What equations differentiate by, each with the position of the first that does.
    variables: Vec<(Symbol, usize)>,
    /// Symbols by themselves on a side of an equation, whether that is the left one, and all that it speaks of.
    explicit: Vec<(Symbol, bool, Set<Symbol>)>,
    constants: Set<Symbol>,
    /// All equations, each with the position of what states it and all that it speaks of.
    laws: Vec<(usize, Formula, Set<Symbol>)>,
}

impl Moving {
    fn of(derivation: &Derivation, page: usize) -> Moving {
        let mut found = Moving::default();
        let own_page = &derivation.pages[page];
        let constants = own_page.domains.iter().filter(|own| own.1.constant);
        found.constants = constants.map(|own| own.0.clone()).collect();
        found.differentiated = own_page.changing();
        let locals = &own_page.locals;
        // What is so at one moment says nothing of others.
        let at_moment = |own: &Equation| {
            let mut locals = own.locals.iter().copied().chain(own.moments.clone());
            locals.any(|at| derivation.pages[page].locals[at].is_momentary())
        };
        for at in derivation.equations_of(page) {
            let equation = &derivation.equations[at];
            if !at_moment(equation) {
                for formula in equation.statements().iter().flat_map(formulas) {
                    found.learn(&formula);
                    let mut variables = Set::new();
                    for term in formula.terms() {
                        term.collect_variables(&mut variables);
                    }
                    variables.retain(|new| found.variables.iter().all(|own| own.0 != *new));
                    let variables = variables.into_iter().map(|variable| (variable, at));
                    found.variables.extend(variables);
                    let names = formula.free_symbols();
                    found.laws.push((at, formula, names));
                }
            }
        }
        let locals = locals.iter().filter(|local| !local.is_momentary());
        for formula in locals.flat_map(|local| &local.formulas) {
            found.learn(formula);
        }
        found
    }

    fn learn(&mut self, formula: &Formula) {
        for term in formula.terms() {
            term.collect_differentiated(&mut self.differentiated);
        }
        let Some((left, right)) = formula.as_equation() else {
            return;
        };
        for (side, other, gives) in [(left, right, true), (right, left, false)] {
            // "At $t = \tau$" names a moment, and what something is at a place does not move with it.
            let at_place = |part: &Expr| matches!(part, Expr::Limit { .. });
            if let Expr::Symbol(symbol) = side
                && !matches!(other, Expr::Symbol(_) | Expr::Number(_))
                && !other.any(&at_place)
            {
                self.explicit.push((symbol.clone(), gives, formula.names()));
            }
        }
    }

    /// Whether a symbol is said to change with a variable; of a sequence, one of its elements.
    fn says(
        &self,
        (at, equation): (usize, &Equation),
        (name, is_sequence): (&Symbol, bool),
        variable: &Symbol,
    ) -> bool {
        let before = self.laws.partition_point(|own| own.0 < at);
        let speaking = self.laws[..before].iter().rev();
        let speaking = speaking.filter(|own| own.2.contains(variable));
        let mut laws: Vec<&Formula> = speaking.take(MOST_LAWS).map(|own| &own.1).collect();
        laws.reverse();
        let moves = |own: &Symbol| self.differentiated.contains(own);
        let constant =
            |own: &Symbol| self.constants.contains(own) || equation.is_told_constant(own);
        self.changes((name, is_sequence), variable, false)
            || are_tied(name, variable, &laws, moves, constant)
    }

    /// Whether it is differentiated, or stands by itself beside what changes: `given` by that, on the left, or anywhere.
    fn changes(
        &self,
        (name, is_sequence): (&Symbol, bool),
        variable: &Symbol,
        given: bool,
    ) -> bool {
        let is_meant = |own: &Symbol| {
            let stem = own.name().rsplit_once('_').map(|parts| parts.0);
            own == name || is_sequence && stem == Some(name.name())
        };
        let dotted = Symbol::new(format!("\\dot{{{name}}}"));
        let changes = |named: &Set<Symbol>| {
            let mut all = named.iter();
            all.any(|other| other == variable || self.differentiated.contains(other))
        };
        let mut explicit = self.explicit.iter();
        self.differentiated.iter().any(is_meant)
            || explicit.any(|(own, left, named)| {
                let stands = is_meant(own) && (*left || !given);
                *own == dotted || named.contains(&dotted) || stands && changes(named)
            })
    }
}

impl Auditor<'_> {
    fn moving(&self, page: usize) -> &Moving {
        let derivation = self.derivation;
        self.moving.get_or_init(|| Moving::of(derivation, page))
    }

    /// By what an equation and those before it on its page differentiate.
    pub(super) fn variables(&self, at: usize) -> Vec<Symbol> {
        let moving = self.moving(self.derivation.equations[at].page);
        let before = moving.variables.iter().filter(|own| own.1 <= at);
        before.map(|own| own.0.clone()).collect()
    }

    /// Whether the page differentiates a symbol, or gives it by what changes with a variable: not the `U` of `L \dot I + R I = U`.
    pub(super) fn changes(&self, at: usize, symbol: &Symbol, variable: &Symbol) -> bool {
        let moving = self.moving(self.derivation.equations[at].page);
        moving.changes((symbol, false), variable, true)
    }

    /// Whether the page says that something moves of which conditions say that it does not.
    pub(super) fn says_otherwise(&self, at: usize, conditions: &[Formula]) -> bool {
        let equation = &self.derivation.equations[at];
        let moving = self.moving(equation.page);
        conditions.iter().any(|condition| {
            let Some((Expr::Derivative { variable, .. }, _)) = condition.as_equation() else {
                return false;
            };
            let (names, sequences) = (condition.names(), condition.sequences());
            let mut held = names.iter().filter(|name| *name != variable);
            held.any(|name| {
                if equation.all_vary && !equation.is_told_constant(name) {
                    return true;
                }
                let name = (name, sequences.contains(name));
                moving.says((at, equation), name, variable)
            })
        })
    }
}
