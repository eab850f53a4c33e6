use crate::algebra::{Expr, Rational};
use crate::kernel::{Combination, Size};
use crate::sorted::Map;

/// Exponents of quantities.
pub(super) type Exponents = Map<Expr, Rational>;

/// Rows in reduced echelon form that remember how they were made. The first column in which a row does not
/// vanish is its pivot; columns that are not named come first, by name.
#[derive(Clone, Default)]
pub(super) struct Echelon {
    /// The columns that had better stay free, the best one last.
    late: Vec<Expr>,
    rows: Vec<Reduced>,
}

#[derive(Clone)]
struct Reduced {
    pivot: Expr,
    row: Exponents,
    made_of: Map<usize, Rational>,
    /// What the product of the row comes to, for rows that have a value.
    value: Size,
}

impl Echelon {
    pub fn new(late: Vec<Expr>) -> Echelon {
        Echelon {
            late,
            rows: Vec::new(),
        }
    }

    fn rank(&self, column: &Expr) -> usize {
        let at = self.late.iter().position(|c| c == column);
        at.map_or(0, |at| at + 1)
    }

    /// What is left of exponents, the combination of rows that was taken away, and its value.
    pub fn reduce(&self, row: &Exponents) -> (Exponents, Map<usize, Rational>, Size) {
        let (mut rest, mut made_of, mut value) = (row.clone(), Map::new(), Size::one());
        for own in &self.rows {
            if let Some(factor) = row.get(&own.pivot) {
                add(&mut rest, &own.row, &-factor);
                add(&mut made_of, &own.made_of, factor);
                value = value.times(&own.value, factor);
            }
        }
        (rest, made_of, value)
    }

    /// Adds a row. Returns its value by the rows before it, where it depends on them.
    pub fn insert(&mut self, number: usize, row: &Exponents, value: &Size) -> Option<Size> {
        let (mut rest, made_of, known) = self.reduce(row);
        let Some(pivot) = rest.keys().min_by_key(|c| self.rank(c)).cloned() else {
            return Some(known);
        };
        let scale = rest[&pivot].recip();
        rest.values_mut().for_each(|e| *e = &*e * &scale);
        let mut own = Map::from([(number, Rational::one())]);
        add(&mut own, &made_of, &-Rational::one());
        own.values_mut().for_each(|e| *e = &*e * &scale);
        let value = Size::one().times(&value.over(&known), &scale);
        for other in &mut self.rows {
            if let Some(factor) = other.row.get(&pivot).cloned() {
                add(&mut other.row, &rest, &-&factor);
                add(&mut other.made_of, &own, &-&factor);
                other.value = other.value.times(&value, &-&factor);
            }
        }
        self.rows.push(Reduced {
            pivot,
            row: rest,
            made_of: own,
            value,
        });
        None
    }

    /// The combination of rows that exponents are, if they are one.
    pub fn combination(&self, row: &Exponents) -> Option<Combination> {
        let (rest, made_of, _) = self.reduce(row);
        rest.is_empty().then(|| made_of.into_iter().collect())
    }

    pub fn is_pivot(&self, column: &Expr) -> bool {
        self.rows.iter().any(|row| row.pivot == *column)
    }

    /// The rescaling in which a free column grows by one factor and all other free ones stay.
    pub fn rescaling(&self, free: &Expr) -> Exponents {
        let mut rescaling = Exponents::from([(free.clone(), Rational::one())]);
        for row in &self.rows {
            if let Some(slope) = row.row.get(free) {
                rescaling.insert(row.pivot.clone(), -slope);
            }
        }
        rescaling
    }

    /// The value of each pivot for given values of the free columns.
    pub fn solve(&self, free: &Map<Expr, Size>) -> Map<Expr, Size> {
        let mut values = free.clone();
        for row in &self.rows {
            let mut value = row.value.clone();
            for (column, slope) in row.row.iter().filter(|(c, _)| **c != row.pivot) {
                if let Some(size) = free.get(column) {
                    value = value.times(size, &-slope);
                }
            }
            values.insert(row.pivot.clone(), value);
        }
        values
    }
}

/// `to += factor · what`, without zeros.
fn add<K: Ord + Clone>(to: &mut Map<K, Rational>, what: &Map<K, Rational>, factor: &Rational) {
    for (key, value) in what {
        let slot = to.entry(key.clone()).or_insert_with(Rational::zero);
        *slot += value * factor;
    }
    to.retain(|_, value| !value.is_zero());
}

/// `Σ a_s b_s`.
pub(super) fn pairing(a: &Exponents, b: &Exponents) -> Rational {
    let mut sum = Rational::zero();
    for (key, value) in a {
        if let Some(other) = b.get(key) {
            sum += value * other;
        }
    }
    sum
}
