//! A line of balls that collide pair by pair.
//!
//! Hanging balls that seem to touch are taken to be an infinitesimal distance apart, so that only two ever meet at once.
//! Where several pairs approach each other the leftmost meets first: a rule, not a law. It cannot matter for equal
//! elastic balls, which only exchange velocities and so end up sorted by them. For unequal or inelastic balls the real
//! order depends on gaps that this picture does not know, and so may the outcome: [`Line`](super::Line) knows them.

use nalgebra::DVector;
use num_rational::BigRational;
use num_traits::{One, Signed};

use super::collision::with_restitution;
use super::error::{ChainError, massless};

/// Balls on a line, left to right, and how they rebound from one another.
///
/// ```
/// use cradle_verify::cradle::{Chain, list_text, parse_exact, parse_list};
/// let masses = parse_list("1, 1, 1, 1, 1").unwrap();
/// let mut cradle = Chain::new(masses, parse_list("1, 1, 0, 0, 0").unwrap(), parse_exact("1").unwrap()).unwrap();
/// assert_eq!(cradle.settle(100).unwrap().len(), 6);
/// assert_eq!(list_text(cradle.velocities()), "(0, 0, 0, 1, 1)");
/// ```
#[derive(Clone, Debug)]
pub struct Chain {
    masses: DVector<BigRational>,
    velocities: DVector<BigRational>,
    restitution: BigRational,
}

/// One collision of a ball with its right-hand neighbour.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Encounter {
    /// The left ball of the two, counted from 0.
    pub left: usize,
    /// The two velocities before, left ball first.
    pub before: (BigRational, BigRational),
    /// The two velocities after, left ball first.
    pub after: (BigRational, BigRational),
}

impl Chain {
    /// Balls of these masses, moving at these velocities, that rebound with this coefficient of restitution.
    ///
    /// # Errors
    /// Unless there is a ball, each has a positive mass and a velocity, and the coefficient lies between 0 and 1.
    pub fn new(
        masses: DVector<BigRational>,
        velocities: DVector<BigRational>,
        restitution: BigRational,
    ) -> Result<Self, ChainError> {
        if masses.is_empty() {
            return Err(ChainError::NoBalls);
        }
        if masses.len() != velocities.len() {
            return Err(ChainError::LengthsDiffer {
                masses: masses.len(),
                velocities: velocities.len(),
            });
        }
        if let Some((ball, mass)) = massless(&masses) {
            return Err(ChainError::MassNotPositive { ball, mass });
        }
        if restitution.is_negative() || restitution > BigRational::one() {
            return Err(ChainError::RestitutionOutOfRange(restitution));
        }
        Ok(Chain {
            masses,
            velocities,
            restitution,
        })
    }

    /// The masses, left to right.
    pub fn masses(&self) -> &DVector<BigRational> {
        &self.masses
    }

    /// The velocities now, left to right.
    pub fn velocities(&self) -> &DVector<BigRational> {
        &self.velocities
    }

    /// The coefficient of restitution.
    pub fn restitution(&self) -> &BigRational {
        &self.restitution
    }

    /// The next collision, that of the leftmost approaching pair; none if no ball is faster than its right-hand neighbour.
    pub fn collide_next(&mut self) -> Option<Encounter> {
        (1..self.masses.len()).find_map(|right| self.collide(right - 1))
    }

    /// Lets the balls collide until they part, and tells the collisions in order.
    ///
    /// Elastic balls always part (Burago–Ferleger–Kononenko, *Ann. of Math.* 147, 1998, even in space); equal ones after
    /// as many collisions as there are pairs in the wrong order, at most `N(N − 1)/2`. Inelastic balls need not: three
    /// that stick (`e = 0`) close in on their common velocity for ever.
    ///
    /// # Errors
    /// [`ChainError::TooManyCollisions`] if they still approach after `at_most` collisions; the chain is left as it then is.
    pub fn settle(&mut self, at_most: usize) -> Result<Vec<Encounter>, ChainError> {
        let mut story = Vec::new();
        while story.len() < at_most {
            let Some(encounter) = self.collide_next() else {
                return Ok(story);
            };
            story.push(encounter);
        }
        if self.is_approaching() {
            Err(ChainError::TooManyCollisions(at_most))
        } else {
            Ok(story)
        }
    }

    /// The first pass of the pulse: each pair that approaches when its turn comes collides once, from left to right.
    ///
    /// With one ball in at `v0` and the rest standing, every later pair is struck in turn, and the last ball leaves with
    ///
    /// $$ v_N = v_0 \prod_{i=1}^{N-1} \frac{(1 + e)\,m_i}{m_i + m_{i+1}}, \qquad
    ///    \text{for equal masses} \quad \left(\frac{1 + e}{2}\right)^{N-1} v_0 . $$
    ///
    /// For `e < 1` the balls behind still move. If they catch up with the front before it has passed, then
    /// [`Chain::settle`], which lets the leftmost pair go first, strikes the last ball harder. Up to three equal balls that
    /// cannot be; with four it happens for `e < 3 − 2√2`; with more, for larger `e` too.
    ///
    /// **Units.** Velocities in one unit, `e` a pure number. **Frame.** Where the struck balls rest.
    pub fn first_pass(&mut self) -> Vec<Encounter> {
        (1..self.masses.len())
            .filter_map(|right| self.collide(right - 1))
            .collect()
    }

    /// Whether some ball is faster than its right-hand neighbour.
    pub fn is_approaching(&self) -> bool {
        (1..self.velocities.len()).any(|right| self.velocities[right - 1] > self.velocities[right])
    }

    /// Collides ball `left` with its right-hand neighbour if they approach each other.
    fn collide(&mut self, left: usize) -> Option<Encounter> {
        let (m, v, right) = (&self.masses, &mut self.velocities, left + 1);
        if v[left] <= v[right] {
            return None;
        }
        let after = with_restitution(&m[left], &m[right], &v[left], &v[right], &self.restitution);
        let before = (
            std::mem::replace(&mut v[left], after.0.clone()),
            std::mem::replace(&mut v[right], after.1.clone()),
        );
        Some(Encounter {
            left,
            before,
            after,
        })
    }
}
