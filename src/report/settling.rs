//! Which dimensions, once declared, settle others.

use crate::kernel::dimension::Form;

/// Of more symbols nobody will read how they hang together, and finding out takes the square of their number.
const MOST: usize = 500;

/// Of dimensions that are not known, those that must be declared so that all are known: the first ones that do, by
/// position. Nothing where there are too many to tell.
///
/// Each is a product of powers of unknown ones, so this is a basis of the space that their exponents span.
pub(super) fn settling(open: &[&Form]) -> Vec<usize> {
    if open.len() > MOST {
        return Vec::new();
    }
    let mut basis: Vec<Form> = Vec::new();
    let mut chosen = Vec::new();
    for (at, form) in open.iter().enumerate() {
        let mut rest = (*form).clone();
        for row in &basis {
            let Some((pivot, _)) = row.unknowns.first_key_value() else {
                continue;
            };
            if let Some(exponent) = rest.unknowns.get(pivot).cloned() {
                rest.multiply(row, &-exponent);
            }
        }
        let Some((_, leading)) = rest.unknowns.first_key_value() else {
            continue;
        };
        let inverse = leading.recip();
        basis.push(rest.power(&inverse));
        chosen.push(at);
    }
    chosen
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::{Dimension, Rational};
    use crate::kernel::dimension::Unknown;

    fn form(powers: &[(usize, i32)]) -> Form {
        let unknowns = powers
            .iter()
            .map(|&(at, n)| (Unknown(at), Rational::from(n)));
        Form {
            known: Dimension::none(),
            unknowns: unknowns.collect(),
        }
    }

    #[test]
    fn what_follows_from_others_is_not_asked_for() {
        // v, a, t with a t = v, and m apart.
        let all = [
            form(&[(0, 1), (1, 1)]),
            form(&[(0, 1)]),
            form(&[(1, 1)]),
            form(&[(2, 3)]),
        ];
        let all: Vec<&Form> = all.iter().collect();
        assert_eq!(settling(&all), [0, 1, 3]);
        assert_eq!(settling(&all[1..]), [0, 1, 2]);
        assert!(settling(&[]).is_empty());
    }
}
