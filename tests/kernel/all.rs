//! Forged evidence, and the reason for which the kernel rejects it; beside each forgery stands the valid evidence from
//! which it differs in one thing. `cargo test --test kernel roots::` runs one file.

mod algebraic;
mod claims;
mod closed_holes;
mod course;
mod dimensions;
mod exponentials;
mod family;
mod functions;
mod induction;
mod integrals;
mod knowledge;
mod logarithms;
mod obligations;
mod partial;
mod proofs;
mod rates;
mod readings;
mod roots;
mod running;
mod scaling;
mod search;
mod series;
mod unknown;
mod witnesses;
