//! A finished audit looked at again: what falls with a failing equation, and what of it stands without.
//!
//! None of this is done in the audit itself: it answers questions that are asked afterwards.

use std::sync::OnceLock;
use std::sync::atomic::AtomicUsize;

use crate::algebra::{Formula, effort};
use crate::derivation::{Assumed, Derivation, Goal, Source, goals};
use crate::kernel::Assignment;
use crate::search::{self, Effort, Stop};

use super::judge::{Found, Judge, sources, step};
use super::premise::{Offer, Usable, usable};
use super::schedule::Schedule;
use super::{
    Audit, Auditor, Done, Entry, Judged, MOST_WORK, Note, Outcome, Shared, Verdict, given,
};
use crate::sorted::{Map, Set};

/// How many earlier equations are looked at for another way to a step.
const MOST_RELATIVES: usize = 12;
/// How many hypotheses that are not cited are added, and how hard is tried.
const STAGES: [(usize, Effort); 3] = [(2, Effort::Light), (8, Effort::Light), (12, Effort::Full)];
/// More steps than this are not derived anew: a reader of so long a list has other worries.
const MOST_REDERIVED: usize = 200;

/// A step that comes from something false.
#[derive(Clone, Debug)]
pub struct Fallen {
    /// Its position in [`Audit::entries`].
    pub entry: usize,
    /// The failing equations that it comes from.
    pub with: Vec<usize>,
    /// What it follows from all the same, none of which comes from anything false; `None` where no such way was found.
    pub instead: Option<Vec<Source>>,
}

/// An audit with what is needed to judge its steps once more.
pub struct Review<'a> {
    audit: &'a Audit,
    shared: Shared<'a>,
    models: given::Models,
}

/// Nothing is left to be counted.
static FINISHED: AtomicUsize = AtomicUsize::new(0);

impl<'a> Review<'a> {
    /// Takes up an audit of `derivation`.
    pub fn new(derivation: &'a Derivation, audit: &'a Audit) -> Self {
        let mut done: Vec<Done> = Vec::new();
        for at in 0..derivation.equations.len() {
            let entries = audit.of_equation(at).to_vec();
            let given = |e: &Entry| e.verdict == Verdict::Given && e.judged.is_empty();
            let offer = match entries.iter().all(given) {
                true => Offer::given(derivation, at),
                false => Offer::judged(derivation, at, &entries, |premise| {
                    done.get(premise).map(|d| &d.offer)
                }),
            };
            done.push(Done { entries, offer });
        }
        let shared = Shared {
            derivation,
            schedule: Schedule::finished(),
            dimensions: OnceLock::new(),
            givens: Vec::new(),
            moving: derivation.pages.iter().map(|_| OnceLock::new()).collect(),
            duplicates: Map::new(),
            done: done.into_iter().map(OnceLock::from).collect(),
            progress: &FINISHED,
        };
        Review {
            audit,
            shared,
            models: given::Models::default(),
        }
    }

    /// Every step that comes from something false, in reading order.
    pub fn fallen(&self) -> Vec<Fallen> {
        let mut standing: Set<usize> = Set::new();
        let mut all: Vec<Fallen> = Vec::new();
        for (position, entry) in self.audit.entries.iter().enumerate() {
            if entry.rests_on.is_empty() {
                continue;
            }
            let instead = match all.len() < MOST_REDERIVED {
                true => effort::within(MOST_WORK, || self.without(entry, &standing)),
                false => None,
            };
            // A display of several statements stands where all of them do.
            let first = entry.part == 0;
            match instead.is_some() {
                true if first || standing.contains(&entry.equation) => {
                    standing.insert(entry.equation);
                }
                true => {}
                false => {
                    standing.remove(&entry.equation);
                }
            }
            all.push(Fallen {
                entry: position,
                with: entry.rests_on.clone(),
                instead,
            });
        }
        all
    }

    /// What a step follows from that does not come from anything false. `standing` are those known to stand without.
    fn without(&self, entry: &Entry, standing: &Set<usize>) -> Option<Vec<Source>> {
        let derivation = self.shared.derivation;
        let at = entry.equation;
        let is_sound = |&premise: &usize| {
            premise < at && {
                let wrong = |e: &&Entry| e.is_mistake();
                let own = || self.audit.of_equation(premise).iter();
                !own().any(|e| wrong(&e))
                    && (standing.contains(&premise) || own().all(|e| e.rests_on.is_empty()))
            }
        };
        if entry.premises.iter().all(is_sound) {
            let used = entry.judged.iter().flat_map(|j| sources(&j.assumed));
            let used: Set<Source> = used.collect();
            return Some(used.into_iter().collect());
        }
        let statement = derivation.equations[at].statements().get(entry.part)?;
        let (cited, ..) = derivation.premises(at);
        let mut cited: Vec<usize> = cited.iter().chain(&entry.premises).copied().collect();
        cited.retain(is_sound);
        cited.dedup();
        let mut others = derivation.relatives(at, MOST_RELATIVES);
        others.retain(|other| is_sound(other) && !cited.contains(other) && self.is_certain(*other));
        let auditor = self.auditor(entry);
        let offer = |premise| auditor.offer(at, premise);
        let own = usable(derivation, offer, at, &cited);
        let gathered = usable(derivation, offer, at, &others).assumed;
        let others: Vec<Assumed> = gathered
            .into_iter()
            .filter(|a| !own.assumed.contains(a))
            .collect();
        let mut used: Set<Source> = Set::new();
        let mut steps: Vec<(usize, Formula)> = Vec::new();
        for goal in goals(statement) {
            used.extend(self.derived(&auditor, at, &own, &others, &goal, &steps)?);
            steps.push((goal.clause, goal.formula));
        }
        Some(used.into_iter().collect())
    }

    /// Whether nothing is left open about an equation.
    fn is_certain(&self, at: usize) -> bool {
        let doubtful =
            |n: &Note| matches!(n, Note::UnstatedCondition(_) | Note::RestsOnUnproved(_));
        self.audit
            .of_equation(at)
            .iter()
            .all(|e| e.verdict != Verdict::Undecided && !e.notes.iter().any(doubtful))
    }

    /// One who judges with the counterexamples to what the step comes from at hand.
    fn auditor(&self, entry: &Entry) -> Auditor<'_> {
        let against = entry.rests_on.iter().rev().take(2);
        let entries = against.flat_map(|&at| self.audit.of_equation(at));
        let points: Vec<Assignment> = entries
            .filter_map(|e| e.refuted())
            .map(|(_, refuted)| refuted.witness().clone())
            .collect();
        Auditor::new(&self.shared, &self.models, points)
    }

    /// Proves one goal, and says from what.
    fn derived(
        &self,
        auditor: &Auditor<'_>,
        at: usize,
        own: &Usable,
        others: &[Assumed],
        goal: &Goal,
        steps: &[(usize, Formula)],
    ) -> Option<Vec<Source>> {
        let mut assumed = own.assumed.clone();
        assumed.extend(goal.suppositions.iter().map(step));
        if goal.suppositions.is_empty() {
            assumed.extend(steps.iter().map(|(_, formula)| step(formula)));
        }
        let judge = Judge {
            others: [others.to_vec(), Vec::new()].into(),
            ..Judge::new(auditor, at, own)
        };
        let mut found = Found::open(Judged {
            goal: goal.clone(),
            assumed: assumed.clone(),
            outcome: Outcome::Open(Stop::default()),
        });
        if search::is_scaling(&goal.formula) {
            judge.scaling(goal, &assumed, &[], &mut found);
        } else {
            let claim = judge.derivation.claim(at, &assumed, &goal.formula);
            if let Ok(posed) = search::pose(claim)
                && let Some(derived) = search::prove_posed(&posed, Effort::Light)
            {
                let (kept, _) = judge.least(assumed, goal, &posed, derived);
                return (!judge.is_contradictory(&kept, goal)).then(|| sources(&kept));
            }
            let attempts = judge.attempts(goal, &assumed, &[], None);
            judge.rescue(goal, &attempts, &STAGES, &mut found);
        }
        let proven = found.judged.outcome.is_proven();
        proven.then(|| sources(&found.judged.assumed))
    }
}
