//! Sums over whole numbers. Between numbers they are written out; over the elements of a sequence they are power sums.
//!
//! Of sums up to a symbol, of terms with the index in them, `Σ_{i=1}^{n} i²`, `Σ_{i=0}^{n-1} r^i`, what does not depend on the index stands before the sum, and the upper limit has no number added to it:
//!
//! $$ \sum_{i=a}^{m+c} f(i) = \sum_{i=a}^{m} f(i) + f(m+1) + \dots + f(m+c) \qquad (m \ge a - 1) $$
//!
//! and the same with minus for negative `c`. What is left is an unknown, of which no more is known; its values are
//! found by induction.

use num_traits::ToPrimitive;

use super::lower::{LowerError, Lowered, Lowering};
use super::{
    Atom, BigRational, Expr, Fraction, Functions, Monomial, Polynomial, Rational, Symbol, Var,
    expr_of, expr_of_fraction,
};
use crate::sorted::Set;

/// Sums with definite limits are written out up to this many terms.
const MOST_EXPLICIT_TERMS: i64 = 512;
/// A limit with a larger number in it is left as it is.
const FARTHEST: i64 = 8;

/// A sum whose every term has a value, for every number of terms that there may be.
struct Run<'a> {
    index: &'a Symbol,
    first: i64,
    /// The upper limit without its number, and that.
    last: Expr,
    more: i64,
}

impl Lowering<'_> {
    /// The value of `whole`, which is the sum of `body` from `from` to `to`.
    pub(super) fn series(
        &mut self,
        whole: &Expr,
        index: &Symbol,
        from: &Expr,
        to: &Expr,
        body: &Expr,
    ) -> Lowered {
        let integer = |value: &Fraction| {
            let value = value.as_constant().filter(Rational::is_integer)?;
            value.numer().to_i64()
        };
        let (first, last) = (self.lower(from)?, self.lower(to)?);
        if let (Some(first), Some(last)) = (integer(&first), integer(&last)) {
            if last.saturating_sub(first) > MOST_EXPLICIT_TERMS {
                return Err(LowerError::TooLarge);
            }
            // A sequence begins at 1.
            let (Ok(first), Ok(last)) = (u32::try_from(first), u32::try_from(last.max(0))) else {
                return Ok(self.atom(Atom::Opaque(whole.clone())));
            };
            if first == 0 && body.has_elements() {
                return Ok(self.atom(Atom::Opaque(whole.clone())));
            }
            let mut sum = Fraction::default();
            for position in first..=last {
                sum = sum.plus(&self.lower(&body.at_index(index, position))?)?;
            }
            return Ok(sum);
        }
        let opaque = Atom::Opaque(whole.clone());
        if let Some(first) = integer(&first)
            && let Some(value) = self.running_sum(index, first, &last, body)?
        {
            return Ok(value);
        }
        let (Some(1), Expr::Symbol(count)) = (integer(&first), to) else {
            return Ok(self.atom(opaque));
        };
        if matches!(self.atom_of_symbol(count), Atom::Element { .. }) {
            return Ok(self.atom(opaque));
        }
        let outer = std::mem::take(&mut self.conditions);
        let body = self.lower(body)?;
        let inner = std::mem::replace(&mut self.conditions, outer);
        // What must hold for every element cannot be said of one.
        let bound = inner
            .polynomials()
            .any(|p| p.vars().iter().any(|&v| self.depends(v, index)));
        if !bound
            && inner.doubtful.is_empty()
            && let Some(value) = self.power_sums(&body, index, count)?
        {
            self.conditions.extend(inner);
            return Ok(value);
        }
        self.conditions.doubtful.insert(whole.clone());
        Ok(self.atom(opaque))
    }

    /// The sum of `body` from `first` to `last`; `None` where some term may have no value, or where there may be less
    /// than no terms.
    fn running_sum(
        &mut self,
        index: &Symbol,
        first: i64,
        last: &Fraction,
        body: &Expr,
    ) -> Result<Option<Fraction>, LowerError> {
        let (Some(functions), Some(last)) = (self.functions, last.as_polynomial()) else {
            return Ok(None);
        };
        let Some(least) = self.least(last).filter(|&l| first >= 0 && l >= first - 1) else {
            return Ok(None);
        };
        // What is put in for the index might be caught by something bound.
        let binds = |part: &Expr| part.binder().is_some();
        if body.has_elements() || body.any(&binds) || !mentions_symbol(body, index) {
            return Ok(None);
        }
        let own = |var: &Var| matches!(self.atoms.atom(*var), Atom::Symbol(own) if own == index);
        if last.vars().iter().any(own) {
            return Ok(None);
        }
        let more = last.terms().find(|(m, _)| m.is_one());
        let more = more.and_then(|(_, c)| c.numer().to_i64()).unwrap_or(0);
        let splits = more.abs() <= FARTHEST && least - more >= first - 1;
        let more = if splits { more } else { 0 };
        let count = last.minus(&Polynomial::constant(number(first - 1)));
        let kept = last.minus(&Polynomial::constant(number(more)));
        let run = Run {
            index,
            first,
            last: expr_of(&kept, self.atoms),
            more,
        };
        // The index is known to be a whole number in the body, and is no unknown of the claim.
        let known = with_index(functions, index, first);
        let mut atoms = self.atoms.clone();
        let mut inside = Lowering {
            functions: Some(&known),
            ..self.over(&mut atoms)
        };
        let value = inside.lower(body)?;
        let Some([divisors, bases]) = inside.conditions_outside(index) else {
            return Ok(None);
        };
        // Of no terms at all nothing is learnt.
        if least < first && !(divisors.is_empty() && bases.is_empty()) {
            return Ok(None);
        }
        self.require(&divisors, &bases)?;
        let depends = |var: Var| match atoms.atom(var) {
            Atom::Symbol(own) | Atom::Root { of: own, .. } => own == index,
            atom => super::expr_of_atom(atom).mentions(index),
        };
        let moving = |polynomial: &Polynomial| polynomial.vars().into_iter().any(depends);
        if value.denominator().any(|(factor, _)| moving(factor)) {
            let whole = expr_of_fraction(&value, &atoms);
            return self.sum_of(&run, &whole).map(Some);
        }
        let mut sum = Fraction::default();
        for (monomial, coefficient) in value.numerator().terms() {
            let powers = monomial.powers().iter();
            let (own, other): (Vec<_>, Vec<_>) = powers.partition(|&&(var, _)| depends(var));
            let product = |powers: Vec<&(Var, u32)>, coefficient: &Rational| {
                let powers = powers.into_iter();
                let all = powers.fold(Monomial::one(), |all, &(var, exponent)| {
                    all.times(&Monomial::power(var, exponent))
                });
                expr_of(&Polynomial::term(all, coefficient.clone()), &atoms)
            };
            let part = match own.is_empty() {
                true => Fraction::from(count.clone()),
                false => self.sum_of(&run, &product(own, &Rational::one()))?,
            };
            let factor = self.lower(&product(other, coefficient))?;
            sum = sum.plus(&part.times(&factor)?)?;
        }
        let below = Fraction::from(value.expanded_denominator()?);
        let below = expr_of_fraction(&below, &atoms);
        let below = self.lower(&below)?;
        Ok(Some(sum.times(&self.recip(&below)?)?))
    }

    /// The sum of one term: an unknown up to the limit without its number, and the terms that are left.
    fn sum_of(&mut self, run: &Run, body: &Expr) -> Result<Fraction, LowerError> {
        let series = Expr::Series {
            index: run.index.clone(),
            from: Expr::integer(run.first).into(),
            to: run.last.clone().into(),
            body: body.clone().into(),
        };
        let mut sum = self.atom(Atom::Opaque(series));
        for ahead in run.more.min(0) + 1..=run.more.max(0) {
            let position = match ahead {
                0 => run.last.clone(),
                _ => Expr::Sum([run.last.clone(), Expr::integer(ahead)].into()),
            };
            let term = self.lower(&body.substitute(run.index, &position))?;
            sum = match run.more > 0 {
                true => sum.plus(&term)?,
                false => sum.minus(&term)?,
            };
        }
        Ok(sum)
    }

    /// The divisors and the bases that a term needs not to be 0 beside what it needs of its index, which it is seen to
    /// have from the first value on; `None` where it needs anything else.
    pub(super) fn conditions_outside(&self, index: &Symbol) -> Option<[Vec<Expr>; 2]> {
        let conditions = &self.conditions;
        let limits = !conditions.zero.is_empty() || !conditions.away.is_empty();
        let others = limits || !conditions.doubtful.is_empty();
        if others || !conditions.nonnegative.is_empty() || !conditions.positive.is_empty() {
            return None;
        }
        let outside = |divisors: &Set<Polynomial>| {
            let sure = |divisor: &&Polynomial| {
                self.is_plainly_positive(divisor)
                    || self.least(divisor).is_some_and(|least| least > 0)
            };
            let others = divisors.iter().filter(|divisor| !sure(divisor));
            let written = others.map(|divisor| expr_of(divisor, self.atoms));
            let written = written.map(|own| (!own.mentions(index)).then_some(own));
            written.collect::<Option<Vec<Expr>>>()
        };
        Some([outside(&conditions.nonzero)?, outside(&conditions.bases)?])
    }

    /// Takes up as conditions here the divisors and the bases that a term with an index needs not to be 0.
    pub(super) fn require(&mut self, divisors: &[Expr], bases: &[Expr]) -> Result<(), LowerError> {
        for divisor in divisors {
            let divisor = self.lower(divisor)?;
            self.conditions.nonzero.insert(divisor.numerator().clone());
        }
        for base in bases {
            let base = self.lower(base)?;
            self.conditions.bases.insert(base.numerator().clone());
        }
        Ok(())
    }

    /// The least value of a sum of multiples of whole numbers that are known not to be negative; `None` for other terms.
    pub(super) fn least(&self, polynomial: &Polynomial) -> Option<i64> {
        let known = self.functions?;
        polynomial.terms().try_fold(0i64, |sum, (monomial, own)| {
            let own = own.is_integer().then(|| own.numer().to_i64())??;
            let least = match monomial.powers() {
                [] => own,
                [(var, 1)] => match self.atoms.atom(*var) {
                    Atom::Symbol(symbol) if own > 0 && known.naturals.contains(symbol) => {
                        own * i64::from(known.positive.contains(symbol))
                    }
                    _ => return None,
                },
                _ => return None,
            };
            sum.checked_add(least)
        })
    }
}

fn number(value: i64) -> Rational {
    BigRational::from_integer(value.into()).into()
}

/// What is known in the body of a sum.
pub(super) fn with_index(known: &Functions, index: &Symbol, first: i64) -> Functions {
    let mut known = known.clone();
    known.naturals.insert(index.clone());
    known.integers.insert(index.clone());
    match first > 0 {
        true => known.positive.insert(index.clone()),
        false => known.positive.remove(index),
    };
    known
}

/// Whether a symbol stands in a term by itself, and not as the index of an element.
pub fn mentions_symbol(term: &Expr, symbol: &Symbol) -> bool {
    term.any(&|part| matches!(part, Expr::Symbol(own) if own == symbol))
}
