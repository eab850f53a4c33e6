//! Ordinary differential equations in floating point: Dormand and Prince's method of order 5 with an error of order 4.
//!
//! Forty lines of a well-known tableau are kept here rather than a library. The systems are small, smooth between
//! contacts and not stiff, so that nothing cleverer pays; what the crates on offer would add is some twenty
//! dependencies, and versions of `nalgebra` of their own. The tableau is checked by its order of convergence.
//!
//! Systems are autonomous: where time is wanted it is one of the unknowns, with slope 1. State and slope are vectors of
//! `nalgebra`, of a fixed length or of one that is known at run time.

use std::cmp::Ordering;

use nalgebra::allocator::Allocator;
use nalgebra::{DefaultAllocator, Dim, OVector};

use super::contact::ContactError;

/// The most steps that one integration takes, refused ones included. A guess: an impact needs a few hundred, a line of a
/// hundred balls some ten thousand.
pub const MOST_STEPS: usize = 200_000;

/// Stage weights `a_ij`; the last row are also the weights of the result, of order 5.
#[rustfmt::skip]
const STAGES: [&[f64]; 6] = [
    &[1.0 / 5.0],
    &[3.0 / 40.0, 9.0 / 40.0],
    &[44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0],
    &[19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0],
    &[9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0],
    &[35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0],
];
/// Those weights less the ones of the embedded method of order 4.
const DEFECT: [f64; 7] = [
    71.0 / 57600.0,
    0.0,
    -71.0 / 16695.0,
    71.0 / 1920.0,
    -17253.0 / 339200.0,
    22.0 / 525.0,
    -1.0 / 40.0,
];

/// A system `y' = slope(y)`, and how carefully it is followed.
///
/// **Source.** Dormand and Prince, *J. Comput. Appl. Math.* 6, 19 (1980); Hairer, Nørsett and Wanner, *Solving Ordinary
/// Differential Equations I*, II.4 and II.5.
pub struct System<F, D: Dim>
where
    DefaultAllocator: Allocator<D>,
{
    /// The slope of every unknown.
    pub slope: F,
    /// The size of each unknown that counts as large, in its own unit. It steers the steps and nothing else.
    pub scale: OVector<f64, D>,
    /// The error allowed in one step, as a share of `scale`.
    pub tolerance: f64,
}

/// A state on the way, and the step to try from it.
#[derive(Clone, Debug)]
pub struct Moment<D: Dim>
where
    DefaultAllocator: Allocator<D>,
{
    /// The unknowns.
    pub state: OVector<f64, D>,
    /// The step to try next.
    pub step: f64,
    /// Steps tried so far, refused ones included.
    pub tried: usize,
    /// The step that led here; 0 at the start.
    pub taken: f64,
}

impl<D: Dim> Moment<D>
where
    DefaultAllocator: Allocator<D>,
{
    /// The start, with a first step to try. That may be far too long or too short.
    pub fn start(state: OVector<f64, D>, step: f64) -> Self {
        Moment {
            state,
            step,
            tried: 0,
            taken: 0.0,
        }
    }
}

impl<F, D> System<F, D>
where
    D: Dim,
    DefaultAllocator: Allocator<D>,
    F: Fn(&OVector<f64, D>) -> OVector<f64, D>,
{
    /// One step of size `h`, however large: the new state, and an estimate of its error.
    pub fn leap(&self, from: &OVector<f64, D>, h: f64) -> (OVector<f64, D>, OVector<f64, D>) {
        let mut slopes = vec![(self.slope)(from)];
        let mut state = from.clone();
        for weights in STAGES {
            state.copy_from(from);
            for (weight, slope) in weights.iter().zip(&slopes) {
                state.axpy(h * weight, slope, 1.0);
            }
            slopes.push((self.slope)(&state));
        }
        let mut error = from * 0.0;
        for (weight, slope) in DEFECT.iter().zip(&slopes) {
            error.axpy(h * weight, slope, 1.0);
        }
        (state, error)
    }

    /// One step that keeps to the tolerance; it starts with the size that the moment proposes.
    ///
    /// # Errors
    /// [`ContactError::TooManySteps`]; then the state is where it was.
    pub fn advance(&self, from: &Moment<D>) -> Result<Moment<D>, ContactError> {
        let (mut h, mut tried) = (from.step, from.tried);
        loop {
            if tried >= MOST_STEPS {
                return Err(ContactError::TooManySteps(tried));
            }
            tried += 1;
            let (state, error) = self.leap(&from.state, h);
            let worst = match state.iter().chain(error.iter()).all(|x| x.is_finite()) {
                true => error.component_div(&self.scale).amax() / self.tolerance,
                false => f64::INFINITY,
            };
            // The usual controller: the error goes with the fifth power of the step, so aim for nine tenths of what
            // would just do, and change by no more than a factor of 5.
            let factor = (0.9 * worst.powf(-0.2)).clamp(0.2, 5.0);
            if worst <= 1.0 {
                return Ok(Moment {
                    state,
                    step: h * factor,
                    tried,
                    taken: h,
                });
            }
            h *= factor;
        }
    }

    /// Follows the system until `sign` falls from above 0 to 0 or below, and finds where it does.
    ///
    /// The step across is repeated with a smaller size until its end lies on the zero: regula falsi with Illinois'
    /// remedy, so each trial is a step of full order and no interpolation enters.
    ///
    /// # Errors
    /// [`ContactError::TooManySteps`].
    pub fn until(
        &self,
        mut moment: Moment<D>,
        sign: impl Fn(&OVector<f64, D>) -> f64,
    ) -> Result<Moment<D>, ContactError> {
        loop {
            let before = sign(&moment.state);
            let next = self.advance(&moment)?;
            let after = sign(&next.state);
            if before > 0.0 && after <= 0.0 {
                return Ok(self.locate(&moment, &next, &sign));
            }
            moment = next;
        }
    }

    fn locate(
        &self,
        from: &Moment<D>,
        across: &Moment<D>,
        sign: &impl Fn(&OVector<f64, D>) -> f64,
    ) -> Moment<D> {
        let (mut short, mut long) = (0.0, across.taken);
        let (mut above, mut below) = (sign(&from.state), sign(&across.state));
        let mut found = across.clone();
        let mut moved = Ordering::Equal;
        // Some eight trials are usual; 60 would do even for halving.
        for _ in 0..60 {
            if below == 0.0 || long - short <= 4.0 * f64::EPSILON * long {
                break;
            }
            let between = (short * below - long * above) / (below - above);
            let h = match between > short && between < long {
                true => between,
                false => 0.5 * (short + long),
            };
            let state = self.leap(&from.state, h).0;
            let value = sign(&state);
            // An end that stays a second time counts half, so that it will move too.
            if value > 0.0 {
                below *= if moved == Ordering::Less { 0.5 } else { 1.0 };
                (short, above, moved) = (h, value, Ordering::Less);
            } else {
                above *= if moved == Ordering::Greater { 0.5 } else { 1.0 };
                (long, below, moved) = (h, value, Ordering::Greater);
                (found.state, found.taken) = (state, h);
            }
        }
        found
    }
}
