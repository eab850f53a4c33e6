//! What is tried again where a step does not follow from what it cites, or follows only as nobody means it.
//!
//! Authors cite less than they use: the display before ([`going_on`]), what else stands before ([`borrowed`], [`rescue`]), what the words name
//! ([`named`], [`there`], [`unitless`]). They leave unsaid that something is not 0 ([`unstated`], [`conditions`]), that it is so for every
//! value of a variable ([`throughout`]), in a limit ([`limiting`]), up to an order ([`expanded`]) or where something has a value ([`solution`]); what is no solution of the
//! law that it is said to solve is told to be none ([`obeys`]). What is proved only with premises that no author joins is judged again
//! without them ([`joined`]), or left open where they are of a case that may be over
//! ([`lingering`]), and what refutes a step is held against what else stands before ([`against`]), what the text calls near something
//! ([`approximated`]) and what it may say with a stroke ([`slashes`]). Nothing is refuted that words say more of than was understood
//! ([`in_words`]), or that speaks of what nothing before does ([`silent`]). In which order all this is tried is said where a goal is
//! judged.

mod against;
mod antiderivative;
mod approximated;
mod at_places;
pub(super) mod borrowed;
mod compared;
pub(super) mod conditions;
mod determined;
mod driven;
pub(super) mod expanded;
mod going_on;
mod harmonic;
mod implicit;
mod in_words;
mod invariant;
mod joined;
pub(super) mod limiting;
mod lingering;
mod named;
mod obeys;
mod one_slip_away;
mod opposite_roots;
mod otherwise;
mod overlooked;
mod rescue;
mod rooted;
mod silent;
mod slashes;
mod solution;
mod solved;
pub(super) mod there;
pub(super) mod throughout;
mod twice;
pub(super) mod unitless;
mod unstated;
pub(super) mod vanishing_there;
mod worded;

/// Why a step is left open that nothing shows: what stands before is not all that it may be meant to follow from.
pub(super) const OPEN_ITSELF: &str =
    "it may follow from what stands before and is left open itself";
pub(super) const ELSEWHERE: &str = "what stands just before says nothing of some symbol in it, and nothing decides it with what does";
pub(super) const ELEMENT: &str = "what the text says of an element may be meant of all";
pub(super) const NAMED: &str = "it may follow with what the text before it names";
pub(super) const UNSAID: &str = "no equation before says what some symbol in it is";
