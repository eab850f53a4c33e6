//! A choice of units: which unknowns may be set to 1 without loss.
//!
//! Where every equation and condition is homogeneous (momentum is in velocities and in masses), all points
//! can be rescaled, and one unknown for each independent rescaling can be taken to be 1, −1 or 0. It is the
//! physicist's "let m = v₀ = 1".

use crate::algebra::{Polynomial, Rational, Var};

/// Unknowns that can be given the values 1, −1 and 0 only: for each a rescaling that leaves the others alone
/// and multiplies every remaining unknown by an integer power of one factor.
///
/// `order` lists all unknowns, those that should be set first; `fixed` ones cannot be rescaled.
pub fn unit_choices<'a>(
    polynomials: impl Iterator<Item = &'a Polynomial>,
    order: &[Var],
    fixed: impl Fn(Var) -> bool,
) -> Vec<Var> {
    let column = |var: Var| order.iter().position(|v| *v == var);
    let width = order.len();
    let mut rows: Vec<Vec<Rational>> = Vec::new();
    let blank = || vec![Rational::zero(); width];
    for (at, &var) in order.iter().enumerate() {
        if fixed(var) {
            let mut row = blank();
            row[at] = Rational::one();
            rows.push(row);
        }
    }
    // All terms of a polynomial must scale alike.
    for polynomial in polynomials {
        let mut terms = polynomial.terms().map(|(monomial, _)| {
            let mut row = blank();
            for &(var, exponent) in monomial.powers() {
                if let Some(at) = column(var) {
                    row[at] = exponent.into();
                }
            }
            row
        });
        let Some(first) = terms.next() else {
            continue;
        };
        for other in terms {
            rows.push(other.iter().zip(&first).map(|(a, b)| a - b).collect());
        }
    }
    let pivots = reduce(&mut rows, width);
    // A free column is a rescaling: the unknown itself by the factor, each pivot by what its row says.
    let free = (0..width).filter(|at| !pivots.contains(at));
    let whole = |at: &usize| {
        rows.iter()
            .take(pivots.len())
            .all(|row| row[*at].is_integer())
    };
    free.filter(whole).map(|at| order[at]).collect()
}

/// Brings rows to reduced echelon form and says which columns lead. The last columns lead first, so that the
/// first ones stay free.
fn reduce(rows: &mut [Vec<Rational>], width: usize) -> Vec<usize> {
    let mut pivots = Vec::new();
    for column in (0..width).rev() {
        let done = pivots.len();
        let Some(at) = (done..rows.len()).find(|&row| !rows[row][column].is_zero()) else {
            continue;
        };
        rows.swap(done, at);
        let scale = rows[done][column].recip();
        rows[done].iter_mut().for_each(|x| *x *= &scale);
        let lead = rows[done].clone();
        for (other, row) in rows.iter_mut().enumerate() {
            let factor = row[column].clone();
            if other != done && !factor.is_zero() {
                row.iter_mut()
                    .zip(&lead)
                    .for_each(|(x, l)| *x -= &(&factor * l));
            }
        }
        pivots.push(column);
    }
    pivots
}
