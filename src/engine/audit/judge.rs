//! One goal: from what it is decided, and what to say of it.

mod decided;
mod instead;
mod together;
mod unclear;

use std::cell::{OnceCell, RefCell};
use std::rc::Rc;

use crate::algebra::{Expr, Formula, Symbol, effort};
use crate::derivation::{Assumed, Beyond, Derivation, Goal, Source};
use crate::kernel::{Claim, Obligation, Refuted, Reject, Standing};
use crate::notation::{plain, plain_symbol};
use crate::search::{self, Change, Decision, Effort, Implied, Mended};
use crate::sorted::{self, Set};

use self::unclear::{
    moves_unseen, only_changes, prescribes, squared_to_nought, takes_slope_at_a_point,
};
use super::again::borrowed::Before;
use super::again::limiting::is_told_of;
use super::premise::Usable;
use super::{Auditor, Judged, Outcome, stated};

/// So much work is done to see whether a link is an identity.
const MOST_WORK_FOR_IDENTITY: u64 = 200_000;
/// How many uncited hypotheses are added, and how hard is tried: most stale citations mean an equation a few
/// lines up.
pub(super) const NEARBY: [(usize, Effort); 2] = [(2, Effort::Light), (8, Effort::Light)];
/// Why nothing is said of partial derivatives of which the page does not say what they hold fixed.
pub(super) const UNCLEAR: &str = "it is not clear what a partial derivative in it is meant of";
/// Why nothing is said of what is no exact statement about real numbers.
pub(super) fn beyond(own: Beyond) -> &'static str {
    match own {
        Beyond::Complex => {
            "it speaks of complex numbers, and what their real and imaginary parts are cannot be told"
        }
        Beyond::Small => {
            "it speaks of small changes, as far as can be told, and is meant up to their squares"
        }
    }
}
/// Why nothing is proved from premises that cannot all be true.
pub(super) const CONTRADICTORY: &str =
    "the premises contradict one another, so anything would follow";

/// So many claims that were read are kept: what is asked of a step one thing after another is asked of these.
const MOST_READ: usize = 16;

/// Judges the goals of one statement.
pub(super) struct Judge<'a> {
    pub derivation: &'a Derivation,
    pub at: usize,
    pub usable: &'a Usable,
    pub auditor: &'a Auditor<'a>,
    /// What stands before and is not cited, once it is asked for.
    pub before: OnceCell<Before>,
    /// What the text tells and what of this is sound offers; and the same with what rests on no more than what is cited does.
    pub others: OnceCell<[Vec<Assumed>; 2]>,
    /// The claims that were read last, the latest first.
    pub read: RefCell<Vec<Rc<Obligation>>>,
    /// What was said in a section that is over and is said otherwise in this one: nothing stands on it here.
    pub over: Set<usize>,
    /// Whether only proofs are of use to who asks: what holds in the place of what is refuted is not looked for.
    pub only_proofs: bool,
}

impl<'a> Judge<'a> {
    /// Judges by what an equation may use. Its goals are judged from the same premises.
    pub fn new(auditor: &'a Auditor<'a>, at: usize, usable: &'a Usable) -> Judge<'a> {
        Judge {
            derivation: auditor.derivation,
            at,
            usable,
            auditor,
            before: OnceCell::new(),
            others: OnceCell::new(),
            read: RefCell::default(),
            over: Set::new(),
            only_proofs: false,
        }
    }

    /// The same judge, asked only what follows.
    pub fn for_proofs(&self) -> Judge<'a> {
        Judge {
            before: self.before.clone(),
            others: self.others.clone(),
            ..self.for_proofs_from_these()
        }
    }

    /// The same where nothing that stands before is tried besides.
    pub fn for_proofs_from_these(&self) -> Judge<'a> {
        Judge {
            before: Before::default().into(),
            others: <[Vec<Assumed>; 2]>::default().into(),
            read: self.read.clone(),
            over: self.over.clone(),
            only_proofs: true,
            ..*self
        }
    }
}

/// What was found of one goal.
pub(super) struct Found {
    pub judged: Judged,
    /// What it follows from, where that is not what is cited.
    pub instead: Vec<Source>,
    /// Whether it may follow from what is cited all the same: nothing was found against that.
    pub may_follow: bool,
    /// What must hold besides.
    pub conditions: Vec<Formula>,
    /// What is taken as constant besides, and may be.
    pub constant: Vec<Symbol>,
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
            may_follow: false,
            conditions: Vec::new(),
            constant: Vec::new(),
            contradictory: Vec::new(),
            implied: None,
            mended: None,
            missing: Vec::new(),
            has_conditions: false,
        }
    }

    /// Says nothing of a step after all, and not what would hold in its place.
    pub fn leave_open(&mut self, reason: impl Into<String>) {
        self.judged.outcome = Outcome::open(reason);
        (self.implied, self.mended) = (None, None);
        self.missing.clear();
        self.conditions.clear();
    }
}

impl Judge<'_> {
    pub fn goal(&self, goal: &Goal, steps: &[(usize, Formula)], premises: &[usize]) -> Found {
        let mut found = self.goal_from_all(goal, steps, premises);
        let elsewhere = self.of_other_ranges(&found.contradictory);
        if !elsewhere.is_empty() {
            return self.without_what_is_over(goal, steps, premises, elsewhere);
        }
        if found.judged.outcome.is_proven()
            && let Some((twice, over)) = self.joins_two_sections(&found.judged, premises)
        {
            let without = self.without_what_is_over(goal, steps, premises, over);
            if without.judged.outcome.is_proven() || without.judged.outcome.is_refuted() {
                return without;
            }
            let twice = plain(&twice);
            found.leave_open(format!(
                "it joins what two sections say of `{twice}`, and they may speak of different cases"
            ));
        }
        found
    }

    /// The same from all that was said, also of what is over.
    fn goal_from_all(&self, goal: &Goal, steps: &[(usize, Formula)], premises: &[usize]) -> Found {
        if let Some(own) = self.beyond(goal) {
            return Found::open(Judged {
                goal: goal.clone(),
                assumed: Vec::new(),
                outcome: Outcome::open(beyond(own)),
            });
        }
        let found = self.judged_from(goal, steps, premises);
        let instead = match &found.judged.outcome {
            Outcome::Open(stop) if !stop.hopeless && found.contradictory.is_empty() => {
                self.refuted_by_roots(goal, steps, premises)
            }
            _ => None,
        };
        let mut found = instead.unwrap_or(found);
        if found.judged.outcome.is_proven()
            && let Some(own) = self.moves_after_all(goal, premises, &found)
        {
            return own;
        }
        if found.judged.outcome.is_proven()
            && let Some(held) = self.held_though_gone(goal, &found)
        {
            found.instead.clear();
            found.leave_open(format!(
                "it follows only if `{held}` does not change, and what is differentiated is given without that"
            ));
        }
        if found.judged.outcome.is_proven()
            && let Some(own) = self.alone_after_all(goal, steps, premises, &found)
        {
            return own;
        }
        if found.judged.outcome.is_proven()
            && let Some(own) = self.without_roots(goal, steps, premises, &found)
        {
            return own;
        }
        if found.judged.outcome.is_proven()
            && let Some(case) = self.lingering(&found, premises)
        {
            found.instead.clear();
            found.leave_open(format!(
                "it follows only where `{case}`, and nothing says that this is still meant"
            ));
        }
        if found.judged.outcome.is_proven()
            && let Some(symbol) = self.ties_what_grows(&found.judged)
        {
            // What is told of it does not stand in the way of what follows without.
            let mut without = self.usable.assumed.clone();
            without.retain(|own| !is_told_of(own, &symbol));
            let again = self.judged(goal, without, premises);
            match again.judged.outcome.is_proven() {
                true => found = again,
                false => found.leave_open(format!(
                    "it follows only where something says what `{}` is, and in the limit that grows beyond it",
                    plain_symbol(&symbol)
                )),
            }
        }
        if found.judged.outcome.is_proven()
            && let Some(symbol) = squared_to_nought(&found.judged)
        {
            let symbol = plain_symbol(&symbol);
            found.leave_open(format!(
                "the square of `{symbol}` is said to be 0, and so it may be no number: a vector, or something else"
            ));
        }
        if found.judged.outcome.is_proven()
            && let Some(symbol) = self.joins_what_moves(&found.judged)
        {
            found.leave_open(format!(
                "it joins what was said of a constant `{}` with how that changes",
                plain_symbol(symbol)
            ));
        }
        if !found.judged.outcome.is_proven()
            && found.contradictory.is_empty()
            && let Some(own) = self.integrated(goal, premises)
        {
            return own;
        }
        if !found.judged.outcome.is_proven()
            && found.contradictory.is_empty()
            && let Some(own) = self.as_solution(goal, premises, &found)
        {
            return own;
        }
        if !found.judged.outcome.is_proven()
            && let Some(own) = self
                .as_no_solution(goal, premises, Some(&found.judged))
                .or_else(|| self.as_no_integral_of_law(goal, premises))
                .or_else(|| self.as_no_ratio_of_states(goal, &found.judged))
                .or_else(|| self.as_no_frequency(goal, premises))
                .or_else(|| self.as_no_zero(goal))
        {
            return own;
        }
        if matches!(&found.judged.outcome, Outcome::Open(stop) if !stop.hopeless)
            && found.contradictory.is_empty()
            && let Some(own) = self
                .fails_throughout(goal)
                .or_else(|| self.fails_compared(goal, premises))
        {
            return own;
        }
        if !found.judged.outcome.is_proven() {
            let expanded = match self.by_expansion(goal, premises) {
                Some(own) if own.judged.outcome.is_proven() => return own,
                expanded => expanded,
            };
            // What it goes to says more than that its series is another.
            if let Some(own) = self.in_limit(goal, premises, &found).or(expanded) {
                return own;
            }
        }
        if found.contradictory.is_empty()
            && let Some(own) = self.determined_otherwise(goal, premises, &found)
        {
            return own;
        }
        if found.judged.outcome.is_refuted()
            && !self.is_directed()
            && goal.formula.speaks_of_slopes()
            && let Some(own) = self.stays_the_same(goal, &found)
        {
            return own;
        }
        if found.judged.outcome.is_refuted() && self.is_disputed(&found.judged) {
            let reason =
                "the text says that something in it is constant, and the page lets that change";
            found = Found::open(Judged {
                outcome: Outcome::open(reason),
                ..found.judged
            });
        }
        if found.judged.outcome.is_refuted() && takes_slope_at_a_point(&found.judged) {
            found.leave_open("it takes the slope of what the text gives for one moment alone");
        }
        if found.judged.outcome.is_refuted()
            && let Some(moves) = moves_unseen(&found.judged)
        {
            let moves = plain(&moves);
            found.leave_open(format!(
                "`{moves}` is given by what it changes with, and by something that is not seen to change"
            ));
        }
        if found.judged.outcome.is_refuted()
            && found.mended.is_none()
            && let Some(moves) = self.held_and_moving(&found.judged)
        {
            let moves = plain_symbol(&moves);
            found.leave_open(format!(
                "`{moves}` changes, and what it is drawn from does not say how"
            ));
        }
        if found.judged.outcome.is_refuted()
            && self.is_of_unknown_place(goal, &found.judged.assumed)
        {
            found.leave_open(
                "it is said of where slopes vanish, and nothing sound says what these are",
            );
        }
        if found.judged.outcome.is_refuted() && prescribes(&found.judged) {
            found.leave_open("what a value at a place is may be prescribed, and not derived");
        }
        if found.judged.outcome.is_refuted()
            && let Some(changes) = only_changes(&found.judged)
        {
            let changes = plain_symbol(&changes);
            found.leave_open(format!(
                "of `{changes}` only how it changes is told before, and it may be something else here"
            ));
        }
        // What follows with one other sign or number was meant so.
        if found.judged.outcome.is_refuted()
            && !found.mended.as_deref().is_some_and(is_of_numbers)
            && self.is_unclear(&found.judged)
        {
            found = Found::open(Judged {
                outcome: Outcome::open(UNCLEAR),
                ..found.judged
            });
        }
        if found.judged.outcome.is_proven() {
            let held = self.held_for_rates(&found.judged);
            found.constant.extend(held);
        }
        found
    }

    /// That each of some symbols that stands for a quantity is meant to be positive.
    pub(super) fn meant_positive(&self, symbols: Set<Symbol>) -> Vec<Assumed> {
        let page = &self.derivation.pages[self.derivation.equations[self.at].page];
        let quantities = symbols.iter().filter(|own| page.is_quantity(own));
        quantities.map(positive).collect()
    }

    /// What a goal is judged from, where nothing else is needed.
    pub(super) fn cited(
        &self,
        goal: &Goal,
        steps: &[(usize, Formula)],
        premises: &[usize],
    ) -> Vec<Assumed> {
        let mut assumed = self.usable.assumed.clone();
        assumed.retain(|own| !self.announces(own, goal));
        // The other side of an equivalence is supposed; what was shown before in the statement is known.
        assumed.extend(goal.suppositions.iter().map(step));
        if goal.suppositions.is_empty() {
            assumed.extend(steps.iter().map(|(_, formula)| step(formula)));
        }
        let instances = self.instances(goal, &assumed);
        assumed.extend(instances);
        assumed.extend(self.along_the_motion(goal, &assumed));
        assumed.extend(self.rates_of_relations(goal, &assumed));
        assumed.extend(self.propagated(goal, &assumed, premises));
        assumed.extend(self.averaged(goal, &assumed));
        assumed
    }

    /// The goal judged from some premises.
    pub(super) fn judged_from(
        &self,
        goal: &Goal,
        steps: &[(usize, Formula)],
        premises: &[usize],
    ) -> Found {
        let mut assumed = self.cited(goal, steps, premises);
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

    /// What to say of a link that is so whatever its symbols are, for which nothing was left by what was tried before.
    pub(super) fn as_identity(&self, goal: &Goal) -> Option<Found> {
        let claim = self.derivation.claim(self.at, &[], &goal.formula);
        let derived = effort::within(MOST_WORK_FOR_IDENTITY, || {
            search::prove_unconditionally(claim, Effort::Light)
        })?;
        Some(Found::open(Judged {
            goal: goal.clone(),
            assumed: Vec::new(),
            outcome: Outcome::Proven(derived.proven.into()),
        }))
    }

    /// A goal from hypotheses as the kernel reads it.
    pub(super) fn pose(
        &self,
        assumed: &[Assumed],
        goal: &Formula,
    ) -> Result<Rc<Obligation>, Reject> {
        self.pose_claim(self.derivation.claim(self.at, assumed, goal))
    }

    /// The same for a claim that is put together otherwise. What was read before is not read again.
    pub(super) fn pose_claim(&self, claim: Claim) -> Result<Rc<Obligation>, Reject> {
        // Claims about one step differ in what they follow from.
        let is_same = |own: &Claim| own.hypotheses == claim.hypotheses && *own == claim;
        let mut read = self.read.borrow_mut();
        let posed = match read.iter().position(|own| is_same(own.claim())) {
            Some(at) => read.remove(at),
            None => Rc::new(search::pose(claim)?),
        };
        read.insert(0, Rc::clone(&posed));
        read.truncate(MOST_READ);
        Ok(posed)
    }

    /// What is decided of a claim that was read, within what the author allows.
    pub(super) fn decide(&self, posed: &Obligation) -> Decision {
        search::decide_within(posed, &self.auditor.hints(), self.points())
    }

    /// What is decided of a goal under hypotheses; nothing where the kernel cannot read that.
    pub(super) fn decide_from(&self, assumed: &[Assumed], goal: &Formula) -> Option<Decision> {
        Some(self.decide(&*self.pose(assumed, goal).ok()?))
    }

    /// A counterexample to a goal under hypotheses; nothing where it follows or is left open.
    pub(super) fn counterexample(&self, assumed: &[Assumed], goal: &Formula) -> Option<Refuted> {
        match self.decide_from(assumed, goal)? {
            Decision::Refuted(refuted) => Some(refuted),
            _ => None,
        }
    }

    /// How many choices of values may be tried, where the author limits that.
    fn points(&self) -> Option<usize> {
        let page = &self.derivation.pages[self.derivation.equations[self.at].page];
        page.beside.as_ref()?.budget.points
    }

    /// Whether the step is said to follow from nothing, and so meant for all values.
    pub(super) fn says_from_nothing(&self) -> bool {
        let (cited, says_so, _) = self.derivation.premises(self.at);
        says_so && cited.is_empty()
    }

    /// Whether the author says what the step follows from.
    pub(super) fn names_its_premises(&self) -> bool {
        let (_, says_so, _) = self.derivation.premises(self.at);
        says_so
    }
}

/// A hypothesis that is supposed, or was shown before, in the statement itself.
pub(super) fn step(formula: &Formula) -> Assumed {
    Assumed {
        formula: formula.clone().into(),
        standing: Standing::AtPoint,
        source: Source::Step,
    }
}

/// A hypothesis that nobody says, and that is meant where something stands for a value of something else.
pub(super) fn taken(formula: &Formula) -> Assumed {
    Assumed {
        source: Source::Taken,
        ..step(formula)
    }
}

/// That a symbol is meant to be positive, as [`taken`].
pub(super) fn positive(own: &Symbol) -> Assumed {
    taken(&Formula::positive(Expr::Symbol(own.clone())))
}

/// A condition under which a step is tried: that something does not change is meant throughout.
pub(super) fn condition(formula: &Formula) -> Assumed {
    let standing = match stated::stands_still(formula) {
        true => Standing::Identity,
        false => Standing::AtPoint,
    };
    Assumed {
        standing,
        ..step(formula)
    }
}

/// Whether what is near differs by no more than a sign, a number or an exponent.
fn is_of_numbers(own: &Mended) -> bool {
    matches!(
        own.change,
        Change::Sign | Change::Coefficient | Change::Exponent
    )
}

/// Where hypotheses come from, each source once.
pub(super) fn sources(assumed: &[Assumed]) -> Vec<Source> {
    let mut all: Vec<Source> = assumed
        .iter()
        .map(|a| a.source)
        .filter(|s| !s.is_of_statement())
        .collect();
    sorted::sort(&mut all);
    all.dedup();
    all
}
