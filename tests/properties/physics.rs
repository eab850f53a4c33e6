//! Points at which the laws are true: computed by the collisions of `src/cradle`, not from any equation.

use cradle_verify::algebra::BigRational;
use cradle_verify::cradle::{Chain, efficiency, elastic, energy_loss, with_restitution};
use cradle_verify::derivation::Point;
use nalgebra::DVector;
use num_traits::{One, Zero};
use proptest::collection::vec;
use proptest::prelude::*;

pub fn ratio(numerator: i64, denominator: i64) -> BigRational {
    BigRational::new(numerator.into(), denominator.into())
}

pub fn whole(value: usize) -> BigRational {
    BigRational::from_integer(value.into())
}

pub fn positive() -> impl Strategy<Value = BigRational> {
    (1i64..40, 1i64..12).prop_map(|(n, d)| ratio(n, d))
}

pub fn nonzero() -> impl Strategy<Value = BigRational> {
    (positive(), any::<bool>()).prop_map(|(v, back)| if back { -v } else { v })
}

pub fn any_number() -> impl Strategy<Value = BigRational> {
    (-40i64..=40, 1i64..12).prop_map(|(n, d)| ratio(n, d))
}

pub fn restitution() -> impl Strategy<Value = BigRational> {
    (1i64..12).prop_flat_map(|d| (0..=d).prop_map(move |n| ratio(n, d)))
}

fn energy(mass: &BigRational, velocity: &BigRational) -> BigRational {
    mass * velocity * velocity / whole(2)
}

/// An elastic collision of unequal balls, the second at rest: pages 3.1 to 3.6.
pub fn unequal(m1: &BigRational, m2: &BigRational, v0: &BigRational) -> Point {
    let (w1, w2) = elastic(m1, m2, v0, &BigRational::zero());
    let ratio = m2 / m1;
    Point::new()
        .with_ratio("m_1", m1.clone())
        .with_ratio("m_2", m2.clone())
        .with_ratio("v_0", v0.clone())
        .with_ratio("E_0", energy(m1, v0))
        .with_ratio("E'_2", energy(m2, &w2))
        .with_ratio("v'_1", w1)
        .with_ratio("v'_2", w2)
        .with_ratio("\\eta", efficiency(&ratio))
        .with_ratio("\\mu", ratio)
}

/// A collision of identical balls with restitution `e`, of whose loss `heat` goes into heat: pages 2.1 and 2.5.
pub fn identical(m: &BigRational, v0: &BigRational, e: &BigRational, heat: &BigRational) -> Point {
    let zero = BigRational::zero();
    let (w1, w2) = with_restitution(m, m, v0, &zero, e);
    let loss = energy_loss(m, m, v0, &zero, e);
    // The same collision seen by an observer who moves along with the centre of mass.
    let half = v0 / whole(2);
    let (c1, c2) = (&w1 - &half, &w2 - &half);
    let centred = energy(m, &half) * whole(2);
    let left = energy(m, &c1) + energy(m, &c2);
    Point::new()
        .with_ratio("u'_1", c1)
        .with_ratio("u'_2", c2)
        .with_ratio("\\Delta E_{\\text{cm}}", &centred - &left)
        .with_ratio("E_{\\text{cm}}", centred)
        .with_ratio("E_{\\text{cm,after}}", left)
        .with_ratio("m", m.clone())
        .with_ratio("v_0", v0.clone())
        .with_ratio("e", e.clone())
        .with_ratio("E_0", energy(m, v0))
        .with_ratio("E_{\\text{after}}", energy(m, &w1) + energy(m, &w2))
        .with_ratio("E_{\\text{heat}}", heat * &loss)
        .with_ratio("E_{\\text{sound}}", (BigRational::one() - heat) * &loss)
        .with_ratio("\\Delta E_{\\text{total}}", loss)
        .with_ratio("v'_1", w1)
        .with_ratio("v'_2", w2)
}

/// The same velocities thrown to another place where sum and sum of squares are the same: the reflection
///
/// $$ p \mapsto p - 2 \frac{p \cdot d}{d \cdot d} d, \qquad \textstyle\sum d_i = 0. $$
pub fn scattered(mut velocities: Vec<BigRational>, direction: &[BigRational]) -> Vec<BigRational> {
    let count = velocities.len();
    let mean = direction[..count].iter().sum::<BigRational>() / whole(count);
    let d: Vec<BigRational> = direction[..count].iter().map(|c| c - &mean).collect();
    let length: BigRational = d.iter().map(|c| c * c).sum();
    if length.is_zero() {
        return velocities;
    }
    let along: BigRational = velocities.iter().zip(&d).map(|(p, c)| p * c).sum();
    let shift = whole(2) * along / length;
    for (velocity, c) in velocities.iter_mut().zip(&d) {
        *velocity -= &shift * c;
    }
    velocities
}

/// Page 1.4: of `balls`, `moving` come in with velocity `v0`; `after` are the velocities of those that leave.
#[derive(Clone, Debug)]
pub struct Cradle {
    pub balls: usize,
    pub moving: usize,
    pub v0: BigRational,
    pub after: Vec<BigRational>,
}

impl Cradle {
    pub fn point(&self) -> Point {
        Point::new()
            .with("N", self.balls)
            .with("n", self.moving)
            .with("k", self.after.len())
            .with_ratio("v_0", self.v0.clone())
            .with_list("u", self.after.iter().cloned())
            .with_ratio("u", self.after[0].clone())
    }
}

/// What a line of equal balls really does.
pub fn collided() -> impl Strategy<Value = Cradle> {
    (1usize..7, nonzero())
        .prop_flat_map(|(balls, v0)| (1..=balls, Just(balls), Just(v0)))
        .prop_map(|(moving, balls, v0)| {
            let before = DVector::from_fn(balls, |ball, _| match ball < moving {
                true => v0.clone(),
                false => BigRational::zero(),
            });
            // Balls that move to the left are the last ones of the line.
            let before = match v0 < BigRational::zero() {
                true => DVector::from_iterator(balls, before.iter().rev().cloned()),
                false => before,
            };
            let masses = DVector::from_element(balls, BigRational::one());
            let mut chain = Chain::new(masses, before, BigRational::one()).unwrap();
            chain.settle(balls * balls).unwrap();
            let leaving = chain.velocities().iter().filter(|v| !v.is_zero());
            Cradle {
                balls,
                moving,
                after: leaving.cloned().collect(),
                v0,
            }
        })
}

/// Whatever two conservation laws allow: `moving` balls come in, `k` of any velocities but 0 leave.
pub fn conserved() -> impl Strategy<Value = Cradle> {
    (
        1usize..5,
        0usize..4,
        0usize..3,
        nonzero(),
        vec(vec(any_number(), 8), 1..3),
    )
        .prop_map(|(moving, more, idle, v0, directions)| {
            let mut after = vec![v0.clone(); moving];
            after.resize(moving + more, BigRational::zero());
            for direction in &directions {
                after = scattered(after, direction);
            }
            Cradle {
                balls: moving + more + idle,
                moving,
                v0,
                after,
            }
        })
        .prop_filter("every ball that leaves moves", |cradle| {
            cradle.after.iter().all(|v| !v.is_zero())
        })
}
