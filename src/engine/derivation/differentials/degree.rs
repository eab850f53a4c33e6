//! How many differentials each term has as factors: only where that is one and the same number do they mean rates.

use num_traits::Zero;

use crate::algebra::Expr;

/// Of nought it is any number.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Degree {
    Any,
    Of(i32),
}

/// Whether an equation may be read along a change: each term has one differential as a factor, as in `dU = T\,dS - p\,dV`, or as many above a
/// stroke as below, `F = \frac{m\,dv}{dt}`.
pub(super) fn is_understood<'a>(sides: impl Iterator<Item = &'a Expr>) -> bool {
    common(sides).is_some_and(|own| matches!(own, Degree::Any | Degree::Of(0 | 1)))
}

fn common<'a>(mut terms: impl Iterator<Item = &'a Expr>) -> Option<Degree> {
    terms.try_fold(Degree::Any, |all, term| match (all, degree(term)?) {
        (Degree::Any, own) | (own, Degree::Any) => Some(own),
        (all, own) => (all == own).then_some(own),
    })
}

/// How many differentials a term has as factors, if each of its terms has as many and no power or function is taken of any.
fn degree(term: &Expr) -> Option<Degree> {
    if let Some(of) = term.as_differential() {
        let is_second = of.any(&|part| part.as_differential().is_some());
        return (!is_second).then_some(Degree::Of(1));
    }
    match term {
        Expr::Number(number) if number.is_zero() => Some(Degree::Any),
        Expr::Sum(terms) => common(terms.iter()),
        Expr::Negate(inner) => degree(inner),
        Expr::Product(factors) => {
            factors
                .iter()
                .try_fold(Degree::Of(0), |all, factor| match (all, degree(factor)?) {
                    (Degree::Of(all), Degree::Of(own)) => Some(Degree::Of(all + own)),
                    _ => Some(Degree::Any),
                })
        }
        Expr::Quotient(over, under) => match (degree(over)?, degree(under)?) {
            (Degree::Of(over), Degree::Of(under)) => Some(Degree::Of(over - under)),
            (Degree::Any, Degree::Of(_)) => Some(Degree::Any),
            (_, Degree::Any) => None,
        },
        term => {
            let is_free = |part: &Expr| matches!(degree(part), Some(Degree::Any | Degree::Of(0)));
            term.children().all(is_free).then_some(Degree::Of(0))
        }
    }
}
