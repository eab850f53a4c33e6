//! Newton's cradle itself: collisions in exact rationals, and contacts that last in floating point.
//!
//! The balls stand on a line, numbered from the left, and move along it: a positive velocity points to the right. All
//! velocities are taken in one inertial frame, usually the one where the struck balls rest. Masses and velocities
//! are rational numbers and stay so, for a head-on collision is a rational map: outside of [`contact`] and [`ode`] no result
//! carries a rounding error, and these two say how large theirs are.
//!
//! - [`laws`]: momentum and kinetic energy of a line of balls.
//! - [`collision`]: two balls, elastic or with a coefficient of restitution.
//! - [`chain`]: a line of balls, colliding pair by pair until they part.
//! - [`mod@line`]: the same with gaps between the balls, so that it is known which pair is next.
//! - [`contact`]: collisions that take time: Hertz's law, damping, touching balls, heat and sound. [`ode`] integrates them.
//! - [`scenario`]: a proposed outcome, "two balls in, one out at twice the speed", and [`outcome`]: what the laws say to it.
//! - [`error`]: why masses and velocities make no chain and no scenario.
//! - [`number`]: exact numbers read from text.
//!
//! Invariant: nothing here reads an equation. This is the physics told a second time, from collisions rather than from
//! the algebra of a report, so that the two can be held against each other.

pub mod chain;
pub mod collision;
pub mod contact;
pub mod error;
pub mod laws;
pub mod line;
pub mod number;
pub mod ode;
pub mod outcome;
pub mod scenario;

pub use chain::{Chain, Encounter};
pub use collision::{efficiency, elastic, energy_loss, with_restitution};
pub use error::{ChainError, ScenarioError};
pub use laws::{Law, kinetic_energy, momentum};
pub use line::{Event, Limits, Line};
pub use number::{NumberError, list_text, parse_exact, parse_list};
pub use outcome::{Judgement, Outcome, Remark};
pub use scenario::Scenario;
