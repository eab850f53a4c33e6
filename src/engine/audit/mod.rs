//! The audit: every equation of a derivation judged, in reading order.
//!
//! One failing step does not drown the rest: each is judged from the premises it cites, as they are written.
//! A step that does not follow from these is tried once more from what stands before it, so that a stale
//! citation is told apart from an error.
//!
//! `equation` goes through the statements of an equation, `statement` through the links of a statement, and `judge` decides a link: what is tried
//! when it does not follow is in `again`, what is weighed rather than proved in `numeric`. `premise` says what all of them may use, and
//! `review` what falls with what fails.

mod again;
mod along;
mod averaged;
mod branch;
mod cases;
mod cited;
mod constant;
mod dimensions;
mod domain;
mod dots;
mod entry;
mod equation;
mod family;
mod given;
mod identity;
mod induction;
mod instances;
mod judge;
mod least;
mod mark;
mod moving;
mod nature;
mod numeric;
mod premise;
mod propagated;
mod readings;
mod rests;
mod review;
mod roots;
mod scaling;
mod schedule;
mod shifted;
mod slip;
mod stated;
mod statement;
mod warranted;
mod without;

use std::cell::{Ref, RefCell};
use std::ops::Range;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};

use crate::algebra::effort;
use crate::derivation::Derivation;
use crate::kernel::Assignment;
use crate::parallel::threads;
use crate::sorted::Map;

pub use dimensions::{Dimensions, Tells};
use entry::blank;
pub use entry::{Entry, Judged, Note, Outcome, Verdict};
pub use family::{Counterexamples, changes, counterexamples, is_idle, true_besides};
pub use numeric::{FAR, Link, Numeric, Weighed};
use premise::Offer;
pub use readings::OtherReading;
pub use review::{Fallen, Review};
use schedule::Schedule;
pub use without::{Without, without_each};

/// How much exact arithmetic a statement is worth, in units of [`effort`]: about a second, where all of the
/// report takes a few hundredths of one.
const MOST_WORK: u64 = 8_000_000;
/// How many points at which premises held are tried again on the next ones.
const REMEMBERED_POINTS: usize = 4;

/// The audit of a derivation.
#[derive(Clone, Debug)]
pub struct Audit {
    /// One entry for each statement of each equation, in reading order.
    pub entries: Vec<Entry>,
    /// What is known of dimensions.
    pub dimensions: Dimensions,
}

impl Audit {
    /// Judges every equation, several pages at a time where there is more than one processor.
    ///
    /// A page waits for what it needs of an earlier one, so the result does not depend on how many work at it.
    pub fn of(derivation: &Derivation) -> Audit {
        Audit::by(derivation, threads(), &AtomicUsize::new(0))
    }

    /// The same by at most so many threads; the number of equations that are done can be read meanwhile.
    pub fn by(derivation: &Derivation, threads: usize, progress: &AtomicUsize) -> Audit {
        Audit::with(derivation, |_| true, threads, progress)
    }

    /// Judges some equations, by their positions, with all that their verdicts depend on: as the whole audit would, only that
    /// others may be missing. Where many steps miss what they cite by the same number, it is not said.
    pub fn of_these(derivation: &Derivation, wanted: &[usize]) -> Audit {
        let is_wanted = |at: usize| wanted.contains(&at);
        Audit::with(derivation, is_wanted, threads(), &AtomicUsize::new(0))
    }

    fn with(
        derivation: &Derivation,
        is_wanted: impl Fn(usize) -> bool,
        threads: usize,
        progress: &AtomicUsize,
    ) -> Audit {
        let shared = Shared {
            derivation,
            schedule: Schedule::new(derivation, is_wanted),
            dimensions: OnceLock::new(),
            givens: derivation.pages.iter().map(|_| OnceLock::new()).collect(),
            moving: derivation.pages.iter().map(|_| OnceLock::new()).collect(),
            duplicates: derivation.duplicates().into_iter().collect(),
            done: derivation
                .equations
                .iter()
                .map(|_| OnceLock::new())
                .collect(),
            progress,
        };
        let is_done = |at: usize| shared.done[at].get().is_some();
        let work = || {
            while let Some(part) = shared.schedule.take(is_done) {
                shared.part(part);
            }
        };
        std::thread::scope(|scope| {
            for _ in 1..threads.min(shared.schedule.len()) {
                scope.spawn(work);
            }
            // The others begin without them.
            let dimensions = catch_unwind(AssertUnwindSafe(|| Dimensions::of(derivation)));
            let _ = shared.dimensions.set(dimensions.unwrap_or_default());
            work();
        });
        let shifted = effort::within(MOST_WORK, || shifted::gather(&shared));
        let done = shared.done.into_iter().filter_map(OnceLock::into_inner);
        let mut entries: Vec<Entry> = done.flat_map(|done| done.entries).collect();
        for (at, note) in shifted {
            let notes = &mut entries[at].notes;
            notes.retain(|n| !matches!(n, Note::Miscited { .. }));
            notes.push(note);
        }
        cited::forgive_rows(derivation, &mut entries);
        Audit {
            entries,
            dimensions: shared.dimensions.into_inner().unwrap_or_default(),
        }
    }

    /// The entries of one equation.
    pub fn of_equation(&self, at: usize) -> &[Entry] {
        entry::of_equations(&self.entries, at..at + 1)
    }

    /// How many entries have each verdict.
    pub fn counts(&self) -> Map<Verdict, usize> {
        let mut counts: Map<Verdict, usize> = Verdict::ALL.iter().map(|&v| (v, 0)).collect();
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

/// What is known of an equation once it is judged.
struct Done {
    entries: Vec<Entry>,
    offer: Offer,
}

/// What all who work at an audit share.
struct Shared<'a> {
    derivation: &'a Derivation,
    schedule: Schedule,
    /// The dimensions of all pages, once they are inferred.
    dimensions: OnceLock<Dimensions>,
    /// What is given on each page, once somebody has looked at it.
    givens: Vec<OnceLock<given::Models>>,
    /// What each page says of what moves, once it is asked for.
    moving: Vec<OnceLock<moving::Moving>>,
    duplicates: Map<usize, usize>,
    /// Filled in reading order within each part.
    done: Vec<OnceLock<Done>>,
    /// How many are filled.
    progress: &'a AtomicUsize,
}

impl Shared<'_> {
    /// What was found of an equation, once it is.
    fn finished(&self, at: usize) -> &Done {
        while self.done[at].get().is_none()
            && let Some(part) = self.schedule.take_until(at)
        {
            self.part(part);
        }
        self.done[at].wait()
    }

    /// Judges some neighbouring equations of one page.
    fn part(&self, equations: Range<usize>) {
        let Some(first) = self.derivation.equations.get(equations.start) else {
            return;
        };
        let page = first.page;
        let models = || given::models(self.derivation, page);
        let givens = self.givens[page]
            .get_or_init(|| catch_unwind(AssertUnwindSafe(models)).unwrap_or_default());
        let auditor = Auditor::new(self, givens, vec![givens.point.clone()]);
        for at in equations {
            // Others may be waiting for this equation: whatever happens, there is a result.
            let result = catch_unwind(AssertUnwindSafe(|| auditor.done(at)));
            let done = result.unwrap_or_else(|_| auditor.given_up(at));
            let _ = self.done[at].set(done);
            self.progress.fetch_add(1, Ordering::Relaxed);
        }
    }
}

/// Judges neighbouring equations, one after another.
struct Auditor<'a> {
    shared: &'a Shared<'a>,
    derivation: &'a Derivation,
    givens: &'a given::Models,
    /// Points at which premises were found to hold together, the latest first.
    points: RefCell<Vec<Assignment>>,
}

impl<'a> Auditor<'a> {
    fn new(shared: &'a Shared<'a>, givens: &'a given::Models, points: Vec<Assignment>) -> Self {
        Auditor {
            shared,
            derivation: shared.derivation,
            givens,
            points: RefCell::new(points),
        }
    }
}

impl Auditor<'_> {
    /// Points at which premises of the page are known to hold.
    fn hints(&self) -> Ref<'_, Vec<Assignment>> {
        self.points.borrow()
    }

    fn remember(&self, point: &Assignment) {
        let mut points = self.points.borrow_mut();
        if !points.contains(point) {
            points.insert(0, point.clone());
            points.truncate(REMEMBERED_POINTS);
        }
    }

    fn done(&self, at: usize) -> Done {
        let mut entries = self.equation(at);
        if let (Some(&original), Some(entry)) =
            (self.shared.duplicates.get(&at), entries.first_mut())
        {
            entry.notes.push(Note::DuplicateTag(original));
        }
        let given = entries
            .iter()
            .all(|e| e.verdict == Verdict::Given && e.judged.is_empty());
        let offer = match given {
            true => Offer::given(self.derivation, at),
            false => Offer::judged(self.derivation, at, &entries, |premise| {
                self.offer(at, premise)
            }),
        };
        self.shared.dimensions.wait().mark(&mut entries);
        Done { entries, offer }
    }

    /// The result for an equation at which the search broke down.
    fn given_up(&self, at: usize) -> Done {
        let mut entry = blank(
            at,
            0,
            1,
            self.derivation.equations[at].kind,
            Verdict::Undecided,
        );
        entry.notes.push(Note::GivenUp);
        Done {
            entries: vec![entry],
            offer: Offer::given(self.derivation, at),
        }
    }

    /// What an earlier equation offers; nothing for one that is not yet judged when its turn has not come.
    fn offer(&self, at: usize, premise: usize) -> Option<&Offer> {
        (premise < at).then(|| &self.shared.finished(premise).offer)
    }

    /// The entries of an equation before the one at `at`; none of what is cited and comes only later, which may wait for that one.
    fn entries_of(&self, at: usize, premise: usize) -> impl Iterator<Item = &Entry> {
        let before = (premise < at).then(|| self.shared.finished(premise));
        before.into_iter().flat_map(|own| &own.entries)
    }
}
