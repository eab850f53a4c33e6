//! Figures put into a formula: `v = \sqrt{2 g h} = \sqrt{2 \cdot 9.81 \cdot 1.9} = 6.11\,\mathrm{m/s}`.
//!
//! What is worked out so is weighed with what the page prints for its symbols, be it told in passing, and as near as what was rounded on
//! the way. Of whatever case a number may be told that differs: what is not supported is told only where it is with one small edit.

use std::cell::Cell;

use crate::algebra::{BigRational, Expr, Formula, Symbol};
use crate::derivation::{Assumed, Goal, Printed, values_at};
use crate::search::{InChain, Slips};
use crate::sorted::Map;

use super::super::entry::leave_open;
use super::super::judge::Judge;
use super::super::{Auditor, Entry, Note, Verdict, numeric};
use super::decimals::FEWEST_DIGITS;
use super::rounded::{ROUNDED, is_weighed};
use super::{Link, Numeric, Taken, Weighed, decimals};

/// So many symbols may stand for numbers that are written where they are put in.
const MOST_WRITTEN: usize = 2;
/// Of so many it is tried.
const MOST_UNKNOWN: usize = 6;
/// So many ways to put them in are weighed.
const MOST_TRIED: usize = 64;
/// So many edits of a link are weighed.
const MOST_EDITS: usize = 40;

impl Auditor<'_> {
    /// Weighs a statement in which something is calculated from what was rounded on the way. It is left open where that is as near as it can be.
    pub(super) fn weigh_decimals(
        &self,
        judge: &Judge,
        premises: &[usize],
        open: &[Goal],
        entry: &mut Entry,
    ) -> bool {
        let (at, usable) = (judge.at, judge.usable);
        let page = self.derivation.equations[at].page;
        let source = &self.derivation.pages[page].document.source;
        let near = |goal: &Goal| match is_weighed(goal) {
            true => Some(goal.clone()),
            false => decimals::as_near_as_decimals(goal, source, &usable.assumed),
        };
        let near: Option<Vec<Goal>> = open.iter().map(near).collect();
        let Some(near) = near.filter(|near| !near.is_empty() && near.iter().all(is_weighed)) else {
            return false;
        };
        let mut figures = self.figures(at, usable);
        let weigh = |goals: &[Goal], all: &[Assumed], taken, said: &[Printed]| {
            numeric::weigh_rounded(self.derivation, at, goals, all, taken, said)
        };
        let exactly = |all: &[Assumed], said: &[Printed]| weigh(&near, all, Taken::Exactly, said);
        let mut numeric = exactly(&figures, &[]);
        let has_no_value = |own: &Numeric| matches!(own.outcome(), Weighed::NoValue(_));
        let lacks_more = has_no_value(&numeric) && !judge.is_directed();
        if lacks_more && judge.cites_loosely() {
            figures.extend(judge.others(premises)[0].iter().cloned());
            numeric = exactly(&figures, &[]);
        }
        if !numeric.is_supported() {
            // What the text tells in passing is no premise, and it is what figures are put in for.
            let printed = self.printed_before(at);
            numeric = exactly(&figures, &printed);
            let written = source.get(self.derivation.equations[at].body.range());
            let mut written = decimals::decimals(written.unwrap_or_default(), FEWEST_DIGITS);
            // What is come to is not put in.
            let is_result = |own: &Goal, number: &BigRational| {
                let right = own.formula.as_equation().map(|(_, right)| right);
                let is_it = |part: &Expr| matches!(part, Expr::Number(own) if own == number);
                is_weighed(own) && right.is_some_and(|right| right.any(&is_it))
            };
            written.retain(|number, _| !open.iter().any(|own| is_result(own, number)));
            let left = Cell::new(MOST_TRIED);
            let supported = |figures: &[Assumed], numeric: &Numeric| {
                let with = |said: &[Printed]| match left.get() {
                    0 => numeric.clone(),
                    more => {
                        left.set(more - 1);
                        exactly(figures, said)
                    }
                };
                let constants = || {
                    let found = self.with_constants(at, numeric, figures, &printed, &with);
                    found.map(|own| own.0).filter(Numeric::is_supported)
                };
                self.with_written(at, numeric, &printed, &written, &with)
                    .or_else(constants)
            };
            if let Some(with) = supported(&figures, &numeric) {
                numeric = with;
            } else if lacks_more && has_no_value(&numeric) {
                let mut all = figures.clone();
                all.extend(self.open_figures(judge, premises));
                let with = exactly(&all, &printed);
                match with.is_supported() {
                    true => numeric = with,
                    false => numeric = supported(&all, &with).unwrap_or(numeric),
                }
            }
            let rounded = || weigh(&near, &figures, Taken::Rounded, &printed);
            if *numeric.outcome() == Weighed::Contradicted
                && *rounded().outcome() == Weighed::Contradicted
            {
                let exactly = |goals: &[Goal]| weigh(goals, &figures, Taken::Exactly, &printed);
                let Some(nearest) = self.slip_of_figures(at, &near, &numeric, &exactly) else {
                    return false;
                };
                // What fails by a proof needs no figures.
                if entry.verdict == Verdict::Undecided {
                    numeric.nearest = Some(nearest);
                    entry.notes.push(Note::NumericNotSupported);
                    entry.numeric = Some(numeric.into());
                }
                return true;
            }
        }
        if !numeric.is_supported() {
            return false;
        }
        leave_open(entry, ROUNDED);
        let used = numeric::used(&numeric);
        let unproved = self.unproved(at, &used);
        if !unproved.is_empty() {
            entry.notes.push(Note::RestsOnUnproved(unproved));
        }
        entry.numeric = Some(numeric.into());
        true
    }

    /// What is supported once symbols of which nothing says how great they are stand for numbers that are written there: who writes
    /// `\frac{2 a}{R T} = \frac{2 (0.137)}{(8.314)(300)}` put 8.314 in for `R`.
    fn with_written(
        &self,
        at: usize,
        weighed: &Numeric,
        said: &[Printed],
        written: &Map<BigRational, BigRational>,
        weigh: &dyn Fn(&[Printed]) -> Numeric,
    ) -> Option<Numeric> {
        let is_written = |own: &&Printed| own.equation == Some(at);
        if said.iter().filter(is_written).count() >= MOST_WRITTEN {
            return None;
        }
        let is_open = |own: &&Link| matches!(own.outcome, Weighed::NoValue(_));
        let goal = &weighed.links.iter().find(is_open)?.goal;
        // What is to be worked out is not put in.
        let is_result = |own: &Symbol| weighed.links.iter().any(|link| link.goal.is_of(own));
        let may_be = weighed.unknown.iter().filter(|own| !is_result(own));
        let may_be: Vec<&Symbol> = may_be.take(MOST_UNKNOWN).collect();
        let mut numbers = may_be
            .iter()
            .flat_map(|&own| written.keys().map(move |number| (own, number)));
        numbers.find_map(|(symbol, number)| {
            let mut said = said.to_vec();
            said.push(Printed {
                goal: Goal {
                    formula: Formula::equal(
                        Expr::Symbol(symbol.clone()),
                        Expr::Number(number.clone()),
                    ),
                    rounding: None,
                    ..goal.clone()
                },
                span: self.derivation.equations[at].body,
                equation: Some(at),
                constant: None,
            });
            let with = weigh(&said);
            match with.is_supported() {
                true => Some(with),
                false => self.with_written(at, &with, &said, written, weigh),
            }
        })
    }

    /// What a link that is contradicted says with one small edit, if all is supported with that.
    pub(super) fn slip_of_figures(
        &self,
        at: usize,
        goals: &[Goal],
        weighed: &Numeric,
        exactly: &dyn Fn(&[Goal]) -> Numeric,
    ) -> Option<Formula> {
        let is_wrong = |own: &Link| own.outcome == Weighed::Contradicted;
        let wrong = weighed.links.iter().position(is_wrong)?;
        let claim = self.derivation.claim(at, &[], &goals[wrong].formula);
        let slips = Slips::of(&claim, &InChain::default(), None, values_at);
        // What is printed may be said of another case; that nobody meant it at all is less likely.
        let names = goals[wrong].formula.names();
        let mut edits = (slips.take(MOST_EDITS).map(|edit| edit.formula))
            .filter(|formula| names.is_subset(&formula.names()));
        edits.find(|formula| {
            let mut edited = goals.to_vec();
            edited[wrong].formula = formula.clone();
            exactly(&edited).is_supported()
        })
    }
}
