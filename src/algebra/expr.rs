use super::{BigRational, Symbol};

/// A mathematical term, as its author structured it. There is no floating point in it: decimals are rationals.
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
    Sum(Vec<Expr>),
    /// A product of two or more factors.
    Product(Vec<Expr>),
    /// `-a`.
    Negate(Box<Expr>),
    /// `a / b` or `\frac{a}{b}`.
    Quotient(Box<Expr>, Box<Expr>),
    /// `a^b`; a root is a power with a fractional exponent.
    Power(Box<Expr>, Box<Expr>),
    /// A known function of one argument.
    Call(Function, Box<Expr>),
    /// An unknown function applied to bare symbols: `P(t)`, `F(\delta, \dot\delta)`.
    Apply(Symbol, Vec<Expr>),
    /// `\sum_{index=from}^{to} body`.
    Series {
        /// The bound index.
        index: Symbol,
        /// The first value of the index.
        from: Box<Expr>,
        /// The last value of the index.
        to: Box<Expr>,
        /// The summand.
        body: Box<Expr>,
    },
    /// `\frac{d}{dx} body`, a total derivative.
    Derivative {
        /// What is differentiated.
        body: Box<Expr>,
        /// The variable.
        variable: Symbol,
    },
    /// `\lim_{x \to point} body`.
    Limit {
        /// What the limit is taken of.
        body: Box<Expr>,
        /// The variable that moves.
        variable: Symbol,
        /// Where it goes.
        point: LimitPoint,
    },
    /// `\int_{from}^{to} body \, d variable`.
    Integral {
        /// The integrand.
        body: Box<Expr>,
        /// The variable of integration.
        variable: Symbol,
        /// The lower limit.
        from: Box<Expr>,
        /// The upper limit.
        to: Box<Expr>,
    },
}

/// Where the variable of a limit goes.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum LimitPoint {
    /// A finite point.
    Finite(Box<Expr>),
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
