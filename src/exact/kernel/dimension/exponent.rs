use crate::algebra::{Expr, Rational};
use crate::sorted::Map;

/// A number plus multiples of terms that are no numbers: `2γ − 1`.
pub(super) type Linear<'a> = (Rational, Map<&'a Expr, Rational>);

/// Takes an exponent apart; each term is looked at once.
pub(super) fn linear(term: &Expr) -> Linear<'_> {
    let opaque = || (Rational::zero(), Map::from([(term, Rational::one())]));
    match term {
        Expr::Number(value) => (Rational::from(value), Map::new()),
        Expr::Negate(inner) => scaled(linear(inner), &-Rational::one()),
        Expr::Sum(items) => items
            .iter()
            .map(linear)
            .fold((Rational::zero(), Map::new()), plus),
        Expr::Quotient(over, under) => match linear(under) {
            (divisor, others) if others.is_empty() && !divisor.is_zero() => {
                scaled(linear(over), &divisor.recip())
            }
            _ => opaque(),
        },
        Expr::Product(items) => {
            let (numbers, mut others): (Vec<Linear<'_>>, Vec<Linear<'_>>) = items
                .iter()
                .map(linear)
                .partition(|(_, others)| others.is_empty());
            let number = numbers
                .iter()
                .fold(Rational::one(), |product, (n, _)| product * n);
            match (others.pop(), others.is_empty()) {
                (None, _) => (number, Map::new()),
                (Some(only), true) => scaled(only, &number),
                // The numbers in it stay in the opaque term.
                (Some(_), false) => opaque(),
            }
        }
        _ => opaque(),
    }
}

fn scaled<'a>((number, mut others): Linear<'a>, factor: &Rational) -> Linear<'a> {
    others.values_mut().for_each(|own| *own *= factor);
    others.retain(|_, own| !own.is_zero());
    (number * factor, others)
}

fn plus<'a>((number, mut sum): Linear<'a>, (other, terms): Linear<'a>) -> Linear<'a> {
    for (term, factor) in terms {
        *sum.entry(term).or_insert_with(Rational::zero) += factor;
    }
    sum.retain(|_, own| !own.is_zero());
    (number + other, sum)
}
