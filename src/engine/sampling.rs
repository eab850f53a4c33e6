//! Where premises may all be true, as far as floating point tells.
//!
//! It proves nothing and refutes nothing, and no verdict rests on it: of the many formulas that are near to what is printed it finds the few
//! that are worth asking the kernel about.

use std::cell::Cell;

use num_traits::ToPrimitive;

use crate::algebra::{Expr, Formula, Function, LimitPoint, Relation, Symbol, product_of};
use crate::sorted::{Map, Set};

/// More premises than this are not looked at.
const MOST_PREMISES: usize = 80;
/// So many terms are worked out for one sample, and with it, in all.
const MOST_STEPS: u64 = 1_000_000;
/// Deeper terms are not.
const DEEPEST: usize = 48;
/// How near two values are that are taken for the same.
const NEAR: f64 = 1e-6;
/// What is less than so much of that is nought.
const LEAST: f64 = 1e-4;
/// How far apart the points are between which slopes are taken, as a share.
const APART: f64 = 4e-3;
/// Into so many pieces an interval of integration is cut.
const PIECES: u32 = 24;
/// Where in each of them something is integrated, and with what weight (Abramowitz and Stegun, table 25.4, n = 5).
const NODES: [(f64, f64); 5] = [
    (-0.906_179_845_938_664, 0.236_926_885_056_189_1),
    (-0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
    (0.0, 0.568_888_888_888_888_9),
    (0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
    (0.906_179_845_938_664, 0.236_926_885_056_189_1),
];
/// What is far enough for infinity.
const FAR: f64 = 40.0;
/// So many terms in a row add nothing to a series that goes on without end.
const NEGLIGIBLE: u32 = 3;
/// A series with more terms is not summed.
const MOST_TERMS: f64 = 200.0;
/// A symbol is looked for between the powers of this to so many steps and their reciprocals.
const GROWTH: f64 = 1.7;
const STEPS: i32 = 13;
/// What is the same at all of these is the same anywhere, and how near that must be.
const ANYWHERE: [f64; 3] = [0.83, 1.37, 2.21];
const SAME: f64 = 1e-10;
/// From this seed on values are chosen farther apart, between this and its reciprocal: `\sqrt{1 - \frac{4 H}{r K}}`.
const CLOSE_TOGETHER: u32 = 8;
const FARTHEST: f64 = 6.0;
/// The letter that mostly counts something.
const COUNTING: &str = "n";

/// Values of symbols with which premises are true, as near as that can be.
pub struct Sample {
    /// What a symbol is said to be, and of what it is said as a function.
    defined: Map<Symbol, (Vec<Symbol>, Expr)>,
    values: Map<Symbol, f64>,
    /// What something is said to change with.
    clocks: Set<Symbol>,
    /// The symbols that count something.
    counted: Set<Symbol>,
    /// Which of two symbols is said to be the smaller one: `a < r`.
    ordered: Vec<[Symbol; 2]>,
    seed: u32,
    steps: Cell<u64>,
    /// A series that goes on without end did not die away.
    diverges: Cell<bool>,
}

impl Sample {
    /// Values for the symbols of a goal; the premises that are named first are heeded first.
    pub fn of<'a>(
        premises: impl IntoIterator<Item = &'a Formula>,
        goal: &Formula,
        seed: u32,
    ) -> Sample {
        let mut sample = Sample {
            defined: Map::new(),
            values: Map::new(),
            clocks: Set::new(),
            counted: Set::new(),
            ordered: Vec::new(),
            seed,
            steps: Cell::new(0),
            diverges: Cell::new(false),
        };
        let mut equations = Vec::new();
        for premise in premises.into_iter().take(MOST_PREMISES) {
            equations.extend(premise.as_equation());
            sample.ordered.extend(ordered(premise));
        }
        let terms = equations.iter().flat_map(|(one, other)| [*one, *other]);
        for term in terms.chain(goal.terms()) {
            collect_counted(term, &mut sample.counted);
        }
        let mut left = Vec::new();
        for &(one, other) in &equations {
            if !sample.define(one, other) && !sample.define(other, one) {
                left.push((one, other));
            }
        }
        sample.solve(left);
        for term in goal.terms() {
            sample.tie_slopes(term, &equations);
        }
        let mut open = Set::new();
        for term in goal.terms() {
            sample.collect_open(term, &mut Vec::new(), &mut open);
        }
        for symbol in open {
            sample.choose(&symbol);
        }
        sample
    }

    /// Whether a formula is true here; nothing where it has no value.
    pub fn holds(&self, formula: &Formula) -> Option<bool> {
        let Formula::Relation {
            left,
            relation,
            right,
        } = formula
        else {
            return None;
        };
        let (left, right) = (self.value(left)?, self.value(right)?);
        match relation {
            Relation::Equal => {
                Some((left - right).abs() <= NEAR * left.abs().max(right.abs()).max(LEAST))
            }
            Relation::Less | Relation::LessOrEqual => Some(left <= right),
            Relation::Greater | Relation::GreaterOrEqual => Some(left >= right),
            _ => None,
        }
    }

    /// Whether both sides of a formula have values here that can be told: a series that goes on without end must die away.
    pub fn has_value(&self, formula: &Formula) -> bool {
        self.diverges.set(false);
        self.holds(formula).is_some() && !self.diverges.get()
    }

    /// How many terms were worked out.
    pub fn steps(&self) -> u64 {
        self.steps.get()
    }

    /// Whether all values that were chosen or found are positive.
    pub fn is_positive(&self) -> bool {
        self.values.iter().all(|own| *own.1 > 0.0)
    }

    /// The same, and all that a formula speaks of as well.
    pub fn is_positive_with(&self, formula: &Formula) -> bool {
        let is_negative = |own: &Symbol| {
            let value = self.symbol(own, &mut Vec::new(), 0);
            value.is_some_and(|own| own <= 0.0)
        };
        self.is_positive() && !formula.free_symbols().iter().any(is_negative)
    }

    /// Takes a premise for what it says that a symbol is, if it says so plainly and that is not said in a circle.
    fn define(&mut self, of: &Expr, value: &Expr) -> bool {
        let (symbol, arguments) = match of {
            // `E I \frac{dw}{dx} = …` says how fast `w` changes.
            Expr::Product(factors) => {
                let is_slope = |own: &Expr| matches!(own, Expr::Derivative { .. });
                let Some(at) = factors.iter().position(is_slope) else {
                    return false;
                };
                let mut others = factors.to_vec();
                let slope = others.remove(at);
                let value = Expr::Quotient(value.clone().into(), product_of(others).into());
                return self.define(&slope, &value);
            }
            Expr::Symbol(own) if !own.is_unit() => (own, Vec::new()),
            Expr::Apply(own, arguments) => {
                let bare = arguments.iter().map(|own| match own {
                    Expr::Symbol(own) => Some(own.clone()),
                    _ => None,
                });
                match bare.collect() {
                    Some(bare) => (own, bare),
                    None => return false,
                }
            }
            own => match self.slope(own) {
                Some(slope) => {
                    if let Expr::Derivative { variable, .. } | Expr::Partial { variable, .. } = own
                    {
                        self.clocks.insert(variable.clone());
                    }
                    return self.define(&Expr::Symbol(slope), value);
                }
                None => return false,
            },
        };
        if self.defined.contains_key(symbol) {
            return false;
        }
        let (mut open, mut met) = (Set::new(), Vec::new());
        self.collect_open(value, &mut met, &mut open);
        if open.contains(symbol) || met.contains(symbol) {
            return false;
        }
        self.defined
            .insert(symbol.clone(), (arguments, value.clone()));
        true
    }

    /// The name of how fast something changes of which nothing says how it varies.
    fn slope(&self, term: &Expr) -> Option<Symbol> {
        let (Expr::Derivative { body, variable } | Expr::Partial { body, variable, .. }) = term
        else {
            return None;
        };
        let of = match &**body {
            Expr::Symbol(own) | Expr::Apply(own, _) => own.clone(),
            own => self.slope(own)?,
        };
        let is_open = of != *variable && !self.defined.contains_key(&of);
        is_open.then(|| slope(&of, variable))
    }

    /// How fast two symbols change with a third, where something says that of both and nothing how the one changes with the other.
    fn side_by_side(&self, term: &Expr) -> Option<[Symbol; 2]> {
        let (Expr::Derivative { body, variable } | Expr::Partial { body, variable, .. }) = term
        else {
            return None;
        };
        let Expr::Symbol(of) = &**body else {
            return None;
        };
        // Most slopes are by what all changes with.
        let mut clocks = self.clocks.iter().filter(|own| *own != variable).peekable();
        clocks.peek()?;
        if self.defined.contains_key(&slope(of, variable)) {
            return None;
        }
        let both = clocks.map(|clock| [slope(of, clock), slope(variable, clock)]);
        let mut both = both.filter(|own| own.iter().all(|own| self.defined.contains_key(own)));
        both.next()
    }

    /// The symbols on which the value of a term depends in the end.
    fn collect_open(&self, term: &Expr, met: &mut Vec<Symbol>, open: &mut Set<Symbol>) {
        match term {
            Expr::Symbol(symbol) => self.collect_open_of(symbol, met, open),
            Expr::Derivative { variable, .. } | Expr::Partial { variable, .. } => {
                if let Some(both) = self.side_by_side(term) {
                    both.iter()
                        .for_each(|own| self.collect_open_of(own, met, open));
                    return;
                }
                if let Some(slope) = self.slope(term) {
                    return self.collect_open_of(&slope, met, open);
                }
                self.collect_open_of(variable, met, open);
            }
            Expr::Apply(function, _) => self.collect_open_of(function, met, open),
            _ => {}
        }
        let bound = match term {
            Expr::Integral { variable, .. } | Expr::Limit { variable, .. } => Some(variable),
            Expr::Series { index, .. } => Some(index),
            _ => None,
        };
        let is_new = bound.is_some_and(|own| !met.contains(own));
        met.extend(bound.filter(|_| is_new).cloned());
        term.children()
            .for_each(|part| self.collect_open(part, met, open));
        if is_new {
            met.retain(|own| Some(own) != bound);
        }
    }

    fn collect_open_of(&self, symbol: &Symbol, met: &mut Vec<Symbol>, open: &mut Set<Symbol>) {
        if met.contains(symbol) {
            return;
        }
        met.push(symbol.clone());
        match self.defined.get(symbol) {
            Some((_, value)) => self.collect_open(value, met, open),
            None if known(symbol).is_some() => {}
            None => {
                open.insert(symbol.clone());
            }
        }
    }

    /// Chooses values, and finds those that are left no choice, one premise after another.
    fn solve(&mut self, mut left: Vec<(&Expr, &Expr)>) {
        while !left.is_empty() {
            let unknown = |sample: &Sample, (one, other): &(&Expr, &Expr)| {
                let mut open = Set::new();
                sample.collect_open(one, &mut Vec::new(), &mut open);
                sample.collect_open(other, &mut Vec::new(), &mut open);
                open.retain(|own| !sample.values.contains_key(own));
                open
            };
            let fewest = left.iter().enumerate();
            let fewest = fewest.map(|(at, own)| (at, unknown(self, own)));
            let Some((at, open)) = fewest.min_by_key(|(at, open)| (open.len(), *at)) else {
                return;
            };
            let mut open: Vec<Symbol> = open.into_iter().collect();
            // What an equation is written for comes last.
            let (one, other) = left.remove(at);
            open.sort_by_key(|own| {
                (
                    one.mentions(own),
                    !self.counted.contains(own),
                    own.name() != COUNTING,
                )
            });
            for symbol in open.split_last().map_or(&[][..], |own| own.1) {
                self.choose(symbol);
            }
            // What is on both sides alike leaves another one no choice: `\frac{1}{\sqrt{μ ε ε_r}} = \frac{c}{\sqrt{ε_r}}`.
            for symbol in open.iter().rev() {
                let chosen = self.values.remove(symbol);
                let root = self.root(one, other, symbol);
                match root.or(chosen) {
                    Some(value) => drop(self.values.insert(symbol.clone(), value)),
                    None => self.choose(symbol),
                }
                if root.is_some() {
                    break;
                }
            }
        }
    }

    /// Finds how fast something changes that an equation ties to what it changes with, all else being left as it is: `d \sin θ = m λ`.
    fn tie_slopes(&mut self, term: &Expr, equations: &[(&Expr, &Expr)]) {
        if let Expr::Derivative { body, variable } = term
            && let Expr::Symbol(of) = &**body
            && let Some(slope) = self.slope(term)
            && !self.values.contains_key(&slope)
            && !self.defined.contains_key(&slope)
            && self.side_by_side(term).is_none()
        {
            let steep = |by: &Symbol, side: &Expr| {
                let mut scope = Vec::new();
                let at = self.symbol(by, &mut scope, 0)?;
                self.steepness(side, by, at, &mut scope, 0)
            };
            let ties = |(one, other): &(&Expr, &Expr)| {
                let by = |own: &Symbol| Some(steep(own, one)? - steep(own, other)?);
                let (above, below) = (by(variable)?, by(of)?);
                (above.abs() > NEAR && below.abs() > NEAR).then(|| -above / below)
            };
            let is_of_both = |(one, other): &&(&Expr, &Expr)| {
                [of, variable]
                    .into_iter()
                    .all(|own| one.mentions(own) || other.mentions(own))
            };
            let found = equations.iter().filter(is_of_both).find_map(ties);
            if let Some(value) = found {
                self.values.insert(slope, value);
            }
        }
        term.children()
            .for_each(|part| self.tie_slopes(part, equations));
    }

    fn choose(&mut self, symbol: &Symbol) {
        if self.values.contains_key(symbol) {
            return;
        }
        let share = share(symbol.name(), &[], self.seed);
        let value = match self.counted.contains(symbol) || symbol.name() == COUNTING {
            true => 2.0 + (3.0 * share).floor(),
            false => match (self.nearest(symbol, true), self.nearest(symbol, false)) {
                (Some(low), Some(high)) if low < high => low + (high - low) * (0.1 + 0.8 * share),
                (Some(low), None) if low > 0.0 => low * (1.1 + share),
                (None, Some(high)) if high > 0.0 => high * (0.2 + 0.7 * share),
                _ if self.seed < CLOSE_TOGETHER => 0.4 + 1.2 * share,
                _ => FARTHEST.powf(2.0 * share - 1.0),
            },
        };
        self.values.insert(symbol.clone(), value);
    }

    /// The nearest value below a symbol, or above it, among those that are said to be there.
    fn nearest(&self, symbol: &Symbol, below: bool) -> Option<f64> {
        let (mut found, mut met, mut left) = (None, Set::new(), vec![symbol]);
        while let Some(own) = left.pop() {
            if !met.insert(own) {
                continue;
            }
            for [low, high] in &self.ordered {
                let (of, next) = if below { (high, low) } else { (low, high) };
                if of != own {
                    continue;
                }
                match (self.values.get(next), found) {
                    (Some(&value), Some(known)) if (value > known) != below => {}
                    (Some(&value), _) => found = Some(value),
                    (None, _) => left.push(next),
                }
            }
        }
        found
    }

    /// Where both sides are the same for a value of a symbol, next to 1; nothing where they are the same for any.
    fn root(&mut self, one: &Expr, other: &Expr, symbol: &Symbol) -> Option<f64> {
        let mut difference = |at: f64| {
            self.values.insert(symbol.clone(), at);
            let found = self.value(one).zip(self.value(other));
            self.values.remove(symbol);
            let (one, other) = found?;
            let is_same = (one - other).abs() <= SAME * one.abs().max(other.abs());
            Some(if is_same { 0.0 } else { one - other })
        };
        if ANYWHERE.iter().all(|at| difference(*at) == Some(0.0)) {
            return None;
        }
        for sign in [1.0, -1.0] {
            let grid = (-STEPS..=STEPS).map(|step| sign * GROWTH.powi(step));
            let grid: Vec<(f64, Option<f64>)> = grid.map(|at| (at, difference(at))).collect();
            let mut pairs: Vec<&[(f64, Option<f64>)]> = grid.windows(2).collect();
            pairs.sort_by(|one, other| {
                let far = |own: &[(f64, Option<f64>)]| own[0].0.abs().ln().abs();
                far(one).total_cmp(&far(other))
            });
            for pair in pairs {
                let [(low, Some(there)), (high, Some(here))] = *pair else {
                    continue;
                };
                if here == 0.0 {
                    return Some(high);
                }
                if (there < 0.0) == (here < 0.0) || there == 0.0 {
                    continue;
                }
                let (mut low, mut high) = (low, high);
                for _ in 0..60 {
                    let middle = 0.5 * (low + high);
                    match difference(middle)? {
                        own if (own < 0.0) == (there < 0.0) => low = middle,
                        _ => high = middle,
                    }
                }
                return Some(0.5 * (low + high));
            }
        }
        None
    }

    fn value(&self, term: &Expr) -> Option<f64> {
        let mut scope = Vec::new();
        self.evaluate(term, &mut scope, 0)
            .filter(|own| own.is_finite())
    }

    /// The value of a term where some symbols have other values: what is defined with these has another one, too.
    fn evaluate(&self, term: &Expr, scope: &mut Vec<(Symbol, f64)>, depth: usize) -> Option<f64> {
        self.steps.set(self.steps.get() + 1);
        if self.steps.get() > MOST_STEPS || depth > DEEPEST {
            return None;
        }
        let next = depth + 1;
        match term {
            Expr::Number(own) => own.to_f64(),
            Expr::Symbol(symbol) => self.symbol(symbol, scope, next),
            Expr::Element { sequence, index } => {
                let index = self.symbol(index, scope, next)?;
                Some(0.4 + 1.2 * share(sequence.name(), &index.to_le_bytes(), self.seed))
            }
            Expr::Sum(terms) => terms
                .iter()
                .try_fold(0.0, |sum, own| Some(sum + self.evaluate(own, scope, next)?)),
            Expr::Product(factors) => factors
                .iter()
                .try_fold(1.0, |all, own| Some(all * self.evaluate(own, scope, next)?)),
            Expr::Negate(inner) => Some(-self.evaluate(inner, scope, next)?),
            Expr::Quotient(above, below) => {
                let (above, below) = (
                    self.evaluate(above, scope, next)?,
                    self.evaluate(below, scope, next)?,
                );
                Some(above / below)
            }
            Expr::Power(base, exponent) => {
                let base = self.evaluate(base, scope, next)?;
                Some(base.powf(self.evaluate(exponent, scope, next)?))
            }
            Expr::Call(function, inner) => {
                Some(apply(*function, self.evaluate(inner, scope, next)?))
            }
            Expr::Apply(function, arguments) => {
                let mut values = Vec::new();
                for argument in arguments.iter() {
                    values.push(self.evaluate(argument, scope, next)?);
                }
                // What is said of `u` is so of `u(r)`, and not of `u(2 r)`.
                let is_bare = |own: &Expr| matches!(own, Expr::Symbol(_));
                let Some((parameters, value)) = self.defined.get(function) else {
                    return Some(self.anything(function, &values));
                };
                if parameters.is_empty() && !arguments.iter().all(is_bare) {
                    return None;
                }
                let length = scope.len();
                scope.extend(parameters.iter().cloned().zip(values));
                let found = self.evaluate(value, scope, next);
                scope.truncate(length);
                found
            }
            Expr::Derivative { body, variable } | Expr::Partial { body, variable, .. } => {
                if let Some([above, below]) = self.side_by_side(term) {
                    let below = self.symbol(&below, scope, next)?;
                    return Some(self.symbol(&above, scope, next)? / below);
                }
                if let Some(slope) = self.slope(term) {
                    return self.symbol(&slope, scope, next);
                }
                let at = self.symbol(variable, scope, next)?;
                let mut sum = self.steepness(body, variable, at, scope, next)?;
                let mut open = Set::new();
                self.collect_open(body, &mut Vec::new(), &mut open);
                for own in open.iter().filter(|own| *own != variable) {
                    if let Some(slope) = self.symbol(&slope(own, variable), scope, next) {
                        let at = self.symbol(own, scope, next)?;
                        sum += slope * self.steepness(body, own, at, scope, next)?;
                    }
                }
                // What does not change as far as is known is of what is not known.
                (sum != 0.0).then_some(sum)
            }
            Expr::Integral {
                body,
                variable,
                from,
                to,
            } => {
                let from = self.evaluate(from, scope, next)?;
                let to = self.evaluate(to, scope, next)?;
                // What goes on without end mostly dies away soon.
                let power = if (to - from).abs() >= FAR { 3 } else { 1 };
                let end = |piece: u32| (f64::from(piece) / f64::from(PIECES)).powi(power);
                let (mut sum, mut last) = (0.0, [f64::NAN; 4]);
                // By Gauß and Legendre: what has no value at an end is integrated, too.
                for piece in 0..PIECES {
                    let start = from + (to - from) * end(piece);
                    let width = from + (to - from) * end(piece + 1) - start;
                    for (off, weight) in NODES {
                        let at = start + width * (0.5 + 0.5 * off);
                        let value = self.with(variable, at, body, scope, next)?;
                        sum += 0.5 * width * weight * value;
                        last = [last[1], last[2], last[3], value];
                        if is_pole(last) {
                            return None;
                        }
                    }
                }
                Some(sum)
            }
            Expr::Limit {
                body,
                variable,
                point,
            } => {
                let (point, near) = match point {
                    LimitPoint::Finite(point) => {
                        let point = self.evaluate(point, scope, next)?;
                        (point, point + 1e-8 * point.abs().max(1e-2))
                    }
                    LimitPoint::PlusInfinity => (FAR, FAR),
                    LimitPoint::MinusInfinity => (-FAR, -FAR),
                };
                [point, near].into_iter().find_map(|value| {
                    let found = self.with(variable, value, body, scope, next);
                    found.filter(|own| own.is_finite())
                })
            }
            Expr::Series {
                index,
                from,
                to,
                body,
            } => {
                let from = self.evaluate(from, scope, next)?;
                let to = self.evaluate(to, scope, next)?;
                if from.fract() != 0.0 || to.fract() != 0.0 || to - from > MOST_TERMS {
                    return None;
                }
                let (mut sum, mut at, mut negligible) = (0.0_f64, from, 0);
                while at <= to && negligible < NEGLIGIBLE {
                    let term = self.with(index, at, body, scope, next)?;
                    negligible = match term.abs() <= SAME * sum.abs() && to >= FAR {
                        true => negligible + 1,
                        false => 0,
                    };
                    sum += term;
                    at += 1.0;
                }
                if to >= FAR && negligible < NEGLIGIBLE {
                    self.diverges.set(true);
                }
                Some(sum)
            }
        }
    }

    /// The value of a term where a symbol has this one.
    fn with(
        &self,
        symbol: &Symbol,
        value: f64,
        term: &Expr,
        scope: &mut Vec<(Symbol, f64)>,
        depth: usize,
    ) -> Option<f64> {
        scope.push((symbol.clone(), value));
        let found = self.evaluate(term, scope, depth);
        scope.pop();
        found
    }

    /// How fast a term grows with a symbol.
    fn steepness(
        &self,
        term: &Expr,
        by: &Symbol,
        at: f64,
        scope: &mut Vec<(Symbol, f64)>,
        depth: usize,
    ) -> Option<f64> {
        let apart = APART * at.abs().max(0.1);
        let mut beside = |steps: f64| self.with(by, at + steps * apart, term, scope, depth);
        let near = beside(1.0)? - beside(-1.0)?;
        let far = beside(2.0)? - beside(-2.0)?;
        Some((8.0 * near - far) / (12.0 * apart))
    }

    fn symbol(&self, symbol: &Symbol, scope: &mut Vec<(Symbol, f64)>, depth: usize) -> Option<f64> {
        if let Some((_, value)) = scope.iter().rev().find(|(own, _)| own == symbol) {
            return Some(*value);
        }
        if let Some(value) = known(symbol) {
            return Some(value);
        }
        match self.defined.get(symbol) {
            Some((_, value)) => self.evaluate(value, scope, depth),
            None => self.values.get(symbol).copied(),
        }
    }

    /// What a function of which nothing is said comes to.
    fn anything(&self, function: &Symbol, at: &[f64]) -> f64 {
        // What is the same but for how it was worked out is the same.
        let rough = |own: &f64| format!("{own:.6e} ").into_bytes();
        let at: Vec<u8> = at.iter().flat_map(rough).collect();
        0.4 + 1.2 * share(function.name(), &at, self.seed)
    }
}

/// Which of two symbols a premise says to be the smaller one.
fn ordered(premise: &Formula) -> Option<[Symbol; 2]> {
    let Formula::Relation {
        left: Expr::Symbol(left),
        relation,
        right: Expr::Symbol(right),
    } = premise
    else {
        return None;
    };
    match relation {
        Relation::Less | Relation::LessOrEqual => Some([left.clone(), right.clone()]),
        Relation::Greater | Relation::GreaterOrEqual => Some([right.clone(), left.clone()]),
        _ => None,
    }
}

/// The name of how fast a symbol changes.
fn slope(of: &Symbol, by: &Symbol) -> Symbol {
    Symbol::new(format!("\\slope{{{}}}{{{}}}", of.name(), by.name()))
}

/// Whether what takes these values one after another has a pole in their middle: it grows towards where its sign changes.
fn is_pole([far, near, beyond, farther]: [f64; 4]) -> bool {
    let grows = |from: f64, to: f64| (0.0..1.0).contains(&(from / to));
    near * beyond < 0.0 && grows(far, near) && grows(farther, beyond)
}

/// Units are those of the SI.
fn known(symbol: &Symbol) -> Option<f64> {
    match symbol.name() {
        "\\pi" => Some(std::f64::consts::PI),
        _ => symbol.is_unit().then_some(1.0),
    }
}

/// The symbols that count: those that a series ends at.
fn collect_counted(term: &Expr, found: &mut Set<Symbol>) {
    if let Expr::Series { to, from, .. } = term {
        found.extend(to.free_symbols());
        found.extend(from.free_symbols());
    }
    term.children()
        .for_each(|part| collect_counted(part, found));
}

fn apply(function: Function, at: f64) -> f64 {
    match function {
        Function::Sin => at.sin(),
        Function::Cos => at.cos(),
        Function::Tan => at.tan(),
        Function::ArcSin => at.asin(),
        Function::ArcCos => at.acos(),
        Function::ArcTan => at.atan(),
        Function::Exp => at.exp(),
        Function::Ln => at.ln(),
        Function::Abs => at.abs(),
        Function::Ceiling => at.ceil(),
        Function::Floor => at.floor(),
    }
}

/// A number from 0 to 1 that is always the same for a name, an index and a seed (FNV-1a).
fn share(name: &str, index: &[u8], seed: u32) -> f64 {
    let bytes = name.bytes().chain(index.iter().copied());
    let bytes = bytes.chain(seed.to_le_bytes());
    let hash = bytes.fold(0x811c_9dc5_u32, |hash, byte| {
        (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193)
    });
    let mixed = (hash ^ (hash >> 15)).wrapping_mul(0x2c1b_3c6d);
    f64::from(mixed ^ (mixed >> 13)) / f64::from(u32::MAX)
}
