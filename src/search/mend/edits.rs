//! The slips of the pen that may have been made: every formula that is one small edit away from a printed one.

use crate::algebra::{BigRational, Expr, Formula, Rational, Relation, Symbol};

use super::super::implied::{number, own_number, scaled};

/// Formulas with more parts than this are not edited: a reader could not see one slip in them either.
const MOST_PARTS: usize = 80;
/// No more formulas than this are made of one.
const MOST_EDITS: usize = 400;
/// What a coefficient may be off by, the likeliest first.
const FACTORS: [(i64, i64); 20] = [
    (1, 2),
    (2, 1),
    (1, 4),
    (4, 1),
    (1, 3),
    (3, 1),
    (2, 3),
    (3, 2),
    (3, 4),
    (4, 3),
    (1, 8),
    (8, 1),
    (1, 6),
    (6, 1),
    (1, 5),
    (5, 1),
    (2, 5),
    (5, 2),
    (3, 5),
    (5, 3),
];

/// What kind of slip it would have been.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Change {
    /// A plus for a minus, or the other way round.
    Sign,
    /// A number, or one that is missing.
    Coefficient,
    /// An exponent, or one that is missing.
    Exponent,
    /// One symbol for another.
    Symbol {
        /// As printed.
        printed: Symbol,
        /// As it should be.
        meant: Symbol,
    },
    /// A fraction upside down.
    Inverted,
    /// `≤` for `≥`.
    Relation,
}

/// A formula one edit away.
#[derive(Clone, Debug)]
pub struct Edit {
    /// What was changed.
    pub change: Change,
    /// The formula as it would read.
    pub formula: Formula,
    /// The likelier a slip, the less.
    pub cost: u32,
    /// Whether the left side is as printed.
    pub left_kept: bool,
    /// Whether the right side is.
    pub right_kept: bool,
}

/// All formulas one edit away from a printed one, the likeliest slip first. `names` are what a symbol may have been
/// mistaken for.
pub fn edits(printed: &Formula, names: &[Symbol]) -> Vec<Edit> {
    let Formula::Relation {
        left,
        relation,
        right,
    } = printed
    else {
        return Vec::new();
    };
    if parts(left) + parts(right) > MOST_PARTS {
        return Vec::new();
    }
    let rebuilt = |left: &Expr, relation: Relation, right: &Expr| Formula::Relation {
        left: left.clone(),
        relation,
        right: right.clone(),
    };
    let mut all = Vec::new();
    let mut editor = Editor {
        names,
        found: Vec::new(),
    };
    for is_left in [false, true] {
        let side = if is_left { left } else { right };
        editor.whole(side);
        for (change, cost, term) in editor.found.drain(..) {
            let formula = match is_left {
                true => rebuilt(&term, *relation, right),
                false => rebuilt(left, *relation, &term),
            };
            // What an equation is solved for is less often wrong than what it says of it.
            let solved = matches!((is_left, left), (true, Expr::Symbol(_)));
            let cost = 4 * cost + u32::from(is_left) + 8 * u32::from(solved);
            all.push(Edit {
                change,
                formula,
                cost,
                left_kept: !is_left,
                right_kept: is_left,
            });
        }
    }
    let turned = match relation {
        Relation::Less => Some(Relation::Greater),
        Relation::Greater => Some(Relation::Less),
        Relation::LessOrEqual => Some(Relation::GreaterOrEqual),
        Relation::GreaterOrEqual => Some(Relation::LessOrEqual),
        _ => None,
    };
    all.extend(turned.map(|turned| Edit {
        change: Change::Relation,
        formula: rebuilt(left, turned, right),
        cost: 4,
        left_kept: true,
        right_kept: true,
    }));
    let same = |edit: &Edit| match &edit.formula {
        Formula::Relation { left, right, .. } => left == right,
        Formula::AllEqual { .. } => false,
    };
    all.retain(|edit| !same(edit));
    all.sort_by_key(|edit| edit.cost);
    all.truncate(MOST_EDITS);
    all
}

fn parts(term: &Expr) -> usize {
    1 + term.children().into_iter().map(parts).sum::<usize>()
}

type Found = Vec<(Change, u32, Expr)>;

struct Editor<'a> {
    names: &'a [Symbol],
    found: Found,
}

impl Editor<'_> {
    /// A side, a summand, or the argument of a function: what may have a sign and a coefficient.
    fn whole(&mut self, term: &Expr) {
        if !matches!(term, Expr::Sum(_)) {
            self.factors(term);
        }
        match term {
            Expr::Negate(inner) => self.found.push((Change::Sign, 1, (**inner).clone())),
            Expr::Number(value) if *value == BigRational::from_integer(0.into()) => {}
            term => self
                .found
                .push((Change::Sign, 1, Expr::Negate(term.clone().into()))),
        }
        self.within(term);
    }

    fn factors(&mut self, term: &Expr) {
        if let Expr::Number(value) = term {
            let one = BigRational::from_integer(1.into());
            for other in [value + &one, value - &one] {
                self.found
                    .push((Change::Coefficient, 2, number(&Rational::from(&other))));
            }
        }
        let (term, negative) = match term {
            Expr::Negate(inner) => (&**inner, true),
            term => (term, false),
        };
        for (at, (above, below)) in FACTORS.into_iter().enumerate() {
            let factor = BigRational::new(above.into(), below.into());
            let other = scaled(term, &Rational::from(&factor));
            let other = match negative {
                true => Expr::Negate(other.into()),
                false => other,
            };
            let cost = 2 + u32::from(at >= 6) + u32::from(at >= 12);
            self.found.push((Change::Coefficient, cost, other));
        }
    }

    /// What may be wrong in the parts of a term.
    fn within(&mut self, term: &Expr) {
        match term {
            Expr::Symbol(symbol) => {
                for name in self.names.iter().filter(|name| *name != symbol) {
                    let change = Change::Symbol {
                        printed: symbol.clone(),
                        meant: name.clone(),
                    };
                    let cost = match alike(symbol, name) {
                        true => 2,
                        false => 4,
                    };
                    self.found.push((change, cost, Expr::Symbol(name.clone())));
                }
                let squared = Expr::Power(term.clone().into(), Expr::integer(2).into());
                self.found.push((Change::Exponent, 3, squared));
            }
            Expr::Power(base, exponent) => {
                self.exponents(base, exponent);
                self.inside(term, 0, |editor, base| match base {
                    // A symbol that has an exponent is not given another.
                    Expr::Symbol(_) => {
                        let before = editor.found.len();
                        editor.within(base);
                        let swapped = |f: &(Change, u32, Expr)| f.0 != Change::Exponent;
                        let own: Found = editor.found.drain(before..).filter(swapped).collect();
                        editor.found.extend(own);
                    }
                    base => editor.within(base),
                });
            }
            Expr::Quotient(above, below) if own_number(term).is_none() => {
                let inverted = Expr::Quotient(below.clone(), above.clone());
                self.found.push((Change::Inverted, 3, inverted));
                self.inside(term, 0, Editor::within);
                self.inside(term, 1, Editor::within);
            }
            Expr::Sum(items) => {
                for at in 0..items.len() {
                    self.inside(term, at, Editor::whole);
                }
            }
            Expr::Call(..) => self.inside(term, 0, Editor::whole),
            Expr::Product(_) | Expr::Negate(_) => {
                for at in 0..term.children().len() {
                    self.inside(term, at, Editor::within);
                }
            }
            _ => {}
        }
    }

    fn exponents(&mut self, base: &Expr, exponent: &Expr) {
        let Some(printed) = own_number(exponent) else {
            return;
        };
        let whole = |value: i64| Rational::from(&BigRational::from_integer(value.into()));
        let (one, two) = (whole(1), whole(2));
        let half = &one / &two;
        let others = [
            &printed + &one,
            &printed - &one,
            -&printed,
            &printed * &two,
            &printed * &half,
            &printed + &half,
            &printed - &half,
        ];
        for (at, other) in others.into_iter().enumerate() {
            if other == printed || other == whole(0) {
                continue;
            }
            let term = match other == one {
                true => base.clone(),
                false => Expr::Power(base.clone().into(), number(&other).into()),
            };
            self.found
                .push((Change::Exponent, 2 + u32::from(at > 2), term));
        }
    }

    /// Edits the child at a position, the rest left as it is.
    fn inside(&mut self, term: &Expr, position: usize, edit: impl FnOnce(&mut Self, &Expr)) {
        let children = term.children();
        let Some(child) = children.get(position) else {
            return;
        };
        let before = self.found.len();
        edit(self, child);
        for (_, _, found) in &mut self.found[before..] {
            let mut at = 0;
            *found = term.map_children(|own| {
                at += 1;
                match at == position + 1 {
                    true => found.clone(),
                    false => own.clone(),
                }
            });
        }
    }
}

/// Whether two names differ in primes or in an index alone.
fn alike(one: &Symbol, other: &Symbol) -> bool {
    let letters = |symbol: &Symbol| -> String {
        let name = symbol.name().replace('\'', "");
        name.split('_').next().unwrap_or_default().to_owned()
    };
    letters(one) == letters(other)
}
