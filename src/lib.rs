//! Exact verification of the equations in a physics derivation.
//!
//! A report goes in as its author wrote it, in LaTeX or with LaTeX mathematics in Markdown. Out comes a verdict for every displayed
//! equation, with exact evidence: a certificate that it follows from what it is said to follow from, or a point in
//! exact numbers at which its premises are true and it is false. Where neither is found it is undecided.
//!
//! ```text
//!   .md ─► document ─► notation ─► derivation ─► search ─► kernel ─► report
//!        equations   LaTeX math    what must     finds     checks    terminal,
//!        tags, spans ─► Expr       follow from   evidence  evidence  JSON
//!        directives                what          (clever)  (small)
//! ```
//!
//! # A derivation as its own checker
//!
//! A [`Derivation`](derivation::Derivation) is read from text; an [`Audit`](audit::Audit) judges all of it. Here a
//! momentum balance is followed by one step that is right and one with a slip:
//!
//! ```
//! use cradle_verify::audit::{Audit, Outcome, Verdict};
//! use cradle_verify::derivation::Derivation;
//! use cradle_verify::notation::latex_formula;
//!
//! let derivation = Derivation::from_markdown(
//!     "carts.md",
//!     r"
//! # Two carts that stick together
//!
//! <!-- check: symbols M, m: mass, positive -->
//! <!-- check: law -->
//! $$ m v = (M + m) w \tag{1} $$
//!
//! Solved for the common velocity:
//! $$ w = \frac{m}{M + m} v \tag{2} $$
//!
//! The lost energy is, by (2),
//! $$ Q = \frac12 m v^2 - \frac12 (M + m) w^2 = \frac12 \frac{M m}{M - m} v^2 \tag{3} $$
//! ",
//! );
//! let audit = Audit::of(&derivation);
//! let verdicts: Vec<Verdict> = audit.entries.iter().map(|entry| entry.verdict).collect();
//! assert_eq!(verdicts, [Verdict::Given, Verdict::Holds, Verdict::Fails]);
//!
//! // The evidence for (2): the claim that was really proved, and the kernel's certificate for it.
//! let Outcome::Proven(proven) = &audit.entries[1].judged[0].outcome else { panic!() };
//! assert_eq!(latex_formula(&proven.claim().goal), r"w = \frac{m}{M + m} v");
//! assert!(proven.certificate().lemmas.is_empty());
//!
//! // The evidence against (3): exact values for every symbol.
//! let (judged, refuted) = audit.entries[2].refuted().unwrap();
//! assert!(latex_formula(&judged.goal.formula).ends_with(r"\frac{M m}{M - m} v^2"));
//! for (symbol, value) in &refuted.witness().symbols {
//!     println!("{symbol} = {value}");
//! }
//! ```
//!
//! Nobody needs to take that point on trust. A [`Checker`](derivation::Checker) is a derivation to be questioned:
//! it looks up any equation, evaluates both its sides at any exact point, and hunts for counterexamples.
//!
//! ```
//! use cradle_verify::derivation::{Checker, Point};
//!
//! let page = Checker::from_markdown("slip.md", r"
//! <!-- check: law -->
//! $$ s = \frac12 a t^2 \tag{1} $$
//! Hence
//! $$ 2 s = a t \tag{2} $$
//! ");
//! let refuted = page.hunt("2").unwrap();
//! let there = Point::at_witness(&refuted);
//! assert!(there.holds(&refuted.claim().hypotheses[0].formula).unwrap());
//! assert!(!there.holds(&refuted.claim().goal).unwrap());
//!
//! let elsewhere = Point::new().with("a", 2).with("t", 1).with("s", 1);
//! assert!(page.sides_at("2", &elsewhere).unwrap()[0].holds);
//! ```
//!
//! [`proofs::pages`] has such a handle for each page of the report on Newton's cradle that ships inside;
//! [`proofs::report`] is all of it together, which is what the bare command audits.
//!
//! [`config`] reads what an author has declared once for several documents, in a `cradle.toml` beside them.
//!
//! # Whom to believe
//!
//! [`search`] is clever and believed by nobody. [`kernel::check`] is the one place where a
//! [`Proven`](kernel::Proven) or [`Refuted`](kernel::Refuted) is built: it replays certificates and evaluates points,
//! with the exact arithmetic of [`algebra`] and nothing else. What a verdict is about is in
//! [`kernel::Claim`]: hypotheses, domains and the goal, which [`notation`] prints back as LaTeX.
//!
//! [`dimension`] infers what nobody declares, and is not believed either: [`kernel::dimension`] adds up what it hands
//! over, and alone builds the verdict that an equation compares what cannot be compared.
//!
//! [`cradle`] holds the physics of the cradle as code: collisions in exact rationals, and, in floating point with errors
//! stated, contacts that take time. It shares nothing with the route from LaTeX to verdicts, so
//! that each can be tested against the other.
//!
//! [`figures`] draws what audited equations say, in exact numbers until a place on paper is needed.
#![forbid(unsafe_code)]

#[doc(inline)]
pub use cradle_engine::{
    algebra, audit, derivation, dimension, document, interval, kernel, notation, parallel, search,
    sorted,
};

pub mod cli;
pub mod config;
pub mod cradle;
pub mod figures;
pub mod proofs;
pub mod report;

/// The README's own example, run as a test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;
