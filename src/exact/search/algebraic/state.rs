//! What is left to satisfy, and the choices in it.

use super::solve::{fields, rational, roots_in};
use super::{polynomial_in, univariate};
use crate::algebra::{Monomial, Polynomial, Rational, Univariate, Var};
use crate::kernel::{Fact, Field, Sign};
use crate::search::point::satisfies;
use crate::search::values::candidates;
use crate::sorted::{self, Map};

/// How many of the usual numbers are tried for an unknown.
const MOST_NUMBERS: usize = 10;
/// In longer polynomials nothing is put in.
const MOST_TERMS: usize = 64;
/// A divisor with more terms is not put in.
const LONGEST_DIVISOR: usize = 6;

/// What is left to satisfy.
#[derive(Clone, Default)]
pub struct State {
    equations: Vec<Polynomial>,
    conditions: Vec<Fact>,
    /// Unknowns with what they are, a quotient of polynomials in others.
    solved: Vec<(Var, Polynomial, Polynomial)>,
    /// The unknown that is the irrational root, and its field.
    root: Option<(Var, Field)>,
}

/// A search among choices.
pub struct Search<'a> {
    pub order: &'a [Var],
    pub integers: &'a [Var],
    /// The highest degree of a root that is adjoined.
    pub highest: usize,
    /// How many choices are left.
    pub left: usize,
    /// Whether an equation was met that has roots of a higher degree only.
    pub passed_over: bool,
}

type Values = Map<Var, Univariate>;

impl State {
    pub fn new(facts: Vec<Fact>) -> State {
        let (equations, conditions) = facts.into_iter().partition(|f| f.sign == Sign::Zero);
        let equations: Vec<Fact> = equations;
        State {
            equations: equations.into_iter().map(|f| f.polynomial).collect(),
            conditions,
            ..State::default()
        }
    }

    /// The unknowns of a polynomial that have no value yet.
    fn open(&self, polynomial: &Polynomial) -> Vec<Var> {
        let root = self.root.as_ref().map(|r| r.0);
        let vars = polynomial.vars().into_iter();
        vars.filter(|var| Some(*var) != root).collect()
    }

    /// A polynomial modulo that of the root.
    fn reduced(&self, polynomial: Polynomial) -> Option<Polynomial> {
        let Some((var, field)) = &self.root else {
            return Some(polynomial);
        };
        let modulus = field.polynomial().monic();
        if (polynomial.degree_in(*var) as usize) < modulus.degree() {
            return Some(polynomial);
        }
        let mut parts = polynomial.in_powers_of(*var);
        while parts.len() > modulus.degree() {
            let lead = parts.pop()?;
            let from = parts.len() - modulus.degree();
            for (k, c) in modulus.coefficients()[..modulus.degree()]
                .iter()
                .enumerate()
            {
                parts[from + k] = parts[from + k].minus(&lead.scaled(c));
            }
        }
        let mut sum = Polynomial::zero();
        for (part, k) in parts.iter().zip(0_u32..) {
            sum = sum.plus(&part.times_term(&Monomial::power(*var, k), &Rational::one()));
        }
        Some(sum)
    }

    /// Takes out what is settled; `None` where something is false.
    fn settled(mut self) -> Option<State> {
        let mut open = Vec::new();
        for equation in std::mem::take(&mut self.equations) {
            let equation = self.without_factors(self.reduced(equation)?);
            match self.is_true(&equation, Sign::Zero) {
                None => open.push(equation),
                Some(true) => {}
                Some(false) => return None,
            }
        }
        let mut conditions = Vec::new();
        for Fact { polynomial, sign } in std::mem::take(&mut self.conditions) {
            let polynomial = self.reduced(polynomial)?;
            match self.is_true(&polynomial, sign) {
                None => conditions.push(Fact { polynomial, sign }),
                Some(true) => {}
                Some(false) => return None,
            }
        }
        (self.equations, self.conditions) = (open, conditions);
        Some(self)
    }

    /// An equation without the unknowns that divide it and are said not to be 0.
    fn without_factors(&self, equation: Polynomial) -> Polynomial {
        let content = equation.content();
        let is_nonzero = |var: Var| {
            let own = Polynomial::var(var);
            let nonzero = |f: &Fact| f.sign != Sign::NonNegative && f.polynomial == own;
            self.conditions.iter().any(nonzero)
        };
        let known = content.powers().iter().filter(|(var, _)| is_nonzero(*var));
        let known = known.fold(Monomial::one(), |all, &(var, exponent)| {
            all.times(&Monomial::power(var, exponent))
        });
        let factor = Polynomial::term(known, Rational::one());
        equation.divided_by(&factor).unwrap_or(equation)
    }

    /// `None` while there are unknowns in it.
    fn is_true(&self, polynomial: &Polynomial, sign: Sign) -> Option<bool> {
        if let Some(value) = polynomial.as_constant() {
            return Some(satisfies(&value, sign));
        }
        let (var, field) = self.root.as_ref()?;
        let order = field.sign(&univariate(polynomial, *var)?);
        Some(sign.admits(order))
    }

    /// The same with a quotient in the place of an unknown. `None` where something becomes too large.
    fn with(&self, var: Var, above: &Polynomial, below: &Polynomial) -> Option<State> {
        let put = |polynomial: &Polynomial, even: bool| {
            let degree = polynomial.degree_in(var);
            if polynomial.len() > MOST_TERMS {
                return None;
            }
            if degree == 0 || below.as_constant().is_some_and(|b| b.is_one()) {
                return polynomial.substitute(var, above).ok();
            }
            // Multiplied by a power of the divisor; an even one changes no sign.
            let power = degree + u32::from(even && degree % 2 == 1);
            let mut sum = Polynomial::zero();
            for (part, k) in polynomial.in_powers_of(var).iter().zip(0_u32..) {
                let own = above.pow(k).ok()?.times(&below.pow(power - k).ok()?).ok()?;
                sum = sum.plus(&part.times(&own).ok()?);
            }
            Some(sum)
        };
        let mut next = State {
            root: self.root.clone(),
            solved: self.solved.clone(),
            ..State::default()
        };
        for equation in &self.equations {
            next.equations.push(put(equation, false)?);
        }
        for fact in &self.conditions {
            next.conditions.push(Fact {
                polynomial: put(&fact.polynomial, true)?,
                sign: fact.sign,
            });
        }
        if below.as_constant().is_none() {
            next.conditions.push(Fact {
                polynomial: below.clone(),
                sign: Sign::NonZero,
            });
        }
        next.solved.push((var, above.clone(), below.clone()));
        Some(next)
    }

    /// The same with a value in the field for an unknown.
    fn with_number(&self, var: Var, value: &Univariate) -> Option<State> {
        let value = match (&self.root, value.as_constant()) {
            (_, Some(number)) => Polynomial::constant(number),
            (Some((root, _)), None) => polynomial_in(*root, value),
            (None, None) => return None,
        };
        self.with(var, &value, &Polynomial::one())
    }

    /// An unknown that an equation is linear in, with what it is: first one with a number for its coefficient, then,
    /// where there are as many equations as unknowns, one with an expression.
    fn linear(&self) -> Option<(usize, Var, Polynomial, Polynomial)> {
        let mut unknowns: Vec<Var> = self.equations.iter().flat_map(|e| self.open(e)).collect();
        sorted::sort(&mut unknowns);
        unknowns.dedup();
        let tight = self.equations.len() >= unknowns.len();
        let mut best: Option<(bool, usize, Var, Polynomial, Polynomial)> = None;
        for (at, equation) in self.equations.iter().enumerate() {
            // Unknowns met late are solved for first: those of the goal stay free.
            for var in self.open(equation).into_iter().rev() {
                if equation.degree_in(var) != 1 {
                    continue;
                }
                let mut parts = equation.in_powers_of(var);
                let (Some(slope), Some(rest)) = (parts.pop(), parts.pop()) else {
                    continue;
                };
                let number = self.open(&slope).is_empty();
                if !number && (!tight || slope.len() > LONGEST_DIVISOR) {
                    continue;
                }
                let better = best
                    .as_ref()
                    .is_none_or(|b| (number, var) > (b.0, b.2) && number >= b.0);
                if better {
                    best = Some((number, at, var, rest.negated(), slope));
                }
            }
        }
        best.map(|(_, at, var, above, below)| (at, var, above, below))
    }

    /// A quotient whose divisor has a value, as a polynomial.
    fn divided(&self, above: Polynomial, below: Polynomial) -> Option<(Polynomial, Polynomial)> {
        if let Some(number) = below.as_constant() {
            return Some((above.scaled(&number.recip()), Polynomial::one()));
        }
        let Some((root, field)) = self.root.as_ref().filter(|_| self.open(&below).is_empty())
        else {
            return Some((above, below));
        };
        let below = univariate(&below, *root)?;
        let inverse = below.inverse_modulo(field.polynomial())?;
        let inverse = polynomial_in(*root, &inverse);
        Some((
            self.reduced(above.times(&inverse).ok()?)?,
            Polynomial::one(),
        ))
    }
}

impl Search<'_> {
    /// The first point that is accepted, from a state on.
    pub fn explore<T>(
        &mut self,
        state: State,
        accepts: &impl Fn(&Field, &Values) -> Option<T>,
    ) -> Option<T> {
        self.left = self.left.checked_sub(1)?;
        let mut state = state.settled()?;
        while let Some((at, var, above, below)) = state.linear() {
            let (above, below) = state.divided(above, below)?;
            state.equations.remove(at);
            state = state.with(var, &above, &below)?.settled()?;
        }
        let single = state.equations.iter().find_map(|equation| {
            let open = state.open(equation);
            (open.len() == 1).then(|| (equation.clone(), open[0]))
        });
        if let Some((equation, var)) = single {
            return self.roots(&state, &equation, var, accepts);
        }
        let narrowest = state.equations.iter().min_by_key(|e| state.open(e).len());
        let next = match narrowest {
            // What is of the lowest degree is chosen, so that a root of the rest is left to be found.
            Some(equation) => {
                let open = state.open(equation).into_iter();
                open.min_by_key(|&var| equation.degree_in(var))
            }
            None => {
                let asked = |var: &&Var| {
                    let own = |f: &Fact| f.polynomial.degree_in(**var) > 0;
                    let root = state.root.as_ref().is_some_and(|r| r.0 == **var);
                    !root && state.conditions.iter().any(own)
                };
                self.order.iter().find(asked).copied()
            }
        };
        let Some(var) = next else {
            let (field, values) = finished(&state)?;
            return accepts(&field, &values);
        };
        let whole = self.integers.contains(&var);
        let numbers = candidates().iter().map(|(_, value)| value);
        let numbers = numbers.filter(|value| !whole || value.is_integer());
        numbers.take(MOST_NUMBERS).find_map(|value| {
            let next = state.with_number(var, &Univariate::constant(value.clone()))?;
            self.explore(next, accepts)
        })
    }

    /// Goes on with each root of an equation in one unknown.
    fn roots<T>(
        &mut self,
        state: &State,
        equation: &Polynomial,
        var: Var,
        accepts: &impl Fn(&Field, &Values) -> Option<T>,
    ) -> Option<T> {
        if let Some((root, field)) = &state.root {
            let parts = equation.in_powers_of(var).into_iter();
            let parts: Vec<Univariate> = parts
                .map(|part| univariate(&part, *root))
                .collect::<Option<_>>()?;
            let mut roots = roots_in(field, parts).into_iter();
            return roots.find_map(|value| {
                let next = state.with_number(var, &value)?;
                self.explore(next, accepts)
            });
        }
        let polynomial = univariate(equation, var)?;
        for value in rational(&polynomial) {
            let next = state.with_number(var, &Univariate::constant(value));
            if let Some(found) = next.and_then(|next| self.explore(next, accepts)) {
                return Some(found);
            }
        }
        if self.integers.contains(&var) {
            return None;
        }
        let (low, high): (Vec<Field>, Vec<Field>) = fields(&polynomial)
            .into_iter()
            .partition(|field| field.polynomial().degree() <= self.highest);
        self.passed_over |= !high.is_empty();
        low.into_iter().find_map(|field| {
            let mut next = state.clone();
            next.root = Some((var, field));
            self.explore(next, accepts)
        })
    }
}

/// The values of all unknowns. `None` where something is divided by 0, or too large.
fn finished(state: &State) -> Option<(Field, Values)> {
    // Rational points are the other search's to find.
    let (root, field) = state.root.clone()?;
    let mut values = Values::from([(root, Univariate::unknown())]);
    // What was solved first may depend on what was solved later. Unknowns that are free still are 1.
    for (var, above, below) in state.solved.iter().rev() {
        let mut value = |polynomial: &Polynomial| {
            let own = |var| {
                let free = || Univariate::constant(Rational::one());
                Ok(values.entry(var).or_insert_with(free).clone())
            };
            field.evaluate(polynomial, own).ok()
        };
        let (above, below) = (value(above)?, value(below)?);
        let inverse = below.inverse_modulo(field.polynomial())?;
        values.insert(*var, field.times(&above, &inverse).ok()?);
    }
    Some((field, values))
}
