//! Where it is known that there are no rational points at all.

use super::univariate;
use crate::algebra::{Expr, Polynomial, expr_of};
use crate::kernel::{Claim, Fact, Obligation, Sign};
use crate::search::refute::negation;
use crate::search::values::rational_roots;

/// An equation `term = 0` in one unknown that every counterexample to a claim satisfies and no rational number does.
///
/// Nothing where there may be a rational point, or where that is not seen: equations in one unknown alone are looked
/// at, with what other equations say plainly put in.
pub fn without_rational_points(claim: &Claim, unfold: &[usize]) -> Option<Expr> {
    let obligation = Obligation::new(claim.clone(), unfold.to_vec()).ok()?;
    let problem = obligation.as_written();
    let against = negation(&problem.goal);
    let facts = problem.facts.iter().chain([&against]);
    let mut equations: Vec<Polynomial> = facts
        .filter(|f: &&Fact| f.sign == Sign::Zero)
        .map(|f| f.polynomial.clone())
        .collect();
    // Each number that is put in settles an unknown.
    loop {
        let mut settled = None;
        for equation in &equations {
            let [var] = equation.vars()[..] else {
                continue;
            };
            let own = univariate(equation, var)?;
            match own.coefficients() {
                [c, a] => settled = Some((var, Polynomial::constant(-c / a))),
                _ if rational_roots(equation, var).is_some_and(|roots| roots.is_empty()) => {
                    return Some(expr_of(&equation.monic(), &problem.atoms));
                }
                _ => {}
            }
        }
        let (var, value) = settled?;
        for equation in &mut equations {
            *equation = equation.substitute(var, &value).ok()?;
        }
    }
}
