//! Infinite sums of geometric terms, with powers of the index before them.
//!
//! $$ \sum_{k=a}^\infty k^m g(k) = g(a) \sum_{j=0}^{m} \binom{m}{j} a^{m-j} T_j, \qquad T_j = \sum_{k=0}^\infty k^j x^k $$
//!
//! where g(k+1) = x g(k) with |x| < 1. There T_0 is 1/(1 - x), and T_j, for j > 0, is x/(1 - x) times the sum of the C(j, i) T_i with i < j.

use super::lower::{LowerError, Lowered, Lowering, sign_of_fraction};
use super::series::with_index;
use super::{
    Atom, BigInt, Expr, Fraction, Function, Monomial, Polynomial, Powers, Rational, Symbol, Var,
    expr_of, expr_of_fraction,
};

/// The highest power of the index that is summed.
const HIGHEST_POWER: u32 = 8;

/// One term of an infinite sum, taken apart.
struct Geometric {
    /// What does not depend on the index.
    factor: Expr,
    /// The power of the index.
    power: u32,
    /// What is multiplied by the same from each index to the next.
    own: Expr,
    /// By what.
    ratio: Expr,
}

impl Lowering<'_> {
    /// The sum of `body` from `from` on, without end; `None` where it is not known whether it has a value, or which.
    pub(super) fn endless_sum(
        &mut self,
        index: &Symbol,
        from: &Expr,
        body: &Expr,
    ) -> Result<Option<Fraction>, LowerError> {
        let Some(functions) = self.functions else {
            return Ok(None);
        };
        let binds = |part: &Expr| part.binder().is_some();
        if body.has_elements() || body.any(&binds) || from.mentions(index) {
            return Ok(None);
        }
        let start = self.lower(from)?;
        let least = start.as_polynomial().and_then(|own| self.least(own));
        let Some(first) = least.filter(|&least| least >= 0) else {
            return Ok(None);
        };
        // The index is known to be a whole number in the body, and is no unknown of the claim.
        let known = with_index(functions, index, first);
        // Powers of it are taken apart even where others are read as they are written.
        let powers = Powers::default();
        let mut atoms = self.atoms.clone();
        let mut inside = Lowering {
            functions: Some(&known),
            powers: Some(self.powers.unwrap_or(&powers)),
            ..self.over(&mut atoms)
        };
        let value = inside.lower(body)?;
        let Some(terms) = inside.geometric_terms(&value, index)? else {
            return Ok(None);
        };
        let Some([divisors, bases]) = inside.conditions_outside(index) else {
            return Ok(None);
        };
        self.require(&divisors, &bases)?;
        let mut sum = Fraction::default();
        for term in terms {
            let Some(part) = self.geometric_sum(&term, index, from, &start)? else {
                return Ok(None);
            };
            sum = sum.plus(&part)?;
        }
        Ok(Some(sum))
    }

    /// The terms of a value; `None` where one is not geometric but for a power of the index.
    fn geometric_terms(
        &mut self,
        value: &Fraction,
        index: &Symbol,
    ) -> Result<Option<Vec<Geometric>>, LowerError> {
        let depends = |atom: &Atom| super::expr_of_atom(atom).mentions(index);
        let (mut still, mut below) = (Vec::new(), Vec::new());
        for (factor, exponent) in value.denominator() {
            let moves = (factor.vars().into_iter()).any(|var| depends(self.atoms.atom(var)));
            let factor = expr_of(factor, self.atoms);
            let factor = Expr::Power(factor.into(), Expr::integer(exponent).into());
            match moves {
                true => below.push(factor),
                false => still.push(factor),
            }
        }
        let quotient = |above, below: &[Expr]| {
            let below = Expr::Product(below.iter().cloned().collect());
            Expr::Quotient(Expr::into(above), below.into())
        };
        let next = Expr::Sum([Expr::Symbol(index.clone()), Expr::integer(1)].into());
        let mut terms = Vec::new();
        for (monomial, coefficient) in value.numerator().terms() {
            let (mut factor, mut own, mut power) = (Monomial::one(), Monomial::one(), 0);
            for &(var, exponent) in monomial.powers() {
                let this = Monomial::power(var, exponent);
                match self.atoms.atom(var) {
                    Atom::Symbol(symbol) if symbol == index => power = exponent,
                    atom if depends(atom) => own = own.times(&this),
                    _ => factor = factor.times(&this),
                }
            }
            let factor = expr_of(&Polynomial::term(factor, coefficient.clone()), self.atoms);
            let own = expr_of(&Polynomial::term(own, Rational::one()), self.atoms);
            let own = quotient(own, &below);
            let (this, then) = (
                self.lower(&own)?,
                self.lower(&own.substitute(index, &next))?,
            );
            let ratio = then.times(&super::function::inverse(&this)?)?;
            let moves = |own: &Polynomial| {
                let mut vars = own.vars().into_iter();
                vars.any(|var| depends(self.atoms.atom(var)))
            };
            let changes =
                moves(ratio.numerator()) || ratio.denominator().any(|(own, _)| moves(own));
            if changes || power > HIGHEST_POWER {
                return Ok(None);
            }
            terms.push(Geometric {
                factor: quotient(factor, &still),
                power,
                own,
                ratio: expr_of_fraction(&ratio, self.atoms),
            });
        }
        Ok(Some(terms))
    }

    /// The sum of one term; `None` where it has none.
    fn geometric_sum(
        &mut self,
        term: &Geometric,
        index: &Symbol,
        from: &Expr,
        start: &Fraction,
    ) -> Result<Option<Fraction>, LowerError> {
        let one = Fraction::from(Rational::one());
        let ratio = self.lower(&term.ratio)?;
        let bounds = match self.rate_of(&ratio)? {
            Some(rate) => vec![Fraction::default().minus(&rate)?],
            None => vec![one.minus(&ratio)?, one.plus(&ratio)?],
        };
        for bound in bounds {
            let sign = sign_of_fraction(&bound)?;
            match sign.as_constant() {
                Some(number) if number.is_positive() => {}
                Some(_) => return Ok(None),
                None => {
                    self.conditions.positive.insert(sign);
                }
            }
        }
        let over = self.recip(&one.minus(&ratio)?)?;
        let mut from_zero: Vec<Fraction> = vec![over.clone()];
        for power in 1..=term.power {
            let less = weighted(&from_zero, power, |_| Ok(one.clone()))?;
            from_zero.push(less.times(&ratio)?.times(&over)?);
        }
        let all = weighted(&from_zero, term.power, |own| {
            Ok(start.pow(term.power - own)?)
        })?;
        let begins = self.lower(&term.own.substitute(index, from))?;
        let factor = self.lower(&term.factor)?;
        Ok(Some(all.times(&begins)?.times(&factor)?))
    }

    /// `r`, where a value is a product of exponentials and so `e^r`.
    fn rate_of(&mut self, value: &Fraction) -> Result<Option<Fraction>, LowerError> {
        let mut factors: Vec<(Var, i64)> = Vec::new();
        let mut terms = value.numerator().terms();
        let (Some((above, coefficient)), None) = (terms.next(), terms.next()) else {
            return Ok(None);
        };
        factors.extend(above.powers().iter().map(|&(var, own)| (var, own.into())));
        for (factor, exponent) in value.denominator() {
            match super::function::alone(factor) {
                Some(var) => factors.push((var, -i64::from(exponent))),
                None => return Ok(None),
            }
        }
        if factors.is_empty() || *coefficient != Rational::one() {
            return Ok(None);
        }
        let mut rate = Fraction::default();
        for (var, exponent) in factors {
            let Atom::Opaque(Expr::Call(Function::Exp, own)) = self.atoms.atom(var).clone() else {
                return Ok(None);
            };
            let exponent = Rational::from(BigInt::from(exponent));
            rate = rate.plus(&self.lower(&own)?.times(&exponent.into())?)?;
        }
        Ok(Some(rate))
    }
}

/// Values times binomial coefficients C(m, j) and a weight for each j: of all values for j up to m that there are.
fn weighted(values: &[Fraction], m: u32, weight: impl Fn(u32) -> Lowered) -> Lowered {
    let mut sum = Fraction::default();
    let mut binomial = Rational::one();
    for (j, value) in (0..).zip(values) {
        let part = value.times(&weight(j)?)?;
        sum = sum.plus(&part.times(&binomial.clone().into())?)?;
        binomial *= Rational::from(m - j);
        binomial *= Rational::from(j + 1).recip();
    }
    Ok(sum)
}
