//! The identities of a certificate, a line each.

use num_traits::Zero;

use crate::algebra::{Polynomial, Symbol, expr_of};
use crate::kernel::{
    BoundedSeries, Cofactors, ElementFactor, ElementSide, Fact, Factors, PositiveTerm, Problem,
    Proof, SeriesSquare, Sign,
};
use crate::notation::plain;

use super::words;
use crate::sorted::Set;

/// A proof as it is being written.
pub(super) struct Written<'a> {
    problem: &'a Problem,
    /// The facts so far, lemmas included.
    pub known: Vec<Fact>,
    /// The facts that are used, by position.
    pub used: Set<usize>,
    pub steps: Vec<String>,
}

impl<'a> Written<'a> {
    pub fn new(problem: &'a Problem) -> Self {
        Written {
            problem,
            known: problem.facts.clone(),
            used: Set::new(),
            steps: Vec::new(),
        }
    }

    pub fn polynomial(&self, polynomial: &Polynomial) -> String {
        plain(&expr_of(polynomial, &self.problem.atoms))
    }

    pub fn fact(&self, fact: &Fact) -> String {
        let sign = match fact.sign {
            Sign::Zero => "= 0",
            Sign::NonZero => "≠ 0",
            Sign::NonNegative => "≥ 0",
            Sign::Positive => "> 0",
        };
        format!("{} {sign}", self.polynomial(&fact.polynomial))
    }

    pub fn say(&mut self, indent: usize, text: &str) {
        self.steps.push(format!("{:indent$}{text}", ""));
    }

    /// One proof; `name` is what is to be shown, in short.
    pub fn step(&mut self, fact: &Fact, proof: &Proof, name: &str, indent: usize) {
        let goal = Polynomial::clone(&fact.polynomial);
        match proof {
            Proof::Combination {
                multiplier,
                power,
                cofactors,
            } => {
                let left = self.product(multiplier, &raised(name, *power));
                let right = self.combination(cofactors);
                self.say(indent, &format!("{left} = {}", sum(right)));
                self.reasons(multiplier, "≠ 0", indent);
            }
            Proof::NonVanishing {
                certain,
                cofactor,
                cofactors,
            } => {
                let mut right = vec![self.times(cofactor, name)];
                right.extend(self.combination(cofactors));
                let left = self.product(certain, "");
                self.say(indent, &format!("{left} = {}", sum(right)));
                self.reasons(certain, "≠ 0", indent);
            }
            Proof::Positivity {
                multiplier,
                terms,
                cofactors,
            } => {
                let mut right: Vec<String> = terms.iter().map(|t| self.positive(t)).collect();
                right.extend(self.combination(cofactors));
                let left = self.product(multiplier, name);
                self.say(indent, &format!("{left} = {}", sum(right)));
                self.reasons(multiplier, "> 0", indent);
                let factors: Factors = terms.iter().flat_map(|t| t.factors.clone()).collect();
                self.reasons(&factors, "≥ 0", indent);
            }
            Proof::BothBounds { below, above } => {
                let bound = |polynomial| Fact {
                    polynomial,
                    sign: Sign::NonNegative,
                };
                self.say(indent, &format!("{name} ≥ 0, for"));
                self.step(&bound(goal.clone()), below, name, indent + 2);
                self.say(indent, &format!("−{name} ≥ 0, for"));
                self.step(
                    &bound(goal.negated()),
                    above,
                    &format!("(−{name})"),
                    indent + 2,
                );
            }
            Proof::Larger { larger, squares } => {
                let (a, b) = (
                    self.polynomial(larger),
                    self.polynomial(&larger.minus(&goal)),
                );
                let sign = match fact.sign {
                    Sign::Positive => ">",
                    _ => "≥",
                };
                let text =
                    format!("{name} = a − b with a = {a} ≥ 0 and b = {b}, for a² {sign} b²:");
                self.say(indent, &text);
                if let Ok(polynomial) = Proof::difference_of_squares(larger, &goal) {
                    let sign = fact.sign;
                    let fact = Fact { polynomial, sign };
                    self.step(&fact, squares, "(a² − b²)", indent + 2);
                }
            }
            Proof::Logarithms(inner) => {
                if let Some(polynomial) = self.problem.goal_in_logarithms.clone() {
                    let sign = Sign::Zero;
                    let taken = Fact { polynomial, sign };
                    let text = format!(
                        "{name} = 0 equates what is positive, so that it is enough to equate the logarithms: {} (L)",
                        self.fact(&taken)
                    );
                    self.say(indent, &text);
                    self.step(&taken, inner, "L", indent + 2);
                }
            }
            Proof::Square(inner) => {
                self.say(indent, &format!("{name} = 0, for −{name}² ≥ 0:"));
                if let Ok(square) = goal.pow(2) {
                    let fact = Fact {
                        polynomial: square.negated(),
                        sign: Sign::NonNegative,
                    };
                    self.step(&fact, inner, &format!("(−{name}²)"), indent + 2);
                }
            }
            Proof::OfPower { power, base } => {
                self.used.insert(*base);
                let power = self.polynomial(&Polynomial::var(*power));
                let text = format!(
                    "by what {power} is, its base being known from [{}]",
                    base + 1
                );
                self.say(indent, &text);
            }
        }
    }

    fn combination(&mut self, cofactors: &Cofactors) -> Vec<String> {
        let mut terms = Vec::new();
        for (position, cofactor) in cofactors {
            self.used.insert(*position);
            terms.push(self.times(cofactor, &format!("[{}]", position + 1)));
        }
        terms
    }

    fn times(&self, cofactor: &Polynomial, name: &str) -> String {
        match cofactor.as_constant() {
            Some(one) if one.is_one() => name.to_owned(),
            _ => format!("({}) · {name}", self.polynomial(cofactor)),
        }
    }

    fn product(&self, factors: &Factors, rest: &str) -> String {
        let mut shown: Vec<String> = factors
            .iter()
            .filter(|(_, exponent)| *exponent > 0)
            .map(|(f, e)| raised(&format!("({})", self.polynomial(f)), *e))
            .collect();
        if !rest.is_empty() {
            shown.push(rest.to_owned());
        }
        match shown.is_empty() {
            true => "1".into(),
            false => shown.join(" · "),
        }
    }

    /// `Σ_i x_i (1 − x_i)²`.
    fn bounded(&self, series: &BoundedSeries) -> String {
        let count = words::symbol(&series.count);
        let f = element_product(self.problem, &series.f, "i");
        match &series.g {
            None => format!("Σ_{{i≤{count}}} {f}"),
            Some(g) => {
                let g = element_product(self.problem, g, "j");
                format!("Σ_{{i≠j≤{count}}} {f} {g}")
            }
        }
    }

    fn positive(&mut self, term: &PositiveTerm) -> String {
        let mut shown = Vec::new();
        if !term.coefficient.is_one() {
            shown.push(self.polynomial(&Polynomial::constant(term.coefficient.clone())));
        }
        if !term.factors.is_empty() {
            shown.push(self.product(&term.factors, ""));
        }
        for square in &term.squares {
            shown.push(format!("({})²", self.polynomial(square)));
        }
        shown.extend(term.series.iter().map(series));
        shown.extend(term.bounded.iter().map(|b| self.bounded(b)));
        for &position in &term.facts {
            self.used.insert(position);
            shown.push(format!("[{}]", position + 1));
        }
        match shown.is_empty() {
            true => "1".into(),
            false => shown.join(" · "),
        }
    }
}

/// `x_i² (1 − x_i)`.
fn element_product(problem: &Problem, factors: &[ElementFactor], index: &str) -> String {
    let shown: Vec<String> = factors
        .iter()
        .filter(|factor| factor.exponent > 0)
        .map(|factor| {
            let element = format!("{}_{index}", words::symbol(&factor.sequence));
            let domain = problem.element_domain(&factor.sequence);
            let lower = domain.and_then(|d| d.lower.as_ref()).map(|b| &b.0);
            let upper = domain.and_then(|d| d.upper.as_ref()).map(|b| &b.0);
            let base = match (factor.side, lower, upper) {
                (ElementSide::AboveLower, Some(lower), _) if !lower.is_zero() => {
                    format!("({element} − ({lower}))")
                }
                (ElementSide::BelowUpper, _, Some(upper)) => format!("({upper} − {element})"),
                _ => element,
            };
            raised(&base, factor.exponent)
        })
        .collect();
    shown.join(" ")
}

pub(super) fn raised(name: &str, power: u32) -> String {
    match power {
        1 => name.to_owned(),
        2 => format!("{name}²"),
        3 => format!("{name}³"),
        _ => format!("{name}^{power}"),
    }
}

fn sum(terms: Vec<String>) -> String {
    match terms.is_empty() {
        true => "0".into(),
        false => terms.join(" + "),
    }
}

/// `Σ_{i<j} (u_i − u_j)²`.
fn series(square: &SeriesSquare) -> String {
    let side = |powers: &[(Symbol, u32)], index: &str| {
        let shown: Vec<String> = powers
            .iter()
            .filter(|(_, e)| *e > 0)
            .map(|(s, e)| raised(&format!("{}_{index}", words::symbol(s)), *e))
            .collect();
        shown.join(" ")
    };
    let product = |a: String, b: String| match (a.is_empty(), b.is_empty()) {
        (true, true) => "1".to_owned(),
        (true, false) => b,
        (false, true) => a,
        (false, false) => format!("{a} {b}"),
    };
    let (f, g) = (&square.f, &square.g);
    format!(
        "Σ_{{i<j≤{}}} ({} − {})²",
        words::symbol(&square.count),
        product(side(f, "i"), side(g, "j")),
        product(side(f, "j"), side(g, "i")),
    )
}
