//! Solutions of laws of change of which the text tells a value at a place: `w = \frac{a}{2} (x^2 - b^2)` from `\frac{dw}{dx} = a x`, "with
//! $w = 0$ at $x = b$".
//!
//! What both sides differ by does not change, by itself or times an exponential, and it is 0 at the place; then it is 0 everywhere. A law by itself leaves open which solution
//! is meant, so a point on it refutes none: what refutes one is that it does not obey the law, or has another value there.

use crate::algebra::{
    Expr, Formula, Function, LimitPoint, Symbol, effort, product_of, split_subscript,
};
use crate::derivation::{Assumed, ConditionSaid, Goal, Source};
use crate::kernel::Standing;
use crate::search::{self, Decision, Effort};

use super::super::constant::OF_INTEGRATION;
use super::super::judge::{Found, Judge, step};

/// Why it is left open whether it is the solution that is meant.
const UNDECIDED: &str = "it may be the solution with the values that the text tells at one place";

/// So much work is done to see whether one term does not change: what was tried before may have left nothing.
const MOST_WORK: u64 = 1_000_000;
/// More exponentials than these are not tried.
const MOST_EXPONENTS: usize = 3;

impl Judge<'_> {
    /// What to say of a step that does not follow from laws of change alone, where the text tells the value at a place of something that it
    /// speaks of.
    pub(in crate::audit) fn as_solution(
        &self,
        goal: &Goal,
        premises: &[usize],
        found: &Found,
    ) -> Option<Found> {
        if !goal.is_said_outright() {
            return None;
        }
        let said = self.derivation.conditions_said(self.at);
        self.as_integrated_twice(goal, premises, found, &said)
            .or_else(|| self.as_solution_where(goal, premises, found, said))
    }

    /// The same with what the text tells at places.
    pub(super) fn as_solution_where(
        &self,
        goal: &Goal,
        premises: &[usize],
        found: &Found,
        said: Vec<ConditionSaid>,
    ) -> Option<Found> {
        let (left, right) = goal.formula.as_equation()?;
        // To look for the variable is to look through the page.
        let (right, own) = with_own_value_named(left, right);
        let is_told = !said.is_empty() || own.is_some() || self.starts_from_rest();
        if !is_told && bounds(&goal.formula).is_empty() {
            return None;
        }
        let variable = self.variable_between(left, &right)?;
        if own.is_some_and(|own| own != variable) {
            return None;
        }
        let conditions = self.met_where_it_begins(said, goal, &variable);
        if conditions.is_empty() {
            return None;
        }
        // The law may stand farther before.
        let near = self.others(premises)[0].iter();
        let throughout = self.usable.assumed.iter().chain(near);
        let throughout = throughout.filter(|own| own.standing == Standing::Identity);
        let (mut laws, others): (Vec<&Assumed>, Vec<&Assumed>) =
            throughout.partition(|own| own.formula.speaks_of_slopes());
        let is_subject = |name: &Symbol| conditions.iter().any(|own| own.0.of.mentions(name));
        laws.retain(|law| law.formula.names().iter().any(is_subject));
        if laws.is_empty() {
            return None;
        }
        // What is written in another form by what says already what it is needs no law.
        let is_given = |own: &Assumed| {
            let names = own.formula.names();
            matches!(own.source, Source::Equation(_))
                && !own.formula.speaks_of_slopes()
                && !own.formula.speaks_of_values()
                && names.contains(&variable)
                && names.iter().any(is_subject)
        };
        let difference = Expr::Sum([left.clone(), Expr::Negate(right.into())].into());
        let kept = possibly_kept(difference, goal, &laws, &variable);
        let mut fixed: Vec<Assumed> = others.iter().copied().cloned().collect();
        fixed.retain(|own| self.is_fixed(own, &conditions, &variable));
        let mut is_refuted = true;
        for (said, there) in &conditions {
            let claim = self.derivation.claim(self.at, &fixed, there);
            // What the step divides by anywhere is not 0 there either.
            let divided = || {
                self.pose(&[], there).is_ok_and(|bare| {
                    search::missing_conditions(&bare, None, Effort::Light, &[]).is_some()
                })
            };
            if search::prove_unconditionally(claim.clone(), Effort::Light).is_some() || divided() {
                let mut kept = kept.iter();
                if let Some(mut own) = kept.find_map(|kept| self.keeps(goal, kept, premises)) {
                    if !matches!(said.value, Expr::Limit { .. }) {
                        let there = step(&value_there(said, &variable));
                        own.judged.assumed.push(there);
                    }
                    // That it does not change is no condition.
                    let speaks = |own: &Formula| {
                        let mut terms = own.terms().into_iter();
                        terms.any(|term| term.any(&|part| *part == value_of_its_own()))
                    };
                    own.conditions.retain(|own| !speaks(own));
                    own.constant
                        .retain(|own| Expr::Symbol(own.clone()) != value_of_its_own());
                    own.judged.assumed.retain(|own| !speaks(&own.formula));
                    return Some(own);
                }
            }
            let decision = search::decide(claim, &self.auditor.hints());
            // Of several values it need have one.
            is_refuted &= matches!(decision, Decision::Refuted(_));
        }
        if !is_told
            || is_refuted
            || !found.judged.outcome.is_refuted()
            || found.judged.assumed.iter().any(is_given)
            || self.breaks(goal, &laws, &others)
        {
            return None;
        }
        let mut own = Found::open(found.judged.clone());
        own.leave_open(UNDECIDED);
        Some(own)
    }

    /// What the text tells at places of what a solution speaks of, that it starts from rest, and what it says of its own value at a place.
    pub(super) fn met_where_it_begins(
        &self,
        mut said: Vec<ConditionSaid>,
        goal: &Goal,
        variable: &Symbol,
    ) -> Vec<(ConditionSaid, Formula)> {
        let sides = goal.formula.as_equation();
        if self.starts_from_rest() {
            said.extend(sides.and_then(|(left, _)| at_rest(left, variable)));
        }
        let mut bounds = where_bounds_meet(&goal.formula, variable);
        // Where the text tells when it has a value, that is what the bound says.
        bounds.retain(|own| {
            let moves = |of: &Symbol| self.auditor.changes(self.at, of, variable);
            let is_told = |other: &ConditionSaid| other.just_said && other.of == own.of;
            matches!(&own.of, Expr::Symbol(of) if moves(of)) && !said.iter().any(is_told)
        });
        said.extend(bounds);
        let mut conditions = met(said, goal, variable);
        let own = sides.and_then(|(left, right)| own_value(left, right));
        conditions.extend(own);
        conditions
    }

    /// Whether the sentence before the step says that something starts from rest. "The rest follows from" does not.
    fn starts_from_rest(&self) -> bool {
        let said = self.derivation.leading(self.at).unwrap_or_default();
        let mut words = said
            .split(|c: char| !c.is_alphabetic())
            .filter(|own| !own.is_empty());
        let mut before = "";
        words.any(|word| std::mem::replace(&mut before, word) == "from" && word == "rest")
    }

    /// Whether a term that is 0 where a goal is met does not change.
    fn keeps(&self, goal: &Goal, term: &Expr, premises: &[usize]) -> Option<Found> {
        let constant = Symbol::new(OF_INTEGRATION);
        let assumed = self.usable.assumed.clone();
        effort::within(MOST_WORK, || {
            self.where_constant(goal, (term.clone(), &constant), assumed, premises)
        })
    }

    /// Whether a premise says nothing of what varies.
    fn is_fixed(
        &self,
        own: &Assumed,
        conditions: &[(ConditionSaid, Formula)],
        variable: &Symbol,
    ) -> bool {
        let names = own.formula.names();
        let moves = |name: &Symbol| {
            let mut subjects = conditions.iter();
            name == variable
                || subjects.any(|own| own.0.of.mentions(name))
                || self.auditor.changes(self.at, name, variable)
        };
        !names.iter().any(moves)
    }

    /// Whether what a goal claims does not obey one of the laws that it is drawn from.
    fn breaks(&self, goal: &Goal, laws: &[&Assumed], others: &[&Assumed]) -> bool {
        let mut with: Vec<Assumed> = others.iter().copied().cloned().collect();
        with.push(Assumed {
            standing: Standing::Identity,
            ..step(&goal.formula)
        });
        laws.iter().any(|law| {
            let claim = self.derivation.claim(self.at, &with, &law.formula);
            matches!(
                search::decide(claim, &self.auditor.hints()),
                Decision::Refuted(_)
            )
        })
    }
}

/// The value of what a step gives, where that speaks of it itself: `z = a + (z(0) - a) e^{-t}` must come to `z(0)` there.
fn own_value(left: &Expr, right: &Expr) -> Option<(ConditionSaid, Formula)> {
    fn find<'e>(term: &'e Expr, of: &Expr) -> Option<(&'e Expr, &'e Symbol, &'e Expr)> {
        match term {
            Expr::Limit {
                body,
                variable,
                point: LimitPoint::Finite(place),
            } if **body == *of => Some((term, variable, place)),
            term => term.children().find_map(|part| find(part, of)),
        }
    }
    let (value, variable, place) = find(right, left).filter(|_| matches!(left, Expr::Symbol(_)))?;
    let named = right.replace(value, &value_of_its_own());
    let there = Formula::equal(value_of_its_own(), named.substitute(variable, place));
    let said = ConditionSaid {
        of: left.clone(),
        value: value.clone(),
        variable: Some(variable.clone()),
        place: place.clone(),
        just_said: true,
    };
    Some((said, there))
}

/// The right side of what a step gives, with a name for its own value at a place, if it speaks of that; and what says where that is.
pub(super) fn with_own_value_named(left: &Expr, right: &Expr) -> (Expr, Option<Symbol>) {
    match own_value(left, right) {
        Some((said, _)) => (
            right.replace(&said.value, &value_of_its_own()),
            said.variable,
        ),
        None => (right.clone(), None),
    }
}

/// What a step gives, solved for the quantity itself: `T = T_b f` of `T/T_b = f`.
pub(super) fn for_the_quantity(left: &Expr, right: &Expr) -> (Expr, Expr) {
    match left {
        Expr::Quotient(own, below) if matches!(**own, Expr::Symbol(_)) => {
            let value = Expr::Product([(**below).clone(), right.clone()].into());
            ((**own).clone(), value)
        }
        _ => (left.clone(), right.clone()),
    }
}

/// The same where the quantity is one of some factors: `w = \frac{f}{E I}` of `E I w = f`.
pub(super) fn without_factors(left: &Expr, right: &Expr, of: &Symbol) -> Option<(Expr, Expr)> {
    let Expr::Product(factors) = left else {
        return None;
    };
    let (own, others): (Vec<&Expr>, Vec<&Expr>) = factors.iter().partition(|own| own.mentions(of));
    let [own @ Expr::Symbol(_)] = own[..] else {
        return None;
    };
    let below = product_of(others.into_iter().cloned().collect());
    Some((
        own.clone(),
        Expr::Quotient(right.clone().into(), below.into()),
    ))
}

/// What stands for the value at a place, whatever that is.
pub(super) fn value_of_its_own() -> Expr {
    Expr::Symbol(Symbol::new("\\text{value there}"))
}

/// That a velocity begins with nought: "The solution that starts from rest is".
fn at_rest(velocity: &Expr, variable: &Symbol) -> Option<ConditionSaid> {
    let is_velocity = |own: &Symbol| {
        let stem = split_subscript(own.name()).map_or(own.name(), |(stem, _)| stem);
        matches!(stem, "v" | "u" | "w" | "V" | "U" | "\\omega")
    };
    let is_of_time = matches!(variable.name(), "t");
    matches!(velocity, Expr::Symbol(own) if is_of_time && is_velocity(own)).then(|| ConditionSaid {
        of: velocity.clone(),
        value: Expr::integer(0),
        variable: Some(variable.clone()),
        place: Expr::integer(0),
        just_said: true,
    })
}

/// The integrals of a formula that run up to a symbol: from where, and to which.
fn bounds(formula: &Formula) -> Vec<(&Expr, &Symbol)> {
    fn collect<'e>(term: &'e Expr, found: &mut Vec<(&'e Expr, &'e Symbol)>) {
        match term {
            Expr::Integral { from, to, .. } => {
                if let Expr::Symbol(to) = &**to {
                    found.push((from, to));
                }
            }
            term => term.children().for_each(|part| collect(part, found)),
        }
    }
    let mut found = Vec::new();
    let terms = formula.terms().into_iter();
    terms.for_each(|term| collect(term, &mut found));
    found
}

/// What the bounds of integrals say of where a solution begins: with `\int_{v_0}^v … = \int_0^t …` there is `v = v_0` at `t = 0`. Where nothing is
/// integrated over the variable, it begins at nought.
fn where_bounds_meet(formula: &Formula, variable: &Symbol) -> Vec<ConditionSaid> {
    let bounds = bounds(formula);
    let (along, of): (Vec<_>, Vec<_>) = bounds.into_iter().partition(|own| own.1 == variable);
    let place = match &along[..] {
        [] => Expr::integer(0),
        [(first, _), rest @ ..] if rest.iter().all(|own| own.0 == *first) => (*first).clone(),
        _ => return Vec::new(),
    };
    let said = of.into_iter().map(|(value, own)| ConditionSaid {
        of: Expr::Symbol(own.clone()),
        value: value.clone(),
        variable: Some(variable.clone()),
        place: place.clone(),
        just_said: true,
    });
    said.collect()
}

/// What the text tells at places of things that a goal speaks of, the last that it tells of each, and what the goal comes to there.
fn met(all: Vec<ConditionSaid>, goal: &Goal, variable: &Symbol) -> Vec<(ConditionSaid, Formula)> {
    let mut found: Vec<(ConditionSaid, Formula)> = Vec::new();
    for said in all {
        let speaks = |own: &ConditionSaid| {
            let mut terms = goal.formula.terms().into_iter();
            terms.any(|term| term.any(&|part| *part == own.of))
        };
        let said = match speaks(&said) {
            true => said,
            false => ConditionSaid {
                of: said.subject(variable),
                ..said
            },
        };
        let is_same = |own: &ConditionSaid| own.of == said.of && own.place == said.place;
        let is_known = found.iter().any(|own| is_same(&own.0));
        if said.variable.as_ref().is_none_or(|own| own == variable)
            && !is_known
            && let Some(there) = there(&goal.formula, &said, variable)
        {
            found.push((said, there));
        }
    }
    found
}

/// That something has its value at a place, for who reads what a step was judged from.
fn value_there(said: &ConditionSaid, variable: &Symbol) -> Formula {
    let there = Expr::Limit {
        body: said.of.clone().into(),
        variable: variable.clone(),
        point: LimitPoint::Finite(said.place.clone().into()),
    };
    Formula::equal(there, said.value.clone())
}

/// A difference, and its products with the exponentials in what varies of which a goal and laws speak, and with one over them: what solves a
/// linear law differs from other solutions by a constant times one of these.
fn possibly_kept(difference: Expr, goal: &Goal, laws: &[&Assumed], variable: &Symbol) -> Vec<Expr> {
    let mut exponents: Vec<Expr> = Vec::new();
    let all = laws.iter().map(|law| &*law.formula).chain([&goal.formula]);
    for term in all.flat_map(Formula::terms) {
        collect_exponents(term, variable, &mut exponents);
    }
    exponents.truncate(MOST_EXPONENTS);
    let times = |exponent: Expr| {
        let power = Expr::Call(Function::Exp, exponent.into());
        Expr::Product([difference.clone(), power].into())
    };
    let both = exponents.iter().flat_map(|own| {
        let negative = Expr::Negate(own.clone().into());
        [times(negative), times(own.clone())]
    });
    both.chain([difference.clone()]).collect()
}

fn collect_exponents(term: &Expr, variable: &Symbol, found: &mut Vec<Expr>) {
    if let Expr::Call(Function::Exp, exponent) = term
        && exponent.mentions(variable)
        && !found.contains(exponent)
    {
        found.push((**exponent).clone());
    }
    let parts = term.children();
    parts.for_each(|part| collect_exponents(part, variable, found));
}

/// What a formula comes to where a condition is met, if it speaks of what has the value there; `None` where it speaks of how that varies, too.
fn there(formula: &Formula, said: &ConditionSaid, variable: &Symbol) -> Option<Formula> {
    let varies = |part: &Expr| {
        matches!(
            part,
            Expr::Derivative { .. }
                | Expr::Partial { .. }
                | Expr::Integral { .. }
                | Expr::Limit { .. }
                | Expr::Apply(..)
        )
    };
    let mut speaks = false;
    let put = formula.map_terms(|term| put_in(term, (said, variable), &mut speaks));
    let put = put.map_terms(|term| without_empty(&term.substitute(variable, &said.place)));
    let is_known = !put.terms().into_iter().any(|term| term.any(&varies));
    (speaks && is_known).then_some(put)
}

/// A term in which integrals from a place to the same place are nought.
fn without_empty(term: &Expr) -> Expr {
    match term {
        Expr::Integral { from, to, .. } if from == to => Expr::integer(0),
        term => term.map_children(without_empty),
    }
}

/// A term with a value put in for what has it.
fn put_in(term: &Expr, (said, variable): (&ConditionSaid, &Symbol), speaks: &mut bool) -> Expr {
    let is_applied = match (term, &said.of) {
        (Expr::Apply(name, arguments), Expr::Symbol(own)) => {
            name == own && arguments[..] == [Expr::Symbol(variable.clone())]
        }
        _ => false,
    };
    if *term == said.of || is_applied {
        *speaks = true;
        return said.value.clone();
    }
    match term {
        // How it varies is no value of it.
        Expr::Derivative { .. } => term.clone(),
        term => term.map_children(|part| put_in(part, (said, variable), speaks)),
    }
}
