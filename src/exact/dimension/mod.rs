//! Dimensions: what is declared is read, what is not declared is inferred, and what cannot be right is found.
//!
//! A dimension is a vector of rational exponents, and each equation of a document is a linear equation between such
//! vectors. [`parse`] reads a declared one. [`Inference`] takes up the statements in reading order, each reduced once
//! by those before it. A statement that fits teaches what its undeclared symbols are; one that does not is a
//! [`Conflict`], with the few comparisons that cannot all be right, multipliers with which all unknowns cancel from
//! them, and a change of units that makes one side grow more than the other. The evidence is built by the kernel
//! ([`crate::kernel::dimension`]); nothing in here is believed.
//!
//! Where nothing is declared nothing can disagree: then every symbol may be a pure number.

mod infer;
mod names;
pub mod occur;
mod parse;
mod rescale;
mod system;

pub use infer::{Conflict, Inference, Reading};
pub use names::{base_letter, base_name, declared_name, named, names, names_of};
pub use parse::{Unreadable, parse};
