//! The slips of the pen that may have been made: every formula that is one small edit away from a printed one.

use crate::algebra::{
    BigRational, Expr, Formula, Function, Rational, Relation, Symbol, product_of,
};

use super::super::implied::{coefficient, number, own_number, scaled};
use crate::sorted::{self, Set};

/// Formulas with more parts than this are not edited: a reader could not see one slip in them either.
const MOST_PARTS: usize = 80;
/// No more formulas than this are made of one.
const MOST_EDITS: usize = 400;
/// Of terms with more symbols than this no two are exchanged.
const MOST_EXCHANGED: usize = 5;
/// What a coefficient may be off by, the likeliest first.
const FACTORS: [(i32, i32); 20] = [
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
    /// Two symbols in each other's place.
    Exchanged {
        /// One of them.
        one: Symbol,
        /// The other one.
        other: Symbol,
    },
    /// A fraction upside down, or a product where there should be a quotient.
    Inverted,
    /// `≤` for `≥`.
    Relation,
    /// `<` for `≤`.
    Strict,
    /// A factor that is missing, or one too many.
    Factor,
    /// A summand that is missing, or one too many.
    Summand,
    /// One function for another: a sine for a cosine.
    Function,
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

/// The symbols that a formula may speak of.
#[derive(Default)]
pub struct Names {
    /// What a symbol may have been mistaken for, or what may be missing.
    pub all: Vec<Symbol>,
    /// Shares of a whole: `p` may stand for `1 - p`.
    pub shares: Set<Symbol>,
}

/// All formulas one edit away from a printed one, the likeliest slip first.
pub fn edits(printed: &Formula, names: &Names) -> Vec<Edit> {
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
        is_equation: *relation == Relation::Equal,
        takes_roots: [left, right].iter().any(|side| side.any(&Expr::is_root)),
        found: Vec::new(),
    };
    for is_left in [false, true] {
        let side = if is_left { left } else { right };
        editor.whole(side);
        editor.missing_factor(side);
        editor.exchanged(side);
        // Of what a number is said to be, no other number is missing.
        if own_number(if is_left { right } else { left }).is_none() {
            editor.missing_one(side);
            editor.upside_down(side);
        }
        for (change, cost, term) in editor.found.drain(..) {
            let formula = match is_left {
                true => rebuilt(&term, *relation, right),
                false => rebuilt(left, *relation, &term),
            };
            // What an equation is solved for is less often wrong than what it says of it.
            let solved = matches!((is_left, left), (true, Expr::Symbol(_)));
            let is_sign = change == Change::Sign;
            let leading = is_sign && starts_with_minus(&term);
            let more = is_sign && minuses(&term) > minuses(side);
            let unlikely = u32::from(is_left) + u32::from(more) + 2 * u32::from(leading);
            let cost = 4 * cost + unlikely + 8 * u32::from(solved);
            all.push(Edit {
                change,
                formula,
                cost,
                left_kept: !is_left,
                right_kept: is_left,
            });
        }
    }
    let (own, other) = (left.free_symbols(), right.free_symbols());
    for (one, two) in pairs(&own.union(&other).cloned().collect()) {
        let [left, right] = [left, right].map(|side| exchange(side, &one, &two));
        all.push(Edit {
            change: Change::Exchanged { one, other: two },
            formula: rebuilt(&left, *relation, &right),
            cost: 20,
            left_kept: false,
            right_kept: false,
        });
    }
    let loose = match relation {
        Relation::Less => Some(Relation::LessOrEqual),
        Relation::Greater => Some(Relation::GreaterOrEqual),
        _ => None,
    };
    let turned = match relation {
        Relation::Less => vec![Relation::Greater, Relation::GreaterOrEqual],
        Relation::Greater => vec![Relation::Less, Relation::LessOrEqual],
        Relation::LessOrEqual => vec![Relation::GreaterOrEqual],
        Relation::GreaterOrEqual => vec![Relation::LessOrEqual],
        _ => Vec::new(),
    };
    let loose = loose.map(|relation| (Change::Strict, relation)).into_iter();
    let turned = turned
        .into_iter()
        .map(|relation| (Change::Relation, relation));
    for (at, (change, relation)) in (0..).zip(loose.chain(turned)) {
        all.push(Edit {
            change,
            formula: rebuilt(left, relation, right),
            cost: 2 + at,
            left_kept: true,
            right_kept: true,
        });
    }
    let same = |edit: &Edit| match &edit.formula {
        Formula::Relation { left, right, .. } => left == right,
        Formula::AllEqual { .. } => false,
    };
    all.retain(|edit| !same(edit));
    sorted::sort_by_key(&mut all, |edit| edit.cost);
    all.truncate(MOST_EDITS);
    all
}

/// Whether a minus is the first that is read of a term: where another sign can be wrong, that is the likelier.
fn starts_with_minus(term: &Expr) -> bool {
    match term {
        Expr::Negate(_) => true,
        Expr::Sum(items) | Expr::Product(items) => items.first().is_some_and(starts_with_minus),
        Expr::Quotient(above, _) => starts_with_minus(above),
        Expr::Power(base, _) => starts_with_minus(base),
        _ => false,
    }
}

fn minuses(term: &Expr) -> usize {
    let own = usize::from(matches!(term, Expr::Negate(_)));
    own + term.children().map(minuses).sum::<usize>()
}

/// How many parts a term has.
pub fn parts(term: &Expr) -> usize {
    1 + term.children().map(parts).sum::<usize>()
}

type Found = Vec<(Change, u32, Expr)>;

struct Editor<'a> {
    names: &'a Names,
    is_equation: bool,
    /// A root stands somewhere in it.
    takes_roots: bool,
    found: Found,
}

impl Editor<'_> {
    /// A side, a summand, or the argument of a function: what may have a sign and a coefficient.
    fn whole(&mut self, term: &Expr) {
        if is_unit(term) {
            return;
        }
        if !matches!(term, Expr::Sum(_)) {
            self.factors(term);
        }
        match term {
            Expr::Negate(inner) => self.found.push((Change::Sign, 1, (**inner).clone())),
            Expr::Number(value) if *value == BigRational::from_integer(0.into()) => {}
            // Nobody writes a minus before a whole sum.
            Expr::Sum(_) => {}
            term => self
                .found
                .push((Change::Sign, 1, Expr::Negate(term.clone().into()))),
        }
        self.within(term);
    }

    fn factors(&mut self, term: &Expr) {
        let one = || Rational::one();
        let (term, negative) = match term {
            Expr::Negate(inner) => (&**inner, true),
            term => (term, false),
        };
        let signed = |term: Expr| match negative {
            true => Expr::Negate(term.into()),
            false => term,
        };
        let before = self.found.len();
        let printed = whole_coefficient(term);
        if let Some(printed) = &printed {
            for other in [printed + &one(), printed - &one()] {
                // Nobody writes a 0, nor a number for one, but among others.
                let cost = match (printed.is_zero(), other.is_zero()) {
                    (false, false) => 2,
                    (_, zero) => {
                        if zero {
                            5
                        } else {
                            6
                        }
                    }
                };
                let other = match own_number(term) {
                    Some(_) => number(&other),
                    None if other.is_zero() || printed.is_zero() => continue,
                    None => scaled(term, &(&other / printed)),
                };
                self.found.push((Change::Coefficient, cost, signed(other)));
            }
        }
        if let Some(value) = own_number(term).filter(|v| !v.is_integer()) {
            let below = BigRational::from_integer(value.denom());
            for other in [1, -1].map(|step| &below + BigRational::from_integer(step.into())) {
                let other = Rational::from(value.numer()) / Rational::from(&other);
                self.found
                    .push((Change::Coefficient, 2, signed(number(&other))));
            }
        }
        if printed.as_ref().is_some_and(Rational::is_zero) {
            return;
        }
        for factor in beside_fraction(term) {
            self.coefficient(before, 2, signed(scaled(term, &factor)));
        }
        for (at, (above, below)) in FACTORS.into_iter().enumerate() {
            let factor = Rational::ratio(above, below);
            // Who writes whole numbers means a whole number.
            let broken = printed
                .as_ref()
                .is_some_and(|own| !((own * &factor).is_integer() || own.is_one() && above == 1));
            let unlikely = [2, 6, 12].into_iter().filter(|&from| at >= from).count() as u32;
            let cost = 2 + unlikely + 2 * u32::from(broken);
            self.coefficient(before, cost, signed(scaled(term, &factor)));
        }
    }

    /// A term with another coefficient, if it is none that was found since.
    fn coefficient(&mut self, since: usize, cost: u32, term: Expr) {
        if self.found[since..].iter().all(|(.., found)| *found != term) {
            self.found.push((Change::Coefficient, cost, term));
        }
    }

    /// What may be missing from a product, or be too much in it.
    fn product(&mut self, factors: &[Expr]) {
        let letter = |term: &Expr| match term {
            Expr::Symbol(_) => true,
            Expr::Power(base, _) => matches!(**base, Expr::Symbol(_)),
            _ => false,
        };
        for (at, factor) in factors.iter().enumerate() {
            let mut others = factors.to_vec();
            others.remove(at);
            let others = product_of(others);
            if letter(factor) {
                self.found.push((Change::Factor, 3, others.clone()));
            }
            if own_number(factor).is_none() {
                let quotient = Expr::Quotient(others.into(), factor.clone().into());
                self.found.push((Change::Inverted, 4, quotient));
            }
        }
    }

    /// Two symbols of a side in each other's place: `m` and `M`.
    fn exchanged(&mut self, side: &Expr) {
        for (one, other) in pairs(&side.free_symbols()) {
            let term = exchange(side, &one, &other);
            if term != *side {
                let change = Change::Exchanged { one, other };
                self.found.push((change, 4, term));
            }
        }
    }

    /// `1 −` or `1 +` before the whole of a side.
    fn missing_one(&mut self, side: &Expr) {
        let (term, negative) = match side {
            Expr::Sum(_) | Expr::Number(_) => return,
            Expr::Negate(inner) => (&**inner, Expr::Negate(inner.clone())),
            term => (term, Expr::Negate(term.clone().into())),
        };
        let one = || Expr::integer(1);
        for item in [negative, term.clone()] {
            let sum = Expr::Sum([one(), item].into());
            self.found.push((Change::Summand, 5, sum));
        }
    }

    /// The whole of a side upside down: `R \sqrt{C/L}` for `\frac{1}{R} \sqrt{L/C}`.
    fn upside_down(&mut self, side: &Expr) {
        let is_term = |own: &&Expr| own_number(own).is_none();
        if let Expr::Product(factors) = side
            && factors.iter().filter(is_term).count() > 1
        {
            let inverse = Expr::Quotient(Expr::integer(1).into(), side.clone().into());
            self.found.push((Change::Inverted, 5, inverse));
        }
    }

    /// What may be missing before or after a product, a symbol or a quotient.
    fn missing_factor(&mut self, term: &Expr) {
        let factors = match term {
            Expr::Product(factors) => factors.to_vec(),
            Expr::Symbol(_) | Expr::Power(..) | Expr::Sum(_) => vec![term.clone()],
            Expr::Number(value) if *value == BigRational::from_integer(1.into()) => Vec::new(),
            Expr::Number(_) => vec![term.clone()],
            _ => return,
        };
        for name in &self.names.all {
            let name = Expr::Symbol(name.clone());
            // A square is written as one.
            if !factors.contains(&name) {
                let all = factors.iter().cloned().chain([name]).collect();
                self.found.push((Change::Factor, 4, product_of(all)));
            }
        }
    }

    /// What may be wrong in the parts of a term.
    fn within(&mut self, term: &Expr) {
        if is_unit(term) {
            return;
        }
        match term {
            Expr::Symbol(symbol) => {
                for name in self.names.all.iter().filter(|name| *name != symbol) {
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
                // Beside another root one is left out more easily.
                if self.takes_roots && self.is_equation {
                    let half = number(&Rational::from(2).recip());
                    let root = Expr::Power(term.clone().into(), half.into());
                    self.found.push((Change::Exponent, 5, root));
                }
                if self.names.shares.contains(symbol) {
                    let rest = vec![Expr::integer(1), Expr::Negate(term.clone().into())];
                    self.found
                        .push((Change::Summand, 4, Expr::Sum(rest.into())));
                }
            }
            Expr::Power(base, exponent) => {
                self.exponents(base, exponent);
                if own_number(exponent).is_none() {
                    self.inside(term, 1, Editor::whole);
                }
                let root = term.is_root();
                self.inside(term, 0, |editor, base| match base {
                    // What a root is taken of is written as a side is. Of a bound nearly any number would do.
                    base if root && editor.is_equation => {
                        let before = editor.found.len();
                        editor.whole(base);
                        editor.found[before..].iter_mut().for_each(|f| f.1 += 1);
                    }
                    // A symbol that has an exponent is not given another.
                    Expr::Symbol(_) => {
                        let before = editor.found.len();
                        editor.within(base);
                        let swapped = |f: &(Change, u32, Expr)| f.0 != Change::Exponent;
                        let own: Found = editor.found.drain(before..).filter(swapped).collect();
                        editor.found.extend(own);
                    }
                    // The square of a quotient, `(2 s/T)^2`: what stands in the parentheses is written as a side is.
                    base @ Expr::Quotient(..) if editor.is_equation && !root => {
                        let before = editor.found.len();
                        editor.factors(base);
                        editor.found[before..].iter_mut().for_each(|f| f.1 += 1);
                        editor.within(base);
                    }
                    base => editor.within(base),
                });
            }
            Expr::Quotient(above, below) => {
                let inverted = Expr::Quotient(below.clone(), above.clone());
                self.found.push((Change::Inverted, 3, inverted));
                self.numbers_inverted(above, below);
                let factors = [(**above).clone(), (**below).clone()];
                if own_number(below).is_none() && **above != Expr::integer(1) {
                    let product = product_of(factors.to_vec());
                    self.found.push((Change::Inverted, 4, product));
                }
                if own_number(term).is_none() {
                    self.inside(term, 0, Editor::part);
                    self.inside(term, 1, Editor::part);
                }
            }
            Expr::Sum(items) => {
                self.between(items);
                for at in 0..items.len() {
                    let mut others = items.to_vec();
                    others.remove(at);
                    if let [only] = others.as_slice() {
                        others = match only {
                            Expr::Sum(items) => items.to_vec(),
                            only => vec![only.clone()],
                        };
                    }
                    let rest = match others.len() {
                        1 => others.remove(0),
                        _ => Expr::Sum(others.into()),
                    };
                    self.found.push((Change::Summand, 4, rest));
                    let nought = |item: &Expr| own_number(item).is_some_and(|own| own.is_zero());
                    if own_number(&items[at]).is_some_and(|own| own.is_one())
                        && items.iter().any(nought)
                    {
                        let mut others = items.to_vec();
                        others[at] = Expr::integer(0);
                        self.found
                            .push((Change::Coefficient, 1, Expr::Sum(others.into())));
                    }
                    let before = self.found.len();
                    let among_others = items.iter().any(nought);
                    self.inside(term, at, |editor, item| {
                        editor.whole(item);
                        // That is the summand left out.
                        let mut own = editor.found.split_off(before);
                        own.retain(|(_, _, other)| among_others || !nought(other));
                        editor.found.extend(own);
                        editor.sum_in_brackets(item);
                        editor.missing_factor(item);
                    });
                }
            }
            Expr::Call(function, argument) => {
                let other = match function {
                    Function::Sin => Some(Function::Cos),
                    Function::Cos => Some(Function::Sin),
                    _ => None,
                };
                // Logarithms are seldom squared, and exponentials never.
                if other.is_some() {
                    let squared = Expr::Power(term.clone().into(), Expr::integer(2).into());
                    self.found.push((Change::Exponent, 3, squared));
                }
                let other = other.map(|f| Expr::Call(f, argument.clone()));
                self.found
                    .extend(other.map(|call| (Change::Function, 2, call)));
                let before = self.found.len();
                self.inside(term, 0, Editor::whole);
                // A sign is rather lost before a function than within.
                for (change, cost, _) in &mut self.found[before..] {
                    *cost += u32::from(*change == Change::Sign);
                }
            }
            Expr::Product(factors) => {
                for at in 0..factors.len() {
                    self.inside(term, at, |editor, factor| {
                        editor.within(factor);
                        editor.sum_in_brackets(factor);
                    });
                }
                self.product(factors);
            }
            Expr::Negate(_) => self.inside(term, 0, Editor::part),
            Expr::Integral { .. } | Expr::Limit { .. } | Expr::Series { .. } => {
                for at in 0..term.children().count() {
                    self.inside(term, at, Editor::whole);
                }
            }
            _ => {}
        }
    }

    /// What may be wrong in what grows from one limit to another, `\left[\frac{r^4}{4}\right]_0^a`: it is written once.
    fn between(&mut self, items: &[Expr]) {
        let [Expr::Limit { body, .. }, Expr::Negate(lower)] = items else {
            return;
        };
        if !matches!(&**lower, Expr::Limit { body: own, .. } if own == body) {
            return;
        }
        let before = self.found.len();
        self.whole(body);
        for (_, _, found) in &mut self.found[before..] {
            let both = items.iter().map(|item| item.replace(body, found));
            *found = Expr::Sum(both.collect());
        }
    }

    /// The numbers of a quotient in each other's place: `\frac{3 a}{4 b}` for `\frac{4 a}{3 b}`.
    fn numbers_inverted(&mut self, above: &Expr, below: &Expr) {
        let is_product = |term: &Expr| matches!(term, Expr::Product(_));
        let (Some(one), Some(other)) = (whole_coefficient(above), whole_coefficient(below)) else {
            return;
        };
        let is_nought = one.is_zero() || other.is_zero();
        if is_nought || one == other || !is_product(above) && !is_product(below) {
            return;
        }
        let quotient = Expr::Quotient(
            scaled(above, &(&other / &one)).into(),
            scaled(below, &(&one / &other)).into(),
        );
        self.found.push((Change::Inverted, 3, quotient));
    }

    /// A numerator, a denominator, or what follows a minus.
    fn part(&mut self, term: &Expr) {
        self.within(term);
        self.missing_factor(term);
    }

    /// A sum within something else may have lost its square.
    fn sum_in_brackets(&mut self, term: &Expr) {
        if let Expr::Sum(_) = term {
            let squared = Expr::Power(term.clone().into(), Expr::integer(2).into());
            self.found.push((Change::Exponent, 4, squared));
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
        // `3/2` for `2/3`; a root is no power upside down.
        let upside_down = (!printed.is_integer()).then(|| printed.recip());
        let upside_down = upside_down.filter(|own| !own.is_integer());
        for (at, other) in others.into_iter().chain(upside_down).enumerate() {
            if other == printed || other == whole(0) {
                continue;
            }
            let term = match other == one {
                true => base.clone(),
                false => Expr::Power(base.clone().into(), number(&other).into()),
            };
            // A negative exponent is a fraction upside down; a root of a power is rarely left out.
            let turned = other.is_negative() && !printed.is_negative();
            let broken = printed.is_integer() && !other.is_integer();
            let unlikely = 3 * u32::from(turned) + 2 * u32::from(broken);
            let cost = 2 + u32::from(at > 2) + unlikely;
            self.found.push((Change::Exponent, cost, term));
        }
    }

    /// Edits the child at a position, the rest left as it is.
    fn inside(&mut self, term: &Expr, position: usize, edit: impl FnOnce(&mut Self, &Expr)) {
        let Some(child) = term.children().nth(position) else {
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

/// Whether a term is nothing but a unit, `(0.001 m)^{-1}`: whoever slips by one writes another.
fn is_unit(term: &Expr) -> bool {
    let is_unit = |own: &Expr| matches!(own, Expr::Symbol(own) if own.is_unit());
    let is_letter = |own: &Expr| matches!(own, Expr::Symbol(own) if !own.is_unit());
    let begins_with_it = match term {
        Expr::Product(factors) => {
            factors.len() < 2 || factors[1..].iter().all(|own| own.any(&is_unit))
        }
        _ => true,
    };
    begins_with_it && term.any(&is_unit) && !term.any(&is_letter)
}

/// The whole number that a term is or begins with, 1 if it begins with none; nothing where that is a fraction.
fn whole_coefficient(term: &Expr) -> Option<Rational> {
    let own = match term {
        Expr::Number(_) => own_number(term),
        Expr::Quotient(..) | Expr::Sum(_) => None,
        Expr::Product(factors) => match factors.first() {
            Some(Expr::Quotient(..)) => None,
            Some(first) => Some(own_number(first).unwrap_or_else(Rational::one)),
            None => None,
        },
        _ => Some(Rational::one()),
    };
    own.filter(Rational::is_integer)
}

/// What a term is multiplied by where the number below its fraction, or above it, is one more or less: `\frac{b^4}{5}` for `\frac{b^4}{4}`.
fn beside_fraction(term: &Expr) -> Vec<Rational> {
    let (above, below) = match term {
        Expr::Quotient(above, below) => (coefficient(above), coefficient(below)),
        Expr::Product(factors) => {
            let mut fractions = factors
                .iter()
                .filter(|own| matches!(own, Expr::Quotient(..)));
            return fractions.next().map(beside_fraction).unwrap_or_default();
        }
        _ => return Vec::new(),
    };
    let one = Rational::one();
    let beside = |own: &Rational| {
        let others = (own.is_integer() && !own.is_one()).then(|| [own - &one, own + &one]);
        let others = others.into_iter().flatten();
        others.filter(|other| !other.is_zero())
    };
    let over = beside(&below).map(|other| &below / &other);
    over.chain(beside(&above).map(|other| &other / &above))
        .collect()
}

/// Two of these symbols at a time, where they are few.
fn pairs(symbols: &Set<Symbol>) -> Vec<(Symbol, Symbol)> {
    let all: Vec<&Symbol> = symbols.iter().filter(|own| !own.is_unit()).collect();
    if all.len() > MOST_EXCHANGED {
        return Vec::new();
    }
    let mut pairs = Vec::new();
    for (at, one) in all.iter().enumerate() {
        let others = all[at + 1..].iter();
        pairs.extend(others.map(|other| ((*one).clone(), (*other).clone())));
    }
    pairs
}

/// A term with two symbols in each other's place; the same where one of them is bound in it.
fn exchange(term: &Expr, one: &Symbol, other: &Symbol) -> Expr {
    match term {
        Expr::Symbol(own) if own == one => Expr::Symbol(other.clone()),
        Expr::Symbol(own) if own == other => Expr::Symbol(one.clone()),
        term if term.binder().is_some() => term.clone(),
        term => term.map_children(|part| exchange(part, one, other)),
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
