//! A line of balls with gaps between them, event by event: which two meet next is worked out from where the balls are.
//!
//! [`Chain`] knows velocities only and needs a rule for who meets first. Here the balls have places. At the
//! start each is one gap from the next, all gaps alike; how large they are decides nothing, for there is no other length that
//! it could be compared with. So this is also the limit of balls that all but touch, and the pulse runs ahead of what follows
//! it, as it does in a real cradle with small gaps.

use std::collections::BTreeSet;

use nalgebra::DVector;
use num_rational::BigRational;

use super::chain::{Chain, Encounter};
use super::collision::with_restitution;
use super::error::ChainError;

/// How far a line is followed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// The most collisions.
    pub collisions: usize,
    /// The most bits of a numerator or denominator of a place or velocity. Each collision of unequal or inelastic balls adds
    /// some, so that this is what bounds work and memory.
    pub bits: u64,
}

impl Limits {
    /// A second or so of work. A guess at what is worth waiting for: with twice the bits it may take eight times as
    /// long.
    pub const USUAL: Limits = Limits {
        collisions: 20_000,
        bits: 1_000,
    };
}

/// A collision, and when it happens.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Event {
    /// The time since the start, in gaps over the unit of velocity.
    pub time: BigRational,
    /// Which two, and what becomes of their velocities.
    pub encounter: Encounter,
}

/// Balls on a line, one gap apart at the start, that collide pair by pair.
///
/// ```
/// use cradle_verify::cradle::{Chain, Limits, Line, list_text, parse_exact, parse_list};
/// let balls = |e| Chain::new(parse_list("1, 1, 1").unwrap(), parse_list("1, 0, 0").unwrap(), parse_exact(e).unwrap());
/// let mut line = Line::new(balls("1").unwrap());
/// assert_eq!(line.settle(Limits::USUAL).unwrap().len(), 2);
/// assert_eq!(list_text(line.velocities()), "(0, 0, 1)");
/// ```
///
/// **Units.** Masses in one unit, velocities in one unit, lengths in gaps. **Frame.** Any inertial one.
#[derive(Clone, Debug)]
pub struct Line {
    masses: DVector<BigRational>,
    velocities: DVector<BigRational>,
    restitution: BigRational,
    /// Where each ball would have been at time 0 with the velocity it has now: it is at `origin + velocity · time`.
    origins: DVector<BigRational>,
    /// For each pair that approaches, when it meets, and its left ball. Of meetings at one time the leftmost comes first,
    /// which matters only if they share a ball.
    meetings: BTreeSet<(BigRational, usize)>,
    /// The entry of each pair in `meetings`.
    due: Vec<Option<BigRational>>,
}

impl Line {
    /// The balls of a chain, one gap apart, at time 0.
    pub fn new(chain: Chain) -> Self {
        let count = chain.masses().len();
        let mut line = Line {
            masses: chain.masses().clone(),
            velocities: chain.velocities().clone(),
            restitution: chain.restitution().clone(),
            origins: DVector::from_fn(count, |ball, _| BigRational::from_integer(ball.into())),
            meetings: BTreeSet::new(),
            due: vec![None; count - 1],
        };
        (0..count - 1).for_each(|left| line.schedule(left));
        line
    }

    /// The masses, left to right.
    pub fn masses(&self) -> &DVector<BigRational> {
        &self.masses
    }

    /// The velocities now, left to right.
    pub fn velocities(&self) -> &DVector<BigRational> {
        &self.velocities
    }

    /// The next collision; none if no ball is faster than its right-hand neighbour.
    pub fn collide_next(&mut self) -> Option<Event> {
        let (time, left) = self.meetings.first()?.clone();
        let right = left + 1;
        let (m, v) = (&self.masses, &self.velocities);
        let before = (v[left].clone(), v[right].clone());
        let after = with_restitution(&m[left], &m[right], &before.0, &before.1, &self.restitution);
        for (ball, velocity) in [(left, &after.0), (right, &after.1)] {
            // Same place now, other velocity from now on.
            let change = &self.velocities[ball] - velocity;
            self.origins[ball] += change * &time;
            self.velocities[ball].clone_from(velocity);
        }
        for pair in left.saturating_sub(1)..(right + 1).min(self.due.len()) {
            self.schedule(pair);
        }
        let encounter = Encounter {
            left,
            before,
            after,
        };
        Some(Event { time, encounter })
    }

    /// Lets the balls collide until no two approach, and tells the collisions in order.
    ///
    /// Elastic balls always come to an end; inelastic ones may collide for ever within a finite time (McNamara and Young,
    /// *Phys. Fluids A* 4, 496, 1992), as three that stick do. The line is left where the limit was met.
    ///
    /// # Errors
    /// [`ChainError::TooManyCollisions`] or [`ChainError::NumbersTooLong`].
    pub fn settle(&mut self, limits: Limits) -> Result<Vec<Event>, ChainError> {
        let mut story = Vec::new();
        while !self.meetings.is_empty() {
            if story.len() >= limits.collisions {
                return Err(ChainError::TooManyCollisions(story.len()));
            }
            let Some(event) = self.collide_next() else {
                break;
            };
            let left = event.encounter.left;
            story.push(event);
            let longest = [left, left + 1].map(|ball| {
                let numbers = [&self.origins[ball], &self.velocities[ball]];
                let sizes = numbers.map(|q| q.numer().bits().max(q.denom().bits()));
                sizes[0].max(sizes[1])
            });
            let goes_on = !self.meetings.is_empty();
            if goes_on && longest[0].max(longest[1]) > limits.bits {
                let (collisions, bits) = (story.len(), limits.bits);
                return Err(ChainError::NumbersTooLong { collisions, bits });
            }
        }
        Ok(story)
    }

    /// Works out anew when a pair meets.
    fn schedule(&mut self, left: usize) {
        if let Some(time) = self.due[left].take() {
            self.meetings.remove(&(time, left));
        }
        let (x, v, right) = (&self.origins, &self.velocities, left + 1);
        if v[left] > v[right] {
            let time = (&x[right] - &x[left]) / (&v[left] - &v[right]);
            self.meetings.insert((time.clone(), left));
            self.due[left] = Some(time);
        }
    }
}
