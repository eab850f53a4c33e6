//! Names for where a difference vanishes: "It peaks where the reactance vanishes, at $$\omega_0 = \frac{1}{\sqrt{L C}}$$" after
//! `I = \frac{V}{\sqrt{R^2 + (\omega L - \frac{1}{\omega C})^2}}`.
//!
//! Which of all differences it is that words mean is not understood. Where the new name makes none of them vanish that stand before, and with one
//! small edit would, something else is meant than what is printed.

use crate::algebra::{Expr, Formula, Symbol, effort};
use crate::derivation::{Assumed, Goal, Source, formulas};
use crate::search::{self, Change, Effort};

use super::super::Judged;
use super::super::instances::index;
use super::super::judge::{Found, Judge, taken};

/// So much work is done for that, as [`effort`] counts it.
const MOST_WORK: u64 = 1_000_000;
/// So many displays before are looked at, and so many differences in them.
const MOST_BEFORE: usize = 6;
const MOST_DIFFERENCES: usize = 4;
/// With one of these something is said to vanish.
const VANISHING: [&str; 14] = [
    "vanish",
    "vanishes",
    "vanishing",
    "zero",
    "cancel",
    "cancels",
    "resonance",
    "resonant",
    "balance",
    "balances",
    "equal",
    "equals",
    "disappears",
    "disappear",
];

impl Judge<'_> {
    /// What to say of a new name for where something vanishes, if nothing does there.
    pub(in crate::audit) fn as_no_zero(&self, goal: &Goal) -> Option<Found> {
        let (new, value) = goal.formula.said_of()?;
        let is_plain = goal.is_said_outright() && goal.rounding.is_none();
        let whole = new.without_subscript().filter(|_| index(new).is_some())?;
        if !is_plain
            || value.mentions(&whole)
            || matches!(value, Expr::Number(_))
            || !self.derivation.equations[self.at].introduces.contains(new)
            || !self.says(&VANISHING)
        {
            return None;
        }
        let differences = self.differences_of(&whole);
        effort::within(MOST_WORK, || {
            self.held_to_vanish(goal, (new, &whole), &differences)
        })
    }

    fn held_to_vanish(
        &self,
        goal: &Goal,
        (new, whole): (&Symbol, &Symbol),
        differences: &[Expr],
    ) -> Option<Found> {
        let there = |difference: &Expr| {
            let there = difference.substitute(whole, &Expr::Symbol(new.clone()));
            Formula::equal(there, Expr::integer(0))
        };
        let zeros: Vec<Formula> = differences.iter().map(there).collect();
        let mut symbols = goal.formula.free_symbols();
        symbols.extend(zeros.iter().flat_map(Formula::free_symbols));
        let positive = self.meant_positive(symbols);
        let with = |said: &Formula| -> Vec<Assumed> {
            positive.iter().cloned().chain([taken(said)]).collect()
        };
        let makes_vanish = |zero: &Formula| {
            let claim = self.derivation.claim(self.at, &with(&goal.formula), zero);
            search::prove_unconditionally(claim, Effort::Light).is_some()
        };
        if zeros.iter().any(makes_vanish) {
            return None;
        }
        let all: Vec<Vec<Assumed>> = zeros.iter().map(with).collect();
        self.one_slip_away_from_each(goal, &all, is_slip)
    }

    /// The differences of two terms that speak of a symbol, in the displays before, the nearest first.
    fn differences_of(&self, symbol: &Symbol) -> Vec<Expr> {
        let page = self.derivation.equations[self.at].page;
        let before = self.derivation.equations_of(page).start..self.at;
        let mut found = Vec::new();
        for at in before.rev().take(MOST_BEFORE) {
            let said = self.derivation.equations[at].statements().iter();
            for formula in said.flat_map(formulas) {
                for term in formula.terms() {
                    collect_differences(term, symbol, &mut found);
                }
            }
        }
        found.truncate(MOST_DIFFERENCES);
        found
    }
}

/// The differences of two terms in a term that both speak of a symbol.
fn collect_differences(term: &Expr, symbol: &Symbol, found: &mut Vec<Expr>) {
    if let Expr::Sum(items) = term
        && let [one, Expr::Negate(other)] = &items[..]
        && one.mentions(symbol)
        && other.mentions(symbol)
        && !found.contains(term)
    {
        found.push(term.clone());
    }
    (term.children()).for_each(|part| collect_differences(part, symbol, found));
}

/// Whether a refuted step is held against a difference that is taken to be what words say to vanish.
pub(in crate::audit) fn is_of_zero(judged: &Judged) -> bool {
    let is_zero = |own: &Assumed| match own.formula.as_equation() {
        Some((Expr::Sum(_), value)) => *value == Expr::integer(0) && own.source == Source::Taken,
        _ => false,
    };
    judged.assumed.iter().any(is_zero)
}

/// Whether an edit leaves what is spoken of as it is.
fn is_slip(change: &Change) -> bool {
    use Change::{Coefficient, Exponent, Inverted, Sign};
    matches!(change, Coefficient | Exponent | Inverted | Sign)
}
