//! The LaTeX-math reader and its inverse, the printer: one for all formats.

mod statement;

pub use statement::{
    Clause, Connective, Display, Link, Mark, Side, Spanned, Statement, SyntaxError,
};
