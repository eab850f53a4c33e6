//! What follows from equations: linear unknowns are eliminated, the rest is left to Buchberger's algorithm.

use std::cmp::Reverse;

use num_integer::Integer;
use smallvec::SmallVec;

use super::tracked::{Pivot, Reduced, Tracked, next_division};
use crate::algebra::{Polynomial, TooLarge, Var};
use crate::kernel::{Fact, Knowledge, Sign};
use crate::sorted;

/// Guesses at what a derivation step can need; beyond them the search gives up.
const MOST_BASIS_ELEMENTS: usize = 40;
const MOST_PAIRS: usize = 150;
const MOST_REDUCTIONS: usize = 3_000;
const HIGHEST_DEGREE: u32 = 14;
const MOST_TERMS: usize = 300;
/// Room is made for so many unknowns of an equation.
const LIKELY_UNKNOWNS: usize = 8;

/// The equations of a problem in a form that decides membership.
pub struct Ideal {
    /// Each removes one unknown from everything after it.
    pivots: Vec<Pivot>,
    /// What is left, in which no unknown is linear with a coefficient that cannot vanish.
    pub rest: Vec<Tracked>,
    divisors: Vec<Polynomial>,
}

impl Ideal {
    /// Eliminates all unknowns that can be.
    pub fn new(facts: &[Fact], knowledge: &Knowledge) -> Result<Self, TooLarge> {
        Ideal::without(facts, knowledge, |_| true)
    }

    /// Eliminates all unknowns that can be, some of them only once no other is left.
    pub fn keeping(
        facts: &[Fact],
        knowledge: &Knowledge,
        kept: impl Fn(Var) -> bool,
    ) -> Result<Self, TooLarge> {
        let phases: [&dyn Fn(Var) -> bool; 2] = [&|var| !kept(var), &|_| true];
        Ideal::in_phases(facts, knowledge, &phases)
    }

    /// Eliminates some of the unknowns, as far as they can be.
    pub fn without(
        facts: &[Fact],
        knowledge: &Knowledge,
        unwanted: impl Fn(Var) -> bool,
    ) -> Result<Self, TooLarge> {
        Ideal::in_phases(facts, knowledge, &[&unwanted])
    }

    fn in_phases(
        facts: &[Fact],
        knowledge: &Knowledge,
        phases: &[&dyn Fn(Var) -> bool],
    ) -> Result<Self, TooLarge> {
        let divisors = divisors(facts);
        let mut pending: Vec<Tracked> = facts
            .iter()
            .enumerate()
            .filter(|(_, f)| f.sign == Sign::Zero && !f.polynomial.is_zero())
            .map(|(at, f)| Tracked::equation(at, f.polynomial.clone()))
            .collect();
        pending
            .iter_mut()
            .for_each(|e| e.strip(knowledge, &divisors));
        let mut ideal = Ideal {
            pivots: Vec::new(),
            rest: pending,
            divisors,
        };
        for unwanted in phases {
            let linear = |_: &[Tracked], var| u32::from(unwanted(var));
            ideal.eliminate(knowledge, linear)?;
        }
        Ok(ideal)
    }

    /// Solves for powers of unknowns, as long as an element is linear in one. `power` says for which, and 0 for none.
    fn eliminate(
        &mut self,
        knowledge: &Knowledge,
        power: impl Fn(&[Tracked], Var) -> u32,
    ) -> Result<(), TooLarge> {
        while let Some(best) = best_pivot(&self.rest, knowledge, &power) {
            let pivot = best.pivot(self.rest.remove(best.at));
            for element in &mut self.rest {
                if element.polynomial.has(pivot.var) {
                    *element = element.eliminate(&pivot)?;
                    element.strip(knowledge, &self.divisors);
                }
            }
            self.rest.retain(|e| !e.polynomial.is_zero());
            self.pivots.push(pivot);
        }
        Ok(())
    }

    /// The same with what is left solved for powers, too: for `q^2`, where no `q` stands alone. `None` where none can be.
    pub fn by_powers(&self, knowledge: &Knowledge) -> Result<Option<Self>, TooLarge> {
        let common = |rest: &[Tracked], var| {
            let terms = rest.iter().flat_map(|e| e.polynomial.terms());
            terms.fold(0, |common, (monomial, _)| {
                common.gcd(&monomial.exponent(var))
            })
        };
        if best_pivot(&self.rest, knowledge, common).is_none() {
            return Ok(None);
        }
        let mut ideal = Ideal {
            pivots: self.pivots.clone(),
            rest: self.rest.clone(),
            divisors: self.divisors.clone(),
        };
        ideal.eliminate(knowledge, common)?;
        Ok(Some(ideal))
    }

    /// The unknown that was eliminated first.
    pub fn first(&self) -> Option<Var> {
        self.pivots.first().map(|pivot| pivot.var)
    }

    /// The goal with all pivots' unknowns removed.
    pub fn reduce(&self, goal: &Polynomial, keep_sign: bool) -> Result<Reduced, TooLarge> {
        let mut reduced = Reduced::new(goal.clone());
        for pivot in &self.pivots {
            reduced.eliminate(pivot, keep_sign)?;
        }
        Ok(reduced)
    }

    /// A Gröbner basis of what is left, or as much of one as the bounds allow.
    pub fn basis(&self, knowledge: &Knowledge) -> Vec<Tracked> {
        let mut basis = self.rest.clone();
        let mut pairs: Vec<(usize, usize)> = Vec::new();
        for j in 0..basis.len() {
            pairs.extend((0..j).map(|i| (i, j)));
        }
        let mut steps = MOST_REDUCTIONS;
        for _ in 0..MOST_PAIRS {
            // The smallest pair first.
            let size = |&(i, j): &(usize, usize)| lcm_degree(&basis[i], &basis[j]);
            let Some(next) = (0..pairs.len()).min_by_key(|&at| (size(&pairs[at]), pairs[at]))
            else {
                break;
            };
            let (i, j) = pairs.swap_remove(next);
            let Ok(Some(mut element)) = s_polynomial(&basis[i], &basis[j]) else {
                continue;
            };
            if reduce_element(&mut element, &basis, &mut steps).is_err() {
                continue;
            }
            element.strip(knowledge, &self.divisors);
            let polynomial = &element.polynomial;
            if polynomial.is_zero()
                || polynomial.degree() > HIGHEST_DEGREE
                || polynomial.len() > MOST_TERMS
            {
                continue;
            }
            pairs.extend((0..basis.len()).map(|k| (k, basis.len())));
            let done = knowledge.is_nonzero(polynomial);
            basis.push(element);
            if done || basis.len() >= MOST_BASIS_ELEMENTS {
                break;
            }
        }
        basis
    }
}

/// Polynomials that are known not to vanish and may be divided out, unknowns aside.
fn divisors(facts: &[Fact]) -> Vec<Polynomial> {
    let mut divisors: Vec<Polynomial> = facts
        .iter()
        .filter(|f| matches!(f.sign, Sign::NonZero | Sign::Positive) && f.polynomial.len() > 1)
        .map(|f| f.polynomial.without_content().1.monic())
        .collect();
    sorted::sort(&mut divisors);
    divisors.dedup();
    divisors
}

/// The element and unknown that are the cheapest to eliminate with.
struct Best {
    /// Where the element stands.
    at: usize,
    var: Var,
    power: u32,
    positive: bool,
    negative: bool,
}

impl Best {
    /// The element with the unknown to be solved for, its sign turned round where that makes the coefficient positive.
    fn pivot(&self, mut element: Tracked) -> Pivot {
        if self.negative {
            element = element.negated();
        }
        Pivot {
            var: self.var,
            power: self.power,
            coefficient: (element.polynomial).coefficient_of_power(self.var, self.power),
            positive: self.positive || self.negative,
            element,
        }
    }
}

fn best_pivot(
    pending: &[Tracked],
    knowledge: &Knowledge,
    power: impl Fn(&[Tracked], Var) -> u32,
) -> Option<Best> {
    // The cheapest first: what its coefficient is known to be need not be asked of the others.
    let mut choices = Vec::with_capacity(LIKELY_UNKNOWNS * pending.len());
    for (at, element) in pending.iter().enumerate() {
        let costs = costs(&element.polynomial, |var| power(pending, var));
        choices.extend(costs.into_iter().filter_map(|own| {
            let rank = (own.of()?, element.polynomial.len(), Reverse(own.var), at);
            Some((rank, own.power))
        }));
    }
    loop {
        let cheapest = (0..choices.len()).min_by_key(|&own| choices[own].0)?;
        let ((cost, _, Reverse(var), at), power) = choices.swap_remove(cheapest);
        // What is constant need not be looked at.
        let (positive, negative, nonzero) = match cost {
            0 => (true, false, true),
            _ => {
                let own = pending[at].polynomial.coefficient_of_power(var, power);
                let positive = knowledge.is_positive(&own);
                let negative = !positive && knowledge.is_positive(&own.negated());
                let nonzero = positive || negative || knowledge.is_nonzero(&own);
                (positive, negative, nonzero)
            }
        };
        if nonzero {
            return Some(Best {
                at,
                var,
                power,
                positive,
                negative,
            });
        }
    }
}

/// What it takes to solve for a power of an unknown.
struct Cost {
    var: Var,
    power: u32,
    /// How long the coefficient of the power is, and whether it has a constant term.
    length: usize,
    constant: bool,
    /// There are other powers.
    others: bool,
}

impl Cost {
    /// How long the coefficient is, 0 for a constant; `None` where there are other powers.
    fn of(&self) -> Option<usize> {
        match (self.length, self.constant) {
            _ if self.others => None,
            (1, true) => Some(0),
            (length, _) => Some(length),
        }
    }
}

/// What it takes to solve for each unknown of a polynomial; `power` says for which power of it.
fn costs(polynomial: &Polynomial, power: impl Fn(Var) -> u32) -> SmallVec<[Cost; 8]> {
    let mut costs: SmallVec<[Cost; 8]> = SmallVec::new();
    for (monomial, _) in polynomial.terms() {
        for &(var, exponent) in monomial.powers() {
            let at = costs.iter().position(|own| own.var == var);
            let at = at.unwrap_or_else(|| {
                costs.push(Cost {
                    var,
                    power: power(var),
                    length: 0,
                    constant: false,
                    others: false,
                });
                costs.len() - 1
            });
            let own = &mut costs[at];
            own.length += 1;
            own.constant |= monomial.degree() == exponent;
            own.others |= exponent != own.power;
        }
    }
    costs
}

fn lcm_degree(a: &Tracked, b: &Tracked) -> u32 {
    match (a.polynomial.leading(), b.polynomial.leading()) {
        (Some((m, _)), Some((n, _))) => m.lcm(n).degree(),
        _ => u32::MAX,
    }
}

/// `None` where the leading terms have nothing in common, so that the result would reduce to 0.
fn s_polynomial(a: &Tracked, b: &Tracked) -> Result<Option<Tracked>, TooLarge> {
    let (Some((m, c)), Some((n, d))) = (a.polynomial.leading(), b.polynomial.leading()) else {
        return Ok(None);
    };
    if m.gcd(n).is_one() {
        return Ok(None);
    }
    let lcm = m.lcm(n);
    let (Some(p), Some(q)) = (lcm.divided_by(m), lcm.divided_by(n)) else {
        return Ok(None);
    };
    let (p, q) = (
        Polynomial::term(p, c.recip()),
        Polynomial::term(q, d.recip()),
    );
    a.combine(&p, b, &q).map(Some)
}

fn reduce_element(
    element: &mut Tracked,
    basis: &[Tracked],
    steps: &mut usize,
) -> Result<(), TooLarge> {
    while let Some((quotient, other)) = next_division(&element.polynomial, basis) {
        *steps = steps.checked_sub(1).ok_or(TooLarge)?;
        element.subtract(&quotient, other)?;
    }
    Ok(())
}
