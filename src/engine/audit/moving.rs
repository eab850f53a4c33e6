//! What a page says of what changes with what: something of which it says so is not taken as constant, cited or not.

use std::cell::LazyCell;

use crate::algebra::{Expr, Formula, Symbol};
use crate::derivation::{Assumed, Derivation, Equation, Goal, Source, dotted, formulas};
use crate::kernel::{Standing, definition};
use crate::search::{self, Effort, are_tied};

use super::again::throughout::slope;
use super::judge::{Found, Judge, step};
use super::{Auditor, Outcome, stated};
use crate::sorted::{Map, Set};

/// Why a step is left open that follows only where something stands still.
const MOVES: &str =
    "it follows only where something stands still that what stands before lets change";
/// Words that announce what does not change.
const STAYING: [&str; 4] = ["constant", "conserved", "conservation", "uniform"];
/// So many equations before that speak of a variable are asked what moves with it.
const MOST_LAWS: usize = 64;

/// Whether a variable stands in an equation, and nowhere but in integrals over it.
fn runs_in_integrals(equation: &Equation, variable: &Symbol) -> bool {
    let is_over =
        |part: &Expr| matches!(part, Expr::Integral { variable: own, .. } if own == variable);
    let said = || equation.statements().iter().flat_map(formulas);
    let integrates = |own: Formula| own.terms().into_iter().any(|term| term.any(&is_over));
    said().any(integrates) && !said().any(|own| own.free_symbols().contains(variable))
}

fn collect_limits(term: &Expr, found: &mut Set<(Symbol, Symbol)>) {
    if let Expr::Integral {
        variable, from, to, ..
    } = term
    {
        let limits: Set<Symbol> = Formula::names_in([&**from, &**to].into_iter());
        let limits = limits.into_iter().filter(|own| own != variable);
        found.extend(limits.map(|limit| (variable.clone(), limit)));
    }
    term.children()
        .for_each(|child| collect_limits(child, found));
}

/// Adds what total derivatives in a term differentiate, with what by.
fn collect_total_slopes(term: &Expr, found: &mut Set<(Symbol, Symbol)>) {
    if let Expr::Derivative { body, variable } = term {
        let named = Formula::names_in([&**body].into_iter()).into_iter();
        found.extend(named.map(|own| (own, variable.clone())));
    }
    (term.children()).for_each(|child| collect_total_slopes(child, found));
}

/// Adds the symbols in a term of which a slope is written, with what by.
fn collect_written_slopes(term: &Expr, found: &mut Set<(Symbol, Symbol)>) {
    if let Expr::Derivative { body, variable } = term
        && let Expr::Symbol(of) = &**body
    {
        found.insert((of.clone(), variable.clone()));
    }
    (term.children()).for_each(|child| collect_written_slopes(child, found));
}

fn at_place(part: &Expr) -> bool {
    matches!(part, Expr::Limit { .. })
}

/// What some equations and suppositions say of what moves.
#[derive(Default)]
pub(super) struct Moving {
    differentiated: Set<Symbol>,
    /// The same with what by.
    slopes: Set<(Symbol, Symbol)>,
    /// What all relations of the page differentiate in total, with what by.
    total_slopes: Set<(Symbol, Symbol)>,
    /// The symbols of which its laws write a slope, with what by.
    written_slopes: Set<(Symbol, Symbol)>,
    /// What words say to change, with where they do first.
    told: Map<Symbol, usize>,
    /// What equations differentiate by, each with the position of the first that does.
    variables: Vec<(Symbol, usize)>,
    /// Symbols by themselves on a side of an equation, whether that is the left one, and all that it speaks of.
    explicit: Vec<(Symbol, bool, Set<Symbol>)>,
    constants: Set<Symbol>,
    /// What is integrated over, with the symbols in the limits.
    limits: Set<(Symbol, Symbol)>,
    /// All equations, each with the position of what states it and all that it speaks of.
    laws: Vec<(usize, Formula, Set<Symbol>)>,
}

impl Moving {
    fn of(derivation: &Derivation, page: usize) -> Moving {
        let mut found = Moving::default();
        let own_page = &derivation.pages[page];
        let constants = own_page.domains.iter().filter(|own| own.1.constant);
        found.constants = constants.map(|own| own.0.clone()).collect();
        found.told = own_page.changing_since();
        // "As $n$ grows" goes from one whole number to the next.
        let is_whole = |own: &Symbol| own_page.domains.get(own).is_some_and(|own| own.integer);
        found.told.retain(|own, _| !is_whole(own));
        let locals = &own_page.locals;
        // What is so at one moment says nothing of others.
        let at_moment = |own: &Equation| {
            let mut locals = own.locals.iter().copied().chain(own.moments.clone());
            locals.any(|at| derivation.pages[page].locals[at].is_momentary())
        };
        for at in derivation.equations_of(page) {
            let equation = &derivation.equations[at];
            for (left, _, right) in equation.relations() {
                for term in [&left, &right] {
                    collect_total_slopes(term, &mut found.total_slopes);
                }
            }
            if !at_moment(equation) {
                // What is so where a slope vanishes ties nothing to what moves either.
                let said = equation.statements().iter().flat_map(formulas);
                for formula in said.filter(|own| !equation.puts_to_nought(own)) {
                    found.learn(&formula);
                    let mut variables = Set::new();
                    for term in formula.terms() {
                        term.collect_variables(&mut variables);
                    }
                    variables.retain(|new| found.variables.iter().all(|own| own.0 != *new));
                    let variables = variables.into_iter().map(|variable| (variable, at));
                    found.variables.extend(variables);
                    let names = formula.free_symbols();
                    // What something is at a place, `y(L)`, ties nothing to what moves.
                    if !formula.terms().into_iter().any(|term| term.any(&at_place)) {
                        for term in formula.terms() {
                            collect_written_slopes(term, &mut found.written_slopes);
                        }
                        found.laws.push((at, formula, names));
                    }
                }
            }
        }
        let locals = locals.iter().filter(|local| !local.is_momentary());
        for formula in locals.flat_map(|local| &local.formulas) {
            found.learn(formula);
        }
        found
    }

    /// Whether a symbol is differentiated, or told to change.
    fn moves(&self, symbol: &Symbol) -> bool {
        self.differentiated.contains(symbol) || self.told.contains_key(symbol)
    }

    /// Whether nothing but words says that a symbol changes.
    fn is_told_alone(&self, symbol: &Symbol) -> bool {
        self.told.contains_key(symbol) && !self.differentiated.contains(symbol)
    }

    /// Whether a symbol is a limit of an integral over a variable, and differentiated nowhere.
    fn is_limit(&self, symbol: &Symbol, variable: &Symbol) -> bool {
        let mut limits = self.limits.iter();
        limits.any(|(own, limit)| own == variable && limit == symbol)
            && !self.differentiated.contains(symbol)
    }

    fn learn(&mut self, formula: &Formula) {
        for term in formula.terms() {
            term.collect_differentiated(&mut self.differentiated);
            collect_limits(term, &mut self.limits);
            term.collect_slopes(&mut self.slopes);
        }
        let Some((left, right)) = formula.as_equation() else {
            return;
        };
        for (side, other, gives) in [(left, right, true), (right, left, false)] {
            // "At $t = \tau$" names a moment, and what something is at a place does not move with it.
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
        let moves = |own: &Symbol| self.moves(own);
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
        let velocity = dotted(name, false);
        // The level `h(t)` of a tank has nothing to do with the distance `r` from the axis of its drain.
        let may_be_tied = LazyCell::new(|| {
            self.moves(variable) || self.explicit.iter().any(|own| own.0 == *variable)
        });
        let moves_with = |other: &Symbol| {
            let is_slope = || self.slopes.contains(&(other.clone(), variable.clone()));
            self.told.contains_key(other)
                || self.differentiated.contains(other) && (*may_be_tied || is_slope())
        };
        let changes = |named: &Set<Symbol>| {
            let mut all = named.iter();
            all.any(|other| other == variable || moves_with(other))
        };
        let mut explicit = self.explicit.iter();
        let mut moving = self.differentiated.iter().chain(self.told.keys());
        moving.any(is_meant)
            || explicit.any(|(own, left, named)| {
                let stands = is_meant(own) && (*left || !given);
                *own == velocity || named.contains(&velocity) || stands && changes(named)
            })
    }
}

impl Judge<'_> {
    /// What was refuted, if it follows where something does not change that is made of several things that do, is differentiated nowhere, and is
    /// announced as constant: the logarithmic derivative of "a constant rate $$Q = 4 \pi r^2 \rho v$$".
    pub(super) fn stays_the_same(&self, goal: &Goal, found: &Found) -> Option<Found> {
        let page = self.derivation.equations[self.at].page;
        let page = &self.derivation.pages[page];
        let mut variables = Set::new();
        let mut differentiated = Set::new();
        for term in goal.formula.terms() {
            term.collect_variables(&mut variables);
            term.collect_differentiated(&mut differentiated);
        }
        let mut variables = variables.into_iter();
        let variable = variables.next().filter(|_| variables.next().is_none())?;
        let named = goal.formula.names();
        let moves = |own: &Symbol| *own == variable || differentiated.contains(own);
        let made_of_several = |own: &Assumed| {
            let (Expr::Symbol(of), term) = own.formula.as_equation()? else {
                return None;
            };
            let Source::Equation(at) = own.source else {
                return None;
            };
            if !self.is_led_to_by(at, &STAYING) {
                return None;
            }
            let names = term.free_symbols();
            let is_one =
                !page.changing().contains(of) && !named.contains(of) && !names.contains(of);
            let parts: Vec<Symbol> = names.into_iter().filter(moves).collect();
            (is_one && parts.len() > 1).then(|| (of.clone(), parts))
        };
        let mut premises = found.judged.assumed.iter();
        let (of, parts) = premises.find_map(made_of_several)?;
        let rate = Expr::Symbol(of).differentiated_by(&variable);
        let still = Formula::equal(rate, Expr::integer(0));
        let assumed = found.judged.assumed.clone();
        let bare = self.pose(&assumed, &goal.formula).ok()?;
        let mut conditions = search::still_in(&bare);
        conditions.retain(|own| {
            !self
                .auditor
                .says_otherwise(self.at, std::slice::from_ref(own))
        });
        conditions.push(still);
        let mut own = Found::open(found.judged.clone());
        let under = |conditions: &[Formula], own: &mut Found| {
            self.holds_under(goal, assumed.clone(), conditions, Effort::Full, own)
        };
        if under(&conditions, &mut own) {
            return Some(own);
        }
        // What it is made of is divided by.
        let moving = parts
            .into_iter()
            .map(|own| Formula::nonzero(Expr::Symbol(own)));
        conditions.extend(moving);
        under(&conditions, &mut own).then_some(own)
    }

    /// What to say of a step that follows only where something stands still of which the page says how it moves. The counterexample obeys
    /// what the page says of that, and at it all else stands still. Where there is none, and that cannot stand
    /// still beside what the page says, the step is left open.
    pub(super) fn moves_after_all(
        &self,
        goal: &Goal,
        premises: &[usize],
        found: &Found,
    ) -> Option<Found> {
        let still: Vec<Formula> = (found.conditions.iter())
            .filter(|own| stated::stands_still(own))
            .cloned()
            .collect();
        if still.is_empty() || !self.auditor.says_otherwise(self.at, &still) {
            return None;
        }
        let mut variables = still.iter().filter_map(|own| match own.as_equation()? {
            (Expr::Derivative { variable, .. }, _) => Some(variable),
            _ => None,
        });
        let variable = variables.next()?;
        let moves = |symbol: &Symbol| {
            let mut rates = still.iter().filter_map(Formula::as_equation);
            rates.any(|(rate, _)| rate.mentions(symbol) && symbol != variable)
        };
        let gives = |own: &Assumed| definition(&own.formula).is_some_and(|own| moves(&own.0));
        let sound = self.sound(&self.usable.assumed, &self.failing(premises));
        let all = self.with_others(&sound, premises).unwrap_or(sound);
        let all = self.without_repeated(all, &gives);
        let mut with = Vec::new();
        for own in &all {
            // What is put in is not seen to move: what gives it is said of one point, with its slope.
            if own.standing == Standing::Identity && gives(own) {
                with.push(step(&own.formula));
                with.extend(slope(&own.formula, variable).as_ref().map(step));
            } else {
                with.push(own.clone());
            }
        }
        let bare = self.pose(&all, &goal.formula);
        let mut others = bare.map_or_else(|_| Vec::new(), |bare| search::still_in(&bare));
        others.retain(|own| {
            let own = std::slice::from_ref(own);
            !self.auditor.says_otherwise(self.at, own)
        });
        with.extend(others.iter().map(step));
        let is_cited = |own: &&Assumed| all.contains(own) && !still.contains(&own.formula);
        let mut cited: Vec<Assumed> = (found.judged.assumed.iter())
            .filter(is_cited)
            .cloned()
            .collect();
        cited.extend(all.iter().filter(|own| gives(own)).map(|own| Assumed {
            standing: Standing::AtPoint,
            ..own.clone()
        }));
        let mut own = Found::open(found.judged.clone());
        let larger = self.derivation.claim(self.at, &with, &goal.formula);
        let Some(refuted) = self.refuted_in_context(goal, &cited, larger) else {
            let all = self.derivation.claim(self.at, &all, &goal.formula);
            own.leave_open(MOVES);
            return (!search::is_possible(&all, &still)).then_some(own);
        };
        own.judged.assumed = cited;
        own.judged.outcome = Outcome::Refuted(refuted.into());
        self.instead(goal, &all, premises, &mut own);
        Some(own)
    }

    /// What a slope takes as constant, where the nearest premise that says by a term what is differentiated does not speak of it: the slope of
    /// that term is meant, and nobody can have meant it to be held.
    pub(super) fn held_though_gone(&self, goal: &Goal, found: &Found) -> Option<Symbol> {
        let (Expr::Derivative { body, variable }, slope) = goal.formula.as_equation()? else {
            return None;
        };
        let of_slope = stated::quantities(slope);
        let gives = |own: &Assumed| match (own.source, own.formula.as_equation()?) {
            (Source::Equation(at), (left, value))
                if *left == **body && value.mentions(variable) =>
            {
                Some((at, value.free_symbols()))
            }
            _ => None,
        };
        let given = self.usable.assumed.iter().filter_map(gives);
        let (_, named) = given.max_by_key(|(at, _)| *at)?;
        if !of_slope.is_subset(&named) {
            return None;
        }
        let still = found.conditions.iter();
        let still = still.filter_map(|own| match own.as_equation()? {
            (Expr::Derivative { body, .. }, Expr::Number(_))
                if let Expr::Symbol(held) = &**body =>
            {
                Some(held)
            }
            _ => None,
        });
        let mut held = found.constant.iter().chain(still);
        held.find(|held| !named.contains(*held)).cloned()
    }

    /// Premises without those that others say already, but for what `gives` something.
    fn without_repeated(
        &self,
        mut all: Vec<Assumed>,
        gives: &impl Fn(&Assumed) -> bool,
    ) -> Vec<Assumed> {
        let mut at = 0;
        while at < all.len() {
            let own = all.remove(at);
            let is_repeated = || {
                let claim = self.derivation.claim(self.at, &all, &own.formula);
                search::prove_unconditionally(claim, Effort::Light).is_some()
            };
            if gives(&own) || definition(&own.formula).is_some() || !is_repeated() {
                all.insert(at, own);
                at += 1;
            }
        }
        all
    }
}

impl Auditor<'_> {
    fn moving(&self, page: usize) -> &Moving {
        let of_page = || Moving::of(self.derivation, page);
        self.shared.moving[page].get_or_init(of_page)
    }

    /// What the relations of a page differentiate in total, each with what by.
    pub(super) fn slopes_of(&self, page: usize) -> &Set<(Symbol, Symbol)> {
        &self.moving(page).total_slopes
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

    /// Whether nothing but words of the page says that a symbol changes, and all of them behind an equation.
    pub(super) fn is_told_to_change_later(&self, at: usize, symbol: &Symbol) -> bool {
        let equation = &self.derivation.equations[at];
        let moving = self.moving(equation.page);
        let first = moving.told.get(symbol);
        moving.is_told_alone(symbol) && first.is_some_and(|&place| place > equation.span.start)
    }

    /// Whether the page writes how fast a symbol changes with a variable.
    pub(super) fn writes_slope(&self, at: usize, symbol: &Symbol, variable: &Symbol) -> bool {
        let moving = self.moving(self.derivation.equations[at].page);
        let slope = (symbol.clone(), variable.clone());
        moving.written_slopes.contains(&slope)
    }

    /// Whether the page says that something moves of which conditions say that it does not.
    pub(super) fn says_otherwise(&self, at: usize, conditions: &[Formula]) -> bool {
        let equation = &self.derivation.equations[at];
        let moving = self.moving(equation.page);
        // Where the factors are written in the variable itself, nothing else need change: `R/(r + R)^2` by the quotient rule.
        let writes_out = |variable: &Symbol| {
            let is_variable = |part: &Expr| matches!(part, Expr::Symbol(own) if own == variable);
            let mut stated = equation.statements().iter().flat_map(formulas);
            stated.any(|own| own.terms().into_iter().any(|term| term.any(&is_variable)))
        };
        conditions.iter().any(|condition| {
            let Some((Expr::Derivative { variable, .. }, _)) = condition.as_equation() else {
                return false;
            };
            // `\int_0^L f \, dx`: the limits do not move with what runs between them.
            let is_limit = |own: &Symbol| moving.is_limit(own, variable);
            let is_dummy = || runs_in_integrals(equation, variable);
            let (names, sequences) = (condition.names(), condition.sequences());
            let held = names.iter().filter(|name| *name != variable);
            held.filter(|name| !is_limit(name)).any(|name| {
                let all_vary = equation.all_vary && !writes_out(variable);
                if all_vary && !equation.is_told_constant(name) {
                    return true;
                }
                // That it grows from case to case says nothing of what runs within one.
                if moving.is_told_alone(name) && is_dummy() {
                    return false;
                }
                let name = (name, sequences.contains(name));
                moving.says((at, equation), name, variable)
            })
        })
    }
}
