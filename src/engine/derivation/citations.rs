//! Which equations are cited: by number, by name or by key, and what an equation is said to follow from.

use std::sync::Arc;

use crate::document::{Citation, Premise, Span};
use crate::notation::Spanned;

use super::Derivation;
use super::equation::Equation;
use super::page::Premises;

/// A longer range of numbers is a slip of the pen; only its ends are read.
const LONGEST_RANGE: usize = 1000;
/// The most rows of one display that the last of them is taken to follow from where nothing is said.
const MOST_ROWS: usize = 16;

/// A citation that leads nowhere.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unknown {
    /// What is cited.
    pub label: String,
    /// Where.
    pub span: Span,
}

impl Derivation {
    /// The equation with a number (`23`) or a name.
    pub fn find(&self, label: &str) -> Option<&Equation> {
        let label = label.trim().trim_start_matches('(').trim_end_matches(')');
        let named = label.strip_prefix("claim ").unwrap_or(label).trim();
        let found = self
            .labels
            .get(&format!("({label})"))
            .or_else(|| self.labels.get(named))
            .or_else(|| self.labels.get(&format!("{{{label}}}")));
        found
            .and_then(|all| all.first())
            .map(|&at| &self.equations[at])
    }

    /// The equations that bear the same number or name as an earlier one.
    pub fn duplicates(&self) -> Vec<(usize, usize)> {
        let several = self.labels.values().filter(|all| all.len() > 1);
        let mut duplicates: Vec<(usize, usize)> = several
            .flat_map(|all| all[1..].iter().map(|&at| (at, all[0])))
            .filter(|&(at, first)| !self.counted_apart(at, first))
            .filter(|&(at, first)| !self.rows_of(first).contains(&at))
            .collect();
        duplicates.sort_unstable();
        duplicates.dedup_by_key(|pair| pair.0);
        duplicates
    }

    /// Whether LaTeX numbers two equations in two documents: each begins with (1).
    fn counted_apart(&self, one: usize, other: usize) -> bool {
        let document = |at: usize| &self.pages[self.equations[at].page].document;
        let typeset = |at: usize| document(at).is_latex;
        typeset(one)
            && typeset(other)
            && !Arc::ptr_eq(&document(one).origin, &document(other).origin)
    }

    /// The equations that a citation on a page means: of the same page before others; one, unless several share the
    /// number. `label` is as [`Derivation::labels`] has it, and `other` is tried where there is none.
    fn resolve(&self, label: &str, other: &str, page: usize) -> Vec<usize> {
        // Thousands of pages may each have a (1), in reading order.
        let own = |all: &[usize]| {
            let start = all.partition_point(|&at| self.equations[at].page < page);
            start..all.partition_point(|&at| self.equations[at].page <= page)
        };
        for label in [label, other] {
            if let Some(all) = self.labels.get(label) {
                let near = all[own(all)].first();
                let first = near.or_else(|| all.first());
                return first.map_or(Vec::new(), |&at| self.rows_of(at).collect());
            }
            if let Some(all) = self.groups.get(label) {
                let near = &all[own(all)];
                return if near.is_empty() {
                    all.clone()
                } else {
                    near.to_vec()
                };
            }
        }
        Vec::new()
    }

    /// The equations that prose cites, in order.
    fn cited(&self, citation: &Citation, page: usize) -> Vec<usize> {
        let find = |tag: &str| {
            let (tag, key) = (format!("({tag})"), format!("{{{tag}}}"));
            match citation.key {
                true => self.resolve(&key, &tag, page),
                false => self.resolve(&tag, &key, page),
            }
        };
        let mut found = find(&citation.tag);
        if let Some(last) = &citation.through
            && let (Some(&from), Some(&to)) = (found.first(), find(last).last())
            && from < to
            && to - from <= LONGEST_RANGE
        {
            let numbered = |at: &usize| self.equations[*at].tag.is_some();
            found = (from..to).filter(numbered).collect();
        }
        found
    }

    /// The number of an equation, where that is a whole number in plain figures.
    pub fn number(&self, at: usize) -> Option<i64> {
        let tag = self.equations[at].tag.as_deref()?;
        let figures = tag.len() <= 9 && tag.bytes().all(|b| b.is_ascii_digit());
        figures.then(|| tag.parse().ok()).flatten()
    }

    /// The equation that a number cited on a page means.
    pub fn numbered(&self, number: i64, page: usize) -> Option<usize> {
        let (tag, key) = (format!("({number})"), format!("{{{number}}}"));
        self.resolve(&tag, &key, page).first().copied()
    }

    /// The equations that an equation is said to follow from, whether it says so itself, and the
    /// citations that lead nowhere.
    ///
    /// A directive names them; without one the prose does; where that cites none it is the equation just
    /// before. What goes on with the equations before it in its display follows from them too, and whoever cites it
    /// cites them.
    pub fn premises(&self, at: usize) -> (&[usize], bool, &[Unknown]) {
        let (premises, says_so, unknown) = &self.cites[at];
        (premises, *says_so, unknown)
    }

    /// The same, found where the equations of all pages are known.
    pub(super) fn find_premises(&self, at: usize) -> (Vec<usize>, bool, Vec<Unknown>) {
        let equation = &self.equations[at];
        let (mut found, mut unknown) = (Vec::new(), Vec::new());
        let mut cite = |premises: Vec<usize>, shown: String, span: Span, required: bool| {
            if premises.is_empty() && required {
                unknown.push(Unknown { label: shown, span });
            }
            for premise in premises {
                let chain = premise - self.equations[premise].continues.min(premise);
                for premise in chain..=premise {
                    if premise != at && !found.contains(&premise) {
                        found.push(premise);
                    }
                }
            }
        };
        let says_so = match &equation.premises {
            Premises::Named(named) => {
                for Spanned { value, span } in named {
                    let (premises, shown) = match value {
                        Premise::Tag(tag) => {
                            let (label, key) = (format!("({tag})"), format!("{{{tag}}}"));
                            (self.resolve(&label, &key, equation.page), label)
                        }
                        Premise::Claim(name) => {
                            let shown = format!("claim {name}");
                            (self.resolve(name, name, equation.page), shown)
                        }
                    };
                    cite(premises, shown, *span, true);
                }
                true
            }
            Premises::Cited(cited) => {
                for citation in cited {
                    let premises = self.cited(citation, equation.page);
                    let shown = format!("({})", citation.tag);
                    cite(premises, shown, citation.span, citation.explicit);
                }
                !found.is_empty() || !unknown.is_empty()
            }
        };
        if says_so
            && equation.relative
            && let Some(before) = at.checked_sub(equation.row + 1)
            && self.equations[before].page == equation.page
            && !found.contains(&before)
        {
            found.push(before);
            found.sort_unstable();
        }
        if !says_so {
            // The equation before the display, and those before this one in it; what is put at one moment stands between a law and what
            // follows from it.
            let mut first = at - (equation.row + 1).min(at);
            while !self.equations[first].moments.is_empty() && first > 0 {
                first -= (self.equations[first].row + 1).min(first);
            }
            // Laws that are written one below the other are one.
            while self.equations[first].joined && first > 0 {
                first -= 1;
            }
            let near = (first..at).rev().take(MOST_ROWS);
            found.extend(near.filter(|&p| self.equations[p].page == equation.page));
            found.sort_unstable();
        }
        for premise in at - equation.continues.min(at)..at {
            if !found.contains(&premise) {
                found.push(premise);
            }
        }
        if equation.row > 0 {
            unknown.clear();
        }
        (found, says_so, unknown)
    }
}

pub(super) fn tag_key(tag: Option<&str>) -> Option<String> {
    tag.map(|tag| format!("({tag})"))
}

pub(super) fn name_key(name: Option<&str>) -> Option<String> {
    name.map(str::to_owned)
}
