//! A proof written out: every fact it uses, every identity, and why no multiplier vanishes.
//!
//! `[3]` is a fact by its number, `G` the polynomial of what is to be shown. An identity is a plain equation between
//! polynomials: expanding both sides is all it takes to check one.

use std::collections::BTreeSet;

use crate::algebra::{Expr, Polynomial, expr_of};
use crate::derivation::Source;
use crate::kernel::{
    Assignment, Cofactors, Fact, Factors, Knowledge, PositiveTerm, Problem, Proof, Proven,
    SeriesSquare, Sign,
};
use crate::notation::{plain, plain_formula};

use crate::audit::Judged;
use crate::kernel::Origin;

use super::evidence::Point;
use super::{Report, words};

impl Report<'_> {
    /// The proof of one link, a step a line.
    pub fn proof(&self, judged: &Judged, proven: &Proven) -> Vec<String> {
        let (claim, certificate) = (proven.claim(), proven.certificate());
        let Ok(problem) = Problem::new(claim, &certificate.unfold) else {
            return vec!["the certificate cannot be written out".into()];
        };
        let mut lines = Vec::new();
        for &position in &certificate.unfold {
            if let Some(hypothesis) = claim.hypotheses.get(position) {
                lines.push(format!(
                    "with {} put in",
                    plain_formula(&hypothesis.formula)
                ));
            }
        }
        let at = Assignment {
            unfold: certificate.unfold.clone(),
            ..Assignment::default()
        };
        let point = Point::new(claim, &at);
        for term in claim.goal.terms().into_iter().filter(|t| has_calculus(t)) {
            if let Some(value) = point.computed(term).filter(|value| value != term) {
                lines.push(format!("{} comes to {}", plain(term), plain(&value)));
            }
        }
        let mut page = Written::new(&problem);
        page.known
            .extend(certificate.lemmas.iter().map(|lemma| lemma.fact.clone()));
        let goal = page.fact(&problem.goal);
        page.steps.push(format!("To show: {goal}   (G)"));
        page.step(&problem.goal, &certificate.conclusion, "G", 2);
        let divisors: Factors = problem
            .conditions
            .nonzero
            .iter()
            .map(|p| (p.clone(), 1))
            .collect();
        if !divisors.is_empty() {
            page.steps
                .push("What is divided by does not vanish:".into());
            page.reasons(&divisors, "≠ 0", 0);
        }
        // From the last lemma to the first: those that nothing refers to are left out.
        let mut parts = vec![std::mem::take(&mut page.steps)];
        for (at, lemma) in certificate.lemmas.iter().enumerate().rev() {
            let number = problem.facts.len() + at;
            if !page.used.contains(&number) {
                continue;
            }
            let name = format!("[{}]", number + 1);
            page.known.truncate(number);
            page.steps
                .push(format!("{name} {}", page.fact(&lemma.fact)));
            page.step(&lemma.fact, &lemma.proof, &name, 2);
            parts.push(std::mem::take(&mut page.steps));
        }
        parts.reverse();
        let used: Vec<usize> = page.used.iter().copied().collect();
        let facts = used.iter().filter(|&&at| at < problem.facts.len());
        let known: Vec<String> = facts
            .map(|&at| {
                let origin = match &problem.origins[at] {
                    Origin::Hypothesis(position) => self.premise(judged, *position),
                    Origin::Domain(symbol) => {
                        format!("declared domain of {}", words::symbol(symbol))
                    }
                    Origin::Sums => "a count or a sum of even powers".into(),
                    Origin::Lemma => "a lemma".into(),
                };
                format!(
                    "  [{}] {}   {origin}",
                    at + 1,
                    page.fact(&problem.facts[at])
                )
            })
            .collect();
        if !known.is_empty() {
            lines.push("Known:".into());
            lines.extend(known);
        }
        lines.extend(parts.into_iter().flatten());
        lines
    }

    /// Where the hypothesis at a position comes from.
    fn premise(&self, judged: &Judged, position: usize) -> String {
        match judged.assumed.get(position).map(|a| a.source) {
            Some(Source::Equation(at)) => format!("premise {}", self.name(at)),
            Some(source @ Source::Local(..)) => format!("supposed: {}", self.source(&source)),
            Some(Source::Step) => "the step before".into(),
            None => "a hypothesis".into(),
        }
    }
}

/// Whether a derivative or a limit is taken in a term.
fn has_calculus(term: &Expr) -> bool {
    matches!(term, Expr::Derivative { .. } | Expr::Limit { .. })
        || term.children().into_iter().any(has_calculus)
}

/// A proof as it is being written.
struct Written<'a> {
    problem: &'a Problem,
    /// The facts so far, lemmas included.
    known: Vec<Fact>,
    /// The facts that are used, by position.
    used: BTreeSet<usize>,
    steps: Vec<String>,
}

impl<'a> Written<'a> {
    fn new(problem: &'a Problem) -> Self {
        Written {
            problem,
            known: problem.facts.clone(),
            used: BTreeSet::new(),
            steps: Vec::new(),
        }
    }

    fn polynomial(&self, polynomial: &Polynomial) -> String {
        plain(&expr_of(polynomial, &self.problem.atoms))
    }

    fn fact(&self, fact: &Fact) -> String {
        let sign = match fact.sign {
            Sign::Zero => "= 0",
            Sign::NonZero => "≠ 0",
            Sign::NonNegative => "≥ 0",
            Sign::Positive => "> 0",
        };
        format!("{} {sign}", self.polynomial(&fact.polynomial))
    }

    fn say(&mut self, indent: usize, text: &str) {
        self.steps.push(format!("{:indent$}{text}", ""));
    }

    /// One proof; `name` is what is to be shown, in short.
    fn step(&mut self, fact: &Fact, proof: &Proof, name: &str, indent: usize) {
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
        for &position in &term.facts {
            self.used.insert(position);
            shown.push(format!("[{}]", position + 1));
        }
        match shown.is_empty() {
            true => "1".into(),
            false => shown.join(" · "),
        }
    }

    /// Why each factor has the sign that is needed, by the facts that say so.
    fn reasons(&mut self, factors: &Factors, sign: &str, indent: usize) {
        let mut told: Vec<&Polynomial> = Vec::new();
        for (factor, exponent) in factors {
            if factor.as_constant().is_some() || told.contains(&factor) {
                continue;
            }
            told.push(factor);
            let shown = self.polynomial(factor);
            if sign == "≥ 0" && exponent % 2 == 0 {
                continue;
            }
            let because = self.because(factor, sign, exponent % 2 == 0);
            for &at in &because {
                self.used.insert(at);
            }
            let cited: Vec<String> = because.iter().map(|at| format!("[{}]", at + 1)).collect();
            let text = match cited.is_empty() {
                true => format!("where {shown} {sign} by inspection"),
                false => format!("where {shown} {sign} by {}", words::list(cited)),
            };
            self.say(indent + 2, &text);
        }
    }

    /// The fewest facts that show the sign of a factor: itself, or what is known of its unknowns.
    fn because(&self, factor: &Polynomial, sign: &str, even: bool) -> Vec<usize> {
        let mut all: Vec<usize> = Vec::new();
        for (at, fact) in self.known.iter().enumerate() {
            let vars = fact.polynomial.vars();
            let about = vars.iter().any(|v| factor.vars().contains(v));
            if fact.sign != Sign::Zero && about {
                all.push(at);
            }
        }
        let enough = |facts: &[usize]| {
            let chosen: Vec<Fact> = facts.iter().map(|&at| self.known[at].clone()).collect();
            let knowledge = Knowledge::new(&chosen);
            match sign {
                "≠ 0" => knowledge.is_nonzero(factor),
                "> 0" => knowledge.is_positive(factor) || even && knowledge.is_nonzero(factor),
                _ => knowledge.is_nonnegative(factor),
            }
        };
        for at in all.clone().into_iter().rev() {
            let fewer: Vec<usize> = all.iter().copied().filter(|&a| a != at).collect();
            if enough(&fewer) {
                all = fewer;
            }
        }
        all
    }
}

fn raised(name: &str, power: u32) -> String {
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
    let side = |powers: &[(crate::algebra::Symbol, u32)], index: &str| {
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
