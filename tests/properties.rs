//! The report's pages against the physics in `src/cradle`, which shares no code with the reading of equations; and the
//! audit against its own evidence. All of it goes through the handles that anybody can use.

#[path = "properties/algebraic.rs"]
mod algebraic;
#[path = "properties/broken.rs"]
mod broken;
#[path = "properties/claims.rs"]
mod claims;
#[path = "properties/corrected.rs"]
mod corrected;
#[path = "properties/functions.rs"]
mod functions;
#[path = "properties/pages.rs"]
mod pages;
#[path = "properties/physics.rs"]
mod physics;
#[path = "properties/roots.rs"]
mod roots;
#[path = "properties/scaling.rs"]
mod scaling;
#[path = "properties/spellings.rs"]
mod spellings;
