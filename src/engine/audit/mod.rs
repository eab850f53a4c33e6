//! The audit: every equation of a derivation judged, in reading order.
//!
//! One failing step does not drown the rest: each is judged from the premises it cites, as they are written.
//! A step that does not follow from these is tried once more from what stands before it, so that a stale
//! citation is told apart from an error.

mod borrowed;
mod cases;
mod constant;
mod dimensions;
mod domain;
mod entry;
mod family;
mod given;
mod identity;
mod induction;
mod judge;
mod least;
mod limiting;
mod moving;
mod named;
mod numeric;
mod premise;
mod readings;
mod review;
mod roots;
mod rounded;
mod scaling;
mod schedule;
mod shifted;
mod stated;
mod throughout;
mod unstated;
mod without;

use std::cell::{OnceCell, Ref, RefCell};
use std::ops::Range;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};

use crate::algebra::{Formula, effort};
use crate::derivation::{Assumed, Derivation, Equation, Kind, Source, goals};
use crate::document::Extent;
use crate::kernel::{Assignment, Standing};
use crate::notation::{Mark, Statement};
use crate::parallel::threads;
use crate::sorted::{Map, Set};

pub use dimensions::Dimensions;
pub use entry::{Entry, Judged, Note, Outcome, Verdict};
pub use family::{Counterexamples, changes, counterexamples, is_idle, true_besides};
pub use numeric::{FAR, Link, Numeric, Weighed};
use premise::{Offer, usable};
pub use readings::OtherReading;
pub use review::{Fallen, Review};
use schedule::Schedule;
pub use without::{Without, without_each};

/// How much exact arithmetic a statement is worth, in units of [`effort`]: about a second, where all of the
/// report takes a few hundredths of one.
const MOST_WORK: u64 = 8_000_000;
/// How many earlier steps of its statement a step may use, the last ones.
const MOST_STEPS: usize = 64;
/// So many of the equations that a step comes from and that fail, or are not proved, are named: the nearest. All of them, for each
/// step of a document where thousands follow from one another, would cost the square of their number.
const MOST_ANCESTORS: usize = 64;
/// So many displays of moments that are left may stand between a step and what it goes on from.
const MOST_MOMENTARY: usize = 8;
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
        Audit {
            entries,
            dimensions: shared.dimensions.into_inner().unwrap_or_default(),
        }
    }

    /// The entries of one equation.
    pub fn of_equation(&self, at: usize) -> &[Entry] {
        let start = self.entries.partition_point(|e| e.equation < at);
        let end = self.entries.partition_point(|e| e.equation <= at);
        &self.entries[start..end]
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

/// Leaves open what was refuted without something that it may follow from.
fn leave_open(entry: &mut Entry, reason: &str) {
    for judged in &mut entry.judged {
        if matches!(judged.outcome, Outcome::Refuted(_)) {
            judged.outcome = Outcome::open(reason);
        }
    }
    (entry.implied, entry.mended) = (None, None);
    entry.missing.clear();
    entry.verdict = Verdict::Undecided;
}

/// The last ones, in order.
fn nearest(ancestors: Set<usize>) -> Vec<usize> {
    let far = ancestors.len().saturating_sub(MOST_ANCESTORS);
    ancestors.into_iter().skip(far).collect()
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
    /// What the page says of what moves, once it is asked for.
    moving: OnceCell<moving::Moving>,
}

impl<'a> Auditor<'a> {
    fn new(shared: &'a Shared<'a>, givens: &'a given::Models, points: Vec<Assignment>) -> Self {
        Auditor {
            shared,
            derivation: shared.derivation,
            givens,
            points: RefCell::new(points),
            moving: OnceCell::new(),
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

    fn equation(&self, at: usize) -> Vec<Entry> {
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
            let given = |(part, statement): (usize, &Statement)| {
                let mut entry = self.givens.entry(at, part, parts);
                let how = readings::Circumstances {
                    at,
                    part,
                    usable: &premise::Usable::default(),
                    premises: &[],
                    says_so: false,
                    defines: false,
                };
                let other =
                    effort::within(MOST_WORK, || self.other_reading(statement, &entry, &how));
                entry.notes.extend(other);
                entry
            };
            return statements.iter().enumerate().map(given).collect();
        }
        let (mut premises, says_so, unknown) = self.derivation.premises(at);
        if !says_so {
            let of_page = self.derivation.equations_of(equation.page).start;
            let last = premises.last().copied();
            premises.retain(|&premise| self.is_said_here(at, premise));
            // What was said of a moment that is left stands between.
            if let Some(last) = last.filter(|_| premises.is_empty()) {
                let mut before = (of_page..last).rev().take(MOST_MOMENTARY);
                premises.extend(before.find(|&premise| self.is_said_here(at, premise)));
            }
        }
        let mut usable = usable(
            self.derivation,
            |premise| self.offer(at, premise),
            at,
            &premises,
        );
        let mut entries = Vec::new();
        // Where a formula is meant is said beside it.
        let domains = match equation.numeric {
            Some(_) => Vec::new(),
            None => domain::domains(statements),
        };
        let said = domains.iter().flat_map(|&part| goals(&statements[part]));
        usable
            .assumed
            .extend(said.map(|goal| judge::step(&goal.formula)));
        for (part, statement) in statements.iter().enumerate() {
            if domains.contains(&part) {
                let mut entry = blank(at, part, parts, Kind::Given, Verdict::Given);
                let stated = |goal| Judged {
                    goal,
                    assumed: Vec::new(),
                    outcome: Outcome::Stated,
                };
                entry.judged = goals(statement).into_iter().map(stated).collect();
                entries.push(entry);
                continue;
            }
            let defines = equation.defines.contains(&part);
            let lasting = match says_so {
                true => self.without_moments(at, &usable, &premises),
                false => None,
            };
            let from = |usable: &premise::Usable| {
                self.statement(at, statement, usable, &premises, says_so, defines)
            };
            let mut entry = effort::within(MOST_WORK, || match equation.numeric {
                Some(_) => self.numeric(at, statement, &usable),
                None => {
                    let plain = lasting.map(|lasting| from(&lasting));
                    plain.filter(simply_holds).unwrap_or_else(|| from(&usable))
                }
            });
            // What stands just before and is false says nothing of an identity, or of what follows without it.
            if equation.numeric.is_none()
                && !says_so
                && entry.verdict == Verdict::Undecided
                && premises
                    .iter()
                    .any(|&p| self.entries_of(p).any(Entry::is_wrong))
            {
                let offer = |premise| self.offer(at, premise);
                let alone = premise::usable(self.derivation, offer, at, &[]);
                let alone = effort::within(MOST_WORK, || {
                    self.statement(at, statement, &alone, &[], says_so, defines)
                });
                let told = self.derivation.told(at);
                if simply_holds(&alone) || identity::is_identity(&alone, &told, true) {
                    entry = alone;
                }
            }
            if entry.numeric.is_none() {
                let how = readings::Circumstances {
                    at,
                    part,
                    usable: &usable,
                    premises: &premises,
                    says_so,
                    defines,
                };
                let other =
                    effort::within(MOST_WORK, || self.other_reading(statement, &entry, &how));
                entry.notes.extend(other);
            }
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
            // What a display defines, it goes on with: `a = b, \qquad c = a`.
            if let Some(judged) = entry.judged.first()
                && matches!(judged.outcome, Outcome::Defined | Outcome::Stated)
                && statement.under.is_empty()
            {
                usable.assumed.push(Assumed {
                    formula: judged.goal.formula.clone().into(),
                    standing: Standing::Identity,
                    source: Source::Step,
                });
            }
            entries.push(entry);
        }
        // What the text tells may come of what is cited.
        let by_words = |note: &Note| match note {
            Note::Uncited(sources) => sources.iter().any(|source| self.is_told(at, source)),
            _ => false,
        };
        if says_so
            && entries.iter().all(|e| e.verdict == Verdict::Holds)
            && !entries.iter().flat_map(|e| &e.notes).any(by_words)
        {
            let unused = unused(&entries, &premises);
            if let Some(first) = entries.first_mut()
                && !unused.is_empty()
            {
                first.notes.push(Note::UnusedPremise(unused));
            }
        }
        // A page must begin somewhere: what nothing precedes is given.
        if equation.opens && self.are_laws(at, &entries) {
            if !entries.iter().any(|e| stated::slips(e, equation)) {
                return (0..parts)
                    .map(|part| blank(at, part, parts, Kind::Given, Verdict::Given))
                    .collect();
            }
            if equation.continues == 0 {
                entries.iter_mut().for_each(stated::begin);
            }
        }
        entries
    }

    /// Whether what a page begins with is taken as it stands.
    fn are_laws(&self, at: usize, entries: &[Entry]) -> bool {
        let (told, drawn) = (
            self.derivation.told(at),
            self.derivation.equations[at].drawn,
        );
        let is_law = |entry: &Entry| {
            entry.verdict != Verdict::Holds
                && entry.numeric.is_none()
                && !identity::is_step(entry, &told, drawn)
        };
        entries.iter().all(is_law)
    }

    /// What a step may use without what is so at the moment that the text speaks of: that is no premise of what follows from what is
    /// cited. Nothing where there is no such thing, or it is cited.
    fn without_moments(
        &self,
        at: usize,
        usable: &premise::Usable,
        premises: &[usize],
    ) -> Option<premise::Usable> {
        let mut momentary = self.derivation.momentary(at);
        let is_cited =
            |a: &Assumed| matches!(a.source, Source::Equation(p) if premises.contains(&p));
        momentary.retain(|a| !is_cited(a));
        let mut lasting = usable.clone();
        lasting.assumed.retain(|a| !momentary.contains(a));
        (!momentary.is_empty()).then_some(lasting)
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
        let judge = judge::Judge::new(self, at, usable);
        let mut steps: Vec<(usize, Formula)> = Vec::new();
        let mut instead: Set<Source> = Set::new();
        let mut may_follow = false;
        let mut of_proven: Vec<Formula> = Vec::new();
        for (position, goal) in goals(statement).into_iter().enumerate() {
            if defines && position == 0 {
                // What could not be read may have spoken of it: then it is no definition.
                let outcome = match equation.drawn && !usable.unreadable.is_empty() {
                    true => Outcome::open("it is said to follow from what could not be read"),
                    false => Outcome::Defined,
                };
                steps.push((goal.clause, goal.formula.clone()));
                entry.judged.push(Judged {
                    goal,
                    assumed: Vec::new(),
                    outcome,
                });
                continue;
            }
            let recent = &steps[steps.len().saturating_sub(MOST_STEPS)..];
            let found = judge.goal(&goal, recent, premises);
            if found.judged.outcome.is_proven() && goal.suppositions.is_empty() {
                steps.push((goal.clause, goal.formula.clone()));
            } else if statement.clauses.len() > 1 && goal.suppositions.is_empty() {
                // The next clause of an implication is judged as if this one were true.
                steps.push((goal.clause, goal.formula.clone()));
            }
            if !found.constant.is_empty() {
                entry.takes_as_constant(found.constant);
            }
            let (still, mut conditions): (Vec<Formula>, _) =
                found.conditions.into_iter().partition(stated::stands_still);
            match stated::constants(&found.judged, &still) {
                Some(symbols) if !self.says_otherwise(at, &still) => {
                    entry.takes_as_constant(symbols);
                }
                _ => conditions.extend(still),
            }
            // Links of a chain may need the same.
            let told = |own: &Formula| {
                let mut notes = entry.notes.iter();
                notes
                    .any(|note| matches!(note, Note::UnstatedCondition(told) if told.contains(own)))
            };
            conditions.retain(|own| !told(own));
            let all = std::mem::take(&mut conditions);
            for own in all {
                if !conditions.contains(&own) {
                    conditions.push(own);
                }
            }
            if !conditions.is_empty() {
                if found.judged.outcome.is_proven() {
                    of_proven.extend(conditions.iter().cloned());
                }
                entry.notes.push(Note::UnstatedCondition(conditions));
            }
            if !found.contradictory.is_empty() {
                entry
                    .notes
                    .push(Note::InconsistentPremises(found.contradictory));
            }
            instead.extend(found.instead);
            may_follow |= found.may_follow;
            if entry.implied.is_none() && entry.mended.is_none() {
                (entry.implied, entry.mended) = (found.implied, found.mended);
                entry.missing = found.missing;
            }
            entry.judged.push(found.judged);
        }
        entry.verdict = verdict(&entry.judged, defines);
        if entry.verdict == Verdict::Fails {
            // With what another link needs the one that fails does not follow.
            entry.notes.retain(|note| match note {
                Note::UnstatedCondition(told) => !told.iter().all(|own| of_proven.contains(own)),
                _ => true,
            });
        }
        self.weigh_rounded(at, &mut entry, usable);
        if matches!(entry.verdict, Verdict::Fails | Verdict::Undecided)
            && let Some(symbols) = judge.stated(&entry)
        {
            if entry.numeric.is_none() {
                return stated::given(entry, symbols);
            }
            // What might be a law, but for the figures that speak against it.
            if entry.verdict == Verdict::Fails {
                rounded::open_by_figures(&mut entry);
            }
        }
        if entry.verdict == Verdict::Given {
            entry.kind = Kind::Given;
            entry.notes.extend(judge.unchecked(&entry));
        }
        let mut used: Set<usize> = entry
            .judged
            .iter()
            .flat_map(|j| j.assumed.iter())
            .filter_map(|a| match a.source {
                Source::Equation(premise) => Some(premise),
                _ => None,
            })
            .collect();
        used.extend(entry.numeric.iter().flat_map(|own| numeric::used(own)));
        if !instead.is_empty() {
            // A link of a chain may need what another does not.
            instead.extend(used.iter().map(|&premise| Source::Equation(premise)));
            let cites = says_so && !premises.is_empty() && !may_follow;
            let wrongly = cites && !self.goes_on(at, premises, &instead);
            let note = match wrongly {
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
        // A premise that could not be had may be just what is needed.
        let missing = [
            &usable.unreadable,
            &usable.later,
            &usable.numeric,
            &usable.in_limit,
        ];
        let missing = missing.into_iter().any(|premises| !premises.is_empty());
        if entry.verdict == Verdict::Fails && missing {
            match entry.numeric {
                Some(_) => rounded::open_by_figures(&mut entry),
                None => entry.verdict = Verdict::Undecided,
            }
        }
        if entry.verdict == Verdict::Fails && !equation.unread.is_empty() {
            leave_open(&mut entry, &self.unread(equation));
        }
        if entry.verdict == Verdict::Fails && usable.has_complex {
            leave_open(&mut entry, judge::COMPLEX);
        }
        if entry.verdict == Verdict::Fails && usable.has_presumed {
            leave_open(&mut entry, judge::UNCLEAR);
        }
        if entry.verdict == Verdict::Undecided {
            entry.notes.extend(
                usable
                    .unreadable
                    .iter()
                    .map(|&p| Note::UnreadablePremise(p)),
            );
            if !usable.numeric.is_empty() && entry.numeric.is_none() {
                let numeric = usable.numeric.clone();
                entry.notes.push(Note::RestsOnUnproved(numeric));
            }
        }
        entry.premises = used.iter().copied().collect();
        if entry.verdict == Verdict::Holds {
            entry.rests_on = self.failing(at, &used);
            if !entry.rests_on.is_empty() {
                entry.notes.insert(0, Note::RestsOn(entry.rests_on.clone()));
            }
            let mut open = self.unproved(at, &used);
            open.retain(|premise| !entry.rests_on.contains(premise));
            if !open.is_empty() {
                entry.notes.push(Note::RestsOnUnproved(open));
            }
        }
        self.mark(statement, &mut entry);
        entry
    }

    /// What is supposed before an equation and could not be read.
    fn unread(&self, equation: &Equation) -> String {
        let source = &self.derivation.pages[equation.page].document.source;
        let unread = equation
            .unread
            .iter()
            .filter_map(|own| source.get(own.range()));
        let unread: Vec<String> = unread.map(|own| format!("`{}`", own.trim())).collect();
        format!(
            "what is supposed before it could not be read: {}",
            unread.join(", ")
        )
    }

    /// Evaluates a numeric claim.
    fn numeric(&self, at: usize, statement: &Statement, usable: &premise::Usable) -> Entry {
        let mut entry = blank(at, 0, 1, Kind::Derived, Verdict::Undecided);
        let assumed = self.sound_figures(at, usable);
        let numeric = numeric::evaluate(self.derivation, at, &goals(statement), &assumed);
        let used = numeric::used(&numeric);
        if *numeric.outcome() == Weighed::Contradicted {
            entry.notes.push(Note::NumericNotSupported);
        }
        let open = self.unproved(at, &used);
        if !open.is_empty() {
            entry.notes.push(Note::RestsOnUnproved(open));
        }
        entry.premises = used.into_iter().collect();
        entry.numeric = Some(numeric.into());
        entry
    }

    /// What figures may be taken from: what is wrong or not proved itself is not put in.
    fn sound_figures(&self, at: usize, usable: &premise::Usable) -> Vec<Assumed> {
        let sound = |premise: usize| {
            // Of what figures support only what is exact is offered.
            let proved = |e: &Entry| match e.verdict {
                Verdict::Given | Verdict::Holds => true,
                Verdict::Undecided => e.numeric.is_some(),
                _ => false,
            };
            premise >= at
                || self
                    .entries_of(premise)
                    .all(|e| proved(e) && e.rests_on.is_empty())
        };
        let assumed = usable.assumed.iter();
        assumed
            .filter(|a| !matches!(a.source, Source::Equation(premise) if !sound(premise)))
            .cloned()
            .collect()
    }

    /// The failing equations among premises, and those that these rest on.
    fn failing(&self, at: usize, premises: &Set<usize>) -> Vec<usize> {
        let mut failing = Set::new();
        for &premise in premises.iter().filter(|&&p| p < at) {
            for entry in self.entries_of(premise) {
                if entry.is_mistake() {
                    failing.insert(premise);
                }
                failing.extend(&entry.rests_on);
            }
        }
        nearest(failing)
    }

    /// Whether an equation says something, and no moment was left of which it does: what is not cited is a premise of what is said of that moment.
    fn is_said_here(&self, at: usize, premise: usize) -> bool {
        let own = &self.derivation.equations[at];
        let is_here = |&(page, local): &(usize, usize)| {
            own.is_under(page, local) || !self.derivation.local(page, local).is_momentary()
        };
        // What an author only asks, or crosses out, says nothing.
        let is_marked = self.derivation.equations[premise].kind == Kind::Marked;
        let says =
            |offer: &Offer| !is_marked || !offer.formulas.is_empty() || !offer.cases.is_empty();
        let offer = self.offer(at, premise);
        offer.is_none_or(|offer| says(offer) && offer.under.iter().all(is_here))
    }

    /// Whether the text tells something in passing before a step.
    fn is_told(&self, at: usize, source: &Source) -> bool {
        let own = &self.derivation.equations[at];
        match source {
            Source::Local(page, local) => {
                *page == own.page && own.told.iter().chain(&own.named).any(|told| told == local)
            }
            _ => false,
        }
    }

    /// Whether a step uses all that it cites, and besides only what stands just before it: "Inserting this into (1)". What the
    /// text tells may come of what is cited: "With (2), $v_2 = a v_1$, so".
    fn goes_on(&self, at: usize, premises: &[usize], used: &Set<Source>) -> bool {
        let equations = &self.derivation.equations;
        let first = at - equations[at].row.min(at);
        let before = match first.checked_sub(1) {
            Some(last) if equations[last].page == equations[at].page => {
                last - equations[last].row.min(last)..first
            }
            _ => first..first,
        };
        let own = &equations[at];
        let is_near = |source: &Source| match *source {
            Source::Equation(other) => {
                let put = &equations[other];
                let is_put = put.extent != Extent::Throughout && put.section == own.section;
                premises.contains(&other)
                    || before.contains(&other)
                    || is_put && put.page == own.page
            }
            Source::Local(page, local) => own.is_under(page, local),
            Source::Step => true,
        };
        let is_used = |premise: &usize| used.contains(&Source::Equation(*premise));
        let uses_all = premises.iter().all(is_used) || used.iter().any(|s| self.is_told(at, s));
        uses_all && used.iter().all(is_near)
    }

    /// The premises that are not proved themselves, or only under a condition that nothing states, and those
    /// that these rest on.
    fn unproved(&self, at: usize, premises: &Set<usize>) -> Vec<usize> {
        let mut open = Set::new();
        for &premise in premises.iter().filter(|&&p| p < at) {
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
        nearest(open)
    }

    /// The entries of an equation before the one that is being judged.
    fn entries_of(&self, at: usize) -> impl Iterator<Item = &Entry> {
        self.shared.finished(at).entries.iter()
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
        let refuted = |j: &&Judged| j.outcome.is_refuted();
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

/// Whether it holds, and nothing is to be said of that but what is taken as constant.
fn simply_holds(entry: &Entry) -> bool {
    let fine = |note: &Note| matches!(note, Note::TakenAsConstant(_));
    entry.verdict == Verdict::Holds && entry.notes.iter().all(fine)
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
        numeric: None,
        model: None,
        implied: None,
        mended: None,
        missing: Vec::new(),
    }
}

/// What is cited and not needed. What is cited wrongly is told already.
fn unused(entries: &[Entry], premises: &[usize]) -> Vec<usize> {
    let told = |n: &Note| {
        matches!(
            n,
            Note::Miscited { .. } | Note::OutOfScope(_) | Note::CitesLater(_)
        )
    };
    if entries.iter().any(|e| e.notes.iter().any(told)) {
        return Vec::new();
    }
    let needed = |premise: &&usize| entries.iter().any(|e| e.premises.contains(premise));
    premises.iter().filter(|p| !needed(p)).copied().collect()
}

/// What the links together say of the statement.
fn verdict(judged: &[Judged], defines: bool) -> Verdict {
    let any = |test: fn(&Outcome) -> bool| judged.iter().any(|j| test(&j.outcome));
    if any(Outcome::is_refuted) {
        Verdict::Fails
    } else if judged.is_empty() || any(|o| matches!(o, Outcome::Open(_))) {
        Verdict::Undecided
    } else if defines && judged.len() == 1 {
        Verdict::Given
    } else {
        Verdict::Holds
    }
}
