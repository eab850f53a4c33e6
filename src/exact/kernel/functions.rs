//! What sines, exponentials and absolute values are known to be, and `\pi`.

use num_traits::ToPrimitive;

use super::{Claim, Knowledge, Origin, Problem, Reject, Sign};
use crate::algebra::{
    Atom, Expr, Formula, Fraction, Function, Polynomial, Rational, SineCosine, Symbol, Var,
    expr_of_fraction, multiplied,
};
use crate::sorted::{self, Map};

/// Angles and exponents that are multiples of one another are related up to this.
const HIGHEST_MULTIPLE: u32 = 8;

/// Whether `\pi` is the number in a claim: nobody declares it, and nothing gives it a value.
pub(crate) fn pi_is_the_number(claim: &Claim) -> bool {
    let pi = Symbol::new("\\pi");
    if claim.domains.contains_key(&pi) {
        return false;
    }
    let given = |formula: &Formula| {
        let symbol = |e: &Expr| matches!(e, Expr::Symbol(s) if *s == pi);
        let number = |e: &Expr| e.free_symbols().is_empty();
        let sides = formula.as_equation();
        sides.is_some_and(|(l, r)| symbol(l) && number(r) || symbol(r) && number(l))
    };
    // An index or a variable of that name is something else.
    let binds = |part: &Expr| part.binder() == Some(&pi);
    let something_else = |formula: &Formula| {
        let bound = formula.terms().iter().any(|term| term.any(&binds));
        bound || formula.sequences().contains(&pi)
    };
    // Most claims do not speak of it at all.
    let mentioned = |f: &Formula| f.terms().iter().any(|term| term.mentions(&pi));
    let named = |f: &Formula| mentioned(f) && f.free_symbols().contains(&pi);
    let mut hypotheses = claim.hypotheses.iter().map(|h| &*h.formula);
    claim.formulas().any(named) && !hypotheses.any(given) && !claim.formulas().any(something_else)
}

/// What is below π, and what is above.
pub(super) fn about_pi() -> (Rational, Rational) {
    (Rational::ratio(157, 50), Rational::ratio(63, 20))
}

impl Problem {
    /// Between which numbers `\pi` lies, where it is the number.
    pub(super) fn add_facts_about_pi(&mut self) {
        if self.pi_is_the_number() {
            let (below, above) = about_pi();
            let pi = Polynomial::var(self.atoms.var(Atom::Symbol(Symbol::new("\\pi"))));
            let above = Polynomial::constant(above).minus(&pi);
            self.learn(pi.minus(&Polynomial::constant(below)), Sign::Positive);
            self.learn(above, Sign::Positive);
        }
    }

    /// What is true of functions at every point where their terms have values; where an argument has none, there
    /// are values that make it true all the same, so that nothing is said of the argument.
    pub(super) fn add_facts_about_functions(&mut self) -> Result<(), Reject> {
        let called = |atom: &Atom| matches!(atom, Atom::Opaque(Expr::Call(..)));
        if !self.atoms.iter().any(|(_, atom)| called(atom)) {
            self.take_logarithms()?;
            self.add_facts_about_logarithms_of_numbers();
            return Ok(());
        }
        let knowledge = Knowledge::new(&self.facts);
        self.add_facts_about_logarithms(&knowledge)?;
        // Arguments that are multiples of one another, each with what it is a multiple of.
        let mut angles: Map<Expr, Vec<(Rational, Expr)>> = Map::new();
        let mut exponents: Map<Expr, Vec<(Rational, Var)>> = Map::new();
        // The partner of a sine or cosine is added on the way.
        let mut at = 0;
        loop {
            let next = self.atoms.iter().nth(at);
            let Some((var, atom)) = next.map(|(var, atom)| (var, atom.clone())) else {
                break;
            };
            at += 1;
            let Atom::Opaque(Expr::Call(function, argument)) = atom else {
                continue;
            };
            let value = self.lowering().lower(&argument)?;
            match function {
                Function::Sin | Function::Cos => {
                    let (size, unit) = self.split(&value)?;
                    let known = angles.entry(unit).or_default();
                    if known.iter().all(|(_, other)| *other != *argument) {
                        known.push((size, (*argument).clone()));
                        self.add_circle(&argument)?;
                    }
                }
                Function::Exp => {
                    let (size, unit) = self.split(&value)?;
                    exponents.entry(unit).or_default().push((size, var));
                    self.about_exponential(var, &value, &knowledge)?;
                }
                Function::Abs => {
                    if let Some(inner) = value.as_polynomial() {
                        self.about_absolute(var, inner, &knowledge)?;
                    }
                }
                _ => {}
            }
        }
        for related in angles.into_values() {
            self.relate_angles(related)?;
        }
        for related in exponents.into_values() {
            self.relate_exponentials(related)?;
        }
        self.take_logarithms()?;
        self.add_facts_about_logarithms_of_numbers();
        Ok(())
    }

    fn learn(&mut self, polynomial: Polynomial, sign: Sign) {
        self.add(polynomial, sign, Origin::Functions);
    }

    /// A value as a number times what begins with the coefficient 1.
    fn split(&self, value: &Fraction) -> Result<(Rational, Expr), Reject> {
        let lead = value.numerator().leading();
        let size = lead.map_or_else(Rational::one, |(_, c)| c.clone());
        let unit = value.times(&size.recip().into())?;
        Ok((size, expr_of_fraction(&unit, &self.atoms)))
    }

    fn sine_and_cosine(&mut self, argument: &Expr) -> (Polynomial, Polynomial) {
        let mut own = |function| {
            let call = Expr::Call(function, argument.clone().into());
            Polynomial::var(self.atoms.var(Atom::Opaque(call)))
        };
        (own(Function::Sin), own(Function::Cos))
    }

    /// `sin² + cos² = 1`, and neither is outside of `[−1, 1]`.
    fn add_circle(&mut self, argument: &Expr) -> Result<(), Reject> {
        let (sine, cosine) = self.sine_and_cosine(argument);
        let one = Polynomial::one();
        let circle = sine.pow(2)?.plus(&cosine.pow(2)?).minus(&one);
        self.learn(circle, Sign::Zero);
        for own in [sine, cosine] {
            self.learn(one.minus(&own), Sign::NonNegative);
            self.learn(one.plus(&own), Sign::NonNegative);
        }
        Ok(())
    }

    /// The sine and cosine of an angle by those of a part of it.
    fn relate_angles(&mut self, mut related: Vec<(Rational, Expr)>) -> Result<(), Reject> {
        sorted::sort(&mut related);
        for (at, (whole, of_whole)) in related.iter().enumerate() {
            let base = related[..at]
                .iter()
                .find_map(|(part, of_part)| Some((multiple(whole, part)?, of_part)));
            let Some((times, of_part)) = base else {
                continue;
            };
            let (sine, cosine) = self.sine_and_cosine(of_part);
            let own: SineCosine = (sine.into(), cosine.into());
            let expanded = multiplied(&own, times)?;
            let (sine, cosine) = self.sine_and_cosine(of_whole);
            for (own, expanded) in [(sine, expanded.0), (cosine, expanded.1)] {
                self.learn(own.minus(expanded.numerator()), Sign::Zero);
            }
        }
        Ok(())
    }

    /// `exp(k a) = exp(a)^k`.
    fn relate_exponentials(&mut self, mut related: Vec<(Rational, Var)>) -> Result<(), Reject> {
        sorted::sort(&mut related);
        for (at, (whole, of_whole)) in related.iter().enumerate() {
            let base = related[..at]
                .iter()
                .find_map(|(part, of_part)| Some((multiple(whole, part)?, *of_part)));
            if let Some((times, of_part)) = base {
                let power = Polynomial::var(of_part).pow(times)?;
                self.learn(Polynomial::var(*of_whole).minus(&power), Sign::Zero);
            }
        }
        Ok(())
    }

    /// `exp(a) > 0`; it is at least 1 where `a` is seen not to be negative, and at most where `a` is not positive.
    fn about_exponential(
        &mut self,
        var: Var,
        exponent: &Fraction,
        knowledge: &Knowledge,
    ) -> Result<(), Reject> {
        let own = Polynomial::var(var);
        self.learn(own.clone(), Sign::Positive);
        let sure = exponent.denominator().all(|(f, _)| knowledge.is_nonzero(f));
        if !sure {
            return Ok(());
        }
        let mut sign = exponent.numerator().clone();
        for (factor, times) in exponent.denominator() {
            if times % 2 == 1 {
                sign = sign.times(factor)?;
            }
        }
        let more = own.minus(&Polynomial::one());
        for (sign, more) in [
            (sign.clone(), more.clone()),
            (sign.negated(), more.negated()),
        ] {
            if knowledge.is_positive(&sign) {
                self.learn(more, Sign::Positive);
            } else if knowledge.is_nonnegative(&sign) {
                self.learn(more, Sign::NonNegative);
            }
        }
        Ok(())
    }

    /// `|p|² = p²`, `|p| ≥ ±p`, and which of both it is where the sign is seen.
    fn about_absolute(
        &mut self,
        var: Var,
        inner: &Polynomial,
        knowledge: &Knowledge,
    ) -> Result<(), Reject> {
        let own = Polynomial::var(var);
        let positive = knowledge.is_nonzero(inner);
        let sign = if positive {
            Sign::Positive
        } else {
            Sign::NonNegative
        };
        self.learn(own.clone(), sign);
        for side in [inner.clone(), inner.negated()] {
            if knowledge.is_nonnegative(&side) {
                self.learn(own.minus(&side), Sign::Zero);
                return Ok(());
            }
        }
        self.learn(own.pow(2)?.minus(&inner.pow(2)?), Sign::Zero);
        self.learn(own.minus(inner), Sign::NonNegative);
        self.learn(own.plus(inner), Sign::NonNegative);
        Ok(())
    }
}

/// How many times one number is another, where that is a few times.
fn multiple(whole: &Rational, part: &Rational) -> Option<u32> {
    let ratio = whole / part;
    let times = ratio.is_integer().then(|| ratio.numer().to_u32())?;
    times.filter(|k| (2..=HIGHEST_MULTIPLE).contains(k))
}
