//! Rarer slips of the pen, of which there are many: worth a look only where it is cheap to see which of them would be right.

use crate::algebra::{BigRational, Expr, Formula, Function, Rational, Symbol, product_of};
use num_traits::One;

use super::super::implied::{number, own_number};
use super::edits::{Change, Edit, parts};
use crate::sorted::Set;

/// Formulas with more parts than this are not edited so.
const MOST_PARTS: usize = 60;
/// No more formulas than this are made of one.
const MOST_EDITS: usize = 300;
/// So unlikely is any of them, beside [`super::edits::edits`].
const COST: u32 = 30;

/// All equations one rarer edit away from a printed one, in the order of where they differ.
pub fn rarer_edits(printed: &Formula) -> Vec<Edit> {
    let Some((left, right)) = printed.as_equation() else {
        return Vec::new();
    };
    if parts(left) + parts(right) > MOST_PARTS {
        return Vec::new();
    }
    let mut symbols = printed.free_symbols();
    symbols.retain(|own| !own.is_unit() && own.name() != "\\pi");
    let writer = Writer {
        symbols,
        takes_roots: [left, right].iter().any(|side| side.any(&Expr::is_root)),
    };
    let mut all = Vec::new();
    for is_left in [false, true] {
        let side = if is_left { left } else { right };
        let mut found = Vec::new();
        writer.everywhere(side, &mut |change, term| found.push((change, term)));
        writer.throughout(side, &mut |change, term| found.push((change, term)));
        all.extend(found.into_iter().map(|(change, term)| {
            let formula = match is_left {
                true => Formula::equal(term, right.clone()),
                false => Formula::equal(left.clone(), term),
            };
            Edit {
                change,
                formula,
                cost: COST + u32::from(is_left),
                left_kept: !is_left,
                right_kept: is_left,
            }
        }));
    }
    all.truncate(MOST_EDITS);
    all
}

struct Writer {
    symbols: Set<Symbol>,
    takes_roots: bool,
}

impl Writer {
    /// What a term may have been, one part of it edited.
    fn everywhere(&self, term: &Expr, found: &mut dyn FnMut(Change, Expr)) {
        self.here(term, found);
        for (at, child) in term.children().enumerate() {
            self.everywhere(child, &mut |change, edited| {
                found(change, with_child(term, at, edited));
            });
        }
    }

    /// What a term may have been where a symbol stands in it more than once, and everywhere without its square, or with one that it has not:
    /// `\frac{1 + e}{1 - e}` for `\frac{1 + e^2}{1 - e^2}`.
    fn throughout(&self, term: &Expr, found: &mut dyn FnMut(Change, Expr)) {
        for own in self.symbols.iter().cloned().map(Expr::Symbol) {
            if occurrences(term, &own) < 2 {
                continue;
            }
            let square = Expr::Power(own.clone().into(), Expr::integer(2).into());
            match occurrences(term, &square) {
                0 => found(Change::Exponent, term.replace(&own, &square)),
                1 => {}
                _ => found(Change::Exponent, term.replace(&square, &own)),
            }
        }
    }

    /// What a term as a whole may have been.
    fn here(&self, term: &Expr, found: &mut dyn FnMut(Change, Expr)) {
        match term {
            // `1 - e^{-t/τ}` for `e^{-t/τ}`.
            Expr::Sum(items) => {
                if let [one, Expr::Negate(rest)] = &items[..]
                    && own_number(one).is_some_and(|own| own.is_one())
                {
                    found(Change::Summand, (**rest).clone());
                }
            }
            Expr::Quotient(above, below) => {
                self.across(above, below, found);
                for (at, part) in [above, below].into_iter().enumerate() {
                    self.short_of_a_summand(part, &mut |edited| {
                        found(Change::Summand, with_child(term, at, edited));
                    });
                }
                if own_number(term).is_none() {
                    found(Change::Exponent, root(term.clone()));
                }
            }
            // `σ/N` for `σ/\sqrt N`: where there is a root, that is no rare slip.
            Expr::Symbol(own) if !self.takes_roots && !own.is_unit() => {
                found(Change::Exponent, root(term.clone()));
            }
            // `L/(3 g)` for `L/(\sqrt3 g)`.
            Expr::Number(value) if self.takes_roots && *value > BigRational::one() => {
                found(Change::Exponent, root(term.clone()));
            }
            Expr::Power(base, exponent) => {
                let with = |exponent: Expr| Expr::Power(base.clone(), exponent.into());
                match &**exponent {
                    Expr::Sum(items) => {
                        let turned = items.iter().map(|own| match own {
                            Expr::Negate(own) => (**own).clone(),
                            own => Expr::Negate(own.clone().into()),
                        });
                        found(Change::Sign, with(Expr::Sum(turned.collect())));
                    }
                    own if own_number(own).is_none() => {
                        for one in [Expr::integer(1), Expr::integer(-1)] {
                            found(Change::Exponent, with(Expr::Sum([own.clone(), one].into())));
                        }
                    }
                    _ => {}
                }
            }
            Expr::Call(function, argument) => {
                let others: &[Function] = match function {
                    Function::Sin | Function::Cos => &[Function::Tan],
                    Function::Tan => &[Function::Sin, Function::Cos],
                    _ => &[],
                };
                for other in others {
                    found(Change::Function, Expr::Call(*other, argument.clone()));
                }
                if *function == Function::Tan {
                    let turned = Expr::Quotient(Expr::integer(1).into(), term.clone().into());
                    found(Change::Inverted, turned);
                }
            }
            _ => {}
        }
    }

    /// A factor on the other side of the line: `\frac{R}{s}` for `\frac{1}{R s}`, or `\frac{h R}{k}` for `\frac{h}{k R}`.
    fn across(&self, above: &Expr, below: &Expr, found: &mut dyn FnMut(Change, Expr)) {
        let factors = |own: &Expr| match own {
            Expr::Product(factors) => factors.to_vec(),
            own => vec![own.clone()],
        };
        let (above, below) = (factors(above), factors(below));
        let is_letter = |own: &Expr| own_number(own).is_none();
        let mut quotient = |above: Vec<Expr>, below: Vec<Expr>| {
            let term = match below.is_empty() {
                true => product_of(above),
                false => Expr::Quotient(product_of(above).into(), product_of(below).into()),
            };
            found(Change::Inverted, term);
        };
        for at in (0..above.len()).filter(|&at| is_letter(&above[at])) {
            let (mut above, mut below) = (above.clone(), below.clone());
            below.insert(0, above.remove(at));
            quotient(above, below);
        }
        // `\frac{H r}{K}` for `\frac{H K}{r}`.
        if above.len() > 1 || below.len() > 1 {
            for up in (0..above.len()).filter(|&at| is_letter(&above[at])) {
                for down in (0..below.len()).filter(|&at| is_letter(&below[at])) {
                    let (mut above, mut below) = (above.clone(), below.clone());
                    std::mem::swap(&mut above[up], &mut below[down]);
                    quotient(above, below);
                }
            }
        }
        if below.len() > 1 {
            for at in (0..below.len()).filter(|&at| is_letter(&below[at])) {
                let (mut above, mut below) = (above.clone(), below.clone());
                above.push(below.remove(at));
                quotient(above, below);
            }
        }
    }

    /// A numerator or denominator that has lost a summand: `\frac{1}{1 - e}` for `\frac{1 + e}{1 - e}`.
    fn short_of_a_summand(&self, term: &Expr, found: &mut dyn FnMut(Expr)) {
        if !matches!(term, Expr::Symbol(_)) && !own_number(term).is_some_and(|own| own.is_one()) {
            return;
        }
        for own in self.symbols.iter().cloned().map(Expr::Symbol) {
            if own == *term {
                continue;
            }
            for own in [own.clone(), Expr::Negate(own.into())] {
                found(Expr::Sum([term.clone(), own].into()));
            }
        }
    }
}

/// How often a part stands in a term.
fn occurrences(term: &Expr, part: &Expr) -> usize {
    match term == part {
        true => 1,
        false => term.children().map(|own| occurrences(own, part)).sum(),
    }
}

/// A term with another one in the place of one of its children.
fn with_child(term: &Expr, position: usize, other: Expr) -> Expr {
    let (mut at, mut other) = (0, Some(other));
    term.map_children(|own| {
        at += 1;
        match at == position + 1 {
            true => other.take().unwrap_or_else(|| own.clone()),
            false => own.clone(),
        }
    })
}

fn root(term: Expr) -> Expr {
    Expr::Power(term.into(), number(&Rational::from(2).recip()).into())
}
