//! Relative changes, `\frac{d\rho}{\rho} = \frac{dm}{m} - 2 \frac{dd}{d}`, which show what they are also where `d` is a quantity.

use crate::algebra::{Expr, Relation, Symbol};
use crate::notation::{Clause, Statement};

use super::SIGNS;

/// Reads as differentials what stands over its own quantity, where each term of an equation is a multiple of such a quotient: nobody writes
/// a product with a number `d` so that all it is multiplied by cancels.
pub(super) fn read(statement: &mut Statement) {
    let sign = Symbol::new(SIGNS[0]);
    let [Clause::Chain { sides, links, .. }] = statement.clauses.as_mut_slice() else {
        return;
    };
    let are_equal = links.iter().all(|link| link.relation == Relation::Equal);
    if sides.len() < 2 || !are_equal {
        return;
    }
    let read: Option<Vec<Expr>> = sides.iter().map(|side| of(&side.expr, &sign)).collect();
    for (side, read) in sides.iter_mut().zip(read.into_iter().flatten()) {
        side.expr = read;
    }
}

/// A term with its relative changes read; nothing unless each summand is a multiple of just one.
fn of(term: &Expr, sign: &Symbol) -> Option<Expr> {
    match term {
        Expr::Sum(summands) => {
            let read: Option<Vec<Expr>> = summands.iter().map(|own| of(own, sign)).collect();
            Some(Expr::Sum(read?.into()))
        }
        Expr::Negate(inner) => Some(Expr::Negate(of(inner, sign)?.into())),
        Expr::Product(factors) => {
            let mut read: Vec<Expr> = factors.to_vec();
            let is_one = |own: &Expr| own.mentions(sign);
            let at = read.iter().position(is_one)?;
            read[at] = of(&read[at], sign)?;
            let mut others = read[at + 1..].iter();
            (!others.any(is_one)).then(|| Expr::Product(read.into()))
        }
        Expr::Quotient(over, under) => match (&**over, &**under) {
            (Expr::Product(factors), Expr::Symbol(quantity)) => match &factors[..] {
                [Expr::Symbol(d), Expr::Symbol(own)] if d == sign && own == quantity => {
                    let change = Expr::Symbol(own.clone()).differential();
                    Some(Expr::Quotient(change.into(), under.clone()))
                }
                _ => None,
            },
            _ => None,
        },
        _ => None,
    }
}
