//! Approximations: "For $u \ll c$, $$E \approx m c^2 + \frac12 m u^2$$", "to first order in $x$", "For small $x$".
//!
//! What is printed on the right is a sum of powers of what is small, and is meant up to the highest that is printed: the left side, by what
//! stands before, must have the same series up to there. With `x/N` for a small `x` that is said exactly: `N^k` times the difference goes to
//! 0 as `N` grows, for each order `k`. The kernel decides these limits.
//!
//! It fails only where nobody can take it otherwise: where all that may be small has been tried, and in one order something is printed that is
//! not there, or with another number. Where something is missing, it may be small, too: `\frac{a + b}{1 + a b} \approx a + b`.

use num_traits::ToPrimitive;

use crate::algebra::{
    Atom, Atoms, BigRational, Expr, Formula, Fraction, LimitPoint, Lowering, Monomial, Rational,
    Relation, Symbol,
};
use crate::derivation::{Approach, Assumed, Goal, Source, sizes};

use super::super::Outcome;
use super::super::judge::{Found, Judge, sources};
use super::super::premise::ends_of_chains;
use super::limiting::written_out;
use crate::sorted::Set;

/// So many symbols may be what is small where the text does not say what is.
const MOST_CANDIDATES: usize = 6;
/// More orders than this are not compared.
const MOST_ORDERS: i64 = 8;
/// What grows: a name that no author uses.
const GROWING: &str = "\\mathcal{N}";

/// Whether it says of an approximation that it holds up to an order. That is no premise: it says nothing of any value.
pub(in crate::audit) fn is_of_expansion(formula: &Formula) -> bool {
    let sides = formula.as_equation();
    sides.is_some_and(|(limit, _)| limit.binder().is_some_and(|own| own.name() == GROWING))
}

/// What becomes of an approximation in one way to read it.
enum Reading {
    Holds(Box<Found>),
    /// Whether that can only be a slip.
    Fails(Box<Found>, bool),
    Open,
}

/// An approximation with its left side written out.
struct Written {
    left: Expr,
    right: Expr,
    /// What was put in.
    used: Vec<Assumed>,
}

impl Judge<'_> {
    /// What becomes of an approximation that may be the beginning of a series.
    pub(in crate::audit) fn by_expansion(&self, goal: &Goal, premises: &[usize]) -> Option<Found> {
        let Formula::Relation {
            left,
            relation: Relation::Approximately,
            right,
        } = &goal.formula
        else {
            return None;
        };
        let of_case: Vec<Vec<Approach>> = goal.suppositions.iter().map(sizes).collect();
        if of_case.iter().any(Vec::is_empty) {
            return None;
        }
        let told: Vec<Vec<Approach>> = self.derivation.expanded_in(self.at);
        let told: Vec<Vec<Approach>> = told.into_iter().chain(of_case).collect();
        let said = self.derivation.told(self.at);
        let own = self.usable.assumed.iter().chain(&said);
        let cited: Vec<&Assumed> = own.collect();
        let others = self.others(premises).iter().flatten();
        let all: Vec<&Assumed> = cited.iter().copied().chain(others).collect();
        let mut failing = None;
        for (is_cited, from) in [(true, &cited), (false, &all)] {
            // What the right side speaks of is meant to stay, and what speaks of nothing else is put in before other things: the end of a chain.
            let kept = right.free_symbols();
            let ends = ends_of_chains(from.iter().copied(), |_| true);
            let from: Vec<&Assumed> = from.iter().copied().chain(&ends).collect();
            let speaks_of_these = |value: &Expr| value.free_symbols().is_subset(&kept);
            let (body, used) = written_out(left, &kept, &from, &speaks_of_these);
            let written = Written {
                left: body,
                right: right.clone(),
                used,
            };
            if !is_cited && written.used.iter().all(|own| cited.contains(&own)) {
                break;
            }
            // What is expanded by name is expanded as it is, whatever is so elsewhere.
            let around = match is_cited && self.names_its_premises() {
                true => &cited,
                false => &all,
            };
            match self.in_readings(goal, &written, &told, around) {
                Reading::Holds(mut found) => {
                    if !is_cited {
                        found.instead = sources(&written.used);
                    }
                    return Some(*found);
                }
                Reading::Fails(found, true) => failing = failing.or(Some(*found)),
                Reading::Fails(_, false) | Reading::Open => {}
            }
        }
        failing
    }

    /// All ways to take what is small: one in which it holds is meant, and it fails only if it does in all.
    fn in_readings(
        &self,
        goal: &Goal,
        written: &Written,
        told: &[Vec<Approach>],
        all: &[&Assumed],
    ) -> Reading {
        let Written { left, right, .. } = written;
        // What was told to be small before something else was expanded is nothing of this.
        let is_of_this = |own: &&Vec<Approach>| {
            let mut own = own.iter().map(|own| &own.variable);
            own.any(|variable| left.mentions(variable) || right.mentions(variable))
        };
        let told: Vec<&Vec<Approach>> = told.iter().filter(is_of_this).collect();
        let candidates: Vec<Approach> = match told.is_empty() {
            false => told.iter().copied().flatten().cloned().collect(),
            true => {
                let all = right.free_symbols();
                // Where it is one of several of its kind, `m_1 + m_2 - m_{12}`, all of them are, or what they differ by.
                let is_one_of_many = |own: &Symbol| {
                    let stem = |of: &Symbol| of.without_subscript().unwrap_or(of.clone());
                    let alike = |other: &Symbol| other != own && stem(other) == stem(own);
                    own.without_subscript().is_some() && all.iter().any(alike)
                };
                let names = all.iter().filter(|&own| {
                    let is_quantity = !own.is_unit() && !is_one_of_many(own);
                    is_quantity && may_be_small(left, right, own)
                });
                let names = names.cloned();
                let both = |own: Symbol| [Approach::vanishing(own.clone()), Approach::growing(own)];
                names.take(MOST_CANDIDATES).flat_map(both).collect()
            }
        };
        let (mut failing, mut is_open) = (None, told.len() > 1);
        for approach in &candidates {
            if !left.mentions(&approach.variable) {
                continue;
            }
            let is_small = matches!(approach.point, LimitPoint::Finite(_));
            let is_certain =
                !told.is_empty() || is_small && self.derivation.speaks_of_what_is_small(self.at);
            match self.in_reading(goal, written, approach, all, is_certain) {
                own @ Reading::Holds(_) => return own,
                Reading::Fails(found, true) => failing = failing.or(Some(found)),
                // What nobody said need not be meant.
                Reading::Fails(_, false) => is_open |= !told.is_empty(),
                Reading::Open => is_open |= !told.is_empty(),
            }
        }
        match failing {
            Some(found) if !is_open => Reading::Fails(found, true),
            _ => Reading::Open,
        }
    }

    /// The approximation where one thing goes to 0 or beyond all bounds.
    fn in_reading(
        &self,
        goal: &Goal,
        written: &Written,
        approach: &Approach,
        all: &[&Assumed],
        is_certain: bool,
    ) -> Reading {
        let Written { left, right, used } = written;
        let variable = &approach.variable;
        let steps: &[i64] = match left.any(&Expr::is_root) || right.any(&Expr::is_root) {
            true => &[1, 2],
            false => &[1],
        };
        for &step in steps {
            let step = match approach.point {
                LimitPoint::PlusInfinity => -step,
                _ => step,
            };
            let Some(graded) = graded(right, variable, step) else {
                continue;
            };
            let orders = graded.iter().map(|(order, _)| *order);
            let (Some(first), Some(last)) = (orders.clone().min(), orders.max()) else {
                continue;
            };
            if last - first > MOST_ORDERS || last.abs() > MOST_ORDERS {
                continue;
            }
            let growing = Symbol::new(GROWING);
            let scaled = |term: &Expr| {
                let by = raised(&growing, -step);
                let value = Expr::Product([Expr::Symbol(variable.clone()), by].into());
                term.substitute(variable, &value)
            };
            let difference = difference(&scaled(left), &scaled(right));
            let compared = |order: i64, value: Expr| {
                let body = Expr::Product([raised(&growing, order), difference.clone()].into());
                let limit = Expr::Limit {
                    body: body.into(),
                    variable: growing.clone(),
                    point: LimitPoint::PlusInfinity,
                };
                Formula::equal(limit, value)
            };
            let kept: Vec<Assumed> = (self.usable.assumed.iter())
                .filter(|own| !own.formula.names().contains(variable) && !is_near(&own.formula))
                .cloned()
                .collect();
            let kept = speaking_of(kept, left.free_symbols());
            let goal = Goal {
                suppositions: Vec::new(),
                ..goal.clone()
            };
            let moved = Approach::growing(growing.clone());
            let judged =
                |formula: Formula| self.judged_as_limit(&goal, formula, &kept, used, &moved);
            let nothing = || Expr::integer(0);
            let whole = compared(last, nothing());
            if has_values(&whole)
                && let found = judged(whole)
                && found.judged.outcome.is_proven()
            {
                return Reading::Holds(found.into());
            }
            for order in first..=last {
                let of_order = compared(order, nothing());
                if !has_values(&of_order) {
                    return Reading::Open;
                }
                let found = judged(of_order);
                match found.judged.outcome {
                    Outcome::Proven(_) => {}
                    Outcome::Refuted(_) => {
                        let of_order = graded.iter().filter(|(own, _)| *own == order);
                        let of_order: Vec<Expr> = of_order.map(|(_, own)| own.clone()).collect();
                        let (Some(printed), Formula::Relation { left: limit, .. }) =
                            (sum_of(of_order), &found.judged.goal.formula)
                        else {
                            return Reading::Open;
                        };
                        // Where several orders are printed and the first ones are right, they say what is small.
                        let is_meant = is_certain || order > first;
                        let has_other_number = || {
                            other_number(limit, &printed).is_some_and(|times| {
                                let times = Expr::Number(times);
                                let value = Expr::Product([times, printed.clone()].into());
                                judged(compared(order, value)).judged.outcome.is_proven()
                            })
                        };
                        let is_slip = is_meant
                            && self.is_spoken_out(written, approach, all)
                            && (has_other_number() || has_wrong_term(limit, &printed));
                        return Reading::Fails(found.into(), is_slip);
                    }
                    _ => return Reading::Open,
                }
            }
        }
        Reading::Open
    }

    /// Whether nothing is left that may depend on what is small, or be written otherwise, and no number in it is rounded.
    fn is_spoken_out(&self, written: &Written, approach: &Approach, all: &[&Assumed]) -> bool {
        let Written { left, right, used } = written;
        let known = right.free_symbols();
        let own = left_when_cancelled(left).unwrap_or_else(|| left.free_symbols());
        let is_constant = |own: &Symbol| own.is_unit() || own.name() == "\\pi";
        // A chain goes on with what it began with, and ties nothing: `V = V_s (\frac{1 + x}{2 + x} - \frac12) = \frac{V_s}{4} \frac{x}{1 + x/2}`.
        let goes_on = |own: &Assumed| {
            let is_equation = matches!(own.source, Source::Equation(_));
            is_equation && used.iter().any(|used| used.source == own.source)
        };
        let ties = |own: &&Assumed| {
            let names = own.formula.names();
            let is_of_both = |name: &Symbol| known.contains(name) || is_constant(name);
            own.formula.as_equation().is_some()
                && names.contains(&approach.variable)
                && names.len() > 1
                && names.iter().all(is_of_both)
                && !used.contains(own)
                && !goes_on(own)
        };
        own.iter()
            .all(|own| known.contains(own) || is_constant(own) || *own == approach.variable)
            && !may_be_rounded(left)
            && !may_be_rounded(right)
            && !all.iter().any(ties)
            && self.approximations().is_empty()
    }
}

/// What speaks of some symbols, or of what others that do speak of: the rest says nothing of them.
fn speaking_of(mut all: Vec<Assumed>, mut names: Set<Symbol>) -> Vec<Assumed> {
    let mut kept = Vec::new();
    loop {
        let before = kept.len();
        kept.extend(all.extract_if(.., |own| !own.formula.names().is_disjoint(&names)));
        if kept.len() == before {
            return kept;
        }
        names.extend(kept[before..].iter().flat_map(|own| own.formula.names()));
    }
}

/// The summands of a term with their orders in what is small, where each has one: `m u^2/2` is of order 2 in `u`. With `step` 2 that is in
/// the root of `u`, and negative in what is large.
fn graded(term: &Expr, variable: &Symbol, step: i64) -> Option<Vec<(i64, Expr)>> {
    if !term.mentions(variable) {
        return Some(vec![(0, term.clone())]);
    }
    let single = |term: &Expr| match &graded(term, variable, step)?[..] {
        [(order, _)] => Some(*order),
        _ => None,
    };
    match term {
        Expr::Symbol(_) => Some(vec![(step, term.clone())]),
        Expr::Sum(terms) => {
            let all: Option<Vec<_>> = (terms.iter())
                .map(|own| graded(own, variable, step))
                .collect();
            Some(all?.into_iter().flatten().collect())
        }
        Expr::Negate(inner) => {
            let all = graded(inner, variable, step)?.into_iter();
            Some(
                all.map(|(order, own)| (order, Expr::Negate(own.into())))
                    .collect(),
            )
        }
        Expr::Product(factors) => {
            let mut whole: Vec<(i64, Vec<Expr>)> = vec![(0, Vec::new())];
            for factor in factors.iter() {
                let own = graded(factor, variable, step)?;
                // Of two sums nobody says which of their products are meant.
                if whole.len() > 1 && own.len() > 1 && factor.mentions(variable) {
                    return None;
                }
                let joined = whole.iter().flat_map(|(order, before)| {
                    own.iter().map(move |(other, factor)| {
                        let all = before.iter().chain([factor]).cloned().collect();
                        (order + other, all)
                    })
                });
                whole = joined.collect();
            }
            let product = |own: Vec<Expr>| Expr::Product(own.into());
            Some(
                whole
                    .into_iter()
                    .map(|(order, own)| (order, product(own)))
                    .collect(),
            )
        }
        Expr::Quotient(above, below) => {
            let order = single(below)?;
            let all = graded(above, variable, step)?.into_iter();
            let divided = |own: Expr| Expr::Quotient(own.into(), below.clone());
            Some(
                all.map(|(own, above)| (own - order, divided(above)))
                    .collect(),
            )
        }
        Expr::Power(base, exponent) => {
            let Expr::Number(exponent) = &**exponent else {
                return None;
            };
            let order = exponent * BigRational::from_integer(single(base)?.into());
            let order = order.is_integer().then(|| order.to_i64())??;
            Some(vec![(order, term.clone())])
        }
        _ => None,
    }
}

/// Whether a symbol may be what is small where nothing says so: the left side is no sum of powers of it, or of just those, several, that the
/// right side is.
fn may_be_small(left: &Expr, right: &Expr, symbol: &Symbol) -> bool {
    let orders = |term: &Expr| -> Option<Set<i64>> {
        let graded = graded(term, symbol, 1)?.into_iter();
        Some(graded.map(|(order, _)| order).collect())
    };
    left.mentions(symbol)
        && match orders(left) {
            None => true,
            Some(own) => own.len() > 1 && orders(right) == Some(own),
        }
}

/// By which number what is printed differs from what it should be, as a part of that.
fn other_number(limit: &Expr, printed: &Expr) -> Option<BigRational> {
    let mut atoms = Atoms::default();
    let mut lowering = Lowering::plain(&mut atoms);
    let of_both = Expr::Quotient(limit.clone().into(), printed.clone().into());
    let times = lowering.lower(&of_both).ok()?.as_constant()?.to_big();
    // Where nothing is left of it the whole order is missing.
    let nothing = BigRational::from_integer((-1).into());
    (times != nothing).then_some(times)
}

/// Whether a number in a term may be rounded: in no exponent, `\sqrt{x}`.
fn may_be_rounded(term: &Expr) -> bool {
    match term {
        Expr::Number(number) => !number.is_integer(),
        Expr::Power(base, exponent) if matches!(**exponent, Expr::Number(_)) => {
            may_be_rounded(base)
        }
        _ => term.children().any(may_be_rounded),
    }
}

/// Whether a formula says no more than that something is near something else, or much less.
fn is_near(formula: &Formula) -> bool {
    use Relation::{Approximately, MuchGreater, MuchLess};
    matches!(
        formula,
        Formula::Relation {
            relation: Approximately | MuchLess | MuchGreater,
            ..
        }
    )
}

/// Whether both sides have values that can be told, under conditions.
fn has_values(formula: &Formula) -> bool {
    let mut atoms = Atoms::default();
    let mut lowering = Lowering::plain(&mut atoms);
    let all = formula.terms().into_iter();
    all.map(|term| lowering.lower(term)).all(|own| own.is_ok())
        && lowering.conditions.doubtful.is_empty()
}

/// Whether a summand is printed that is not there, or with another number. What is compared is printed in symbols alone.
fn has_wrong_term(limit: &Expr, printed: &Expr) -> bool {
    let mut atoms = Atoms::default();
    let mut lowering = Lowering::plain(&mut atoms);
    let mut lower = |term: &Expr| {
        let value = lowering.lower(term).ok()?;
        let is_sum_of_powers = value.denominator().all(|(factor, _)| factor.len() == 1);
        is_sum_of_powers.then_some(value)
    };
    let there = Expr::Sum([limit.clone(), printed.clone()].into());
    let (Some(there), Some(printed)) = (lower(&there), lower(printed)) else {
        return false;
    };
    let over = |one: &Fraction, other: &Fraction| {
        let below = other.expanded_denominator().ok()?;
        one.numerator().times(&below).ok()
    };
    let (Some(own), Some(shown)) = (over(&there, &printed), over(&printed, &there)) else {
        return false;
    };
    let vars = own.vars().into_iter().chain(shown.vars());
    let is_plain = vars
        .into_iter()
        .all(|var| matches!(atoms.atom(var), Atom::Symbol(_)));
    let is_there = |monomial: &Monomial, number: &Rational| {
        let mut terms = own.terms();
        terms.any(|(other, own)| other == monomial && own == number)
    };
    is_plain && !own.is_zero() && shown.terms().any(|(own, number)| !is_there(own, number))
}

/// The symbols that are left of a term when what is above and below a stroke is cancelled: `f` goes out of `\frac{f (c + u)/c}{f}`.
fn left_when_cancelled(term: &Expr) -> Option<Set<Symbol>> {
    let mut atoms = Atoms::default();
    let value = Lowering::plain(&mut atoms).lower(term).ok()?;
    let below = value.denominator().flat_map(|(factor, _)| factor.vars());
    let vars = value.numerator().vars().into_iter().chain(below);
    let mut symbols = Set::new();
    for var in vars {
        match atoms.atom(var) {
            Atom::Symbol(own) | Atom::Root { of: own, .. } => {
                symbols.insert(own.clone());
            }
            Atom::Opaque(term) => symbols.extend(term.free_symbols()),
            _ => return None,
        }
    }
    Some(symbols)
}

fn sum_of(mut terms: Vec<Expr>) -> Option<Expr> {
    match terms.len() {
        0 => None,
        1 => terms.pop(),
        _ => Some(Expr::Sum(terms.into())),
    }
}

fn difference(one: &Expr, other: &Expr) -> Expr {
    Expr::Sum([one.clone(), Expr::Negate(other.clone().into())].into())
}

fn raised(symbol: &Symbol, exponent: i64) -> Expr {
    Expr::Power(
        Expr::Symbol(symbol.clone()).into(),
        Expr::integer(exponent).into(),
    )
}
