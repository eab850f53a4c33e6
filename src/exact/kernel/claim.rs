use std::sync::{Arc, LazyLock};

use num_traits::{Signed, Zero};

use crate::algebra::{BigRational, Expr, Formula, Relation, Symbol};
use crate::sorted::Map;

/// What must follow from what: hypotheses ⊢ goal, over the reals.
///
/// **Semantics.** A formula is true at a point when every term in it is defined there and the relation is
/// true. The claim is that the goal is true wherever all domains and hypotheses are.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Claim {
    /// Where each symbol may lie; a symbol without an entry is any real number.
    pub domains: Map<Symbol, Domain>,
    /// The symbols that name sequences, with the domain of their elements.
    pub sequences: Map<Symbol, Domain>,
    /// The premises, in the order in which evidence refers to them.
    pub hypotheses: Vec<Hypothesis>,
    /// What is to follow.
    pub goal: Formula,
}

/// A premise.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Hypothesis {
    /// What is assumed; shared, for one formula is a premise of many claims.
    pub formula: Arc<Formula>,
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

    /// Whether everything in the domain is greater than 0.
    pub fn is_positive(&self) -> bool {
        let above = |(bound, strict): &(BigRational, bool)| {
            bound.is_positive() || (*strict && bound.is_zero())
        };
        self.lower.as_ref().is_some_and(above)
    }

    /// What the domain says of a term, as relations to numbers; that it is an integer cannot be said so.
    pub fn bounds(&self) -> impl Iterator<Item = (Relation, &BigRational)> {
        let lower = self.lower.iter().map(|(bound, strict)| match strict {
            true => (Relation::Greater, bound),
            false => (Relation::GreaterOrEqual, bound),
        });
        let upper = self.upper.iter().map(|(bound, strict)| match strict {
            true => (Relation::Less, bound),
            false => (Relation::LessOrEqual, bound),
        });
        let zero = self.nonzero.then(|| (Relation::NotEqual, nought()));
        let excluded = |(bound, strict): &(BigRational, bool)| {
            bound.is_positive() || (*strict && bound.is_zero())
        };
        let zero = zero.filter(|_| !self.lower.as_ref().is_some_and(excluded));
        lower.chain(upper).chain(zero)
    }

    /// The same as formulas about a term.
    pub fn formulas(&self, term: &Expr) -> Vec<Formula> {
        let bounds = self.bounds().map(|(relation, bound)| Formula::Relation {
            left: term.clone(),
            relation,
            right: Expr::Number(bound.clone()),
        });
        bounds.collect()
    }
}

/// 0, to be lent out.
fn nought() -> &'static BigRational {
    static ZERO: LazyLock<BigRational> = LazyLock::new(BigRational::zero);
    &ZERO
}

impl Claim {
    /// Whether a symbol is declared to depend on no variable.
    pub fn is_constant(&self, symbol: &Symbol) -> bool {
        (self.domains.get(symbol)).is_some_and(|domain| domain.constant)
    }

    /// Every formula: the hypotheses in order, then the goal.
    pub fn formulas(&self) -> impl Iterator<Item = &Formula> {
        let hypotheses = self.hypotheses.iter().map(|h| &*h.formula);
        hypotheses.chain(std::iter::once(&self.goal))
    }

    /// The symbols that have a value of their own in some formula, in order.
    pub fn free_symbols(&self) -> Vec<&Symbol> {
        Formula::free_symbols_of(self.formulas())
    }
}
