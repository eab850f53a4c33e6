//! The audit: every equation of a derivation judged, in reading order.
//!
//! One failing step does not drown the rest: each is judged from the premises it cites, as they are written.
//! A step that does not follow from these is tried once more from what stands before it, so that a stale
//! citation is told apart from an error.

mod entry;
mod given;
mod judge;
mod premise;

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet, VecDeque};

use crate::derivation::{Derivation, Kind, Source, goals};
use crate::kernel::Assignment;
use crate::notation::{Mark, Statement};

pub use entry::{Entry, Judged, Note, Outcome, Verdict};
use premise::{Offer, usable};

/// The audit of a derivation.
#[derive(Clone, Debug)]
pub struct Audit {
    /// One entry for each statement of each equation, in reading order.
    pub entries: Vec<Entry>,
}

impl Audit {
    /// Judges every equation.
    pub fn of(derivation: &Derivation) -> Audit {
        let mut auditor = Auditor {
            derivation,
            offers: vec![None; derivation.equations.len()],
            entries: Vec::new(),
            first: Vec::new(),
            points: RefCell::default(),
        };
        let givens = given::models(derivation);
        let duplicates: BTreeMap<usize, usize> = derivation.duplicates().into_iter().collect();
        for at in 0..derivation.equations.len() {
            let start = auditor.entries.len();
            auditor.first.push(start);
            let mut entries = auditor.equation(at, &givens);
            if let (Some(&original), Some(entry)) = (duplicates.get(&at), entries.first_mut()) {
                entry.notes.push(Note::DuplicateTag(original));
            }
            let given = entries
                .iter()
                .all(|e| e.verdict == Verdict::Given && e.judged.is_empty());
            auditor.offers[at] = Some(match given {
                true => Offer::given(derivation, at),
                false => Offer::judged(derivation, at, &entries, &auditor.offers),
            });
            auditor.entries.extend(entries);
        }
        Audit {
            entries: auditor.entries,
        }
    }

    /// The entries of one equation.
    pub fn of_equation(&self, at: usize) -> &[Entry] {
        let start = self.entries.partition_point(|e| e.equation < at);
        let end = self.entries.partition_point(|e| e.equation <= at);
        &self.entries[start..end]
    }

    /// How many entries have each verdict.
    pub fn counts(&self) -> BTreeMap<Verdict, usize> {
        let mut counts: BTreeMap<Verdict, usize> = Verdict::ALL.iter().map(|&v| (v, 0)).collect();
        for entry in &self.entries {
            *counts.entry(entry.verdict).or_default() += 1;
        }
        counts
    }

    /// The entries with something to mend.
    pub fn findings(&self) -> impl Iterator<Item = &Entry> {
        self.entries.iter().filter(|e| e.is_finding())
    }
}

struct Auditor<'a> {
    derivation: &'a Derivation,
    offers: Vec<Option<Offer>>,
    entries: Vec<Entry>,
    /// The first entry of each equation so far.
    first: Vec<usize>,
    /// Points at which premises were found to hold together, the latest first.
    points: RefCell<VecDeque<Assignment>>,
}

impl Auditor<'_> {
    fn equation(&self, at: usize, givens: &given::Models) -> Vec<Entry> {
        let equation = &self.derivation.equations[at];
        let statements = match &equation.statements {
            Ok(statements) => statements,
            Err(error) => {
                let mut entry = blank(at, 0, 1, equation.kind, Verdict::Undecided);
                entry.notes.push(Note::Unreadable(error.clone()));
                return vec![entry];
            }
        };
        let parts = statements.len();
        if equation.kind == Kind::Given {
            return (0..parts)
                .map(|part| givens.entry(at, part, parts))
                .collect();
        }
        let (premises, says_so, unknown) = self.derivation.premises(at);
        let usable = usable(self.derivation, &self.offers, at, &premises);
        let mut entries = Vec::new();
        for (part, statement) in statements.iter().enumerate() {
            let defines = equation.defines && part == 0;
            let mut entry = self.statement(at, statement, &usable, &premises, says_so, defines);
            (entry.part, entry.parts) = (part, parts);
            if part == 0 {
                entry.notes.extend(
                    unknown
                        .iter()
                        .map(|u| Note::UnknownCitation(u.label.clone(), u.span)),
                );
                entry
                    .notes
                    .extend(usable.later.iter().map(|&p| Note::CitesLater(p)));
            }
            entries.push(entry);
        }
        let opens = equation.opens && entries.iter().all(|e| e.verdict != Verdict::Holds);
        if opens {
            // A page must begin somewhere: what nothing precedes is given.
            return (0..parts)
                .map(|part| blank(at, part, parts, Kind::Given, Verdict::Given))
                .collect();
        }
        entries
    }

    fn statement(
        &self,
        at: usize,
        statement: &Statement,
        usable: &premise::Usable,
        premises: &[usize],
        says_so: bool,
        defines: bool,
    ) -> Entry {
        let equation = &self.derivation.equations[at];
        let mut entry = blank(at, 0, 1, equation.kind, Verdict::Holds);
        let mut judge = judge::Judge {
            derivation: self.derivation,
            at,
            usable,
            others: None,
            auditor: self,
        };
        let mut steps: Vec<(usize, crate::algebra::Formula)> = Vec::new();
        let mut instead: BTreeSet<Source> = BTreeSet::new();
        for (position, goal) in goals(statement).into_iter().enumerate() {
            if defines && position == 0 {
                let outcome = Outcome::Defined;
                steps.push((goal.clause, goal.formula.clone()));
                entry.judged.push(Judged {
                    goal,
                    assumed: Vec::new(),
                    outcome,
                });
                continue;
            }
            let found = judge.goal(&goal, &steps, premises);
            if matches!(found.judged.outcome, Outcome::Proven(_)) && goal.suppositions.is_empty() {
                steps.push((goal.clause, goal.formula.clone()));
            } else if statement.clauses.len() > 1 && goal.suppositions.is_empty() {
                // The next clause of an implication is judged as if this one were true.
                steps.push((goal.clause, goal.formula.clone()));
            }
            if !found.conditions.is_empty() {
                entry.notes.push(Note::UnstatedCondition(found.conditions));
            }
            if !found.contradictory.is_empty() {
                entry
                    .notes
                    .push(Note::InconsistentPremises(found.contradictory));
            }
            instead.extend(found.instead);
            entry.judged.push(found.judged);
        }
        entry.verdict = verdict(&entry.judged, defines);
        if defines && entry.judged.len() == 1 {
            entry.kind = Kind::Given;
        }
        let used: BTreeSet<usize> = entry
            .judged
            .iter()
            .flat_map(|j| j.assumed.iter())
            .filter_map(|a| match a.source {
                Source::Equation(premise) => Some(premise),
                _ => None,
            })
            .collect();
        if !instead.is_empty() {
            let note = match says_so && !premises.is_empty() {
                true => Note::Miscited {
                    cited: premises.to_vec(),
                    instead: instead.into_iter().collect(),
                },
                false => Note::Uncited(instead.into_iter().collect()),
            };
            entry.notes.push(note);
        }
        if says_so && (entry.verdict != Verdict::Holds || !entry.notes.is_empty()) {
            let missing = usable.out_of_scope.iter();
            entry.notes.extend(missing.map(|&p| Note::OutOfScope(p)));
        }
        // The premise that could not be read may be just what is needed.
        if entry.verdict == Verdict::Fails && !usable.unreadable.is_empty() {
            entry.verdict = Verdict::Undecided;
        }
        if entry.verdict == Verdict::Undecided {
            entry.notes.extend(
                usable
                    .unreadable
                    .iter()
                    .map(|&p| Note::UnreadablePremise(p)),
            );
        }
        entry.premises = used.iter().copied().collect();
        if entry.verdict == Verdict::Holds {
            entry.rests_on = self.failing(&used);
            if !entry.rests_on.is_empty() {
                entry.notes.insert(0, Note::RestsOn(entry.rests_on.clone()));
            }
            let open = self.unproved(&used);
            if !open.is_empty() {
                entry.notes.push(Note::RestsOnUnproved(open));
            }
        }
        self.mark(statement, &mut entry);
        entry
    }

    /// The failing equations among premises, and those that these rest on.
    fn failing(&self, premises: &BTreeSet<usize>) -> Vec<usize> {
        let mut failing = BTreeSet::new();
        for &premise in premises.iter().filter(|&&p| p < self.first.len()) {
            for entry in self.entries_of(premise) {
                if entry.verdict == Verdict::Fails && !entry.fails_as_marked() {
                    failing.insert(premise);
                }
                failing.extend(&entry.rests_on);
            }
        }
        failing.into_iter().collect()
    }

    /// The premises that are not proved themselves, or only under a condition that nothing states, and those
    /// that these rest on.
    fn unproved(&self, premises: &BTreeSet<usize>) -> Vec<usize> {
        let mut open = BTreeSet::new();
        for &premise in premises.iter().filter(|&&p| p < self.first.len()) {
            for entry in self.entries_of(premise) {
                let conditional = entry
                    .notes
                    .iter()
                    .any(|n| matches!(n, Note::UnstatedCondition(_)));
                if entry.verdict == Verdict::Undecided || conditional {
                    open.insert(premise);
                }
                for note in &entry.notes {
                    if let Note::RestsOnUnproved(others) = note {
                        open.extend(others);
                    }
                }
            }
        }
        open.into_iter().collect()
    }

    fn entries_of(&self, at: usize) -> impl Iterator<Item = &Entry> {
        let start = self.first.get(at).copied().unwrap_or(self.entries.len());
        self.entries[start..]
            .iter()
            .take_while(move |e| e.equation == at)
    }

    /// Whether the author's ✓ or ✗ is right.
    fn mark(&self, statement: &Statement, entry: &mut Entry) {
        let Some(mark) = &statement.mark else {
            return;
        };
        // `a ≠ b ✗` crosses out the law `a = b` that the author tested, and says so twice.
        let denied = entry.judged.iter().any(|j| {
            matches!(
                &j.goal.formula,
                crate::algebra::Formula::Relation {
                    relation: crate::algebra::Relation::NotEqual,
                    ..
                }
            )
        });
        let right = match (mark.value, entry.verdict) {
            (_, Verdict::Undecided) => return,
            (Mark::Tick, verdict) => verdict == Verdict::Holds,
            (Mark::Cross, Verdict::Holds) => denied,
            (Mark::Cross, _) => self.crossed_out_rightly(entry),
        };
        if !right {
            entry.notes.push(Note::WrongMark(mark.value));
        }
    }

    /// Where the author asks with `\stackrel{?}{=}`, that link alone is crossed out; the others must hold.
    fn crossed_out_rightly(&self, entry: &Entry) -> bool {
        let refuted = |j: &&Judged| matches!(j.outcome, Outcome::Refuted(_));
        match entry.judged.iter().any(|j| j.goal.questioned) {
            true => entry
                .judged
                .iter()
                .filter(refuted)
                .all(|j| j.goal.questioned),
            false => true,
        }
    }
}

fn blank(equation: usize, part: usize, parts: usize, kind: Kind, verdict: Verdict) -> Entry {
    Entry {
        equation,
        part,
        parts,
        kind,
        verdict,
        judged: Vec::new(),
        premises: Vec::new(),
        rests_on: Vec::new(),
        notes: Vec::new(),
        model: None,
    }
}

/// What the links together say of the statement.
fn verdict(judged: &[Judged], defines: bool) -> Verdict {
    let any = |test: fn(&Outcome) -> bool| judged.iter().any(|j| test(&j.outcome));
    if any(|o| matches!(o, Outcome::Refuted(_))) {
        Verdict::Fails
    } else if judged.is_empty() || any(|o| matches!(o, Outcome::Open(_))) {
        Verdict::Undecided
    } else if defines && judged.len() == 1 {
        Verdict::Given
    } else {
        Verdict::Holds
    }
}
