//! Exact points on the premises, with small numbers, found by solving rather than by luck.
//!
//! Linear equations are solved for an unknown, equations in one unknown for their rational roots; what is
//! still free is tried in the order of simplicity, the total cost of all choices growing step by step, so
//! that the first point found is among the simplest. The same input always gives the same point.

use std::rc::Rc;

use super::functions::simplest_between;
use super::units::unit_choices;
use super::values::{candidates, rational_roots};
use crate::algebra::{Monomial, Polynomial, Rational, Var};
use crate::kernel::{Fact, Sign};
use crate::sorted::{self, Map, Set};

/// What a point must satisfy.
pub struct Target {
    start: Node,
    /// The unknowns that take integer values only.
    integers: Vec<Var>,
    order: Vec<Var>,
    /// The unknowns that a choice of units lets be 1, −1 or 0.
    units: Vec<Var>,
    wanted: Wanted,
}

/// Which of all points is looked for.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Wanted {
    /// One of the simplest, for a reader.
    Simple,
    /// Whichever is found soonest.
    Any,
    /// One at which every symbol has a value, and exponentials are powers of `e`.
    Exponentials,
    /// One at which several exponentials of one symbol are powers of one of them.
    Powers,
}

/// What came of trying all choices up to a cost.
pub enum Tried {
    /// A point; the unknowns that occur nowhere are left out.
    Found(Map<Var, Rational>),
    /// There is none among these choices, but costlier ones are left.
    Costlier,
    /// There is no point with numbers that would be tried at all.
    Exhausted,
}

struct Search<'a> {
    integers: &'a [Var],
    values: &'a [(u32, Rational)],
    budget: &'a mut usize,
    order: &'a [Var],
    units: &'a [Var],
    wanted: Wanted,
    /// Whether a number was passed over because it costs too much.
    cut: bool,
}

/// What is left to satisfy. No equation or condition in it is constant.
#[derive(Clone, Default)]
struct State {
    /// Shared between states: a choice changes few of them.
    equations: Vec<Rc<Open>>,
    conditions: Vec<Rc<Open>>,
    solved: Option<Rc<Solved>>,
}

/// What an unknown is, with what was solved before; that is shared, too.
struct Solved {
    var: Var,
    value: Polynomial,
    before: Option<Rc<Solved>>,
}

/// A state with the choices made from it. It is kept, for every choice up to a cost is made again at the next one.
enum Node {
    /// Nothing was chosen yet.
    New(State),
    /// One of the rational roots of an equation.
    Roots(Vec<Node>),
    /// One of the numbers for an unknown.
    Numbers(Box<Numbers>),
    /// No choice leads to a point, whatever it costs; to see that takes so many.
    Dead(usize),
}

/// The numbers for an unknown.
struct Numbers {
    state: State,
    var: Var,
    /// Whether an equation ties the unknown down.
    tied: bool,
    /// What speaks of this unknown alone.
    conditions: Vec<Rc<Open>>,
    /// How many numbers were looked at.
    tried: usize,
    /// Whether one of them met the conditions.
    met: bool,
    /// Those that were possible, with what they cost.
    choices: Vec<(u32, Node)>,
}

type Solution = Map<Var, Rational>;

/// A fact that is not yet decided.
struct Open {
    polynomial: Polynomial,
    sign: Sign,
    vars: Unknowns,
    /// The unknown to solve for, where the fact is an equation that is linear in one with a constant
    /// coefficient: one that may be any number before an integer, then the one met last.
    solvable: Option<(bool, Var)>,
}

/// A set of unknowns at a glance; the last bit stands for all that have none of their own.
#[derive(Clone, Copy, Default)]
struct Mask(u128);

impl Mask {
    const LAST: u32 = u128::BITS - 1;

    fn of(var: Var) -> Mask {
        let bit = u32::try_from(var.position()).map_or(Mask::LAST, |at| at.min(Mask::LAST));
        Mask(1 << bit)
    }

    /// Whether others share its bit.
    fn is_shared(self) -> bool {
        self.0 == 1 << Mask::LAST
    }

    /// Whether an unknown may be in the set; certain but for the last bit.
    fn may_have(self, var: Var) -> bool {
        self.0 & Mask::of(var).0 != 0
    }
}

/// The unknowns of a polynomial.
struct Unknowns {
    /// The first in order.
    first: Option<Var>,
    met: Mask,
    /// Those in more than one term.
    again: Mask,
    /// Those that have no bit of their own, in order, each as often as there are terms with it.
    far: Vec<Var>,
}

impl Unknowns {
    fn of(polynomial: &Polynomial) -> Unknowns {
        let (mut met, mut again) = (Mask::default(), Mask::default());
        let (mut first, mut far) = (None, Vec::new());
        for (monomial, _) in polynomial.terms() {
            for &(var, _) in monomial.powers() {
                if first.is_none_or(|first| var < first) {
                    first = Some(var);
                }
                let own = Mask::of(var);
                again.0 |= met.0 & own.0;
                met.0 |= own.0;
                if own.is_shared() {
                    far.push(var);
                }
            }
        }
        far.sort_unstable();
        Unknowns {
            first,
            met,
            again,
            far,
        }
    }

    fn has(&self, var: Var) -> bool {
        self.met.may_have(var)
            && (!Mask::of(var).is_shared() || self.far.binary_search(&var).is_ok())
    }

    /// Whether one of these is in a single term.
    fn is_once(&self, var: Var) -> bool {
        match Mask::of(var).is_shared() {
            true => {
                let first = self.far.partition_point(|own| *own < var);
                self.far.get(first + 1) != Some(&var)
            }
            false => !self.again.may_have(var),
        }
    }

    /// Whether there is one at most.
    fn is_single(&self) -> bool {
        self.met.0.count_ones() <= 1 && self.far.first() == self.far.last()
    }
}

impl Open {
    /// `Err` with whether the fact is true, where no unknown is left in it.
    fn new(polynomial: Polynomial, sign: Sign, integers: &[Var]) -> Result<Open, bool> {
        if let Some(value) = polynomial.as_constant() {
            return Err(satisfies(&value, sign));
        }
        let vars = Unknowns::of(&polynomial);
        let solvable = match sign {
            Sign::Zero => solvable(&polynomial, &vars, integers),
            _ => None,
        };
        Ok(Open {
            polynomial,
            sign,
            vars,
            solvable,
        })
    }

    fn has(&self, var: Var) -> bool {
        self.vars.has(var)
    }

    /// The only unknown, where there is just one.
    fn single(&self) -> Option<Var> {
        self.vars.first.filter(|_| self.vars.is_single())
    }
}

/// Unknowns met late are solved for first: those of the goal stay free.
fn solvable(equation: &Polynomial, vars: &Unknowns, integers: &[Var]) -> Option<(bool, Var)> {
    let mut best = None;
    for (monomial, _) in equation.terms() {
        let [(var, 1)] = monomial.powers() else {
            continue;
        };
        let own = Some((!integers.contains(var), *var));
        if own > best && vars.is_once(*var) {
            best = own;
        }
    }
    best
}

impl Target {
    /// Equations and conditions that must hold; `integers` take integer values only.
    pub fn new(facts: Vec<Fact>, integers: Vec<Var>, wanted: Wanted) -> Self {
        let order = order(&facts);
        // What cannot vanish makes the better unit.
        let certain = facts
            .iter()
            .filter(|f| matches!(f.sign, Sign::NonZero | Sign::Positive));
        let nonzero: Set<Var> = certain.filter_map(|f| f.polynomial.as_var()).collect();
        let mut preferred = order.clone();
        sorted::sort_by_key(&mut preferred, |var| !nonzero.contains(var));
        let all = facts.iter().map(|f| &f.polynomial);
        let units = unit_choices(all, &preferred, |var| integers.contains(&var));
        Target {
            start: start(facts, &integers).map_or(Node::Dead(0), Node::New),
            integers,
            order,
            units,
            wanted,
        }
    }

    /// The same where some unknowns have a value already. `None` where that cannot be, or is too large to
    /// compute with.
    pub fn near(
        facts: Vec<Fact>,
        integers: Vec<Var>,
        known: impl Iterator<Item = (Var, Rational)>,
    ) -> Option<Self> {
        let mut state = start(facts, &integers)?;
        for (var, value) in known {
            state = state.with(var, Polynomial::constant(value), &integers)?;
        }
        Some(Target {
            start: Node::New(state),
            integers,
            // Of the simplest points none is asked for.
            order: Vec::new(),
            units: Vec::new(),
            wanted: Wanted::Simple,
        })
    }

    /// Tries all choices up to a total cost, or until the budget is spent. What was tried before is tried, and
    /// counted, again.
    pub fn up_to(&mut self, cost: u32, budget: &mut usize) -> Tried {
        let mut search = Search {
            integers: &self.integers,
            values: candidates(),
            budget,
            order: &self.order,
            units: &self.units,
            wanted: self.wanted,
            cut: false,
        };
        match search.explore(&mut self.start, cost) {
            Some(point) => Tried::Found(point),
            None if search.cut || *search.budget == 0 => Tried::Costlier,
            None => Tried::Exhausted,
        }
    }
}

/// The unknowns of facts, in order.
fn order(facts: &[Fact]) -> Vec<Var> {
    let mut order: Vec<Var> = facts.iter().flat_map(|f| f.polynomial.vars()).collect();
    sorted::sort(&mut order);
    order.dedup();
    order
}

/// What facts require; `None` where one of them is false.
fn start(facts: Vec<Fact>, integers: &[Var]) -> Option<State> {
    let mut state = State::default();
    let mut facts = facts.into_iter();
    let possible = facts.all(|f| state.require(Open::new(f.polynomial, f.sign, integers)));
    possible.then_some(state)
}

impl Search<'_> {
    fn explore(&mut self, node: &mut Node, cost: u32) -> Option<Solution> {
        if let Node::Dead(choices) = node {
            *self.budget = self.budget.saturating_sub(*choices);
            return None;
        }
        *self.budget = self.budget.checked_sub(1)?;
        if let Node::New(state) = node {
            *node = match self.opened(std::mem::take(state)) {
                Ok(node) => node,
                Err(point) => return Some(point),
            };
        }
        let dead = match node {
            Node::Roots(roots) => {
                for root in roots.iter_mut() {
                    if let Some(point) = self.explore(root, cost) {
                        return Some(point);
                    }
                }
                dead(roots.iter())
            }
            Node::Numbers(numbers) => {
                if let Some(point) = self.numbers(numbers, cost) {
                    return Some(point);
                }
                let all = numbers.tried >= self.values.len();
                dead(numbers.choices.iter().map(|choice| &choice.1)).filter(|_| all)
            }
            Node::New(_) | Node::Dead(_) => None,
        };
        if let Some(choices) = dead {
            *node = Node::Dead(choices);
        }
        None
    }

    /// What there is to choose from in a state; `Err` with the point where nothing is left to choose.
    fn opened(&self, mut state: State) -> Result<Node, Solution> {
        loop {
            // Solve what is linear in an unknown with a constant coefficient.
            if let Some((at, var, value)) = linear(&state.equations) {
                state.equations.remove(at);
                match state.with(var, value, self.integers) {
                    Some(next) => state = next,
                    None => return Ok(Node::Dead(1)),
                }
                continue;
            }
            match state.without_factor(self.integers) {
                Some(Some(divided)) => state = divided,
                Some(None) => return Ok(Node::Dead(1)),
                None => break,
            }
        }
        // Branch on the rational roots of an equation in one unknown.
        let single = state
            .equations
            .iter()
            .find_map(|e| Some((e.clone(), e.single()?)));
        if let Some((equation, var)) = single {
            let mut roots = rational_roots(&equation.polynomial, var).unwrap_or_default();
            roots.retain(|root| root.is_integer() || !self.integers.contains(&var));
            let next = |root| state.with(var, Polynomial::constant(root), self.integers);
            let states = roots.into_iter().filter_map(next);
            return Ok(Node::Roots(states.map(Node::New).collect()));
        }
        let Some((var, tied)) = self.next_var(&state) else {
            return self.finish(state).map_or(Ok(Node::Dead(1)), Err);
        };
        // What speaks of this unknown alone is asked before anything is put in.
        let alone = |f: &mut Rc<Open>| f.has(var) && f.single() == Some(var);
        let conditions = state.conditions.extract_if(.., alone).collect();
        Ok(Node::Numbers(Box::new(Numbers {
            state,
            var,
            tied,
            conditions,
            tried: 0,
            met: false,
            choices: Vec::new(),
        })))
    }

    fn numbers(&mut self, numbers: &mut Numbers, cost: u32) -> Option<Solution> {
        for (own, choice) in &mut numbers.choices {
            let Some(left) = cost.checked_sub(*own) else {
                self.cut = true;
                return None;
            };
            if let Some(point) = self.explore(choice, left) {
                return Some(point);
            }
        }
        let var = numbers.var;
        let (is_whole, is_unit) = (self.integers.contains(&var), self.units.contains(&var));
        while let Some((own, value)) = self.values.get(numbers.tried) {
            if *self.budget == 0 {
                return None;
            }
            // What no equation ties down costs nothing: the first number that is allowed will do.
            let own = if numbers.tied { *own } else { 0 };
            let Some(left) = cost.checked_sub(own) else {
                self.cut = true;
                return None;
            };
            numbers.tried += 1;
            if is_whole && !value.is_integer() {
                continue;
            }
            if is_unit && !value.is_zero() && !value.abs().is_one() {
                continue;
            }
            let met = |fact: &Rc<Open>| {
                let value = fact.polynomial.evaluate(|_| Some(value.clone()));
                value.is_ok_and(|v| v.is_some_and(|v| satisfies(&v, fact.sign)))
            };
            if !numbers.conditions.iter().all(met) {
                continue;
            }
            numbers.met = true;
            let value = Polynomial::constant(value.clone());
            if let Some(next) = numbers.state.with(var, value, self.integers) {
                let mut choice = Node::New(next);
                let found = self.explore(&mut choice, left);
                if found.is_some() {
                    return found;
                }
                numbers.choices.push((own, choice));
            }
        }
        // Where none of the usual numbers is allowed, the simplest that is.
        if numbers.tried == self.values.len() && *self.budget > 0 {
            numbers.tried += 1;
            let value = match numbers.met || is_whole {
                true => None,
                false => simplest_allowed(&numbers.conditions, var),
            };
            let next = value.and_then(|value| {
                let value = Polynomial::constant(value);
                numbers.state.with(var, value, self.integers)
            });
            if let Some(next) = next {
                let mut choice = Node::New(next);
                let found = self.explore(&mut choice, cost);
                if found.is_some() {
                    return found;
                }
                numbers.choices.push((0, choice));
            }
        }
        None
    }

    /// The next unknown to try numbers for, and whether an equation ties it down: one of the equation with the fewest unknowns,
    /// for what is wrong with a choice is then soonest seen; without equations, one of a condition.
    fn next_var(&self, state: &State) -> Option<(Var, bool)> {
        let unknowns = |equation: &&Rc<Open>| equation.vars.met.0.count_ones();
        let urgent = match self.wanted {
            Wanted::Any | Wanted::Exponentials | Wanted::Powers => self.urgent(state),
            Wanted::Simple => None,
        };
        if let Some(var) = urgent {
            return Some((var, true));
        }
        if let Some(narrowest) = state.equations.iter().min_by_key(unknowns) {
            return narrowest.vars.first.map(|var| (var, true));
        }
        let free = state.conditions.iter().filter_map(|own| own.vars.first);
        free.min().map(|var| (var, false))
    }

    /// An unknown that cannot wait.
    ///
    /// An equation that alone speaks of an unknown, and is linear in it, can be solved whatever the others are: it can wait, and so can
    /// that unknown. Nothing where all that is left are such unknowns.
    fn urgent(&self, state: &State) -> Option<Var> {
        let waits = |var: Var, own: &Rc<Open>| {
            let mut all = state.equations.iter();
            !self.integers.contains(&var)
                && own.polynomial.degree_in(var) == 1
                && all.all(|other| Rc::ptr_eq(own, other) || !other.has(var))
        };
        let own = |open: &Rc<Open>| {
            let vars = self.order.iter().copied().filter(|&var| open.has(var));
            let (waiting, asked): (Vec<Var>, Vec<Var>) = vars.partition(|&var| waits(var, open));
            (!waiting.is_empty(), asked.first().copied())
        };
        let all = state.equations.iter();
        let narrowest = all
            .map(|equation| (own(equation), equation.vars.met.0.count_ones()))
            .min_by_key(|((waits, _), unknowns)| (*waits, *unknowns));
        narrowest.and_then(|((_, asked), _)| asked)
    }

    fn finish(&self, state: State) -> Option<Map<Var, Rational>> {
        if !state.equations.is_empty() || !state.conditions.is_empty() {
            return None;
        }
        let mut point: Map<Var, Rational> = Map::new();
        // What was solved last comes first.
        let solved = || std::iter::successors(state.solved.as_deref(), |own| own.before.as_deref());
        // Unknowns that are free still are 1.
        let settled: Set<Var> = solved().map(|own| own.var).collect();
        for free in solved().flat_map(|own| own.value.vars()) {
            if !settled.contains(&free) {
                point.insert(free, Rational::one());
            }
        }
        // What was solved first may depend on what was solved later.
        for Solved { var, value, .. } in solved() {
            let known = |v: Var| Some(point.get(&v).cloned().unwrap_or_else(Rational::one));
            let value = value.evaluate(known).ok()??;
            if self.integers.contains(var) && !value.is_integer() {
                return None;
            }
            point.insert(*var, value);
        }
        Some(point)
    }
}

impl State {
    /// Adds what must be true; `false` where it is false.
    fn require(&mut self, open: Result<Open, bool>) -> bool {
        match open {
            Ok(open) if open.sign == Sign::Zero => self.equations.push(open.into()),
            Ok(open) => self.conditions.push(open.into()),
            Err(known) => return known,
        }
        true
    }

    /// The same with a value in the place of an unknown. `None` where something becomes false, or too large.
    fn with(&self, var: Var, value: Polynomial, integers: &[Var]) -> Option<State> {
        let put = |list: &[Rc<Open>]| {
            let mut changed = Vec::with_capacity(list.len());
            for open in list {
                if !open.has(var) {
                    changed.push(Rc::clone(open));
                    continue;
                }
                let polynomial = open.polynomial.substitute(var, &value).ok()?;
                match Open::new(polynomial, open.sign, integers) {
                    Ok(open) => changed.push(open.into()),
                    Err(true) => {}
                    Err(false) => return None,
                }
            }
            Some(changed)
        };
        let (equations, conditions) = (put(&self.equations)?, put(&self.conditions)?);
        let before = self.solved.clone();
        let solved = Solved { var, value, before };
        Some(State {
            equations,
            conditions,
            solved: Some(solved.into()),
        })
    }
}

impl State {
    /// The same with an equation divided by what all of its terms have in common, where that must not vanish: `b G = 4 b H` is an
    /// equation for `G`. Nothing where there is none; `Some(None)` where an equation cannot be true.
    fn without_factor(&self, integers: &[Var]) -> Option<Option<State>> {
        let excluded = |var: Var| {
            let mut all = self.conditions.iter();
            all.any(|own| {
                let excludes = matches!(own.sign, Sign::NonZero | Sign::Positive);
                excludes && own.polynomial.len() == 1 && own.has(var)
            })
        };
        let (at, rest) = self.equations.iter().enumerate().find_map(|(at, own)| {
            let (content, rest) = own.polynomial.without_content();
            let mut factors = content.powers().iter();
            let divides = !content.is_one() && factors.all(|&(var, _)| excluded(var));
            divides.then(|| (at, rest.into_owned()))
        })?;
        let mut divided = self.clone();
        divided.equations.remove(at);
        let possible = divided.require(Open::new(rest, Sign::Zero, integers));
        Some(possible.then_some(divided))
    }
}

/// The simplest number strictly between the bounds that conditions set an unknown.
fn simplest_allowed(conditions: &[Rc<Open>], var: Var) -> Option<Rational> {
    let (mut below, mut above): (Option<Rational>, Option<Rational>) = (None, None);
    for open in conditions.iter().filter(|f| f.polynomial.degree() == 1) {
        let slope = open.polynomial.coefficient(&Monomial::power(var, 1))?;
        let rest = open.polynomial.coefficient(&Monomial::one());
        let bound = rest.map_or_else(Rational::zero, |rest| -(rest / slope));
        let slot = match (open.sign, slope.is_positive()) {
            (Sign::NonNegative | Sign::Positive, true) => &mut below,
            (Sign::NonNegative | Sign::Positive, false) => &mut above,
            _ => continue,
        };
        let tighter = match (&*slot, slope.is_positive()) {
            (None, _) => true,
            (Some(old), true) => bound > *old,
            (Some(old), false) => bound < *old,
        };
        if tighter {
            *slot = Some(bound);
        }
    }
    let one = Rational::one();
    let (below, above) = match (below, above) {
        (Some(below), Some(above)) => (below, above),
        (Some(below), None) => (below.clone(), below + &one + &one),
        (None, Some(above)) => (above.clone() - &one - &one, above),
        (None, None) => return None,
    };
    let value = simplest_between(&below, &above).filter(|_| below < above)?;
    let met = |fact: &Rc<Open>| {
        let own = fact.polynomial.evaluate(|_| Some(value.clone()));
        own.is_ok_and(|v| v.is_some_and(|v| satisfies(&v, fact.sign)))
    };
    conditions.iter().all(met).then_some(value)
}

/// How many choices it takes to see that nothing leads to a point, where every choice was seen not to.
fn dead<'a>(mut choices: impl Iterator<Item = &'a Node>) -> Option<usize> {
    choices.try_fold(1_usize, |sum, choice| match choice {
        Node::Dead(own) => Some(sum + own),
        _ => None,
    })
}

/// The equation to solve, the unknown to solve it for, and what that then is.
fn linear(equations: &[Rc<Open>]) -> Option<(usize, Var, Polynomial)> {
    let mut best: Option<((bool, Var), usize)> = None;
    for (at, equation) in equations.iter().enumerate() {
        if let Some(own) = equation.solvable
            && best.is_none_or(|b| own > b.0)
        {
            best = Some((own, at));
        }
    }
    let ((_, var), at) = best?;
    let equation = &equations[at].polynomial;
    let own = Monomial::power(var, 1);
    let slope = equation.coefficient(&own)?.clone();
    let rest = equation.minus(&Polynomial::term(own, slope.clone()));
    Some((at, var, rest.scaled(&-slope.recip())))
}

pub fn satisfies(value: &Rational, sign: Sign) -> bool {
    sign.admits(value.cmp(&Rational::zero()))
}
