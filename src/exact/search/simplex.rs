//! Nonnegative solutions of linear equations, exactly.

use crate::algebra::Rational;

/// A guess: a problem of this size that needs more pivots is not worth waiting for.
const MOST_PIVOTS: usize = 250;

/// Finds `x ≥ 0` with `A x = b` by the first phase of the simplex method with Bland's rule.
///
/// `columns` are the columns of `A`, sparse: (row, value). `None` where there is no solution, or none was
/// found within the bound.
pub fn nonnegative_solution(
    columns: &[Vec<(usize, Rational)>],
    right: &[Rational],
) -> Option<Vec<Rational>> {
    let (rows, n) = (right.len(), columns.len());
    // One artificial unknown a row; its sign makes the right side nonnegative.
    let mut table: Vec<Vec<Rational>> = vec![vec![Rational::zero(); n + 1]; rows];
    for (column, entries) in columns.iter().enumerate() {
        for (row, value) in entries {
            table[*row][column] = value.clone();
        }
    }
    for (row, value) in right.iter().enumerate() {
        table[row][n] = value.clone();
        if value.is_negative() {
            table[row].iter_mut().for_each(|x| *x = -x.clone());
        }
    }
    // Artificial unknowns are numbered from n on and never enter again.
    let mut basis: Vec<usize> = (n..n + rows).collect();
    // The sum of the artificial unknowns, to be brought to 0: its gradient is minus the column sums.
    let mut gain: Vec<Rational> = (0..=n)
        .map(|c| {
            table
                .iter()
                .fold(Rational::zero(), |sum, row| sum + &row[c])
        })
        .collect();
    for _ in 0..MOST_PIVOTS {
        if gain[n].is_zero() {
            let mut solution = vec![Rational::zero(); n];
            for (row, &unknown) in basis.iter().enumerate() {
                if unknown < n {
                    solution[unknown] = table[row][n].clone();
                }
            }
            return Some(solution);
        }
        let entering = (0..n).find(|&c| gain[c].is_positive())?;
        let leaving = (0..rows)
            .filter(|&r| table[r][entering].is_positive())
            .min_by_key(|&r| (&table[r][n] / &table[r][entering], basis[r]))?;
        let pivot = table[leaving][entering].recip();
        if !pivot.is_one() {
            table[leaving]
                .iter_mut()
                .filter(|x| !x.is_zero())
                .for_each(|x| *x *= &pivot);
        }
        let source = table[leaving].clone();
        let targets = table.iter_mut().enumerate().filter(|(r, _)| *r != leaving);
        for row in targets.map(|(_, row)| row).chain([&mut gain]) {
            let factor = row[entering].clone();
            if factor.is_zero() {
                continue;
            }
            for (x, s) in row.iter_mut().zip(&source) {
                if !s.is_zero() {
                    *x -= &factor * s;
                }
            }
        }
        basis[leaving] = entering;
    }
    None
}
