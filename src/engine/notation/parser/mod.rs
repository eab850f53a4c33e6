//! From tokens to statements, by recursive descent: one file per kind of thing that is read.
//!
//! `statement` reads what is said, `cases` what is said under conditions, `quantifier` of what all it is said, `aside` remarks beside it, `reason` what it cites there, `shared` what is said of several names at once, `term` the arithmetic, `atom`, `group` and `function` single factors, `quantity` and `unit` numbers with units, `count` factorials and binomial coefficients, `name` whole
//! symbol names, `doubt` and `word` what may be no power and no product, `vector` what may be no number, `series` the sums over an index and the ones with dots, `calculus` derivatives, integrals and limits, `partial` partial derivatives, `primitive` integrals without limits,
//! `between` what a term grows by from one limit to another, `both` what is said with `\pm`, `bracketed` quantities that are written with brackets, `rounding` how near a number is meant.
//!
//! Invariant: every token is either used or named in an error. Nothing is skipped. Nesting is bounded by
//! [`DEPTH`], so that no input can exhaust the stack.

mod argument;
mod aside;
mod atom;
mod between;
mod both;
mod bracketed;
mod calculus;
mod cases;
mod count;
mod doubt;
mod function;
mod group;
mod name;
mod partial;
mod primitive;
mod progression;
mod quantifier;
mod quantity;
mod reason;
mod rounding;
mod series;
mod shared;
mod statement;
mod term;
mod unit;
mod vector;
mod word;
mod worked_out;

pub(crate) use function::{angle_of, argument_of};
pub(super) use function::{is_minus_one, stem};
pub(crate) use name::with_subscript;
pub(super) use quantity::product as quantity_of;

use std::collections::BTreeSet;
use std::convert::Infallible;

use super::commands;
use super::lexer::{Kind, Token};
use super::{
    Before, BeforeKind, Choice, Clause, Context, Doubt, DoubtKind, Run, Side, SyntaxError, Through,
};
use between::Limits;

use crate::algebra::{Expr, Symbol};
use crate::document::Span;
use crate::sorted::Set;

/// How deep the reader may recurse; a group costs it two or three steps. People stop at ten groups.
const DEPTH: usize = 200;
/// The longest numeral, in digits.
const DIGITS: usize = 2_000;

/// The result of reading a part of a formula.
type Read<T> = Result<T, SyntaxError>;

/// The reader's place in the tokens, and what it must remember there.
pub(super) struct Parser<'s> {
    tokens: Vec<Token<'s>>,
    errors: Vec<SyntaxError>,
    body: Span,
    /// Whether the word `and` separates formulas here.
    words: bool,
    at: usize,
    depth: usize,
    /// The indices bound by the sums around this place.
    bound: Vec<String>,
    /// Whether `dx` ends the integrand that is being read.
    integrand: bool,
    /// The variable of a differential that stands above the stroke of a fraction, `\int \frac{dx}{x}`; it ends the integrand.
    differential: Option<Symbol>,
    /// Which sign a `\pm` is read as, where that is read.
    signs: Option<both::Signs>,
    /// The integrals without limits in the equation that is being read.
    primitives: Vec<primitive::Primitive>,
    /// The variables of the integrals read so far, with their limits.
    integrals: Vec<(Symbol, Limits)>,
    /// What runs to the bar after the term that was read last, where nothing opens it: `f |_a^b`.
    barred: Option<Symbol>,
    /// Whether the innermost open delimiter is a bare `|`, so that the next one closes it.
    bar: bool,
    /// Whether this is in the argument of a sine, a cosine or a tangent, where degrees are read.
    angle: bool,
    /// Whether this is in the argument of a hyperbolic function.
    doubled: bool,
    /// Whether a name by itself may be all of the argument here: in `\sin\theta`, `\cosh\eta`.
    of_angle: bool,
    /// Whether a side is read, and if so, whether it ends in dots: `1 + x + \dots`.
    truncated: Option<bool>,
    /// The places of the summands of the sum that was read last.
    summands: Vec<Span>,
    /// The name that was read last, for braces around nothing but a name: `{v'_1}^2`.
    last_name: Option<LastName>,
    /// The tokens of the group that was read last, its delimiters among them.
    last_group: Option<(usize, usize)>,
    /// What is chosen in the other way here.
    choice: Option<Choice>,
    /// The places where there is a choice.
    choices: Vec<(Choice, Span)>,
    /// The names that the page has as functions.
    applied: Option<&'s BTreeSet<Symbol>>,
    /// The names that the page has as functions and without an argument, too.
    valued: Option<&'s BTreeSet<Symbol>>,
    /// What the sums of the page run through.
    run: Option<&'s Through>,
    /// Whether the page speaks of concentrations.
    has_concentrations: bool,
    /// The names that stand before a parenthesis.
    before: Vec<Before>,
    /// The places that may be no power and no product.
    doubts: Vec<Doubt>,
    /// The quantities with brackets in the statement that is being read.
    bracketed: Vec<bracketed::Bracketed>,
    /// What runs through whole numbers, as is said after the statement that is being read.
    runs: Vec<Run>,
    /// What that statement is said of all values of.
    quantified: Set<Symbol>,
    /// The cases of the clause that was read last.
    cases: Vec<Case>,
    /// A group after a name that turned out to be a factor, not an argument: `v_0(1 - \mu)`.
    pending: Option<Factor>,
}

/// One of the cases of a side: the side there, and when it is that.
struct Case {
    side: Side,
    under: Vec<Clause>,
    span: Span,
}

/// A name, and the tokens it was read from.
struct LastName {
    name: name::Name,
    start: usize,
    end: usize,
}

/// How firmly the parts of a term hold together, as a reader of the printed page sees them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Shape {
    /// Digits.
    Number,
    /// A name, a fraction, a group with visible delimiters.
    Tight,
    /// Something with a superscript.
    Power,
    /// A sum, a product, a sign: braces around it cannot be seen.
    Loose,
}

/// A factor as read.
struct Factor {
    expr: Expr,
    shape: Shape,
    span: Span,
    /// Whether braces, which TeX does not print, are all that holds it together.
    braces: bool,
}

/// A term as read.
struct Term {
    expr: Expr,
    shape: Shape,
    span: Span,
    negative: bool,
    /// Whether braces are all that holds a loose term together.
    braces: bool,
}

fn refuse<T>(span: Span, message: impl Into<String>) -> Read<T> {
    Err(SyntaxError {
        span,
        message: message.into(),
        help: None,
    })
}

fn refuse_with<T>(span: Span, message: impl Into<String>, help: impl Into<String>) -> Read<T> {
    Err(SyntaxError {
        span,
        message: message.into(),
        help: Some(help.into()),
    })
}

/// The refusal of a matrix.
fn no_matrix<T>(span: Span) -> Read<T> {
    refuse_with(
        span,
        "the notation has no matrices",
        "write the equations of their entries",
    )
}

impl<'s> Parser<'s> {
    /// With what the page tells of its notation.
    pub(in crate::notation) fn within(mut self, context: &'s Context) -> Self {
        self.applied = Some(&context.applied).filter(|own| !own.is_empty());
        self.valued = Some(&context.valued).filter(|own| !own.is_empty());
        self.run = context.run.as_ref();
        self.has_concentrations = context.has_concentrations;
        self
    }

    pub(super) fn new(
        tokens: Vec<Token<'s>>,
        errors: Vec<SyntaxError>,
        body: Span,
        words: bool,
    ) -> Self {
        Parser {
            tokens,
            errors,
            body,
            words,
            at: 0,
            depth: 0,
            bound: Vec::new(),
            integrand: false,
            differential: None,
            signs: None,
            primitives: Vec::new(),
            integrals: Vec::new(),
            barred: None,
            bar: false,
            angle: false,
            doubled: false,
            applied: None,
            valued: None,
            run: None,
            has_concentrations: false,
            of_angle: false,
            truncated: None,
            summands: Vec::new(),
            last_name: None,
            last_group: None,
            choice: None,
            choices: Vec::new(),
            before: Vec::new(),
            doubts: Vec::new(),
            bracketed: Vec::new(),
            cases: Vec::new(),
            runs: Vec::new(),
            quantified: Set::new(),
            pending: None,
        }
    }

    /// Reads one term and nothing after it.
    pub(super) fn whole_term(mut self) -> Read<Expr> {
        let term = self.sum()?;
        self.no_primitive_is_left()?;
        match self.peek() {
            Kind::End => Ok(term.expr),
            _ => self.unexpected(),
        }
    }

    fn kind(&self, at: usize) -> Kind<'s> {
        self.tokens.get(at).map_or(Kind::End, |token| token.kind)
    }

    fn peek(&self) -> Kind<'s> {
        self.kind(self.at)
    }

    /// The place of the next token; at the end, that of the last.
    fn span(&self) -> Span {
        self.tokens
            .get(self.at)
            .or(self.tokens.last())
            .map_or(self.body, |token| token.span)
    }

    /// From the token at `start` to the one before this place.
    fn since(&self, start: usize) -> Span {
        let first = self.tokens.get(start).map_or(self.body, |token| token.span);
        let last = self
            .at
            .checked_sub(1)
            .and_then(|at| self.tokens.get(at))
            .map_or(first, |token| token.span);
        if last.end < first.start {
            first
        } else {
            first.to(last)
        }
    }

    fn advance(&mut self) {
        self.at += 1;
    }

    fn accept(&mut self, kind: Kind) -> bool {
        let found = self.peek() == kind;
        if found {
            self.advance();
        }
        found
    }

    /// Takes the `}` of the group that opened at `open`.
    fn close(&mut self, open: Span) -> Read<()> {
        match self.peek() {
            Kind::Close => {
                self.advance();
                Ok(())
            }
            Kind::End => refuse(open, "this brace is never closed"),
            _ => self.unexpected(),
        }
    }

    /// Reads something nested, keeping count of the depth.
    fn nested<T>(&mut self, read: impl FnOnce(&mut Self) -> Read<T>) -> Read<T> {
        if self.depth >= DEPTH {
            return refuse(self.span(), "this is nested too deeply to be read");
        }
        self.depth += 1;
        let result = read(self);
        self.depth -= 1;
        result
    }

    /// Reads what stands between delimiters, where neither a bare `|` nor a `dx` of outside counts.
    fn inside<T>(&mut self, bar: bool, read: impl FnOnce(&mut Self) -> Read<T>) -> Read<T> {
        let outside = (self.bar, self.integrand);
        (self.bar, self.integrand) = (bar, false);
        let result = self.nested(read);
        (self.bar, self.integrand) = outside;
        result
    }

    /// The refusal of the next token, which cannot stand where it stands.
    fn unexpected<T>(&self) -> Read<T> {
        self.unexpected_here().map(|never| match never {})
    }

    /// The same, compiled once for all that might have been read.
    fn unexpected_here(&self) -> Read<Infallible> {
        let span = self.span();
        match self.peek() {
            Kind::Bad(number) => match self.errors.get(number) {
                Some(error) => Err(error.clone()),
                None => refuse(span, "this cannot be read"),
            },
            Kind::End => refuse(span, "the formula ends where something more is expected"),
            Kind::Command(name) => {
                let (message, help) = commands::complaint(name);
                Err(SyntaxError {
                    span,
                    message,
                    help,
                })
            }
            Kind::Relation(..) => refuse(span, "a relation sign cannot stand here"),
            Kind::Connective(_) => refuse(
                span,
                "an implication joins whole statements, so it cannot stand here",
            ),
            Kind::Mark(_) => refuse(span, "a mark belongs at the end of a statement"),
            Kind::Wide => refuse(
                span,
                "a wide space, such as `\\quad`, separates statements, so it cannot stand inside one",
            ),
            Kind::Row => refuse(span, "a new row cannot start here"),
            Kind::Reference(_) => refuse_with(
                span,
                "an equation is cited in the mathematics, where it says nothing",
                "cite it in the text, or above a relation sign: `\\overset{\\eqref{…}}{=}`",
            ),
            Kind::Cell => refuse_with(
                span,
                "a second column is read only beside the cases of one side of a relation",
                "write `f = \\begin{cases} a & x < 0 \\\\ b & x \\geq 0 \\end{cases}`",
            ),
            Kind::And => refuse_with(
                span,
                "the word `and` stands in the mathematics, where TeX sets it as a product of three symbols",
                "write `\\text{ and }`",
            ),
            Kind::Text(words) if reason::gives_reason(words) => refuse_with(
                span,
                format!(
                    "the reason `{}` is not read beside a statement",
                    words.trim()
                ),
                "give it in the text; what is cited is read, as in `\\text{by (1)}`",
            ),
            Kind::Text(words) => refuse_with(
                span,
                format!("the words `{}` cannot be read here", words.trim()),
                "words are read as a label in front (`\\text{Initial: }`), as `\\text{and}` between statements, \
                 or as a name",
            ),
            Kind::Begin(name) if name.ends_with("matrix") => no_matrix(span),
            Kind::Begin(name) => {
                refuse(span, format!("the environment `{name}` cannot start here"))
            }
            Kind::Finish(name) => refuse(span, format!("the environment `{name}` cannot end here")),
            Kind::BoxOpen => refuse(span, "a boxed relation must be a whole statement"),
            Kind::Open | Kind::BoxClose => refuse(span, "a brace cannot stand here"),
            Kind::Close => refuse(span, "this `}` closes nothing that is open here"),
            Kind::Number(text) => refuse(span, format!("the number `{text}` cannot stand here")),
            Kind::Quantity(..) => refuse(span, "a quantity with a unit cannot stand here"),
            Kind::Letter(c) => refuse(span, format!("`{c}` cannot stand here")),
            Kind::Upright(text) | Kind::Operator(text) => {
                refuse(span, format!("`{text}` cannot stand here"))
            }
            Kind::Char('^') => refuse(span, "this superscript belongs to nothing"),
            Kind::Char('_') => refuse(span, "this subscript belongs to nothing"),
            Kind::Char('!') => refuse_with(
                span,
                "only factorials of numerals are read, as `3!`",
                "for a few factors write the product: `n (n - 1)`",
            ),
            Kind::Char(c @ (')' | ']' | '|')) => {
                refuse(span, format!("`{c}` closes nothing that is open here"))
            }
            Kind::Char(',' | ';') => refuse(
                span,
                "a comma or semicolon separates statements, so it cannot stand here",
            ),
            Kind::Char(c) => refuse(span, format!("`{c}` cannot stand here")),
        }
    }

    /// The refusal of this place, where a term should stand.
    fn no_term<T>(&self) -> Read<T> {
        self.no_term_here().map(|never| match never {})
    }

    fn no_term_here(&self) -> Read<Infallible> {
        let span = self.span();
        match self.peek() {
            Kind::Relation(..) => refuse(span, "a term is missing before this relation sign"),
            Kind::End if self.tokens.is_empty() => refuse(span, "there is nothing here to read"),
            Kind::End => refuse(span, "a term is missing after this"),
            Kind::Close => refuse(span, "a term is missing before this brace"),
            Kind::BoxClose => refuse(span, "a term is missing before the end of the box"),
            Kind::Char('+' | '-') => refuse_with(
                span,
                "two signs stand side by side",
                "put the signed term in parentheses",
            ),
            Kind::Command("cdot" | "times") | Kind::Char('*' | '/') => {
                refuse(span, "a factor is missing before this sign")
            }
            Kind::Command(name) if commands::is_dots(name) => refuse(
                span,
                "dots are read only between `+` signs, as in `u_1 + \\cdots + u_k`, or between `=` signs",
            ),
            Kind::Char(c @ (')' | ']' | '|')) => {
                refuse(span, format!("a term is missing before `{c}`"))
            }
            Kind::Char(',' | ';' | '.') => {
                refuse(span, "a term is missing before this punctuation")
            }
            _ => self.unexpected(),
        }
    }
}
