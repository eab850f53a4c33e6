//! Documents as their authors wrote them: where the displayed equations are, what is said between
//! them, and what the `check:` comments declare. Every byte keeps its place.

mod span;

pub use span::Span;
