//! Values that the text before a step tells in words that were not taken for a supposition: "Our firm has $a = 100$ and $c = 40$. By (1) the
//! price is therefore".
//!
//! What comes to a number is not refuted as if they were not there: either with them, or not at all.

use crate::algebra::{Expr, Formula, Symbol};
use crate::derivation::{Assumed, Goal, Source, formulas, goals};
use crate::document::{Item, Span};
use crate::notation::{Statement, has_decimals, plain_symbol, read_formulas};
use crate::search::{self, Change, Decision, Mended};
use crate::sorted::Set;

use super::super::Outcome;
use super::super::judge::{Found, Judge, step};

/// So many displays before may come to a value that is meant.
const MOST_DISPLAYED: usize = 8;
/// What the text tells is looked for before so many displays.
const MOST_DISPLAYS: usize = 2;

impl Judge<'_> {
    /// Refutes what comes to a number with the values that the text since the last display tells, or leaves it open; what follows with
    /// values that stand farther back, too.
    pub(in crate::audit) fn heed_values_told(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        found: &mut Found,
    ) {
        let comes_to_number = match goal.formula.as_equation() {
            Some((_, right)) => is_number(right),
            None => false,
        };
        if !found.judged.outcome.is_refuted() || !comes_to_number {
            return;
        }
        // `\frac{1.341 - 1}{1.341 + 1}` is worked out of what was rounded on the way.
        let is_rounded = match goal.formula.as_equation() {
            Some((_, Expr::Number(_))) | None => false,
            Some((_, right)) => has_decimals(right),
        };
        let with = |values: &[Formula]| -> Vec<Assumed> {
            assumed
                .iter()
                .cloned()
                .chain(values.iter().map(step))
                .collect()
        };
        let near = self.without_value(self.values_near(), goal, assumed);
        if !near.is_empty() {
            let all = with(&near);
            match self.decide_from(&all, &goal.formula) {
                // There is a point at which all of them are so.
                Some(Decision::Refuted(refuted)) if !is_rounded => {
                    found.judged.outcome = Outcome::Refuted(refuted.into());
                    found.judged.assumed = all;
                }
                Some(Decision::Proven { .. }) if !self.is_contradictory(&all, goal) => {
                    found.leave_open(format!(
                        "it follows with the numbers that the text names for {}, and does not plainly suppose: write “Let” before them",
                        names(&near)
                    ));
                }
                _ => found.leave_open(may_follow_with(&near)),
            }
        }
        if !found.judged.outcome.is_refuted() {
            return;
        }
        if let Some(symbol) = self.brings_without_value(goal) {
            let symbol = plain_symbol(&symbol);
            found.leave_open(format!("nothing before says how great `{symbol}` is"));
            return;
        }
        let mut far = self.values_before();
        far.splice(0..0, near);
        let far = self.without_value(far, goal, assumed);
        let all = with(&far);
        if let Some(Decision::Proven { .. }) = self.decide_from(&all, &goal.formula)
            && !self.is_contradictory(&all, goal)
        {
            found.leave_open(format!(
                "it follows with the numbers that stand before for {}, and nothing says that these are still meant",
                names(&far)
            ));
        }
    }

    /// Leaves open what a chain says that comes to a number, where the text since the last display tells a number for what a premise has
    /// besides: `E = \rho R^5/t^2 = 1.1 \times 10^{14}\,\mathrm{J}` of `R = C (E t^2/\rho)^{1/5}`, "with $C = 1$".
    pub(in crate::audit) fn heed_values_put_in(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        found: &mut Found,
    ) {
        let is_slip = |own: &Mended| !matches!(own.change, Change::Symbol { .. });
        if !found.judged.outcome.is_refuted() || found.mended.as_deref().is_some_and(is_slip) {
            return;
        }
        let statements = self.derivation.equations[self.at].statements().iter();
        let comes_to_number = statements.map(goals).any(|chain| {
            let mut rest = chain.iter().skip_while(|own| own.formula != goal.formula);
            let is_one = rest.next().is_some();
            let ends = |own: &Goal| {
                let sides = own.formula.as_equation();
                sides.is_some_and(|(_, right)| is_number(right))
            };
            is_one && rest.any(ends)
        });
        if !comes_to_number {
            return;
        }
        let mut near = self.without_value(self.values_near(), goal, assumed);
        let names = goal.formula.names();
        near.retain(|own| valued(own).is_some_and(|(of, _)| !names.contains(of)));
        if !near.is_empty() {
            found.leave_open(may_follow_with(&near));
        }
    }

    /// Leaves open what puts figures into a law for something of which no value is told: "A probe fired sideways at $0.60 c$ has
    /// $$u_y = \frac{0.60 c}{1.155}$$" after `u_y = u_y'/\gamma`.
    pub(in crate::audit) fn heed_figures_for_what_has_no_value(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        found: &mut Found,
    ) {
        let Some((Expr::Symbol(of), right)) = goal.formula.as_equation() else {
            return;
        };
        let is_put_in = has_decimals(right) && !is_number(right);
        if !found.judged.outcome.is_refuted() || found.mended.is_some() || !is_put_in {
            return;
        }
        let names = goal.formula.names();
        let is_told = |own: &Symbol| {
            let mut all = assumed.iter();
            names.contains(own)
                || all.any(|said| said.is_of(own) || said.formula.set_to_number() == Some(own))
        };
        let mut laws = assumed.iter().filter(|own| own.is_of(of));
        let unknown =
            laws.find_map(|law| law.formula.names().into_iter().find(|own| !is_told(own)));
        if let Some(unknown) = unknown {
            let unknown = plain_symbol(&unknown);
            found.leave_open(format!("nothing before says how great `{unknown}` is"));
        }
    }

    /// A premise that says what something is of which the text tells a number after it, where nothing is refuted without that: "The best
    /// index is by (7) $1.23$, but no solid has one so low. With $n_1 = 1.38$".
    pub(in crate::audit) fn heed_values_replaced(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        found: &mut Found,
    ) {
        let comes_to_number = valued(&goal.formula).is_some_and(|(_, right)| is_number(right));
        if !found.judged.outcome.is_refuted() || !comes_to_number {
            return;
        }
        let is_told = |symbol: &Symbol| {
            let mut said = assumed
                .iter()
                .filter(|own| matches!(own.source, Source::Local(..)));
            said.any(|own| {
                valued(&own.formula).is_some_and(|(of, value)| of == symbol && is_number(value))
            })
        };
        let names = goal.formula.names();
        let is_replaced = |own: &Assumed| {
            let valued = valued(&own.formula).filter(|_| own.formula.names().is_disjoint(&names));
            matches!(own.source, Source::Equation(_))
                && valued.is_some_and(|(of, value)| !is_number(value) && is_told(of))
        };
        let (replaced, kept): (Vec<Assumed>, Vec<Assumed>) =
            assumed.iter().cloned().partition(is_replaced);
        if replaced.is_empty() {
            return;
        }
        let posed = self.pose(&kept, &goal.formula).ok();
        let implied = posed.and_then(|posed| search::implied(&posed));
        let value = implied
            .as_ref()
            .and_then(|own| own.proven.claim().goal.as_equation());
        if !value.is_some_and(|(_, value)| is_number(value)) {
            found.leave_open("a number is told for what a premise gives by other quantities");
        }
    }

    /// A symbol of which a link that comes to a number is the first to speak, beside what its display defines: "In two hours it uses
    /// `W = P t = 2.3\,\mathrm{kWh}`".
    fn brings_without_value(&self, goal: &Goal) -> Option<Symbol> {
        let own = &self.derivation.equations[self.at];
        let (left, right) = goal.formula.as_equation()?;
        let defines = |statement: &Statement| {
            let first = formulas(statement).into_iter().next()?;
            let (symbol, value) = valued(&first)?;
            (value == left).then(|| symbol.clone())
        };
        let defined = own.statements().iter().find_map(defines)?;
        // That something is 0 says no more of what is new.
        if *right == Expr::integer(0) || goal.formula.speaks_of_slopes() {
            return None;
        }
        let is_new = |symbol: &Symbol| {
            own.introduces.contains(symbol) && *symbol != defined && !symbol.is_unit()
        };
        left.free_symbols().into_iter().find(is_new)
    }

    /// Of values those of symbols of which hypotheses, or the step, speak and say no value; the first for each.
    fn without_value(&self, said: Vec<Formula>, goal: &Goal, assumed: &[Assumed]) -> Vec<Formula> {
        let mut spoken: Set<Symbol> = assumed.iter().flat_map(|a| a.formula.names()).collect();
        spoken.extend(goal.formula.names());
        let has_value = |symbol: &Symbol| {
            let mut all = assumed.iter().filter_map(|a| a.formula.as_equation());
            let is_left =
                matches!(goal.formula.as_equation(), Some((Expr::Symbol(own), _)) if own == symbol);
            is_left
                || all.any(|(left, right)| {
                    matches!(left, Expr::Symbol(s) if s == symbol) && is_number(right)
                })
        };
        let mut values: Vec<Formula> = Vec::new();
        for own in said {
            let Some((symbol, number)) = valued(&own) else {
                continue;
            };
            let is_known = values
                .iter()
                .any(|other| valued(other).is_some_and(|(other, _)| other == symbol));
            if is_number(number) && spoken.contains(symbol) && !has_value(symbol) && !is_known {
                values.push(own);
            }
        }
        values
    }

    /// What the text since the last display says.
    fn values_near(&self) -> Vec<Formula> {
        let own = &self.derivation.equations[self.at];
        let bodies = self.bodies_before(0);
        self.read(own.page, bodies)
    }

    /// What is told, and not supposed for some case that may be over, in the text of the section a little farther back, and the values to
    /// which displays come: "At $U = 12$ the current is $$I = U/R = 6$$".
    fn values_before(&self) -> Vec<Formula> {
        let equations = &self.derivation.equations;
        let own = &equations[self.at];
        let mut bodies = self.bodies_before(MOST_DISPLAYS);
        bodies.retain(|&body| !self.derivation.is_supposed(own.page, body));
        let mut said = self.read(own.page, bodies);
        let page = self.derivation.equations_of(own.page);
        let near = page.start.max(self.at.saturating_sub(MOST_DISPLAYED))..self.at;
        let near = near.rev().map(|at| &equations[at]);
        let here = near.take_while(|other| other.section_start == own.section_start);
        let value = |statement: &Statement| {
            let said = formulas(statement);
            let ((left, _), (_, right)) =
                (said.first()?.as_equation()?, said.last()?.as_equation()?);
            Some(Formula::equal(left.clone(), right.clone()))
        };
        said.extend(here.flat_map(|other| other.statements()).filter_map(value));
        said
    }

    /// The formulas in the text before the step, past so many displays, the nearest first: "$z = 1$. For the quasar, with $z = 0.158$".
    fn bodies_before(&self, displays: usize) -> Vec<Span> {
        let own = &self.derivation.equations[self.at];
        let document = &self.derivation.pages[own.page].document;
        let here = (document.items).partition_point(|item| item.span().start < own.span.start);
        let mut passed = 0;
        let before = document.items[..here].iter().rev();
        let since = before.take_while(|item| {
            passed += usize::from(matches!(item, Item::Display { .. }));
            passed <= displays && !matches!(item, Item::Heading { .. })
        });
        let texts = since.filter_map(|item| match item {
            Item::Prose(prose) => Some(prose),
            _ => None,
        });
        let bodies = texts.flat_map(|prose| prose.math.iter().rev().map(|math| math.body));
        bodies.collect()
    }

    fn read(&self, page: usize, bodies: Vec<Span>) -> Vec<Formula> {
        let source = &self.derivation.pages[page].document.source;
        let read = bodies
            .into_iter()
            .filter_map(|body| read_formulas(source, body).ok());
        read.flatten().flat_map(|own| formulas(&own)).collect()
    }
}

fn is_number(term: &Expr) -> bool {
    term.is_arithmetic() && term.free_symbols().iter().all(Symbol::is_unit)
}

/// The symbol of which an equation says what it is, and that.
fn valued(formula: &Formula) -> Option<(&Symbol, &Expr)> {
    match formula.as_equation() {
        Some((Expr::Symbol(symbol), value)) => Some((symbol, value)),
        _ => None,
    }
}

/// Why a step is left open that may follow with values that words tell.
fn may_follow_with(values: &[Formula]) -> String {
    let names = names(values);
    format!("it may follow with the numbers that the text names for {names}")
}

/// The symbols that values are of, as a message lists them.
fn names(values: &[Formula]) -> String {
    let symbols = values.iter().filter_map(valued);
    let names: Vec<String> = symbols
        .map(|(symbol, _)| format!("`{}`", plain_symbol(symbol)))
        .collect();
    names.join(", ")
}
