//! From a document to verdicts: what `cradle-verify` knows about documents, equations and proofs. How a verdict is shown is
//! no part of it.
//!
//! Use it as [`cradle_verify`](https://docs.rs/cradle-verify), whose documentation explains the whole.
#![forbid(unsafe_code)]

pub mod algebra;
pub mod audit;
pub mod derivation;
pub mod dimension;
pub mod document;
pub mod interval;
pub mod kernel;
pub mod notation;
pub mod parallel;
pub mod search;
pub mod sorted;
