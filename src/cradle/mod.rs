//! Newton's cradle itself, in exact rationals.
