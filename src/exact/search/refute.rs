//! Exact counterexamples, and exact points at which premises hold together.

mod concrete;
mod facts;
mod sizes;

use std::cell::RefCell;
use std::rc::Rc;

use num_traits::ToPrimitive;

use super::course::in_motion;
use super::point::{Tried, Wanted};
use super::unfold::definitions_to_unfold;
use crate::algebra::Symbol;
use crate::kernel::{Assignment, Obligation};
use crate::sorted::Map;
use concrete::{Concrete, Posed};
pub use concrete::{complete, known_at, put_in};
pub use facts::{measured_in_units, negation, roots};
pub use sizes::count_symbols;
use sizes::{MOST_ELEMENTS, at_sizes, restored, rule_out, sizes};

/// The costs that are tried one after another.
const MOST_COST: u32 = 11;
/// How far is looked from a point that is nearly right.
const NEAR_COST: u32 = 3;
const NEAR_CHOICES: usize = 24;

/// A search for points at which all hypotheses of a claim hold and, if so wanted, its goal does not.
pub struct Points<'a> {
    obligation: &'a Obligation,
    counts: Vec<Symbol>,
    /// One search for each choice of the numbers of elements, the smallest first.
    sizes: Vec<(Vec<i64>, Slot<'a>)>,
    /// The claim with definite numbers of elements, where it was read so before; `None` where it cannot be.
    sized: RefCell<Map<Vec<i64>, Option<Rc<Obligation>>>>,
    against_goal: bool,
    wanted: Wanted,
    cost: u32,
    /// How many choices were tried.
    pub tried: usize,
}

/// A search that is prepared when its turn comes, and dropped when it has nothing left.
enum Slot<'a> {
    Waiting,
    Ready(Box<Concrete<'a>>),
    Done,
}

impl<'a> Points<'a> {
    /// Prepares a search for points at which the hypotheses hold and the goal does not.
    pub fn new(obligation: &'a Obligation) -> Self {
        Points::prepared(obligation, true, Wanted::Simple)
    }

    /// The same where any such point will do, simple or not.
    pub fn any(obligation: &'a Obligation) -> Self {
        Points::prepared(obligation, true, Wanted::Any)
    }

    /// The same where exponentials are powers of `e`.
    pub fn of_exponentials(obligation: &'a Obligation) -> Self {
        Points::prepared(obligation, true, Wanted::Exponentials)
    }

    /// The same where several exponentials of one symbol are powers of one of them.
    pub fn of_powers(obligation: &'a Obligation) -> Self {
        Points::prepared(obligation, true, Wanted::Powers)
    }

    /// Prepares a search for points at which the hypotheses hold; the goal is left alone.
    pub fn of_premises(obligation: &'a Obligation) -> Self {
        Points::prepared(obligation, false, Wanted::Any)
    }

    fn prepared(obligation: &'a Obligation, against_goal: bool, wanted: Wanted) -> Self {
        let claim = obligation.claim();
        let counts = count_symbols(claim);
        let mut sizes = sizes(&counts, claim, against_goal);
        rule_out(&mut sizes, &counts, claim, against_goal);
        let sizes = sizes.into_iter();
        Points {
            obligation,
            sizes: sizes.map(|sizes| (sizes, Slot::Waiting)).collect(),
            sized: RefCell::default(),
            counts,
            against_goal,
            wanted,
            cost: 0,
            tried: 0,
        }
    }

    /// Points that agree with one of the `hints` wherever these give a symbol a value.
    pub fn near<'h>(
        &self,
        hints: impl IntoIterator<Item = &'h Assignment>,
    ) -> impl Iterator<Item = Assignment> {
        let found = hints.into_iter().map(|hint| {
            let size = |count: &Symbol| {
                let value = hint.symbols.get(count)?.to_integer().to_i64()?;
                (1..=MOST_ELEMENTS).contains(&value).then_some(value)
            };
            let sizes: Vec<i64> = self.counts.iter().map(size).collect::<Option<_>>()?;
            let mut concrete = Concrete::new(
                self.at_sizes(&sizes)?,
                self.against_goal,
                Wanted::Simple,
                Some(hint),
            )?;
            let Tried::Found(values) = concrete.target.up_to(NEAR_COST, &mut { NEAR_CHOICES })
            else {
                return None;
            };
            let point = concrete.assignment(&values);
            let claim = self.obligation.claim();
            restored(claim, self.obligation.unfold(), &self.counts, &sizes, point).pop()
        });
        found.flatten()
    }

    /// The claim with definite numbers of elements.
    fn at_sizes(&self, sizes: &[i64]) -> Option<Posed<'a>> {
        let claim = self.obligation.claim();
        if self.counts.is_empty() && claim.sequences.is_empty() {
            return Some(Posed::Itself(self.obligation));
        }
        let read = || {
            let claim = at_sizes(claim, &self.counts, sizes)?;
            let unfold = definitions_to_unfold(&claim);
            Obligation::new(claim, unfold).ok().map(Rc::new)
        };
        let mut sized = self.sized.borrow_mut();
        let own = sized.entry(sizes.to_vec()).or_insert_with(read);
        own.clone().map(Posed::Sized)
    }

    /// The simplest point not yet ruled out, in more than one order of its elements; more of them with each
    /// call. Nothing once the budget is spent or there is nothing left to try.
    ///
    /// A further element costs as much as two less simple numbers, so that few elements come first.
    pub fn next(&mut self, budget: usize) -> Vec<Assignment> {
        let mut left = budget;
        let smallest = self.sizes.first().map_or(0, |s| s.0.iter().sum::<i64>());
        while self.cost <= MOST_COST && left > 0 {
            for at in 0..self.sizes.len() {
                let sizes = &self.sizes[at].0;
                let more = 2 * u32::try_from(sizes.iter().sum::<i64>() - smallest).unwrap_or(0);
                let Some(cost) = self.cost.checked_sub(more) else {
                    continue;
                };
                if let Some(points) = self.found(at, cost, &mut left) {
                    return points;
                }
                if left == 0 {
                    return Vec::new();
                }
            }
            if self.sizes.iter().all(|s| matches!(s.1, Slot::Done)) {
                break;
            }
            self.cost += 1;
        }
        Vec::new()
    }
    /// What is found at the sizes at a position for at most so much; the choices that were tried are taken from what is `left`.
    fn found(&mut self, at: usize, cost: u32, left: &mut usize) -> Option<Vec<Assignment>> {
        if matches!(self.sizes[at].1, Slot::Waiting) {
            let concrete = self.at_sizes(&self.sizes[at].0);
            let concrete =
                concrete.and_then(|c| Concrete::new(c, self.against_goal, self.wanted, None));
            self.sizes[at].1 = concrete.map_or(Slot::Done, |c| Slot::Ready(c.into()));
        }
        let (sizes, slot) = &mut self.sizes[at];
        let Slot::Ready(concrete) = slot else {
            return None;
        };
        let before = *left;
        let tried = concrete.target.up_to(cost, left);
        self.tried += before - *left;
        let values = match tried {
            Tried::Found(values) => values,
            Tried::Costlier => return None,
            Tried::Exhausted => {
                *slot = Slot::Done;
                return None;
            }
        };
        let point = concrete.assignment(&values);
        let posed = &concrete.obligation;
        let moving = in_motion(posed.claim(), posed.as_written(), &values, &point);
        *slot = Slot::Done;
        let claim = self.obligation.claim();
        let unfold = self.obligation.unfold();
        let mut points = restored(claim, unfold, &self.counts, sizes, point);
        points.extend(moving.filter(|_| self.counts.is_empty()));
        Some(points)
    }
}
