//! Exact algebra: the terms that equations are made of, and polynomials over the rationals.

mod expr;
mod formula;
mod symbol;

pub use expr::{Expr, Function, LimitPoint};
pub use formula::{Formula, Relation};
pub use num_bigint::BigInt;
pub use num_rational::BigRational;
pub use symbol::Symbol;
