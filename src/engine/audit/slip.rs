//! The slip of the pen in a step: one small edit with which it would have been shown.
//!
//! Of all that is near to what is printed little is true where all is true that stands before it, as far as floating point tells; that
//! much is judged as what is printed was. What is shown so is said, and that what is printed is false: at a point, by the kernel.

use std::cell::{Cell, LazyCell};

use crate::algebra::{Expr, Formula, Symbol, effort, product_of};
use crate::derivation::{Assumed, Goal, Source, formulas, values_at};
use crate::kernel::{Assignment, Claim, Standing};
use crate::notation::{Clause, Statement};
use crate::sampling::Sample;
use crate::search::{
    self, Change, Decision, Edit, Effort, InChain, Mended, Slips, Stop, UNDECIDED,
};
use crate::sorted::Set;

use super::again::{ELEMENT, ELSEWHERE, NAMED, OPEN_ITSELF, UNSAID};
use super::entry::Entry;
use super::readings::Circumstances;
use super::warranted::is_supposed;
use super::{Auditor, Judged, Note, Outcome, Verdict, judge, stated};

/// How much work may be done for that in all, and for one edit.
const MOST_WORK: u64 = 3_000_000;
const MOST_WORK_FOR_ONE: u64 = 60_000;
/// The same for one that is right as far as floating point tells, or one of the likeliest where that tells nothing.
const MOST_WORK_IF_LIKELY: u64 = 600_000;
const LIKELIEST: usize = 3;
/// So many edits are tried.
const MOST_TRIED: usize = 60;
/// So many displays before are looked at for what ties a symbol to others.
const MOST_BEFORE: usize = 64;
/// So many times it is tried to find out where all may be true; so many such places are enough, and so many are needed.
const MOST_SEEDS: u32 = 20;
/// So many terms are worked out for that.
const MOST_STEPS: u64 = 1_000_000;
const MOST_SAMPLES: usize = 3;
const FEWEST_SAMPLES: usize = 2;
/// So many times it is tried whether a law is true with what is near to a link.
const MOST_SAMPLES_WITH: u32 = 2;
/// So many links of a chain are looked at.
const MOST_LINKS: usize = 2;

impl Auditor<'_> {
    /// One small edit with which what is refuted would have been shown, and what is said of the links before: the first may be a definition
    /// of which nothing says so, `\frac{dM}{dt} = (1 - ϵ) \dot m = \frac{1 - ϵ}{ϵ} \frac{L}{c^2}`.
    pub(super) fn slip_in(
        &self,
        statement: &Statement,
        how: &Circumstances,
        entry: &Entry,
    ) -> Option<(Vec<Judged>, Mended)> {
        let is_refuted = |at: &usize| entry.judged[*at].outcome.is_refuted();
        let mut refuted = (0..entry.judged.len()).filter(is_refuted).take(MOST_LINKS);
        refuted.find_map(|at| {
            let shown = self.shown_for(statement, how, entry, at)?;
            let before = shown.before.into_iter().take(at);
            Some((before.collect(), shown.mended))
        })
    }

    fn shown_for(
        &self,
        statement: &Statement,
        how: &Circumstances,
        entry: &Entry,
        at: usize,
    ) -> Option<Shown> {
        let judged = &entry.judged[at];
        let Outcome::Refuted(refuted) = &judged.outcome else {
            return None;
        };
        let (claim, witness) = (refuted.claim(), refuted.witness());
        let slips = || slips(statement, &entry.judged, &judged.goal, claim, Some(witness));
        let samples = self.samples(how, entry, &judged.goal);
        let link = (entry, &judged.goal);
        let likely = || {
            let is_likely = |own: &Formula| samples.are_true_with(own);
            let slips = slips().and_rarer().such_that(is_likely);
            self.first_shown(statement, how, link, slips, MOST_TRIED)
        };
        let any = || self.first_shown(statement, how, link, slips(), LIKELIEST);
        let found = match samples.all.len() < FEWEST_SAMPLES {
            true => None,
            false => effort::altogether(MOST_WORK, likely),
        };
        found.or_else(|| effort::altogether(MOST_WORK, any))
    }

    /// Says of a step that is neither shown nor refuted that it fails, where it would have been shown with one small edit, and is false at a
    /// point at which all is true that shows that.
    pub(super) fn look_for_slip(
        &self,
        statement: &Statement,
        how: &Circumstances,
        mut entry: Entry,
    ) -> Entry {
        if entry.verdict != Verdict::Undecided || !self.may_leave_unsaid(statement, how, &entry) {
            return entry;
        }
        let is_open = |own: &Judged| {
            let goal = &own.goal;
            let is_plain = goal.rounding.is_none() && !goal.questioned;
            let is_equation = goal.formula.as_equation().is_some();
            let is_open = matches!(&own.outcome, Outcome::Open(stop) if is_simply_open(stop));
            is_open && is_equation && is_plain
        };
        let sets_against = || judge::Judge::new(self, how.at, how.usable).sets_against();
        let open = entry.judged.iter().position(is_open);
        let Some(open) = open.filter(|_| !sets_against()) else {
            return entry;
        };
        let judged = &entry.judged[open];
        let samples = self.samples(how, &entry, &judged.goal);
        let is_right = |own: &Sample| own.holds(&judged.goal.formula) == Some(true);
        if samples.all.len() < FEWEST_SAMPLES || samples.all.iter().any(is_right) {
            return entry;
        }
        let (formula, assumed) = (&judged.goal.formula, &judged.assumed);
        let claim = self.derivation.claim(how.at, assumed, formula);
        let slips = slips(statement, &entry.judged, &judged.goal, &claim, None);
        let slips = slips.and_rarer();
        let slips = slips.such_that(|own| samples.are_true_with(own));
        let link = (&entry, &judged.goal);
        let shown = || self.first_shown(statement, how, link, slips, MOST_TRIED);
        let Some(shown) = effort::altogether(MOST_WORK, shown) else {
            return entry;
        };
        let refuted = || self.refuted_beside(how, &judged.goal, &shown);
        let Some(refuted) = effort::altogether(MOST_WORK, refuted) else {
            return entry;
        };
        entry.judged[open] = refuted;
        entry.verdict = Verdict::Fails;
        entry.mended = Some(Box::new(shown.mended));
        entry
    }

    /// What is printed, refuted where all is true that something near to it was shown from, and so that as well.
    fn refuted_beside(&self, how: &Circumstances, printed: &Goal, shown: &Shown) -> Option<Judged> {
        let (at, usable) = (how.at, how.usable);
        let from = self.needed(at, shown);
        let domains = &self.derivation.pages[self.derivation.equations[at].page].domains;
        let is_anything = |own: &Symbol| {
            let domain = domains.get(own);
            domain.is_none_or(|own| !own.nonzero && !own.integer && own.bounds().next().is_none())
        };
        let decided = |assumed: Vec<Assumed>, formula: Formula| {
            let claim = self.derivation.claim(at, &assumed, &formula);
            let Decision::Refuted(refuted) = search::decide(claim, &self.hints()) else {
                return None;
            };
            let goal = Goal {
                formula,
                ..printed.clone()
            };
            let judged = Judged {
                goal,
                assumed,
                outcome: Outcome::Refuted(refuted.into()),
            };
            let judge = judge::Judge::new(self, at, usable);
            judge.held_and_moving(&judged).is_none().then_some(judged)
        };
        let plain = decided(from.clone(), printed.formula.clone());
        let plain = plain.or_else(|| {
            let mut with_shown = from.clone();
            // What solves a law says how it varies.
            let standing = match from.iter().any(|own| own.formula.speaks_of_slopes()) {
                true => Standing::Identity,
                false => Standing::AtPoint,
            };
            with_shown.push(Assumed {
                standing,
                ..judge::taken(&shown.formula)
            });
            decided(with_shown, printed.formula.clone())
        });
        let plain = plain.or_else(|| {
            let between = between(&shown.formula, &printed.formula)?;
            decided(
                but_names(from.clone(), &between, Some(&is_anything)),
                between,
            )
        });
        let plain = plain.or_else(|| {
            let known = but_integrals(&from, &printed.formula)?;
            decided(known, printed.formula.clone())
        });
        // What is false where all is positive is false.
        plain.or_else(|| {
            let between = between(&shown.formula, &printed.formula)?;
            let symbols = between
                .free_symbols()
                .into_iter()
                .filter(|own| !own.is_unit());
            let positive = symbols.map(|own| Formula::positive(Expr::Symbol(own.clone())));
            let mut all = but_names(from.clone(), &between, Some(&is_anything));
            all.extend(positive.map(|own| judge::condition(&own)));
            decided(all, between)
        })
    }

    /// What something is shown from: what it is not shown from may stand in the way of a point.
    fn needed(&self, at: usize, shown: &Shown) -> Vec<Assumed> {
        let mut assumed = shown.from.clone();
        // Nothing is shown from that, and of no point it is known whether it is true there.
        assumed.retain(|own| !own.formula.is_approximation());
        let follows = |assumed: &[Assumed]| {
            let claim = self.derivation.claim(at, assumed, &shown.formula);
            search::prove_unconditionally(claim, Effort::Full).is_some()
        };
        for from in (0..assumed.len()).rev() {
            let own = assumed.remove(from);
            if !follows(&assumed) {
                assumed.insert(from, own);
            }
        }
        assumed
    }

    /// Where all may be true that stands before a link.
    fn samples(&self, how: &Circumstances, entry: &Entry, goal: &Goal) -> Samples {
        let judge = judge::Judge::new(self, how.at, how.usable);
        let links = entry.judged.iter().map(|own| &own.goal);
        let links = links.take_while(|own| own.sides != goal.sides);
        let links: Vec<Assumed> = links.map(|own| judge::step(&own.formula)).collect();
        let [near, all] = judge.others(how.premises);
        let open = judge.open_before(how.premises);
        let with = |others| -> Vec<&Formula> {
            let all = [&how.usable.assumed, &links, others, &open];
            all.into_iter().flatten().map(|own| &*own.formula).collect()
        };
        let mut sets = vec![with(near)];
        if !all.is_empty() {
            sets.insert(0, with(all));
        }
        // Where something is, how it moves leaves open.
        let mut still = sets[sets.len() - 1].clone();
        still.retain(|own| !own.speaks_of_slopes());
        if !goal.formula.speaks_of_slopes() && still.len() < sets[sets.len() - 1].len() {
            sets.push(still);
        }
        // What nobody says the sign of is mostly meant to be positive.
        let mut of_any_sign = Vec::new();
        for premises in &sets {
            let mut found = where_true(premises, &goal.formula);
            if found.iter().filter(|own| own.is_positive()).count() >= FEWEST_SAMPLES {
                found.retain(Sample::is_positive);
                return Samples::new(found, &sets, &goal.formula);
            }
            of_any_sign.push(found);
        }
        let enough = of_any_sign
            .into_iter()
            .find(|own| own.len() >= FEWEST_SAMPLES);
        let any = || seeds(&sets[0], &goal.formula).take(MOST_SAMPLES).collect();
        let mut found: Vec<Sample> = enough.unwrap_or_else(any);
        found.truncate(MOST_SAMPLES);
        Samples::new(found, &sets, &goal.formula)
    }

    /// The first of some edits with which a link would have been shown; so many of them are tried in earnest.
    fn first_shown(
        &self,
        statement: &Statement,
        how: &Circumstances,
        (entry, goal): (&Entry, &Goal),
        mut slips: Slips,
        in_earnest: usize,
    ) -> Option<Shown> {
        let untied = LazyCell::new(|| self.untied(how.at, &goal.formula));
        let mut tried = 0;
        while let Some(edit) = slips.next().filter(|_| tried < MOST_TRIED) {
            // What speaks of more may be said of more, and lack nothing.
            let is_less = matches!(edit.change, Change::Summand | Change::Factor)
                && !goal.formula.names().is_subset(&edit.formula.names());
            let likely = !is_less && self.is_likely(how.at, &edit.change, &untied);
            let edited = likely.then(|| edited(statement, goal, &edit));
            let Some(edited) = edited.flatten() else {
                continue;
            };
            let most_work = match tried < in_earnest {
                true => MOST_WORK_IF_LIKELY,
                false => MOST_WORK_FOR_ONE,
            };
            tried += 1;
            let other = effort::altogether(most_work, || self.step(&edited, how));
            if effort::is_exhausted() {
                break;
            }
            if let Some((_, refuted)) = other.refuted() {
                slips.heed(refuted.witness());
            }
            let mut all = other.judged.iter();
            let own = all.find(|own| own.goal.sides == goal.sides);
            let Some((own, Outcome::Proven(proven))) = own.map(|own| (own, &own.outcome)) else {
                continue;
            };
            let of_another_case = || {
                let formula = &own.goal.formula;
                self.derivation.is_of_section_before(how.at, formula)
            };
            if !is_right(&other, entry, own)
                || self.says_the_same(how.at, &own.goal, goal)
                || of_another_case()
            {
                continue;
            }
            let mut notes = other.notes.iter();
            let under = notes.find_map(|note| match note {
                Note::UnstatedCondition(under) => Some(under.clone()),
                _ => None,
            });
            let under = under.unwrap_or_default();
            if is_supposed(&goal.formula, &under) {
                continue;
            }
            // What is shown where something stands still that moves is not shown.
            if self.holds_what_changes(how.at, own) {
                continue;
            }
            let mut from = own.assumed.clone();
            from.retain(|own| !under.contains(&own.formula));
            from.extend(under.iter().map(|own| Assumed {
                standing: judge::condition(own).standing,
                ..judge::taken(own)
            }));
            // Where nothing can be so, anything would have been shown: `\sqrt{-K p}` where `K > 0` and `p > 0`. What is shown has values
            // itself, and so it is supposed, too.
            let is_contradictory = || {
                let judge = judge::Judge::new(self, how.at, how.usable);
                let with_shown: Vec<Assumed> = (from.iter().cloned())
                    .chain([judge::taken(&own.goal.formula)])
                    .collect();
                judge.is_contradictory(&with_shown, &own.goal)
            };
            if !under.is_empty() && (search::rests_on_contradiction(proven) || is_contradictory()) {
                continue;
            }
            return Some(Shown {
                formula: own.goal.formula.clone(),
                before: other.judged.clone(),
                from,
                mended: Mended {
                    proven: (**proven).clone(),
                    change: edit.change,
                    next: None,
                    under,
                },
            });
        }
        None
    }

    /// Whether something stands still by a condition of which the page writes how fast it changes, or that is integrated as what changes.
    fn holds_what_changes(&self, at: usize, judged: &Judged) -> bool {
        // What the text itself says to stand still does.
        let conditions = judged
            .assumed
            .iter()
            .filter(|own| own.source == Source::Step);
        let formulas = conditions.map(|own| &*own.formula);
        let mut held = formulas.filter(|own| stated::stands_still(own));
        let is_integrated = |own: &Symbol, over: &Symbol| {
            let is_one = |part: &Expr| match part {
                Expr::Integral { body, variable, .. } => variable == over && body.mentions(own),
                _ => false,
            };
            let mut terms = judged.goal.formula.terms().into_iter();
            terms.any(|term| term.any(&is_one))
        };
        let moves = |own: &Formula| match own.as_equation() {
            Some((Expr::Derivative { body, variable }, _)) => {
                let mut of = body.free_symbols().into_iter();
                of.any(|own| {
                    self.writes_slope(at, &own, variable)
                        || is_integrated(&own, variable) && self.changes(at, &own, variable)
                })
            }
            _ => false,
        };
        held.any(moves)
    }

    /// Whether what is shown says what is printed, but for what both divide by, so that no pen slipped.
    fn says_the_same(&self, at: usize, shown: &Goal, printed: &Goal) -> bool {
        let printed = &printed.formula;
        let nonzero = printed.free_symbols().into_iter();
        let nonzero = nonzero.map(|own| Formula::nonzero(Expr::Symbol(own.clone())));
        let with: Vec<Formula> = nonzero.chain([shown.formula.clone()]).collect();
        let with: Vec<Assumed> = with.iter().map(judge::taken).collect();
        let claim = self.derivation.claim(at, &with, printed);
        search::prove_unconditionally(claim, Effort::Light).is_some()
    }

    /// Whether a change is one that a pen slips by: authors have more names for a thing than one, and new ones for what they come to. What
    /// nothing before ties to the rest of a formula may be tied to it by the formula.
    pub(super) fn is_likely(
        &self,
        at: usize,
        change: &Change,
        untied: &LazyCell<Set<Symbol>, impl FnOnce() -> Set<Symbol>>,
    ) -> bool {
        let Change::Symbol { printed, meant } = change else {
            return true;
        };
        let is_kind = printed.is_variant_of(meant) || meant.is_variant_of(printed);
        // Nobody writes an angle for the number π.
        !is_kind
            && meant.name() != "\\pi"
            && !self.derivation.equations[at].introduces.contains(printed)
            && !untied.contains(printed)
    }

    /// The symbols of a formula that nothing that stands before ties to another one of them.
    pub(super) fn untied(&self, at: usize, formula: &Formula) -> Set<Symbol> {
        let page = self.derivation.equations[at].page;
        let before = (self.derivation.equations_of(page).start..at).rev();
        let displays = before.take(MOST_BEFORE);
        let displays = displays.flat_map(|own| self.derivation.equations[own].statements());
        let told = self.derivation.told(at);
        let told = told.iter().map(|own| own.formula.names());
        let said = displays.flat_map(formulas).map(|own| own.names());
        let mut tied: Vec<Set<Symbol>> = Vec::new();
        for mut own in said.chain(told) {
            own.retain(|name| !name.is_unit() && name.name() != "\\pi");
            let shares = |other: &mut Set<Symbol>| other.iter().any(|name| own.contains(name));
            let joined: Vec<Set<Symbol>> = tied.extract_if(.., shares).collect();
            own.extend(joined.into_iter().flatten());
            tied.push(own);
        }
        let names = formula.names();
        let is_alone = |own: &Symbol| {
            let mut of_it = tied.iter().filter(|all| all.contains(own));
            !of_it.any(|all| {
                names
                    .iter()
                    .any(|other| other != own && all.contains(other))
            })
        };
        names.iter().filter(|own| is_alone(own)).cloned().collect()
    }
}

/// Places at which a goal has a value, from different seeds.
fn seeds<'a>(premises: &'a [&Formula], goal: &'a Formula) -> impl Iterator<Item = Sample> + 'a {
    let mut left = MOST_STEPS;
    let samples = (0..MOST_SEEDS).map_while(move |seed| {
        let own = (left > 0).then(|| Sample::of(premises.iter().copied(), goal, seed))?;
        let has_value = own.holds(goal).is_some();
        left = left.saturating_sub(own.steps());
        Some((own, has_value))
    });
    samples.filter_map(|(own, has_value)| has_value.then_some(own))
}

/// Those of these places at which premises are true, as far as that can be told, until there are enough at which all is positive.
fn where_true(premises: &[&Formula], goal: &Formula) -> Vec<Sample> {
    let is_false = |own: &Sample, premise: &Formula| own.holds(premise) == Some(false);
    let fits = |own: &Sample| !premises.iter().any(|premise| is_false(own, premise));
    let (mut found, mut positive) = (Vec::new(), 0);
    for own in seeds(premises, goal).filter(fits) {
        positive += usize::from(own.is_positive());
        found.push(own);
        if positive == MOST_SAMPLES {
            break;
        }
    }
    found
}

/// A link that would have been shown, as it should read.
struct Shown {
    formula: Formula,
    /// All links of the edited statement.
    before: Vec<Judged>,
    /// From what, and under what besides.
    from: Vec<Assumed>,
    mended: Mended,
}

/// Whether an edited statement is right as far as was found: what is shown of it as it is printed is shown still, and no more is left open.
fn is_right(edited: &Entry, printed: &Entry, link: &Judged) -> bool {
    let is_settled = |own: &Judged| {
        own.outcome.is_proven() || matches!(own.outcome, Outcome::Defined | Outcome::Stated)
    };
    let was_open = |own: &Judged| {
        let mut printed = printed.judged.iter();
        let as_printed = printed.find(|other| other.goal.sides == own.goal.sides);
        as_printed.is_some_and(|other| matches!(other.outcome, Outcome::Open(_)))
    };
    // What goes on with what was edited is no longer open.
    let goes_on = |own: &Judged| own.goal.sides.0 == link.goal.sides.1;
    // What figures are put in for is as good as they are.
    let is_supported = |own: &Judged| {
        let numeric = edited.numeric.as_ref().filter(|own| own.is_supported());
        numeric.is_some_and(|all| {
            all.links
                .iter()
                .any(|link| link.goal.sides == own.goal.sides)
        })
    };
    let fits = |own: &Judged| {
        let is_open = || matches!(own.outcome, Outcome::Open(_)) && was_open(own) && !goes_on(own);
        is_settled(own) || is_supported(own) || is_open()
    };
    let is_weighed = || edited.numeric.as_ref().is_none_or(|own| own.is_supported());
    match edited.verdict {
        Verdict::Holds => true,
        Verdict::Undecided | Verdict::Given => is_weighed() && edited.judged.iter().all(fits),
        _ => false,
    }
}

/// Where all may be true that stands before a link.
struct Samples {
    all: Vec<Sample>,
    /// What says how something changes that the link says what it is, with what else stands before; few links have that.
    premises: Vec<Formula>,
    /// What the link says what it is.
    of: Option<Symbol>,
    /// So many terms may still be worked out to see whether laws are true.
    left: Cell<u64>,
}

impl Samples {
    fn new(all: Vec<Sample>, sets: &[Vec<&Formula>], goal: &Formula) -> Samples {
        let of = goal.as_equation().and_then(|(left, _)| match left {
            Expr::Symbol(own) | Expr::Apply(own, _) => Some(own.clone()),
            _ => None,
        });
        let premises = sets.first().into_iter().flatten();
        let is_told = of
            .as_ref()
            .is_some_and(|of| premises.clone().any(|own| says_how_changes(own, of)));
        Samples {
            all,
            premises: match is_told {
                true => premises.map(|own| (*own).clone()).collect(),
                false => Vec::new(),
            },
            of: of.filter(|_| is_told),
            left: Cell::new(MOST_STEPS),
        }
    }

    /// Whether something near to the link is true wherever the premises are, or they are true with it: `w = \frac{F x^2}{6 E I} (3 L - x)`
    /// beside `E I \frac{dw}{dx} = F (L x - \frac{x^2}{2})`.
    fn are_true_with(&self, formula: &Formula) -> bool {
        if self.all.iter().all(|own| own.holds(formula) == Some(true)) {
            return true;
        }
        let Some(of) = &self.of else {
            return false;
        };
        let (laws, others): (Vec<&Formula>, Vec<&Formula>) = self
            .premises
            .iter()
            .partition(|own| says_how_changes(own, of));
        (0..MOST_SAMPLES_WITH).all(|seed| {
            if self.left.get() == 0 {
                return false;
            }
            let all = [formula].into_iter().chain(others.iter().copied());
            let sample = Sample::of(all, laws[0], seed);
            let are_true = laws.iter().all(|own| sample.holds(own) == Some(true));
            self.left
                .set(self.left.get().saturating_sub(sample.steps()));
            are_true
        })
    }
}

/// Whether a formula is a law of how something changes.
fn says_how_changes(formula: &Formula, of: &Symbol) -> bool {
    let is_slope = |part: &Expr| match part {
        Expr::Derivative { body, .. } => {
            matches!(&**body, Expr::Symbol(own) | Expr::Apply(own, _) if own == of)
        }
        _ => false,
    };
    let mut terms = formula.terms().into_iter();
    formula.as_equation().is_some() && terms.any(|term| term.any(&is_slope))
}

/// Whether no more is known of what is left open than that it does not follow from what stands before, as far as was found.
fn is_simply_open(stop: &Stop) -> bool {
    let reasons = [UNDECIDED, OPEN_ITSELF, ELSEWHERE, ELEMENT, NAMED, UNSAID];
    reasons.contains(&&*stop.reason)
}

/// That what should be printed on one side is what is printed there: the other side is the same.
fn between(shown: &Formula, printed: &Formula) -> Option<Formula> {
    let (left, right) = shown.as_equation()?;
    let (printed_left, printed_right) = printed.as_equation()?;
    if left == printed_left {
        return Some(Formula::equal(right.clone(), printed_right.clone()));
    }
    (right == printed_right).then(|| Formula::equal(printed_left.clone(), left.clone()))
}

/// What is assumed, but for what only gives names to things of which nothing else speaks: what is true without these is true with them.
///
/// Where it is told which names may stand for anything, they may stand beside something, too, that is not 0 then: `E I w(x) = F x^2` says what
/// `w(x)` is where `E I ≠ 0`.
pub(super) fn but_names(
    mut assumed: Vec<Assumed>,
    goal: &Formula,
    is_anything: Option<&dyn Fn(&Symbol) -> bool>,
) -> Vec<Assumed> {
    let may_be = |named: &Expr| {
        let name = match named {
            Expr::Symbol(own) => Some(own),
            _ => None,
        };
        is_anything.is_none_or(|is_anything| name.is_none_or(is_anything))
    };
    loop {
        let beside = |at: usize| {
            let (left, right) = assumed[at].formula.as_equation()?;
            let mut others: Vec<&Formula> = vec![goal];
            let rest = assumed.iter().enumerate().filter(|(other, _)| *other != at);
            others.extend(rest.map(|(_, own)| &*own.formula));
            if may_be(left) && names(left, right, &others) {
                return Some((at, Vec::new()));
            }
            is_anything?;
            let sides = [(left, right), (right, left)].into_iter();
            sides
                .filter_map(|(product, value)| match product {
                    Expr::Product(factors) => Some((factors, value)),
                    _ => None,
                })
                .find_map(|(factors, value)| {
                    (0..factors.len()).find_map(|named| {
                        let mut beside = factors.to_vec();
                        let named = beside.remove(named);
                        let said = Formula::nonzero(product_of(beside.clone()));
                        let others: Vec<&Formula> = others.iter().copied().chain([&said]).collect();
                        let is_one = may_be(&named) && names(&named, value, &others);
                        is_one.then_some((at, beside))
                    })
                })
        };
        let Some((at, beside)) = (0..assumed.len()).rev().find_map(beside) else {
            return assumed;
        };
        assumed.remove(at);
        let nonzero = beside.into_iter().map(Formula::nonzero);
        assumed.extend(nonzero.map(|own| judge::condition(&own)));
    }
}

/// What is assumed, with what integrals come to put in for them, where nothing else speaks of what is integrated: `V = \int_a^b E\,dr = c` says
/// that `V = c`, and what else it says is so for some `E`. `None` where there is no such integral.
fn but_integrals(assumed: &[Assumed], goal: &Formula) -> Option<Vec<Assumed>> {
    let (at, integral, value) = assumed.iter().enumerate().find_map(|(at, own)| {
        let (left, right) = own.formula.as_equation()?;
        let is_free = |term: &Expr| {
            let Expr::Integral { body, .. } = term else {
                return false;
            };
            let Expr::Symbol(integrated) = &**body else {
                return false;
            };
            let elsewhere = |own: &Formula| {
                let all = own.map_terms(|own| own.replace(term, &Expr::integer(0)));
                all.names().contains(integrated)
            };
            !elsewhere(goal) && !assumed.iter().any(|own| elsewhere(&own.formula))
        };
        let sides = [(left, right), (right, left)].into_iter();
        let mut sides = sides.filter(|own| is_free(own.0) && !own.1.any(&|part| part == own.0));
        // That it is a number that has a name says nothing of it.
        let (integral, value) = sides.find(|own| !matches!(own.1, Expr::Symbol(_)))?;
        Some((at, integral.clone(), value.clone()))
    })?;
    let mut known = assumed.to_vec();
    known.remove(at);
    for own in &mut known {
        let put_in = (own.formula).map_terms(|term| term.replace(&integral, &value));
        own.formula = put_in.into();
    }
    Some(known)
}

/// Whether an equation is the only one that speaks of what its left side is, a name or how fast something changes.
fn names(left: &Expr, right: &Expr, others: &[&Formula]) -> bool {
    match left {
        Expr::Symbol(own) | Expr::Apply(own, _) => {
            let speaks = |term: &Expr| term.any(&|part| is_of(part, own));
            let mut terms = others.iter().flat_map(|own| own.terms());
            !speaks(right) && !terms.any(speaks)
        }
        Expr::Derivative { .. } => {
            let is_slope = |part: &Expr| {
                matches!(part, Expr::Derivative { .. } | Expr::Partial { .. })
                    && part.any(&|own| own == left)
            };
            let mut terms = others.iter().flat_map(|own| own.terms());
            !right.any(&is_slope) && !terms.any(|term| term.any(&is_slope))
        }
        _ => false,
    }
}

fn is_of(part: &Expr, symbol: &Symbol) -> bool {
    match part {
        Expr::Symbol(own) | Expr::Apply(own, _) => own == symbol,
        own => own.binder() == Some(symbol),
    }
}

fn slips<'a>(
    statement: &Statement,
    judged: &[Judged],
    goal: &Goal,
    claim: &'a Claim,
    witness: Option<&Assignment>,
) -> Slips<'a> {
    // What a link begins with may be wrong itself, unless the link before has shown it.
    let goes_on =
        |own: &&Judged| own.goal.clause == goal.clause && own.goal.sides.1 == goal.sides.0;
    let before = judged.iter().find(goes_on);
    let is_taken =
        before.is_some_and(|own| matches!(own.outcome, Outcome::Defined | Outcome::Stated));
    let begins = statement.clauses.get(goal.clause);
    let begins = begins.is_some_and(|clause| match clause {
        Clause::Chain { sides, .. } => sides[0].span == goal.sides.0,
        Clause::AllEqual { .. } => true,
    });
    let chain = InChain {
        left_settled: !begins && !is_taken,
        ..InChain::default()
    };
    Slips::of(claim, &chain, witness, values_at)
}

/// A statement with one link edited.
fn edited(statement: &Statement, goal: &Goal, edit: &Edit) -> Option<Statement> {
    let Formula::Relation {
        left,
        relation,
        right,
    } = &edit.formula
    else {
        return None;
    };
    let mut edited = statement.clone();
    let Clause::Chain { sides, links } = edited.clauses.get_mut(goal.clause)? else {
        return None;
    };
    let at = sides
        .windows(2)
        .position(|pair| (pair[0].span, pair[1].span) == goal.sides)?;
    links.get_mut(at)?.relation = *relation;
    for (side, (kept, term)) in sides[at..]
        .iter_mut()
        .zip([(edit.left_kept, left), (edit.right_kept, right)])
    {
        if !kept {
            side.expr = term.clone();
            side.rounding = None;
        }
    }
    Some(edited)
}
