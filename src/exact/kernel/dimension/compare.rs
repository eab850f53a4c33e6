use crate::algebra::{
    BigRational, Expr, Formula, Function, LimitPoint, Rational, Relation, Symbol,
};

use super::exponent::linear;
use super::{Form, Said, Scope};

/// Two dimensions that a formula needs to be alike.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Comparison {
    /// Why they must be.
    pub what: What,
    /// One of the two.
    pub left: Member,
    /// The other; a pure number where there is none.
    pub right: Option<Member>,
}

/// A term with its dimension.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Member {
    /// Where the term stands: its side among [`Formula::terms`], then the position of the child at each step down.
    /// Empty for the sequence of [`Formula::AllEqual`].
    pub path: Vec<usize>,
    /// Its dimension.
    pub form: Form,
}

/// Why two dimensions must be alike.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum What {
    /// The two sides of a relation.
    Sides,
    /// Two summands.
    Summands,
    /// The argument of a function: a pure number.
    Argument(Function),
    /// An exponent: a pure number.
    Exponent,
    /// A limit of a sum: a pure number.
    Count,
    /// Where a variable goes, or between what it is integrated, and the variable.
    Limit,
}

impl Comparison {
    /// The quotient of the two: a pure number, if all is well.
    pub fn quotient(&self) -> Form {
        match &self.right {
            Some(right) => self.left.form.over(&right.form),
            None => self.left.form.clone(),
        }
    }
}

/// The dimension of a term.
#[derive(Clone, Debug)]
pub(super) enum Found {
    /// That of 0, which is as good a length as a time.
    Any,
    /// Nothing is said of a symbol in it, or a symbolic power of an unknown occurs.
    Unsaid,
    /// This one.
    Form(Form),
}

/// All that a formula needs to be alike, in a fixed order: inner terms first, left before right.
pub fn comparisons(formula: &Formula, scope: &Scope) -> Vec<Comparison> {
    read(formula, scope).0
}

/// The comparisons, and the dimension of each term of the formula.
pub(super) fn read(formula: &Formula, scope: &Scope) -> (Vec<Comparison>, Vec<Found>) {
    let mut walk = Walk {
        scope,
        bound: Vec::new(),
        path: Vec::new(),
        found: Vec::new(),
    };
    let terms = formula.terms();
    let sides: Vec<Found> = (0..)
        .zip(&terms)
        .map(|(at, term)| walk.below(at, term))
        .collect();
    match formula {
        Formula::Relation { relation, .. } => {
            // `F \propto x` leaves the constant out, and with it its dimension.
            if *relation != Relation::Proportional {
                walk.alike(What::Sides, (&[0], &sides[0]), (&[1], &sides[1]));
            }
        }
        Formula::AllEqual { sequence, .. } => {
            walk.number(What::Count, &[0], &sides[0]);
            if let (Some(said), Some(value)) = (scope.sequences.get(sequence), sides.get(1)) {
                let own = Found::Form(Form::said(said));
                walk.alike(What::Sides, (&[], &own), (&[1], value));
            }
        }
    }
    (walk.found, sides)
}

struct Walk<'a> {
    scope: &'a Scope,
    /// The bound symbols and their dimensions, the innermost last.
    bound: Vec<(&'a Symbol, Found)>,
    path: Vec<usize>,
    found: Vec<Comparison>,
}

impl<'a> Walk<'a> {
    fn below(&mut self, at: usize, term: &'a Expr) -> Found {
        self.path.push(at);
        let found = self.term(term);
        self.path.pop();
        found
    }

    fn member(&self, steps: &[usize], form: &Form) -> Member {
        Member {
            path: [&self.path[..], steps].concat(),
            form: form.clone(),
        }
    }

    fn alike(&mut self, what: What, left: (&[usize], &Found), right: (&[usize], &Found)) {
        if let (Found::Form(a), Found::Form(b)) = (left.1, right.1)
            && a != b
        {
            let comparison = Comparison {
                what,
                left: self.member(left.0, a),
                right: Some(self.member(right.0, b)),
            };
            self.found.push(comparison);
        }
    }

    fn number(&mut self, what: What, at: &[usize], term: &Found) {
        if let Found::Form(form) = term
            && !form.is_none()
        {
            let comparison = Comparison {
                what,
                left: self.member(at, form),
                right: None,
            };
            self.found.push(comparison);
        }
    }

    fn symbol(&self, symbol: &Symbol) -> Found {
        let bound = self.bound.iter().rev().find(|(own, _)| *own == symbol);
        match (bound, self.scope.symbols.get(symbol)) {
            (Some((_, found)), _) => found.clone(),
            (None, said) => said.map_or(Found::Unsaid, |said| Found::Form(Form::said(said))),
        }
    }

    fn term(&mut self, term: &'a Expr) -> Found {
        match term {
            Expr::Number(value) if *value == BigRational::default() => Found::Any,
            Expr::Number(_) => Found::Form(Form::default()),
            Expr::Symbol(symbol) => self.symbol(symbol),
            Expr::Apply(function, _) => self.symbol(function),
            Expr::Element { sequence, .. } => match self.scope.sequences.get(sequence) {
                Some(said) => Found::Form(Form::said(said)),
                None => Found::Unsaid,
            },
            Expr::Negate(inner) => self.below(0, inner),
            Expr::Sum(items) => self.sum(items),
            Expr::Product(items) => {
                let factors: Vec<Found> = (0..)
                    .zip(items.iter())
                    .map(|(at, item)| self.below(at, item))
                    .collect();
                let whole = Found::Form(Form::default());
                factors.iter().fold(whole, |whole, factor| {
                    times(whole, factor, &Rational::one())
                })
            }
            Expr::Quotient(over, under) => {
                let over = self.below(0, over);
                let under = self.below(1, under);
                times(over, &under, &-Rational::one())
            }
            Expr::Power(base, exponent) => self.power(base, exponent),
            Expr::Call(function, inner) => {
                let argument = self.below(0, inner);
                match function {
                    Function::Abs | Function::Ceiling | Function::Floor => argument,
                    _ => {
                        self.number(What::Argument(*function), &[0], &argument);
                        Found::Form(Form::default())
                    }
                }
            }
            Expr::Series {
                index,
                from,
                to,
                body,
            } => {
                for (at, limit) in [(0, from), (1, to)] {
                    let limit = self.below(at, limit);
                    self.number(What::Count, &[at], &limit);
                }
                self.bound.push((index, Found::Form(Form::default())));
                let body = self.below(2, body);
                self.bound.pop();
                body
            }
            Expr::Derivative { body, variable } | Expr::Partial { body, variable, .. } => {
                let body = self.below(0, body);
                times(body, &self.symbol(variable), &-Rational::one())
            }
            Expr::Limit {
                body,
                variable,
                point,
            } => {
                if let LimitPoint::Finite(point) = point {
                    let point = self.below(1, point);
                    let variable = self.symbol(variable);
                    self.alike(What::Limit, (&[1], &point), (&[1], &variable));
                }
                self.below(0, body)
            }
            Expr::Integral {
                body,
                variable,
                from,
                to,
            } => {
                let (from, to) = (self.below(0, from), self.below(1, to));
                let declared = matches!(self.scope.symbols.get(variable), Some(Said::Declared(_)));
                // The variable is bound: unless it is declared, the limits alone say what it is.
                let own = match (declared, &to, &from) {
                    (true, ..) => self.symbol(variable),
                    (false, Found::Form(_), _) => to.clone(),
                    (false, _, Found::Form(_)) => from.clone(),
                    _ => Found::Unsaid,
                };
                self.alike(What::Limit, (&[0], &from), (&[0], &own));
                self.alike(What::Limit, (&[1], &to), (&[1], &own));
                self.bound.push((variable, own.clone()));
                let body = self.below(2, body);
                self.bound.pop();
                times(body, &own, &Rational::one())
            }
        }
    }

    /// Each summand is compared with the first one whose dimension is known, or with the first at all.
    fn sum(&mut self, items: &'a [Expr]) -> Found {
        let found: Vec<Found> = (0..)
            .zip(items)
            .map(|(at, item)| self.below(at, item))
            .collect();
        let known = |f: &Found| matches!(f, Found::Form(form) if form.unknowns.is_empty());
        let any = |f: &Found| matches!(f, Found::Form(_));
        let first = found.iter().position(known);
        let Some(first) = first.or_else(|| found.iter().position(any)) else {
            let zeros = found.iter().all(|f| matches!(f, Found::Any));
            return if zeros { Found::Any } else { Found::Unsaid };
        };
        for (at, item) in found.iter().enumerate().filter(|(at, _)| *at != first) {
            self.alike(What::Summands, (&[at], item), (&[first], &found[first]));
        }
        found[first].clone()
    }

    fn power(&mut self, base: &'a Expr, exponent: &'a Expr) -> Found {
        let own = self.below(0, base);
        let raised = self.below(1, exponent);
        self.number(What::Exponent, &[1], &raised);
        let (constant, opaque) = linear(exponent);
        let Found::Form(form) = own else {
            return own;
        };
        // In `\sum_i a_i x^i` each term has a dimension of its own.
        let varies = |term: &&Expr| self.bound.iter().any(|(index, _)| term.mentions(index));
        if !form.is_none() && opaque.keys().any(varies) {
            return Found::Unsaid;
        }
        let mut power = form.power(&constant);
        for (term, factor) in &opaque {
            if !form.unknowns.is_empty() {
                // `e^{-t}`: nobody declares the base of natural logarithms.
                let natural =
                    matches!(base, Expr::Symbol(s) if ["e", "\\text{e}"].contains(&s.name()));
                return if natural {
                    Found::Form(Form::default())
                } else {
                    Found::Unsaid
                };
            }
            match form.known.opaque_power(term) {
                Some(part) => power.known.multiply(&part, factor),
                None => return Found::Unsaid,
            }
        }
        Found::Form(power)
    }
}

fn times(left: Found, right: &Found, power: &Rational) -> Found {
    match (left, right) {
        (Found::Unsaid, _) | (_, Found::Unsaid) => Found::Unsaid,
        (Found::Any, _) | (_, Found::Any) => Found::Any,
        (Found::Form(mut left), Found::Form(right)) => {
            left.multiply(right, power);
            Found::Form(left)
        }
    }
}

/// The dimension of a side, where it has one.
pub(super) fn form(found: &Found) -> Option<Form> {
    match found {
        Found::Form(form) => Some(form.clone()),
        Found::Any | Found::Unsaid => None,
    }
}
