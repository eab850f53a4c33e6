//! Real and imaginary parts of terms, as terms in real symbols: of `R + j \omega L` they are `R` and `\omega L`.
//!
//! A complex symbol `Z` is `\text{Re}(Z) + i \text{Im}(Z)`. What has no parts that can be written so, a root of something complex or a power
//! that is no small whole number, has none here.

use std::collections::BTreeSet;

use num_traits::{One, ToPrimitive, Zero};

use crate::algebra::{BigRational, Expr, Function, LimitPoint, Symbol};

/// A larger whole power is not multiplied out.
const LARGEST_POWER: i64 = 6;
/// So many terms are made at most.
const MOST_TERMS: usize = 300;

/// What is complex where terms are taken apart.
pub(super) struct Complex<'a> {
    /// The letters for the imaginary unit.
    pub units: &'a BTreeSet<Symbol>,
    /// The symbols that stand for complex numbers.
    pub complex: &'a BTreeSet<Symbol>,
}

/// A term as real and imaginary part. What vanishes is the number 0.
#[derive(Clone, Debug)]
pub(super) struct Parts {
    pub re: Expr,
    pub im: Expr,
}

/// What a term is, as far as it is written: the symbols in it may be given by others.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Zero,
    Real,
    Imaginary,
    Mixed,
}

impl Parts {
    fn real(re: Expr) -> Parts {
        Parts { re, im: zero() }
    }

    pub fn is_real(&self) -> bool {
        is_zero(&self.im)
    }

    pub fn kind(&self) -> Kind {
        match (is_zero(&self.re), is_zero(&self.im)) {
            (true, true) => Kind::Zero,
            (false, true) => Kind::Real,
            (true, false) => Kind::Imaginary,
            (false, false) => Kind::Mixed,
        }
    }

    fn negative(self) -> Parts {
        Parts {
            re: negative(self.re),
            im: negative(self.im),
        }
    }

    fn times(&self, other: &Parts) -> Parts {
        let product = |a: &Expr, b: &Expr| match a == b {
            true => square(a),
            false => product([a.clone(), b.clone()]),
        };
        Parts {
            re: sum([
                product(&self.re, &other.re),
                negative(product(&self.im, &other.im)),
            ]),
            im: sum([product(&self.re, &other.im), product(&self.im, &other.re)]),
        }
    }

    fn times_real(self, factor: &Expr) -> Parts {
        let product = |own| product([factor.clone(), own]);
        Parts {
            re: product(self.re),
            im: product(self.im),
        }
    }

    fn over_real(self, below: &Expr) -> Parts {
        let over = |own| quotient(own, below.clone());
        Parts {
            re: over(self.re),
            im: over(self.im),
        }
    }

    /// The square of its modulus.
    fn squared(&self) -> Expr {
        sum([square(&self.re), square(&self.im)])
    }

    /// Its quotient by another: what is only imaginary is divided by as it is, all else as `a / b = a \bar b / |b|^2`.
    fn over(self, below: &Parts) -> Parts {
        if below.is_real() {
            return self.over_real(&below.re);
        }
        if is_zero(&below.re) {
            let turned = Parts {
                re: self.im,
                im: negative(self.re),
            };
            return turned.over_real(&below.im);
        }
        let conjugate = Parts {
            re: below.re.clone(),
            im: negative(below.im.clone()),
        };
        self.times(&conjugate).over_real(&below.squared())
    }
}

/// What takes one of the parts.
#[derive(Clone, Copy)]
enum Part {
    Real,
    Imaginary,
}

impl Part {
    /// Of a term that is its name.
    fn of(term: &Expr) -> Option<Part> {
        match term {
            Expr::Symbol(own) => Part::named(own),
            _ => None,
        }
    }

    fn named(symbol: &Symbol) -> Option<Part> {
        match symbol.name() {
            "\\text{Re}" | "\\Re" => Some(Part::Real),
            "\\text{Im}" | "\\Im" => Some(Part::Imaginary),
            _ => None,
        }
    }

    fn taken(self, parts: Parts) -> Parts {
        Parts::real(match self {
            Part::Real => parts.re,
            Part::Imaginary => parts.im,
        })
    }
}

/// Whether a part is taken of a factor, as in `\text{Re} Z`: such a product is none of what its factors are.
fn takes_a_part(factors: &[Expr]) -> bool {
    factors.iter().any(|own| Part::of(own).is_some())
}

impl Complex<'_> {
    /// Whether a term speaks of anything that is complex here.
    pub fn concerns(&self, term: &Expr) -> bool {
        term.any(&|part| match part {
            Expr::Symbol(own) | Expr::Apply(own, _) => {
                self.units.contains(own)
                    || self.complex.contains(own)
                    || self.conjugate_of(own).is_some()
            }
            Expr::Element { sequence, .. } => self.complex.contains(sequence),
            _ => false,
        })
    }

    /// The parts of a term, where they can be written.
    pub fn parts(&self, term: &Expr) -> Option<Parts> {
        self.within(term)
            .filter(|own| is_small(&own.re) && is_small(&own.im))
    }

    fn within(&self, term: &Expr) -> Option<Parts> {
        if !self.concerns(term) {
            return Some(Parts::real(term.clone()));
        }
        let real = |term: &Expr| self.real(term);
        Some(match term {
            Expr::Symbol(own) => self.of_symbol(own, &Expr::Symbol)?,
            Expr::Apply(own, arguments) if Part::named(own).is_some() => match &arguments[..] {
                [of] => Part::named(own)?.taken(self.parts(of)?),
                _ => return None,
            },
            Expr::Apply(own, arguments) => {
                let arguments: Vec<Expr> = arguments.iter().map(real).collect::<Option<_>>()?;
                let apply = |name| Expr::Apply(name, arguments.clone().into());
                match self.complex.contains(own) || self.conjugate_of(own).is_some() {
                    true => self.of_symbol(own, &apply)?,
                    false => Parts::real(apply(own.clone())),
                }
            }
            Expr::Element { sequence, index } => self.of_symbol(sequence, &|sequence| {
                let index = index.clone();
                Expr::Element { sequence, index }
            })?,
            Expr::Sum(terms) => {
                let parts: Vec<Parts> = terms
                    .iter()
                    .map(|own| self.parts(own))
                    .collect::<Option<_>>()?;
                let (re, im): (Vec<Expr>, Vec<Expr>) =
                    parts.into_iter().map(|own| (own.re, own.im)).unzip();
                Parts {
                    re: sum(re),
                    im: sum(im),
                }
            }
            Expr::Negate(inner) => self.parts(inner)?.negative(),
            Expr::Product(factors) => self.of_product(factors)?,
            Expr::Quotient(above, below) => self.parts(above)?.over(&self.parts(below)?),
            Expr::Power(base, exponent) => self.of_power(base, exponent)?,
            Expr::Call(Function::Exp, inner) => {
                let inner = self.parts(inner)?;
                let size = match is_zero(&inner.re) {
                    true => Expr::integer(1),
                    false => Expr::Call(Function::Exp, inner.re.into()),
                };
                let turned = |function| Expr::Call(function, inner.im.clone().into());
                match is_zero(&inner.im) {
                    true => Parts::real(size),
                    false => Parts {
                        re: product([size.clone(), turned(Function::Cos)]),
                        im: product([size, turned(Function::Sin)]),
                    },
                }
            }
            Expr::Call(Function::Abs, inner) => Parts::real(self.modulus(inner, false)?),
            Expr::Call(function, inner) => {
                Parts::real(Expr::Call(*function, self.real(inner)?.into()))
            }
            Expr::Limit {
                point: LimitPoint::Finite(point),
                ..
            } if self.concerns(point) => return None,
            Expr::Derivative { body, variable }
            | Expr::Partial { body, variable, .. }
            | Expr::Limit { body, variable, .. }
            | Expr::Integral { body, variable, .. }
            | Expr::Series {
                body,
                index: variable,
                ..
            } => self.linear(term, body, variable)?,
            Expr::Number(_) => Parts::real(term.clone()),
        })
    }

    /// A term that is real, in real symbols.
    fn real(&self, term: &Expr) -> Option<Expr> {
        let parts = self.parts(term)?;
        parts.is_real().then_some(parts.re)
    }

    /// What is taken part by part of a body. What runs in it, and from where to where, is real.
    fn linear(&self, term: &Expr, body: &Expr, runs: &Symbol) -> Option<Parts> {
        if self.concerns(&Expr::Symbol(runs.clone())) {
            return None;
        }
        let parts = self.parts(body)?;
        let with = |part: Expr| {
            if is_zero(&part) {
                return Some(part);
            }
            let mut is_real = true;
            let own = term.map_children(|child| match std::ptr::eq(child, body) {
                true => part.clone(),
                false => self.real(child).unwrap_or_else(|| {
                    is_real = false;
                    child.clone()
                }),
            });
            is_real.then_some(own)
        };
        Some(Parts {
            re: with(parts.re)?,
            im: with(parts.im)?,
        })
    }

    fn of_symbol(&self, symbol: &Symbol, named: &dyn Fn(Symbol) -> Expr) -> Option<Parts> {
        if self.units.contains(symbol) {
            return Some(Parts {
                re: zero(),
                im: Expr::integer(1),
            });
        }
        let (whole, sign) = match self.conjugate_of(symbol) {
            Some(whole) => (whole, true),
            None => (symbol.clone(), false),
        };
        let (re, im) = part_names(&whole);
        let im = named(im);
        Some(Parts {
            re: named(re),
            im: if sign { negative(im) } else { im },
        })
    }

    /// `Z` of `Z^*` and `\bar{Z}`, where that is complex.
    fn conjugate_of(&self, symbol: &Symbol) -> Option<Symbol> {
        let name = symbol.name();
        let barred = |line: &str| name.strip_prefix(line)?.strip_suffix('}');
        let whole = (name.strip_suffix("^*"))
            .or_else(|| barred("\\bar{"))
            .or_else(|| barred("\\overline{"))?;
        Some(Symbol::new(whole)).filter(|whole| self.complex.contains(whole))
    }

    fn of_product(&self, factors: &[Expr]) -> Option<Parts> {
        // Factors that are real, and such as turn out to be, |Z|^2, stay beside the others, in order.
        let mut rest = Parts::real(Expr::integer(1));
        let (mut size, mut complex): (Vec<Expr>, Vec<Expr>) = (Vec::new(), Vec::new());
        let mut left = factors.iter();
        while let Some(factor) = left.next() {
            let parts = match Part::of(factor) {
                // `\text{Re} Z`
                Some(part) => part.taken(self.parts(left.next()?)?),
                None if !self.concerns(factor) => {
                    size.push(factor.clone());
                    continue;
                }
                None => self.parts(factor)?,
            };
            match parts.is_real() {
                true => complex.push(parts.re),
                false => rest = rest.times(&parts),
            }
            if !is_small(&rest.re) || !is_small(&rest.im) {
                return None;
            }
        }
        size.append(&mut complex);
        Some(rest.times_real(&product(size)))
    }

    fn of_power(&self, base: &Expr, exponent: &Expr) -> Option<Parts> {
        // The square of a modulus has no root in it.
        if let (Expr::Call(Function::Abs, inner), Some(2)) = (base, whole(exponent)) {
            return Some(Parts::real(self.modulus(inner, true)?));
        }
        // Of a broken power there are several.
        if let Expr::Call(Function::Exp, inner) = base
            && whole(exponent).is_some()
        {
            let inner = product([self.real(exponent)?, (**inner).clone()]);
            return self.parts(&Expr::Call(Function::Exp, inner.into()));
        }
        let base = self.parts(base)?;
        if base.is_real() {
            let exponent = self.real(exponent)?;
            return Some(Parts::real(Expr::Power(base.re.into(), exponent.into())));
        }
        let power = whole(exponent)?;
        // `i^2 = -1`
        let is_unit = is_zero(&base.re) && base.im == Expr::integer(1);
        let times = match is_unit {
            true => power.rem_euclid(4),
            false => power.abs(),
        };
        if times > LARGEST_POWER {
            return None;
        }
        let mut all = Parts::real(Expr::integer(1));
        for _ in 0..times {
            all = all.times(&base);
        }
        Some(match power < 0 && !is_unit {
            true => Parts::real(Expr::integer(1)).over(&all),
            false => all,
        })
    }

    /// The modulus of a term, or its square: `|a b| = |a| |b|`, and `|e^{i a}| = 1`; of a sum `\sqrt{a^2 + b^2}`.
    fn modulus(&self, term: &Expr, squared: bool) -> Option<Expr> {
        let of = |own: &Expr| self.modulus(own, squared);
        let of_real = |own: Expr| match squared {
            true => square(&own),
            false => Expr::Call(Function::Abs, own.into()),
        };
        if !self.concerns(term) {
            return Some(of_real(term.clone()));
        }
        Some(match term {
            Expr::Negate(inner) => of(inner)?,
            Expr::Quotient(above, below) => quotient(of(above)?, of(below)?),
            Expr::Product(factors) if !takes_a_part(factors) => {
                let factors = factors.iter().filter(|own| !self.is_unit_itself(own));
                let all: Vec<Expr> = factors.map(of).collect::<Option<_>>()?;
                product(all)
            }
            Expr::Call(Function::Exp, inner) => {
                let power = match (self.parts(inner)?.re, squared) {
                    (own, _) if is_zero(&own) => return Some(Expr::integer(1)),
                    (own, true) => product([Expr::integer(2), own]),
                    (own, false) => own,
                };
                Expr::Call(Function::Exp, power.into())
            }
            _ => {
                let parts = self.parts(term)?;
                match (is_zero(&parts.re), parts.is_real()) {
                    _ if squared => parts.squared(),
                    (_, true) => of_real(parts.re),
                    (true, _) => of_real(parts.im),
                    _ => Expr::Power(parts.squared().into(), half().into()),
                }
            }
        })
    }

    fn is_unit_itself(&self, term: &Expr) -> bool {
        matches!(term, Expr::Symbol(own) if self.units.contains(own))
    }
}

/// The real and the imaginary part of a term in which nothing but the unit is complex.
pub(crate) fn parts_of(term: &Expr, unit: &Symbol) -> Option<(Expr, Expr)> {
    let complex = Complex {
        units: &BTreeSet::from([unit.clone()]),
        complex: &BTreeSet::new(),
    };
    complex.parts(term).map(|own| (own.re, own.im))
}

/// The names of the parts of a complex symbol.
pub(super) fn part_names(symbol: &Symbol) -> (Symbol, Symbol) {
    let named = |part: &str| Symbol::new(format!("\\text{{{part}}}({})", symbol.name()));
    (named("Re"), named("Im"))
}

fn zero() -> Expr {
    Expr::integer(0)
}

fn half() -> Expr {
    Expr::Number(BigRational::new(1.into(), 2.into()))
}

pub(super) fn is_zero(term: &Expr) -> bool {
    matches!(term, Expr::Number(own) if own.is_zero())
}

fn is_one(term: &Expr) -> bool {
    matches!(term, Expr::Number(own) if own.is_one())
}

/// A whole number that is written as one.
fn whole(term: &Expr) -> Option<i64> {
    match term {
        Expr::Number(own) if own.is_integer() => own.to_integer().to_i64(),
        Expr::Negate(inner) => whole(inner)?.checked_neg(),
        _ => None,
    }
}

fn negative(term: Expr) -> Expr {
    match term {
        own if is_zero(&own) => own,
        Expr::Negate(inner) => (*inner).clone(),
        Expr::Sum(terms) => Expr::Sum(terms.iter().cloned().map(negative).collect()),
        own => Expr::Negate(own.into()),
    }
}

fn sum(terms: impl IntoIterator<Item = Expr>) -> Expr {
    let mut all: Vec<Expr> = Vec::new();
    for term in terms.into_iter().filter(|own| !is_zero(own)) {
        match term {
            Expr::Sum(inner) => all.extend(inner.iter().cloned()),
            own => all.push(own),
        }
    }
    match all.len() {
        0 => zero(),
        1 => all.remove(0),
        _ => Expr::Sum(all.into()),
    }
}

fn product(factors: impl IntoIterator<Item = Expr>) -> Expr {
    let (mut all, mut is_negative): (Vec<Expr>, bool) = (Vec::new(), false);
    for mut factor in factors {
        if is_zero(&factor) {
            return factor;
        }
        if let Expr::Negate(inner) = &factor {
            is_negative = !is_negative;
            factor = (**inner).clone();
        }
        match factor {
            Expr::Product(inner) => all.extend(inner.iter().cloned()),
            own if is_one(&own) => {}
            own => match all.last_mut() {
                Some(last) if *last == own => *last = square(&own),
                _ => all.push(own),
            },
        }
    }
    let product = match all.len() {
        0 => Expr::integer(1),
        1 => all.remove(0),
        _ => Expr::Product(all.into()),
    };
    match is_negative {
        true => negative(product),
        false => product,
    }
}

fn quotient(above: Expr, below: Expr) -> Expr {
    match above {
        own if is_zero(&own) || is_one(&below) => own,
        Expr::Negate(inner) => negative(quotient((*inner).clone(), below)),
        own => Expr::Quotient(own.into(), below.into()),
    }
}

fn square(term: &Expr) -> Expr {
    match term {
        own if is_zero(own) || is_one(own) => own.clone(),
        Expr::Negate(inner) => square(inner),
        own => Expr::Power(own.clone().into(), Expr::integer(2).into()),
    }
}

/// Whether a term has no more parts than are worth reading.
fn is_small(term: &Expr) -> bool {
    term.has_fewer_parts_than(MOST_TERMS)
}
