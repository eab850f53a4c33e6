use super::{Expr, Symbol};

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
    /// `\ll`
    MuchLess,
    /// `\gg`
    MuchGreater,
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
