use std::collections::{BTreeMap, BTreeSet};

use num_traits::{Signed, Zero};

use crate::algebra::{BigRational, Expr, Formula, Relation, Symbol};

/// What must follow from what: hypotheses ⊢ goal, over the reals.
///
/// **Semantics.** A formula is true at a point when every term in it is defined there and the relation is
/// true. The claim is that the goal is true wherever all domains and hypotheses are.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Claim {
    /// Where each symbol may lie; a symbol without an entry is any real number.
    pub domains: BTreeMap<Symbol, Domain>,
    /// The symbols that name sequences, with the domain of their elements.
    pub sequences: BTreeMap<Symbol, Domain>,
    /// The premises, in the order in which evidence refers to them.
    pub hypotheses: Vec<Hypothesis>,
    /// What is to follow.
    pub goal: Formula,
}

/// A premise.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Hypothesis {
    /// What is assumed.
    pub formula: Formula,
    /// Whether it is assumed throughout or at the point in question only.
    pub standing: Standing,
}

/// How far a premise reaches. It matters under a derivative, a limit or an integral alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Standing {
    /// True for all values of the variables, as a law or a definition is: it may be differentiated.
    Identity,
    /// True at the point in question, as `let \mu = 1` is.
    AtPoint,
}

/// Where a symbol may lie.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Domain {
    /// The lower bound, and whether it is itself excluded.
    pub lower: Option<(BigRational, bool)>,
    /// The upper bound, and whether it is itself excluded.
    pub upper: Option<(BigRational, bool)>,
    /// 0 is excluded.
    pub nonzero: bool,
    /// Integers only.
    pub integer: bool,
    /// Depends on no variable of differentiation.
    pub constant: bool,
}

impl Domain {
    /// Whether a number lies in the domain.
    pub fn contains(&self, value: &BigRational) -> bool {
        let above =
            |(bound, strict): &(BigRational, bool)| value > bound || (!strict && value == bound);
        let below =
            |(bound, strict): &(BigRational, bool)| value < bound || (!strict && value == bound);
        self.lower.as_ref().is_none_or(above)
            && self.upper.as_ref().is_none_or(below)
            && !(self.nonzero && value.is_zero())
            && (!self.integer || value.is_integer())
    }

    /// The domain as formulas about a term; that it is an integer cannot be said so.
    pub fn formulas(&self, term: &Expr) -> Vec<Formula> {
        let mut formulas = Vec::new();
        let mut say = |relation, bound: &BigRational| {
            formulas.push(Formula::Relation {
                left: term.clone(),
                relation,
                right: Expr::Number(bound.clone()),
            });
        };
        if let Some((bound, strict)) = &self.lower {
            let relation = match strict {
                true => Relation::Greater,
                false => Relation::GreaterOrEqual,
            };
            say(relation, bound);
        }
        if let Some((bound, strict)) = &self.upper {
            let relation = match strict {
                true => Relation::Less,
                false => Relation::LessOrEqual,
            };
            say(relation, bound);
        }
        let excluded = self
            .lower
            .as_ref()
            .is_some_and(|(b, strict)| b.is_positive() || (*strict && b.is_zero()));
        if self.nonzero && !excluded {
            say(Relation::NotEqual, &BigRational::zero());
        }
        formulas
    }
}

impl Claim {
    /// Every formula: the hypotheses in order, then the goal.
    pub fn formulas(&self) -> impl Iterator<Item = &Formula> {
        let hypotheses = self.hypotheses.iter().map(|h| &h.formula);
        hypotheses.chain(std::iter::once(&self.goal))
    }

    /// The symbols that have a value of their own in some formula.
    pub fn free_symbols(&self) -> BTreeSet<Symbol> {
        self.formulas().flat_map(Formula::free_symbols).collect()
    }
}
