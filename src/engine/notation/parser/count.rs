//! Factorials of numerals and binomial coefficients: numbers, and polynomials in what is above.

use super::vector::refuse_vector;
use super::{Kind, Parser, Read, refuse_with};
use crate::algebra::{BigInt, Expr};

/// The greatest number of which the factorial is taken.
const GREATEST: u32 = 100;
/// The greatest number below in a binomial coefficient: it is written out with so many factors.
const FACTORS: u32 = 12;
/// The largest term above, in parts; each factor holds it once.
const PARTS: usize = 20;

impl Parser<'_> {
    /// `3!`, after the numeral. `n!` is no polynomial, and `3!!` something else.
    pub(super) fn factorial(&mut self, start: usize, number: Expr) -> Read<Expr> {
        self.advance();
        let span = self.since(start);
        if self.peek() == Kind::Char('!') {
            let message = "double factorials are not read";
            return refuse_with(self.span(), message, "write the product");
        }
        match whole(&number).filter(|n| *n <= GREATEST) {
            Some(n) => Ok(Expr::integer(factorial(n))),
            None => {
                let message = format!("factorials are read of whole numbers up to {GREATEST}");
                refuse_with(span, message, "give the number a name")
            }
        }
    }

    /// `\binom{n}{k}` with a numeral below is the polynomial `n (n - 1) … / k!`.
    pub(super) fn binomial(&mut self) -> Read<Expr> {
        let start = self.at;
        self.advance();
        let above = self.argument("\\binom")?;
        let message = "binomial coefficients of vectors are not read";
        refuse_vector(&above, self.since(start), message)?;
        let from = self.at;
        let below = self.argument("\\binom")?;
        let Some(below) = whole(&below).filter(|below| *below <= FACTORS) else {
            let message = format!(
                "binomial coefficients are read only with a whole number up to {FACTORS} below"
            );
            let help = "write it out: `\\binom{n}{2}` is `\\frac{n (n - 1)}{2}`";
            return refuse_with(self.since(from), message, help);
        };
        if parts(&above) > PARTS {
            let message = "what stands above in this binomial coefficient is too long";
            return refuse_with(self.since(start), message, "give it a name");
        }
        Ok(written_out(&above, below))
    }
}

/// `above (above - 1) … / below!`
fn written_out(above: &Expr, below: u32) -> Expr {
    let factor = |less: u32| match less {
        0 => above.clone(),
        less => Expr::Sum([above.clone(), Expr::Negate(Expr::integer(less).into())].into()),
    };
    match below {
        0 => Expr::integer(1),
        1 => above.clone(),
        _ => Expr::Quotient(
            Expr::Product((0..below).map(factor).collect()).into(),
            Expr::integer(factorial(below)).into(),
        ),
    }
}

fn whole(expr: &Expr) -> Option<u32> {
    match expr {
        Expr::Number(n) if n.is_integer() => u32::try_from(n.to_integer()).ok(),
        _ => None,
    }
}

fn factorial(n: u32) -> BigInt {
    (1..=n).map(BigInt::from).product()
}

/// How many numbers, names and signs a term is made of.
fn parts(expr: &Expr) -> usize {
    1 + expr.children().map(parts).sum::<usize>()
}
