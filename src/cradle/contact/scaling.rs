//! The exponents of an impact's power laws, measured on integrated impacts.
//!
//! Without damping every impact is the same one, stretched in depth and in time, and its quantities are products of powers
//! of the parameters. With weak damping so is the heat, to first order. Here nobody relies on that: impacts over some decades
//! of one parameter are integrated, and a straight line is laid through the logarithms.

use super::impact::{Impact, Rebound};
use super::numeric::{ContactError, Numeric};

/// What is measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// The largest compression.
    Compression,
    /// The time of contact.
    Duration,
    /// The heat.
    Dissipated,
}

/// What is varied.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Parameter {
    /// The speed of the striking ball, `v0`.
    Speed,
    /// The mass of each ball, `m`.
    Mass,
    /// The stiffness of the contact, `k`.
    Stiffness,
    /// Its damping, `γ`.
    Damping,
}

impl Quantity {
    /// All that is measured.
    pub const ALL: [Quantity; 3] = [
        Quantity::Compression,
        Quantity::Duration,
        Quantity::Dissipated,
    ];

    fn of(self, rebound: &Rebound) -> Numeric {
        match self {
            Quantity::Compression => rebound.compression,
            Quantity::Duration => rebound.duration,
            Quantity::Dissipated => rebound.dissipated,
        }
    }
}

impl Parameter {
    /// All that is varied.
    pub const ALL: [Parameter; 4] = [
        Parameter::Speed,
        Parameter::Mass,
        Parameter::Stiffness,
        Parameter::Damping,
    ];

    fn times(self, factor: f64, impact: &Impact) -> Impact {
        let mut other = *impact;
        *match self {
            Parameter::Speed => &mut other.speed,
            Parameter::Mass => &mut other.mass,
            Parameter::Stiffness => &mut other.contact.stiffness,
            Parameter::Damping => &mut other.contact.damping,
        } *= factor;
        other
    }
}

/// How many impacts a line is laid through.
const POINTS: usize = 5;
/// By how much damping is weakened to see what it does.
const WEAKENED: f64 = 4.0;

/// The exponent with which a quantity grows with a parameter, where damping is weak.
///
/// The impact stands in the middle of so many decades of the parameter. The error has three parts: that of the numbers, that
/// of the straight line (how far the points are off it), and that of damping which is weak but there. The last one bends
/// the line so little that the points do not show it; hence everything is measured again with a quarter of the damping. A
/// departure proportional to the damping is 4/3 of what then changes, and twice that is reported.
///
/// # Errors
/// Those of [`Impact::run`].
pub fn exponent(
    quantity: Quantity,
    parameter: Parameter,
    impact: &Impact,
    decades: f64,
) -> Result<Numeric, ContactError> {
    let measured = |from: &Impact| {
        let points = (0..POINTS).map(|at| {
            let share = at as f64 / (POINTS - 1) as f64 - 0.5;
            let factor = 10f64.powf(decades * share);
            let rebound = parameter.times(factor, from).run()?;
            Ok((factor, quantity.of(&rebound)))
        });
        Ok(power_law(
            &points.collect::<Result<Vec<_>, ContactError>>()?,
        ))
    };
    let here = measured(impact)?;
    if impact.contact.damping == 0.0 {
        return Ok(here);
    }
    let weaker = measured(&Parameter::Damping.times(1.0 / WEAKENED, impact))?;
    let departure = (here.value - weaker.value).abs() * WEAKENED / (WEAKENED - 1.0);
    Ok(Numeric {
        value: here.value,
        error: here.error + weaker.error + 2.0 * departure,
    })
}

/// The exponent `p` of `y = C x^p`: the slope of the straight line of least squares through the logarithms.
///
/// The slope is a weighted sum of the `ln y`, so an error of each changes it by at most the sum of weight times error.
/// The error of a point is that of its number, and its distance from the line.
///
/// # Panics
/// With fewer than two different `x`, or numbers that are not positive.
pub fn power_law(points: &[(f64, Numeric)]) -> Numeric {
    let count = points.len() as f64;
    let mean = |of: &dyn Fn(&(f64, Numeric)) -> f64| points.iter().map(of).sum::<f64>() / count;
    assert!(
        points.iter().all(|(x, y)| *x > 0.0 && y.value > 0.0),
        "a power law relates positive numbers"
    );
    let (x, y) = (mean(&|p| p.0.ln()), mean(&|p| p.1.value.ln()));
    let spread = mean(&|p| (p.0.ln() - x).powi(2)) * count;
    assert!(spread > 0.0, "a slope needs two different places");
    let weight = |p: &(f64, Numeric)| (p.0.ln() - x) / spread;
    let value: f64 = points.iter().map(|p| weight(p) * p.1.value.ln()).sum();
    let error = points.iter().map(|p| {
        let off = p.1.value.ln() - y - value * (p.0.ln() - x);
        // A logarithm is itself off by a rounding.
        let own = p.1.error / p.1.value + f64::EPSILON * (1.0 + p.1.value.ln().abs());
        weight(p).abs() * (own + off.abs())
    });
    Numeric {
        value,
        error: error.sum(),
    }
}
