//! What a page begins with, and is no law: identities, and what the text has settled already.

use crate::algebra::{Expr, Formula, LimitPoint, Symbol};
use crate::derivation::{Assumed, Source};
use crate::sorted::Set;

use super::stated::{is_slip, quantities};
use super::{Entry, Judged, Outcome};

/// Whether a statement that is not proved is no law: it is an identity, or what is left open is said to follow, and what is supposed says
/// all that it speaks of.
pub(super) fn is_step(entry: &Entry, told: &[Assumed], drawn: bool) -> bool {
    let open =
        |judged: &Judged| matches!(judged.outcome, Outcome::Open(_)) && is_settled(judged, told);
    is_identity(entry, told, drawn) || drawn && entry.judged.iter().any(open)
}

/// Whether a refuted statement is no law: it speaks of nothing, or it is an identity that the pen slipped on, or, where words say that
/// it follows (`drawn`) or its chain does, what is supposed says all that it speaks of. Both sides of an identity speak of the same; and
/// either one edit makes it true, or that is whole numbers alone, or something is worked out.
pub(super) fn is_identity(entry: &Entry, told: &[Assumed], drawn: bool) -> bool {
    entry.refuted().is_some_and(|(judged, refuted)| {
        let Formula::Relation { left, right, .. } = &judged.goal.formula else {
            return false;
        };
        // `\frac{\partial}{\partial r} (r^2 u) = r u` may say what `u` is.
        if !drawn && (may_be_a_law(left) || may_be_a_law(right)) {
            return false;
        }
        let (named, others) = (quantities(left), quantities(right));
        let counted = |symbol: &Symbol| {
            let domain = refuted.claim().domains.get(symbol);
            domain.is_some_and(|domain| domain.integer)
        };
        let same = !named.is_empty() && named == others;
        let goes_on = (entry.judged.first()).is_none_or(|first| !std::ptr::eq(first, judged));
        let works =
            is_slip(entry) || named.iter().all(counted) || is_worked_out(left, right, drawn);
        same && works
            || is_closed(left) && is_closed(right)
            || is_measured(left) && is_measured(right)
            || is_equivalence(judged)
            || (drawn || goes_on) && is_settled(judged, told)
    })
}

/// Whether something is differentiated partially that speaks of more than the variable, and is no name.
fn may_be_a_law(term: &Expr) -> bool {
    term.any(&|part| match part {
        Expr::Partial { body, .. } => {
            let named = matches!(
                **body,
                Expr::Symbol(_) | Expr::Apply(..) | Expr::Partial { .. }
            );
            !named && body.free_symbols().len() > 1
        }
        _ => false,
    })
}

/// Whether it is a side of an equivalence whose other side speaks of all that it does.
fn is_equivalence(judged: &Judged) -> bool {
    let supposed = judged.goal.suppositions.iter();
    let supposed: Set<Symbol> = supposed.flat_map(spoken_of).collect();
    !supposed.is_empty() && spoken_of(&judged.goal.formula).is_subset(&supposed)
}

/// Whether a term has one value and no other.
fn is_closed(term: &Expr) -> bool {
    let open = |part: &Expr| matches!(part, Expr::Apply(..) | Expr::Element { .. });
    term.free_symbols().is_empty() && !term.any(&open)
}

/// Whether a term is a number of units.
fn is_measured(term: &Expr) -> bool {
    let named = term.free_symbols();
    !named.is_empty() && named.iter().all(Symbol::is_unit)
}

/// Whether one of two terms is what the other comes to, and speaks of nothing else.
pub(super) fn is_carried_out(left: &Expr, right: &Expr, drawn: bool) -> bool {
    let (named, others) = (quantities(left), quantities(right));
    let within = match is_task(left) || is_limit(left) {
        true => others.is_subset(&named),
        false => named.is_subset(&others),
    };
    let applied = |side: &Expr| side.any(&|part| matches!(part, Expr::Apply(..)));
    let limit = (is_limit(left) || is_limit(right)) && !applied(left) && !applied(right);
    within && (limit || is_worked_out(left, right, drawn))
}

/// Whether a term is a limit of what varies: a value at a place may be a condition on the place.
fn is_limit(term: &Expr) -> bool {
    use LimitPoint::{MinusInfinity, PlusInfinity};
    let Expr::Limit {
        body,
        variable,
        point: PlusInfinity | MinusInfinity,
    } = term
    else {
        return false;
    };
    body.mentions(variable)
}

/// Whether one of two terms is what the other comes to: a slope, an integral or a sum of what is written out, or a product that is
/// multiplied out.
fn is_worked_out(left: &Expr, right: &Expr, drawn: bool) -> bool {
    let sides = [(left, right), (right, left)];
    sides.into_iter().any(|(from, to)| {
        // `\frac{d}{dx} (x y) = y` may say what `y` is.
        let derived = matches!(from, Expr::Derivative { .. } | Expr::Partial { .. });
        let alone = !derived || from.free_symbols().len() == 1;
        let carried_out = (drawn || alone) && is_task(from) && !to.any(&is_task);
        carried_out || drawn && is_product_of_sums(from) && is_multiplied_out(to)
    })
}

/// What has to be carried out, and is written out: in the term is what it varies with, and no function or sequence that is not known.
fn is_task(term: &Expr) -> bool {
    let (body, variable) = match term {
        Expr::Derivative { body, variable }
        | Expr::Partial {
            body,
            variable,
            held: Some(_),
        }
        | Expr::Integral { body, variable, .. } => (body, variable),
        Expr::Series { body, index, .. } => (body, index),
        Expr::Negate(inner) => return is_task(inner),
        _ => return false,
    };
    let unknown = |part: &Expr| {
        matches!(
            part,
            Expr::Apply(..) | Expr::Element { .. } | Expr::Derivative { .. }
        )
    };
    body.mentions(variable) && !body.any(&unknown)
}

/// `(a + b)^2`, `(a + b)(a - b)`.
fn is_product_of_sums(term: &Expr) -> bool {
    match term {
        Expr::Power(base, exponent) => {
            matches!((&**base, &**exponent), (Expr::Sum(_), Expr::Number(n)) if n.is_integer())
        }
        Expr::Product(factors) => factors.iter().all(|own| matches!(own, Expr::Sum(_))),
        _ => false,
    }
}

/// A sum in which no sum is multiplied, of several quantities.
fn is_multiplied_out(term: &Expr) -> bool {
    let inner = |part: &Expr| matches!(part, Expr::Sum(_) | Expr::Quotient(..));
    match term {
        Expr::Sum(terms) => {
            term.free_symbols().len() > 1 && !terms.iter().any(|own| own.any(&inner))
        }
        _ => false,
    }
}

/// Whether what is supposed or told in passing defines something that a statement speaks of, and speaks of all that it does: after
/// "Let $y = x^2$" nothing more is to be said of $y$ and $x$.
fn is_settled(judged: &Judged, told: &[Assumed]) -> bool {
    let supposed = judged.assumed.iter().chain(told);
    let supposed = supposed.filter(|own| matches!(own.source, Source::Local(..)));
    let (mut defined, mut named) = (Set::new(), Set::new());
    for own in supposed {
        if let Some((Expr::Symbol(name) | Expr::Apply(name, _), _)) = own.formula.as_equation() {
            defined.insert(name.clone());
        }
        named.append(&mut spoken_of(&own.formula));
    }
    let own = spoken_of(&judged.goal.formula);
    own.iter().any(|symbol| defined.contains(symbol)) && own.iter().all(|own| named.contains(own))
}

/// The symbols, sequences and functions of a formula.
pub(super) fn spoken_of(formula: &Formula) -> Set<Symbol> {
    let mut found = formula.names();
    found.extend(Formula::applied_in(formula.terms()));
    found
}
