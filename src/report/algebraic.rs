//! Values in terms of one irrational root, in words: closed forms with a square root, a name and a decimal for others.

use std::fmt;

use num_traits::{One, Signed, ToPrimitive, Zero};

use crate::algebra::{
    BigInt, BigRational, Expr, Function, Rational, Symbol, Univariate, Values, product_of, raised,
};
use crate::kernel::{Algebraic, Assignment, Field};
use crate::notation::plain;

use super::evidence::number;
use super::numeric::about;
use super::words;
use crate::sorted::Set;

/// What a root is called that is the value of no symbol.
const NAMES: [&str; 4] = ["\\alpha", "\\xi", "\\zeta", "\\rho"];
/// Square factors below a root are looked for up to this.
const LARGEST_FACTOR: u32 = 1_000;
/// Definitions that lead to one another more often than this are not followed.
const DEEPEST: usize = 64;
/// How often an interval is halved for a decimal.
const HALVINGS: usize = 64;

/// A value, as exactly as it is printed.
#[derive(Clone, Debug)]
pub enum Exact {
    /// A fraction.
    Rational(BigRational),
    /// A term with a square root.
    Closed(Expr),
    /// The nearest decimal of a few digits.
    About(String),
}

impl Exact {
    /// The value as a term, where it is exact.
    pub fn expr(&self) -> Option<Expr> {
        match self {
            Exact::Rational(value) => Some(Expr::Number(value.clone())),
            Exact::Closed(term) => Some(term.clone()),
            Exact::About(_) => None,
        }
    }

    /// `= 2/3`, `≈ 1.2599`
    pub fn equated(&self) -> String {
        match self {
            Exact::About(_) => self.to_string(),
            _ => format!("= {self}"),
        }
    }
}

impl fmt::Display for Exact {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Exact::Rational(value) => f.write_str(&number(value)),
            Exact::Closed(term) => f.write_str(&plain(term)),
            Exact::About(decimal) => write!(f, "≈ {decimal}"),
        }
    }
}

/// The root that values are given in, and the values.
#[derive(Clone, Debug)]
pub struct Root<'a> {
    at: &'a Assignment,
    own: &'a Algebraic,
    field: Field,
}

impl<'a> Root<'a> {
    /// The root that a point has, if it has one.
    pub fn of(at: &'a Assignment) -> Option<Self> {
        let own = at.algebraic.as_deref()?;
        let polynomial = Univariate::new(own.polynomial.iter().map(Rational::from));
        let field = Field::new(polynomial, (&own.low).into(), (&own.high).into()).ok()?;
        Some(Root { at, own, field })
    }

    /// `x = √2`; `x = the root of x³ − 2 in (1, 2) (≈ 1.2599)`, `y = x² + 1 (≈ 2.5874)`.
    pub fn values(&self) -> Vec<(String, String)> {
        let mut all = Vec::new();
        let (root, stands_for_it) = self.symbol();
        if !stands_for_it && !self.is_quadratic() && !self.own.symbols.is_empty() {
            all.push((words::symbol(&root), self.defined(&root)));
        }
        for (symbol, value) in self.symbols() {
            let text = match self.exact(&value) {
                Exact::About(_) if symbol == root => self.defined(&root),
                Exact::About(decimal) => {
                    let term = in_powers_of(&value, &Expr::Symbol(root.clone()));
                    format!("{} (≈ {decimal})", plain(&term))
                }
                exact => exact.to_string(),
            };
            all.push((words::symbol(&symbol), text));
        }
        all
    }

    /// The same for a program: `(1+sqrt(5))/2`, `root of x^3-2 in [1,2]`, `x^2+1 for x = root of x^3-2 in [1,2]`.
    pub fn written(&self) -> Vec<(Symbol, String)> {
        let (low, high) = self.field.ends();
        let root = format!(
            "root of {} in [{low},{high}]",
            typed(self.field.polynomial())
        );
        let symbols = self.symbols().into_iter();
        let all = symbols.map(|(symbol, value)| {
            let text = match (value.as_constant(), self.surd(&value)) {
                (Some(number), _) => number.to_string(),
                (None, Some(surd)) => surd.typed(),
                (None, None) if value == Univariate::unknown() => root.clone(),
                (None, None) => format!("{} for x = {root}", typed(&value)),
            };
            (symbol, text)
        });
        all.collect()
    }

    /// The name of the root, where a value of one of the symbols is told by it.
    pub fn name_for(&self, symbols: &Set<Symbol>) -> Option<String> {
        let told = self.own.symbols.keys().any(|own| symbols.contains(own));
        (told && !self.is_quadratic()).then(|| words::symbol(&self.symbol().0))
    }

    fn is_quadratic(&self) -> bool {
        self.field.polynomial().degree() == 2
    }

    fn symbols(&self) -> Vec<(Symbol, Univariate)> {
        let number = |value: &Vec<BigRational>| {
            let value = Univariate::new(value.iter().map(Rational::from));
            value.modulo(self.field.polynomial())
        };
        let all = self.own.symbols.iter();
        all.map(|(symbol, value)| (symbol.clone(), number(value)))
            .collect()
    }

    /// What the root is called: as the symbol whose value it is, if there is one.
    fn symbol(&self) -> (Symbol, bool) {
        let mut symbols = self.symbols().into_iter();
        match symbols.find(|(_, value)| *value == Univariate::unknown()) {
            Some((symbol, _)) => (symbol, true),
            None => {
                let mut names = NAMES.iter().map(|name| Symbol::new(*name));
                let taken = |name: &Symbol| {
                    self.own.symbols.contains_key(name) || self.at.symbols.contains_key(name)
                };
                let name = names.find(|name| !taken(name));
                (name.unwrap_or_else(|| Symbol::new("r_0")), false)
            }
        }
    }

    /// `the root of x³ − 2 in (1, 2) (≈ 1.2599)`
    fn defined(&self, name: &Symbol) -> String {
        let (low, high) = self.field.ends();
        let polynomial = in_powers_of(self.field.polynomial(), &Expr::Symbol(name.clone()));
        let decimal = self.decimal(&Univariate::unknown());
        let (low, high) = (number(&low.to_big()), number(&high.to_big()));
        format!(
            "the root of {} in ({low}, {high}) (≈ {decimal})",
            plain(&polynomial)
        )
    }

    fn exact(&self, value: &Univariate) -> Exact {
        match (value.as_constant(), self.surd(value)) {
            (Some(number), _) => Exact::Rational(number.to_big()),
            (None, Some(surd)) => surd.exact(),
            (None, None) => Exact::About(self.decimal(value)),
        }
    }

    fn decimal(&self, value: &Univariate) -> String {
        let (low, high) = self.field.ends();
        let (mut low, mut high) = (low.clone(), high.clone());
        let polynomial = self.field.polynomial();
        let rising = polynomial.at(&high).is_positive();
        for _ in 0..HALVINGS {
            let middle = (&low + &high) * Rational::ratio(1, 2);
            match polynomial.at(&middle).is_positive() == rising {
                true => high = middle,
                false => low = middle,
            }
        }
        about(&value.at(&low).to_big())
    }

    /// A value in a quadratic field, in closed form.
    fn surd(&self, value: &Univariate) -> Option<Surd> {
        let monic = self.field.polynomial().monic();
        let [c, b, _] = monic.coefficients() else {
            return None;
        };
        // s = 2α + b is a root of b² − 4c.
        let two = Rational::from(2);
        let s = Univariate::new([b.clone(), two.clone()]);
        let square = b * b - Rational::from(4) * c;
        let at = |k: usize| value.coefficients().get(k).cloned();
        let at = |k| at(k).unwrap_or_else(Rational::zero);
        let slope = at(1) / &two;
        let free = at(0) - &slope * b;
        let slope = match self.field.sign(&s).is_lt() {
            true => -slope,
            false => slope,
        };
        // √(n/d) = √(n d) / d, squares taken out.
        let (mut outside, mut inside) = (BigInt::one(), square.numer() * square.denom());
        for factor in 2..=LARGEST_FACTOR {
            let own = BigInt::from(factor).pow(2);
            while (&inside % &own).is_zero() {
                inside /= &own;
                outside *= factor;
            }
        }
        let slope = slope * Rational::from(BigRational::new(outside, square.denom()));
        let below = num_integer::lcm(free.denom(), slope.denom());
        let whole = |part: &Rational| part.numer() * (&below / part.denom());
        Some(Surd {
            free: whole(&free),
            times: whole(&slope),
            inside,
            below,
        })
    }

    /// The value of a term at the point.
    pub fn value_of(&self, term: &Expr, values: &Values) -> Option<Exact> {
        let there = There { root: self, values };
        Some(self.exact(&there.value(term, 0)?))
    }
}

/// `(free + times √inside) / below`, in lowest terms.
struct Surd {
    free: BigInt,
    times: BigInt,
    inside: BigInt,
    below: BigInt,
}

impl Surd {
    fn exact(&self) -> Exact {
        let half = BigRational::new(1.into(), 2.into());
        let inside = BigRational::from_integer(self.inside.clone());
        let whole = |n: &BigInt| Expr::Number(BigRational::from_integer(n.clone()));
        if self.inside.is_one() {
            let value = BigRational::new(&self.free + &self.times, self.below.clone());
            return Exact::Rational(value);
        }
        let root = Expr::Power(Expr::Number(inside).into(), Expr::Number(half).into());
        let mut size = vec![whole(&self.times.abs()), root];
        size.retain(|factor| !factor.is_one());
        let size = product_of(size);
        let over = |above: Expr| match self.below.is_one() {
            true => above,
            false => Expr::Quotient(above.into(), whole(&self.below).into()),
        };
        // What is positive comes first.
        if self.free.is_negative() && self.times.is_positive() {
            let less = Expr::Negate(whole(&self.free.abs()).into());
            return Exact::Closed(over(Expr::Sum([size, less].into())));
        }
        Exact::Closed(match (self.free.is_zero(), self.times.is_negative()) {
            (true, true) => Expr::Negate(over(size).into()),
            (true, false) => over(size),
            (false, true) => over(Expr::Sum(
                [whole(&self.free), Expr::Negate(size.into())].into(),
            )),
            (false, false) => over(Expr::Sum([whole(&self.free), size].into())),
        })
    }

    fn typed(&self) -> String {
        let root = match self.times.abs() {
            size if size.is_one() => format!("sqrt({})", self.inside),
            size => format!("{size}*sqrt({})", self.inside),
        };
        let sign = match (self.times.is_negative(), self.free.is_zero()) {
            (true, _) => "-",
            (false, true) => "",
            (false, false) => "+",
        };
        let above = match self.free.is_zero() {
            true => format!("{sign}{root}"),
            false => format!("{}{sign}{root}", self.free),
        };
        match (self.below.is_one(), self.free.is_zero()) {
            (true, _) => above,
            (false, true) => format!("{above}/{}", self.below),
            (false, false) => format!("({above})/{}", self.below),
        }
    }
}

/// `x^3-2`
fn typed(polynomial: &Univariate) -> String {
    let mut text = String::new();
    for (k, c) in polynomial.coefficients().iter().enumerate().rev() {
        if c.is_zero() {
            continue;
        }
        text += match (c.is_negative(), text.is_empty()) {
            (true, _) => "-",
            (false, true) => "",
            (false, false) => "+",
        };
        let (size, power) = (c.abs(), format!("x^{k}"));
        text += &match (k, size.is_one()) {
            (0, _) => size.to_string(),
            (1, true) => "x".into(),
            (1, false) => format!("{size}*x"),
            (_, true) => power,
            (_, false) => format!("{size}*{power}"),
        };
    }
    text
}

/// A polynomial as a term in something, the highest power first.
fn in_powers_of(polynomial: &Univariate, unknown: &Expr) -> Expr {
    let terms = polynomial.coefficients().iter().enumerate().rev();
    let mut terms: Vec<Expr> = terms
        .filter(|(_, c)| !c.is_zero())
        .map(|(k, c)| {
            let mut factors = vec![Expr::Number(c.abs().to_big())];
            if k > 0 {
                factors.push(raised(unknown.clone(), k as u32));
            }
            factors.retain(|factor| k == 0 || !factor.is_one());
            match c.is_negative() {
                true => Expr::Negate(product_of(factors).into()),
                false => product_of(factors),
            }
        })
        .collect();
    match terms.len() {
        1 => terms.remove(0),
        _ => Expr::Sum(terms.into()),
    }
}

/// Terms at the point, evaluated as they are written.
struct There<'a> {
    root: &'a Root<'a>,
    values: &'a Values,
}

impl There<'_> {
    fn value(&self, term: &Expr, depth: usize) -> Option<Univariate> {
        let field = &self.root.field;
        if depth > DEEPEST {
            return None;
        }
        let value = |inner: &Expr| self.value(inner, depth);
        match term {
            Expr::Symbol(symbol) => {
                if let Some(own) = self.root.own.symbols.get(symbol) {
                    return field.number(own).ok();
                }
                match (
                    self.root.at.symbols.get(symbol),
                    self.values.terms.get(symbol),
                ) {
                    (None, Some(defined)) => self.value(defined, depth + 1),
                    _ => self.rational(term),
                }
            }
            Expr::Sum(terms) => {
                let mut sum = Univariate::default();
                for term in terms.iter() {
                    sum = sum.plus(&value(term)?);
                }
                Some(sum)
            }
            Expr::Product(factors) => {
                let mut product = Univariate::constant(Rational::one());
                for factor in factors.iter() {
                    product = field.times(&product, &value(factor)?).ok()?;
                }
                Some(product)
            }
            Expr::Negate(inner) => Some(value(inner)?.scaled(&-Rational::one())),
            Expr::Quotient(above, below) => {
                let inverse = value(below)?.inverse_modulo(field.polynomial())?;
                field.times(&value(above)?, &inverse).ok()
            }
            Expr::Power(base, exponent) => {
                let exponent = value(exponent)?.as_constant()?;
                self.power(&value(base)?, &exponent)
            }
            Expr::Call(Function::Abs, inner) => {
                let inner = value(inner)?;
                Some(match field.sign(&inner).is_lt() {
                    true => inner.scaled(&-Rational::one()),
                    false => inner,
                })
            }
            _ => self.rational(term),
        }
    }

    fn rational(&self, term: &Expr) -> Option<Univariate> {
        let value = self.values.value(term).ok()?;
        Some(Univariate::constant(value.into()))
    }

    /// A power; of a root the value is among those that the point gives.
    fn power(&self, base: &Univariate, exponent: &Rational) -> Option<Univariate> {
        let field = &self.root.field;
        let order = exponent.denom().to_u32()?;
        if let Some(base) = base.as_constant() {
            let number = |value: &Rational| Expr::Number(value.to_big());
            let term = Expr::Power(number(&base).into(), number(exponent).into());
            if let Some(value) = self.rational(&term) {
                return Some(value);
            }
        }
        let given = || {
            let mut roots = self.root.own.roots.values();
            roots.find_map(|value| {
                let value = field.number(value).ok()?;
                let excess = field.power(&value, order).ok()?.minus(base);
                let is_it = field.sign(&value).is_ge() && field.sign(&excess).is_eq();
                is_it.then_some(value)
            })
        };
        let root = match order {
            1 => base.clone(),
            _ => given()?,
        };
        let power = field.power(&root, exponent.numer().abs().to_u32()?).ok()?;
        match exponent.is_negative() {
            true => power.inverse_modulo(field.polynomial()),
            false => Some(power),
        }
    }
}
