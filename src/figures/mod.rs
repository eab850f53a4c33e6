//! Figures, drawn from the audited equations themselves.
//!
//! A figure evaluates the terms of a page's equations in exact numbers, through the derivation that is audited: there
//! is no second formula that could differ from the first. Its caption says which equations it rests on, and what the
//! audit finds of them.
//!
//! ```text
//!   Checker ─► Law, Decay ─► Figure: numbers (exact) ─► tables
//!                                    scene (points)  ─► svg, pdf, png
//! ```
//!
//! A [`Scene`] is paths and text with places. Its three writers need no library of the system and no font but the one
//! that ships inside, and the same scene gives the same bytes. Floating point says where something is drawn, never
//! what is said of it.
//!
//! ```
//! use cradle_verify::{figures, proofs};
//!
//! let figure = figures::collision(&proofs::checker()).unwrap();
//! let mu = figure.numbers.column("mu").unwrap();
//! let eta = figure.numbers.column("eta").unwrap();
//! let at = mu.iter().position(|mu| mu.to_string() == "3").unwrap();
//! assert_eq!(eta[at].to_string(), "3/4");
//! assert!(figures::svg(&figure.scene).starts_with("<svg "));
//! ```

mod collision;
mod decay;
mod energy;
mod error;
mod figure;
mod font;
mod halving;
mod law;
mod legend;
mod lithotripsy;
mod markup;
mod material;
mod numbers;
mod outcomes;
mod palette;
mod panel;
mod pdf;
mod png;
pub mod rich;
pub mod scene;
mod svg;
mod words;

pub use collision::collision;
pub use decay::{Decay, share};
pub use energy::energy;
pub use error::FigureError;
pub use figure::{Figure, Source};
pub use halving::first_half;
pub use law::{Audited, Law, Standing};
pub use lithotripsy::lithotripsy;
pub use markup::markup;
pub use material::{Material, MaterialError};
pub use numbers::Numbers;
pub use outcomes::outcomes;
pub use palette::{Palette, SERIES};
pub use pdf::pdf;
pub use png::png;
pub use scene::Scene;
pub use svg::svg;
pub use words::{alike, exact, rounded};
