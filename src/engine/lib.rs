//! From a document to verdicts: what `cradle-verify` knows about documents, equations and derivations. How a claim is decided is in
//! [`cradle_exact`], how a verdict is shown is no part of it either.
//!
//! Use it as [`cradle_verify`](https://docs.rs/cradle-verify), whose documentation explains the whole.
#![forbid(unsafe_code)]

pub mod audit;
pub mod derivation;
pub mod document;
pub mod notation;
pub mod parallel;
mod sampling;

pub use cradle_exact::{algebra, dimension, interval, kernel, search, sorted};
