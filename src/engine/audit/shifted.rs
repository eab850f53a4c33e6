//! Citations that are all off by the same number, as where a section was once numbered from 1.

use std::cmp::Reverse;
use std::sync::OnceLock;

use crate::derivation::{Assumed, Source, goals};
use crate::search::{self, Effort};

use super::judge::{Judge, step};
use super::premise::usable;
use super::{Auditor, Entry, Note, Shared, given};
use crate::sorted::{self, Map, Set};

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

/// What a shift comes to.
#[derive(Default)]
struct Shift<'a> {
    by: i64,
    /// The steps that it explains on pages where it explains all of which it can be told.
    explained: Vec<&'a Miscited>,
    /// The pages on which it explains any, or might if nothing were wrong: no other number is told of these.
    touched: Set<usize>,
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
    let mut votes: Map<i64, usize> = Map::new();
    for step in &all {
        for shift in shifts(shared, step) {
            *votes.entry(shift).or_default() += 1;
        }
    }
    let mut order: Vec<(i64, usize)> = votes.into_iter().collect();
    sorted::sort_by_key(&mut order, |&(shift, number)| {
        (Reverse(number), shift.abs(), shift)
    });
    let mut found: Vec<Shift<'_>> = Vec::new();
    for (by, _) in order.into_iter().take(MOST_SHIFTS) {
        let shift = weighed(shared, entries, &all, by, &mut budget);
        // One number for all of them is what was meant.
        if shift.explained.len() == all.len() {
            found = vec![shift];
            break;
        }
        found.push(shift);
    }
    sorted::sort_by_key(&mut found, |shift| Reverse(shift.explained.len()));
    let mut touched: Set<usize> = Set::new();
    for mut shift in found {
        shift.explained.retain(|step| !touched.contains(&step.page));
        if shift.explained.len() < FEWEST {
            continue;
        }
        touched.extend(shift.touched);
        let steps = shift.explained.iter();
        let steps: Vec<usize> = steps.map(|step| entries[step.entry].equation).collect();
        for (at, step) in shift.explained.into_iter().enumerate() {
            let note = Note::CitationsShifted {
                by: shift.by,
                cited: step.cited.clone(),
                instead: step.instead.clone(),
                steps: if at == 0 { steps.clone() } else { Vec::new() },
            };
            notes.push((step.entry, note));
        }
    }
    notes
}

fn weighed<'a>(
    shared: &Shared<'_>,
    entries: &[&Entry],
    all: &'a [Miscited],
    by: i64,
    budget: &mut usize,
) -> Shift<'a> {
    let mut shift = Shift {
        by,
        ..Shift::default()
    };
    for own in all.chunk_by(|one, other| one.page == other.page) {
        let mut explained = Vec::new();
        let (mut is_against, mut is_open) = (false, false);
        for step in own {
            match is_explained(shared, entries, step, by, budget) {
                Some(true) => explained.push(step),
                Some(false) => is_against = true,
                None => is_open = true,
            }
        }
        if is_open || !explained.is_empty() {
            shift.touched.insert(own[0].page);
        }
        if !is_against {
            shift.explained.extend(explained);
        }
    }
    shift
}

/// Whether an equation is no mistake, and comes from none.
fn is_sound(shared: &Shared<'_>, at: usize) -> bool {
    let done = shared.done[at].get();
    let mut entries = done.iter().flat_map(|done| &done.entries);
    entries.all(|e| !e.is_mistake() && e.rests_on.is_empty())
}

/// Steps that cite what is right, and do not follow from it. Of what is wrong itself its number need not be.
fn miscited(shared: &Shared<'_>, entries: &[&Entry]) -> Vec<Miscited> {
    let found = entries.iter().enumerate().flat_map(|(at, entry)| {
        let page = shared.derivation.equations[entry.equation].page;
        entry.notes.iter().filter_map(move |note| match note {
            Note::Miscited { cited, instead } if cited.iter().all(|&c| is_sound(shared, c)) => {
                Some(Miscited {
                    entry: at,
                    page,
                    cited: cited.clone(),
                    instead: instead.clone(),
                })
            }
            _ => None,
        })
    });
    found.collect()
}

/// What takes a number that is cited to one of what the step follows from.
fn shifts(shared: &Shared<'_>, step: &Miscited) -> Set<i64> {
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

/// Whether a step follows from exactly what it cites once `by` is added to every number, with what it needs and has no number;
/// if need be with the equation just before it, too. Nothing can be told where one of these is wrong.
fn is_explained(
    shared: &Shared<'_>,
    entries: &[&Entry],
    step: &Miscited,
    by: i64,
    budget: &mut usize,
) -> Option<bool> {
    let derivation = shared.derivation;
    let at = entries[step.entry].equation;
    let mut named: Vec<usize> = Vec::new();
    let mut shifted: Vec<usize> = Vec::new();
    for &cited in &step.cited {
        let Some(number) = derivation.number(cited) else {
            named.push(cited);
            continue;
        };
        let target = number.checked_add(by);
        match target.and_then(|n| derivation.numbered(n, step.page)) {
            Some(target) if target < at => shifted.push(target),
            _ => return Some(false),
        }
    }
    if shifted.is_empty() {
        return Some(false);
    }
    if !shifted.iter().all(|&target| is_sound(shared, target)) {
        return None;
    }
    // What is cited as it is printed and needed is cited rightly.
    let before = at.checked_sub(1).filter(|before| {
        let own_page = derivation.equations[*before].page == step.page;
        own_page && !step.cited.contains(before) && is_sound(shared, *before)
    });
    let needed = step.instead.iter().filter_map(|source| match source {
        Source::Equation(premise) => Some(*premise),
        _ => None,
    });
    let (numbered, others): (Vec<usize>, Vec<usize>) =
        needed.partition(|&premise| derivation.number(premise).is_some());
    let is_meant = |premise: &usize| shifted.contains(premise);
    if numbered.iter().any(is_meant)
        && (numbered.iter()).all(|premise| is_meant(premise) || before == Some(*premise))
    {
        return Some(true);
    }
    named.extend(others);
    let mut proves = |premises: &[usize]| {
        let enough = *budget > 0;
        *budget = budget.saturating_sub(1);
        let mut premises = [premises, &named].concat();
        premises.sort_unstable();
        premises.dedup();
        enough && follows(shared, entries[step.entry], &premises)
    };
    if proves(&shifted) {
        return Some(true);
    }
    let Some(before) = before else {
        return Some(false);
    };
    // What follows from the equation before it alone says nothing of the numbers.
    Some(proves(&[&shifted[..], &[before]].concat()) && !proves(&[before]))
}

/// Whether a step follows from equations, by the kernel.
fn follows(shared: &Shared<'_>, entry: &Entry, premises: &[usize]) -> bool {
    let derivation = shared.derivation;
    let at = entry.equation;
    let models = given::Models::default();
    let auditor = Auditor::new(shared, &models, Vec::new());
    let own = usable(
        derivation,
        |premise| auditor.offer(at, premise),
        at,
        premises,
    );
    let judge = Judge::new(&auditor, at, &own);
    let Some(statement) = derivation.equations[at].statements().get(entry.part) else {
        return false;
    };
    let mut steps: Vec<Assumed> = Vec::new();
    goals(statement).into_iter().all(|goal| {
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
