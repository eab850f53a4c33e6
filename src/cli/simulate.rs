//! `simulate`: balls from the arguments, and what becomes of them by either model. [`view`] shows it.

mod view;

use nalgebra::DVector;
use num_rational::BigRational;
use num_traits::{One, ToPrimitive, Zero};

use super::Failure;
use super::args::Model;
use crate::cradle::contact::{Parting, TouchingBalls};
use crate::cradle::number::MAX_ITEMS;
use crate::cradle::{Chain, Limits, Line, parse_exact, parse_list};

/// Balls in a line, of which some come in.
pub(super) struct Balls {
    masses: DVector<BigRational>,
    before: DVector<BigRational>,
    arriving: usize,
}

/// Balls, and what becomes of them.
pub(super) struct Simulation {
    balls: Balls,
    end: End,
}

enum End {
    Pairwise {
        after: DVector<BigRational>,
        restitution: BigRational,
        collisions: usize,
    },
    Hertz(Parting),
}

/// The balls that the arguments describe.
pub(super) fn balls(
    count: Option<usize>,
    arriving: usize,
    masses: Option<&str>,
) -> Result<Balls, Failure> {
    let masses = match masses {
        Some(text) => {
            Some(parse_list(text).map_err(|error| Failure::new(format!("--masses: {error}")))?)
        }
        None => None,
    };
    let count = match (count, &masses) {
        (Some(count), Some(masses)) if count != masses.len() => {
            return Err(Failure::new(format!(
                "--balls says {count}, and --masses has {}",
                masses.len()
            ))
            .help("leave out --balls: there are as many as masses"));
        }
        (_, Some(masses)) => masses.len(),
        (count, None) => count.unwrap_or(5),
    };
    if count == 0 || count > MAX_ITEMS {
        return Err(Failure::new(format!(
            "--balls: there can be 1 to {MAX_ITEMS} balls, and not {count}"
        )));
    }
    if arriving == 0 || arriving > count {
        return Err(Failure::new(format!(
            "--in: of {count} balls, 1 to {count} can come in, and not {arriving}"
        )));
    }
    let speed = |ball, _| match ball < arriving {
        true => BigRational::one(),
        false => BigRational::zero(),
    };
    Ok(Balls {
        masses: masses.unwrap_or_else(|| DVector::from_element(count, BigRational::one())),
        before: DVector::from_fn(count, speed),
        arriving,
    })
}

impl Balls {
    /// Why so many balls collide so often, and what comes to an end sooner.
    fn endless(&self, restitution: &BigRational) -> String {
        let (arriving, waiting) = (self.arriving, self.masses.len() - self.arriving);
        let are_alike = self.masses.iter().all(|mass| *mass == self.masses[0]);
        match (restitution.is_one(), are_alike) {
            (true, true) => format!(
                "each of {arriving} balls strikes its way through {waiting}: {} collisions; fewer balls come to an end",
                arriving * waiting
            ),
            (true, false) => {
                "fewer balls or masses less unequal come to an end sooner".to_owned()
            }
            (false, _) => "inelastic balls may never stop; fewer balls, a restitution nearer to 1 or masses less unequal \
                           come to an end sooner"
                .to_owned(),
        }
    }

    /// What becomes of them.
    pub(super) fn simulate(
        self,
        model: Model,
        restitution: Option<&str>,
    ) -> Result<Simulation, Failure> {
        let restitution = match restitution {
            Some(text) => parse_exact(text)
                .map_err(|error| Failure::new(format!("--restitution: {error}")))?,
            None => BigRational::one(),
        };
        // Both models want just the same of the balls; this one says it with exact numbers.
        let chain = Chain::new(
            self.masses.clone(),
            self.before.clone(),
            restitution.clone(),
        )
        .map_err(|error| Failure::new(error.to_string()))?;
        let end = match model {
            Model::Pairwise => {
                let mut line = Line::new(chain);
                let events = line.settle(Limits::USUAL).map_err(|error| {
                    Failure::new(error.to_string()).help(self.endless(&restitution))
                })?;
                End::Pairwise {
                    after: line.velocities().clone(),
                    restitution,
                    collisions: events.len(),
                }
            }
            Model::Hertz if !restitution.is_one() => {
                return Err(Failure::new(
                    "--restitution: Hertz's force is elastic and has no restitution to choose",
                )
                .help("leave it out, or take `--model pairwise`"));
            }
            Model::Hertz => {
                let masses = self.masses.iter().map(floating).collect();
                let before = self.before.iter().map(floating).collect();
                let parting = TouchingBalls::new(masses, before).and_then(|balls| balls.part());
                End::Hertz(parting.map_err(|error| Failure::new(error.to_string()))?)
            }
        };
        Ok(Simulation { balls: self, end })
    }
}

/// The nearest floating-point number; what is too large for one is refused where it is used.
fn floating(value: &BigRational) -> f64 {
    value.to_f64().unwrap_or(f64::NAN)
}
