//! Why a factor does not vanish, or is not negative: the fewest facts from which it can be seen.

use crate::algebra::Polynomial;
use crate::kernel::{Fact, Factors, Knowledge, Sign};

use super::words;
use super::written::{Written, raised};

impl Written<'_> {
    /// Why each factor has the sign that is needed, by the facts that say so.
    pub fn reasons(&mut self, factors: &Factors, sign: &str, indent: usize) {
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
            let is_even = exponent % 2 == 0;
            let because = self.because(factor, sign, is_even);
            for &at in &because {
                self.used.insert(at);
            }
            let cited: Vec<String> = because.iter().map(|at| format!("[{}]", at + 1)).collect();
            let how = match cited.is_empty() {
                true => "inspection".to_owned(),
                false => words::list(cited),
            };
            // An even power is positive where the factor itself may be negative.
            let text = match sign == "> 0" && is_even && !self.shows(&because, factor, sign) {
                true => {
                    let power = raised(&format!("({shown})"), *exponent);
                    format!("where {shown} ≠ 0 by {how}, so {power} > 0")
                }
                false => format!("where {shown} {sign} by {how}"),
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
            self.shows(facts, factor, sign) || even && self.shows(facts, factor, "≠ 0")
        };
        for at in all.clone().into_iter().rev() {
            let fewer: Vec<usize> = all.iter().copied().filter(|&a| a != at).collect();
            if enough(&fewer) {
                all = fewer;
            }
        }
        all
    }

    /// Whether some facts show that a factor has a sign.
    fn shows(&self, facts: &[usize], factor: &Polynomial, sign: &str) -> bool {
        let chosen: Vec<Fact> = facts.iter().map(|&at| self.known[at].clone()).collect();
        let knowledge = Knowledge::new(&chosen);
        match sign {
            "≠ 0" => knowledge.is_nonzero(factor),
            "> 0" => knowledge.is_positive(factor),
            _ => knowledge.is_nonnegative(factor),
        }
    }
}
