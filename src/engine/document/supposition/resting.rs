//! States in which nothing changes: "Steady states of (1) satisfy", "At equilibrium (1) reduces to", "The fixed points solve".

use super::super::prose::{Placed, Token, among};
use super::super::words::Words;
use super::super::{Supposition, SuppositionKind};
use super::words::{DENYING, DOUBTFUL};

/// States that last are called by one of these.
const AT_REST: &[&str] = &["equilibria", "equilibrium"];
/// So are these with a word before that says so: "steady states", "fixed points".
const STATES: &[&str] = &[
    "state",
    "states",
    "point",
    "points",
    "solution",
    "solutions",
    "value",
    "values",
    "concentration",
    "concentrations",
];
const LASTING: &[&str] = &["steady", "stationary", "fixed", "equilibrium", "rest"];
/// Before what is said of that state: "In the steady state", "At equilibrium".
const BEFORE: &[&str] = &[
    "in",
    "at",
    "for",
    "the",
    "a",
    "any",
    "its",
    "all",
    "their",
    "these",
    "thermal",
    "of",
    "with",
    "nonzero",
    "nontrivial",
    "such",
];
/// With one of these a sentence is about what is not yet such a state, or no longer, or about something beside it.
static AWAY: Words = Words::of(&[
    "about",
    "approach",
    "approaches",
    "approached",
    "around",
    "away",
    "before",
    "constant",
    "deviation",
    "deviations",
    "distance",
    "from",
    "linearise",
    "linearised",
    "linearize",
    "linearized",
    "near",
    "perturbation",
    "perturbed",
    "reach",
    "reached",
    "reaches",
    "stability",
    "stable",
    "toward",
    "towards",
    "unstable",
    "until",
]);
/// More tokens of a sentence are not looked at.
const LONGEST: usize = 60;

/// What a sentence says of a state in which nothing changes: of what it cites, or, where it leads on to a display, of the law before.
pub(super) fn read(source: &str, sentence: &[Placed<'_>], leads: bool) -> Option<Supposition> {
    let places = 0..sentence.len().min(LONGEST);
    let noun = places.clone().find(|&at| is_state(sentence, at))?;
    let writes_it = |&(token, _): &Placed<'_>| match token {
        Token::Math(body) => source
            .get(body.range())
            .is_some_and(|own| own.contains('=')),
        token => token.is_among(&AWAY) || token.is_among(&DENYING) || token.is_among(&DOUBTFUL),
    };
    if !leads || sentence.len() > LONGEST || sentence.iter().any(writes_it) {
        return None;
    }
    let mut cited = places.filter(|&at| sentence[at].0.cites());
    let body = match (cited.next(), cited.next()) {
        (Some(at), None) => sentence[at].1,
        // "At equilibrium" alone may be one of forces.
        (None, _) if !among(sentence, noun, &["equilibrium"]) => sentence[noun].1,
        _ => return None,
    };
    let kind = SuppositionKind::AtRest;
    Some(Supposition { kind, body })
}

/// Whether a token names a state in which nothing changes, and it is that one which is spoken of.
fn is_state(sentence: &[Placed<'_>], at: usize) -> bool {
    let begins = match () {
        () if among(sentence, at, AT_REST) => at,
        () if among(sentence, at, STATES) => {
            let dash = at > 0 && matches!(sentence[at - 1].0, Token::Dash);
            let Some(before) = at.checked_sub(1 + usize::from(dash)) else {
                return false;
            };
            if !among(sentence, before, LASTING) {
                return false;
            }
            before
        }
        () => return false,
    };
    begins == 0 || among(sentence, begins - 1, BEFORE)
}
