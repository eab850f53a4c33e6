//! What stands before and is not cited: what a step follows from in the place of what it cites, or besides.

use std::cell::OnceCell;

use crate::algebra::{Expr, Formula, Symbol};
use crate::derivation::{Assumed, Goal, Kind, Local, Source, unconditional, values_at};
use crate::kernel::{Assignment, Obligation};
use crate::search::{self, Effort, InChain};

use super::super::judge::{Found, Judge, NEARBY, sources};
use super::super::premise::usable;
use super::super::{Entry, Note, Outcome, Verdict};
use crate::sorted::Set;

/// How many earlier equations are looked at for a step that does not follow from what it cites.
const MOST_RELATIVES: usize = 12;
/// How many more formulas than are cited come of these.
const MOST_BORROWED: usize = 40;
/// How many formulas that are given only later are tried with what does not follow.
const MOST_LATER: usize = 4;

/// The equations that stand before a step and that it does not cite.
#[derive(Default)]
pub(in crate::audit) struct Before {
    /// What rests on nothing false or open.
    pub(in crate::audit) sound: Vec<usize>,
    /// What rests on no more than what is cited does.
    all: Vec<usize>,
    /// This, and what is left open itself or holds under conditions.
    open: Vec<usize>,
}

/// What a step that does not follow from what it cites may be tried with.
pub(in crate::audit) struct Attempt {
    cited: Vec<Assumed>,
    /// The likeliest first.
    others: Vec<Assumed>,
    witness: Option<Assignment>,
    whole: OnceCell<Whole>,
}

/// The goal from all that a step may be tried with.
enum Whole {
    Posed(Box<Obligation>),
    /// The kernel cannot read it.
    Unread,
    /// All of it is true somewhere where the goal is not, so that no part of it will do.
    Doomed,
}

impl Judge<'_> {
    /// Hypotheses with the nearest of what stands before and is not cited, if there is anything.
    pub(in crate::audit) fn with_others(
        &self,
        assumed: &[Assumed],
        premises: &[usize],
    ) -> Option<Vec<Assumed>> {
        let [others, _] = self.others(premises);
        // With what it was refuted from, what fails would prove nearly anything.
        let against = match self.names_its_premises() {
            true => Set::new(),
            false => {
                let failing = self.failing(premises);
                let is_joined = self.sound(assumed, &failing).len() < assumed.len();
                self.refuted_from(if is_joined { &failing } else { &[] })
            }
        };
        let near = others.iter().filter(|own| !against.contains(&own.source));
        let near = near.take(NEARBY[1].0).cloned();
        let all: Vec<Assumed> = assumed.iter().cloned().chain(near).collect();
        (all.len() > assumed.len()).then_some(all)
    }

    /// Whether directives on the page say what is given and what follows from what: where none does, citations are seldom complete
    /// either.
    pub(super) fn is_directed(&self) -> bool {
        self.derivation.pages[self.derivation.equations[self.at].page].directs
    }

    /// Whether the step may rest on what stands before as its author goes along: nothing is cited, and no directive says what follows.
    pub(in crate::audit) fn cites_loosely(&self) -> bool {
        !self.names_its_premises() && !self.is_directed()
    }

    /// The slip of the pen in a step that needs what stands before and is not cited.
    pub(in crate::audit) fn mended_from_all(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        premises: &[usize],
        chain: &InChain,
        found: &mut Found,
    ) {
        let Outcome::Refuted(refuted) = &found.judged.outcome else {
            return;
        };
        if self.names_its_premises() {
            return;
        }
        let Some(all) = self.with_others(assumed, premises) else {
            return;
        };
        if !speaks_of_all(all.iter(), &goal.formula) {
            return;
        }
        let claim = self.derivation.claim(self.at, &all, &goal.formula);
        let hints = self.auditor.hints();
        let mended = search::mended(&claim, chain, refuted.witness(), &hints, values_at);
        if let Some(mended) = mended {
            (found.mended, found.implied) = (Some(Box::new(mended)), None);
        }
    }

    /// What a step that does not follow may be tried with: what is cited, and what is not but stands before.
    /// The witness against it may stand against all of these too.
    pub(in crate::audit) fn attempts(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        premises: &[usize],
        witness: Option<Assignment>,
    ) -> Vec<Attempt> {
        let others = self.others(premises);
        self.attempts_with(goal, assumed, premises, witness, others)
    }

    /// What stands before on the page and is not cited, with what is left open or holds under conditions; empty, where nothing is.
    fn open_on_this_page(&self, premises: &[usize]) -> Vec<usize> {
        let Before { all, open, .. } = self.before(premises);
        // Other pages may mean other things by the same letters.
        let page = |at: usize| self.derivation.equations[at].page;
        let mut here = open.clone();
        here.retain(|&other| page(other) == page(self.at));
        match here.iter().all(|other| all.contains(other)) {
            true => Vec::new(),
            false => here,
        }
    }

    /// What that says.
    pub(in crate::audit) fn open_before(&self, premises: &[usize]) -> Vec<Assumed> {
        self.gathered(&self.open_on_this_page(premises))
    }

    /// Tries a step that is not proved from what is itself left open, or holds under conditions.
    pub(in crate::audit) fn rescue_from_open(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        premises: &[usize],
        found: &mut Found,
    ) -> bool {
        let open = self.open_on_this_page(premises);
        self.rescue_from(&open, goal, assumed, premises, found)
    }

    /// Tries a step that does not follow from what it says it does with what stands before under conditions, where no directive says what
    /// follows from what: "Expressed by the frequency, the energy (5) becomes" goes on from what the frequency is, too.
    pub(in crate::audit) fn rescue_from_conditional(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        premises: &[usize],
        found: &mut Found,
    ) -> bool {
        if !self.names_its_premises() || self.is_directed() || !self.failing(premises).is_empty() {
            return false;
        }
        let mut conditional = self.open_on_this_page(premises);
        conditional.retain(|&own| {
            let on = self.auditor.unproved(self.at, &Set::from([own]));
            !self.is_undecided(own) && !on.iter().any(|&other| self.is_undecided(other))
        });
        self.rescue_from(&conditional, goal, assumed, premises, found)
            || !conditional.is_empty() && self.follows_with(&conditional, goal, assumed, found)
    }

    /// Whether something of an equation before is undecided.
    pub(super) fn is_undecided(&self, other: usize) -> bool {
        let mut entries = self.auditor.entries_of(other);
        entries.any(|entry| entry.verdict == Verdict::Undecided)
    }

    /// Tries a step again from some equations before.
    pub(super) fn rescue_from(
        &self,
        open: &[usize],
        goal: &Goal,
        assumed: &[Assumed],
        premises: &[usize],
        found: &mut Found,
    ) -> bool {
        if open.is_empty() {
            return false;
        }
        let open = [self.gathered(open)];
        let attempts = self.attempts_with(goal, assumed, premises, None, &open);
        self.rescue(goal, &attempts, &NEARBY, found)
    }

    /// The same, where symbols that could be anything are not 0.
    pub(in crate::audit) fn follows_from_open(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        premises: &[usize],
        found: &mut Found,
    ) -> bool {
        // From what fails anything may follow, if only hard enough is tried.
        if !self.failing(premises).is_empty() {
            return false;
        }
        let open = self.open_on_this_page(premises);
        if open.is_empty() {
            return false;
        }
        self.follows_with(&open, goal, assumed, found)
    }

    /// Whether a step follows with some equations before, where symbols that could be anything are not 0.
    pub(super) fn follows_with(
        &self,
        equations: &[usize],
        goal: &Goal,
        assumed: &[Assumed],
        found: &mut Found,
    ) -> bool {
        let near = self.gathered(equations).into_iter().take(NEARBY[1].0);
        let all = assumed.iter().cloned().chain(near).collect();
        self.under_conditions(goal, all, None, (true, Effort::Light), found)
    }

    /// Leaves open a step that was refuted from less than what stands before, where all of it with what is itself left open does not
    /// refute it: it may follow from that. Nothing is left open of which a slip of the pen is found, or where the author says what it
    /// follows from.
    pub(in crate::audit) fn heed_what_is_open(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        premises: &[usize],
        found: &mut Found,
    ) {
        if self.names_its_premises() || found.mended.is_some() {
            return;
        }
        let mut open = self.open_on_this_page(premises);
        open.retain(|&other| self.is_undecided(other));
        let names = goal.formula.free_symbols();
        let concerns = |own: &Assumed| {
            let stated = matches!(own.source, Source::Equation(_));
            stated && !own.formula.free_symbols().is_disjoint(&names)
        };
        let open: Vec<Assumed> = (self.gathered(&open).into_iter())
            .filter(concerns)
            .collect();
        if open.is_empty() {
            return;
        }
        let [sound, _] = self.others(premises);
        let sound = sound.iter().chain(&open).cloned();
        let all: Vec<Assumed> = assumed.iter().cloned().chain(sound).collect();
        let larger = self.derivation.claim(self.at, &all, &goal.formula);
        let claim = self.derivation.claim(self.at, assumed, &goal.formula);
        match search::refute_in_context(&claim, larger) {
            Some(refuted) => found.judged.outcome = Outcome::Refuted(refuted.into()),
            None => {
                found.leave_open("it may follow from what stands before and is left open itself");
            }
        }
    }

    fn attempts_with(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        premises: &[usize],
        witness: Option<Assignment>,
        others: &[Vec<Assumed>],
    ) -> Vec<Attempt> {
        let mut attempts = Vec::new();
        let failing = self.failing(premises);
        let sound = self.sound(assumed, &failing);
        let against = self.refuted_from(&failing);
        for others in others {
            if others.is_empty() || !speaks_of_all(assumed.iter().chain(others), &goal.formula) {
                continue;
            }
            // Together with what it was refuted from, what fails would prove nearly anything.
            let mut harmless = others.clone();
            harmless.retain(|own| !against.contains(&own.source));
            let mut choices = Vec::new();
            if sound.len() < assumed.len() {
                choices.push((sound.clone(), others.clone()));
            }
            if !harmless.is_empty() {
                choices.push((assumed.to_vec(), harmless));
            }
            attempts.extend(choices.into_iter().map(|(cited, others)| Attempt {
                cited,
                others,
                witness: witness.clone(),
                whole: OnceCell::new(),
            }));
        }
        attempts
    }

    /// The goal from all of an attempt, once it is asked for.
    fn whole<'a>(&self, goal: &Goal, attempt: &'a Attempt) -> &'a Whole {
        attempt.whole.get_or_init(|| {
            let Attempt { cited, others, .. } = attempt;
            let all: Vec<Assumed> = cited.iter().chain(others).cloned().collect();
            let claim = self.derivation.claim(self.at, &all, &goal.formula);
            let Ok(posed) = search::pose(claim) else {
                return Whole::Unread;
            };
            let known = self.auditor.hints();
            match search::is_doomed(&posed, attempt.witness.iter().chain(&*known)) {
                true => Whole::Doomed,
                false => Whole::Posed(posed.into()),
            }
        })
    }

    /// What is cited and does not fail: what does can stand in the way of what follows.
    pub(in crate::audit) fn sound(&self, assumed: &[Assumed], failing: &[usize]) -> Vec<Assumed> {
        let fails = |a: &Assumed| matches!(a.source, Source::Equation(p) if failing.contains(&p));
        assumed.iter().filter(|a| !fails(a)).cloned().collect()
    }

    /// The failing equations that what is cited rests on.
    pub(in crate::audit) fn failing(&self, premises: &[usize]) -> Vec<usize> {
        let premises = premises.iter().copied().collect();
        self.auditor.failing(self.at, &premises)
    }

    /// What was true at a point at which failing equations were found to be false. Where the point tells slopes, also what that was
    /// shown from: what is refuted from a slope is refuted from what that is the slope of.
    fn refuted_from(&self, failing: &[usize]) -> Set<Source> {
        let entries = failing.iter().flat_map(|&at| self.auditor.entries_of(at));
        let mut found = Set::new();
        for (judged, refuted) in entries.filter_map(|entry| entry.refuted()) {
            let from = sources(&judged.assumed);
            let witness = refuted.witness();
            if witness.course.is_some() || !witness.derivatives.is_empty() {
                found.extend(from.iter().flat_map(|own| self.shown_from(own)));
            }
            found.extend(from);
        }
        found
    }

    /// What an equation before was proved from.
    fn shown_from(&self, source: &Source) -> Vec<Source> {
        let Source::Equation(at) = *source else {
            return Vec::new();
        };
        // What is given may come later, and was shown from nothing.
        if at >= self.at {
            return Vec::new();
        }
        let entries = self.auditor.entries_of(at);
        let judged = entries.flat_map(|entry| &entry.judged);
        let proven = judged.filter(|judged| judged.outcome.is_proven());
        proven.flat_map(|judged| sources(&judged.assumed)).collect()
    }

    /// Tries again with what stands before, cited or not.
    pub(in crate::audit) fn rescue(
        &self,
        goal: &Goal,
        attempts: &[Attempt],
        stages: &[(usize, Effort)],
        found: &mut Found,
    ) -> bool {
        for attempt in attempts {
            let Attempt { cited, others, .. } = attempt;
            let mut last = None;
            for (stage, &(most, effort)) in stages.iter().enumerate() {
                // Where there are no more of them, the same would be tried again.
                let most = most.min(others.len());
                if last.replace((most, effort)) == Some((most, effort)) {
                    continue;
                }
                // To try the nearest is less work than to look at all of them.
                let looked_at = attempt.whole.get().is_some();
                let is_few = stage == 0 && most < others.len();
                if (looked_at || !is_few) && matches!(self.whole(goal, attempt), Whole::Doomed) {
                    break;
                }
                let near = others.iter().take(most);
                let all: Vec<Assumed> = cited.iter().chain(near).cloned().collect();
                let fewer = (most < others.len())
                    .then(|| search::pose(self.derivation.claim(self.at, &all, &goal.formula)));
                let posed = match &fewer {
                    Some(fewer) => fewer.as_ref().ok(),
                    None => match self.whole(goal, attempt) {
                        Whole::Posed(posed) => Some(&**posed),
                        _ => None,
                    },
                };
                let Some(posed) = posed else {
                    continue;
                };
                let Some(derived) = search::prove_posed(posed, effort) else {
                    continue;
                };
                let cited = cited.len();
                let (kept, least) = self.least_borrowed(all, cited, goal, posed, derived);
                if self.is_contradictory(&kept, goal) {
                    continue;
                }
                let from = sources(&kept);
                if let Some(reason) = self.in_other_letters(&from) {
                    found.leave_open(reason);
                    return true;
                }
                found.instead = from;
                found.conditions.clear();
                found.judged.assumed = kept;
                found.judged.outcome = Outcome::Proven(least.into());
                return true;
            }
        }
        false
    }

    /// What stands before and is not cited: what is sound, and the same with what rests on no more than what is cited does. Empty, where
    /// that is no more.
    pub(in crate::audit) fn others(&self, premises: &[usize]) -> &[Vec<Assumed>; 2] {
        self.others.get_or_init(|| {
            let Before { sound, all, .. } = self.before(premises);
            match sound.len() == all.len() {
                true => [self.gathered(sound), Vec::new()],
                false => [self.gathered(sound), self.gathered(all)],
            }
        })
    }

    pub(in crate::audit) fn before(&self, premises: &[usize]) -> &Before {
        self.before.get_or_init(|| self.look_before(premises))
    }

    fn look_before(&self, premises: &[usize]) -> Before {
        let relatives = self.derivation.relatives(self.at, MOST_RELATIVES);
        // What is cited may rest on something false already, or not proved; then so may what is found instead.
        let own_premises: Set<usize> = premises.iter().copied().collect();
        let failing = self.auditor.failing(self.at, &own_premises);
        let unproved = self.auditor.unproved(self.at, &own_premises);
        let mut before = Before::default();
        // Of a wrong citation, or one of what is not there, is told whatever is found.
        let (_, _, unknown) = self.derivation.premises(self.at);
        let cites = !premises.is_empty() || !unknown.is_empty();
        for other in relatives.into_iter().filter(|r| !premises.contains(r)) {
            let entries: Vec<&Entry> = self.auditor.entries_of(other).collect();
            let is_wrong = entries.iter().any(|e| e.is_wrong());
            let is_given = entries.iter().any(|e| e.verdict == Verdict::Given);
            if is_wrong
                || is_given && self.is_of_other_circumstances(other)
                || self.derivation.is_released(self.at, other).is_some()
                || !self.may_borrow(other, cites)
            {
                continue;
            }
            let conditional = |n: &Note| matches!(n, Note::UnstatedCondition(_));
            let is_open =
                |e: &&Entry| e.verdict == Verdict::Undecided || e.notes.iter().any(conditional);
            let is_open = entries.iter().any(is_open);
            let on = |n: &Note| match n {
                Note::RestsOnUnproved(on) => on.clone(),
                _ => Vec::new(),
            };
            let notes = entries.iter().flat_map(|e| &e.notes);
            let on: Vec<usize> = notes.flat_map(on).collect();
            let mut rests_on = entries.iter().flat_map(|e| &e.rests_on).peekable();
            if rests_on.peek().is_none() && on.is_empty() && !is_open {
                before.sound.push(other);
            }
            if rests_on.all(|r| failing.contains(r)) {
                before.open.push(other);
                if on.iter().all(|u| unproved.contains(u)) && !is_open {
                    before.all.push(other);
                }
            }
        }
        before
    }

    /// What the text tells here, and what equations that are not cited offer.
    fn gathered(&self, equations: &[usize]) -> Vec<Assumed> {
        let own = &self.usable.assumed;
        let offer = |premise| self.auditor.offer(self.at, premise);
        let offered = usable(self.derivation, offer, self.at, equations).assumed;
        let told = self.derivation.told(self.at).into_iter();
        let mut gathered: Vec<Assumed> = told.chain(offered).filter(|a| !own.contains(a)).collect();
        gathered.truncate(own.len() + MOST_BORROWED);
        gathered
    }

    /// Whether the words before a step say that it is of other circumstances than an equation was said under.
    fn is_of_other_circumstances(&self, other: usize) -> bool {
        let equations = &self.derivation.equations;
        let (own, other) = (&equations[self.at], &equations[other]);
        let first = self.derivation.equations_of(own.page).start;
        own.page == other.page
            && other.circumstances.is_some()
            && own.circumstances == Some(self.at - own.row.min(self.at) - first)
    }

    /// An equation of a section above that speaks of a letter which the section of this one introduces anew.
    fn in_other_letters(&self, sources: &[Source]) -> Option<String> {
        let own = &self.derivation.equations[self.at];
        if own.anew.is_empty() {
            return None;
        }
        let page = self.derivation.equations_of(own.page);
        let (cited, ..) = self.derivation.premises(self.at);
        let mut above = sources.iter().filter_map(|source| match *source {
            Source::Equation(other) if other < page.start + own.section_start => Some(other),
            _ => None,
        });
        let letter = above.find_map(|other| {
            let spoken_of = self.derivation.equations[other].symbols();
            let mut anew = own.anew.iter().filter(|_| !cited.contains(&other));
            anew.find(|&letter| spoken_of.contains(letter))
        })?;
        Some(format!(
            "it follows from what stands above, where `{letter}` may mean something else"
        ))
    }

    /// Whether all that an earlier equation was shown under is supposed here too: what is not cited brings no special case with it.
    /// In the place of a wrong citation, which is told of, one under mere conditions will do.
    pub(super) fn may_borrow(&self, other: usize, cites: bool) -> bool {
        let own = &self.derivation.equations[self.at];
        let Some(offer) = self.auditor.offer(self.at, other) else {
            return false;
        };
        let goes_on = self.goes_on_from(other);
        offer.under.iter().all(|&(page, local)| {
            let said = self.derivation.local(page, local);
            let bounds = || said.formulas.iter().all(|f| f.as_equation().is_none());
            let special = || said.is_let || said.is_case() || said.is_momentary();
            let means = || said.is_told && said.means && !self.is_replaced(said);
            let is_meant = own.is_under(page, local) || goes_on && !special() || means();
            is_meant && !self.derivation.is_beyond(self.at, (page, local)) || cites && bounds()
        })
    }

    /// Whether something else is said here in the place of what was told.
    fn is_replaced(&self, told: &Local) -> bool {
        let own = &self.derivation.equations[self.at];
        let in_effect = own.locals.iter().chain(&own.told).chain(&own.named);
        let mut others = in_effect.map(|&other| self.derivation.local(own.page, other));
        others.any(|other| told.is_replaced_by(other))
    }

    /// What is given further on in the page and not cited: an author may have used it too soon.
    pub(in crate::audit) fn later(&self, premises: &[usize]) -> Vec<Formula> {
        let equations = &self.derivation.equations;
        let own = self.derivation.equations_of(equations[self.at].page);
        let given = (self.at + 1..own.end)
            .take(MOST_RELATIVES)
            .filter(|at| equations[*at].kind == Kind::Given && !premises.contains(at));
        let statements = given.flat_map(|at| equations[at].statements());
        statements
            .flat_map(unconditional)
            .take(MOST_LATER)
            .collect()
    }

    /// Looks for a counterexample at which what stands before is true too: it convinces more, and nothing that
    /// stands before can then be what the step follows from.
    pub(in crate::audit) fn strengthen(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        premises: &[usize],
        found: &mut Found,
    ) -> bool {
        // Other pages may mean other things by the same letters.
        let page = self.derivation.equations[self.at].page;
        let near = |a: &Assumed| match a.source {
            Source::Equation(other) => self.derivation.equations[other].page == page,
            Source::Local(other, _) => other == page,
            Source::Step => true,
        };
        let [sound, _] = self.others(premises);
        let sound = sound.iter().filter(|own| near(own)).cloned();
        let all: Vec<Assumed> = assumed.iter().cloned().chain(sound).collect();
        if all.len() == assumed.len() {
            return false;
        }
        let larger = self.derivation.claim(self.at, &all, &goal.formula);
        let claim = self.derivation.claim(self.at, assumed, &goal.formula);
        if let Some(refuted) = search::refute_in_context(&claim, larger) {
            found.judged.outcome = Outcome::Refuted(refuted.into());
            return true;
        }
        false
    }

    /// What gives as an integral a symbol of a goal on which what is cited is silent, or a function that this applies: a counterexample that
    /// gives it any value is none to what the author says.
    pub(in crate::audit) fn told_before(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        premises: &[usize],
    ) -> Vec<Assumed> {
        let integral = |part: &Expr| matches!(part, Expr::Integral { .. });
        let names = goal.formula.free_symbols();
        let concerns = |own: &&Assumed| !own.formula.free_symbols().is_disjoint(&names);
        let mut applied = Set::new();
        for term in (assumed.iter().filter(concerns)).flat_map(|own| own.formula.terms()) {
            term.collect_applied(&|_| true, &mut applied);
        }
        // What is cited says itself what these are.
        for own in assumed {
            if let Some((Expr::Apply(function, _), _)) = own.formula.as_equation() {
                applied.remove(function);
            }
        }
        let tells = |own: &&Assumed| match own.formula.as_equation() {
            Some((Expr::Apply(function, _), _)) => applied.contains(function),
            Some((Expr::Symbol(symbol), term)) => {
                let one = Formula::equal(Expr::Symbol(symbol.clone()), Expr::integer(0));
                names.contains(symbol)
                    && term.any(&integral)
                    && !speaks_of_all(assumed.iter(), &one)
            }
            _ => false,
        };
        let [near, _] = self.others(premises);
        near.iter().filter(tells).cloned().collect()
    }
}

impl Judge<'_> {
    /// Leaves open a step that cites nothing and is of something else than what stands just before it, unless it is refuted with what
    /// speaks of it, or a slip of the pen is found.
    pub(in crate::audit) fn heed_what_is_elsewhere(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        premises: &[usize],
        found: &mut Found,
    ) {
        if !found.judged.outcome.is_refuted() || found.mended.is_some() {
            return;
        }
        let elsewhere = self.said_elsewhere(goal, assumed, premises);
        if elsewhere.is_empty() {
            return;
        }
        if !self.refutes_with(goal, assumed, elsewhere, premises, found) {
            found.leave_open(
                "what stands just before says nothing of some symbol in it, and nothing decides it with what does",
            );
        }
    }

    /// Whether a step is refuted with what stands elsewhere, too. A point that everything before allows says most; if none is found,
    /// one that this allows.
    pub(in crate::audit) fn refutes_with(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        elsewhere: Vec<Assumed>,
        premises: &[usize],
        found: &mut Found,
    ) -> bool {
        let with = assumed.iter().cloned().chain(elsewhere).collect();
        let everything = self.with_others(assumed, premises);
        everything.into_iter().chain([with]).any(|all| {
            let Some(refuted) = self.counterexample(&all, &goal.formula) else {
                return false;
            };
            found.judged.outcome = Outcome::Refuted(refuted.into());
            found.judged.assumed = all;
            true
        })
    }

    /// What stands before and speaks of a symbol of which what stands just before a step that cites nothing says nothing: with that as
    /// the premise the symbol could have any value.
    fn said_elsewhere(&self, goal: &Goal, assumed: &[Assumed], premises: &[usize]) -> Vec<Assumed> {
        let mut names = goal.formula.names();
        names.retain(|symbol| !symbol.is_unit());
        let is_premise = |own: &&Assumed| matches!(own.source, Source::Equation(_));
        let mut near = assumed.iter().filter(is_premise).peekable();
        if !self.cites_loosely() || near.peek().is_none() {
            return Vec::new();
        }
        for own in near {
            let spoken_of = own.formula.names();
            names.retain(|symbol| !spoken_of.contains(symbol));
        }
        let speaks = |own: &&Assumed| !own.formula.names().is_disjoint(&names);
        let [others, _] = self.others(premises);
        let speaking = others.iter().filter(is_premise).filter(speaks);
        speaking.take(NEARBY[1].0).cloned().collect()
    }
}

/// Whether hypotheses say something of each symbol of a goal: one of which nothing at all is said can have any value.
fn speaks_of_all<'a>(
    hypotheses: impl Iterator<Item = &'a Assumed> + Clone,
    goal: &Formula,
) -> bool {
    let said = |symbol: &&Symbol| {
        let mut terms = hypotheses.clone().flat_map(|a| a.formula.terms());
        terms.any(|term| term.mentions(symbol))
    };
    Formula::free_symbols_of(std::iter::once(goal))
        .iter()
        .all(said)
}
