//! Exact points on the premises, with small numbers, found by solving rather than by luck.
//!
//! Linear equations are solved for an unknown, equations in one unknown for their rational roots; what is
//! still free is tried in the order of simplicity, the total cost of all choices growing step by step, so
//! that the first point found is among the simplest. The same input always gives the same point.

use std::collections::BTreeMap;

use super::values::{candidates, rational_roots};
use crate::algebra::{Polynomial, Rational, Var};
use crate::kernel::{Fact, Sign};

/// What a point must satisfy.
pub struct Target {
    /// Equations and conditions alike.
    pub facts: Vec<Fact>,
    /// The unknowns that take integer values only.
    pub integers: Vec<Var>,
    /// How many choices may be tried.
    pub budget: usize,
}

struct Search<'a> {
    integers: &'a [Var],
    values: Vec<(u32, Rational)>,
    budget: usize,
    order: Vec<Var>,
    /// Whether a number was passed over because it costs too much.
    cut: bool,
}

#[derive(Clone)]
struct State {
    equations: Vec<Polynomial>,
    conditions: Vec<Fact>,
    solved: Vec<(Var, Polynomial)>,
}

/// The costs that are tried one after another.
const MOST_COST: u32 = 9;

impl Target {
    /// A point, the unknowns that occur nowhere left out; and how many choices were tried.
    pub fn find(&self) -> (Option<BTreeMap<Var, Rational>>, usize) {
        let mut vars: Vec<Var> = self
            .facts
            .iter()
            .flat_map(|f| f.polynomial.vars())
            .collect();
        vars.sort();
        vars.dedup();
        let zero = |f: &&Fact| f.sign == Sign::Zero;
        let state = State {
            equations: self
                .facts
                .iter()
                .filter(zero)
                .map(|f| f.polynomial.clone())
                .collect(),
            conditions: self
                .facts
                .iter()
                .filter(|f| f.sign != Sign::Zero)
                .cloned()
                .collect(),
            solved: Vec::new(),
        };
        let mut search = Search {
            integers: &self.integers,
            values: candidates(),
            budget: self.budget,
            order: vars,
            cut: false,
        };
        for cost in 0..=MOST_COST {
            search.cut = false;
            if let Some(point) = search.explore(state.clone(), cost) {
                return (Some(point), self.budget - search.budget);
            }
            if search.budget == 0 || !search.cut {
                break;
            }
        }
        (None, self.budget - search.budget)
    }
}

impl Search<'_> {
    fn explore(&mut self, mut state: State, cost: u32) -> Option<BTreeMap<Var, Rational>> {
        if self.budget == 0 {
            return None;
        }
        self.budget -= 1;
        // Solve what is linear in an unknown with a constant coefficient.
        loop {
            state.equations.retain(|e| !e.is_zero());
            if state.equations.iter().any(|e| e.as_constant().is_some()) || !state.is_possible() {
                return None;
            }
            let Some((at, var, value)) = self.linear(&state.equations) else {
                break;
            };
            state.equations.remove(at);
            state.put(var, value)?;
        }
        // Branch on the rational roots of an equation in one unknown.
        let single = state.equations.iter().find_map(|e| {
            let mut vars = e.vars().into_iter();
            let var = vars.next()?;
            vars.next().is_none().then(|| (e.clone(), var))
        });
        if let Some((equation, var)) = single {
            for root in rational_roots(&equation, var)? {
                if self.integers.contains(&var) && !root.is_integer() {
                    continue;
                }
                let mut next = state.clone();
                if next.put(var, Polynomial::constant(root)).is_some()
                    && let Some(point) = self.explore(next, cost)
                {
                    return Some(point);
                }
            }
            return None;
        }
        let Some((var, tied)) = self.next_var(&state) else {
            return self.finish(state);
        };
        let values = self.values.clone();
        for (own, value) in &values {
            // What no equation ties down costs nothing: the first number that is allowed will do.
            let own = if tied { *own } else { 0 };
            if own > cost {
                self.cut = true;
                break;
            }
            if self.integers.contains(&var) && !value.is_integer() {
                continue;
            }
            let mut next = state.clone();
            if next.put(var, Polynomial::constant(value.clone())).is_some()
                && let Some(point) = self.explore(next, cost - own)
            {
                return Some(point);
            }
        }
        None
    }

    /// An equation that is linear in an unknown with a constant coefficient, solved for it. Unknowns met
    /// late are solved for first: those of the goal stay free.
    fn linear(&self, equations: &[Polynomial]) -> Option<(usize, Var, Polynomial)> {
        let mut best: Option<(bool, Var, usize, Polynomial)> = None;
        for (at, equation) in equations.iter().enumerate() {
            for var in equation.vars() {
                if equation.degree_in(var) != 1 {
                    continue;
                }
                let parts = equation.in_powers_of(var);
                let Some(slope) = parts[1].as_constant() else {
                    continue;
                };
                let free = !self.integers.contains(&var);
                if best.as_ref().is_some_and(|b| (b.0, b.1) >= (free, var)) {
                    continue;
                }
                best = Some((free, var, at, parts[0].scaled(&-slope.recip())));
            }
        }
        best.map(|(_, var, at, value)| (at, var, value))
    }

    /// The next unknown to try numbers for, one of an equation before one of a condition; and whether it is
    /// one of an equation.
    fn next_var(&self, state: &State) -> Option<(Var, bool)> {
        let in_equations = |var: &&Var| state.equations.iter().any(|e| e.degree_in(**var) > 0);
        let in_conditions = |var: &&Var| {
            state
                .conditions
                .iter()
                .any(|f| f.polynomial.degree_in(**var) > 0)
        };
        let mut vars = self.order.iter();
        let tied = vars.clone().find(in_equations).map(|&var| (var, true));
        tied.or_else(|| vars.find(in_conditions).map(|&var| (var, false)))
    }

    fn finish(&self, state: State) -> Option<BTreeMap<Var, Rational>> {
        if !state.equations.is_empty() || !state.conditions.is_empty() {
            return None;
        }
        let mut point: BTreeMap<Var, Rational> = BTreeMap::new();
        // What was solved first may depend on what was solved later. Unknowns that are free still are 1.
        for (var, value) in state.solved.iter().rev() {
            let known = |v: Var| Some(point.get(&v).cloned().unwrap_or_else(Rational::one));
            let value = value.evaluate(known).ok()??;
            if self.integers.contains(var) && !value.is_integer() {
                return None;
            }
            for free in state.solved.iter().flat_map(|(_, p)| p.vars()) {
                let settled = state.solved.iter().any(|(v, _)| *v == free);
                if !settled {
                    point.entry(free).or_insert_with(Rational::one);
                }
            }
            point.insert(*var, value);
        }
        Some(point)
    }
}

impl State {
    /// Puts a value in the place of an unknown. `None` where that grows too large.
    fn put(&mut self, var: Var, value: Polynomial) -> Option<()> {
        for equation in &mut self.equations {
            if equation.degree_in(var) > 0 {
                *equation = equation.substitute(var, &value).ok()?;
            }
        }
        for condition in &mut self.conditions {
            if condition.polynomial.degree_in(var) > 0 {
                condition.polynomial = condition.polynomial.substitute(var, &value).ok()?;
            }
        }
        self.solved.push((var, value));
        Some(())
    }

    /// Drops conditions that are met; `false` where one is not.
    fn is_possible(&mut self) -> bool {
        let mut possible = true;
        self.conditions.retain(|fact| {
            let Some(value) = fact.polynomial.as_constant() else {
                return true;
            };
            possible &= match fact.sign {
                Sign::Zero => value.is_zero(),
                Sign::NonZero => !value.is_zero(),
                Sign::NonNegative => !value.is_negative(),
                Sign::Positive => value.is_positive(),
            };
            false
        });
        possible
    }
}
