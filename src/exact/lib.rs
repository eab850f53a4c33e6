//! Claims decided exactly: the algebra, the search for evidence, and the small kernel that alone says what is proved. Nothing here
//! knows of documents.
//!
//! Use it as [`cradle_verify`](https://docs.rs/cradle-verify), whose documentation explains the whole.
#![forbid(unsafe_code)]

pub mod algebra;
pub mod dimension;
pub mod interval;
pub mod kernel;
pub mod search;
pub mod sorted;
