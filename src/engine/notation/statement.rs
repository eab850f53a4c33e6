use crate::algebra::{BigRational, Expr, Relation, Symbol};
use crate::document::Span;
use crate::sorted::Set;

/// A displayed equation as read: its number, and what it states.
#[derive(Clone, Debug)]
pub struct Display {
    /// The number from `\tag{…}`, as printed: `23`.
    pub tag: Option<Spanned<String>>,
    /// The key of `\label{…}`.
    pub label: Option<Spanned<String>>,
    /// The statements, in order (`a=b, \qquad c=d` are two), or why they could not be read.
    pub statements: Result<Vec<Statement>, SyntaxError>,
}

/// One statement: clauses joined by `\Rightarrow` or `\iff`, perhaps with the author's ✓ or ✗.
#[derive(Clone, Debug)]
pub struct Statement {
    /// Leading words, `Initial` in `\text{Initial: } v_0^2 + v_0^2 = 2 v_0^2`.
    pub label: Option<String>,
    /// The clauses; one more than there are connectives.
    pub clauses: Vec<Clause>,
    /// What joins each clause to the next.
    pub connectives: Vec<Spanned<Connective>>,
    /// The conditions under which it is said: `x < 0` in `a = b \quad \text{if } x < 0`, or of a case.
    pub under: Vec<Clause>,
    /// The author's own verdict.
    pub mark: Option<Spanned<Mark>>,
    /// The whole statement.
    pub span: Span,
    /// What it would be where a reader has a choice and takes the other way, each way by itself.
    pub others: Vec<Other>,
    /// The names that stand before a parenthesis or as a unit after a number, in order.
    pub before: Vec<Before>,
    /// What may be no power and no product, in order.
    pub doubts: Vec<Doubt>,
    /// What is said beside it of what runs through whole numbers: `n = 1, 2, \dots`.
    pub runs: Vec<Run>,
    /// What it is said of all values of: `\text{for all } x`.
    pub quantified: Set<Symbol>,
}

/// A symbol that runs through whole numbers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Run {
    /// The symbol.
    pub symbol: Symbol,
    /// The first of the numbers, if there is a first.
    pub from: Option<i64>,
    /// The last of them, if there is a last: `i = 1, 2`.
    pub to: Option<i64>,
}

/// A way to take a place that is not the one taken here; which that is, `docs/notation.md` says.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Choice {
    /// `a/bc` as `(a/b) c`, `1/2m` as `1/(2m)`: so many of the factors beside what a stroke divides by stand below it too.
    Below(u8),
    /// `\sin x y` as `(\sin x) y`: the argument of a function ends with the first name.
    FirstName,
    /// `\ln x^2` as `(\ln x)^2`: a power at the end of an argument is that of the function's value.
    OfValue,
    /// `P(t)` as `P \cdot t`.
    Product,
    /// `\cos\omega(t - t_0)` as `\cos(\omega (t - t_0))`: a group after the first name belongs to the argument.
    Group,
}

/// Another reading of a statement.
#[derive(Clone, Debug)]
pub struct Other {
    /// What is chosen otherwise, wherever there is this choice.
    pub choice: Choice,
    /// The first place where there is.
    pub span: Span,
    /// The statement read so.
    pub statement: Statement,
}

/// A name whose neighbour says what it is.
#[derive(Clone, Debug)]
pub struct Before {
    /// The name.
    pub name: Symbol,
    /// The name and its neighbour.
    pub span: Span,
    /// What it is read as.
    pub kind: BeforeKind,
}

/// What a name is read as for its neighbour's sake.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BeforeKind {
    /// A function of what is in the parenthesis after it.
    Function,
    /// A function whose value at a number this is, `x(0)`.
    Value,
    /// A factor before a parenthesis.
    Factor,
    /// A factor before a parenthesis in which it stands itself, `N (K - N)`: no argument holds the function that it is one of.
    Product,
    /// A factor before brackets, which only what is a quantity elsewhere is: `P[R + S]`, `\alpha(k^*)^2`.
    Quantity,
    /// A unit after a number, `5\,\mathrm{km}`.
    Unit,
    /// The number π, which degrees bring in, `30^\circ`.
    Degrees,
}

/// A place that is read as a power or a product, and may be meant otherwise: the page tells.
#[derive(Clone, Debug)]
pub struct Doubt {
    /// The place.
    pub span: Span,
    /// What is in doubt there.
    pub kind: DoubtKind,
}

/// What may be meant otherwise.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum DoubtKind {
    /// A name with nothing but letters for its exponent, which may be indices: `T^{\mu\nu}`.
    Raised {
        /// The name without its exponent, with its subscript.
        name: Symbol,
        /// The letters above it.
        letters: Vec<Symbol>,
    },
    /// `\Delta` or `\Sigma` right before what it would multiply: a difference, `\Delta(m v)`, or a sum, `\Sigma F`.
    Operator(Symbol),
    /// A symbol of which a sine, a cosine or a tangent is taken, right before a parenthesis that is read as a factor: `\sin\theta (1 - x)`.
    Angle(Symbol),
    /// A symbol of which a sine, a cosine or a tangent is taken, with a space before what else is read as its argument: `\cos\theta\,t`.
    Spaced(Symbol),
    /// A name that is read as applied to the brackets after it, `P(X > 3)`, unless it is a quantity itself.
    Applied(Symbol),
    /// A concentration right after a name or a number, whose unit it may be: `k [\mathrm{A}]`.
    Concentration(Symbol),
    /// Letters written without a space between them, which TeX sets as a product, and which spell something: `cos`, `intensity`.
    Letters {
        /// The letters.
        word: String,
        /// What they spell.
        spelt: Spelt,
    },
}

/// What letters side by side spell.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Spelt {
    /// The function of this name, perhaps with other letters: `cos`, `Acos`.
    Function(&'static str),
    /// A word between two statements: `or`, `if`.
    Between,
    /// A unit after a number: `5 kg`.
    Unit,
    /// `mod`.
    Remainder,
    /// A word.
    Word,
}

/// A clause of a statement.
#[derive(Clone, Debug)]
pub enum Clause {
    /// `a = b \le c`: sides and, between them, links. A single side with no link is not a statement and is refused.
    Chain {
        /// The sides; one more than there are links.
        sides: Vec<Side>,
        /// The relations between neighbouring sides.
        links: Vec<Link>,
    },
    /// `u_1 = u_2 = \dots = u_n`, perhaps `= w`.
    AllEqual {
        /// The sequence, `u`.
        sequence: Symbol,
        /// The index of the last element.
        to: Expr,
        /// The common value, where the chain goes on to name one.
        value: Option<Side>,
        /// The whole clause.
        span: Span,
    },
}

/// One side of a relation.
#[derive(Clone, Debug)]
pub struct Side {
    /// Whether it ends in dots, so that it is near to what it is said to be, and nobody knows how near: `1 + x + \dots`.
    pub truncated: bool,
    /// The term.
    pub expr: Expr,
    /// Where the side stands.
    pub span: Span,
    /// Where each top-level summand of `expr` stands, sign included, in order; one span when there is one summand.
    pub terms: Vec<Span>,
    /// How near it is meant, where it is one number.
    pub rounding: Option<Box<Rounding>>,
}

/// How near a printed number is meant.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Rounding {
    /// What share of the number may be missing or too much.
    pub share: BigRational,
    /// How that is seen.
    pub precision: Precision,
}

/// How it is seen how near a number is meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Precision {
    /// It is whole, and may be meant exactly: `300`.
    Whole,
    /// It has decimals: half a unit of the last one.
    Decimal,
    /// `\pm` says so.
    Stated,
}

/// A relation sign between two sides.
#[derive(Clone, Copy, Debug)]
pub struct Link {
    /// The relation.
    pub relation: Relation,
    /// `\stackrel{?}{=}`: the author asks rather than asserts.
    pub questioned: bool,
    /// Where the sign stands.
    pub span: Span,
}

/// What joins two clauses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Connective {
    /// `\Rightarrow`, `\implies`
    Implies,
    /// `\iff`, `\Leftrightarrow`
    Equivalent,
}

/// The author's own verdict beside an equation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    /// `\checkmark`, ✓: it holds.
    Tick,
    /// A trailing `\times`, ✗: it does not hold.
    Cross,
}

/// A value and where it stands in the source.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Spanned<T> {
    /// The value.
    pub value: T,
    /// Where it stands.
    pub span: Span,
}

/// Why a piece of mathematics could not be read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SyntaxError {
    /// The guilty token.
    pub span: Span,
    /// What is wrong, as a headline: "`\foo` is not known".
    pub message: String,
    /// What to write instead, where something can be said.
    pub help: Option<String>,
}
