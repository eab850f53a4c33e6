//! Whether what is given can all be true together: no audit is vacuous.

use std::ops::Range;

use crate::algebra::{Expr, Formula, Symbol, effort};
use crate::derivation::{Assumed, Derivation, Equation, Kind, Source, formulas};
use crate::kernel::{Assignment, Model};
use crate::search::{Consistency, consistency};
use crate::sorted::Tree;

use super::entry::blank;
use super::{Entry, MOST_WORK, Note, Verdict};

/// More formulas than this in one tangle are not tried.
const MOST_FORMULAS: usize = 40;

/// For each given equation a point at which it and all that hangs together with it holds, or what it contradicts.
#[derive(Default)]
pub(super) struct Models {
    found: Tree<usize, Model>,
    contradictions: Tree<usize, Vec<Source>>,
    /// Where all groups have their models.
    pub point: Assignment,
}

impl Models {
    /// Groups have no symbol in common, so their models can be had at once.
    fn together(&mut self, point: &Assignment) {
        let own = &mut self.point;
        let of = |s: &(Symbol, Symbol)| s.clone();
        own.symbols
            .extend(point.symbols.iter().map(|(s, v)| (s.clone(), v.clone())));
        own.sequences
            .extend(point.sequences.iter().map(|(s, v)| (s.clone(), v.clone())));
        own.derivatives
            .extend(point.derivatives.iter().map(|(s, v)| (of(s), v.clone())));
    }

    pub fn entry(&self, at: usize, part: usize, parts: usize) -> Entry {
        let mut entry = blank(at, part, parts, Kind::Given, Verdict::Given);
        entry.model = self.found.get(&at).cloned();
        if let Some(sources) = self.contradictions.get(&at) {
            entry
                .notes
                .push(Note::InconsistentPremises(sources.clone()));
        }
        entry
    }
}

/// Looks for a model of the givens of a page, one group of equations with common symbols at a time.
pub(super) fn models(derivation: &Derivation, page: usize) -> Models {
    let mut models = Models::default();
    for group in groups(derivation, derivation.equations_of(page)) {
        let assume = |members: &[usize]| -> Vec<Assumed> {
            let all = members.iter().flat_map(|&at| {
                let standing = derivation.standing_among(at, members);
                let statements = derivation.equations[at].statements().iter();
                statements.flat_map(formulas).map(move |formula| Assumed {
                    formula: formula.into(),
                    standing,
                    source: Source::Equation(at),
                })
            });
            all.collect()
        };
        let trivial = Formula::equal(Expr::integer(0), Expr::integer(0));
        let together = |members: &[usize]| {
            let assumed = assume(members);
            if assumed.len() > MOST_FORMULAS {
                return Consistency::Unknown;
            }
            let claim = derivation.claim(members[0], &assumed, &trivial);
            effort::within(MOST_WORK, || consistency(&claim, &[]))
        };
        match together(&group) {
            Consistency::Model(model) => {
                models.together(model.point());
                models
                    .found
                    .extend(group.iter().map(|&at| (at, model.clone())));
            }
            Consistency::Unknown => {}
            Consistency::Contradictory(_) => {
                // The first one that contradicts those before it, and the fewest of these.
                let mut length = 1;
                while !matches!(together(&group[..length]), Consistency::Contradictory(_))
                    && length < group.len()
                {
                    length += 1;
                }
                let mut members = group[..length].to_vec();
                let culprit = members[length - 1];
                let mut at = 0;
                while at + 1 < members.len() {
                    let mut fewer = members.clone();
                    fewer.remove(at);
                    match together(&fewer) {
                        Consistency::Contradictory(_) => members = fewer,
                        _ => at += 1,
                    }
                }
                members.retain(|&m| m != culprit);
                let sources = members.into_iter().map(Source::Equation).collect();
                models.contradictions.insert(culprit, sources);
            }
        }
    }
    models
}

/// The given ones among some equations, grouped so that no symbol occurs in two groups.
fn groups(derivation: &Derivation, among: Range<usize>) -> Vec<Vec<usize>> {
    // Union-find over equations: each symbol joins the equations that it occurs in.
    let start = among.start;
    let mut parent: Vec<usize> = (0..among.len()).collect();
    fn root(parent: &mut [usize], mut at: usize) -> usize {
        while parent[at] != at {
            parent[at] = parent[parent[at]];
            at = parent[at];
        }
        at
    }
    let mut first: Tree<Symbol, usize> = Tree::new();
    // What is said under conditions only is not said at a point.
    let plain = |equation: &Equation| equation.statements().iter().all(|s| s.under.is_empty());
    let is_given = |equation: &Equation| {
        equation.kind == Kind::Given && equation.statements.is_ok() && plain(equation)
    };
    let equations = || {
        let own = derivation.equations[among.clone()].iter();
        own.enumerate().filter(|(_, e)| is_given(e))
    };
    for (at, equation) in equations() {
        for symbol in equation.symbols() {
            let other = *first.entry(symbol).or_insert(at);
            let (a, b) = (root(&mut parent, at), root(&mut parent, other));
            parent[a.max(b)] = a.min(b);
        }
    }
    let mut groups: Tree<usize, Vec<usize>> = Tree::new();
    for (at, _) in equations() {
        let group = groups.entry(root(&mut parent, at)).or_default();
        group.push(start + at);
    }
    groups.into_values().collect()
}
