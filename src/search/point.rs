//! Exact points on the premises, with small numbers, found by solving rather than by luck.
//!
//! Linear equations are solved for an unknown, equations in one unknown for their rational roots; what is
//! still free is tried in the order of simplicity, the total cost of all choices growing step by step, so
//! that the first point found is among the simplest. The same input always gives the same point.

use std::collections::BTreeMap;
use std::rc::Rc;

use super::units::unit_choices;
use super::values::{candidates, rational_roots};
use crate::algebra::{Monomial, Polynomial, Rational, Var};
use crate::kernel::{Fact, Sign};

/// What a point must satisfy.
pub struct Target {
    start: State,
    /// The unknowns that take integer values only.
    integers: Vec<Var>,
    order: Vec<Var>,
    /// The unknowns that a choice of units lets be 1, −1 or 0.
    units: Vec<Var>,
}

/// What came of trying all choices up to a cost.
pub enum Tried {
    /// A point; the unknowns that occur nowhere are left out.
    Found(BTreeMap<Var, Rational>),
    /// There is none among these choices, but costlier ones are left.
    Costlier,
    /// There is no point with numbers that would be tried at all.
    Exhausted,
}

struct Search<'a> {
    integers: &'a [Var],
    values: Vec<(u32, Rational)>,
    budget: &'a mut usize,
    order: &'a [Var],
    units: &'a [Var],
    /// Whether a number was passed over because it costs too much.
    cut: bool,
}

#[derive(Clone)]
struct State {
    /// Shared between states: a choice changes few of them.
    equations: Vec<Rc<Polynomial>>,
    conditions: Vec<Rc<Fact>>,
    solved: Vec<(Var, Rc<Polynomial>)>,
}

impl Target {
    /// Equations and conditions that must hold; `integers` take integer values only.
    pub fn new(facts: &[Fact], integers: Vec<Var>) -> Self {
        let mut order: Vec<Var> = facts.iter().flat_map(|f| f.polynomial.vars()).collect();
        order.sort();
        order.dedup();
        // What cannot vanish makes the better unit.
        let nonzero = |var: &Var| {
            let alone = |f: &&Fact| {
                matches!(f.sign, Sign::NonZero | Sign::Positive)
                    && f.polynomial == Polynomial::var(*var)
            };
            !facts.iter().any(|f| alone(&f))
        };
        let mut preferred = order.clone();
        preferred.sort_by_key(nonzero);
        let all = facts.iter().map(|f| &f.polynomial);
        let units = unit_choices(all, &preferred, |var| integers.contains(&var));
        let (equations, conditions): (Vec<&Fact>, Vec<&Fact>) =
            facts.iter().partition(|f| f.sign == Sign::Zero);
        Target {
            start: State {
                equations: equations
                    .into_iter()
                    .map(|f| Rc::new(f.polynomial.clone()))
                    .collect(),
                conditions: conditions.into_iter().cloned().map(Rc::new).collect(),
                solved: Vec::new(),
            },
            integers,
            order,
            units,
        }
    }

    /// Tries all choices up to a total cost, or until the budget is spent.
    pub fn up_to(&self, cost: u32, budget: &mut usize) -> Tried {
        let mut search = Search {
            integers: &self.integers,
            values: candidates(),
            budget,
            order: &self.order,
            units: &self.units,
            cut: false,
        };
        match search.explore(self.start.clone(), cost) {
            Some(point) => Tried::Found(point),
            None if search.cut || *search.budget == 0 => Tried::Costlier,
            None => Tried::Exhausted,
        }
    }
}

impl Search<'_> {
    fn explore(&mut self, mut state: State, cost: u32) -> Option<BTreeMap<Var, Rational>> {
        if *self.budget == 0 {
            return None;
        }
        *self.budget -= 1;
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
        // What speaks of this unknown alone is asked before anything is put in.
        let (own_conditions, rest): (Vec<Rc<Fact>>, Vec<Rc<Fact>>) =
            std::mem::take(&mut state.conditions)
                .into_iter()
                .partition(|f| f.polynomial.vars().len() == 1 && f.polynomial.degree_in(var) > 0);
        state.conditions = rest;
        for at in 0..self.values.len() {
            let (own, value) = &self.values[at];
            // What no equation ties down costs nothing: the first number that is allowed will do.
            let own = if tied { *own } else { 0 };
            let value = value.clone();
            if own > cost {
                self.cut = true;
                break;
            }
            if self.integers.contains(&var) && !value.is_integer() {
                continue;
            }
            if self.units.contains(&var) && !value.is_zero() && !value.abs().is_one() {
                continue;
            }
            let met = |fact: &Rc<Fact>| {
                let value = fact.polynomial.evaluate(|_| Some(value.clone()));
                value.is_ok_and(|v| v.is_some_and(|v| satisfies(&v, fact.sign)))
            };
            if !own_conditions.iter().all(met) {
                continue;
            }
            let mut next = state.clone();
            if next.put(var, Polynomial::constant(value)).is_some()
                && let Some(point) = self.explore(next, cost - own)
            {
                return Some(point);
            }
        }
        None
    }

    /// An equation that is linear in an unknown with a constant coefficient, solved for it. Unknowns met
    /// late are solved for first: those of the goal stay free.
    fn linear(&self, equations: &[Rc<Polynomial>]) -> Option<(usize, Var, Polynomial)> {
        let mut best: Option<(bool, Var, usize)> = None;
        for (at, equation) in equations.iter().enumerate() {
            for (monomial, _) in equation.terms() {
                let [(var, 1)] = monomial.powers() else {
                    continue;
                };
                let free = !self.integers.contains(var);
                let elsewhere = equation
                    .terms()
                    .filter(|(m, _)| m.exponent(*var) > 0)
                    .count()
                    > 1;
                if elsewhere || best.is_some_and(|b| (b.0, b.1) >= (free, *var)) {
                    continue;
                }
                best = Some((free, *var, at));
            }
        }
        let (_, var, at) = best?;
        let own = Monomial::power(var, 1);
        let slope = equations[at].coefficient(&own)?.clone();
        let rest = equations[at].minus(&Polynomial::term(own, slope.clone()));
        Some((at, var, rest.scaled(&-slope.recip())))
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
                *equation = equation.substitute(var, &value).ok()?.into();
            }
        }
        for condition in &mut self.conditions {
            if condition.polynomial.degree_in(var) > 0 {
                *condition = Rc::new(Fact {
                    polynomial: condition.polynomial.substitute(var, &value).ok()?,
                    sign: condition.sign,
                });
            }
        }
        self.solved.push((var, value.into()));
        Some(())
    }

    /// Drops conditions that are met; `false` where one is not.
    fn is_possible(&mut self) -> bool {
        let mut possible = true;
        self.conditions.retain(|fact| {
            let Some(value) = fact.polynomial.as_constant() else {
                return true;
            };
            possible &= satisfies(&value, fact.sign);
            false
        });
        possible
    }
}

fn satisfies(value: &Rational, sign: Sign) -> bool {
    match sign {
        Sign::Zero => value.is_zero(),
        Sign::NonZero => !value.is_zero(),
        Sign::NonNegative => !value.is_negative(),
        Sign::Positive => value.is_positive(),
    }
}
