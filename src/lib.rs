//! Exact verification of the equations in a physics derivation.
#![forbid(unsafe_code)]

pub mod algebra;
pub mod audit;
pub mod cli;
pub mod cradle;
pub mod derivation;
pub mod document;
pub mod kernel;
pub mod notation;
pub mod proofs;
pub mod report;
pub mod search;
