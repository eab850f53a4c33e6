use smallvec::{SmallVec, smallvec};

use super::{BigRational, Expr, Moved, Symbol};
use crate::sorted::Set;

/// Few claims speak of more symbols: so many are listed without asking for more room.
const FEW_SYMBOLS: usize = 16;

/// How two terms are related.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Relation {
    /// `=`
    Equal,
    /// `\neq`
    NotEqual,
    /// `<`
    Less,
    /// `\leq`
    LessOrEqual,
    /// `>`
    Greater,
    /// `\geq`
    GreaterOrEqual,
    /// `\sim`: scales as
    Scales,
    /// `\propto`
    Proportional,
    /// `\approx`
    Approximately,
    /// `\to`: in a limit that is named elsewhere
    Tends,
    /// `\ll`
    MuchLess,
    /// `\gg`
    MuchGreater,
}

impl Relation {
    /// The relation that holds between two numbers just where this one does not; none for what is no relation of numbers.
    pub fn denied(self) -> Option<Relation> {
        Some(match self {
            Relation::Equal => Relation::NotEqual,
            Relation::NotEqual => Relation::Equal,
            Relation::Less => Relation::GreaterOrEqual,
            Relation::GreaterOrEqual => Relation::Less,
            Relation::Greater => Relation::LessOrEqual,
            Relation::LessOrEqual => Relation::Greater,
            _ => return None,
        })
    }
}

/// One statement that is true or false at a point.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Formula {
    /// `left relation right`.
    Relation {
        /// The left side.
        left: Expr,
        /// How it is related to the right side.
        relation: Relation,
        /// The right side.
        right: Expr,
    },
    /// `u_1 = u_2 = \dots = u_to`, and `= value` where one is named.
    AllEqual {
        /// The sequence, `u`.
        sequence: Symbol,
        /// The index of the last element that is meant.
        to: Expr,
        /// The common value, where one is named.
        value: Option<Expr>,
    },
}

impl Formula {
    /// `left = right`.
    pub fn equal(left: Expr, right: Expr) -> Formula {
        Formula::Relation {
            left,
            relation: Relation::Equal,
            right,
        }
    }

    /// What is true of numbers where this is not, if that is a relation, too.
    pub fn denied(&self) -> Option<Formula> {
        match self {
            Formula::Relation {
                left,
                relation,
                right,
            } => Some(Formula::Relation {
                left: left.clone(),
                relation: relation.denied()?,
                right: right.clone(),
            }),
            _ => None,
        }
    }

    /// `one = other`, of two symbols.
    pub fn same(one: &Symbol, other: &Symbol) -> Formula {
        Formula::equal(Expr::Symbol(one.clone()), Expr::Symbol(other.clone()))
    }

    /// `term \neq 0`.
    pub fn nonzero(term: Expr) -> Formula {
        Formula::Relation {
            left: term,
            relation: Relation::NotEqual,
            right: Expr::integer(0),
        }
    }

    /// Whether something is differentiated in it.
    pub fn speaks_of_slopes(&self) -> bool {
        let is_slope = |part: &Expr| matches!(part, Expr::Derivative { .. } | Expr::Partial { .. });
        self.terms().into_iter().any(|term| term.any(&is_slope))
    }

    /// Whether the value of something at a place stands in it.
    pub fn speaks_of_values(&self) -> bool {
        let mut terms = self.terms().into_iter();
        terms.any(|term| term.any(&Expr::is_value_somewhere))
    }

    /// Whether it is of the form `term ≠ 0`.
    pub fn is_nonzero(&self) -> bool {
        matches!(self, Formula::Relation { relation: Relation::NotEqual, right, .. } if *right == Expr::integer(0))
    }

    /// Whether it says that two names mean the same: `a = b`.
    pub fn equates_names(&self) -> bool {
        let sides = self.as_equation();
        matches!(sides, Some((Expr::Symbol(_), Expr::Symbol(_))))
    }

    /// `symbol = number`.
    pub fn number(symbol: Symbol, number: BigRational) -> Formula {
        Formula::equal(Expr::Symbol(symbol), Expr::Number(number))
    }

    /// `term > 0`.
    pub fn positive(term: Expr) -> Formula {
        Formula::Relation {
            left: term,
            relation: Relation::Greater,
            right: Expr::integer(0),
        }
    }

    /// Whether it says that something is about something else.
    pub fn is_approximation(&self) -> bool {
        matches!(
            self,
            Formula::Relation {
                relation: Relation::Approximately,
                ..
            }
        )
    }

    /// Whether this says which of two numbers is the greater.
    pub fn is_inequality(&self) -> bool {
        use Relation::{Greater, GreaterOrEqual, Less, LessOrEqual};
        let Formula::Relation { relation, .. } = self else {
            return false;
        };
        matches!(relation, Less | LessOrEqual | Greater | GreaterOrEqual)
    }

    /// The symbol of which this says what number it is, `n = 3`, and that.
    pub fn number_said(&self) -> Option<(&Symbol, &BigRational)> {
        match self.as_equation() {
            Some((Expr::Symbol(symbol), Expr::Number(number))) => Some((symbol, number)),
            _ => None,
        }
    }

    /// The symbol of which it says what that is, or what a power of it is, and the right side: `\omega` and `k/m` of `\omega^2 = k/m`.
    pub fn said_of(&self) -> Option<(&Symbol, &Expr)> {
        let (left, right) = self.as_equation()?;
        let symbol = match left {
            Expr::Symbol(symbol) => symbol,
            Expr::Power(base, exponent) => match (&**base, &**exponent) {
                (Expr::Symbol(symbol), Expr::Number(_)) => symbol,
                _ => return None,
            },
            _ => return None,
        };
        Some((symbol, right))
    }

    /// The symbol of which this says what number it is.
    pub fn set_to_number(&self) -> Option<&Symbol> {
        Some(self.number_said()?.0)
    }

    /// Both sides, where this is an equation.
    pub fn as_equation(&self) -> Option<(&Expr, &Expr)> {
        match self {
            Formula::Relation {
                left,
                relation: Relation::Equal,
                right,
            } => Some((left, right)),
            _ => None,
        }
    }

    /// The terms of the formula.
    pub fn terms(&self) -> SmallVec<[&Expr; 2]> {
        match self {
            Formula::Relation { left, right, .. } => smallvec![left, right],
            Formula::AllEqual { to, value, .. } => std::iter::once(to).chain(value).collect(),
        }
    }

    /// The same formula with each of its terms replaced.
    pub fn map_terms(&self, mut change: impl FnMut(&Expr) -> Expr) -> Formula {
        match self {
            Formula::Relation {
                left,
                relation,
                right,
            } => Formula::Relation {
                left: change(left),
                relation: *relation,
                right: change(right),
            },
            Formula::AllEqual {
                sequence,
                to,
                value,
            } => Formula::AllEqual {
                sequence: sequence.clone(),
                to: change(to),
                value: value.as_ref().map(change),
            },
        }
    }

    /// Whether an index occurs, by itself or in the name of a symbol.
    pub fn depends_on(&self, index: &Symbol) -> bool {
        let own = match self {
            Formula::Relation { .. } => false,
            Formula::AllEqual { sequence, .. } => Expr::Symbol(sequence.clone()).depends_on(index),
        };
        own || self.terms().iter().any(|term| term.depends_on(index))
    }

    /// The same relation for another value of an index; `None` as for [`Expr::moved`].
    pub fn moved(&self, index: &Symbol, to: Moved) -> Option<Formula> {
        match self {
            formula if !formula.depends_on(index) => Some(formula.clone()),
            Formula::Relation {
                left,
                relation,
                right,
            } => Some(Formula::Relation {
                left: left.moved(index, to)?,
                relation: *relation,
                right: right.moved(index, to)?,
            }),
            Formula::AllEqual { .. } => None,
        }
    }

    /// The symbols that have a value of their own.
    pub fn free_symbols(&self) -> Set<Symbol> {
        Formula::free_symbols_of(std::iter::once(self))
            .into_iter()
            .cloned()
            .collect()
    }

    /// The same for several formulas at once, in order.
    pub fn free_symbols_of<'a>(formulas: impl Iterator<Item = &'a Formula>) -> Vec<&'a Symbol> {
        let mut free = Vec::with_capacity(FEW_SYMBOLS);
        for formula in formulas {
            for term in formula.terms() {
                term.collect_free(&mut Vec::new(), &mut free);
            }
        }
        free
    }

    /// The symbols that are differentiated in formulas, once or more often.
    pub fn differentiated_in<'a>(formulas: impl Iterator<Item = &'a Formula>) -> Set<Symbol> {
        let mut found = Set::new();
        for term in formulas.flat_map(Formula::terms) {
            term.collect_differentiated(&mut found);
        }
        found
    }

    /// Whether it speaks of a slope with respect to a variable.
    pub fn differentiates_by(&self, variable: &Symbol) -> bool {
        let mut found = Set::new();
        for term in self.terms() {
            term.collect_variables(&mut found);
        }
        found.contains(variable)
    }

    /// The symbols that have a value of their own, and the sequences.
    pub fn names(&self) -> Set<Symbol> {
        let mut names = Formula::names_in(self.terms().into_iter());
        if let Formula::AllEqual { sequence, .. } = self {
            names.insert(sequence.clone());
        }
        names
    }

    /// The same for terms.
    pub fn names_in<'a>(terms: impl Iterator<Item = &'a Expr>) -> Set<Symbol> {
        let (mut free, mut sequences) = (Vec::with_capacity(FEW_SYMBOLS), Set::new());
        for term in terms {
            term.collect_free(&mut Vec::new(), &mut free);
            collect_sequences(term, &mut sequences);
        }
        free.into_iter().cloned().chain(sequences).collect()
    }

    /// What is applied in terms: `f` in `f(x)`.
    pub fn applied_in<'a>(terms: impl IntoIterator<Item = &'a Expr>) -> Set<Symbol> {
        let mut found = Set::new();
        for term in terms {
            term.collect_applied(&|_| true, &mut found);
        }
        found
    }

    /// The sequences that occur.
    pub fn sequences(&self) -> Set<Symbol> {
        Formula::sequences_of(std::iter::once(self))
    }

    /// The same for a term.
    pub fn sequences_in(term: &Expr) -> Set<Symbol> {
        let mut found = Set::new();
        collect_sequences(term, &mut found);
        found
    }

    /// The same for several formulas at once.
    pub fn sequences_of<'a>(formulas: impl Iterator<Item = &'a Formula>) -> Set<Symbol> {
        let mut found = Set::new();
        for formula in formulas {
            for term in formula.terms() {
                collect_sequences(term, &mut found);
            }
            if let Formula::AllEqual { sequence, .. } = formula {
                found.insert(sequence.clone());
            }
        }
        found
    }
}

fn collect_sequences(expr: &Expr, found: &mut Set<Symbol>) {
    match expr {
        Expr::Element { sequence, .. } => {
            found.insert(sequence.clone());
        }
        // Most terms are one of these.
        Expr::Symbol(_) | Expr::Number(_) => {}
        Expr::Sum(terms) | Expr::Product(terms) => {
            (terms.iter()).for_each(|child| collect_sequences(child, found));
        }
        Expr::Quotient(a, b) | Expr::Power(a, b) => {
            collect_sequences(a, found);
            collect_sequences(b, found);
        }
        _ => (expr.children()).for_each(|child| collect_sequences(child, found)),
    }
}
