//! Exact algebra: the terms that equations are made of, and polynomials over the rationals.
//!
//! [`Expr`] and [`Formula`] keep what the author wrote. [`Lowering`] turns a term into a [`Fraction`] of
//! [`Polynomial`]s in [`Atoms`] and notes what must not vanish on the way. Everything is exact: there is no
//! floating point here, and every operation that could grow without bound returns [`TooLarge`] instead, as does what is
//! asked for after all the work allowed for a question is done ([`effort`]).

mod atom;
mod conditions;
mod derivative;
mod differential;
mod dimension;
mod division;
pub mod effort;
mod endless;
mod evaluate;
mod expansion;
mod expr;
mod formula;
mod fraction;
mod function;
mod indexed;
mod integral;
mod limit;
mod lower;
mod monomial;
mod partial;
mod polynomial;
mod power;
mod power_sum;
mod rational;
mod residue;
mod series;
mod sum;
mod symbol;
mod terms;
mod univariate;
mod written;

pub use atom::{Atom, Atoms};
pub use conditions::{Conditions, Needed};
pub use dimension::{Base, Dimension};
pub use evaluate::{EvaluateError, Sides, Values};
pub use expr::{Children, Expr, Function, LimitPoint};
pub use formula::{Formula, Relation};
pub use fraction::{Fraction, factors, product, times_all};
pub use function::{Functions, SineCosine, multiplied};
pub use indexed::{Moved, Place, element_at, element_parts, element_symbol, running_symbol};
pub use lower::{LowerError, Lowering, sign_of_fraction};
pub use monomial::{Monomial, Var};
pub use num_bigint::BigInt;
pub use num_rational::BigRational;
pub use partial::Held;
pub use polynomial::{Polynomial, TooLarge};
pub use power::Powers;
pub use power_sum::power_sum;
pub use rational::Rational;
pub use series::mentions_symbol;
pub use symbol::split_subscript;
pub use symbol::{Symbol, another_meaning, as_printed};
pub use univariate::{Univariate, sum_of_signs};
pub use written::{expr_of, expr_of_atom, expr_of_fraction, product_of, raised};
