//! Complex numbers with figures put in: `-a + j \sqrt{b} = -0.40 + 0.30j`, weighed a part at a time.

use std::collections::BTreeSet;

use num_traits::ToPrimitive;

use crate::algebra::{Expr, Formula, Function, Relation, Symbol, product_of};
use crate::derivation::{Goal, is_imaginary_unit};
use crate::interval::{Figures, Interval};

use super::{Known, Weighed, decimals, weigh};

/// No greater power of what is complex is written out.
const GREATEST_POWER: u32 = 4;

/// The imaginary unit in a formula, where what `complex` are may be complex and nothing but it is.
fn unit_in(formula: &Formula, complex: &BTreeSet<Symbol>) -> Option<Symbol> {
    let names = formula.names();
    let mut units = names.into_iter().filter(|own| complex.contains(own));
    let unit = units.next()?;
    (is_imaginary_unit(&unit) && units.next().is_none()).then_some(unit)
}

/// Whether a goal ends in a complex number, `-0.40 + 0.30j`, with nothing on its left side that is not known to be one.
pub(super) fn ends_in_one(goal: &Goal, complex: &BTreeSet<Symbol>) -> bool {
    let Some((_, right)) = goal.formula.as_equation() else {
        return false;
    };
    let is_figure = |own: &Symbol| own.is_unit() || is_imaginary_unit(own);
    goal.suppositions.is_empty()
        && !goal.questioned
        && unit_in(&goal.formula, complex).is_some_and(|unit| right.mentions(&unit))
        && right.free_symbols().iter().all(is_figure)
}

impl Known<'_> {
    /// Weighs an equation between complex numbers; nothing of other goals.
    pub(super) fn weigh_complex(&mut self, goal: &Goal) -> Option<Weighed> {
        let page = &self.derivation.pages[self.pages[0]];
        let unit = unit_in(&goal.formula, &page.complex)?;
        let Formula::Relation {
            left,
            relation: Relation::Equal | Relation::Approximately,
            right,
        } = &goal.formula
        else {
            return Some(Weighed::NoComparison);
        };
        let written = page.document.source.get(goal.sides.1.range())?;
        self.unit = Some(unit.clone());
        let sides = self
            .in_data(left, &mut Vec::new())
            .and_then(|left| Ok((left, self.in_data(right, &mut Vec::new())?)));
        self.unit = None;
        let (left, right) = match sides {
            Ok(sides) => sides,
            Err(error) => return Some(Weighed::NoValue(error)),
        };
        let mut figures: Vec<(Symbol, Interval)> = self.intervals().collect();
        let right = decimals::loosened(&right, &decimals::decimals(written, 1), &mut figures)?;
        let (one, other) = (parts(&left, &unit)?, parts(&right, &unit)?);
        let figures = Figures::from_iter(figures);
        let mut outcomes = [(one.0, other.0), (one.1, other.1)].map(|(one, other)| {
            match figures.compared(&one, &other) {
                Ok(found) => weigh(Relation::Equal, &found.difference, None, None),
                Err(error) => Weighed::NoValue(error),
            }
        });
        outcomes.sort_by_key(|own| match own {
            Weighed::Contradicted => 0,
            Weighed::Supported => 2,
            _ => 1,
        });
        let [worst, _] = outcomes;
        Some(worst)
    }
}

/// The real and the imaginary part of a term in which nothing but the unit is complex.
fn parts(term: &Expr, unit: &Symbol) -> Option<(Expr, Expr)> {
    let zero = || Expr::integer(0);
    if !term.mentions(unit) {
        return Some((term.clone(), zero()));
    }
    let negative = |own: Expr| Expr::Negate(own.into());
    Some(match term {
        Expr::Symbol(_) => (zero(), Expr::integer(1)),
        Expr::Negate(inner) => {
            let (real, imaginary) = parts(inner, unit)?;
            (negative(real), negative(imaginary))
        }
        Expr::Sum(terms) => {
            let all: Option<Vec<_>> = terms.iter().map(|own| parts(own, unit)).collect();
            let (real, imaginary): (Vec<_>, Vec<_>) = all?.into_iter().unzip();
            (Expr::Sum(real.into()), Expr::Sum(imaginary.into()))
        }
        Expr::Product(factors) => {
            let mut product = (Expr::integer(1), zero());
            for factor in factors.iter() {
                product = times(&product, &parts(factor, unit)?);
            }
            product
        }
        Expr::Quotient(over, under) => {
            let (over, (real, imaginary)) = (parts(over, unit)?, parts(under, unit)?);
            let squares = [&real, &imaginary].map(|own| product_of(vec![own.clone(), own.clone()]));
            let size = Expr::Sum(squares.into());
            let (above, beside) = times(&over, &(real, negative(imaginary)));
            let by_size = |own: Expr| Expr::Quotient(own.into(), size.clone().into());
            (by_size(above), by_size(beside))
        }
        Expr::Power(base, exponent) => {
            let Expr::Number(exponent) = &**exponent else {
                return None;
            };
            let power = exponent
                .is_integer()
                .then(|| exponent.to_integer().to_u32())??;
            let base = (power <= GREATEST_POWER).then(|| parts(base, unit))??;
            (1..power).fold(base.clone(), |product, _| times(&product, &base))
        }
        Expr::Call(Function::Exp, of) => {
            let (real, imaginary) = parts(of, unit)?;
            let call = |function, of: &Expr| Expr::Call(function, of.clone().into());
            let size = call(Function::Exp, &real);
            let part = |function| product_of(vec![size.clone(), call(function, &imaginary)]);
            (part(Function::Cos), part(Function::Sin))
        }
        _ => return None,
    })
}

/// The product of two complex numbers.
fn times(one: &(Expr, Expr), other: &(Expr, Expr)) -> (Expr, Expr) {
    let both = |a: &Expr, b: &Expr| product_of(vec![a.clone(), b.clone()]);
    let crossed = Expr::Negate(both(&one.1, &other.1).into());
    let real = Expr::Sum([both(&one.0, &other.0), crossed].into());
    let imaginary = Expr::Sum([both(&one.0, &other.1), both(&one.1, &other.0)].into());
    (real, imaginary)
}
