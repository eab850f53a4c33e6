//! What drives a law: the moment `M` of `E I y'' = M`, of which it is said before how it goes with the variable.

use crate::algebra::{Expr, Formula, Symbol};
use crate::derivation::Assumed;
use crate::kernel::Standing;

/// What a law is driven by, of which it is said before how it goes with the variable: `M = \frac{w}{2} (L - x)^2` of `E I y'' = M`. What is
/// said last counts.
pub(super) fn driven_by<'a>(
    said: impl Iterator<Item = &'a Assumed>,
    law: &Formula,
    (of, variable): (&Symbol, &Symbol),
) -> Vec<Assumed> {
    let terms = law.terms();
    let drives = |own: &&Assumed| {
        let Some((driver, value)) = own.formula.as_equation() else {
            return false;
        };
        let is_part = |name: &Symbol| {
            let mut terms = terms.iter();
            ![of, variable].contains(&name)
                && !value.mentions(of)
                && !value.mentions(name)
                && terms.any(|term| term.any(&|part| part == driver))
        };
        own.standing == Standing::Identity
            && value.mentions(variable)
            && driving(driver, variable).is_some_and(is_part)
    };
    let mut found: Vec<Assumed> = Vec::new();
    for own in said.filter(drives) {
        let of = own.formula.as_equation().map(|own| own.0);
        let is_same = |other: &&mut Assumed| other.formula.as_equation().map(|own| own.0) == of;
        match found.iter_mut().find(is_same) {
            Some(other) if other.source < own.source => *other = own.clone(),
            Some(_) => {}
            None => found.push(own.clone()),
        }
    }
    found
}

/// What is meant by `M` and by `M(x)`.
fn driving<'e>(term: &'e Expr, variable: &Symbol) -> Option<&'e Symbol> {
    match term {
        Expr::Symbol(name) => Some(name),
        Expr::Apply(name, arguments) if **arguments == [Expr::Symbol(variable.clone())] => {
            Some(name)
        }
        _ => None,
    }
}

/// A law with what it is driven by put in.
pub(super) fn with_drivers_put_in(law: &Formula, drivers: &[Assumed]) -> Formula {
    let given = drivers.iter().filter_map(|own| own.formula.as_equation());
    given.fold(law.clone(), |law, (name, value)| {
        law.map_terms(|term| term.replace(name, value))
    })
}
