//! The two things that an ill-dimensioned equation compares: which they are, which is guilty, where they stand.

use crate::algebra::{Expr, Formula};
use crate::derivation::Source;
use crate::dimension::Conflict;
use crate::document::Span;
use crate::kernel::dimension::{Comparison, Form, Member, Part, What, comparisons};
use crate::notation::{Clause, Side, Statement, plain};

use super::super::words::shortened;

/// The widest that a term may be beside its dimension.
const WIDEST_TERM: usize = 28;

/// One of the two things that differ.
pub(super) struct Thing {
    /// `the left side`, `` `m v` ``.
    pub words: String,
    /// `left`, `` `m v` ``.
    pub label: String,
    pub form: Form,
    pub path: Option<Vec<usize>>,
}

/// What is guilty, and what it is held against.
pub(super) fn things(conflict: &Conflict<Source>) -> (Thing, Thing) {
    let (first, second) = in_order(conflict);
    match conflict.evidence.comparison().what {
        What::Sides => (second, first),
        What::Summands if reference_is_guilty(conflict) => (second, first),
        _ => (first, second),
    }
}

/// The two things in the order of the comparison.
pub(super) fn in_order(conflict: &Conflict<Source>) -> (Thing, Thing) {
    let formula = &conflict.evidence.parts()[0].formula;
    let Comparison { what, left, right } = conflict.evidence.comparison();
    let thing = |member: &Member, side: &str| {
        let (words, label) = match what {
            What::Sides => (format!("the {side} side"), side.to_owned()),
            _ => {
                let term = term_at(formula, &member.path)
                    .map(plain)
                    .unwrap_or_default();
                let term = format!("`{}`", shortened(&term, WIDEST_TERM));
                (term.clone(), term)
            }
        };
        Thing {
            words,
            label,
            form: member.form.clone(),
            path: Some(member.path.clone()),
        }
    };
    let second = match right {
        Some(right) if *what == What::Limit => Thing {
            words: "the variable".into(),
            label: "the variable".into(),
            form: right.form.clone(),
            path: None,
        },
        Some(right) => thing(right, "right"),
        None => Thing {
            words: "a pure number".into(),
            label: "needed".into(),
            form: Form::default(),
            path: None,
        },
    };
    (thing(left, "left"), second)
}

/// `` `w` beside `1` ``
pub(super) fn compared(part: &Part) -> String {
    let all = comparisons(&part.formula, &part.scope);
    let member = |member: &Member| term_at(&part.formula, &member.path).map(plain);
    let comparison = all.get(part.comparison);
    let left = comparison.and_then(|c| member(&c.left)).unwrap_or_default();
    match comparison.and_then(|c| c.right.as_ref()).and_then(member) {
        Some(right) => format!("`{left}` beside `{right}`"),
        None => format!("`{left}` must be a pure number"),
    }
}

/// Whether it is rather the summand that all others were compared with: two or more agree against it, or the other
/// side of the equation does.
fn reference_is_guilty(conflict: &Conflict<Source>) -> bool {
    let part = &conflict.evidence.parts()[0];
    let Comparison {
        left,
        right: Some(right),
        ..
    } = conflict.evidence.comparison()
    else {
        return false;
    };
    let all = comparisons(&part.formula, &part.scope);
    let known = |form: &Form| form.known == left.form.known;
    let sum = &right.path[..right.path.len().saturating_sub(1)];
    let Some(Expr::Sum(items)) = term_at(&part.formula, sum) else {
        return false;
    };
    let against = all.iter().filter(|c| {
        c.what == What::Summands && c.right.as_ref().is_some_and(|r| r.path == right.path)
    });
    let against = against.filter(|c| known(&c.left.form)).count();
    let others = against + 1 == items.len() && against > 1;
    let side = all.iter().any(|c| {
        let member = |m: &Member| m.path != sum && known(&m.form);
        c.what == What::Sides
            && sum.len() == 1
            && (member(&c.left) || c.right.as_ref().is_some_and(member))
    });
    others || side
}

fn term_at<'a>(formula: &'a Formula, path: &[usize]) -> Option<&'a Expr> {
    let (side, steps) = path.split_first()?;
    let mut term = formula.terms().into_iter().nth(*side)?;
    for step in steps {
        term = term.children().nth(*step)?;
    }
    Some(term)
}

/// Where a term of the `reading`-th formula of a statement stands: the whole summand that it is part of.
pub(super) fn place(statement: &Statement, reading: usize, path: &[usize]) -> Option<Span> {
    let mut sides: Vec<(Option<&Side>, Option<&Side>, Span)> = Vec::new();
    for clause in statement.clauses.iter().chain(&statement.under) {
        match clause {
            Clause::Chain { sides: all, links } => {
                let pairs = links.iter().zip(all.windows(2));
                sides.extend(pairs.map(|(link, pair)| (pair.first(), pair.last(), link.span)));
            }
            Clause::AllEqual { value, span, .. } => sides.push((None, value.as_ref(), *span)),
        }
    }
    let (left, right, whole) = sides.get(reading)?;
    let side = match path.first() {
        Some(0) => *left,
        Some(_) => *right,
        None => None,
    };
    let Some(side) = side else {
        return Some(*whole);
    };
    let summand = match (&side.expr, path.get(1)) {
        (Expr::Sum(_), Some(at)) => side.terms.get(*at).copied(),
        _ => None,
    };
    Some(summand.unwrap_or(side.span))
}
