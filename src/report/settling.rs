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
