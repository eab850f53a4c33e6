//! Counterexamples to claims about every index: some first elements, and why there are more.
//!
//! At one index the premises may be true and the goal false by values that no sequence goes through. So the premises are
//! asked for at every index up to the one in question, and must be equations that give each later element from
//! those before it, within its domain.

use num_traits::{Signed, Zero};

use super::{ForEvery, Instance};
use crate::algebra::{BigRational, Expr, Formula, Function, Moved, Place, Symbol, element_at};
use crate::kernel::{
    Assignment, Candidate, Checked, Claim, Domain, Hypothesis, Refuted, Reject, Standing, check,
};
use crate::sorted::{Map, Set};

/// Counterexamples do not go through more elements.
const MOST_ELEMENTS: u32 = 32;

/// Decides whether a point refutes a claim about every index, at the index `at`. The point has values for the index,
/// for what stands at it, and for the first elements by their numbers.
///
/// # Errors
/// The first reason found for which it does not.
pub fn refute_for_every(claim: &ForEvery, at: u32, point: Assignment) -> Result<Refuted, Reject> {
    claim.goes_on(at, &point)?;
    let unrolled = claim.unrolled(at)?;
    match check(unrolled, Candidate::Counterexample(point))? {
        Checked::Refuted(refuted) => Ok(refuted),
        Checked::Proven(_) => Err(Reject::WrongKind),
    }
}

impl ForEvery {
    /// The instances that say something of elements up to those of which anything is said at index `at`.
    ///
    /// # Errors
    /// A hypothesis cannot be taken at an index.
    pub fn first_instances(&self, at: u32) -> Result<Vec<Instance>, Reject> {
        let start = self.start()?;
        if at.saturating_sub(start) + self.last_offset() > MOST_ELEMENTS {
            return Err(Reject::TooLarge);
        }
        let mut instances = Vec::new();
        for &hypothesis in &self.throughout {
            if self.is_constant(hypothesis) {
                continue;
            }
            for number in start..=at + self.last_offset() {
                let at = Moved::To(number);
                let instance = Instance { hypothesis, at };
                match self.instance(instance, start) {
                    Ok(_) => instances.push(instance),
                    Err(Reject::OutOfRange(_)) => {}
                    Err(reject) => return Err(reject),
                }
            }
        }
        Ok(instances)
    }

    /// What stands at the running index in the claim, each with the name that it has by its number.
    pub fn links(&self, at: u32) -> Vec<(Symbol, Symbol)> {
        let symbols = Formula::free_symbols_of(self.claim.formulas());
        let named = symbols.into_iter().filter_map(|symbol| {
            let (stem, Place::Running(offset)) = symbol.place(&self.index)? else {
                return None;
            };
            let numbered = element_at(&stem, &self.index, offset, Moved::To(at))?;
            Some((symbol.clone(), numbered))
        });
        named.collect()
    }

    /// The claim at one index, with all that the premises say of the elements before it.
    fn unrolled(&self, at: u32) -> Result<Claim, Reject> {
        let start = self.start()?;
        let mut claim = self.claim.clone();
        let mut suppose = |formula: Formula, standing| {
            let formula = formula.into();
            claim.hypotheses.push(Hypothesis { formula, standing });
        };
        let index = Expr::Symbol(self.index.clone());
        suppose(Formula::equal(index, Expr::integer(at)), Standing::AtPoint);
        for (running, numbered) in self.links(at) {
            let equal = Formula::equal(Expr::Symbol(running), Expr::Symbol(numbered));
            suppose(equal, Standing::AtPoint);
        }
        for instance in self.first_instances(at)? {
            let own = self.instance(instance, start)?;
            claim.hypotheses.push(own);
        }
        let symbols: Vec<Symbol> = claim.free_symbols().into_iter().cloned().collect();
        for symbol in symbols {
            if let Some((stem, Place::Number(number))) = symbol.place(&self.index)
                && number >= start
                && let Some(domain) = self.elements.get(&stem)
            {
                claim
                    .domains
                    .entry(symbol)
                    .or_insert_with(|| domain.clone());
            }
        }
        Ok(claim)
    }

    /// The greatest offset from the index anywhere in the claim.
    pub(super) fn last_offset(&self) -> u32 {
        let symbols = Formula::free_symbols_of(self.claim.formulas()).into_iter();
        let offsets = symbols.filter_map(|s| match s.place(&self.index)?.1 {
            Place::Running(offset) => u32::try_from(offset).ok(),
            _ => None,
        });
        offsets.max().unwrap_or(0)
    }

    /// Whether elements that satisfy the premises up to an index can be followed by others for ever.
    fn goes_on(&self, at: u32, point: &Assignment) -> Result<(), Reject> {
        let covered = at + self.last_offset();
        for symbol in Formula::free_symbols_of(self.claim.formulas()) {
            match symbol.place(&self.index) {
                Some((stem, Place::Number(number)))
                    if number > covered && self.is_running(&stem) =>
                {
                    return Err(Reject::MayEnd);
                }
                // What is declared for `E_{n+1}` alone is not looked at.
                Some((stem, Place::Running(offset)))
                    if offset != 0
                        && self.claim.domains.get(symbol).is_some_and(|own| {
                            *own != Domain::default() && self.elements.get(&stem) != Some(own)
                        }) =>
                {
                    return Err(Reject::MayEnd);
                }
                Some((_, Place::Unclear)) => return Err(Reject::Unmovable),
                _ => {}
            }
        }
        let dependent = self.throughout.iter().filter(|at| !self.is_constant(**at));
        let mut open: Vec<&Formula> = dependent
            .filter_map(|&at| self.claim.hypotheses.get(at))
            .map(|h| &*h.formula)
            .collect();
        let varying = self.varying();
        for formula in &open {
            // Symbols that may depend on the index would be wanted for each of them.
            self.elsewhere(formula, Moved::By(0), &varying)?;
        }
        let mut laws: Map<Symbol, Expr> = Map::new();
        while let Some((at, stem, term)) = self.next_of(&open, &laws) {
            laws.insert(stem, term);
            open.remove(at);
        }
        // What no equation gives stays as it is, if what is said of it says nothing of the index alone.
        for formula in open {
            for symbol in formula.free_symbols() {
                let stem = symbol.place(&self.index).map(|(stem, _)| stem);
                let runs = stem.filter(|stem| self.is_running(stem));
                let moves = runs.is_some_and(|stem| {
                    laws.contains_key(&stem) || self.still(&stem, point).is_none()
                });
                if symbol == self.index || moves {
                    return Err(Reject::MayEnd);
                }
            }
        }
        let stay = laws.iter().all(|(stem, term)| {
            let free = |other: &Symbol| !laws.contains_key(other);
            self.stays(stem, term, free, point)
        });
        match stay {
            true => Ok(()),
            false => Err(Reject::MayEnd),
        }
    }

    /// The one value that all elements of a sequence have at a point.
    fn still(&self, stem: &Symbol, point: &Assignment) -> Option<BigRational> {
        let elements = point.symbols.iter().filter(|(symbol, _)| {
            let place = symbol.place(&self.index);
            place.is_some_and(|(own, _)| own == *stem)
        });
        let mut values = elements.map(|(_, value)| value);
        let first = values.next()?;
        values.all(|value| value == first).then(|| first.clone())
    }

    /// The first formula that gives the elements of a sequence of which no other says how it goes on.
    fn next_of(
        &self,
        open: &[&Formula],
        laws: &Map<Symbol, Expr>,
    ) -> Option<(usize, Symbol, Expr)> {
        open.iter().enumerate().find_map(|(at, formula)| {
            let others = open.iter().enumerate().filter(|(other, _)| *other != at);
            let sides = others.filter_map(|(_, other)| other.as_equation());
            let alone: Set<Symbol> = sides
                .flat_map(|(left, right)| [left, right])
                .filter_map(|side| Some(self.alone(side)?.0))
                .collect();
            let (left, right) = formula.as_equation()?;
            let solved = |side: &Expr, term: &Expr| {
                let (stem, offset) = self.alone(side)?;
                let before = |s: &Symbol| match s.place(&self.index) {
                    Some((other, Place::Running(own))) => {
                        let known = laws.contains_key(&other) || !alone.contains(&other);
                        own < offset || own == offset && other != stem && known
                    }
                    Some((_, Place::Unclear)) => false,
                    _ => true,
                };
                let fine = term.free_symbols().iter().all(before) && self.has_value(term);
                let term = term.clone();
                (fine && !laws.contains_key(&stem)).then_some((at, stem, term))
            };
            solved(left, right).or_else(|| solved(right, left))
        })
    }

    /// `X` and 1, for `X_{n+1}`.
    fn alone(&self, side: &Expr) -> Option<(Symbol, i64)> {
        match side {
            Expr::Symbol(symbol) => match symbol.place(&self.index)? {
                (stem, Place::Running(offset)) => Some((stem, offset)),
                _ => None,
            },
            _ => None,
        }
    }

    /// Whether a term that has a value for one index has one for every later one, whatever the elements are.
    fn has_value(&self, term: &Expr) -> bool {
        if !term.depends_on(&self.index) {
            return true;
        }
        match term {
            Expr::Symbol(_) => true,
            Expr::Sum(parts) | Expr::Product(parts) => parts.iter().all(|p| self.has_value(p)),
            Expr::Negate(inner)
            | Expr::Call(Function::Sin | Function::Cos | Function::Exp | Function::Abs, inner) => {
                self.has_value(inner)
            }
            Expr::Quotient(above, below) => self.has_value(above) && !below.depends_on(&self.index),
            Expr::Power(base, exponent) => self.has_value(base) && self.is_natural(exponent),
            _ => false,
        }
    }

    /// Whether an exponent is a whole number and not negative, whatever the index is.
    fn is_natural(&self, exponent: &Expr) -> bool {
        match exponent {
            Expr::Number(value) => value.is_integer() && !value.is_negative(),
            Expr::Symbol(symbol) => *symbol == self.index,
            Expr::Sum(parts) | Expr::Product(parts) => parts.iter().all(|p| self.is_natural(p)),
            _ => false,
        }
    }

    /// Whether the value of a term is one that an element may have. What is `free` may stay as it is.
    fn stays(
        &self,
        stem: &Symbol,
        term: &Expr,
        free: impl Fn(&Symbol) -> bool,
        point: &Assignment,
    ) -> bool {
        let Some(domain) = self.elements.get(stem) else {
            return true;
        };
        let zero = |bound: &(BigRational, bool)| bound.0.is_zero();
        if domain.integer || domain.upper.is_some() || domain.lower.iter().any(|b| !zero(b)) {
            return false;
        }
        let strict = domain.lower.as_ref().map(|bound| bound.1);
        if strict.is_none() && !domain.nonzero {
            return true;
        }
        let mut known = term.clone();
        for symbol in term.free_symbols() {
            let value = match symbol.place(&self.index) {
                Some((other, Place::Running(_))) if free(&other) => self.still(&other, point),
                Some((_, Place::Running(_))) => None,
                _ if symbol == self.index => None,
                _ => point.symbols.get(&symbol).cloned(),
            };
            if let Some(value) = value {
                known = known.substitute(&symbol, &Expr::Number(value));
            }
        }
        let sign = self.sign(&known);
        match strict {
            Some(true) => sign == Some(true),
            Some(false) if domain.nonzero => sign == Some(true),
            Some(false) => sign.is_some(),
            None => sign == Some(true),
        }
    }

    /// Whether a term is seen to be positive, or at least not negative.
    fn sign(&self, term: &Expr) -> Option<bool> {
        let of_domain = |domain: &Domain| match domain.is_positive() {
            true => Some(true),
            false => {
                let lower = domain.lower.as_ref();
                lower.filter(|bound| !bound.0.is_negative()).map(|_| false)
            }
        };
        match term {
            Expr::Number(value) => (!value.is_negative()).then(|| value.is_positive()),
            Expr::Symbol(symbol) => match symbol.place(&self.index) {
                Some((stem, _)) => self.elements.get(&stem).and_then(of_domain),
                None => self.claim.domains.get(symbol).and_then(of_domain),
            },
            Expr::Sum(parts) => {
                let signs: Option<Vec<bool>> = parts.iter().map(|p| self.sign(p)).collect();
                Some(signs?.into_iter().any(|positive| positive))
            }
            Expr::Product(parts) => {
                let signs: Option<Vec<bool>> = parts.iter().map(|p| self.sign(p)).collect();
                Some(signs?.into_iter().all(|positive| positive))
            }
            Expr::Quotient(above, below) => {
                let above = self.sign(above)?;
                (self.sign(below)? || !below.depends_on(&self.index)).then_some(above)
            }
            Expr::Power(base, exponent) => match (&**base, &**exponent) {
                // `0^0` is 1, and other powers of 0 are 0.
                (Expr::Number(value), Expr::Number(own)) if even(own) => Some(!value.is_zero()),
                (_, Expr::Number(own)) if even(own) => Some(self.sign(base) == Some(true)),
                _ => self.sign(base),
            },
            Expr::Call(Function::Exp, _) => Some(true),
            _ => None,
        }
    }
}

/// Whether a number is an even whole one.
fn even(value: &BigRational) -> bool {
    value.is_integer() && (value / BigRational::from_integer(2.into())).is_integer()
}

/// A point at which everything has a value that stands at the running index, from the values of the elements.
pub fn at_the_index(claim: &ForEvery, at: u32, mut point: Assignment) -> Assignment {
    let value = BigRational::from_integer(at.into());
    point.symbols.insert(claim.index.clone(), value);
    let links: Map<Symbol, Symbol> = claim.links(at).into_iter().collect();
    for (running, numbered) in links {
        if let Some(value) = point.symbols.get(&numbered).cloned() {
            point.symbols.insert(running, value);
        }
    }
    point
}
