//! Balls that are pressed together for a while: contact as a force, integrated in time, in floating point.
//!
//! The rest of [`cradle`](super) lets balls collide in an instant and stays exact. Here a collision lasts: a law of
//! force, Newton's second law, and numbers. They say that they are numeric: each comes as a [`Numeric`] with an
//! estimate of its error, or as an [`Interval`] that contains it.
//!
//! - [`law`]: Hertz's force and its viscoelastic companion, and what is known exactly about an impact.
//! - [`impact`]: two identical balls, one at rest, from touch to separation.
//! - [`scaling`]: the exponents of its power laws, measured.
//! - [`touching`]: a line of balls that touch from the start, where no collision is only between two.
//! - [`interval`]: positive numbers known to within bounds.
//! - [`energies`]: heat against sound for a real ball.
//!

pub mod energies;
pub mod impact;
pub mod interval;
pub mod law;
pub mod numeric;
pub mod scaling;
pub mod touching;

pub use energies::{Air, Estimate, Material, heat_against_sound};
pub use impact::{End, Impact, Rebound};
pub use interval::Interval;
pub use law::Contact;
pub use numeric::{ContactError, Numeric};
pub use scaling::{Parameter, Quantity, exponent};
pub use touching::{Parting, TouchingBalls};
