//! Dimensions: the evidence that a formula compares what cannot be compared, or that it does not.
//!
//! A [`Scope`] says of each symbol that its dimension is declared, or that it is one of some numbered unknowns.
//! [`comparisons`] lists what a formula needs to be alike: its sides, summands, and pure numbers where only these
//! make sense. Each is a linear equation between exponents, so that
//!
//! - a **disagreement** is a combination of such equations in which every unknown cancels and a dimension is left:
//!   no choice of the unknowns makes all of them true. One formula alone may disagree with what is declared;
//! - an **agreement** is a solution that satisfies all of them.
//!
//! Both are checked by adding and comparing; who finds the multipliers and the solution is not believed.

mod compare;
mod exponent;
mod form;

use std::sync::Arc;

use num_traits::ToPrimitive;

use crate::algebra::{Base, BigRational, Dimension, Formula, Rational};
use crate::sorted::Map;

pub use compare::{Comparison, Member, What, comparisons};
pub use form::{Form, Said, Scope, Unknown};

/// A change of units raises its factor to no higher a power.
const HIGHEST_POWER: i32 = 10_000;

/// One comparison of a disagreement.
#[derive(Clone, Debug)]
pub struct Part {
    /// The formula.
    pub formula: Formula,
    /// What is said of its symbols.
    pub scope: Arc<Scope>,
    /// Which of its [`comparisons`].
    pub comparison: usize,
    /// How often it is taken.
    pub multiplier: Rational,
}

/// A change of one unit, and by how much the numbers on both sides of a comparison grow with it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Rescaling {
    /// Which unit becomes smaller.
    pub base: Base,
    /// How many of the new unit make one of the old.
    pub factor: BigRational,
    /// What the left side is multiplied by.
    pub left: BigRational,
    /// What the right side is multiplied by.
    pub right: BigRational,
}

/// What is handed over as a disagreement. Nothing in here is believed.
#[derive(Clone, Debug)]
pub struct Disagreement {
    /// The comparison at fault, then those that it disagrees with.
    pub parts: Vec<Part>,
    /// What the other parts say of the unknowns; no value mentions an unknown that has one.
    pub solution: Map<Unknown, Form>,
    /// A change of units that changes the truth, where there is one in exact numbers.
    pub rescaling: Option<Rescaling>,
}

/// A formula whose dimensions do not agree. Only [`check_disagreement`] builds one.
///
/// ```compile_fail
/// use cradle_exact::kernel::dimension::{Disagreement, IllDimensioned};
/// fn forge(evidence: Disagreement) -> IllDimensioned {
///     IllDimensioned { evidence, comparison: todo!() }
/// }
/// ```
#[derive(Clone, Debug)]
pub struct IllDimensioned {
    evidence: Disagreement,
    comparison: Comparison,
}

/// A formula whose dimensions all agree. Only [`check_agreement`] builds one.
///
/// ```compile_fail
/// use cradle_exact::kernel::dimension::WellDimensioned;
/// fn forge() -> WellDimensioned {
///     WellDimensioned { sides: Vec::new() }
/// }
/// ```
#[derive(Clone, Debug)]
pub struct WellDimensioned {
    sides: Vec<Option<Form>>,
}

/// Why evidence about dimensions is none.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mismatch {
    /// It names no comparison.
    Nothing,
    /// It names a comparison that its formula does not make.
    NoSuchComparison,
    /// Unknowns are left over when the comparisons are combined.
    UnknownsLeft,
    /// The comparison at fault does not take part.
    NotInvolved,
    /// The dimensions agree.
    Agrees,
    /// The solution does not solve, or goes in a circle.
    NoSolution,
    /// The change of units does not do what is said.
    WrongFactor,
}

impl IllDimensioned {
    /// The comparisons that cannot all be right, the one at fault first.
    pub fn parts(&self) -> &[Part] {
        &self.evidence.parts
    }

    /// What does not agree; the dimensions with all put in that the other parts say.
    pub fn comparison(&self) -> &Comparison {
        &self.comparison
    }

    /// A change of units that changes the truth.
    pub fn rescaling(&self) -> Option<&Rescaling> {
        self.evidence.rescaling.as_ref()
    }
}

impl WellDimensioned {
    /// The dimension of each term of the formula; none for 0 and where nothing is said.
    pub fn sides(&self) -> &[Option<Form>] {
        &self.sides
    }
}

/// Decides whether a disagreement is one.
///
/// # Errors
/// The first reason found for which it is none.
pub fn check_disagreement(evidence: Disagreement) -> Result<IllDimensioned, Mismatch> {
    let mut total = Form::default();
    let mut compared = Vec::new();
    for part in &evidence.parts {
        let mut all = comparisons(&part.formula, &part.scope);
        if part.comparison >= all.len() {
            return Err(Mismatch::NoSuchComparison);
        }
        let comparison = all.swap_remove(part.comparison);
        total.multiply(&comparison.quotient(), &part.multiplier);
        compared.push(comparison);
    }
    let Some(first) = evidence.parts.first() else {
        return Err(Mismatch::Nothing);
    };
    if first.multiplier.is_zero() {
        return Err(Mismatch::NotInvolved);
    }
    match total.dimension() {
        None => return Err(Mismatch::UnknownsLeft),
        Some(dimension) if dimension.is_none() => return Err(Mismatch::Agrees),
        Some(_) => {}
    }
    let solution = &evidence.solution;
    if !is_solved(solution) {
        return Err(Mismatch::NoSolution);
    }
    let solves = |c: &Comparison| c.quotient().with(solution).is_none();
    if !compared[1..].iter().all(solves) {
        return Err(Mismatch::NoSolution);
    }
    let mut comparison = compared.swap_remove(0);
    comparison.left.form = comparison.left.form.with(solution);
    if let Some(right) = &mut comparison.right {
        right.form = right.form.with(solution);
    }
    if let Some(rescaling) = &evidence.rescaling {
        check_rescaling(&comparison, rescaling)?;
    }
    Ok(IllDimensioned {
        evidence,
        comparison,
    })
}

/// Decides whether all dimensions in a formula agree under a solution for its unknowns.
///
/// # Errors
/// The first reason found for which they do not.
pub fn check_agreement(
    formula: &Formula,
    scope: &Scope,
    solution: &Map<Unknown, Form>,
) -> Result<WellDimensioned, Mismatch> {
    let (comparisons, sides) = compare::read(formula, scope);
    let agrees = |c: &Comparison| c.quotient().with(solution).is_none();
    match is_solved(solution) && comparisons.iter().all(agrees) {
        false => Err(Mismatch::NoSolution),
        true => Ok(WellDimensioned {
            sides: sides
                .iter()
                .map(|side| compare::form(side).map(|form| form.with(solution)))
                .collect(),
        }),
    }
}

/// A solution is put in once, so no value may mention an unknown that has one.
fn is_solved(solution: &Map<Unknown, Form>) -> bool {
    let mut mentioned = solution.values().flat_map(|form| form.unknowns.keys());
    mentioned.all(|unknown| !solution.contains_key(unknown))
}

fn check_rescaling(comparison: &Comparison, claimed: &Rescaling) -> Result<(), Mismatch> {
    let none = Dimension::none();
    let right = comparison.right.as_ref().map(|right| &right.form.known);
    let sides = [
        (&comparison.left.form.known, &claimed.left),
        (right.unwrap_or(&none), &claimed.right),
    ];
    for (dimension, factor) in sides {
        let exponent = dimension.exponent(claimed.base);
        if !exponent.is_some_and(|exponent| is_power(&claimed.factor, &exponent, factor)) {
            return Err(Mismatch::WrongFactor);
        }
    }
    match claimed.left == claimed.right {
        true => Err(Mismatch::WrongFactor),
        false => Ok(()),
    }
}

/// Whether `base^exponent = value`, for positive numbers.
fn is_power(base: &BigRational, exponent: &Rational, value: &BigRational) -> bool {
    let zero = BigRational::default();
    let small = |n: crate::algebra::BigInt| n.to_i32().filter(|n| n.abs() <= HIGHEST_POWER);
    let (Some(over), Some(under)) = (small(exponent.numer()), small(exponent.denom())) else {
        return false;
    };
    *base > zero && *value > zero && base.pow(over) == value.pow(under)
}
