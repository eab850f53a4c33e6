//! A goal decided from premises, and what is tried where it does not follow from them.

use std::cell::OnceCell;
use std::rc::Rc;

use crate::algebra::{Expr, Formula};
use crate::derivation::{Assumed, Goal, Kind};
use crate::kernel::{Assignment, Obligation, Refuted};
use crate::search::{self, Change, Decision, Derived, Effort, Mended, Stop};

use super::super::{Judged, Outcome};
use super::{CONTRADICTORY, Found, Judge, NEARBY, condition, sources};

const FARTHER: [(usize, Effort); 2] = [(40, Effort::Light), (12, Effort::Full)];

/// Laws are differentiated only where more is tried.
const SLOPES: [(usize, Effort); 1] = [(8, Effort::Full)];

/// A goal with what it is decided from.
struct Posed<'a> {
    goal: &'a Goal,
    assumed: &'a [Assumed],
    /// The equations that are cited for it.
    premises: &'a [usize],
    /// What it may be taken from with what the words before it name, once it is asked for.
    named: OnceCell<Option<Vec<Assumed>>>,
}

impl Judge<'_> {
    pub(in crate::audit) fn judged(
        &self,
        goal: &Goal,
        assumed: Vec<Assumed>,
        premises: &[usize],
    ) -> Found {
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
        let obligation = self.pose(&assumed, &goal.formula);
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
        let own = Posed {
            goal,
            assumed: &assumed,
            premises,
            named: OnceCell::new(),
        };
        match decision {
            Decision::Proven {
                derived,
                conditions,
            } if conditions.is_empty()
                && let Ok(posed) = &obligation =>
            {
                self.proved(&own, posed, derived, &mut found);
            }
            Decision::Proven {
                derived,
                conditions,
            } => self.proved_under(&own, derived, conditions, &mut found),
            Decision::Refuted(refuted) => self.refuted(&own, refuted, &mut found),
            Decision::Open(stop) => self.undecided(&own, stop, obligation.ok(), &mut found),
        }
        found
    }

    /// What follows from what is cited.
    fn proved(&self, own: &Posed, posed: &Obligation, derived: Derived, found: &mut Found) {
        let &Posed { goal, assumed, .. } = own;
        let (kept, least) = self.least(assumed.to_vec(), goal, posed, derived);
        if !kept.is_empty() && self.contradicts_itself(posed) {
            found.contradictory = sources(assumed);
            found.judged.outcome = Outcome::open(CONTRADICTORY);
            return;
        }
        found.judged.assumed = kept;
        found.judged.outcome = Outcome::Proven(least.into());
    }

    /// What follows from it under conditions that nothing states.
    fn proved_under(
        &self,
        own: &Posed,
        derived: Derived,
        conditions: Vec<Formula>,
        found: &mut Found,
    ) {
        let &Posed {
            goal,
            assumed,
            premises,
            ..
        } = own;
        // What stands before may say what is missing.
        let attempts = self.attempts(goal, assumed, premises, None);
        let divides = conditions.iter().any(|own| own.is_nonzero());
        if self.rescue(goal, &attempts, &NEARBY, found)
            || divides
                && goal.formula.speaks_of_slopes()
                && self.rescue(goal, &attempts, &SLOPES, found)
        {
            return;
        }
        // A condition that the premises rule out proves nothing.
        let with = conditions.iter().map(condition);
        let all: Vec<Assumed> = assumed.iter().cloned().chain(with).collect();
        if self.is_contradictory(&all, goal) {
            found.contradictory = sources(assumed);
            return;
        }
        // What follows under a condition alone rests on nothing else.
        let posed = self.pose(&all, &goal.formula);
        let again = posed
            .ok()
            .and_then(|posed| Some((search::prove_by_degrees(&posed)?, posed)));
        let (kept, least) = match again {
            Some((derived, posed)) => self.least(all, goal, &posed, derived),
            None => (all, derived.proven),
        };
        let is_kept = |own: &Formula| kept.contains(&condition(own));
        found.conditions = conditions.into_iter().filter(is_kept).collect();
        found.judged.assumed = kept;
        found.judged.outcome = Outcome::Proven(least.into());
    }

    /// What there is a counterexample to.
    fn refuted(&self, own: &Posed, refuted: Refuted, found: &mut Found) {
        let &Posed {
            goal,
            assumed,
            premises,
            ..
        } = own;
        let posed = self.pose(assumed, &goal.formula).ok();
        let better = posed.and_then(|posed| search::without_powers_of_nought(&posed, &refuted));
        let refuted = better.unwrap_or(refuted);
        let witness = refuted.witness().clone();
        found.judged.outcome = Outcome::Refuted(refuted.into());
        let marked = self.derivation.equations[self.at].kind == Kind::Marked;
        let mut strong = false;
        let settled =
            marked && goal.questioned || self.follows_after_all(own, witness, &mut strong, found);
        if self.only_proofs {
            return;
        }
        let told_before = match settled || strong {
            true => Vec::new(),
            false => self.told_before(goal, assumed, premises),
        };
        if !told_before.is_empty() {
            if !self.refutes_with(goal, assumed, told_before, premises, found) {
                let reason = "of some symbol in it only what stands before and is not cited speaks, and \
                              nothing decides it with that";
                found.judged.outcome = Outcome::open(reason);
            }
        } else if !settled {
            let named = self.named_for(own);
            let all = named.unwrap_or(assumed);
            let is_heeded = named.is_none() || self.heed_what_is_named(goal, all, found);
            self.instead(goal, all, premises, found);
            // That both sides may be equal is no slip where the text says more.
            let is_slip = |own: &Mended| own.change != Change::Strict;
            if !is_heeded && !found.mended.as_deref().is_some_and(is_slip) {
                found.leave_open(super::super::again::NAMED);
            }
            if !strong {
                self.heed_what_is_elsewhere(goal, assumed, premises, found);
                self.heed_circumstances(goal, assumed, premises, found);
            }
            self.heed_what_is_written(goal, all, found);
            self.heed_values_told(goal, all, found);
            self.heed_values_put_in(goal, all, found);
            self.heed_values_replaced(goal, all, found);
            self.heed_figures_for_what_has_no_value(goal, all, found);
            self.heed_figures_put_in(goal, found);
            self.heed_other_units(goal, all, found);
            self.heed_what_is_said_of_all(goal, all, found);
            self.heed_symmetry(goal, found);
            self.heed_what_is_new(goal, all, found);
            self.heed_contrast(goal, all, found);
            self.heed_what_is_otherwise_now(goal, all, found);
            self.heed_names_in_words(found);
            self.heed_laws_in_words(found);
            self.heed_what_is_out_of_scope(found);
            self.heed_what_it_goes_on_from(goal, all, premises, found);
            if !strong {
                self.heed_induction(found);
            }
            self.heed_what_varies(goal, all, premises, found);
            self.heed_what_is_open(goal, all, premises, found);
            self.heed_signs(goal, all, found);
            self.heed_approximations(goal, all, found);
            self.heed_other_readings(goal, all, found);
        }
        self.heed_analogues(found);
    }

    /// Whether what was refuted from what is cited follows all the same: what is tried, one after another, the likeliest first. Where a
    /// counterexample is found that allows all that stands before, it is `strong`.
    fn follows_after_all(
        &self,
        own: &Posed,
        witness: Assignment,
        strong: &mut bool,
        found: &mut Found,
    ) -> bool {
        let &Posed {
            goal,
            assumed,
            premises,
            ..
        } = own;
        let named = || self.named_for(own);
        let attempts = self.attempts(goal, assumed, premises, Some(witness));
        self.rescue(goal, &attempts, &NEARBY, found)
            || self.rescue_going_on(goal, assumed, premises, found)
            || named().is_some_and(|all| {
                self.follows_from_words(goal, all, premises, found)
                    || self.rescue_going_on(goal, all, premises, found)
            })
            || self.follows_without_units(goal, assumed, found)
            || self.follows_at_place(goal, named().unwrap_or(assumed), found)
            || self.unstated(goal, assumed, premises, found)
            || self.rescue_from_conditional(goal, assumed, premises, found)
            || {
                *strong = self.strengthen(goal, assumed, premises, found);
                let (loosely, strong) = (self.cites_loosely(), *strong);
                !strong && self.rescue(goal, &attempts, &FARTHER, found)
                    || loosely && self.rescue_from_open(goal, assumed, premises, found)
                    || loosely && !strong && self.follows_from_open(goal, assumed, premises, found)
            }
    }

    /// What neither follows from what is cited nor is refuted.
    fn undecided(
        &self,
        own: &Posed,
        stop: Stop,
        obligation: Option<Rc<Obligation>>,
        found: &mut Found,
    ) {
        let &Posed {
            goal,
            assumed,
            premises,
            ..
        } = own;
        let hopeless = stop.hopeless;
        // Premises that say nothing to an identity or inequality only stand in its way.
        let bare = self.derivation.claim(self.at, &[], &goal.formula);
        if !hopeless
            && !assumed.is_empty()
            && let Some(derived) = search::prove_unconditionally(bare, Effort::Full)
        {
            found.judged.assumed.clear();
            found.judged.outcome = Outcome::Proven(derived.proven.into());
            return;
        }
        found.judged.outcome = Outcome::Open(stop);
        let rescued = !hopeless && self.follows_otherwise(own, found);
        found.may_follow = rescued;
        if !rescued {
            self.heed_approximations(goal, assumed, found);
        }
        if !rescued && !hopeless && self.cites_loosely() {
            let told_before = self.told_before(goal, assumed, premises);
            if !told_before.is_empty()
                && self.refutes_with(goal, assumed, told_before, premises, found)
            {
                return;
            }
        }
        if !rescued && obligation.is_some_and(|posed| self.contradicts_itself(&posed)) {
            found.contradictory = sources(assumed);
        }
    }

    /// Whether what was left open follows from more than what is cited: what is tried, one after another.
    fn follows_otherwise(&self, own: &Posed, found: &mut Found) -> bool {
        let &Posed {
            goal,
            assumed,
            premises,
            ..
        } = own;
        let attempts = self.attempts(goal, assumed, premises, None);
        self.rescue(goal, &attempts, &NEARBY, found)
            || self.rescue(goal, &attempts, &FARTHER, found)
            || (self.named_for(own))
                .is_some_and(|all| self.follows_from_words(goal, all, premises, found))
            || self.follows_without_units(goal, assumed, found)
            || self.rescue_from_open(goal, assumed, premises, found)
            || self.unstated(goal, assumed, premises, found)
            || self.follows_from_open(goal, assumed, premises, found)
    }

    /// What it may be taken from with what the words before it name, if they name anything.
    fn named_for<'a>(&self, own: &'a Posed) -> Option<&'a [Assumed]> {
        let named = (own.named)
            .get_or_init(|| self.with_what_is_named(own.goal, own.assumed, own.premises));
        named.as_deref()
    }
}

/// Whether a statement may be seen to be true whatever its symbols stand for: not where one of them is said to be what is calculated from
/// others, and which of two terms is the greater is not seen at once.
fn may_be_an_identity(formula: &Formula) -> bool {
    let says_what_it_is = |symbol: &Expr, term: &Expr| match symbol {
        Expr::Symbol(symbol) => !term.mentions(symbol) && !term.any(&|part| !part.is_arithmetic()),
        _ => false,
    };
    let sides = formula.as_equation();
    !formula.is_inequality()
        && !sides.is_some_and(|(left, right)| {
            says_what_it_is(left, right) || says_what_it_is(right, left)
        })
}
