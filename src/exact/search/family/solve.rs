//! Few equations in few unknowns, solved exactly as far as linear factors lead.

use crate::algebra::{Fraction, Polynomial, Rational, TooLarge, Var};
use crate::sorted::Map;

/// More solutions are not looked for.
const MOST_SOLUTIONS: usize = 8;

/// What each unknown is in terms of those that are left.
pub(super) type Solution = Map<Var, Fraction>;

/// Solutions in fractions, not all there are. What comes first among the unknowns is eliminated first; whatever else occurs
/// is a number that is not chosen. Only `elements` are set to 0 or to one another where an equation leaves that open.
pub(super) fn solutions(
    equations: Vec<Polynomial>,
    elements: &[Var],
    unknowns: &[Var],
    steps: &mut usize,
) -> Vec<Solution> {
    let mut solver = Solver {
        elements,
        unknowns,
        steps,
        found: Vec::new(),
    };
    solver.go_on(equations, &mut Vec::new());
    solver.found
}

/// A solution with numbers for what is left; `None` where something is divided by 0.
pub(super) fn put_in(solution: &Solution, numbers: &Solution) -> Option<Solution> {
    let mut all = numbers.clone();
    for (&var, value) in solution {
        all.insert(var, at(value, numbers)?);
    }
    Some(all)
}

/// The number that a fraction is at a point; `None` where it has none.
pub(super) fn value_at(value: &Fraction, at: &[(Var, Rational)]) -> Option<Rational> {
    let number = |polynomial: &Polynomial| {
        let own = |var: Var| at.iter().find(|own| own.0 == var).map(|own| own.1.clone());
        polynomial.evaluate(own).ok()?
    };
    let mut result = number(value.numerator())?;
    for (factor, exponent) in value.denominator() {
        let below = number(factor).filter(|below| !below.is_zero())?;
        for _ in 0..exponent {
            result = result / &below;
        }
    }
    Some(result)
}

struct Solver<'a> {
    elements: &'a [Var],
    unknowns: &'a [Var],
    /// How many more may be taken.
    steps: &'a mut usize,
    found: Vec<Solution>,
}

impl Solver<'_> {
    /// Solves what is left, `solved` being found already, in terms of what comes after it.
    fn go_on(&mut self, mut equations: Vec<Polynomial>, solved: &mut Vec<(Var, Fraction)>) {
        equations.retain(|equation| !equation.is_zero());
        let speaks = |equation: &Polynomial| self.unknowns.iter().any(|&v| has(equation, v));
        if *self.steps == 0 || !equations.iter().all(speaks) {
            return;
        }
        *self.steps -= 1;
        if equations.is_empty() {
            if self.found.len() < MOST_SOLUTIONS {
                self.found.extend(finished(solved));
            }
            return;
        }
        if let Some((at, var)) = self.linear(&equations, true) {
            return self.eliminate(equations, at, var, solved);
        }
        let split = |(at, equation)| Some((at, self.factors(equation)?));
        if let Some((at, factors)) = equations.iter().enumerate().find_map(split) {
            for factor in factors {
                let mut equations = equations.clone();
                equations[at] = factor;
                self.go_on(equations, solved);
            }
            return;
        }
        if let Some((at, var)) = self.linear(&equations, false) {
            self.eliminate(equations, at, var, solved);
        }
    }

    /// An equation that is linear in an unknown; if so asked, with a factor before it in which there is no unknown.
    fn linear(&self, equations: &[Polynomial], plainly: bool) -> Option<(usize, Var)> {
        let fits = |equation: &Polynomial, var: Var| {
            let known = || {
                let parts = equation.in_powers_of(var);
                !self.unknowns.iter().any(|&v| has(&parts[1], v))
            };
            equation.degree_in(var) == 1 && (!plainly || known())
        };
        let all = self.unknowns.iter().flat_map(|&var| {
            let equations = equations.iter().enumerate();
            equations.map(move |(at, equation)| (at, equation, var))
        });
        let mut fitting = all.filter(|(_, equation, var)| fits(equation, *var));
        fitting.next().map(|(at, _, var)| (at, var))
    }

    fn eliminate(
        &mut self,
        mut equations: Vec<Polynomial>,
        at: usize,
        var: Var,
        solved: &mut Vec<(Var, Fraction)>,
    ) {
        let own = equations.remove(at).in_powers_of(var);
        let [rest, factor] = own.as_slice() else {
            return;
        };
        let put = |equation: &Polynomial| put_quotient(equation, var, &rest.negated(), factor);
        let Ok(equations) = equations.iter().map(put).collect() else {
            return;
        };
        let Some(value) = quotient(&rest.negated(), factor) else {
            return;
        };
        solved.push((var, value));
        self.go_on(equations, solved);
        solved.pop();
    }

    /// Factors that are seen: an unknown element, or the sum or difference of one and something else. `None` where there is
    /// nothing to see.
    fn factors(&self, equation: &Polynomial) -> Option<Vec<Polynomial>> {
        let (content, rest) = equation.without_content();
        if !content.is_one() {
            let powers = content.powers().iter().map(|power| power.0);
            let forced = rest.as_constant().is_some();
            let may_vanish = |var: &Var| match forced {
                true => self.unknowns.contains(var),
                false => self.elements.contains(var),
            };
            let zeros = powers.filter(may_vanish);
            let zeros = zeros.map(Polynomial::var);
            return Some(std::iter::once(rest.into_owned()).chain(zeros).collect());
        }
        let vars = equation.vars();
        let pairs = self.elements.iter().flat_map(|&a| {
            let others = vars
                .iter()
                .filter(move |&&b| self.unknowns.contains(&b) && b != a);
            others.map(move |&b| (Polynomial::var(a), Polynomial::var(b)))
        });
        let mut factors = pairs.flat_map(|(a, b)| [a.minus(&b), a.plus(&b)]);
        factors.find_map(|factor| {
            let rest = equation.divided_by(&factor)?;
            Some(vec![rest, factor])
        })
    }
}

fn has(polynomial: &Polynomial, var: Var) -> bool {
    polynomial.degree_in(var) > 0
}

/// A polynomial with `above/below` for an unknown, times a power of `below`.
fn put_quotient(
    polynomial: &Polynomial,
    var: Var,
    above: &Polynomial,
    below: &Polynomial,
) -> Result<Polynomial, TooLarge> {
    let parts = polynomial.in_powers_of(var);
    let mut sum = Polynomial::zero();
    let mut power = Polynomial::one();
    for part in parts.iter().rev() {
        sum = sum.times(above)?.plus(&part.times(&power)?);
        power = power.times(below)?;
    }
    Ok(sum)
}

fn quotient(above: &Polynomial, below: &Polynomial) -> Option<Fraction> {
    let inverse = Fraction::from(below.clone()).recip().ok()??;
    Fraction::from(above.clone()).times(&inverse).ok()
}

/// Each unknown in terms of those that are left, from the last one solved to the first.
fn finished(solved: &[(Var, Fraction)]) -> Option<Solution> {
    let mut all = Solution::new();
    for (var, value) in solved.iter().rev() {
        let value = at(value, &all)?;
        all.insert(*var, value);
    }
    Some(all)
}

/// A fraction with others put in for some unknowns.
fn at(value: &Fraction, values: &Solution) -> Option<Fraction> {
    let mut result = polynomial_at(value.numerator(), values)?;
    for (factor, exponent) in value.denominator() {
        let below = polynomial_at(factor, values)?.pow(exponent).ok()?;
        result = result.times(&below.recip().ok()??).ok()?;
    }
    Some(result)
}

fn polynomial_at(polynomial: &Polynomial, values: &Solution) -> Option<Fraction> {
    let mut sum = Fraction::default();
    for (monomial, coefficient) in polynomial.terms() {
        let mut product = Fraction::from(coefficient.clone());
        for &(var, exponent) in monomial.powers() {
            let own = || Fraction::from(Polynomial::var(var));
            let value = values.get(&var).cloned().unwrap_or_else(own);
            product = product.times(&value.pow(exponent).ok()?).ok()?;
        }
        sum = sum.plus(&product).ok()?;
    }
    Some(sum)
}
