//! Two balls meet head-on.
//!
//! Everything is worked out in the frame of their centre of mass, where a collision is as simple as it can be: each
//! ball's velocity turns round, and shrinks by the coefficient of restitution.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

/// The velocities after a head-on collision in which no kinetic energy is lost.
///
/// $$ v_i = 2V - u_i, \qquad V = \frac{m_1 u_1 + m_2 u_2}{m_1 + m_2} $$
///
/// **Units.** Masses in one unit, velocities in one unit. **Frame.** Any inertial one, the same for all four velocities.
/// **Source.** Landau–Lifshitz, *Mechanics*, §17. The other solution of the two conservation laws, nothing changed, is
/// the balls missing each other.
///
/// ```
/// use cradle_verify::cradle::{elastic, parse_exact};
/// let q = |text| parse_exact(text).unwrap();
/// // A ball strikes one of twice its mass, at rest, and comes back at a third of its speed.
/// assert_eq!(elastic(&q("1"), &q("2"), &q("1"), &q("0")), (q("-1/3"), q("2/3")));
/// ```
///
/// # Panics
/// If a mass is not positive.
pub fn elastic(
    m1: &BigRational,
    m2: &BigRational,
    u1: &BigRational,
    u2: &BigRational,
) -> (BigRational, BigRational) {
    with_restitution(m1, m2, u1, u2, &BigRational::one())
}

/// The velocities after a head-on collision with the coefficient of restitution `e`.
///
/// $$ v_i = V - e\,(u_i - V), \qquad V = \frac{m_1 u_1 + m_2 u_2}{m_1 + m_2} $$
///
/// Hence `v2 − v1 = e (u1 − u2)`, the definition of `e`: 1 loses nothing, at 0 the balls go on together.
///
/// **Units.** Masses in one unit, velocities in one unit, `e` a pure number from 0 to 1. **Frame.** Any inertial one.
/// **Source.** Goldsmith, *Impact* (1960), on stereomechanical impact.
///
/// ```
/// use cradle_verify::cradle::{parse_exact, with_restitution};
/// let q = |text| parse_exact(text).unwrap();
/// let (v1, v2) = with_restitution(&q("1"), &q("1"), &q("1"), &q("0"), &q("1/2"));
/// assert_eq!((v1, v2), (q("1/4"), q("3/4")));
/// ```
///
/// # Panics
/// If a mass is not positive.
pub fn with_restitution(
    m1: &BigRational,
    m2: &BigRational,
    u1: &BigRational,
    u2: &BigRational,
    e: &BigRational,
) -> (BigRational, BigRational) {
    assert!(
        m1.is_positive() && m2.is_positive(),
        "the masses {m1} and {m2} must be positive"
    );
    let centre = (m1 * u1 + m2 * u2) / (m1 + m2);
    let rebound = |u: &BigRational| &centre - e * (u - &centre);
    (rebound(u1), rebound(u2))
}

/// The kinetic energy that a head-on collision with restitution `e` turns into heat, sound and the like.
///
/// $$ \Delta E = \frac{1 - e^2}{2}\,\frac{m_1 m_2}{m_1 + m_2}\,(u_1 - u_2)^2 $$
///
/// This function does not use that formula: it subtracts the energy after the collision from the energy before. Only
/// the motion relative to the centre of mass can be lost. When a ball strikes an equal one at rest, half of its energy is
/// in the centre's motion, so the loss is `(1 − e²)/2` of what it brought.
///
/// **Units.** mass × velocity². **Frame.** The same result in every inertial frame. **Source.** Goldsmith, *Impact* (1960).
///
/// ```
/// use cradle_verify::cradle::{energy_loss, parse_exact};
/// let q = |text| parse_exact(text).unwrap();
/// // Equal balls that go on together lose half: 1/4 of the 1/2 brought.
/// assert_eq!(energy_loss(&q("1"), &q("1"), &q("1"), &q("0"), &q("0")), q("1/4"));
/// ```
///
/// # Panics
/// If a mass is not positive.
pub fn energy_loss(
    m1: &BigRational,
    m2: &BigRational,
    u1: &BigRational,
    u2: &BigRational,
    e: &BigRational,
) -> BigRational {
    let (v1, v2) = with_restitution(m1, m2, u1, u2, e);
    energy(m1, u1) + energy(m2, u2) - energy(m1, &v1) - energy(m2, &v2)
}

/// The share of its kinetic energy that a ball hands to one at rest, `mu` times as heavy, in an elastic collision.
///
/// $$ \eta = \frac{m_2 v_2^2}{m_1 u_1^2} = \frac{4\mu}{(1 + \mu)^2}, \qquad \mu = \frac{m_2}{m_1} $$
///
/// This function does not use that formula: it lets the two balls collide and compares the energies.
///
/// **Units.** Pure numbers. **Frame.** Where the struck ball rests. **Source.** Landau–Lifshitz, *Mechanics*, §17, at
/// head-on impact.
///
/// ```
/// use cradle_verify::cradle::{efficiency, parse_exact};
/// assert_eq!(efficiency(&parse_exact("3").unwrap()).to_string(), "3/4");
/// ```
///
/// # Panics
/// If `mu` is not positive.
pub fn efficiency(mu: &BigRational) -> BigRational {
    let (striking, speed) = (BigRational::one(), BigRational::one());
    let (_, struck) = elastic(&striking, mu, &speed, &BigRational::zero());
    energy(mu, &struck) / energy(&striking, &speed)
}

fn energy(mass: &BigRational, velocity: &BigRational) -> BigRational {
    mass * velocity * velocity / BigInt::from(2)
}
