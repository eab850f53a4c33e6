//! What the laws say to a scenario, and what else there is to say about it.

use std::fmt;

use nalgebra::DVector;
use num_rational::BigRational;
use num_traits::{One, Zero};

use super::chain::Chain;
use super::laws::Law;
use super::number::list_text;
use super::scenario::Scenario;

/// How many collisions are played out for a remark. A guess: it covers twenty equal balls.
const COLLISIONS_PLAYED: usize = 200;
/// How long, in bits, a velocity's denominator may grow while they are. A guess: each collision of unequal balls adds
/// digits, and a remark of more than a few hundred is read by nobody.
const BITS_PLAYED: u64 = 512;

/// A scenario, judged.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Outcome {
    scenario: Scenario,
    judgements: [Judgement; 2],
    remarks: Vec<Remark>,
}

/// What one law says to a scenario.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Judgement {
    /// The law.
    pub law: Law,
    /// The report's equations that put the scenario to this law.
    pub equations: &'static [&'static str],
    /// The conserved quantity before.
    pub before: BigRational,
    /// The conserved quantity after, as proposed.
    pub after: BigRational,
}

impl Judgement {
    /// `after − before`, exactly.
    pub fn difference(&self) -> BigRational {
        &self.after - &self.before
    }

    /// `after / before`, unless there was none before.
    pub fn ratio(&self) -> Option<BigRational> {
        (!self.before.is_zero()).then(|| &self.after / &self.before)
    }

    /// Whether the law holds.
    pub fn holds(&self) -> bool {
        self.before == self.after
    }
}

/// Something worth knowing about a scenario that is not one of the two laws.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Remark {
    /// `m = 1` and `v0 = 1` were chosen, which loses nothing.
    UnitsChosen,
    /// Afterwards, this ball (counted from 1) would be faster than its right-hand neighbour, yet is on its left.
    PassesThrough {
        /// The ball, counted from 1.
        ball: usize,
        /// Its velocity after.
        velocity: BigRational,
        /// Its right-hand neighbour's.
        neighbour: BigRational,
    },
    /// Before, no ball is faster than its right-hand neighbour, so none ever meet, but velocities are said to change.
    NothingCollides,
    /// Elastic collisions pair by pair lead to just the proposed velocities.
    PairByPairAgrees,
    /// Elastic collisions pair by pair lead to other velocities.
    PairByPairDiffers {
        /// Those velocities.
        velocities: DVector<BigRational>,
        /// Both laws hold for the proposed ones too, so the laws alone do not decide.
        laws_hold: bool,
    },
    /// The collisions pair by pair were not played out: too many, or their numbers too long.
    PairByPairUnfinished {
        /// How many were played.
        collisions: usize,
    },
}

impl fmt::Display for Remark {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Remark::UnitsChosen => write!(
                f,
                "m = 1 and v0 = 1 lose nothing: every momentum scales with m v0, every kinetic energy with m v0²"
            ),
            Remark::PassesThrough {
                ball,
                velocity,
                neighbour,
            } => write!(
                f,
                "ball {ball} would still be faster ({velocity}) than ball {} to its right ({neighbour}): \
                 they would meet again, or pass through each other",
                ball + 1
            ),
            Remark::NothingCollides => {
                write!(
                    f,
                    "before, no ball is faster than the one on its right: none would meet, and nothing could change"
                )
            }
            Remark::PairByPairAgrees => write!(
                f,
                "elastic collisions, pair by pair, give just these velocities"
            ),
            Remark::PairByPairDiffers {
                velocities,
                laws_hold: false,
            } => {
                write!(
                    f,
                    "elastic collisions, pair by pair, would give {}",
                    list_text(velocities)
                )
            }
            Remark::PairByPairDiffers {
                velocities,
                laws_hold: true,
            } => write!(
                f,
                "the two laws alone do not decide what happens: elastic collisions, pair by pair, give {}",
                list_text(velocities)
            ),
            Remark::PairByPairUnfinished { collisions } => {
                write!(
                    f,
                    "elastic collisions, pair by pair, were given up after {collisions}: too many, or too long their numbers"
                )
            }
        }
    }
}

impl Outcome {
    pub(super) fn of(scenario: Scenario) -> Self {
        let judgements = Law::ALL.map(|law| Judgement {
            law,
            equations: scenario.equations(law),
            before: law.quantity(&scenario.masses, &scenario.before),
            after: law.quantity(&scenario.masses, &scenario.after),
        });
        let laws_hold = judgements.iter().all(Judgement::holds);
        let mut remarks: Vec<Remark> = passes_through(&scenario.after).into_iter().collect();
        remarks.extend(played_out(&scenario, laws_hold));
        if scenario.name.is_some() {
            remarks.push(Remark::UnitsChosen);
        }
        Outcome {
            scenario,
            judgements,
            remarks,
        }
    }

    /// What was judged.
    pub fn scenario(&self) -> &Scenario {
        &self.scenario
    }

    /// What each law says, momentum first.
    pub fn judgements(&self) -> &[Judgement] {
        &self.judgements
    }

    /// What else there is to say. No remark changes what [`Outcome::holds`] answers.
    pub fn remarks(&self) -> &[Remark] {
        &self.remarks
    }

    /// Whether both laws hold.
    pub fn holds(&self) -> bool {
        self.judgements.iter().all(Judgement::holds)
    }
}

/// Balls keep their places on the line, so once they part, none may be faster than its right-hand neighbour.
fn passes_through(after: &DVector<BigRational>) -> Option<Remark> {
    let left = (1..after.len()).find(|&right| after[right - 1] > after[right])? - 1;
    Some(Remark::PassesThrough {
        ball: left + 1,
        velocity: after[left].clone(),
        neighbour: after[left + 1].clone(),
    })
}

fn played_out(scenario: &Scenario, laws_hold: bool) -> Option<Remark> {
    let mut chain = Chain::new(
        scenario.masses.clone(),
        scenario.before.clone(),
        BigRational::one(),
    )
    .ok()?;
    let (starts, mut collisions) = (chain.is_approaching(), 0);
    while chain.collide_next().is_some() {
        collisions += 1;
        let too_long = chain
            .velocities()
            .iter()
            .any(|v| v.denom().bits() > BITS_PLAYED);
        if too_long || (collisions == COLLISIONS_PLAYED && chain.is_approaching()) {
            return Some(Remark::PairByPairUnfinished { collisions });
        }
    }
    Some(match (starts, *chain.velocities() == scenario.after) {
        (_, true) => Remark::PairByPairAgrees,
        (false, false) => Remark::NothingCollides,
        (true, false) => Remark::PairByPairDiffers {
            velocities: chain.velocities().clone(),
            laws_hold,
        },
    })
}
