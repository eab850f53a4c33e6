//! A choice of units: which unknowns may be set to 1 without loss.
//!
//! Where every equation and condition is homogeneous (momentum is in velocities and in masses), all points
//! can be rescaled, and one unknown for each independent rescaling can be taken to be 1, −1 or 0. It is the
//! physicist's "let m = v₀ = 1".

use crate::algebra::{Polynomial, Rational, Var};
use crate::sorted::{self, Map, Set};

/// An equation between exponents: the coefficients that are not 0, by the place of the unknown. Most rows name two or three.
type Row = Map<usize, Rational>;

/// Unknowns that can be given the values 1, −1 and 0 only: for each a rescaling that leaves the others alone
/// and multiplies every remaining unknown by an integer power of one factor.
///
/// `order` lists all unknowns, those that should be set first; `fixed` ones cannot be rescaled.
pub fn unit_choices<'a>(
    polynomials: impl Iterator<Item = &'a Polynomial>,
    order: &[Var],
    fixed: impl Fn(Var) -> bool,
) -> Vec<Var> {
    let place: Map<Var, usize> = order.iter().enumerate().map(|(at, v)| (*v, at)).collect();
    let mut rows = Echelon::default();
    for (_, &at) in place.iter().filter(|(var, _)| fixed(**var)) {
        rows.insert(Row::from([(at, Rational::one())]));
    }
    // All terms of a polynomial must scale alike; where there is one, that says nothing.
    for polynomial in polynomials.filter(|polynomial| polynomial.len() > 1) {
        let terms = polynomial.terms().map(|(monomial, _)| -> Row {
            let powers = monomial.powers().iter();
            powers
                .filter_map(|(var, exponent)| Some((*place.get(var)?, (*exponent).into())))
                .collect()
        });
        // Each is held against the one whose last unknown comes first: in a sum of many unknowns every row is then led by one of its own,
        // and none has to be led on through those before it.
        let mut terms: Vec<Row> = terms.collect();
        let last = |row: &Row| row.last_key_value().map(|own| *own.0);
        sorted::sort_by_key(&mut terms, last);
        let mut terms = terms.into_iter();
        let Some(first) = terms.next() else {
            continue;
        };
        for mut other in terms {
            subtract(&mut other, &Rational::one(), &first);
            rows.insert(other);
        }
    }
    // A free column is a rescaling: the unknown itself by the factor, each pivot by what its row says.
    let reduced = rows.reduced();
    let entries = reduced.values().flatten();
    let broken: Set<usize> = entries
        .filter(|(_, exponent)| !exponent.is_integer())
        .map(|(at, _)| *at)
        .collect();
    let free = (0..order.len()).filter(|at| !reduced.contains_key(at) && !broken.contains(at));
    free.map(|at| order[at]).collect()
}

/// Independent rows by the column that leads each, with coefficient 1: its last, so that the first columns stay free.
#[derive(Default)]
struct Echelon(Map<usize, Row>);

impl Echelon {
    fn insert(&mut self, mut row: Row) {
        while let Some((&column, factor)) = row.last_key_value() {
            let factor = factor.clone();
            match self.0.get(&column) {
                Some(lead) => subtract(&mut row, &factor, lead),
                None => {
                    let scale = factor.recip();
                    row.values_mut().for_each(|x| *x *= &scale);
                    self.0.insert(column, row);
                    return;
                }
            }
        }
    }

    /// The same equations, with nothing but free columns in a row besides the one that leads it.
    fn reduced(self) -> Map<usize, Row> {
        let mut done: Map<usize, Row> = Map::new();
        for (column, mut row) in self.0 {
            let leading: Vec<usize> = row
                .keys()
                .filter(|c| done.contains_key(c))
                .copied()
                .collect();
            for other in leading {
                let factor = row[&other].clone();
                subtract(&mut row, &factor, &done[&other]);
            }
            done.insert(column, row);
        }
        done
    }
}

/// `row − factor · other`.
fn subtract(row: &mut Row, factor: &Rational, other: &Row) {
    for (&column, value) in other {
        let slot = row.entry(column).or_insert_with(Rational::zero);
        *slot -= &(factor * value);
        if slot.is_zero() {
            row.remove(&column);
        }
    }
}
