//! From terms as written to rational functions: `Expr` in, [`Fraction`] out, with all that must not vanish.

use std::fmt;

use num_integer::Integer;
use num_traits::ToPrimitive;

use super::partial::Held;
use super::{
    Atom, Atoms, BigRational, Expr, Fraction, Functions, Monomial, Polynomial, Powers, Rational,
    Symbol, TooLarge, Var,
};
use crate::sorted::Set;

/// Sums with definite limits are written out up to this many terms.
const MOST_EXPLICIT_TERMS: i64 = 512;
/// Sums of more terms than this are put together at once.
const MANY: usize = 32;

/// Exponents up to this are multiplied out without asking whether that grows too large.
const SMALL_EXPONENT: u32 = 64;

/// Why a term has no value as a rational function.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum LowerError {
    /// Too large to expand.
    TooLarge,
    /// Something is divided by an expression that is identically 0.
    DivisionByZero,
}

impl From<TooLarge> for LowerError {
    fn from(_: TooLarge) -> Self {
        LowerError::TooLarge
    }
}

impl fmt::Display for LowerError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            LowerError::TooLarge => TooLarge.fmt(f),
            LowerError::DivisionByZero => f.write_str("division by an expression that is always 0"),
        }
    }
}

/// What must be so for a term to have the value that it is given.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Conditions {
    /// Denominators: they must not vanish.
    pub nonzero: Set<Polynomial>,
    /// Derivatives of what was held constant: they must vanish, and not at one point only.
    pub zero: Set<Polynomial>,
    /// What an even root is taken of: it must not be negative.
    pub nonnegative: Set<Polynomial>,
    /// What a logarithm or a symbolic power is taken of: it must be positive.
    pub positive: Set<Polynomial>,
    /// What a power with a whole exponent that may be negative is taken of: it must not vanish. Where such a power is
    /// asserted it may all the same, for the exponent need not be negative.
    pub bases: Set<Polynomial>,
    /// What a limit has another value for where it vanishes, or none: it must not, but that there is a limit does not say so.
    pub away: Set<Polynomial>,
    /// Terms of which it is not known whether they have a value: a limit that may not exist.
    pub doubtful: Set<Expr>,
}

impl Conditions {
    pub(super) fn extend(&mut self, other: Conditions) {
        self.nonzero.extend(other.nonzero);
        self.zero.extend(other.zero);
        self.nonnegative.extend(other.nonnegative);
        self.positive.extend(other.positive);
        self.bases.extend(other.bases);
        self.away.extend(other.away);
        self.doubtful.extend(other.doubtful);
    }

    /// The same of other polynomials.
    pub(super) fn map(self, mut change: impl FnMut(&Polynomial) -> Polynomial) -> Conditions {
        let mut all = |own: Set<Polynomial>| own.iter().map(&mut change).collect();
        Conditions {
            nonzero: all(self.nonzero),
            zero: all(self.zero),
            nonnegative: all(self.nonnegative),
            positive: all(self.positive),
            bases: all(self.bases),
            away: all(self.away),
            doubtful: self.doubtful,
        }
    }

    /// What must not vanish.
    pub fn divisors(&self) -> impl Iterator<Item = &Polynomial> {
        self.nonzero.iter().chain(&self.bases).chain(&self.away)
    }

    /// Every polynomial that some condition is about.
    pub(super) fn polynomials(&self) -> impl Iterator<Item = &Polynomial> {
        let signs = self.nonnegative.iter().chain(&self.positive);
        self.divisors().chain(&self.zero).chain(signs)
    }
}

/// Reads terms into rational functions over one table of atoms.
pub struct Lowering<'a> {
    /// The unknowns met so far.
    pub atoms: &'a mut Atoms,
    /// The symbols that name sequences.
    pub sequences: &'a Set<Symbol>,
    /// The symbols that depend on no variable of differentiation.
    pub constants: &'a Set<Symbol>,
    /// Symbols that do not depend on another.
    pub still: &'a Set<(Symbol, Symbol)>,
    /// How powers are taken apart; `None` to read them as they are written.
    pub powers: Option<&'a Powers>,
    /// What is known of symbols where functions are taken apart.
    pub functions: Option<&'a Functions>,
    /// What does not change while a partial derivative is taken.
    pub partial: Option<Held>,
    /// What the values found so far depend on.
    pub conditions: Conditions,
}

pub(super) type Lowered = Result<Fraction, LowerError>;

impl<'a> Lowering<'a> {
    /// Reads terms as they are written, no symbol a sequence or known to be constant.
    pub fn plain(atoms: &'a mut Atoms) -> Self {
        static NONE: Set<Symbol> = Set::new();
        static NO_PAIRS: Set<(Symbol, Symbol)> = Set::new();
        Lowering {
            atoms,
            sequences: &NONE,
            constants: &NONE,
            still: &NO_PAIRS,
            powers: None,
            functions: None,
            partial: None,
            conditions: Conditions::default(),
        }
    }
}

impl Lowering<'_> {
    /// The same over another table of atoms, where nothing is needed yet.
    pub(super) fn over<'b>(&'b self, atoms: &'b mut Atoms) -> Lowering<'b> {
        Lowering {
            atoms,
            sequences: self.sequences,
            constants: self.constants,
            still: self.still,
            powers: self.powers,
            functions: self.functions,
            partial: None,
            conditions: Conditions::default(),
        }
    }

    /// The value of a term; [`Lowering::conditions`] grows by what it needs.
    pub fn lower(&mut self, expr: &Expr) -> Lowered {
        match expr {
            Expr::Number(value) => Ok(Rational::from(value).into()),
            Expr::Symbol(symbol) => {
                let power = self.symbol_power(symbol, 1);
                Ok(Polynomial::term(power, Rational::one()).into())
            }
            Expr::Element { sequence, index } => Ok(self.atom(Atom::Bound {
                sequence: sequence.clone(),
                index: index.clone(),
            })),
            Expr::Sum(terms) => {
                if terms.len() > MANY {
                    return self.long_sum(terms);
                }
                let Some((first, rest)) = terms.split_first() else {
                    return Ok(Fraction::default());
                };
                let mut sum = self.lower(first)?;
                for term in rest {
                    sum = sum.plus(&self.lower(term)?)?;
                }
                Ok(sum)
            }
            Expr::Product(factors) => {
                // Most products are of numbers and powers of symbols: these are multiplied in one go.
                let (mut monomial, mut coefficient) = (Monomial::one(), Rational::one());
                let mut others: Option<Fraction> = None;
                for factor in factors {
                    if let Some((own, number)) = self.simple_factor(factor) {
                        monomial = monomial.times(&own);
                        coefficient *= number;
                        continue;
                    }
                    let factor = self.lower(factor)?;
                    others = Some(match others {
                        Some(others) => others.times(&factor)?,
                        None => factor,
                    });
                }
                let simple: Fraction = Polynomial::term(monomial, coefficient).into();
                match others {
                    Some(others) => Ok(simple.times(&others)?),
                    None => Ok(simple),
                }
            }
            Expr::Negate(inner) => Ok(self.lower(inner)?.negated()),
            Expr::Quotient(above, below) => {
                let above = self.lower(above)?;
                Ok(above.times(&self.inverse(below)?)?)
            }
            Expr::Power(base, exponent) => self.power(base, exponent),
            Expr::Series {
                index,
                from,
                to,
                body,
            } => self.series(expr, index, from, to, body),
            Expr::Derivative { body, variable } => self.differentiated(body, variable, None),
            Expr::Partial {
                body,
                variable,
                held,
            } => self.partial(body, variable, held.as_deref()),
            Expr::Limit {
                body,
                variable,
                point,
            } => self.limit(body, variable, point),
            Expr::Call(function, argument) => self.call(*function, argument),
            Expr::Apply(function, arguments) => {
                let opaque = Expr::Apply(function.clone(), arguments.clone());
                Ok(self.atom(Atom::Opaque(opaque)))
            }
            Expr::Integral {
                body,
                variable,
                from,
                to,
            } => self.integral(expr, body, variable, from, to),
        }
    }

    /// A number, a symbol or a small natural power of one.
    fn simple_factor(&mut self, factor: &Expr) -> Option<(Monomial, Rational)> {
        let (symbol, exponent) = match factor {
            Expr::Number(value) => return Some((Monomial::one(), value.into())),
            Expr::Symbol(symbol) => (symbol, 1),
            Expr::Power(base, exponent) => {
                let Expr::Symbol(symbol) = &**base else {
                    return None;
                };
                let whole = natural(exponent)?;
                (
                    symbol,
                    Some(whole).filter(|e| (1..=SMALL_EXPONENT).contains(e))?,
                )
            }
            _ => return None,
        };
        Some((self.symbol_power(symbol, exponent), Rational::one()))
    }

    /// A power of a symbol: of its root, where it is read so.
    fn symbol_power(&mut self, symbol: &Symbol, exponent: u32) -> Monomial {
        if let Some(element) = self.element(symbol) {
            return Monomial::power(self.atoms.var(element), exponent);
        }
        let order = self.powers.and_then(|p| p.roots.get(symbol).copied());
        match order {
            None => Monomial::power(self.atoms.var_of_symbol(symbol), exponent),
            Some(order) => {
                let of = symbol.clone();
                let root = self.atoms.var(Atom::Root { of, order });
                Monomial::power(root, exponent * order)
            }
        }
    }

    pub(super) fn atom(&mut self, atom: Atom) -> Fraction {
        Polynomial::var(self.atoms.var(atom)).into()
    }

    /// `u_3` is an element where `u` is a sequence.
    pub(super) fn atom_of_symbol(&self, symbol: &Symbol) -> Atom {
        let element = self.element(symbol);
        element.unwrap_or_else(|| Atom::Symbol(symbol.clone()))
    }

    fn element(&self, symbol: &Symbol) -> Option<Atom> {
        if self.sequences.is_empty() {
            return None;
        }
        let (name, position) = element_name(symbol)?;
        let sequence = self.sequences.get(name)?.clone();
        Some(Atom::Element { sequence, position })
    }

    /// `1 / divisor`. Its factors are kept apart: `(x + y)^2` vanishes where `x + y` does.
    fn inverse(&mut self, divisor: &Expr) -> Lowered {
        let is_sum = |expr: &Expr| matches!(expr, Expr::Sum(_));
        let may_part = |factor: &Expr| match factor {
            Expr::Power(base, _) => is_sum(base),
            factor => is_sum(factor),
        };
        match divisor {
            Expr::Product(factors) if factors.iter().any(may_part) => {
                let mut whole = Fraction::from(Rational::one());
                for factor in factors {
                    whole = whole.times(&self.inverse(factor)?)?;
                }
                Ok(whole)
            }
            Expr::Power(base, exponent) if is_sum(base) => match natural(exponent) {
                // `0^0` is 1: of what has that exponent nothing is said.
                Some(exponent) if exponent > 0 => Ok(self.inverse(base)?.pow(exponent)?),
                _ => self.inverted(divisor),
            },
            _ => self.inverted(divisor),
        }
    }

    fn inverted(&mut self, divisor: &Expr) -> Lowered {
        let divisor = self.lower(divisor)?;
        self.recip(&divisor)
    }

    pub(super) fn recip(&mut self, value: &Fraction) -> Lowered {
        let inverse = value.recip()?.ok_or(LowerError::DivisionByZero)?;
        for (factor, _) in inverse.denominator() {
            self.conditions.nonzero.insert(factor.clone());
        }
        Ok(inverse)
    }

    fn power(&mut self, base: &Expr, exponent: &Expr) -> Lowered {
        let base = self.lower(base)?;
        if let Expr::Number(exponent) = exponent {
            return self.rational_power(&base, &exponent.into());
        }
        let exponent = self.lower(exponent)?;
        if let Some(exponent) = exponent.as_constant() {
            return self.rational_power(&base, &exponent);
        }
        if let Some(powers) = self.powers
            && let Some(value) = self.symbolic_power(&base, &exponent, powers)?
        {
            return Ok(value);
        }
        match exponent.as_polynomial() {
            Some(exponent) => self.require_base(&base, exponent)?,
            None => {
                self.conditions.positive.insert(sign_of_fraction(&base)?);
            }
        }
        let opaque = Expr::Power(
            expr_of_fraction(&base, self.atoms).into(),
            expr_of_fraction(&exponent, self.atoms).into(),
        );
        Ok(self.atom(Atom::Opaque(opaque)))
    }

    fn rational_power(&mut self, base: &Fraction, exponent: &Rational) -> Lowered {
        if exponent.is_negative() {
            let inverse = self.recip(base)?;
            return self.rational_power(&inverse, &-exponent);
        }
        if exponent.is_integer() {
            let power = exponent.to_u32().ok_or(LowerError::TooLarge)?;
            return Ok(base.pow(power)?);
        }
        let power = exponent.numer().to_u32().ok_or(LowerError::TooLarge)?;
        if self.powers.is_some() {
            let order = exponent.denom().to_u32().ok_or(LowerError::TooLarge)?;
            return self.root_taken_apart(base, power, order);
        }
        let root = match base.as_constant().and_then(|c| exact_root(&c, exponent)) {
            Some(root) => root.into(),
            None => {
                if exponent.denom() == 2.into()
                    && let Some(root) = self.root_of_square(base)?
                {
                    return Ok(root.pow(power)?);
                }
                if exponent.denom().is_even() {
                    self.conditions.nonnegative.insert(sign_of_fraction(base)?);
                }
                let written = expr_of_fraction(base, self.atoms);
                let unit = BigRational::new(1.into(), exponent.denom());
                self.atom(Atom::Opaque(Expr::Power(
                    written.into(),
                    Expr::Number(unit).into(),
                )))
            }
        };
        Ok(root.pow(power)?)
    }

    fn series(
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

    /// `Σ_i` of a polynomial in the elements, as a linear combination of power sums.
    fn power_sums(
        &mut self,
        body: &Fraction,
        index: &Symbol,
        count: &Symbol,
    ) -> Result<Option<Fraction>, LowerError> {
        let bound_sequence = |atoms: &Atoms, var: Var| match atoms.atom(var) {
            Atom::Bound { sequence, index: i } if i == index => Some(sequence.clone()),
            _ => None,
        };
        for (factor, _) in body.denominator() {
            if factor.vars().iter().any(|&v| self.depends(v, index)) {
                return Ok(None);
            }
        }
        let mut sum = Polynomial::zero();
        for (monomial, coefficient) in body.numerator().terms() {
            let (mut outside, mut powers) = (Monomial::one(), Vec::new());
            for &(var, exponent) in monomial.powers() {
                match bound_sequence(self.atoms, var) {
                    Some(sequence) => powers.push((sequence, exponent)),
                    None if self.depends(var, index) => return Ok(None),
                    None => outside = outside.times(&Monomial::power(var, exponent)),
                }
            }
            powers.sort();
            let total = power_sum(count, powers);
            let var = self.atoms.var(total);
            let term =
                Polynomial::term(outside.times(&Monomial::power(var, 1)), coefficient.clone());
            sum = sum.plus(&term);
        }
        let mut value = Fraction::from(sum);
        for (factor, exponent) in body.denominator() {
            let inverse = Fraction::from(factor.clone()).pow(exponent)?.recip()?;
            value = value.times(&inverse.ok_or(LowerError::DivisionByZero)?)?;
        }
        Ok(Some(value))
    }

    /// Whether an unknown is another at another value of a bound index.
    pub(super) fn depends(&self, var: Var, index: &Symbol) -> bool {
        match self.atoms.atom(var) {
            Atom::Bound { index: own, .. } => own == index,
            Atom::Symbol(symbol) | Atom::Root { of: symbol, .. } => symbol == index,
            Atom::PowerSum { to, .. } => to == index,
            Atom::Opaque(expr) => expr.mentions(index),
            Atom::Element { .. } => false,
        }
    }

    /// The derivative of a value by a symbol; [`Lowering::conditions`] grows by what it needs.
    ///
    /// # Errors
    /// As [`Lowering::lower`].
    pub fn derivative(&mut self, value: &Fraction, variable: &Symbol) -> Lowered {
        let mut total = Fraction::default();
        let mut vars: Set<Var> = value.numerator().vars().into_iter().collect();
        for (factor, _) in value.denominator() {
            vars.extend(factor.vars());
        }
        for var in vars {
            let inner = self.atom_derivative(var, variable)?;
            if inner.is_zero() {
                continue;
            }
            total = total.plus(&partial_derivative(value, var)?.times(&inner)?)?;
        }
        Ok(total)
    }

    /// The derivative of one unknown: 1, 0, or an unknown of its own.
    pub(super) fn atom_derivative(&mut self, var: Var, variable: &Symbol) -> Lowered {
        let atom = self.atoms.atom(var).clone();
        if atom == self.atom_of_symbol(variable) {
            return Ok(Rational::one().into());
        }
        if self.is_constant(&atom, variable) {
            return Ok(Fraction::default());
        }
        let body = expr_of_atom(&atom);
        if let Expr::Call(function, argument) = &body
            && let Some(slope) = self.derivative_of_call(*function, argument, variable)?
        {
            return Ok(slope);
        }
        // A root of a symbol would lead back to itself.
        if let Expr::Power(base, exponent) = &body
            && !matches!(atom, Atom::Root { .. })
            && let Expr::Number(exponent) = &**exponent
        {
            // d(b^r) = r · b^r / b · db
            let base = self.lower_apart(base)?;
            let inner = self.derivative(&base, variable)?;
            let outer = Fraction::from(Polynomial::var(var)).times(&self.recip(&base)?)?;
            return Ok(outer.times(&inner)?.times(&exponent.clone().into())?);
        }
        let slope = match &self.partial {
            Some(held) => held.slope_of(body, variable),
            None => body.differentiated_by(variable),
        };
        Ok(self.atom(Atom::Opaque(slope)))
    }

    /// Whether an unknown is made of declared constants alone, the variable not among them.
    pub(super) fn is_constant(&self, atom: &Atom, variable: &Symbol) -> bool {
        // Along the line of a partial derivative something else may change than otherwise.
        let still = |s: &Symbol| {
            self.partial.is_none()
                && !self.still.is_empty()
                && self.still.contains(&(s.clone(), variable.clone()))
        };
        let held = |s: &Symbol| self.partial.as_ref().is_some_and(|own| own.holds(s));
        let constant =
            |s: &Symbol| s != variable && (self.constants.contains(s) || held(s) || still(s));
        match atom {
            Atom::Symbol(symbol) => constant(symbol),
            // How many elements there are does not change while something else does.
            Atom::PowerSum { to, powers } => {
                let own = element_parts(variable).map(|parts| parts.0);
                let still = |s: &Symbol| constant(s) && own.as_ref() != Some(s);
                to != variable && powers.iter().all(|(sequence, _)| still(sequence))
            }
            atom => {
                let body = expr_of_atom(atom);
                // That `f` and `y` are held fixed says nothing of a slope of `f` by `y`, but where they never change.
                let is_slope =
                    |part: &Expr| matches!(part, Expr::Derivative { .. } | Expr::Partial { .. });
                let mut names = body.free_symbols().into_iter();
                let still = match self.partial.is_some() && body.any(&is_slope) {
                    true => names.all(|own| own != *variable && self.constants.contains(&own)),
                    false => names.all(|own| constant(&own)),
                };
                still && !body.has_elements()
            }
        }
    }
}

/// An exponent that is a natural number or 0.
fn natural(exponent: &Expr) -> Option<u32> {
    match exponent {
        Expr::Number(exponent) if exponent.is_integer() => exponent.numer().to_u32(),
        _ => None,
    }
}

/// A polynomial with the sign of a rational function.
pub fn sign_of_fraction(value: &Fraction) -> Result<Polynomial, TooLarge> {
    let mut polynomial = value.numerator().clone();
    for (factor, exponent) in value.denominator() {
        if exponent % 2 == 1 {
            polynomial = polynomial.times(factor)?;
        }
    }
    Ok(polynomial)
}

fn partial_derivative(value: &Fraction, var: Var) -> Lowered {
    let mut below = Fraction::from(Rational::one());
    for (factor, exponent) in value.denominator() {
        below = below.times(&Fraction::from(factor.clone()).pow(exponent)?)?;
    }
    let invert = |f: &Fraction| -> Lowered { f.recip()?.ok_or(LowerError::DivisionByZero) };
    let mut total = Fraction::from(value.numerator().derivative(var)).times(&invert(&below)?)?;
    // (1/f^e)' = -e f' / f^(e+1)
    for (factor, exponent) in value.denominator() {
        let slope = factor.derivative(var);
        if slope.is_zero() {
            continue;
        }
        let slope = slope.scaled(&exponent.into());
        let change = Fraction::from(slope).times(&invert(&factor.clone().into())?)?;
        total = total.plus(&value.times(&change)?.negated())?;
    }
    Ok(total)
}

/// `Σ_{i=1}^{count}` of a product of elements, or the count itself for the empty product.
pub fn power_sum(count: &Symbol, powers: Vec<(Symbol, u32)>) -> Atom {
    if powers.is_empty() {
        return Atom::Symbol(count.clone());
    }
    Atom::PowerSum {
        to: count.clone(),
        powers,
    }
}

/// The q-th root of a number for an exponent p/q, where it is rational.
fn exact_root(value: &Rational, exponent: &Rational) -> Option<Rational> {
    let q = exponent.denom().to_u32()?;
    if value.is_negative() || q > 64 {
        return None;
    }
    let (above, below) = (value.numer().nth_root(q), value.denom().nth_root(q));
    let exact = above.pow(q) == value.numer() && below.pow(q) == value.denom();
    exact.then(|| BigRational::new(above, below).into())
}

/// The term that an atom stands for.
pub fn expr_of_atom(atom: &Atom) -> Expr {
    match atom {
        Atom::Symbol(symbol) => Expr::Symbol(symbol.clone()),
        Atom::Element { sequence, position } => Expr::Symbol(element_symbol(sequence, *position)),
        Atom::Bound { sequence, index } => Expr::Element {
            sequence: sequence.clone(),
            index: index.clone(),
        },
        Atom::PowerSum { to, powers } => {
            let index = Symbol::new("i");
            let elements = powers.iter().map(|(sequence, exponent)| {
                let element = Expr::Element {
                    sequence: sequence.clone(),
                    index: index.clone(),
                };
                raised(element, *exponent)
            });
            Expr::Series {
                from: Expr::integer(1).into(),
                to: Expr::Symbol(to.clone()).into(),
                body: product_of(elements.collect()).into(),
                index: index.clone(),
            }
        }
        Atom::Root { of, order } => power_of_root(of, *order, 1),
        Atom::Opaque(expr) => expr.clone(),
    }
}

/// `r^e`, for the root `r` of a symbol, as a power of the symbol.
fn power_of_root(of: &Symbol, order: u32, exponent: u32) -> Expr {
    let exponent = BigRational::new(exponent.into(), order.into());
    let symbol = Expr::Symbol(of.clone());
    match exponent == BigRational::from_integer(1.into()) {
        true => symbol,
        false => Expr::Power(symbol.into(), Expr::Number(exponent).into()),
    }
}

/// A power of an unknown as a term.
fn expr_of_power(atom: &Atom, exponent: u32) -> Expr {
    match atom {
        Atom::Root { of, order } => power_of_root(of, *order, exponent),
        atom => raised(expr_of_atom(atom), exponent),
    }
}

/// `u` and 3, for the symbol `u_3`; `None` for a symbol that cannot name an element.
pub fn element_parts(symbol: &Symbol) -> Option<(Symbol, u32)> {
    let (name, position) = element_name(symbol)?;
    Some((Symbol::new(name), position))
}

fn element_name(symbol: &Symbol) -> Option<(&str, u32)> {
    let (name, subscript) = symbol.name().rsplit_once('_')?;
    let digits = match subscript.strip_prefix('{') {
        Some(braced) => braced.strip_suffix('}')?,
        None => subscript,
    };
    let plain = digits.bytes().all(|b| b.is_ascii_digit()) && !digits.starts_with('0');
    let position = digits.parse().ok().filter(|_| plain)?;
    Some((name, position))
}

/// `u_3`, as a symbol.
pub fn element_symbol(sequence: &Symbol, position: u32) -> Symbol {
    match position {
        0..=9 => Symbol::new(format!("{sequence}_{position}")),
        _ => Symbol::new(format!("{sequence}_{{{position}}}")),
    }
}

/// A power, the first one without its exponent.
pub fn raised(base: Expr, exponent: u32) -> Expr {
    match exponent {
        1 => base,
        _ => Expr::Power(
            base.into(),
            Expr::Number(BigRational::from_integer(exponent.into())).into(),
        ),
    }
}

/// A product; one factor is itself.
pub fn product_of(mut factors: Vec<Expr>) -> Expr {
    match factors.len() {
        0 => Expr::integer(1),
        1 => factors.remove(0),
        _ => Expr::Product(factors),
    }
}

/// A polynomial as a term, in an order that depends on names alone.
pub fn expr_of(polynomial: &Polynomial, atoms: &Atoms) -> Expr {
    let mut terms: Vec<(std::cmp::Reverse<u32>, Vec<Expr>, Rational)> = polynomial
        .terms()
        .map(|(monomial, coefficient)| {
            let powers = monomial.powers().iter();
            let mut factors: Vec<Expr> = powers
                .map(|&(var, exponent)| expr_of_power(atoms.atom(var), exponent))
                .collect();
            factors.sort();
            (
                std::cmp::Reverse(monomial.degree()),
                factors,
                coefficient.clone(),
            )
        })
        .collect();
    terms.sort();
    let mut written: Vec<Expr> = terms
        .into_iter()
        .map(|(_, mut factors, coefficient)| {
            if !coefficient.abs().is_one() || factors.is_empty() {
                factors.insert(0, Expr::Number(coefficient.abs().to_big()));
            }
            let product = product_of(factors);
            match coefficient.is_negative() {
                true => Expr::Negate(product.into()),
                false => product,
            }
        })
        .collect();
    match written.len() {
        0 => Expr::integer(0),
        1 => written.remove(0),
        _ => Expr::Sum(written),
    }
}

/// A rational function as a term, in an order that depends on names alone.
pub fn expr_of_fraction(value: &Fraction, atoms: &Atoms) -> Expr {
    let above = expr_of(value.numerator(), atoms);
    let mut below: Vec<Expr> = value
        .denominator()
        .map(|(factor, exponent)| {
            let vars = factor.vars();
            match vars.len() == 1 && *factor == Polynomial::var(vars[0]) {
                true => expr_of_power(atoms.atom(vars[0]), exponent),
                false => raised(expr_of(factor, atoms), exponent),
            }
        })
        .collect();
    below.sort();
    match below.is_empty() {
        true => above,
        false => Expr::Quotient(above.into(), product_of(below).into()),
    }
}
