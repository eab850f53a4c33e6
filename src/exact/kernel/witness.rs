use std::borrow::Cow;

use num_traits::{One, ToPrimitive};

use super::algebraic::InField;
use super::exponentials::Unit;
use super::in_pi::InPi;
use super::private::{Bound, Private};
use super::{Assignment, Claim, Domain, Fact, Problem, Reject, Sign, Standing};
use crate::algebra::{
    Atom, Atoms, BigRational, Conditions, Expr, Formula, Fraction, Function, Polynomial, Rational,
    Relation, Symbol, Var, element_parts, element_symbol,
};
use crate::sorted::Map;

/// A claim's formulas at one point.
pub(super) struct Point<'a> {
    pub(super) claim: &'a Claim,
    pub(super) problem: &'a Problem,
    /// The problem's, and what the terms within them bring along.
    pub(super) atoms: Cow<'a, Atoms>,
    pub(super) at: &'a Assignment,
    /// The unknowns' values found so far, by position.
    values: Vec<Option<Rational>>,
    /// Those that are no rational numbers.
    in_pi: Map<usize, InPi>,
    /// Where these are polynomials in another number, and not in π: in which.
    pub(super) unit: Option<Unit>,
    /// Whether what is evaluated is an exponent.
    pub(super) in_exponent: bool,
    /// The values of all unknowns, where some are polynomials in one irrational root.
    pub(super) in_field: Option<InField>,
    /// The symbols that have no value, but functions of which have.
    pub(super) private: Vec<Private>,
    /// What is asked of them.
    pub(super) bounds: Vec<Bound>,
}

impl<'a> Point<'a> {
    /// The point at which the problem of a claim is to be evaluated; it puts in what the problem does.
    pub fn new(claim: &'a Claim, problem: &'a Problem, at: &'a Assignment) -> Self {
        Point {
            claim,
            problem,
            atoms: Cow::Borrowed(&problem.atoms),
            at,
            values: Vec::new(),
            in_pi: Map::new(),
            unit: None,
            in_exponent: false,
            in_field: None,
            private: Vec::new(),
            bounds: Vec::new(),
        }
    }

    /// Whether every domain condition and every hypothesis is true.
    pub fn premises(&mut self) -> Result<(), Reject> {
        let number = self.problem.pi_is_the_number().then(|| Symbol::new("\\pi"));
        if let Some(pi) = number
            && (self.at.symbols.contains_key(&pi) || self.at.in_pi.contains_key(&pi))
        {
            return Err(Reject::OutsideDomain);
        }
        // What is said in terms of π is no value where π is a symbol; and each symbol has one value.
        let twice = |symbol: &Symbol| self.at.symbols.contains_key(symbol);
        if !self.at.in_pi.is_empty() && !self.problem.pi_is_the_number()
            || self.at.in_pi.keys().any(twice)
        {
            return Err(Reject::NoValue);
        }
        self.functions_may_be_constant()?;
        self.take_functions()?;
        self.take_field()?;
        for (symbol, value) in &self.at.symbols {
            if self
                .claim
                .domains
                .get(symbol)
                .is_some_and(|d| !d.contains(value))
            {
                return Err(Reject::OutsideDomain);
            }
        }
        for (sequence, elements) in &self.at.sequences {
            let domain = self.claim.sequences.get(sequence);
            for (position, element) in (1..).zip(elements) {
                let own = self.claim.domains.get(&element_symbol(sequence, position));
                if !domain.into_iter().chain(own).all(|d| d.contains(element)) {
                    return Err(Reject::OutsideDomain);
                }
            }
        }
        for (position, reading) in self.problem.readings.iter().enumerate() {
            let fact = reading.fact.ok_or(Reject::NoValue)?;
            let fact = self.problem.facts.get(fact);
            let fact = fact.ok_or(Reject::NoSuchFact(position))?;
            if !self.is_defined(&reading.conditions)? || !self.is_true(fact)? {
                return Err(Reject::PremiseFalse(position));
            }
        }
        for value in &self.problem.integers {
            if !self.fraction(value)?.is_some_and(|v| v.is_integer()) {
                return Err(Reject::OutsideDomain);
            }
        }
        self.course_exists()?;
        self.laws_can_keep_up()?;
        self.bounds_are_met()
    }

    /// Whether the goal is defined and false.
    pub fn goal_is_false(&mut self) -> Result<(), Reject> {
        let problem = self.problem;
        if !self.is_defined(&problem.conditions)? {
            return Err(Reject::GoalNotFalse);
        }
        self.bounds_are_met()?;
        // A goal that speaks of a private symbol itself is neither true nor false.
        let kept = self.bounds.len();
        match self.is_true(&problem.goal)? {
            _ if self.bounds.len() > kept => Err(Reject::NotPrivate),
            false => Ok(()),
            true => Err(Reject::GoalNotFalse),
        }
    }

    pub(super) fn is_defined(&mut self, conditions: &Conditions) -> Result<bool, Reject> {
        let nonzero = conditions.divisors().map(|p| (p, Sign::NonZero));
        let zero = conditions.zero.iter().map(|p| (p, Sign::Zero));
        let nonnegative = conditions.nonnegative.iter();
        let nonnegative = nonnegative.map(|p| (p, Sign::NonNegative));
        let positive = conditions.positive.iter().map(|p| (p, Sign::Positive));
        for (polynomial, sign) in nonzero.chain(zero).chain(nonnegative).chain(positive) {
            if !self.meets(polynomial, sign)? {
                return Ok(false);
            }
        }
        // What may not exist does where unknown functions are constant and nothing else is in the way.
        for term in &conditions.doubtful {
            let exists = match self.with_functions(term) {
                Some(term) => self.with_functions_put_in(&term).is_ok(),
                None => false,
            };
            if !exists {
                return Ok(false);
            }
        }
        Ok(true)
    }

    fn is_true(&mut self, fact: &Fact) -> Result<bool, Reject> {
        self.meets(&fact.polynomial, fact.sign)
    }

    /// The value of a polynomial.
    pub(super) fn number(&mut self, polynomial: &Polynomial) -> Result<InPi, Reject> {
        let vars = polynomial.vars();
        for &var in &vars {
            self.find(var)?;
        }
        if !vars.iter().any(|v| self.in_pi.contains_key(&v.position())) {
            return self.evaluated(polynomial).map(InPi::rational);
        }
        let known = |var: Var| match self.in_pi.get(&var.position()) {
            Some(value) => Some(value.clone()),
            None => self.values[var.position()].clone().map(InPi::rational),
        };
        InPi::evaluate(polynomial, known)
    }

    /// Looks up the value of an unknown.
    fn find(&mut self, var: Var) -> Result<(), Reject> {
        let position = var.position();
        if self.values.len() <= position {
            self.values.resize(position + 1, None);
        }
        if self.values[position].is_some() || self.in_pi.contains_key(&position) {
            return Ok(());
        }
        if let Atom::Symbol(symbol) = self.atoms.atom(var) {
            let value = match self.at.in_pi.get(symbol) {
                _ if self.problem.pi_is_the_number() && symbol.name() == "\\pi" => Some(InPi::pi()),
                Some(value) => Some(InPi::new(value.iter().map(Rational::from))),
                None => None,
            };
            if let Some(value) = value {
                self.in_pi.insert(position, value);
                return Ok(());
            }
        }
        match self.atom(var) {
            Err(Reject::NoValue) => match self.atoms.atom(var).clone() {
                Atom::Opaque(Expr::Call(Function::Exp, argument)) => {
                    let value = self.exponential(&argument)?;
                    self.in_pi.insert(position, value);
                }
                Atom::Opaque(term @ Expr::Call(Function::Ln, _)) => {
                    let value = self.logarithm_of_number(&term)?;
                    self.in_pi.insert(position, value);
                }
                Atom::Opaque(Expr::Power(base, exponent)) => {
                    let value = self.root_in_pi(&base, &exponent)?;
                    self.in_pi.insert(position, value);
                }
                _ => return Err(Reject::NoValue),
            },
            value => self.values[position] = Some(value?),
        }
        Ok(())
    }

    /// The root of a multiple of a power of π: `\sqrt{9 \pi^2/4} = 3 \pi/2`.
    fn root_in_pi(&mut self, base: &Expr, exponent: &Expr) -> Result<InPi, Reject> {
        let order = match exponent {
            Expr::Number(number) if number.numer().is_one() => number.denom().to_usize(),
            _ => None,
        };
        let order = order.ok_or(Reject::NoValue)?;
        let value = self.lowered(base)?;
        let mut below = InPi::rational(Rational::one());
        for (factor, exponent) in value.denominator() {
            below = below.times(&self.number(&factor.pow(exponent)?)?)?;
        }
        let above = self.number(value.numerator())?;
        let (Some((over, power)), Some((under, less))) = (above.as_multiple(), below.as_multiple())
        else {
            return Err(Reject::NoValue);
        };
        let power = power.checked_sub(less).ok_or(Reject::NoValue)?;
        if power % order > 0 {
            return Err(Reject::NoValue);
        }
        let root = self.raised(over / under, exponent.clone())?;
        let power = u32::try_from(power / order).map_err(|_| Reject::TooLarge)?;
        Ok(InPi::power(power)?.scaled(&root))
    }

    /// A power of a number, where it is rational.
    fn raised(&mut self, base: Rational, exponent: Expr) -> Result<Rational, Reject> {
        let base = Expr::Number(base.to_big());
        let value = self.lowered(&Expr::Power(base.into(), exponent.into()))?;
        value.as_constant().ok_or(Reject::NoValue)
    }

    /// The value of an unknown, where it is rational.
    pub(super) fn rational(&mut self, var: Var) -> Result<Rational, Reject> {
        self.find(var)?;
        self.values[var.position()].clone().ok_or(Reject::NoValue)
    }

    fn value(&mut self, polynomial: &Polynomial) -> Result<Rational, Reject> {
        for var in polynomial.vars() {
            self.find(var)?;
        }
        self.evaluated(polynomial)
    }

    /// The same where its unknowns were looked up.
    fn evaluated(&self, polynomial: &Polynomial) -> Result<Rational, Reject> {
        let value = polynomial.evaluate(|v| self.values[v.position()].clone())?;
        value.ok_or(Reject::NoValue)
    }

    pub(super) fn lowered(&mut self, term: &Expr) -> Result<Fraction, Reject> {
        let mut lowering = self.problem.lowering_over(self.atoms.to_mut());
        Ok(lowering.lower(term)?)
    }

    pub(super) fn fraction(&mut self, value: &Fraction) -> Result<Option<Rational>, Reject> {
        let mut result = self.value(value.numerator())?;
        for (factor, exponent) in value.denominator() {
            let below = self.value(&factor.pow(exponent)?)?;
            if below.is_zero() {
                return Ok(None);
            }
            result = result / below;
        }
        Ok(Some(result))
    }

    fn atom(&mut self, var: Var) -> Result<Rational, Reject> {
        match self.atoms.atom(var).clone() {
            Atom::Symbol(symbol) => self.at.symbols.get(&symbol).map(Rational::from).ok_or(
                match self.private.is_empty() {
                    true => Reject::NoValue,
                    false => Reject::NotPrivate,
                },
            ),
            Atom::Element { sequence, position } => {
                let elements = self.elements(&sequence)?;
                let element = elements.get(position as usize - 1);
                element.map(Rational::from).ok_or(Reject::NoValue)
            }
            Atom::PowerSum { to, powers } => self.power_sum(&to, &powers),
            Atom::Bound { .. } | Atom::Root { .. } => Err(Reject::NoValue),
            Atom::Opaque(expr) => self.opaque(&expr),
        }
    }

    fn elements(&self, sequence: &Symbol) -> Result<&'a [BigRational], Reject> {
        let elements = self.at.sequences.get(sequence).ok_or(Reject::NoValue)?;
        Ok(elements)
    }

    fn power_sum(&self, to: &Symbol, powers: &[(Symbol, u32)]) -> Result<Rational, Reject> {
        let count = self.at.symbols.get(to).ok_or(Reject::NoValue)?;
        let count = Rational::from(count);
        let mut sum = Rational::zero();
        let mut position = Rational::zero();
        let mut at = 0;
        // A count that is not a natural number has no sum; the longest list bounds the loop.
        if count.is_negative() || !count.is_integer() {
            return Err(Reject::NoValue);
        }
        while position < count {
            let mut term = Rational::one();
            for (sequence, exponent) in powers {
                let element = self.elements(sequence)?.get(at).ok_or(Reject::NoValue)?;
                let power = Polynomial::constant(element.into()).pow(*exponent)?;
                term *= power.as_constant().ok_or(Reject::NoValue)?;
            }
            sum += term;
            position += Rational::one();
            at += 1;
        }
        Ok(sum)
    }

    fn opaque(&mut self, expr: &Expr) -> Result<Rational, Reject> {
        if let Some(term) = self.with_functions(expr) {
            return self.with_functions_put_in(&term);
        }
        let mut evaluated = |inner: &Expr| {
            let value = self.lowered(inner)?;
            self.fraction(&value)?.ok_or(Reject::NoValue)
        };
        match expr {
            Expr::Call(
                function @ (Function::Sin | Function::Cos | Function::Exp | Function::Ln),
                argument,
            ) => {
                let argument = self.lowered(argument)?;
                self.function(*function, &argument)
            }
            Expr::Call(function, argument) => {
                let argument = evaluated(argument)?;
                match function {
                    Function::Abs => Ok(argument.abs()),
                    Function::Ceiling => Ok(argument.to_big().ceil().into()),
                    Function::Floor => Ok(argument.to_big().floor().into()),
                    _ => Err(Reject::NoValue),
                }
            }
            Expr::Power(base, exponent) => {
                let (base, exponent) = (evaluated(base)?, evaluated(exponent)?);
                self.raised(base, Expr::Number(exponent.to_big()))
            }
            // That every term has a value is among the conditions of what the sum stands in.
            Expr::Series {
                index,
                from,
                to,
                body,
            } if !body.has_elements() => {
                let (from, to) = (evaluated(from)?, evaluated(to)?);
                let all = from.is_integer() && to.is_integer() && !from.is_negative();
                if !all || (&to - &from) < Rational::from(-1) {
                    return Err(Reject::NoValue);
                }
                evaluated(&Expr::Series {
                    index: index.clone(),
                    from: Expr::Number(from.to_big()).into(),
                    to: Expr::Number(to.to_big()).into(),
                    body: body.clone(),
                })
            }
            Expr::Derivative { .. } if self.at.course.is_some() => self.along_the_way(expr),
            Expr::Derivative { body, variable } => match &**body {
                Expr::Symbol(symbol) => self.derivative(expr, symbol, variable),
                _ => Err(Reject::NoValue),
            },
            _ => Err(Reject::NoValue),
        }
    }

    /// `ds/dx` may be chosen where nothing is said of `s` that a choice could contradict.
    ///
    /// Either `s` occurs in this derivative only, and what is said of it throughout is at most one
    /// equation solved for it: then there is a function with that derivative. Or everything else is held
    /// constant, which no identity that mentions `x` may forbid: then the derivative is 0.
    fn derivative(
        &self,
        whole: &Expr,
        symbol: &Symbol,
        variable: &Symbol,
    ) -> Result<Rational, Reject> {
        let goal = &self.problem.goal_formula;
        // An element is named by its sequence too, and a number that cannot move has no slope to choose.
        let element = element_parts(symbol)
            .is_some_and(|(sequence, _)| self.problem.sequences.contains(&sequence));
        let fixed = |d: &Domain| d.integer || d.lower.is_some() && d.lower == d.upper;
        if element || self.claim.domains.get(symbol).is_some_and(fixed) {
            return Err(Reject::NoValue);
        }
        let formulas = self.problem.formulas.iter();
        let identities: Vec<&Formula> = formulas
            .clone()
            .filter(|f| f.1 == Standing::Identity && !is_trivial(&f.0))
            .map(|f| &*f.0)
            .collect();
        let all = || formulas.clone().map(|f| &*f.0).chain([goal]);
        let key = (symbol.clone(), variable.clone());
        if let Some(chosen) = self.at.derivatives.get(&key) {
            let elsewhere =
                |f: &Formula| f.terms().iter().any(|t| occurs_outside(t, symbol, whole));
            let mut about = identities
                .iter()
                .filter(|f| f.terms().iter().any(|t| t.mentions(symbol)));
            let solved = about.next().is_none_or(|f| is_solved_for(f, whole));
            if all().any(elsewhere) || !solved || about.next().is_some() {
                return Err(Reject::NoValue);
            }
            return Ok(chosen.into());
        }
        let says = |f: &&Formula| f.terms().iter().any(|t| t.mentions(variable));
        match identities.iter().any(says) {
            true => Err(Reject::NoValue),
            false => Ok(Rational::zero()),
        }
    }
}

/// `a = a`, as a hypothesis becomes that has been put in.
fn is_trivial(formula: &Formula) -> bool {
    matches!(formula, Formula::Relation { left, relation: Relation::Equal, right } if left == right)
}

/// Whether a symbol occurs anywhere but inside one particular term.
fn occurs_outside(term: &Expr, symbol: &Symbol, inside: &Expr) -> bool {
    if term == inside {
        return false;
    }
    let mut children = term.children().peekable();
    match children.peek() {
        None => term.mentions(symbol),
        Some(_) => {
            children.any(|child| occurs_outside(child, symbol, inside))
                || term.binder() == Some(symbol)
        }
    }
}

/// `derivative = term`, the term free of that derivative's symbol.
fn is_solved_for(formula: &Formula, derivative: &Expr) -> bool {
    let Some((left, right)) = formula.as_equation() else {
        return false;
    };
    let Expr::Derivative { body, .. } = derivative else {
        return false;
    };
    let free = |side: &Expr| body.free_symbols().iter().all(|s| !side.mentions(s));
    left == derivative && free(right) || right == derivative && free(left)
}
