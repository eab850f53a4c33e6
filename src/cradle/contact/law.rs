//! The force between two balls that are pressed together.

use super::numeric::{ContactError, positive};

/// Two balls in contact: how hard they resist being pressed together.
///
/// $$ F(\delta, \dot\delta) = k\,\delta^{3/2} + \gamma\,\delta^{1/2}\dot\delta \qquad (\delta > 0), $$
///
/// with `δ` the mutual approach of the centres since touch. Hertz's law is `γ = 0`.
///
/// **Units.** In SI, `δ` in m, `F` in N, `k` in N m^(−3/2), `γ` in N s m^(−3/2). **Frame.** Any: only the distance of the
/// two enters. **Source.** Johnson, *Contact Mechanics* (1985), §4.2, for `k`; Brilliantov and Pöschel, *Kinetic Theory
/// of Granular Gases* (2004), ch. 3, for the term with `γ`. It is a quasistatic law: the impact must be slow against the speed of
/// sound in the balls, and the patch of contact small against them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// `k`.
    pub stiffness: f64,
    /// `γ`; 0 for perfectly elastic balls.
    pub damping: f64,
}

/// An elastic impact lasts this many times the largest compression over the speed.
///
/// From `δ'² = v²(1 − x^{5/2})` with `x = δ/δ_max`, there and back,
///
/// $$ \frac{v\tau}{\delta_{\max}} = 2\int_0^1 \frac{dx}{\sqrt{1 - x^{5/2}}} = \frac45\,\mathrm{B}\!\left(\tfrac25, \tfrac12\right)
///    = \frac{4\sqrt\pi\,\Gamma(2/5)}{5\,\Gamma(9/10)} = 2.943\ldots $$
///
/// **Source.** Johnson, *Contact Mechanics*, §11.4 (2.94); Landau–Lifshitz, *Theory of Elasticity*, §9, problem.
pub const CONTACT_TIME: f64 = 2.943_275_184_324_704_7;

/// A weakly damped impact loses this many times `γ δ_max^{3/2} v`.
///
/// The work of the viscous force along the path of the elastic impact, there and back,
///
/// $$ \frac{1}{\gamma\delta_{\max}^{3/2} v}\oint \gamma\delta^{1/2}\dot\delta\,d\delta = 2\int_0^1 \sqrt{x\,(1 - x^{5/2})}\,dx
///    = \frac45\,\mathrm{B}\!\left(\tfrac35, \tfrac32\right) = 1.008\ldots $$
pub const WEAK_LOSS: f64 = 1.008_909_788_539_656_3;

impl Contact {
    /// The contact of two identical spheres of one material.
    ///
    /// $$ k = \tfrac43 E^* \sqrt{R^*}, \qquad E^* = \frac{E}{2(1 - \nu^2)}, \qquad R^* = \frac R2 $$
    ///
    /// **Units.** `young` in Pa, `radius` in m. **Source.** Johnson, *Contact Mechanics*, eqs. 4.22 to 4.24.
    ///
    /// # Errors
    /// A modulus or radius that is not positive, or a Poisson ratio not between −1 and 1/2.
    pub fn of_twins(young: f64, poisson: f64, radius: f64) -> Result<Self, ContactError> {
        positive("modulus", young)?;
        positive("radius", radius)?;
        positive("distance of Poisson's ratio from −1", 1.0 + poisson)?;
        positive(
            "distance of Poisson's ratio from just above 1/2",
            0.5 + f64::EPSILON - poisson,
        )?;
        let modulus = young / (2.0 * (1.0 - poisson * poisson));
        Ok(Contact {
            stiffness: 4.0 / 3.0 * modulus * (radius / 2.0).sqrt(),
            damping: 0.0,
        })
    }

    /// The same contact with this damping.
    #[must_use]
    pub fn damped(self, damping: f64) -> Self {
        Contact { damping, ..self }
    }

    /// The force that pushes the balls apart; none where they do not touch.
    pub fn force(&self, compression: f64, rate: f64) -> f64 {
        match compression > 0.0 {
            true => compression.sqrt() * (self.stiffness * compression + self.damping * rate),
            false => 0.0,
        }
    }

    /// The elastic energy stored at a compression: `(2/5) k δ^{5/2}`.
    pub fn stored(&self, compression: f64) -> f64 {
        0.4 * self.stiffness * compression * compression * compression.sqrt()
    }

    /// The largest compression without damping, where all relative motion has become elastic energy:
    /// `δ_max = (5 μ v² / 4 k)^{2/5}`, with `μ` the reduced mass and `v` the relative speed.
    pub fn largest_compression(&self, reduced_mass: f64, speed: f64) -> f64 {
        (1.25 * reduced_mass * speed * speed / self.stiffness).powf(0.4)
    }

    /// How long the balls touch without damping: [`CONTACT_TIME`] times `δ_max / v`.
    pub fn duration(&self, reduced_mass: f64, speed: f64) -> f64 {
        CONTACT_TIME * self.largest_compression(reduced_mass, speed) / speed
    }

    /// The energy lost where damping is weak, to first order in it: [`WEAK_LOSS`] times `γ δ_max^{3/2} v`.
    pub fn weak_loss(&self, reduced_mass: f64, speed: f64) -> f64 {
        WEAK_LOSS * self.damping * self.largest_compression(reduced_mass, speed).powf(1.5) * speed
    }
}
