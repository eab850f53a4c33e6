//! A proof written out: every fact it uses, every identity, and why no multiplier vanishes.
//!
//! `[3]` is a fact by its number, `G` the polynomial of what is to be shown. An identity is a plain equation between
//! polynomials: expanding both sides is all it takes to check one.

mod reasons;
mod written;

use crate::algebra::Formula;
use crate::audit::{Judged, changes};
use crate::derivation::{Assumed, Source};
use crate::kernel::{Assignment, Factors, Origin, Problem, Proven};
use crate::notation::{plain, plain_formula};

use super::evidence::Point;
use super::{Report, words};
use written::Written;

impl Report<'_> {
    /// The proof of one link, a step a line.
    pub fn proof(&self, judged: &Judged, proven: &Proven) -> Vec<String> {
        let mut lines = Vec::new();
        let goal = &proven.claim().goal;
        if *goal != judged.goal.formula {
            let mut assumed = judged.assumed.iter();
            // What does not change is what it is at one place.
            let there = match assumed.find(|own| own.tells_value_there()) {
                Some(own) => format!(
                    ", for with {} both sides agree there",
                    plain_formula(&own.formula)
                ),
                None => String::new(),
            };
            lines.push(format!("it is enough that {}{there}", plain_formula(goal)));
        }
        lines.extend(self.written_out(Some(judged), proven));
        lines
    }

    /// A proof that needs no premises.
    pub(super) fn proof_of(&self, proven: &Proven) -> Vec<String> {
        self.written_out(None, proven)
    }

    fn written_out(&self, judged: Option<&Judged>, proven: &Proven) -> Vec<String> {
        let (claim, certificate) = (proven.claim(), proven.certificate());
        let problem = Problem::new(claim, &certificate.unfold)
            .and_then(|problem| problem.with_rates(&certificate.rates));
        let Ok(problem) = problem else {
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
        for term in claim.goal.terms().into_iter().filter(|t| changes(t)) {
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
        let premise = |position: usize| match (judged, claim.hypotheses.get(position)) {
            (Some(judged), Some(own)) => self.premise(judged, position, &own.formula),
            _ => "a hypothesis".into(),
        };
        let known: Vec<String> = facts
            .map(|&at| {
                let origin = match &problem.origins[at] {
                    Origin::Hypothesis(position) => premise(*position),
                    Origin::Rate(position) => format!("{}, differentiated", premise(*position)),
                    Origin::Logarithms(position) => {
                        format!("{}, logarithms taken", premise(*position))
                    }
                    Origin::Domain(symbol) => {
                        format!("declared domain of {}", words::symbol(symbol))
                    }
                    Origin::Sums => "a count or a sum of even powers".into(),
                    Origin::Powers => "what a root or a power is".into(),
                    Origin::Functions => "what a function is".into(),
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

    /// Where the hypothesis at a position comes from. What holds in the place of what fails may come from more than that was drawn from.
    pub(super) fn premise(&self, judged: &Judged, position: usize, said: &Formula) -> String {
        let is_it = |own: &&Assumed| *own.formula == *said;
        let own = judged.assumed.get(position).filter(is_it);
        let own = own.or_else(|| judged.assumed.iter().find(is_it));
        let source = own.map(|own| own.source);
        let source = source.or_else(|| self.derivation.stating(said).map(Source::Equation));
        match source {
            Some(Source::Equation(at)) => format!("premise {}", self.name(at)),
            Some(source @ Source::Local(..)) => format!("supposed: {}", self.source(&source)),
            Some(of_no_place) => words::unplaced(of_no_place).into(),
            None => "a hypothesis".into(),
        }
    }
}
