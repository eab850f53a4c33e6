//! Citations that are all off by the same number, as where a section was once numbered from 1.

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::OnceLock;

use crate::derivation::{Assumed, Source, goals};
use crate::kernel::Standing;
use crate::search::{self, Effort};

use super::judge::Judge;
use super::premise::usable;
use super::{Auditor, Entry, Note, Shared, given};

/// How many shifts are looked at: the commonest first.
const MOST_SHIFTS: usize = 12;
/// So many proofs are looked for; a step that is found to follow from the numbers themselves needs none.
const MOST_PROOFS: usize = 100;
/// Of each step so many citations are compared with what it follows from.
const MOST_CITED: usize = 12;
/// A shift is one where it explains so many steps.
const FEWEST: usize = 2;

/// A step that does not follow from what it cites.
struct Miscited {
    entry: usize,
    page: usize,
    cited: Vec<usize>,
    instead: Vec<Source>,
}

/// Puts one finding in the place of many where every miscited step of a page follows once the same number is added to
/// all that it cites. Pages with the same shift are taken together. What comes out are the notes to put in the place of
/// `miscited`, with the positions of their entries.
pub(super) fn gather(shared: &Shared<'_>) -> Vec<(usize, Note)> {
    let done = shared.done.iter().filter_map(OnceLock::get);
    let entries: Vec<&Entry> = done.flat_map(|done| &done.entries).collect();
    let entries = &entries[..];
    let mut notes: Vec<(usize, Note)> = Vec::new();
    let all = miscited(shared, entries);
    if all.len() < FEWEST {
        return notes;
    }
    let mut budget = MOST_PROOFS;
    let mut votes: BTreeMap<i64, usize> = BTreeMap::new();
    for step in &all {
        for shift in shifts(shared, step) {
            *votes.entry(shift).or_default() += 1;
        }
    }
    let mut order: Vec<(i64, usize)> = votes.into_iter().collect();
    order.sort_by_key(|&(shift, number)| (std::cmp::Reverse(number), shift.abs(), shift));
    let mut settled: BTreeSet<usize> = BTreeSet::new();
    let mut of_page: BTreeMap<usize, Vec<&Miscited>> = BTreeMap::new();
    for step in &all {
        of_page.entry(step.page).or_default().push(step);
    }
    for (by, _) in order.into_iter().take(MOST_SHIFTS) {
        let mut explained: Vec<&Miscited> = Vec::new();
        for (_, own) in of_page.iter().filter(|(page, _)| !settled.contains(page)) {
            if own
                .iter()
                .all(|step| is_explained(shared, entries, step, by, &mut budget))
            {
                explained.extend(own.iter().copied());
            }
        }
        if explained.len() < FEWEST {
            continue;
        }
        settled.extend(explained.iter().map(|step| step.page));
        let steps: Vec<usize> = explained
            .iter()
            .map(|step| entries[step.entry].equation)
            .collect();
        for (at, step) in explained.into_iter().enumerate() {
            let note = Note::CitationsShifted {
                by,
                cited: step.cited.clone(),
                instead: step.instead.clone(),
                steps: if at == 0 { steps.clone() } else { Vec::new() },
            };
            notes.push((step.entry, note));
        }
    }
    notes
}

fn miscited(shared: &Shared<'_>, entries: &[&Entry]) -> Vec<Miscited> {
    let found = entries.iter().enumerate().flat_map(|(at, entry)| {
        let page = shared.derivation.equations[entry.equation].page;
        entry.notes.iter().filter_map(move |note| match note {
            Note::Miscited { cited, instead } => Some(Miscited {
                entry: at,
                page,
                cited: cited.clone(),
                instead: instead.clone(),
            }),
            _ => None,
        })
    });
    found.collect()
}

/// What takes a number that is cited to one of what the step follows from.
fn shifts(shared: &Shared<'_>, step: &Miscited) -> BTreeSet<i64> {
    let number = |at: usize| shared.derivation.number(at);
    let meant = step.instead.iter().filter_map(|source| match source {
        Source::Equation(at) => number(*at),
        _ => None,
    });
    let meant: Vec<i64> = meant.take(MOST_CITED).collect();
    let cited = step
        .cited
        .iter()
        .filter_map(|&at| number(at))
        .take(MOST_CITED);
    let differences = cited.flat_map(|from| meant.iter().map(move |to| to - from));
    differences.filter(|&shift| shift != 0).collect()
}

/// Whether a step follows from what it cites once `by` is added to every number, with the equation just before it and
/// what it needs and has no number.
fn is_explained(
    shared: &Shared<'_>,
    entries: &[&Entry],
    step: &Miscited,
    by: i64,
    budget: &mut usize,
) -> bool {
    let derivation = shared.derivation;
    let at = entries[step.entry].equation;
    let mut targets: Vec<usize> = Vec::new();
    let mut any = false;
    for &cited in &step.cited {
        let Some(number) = derivation.number(cited) else {
            targets.push(cited);
            continue;
        };
        any = true;
        let target = number
            .checked_add(by)
            .and_then(|n| derivation.numbered(n, step.page));
        match target {
            Some(target) if target < at => targets.push(target),
            _ => return false,
        }
    }
    if !any {
        return false;
    }
    if at > 0 && derivation.equations[at - 1].page == step.page {
        targets.push(at - 1);
    }
    let needed = step.instead.iter().filter_map(|source| match source {
        Source::Equation(premise) => Some(*premise),
        _ => None,
    });
    let (numbered, named): (Vec<usize>, Vec<usize>) =
        needed.partition(|&premise| derivation.number(premise).is_some());
    if numbered.iter().all(|premise| targets.contains(premise)) {
        return true;
    }
    let Some(left) = budget.checked_sub(1) else {
        return false;
    };
    *budget = left;
    targets.extend(named);
    targets.dedup();
    follows(shared, entries[step.entry], &targets)
}

/// Whether a step follows from equations, by the kernel.
fn follows(shared: &Shared<'_>, entry: &Entry, premises: &[usize]) -> bool {
    let derivation = shared.derivation;
    let at = entry.equation;
    let models = given::Models::default();
    let auditor = Auditor {
        shared,
        derivation,
        givens: &models,
        points: RefCell::new(Vec::new()),
    };
    let own = usable(
        derivation,
        |premise| auditor.offer(at, premise),
        at,
        premises,
    );
    let judge = Judge {
        derivation,
        at,
        usable: &own,
        others: None,
        auditor: &auditor,
    };
    let Some(statement) = derivation.equations[at].statements().get(entry.part) else {
        return false;
    };
    let mut steps: Vec<Assumed> = Vec::new();
    goals(statement).into_iter().all(|goal| {
        let step = |formula: &crate::algebra::Formula| Assumed {
            formula: formula.clone().into(),
            standing: Standing::AtPoint,
            source: Source::Step,
        };
        let mut assumed = own.assumed.clone();
        match goal.suppositions.is_empty() {
            true => assumed.extend(steps.iter().cloned()),
            false => assumed.extend(goal.suppositions.iter().map(step)),
        }
        let claim = derivation.claim(at, &assumed, &goal.formula);
        steps.push(step(&goal.formula));
        match search::is_scaling(&goal.formula) {
            true => search::prove_scaling(&claim).is_some(),
            false => {
                search::prove_unconditionally(claim, Effort::Light).is_some()
                    && !judge.is_contradictory(&assumed, &goal)
            }
        }
    })
}
