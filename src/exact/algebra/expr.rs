use std::sync::Arc;

use num_traits::One;

use super::{BigInt, BigRational, Symbol};
use crate::sorted::Set;

/// Few terms speak of more symbols: so many are listed without asking for more room.
const FEW_SYMBOLS: usize = 4;

/// The terms directly below a term, in the order of reading.
#[derive(Clone, Debug)]
pub struct Children<'a> {
    /// Those with a place of their own come first; a term has these or those in a list.
    few: [Option<&'a Expr>; 3],
    many: std::slice::Iter<'a, Expr>,
}

impl<'a> Iterator for Children<'a> {
    type Item = &'a Expr;

    #[inline]
    fn next(&mut self) -> Option<&'a Expr> {
        match self.few {
            [None, ..] => self.many.next(),
            [first, second, third] => {
                self.few = [second, third, None];
                first
            }
        }
    }

    /// All that are left in one go: walks over whole terms are made of this.
    #[inline]
    fn fold<B, F: FnMut(B, &'a Expr) -> B>(self, start: B, mut join: F) -> B {
        let few = self.few.into_iter().flatten().fold(start, &mut join);
        self.many.fold(few, join)
    }
}

/// A mathematical term, as its author structured it. There is no floating point in it: decimals are rationals.
///
/// What stands below a term is shared: terms are copied far more often than they are changed.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Expr {
    /// An exact number.
    Number(BigRational),
    /// A symbol by its whole name.
    Symbol(Symbol),
    /// `u_i`: the element of a sequence at a bound index.
    Element {
        /// The sequence, `u`.
        sequence: Symbol,
        /// The index: the bound symbol of an enclosing [`Expr::Series`].
        index: Symbol,
    },
    /// A sum of two or more terms.
    Sum(Arc<[Expr]>),
    /// A product of two or more factors.
    Product(Arc<[Expr]>),
    /// `-a`.
    Negate(Arc<Expr>),
    /// `a / b` or `\frac{a}{b}`.
    Quotient(Arc<Expr>, Arc<Expr>),
    /// `a^b`; a root is a power with a fractional exponent.
    Power(Arc<Expr>, Arc<Expr>),
    /// A known function of one argument.
    Call(Function, Arc<Expr>),
    /// An unknown function applied to bare symbols: `P(t)`, `F(\delta, \dot\delta)`.
    Apply(Symbol, Arc<[Expr]>),
    /// `\sum_{index=from}^{to} body`.
    Series {
        /// The bound index.
        index: Symbol,
        /// The first value of the index.
        from: Arc<Expr>,
        /// The last value of the index.
        to: Arc<Expr>,
        /// The summand.
        body: Arc<Expr>,
    },
    /// `\frac{d}{dx} body`, a total derivative.
    Derivative {
        /// What is differentiated.
        body: Arc<Expr>,
        /// The variable.
        variable: Symbol,
    },
    /// `\frac{\partial}{\partial x} body`, a partial derivative.
    Partial {
        /// What is differentiated.
        body: Arc<Expr>,
        /// The variable.
        variable: Symbol,
        /// What is held fixed besides, where that is told: `\left(\frac{\partial U}{\partial V}\right)_T`. Elsewhere it is all else
        /// that the body is written in.
        held: Option<Box<[Symbol]>>,
    },
    /// `\lim_{x \to point} body`.
    Limit {
        /// What the limit is taken of.
        body: Arc<Expr>,
        /// The variable that moves.
        variable: Symbol,
        /// Where it goes.
        point: LimitPoint,
    },
    /// `\int_{from}^{to} body \, d variable`.
    Integral {
        /// The integrand.
        body: Arc<Expr>,
        /// The variable of integration.
        variable: Symbol,
        /// The lower limit.
        from: Arc<Expr>,
        /// The upper limit.
        to: Arc<Expr>,
    },
}

/// Where the variable of a limit goes.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum LimitPoint {
    /// A finite point.
    Finite(Arc<Expr>),
    /// `+\infty` or `\infty`.
    PlusInfinity,
    /// `-\infty`.
    MinusInfinity,
}

/// The functions that the notation knows by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Function {
    /// `\sin`
    Sin,
    /// `\cos`
    Cos,
    /// `\tan`
    Tan,
    /// `\arcsin`
    ArcSin,
    /// `\arccos`
    ArcCos,
    /// `\arctan`
    ArcTan,
    /// `\exp`
    Exp,
    /// `\ln`, and `\log` without a base
    Ln,
    /// `|x|`
    Abs,
    /// `\lceil x \rceil`
    Ceiling,
    /// `\lfloor x \rfloor`
    Floor,
}

impl Expr {
    /// Whether it is a number, a symbol, or put together from the terms below it by arithmetic.
    pub fn is_arithmetic(&self) -> bool {
        matches!(
            self,
            Expr::Number(_)
                | Expr::Symbol(_)
                | Expr::Sum(_)
                | Expr::Product(_)
                | Expr::Negate(_)
                | Expr::Quotient(..)
                | Expr::Power(..)
        )
    }

    /// An integer.
    pub fn integer(value: impl Into<BigInt>) -> Expr {
        Expr::Number(BigRational::from_integer(value.into()))
    }

    /// A symbol by its canonical name.
    pub fn symbol(name: &str) -> Expr {
        Expr::Symbol(Symbol::new(name))
    }

    /// The terms directly below this one.
    #[inline]
    pub fn children(&self) -> Children<'_> {
        let (few, many): (_, &[Expr]) = match self {
            Expr::Number(_) | Expr::Symbol(_) | Expr::Element { .. } => ([None; 3], &[]),
            Expr::Sum(items) | Expr::Product(items) | Expr::Apply(_, items) => ([None; 3], items),
            Expr::Negate(inner)
            | Expr::Call(_, inner)
            | Expr::Derivative { body: inner, .. }
            | Expr::Partial { body: inner, .. } => ([Some(&**inner), None, None], &[]),
            Expr::Quotient(a, b) | Expr::Power(a, b) => ([Some(&**a), Some(&**b), None], &[]),
            Expr::Series { from, to, body, .. } | Expr::Integral { from, to, body, .. } => {
                ([Some(&**from), Some(&**to), Some(&**body)], &[])
            }
            Expr::Limit { body, point, .. } => {
                let point = match point {
                    LimitPoint::Finite(point) => Some(&**point),
                    _ => None,
                };
                ([Some(&**body), point, None], &[])
            }
        };
        Children {
            few,
            many: many.iter(),
        }
    }

    /// Adds the symbols that are differentiated in it, once or more often.
    pub fn collect_differentiated(&self, found: &mut Set<Symbol>) {
        if let Expr::Derivative { body, .. } | Expr::Partial { body, .. } = self
            && let Expr::Symbol(symbol) = &**body
        {
            found.insert(symbol.clone());
        }
        self.children()
            .for_each(|child| child.collect_differentiated(found));
    }

    /// Adds the symbols that stand below a derivative in it, by themselves or in a product, `\frac{d}{dt}(b e^{k t})`, each with what it is
    /// differentiated by.
    pub fn collect_slopes(&self, found: &mut Set<(Symbol, Symbol)>) {
        if let Expr::Derivative { body, variable } | Expr::Partial { body, variable, .. } = self {
            let named = body.free_symbols().into_iter();
            found.extend(named.map(|own| (own, variable.clone())));
        }
        (self.children()).for_each(|child| child.collect_slopes(found));
    }

    /// Its derivative by a variable, to be worked out.
    pub fn differentiated_by(self, variable: &Symbol) -> Expr {
        Expr::Derivative {
            body: self.into(),
            variable: variable.clone(),
        }
    }

    /// Adds what is differentiated by in it.
    pub fn collect_variables(&self, found: &mut Set<Symbol>) {
        if let Expr::Derivative { variable, .. } = self {
            found.insert(variable.clone());
        }
        (self.children()).for_each(|child| child.collect_variables(found));
    }

    /// Adds the names in it that are applied to such arguments: `f` of `f(x)`.
    pub fn collect_applied(&self, such: &impl Fn(&[Expr]) -> bool, found: &mut Set<Symbol>) {
        if let Expr::Apply(name, arguments) = self
            && such(arguments)
        {
            found.insert(name.clone());
        }
        self.children()
            .for_each(|child| child.collect_applied(such, found));
    }

    /// The same term with each term directly below it replaced.
    pub fn map_children(&self, mut change: impl FnMut(&Expr) -> Expr) -> Expr {
        self.map_each_child(&mut change)
    }

    /// The same, compiled once for all changes.
    fn map_each_child(&self, change: &mut dyn FnMut(&Expr) -> Expr) -> Expr {
        let mut shared = |inner: &Expr| Arc::new(change(inner));
        match self {
            Expr::Number(_) | Expr::Symbol(_) | Expr::Element { .. } => self.clone(),
            Expr::Sum(items) => Expr::Sum(items.iter().map(change).collect()),
            Expr::Product(items) => Expr::Product(items.iter().map(change).collect()),
            Expr::Apply(name, items) => {
                Expr::Apply(name.clone(), items.iter().map(change).collect())
            }
            Expr::Negate(inner) => Expr::Negate(shared(inner)),
            Expr::Call(function, inner) => Expr::Call(*function, shared(inner)),
            Expr::Quotient(a, b) => Expr::Quotient(shared(a), shared(b)),
            Expr::Power(a, b) => Expr::Power(shared(a), shared(b)),
            Expr::Series {
                index,
                from,
                to,
                body,
            } => Expr::Series {
                index: index.clone(),
                from: shared(from),
                to: shared(to),
                body: shared(body),
            },
            Expr::Integral {
                variable,
                from,
                to,
                body,
            } => Expr::Integral {
                variable: variable.clone(),
                from: shared(from),
                to: shared(to),
                body: shared(body),
            },
            Expr::Derivative { body, variable } => Expr::Derivative {
                body: shared(body),
                variable: variable.clone(),
            },
            Expr::Partial {
                body,
                variable,
                held,
            } => Expr::Partial {
                body: shared(body),
                variable: variable.clone(),
                held: held.clone(),
            },
            Expr::Limit {
                body,
                variable,
                point,
            } => Expr::Limit {
                body: shared(body),
                variable: variable.clone(),
                point: match point {
                    LimitPoint::Finite(point) => LimitPoint::Finite(shared(point)),
                    other => other.clone(),
                },
            },
        }
    }

    /// The symbol that a term binds or works on: a sum's index, the variable of a derivative, limit or integral.
    pub fn binder(&self) -> Option<&Symbol> {
        match self {
            Expr::Series { index, .. } => Some(index),
            Expr::Derivative { variable, .. }
            | Expr::Partial { variable, .. }
            | Expr::Limit { variable, .. }
            | Expr::Integral { variable, .. } => Some(variable),
            _ => None,
        }
    }

    /// What is told to be held fixed while a partial derivative is taken.
    pub fn held(&self) -> &[Symbol] {
        match self {
            Expr::Partial {
                held: Some(held), ..
            } => held,
            _ => &[],
        }
    }

    /// Whether the term itself or any part of it is as asked, what is bound included.
    pub fn any(&self, is: &impl Fn(&Expr) -> bool) -> bool {
        is(self)
            || match self {
                // Most terms are one of these.
                Expr::Number(_) | Expr::Symbol(_) => false,
                Expr::Sum(terms) | Expr::Product(terms) => terms.iter().any(|term| term.any(is)),
                Expr::Quotient(a, b) | Expr::Power(a, b) => a.any(is) || b.any(is),
                Expr::Negate(inner) | Expr::Call(_, inner) => inner.any(is),
                _ => self.children().any(|child| child.any(is)),
            }
    }

    /// Whether it has fewer parts than so many, itself included; no more of them are counted.
    pub fn has_fewer_parts_than(&self, most: usize) -> bool {
        fn takes(term: &Expr, left: &mut usize) -> bool {
            *left = left.saturating_sub(1);
            *left > 0 && term.children().all(|part| takes(part, left))
        }
        takes(self, &mut { most })
    }

    /// Whether a symbol occurs anywhere, bound or free, as a sequence or as an index too.
    pub fn mentions(&self, symbol: &Symbol) -> bool {
        self.any(&|part| match part {
            Expr::Symbol(own) | Expr::Apply(own, _) => own == symbol,
            Expr::Element { sequence, index } => sequence == symbol || index == symbol,
            Expr::Partial { variable, .. } => variable == symbol || part.held().contains(symbol),
            _ => part.binder() == Some(symbol),
        })
    }

    /// What a binder binds its symbol in, and what lies outside of its scope: the limits of a sum or integral,
    /// the point of a limit.
    pub(crate) fn scope(&self) -> Option<(&Symbol, &Expr, Vec<&Expr>)> {
        match self {
            Expr::Series {
                index: bound,
                from,
                to,
                body,
            }
            | Expr::Integral {
                variable: bound,
                from,
                to,
                body,
            } => Some((bound, body, vec![from, to])),
            Expr::Limit {
                body,
                variable,
                point,
            } => match point {
                LimitPoint::Finite(point) => Some((variable, body, vec![point])),
                _ => Some((variable, body, Vec::new())),
            },
            _ => None,
        }
    }

    /// Whether it is the value of something at a place: `f(0)`, or where that is differentiated the limit there.
    pub fn is_value_somewhere(&self) -> bool {
        match self {
            Expr::Apply(..) => true,
            Expr::Limit { point, .. } => matches!(point, LimitPoint::Finite(_)),
            _ => false,
        }
    }

    /// The first that is found in a part of it.
    pub fn first<T>(&self, find: &dyn Fn(&Expr) -> Option<T>) -> Option<T> {
        find(self).or_else(|| self.children().find_map(|part| part.first(find)))
    }

    /// Whether it is a power of a root.
    pub fn is_root(&self) -> bool {
        fn is_broken(exponent: &Expr) -> bool {
            match exponent {
                Expr::Number(own) => !own.is_integer(),
                Expr::Negate(inner) => is_broken(inner),
                // `(R^2 + s^2)^{3/2}`
                Expr::Quotient(over, under) => match (&**over, &**under) {
                    (Expr::Number(over), Expr::Number(under)) => {
                        !num_traits::Zero::is_zero(under) && !(over / under).is_integer()
                    }
                    _ => false,
                },
                _ => false,
            }
        }
        matches!(self, Expr::Power(_, exponent) if is_broken(exponent))
    }

    /// Whether it is the logarithm of a number: `\ln 2`.
    pub fn is_logarithm_of_number(&self) -> bool {
        matches!(self, Expr::Call(Function::Ln, of) if matches!(**of, Expr::Number(_)))
    }

    /// The symbols that have a value of their own in this term: not indices, not the variables of
    /// limits and integrals. The variable of a derivative has one: the point at which it is taken.
    pub fn free_symbols(&self) -> Set<Symbol> {
        let mut free = Vec::with_capacity(FEW_SYMBOLS);
        self.collect_free(&mut Vec::new(), &mut free);
        free.into_iter().cloned().collect()
    }

    /// Adds the symbols of [`Expr::free_symbols`] to a sorted list.
    pub(super) fn collect_free<'a>(
        &'a self,
        bound: &mut Vec<&'a Symbol>,
        free: &mut Vec<&'a Symbol>,
    ) {
        match self {
            // Most terms are one of these, and bind nothing.
            Expr::Symbol(symbol) => add_free(symbol, bound, free),
            Expr::Number(_) => {}
            Expr::Sum(terms) | Expr::Product(terms) => {
                terms.iter().for_each(|e| e.collect_free(bound, free));
            }
            Expr::Quotient(a, b) | Expr::Power(a, b) => {
                a.collect_free(bound, free);
                b.collect_free(bound, free);
            }
            Expr::Negate(inner) | Expr::Call(_, inner) => inner.collect_free(bound, free),
            _ => self.collect_free_in_scope(bound, free),
        }
    }

    /// The same of terms that bind something, or speak of symbols beside the terms below.
    fn collect_free_in_scope<'a>(
        &'a self,
        bound: &mut Vec<&'a Symbol>,
        free: &mut Vec<&'a Symbol>,
    ) {
        if let Expr::Derivative { variable, .. } | Expr::Partial { variable, .. } = self {
            add_free(variable, bound, free);
            (self.held().iter()).for_each(|symbol| add_free(symbol, bound, free));
        }
        match self.scope() {
            Some((own, body, outside)) => {
                outside
                    .into_iter()
                    .for_each(|e| e.collect_free(bound, free));
                bound.push(own);
                body.collect_free(bound, free);
                bound.pop();
            }
            None => self.children().for_each(|e| e.collect_free(bound, free)),
        }
    }

    /// Puts a term in the place of every free occurrence of a symbol.
    pub fn substitute(&self, symbol: &Symbol, value: &Expr) -> Expr {
        match self {
            Expr::Symbol(own) if own == symbol => value.clone(),
            // What does not speak of it is shared.
            _ if !self.mentions(symbol) => self.clone(),
            // A derivative is taken at a point that cannot be put in under it.
            Expr::Derivative { variable, .. } if variable == symbol => self.clone(),
            Expr::Partial { variable, .. }
                if variable == symbol || self.held().contains(symbol) =>
            {
                self.clone()
            }
            _ => self.in_scope(symbol, |child| child.substitute(symbol, value)),
        }
    }

    /// Puts a term in the place of every occurrence of another, bound symbols in it included.
    pub fn replace(&self, what: &Expr, value: &Expr) -> Expr {
        match self == what {
            true => value.clone(),
            false => self.map_children(|child| child.replace(what, value)),
        }
    }

    /// Changes the terms below, but not the body of a binder of `symbol`.
    fn in_scope(&self, symbol: &Symbol, change: impl Fn(&Expr) -> Expr) -> Expr {
        let Some((own, body, _)) = self.scope() else {
            return self.map_children(change);
        };
        let bound = own == symbol;
        self.map_children(|child| match bound && std::ptr::eq(child, body) {
            true => child.clone(),
            false => change(child),
        })
    }

    /// The summand of a series at a definite position, from 1: `u_i^2` at 3 is `u_3^2`.
    pub fn at_index(&self, index: &Symbol, position: u32) -> Expr {
        match self {
            Expr::Symbol(own) if own == index => Expr::integer(position),
            Expr::Element {
                sequence,
                index: own,
            } if own == index => Expr::Symbol(super::element_symbol(sequence, position)),
            _ => self.in_scope(index, |child| child.at_index(index, position)),
        }
    }

    /// Whether an element of a sequence occurs.
    pub fn has_elements(&self) -> bool {
        self.any(&|part| matches!(part, Expr::Element { .. }))
    }

    /// Whether this is the number 1.
    pub fn is_one(&self) -> bool {
        matches!(self, Expr::Number(value) if value.is_one())
    }
}

/// Adds a symbol that is not bound to a sorted list.
fn add_free<'a>(symbol: &'a Symbol, bound: &[&'a Symbol], free: &mut Vec<&'a Symbol>) {
    if bound.contains(&symbol) {
        return;
    }
    // Few claims speak of so many that the place is found sooner than from one end to the other.
    let at = free.iter().position(|own| *own >= symbol);
    match at {
        Some(at) if free[at] == symbol => {}
        at => free.insert(at.unwrap_or(free.len()), symbol),
    }
}
