//! Forged evidence, and the reason for which the kernel rejects it; beside each forgery stands the valid evidence from
//! which it differs in one thing.

#[path = "kernel/algebraic.rs"]
mod algebraic;
#[path = "kernel/claims.rs"]
mod claims;
#[path = "kernel/course.rs"]
mod course;
#[path = "kernel/dimensions.rs"]
mod dimensions;
#[path = "kernel/functions.rs"]
mod functions;
#[path = "kernel/induction.rs"]
mod induction;
#[path = "kernel/knowledge.rs"]
mod knowledge;
#[path = "kernel/obligations.rs"]
mod obligations;
#[path = "kernel/proofs.rs"]
mod proofs;
#[path = "kernel/readings.rs"]
mod readings;
#[path = "kernel/roots.rs"]
mod roots;
#[path = "kernel/scaling.rs"]
mod scaling;
#[path = "kernel/search.rs"]
mod search;
#[path = "kernel/series.rs"]
mod series;
#[path = "kernel/witnesses.rs"]
mod witnesses;
