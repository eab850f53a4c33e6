//! Well-known constants that a text puts in without a word: `m g h = 3.9\,\mathrm{J}` after `m` and `h` alone.
//!
//! A letter may mean something else, so that a constant is taken only for what nothing before tells, and only to support what is said; what
//! is not supported is told where it is with one small edit. Authors round as they like: each value that is usual is tried.

use crate::algebra::{Expr, Formula, Symbol};
use crate::derivation::{Assumed, Goal, Printed};

use super::super::Auditor;
use super::super::nature::CONSTANTS;
use super::{Numeric, Taken, Weighed, weigh_rounded};

/// No more of them are put in at once.
const MOST: usize = 4;

impl Auditor<'_> {
    /// Goals from figures, with what the page prints and constants that nothing tells: supported, or so with one small edit.
    pub(super) fn with_what_is_usual(
        &self,
        at: usize,
        goals: &[Goal],
        figures: &[Assumed],
        printed: &[Printed],
    ) -> Option<Numeric> {
        let weigh = |goals: &[Goal], said: &[Printed]| {
            weigh_rounded(self.derivation, at, goals, figures, Taken::Exactly, said)
        };
        let plainly = weigh(goals, printed);
        if plainly.is_supported() {
            return Some(plainly);
        }
        let with = |said: &[Printed]| weigh(goals, said);
        let (mut numeric, said) = self.with_constants(at, &plainly, figures, printed, &with)?;
        if !numeric.is_supported() {
            let exactly = |goals: &[Goal]| weigh(goals, &said);
            numeric.nearest = self.slip_of_figures(at, goals, &numeric, &exactly);
            numeric.nearest.as_ref()?;
        }
        Some(numeric)
    }

    /// What is come to with constants, where something had no value without: supported, if that is so with any that are usual, and how it
    /// was worked out.
    pub(super) fn with_constants(
        &self,
        at: usize,
        weighed: &Numeric,
        figures: &[Assumed],
        said: &[Printed],
        weigh: &dyn Fn(&[Printed]) -> Numeric,
    ) -> Option<(Numeric, Vec<Printed>)> {
        if !matches!(weighed.outcome(), Weighed::NoValue(_)) {
            return None;
        }
        let goal = &weighed.links.first()?.goal;
        let page = &self.derivation.pages[self.derivation.equations[at].page];
        let is_told = |own: &Symbol| {
            page.domains.contains_key(own)
                || said.iter().any(|printed| printed.goal.is_of(own))
                || weighed.links.iter().any(|link| link.goal.is_of(own))
                || figures.iter().any(|assumed| assumed.is_of(own))
        };
        let constant = |own: &Symbol| {
            let mut all = CONSTANTS.iter();
            let found = all.find(|constant| constant.may_be(own))?;
            (!is_told(own)).then(|| (own.clone(), found))
        };
        let unknown: Vec<_> = weighed
            .unknown
            .iter()
            .filter_map(constant)
            .take(MOST)
            .collect();
        let usual = unknown.iter().map(|(_, own)| own.values.len()).max()?;
        let mut found = None;
        for nearness in 0..usual {
            let mut with = said.to_vec();
            for (symbol, constant) in &unknown {
                let value = Expr::Number(constant.value(nearness)?);
                with.push(Printed {
                    goal: Goal {
                        formula: Formula::equal(Expr::Symbol(symbol.clone()), value),
                        rounding: None,
                        ..goal.clone()
                    },
                    span: self.derivation.equations[at].body,
                    equation: Some(at),
                    constant: Some(constant.name),
                });
            }
            let numeric = weigh(&with);
            match numeric.outcome() {
                Weighed::Supported => return Some((numeric, with)),
                Weighed::Contradicted => found = found.or(Some((numeric, with))),
                _ => return None,
            }
        }
        found
    }
}
