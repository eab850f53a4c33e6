//! Who judges what, where several work at an audit.

use std::ops::Range;
use std::sync::{Mutex, PoisonError};

use crate::derivation::Derivation;

/// How many equations of a page are judged in one go: a long page is cut up.
const MOST_AT_A_TIME: usize = 40;
/// How far ahead is looked for something that need not wait.
const WINDOW: usize = 64;

/// The parts of a derivation, each taken by one worker.
///
/// A part waits for what it needs of earlier ones. Whoever takes a part that is not the first of those left
/// must be ready to take these too when it has to wait ([`Schedule::take_until`]): then whoever waits does so
/// for somebody at work further up, and somebody always is.
pub(super) struct Schedule {
    parts: Vec<Part>,
    left: Mutex<Left>,
}

struct Part {
    equations: Range<usize>,
    /// The equations elsewhere that it cites.
    cites: Vec<usize>,
}

struct Left {
    taken: Vec<bool>,
    /// All before are taken.
    first: usize,
}

impl Schedule {
    pub fn new(derivation: &Derivation) -> Self {
        let ranges = (0..derivation.pages.len()).flat_map(|page| {
            let own = derivation.equations_of(page);
            let starts = own.clone().step_by(MOST_AT_A_TIME);
            starts.map(move |start| start..own.end.min(start + MOST_AT_A_TIME))
        });
        let parts: Vec<Part> = ranges
            .map(|equations| {
                let cited = equations.clone().flat_map(|at| derivation.premises(at).0);
                let before = cited.filter(|&premise| premise < equations.start);
                Part {
                    cites: before.collect(),
                    equations,
                }
            })
            .collect();
        let left = Left {
            taken: vec![false; parts.len()],
            first: 0,
        };
        Schedule {
            parts,
            left: left.into(),
        }
    }

    /// With nothing left to take.
    pub fn finished() -> Self {
        let left = Left {
            taken: Vec::new(),
            first: 0,
        };
        Schedule {
            parts: Vec::new(),
            left: left.into(),
        }
    }

    pub fn len(&self) -> usize {
        self.parts.len()
    }

    /// The first part left whose citations are all done; if there is none, the first part left.
    pub fn take(&self, is_done: impl Fn(usize) -> bool) -> Option<Range<usize>> {
        self.choose(|left| {
            let end = self.parts.len().min(left.first + WINDOW);
            let ready = |&at: &usize| {
                !left.taken[at] && self.parts[at].cites.iter().all(|&cited| is_done(cited))
            };
            (left.first..end).find(ready).unwrap_or(left.first)
        })
    }

    /// The first part left, if it begins no later than with an equation that is waited for.
    pub fn take_until(&self, equation: usize) -> Option<Range<usize>> {
        let part = |at: usize| self.parts.get(at).filter(|p| p.equations.start <= equation);
        self.choose(|left| part(left.first).map_or(self.parts.len(), |_| left.first))
    }

    fn choose(&self, choice: impl Fn(&Left) -> usize) -> Option<Range<usize>> {
        let mut left = self.left.lock().unwrap_or_else(PoisonError::into_inner);
        let at = choice(&left);
        let part = self.parts.get(at)?;
        left.taken[at] = true;
        while left.taken.get(left.first) == Some(&true) {
            left.first += 1;
        }
        Some(part.equations.clone())
    }
}
