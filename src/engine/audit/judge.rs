use std::cell::OnceCell;

use crate::algebra::{Expr, Formula, Symbol};
use crate::derivation::{Assumed, Derivation, Goal, Kind, Source, values_at};
use crate::kernel::{Obligation, Refuted, Standing};
use crate::search::{self, Consistency, Decision, Effort, Implied, InChain, Mended, Stop};
use crate::sorted;

use super::borrowed::Before;
use super::premise::Usable;
use super::{Auditor, Judged, Outcome, stated};

/// How many uncited hypotheses are added, and how hard is tried: most stale citations mean an equation a few
/// lines up.
pub(super) const NEARBY: [(usize, Effort); 2] = [(2, Effort::Light), (8, Effort::Light)];
/// Why nothing is said of partial derivatives of which the page does not say what they hold fixed.
pub(super) const UNCLEAR: &str = "it is not clear what a partial derivative in it is meant of";
/// Why nothing is said of what may be complex.
pub(super) const COMPLEX: &str =
    "it speaks of complex numbers, as far as can be told, and only real ones are decided";
/// Why nothing is proved from premises that cannot all be true.
pub(super) const CONTRADICTORY: &str =
    "the premises contradict one another, so anything would follow";
const FARTHER: [(usize, Effort); 2] = [(40, Effort::Light), (12, Effort::Full)];

/// Laws are differentiated only where more is tried.
const SLOPES: [(usize, Effort); 1] = [(8, Effort::Full)];

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
        if self.is_complex(goal) {
            return Found::open(Judged {
                goal: goal.clone(),
                assumed: Vec::new(),
                outcome: Outcome::open(COMPLEX),
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
            && let Some(symbol) = self.joins_what_moves(&found.judged)
        {
            found.leave_open(format!(
                "it joins what was said of a constant `{symbol}` with how that changes"
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
            && let Some(own) = self.in_limit(goal, premises, &found)
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
        if found.judged.outcome.is_refuted() && self.is_unclear(&found.judged) {
            found = Found::open(Judged {
                outcome: Outcome::open(UNCLEAR),
                ..found.judged
            });
        }
        found
    }

    /// Whether something speaks of a partial derivative of which it is not clear what it holds fixed, or how it moves: that
    /// `\frac{d}{dt} \frac{\partial L}{\partial \dot x}` goes with `\ddot x` is nowhere said.
    fn is_unclear(&self, judged: &Judged) -> bool {
        let page = self.derivation.equations[self.at].page;
        let unclear = &self.derivation.pages[page].unclear_slopes;
        if self.derivation.pages[page].dependent.is_empty() {
            return false;
        }
        let is_partial = |part: &Expr| matches!(part, Expr::Partial { .. });
        let is_one = |part: &Expr| match part {
            Expr::Derivative { body, .. } => body.any(&is_partial),
            Expr::Partial { body, variable, .. } => unclear
                .iter()
                .any(|(name, own)| own == variable && body.mentions(name)),
            _ => false,
        };
        // What was left out of the counterexample may be what it was to be drawn from.
        let assumed = judged.assumed.iter().chain(&self.usable.assumed);
        let formulas = assumed.map(|own| &*own.formula);
        let mut all = formulas.chain([&judged.goal.formula]);
        all.any(|formula| formula.terms().into_iter().any(|term| term.any(&is_one)))
    }

    /// What is constant by one of the premises of a proof and changes by another.
    fn joins_what_moves(&self, judged: &Judged) -> Option<&Symbol> {
        let all = sources(&judged.assumed).into_iter();
        let all: Vec<usize> = all
            .filter_map(|source| match source {
                Source::Equation(premise) => Some(premise),
                _ => None,
            })
            .collect();
        let derivation = self.derivation;
        let constant = all
            .iter()
            .find_map(|&own| derivation.is_released(self.at, own));
        constant.filter(|&symbol| {
            let mut own = all.iter().map(|&own| &derivation.equations[own]);
            own.any(|own| own.released.contains(symbol) && own.symbols().contains(symbol))
        })
    }

    /// Whether a goal speaks of what may be complex.
    pub(super) fn is_complex(&self, goal: &Goal) -> bool {
        let page = self.derivation.equations[self.at].page;
        self.derivation.pages[page].is_complex(&goal.formula)
    }

    /// Whether a step takes slopes or integrals, and it cannot be told whether something in it changes.
    fn is_disputed(&self, judged: &Judged) -> bool {
        let disputed = &self.derivation.equations[self.at].disputed;
        let runs = |part: &Expr| matches!(part, Expr::Derivative { .. } | Expr::Integral { .. });
        let formulas = judged.assumed.iter().map(|own| &*own.formula);
        let mut all = formulas.chain([&judged.goal.formula]);
        let goal = judged.goal.formula.terms();
        !disputed.is_empty()
            && goal.into_iter().any(|term| term.any(&runs))
            && all.any(|formula| !formula.names().is_disjoint(disputed))
    }

    /// What a goal is judged from, where nothing else is needed.
    pub(super) fn cited(&self, goal: &Goal, steps: &[(usize, Formula)]) -> Vec<Assumed> {
        let mut assumed = self.usable.assumed.clone();
        // The other side of an equivalence is supposed; what was shown before in the statement is known.
        assumed.extend(goal.suppositions.iter().map(step));
        if goal.suppositions.is_empty() {
            assumed.extend(steps.iter().map(|(_, formula)| step(formula)));
        }
        let instances = self.instances(goal, &assumed);
        assumed.extend(instances);
        assumed
    }

    /// The goal judged from some premises.
    pub(super) fn judged_from(
        &self,
        goal: &Goal,
        steps: &[(usize, Formula)],
        premises: &[usize],
    ) -> Found {
        let mut assumed = self.cited(goal, steps);
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

    pub(super) fn judged(&self, goal: &Goal, assumed: Vec<Assumed>, premises: &[usize]) -> Found {
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
        if may_be_an_identity(&goal.formula)
            && let bare = self.derivation.claim(self.at, &[], &goal.formula)
            && let Some(derived) = search::prove_unconditionally(bare, Effort::Light)
        {
            found.judged.assumed.clear();
            found.judged.outcome = Outcome::Proven(derived.proven.into());
            return found;
        }
        let claim = self.derivation.claim(self.at, &assumed, &goal.formula);
        let obligation = search::pose(claim);
        let named = OnceCell::new();
        let named = || {
            named
                .get_or_init(|| self.with_what_is_named(goal, &assumed))
                .as_deref()
        };
        let decision = match &obligation {
            Ok(posed) => self.decide(posed),
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
                    found.judged.outcome = Outcome::open(CONTRADICTORY);
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
                let divides = conditions.iter().any(|own| own.is_nonzero());
                if self.rescue(goal, &attempts, &NEARBY, &mut found)
                    || divides
                        && goal.formula.speaks_of_slopes()
                        && self.rescue(goal, &attempts, &SLOPES, &mut found)
                {
                    return found;
                }
                // A condition that the premises rule out proves nothing.
                let with = conditions.iter().map(step);
                let all: Vec<Assumed> = assumed.iter().cloned().chain(with).collect();
                if self.is_contradictory(&all, goal) {
                    found.contradictory = sources(&assumed);
                    return found;
                }
                // What follows under a condition alone rests on nothing else.
                let posed = search::pose(self.derivation.claim(self.at, &all, &goal.formula));
                let again = posed
                    .ok()
                    .and_then(|posed| Some((search::prove_posed(&posed, Effort::Light)?, posed)));
                let (kept, least) = match again {
                    Some((derived, posed)) => self.least(all, goal, &posed, derived),
                    None => (all, derived.proven),
                };
                let is_kept = |own: &Formula| kept.contains(&step(own));
                found.conditions = conditions.into_iter().filter(is_kept).collect();
                found.judged.assumed = kept;
                found.judged.outcome = Outcome::Proven(least.into());
            }
            Decision::Refuted(refuted) => {
                let claim = self.derivation.claim(self.at, &assumed, &goal.formula);
                let better = search::without_powers_of_nought(&claim, &refuted);
                let refuted = better.unwrap_or(refuted);
                let witness = refuted.witness().clone();
                found.judged.outcome = Outcome::Refuted(refuted.into());
                let marked = self.derivation.equations[self.at].kind == Kind::Marked;
                let mut strong = false;
                let settled = marked && goal.questioned || {
                    let attempts = self.attempts(goal, &assumed, premises, Some(witness));
                    self.rescue(goal, &attempts, &NEARBY, &mut found)
                        || self.rescue_going_on(goal, &assumed, premises, &mut found)
                        || named().is_some_and(|all| {
                            self.follows_from_words(goal, all, premises, &mut found)
                                || self.rescue_going_on(goal, all, premises, &mut found)
                        })
                        || self.follows_without_units(goal, &assumed, &mut found)
                        || self.follows_at_place(goal, named().unwrap_or(&assumed), &mut found)
                        || self.unstated(goal, &assumed, premises, &mut found)
                        || self.rescue_from_conditional(goal, &assumed, premises, &mut found)
                        || {
                            strong = self.strengthen(goal, &assumed, premises, &mut found);
                            let (loosely, found) = (self.cites_loosely(), &mut found);
                            !strong && self.rescue(goal, &attempts, &FARTHER, found)
                                || loosely && self.rescue_from_open(goal, &assumed, premises, found)
                                || loosely
                                    && !strong
                                    && self.follows_from_open(goal, &assumed, premises, found)
                        }
                };
                let told_before = match settled || strong {
                    true => Vec::new(),
                    false => self.told_before(goal, &assumed, premises),
                };
                if !told_before.is_empty() {
                    if !self.refutes_with(goal, &assumed, told_before, premises, &mut found) {
                        let reason = "of some symbol in it only what stands before and is not cited speaks, and \
                                      nothing decides it with that";
                        found.judged.outcome = Outcome::open(reason);
                    }
                } else if !settled {
                    let all = named().unwrap_or(&assumed);
                    let is_heeded =
                        named().is_none() || self.heed_what_is_named(goal, all, &mut found);
                    self.instead(goal, all, premises, &mut found);
                    if !is_heeded && found.mended.is_none() {
                        found.leave_open("it may follow with what the text before it names");
                    }
                    if !strong {
                        self.heed_what_is_elsewhere(goal, &assumed, premises, &mut found);
                    }
                    self.heed_what_varies(goal, all, premises, &mut found);
                    self.heed_what_is_open(goal, all, premises, &mut found);
                }
            }
            Decision::Open(stop) => {
                let hopeless = stop.hopeless;
                // Premises that say nothing to an identity or inequality only stand in its way.
                let bare = self.derivation.claim(self.at, &[], &goal.formula);
                if !hopeless
                    && !assumed.is_empty()
                    && let Some(derived) = search::prove_unconditionally(bare, Effort::Full)
                {
                    found.judged.assumed.clear();
                    found.judged.outcome = Outcome::Proven(derived.proven.into());
                    return found;
                }
                found.judged.outcome = Outcome::Open(stop);
                let rescued = !hopeless && {
                    let attempts = self.attempts(goal, &assumed, premises, None);
                    self.rescue(goal, &attempts, &NEARBY, &mut found)
                        || self.rescue(goal, &attempts, &FARTHER, &mut found)
                        || named().is_some_and(|all| {
                            self.follows_from_words(goal, all, premises, &mut found)
                        })
                        || self.follows_without_units(goal, &assumed, &mut found)
                        || self.rescue_from_open(goal, &assumed, premises, &mut found)
                        || self.unstated(goal, &assumed, premises, &mut found)
                        || self.follows_from_open(goal, &assumed, premises, &mut found)
                };
                found.may_follow = rescued;
                if !rescued && !hopeless && self.cites_loosely() {
                    let told_before = self.told_before(goal, &assumed, premises);
                    if !told_before.is_empty()
                        && self.refutes_with(goal, &assumed, told_before, premises, &mut found)
                    {
                        return found;
                    }
                }
                if !rescued && obligation.is_ok_and(|posed| self.contradicts_itself(&posed)) {
                    found.contradictory = sources(&assumed);
                }
            }
        }
        found
    }

    /// What is decided of a claim that was read, within what the author allows.
    pub(super) fn decide(&self, posed: &Obligation) -> Decision {
        search::decide_within(posed, &self.auditor.hints(), self.points())
    }

    /// What is decided of a goal under hypotheses; nothing where the kernel cannot read that.
    pub(super) fn decide_from(&self, assumed: &[Assumed], goal: &Formula) -> Option<Decision> {
        let claim = self.derivation.claim(self.at, assumed, goal);
        Some(self.decide(&search::pose(claim).ok()?))
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

    /// Looks for what holds in the place of what was refuted: a consequence, a mended formula, or what was not said.
    pub(super) fn instead(
        &self,
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
            && let Some(unless) = search::missing_conditions(
                &claim,
                Some(refuted.witness()),
                Effort::Light,
                &self.auditor.hints(),
            )
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
}

/// Whether a statement may be true whatever its symbols stand for: not where one of them is said to be what is calculated from others.
fn may_be_an_identity(formula: &Formula) -> bool {
    let says_what_it_is = |symbol: &Expr, term: &Expr| match symbol {
        Expr::Symbol(symbol) => !term.mentions(symbol) && !term.any(&|part| !part.is_arithmetic()),
        _ => false,
    };
    let sides = formula.as_equation();
    !sides.is_some_and(|(left, right)| says_what_it_is(left, right) || says_what_it_is(right, left))
}

/// Whether a goal takes the slope of something that is given by a term at one point alone: what its slope is there, that does not say.
fn takes_slope_at_a_point(judged: &Judged) -> bool {
    let at_point = |own: &&Assumed| own.standing == Standing::AtPoint && own.source != Source::Step;
    let at_point = judged.assumed.iter().filter(at_point);
    let mut given = at_point.filter_map(|own| own.formula.as_equation());
    let takes = |left: &Expr, right: &Expr| {
        let is_slope = |part: &Expr| match part {
            Expr::Derivative { body, variable } => **body == *left && right.mentions(variable),
            _ => false,
        };
        let mut terms = judged.goal.formula.terms().into_iter();
        terms.any(|term| term.any(&is_slope))
    };
    given.any(|(left, right)| takes(left, right))
}

/// A hypothesis that is supposed, or was shown before, in the statement itself.
pub(super) fn step(formula: &Formula) -> Assumed {
    Assumed {
        formula: formula.clone().into(),
        standing: Standing::AtPoint,
        source: Source::Step,
    }
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

/// Where hypotheses come from, each source once.
pub(super) fn sources(assumed: &[Assumed]) -> Vec<Source> {
    let mut all: Vec<Source> = assumed
        .iter()
        .map(|a| a.source)
        .filter(|s| *s != Source::Step)
        .collect();
    sorted::sort(&mut all);
    all.dedup();
    all
}
