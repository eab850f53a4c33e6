//! The LaTeX-math reader and its inverse, the printer: one for all formats.
//!
//! `lexer` makes tokens, `fold` joins the signs that are spelt with several, `parser` builds statements, `printer` goes
//! back. What cannot be read is refused by name and place; nothing is skipped or guessed. `typeset` shows on a page what
//! was typed, read or not. Where physicists' notation leaves a choice, this is what is chosen:
//!
//! - Names side by side behind a `/` stand below it, `t/RC` is `t/(RC)`, but `1/2m` is `(1/2)m`.
//! - A symbol directly before parentheses that hold only bare symbols, `P(t)`, is a function; `v_0(1-\mu)` is a product.
//! - `\sum`, `\lim` and `\frac{d}{dx}` take the product that follows them; `\frac{d}{dx}[f] g` is refused.
//! - `\sin` without parentheses takes the plain factors side by side that follow, up to a rate (`\dot\theta`) or a differential; a group or a sign of multiplication
//!   right after them is refused.
//! - Braces do not show on the page, so `{a + b} c` is refused.
//! - `\times` with nothing after it is the author's ✗.
//! - `f = \begin{cases} a & x < 0 \\ b & x \geq 0 \end{cases}` is two statements, each under its condition.
//! - `\frac12` is a quotient of two numbers; a decimal is one number; `\sqrt[n]{x}` is `x` to the number `1/n`.

mod beside;
mod commands;
mod figures;
mod fold;
mod lexer;
mod parser;
mod places;
mod printer;
mod read;
mod shorthand;
mod signs;
mod statement;
mod typeset;
mod unit;

pub(crate) use beside::{are_of_one_system, is_in_units, si_beside};
pub(crate) use commands::is_command;
pub(crate) use figures::{
    has_decimals, has_units, in_si, is_degrees, is_figures, units_beside, without_units,
};
pub use lexer::is_constant_word;
pub(crate) use parser::{angle_of, argument_of, with_subscript};
pub(crate) use places::{is_composed_place, names_a_place};
pub(crate) use printer::decimal_places;
pub use printer::{
    escape, escape_by, latex, latex_formula, latex_statement, mathml, mathml_formula,
    mathml_statement, plain, plain_formula, plain_statement, plain_symbol, relation_latex,
    unbraced,
};
pub use read::{
    Context, Through, Unit, read_display, read_expr, read_formulas, read_on_page, read_rows,
    read_symbol, read_unaligned,
};
pub use statement::{
    Before, BeforeKind, Choice, Clause, Connective, Display, Doubt, DoubtKind, Link, Mark, Other,
    Precision, Rounding, Run, Side, Spanned, Spelt, Statement, SyntaxError,
};
pub use typeset::typeset;
pub use unit::measured;
