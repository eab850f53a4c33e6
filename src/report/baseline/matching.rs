//! Which statement of today is which line of a baseline.
//!
//! An author puts in an equation, and all numbers behind it are others; edits one, and it says something else; renames a
//! page. So a statement is looked for by one trait after the other, the most telling first, and what was found by one is
//! out of the question for the next: a line is the record of one statement alone.

use std::collections::{BTreeMap, VecDeque};

use super::Line;

/// For each statement of today the line that is about it, by position.
pub(super) fn partners(now: &[Line], recorded: &[Line]) -> Vec<Option<usize>> {
    let mut matching = Matching {
        now,
        recorded,
        partners: vec![None; now.len()],
        taken: vec![false; recorded.len()],
    };
    // By the name that the author gave it, whatever it says now.
    matching.pair_by(|line| line.named([&line.path, &line.label, &line.fingerprint]));
    matching.pair_by(|line| line.named([&line.path, &line.label, ""]));
    // By what it says: where that is said several times, with the same remarks first; on another page last.
    for whole in [true, false] {
        let path = |line: &Line| {
            if whole {
                line.path.clone()
            } else {
                String::new()
            }
        };
        matching.pair_by(|line| Some([path(line), line.fingerprint.clone(), line.codes.join(" ")]));
        matching.pair_by(|line| Some([path(line), line.fingerprint.clone(), String::new()]));
    }
    // What could not be read, by what was said of it.
    matching.pair_by(|line| {
        let own = || {
            [
                line.path.clone(),
                line.statement.clone(),
                line.codes.join(" "),
            ]
        };
        (!line.is_statement()).then(own)
    });
    matching.pair_by_number();
    matching.partners
}

/// A trait by which a line is recognised.
type Trait = [String; 3];

struct Matching<'a> {
    now: &'a [Line],
    recorded: &'a [Line],
    partners: Vec<Option<usize>>,
    taken: Vec<bool>,
}

impl Matching<'_> {
    /// Pairs what is left and alike, in order.
    fn pair_by(&mut self, own: impl Fn(&Line) -> Option<Trait>) {
        let mut waiting: BTreeMap<Trait, VecDeque<usize>> = BTreeMap::new();
        let left = (0..self.recorded.len()).filter(|&at| !self.taken[at]);
        for at in left {
            if let Some(own) = own(&self.recorded[at]) {
                waiting.entry(own).or_default().push_back(at);
            }
        }
        for (line, partner) in self.now.iter().zip(&mut self.partners) {
            if partner.is_none()
                && let Some(own) = own(line)
                && let Some(at) = waiting.get_mut(&own).and_then(VecDeque::pop_front)
            {
                *partner = Some(at);
                self.taken[at] = true;
            }
        }
    }

    /// Pairs what has the same printed number, where numbers have not moved: what was recognised next to it, before and
    /// behind, has the number that it had. Elsewhere an equation that was put in would pass for the one that had its number.
    fn pair_by_number(&mut self) {
        let stays = |at: usize| -> Option<bool> {
            let was = &self.recorded[self.partners[at]?];
            let is = &self.now[at];
            let numbered = !is.equation.is_empty() && !was.equation.is_empty();
            numbered.then(|| was.equation == is.equation)
        };
        let same_page = |at: usize, other: usize| self.now[at].path == self.now[other].path;
        // Whether the nearest that was recognised has its number still, going one way.
        let going = |order: &mut dyn Iterator<Item = usize>| {
            let mut unmoved = vec![true; self.now.len()];
            let mut last: Option<(usize, bool)> = None;
            for at in order {
                unmoved[at] = last.is_none_or(|(other, stays)| stays || !same_page(at, other));
                last = stays(at).map(|stays| (at, stays)).or(last);
            }
            unmoved
        };
        let count = self.now.len();
        let (before, behind) = (going(&mut (0..count)), going(&mut (0..count).rev()));
        let unmoved: Vec<bool> = before.iter().zip(&behind).map(|(a, b)| *a && *b).collect();
        let mut waiting: BTreeMap<(&str, &str), usize> = BTreeMap::new();
        for (at, line) in self.recorded.iter().enumerate() {
            if !self.taken[at] && !line.equation.is_empty() {
                waiting.insert((&line.path, &line.equation), at);
            }
        }
        for (at, line) in self.now.iter().enumerate() {
            if self.partners[at].is_none() && unmoved[at] {
                let partner = waiting.remove(&(line.path.as_str(), line.equation.as_str()));
                self.partners[at] = partner;
            }
        }
    }
}

impl Line {
    /// A trait of what the author has named.
    fn named(&self, parts: [&str; 3]) -> Option<Trait> {
        (!self.label.is_empty()).then(|| parts.map(str::to_owned))
    }
}
