//! Who judges what, where several work at an audit.

use std::cmp::Reverse;
use std::ops::Range;
use std::sync::{Mutex, PoisonError};

use crate::derivation::Derivation;

/// How many equations of a page are judged in one go: a long page is cut up.
const MOST_AT_A_TIME: usize = 40;
/// How far ahead is looked for something that need not wait.
const WINDOW: usize = 64;

/// The parts of a derivation, each taken by one worker.
///
/// A part waits for what it needs of earlier ones. Whoever takes a part must be ready to take earlier ones that are left when it
/// has to wait ([`Schedule::take_until`]): then whoever waits does so for somebody at work further up, and somebody always is.
pub(super) struct Schedule {
    parts: Vec<Part>,
    left: Mutex<Left>,
}

struct Part {
    equations: Range<usize>,
    /// The equations elsewhere that it cites.
    cites: Vec<usize>,
    /// Otherwise it is judged only if another turns out to need it.
    wanted: bool,
}

struct Left {
    taken: Vec<bool>,
    /// All before are taken.
    first: usize,
}

impl Schedule {
    /// Wanted are some equations, and all that these cite.
    pub fn new(derivation: &Derivation, is_wanted: impl Fn(usize) -> bool) -> Self {
        let all = 0..derivation.equations.len();
        let cites: Vec<&[usize]> = all.clone().map(|at| derivation.premises(at).0).collect();
        let mut wanted: Vec<bool> = all.clone().map(is_wanted).collect();
        for at in all.rev() {
            if wanted[at] {
                // What is cited stands before, or does not count.
                let before = cites[at].iter().filter(|&&premise| premise < at);
                before.for_each(|&premise| wanted[premise] = true);
            }
        }
        let mut parts: Vec<Part> = Vec::new();
        for page in 0..derivation.pages.len() {
            let own = derivation.equations_of(page);
            let mut start = own.start;
            while start < own.end {
                let most = start..own.end.min(start + MOST_AT_A_TIME);
                let end = most.clone().find(|&at| wanted[at] != wanted[start]);
                let equations = start..end.unwrap_or(most.end);
                start = equations.end;
                let cited = cites[equations.clone()].iter().copied().flatten().copied();
                parts.push(Part {
                    cites: cited.filter(|&premise| premise < equations.start).collect(),
                    wanted: wanted[equations.start],
                    equations,
                });
            }
        }
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

    /// How many parts are wanted.
    pub fn len(&self) -> usize {
        self.parts.iter().filter(|part| part.wanted).count()
    }

    /// The longest of the wanted parts left whose citations are all done, so that the last ones to be taken are short and nobody waits
    /// long for another at the end; if there is none, the first one left.
    pub fn take(&self, is_done: impl Fn(usize) -> bool) -> Option<Range<usize>> {
        self.choose(|left| {
            let own = |&at: &usize| self.parts[at].wanted && !left.taken[at];
            let open = (left.first..self.parts.len()).filter(own).take(WINDOW);
            let ready = |&at: &usize| self.parts[at].cites.iter().all(|&cited| is_done(cited));
            let first = open.clone().next();
            // Of those of one length the first.
            let length = |&at: &usize| (self.parts[at].equations.len(), Reverse(at));
            let longest = open.filter(ready).max_by_key(length);
            longest.or(first).unwrap_or(self.parts.len())
        })
    }

    /// The first wanted part left, if it begins no later than with an equation that is waited for; otherwise the part that holds
    /// the equation, if that is left.
    pub fn take_until(&self, equation: usize) -> Option<Range<usize>> {
        self.choose(|left| {
            let mut before = (left.first..self.parts.len())
                .take_while(|&at| self.parts[at].equations.start <= equation)
                .filter(|&at| !left.taken[at]);
            let holds = |&at: &usize| self.parts[at].equations.contains(&equation);
            let wanted = before.clone().find(|&at| self.parts[at].wanted);
            wanted
                .or_else(|| before.find(holds))
                .unwrap_or(self.parts.len())
        })
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
