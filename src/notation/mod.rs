//! The LaTeX-math reader and its inverse, the printer: one for all formats.

mod commands;
mod fold;
mod lexer;
mod parser;
mod printer;
mod read;
mod statement;

pub use printer::{latex, latex_formula, latex_statement, plain, plain_formula, relation_latex};
pub use read::{read_display, read_expr, read_formulas, read_symbol};
pub use statement::{
    Clause, Connective, Display, Link, Mark, Side, Spanned, Statement, SyntaxError,
};
