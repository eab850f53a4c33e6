//! The slip of the pen in a step: one small edit with which it would have been shown.
//!
//! Of all that is near to what is printed little is true where all is true that stands before it, as far as floating point tells; that
//! much is judged as what is printed was. What is shown so is said, and that what is printed is false: at a point, by the kernel.

mod beside;
mod identity;
mod samples;

use std::cell::LazyCell;

use crate::algebra::{Expr, Formula, Symbol, effort};
use crate::derivation::{Assumed, Goal, Source, formulas, values_at};
use crate::kernel::{Assignment, Claim};
use crate::notation::{Clause, Statement};
use crate::search::{self, Change, Edit, Effort, InChain, Mended, Slips, Stop, UNDECIDED};
use crate::sorted::Set;

use super::again::{ELEMENT, ELSEWHERE, NAMED, OPEN_ITSELF, UNSAID};
use super::entry::Entry;
use super::induction::NO_INDUCTION;
use super::readings::Circumstances;
use super::warranted::is_supposed;
use super::{Auditor, Judged, Note, Outcome, Verdict, judge, stated};
pub(super) use beside::{between, but_names};

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
        let judge = judge::Judge::new(self, how.at, how.usable);
        refuted.find_map(|at| {
            let shown = self.shown_for(&judge, statement, how, (entry, at))?;
            let mut before: Vec<Judged> = shown.links.into_iter().take(at).collect();
            // They are said as they are printed, whichever side the slip is on.
            for (own, printed) in before.iter_mut().zip(&entry.judged) {
                own.goal = printed.goal.clone();
            }
            // What is false and near to nothing that follows says nothing of the slip in another link.
            for own in before.iter_mut().filter(|own| own.outcome.is_refuted()) {
                own.outcome = Outcome::open(UNDECIDED);
            }
            Some((before, shown.mended))
        })
    }

    fn shown_for(
        &self,
        judge: &judge::Judge,
        statement: &Statement,
        how: &Circumstances,
        (entry, at): (&Entry, usize),
    ) -> Option<Shown> {
        let judged = &entry.judged[at];
        let Outcome::Refuted(refuted) = &judged.outcome else {
            return None;
        };
        let (claim, witness) = (refuted.claim(), refuted.witness());
        let slips = || slips(statement, &entry.judged, &judged.goal, claim, Some(witness));
        let samples = self.samples(judge, how, entry, &judged.goal);
        let link = (entry, &judged.goal);
        let likely = || {
            let is_likely = |own: &Formula| samples.are_true_with(own);
            let slips = slips().and_rarer().such_that(is_likely);
            self.first_shown(statement, how, link, slips, MOST_TRIED)
        };
        let any = || self.first_shown(statement, how, link, slips(), LIKELIEST);
        let found = match samples.are_enough() {
            true => effort::altogether(MOST_WORK, likely),
            false => None,
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
        // What speaks of nothing new may be derived all the same.
        let brings_nothing =
            |note: &Note| matches!(note, Note::TakenAsGiven(symbols) if symbols.is_empty());
        let is_stated = entry.verdict == Verdict::Given && entry.notes.iter().any(brings_nothing);
        let is_in_question = is_stated || entry.verdict == Verdict::Undecided;
        if !is_in_question || !self.may_leave_unsaid(statement, how, &entry) {
            return entry;
        }
        let is_open = |own: &Judged| {
            let goal = &own.goal;
            let is_plain = goal.rounding.is_none() && !goal.questioned;
            let is_equation = goal.formula.as_equation().is_some();
            let is_open = match &own.outcome {
                Outcome::Open(stop) => is_simply_open(stop),
                Outcome::Stated | Outcome::Defined => is_stated,
                _ => false,
            };
            is_open && is_equation && is_plain
        };
        let is_open = |at: &usize| is_open(&entry.judged[*at]);
        let open: Vec<usize> = (0..entry.judged.len()).filter(is_open).collect();
        if open.is_empty() {
            return entry;
        }
        let judge = judge::Judge::new(self, how.at, how.usable);
        if judge.sets_against() || judge.draws_on_analogues() {
            return entry;
        }
        let slip_of = |&at: &usize| {
            let judged = &entry.judged[at];
            let samples = self.samples(&judge, how, &entry, &judged.goal);
            if !samples.are_enough() || samples.allow(&judged.goal.formula) {
                return None;
            }
            let (formula, assumed) = (&judged.goal.formula, &judged.assumed);
            let claim = self.derivation.claim(how.at, assumed, formula);
            let slips = slips(statement, &entry.judged, &judged.goal, &claim, None);
            let slips = slips.and_rarer();
            let slips = slips.such_that(|own| samples.are_true_with(own));
            let link = (&entry, &judged.goal);
            let shown = || self.first_shown(statement, how, link, slips, MOST_TRIED);
            let shown = effort::altogether(MOST_WORK, shown);
            // What a new name means may be guessed wrong.
            let is_guessed = |own: &Shown| {
                let is_guess =
                    |own: &Assumed| own.source == Source::Taken && own.formula.equates_names();
                is_stated && own.from.iter().any(is_guess)
            };
            let shown = shown.filter(|own| !is_guessed(own))?;
            let from = effort::altogether(MOST_WORK, || self.needed(how.at, &shown));
            let refuted = || self.refuted_beside(how, &judged.goal, &shown, from);
            let refuted = effort::altogether(MOST_WORK, refuted)?;
            Some((at, refuted, shown))
        };
        let found = open.iter().take(MOST_LINKS).find_map(slip_of);
        let Some((open, refuted, shown)) = found else {
            return entry;
        };
        entry.judged[open] = refuted;
        entry.verdict = Verdict::Fails;
        entry.kind = self.derivation.equations[how.at].kind;
        entry.notes.retain(|note| !brings_nothing(note));
        entry.mended = Some(Box::new(shown.mended));
        entry
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
                links: other.judged.clone(),
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

/// A link that would have been shown, as it should read.
struct Shown {
    formula: Formula,
    /// All links of the edited statement.
    links: Vec<Judged>,
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
    let is_false_still = |own: &Judged| {
        let mut printed = printed.judged.iter();
        let was_false = |other: &Judged| other.outcome.is_refuted();
        own.outcome.is_refuted()
            && !goes_on(own)
            && printed.any(|other| other.goal.sides == own.goal.sides && was_false(other))
    };
    let is_weighed = || edited.numeric.as_ref().is_none_or(|own| own.is_supported());
    match edited.verdict {
        Verdict::Holds => true,
        Verdict::Undecided | Verdict::Given => is_weighed() && edited.judged.iter().all(fits),
        Verdict::Fails => edited
            .judged
            .iter()
            .all(|own| fits(own) || is_false_still(own)),
        _ => false,
    }
}

/// Whether no more is known of what is left open than that it does not follow from what stands before, as far as was found.
fn is_simply_open(stop: &Stop) -> bool {
    let reasons = [
        UNDECIDED,
        OPEN_ITSELF,
        ELSEWHERE,
        ELEMENT,
        NAMED,
        UNSAID,
        NO_INDUCTION,
    ];
    reasons.contains(&&*stop.reason)
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
