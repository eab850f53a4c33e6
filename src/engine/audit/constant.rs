//! `p V = \text{const}` as a step: that there is a constant which `p V` is.
//!
//! Two things show it. What is cited gives the constant in terms of others (`n R T`, where these are declared `constant`): then
//! `p V = n R T` is proved, for the name of the constant stands nowhere else. Or both sides change at the same rate with the one
//! variable by which the page differentiates. What holds at one point only shows neither.

use crate::algebra::{Expr, Formula, Symbol};
use crate::derivation::{Assumed, Goal, Source, ValueSaid};
use crate::kernel::{Claim, Standing};
use crate::search::{self, Decision, Effort, Stop};

use super::judge::{Found, Judge, sources, step};
use super::{Judged, Outcome, stated};
use crate::sorted::Set;

/// What integrates a slope brings along, where nobody gives it a name.
pub(super) const OF_INTEGRATION: &str = "\\text{constant of integration}";
/// Why it is not known whether something is constant.
const UNKNOWN: &str = "nothing that it may follow from shows that this does not change";

impl Judge<'_> {
    /// The constant without a name of which a goal is the first to speak, if there is one.
    pub(super) fn some_constant(&self, goal: &Goal, assumed: &[Assumed]) -> Option<Symbol> {
        let said = |symbol: &Symbol| {
            let mut terms = assumed.iter().flat_map(|a| a.formula.terms());
            terms.any(|term| term.mentions(symbol))
        };
        let symbols = goal.formula.free_symbols();
        let mut symbols = symbols.into_iter();
        symbols.find(|symbol| self.derivation.is_some_constant(symbol) && !said(symbol))
    }

    /// Whether there is such a constant. That there is none is not said of anything.
    pub(super) fn is_constant(
        &self,
        goal: &Goal,
        constant: &Symbol,
        assumed: Vec<Assumed>,
        premises: &[usize],
    ) -> Found {
        let stop = Stop {
            reason: UNKNOWN.into(),
            hopeless: true,
            ..Stop::default()
        };
        let mut found = Found::open(Judged {
            goal: goal.clone(),
            assumed: assumed.clone(),
            outcome: Outcome::Open(stop),
        });
        let Some((left, right)) = goal.formula.as_equation() else {
            return found;
        };
        let throughout = |own: &&Assumed| own.standing == Standing::Identity;
        let [others, _] = self.others(premises);
        let near = others.iter().filter(throughout).cloned();
        let cited: Vec<Assumed> = assumed.iter().filter(throughout).cloned().collect();
        let with: Vec<Assumed> = cited.iter().cloned().chain(near).collect();
        for (at, all) in [cited, with].into_iter().enumerate() {
            let shown = self.is_one_of(goal, constant, &all, &mut found)
                || self.stands_still(goal, (left, right), constant, &all, &mut found);
            if shown {
                if at > 0 {
                    found.instead = sources(&found.judged.assumed);
                }
                break;
            }
        }
        found
    }

    /// A step that brings in a constant of integration, `v = v_0 + a t` from `dv/dt = a`: there is one if `v - a t` does not change. Where
    /// the text says what it is, `v(0) = v_0`, the step must say so too.
    pub(super) fn integrated(&self, goal: &Goal, premises: &[usize]) -> Option<Found> {
        let equation = &self.derivation.equations[self.at];
        let (left @ Expr::Symbol(given), right) = goal.formula.as_equation()? else {
            return None;
        };
        let cited = self.usable.assumed.iter().map(|own| &*own.formula);
        let is_law = Formula::differentiated_in(cited).contains(given);
        if !is_law || !goal.is_said_outright() {
            return None;
        }
        // Nothing speaks of it but what says the value of something at a place.
        let speaks = |own: &&Assumed| !own.formula.speaks_of_values();
        let assumed = self.usable.assumed.iter().filter(speaks);
        let assumed: Vec<Assumed> = assumed.cloned().collect();
        let is_known = |symbol: &Symbol| {
            let mut terms = assumed.iter().flat_map(|own| own.formula.terms());
            terms.any(|term| term.mentions(symbol))
        };
        let Some((constant, what)) = isolated(left, right, is_known) else {
            return self.integrated_from_a_number(goal, given, right, assumed, premises);
        };
        let begins = self
            .derivation
            .values_said(equation.page, &constant, given)?;
        if begins.is_empty() && !equation.introduces.contains(&constant) {
            return None;
        }
        let variable = self.variable_of(left)?;
        // What is isolated has the value that the text says it begins with.
        let keeps = |said: &ValueSaid| {
            let there = right.substitute(&variable, &said.place);
            let formula = Formula::equal(there, Expr::Symbol(constant.clone()));
            // What the step divides by anywhere is not 0 there either.
            let is_so = || {
                self.pose(&[], &formula).is_ok_and(|posed| {
                    search::prove_posed(&posed, Effort::Light).is_some()
                        || search::missing_conditions(&posed, None, Effort::Light, &[]).is_some()
                })
            };
            said.of == *given
                && said.variable.as_ref().is_none_or(|own| *own == variable)
                && is_so()
        };
        if !begins.iter().all(keeps) {
            return None;
        }
        self.where_constant(goal, (what, &constant), assumed, premises)
    }

    /// The same where the text gives the number that something begins with: "Integrating with $w = 0$ at $x = 0$".
    fn integrated_from_a_number(
        &self,
        goal: &Goal,
        given: &Symbol,
        right: &Expr,
        assumed: Vec<Assumed>,
        premises: &[usize],
    ) -> Option<Found> {
        let variable = self.variable_of(&Expr::Symbol(given.clone()))?;
        let (said, number) = self.derivation.number_said(self.at, given)?;
        if said.variable.is_some_and(|own| own != variable) {
            return None;
        }
        let there = Formula::equal(right.substitute(&variable, &said.place), number);
        let claim = self.derivation.claim(self.at, &[], &there);
        search::prove_unconditionally(claim, Effort::Light)?;
        let constant = Symbol::new(OF_INTEGRATION);
        let what = Expr::Sum(
            [
                Expr::Symbol(given.clone()),
                Expr::Negate(right.clone().into()),
            ]
            .into(),
        );
        self.where_constant(goal, (what, &constant), assumed, premises)
    }

    /// A step that says what something is up to a constant, where a term does not change.
    pub(super) fn where_constant(
        &self,
        goal: &Goal,
        (term, constant): (Expr, &Symbol),
        assumed: Vec<Assumed>,
        premises: &[usize],
    ) -> Option<Found> {
        let own = Goal {
            formula: Formula::equal(term, Expr::Symbol(constant.clone())),
            ..goal.clone()
        };
        let mut found = self.is_constant(&own, constant, assumed, premises);
        found.judged.goal = goal.clone();
        found.judged.outcome.is_proven().then_some(found)
    }

    /// The constant in terms of others.
    fn is_one_of(
        &self,
        goal: &Goal,
        constant: &Symbol,
        assumed: &[Assumed],
        found: &mut Found,
    ) -> bool {
        let mut with = assumed.to_vec();
        with.push(Assumed {
            formula: goal.formula.clone().into(),
            standing: Standing::Identity,
            source: Source::Step,
        });
        let nought = Formula::equal(Expr::Symbol(constant.clone()), Expr::integer(0));
        let claim = self.derivation.claim(self.at, &with, &nought);
        let Some(value) = search::value_in_constants(&claim, constant) else {
            return false;
        };
        // Put in rather than supposed: what is supposed has a value.
        let formula = goal
            .formula
            .map_terms(|term| term.substitute(constant, &value));
        let claim = self.derivation.claim(self.at, assumed, &formula);
        self.decided(claim, (goal, constant), assumed.to_vec(), found)
    }

    /// The same rate on both sides.
    fn stands_still(
        &self,
        goal: &Goal,
        (left, right): (&Expr, &Expr),
        constant: &Symbol,
        assumed: &[Assumed],
        found: &mut Found,
    ) -> bool {
        let Some(variable) = self.variable_of(left).or_else(|| self.variable_of(right)) else {
            return false;
        };
        // A constant that is a factor, say, is not the only thing that may be different for each value of the variable.
        let slope = |term: &Expr| match term {
            Expr::Symbol(own) if own == constant => Expr::integer(0),
            term => term.clone().differentiated_by(&variable),
        };
        let stands_alone = |one: &Expr, other: &Expr| {
            matches!(one, Expr::Symbol(own) if own == constant) && !other.mentions(constant)
        };
        if !stands_alone(left, right) && !stands_alone(right, left) {
            return false;
        }
        let formula = Formula::equal(slope(left), slope(right));
        if self.stands_still_with_constants(goal, (&formula, constant), &variable, assumed, found) {
            return true;
        }
        let claim = self.derivation.claim(self.at, assumed, &formula);
        self.decided(claim, (goal, constant), assumed.to_vec(), found)
    }

    /// The same where nothing changes of which nobody says so: to look at how each symbol might is more work.
    fn stands_still_with_constants(
        &self,
        goal: &Goal,
        (formula, constant): (&Formula, &Symbol),
        variable: &Symbol,
        assumed: &[Assumed],
        found: &mut Found,
    ) -> bool {
        let own = Goal {
            formula: formula.clone(),
            ..goal.clone()
        };
        let mut shown = Found::open(Judged {
            goal: own.clone(),
            ..found.judged.clone()
        });
        // What speaks of nothing that is in the laws or in the goal is not needed.
        let mut named = formula.names();
        let laws = assumed.iter().filter(|own| own.formula.speaks_of_slopes());
        named.extend(laws.flat_map(|own| own.formula.names()));
        let speaks = |own: &&Assumed| !own.formula.names().is_disjoint(&named);
        let near: Vec<Assumed> = assumed.iter().filter(speaks).cloned().collect();
        if !self.holds_for_all(variable, &own, &near, &mut shown) {
            return false;
        }
        // That all of it stands still shows nothing.
        let still = |own: &Symbol| own == constant || shown.constant.contains(own);
        if goal.formula.free_symbols().iter().all(still) {
            return false;
        }
        found.judged.assumed = shown.judged.assumed;
        found.judged.outcome = shown.judged.outcome;
        (found.conditions, found.constant) = (shown.conditions, shown.constant);
        true
    }

    fn decided(
        &self,
        claim: Claim,
        (goal, constant): (&Goal, &Symbol),
        assumed: Vec<Assumed>,
        found: &mut Found,
    ) -> bool {
        let Ok(posed) = search::pose(claim.clone()) else {
            return false;
        };
        let decision = self.decide(&posed);
        let own = Goal {
            formula: claim.goal,
            ..goal.clone()
        };
        let mut shown = Found::open(Judged {
            goal: own.clone(),
            ..found.judged.clone()
        });
        match decision {
            Decision::Proven {
                derived,
                conditions,
            } => {
                let (kept, proven) = match conditions.is_empty() {
                    true => self.least(assumed, &own, &posed, derived),
                    false => (assumed, derived.proven),
                };
                shown.judged.assumed = kept;
                shown.judged.assumed.extend(conditions.iter().map(step));
                shown.judged.outcome = Outcome::Proven(proven.into());
                shown.conditions = conditions;
            }
            // Where nobody says where a symbol lies: what is divided by is not 0.
            _ if self.under_conditions(&own, assumed, None, (true, Effort::Light), &mut shown) => {}
            _ => return false,
        }
        let slopes = |formula: &Formula| {
            let mut terms = formula.terms().into_iter();
            terms.any(|term| matches!(term, Expr::Derivative { .. }))
        };
        // That all of it stands still shows nothing.
        let held = shown.conditions.iter().filter(|own| slopes(own));
        let held: Vec<Formula> = held.cloned().collect();
        let symbols = goal.formula.free_symbols().into_iter();
        let mut moves = symbols.filter(|symbol| symbol != constant);
        let stands_still = !held.is_empty()
            && stated::constants(&shown.judged, &held)
                .is_none_or(|taken| moves.all(|symbol| taken.contains(&symbol)));
        if stands_still || self.contradicts_itself(&posed) {
            return false;
        }
        found.judged.assumed = shown.judged.assumed;
        found.judged.outcome = shown.judged.outcome;
        found.conditions = shown.conditions;
        true
    }

    /// What the page differentiates by, where that is one thing.
    pub(super) fn variable(&self) -> Option<Symbol> {
        let by = self.differentiated_by(|_| true);
        (by.len() == 1).then_some(by)?.pop_first()
    }

    /// What the page differentiates the quantities in a term by, where that is one thing; or all others.
    pub(super) fn variable_of(&self, term: &Expr) -> Option<Symbol> {
        let mut by = self.differentiated_by(|body| term.mentions(body));
        match by.len() {
            0 => self.variable(),
            1 => by.pop_first(),
            _ => None,
        }
    }

    /// The same, or of several the one of which what a step gives speaks: `v^2 = u^2 (1 - e^{-2 g y/u^2})` after `\frac{dv}{dt}` and `\frac{d(v^2)}{dy}`.
    pub(super) fn variable_between(&self, left: &Expr, right: &Expr) -> Option<Symbol> {
        let mut by = self.differentiated_by(|body| left.mentions(body));
        if by.len() < 2 {
            return self.variable_of(left);
        }
        by.retain(|own| right.mentions(own));
        (by.len() == 1).then_some(by)?.pop_first()
    }

    /// What the page differentiates by, where a quantity that it differentiates is one of some.
    fn differentiated_by(&self, is_meant: impl Fn(&Symbol) -> bool) -> Set<Symbol> {
        let page = self.derivation.equations[self.at].page;
        let slopes = self.auditor.slopes_of(page).iter();
        let meant = slopes.filter(|(of, _)| is_meant(of));
        meant.map(|(_, by)| by.clone()).collect()
    }
}

/// The one summand or factor of the right side of an equation that is a symbol of which nothing is known, and what that is by the equation.
fn isolated(
    left: &Expr,
    right: &Expr,
    is_known: impl Fn(&Symbol) -> bool,
) -> Option<(Symbol, Expr)> {
    let (Expr::Sum(parts) | Expr::Product(parts)) = right else {
        return None;
    };
    let is_fresh = |part: &&Expr| matches!(part, Expr::Symbol(own) if !is_known(own));
    let (fresh, others): (Vec<&Expr>, Vec<&Expr>) = parts.iter().partition(is_fresh);
    let [Expr::Symbol(constant)] = fresh.as_slice() else {
        return None;
    };
    if others.iter().any(|part| part.mentions(constant)) {
        return None;
    }
    let others = others.into_iter().cloned().collect();
    let left = left.clone();
    let what = match right {
        Expr::Sum(_) => Expr::Sum([left, Expr::Negate(Expr::Sum(others).into())].into()),
        _ => Expr::Quotient(left.into(), Expr::Product(others).into()),
    };
    Some((constant.clone(), what))
}
