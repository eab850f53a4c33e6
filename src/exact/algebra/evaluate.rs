//! Terms evaluated at a point, in exact numbers, as naively as can be.
//!
//! Nothing is expanded or simplified here, and derivatives are taken by Taylor's series at the point rather than by
//! rewriting: it shares next to nothing with [`Lowering`], which the proofs rest on, so that each can be held against
//! the other.

use std::fmt;

use num_traits::{One, Signed, ToPrimitive, Zero};

use super::{
    Atoms, BigInt, BigRational, Expr, Formula, Function, Lowering, Polynomial, Rational, Relation,
    Symbol, effort, element_parts, element_symbol, expr_of_atom,
};
use crate::sorted::{Map, Set};

/// A definite sum longer than this is not written out.
const LONGEST_SUM: i64 = 512;
/// What a term of such a sum takes of the work that may be done: sums of sums of sums have very many.
const TERM_OF_SUM: usize = 64;
/// A power higher than this is not multiplied out.
const HIGHEST_POWER: u32 = 1024;
/// Definitions that lead to one another more often than this are taken to go in a circle.
const DEEPEST: usize = 64;

/// Exact values for the symbols of a term.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Values {
    /// The value of each symbol.
    pub symbols: Map<Symbol, BigRational>,
    /// The elements of each sequence, from the first.
    pub sequences: Map<Symbol, Vec<BigRational>>,
    /// Symbols that are given by a term in other symbols; one that has a value of its own keeps it.
    pub terms: Map<Symbol, Expr>,
    /// The value of `ds/dx`, for a symbol `s` that no term gives.
    pub slopes: Map<(Symbol, Symbol), BigRational>,
    /// The second derivative of a symbol and those above it, where its slope is given.
    pub higher: Map<(Symbol, Symbol), Vec<BigRational>>,
    /// The symbols that depend on no variable.
    pub constants: Set<Symbol>,
    /// A symbol whose slope is not known does not vary; otherwise that is an error.
    pub still: bool,
}

/// Both sides of a relation at a point.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sides {
    /// The value of the left side.
    pub left: BigRational,
    /// How it is said to be related to the right side.
    pub relation: Relation,
    /// The value of the right side.
    pub right: BigRational,
    /// Whether it is.
    pub holds: bool,
}

/// Why a term has no value at a point.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum EvaluateError {
    /// The point says nothing of a symbol.
    Missing(Symbol),
    /// The point's list for a sequence is too short.
    NoElement {
        /// The sequence.
        sequence: Symbol,
        /// The position that is needed, from 1.
        position: u32,
        /// How many elements there are.
        length: usize,
    },
    /// A derivative is asked for and nothing is said of how a symbol varies.
    NoSlope {
        /// The symbol.
        symbol: Symbol,
        /// The variable of differentiation.
        variable: Symbol,
    },
    /// The divisor, which is 0.
    DivisionByZero(Expr),
    /// A root that is not rational, or not real.
    NotRational(Expr),
    /// The limit of a sum or a position that is not a whole number.
    NotWhole(Expr),
    /// A sum or power that is too large to be written out.
    TooLarge(Expr),
    /// A kind of term that is not evaluated.
    Unsupported(Expr),
    /// A relation that numbers alone do not decide: scaling, being much less.
    Undecidable(Relation),
    /// Symbols are defined by one another.
    Circular(Symbol),
    /// A name that is not that of a symbol, or a term that cannot be read.
    Unreadable {
        /// As it was written.
        text: String,
        /// What is wrong with it.
        message: String,
    },
    /// There is no equation of this number or name.
    NoEquation(String),
}

impl fmt::Display for EvaluateError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            EvaluateError::Missing(symbol) => write!(f, "`{symbol}` has no value at this point"),
            EvaluateError::NoElement {
                sequence,
                position,
                length,
            } => write!(
                f,
                "`{sequence}` has {length} elements at this point, and element {position} is needed"
            ),
            EvaluateError::NoSlope { symbol, variable } => write!(
                f,
                "nothing at this point says how `{symbol}` depends on `{variable}`"
            ),
            EvaluateError::DivisionByZero(_) => f.write_str("something is divided by 0"),
            EvaluateError::NotRational(_) => f.write_str("a root is not a rational number here"),
            EvaluateError::NotWhole(_) => f.write_str("a position is not a whole number here"),
            EvaluateError::TooLarge(_) => f.write_str("a sum or power is too large to write out"),
            EvaluateError::Unsupported(_) => {
                f.write_str("a term is of a kind that is not evaluated")
            }
            EvaluateError::Undecidable(_) => {
                f.write_str("the relation is not one that two numbers decide")
            }
            EvaluateError::Circular(symbol) => {
                write!(f, "`{symbol}` is defined by way of itself")
            }
            EvaluateError::Unreadable { text, message } => {
                write!(f, "`{text}` cannot be read: {message}")
            }
            EvaluateError::NoEquation(label) => {
                write!(f, "there is no equation of the number or name `{label}`")
            }
        }
    }
}

impl std::error::Error for EvaluateError {}

/// The coefficients of Taylor's series at the point, the value first.
type Series = Vec<BigRational>;

impl Values {
    /// The value of a term.
    ///
    /// # Errors
    /// It has none at this point, or is of a kind that is not evaluated.
    pub fn value(&self, term: &Expr) -> Result<BigRational, EvaluateError> {
        let start = Along {
            variable: None,
            order: 0,
            depth: 0,
            bare: false,
        };
        Ok(self.series(term, start)?.swap_remove(0))
    }

    /// Both sides of what a formula states: one relation, or one for each element that is said to be equal.
    ///
    /// # Errors
    /// A side has no value, or the relation is not one between numbers.
    pub fn sides(&self, formula: &Formula) -> Result<Vec<Sides>, EvaluateError> {
        match formula {
            Formula::Relation {
                left,
                relation,
                right,
            } => {
                let (left, right) = (self.value(left)?, self.value(right)?);
                let holds = compare(&left, *relation, &right)?;
                Ok(vec![Sides {
                    left,
                    relation: *relation,
                    right,
                    holds,
                }])
            }
            Formula::AllEqual {
                sequence,
                to,
                value,
            } => {
                let last = self.whole(to)?;
                let last = u32::try_from(last)
                    .ok()
                    .filter(|&last| i64::from(last) <= LONGEST_SUM)
                    .ok_or_else(|| EvaluateError::TooLarge(to.clone()))?;
                let element = |at| self.value(&Expr::Symbol(element_symbol(sequence, at)));
                let (first, right) = match value {
                    Some(value) => (1, self.value(value)?),
                    None => (2, element(1)?),
                };
                let sides = (first..=last).map(|at| {
                    let left = element(at)?;
                    Ok(Sides {
                        holds: left == right,
                        left,
                        relation: Relation::Equal,
                        right: right.clone(),
                    })
                });
                sides.collect()
            }
        }
    }

    /// Whether a formula is true.
    ///
    /// # Errors
    /// As [`Values::sides`].
    pub fn holds(&self, formula: &Formula) -> Result<bool, EvaluateError> {
        Ok(self.sides(formula)?.iter().all(|sides| sides.holds))
    }

    fn whole(&self, term: &Expr) -> Result<i64, EvaluateError> {
        let value = self.value(term)?;
        match value.is_integer() {
            true => value
                .to_i64()
                .ok_or_else(|| EvaluateError::TooLarge(term.clone())),
            false => Err(EvaluateError::NotWhole(term.clone())),
        }
    }

    fn series(&self, term: &Expr, along: Along<'_>) -> Result<Series, EvaluateError> {
        match term {
            Expr::Number(value) => Ok(along.constant(value.clone())),
            Expr::Symbol(symbol) => self.symbol(symbol, along),
            Expr::Sum(terms) => {
                let mut sum = along.constant(BigRational::zero());
                for term in terms.iter() {
                    add(&mut sum, &self.series(term, along)?);
                }
                Ok(sum)
            }
            Expr::Product(factors) => {
                let Some((first, rest)) = factors.split_first() else {
                    return Ok(along.constant(BigRational::one()));
                };
                let mut product = self.series(first, along)?;
                for factor in rest {
                    product = multiply(&product, &self.series(factor, along)?);
                }
                Ok(product)
            }
            Expr::Negate(inner) => Ok(self.series(inner, along)?.into_iter().map(|c| -c).collect()),
            Expr::Quotient(above, below) => {
                let divisor = self.series(below, along)?;
                let inverse = reciprocal(&divisor)
                    .ok_or_else(|| EvaluateError::DivisionByZero((**below).clone()))?;
                Ok(multiply(&self.series(above, along)?, &inverse))
            }
            Expr::Power(base, exponent) => {
                let power = self.series(exponent, along)?;
                if power[1..].iter().any(|c| !c.is_zero()) {
                    return Err(EvaluateError::Unsupported(term.clone()));
                }
                raise(term, base, &self.series(base, along)?, &power[0])
            }
            Expr::Series {
                index,
                from,
                to,
                body,
            } => {
                let (from, to) = (self.whole(from)?, self.whole(to)?);
                if to.saturating_sub(from) > LONGEST_SUM {
                    return Err(EvaluateError::TooLarge(term.clone()));
                }
                let mut sum = along.constant(BigRational::zero());
                for at in from..=to {
                    effort::spend(TERM_OF_SUM);
                    if effort::is_spent() {
                        return Err(EvaluateError::TooLarge(term.clone()));
                    }
                    let at =
                        u32::try_from(at).map_err(|_| EvaluateError::NotWhole(term.clone()))?;
                    add(&mut sum, &self.series(&body.at_index(index, at), along)?);
                }
                Ok(sum)
            }
            Expr::Call(function, argument) => {
                let argument = self.series(argument, along)?;
                let constant = argument[1..].iter().all(Zero::is_zero);
                match function {
                    Function::Abs if constant => Ok(along.constant(argument[0].abs())),
                    Function::Abs if !argument[0].is_zero() => {
                        let sign = argument[0].signum();
                        Ok(argument.into_iter().map(|c| c * &sign).collect())
                    }
                    Function::Ceiling if constant => Ok(along.constant(argument[0].ceil())),
                    Function::Floor if constant => Ok(along.constant(argument[0].floor())),
                    _ => Err(EvaluateError::Unsupported(term.clone())),
                }
            }
            Expr::Derivative { body, variable } => {
                if along.order > 0 && along.variable != Some(variable) {
                    return Err(EvaluateError::Unsupported(term.clone()));
                }
                let inner = Along {
                    variable: Some(variable),
                    order: along.order + 1,
                    bare: matches!(**body, Expr::Symbol(_)),
                    ..along
                };
                let series = self.series(body, inner)?.into_iter().enumerate().skip(1);
                Ok(series
                    .map(|(n, c)| c * BigRational::from_integer(n.into()))
                    .collect())
            }
            Expr::Limit { .. } | Expr::Integral { .. } | Expr::Partial { .. }
                if along.order == 0 =>
            {
                Ok(vec![self.worked_out(term)?])
            }
            Expr::Limit { .. }
            | Expr::Element { .. }
            | Expr::Apply(..)
            | Expr::Integral { .. }
            | Expr::Partial { .. } => Err(EvaluateError::Unsupported(term.clone())),
        }
    }

    fn symbol(&self, symbol: &Symbol, along: Along<'_>) -> Result<Series, EvaluateError> {
        let known = self.symbols.get(symbol);
        let term = self.terms.get(symbol);
        let deeper = |term: &Expr| {
            if along.depth == DEEPEST {
                return Err(EvaluateError::Circular(symbol.clone()));
            }
            let depth = along.depth + 1;
            let bare = false;
            self.series(
                term,
                Along {
                    depth,
                    bare,
                    ..along
                },
            )
        };
        let variable = along.variable.filter(|_| along.order > 0);
        let Some(variable) = variable else {
            return match (known, term) {
                (Some(value), _) => Ok(vec![value.clone()]),
                (None, Some(term)) => deeper(term),
                (None, None) => Ok(vec![self.element(symbol)?]),
            };
        };
        let key = (symbol.clone(), variable.clone());
        let slope = self.slopes.get(&key);
        let higher = self.higher.get(&key).map_or(&[][..], Vec::as_slice);
        let slope = match slope {
            _ if symbol == variable => Some(BigRational::one()),
            Some(slope) if along.order <= 1 + higher.len() => Some(slope.clone()),
            // What higher derivatives a symbol has is not said.
            Some(_) => None,
            None if self.constants.contains(symbol) => Some(BigRational::zero()),
            None => match term {
                Some(term) => return deeper(term),
                None => self.still.then(BigRational::zero),
            },
        };
        let slope = slope.ok_or_else(|| EvaluateError::NoSlope {
            symbol: symbol.clone(),
            variable: variable.clone(),
        })?;
        // By itself under a derivative a symbol need not have a value.
        let value = match (known, term) {
            (Some(value), _) => value.clone(),
            (None, Some(term)) => self.value(term)?,
            (None, None) => match self.element(symbol) {
                Err(EvaluateError::Missing(_)) if along.bare && symbol != variable => {
                    BigRational::zero()
                }
                value => value?,
            },
        };
        let mut series = along.constant(value);
        series[1] = slope;
        // Of Taylor's series the n-th coefficient is the n-th derivative over n!.
        let mut factorial = BigRational::one();
        for ((order, coefficient), own) in (2..).zip(series.iter_mut().skip(2)).zip(higher) {
            factorial *= BigRational::from_integer(BigInt::from(order));
            *coefficient = own / &factorial;
        }
        Ok(series)
    }

    /// The element of a sequence that a symbol such as `u_3` names.
    fn element(&self, symbol: &Symbol) -> Result<BigRational, EvaluateError> {
        let missing = || EvaluateError::Missing(symbol.clone());
        let (sequence, position) = element_parts(symbol).ok_or_else(missing)?;
        let elements = self.sequences.get(&sequence).ok_or_else(missing)?;
        let at = (position as usize).checked_sub(1);
        let element = at.and_then(|at| elements.get(at)).cloned();
        element.ok_or(EvaluateError::NoElement {
            sequence,
            position,
            length: elements.len(),
        })
    }

    /// A limit or an integral is taken of the term, not of its value.
    fn worked_out(&self, term: &Expr) -> Result<BigRational, EvaluateError> {
        let unsupported = || EvaluateError::Unsupported(term.clone());
        let term = &self.unfolded(term);
        let mut atoms = Atoms::default();
        let mut constants = self.constants.clone();
        if self.still {
            constants.extend(term.free_symbols());
        }
        let mut lowering = Lowering {
            sequences: &self.sequences.keys().cloned().collect(),
            constants: &constants,
            ..Lowering::plain(&mut atoms)
        };
        let value = lowering.lower(term).map_err(|_| unsupported())?;
        let conditions = lowering.conditions;
        let polynomial = |polynomial: &Polynomial| {
            let mut values = Map::new();
            for var in polynomial.vars() {
                let atom = expr_of_atom(atoms.atom(var));
                if matches!(
                    atom,
                    Expr::Limit { .. } | Expr::Integral { .. } | Expr::Partial { .. }
                ) {
                    return Err(unsupported());
                }
                values.insert(var, self.value(&atom)?);
            }
            let value = polynomial.evaluate(|var| values.get(&var).cloned().map(Into::into));
            let value = value.map_err(|_| unsupported())?;
            Ok(value.ok_or_else(unsupported)?.to_big())
        };
        // There is a limit, or an integral, only where what it is taken of has a value all the way.
        let mut fits = conditions.doubtful.is_empty();
        for base in &conditions.positive {
            fits &= polynomial(base)?.is_positive();
        }
        for base in &conditions.nonnegative {
            fits &= !polynomial(base)?.is_negative();
        }
        for base in &conditions.zero {
            fits &= polynomial(base)?.is_zero();
        }
        if !fits {
            return Err(unsupported());
        }
        let mut result = polynomial(value.numerator())?;
        for (factor, exponent) in value.denominator() {
            let below = polynomial(&factor.pow(exponent).map_err(|_| unsupported())?)?;
            if below.is_zero() {
                return Err(EvaluateError::DivisionByZero(term.clone()));
            }
            result /= below;
        }
        Ok(result)
    }

    /// A term with what defines its symbols put in.
    pub fn unfolded(&self, term: &Expr) -> Expr {
        let mut term = term.clone();
        for _ in 0..=self.terms.len() {
            let defined = self.terms.iter();
            let next = defined.fold(term.clone(), |term, (symbol, value)| {
                term.substitute(symbol, value)
            });
            if next == term {
                break;
            }
            term = next;
        }
        term
    }
}

/// What a series is taken along, and how far.
#[derive(Clone, Copy)]
struct Along<'a> {
    variable: Option<&'a Symbol>,
    order: usize,
    depth: usize,
    /// Of a symbol by itself, whose value its derivative is nothing of.
    bare: bool,
}

impl Along<'_> {
    fn constant(self, value: BigRational) -> Series {
        let mut series = vec![BigRational::zero(); self.order + 1];
        series[0] = value;
        series
    }
}

/// Whether two numbers are related so.
fn compare(
    left: &BigRational,
    relation: Relation,
    right: &BigRational,
) -> Result<bool, EvaluateError> {
    Ok(match relation {
        Relation::Equal => left == right,
        Relation::NotEqual => left != right,
        Relation::Less => left < right,
        Relation::LessOrEqual => left <= right,
        Relation::Greater => left > right,
        Relation::GreaterOrEqual => left >= right,
        Relation::Scales
        | Relation::Proportional
        | Relation::Approximately
        | Relation::Tends
        | Relation::MuchLess
        | Relation::MuchGreater => return Err(EvaluateError::Undecidable(relation)),
    })
}

fn add(sum: &mut Series, other: &Series) {
    for (own, other) in sum.iter_mut().zip(other) {
        *own += other;
    }
}

/// $$ c_n = \sum_{k=0}^n a_k b_{n-k} $$
fn multiply(a: &Series, b: &Series) -> Series {
    // A sum that began at 0 would cost as much again: every sum is brought to lowest terms.
    let sum = |n: usize| {
        let products = (0..=n).map(|k| times(&a[k], &b[n - k]));
        products.reduce(|sum, product| sum + product)
    };
    (0..a.len()).map(|n| sum(n).unwrap_or_default()).collect()
}

/// The product. To bring it to lowest terms is most of the work: nothing to do where both are whole, and little in machine words.
fn times(a: &BigRational, b: &BigRational) -> BigRational {
    if a.is_integer() && b.is_integer() {
        return BigRational::from_integer(a.numer() * b.numer());
    }
    match (Rational::if_small(a), Rational::if_small(b)) {
        (Some(a), Some(b)) => (a * b).into(),
        _ => a * b,
    }
}

/// $$ c_0 = 1/a_0, \qquad c_n = -c_0 \sum_{k=1}^n a_k c_{n-k} $$
fn reciprocal(a: &Series) -> Option<Series> {
    if a[0].is_zero() {
        return None;
    }
    let first = a[0].recip();
    let mut inverse = vec![first.clone()];
    for n in 1..a.len() {
        let rest: BigRational = (1..=n).map(|k| &a[k] * &inverse[n - k]).sum();
        inverse.push(-rest * &first);
    }
    Some(inverse)
}

fn raise(
    term: &Expr,
    base: &Expr,
    a: &Series,
    exponent: &BigRational,
) -> Result<Series, EvaluateError> {
    let too_large = || EvaluateError::TooLarge(term.clone());
    if exponent.is_integer() {
        let by_zero = || EvaluateError::DivisionByZero(base.clone());
        let times = exponent.numer().abs().to_u32();
        let times = times
            .filter(|&t| t <= HIGHEST_POWER)
            .ok_or_else(too_large)?;
        let power = match a.as_slice() {
            // Powers of coprime numbers are coprime.
            [constant] => vec![num_traits::Pow::pow(constant, times)],
            _ => {
                let mut power = vec![BigRational::zero(); a.len()];
                power[0] = BigRational::one();
                for _ in 0..times {
                    power = multiply(&power, a);
                }
                power
            }
        };
        return match exponent.is_negative() {
            true => reciprocal(&power).ok_or_else(by_zero),
            false => Ok(power),
        };
    }
    // Miller's recurrence: a_0 c_n = Σ_{k=1}^n (p k / n − 1 + k / n) a_k c_{n−k}.
    let not_rational = || EvaluateError::NotRational(term.clone());
    let degree = exponent.denom().to_u32();
    let degree = degree
        .filter(|&d| d <= HIGHEST_POWER)
        .ok_or_else(too_large)?;
    let root = root(&a[0], degree).ok_or_else(not_rational)?;
    let whole = BigRational::from_integer(exponent.numer().clone());
    let mut power = raise(term, base, &vec![root], &whole)?;
    if a.len() > 1 && a[0].is_zero() {
        return Err(EvaluateError::DivisionByZero(base.clone()));
    }
    for n in 1..a.len() {
        let whole = BigRational::from_integer(n.into());
        let coefficient = (1..=n)
            .map(|k| {
                let share = BigRational::from_integer(k.into()) / &whole;
                (exponent * &share - BigRational::one() + share) * &a[k] * &power[n - k]
            })
            .sum::<BigRational>();
        power.push(coefficient / &a[0]);
    }
    Ok(power)
}

/// The root of a number that is not negative, where it is rational.
fn root(value: &BigRational, degree: u32) -> Option<BigRational> {
    if value.is_negative() {
        return None;
    }
    let exact = |n: &BigInt| Some(n.nth_root(degree)).filter(|r| r.pow(degree) == *n);
    Some(BigRational::new(
        exact(value.numer())?,
        exact(value.denom())?,
    ))
}
