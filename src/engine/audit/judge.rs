use std::collections::BTreeSet;

use crate::algebra::{Expr, Formula, Symbol};
use crate::derivation::{Assumed, Derivation, Goal, Kind, Source, unconditional, values_at};
use crate::kernel::{Assignment, Obligation, Reject, Standing};
use crate::search::{self, Consistency, Decision, Effort, Implied, InChain, Mended, Stop};

use super::premise::{Usable, usable};
use super::{Auditor, Entry, Judged, Note, Outcome, Verdict};

/// How many earlier equations are looked at for a step that does not follow from what it cites.
const MOST_RELATIVES: usize = 12;
/// How many formulas that are given only later are tried with what does not follow.
const MOST_LATER: usize = 4;
/// How many uncited hypotheses are added, and how hard is tried: most stale citations mean an equation a few
/// lines up.
pub(super) const NEARBY: [(usize, Effort); 2] = [(2, Effort::Light), (8, Effort::Light)];
const FARTHER: [(usize, Effort); 2] = [(40, Effort::Light), (12, Effort::Full)];

/// Judges the goals of one statement.
pub(super) struct Judge<'a> {
    pub derivation: &'a Derivation,
    pub at: usize,
    pub usable: &'a Usable,
    pub auditor: &'a Auditor<'a>,
    /// Premises that are not cited: first those that rest on nothing false, then those that rest on nothing
    /// but what the cited ones rest on already.
    pub others: Option<[Vec<Assumed>; 2]>,
}

/// What was found of one goal.
pub(super) struct Found {
    pub judged: Judged,
    /// What it follows from, where that is not what is cited.
    pub instead: Vec<Source>,
    /// What must hold besides.
    pub conditions: Vec<Formula>,
    /// The premises that cannot all be true.
    pub contradictory: Vec<Source>,
    /// What follows in the place of what fails.
    pub implied: Option<Box<Implied>>,
    /// What is one small edit away from what fails, and follows.
    pub mended: Option<Box<Mended>>,
    /// What would have to be supposed for it to follow.
    pub missing: Vec<Formula>,
    /// What must not vanish was looked for already, from what is cited.
    pub has_conditions: bool,
}

impl Found {
    /// Nothing yet but the goal.
    pub fn open(judged: Judged) -> Found {
        Found {
            judged,
            instead: Vec::new(),
            conditions: Vec::new(),
            contradictory: Vec::new(),
            implied: None,
            mended: None,
            missing: Vec::new(),
            has_conditions: false,
        }
    }
}

/// What a step that does not follow from what it cites may be tried with.
pub(super) struct Attempt {
    cited: Vec<Assumed>,
    /// The likeliest first.
    others: Vec<Assumed>,
    /// The goal from all of them.
    posed: Result<Obligation, Reject>,
}

impl Judge<'_> {
    pub fn goal(&mut self, goal: &Goal, steps: &[(usize, Formula)], premises: &[usize]) -> Found {
        let found = self.judged_from(goal, steps, premises);
        let instead = match &found.judged.outcome {
            Outcome::Open(stop) if !stop.hopeless && found.contradictory.is_empty() => {
                self.refuted_by_roots(goal, steps, premises)
            }
            _ => None,
        };
        instead.unwrap_or(found)
    }

    /// The goal judged from some premises.
    pub(super) fn judged_from(
        &mut self,
        goal: &Goal,
        steps: &[(usize, Formula)],
        premises: &[usize],
    ) -> Found {
        let mut assumed = self.usable.assumed.clone();
        // The other side of an equivalence is supposed; what was shown before in the statement is known.
        assumed.extend(goal.suppositions.iter().map(step));
        if goal.suppositions.is_empty() {
            assumed.extend(steps.iter().map(|(_, formula)| step(formula)));
        }
        let left_out = match self.usable.cases.is_empty() {
            true => None,
            false => self.cases(goal, &mut assumed),
        };
        let found = self.judged(goal, assumed, premises);
        match left_out {
            Some(premise) if !found.judged.outcome.is_proven() => self.without_case(found, premise),
            _ => found,
        }
    }

    fn judged(&mut self, goal: &Goal, assumed: Vec<Assumed>, premises: &[usize]) -> Found {
        let mut found = Found::open(Judged {
            goal: goal.clone(),
            assumed: assumed.clone(),
            outcome: Outcome::Open(Stop::default()),
        });
        if let Some(constant) = self.some_constant(goal, &assumed) {
            return self.is_constant(goal, &constant, assumed, premises);
        }
        if search::is_scaling(&goal.formula) {
            self.scaling(goal, &assumed, premises, &mut found);
            return found;
        }
        // An identity needs no premises.
        let bare = self.derivation.claim(self.at, &[], &goal.formula);
        if let Some(derived) = search::prove_unconditionally(bare, Effort::Light) {
            found.judged.assumed.clear();
            found.judged.outcome = Outcome::Proven(derived.proven.into());
            return found;
        }
        let claim = self.derivation.claim(self.at, &assumed, &goal.formula);
        let obligation = search::pose(claim);
        let decision = match &obligation {
            Ok(posed) => search::decide_within(posed, &self.auditor.hints(), self.points()),
            Err(reject) => search::hopeless(reject.clone()),
        };
        let condition = match &decision {
            Decision::Proven { conditions, .. } => Some(!conditions.is_empty()),
            _ => None,
        };
        if condition != Some(false) {
            let condition = condition.is_some();
            if self.for_every(goal, &assumed, premises, condition, &mut found) {
                return found;
            }
        }
        match decision {
            Decision::Proven {
                derived,
                conditions,
            } if conditions.is_empty()
                && let Ok(posed) = &obligation =>
            {
                let (kept, least) = self.least(assumed.clone(), goal, posed, derived);
                if kept.iter().any(|a| a.source != Source::Step) && self.contradicts_itself(posed) {
                    found.contradictory = sources(&assumed);
                    found.judged.outcome = Outcome::Open(Stop {
                        reason: "the premises contradict one another, so anything would follow"
                            .into(),
                        ..Stop::default()
                    });
                    return found;
                }
                found.judged.assumed = kept;
                found.judged.outcome = Outcome::Proven(least.into());
            }
            Decision::Proven {
                derived,
                conditions,
            } => {
                // What stands before may say what is missing.
                let attempts = self.attempts(goal, &assumed, premises, None);
                if self.rescue(goal, &attempts, &NEARBY, &mut found) {
                    return found;
                }
                // A condition that the premises rule out proves nothing.
                let with: Vec<Assumed> = conditions.iter().map(step).collect();
                let all: Vec<Assumed> = assumed.iter().cloned().chain(with.clone()).collect();
                if self.is_contradictory(&all, goal) {
                    found.contradictory = sources(&assumed);
                    return found;
                }
                found.judged.assumed.extend(with);
                found.conditions = conditions;
                found.judged.outcome = Outcome::Proven(derived.proven.into());
            }
            Decision::Refuted(refuted) => {
                let claim = self.derivation.claim(self.at, &assumed, &goal.formula);
                let better = search::without_powers_of_nought(&claim, &refuted);
                let refuted = better.unwrap_or(refuted);
                let witness = refuted.witness().clone();
                found.judged.outcome = Outcome::Refuted(refuted.into());
                let marked = self.derivation.equations[self.at].kind == Kind::Marked;
                let settled = marked && goal.questioned || {
                    let attempts = self.attempts(goal, &assumed, premises, Some(witness));
                    self.rescue(goal, &attempts, &NEARBY, &mut found)
                        || self.unstated(goal, &assumed, premises, &mut found)
                        || !self.strengthen(goal, &assumed, premises, &mut found)
                            && self.rescue(goal, &attempts, &FARTHER, &mut found)
                };
                if !settled {
                    self.instead(goal, &assumed, premises, &mut found);
                }
            }
            Decision::Open(stop) => {
                let hopeless = stop.hopeless;
                found.judged.outcome = Outcome::Open(stop);
                let rescued = !hopeless && {
                    let attempts = self.attempts(goal, &assumed, premises, None);
                    self.rescue(goal, &attempts, &NEARBY, &mut found)
                        || self.rescue(goal, &attempts, &FARTHER, &mut found)
                };
                if !rescued && obligation.is_ok_and(|posed| self.contradicts_itself(&posed)) {
                    found.contradictory = sources(&assumed);
                }
            }
        }
        found
    }

    /// How many choices of values may be tried, where the author limits that.
    pub(super) fn points(&self) -> Option<usize> {
        let page = &self.derivation.pages[self.derivation.equations[self.at].page];
        page.beside.as_ref()?.budget.points
    }

    /// Looks for what holds in the place of what was refuted: a consequence, a mended formula, or what was not said.
    pub(super) fn instead(
        &mut self,
        goal: &Goal,
        assumed: &[Assumed],
        premises: &[usize],
        found: &mut Found,
    ) {
        let Outcome::Refuted(refuted) = &found.judged.outcome else {
            return;
        };
        let claim = self.derivation.claim(self.at, assumed, &goal.formula);
        let Some(chain) = self.in_chain(goal, assumed) else {
            return;
        };
        // What the text itself names is likelier meant than that the pen slipped.
        let mentioned = self.derivation.mentioned(self.at);
        if !mentioned.is_empty() {
            let mentioned = mentioned.into_iter().map(|(_, formula)| formula).collect();
            let (witness, hints) = (refuted.witness(), self.auditor.hints());
            let missing = search::missing_among(&claim, witness, mentioned, &hints, values_at);
            if let Some((all, _)) = missing {
                found.missing = all;
                return;
            }
        }
        let begins = matches!(goal.formula.as_equation(), Some((Expr::Symbol(_), _)));
        let settled = match begins {
            true => chain.right_settled,
            false => chain.left_settled,
        };
        if !settled {
            let implied = search::implied(&claim);
            // To be told what a premise says helps nobody who cites it.
            let helps = |i: &Implied| !i.restates() || i.ratio.is_some();
            found.implied = implied.filter(helps).map(Box::new);
        }
        // Where only a factor is wrong, the author's own words are kept already.
        if !found.implied.as_ref().is_some_and(|i| i.is_multiple()) {
            let witness = refuted.witness();
            let hints = self.auditor.hints();
            let mended = search::mended(&claim, &chain, witness, &hints, values_at);
            found.mended = mended.map(Box::new);
        }
        if !found.has_conditions
            && let Some(unless) =
                search::missing_conditions(&claim, Some(refuted.witness()), &self.auditor.hints())
        {
            found.conditions = unless.conditions();
        }
        if found.conditions.is_empty()
            && found.mended.is_none()
            && found
                .implied
                .as_ref()
                .is_none_or(|i| i.restates() && !i.is_multiple())
        {
            let elsewhere = self.later(premises);
            let hints = self.auditor.hints();
            let missing = search::missing_suppositions(
                &claim,
                refuted.witness(),
                &elsewhere,
                &hints,
                values_at,
            );
            if let Some((all, _)) = missing {
                (found.missing, found.implied) = (all, None);
            } else {
                self.mended_from_all(goal, assumed, premises, &chain, found);
                if found.mended.is_none() {
                    self.mended_under_conditions(goal, assumed, premises, &chain, found);
                }
            }
        }
    }

    /// Which side of a refuted link may be wrong, as far as its neighbours tell; nothing where it is only the left one,
    /// which is the link before to put right.
    fn in_chain(&self, goal: &Goal, assumed: &[Assumed]) -> Option<InChain> {
        let sides = |goal: &Goal| {
            let (left, right) = goal.formula.as_equation()?;
            Some((left.clone(), right.clone()))
        };
        // Where a chain goes on rightly past a member, that member is wrong.
        let joined = |one: &Goal, other: &Goal| {
            let joined = sides(one).zip(sides(other));
            joined.is_some_and(|((left, _), (_, right))| {
                let formula = Formula::equal(left, right);
                let claim = self.derivation.claim(self.at, assumed, &formula);
                search::prove_unconditionally(claim, Effort::Light).is_some()
            })
        };
        let before = self.derivation.link_before(self.at, goal);
        if let Some(before) = before.as_ref().filter(|before| joined(before, goal)) {
            // Of what an author only asks no repair is looked for.
            let asked = InChain {
                right_settled: true,
                ..InChain::default()
            };
            return before.questioned.then_some(asked);
        }
        let after = self.derivation.link_after(self.at, goal);
        let passed = after.as_ref().is_some_and(|after| joined(goal, after));
        Some(InChain {
            left_settled: before.is_some() || passed,
            right_settled: false,
            next: after.map(|after| after.formula),
        })
    }

    /// Whether the author says what the step follows from.
    pub(super) fn names_its_premises(&self) -> bool {
        let (_, says_so, _) = self.derivation.premises(self.at);
        says_so
    }

    /// Hypotheses with the nearest of what stands before and is not cited, if there is anything.
    pub(super) fn with_others(
        &mut self,
        assumed: &[Assumed],
        premises: &[usize],
    ) -> Option<Vec<Assumed>> {
        let [others, _] = self.others(premises);
        let near = others.into_iter().take(NEARBY[1].0);
        let all: Vec<Assumed> = assumed.iter().cloned().chain(near).collect();
        (all.len() > assumed.len()).then_some(all)
    }

    /// The slip of the pen in a step that needs what stands before and is not cited.
    fn mended_from_all(
        &mut self,
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

    /// Whether hypotheses are known not to be true together.
    pub(super) fn is_contradictory(&self, assumed: &[Assumed], goal: &Goal) -> bool {
        if assumed.is_empty() {
            return false;
        }
        let claim = self.derivation.claim(self.at, assumed, &goal.formula);
        // The hints are given back before a new one is remembered.
        let consistency = search::consistency(&claim, &self.auditor.hints());
        self.cannot_be(consistency)
    }

    /// The same of the hypotheses of a claim that was read before.
    pub(super) fn contradicts_itself(&self, posed: &Obligation) -> bool {
        if posed.claim().hypotheses.is_empty() {
            return false;
        }
        let consistency = search::consistency_posed(posed, &self.auditor.hints());
        self.cannot_be(consistency)
    }

    /// Neighbouring steps share their premises, and so the points at which these hold.
    fn cannot_be(&self, consistency: Consistency) -> bool {
        match consistency {
            Consistency::Model(model) => {
                self.auditor.remember(model.point());
                false
            }
            Consistency::Contradictory(_) => true,
            Consistency::Unknown => false,
        }
    }

    /// What a step that does not follow may be tried with: what is cited, and what is not but stands before.
    /// The witness against it may stand against all of these too.
    pub(super) fn attempts(
        &mut self,
        goal: &Goal,
        assumed: &[Assumed],
        premises: &[usize],
        witness: Option<Assignment>,
    ) -> Vec<Attempt> {
        let mut attempts = Vec::new();
        let hints: Vec<Assignment> = witness
            .into_iter()
            .chain(self.auditor.hints().iter().cloned())
            .collect();
        // What is cited and fails can stand in the way of what does follow.
        let failing = self
            .auditor
            .failing(self.at, &premises.iter().copied().collect());
        let fails = |a: &Assumed| matches!(a.source, Source::Equation(p) if failing.contains(&p));
        let sound: Vec<Assumed> = assumed.iter().filter(|a| !fails(a)).cloned().collect();
        let against = self.refuted_from(&failing);
        let tells_against =
            |a: &Assumed| matches!(a.source, Source::Equation(p) if against.contains(&p));
        for others in self.others(premises) {
            if others.is_empty() || !speaks_of_all(assumed.iter().chain(&others), &goal.formula) {
                continue;
            }
            // Together with what it was refuted from, what fails would prove nearly anything.
            let mut harmless = others.clone();
            harmless.retain(|a| !tells_against(a));
            let mut choices = Vec::new();
            if sound.len() < assumed.len() {
                choices.push((sound.clone(), others));
            }
            if !harmless.is_empty() {
                choices.push((assumed.to_vec(), harmless));
            }
            for (cited, others) in choices {
                let all: Vec<Assumed> = cited.iter().chain(&others).cloned().collect();
                let posed = search::pose(self.derivation.claim(self.at, &all, &goal.formula));
                // Where all of it is true and the goal is not, no part of it will do.
                if !posed.as_ref().is_ok_and(|p| search::is_doomed(p, &hints)) {
                    attempts.push(Attempt {
                        cited,
                        others,
                        posed,
                    });
                }
            }
        }
        attempts
    }

    /// The equations at a common point of which failing ones were found to be false.
    fn refuted_from(&self, failing: &[usize]) -> BTreeSet<usize> {
        let entries = failing.iter().flat_map(|&at| self.auditor.entries_of(at));
        let refuted = entries.filter_map(|entry| entry.refuted());
        let premises = refuted.flat_map(|(judged, _)| sources(&judged.assumed));
        let equations = premises.filter_map(|source| match source {
            Source::Equation(at) => Some(at),
            _ => None,
        });
        equations.collect()
    }

    /// Tries again with what stands before, cited or not.
    pub(super) fn rescue(
        &mut self,
        goal: &Goal,
        attempts: &[Attempt],
        stages: &[(usize, Effort)],
        found: &mut Found,
    ) -> bool {
        for attempt in attempts {
            let Attempt { cited, others, .. } = attempt;
            let mut last = None;
            for &(most, effort) in stages {
                // Where there are no more of them, the same would be tried again.
                let most = most.min(others.len());
                if last.replace((most, effort)) == Some((most, effort)) {
                    continue;
                }
                let near = others.iter().take(most);
                let all: Vec<Assumed> = cited.iter().chain(near).cloned().collect();
                let fewer = (most < others.len())
                    .then(|| search::pose(self.derivation.claim(self.at, &all, &goal.formula)));
                let Ok(posed) = fewer.as_ref().unwrap_or(&attempt.posed) else {
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
                found.instead = sources(&kept);
                found.conditions.clear();
                found.judged.assumed = kept;
                found.judged.outcome = Outcome::Proven(least.into());
                return true;
            }
        }
        false
    }

    pub(super) fn others(&mut self, premises: &[usize]) -> [Vec<Assumed>; 2] {
        if let Some(others) = &self.others {
            return others.clone();
        }
        let relatives = self.derivation.relatives(self.at, MOST_RELATIVES);
        // What is cited may rest on something false already, or not proved; then so may what is found instead.
        let own_premises: BTreeSet<usize> = premises.iter().copied().collect();
        let failing = self.auditor.failing(self.at, &own_premises);
        let open = self.auditor.unproved(self.at, &own_premises);
        let (mut sound, mut all) = (Vec::new(), Vec::new());
        // Of a wrong citation, or one of what is not there, is told whatever is found.
        let (_, _, unknown) = self.derivation.premises(self.at);
        let cites = !premises.is_empty() || !unknown.is_empty();
        for other in relatives.into_iter().filter(|r| !premises.contains(r)) {
            let entries: Vec<&Entry> = self.auditor.entries_of(other).collect();
            let conditional = |n: &&Note| matches!(n, Note::UnstatedCondition(_));
            let unsound = |e: &&Entry| {
                let mut conditions = e.notes.iter().filter(conditional);
                e.is_wrong() || e.verdict == Verdict::Undecided || conditions.next().is_some()
            };
            if entries.iter().any(unsound) || !self.may_borrow(other, cites) {
                continue;
            }
            let unproved = |n: &Note| match n {
                Note::RestsOnUnproved(on) => on.clone(),
                _ => Vec::new(),
            };
            let notes = entries.iter().flat_map(|e| &e.notes);
            let unproved: Vec<usize> = notes.flat_map(unproved).collect();
            let mut rests_on = entries.iter().flat_map(|e| &e.rests_on).peekable();
            if rests_on.peek().is_none() && unproved.is_empty() {
                sound.push(other);
            }
            if rests_on.all(|r| failing.contains(r)) && unproved.iter().all(|u| open.contains(u)) {
                all.push(other);
            }
        }
        let own = self.usable.assumed.len();
        let told = self.derivation.told(self.at);
        let gather = |list: &[usize]| {
            let gathered = {
                let offer = |premise| self.auditor.offer(self.at, premise);
                usable(self.derivation, offer, self.at, list).assumed
            };
            let mut extra: Vec<Assumed> = told
                .iter()
                .cloned()
                .chain(gathered)
                .filter(|a| !self.usable.assumed.contains(a))
                .collect();
            extra.truncate(own + 40);
            extra
        };
        let others = match sound.len() == all.len() {
            true => [gather(&sound), Vec::new()],
            false => [gather(&sound), gather(&all)],
        };
        self.others = Some(others.clone());
        others
    }

    /// Whether all that an earlier equation was shown under is supposed here too: what is not cited brings no special case with it.
    /// In the place of a wrong citation, which is told of, one under mere conditions will do.
    fn may_borrow(&self, other: usize, cites: bool) -> bool {
        let own = &self.derivation.equations[self.at];
        let Some(offer) = self.auditor.offer(self.at, other) else {
            return false;
        };
        offer.under.iter().all(|&(page, local)| {
            let formulas = &self.derivation.local(page, local).formulas;
            own.is_under(page, local) || cites && formulas.iter().all(|f| f.as_equation().is_none())
        })
    }

    /// What is given further on in the page and not cited: an author may have used it too soon.
    fn later(&self, premises: &[usize]) -> Vec<Formula> {
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
    fn strengthen(
        &mut self,
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
        let [mut sound, _] = self.others(premises);
        sound.retain(near);
        if sound.is_empty() {
            return false;
        }
        let all: Vec<Assumed> = assumed.iter().cloned().chain(sound).collect();
        let larger = self.derivation.claim(self.at, &all, &goal.formula);
        let claim = self.derivation.claim(self.at, assumed, &goal.formula);
        if let Some(refuted) = search::refute_in_context(&claim, larger) {
            found.judged.outcome = Outcome::Refuted(refuted.into());
            return true;
        }
        false
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

/// A hypothesis that is supposed, or was shown before, in the statement itself.
pub(super) fn step(formula: &Formula) -> Assumed {
    Assumed {
        formula: formula.clone().into(),
        standing: Standing::AtPoint,
        source: Source::Step,
    }
}

/// Where hypotheses come from, each source once.
pub(super) fn sources(assumed: &[Assumed]) -> Vec<Source> {
    let mut all: Vec<Source> = assumed
        .iter()
        .map(|a| a.source)
        .filter(|s| *s != Source::Step)
        .collect();
    all.sort();
    all.dedup();
    all
}
