//! What cannot be so together: "$x > 0$" and then "$x < 0$" are two cases.

use crate::algebra::{Atoms, Formula, Lowering, Polynomial, Rational, Relation};

/// Whether no numbers make both relations true, as far as their sides show: both bound the same term, up to a number.
pub(in crate::derivation) fn exclude_each_other(one: &Formula, other: &Formula) -> bool {
    if one.names() != other.names() {
        return false;
    }
    let mut atoms = Atoms::default();
    let ranges = (Bounds::of(one, &mut atoms)).zip(Bounds::of(other, &mut atoms));
    ranges.is_some_and(|(one, other)| one.term == other.term && one.is_disjoint(&other))
}

/// An end of a range, and whether it belongs to it.
type End = Option<(Rational, bool)>;

/// What a relation says of a term: where it lies, or where it does not.
struct Bounds {
    /// The leading coefficient is 1, and no number is added.
    term: Polynomial,
    least: End,
    greatest: End,
    not: Option<Rational>,
}

impl Bounds {
    fn of(formula: &Formula, atoms: &mut Atoms) -> Option<Bounds> {
        let Formula::Relation {
            left,
            relation,
            right,
        } = formula
        else {
            return None;
        };
        let mut lowering = Lowering::plain(atoms);
        let difference = lowering.lower(left).ok()?;
        let difference = difference.minus(&lowering.lower(right).ok()?).ok()?;
        let difference = difference.as_polynomial()?;
        let (_, leading) = difference.leading()?;
        let leading = leading.clone();
        let monic = difference.monic();
        let number = match monic.terms().find(|(monomial, _)| monomial.is_one()) {
            Some((_, number)) => number.clone(),
            None => Rational::zero(),
        };
        let term = monic.minus(&Polynomial::constant(number.clone()));
        let at = -number;
        let (mut least, mut greatest, mut not) = (None, None, None);
        let rises = !leading.is_negative();
        match relation {
            Relation::Equal => (least, greatest) = (Some((at.clone(), true)), Some((at, true))),
            Relation::NotEqual => not = Some(at),
            Relation::Less
            | Relation::LessOrEqual
            | Relation::Greater
            | Relation::GreaterOrEqual => {
                let closed = matches!(relation, Relation::LessOrEqual | Relation::GreaterOrEqual);
                let above = matches!(relation, Relation::Greater | Relation::GreaterOrEqual);
                match above == rises {
                    true => least = Some((at, closed)),
                    false => greatest = Some((at, closed)),
                }
            }
            _ => return None,
        }
        Some(Bounds {
            term,
            least,
            greatest,
            not,
        })
    }

    fn is_disjoint(&self, other: &Bounds) -> bool {
        let is_below = |greatest: &End, least: &End| match (greatest, least) {
            (Some((greatest, own)), Some((least, other))) => {
                greatest < least || greatest == least && !(*own && *other)
            }
            _ => false,
        };
        let is_denied = |one: &Bounds, other: &Bounds| {
            one.not.is_some()
                && other.least == other.greatest
                && other.least.as_ref().map(|(at, _)| at) == one.not.as_ref()
        };
        is_below(&self.greatest, &other.least)
            || is_below(&other.greatest, &self.least)
            || is_denied(self, other)
            || is_denied(other, self)
    }
}
