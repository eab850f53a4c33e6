//! The report's pages against the physics in `src/cradle`, which shares no code with the reading of equations; and the
//! audit against its own evidence. All of it goes through the handles that anybody can use.

mod algebraic;
mod broken;
mod claims;
mod corrected;
mod functions;
mod pages;
mod partial;
mod physics;
mod roots;
mod scaling;
mod spellings;
