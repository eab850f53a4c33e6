//! A proposed outcome: these balls come in so, and are said to leave so.

use nalgebra::DVector;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};

use super::error::{ScenarioError, massless};
use super::laws::Law;
use super::outcome::Outcome;

/// Balls on a line, their velocities before, and those that somebody proposes for after.
///
/// A scenario says nothing about whether it can happen: [`Scenario::judge`] does.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Scenario {
    pub(super) name: Option<char>,
    pub(super) sentence: String,
    pub(super) masses: DVector<BigRational>,
    pub(super) before: DVector<BigRational>,
    pub(super) after: DVector<BigRational>,
    momentum_equations: &'static [&'static str],
    energy_equations: &'static [&'static str],
}

impl Scenario {
    /// The names of the report's scenarios.
    pub const BUILT_IN: [char; 4] = ['A', 'B', 'C', 'D'];

    /// One of the report's scenarios, by its letter in either case: five equal balls, with `m = 1` and `v0 = 1`.
    ///
    /// That choice of units loses nothing: momentum is proportional to `m v0` and kinetic energy to `m v0²`, before and
    /// after alike, so that each law holds for all `m > 0` and `v0 ≠ 0` or for none.
    ///
    /// ```
    /// use cradle_verify::cradle::Scenario;
    /// assert!(!Scenario::built_in('C').unwrap().judge().holds());
    /// assert!(Scenario::built_in('d').unwrap().judge().holds());
    /// assert_eq!(Scenario::built_in('E'), None);
    /// ```
    pub fn built_in(name: char) -> Option<Self> {
        let name = name.to_ascii_uppercase();
        // Velocities in halves of v0.
        let (sentence, before, after, momentum, energy): (_, _, _, &'static [_], &'static [_]) =
            match name {
                'A' => (
                    "one ball arrives at v0, two leave at v0/2",
                    [2, 0, 0, 0, 0],
                    [0, 0, 0, 1, 1],
                    &["5"],
                    &["6"],
                ),
                'B' => (
                    "one ball arrives at v0, one leaves at v0",
                    [2, 0, 0, 0, 0],
                    [0, 0, 0, 0, 2],
                    &["7"],
                    &["8"],
                ),
                'C' => (
                    "two balls arrive at v0, one leaves at 2 v0",
                    [2, 2, 0, 0, 0],
                    [0, 0, 0, 0, 4],
                    &["9"],
                    &["10", "11", "12"],
                ),
                'D' => (
                    "two balls arrive at v0, two leave at v0",
                    [2, 2, 0, 0, 0],
                    [0, 0, 0, 2, 2],
                    &["13"],
                    &["14", "15", "16"],
                ),
                _ => return None,
            };
        let halves = |velocities: [i32; 5]| {
            DVector::from_iterator(
                5,
                velocities.map(|v| BigRational::new(v.into(), BigInt::from(2))),
            )
        };
        Some(Scenario {
            name: Some(name),
            sentence: sentence.to_owned(),
            masses: DVector::from_element(5, BigRational::one()),
            before: halves(before),
            after: halves(after),
            momentum_equations: momentum,
            energy_equations: energy,
        })
    }

    /// A scenario of one's own: any number of balls, any masses and velocities, in any units that agree.
    ///
    /// # Errors
    /// Unless there is a ball, and each has a positive mass, a velocity before and a velocity after.
    pub fn new(
        masses: DVector<BigRational>,
        before: DVector<BigRational>,
        after: DVector<BigRational>,
    ) -> Result<Self, ScenarioError> {
        if masses.len() != before.len() || masses.len() != after.len() {
            let (masses, before, after) = (masses.len(), before.len(), after.len());
            return Err(ScenarioError::LengthsDiffer {
                masses,
                before,
                after,
            });
        }
        if masses.is_empty() {
            return Err(ScenarioError::NoBalls);
        }
        if let Some((ball, mass)) = massless(&masses) {
            return Err(ScenarioError::MassNotPositive { ball, mass });
        }
        let moving = |velocities: &DVector<BigRational>| {
            in_words(velocities.iter().filter(|v| !v.is_zero()).count())
        };
        let balls = if masses.len() == 1 { "ball" } else { "balls" };
        let sentence = format!(
            "{} {balls}, {} moving before and {} after",
            in_words(masses.len()),
            moving(&before),
            moving(&after)
        );
        Ok(Scenario {
            name: None,
            sentence,
            masses,
            before,
            after,
            momentum_equations: &[],
            energy_equations: &[],
        })
    }

    /// The report's letter, if it is one of the report's.
    pub fn name(&self) -> Option<char> {
        self.name
    }

    /// The scenario in a sentence, without its full stop.
    pub fn sentence(&self) -> &str {
        &self.sentence
    }

    /// The masses, left to right.
    pub fn masses(&self) -> &DVector<BigRational> {
        &self.masses
    }

    /// The velocities before, left to right.
    pub fn before(&self) -> &DVector<BigRational> {
        &self.before
    }

    /// The velocities proposed for after, left to right.
    pub fn after(&self) -> &DVector<BigRational> {
        &self.after
    }

    /// The report's equations that put this scenario to this law.
    pub fn equations(&self, law: Law) -> &'static [&'static str] {
        match law {
            Law::Momentum => self.momentum_equations,
            Law::KineticEnergy => self.energy_equations,
        }
    }

    /// Holds both laws against the scenario.
    pub fn judge(&self) -> Outcome {
        Outcome::of(self.clone())
    }
}

fn in_words(count: usize) -> String {
    const WORDS: [&str; 11] = [
        "none", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten",
    ];
    WORDS
        .get(count)
        .map_or_else(|| count.to_string(), |&word| word.to_owned())
}
